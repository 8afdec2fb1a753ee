package dev.cairn.core.state;

import org.jspecify.annotations.Nullable;

import java.util.Arrays;

/** The references that differ between two states, by their places in the wide layout. */
final class DeltaReferences {
    private static final int[] NOWHERE = {};
    private static final @Nullable Object[] NOTHING = {};

    int[] places = NOWHERE;
    @Nullable Object[] before = NOTHING;
    @Nullable Object[] after = NOTHING;
    int count;

    /**
     * Adds what differs in an entry.
     *
     * @param base its first reference in the wide layout
     * @return references that it takes there
     */
    @SuppressWarnings("ReferenceEquality") // what is kept by reference is the same only if it is it
    int add(int base, WorldState a, int i, WorldState b, int k) {
        int n = Math.max(a.counts[i], b.counts[k]);
        for (int r = 0; r < n; r++) {
            Object x = r < a.counts[i] ? a.objects[a.at[i] + r] : null;
            Object y = r < b.counts[k] ? b.objects[b.at[k] + r] : null;
            if (x != y) {
                if (count == places.length) {
                    resize(2 * count + 4);
                }
                places[count] = base + r;
                before[count] = x;
                after[count++] = y;
            }
        }
        return n;
    }

    void resize(int length) {
        places = Arrays.copyOf(places, length);
        before = Arrays.copyOf(before, length);
        after = Arrays.copyOf(after, length);
    }

    /** Sets them in a state of the wide layout. */
    void apply(WorldState wide, boolean forward) {
        for (int i = 0; i < count; i++) {
            if (places[i] < 0 || places[i] >= wide.objectCount) {
                throw new StateException(
                        "the delta is damaged: reference "
                                + places[i]
                                + " is to be changed, of "
                                + wide.objectCount);
            }
        }
        @Nullable Object[] values = forward ? after : before;
        for (int i = 0; i < count; i++) {
            wide.objects[places[i]] = values[i];
        }
    }
}
