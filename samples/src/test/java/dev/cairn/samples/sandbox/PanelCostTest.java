package dev.cairn.samples.sandbox;

import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.render.app.Scene;
import dev.cairn.render.app.View;
import dev.cairn.render.input.Key;
import dev.cairn.render.ui.TextBuffer;
import dev.cairn.render.ui.Ui;
import dev.cairn.samples.SceneRegistry;
import dev.cairn.samples.window.WindowFixture;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.locks.LockSupport;

/**
 * What the panels cost the window's thread, with a driver that draws nothing, so that the time is
 * our own and Mesa's front end: CPU time of a frame with them less that of a frame without, as fast
 * as frames come and each made anew, and at 60 frames a second, laid out each time and as they are.
 * With {@code -Dpanels.rasteriser=true} a driver that draws. Prints it; a time is no truth to
 * assert.
 */
@Tag("soak")
class PanelCostTest extends WindowFixture {
    private static final int ROUNDS = 5;

    /** Says something every so many frames only, since to write a line takes longer than panels. */
    static final class Probe extends Sandbox {
        private static final int FRAMES = 100;
        private static final long FRAME_NANOS = 16_666_667;

        private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
        private final TextBuffer text = new TextBuffer();
        private volatile boolean paced;
        private volatile boolean each = true;
        private boolean bound;
        private long nextNanos;
        private long told;
        private long before;

        private Probe() {
            super(SceneRegistry.all(), Map.of(), 1, 4, false, System.err);
        }

        /** Runs until the window is closed. */
        public static void main(String[] arguments) {
            Probe probe = new Probe();
            probe.vsync(false);
            probe.size(1024, 640).start();
        }

        @Override
        protected void initScene(Scene scene) {
            super.initScene(scene);
            if (!bound) {
                bound = true;
                scene.bindings()
                        .onKey(Key.F6, "pace", () -> paced = !paced)
                        .onKey(Key.F7, "each frame anew", () -> each = !each);
            }
        }

        @Override
        protected void panels(Ui ui, View view) {
            // What begins before the question whether to keep has the frame made anew.
            if (each) {
                if (ui.panel("Frames", 400, 10, 200, 60)) {
                    ui.label(text.clear().put(paced ? 0 : view.frames()));
                }
                ui.endPanel();
            }
            super.panels(ui, view);
        }

        @Override
        void shown(Ui ui, View view, SandboxState state) {
            if (paced) {
                long now = System.nanoTime();
                nextNanos = Math.max(nextNanos + FRAME_NANOS, now - FRAME_NANOS);
                LockSupport.parkNanos(nextNanos - now);
            }
            if (view.frames() < told + FRAMES) {
                return;
            }
            long now = threads.getCurrentThreadCpuTime();
            System.out.printf(
                    Locale.ROOT,
                    "frame=%d tick=%d millis=%.5f changes=%d draws=%d paced=%b each=%b%s%n",
                    view.frames(),
                    state.tick,
                    1e-6 * (now - before) / (view.frames() - told),
                    ui.changes(),
                    ui.draws(),
                    paced,
                    each,
                    middle(ui, "Plots"));
            System.out.flush();
            told = view.frames();
            before = threads.getCurrentThreadCpuTime();
        }
    }

    @Override
    public Class<?> program() {
        return Probe.class;
    }

    private static boolean rasterises() {
        return Boolean.getBoolean("panels.rasteriser");
    }

    @Override
    public Map<String, String> environment() {
        return rasterises() ? Map.of() : Map.of("GALLIUM_NOOP", "1");
    }

    @Override
    public List<String> flags() {
        return List.of();
    }

    /** After the JIT's first seconds. */
    @Override
    public boolean ready(Seen seen) {
        return seen.number("frame") >= (rasterises() ? 500 : 4000);
    }

    @Test
    void theCostOfThePanelsIsTold() throws IOException, InterruptedException {
        double shown = median();
        type("key", "h");
        double hidden = median();
        type("key", "h");
        tell("as fast as they come, each laid out", shown - hidden, hidden);
        type("key", "F6");
        paced("");
        click("Plots");
        moveTo(512, 400);
        paced(", with plots");
    }

    private void paced(String what) throws IOException, InterruptedException {
        double each = median();
        type("key", "F7");
        double kept = median();
        type("key", "h");
        double hidden = median();
        type("key", "h", "F7");
        tell("60 a second" + what + ", each laid out", each - hidden, hidden);
        tell("60 a second" + what + ", as they are", kept - hidden, hidden);
    }

    private static void tell(String how, double panels, double rest) {
        System.out.printf(
                Locale.ROOT,
                "panels, ms of CPU time a frame, %s: %.3f; all else %.3f%n",
                how,
                panels,
                rest);
    }

    private double median() throws IOException, InterruptedException {
        now();
        now(); // the first one may have begun before the change
        double[] millis = new double[ROUNDS];
        for (int i = 0; i < ROUNDS; i++) {
            millis[i] = now().number("millis");
        }
        System.out.println(Arrays.toString(millis) + " " + last);
        Arrays.sort(millis);
        assertTrue(millis[0] > 0, "it is measured");
        return millis[ROUNDS / 2];
    }
}
