package dev.cairn.samples.editor;

import dev.cairn.samples.scenefile.EntitySpec;

import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;

/** Which entity is selected after a step through the history. Stateless. */
final class Selection {
    private Selection() {}

    /**
     * The place of what was selected in a list before and after a step. Entities are values that a
     * step leaves as the same objects unless it changes them.
     *
     * @param before the entities before the step
     * @param selected the place there, or {@link Editor#NOTHING}
     * @param after the entities after it
     * @return what was selected, as it is now; else what the step brought back; else nothing
     */
    @SuppressWarnings("ReferenceEquality") // the same object is the same entity
    static int after(List<EntitySpec> before, int selected, List<EntitySpec> after) {
        if (selected != Editor.NOTHING) {
            EntitySpec chosen = before.get(selected);
            for (int i = 0; i < after.size(); i++) {
                if (after.get(i) == chosen) {
                    return i;
                }
            }
            if (before.size() == after.size()) {
                return selected; // changed where it is
            }
        }
        Set<EntitySpec> known = Collections.newSetFromMap(new IdentityHashMap<>());
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
