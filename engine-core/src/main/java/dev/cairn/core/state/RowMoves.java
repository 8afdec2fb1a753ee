package dev.cairn.core.state;

import org.jspecify.annotations.Nullable;

import java.util.Arrays;

/**
 * How the rows of two states correspond, which keep their order while some leave and others come,
 * see {@link StateVisitor#rows}. In the wide layout every row has a place of its own:
 *
 * <pre>
 *   before  a b c d        steps  2 kept, 1 gone, 0 come     wide  a b c d -
 *   after   a b   d e             1 kept, 0 gone, 1 come           a b - d e
 * </pre>
 *
 * @param steps by turns: rows that both have, that only the first has, that only the second has
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
record RowMoves(int[] steps) {
    private static final int STEP = 3;

    /** Rows that lie where they would lie without moves need none: null. */
    static @Nullable RowMoves between(long[] before, long[] after) {
        int head = Arrays.mismatch(before, after);
        if (head < 0 || head == Math.min(before.length, after.length)) {
            return null;
        }
        int[] partner = partners(before, after, head);
        boolean[] keeps = longestAscent(partner, head);
        int[] steps = new int[4 * STEP];
        int count = 0;
        int kept = head;
        int i = head;
        int k = head;
        while (i < before.length || k < after.length) {
            int gone = i;
            while (i < before.length && !keeps[i]) {
                i++;
            }
            int come = k;
            k = i < before.length ? partner[i] : after.length;
            if (count + STEP > steps.length) {
                steps = Arrays.copyOf(steps, 2 * count);
            }
            steps[count++] = kept;
            steps[count++] = i - gone;
            steps[count++] = k - come;
            kept = 0;
            while (i < before.length && keeps[i] && partner[i] == k) {
                i++;
                k++;
                kept++;
            }
        }
        if (kept > 0) {
            steps = Arrays.copyOf(steps, count + STEP);
            steps[count] = kept;
            count += STEP;
        }
        return new RowMoves(Arrays.copyOf(steps, count));
    }

    /**
     * By row before: which row after has the same key, the first with the first where several have;
     * -1 for none. By way of lists of the rows whose keys have the same upper bits of a product.
     */
    private static int[] partners(long[] before, long[] after, int head) {
        int bits = 64 - Long.numberOfLeadingZeros(before.length);
        int[] list = new int[1 << bits];
        int[] next = new int[before.length];
        int[] partner = new int[before.length];
        Arrays.fill(list, -1);
        Arrays.fill(partner, -1);
        for (int i = before.length - 1; i >= head; i--) {
            int slot = slot(before[i], bits);
            next[i] = list[slot];
            list[slot] = i;
        }
        for (int k = head; k < after.length; k++) {
            int slot = slot(after[k], bits);
            int last = -1;
            int i = list[slot];
            while (i >= 0 && before[i] != after[k]) {
                last = i;
                i = next[i];
            }
            if (i >= 0) {
                partner[i] = k;
                if (last < 0) {
                    list[slot] = next[i];
                } else {
                    next[last] = next[i];
                }
            }
        }
        return partner;
    }

    private static int slot(long key, int bits) {
        return (int) ((key * DeltaWords.ODD) >>> (64 - bits));
    }

    /**
     * Which rows keep their order: a longest ascending part of their partners, by patience sorting
     * (Fredman 1975, On computing the length of longest increasing subsequences).
     */
    private static boolean[] longestAscent(int[] partner, int head) {
        int[] end = new int[partner.length];
        int[] previous = new int[partner.length];
        int length = 0;
        for (int i = head; i < partner.length; i++) {
            if (partner[i] < 0) {
                continue;
            }
            int low = 0;
            int high = length;
            while (low < high) {
                int middle = (low + high) >>> 1;
                if (partner[end[middle]] < partner[i]) {
                    low = middle + 1;
                } else {
                    high = middle;
                }
            }
            end[low] = i;
            previous[i] = low == 0 ? -1 : end[low - 1];
            length = Math.max(length, low + 1);
        }
        boolean[] keeps = new boolean[partner.length];
        for (int i = length == 0 ? -1 : end[length - 1]; i >= 0; i = previous[i]) {
            keeps[i] = true;
        }
        return keeps;
    }

    /** How many rows a state has, or the wide layout. */
    long rows(boolean isBefore, boolean isAfter) {
        long rows = 0;
        for (int s = 0; s < steps.length; s += STEP) {
            rows += steps[s] + (isBefore ? steps[s + 1] : 0L) + (isAfter ? steps[s + 2] : 0L);
        }
        return rows;
    }

    /**
     * Lays the rows of a column out widely, or back.
     *
     * @param from has the column
     * @param entry its number there
     * @param width elements to a row
     * @param isBefore whether it is of the first state
     * @param widens whether to the wide layout
     * @param to where the column is put behind all others
     */
    void lay(
            WorldState from,
            int entry,
            int width,
            boolean isBefore,
            boolean widens,
            WorldState to) {
        long rows = rows(isBefore || widens, !isBefore || widens);
        to.append(from, entry, 0, Math.toIntExact(width * rows));
        int wide = 0;
        int narrow = 0;
        for (int s = 0; s < steps.length; s += STEP) {
            int own = steps[s] + (isBefore ? steps[s + 1] : 0);
            move(from, entry, to, width, widens, narrow, wide, own);
            wide += steps[s] + steps[s + 1];
            narrow += own;
            if (!isBefore) {
                move(from, entry, to, width, widens, narrow, wide, steps[s + 2]);
                narrow += steps[s + 2];
            }
            wide += steps[s + 2];
        }
    }

    private static void move(
            WorldState from,
            int entry,
            WorldState to,
            int width,
            boolean widens,
            int narrow,
            int wide,
            int rows) {
        int source = width * (widens ? narrow : wide);
        int target = width * (widens ? wide : narrow);
        to.put(from, entry, source, target, width * rows);
    }
}
