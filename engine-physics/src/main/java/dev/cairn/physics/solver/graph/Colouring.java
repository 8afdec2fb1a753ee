package dev.cairn.physics.solver.graph;

import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.RowList;

import java.util.Arrays;

/**
 * Sorts the contacts into colours: no two of a colour move the same body, so all of a colour may be
 * solved at once, in any order, with the same result.
 *
 * <p>Greedy, in the order of the contact store: a contact of two bodies that move takes the lowest
 * of 64 colours that both still have free. A body with more neighbours goes on to colours of its
 * own count: they are as exact, only narrow. Contacts without an impulse have colours of their own,
 * before the others: most are gaps, and a whole group of gaps costs little. Contacts with what does
 * not move come last, the n-th of a body in the n-th of their colours: the ground has the last
 * word. The colours are a function of the order of the contacts alone. Each batch has its own run
 * of colours, with the same names in the same order; see {@link Batches}.
 *
 * <p>Source: E. Catto, Box3D's constraint graph (2025), but made anew when the contacts change.
 */
public final class Colouring {
    private static final int MASKED = 64;

    /** Sorts of rows in a colour, see {@link #sort}. */
    private static final int SORTS = 3;

    /** Colours in use, and the place where each starts; one more for the end of the last. */
    public int colours;

    public int[] start = {};

    /** Rows of each colour, padding not counted. */
    public int[] size = {};

    /** The first colour of each batch; one more for the end of the last. */
    public int[] firstColour = new int[2];

    /** The first colour of each batch with contacts with what does not move, or the end. */
    public int[] firstFixed = new int[2];

    private long[] used = {};
    private long[] usedCold = {};
    private int[] next = {};
    private int[] still = {};

    /** By row: its colour, those against what does not move below 0. */
    private int[] colour = {};

    /** By colour of the batch in work and sort: the rows, then the next place. */
    private int[] tally = {};

    /** The colour between those of floats and those of doubles. */
    private int divider;

    private int moreColours;
    private int fixedColours;
    private int slots;

    void begin(int slots, int rows) {
        this.slots = slots;
        slots *= 2;
        if (used.length < slots) {
            int n = Math.max(slots, used.length + (used.length >> 1));
            used = new long[n];
            usedCold = new long[n];
            next = new int[n];
            still = new int[n];
        }
        if (colour.length < rows) {
            colour = new int[Math.max(rows, Math.max(64, colour.length + (colour.length >> 1)))];
        }
        Arrays.fill(used, 0, slots, 0L);
        Arrays.fill(usedCold, 0, slots, 0L);
        Arrays.fill(next, 0, slots, 0);
        Arrays.fill(still, 0, slots, 0);
        moreColours = 0;
        fixedColours = 0;
    }

    /**
     * Row {@code m} is a contact of two bodies that move; {@code isCold} if nothing presses. Those
     * in lockstep and those in domains do not see each other's colours.
     */
    void add(int m, int a, int b, boolean isCold, boolean lockstep) {
        if (lockstep) {
            a += slots;
            b += slots;
        }
        long[] taken = isCold ? usedCold : used;
        long free = ~(taken[a] | taken[b]);
        if (free != 0) {
            long bit = Long.lowestOneBit(free);
            taken[a] |= bit;
            taken[b] |= bit;
            int c = Long.numberOfTrailingZeros(bit);
            colour[m] = isCold ? c : MASKED + c;
            return;
        }
        int k = Math.max(next[a], next[b]);
        next[a] = k + 1;
        next[b] = k + 1;
        moreColours = Math.max(moreColours, k + 1);
        colour[m] = 2 * MASKED + k;
    }

    /** Row {@code m} is a contact of {@code body} with something that does not move. */
    void addFixed(int m, int body) {
        int k = still[body]++;
        fixedColours = Math.max(fixedColours, k + 1);
        colour[m] = -1 - k;
    }

    /**
     * Gives each row its place, and pads each colour of a batch to whole groups.
     *
     * @param points of each row
     */
    void finish(RowList list, Batches batches, int[] points) {
        int names = 2 * MASKED + moreColours + fixedColours;
        if (tally.length < SORTS * names) {
            tally = new int[2 * SORTS * names];
        }
        if (firstColour.length < batches.count + 1) {
            firstColour = new int[batches.firstRow.length];
            firstFixed = new int[batches.firstRow.length];
        }
        colours = 0;
        int at = 0;
        for (int b = 0; b < batches.count; b++) {
            firstColour[b] = colours;
            firstFixed[b] = -1;
            if (b == batches.divider) {
                at = divide(list.floats, at);
            } else {
                boolean isSingle = b < batches.divider;
                ConstraintRows rows = isSingle ? list.floats : list.doubles;
                at = place(list, rows, batches, b, names, points, at);
            }
            firstFixed[b] = firstFixed[b] < 0 ? colours : firstFixed[b];
        }
        firstColour[batches.count] = colours;
        ensureColours(colours + 1);
        start[colours] = at;
        end(list.doubles, at);
        pad(list.floats, 0, divider);
        pad(list.doubles, divider + 1, colours);
    }

    /** An empty colour tells where the rows of floats end; those of doubles start anew. */
    private int divide(ConstraintRows floats, int at) {
        ensureColours(colours + 2);
        divider = colours++;
        start[divider] = at;
        size[divider] = 0;
        end(floats, at);
        return 0;
    }

    private static void end(ConstraintRows rows, int places) {
        rows.places = places;
        rows.ensurePlaces(places);
    }

    /**
     * Gives the rows of a batch their places, from {@code at} on; returns the end. Of a colour
     * those of one point come first, then those of two: a group has one kernel, that of its row
     * with most points.
     */
    private int place(
            RowList list,
            ConstraintRows rows,
            Batches batches,
            int batch,
            int names,
            int[] points,
            int at) {
        int from = batches.firstRow[batch];
        int to = batches.firstRow[batch + 1];
        if (from == to) {
            return at;
        }
        int[] byBatch = batches.byBatch;
        Arrays.fill(tally, 0, SORTS * names, 0);
        int least = names;
        int most = 0;
        for (int k = from; k < to; k++) {
            int m = byBatch[k];
            int c = name(colour[m]);
            tally[SORTS * c + sort(points[m])]++;
            least = Math.min(least, c);
            most = Math.max(most, c);
        }
        ensureColours(colours + most - least + 2);
        int end = at;
        for (int c = least; c <= most; c++) {
            int n = 0;
            for (int t = SORTS * c; t < SORTS * (c + 1); t++) {
                int of = tally[t];
                tally[t] = end + n;
                n += of;
            }
            if (n > 0) {
                if (c >= names - fixedColours && firstFixed[batch] < 0) {
                    firstFixed[batch] = colours;
                }
                start[colours] = end;
                size[colours++] = n;
                end += (n + rows.group - 1) / rows.group * rows.group;
            }
        }
        for (int k = from; k < to; k++) {
            int m = byBatch[k];
            list.place[m] = tally[SORTS * name(colour[m]) + sort(points[m])]++;
        }
        return end;
    }

    /** Rows of one kernel: of one point, of two, of more. */
    private static int sort(int points) {
        return points <= 1 ? 0 : points == 2 ? 1 : 2;
    }

    /** The colour's number among all, in the order of solving. */
    private int name(int c) {
        return c >= 0 ? c : 2 * MASKED + moreColours - 1 - c;
    }

    private void ensureColours(int n) {
        if (start.length < n) {
            start = Arrays.copyOf(start, 2 * n);
            size = Arrays.copyOf(size, 2 * n);
        }
    }

    /** The places that no row takes bind nothing to nothing. */
    private void pad(ConstraintRows rows, int from, int to) {
        for (int c = from; c < to; c++) {
            int end = start[c + 1];
            int groupStart = end - rows.group;
            for (int j = groupStart; j < end; j++) {
                Arrays.fill(rows.link, j * ConstraintRows.LINK, (j + 1) * ConstraintRows.LINK, 0);
                rows.unloaded[j] = 0;
            }
        }
    }
}
