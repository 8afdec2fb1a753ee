package dev.cairn.samples.sandbox;

import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.render.app.View;
import dev.cairn.render.ui.TextBuffer;
import dev.cairn.render.ui.Ui;
import dev.cairn.samples.SceneRegistry;
import dev.cairn.samples.window.WindowFixture;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Arrays;
import java.util.Locale;
import java.util.Map;

/**
 * What the panels cost the window's thread, with a driver that draws nothing, so that the time is
 * our own and Mesa's front end: CPU time of a frame with them less that of a frame without. Prints
 * it; a time is no truth to assert.
 */
class PanelCostTest extends WindowFixture {
    private static final int ROUNDS = 7;

    /** Says something every so many frames only, since to write a line takes longer than panels. */
    static final class Probe extends Sandbox {
        private static final int FRAMES = 200;

        private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
        private final TextBuffer text = new TextBuffer();
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
        void shown(Ui ui, View view, SandboxState state) {
            // Frames come faster than ticks here; each shall be made anew all the same.
            if (ui.panel("Frames", 400, 10, 200, 60)) {
                ui.label(text.clear().put(view.frames()));
            }
            ui.endPanel();
            if (view.frames() < told + FRAMES) {
                return;
            }
            long now = threads.getCurrentThreadCpuTime();
            System.out.printf(
                    Locale.ROOT,
                    "frame=%d tick=%d millis=%.5f changes=%d%s%n",
                    view.frames(),
                    state.tick,
                    1e-6 * (now - before) / (view.frames() - told),
                    ui.changes(),
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

    @Override
    public Map<String, String> environment() {
        return Map.of("GALLIUM_NOOP", "1");
    }

    /** After the JIT's first seconds. */
    @Override
    public boolean ready(Seen seen) {
        return seen.number("frame") >= 4000;
    }

    @Test
    void theCostOfThePanelsIsTold() throws IOException, InterruptedException {
        double shown = median();
        click("Plots");
        double plots = median();
        type("key", "h");
        double hidden = median();
        System.out.printf(
                Locale.ROOT,
                "panels, ms of CPU time a frame, median of %d times %d frames: %.3f, with plots"
                        + " %.3f; all else %.3f%n",
                ROUNDS,
                Probe.FRAMES,
                shown - hidden,
                plots - hidden,
                hidden);
        assertTrue(shown > 0 && plots > 0 && hidden > 0, "each is measured");
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
        return millis[ROUNDS / 2];
    }
}
