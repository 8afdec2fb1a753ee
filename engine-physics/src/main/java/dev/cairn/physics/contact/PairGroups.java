package dev.cairn.physics.contact;

import dev.cairn.core.state.StateVisitor;
import dev.cairn.physics.internal.ContactStore;

import java.util.Arrays;

/**
 * The pairs of colliders that may have several contacts, and how many of these touch. A group has a
 * number as long as its pair is there; the first of its rows stays as long, further ones come with
 * the contacts that need them and go when they are empty.
 *
 * <p>Simulation thread. Allocates only when there are more groups than ever.
 */
final class PairGroups {
    /** Numbers that have been used, from 1 on. */
    private int used;

    private int[] free = {};
    private int freeCount;

    /** Of each group, by number: rows that touch; the same at the start of {@link #changes}. */
    private int[] touching = {};

    private int[] before = {};
    private boolean[] hasChanged = {};
    private int[] firstRow = {}, lastRow = {};

    /** Groups that changed in this tick, in the order of rows. */
    int changes;

    private int[] changed = {};

    /** The next row of the same group, by row; -1 at the end. */
    private int[] next = {};

    /** Without groups. */
    PairGroups() {}

    /** A new pair; returns its group's number. */
    int open() {
        int group = freeCount > 0 ? free[--freeCount] : ++used;
        if (group >= touching.length) {
            grow(Math.max(16, 2 * group));
        }
        touching[group] = 0;
        return group;
    }

    private void grow(int n) {
        free = Arrays.copyOf(free, n);
        touching = Arrays.copyOf(touching, n);
        before = Arrays.copyOf(before, n);
        hasChanged = Arrays.copyOf(hasChanged, n);
        changed = Arrays.copyOf(changed, n);
        firstRow = Arrays.copyOf(firstRow, n);
        lastRow = Arrays.copyOf(lastRow, n);
    }

    /** Numbers in use, and how much of each group touches; between ticks nothing is changed. */
    void state(StateVisitor s) {
        s.section("groups", this);
        used = s.count("used", used);
        freeCount = s.value("freeCount", freeCount);
        if (used >= touching.length && used > 0) {
            grow(used + 1);
        }
        free = s.array("free", free, freeCount);
        touching = s.array("touching", touching, used == 0 ? 0 : used + 1); // from 1 on
        changes = s.isRestoring() ? 0 : changes;
    }

    /** A pair is gone; returns whether it touched. */
    boolean close(int group) {
        free[freeCount++] = group;
        return touching[group] > 0;
    }

    /** A row of a group begins to touch, or ceases to. */
    void change(int group, boolean begins, int row) {
        if (!hasChanged[group]) {
            hasChanged[group] = true;
            before[group] = touching[group];
            firstRow[group] = row;
            changed[changes++] = group;
        }
        touching[group] += begins ? 1 : -1;
        if (begins) {
            firstRow[group] = row;
        }
    }

    /**
     * What a change of this tick came to.
     *
     * @param index 0 to changes - 1
     * @return 1 if the pair began to touch, -1 if it ceased, 0 if it did neither
     */
    int outcome(int index) {
        int group = changed[index];
        return (touching[group] > 0 ? 1 : 0) - (before[group] > 0 ? 1 : 0);
    }

    /** A row of a change: the last one that began to touch, if any did. */
    int row(int index) {
        return firstRow[changed[index]];
    }

    /** Forgets the changes. */
    void endChanges() {
        for (int i = 0; i < changes; i++) {
            hasChanged[changed[i]] = false;
        }
        changes = 0;
    }

    /** Lists the rows of each group among the active ones: the first, then the others ascending. */
    void chain(ContactStore c) {
        if (next.length < c.bodyA.length) {
            next = new int[c.bodyA.length];
        }
        for (int i = 0; i < c.activeCount; i++) {
            int row = c.active[i];
            if (c.group[row] > 0) {
                next[row] = -1;
                lastRow[c.group[row]] = row;
            }
        }
        for (int i = 0; i < c.activeCount; i++) {
            int row = c.active[i];
            if (c.group[row] < 0) {
                append(c, -c.group[row], row);
            }
        }
    }

    /** A row more, at the end of its group. */
    void append(ContactStore c, int group, int row) {
        if (next.length <= row) {
            next = Arrays.copyOf(next, Math.max(row + 1, c.bodyA.length));
        }
        next[lastRow[group]] = row;
        next[row] = -1;
        lastRow[group] = row;
    }

    /** The row after one of a group, or -1; valid after {@link #chain}. */
    int next(int row) {
        return next[row];
    }
}
