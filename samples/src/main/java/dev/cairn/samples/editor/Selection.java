package dev.cairn.samples.editor;

import java.util.Arrays;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;

/**
 * Which entities are selected: places in the scene's list, in the order in which they were chosen;
 * the last one is the one that panels show. One thread.
 */
final class Selection {
    private int[] chosen = {};

    /** What was selected after the last step through the history. */
    private int[] left = chosen;

    /** The one chosen last, or {@link Editor#NOTHING}. */
    int primary() {
        return chosen.length == 0 ? Editor.NOTHING : chosen[chosen.length - 1];
    }

    /** All; not to be changed. */
    int[] all() {
        return chosen;
    }

    boolean holds(int index) {
        for (int each : chosen) {
            if (each == index) {
                return true;
            }
        }
        return false;
    }

    void only(int... places) {
        chosen = places;
    }

    /** Takes one more, or lets go of one. */
    void toggle(int index) {
        boolean held = holds(index);
        int[] others = Arrays.stream(chosen).filter(each -> each != index).toArray();
        chosen = held ? others : Arrays.copyOf(others, others.length + 1);
        if (!held) {
            chosen[others.length] = index;
        }
    }

    /**
     * Follows what was selected through a step of the history. Where the step takes all of it away,
     * or brings back what was selected then and nothing else is chosen, it is what was selected
     * then: undoing a copy selects the original, doing it again the copy.
     *
     * @param before the entities before the step
     * @param after the same after it
     * @param then what was selected when the scene was as it is after it
     */
    <T> void travelled(List<T> before, List<T> after, int[] then) {
        boolean free = chosen.length == 0 || Arrays.equals(chosen, left);
        boolean adds =
                after.size() > before.size() && Arrays.stream(then).anyMatch(isNew(before, after));
        int[] followed = followed(before, after);
        boolean isGone = chosen.length > 0 && followed.length == 0;
        chosen = isGone || (free && adds) ? then : followed;
        left = chosen;
    }

    /** Places of entities that a step has brought. */
    private static <T> IntPredicate isNew(List<T> before, List<T> after) {
        Set<T> known = Collections.newSetFromMap(new IdentityHashMap<>());
        known.addAll(before);
        return place -> !known.contains(after.get(place));
    }

    private <T> int[] followed(List<T> before, List<T> after) {
        int primary = after(before, primary(), after);
        int[] others =
                Arrays.stream(chosen)
                        .filter(each -> each != primary())
                        .map(each -> same(before, each, after))
                        .filter(each -> each != Editor.NOTHING && each != primary)
                        .distinct()
                        .toArray();
        if (primary != Editor.NOTHING) {
            others = Arrays.copyOf(others, others.length + 1);
            others[others.length - 1] = primary;
        }
        return others;
    }

    /** The same object's place after a step; its old place if the step changed it there. */
    @SuppressWarnings("ReferenceEquality") // the same object is the same entity
    private static <T> int same(List<T> before, int selected, List<T> after) {
        T wanted = before.get(selected);
        for (int i = 0; i < after.size(); i++) {
            if (after.get(i) == wanted) {
                return i;
            }
        }
        return before.size() == after.size() ? selected : Editor.NOTHING;
    }

    /**
     * The place of what was selected in a list before and after a step. They are values that a step
     * leaves as the same objects unless it changes them.
     *
     * @param before the entities, or joints, before the step
     * @param selected the place there, or {@link Editor#NOTHING}
     * @param after the same after it
     * @return what was selected, as it is now; else what the step brought back; else nothing
     */
    static <T> int after(List<T> before, int selected, List<T> after) {
        int kept = selected == Editor.NOTHING ? selected : same(before, selected, after);
        if (kept != Editor.NOTHING) {
            return kept;
        }
        int[] back = IntStream.range(0, after.size()).filter(isNew(before, after)).toArray();
        return back.length == 1 ? back[0] : Editor.NOTHING; // several: a new scene
    }
}
