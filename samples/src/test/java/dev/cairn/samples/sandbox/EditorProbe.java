package dev.cairn.samples.sandbox;

import dev.cairn.core.snapshot.PoseSnapshot;
import dev.cairn.render.app.View;
import dev.cairn.render.ui.Ui;
import dev.cairn.samples.editor.files.FileChooser;
import dev.cairn.samples.editor.files.LeaveQuestion;
import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenes.stack.StackOfBoxes;
import dev.cairn.samples.window.WindowFixture;

import org.joml.Vector3d;

import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * The sandbox as a program of its own that tells, one line a frame, what the editor shows, for
 * {@link EditorWindowTest}.
 */
public final class EditorProbe extends Sandbox {
    private static final List<String> BUTTONS =
            List.of(
                    "box",
                    "capsule",
                    "hull",
                    "half-space",
                    "Save",
                    "Turn",
                    "Open...",
                    "Save as...",
                    FileChooser.SAVE,
                    FileChooser.NAME,
                    "other.json",
                    "below/",
                    "Scale",
                    "Load",
                    "New joint",
                    "To the world...",
                    "To a body...",
                    "Move its point...",
                    "twist about x",
                    "twist: a motor",
                    "name",
                    "position x",
                    "joint 0  hinge, anchor and box",
                    LeaveQuestion.SAVE,
                    LeaveQuestion.GIVE_UP);
    private final com.sun.management.ThreadMXBean threads =
            (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
    private final Vector3d eye = new Vector3d();
    private final Vector3d ahead = new Vector3d();
    private long bytesBefore;

    private EditorProbe() {
        super(List.of(StackOfBoxes.scene()), Map.of(), 1, 4, false, System.err);
    }

    /** Runs until the window is closed. */
    public static void main(String[] arguments) {
        new EditorProbe().size(1024, 640).start();
    }

    @Override
    void shown(Ui ui, View view, SandboxState state) {
        // What the frame allocated but for this method.
        long bytes = threads.getCurrentThreadAllocatedBytes() - bytesBefore;
        EntitySpec chosen = editor().selectedEntity();
        StringBuilder line = new StringBuilder();
        line.append(
                String.format(
                        Locale.ROOT,
                        "frame=%d mode=%s tick=%d steps=%d entities=%d changed=%b wrong=%b"
                                + " selected=%d selectedX=%s selectedY=%s seenY=%.6f bytes=%d"
                                + " asked=%b shortened=%d eyeZ=%.6f bodyX=%.6f bodyY=%.6f joints=%d"
                                + " joint=%d awaited=%s count=%d tool=%s selectedZ=%s"
                                + " texture=%s turnY=%.6f scaleX=%.6f scaleY=%.6f lowestY=%.6f"
                                + " eyeX=%.6f eyeY=%.6f aheadX=%.6f aheadY=%.6f aheadZ=%.6f"
                                + " nameLength=%d message=%s notes=%s",
                        view.frames(),
                        editor().mode(),
                        state.tick,
                        editor().history().steps(),
                        editor().scene().entities().size(),
                        editor().isChanged(),
                        editor().isWrong(),
                        editor().selected(),
                        chosen == null ? "NaN" : chosen.position().x(),
                        chosen == null ? "NaN" : chosen.position().y(),
                        seen(view, state, state.entities.length - 1, 1),
                        bytes,
                        leaving().isAsked(),
                        ui.shortened(),
                        view.camera().position(eye).z,
                        seen(view, state, 1, 0),
                        seen(view, state, 1, 1),
                        editor().scene().joints().size(),
                        editor().joints().selected(),
                        editor().joints().awaited(),
                        editor().selection().length,
                        editorPanels().gizmo().mode(),
                        chosen == null ? "NaN" : chosen.position().z(),
                        chosen == null ? "" : chosen.look().texture(),
                        chosen == null ? 0 : 2 * Math.asin(chosen.rotation().y()),
                        chosen == null ? 0 : chosen.scale().x(),
                        chosen == null ? 0 : chosen.scale().y(),
                        lowest(),
                        eye.x,
                        eye.y,
                        view.camera().forward(ahead).x,
                        ahead.y,
                        ahead.z,
                        chosen == null ? 0 : chosen.name().length(),
                        editor().message().replaceAll("\\s", "_"),
                        state.notes.replaceAll("\\s", "_")));
        double[] at = new double[2];
        for (int axis = 0; axis < 3 && chosen != null; axis++) {
            if (editorPanels().gizmo().handleAt(axis, at)) {
                line.append(
                        String.format(
                                Locale.ROOT,
                                " handle%dX=%.1f handle%dY=%.1f",
                                axis,
                                at[0] * ui.width(),
                                axis,
                                at[1] * ui.height()));
            }
        }
        line.append(" overlapping=").append(ui.overlapping());
        for (String button : BUTTONS) {
            line.append(WindowFixture.middle(ui, button));
        }
        System.out.println(line);
        System.out.flush();
        bytesBefore = threads.getCurrentThreadAllocatedBytes();
    }

    /** The least height at which one of the selected entities is. */
    private double lowest() {
        return Arrays.stream(editor().selection())
                .mapToDouble(i -> editor().scene().entities().get(i).position().y())
                .min()
                .orElse(0);
    }

    /** Where the world has an entity of the edited scene. */
    private static double seen(View view, SandboxState state, int entity, int axis) {
        PoseSnapshot snapshot = view.snapshot();
        for (int row = 0; row < snapshot.size(); row++) {
            if (entity >= 0
                    && entity < state.entities.length
                    && snapshot.entity(row) == state.entities[entity]) {
                return snapshot.current()[row * PoseSnapshot.STRIDE + axis];
            }
        }
        return Double.NaN;
    }
}
