package dev.cairn.samples.scenefile.edit;

import dev.cairn.samples.scenefile.SceneFile;

import org.jspecify.annotations.Nullable;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.Objects;

/**
 * A scene that is being edited, with the way back. Scenes are immutable values that share their
 * unchanged entities, so a step costs one reference per entity of the scene, and going back gives
 * the very value that was there before.
 *
 * <p>Memory is bounded twice: by the number of steps, and by the sum of their entities (8 bytes
 * each at most); the oldest steps are forgotten first. One thread.
 */
public final class SceneHistory {
    /** Steps that can be undone, unless another number is given. */
    public static final int MOST_STEPS = 500;

    /** Entities of all steps together, unless another number is given: at most 16 MB. */
    public static final long MOST_ENTITIES = 2_000_000;

    private final int mostSteps;
    private final long mostEntities;
    private final Deque<Step> undo = new ArrayDeque<>();
    private final Deque<Step> redo = new ArrayDeque<>();
    private SceneFile current;
    private List<Integer> chosen = List.of();
    private long entities;
    private boolean open;

    /** What was done, and the scene on its other side, with what was selected there. */
    private record Step(String label, SceneFile scene, List<Integer> chosen) {
        int entities() {
            return scene.entities().size();
        }
    }

    /**
     * A history without steps.
     *
     * @param start the scene
     */
    public SceneHistory(SceneFile start) {
        this(start, MOST_STEPS, MOST_ENTITIES);
    }

    /**
     * A history without steps.
     *
     * @param start the scene
     * @param mostSteps steps that can be undone, at least 1
     * @param mostEntities entities of all steps together, at least 0; the last step is kept in any
     *     case
     */
    public SceneHistory(SceneFile start, int mostSteps, long mostEntities) {
        if (mostSteps < 1 || mostEntities < 0) {
            throw new IllegalArgumentException(
                    "mostSteps is %d and mostEntities %d, expected at least 1 and 0"
                            .formatted(mostSteps, mostEntities));
        }
        this.mostSteps = mostSteps;
        this.mostEntities = mostEntities;
        current = Objects.requireNonNull(start, "start");
    }

    /**
     * The scene as it is now.
     *
     * @return the value
     */
    public SceneFile current() {
        return current;
    }

    /**
     * Keeps what is selected in the present scene, for when a step leads back to it. An edit
     * forgets it.
     *
     * @param places in the list of entities
     */
    public void choose(int... places) {
        chosen = Arrays.stream(places).boxed().toList();
    }

    /**
     * What was selected in the present scene.
     *
     * @return what {@link #choose} was given when this scene was left last; else nothing
     */
    public int[] chosen() {
        return chosen.stream().mapToInt(Integer::intValue).toArray();
    }

    /**
     * Takes an edited scene. What was undone can no longer be redone.
     *
     * @param label what was done, a few words
     * @param next the scene afterwards; if it equals the present one, nothing happens
     * @param joins whether this goes on with the last step if that has the same label, as the many
     *     small moves of one drag do; {@link #seal} ends it
     * @return true if the scene changed
     */
    public boolean edit(String label, SceneFile next, boolean joins) {
        if (next.equals(current)) {
            return false;
        }
        Step last = undo.peekLast();
        boolean goesOn = joins && open && last != null && last.label().equals(label);
        if (!goesOn) {
            push(undo, new Step(label, current, chosen));
        }
        forgetRedo();
        trim();
        open = joins;
        current = next;
        chosen = List.of();
        return true;
    }

    /** Ends the step that later edits would otherwise go on with. */
    public void seal() {
        open = false;
    }

    /**
     * Takes the last step back.
     *
     * @return its label, or null if there is none
     */
    public @Nullable String undo() {
        return swap(undo, redo);
    }

    /**
     * Does again what was undone last.
     *
     * @return its label, or null if there is none
     */
    public @Nullable String redo() {
        return swap(redo, undo);
    }

    private @Nullable String swap(Deque<Step> from, Deque<Step> to) {
        Step step = from.pollLast();
        if (step == null) {
            return null;
        }
        entities -= step.entities();
        push(to, new Step(step.label(), current, chosen));
        current = step.scene();
        chosen = step.chosen();
        open = false;
        return step.label();
    }

    private void push(Deque<Step> to, Step step) {
        to.addLast(step);
        entities += step.entities();
    }

    private void forgetRedo() {
        redo.forEach(step -> entities -= step.entities());
        redo.clear();
    }

    private void trim() {
        while (undo.size() > 1 && (undo.size() > mostSteps || entities > mostEntities)) {
            entities -= undo.removeFirst().entities();
        }
    }

    /**
     * What {@link #undo} would take back.
     *
     * @return the label, or null if nothing can be undone
     */
    public @Nullable String undoLabel() {
        Step step = undo.peekLast();
        return step == null ? null : step.label();
    }

    /**
     * What {@link #redo} would do again.
     *
     * @return the label, or null if nothing can be redone
     */
    public @Nullable String redoLabel() {
        Step step = redo.peekLast();
        return step == null ? null : step.label();
    }

    /**
     * How many steps can be undone.
     *
     * @return at least 0
     */
    public int steps() {
        return undo.size();
    }
}
