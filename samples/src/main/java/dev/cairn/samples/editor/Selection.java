package dev.cairn.samples.editor;

import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;

/** Which entity or joint is selected after a step through the history. Stateless. */
final class Selection {
    private Selection() {}

    /**
     * The place of what was selected in a list before and after a step. They are values that a step
     * leaves as the same objects unless it changes them.
     *
     * @param before the entities, or joints, before the step
     * @param selected the place there, or {@link Editor#NOTHING}
     * @param after the same after it
     * @return what was selected, as it is now; else what the step brought back; else nothing
     */
    @SuppressWarnings("ReferenceEquality") // the same object is the same entity
    static <T> int after(List<T> before, int selected, List<T> after) {
        if (selected != Editor.NOTHING) {
            T chosen = before.get(selected);
            for (int i = 0; i < after.size(); i++) {
                if (after.get(i) == chosen) {
                    return i;
                }
            }
            if (before.size() == after.size()) {
                return selected; // changed where it is
            }
        }
        Set<T> known = Collections.newSetFromMap(new IdentityHashMap<>());
        known.addAll(before);
        int back = Editor.NOTHING;
        for (int i = 0; i < after.size(); i++) {
            if (!known.contains(after.get(i))) {
                if (back != Editor.NOTHING) {
                    return Editor.NOTHING; // several came back: a new scene
                }
                back = i;
            }
        }
        return back;
    }
}
