package dev.cairn.core.state;

import org.jspecify.annotations.Nullable;

import java.util.Arrays;

/**
 * How the entries of two states correspond. Those at the beginning and at the end are the same by
 * name and kind; what lies between is in one of the states only, such as a table of entities that
 * was not there before. Of those that correspond some are longer in one state.
 *
 * <p>The wide layout has the entries that correspond, each as long as in the longer state, with
 * zeros behind the shorter one: in it two states can be subtracted word by word.
 *
 * @param head entries that correspond at the beginning
 * @param before entries that only the first state has, behind them
 * @param after entries that only the second state has
 * @param tail entries that correspond at the end
 * @param resized of those that correspond and differ in length: number, length before, length after
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
record Alignment(int head, int before, int after, int tail, int[] resized) {
    static Alignment of(WorldState a, WorldState b) {
        int common = Math.min(a.entries, b.entries);
        int head = 0;
        while (head < common && same(a, head, b, head)) {
            head++;
        }
        int tail = 0;
        while (tail < common - head && same(a, a.entries - 1 - tail, b, b.entries - 1 - tail)) {
            tail++;
        }
        int[] resized = new int[0];
        int count = 0;
        for (int m = 0; m < head + tail; m++) {
            int ea = m < head ? m : a.entries - tail + m - head;
            int eb = m < head ? m : b.entries - tail + m - head;
            if (a.counts[ea] != b.counts[eb]) {
                if (resized.length == count) {
                    resized = Arrays.copyOf(resized, 2 * count + 24);
                }
                resized[count++] = m;
                resized[count++] = a.counts[ea];
                resized[count++] = b.counts[eb];
            }
        }
        return new Alignment(
                head,
                a.entries - head - tail,
                b.entries - head - tail,
                tail,
                Arrays.copyOf(resized, count));
    }

    private static boolean same(WorldState a, int i, WorldState b, int k) {
        return a.kinds[i] == b.kinds[k] && a.names[i].equals(b.names[k]);
    }

    boolean isInPlace() {
        return before == 0 && after == 0 && resized.length == 0;
    }

    /** Entries that correspond. */
    int count() {
        return head + tail;
    }

    /** Lays a state out widely. */
    void widen(WorldState from, int only, WorldState to) {
        to.clear();
        int r = 0;
        for (int m = 0; m < count(); m++) {
            int e = m < head ? m : m + only;
            int length = from.counts[e];
            if (r < resized.length && resized[r] == m) {
                length = Math.max(resized[r + 1], resized[r + 2]);
                r += 3;
            }
            to.append(from, e, length);
        }
    }

    /**
     * Lays a wide state out as one of the two.
     *
     * @param wide as {@link #widen} leaves it
     * @param only what only this state has; null for nothing
     * @param side 1 for the state before, 2 for that after
     */
    void narrow(WorldState wide, @Nullable WorldState only, int side, WorldState to) {
        to.clear();
        int r = 0;
        for (int m = 0; m <= count(); m++) {
            for (int i = 0; m == head && only != null && i < only.entries; i++) {
                to.append(only, i, only.counts[i]);
            }
            if (m == count()) {
                return;
            }
            int length = wide.counts[m];
            if (r < resized.length && resized[r] == m) {
                length = resized[r + side];
                r += 3;
            }
            to.append(wide, m, length);
        }
    }
}
