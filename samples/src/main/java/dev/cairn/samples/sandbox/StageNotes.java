package dev.cairn.samples.sandbox;

import dev.cairn.samples.SceneBuilder;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;

/**
 * What is said of an edited scene; made anew only after it has something more to say. Simulation
 * thread.
 */
final class StageNotes {
    private EditorStage.@Nullable Shown about;
    private int size;
    private String notes = "";

    /** One line; empty for a scene of the list. */
    @SuppressWarnings("ReferenceEquality")
    String of(
            EditorStage.@Nullable Shown edited,
            @Nullable SceneBuilder built,
            String problem,
            double windowStepSeconds) {
        if (edited == null || built == null) {
            return "";
        }
        int said = built.remarks().size() + problem.length();
        if (edited != about || said != size) {
            about = edited;
            size = said;
            notes = make(edited, built, problem, windowStepSeconds);
        }
        return notes;
    }

    private static String make(
            EditorStage.Shown edited,
            SceneBuilder built,
            String problem,
            double windowStepSeconds) {
        List<String> lines = new ArrayList<>(built.remarks());
        if (!problem.isEmpty()) {
            lines.add(problem);
        }
        String state = edited.scene().state();
        if (state != null && !edited.playing()) {
            lines.add("begins with the moment in %s when it is played".formatted(state));
        }
        double tick = edited.scene().tick().seconds();
        if (tick != windowStepSeconds) {
            lines.add(
                    "ticks are %s s here and %s s in the scene; open it by --scene-file"
                            .formatted(windowStepSeconds, tick));
        }
        return String.join("; ", lines);
    }
}
