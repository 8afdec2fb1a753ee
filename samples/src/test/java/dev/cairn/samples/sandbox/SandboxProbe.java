package dev.cairn.samples.sandbox;

import dev.cairn.core.snapshot.PoseSnapshot;
import dev.cairn.physics.BodyRef;
import dev.cairn.render.app.DebugLayer;
import dev.cairn.render.app.Scene;
import dev.cairn.render.app.View;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.input.Bindings;
import dev.cairn.render.input.Key;
import dev.cairn.render.input.MouseMove;
import dev.cairn.render.ui.Ui;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.replay.RunFile;
import dev.cairn.samples.scenes.stack.StackOfBoxes;
import dev.cairn.samples.window.WindowFixture;

import org.joml.Vector3d;

import java.io.IOException;
import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * The sandbox as a program of its own that tells on its standard output, one line a frame, what is
 * in the window, for {@link SandboxWindowTest}.
 */
public final class SandboxProbe extends Sandbox {
    private final PrintStream out;
    private final Vector3d eye = new Vector3d();
    private final com.sun.management.ThreadMXBean threads =
            (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
    private static final List<String> SECTIONS =
            List.of(
                    "Plots",
                    "Stages of a tick",
                    "Draw",
                    "Solver",
                    "Ball (key B)",
                    "Window",
                    "Keys");
    private long bytesBefore;
    private long tickBytes;

    /** Ticks without a frame after which the window is said to sleep. */
    private static final int ASLEEP_TICKS = 120;

    private volatile int ticksUnseen;
    private volatile long framesShown;
    private volatile int quietTicks;

    /** Digest of each tick when it came first; how many came again the same, and otherwise. */
    private final long[] digests = new long[1 << 16];

    private volatile int digestTick;
    private volatile int sameAgain;
    private volatile int otherAgain;

    private SandboxProbe(List<SampleScene> scenes, PrintStream out) {
        super(scenes, Map.of(), 1, 4, false, System.err);
        this.out = out;
    }

    /** Where the test leaves a moment to begin with, if it wants one. */
    public static final String MOMENT = "begin.cairn";

    /** Where the run goes when the window is closed, if a file of that name is there. */
    static final String RUN = "run.cairn";

    /** Runs until the window is closed. */
    public static void main(String[] arguments) throws IOException {
        SandboxProbe probe = new SandboxProbe(List.of(StackOfBoxes.scene()), System.out);
        if (Files.exists(Path.of(RUN))) {
            probe.record(Path.of(RUN));
        }
        if (Files.exists(Path.of(MOMENT))) {
            probe.beginAt(RunFile.open(Path.of(MOMENT)));
        }
        probe.size(1024, 640).start();
    }

    @Override
    protected void initScene(Scene scene) {
        Arrays.fill(digests, 0); // another run
        super.initScene(scene);
        scene.bindings().onKey(Key.U, "spin", () -> spin(scene));
    }

    /** What the camera follows turns about the vertical for a while. */
    private static void spin(Scene scene) {
        BodyRef body = scene.physics().bodyOf(scene.camera().followed());
        if (body != null) {
            body.setAngularVelocity(0, 8, 0);
        }
    }

    private int layers() {
        int count = 0;
        for (DebugLayer layer : DebugLayer.values()) {
            count += isDebug(layer) ? 1 : 0;
        }
        return count;
    }

    private static String places(Ui ui) {
        StringBuilder line = new StringBuilder();
        for (String widget :
                List.of(
                        "boxes",
                        "box",
                        "name",
                        "sink",
                        "fly left",
                        "fly right",
                        "Notice",
                        "[1]",
                        "1",
                        "1.5",
                        "2")) {
            line.append(WindowFixture.middle(ui, widget));
        }
        for (String button :
                List.of(
                        KeyRows.TAKE,
                        KeyRows.LEAVE,
                        KeyRows.RESET,
                        MouseMove.DOWN.label(),
                        TimePanel.FORGET,
                        SimulationPanel.SMOOTH)) {
            line.append(WindowFixture.middle(ui, button));
        }
        for (String section : SECTIONS) {
            line.append(WindowFixture.middle(ui, section));
        }
        for (DebugLayer layer : DebugLayer.values()) {
            line.append(WindowFixture.middle(ui, layer.title()));
        }
        return line.toString();
    }

    /** From the end of one tick to the end of the next: all that the simulation thread does. */
    @Override
    protected void updated(double seconds) {
        super.updated(seconds);
        long now = threads.getCurrentThreadAllocatedBytes();
        quietTicks = now == tickBytes ? quietTicks + 1 : 0;
        if (++ticksUnseen == ASLEEP_TICKS) {
            out.printf("asleep=true frame=%d%n", framesShown);
            out.flush();
        }
        compare((int) Math.min(builtTick(), digests.length - 1), scene().physics().digest());
        tickBytes = threads.getCurrentThreadAllocatedBytes();
    }

    /** Simulation thread. */
    private void compare(int tick, long digest) {
        if (digests[tick] == 0) {
            digests[tick] = digest;
        } else if (digests[tick] == digest) {
            sameAgain = sameAgain + 1;
        } else {
            otherAgain = otherAgain + 1;
        }
        digestTick = tick; // volatile: the digest is there before it
    }

    private String keysOf(String action) {
        Bindings bindings;
        try {
            bindings = keyBindings();
        } catch (IllegalStateException early) {
            return ""; // the first frames may come before the scene
        }
        for (Bindings.Binding binding : bindings.actions()) {
            if (binding.action().equals(action)) {
                return binding.label().replace(' ', '_');
            }
        }
        return "";
    }

    /** The least angle between the ray through the mouse and an entity's place, rad. */
    private double offTheRay(View view) {
        Vector3d ray = new Vector3d();
        view.camera().ray(view.pointer().across(), view.pointer().upwards(), view.aspect(), ray);
        double least = Math.PI;
        double[] at = view.snapshot().current();
        for (int row = 0; row < view.snapshot().size(); row++) {
            int i = row * PoseSnapshot.STRIDE;
            Vector3d to = new Vector3d(at[i], at[i + 1], at[i + 2]).sub(eye);
            least = Math.min(least, ray.angle(to));
        }
        return least;
    }

    @Override
    void shown(Ui ui, View view, SandboxState state) {
        if (state.id.isEmpty()) {
            return; // the simulation thread has not built the scene yet
        }
        // What the frame allocated but for this method.
        long bytes = threads.getCurrentThreadAllocatedBytes() - bytesBefore;
        ticksUnseen = 0;
        framesShown = view.frames();
        view.camera().position(eye);
        int seenTick = digestTick;
        double[] slider = ui.boundsOf("gap");
        double[] bar = ui.boundsOf(TimePanel.BAR);
        out.printf(
                Locale.ROOT,
                "frame=%d tick=%d worldTick=%d paused=%b eyeX=%.6f eyeY=%.6f eyeZ=%.6f pulling=%b"
                    + " held=%s heldX=%.6f gap=%.6f sliderX=%.1f sliderY=%.1f sliderWidth=%.1f"
                    + " sliderHeight=%.1f bodies=%d uiWidth=%.0f uiHeight=%.0f uiScale=%.2f full=%b"
                    + " substeps=%d workers=%d layers=%d bytes=%d help=%b quiet=%d shortened=%d"
                    + " overlapping=%d oldest=%d newest=%d kept=%d future=%b apart=%.9f"
                    + " sameAgain=%d otherAgain=%d digestTick=%d digest=%016x barX=%.1f barY=%.1f"
                    + " barWidth=%.1f sinkKeys=%s rightKeys=%s listKeys=%s followed=%b changes=%d"
                    + " rayOff=%.6f%s%n",
                view.frames(),
                state.tick,
                view.snapshot().tick(),
                isPaused(),
                eye.x,
                eye.y,
                eye.z,
                state.pulling,
                state.held.replace(' ', '_'),
                state.heldAt.x,
                state.options.values().get("gap"),
                slider == null ? -1 : slider[0],
                slider == null ? -1 : slider[1],
                slider == null ? -1 : slider[2],
                slider == null ? -1 : slider[3],
                state.bodies,
                ui.width(),
                ui.height(),
                ui.scale(),
                isFullscreen(),
                state.substeps,
                state.workers,
                layers(),
                bytes,
                isHelpShown(),
                quietTicks,
                ui.shortened(),
                ui.overlapping(),
                state.oldestTick,
                state.newestTick,
                state.keptTick,
                state.future != null,
                state.apart,
                sameAgain,
                otherAgain,
                seenTick,
                digests[seenTick],
                bar == null ? -1 : bar[0],
                bar == null ? -1 : bar[1] + bar[3] / 2,
                bar == null ? -1 : bar[2],
                keysOf("sink"),
                keysOf("fly right"),
                keysOf("list keys"),
                view.camera().followed() != Camera.NOTHING,
                ui.changes(),
                offTheRay(view),
                places(ui));
        out.flush();
        bytesBefore = threads.getCurrentThreadAllocatedBytes();
    }
}
