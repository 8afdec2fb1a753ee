package dev.cairn.physics.solver.graph;

import dev.cairn.core.job.Blocks;
import dev.cairn.physics.solver.row.EdgeList;
import dev.cairn.physics.solver.row.EdgePlaces;

import java.util.Arrays;

/**
 * Sorts the edges into colours: no two of a colour move the same body, so all of a colour may be
 * solved at once, in any order, with the same result.
 *
 * <p>Greedy, in the order of the list, each kind of constraint for itself: an edge between two
 * bodies that move takes the lowest of 64 colours that both still have free. A body with more
 * neighbours goes on to colours of its own count: they are as exact, only narrow. Contacts without
 * an impulse have colours of their own, before the others: most are gaps, and a whole group of gaps
 * costs little. Edges to static bodies come last, the n-th of a body in the n-th of their colours:
 * the ground has the last word. The colours are a function of the order of the edges alone. Each
 * batch has its own run of colours: those of each kind, contacts last, with the same names in the
 * same order; see {@link Batches}.
 *
 * <p>Source: E. Catto, Box3D's constraint graph (2025), but made anew when the edges change.
 */
public final class Colouring {
    private static final int MASKED = 64;

    /**
     * Rows of a colour to a block, at least and at most: whole groups of lanes. All workers wait
     * for the last block of each pass over a colour, some tenths of a microsecond; a row takes as
     * long.
     */
    private static final int FEWEST_TO_A_BLOCK = 16, MOST_TO_A_BLOCK = 64;

    /** Colours for which there is room at first: the first body on fixed ones may come late. */
    private static final int ROOM = 4 * MASKED;

    /** Sorts of rows in a colour, see {@link #sort}. */
    private static final int SORTS = 3;

    /** Colours in use. */
    public int colours;

    /** By colour: its kind of constraint, and its places among the rows of that kind. */
    public int[] kind = new int[ROOM];

    public int[] start = new int[ROOM];

    public int[] end = new int[ROOM];

    /** Rows of each colour, padding not counted. */
    public int[] size = new int[ROOM];

    /** The first colour of each batch; one more for the end of the last. */
    public int[] firstColour = new int[2];

    /** The first colour of each batch with contacts, and with those with static bodies. */
    public int[] firstContact = new int[2];

    public int[] firstFixed = new int[2];

    /** The places of the contacts of each batch. */
    public int[] firstPlace = new int[2];

    public int[] endPlace = new int[2];

    private long[] used = {};
    private long[] usedCold = {};
    private int[] next = {};
    private int[] still = {};

    /** By edge: its colour, those against static bodies below 0. */
    private int[] colour = {};

    /** By colour of the batch and kind in work and sort: the rows, then the next place. */
    private int[] tally = {};

    /** By kind: colours beyond those with a mask, and colours against static bodies. */
    private int[] more = {};

    private int[] fixed = {};

    /** By kind: the next place. */
    private int[] at = {};

    private int kinds;
    private int kindInWork;
    private int slots;

    void begin(int slotCount, EdgeList list) {
        slots = slotCount;
        int n = 2 * slots;
        if (used.length < n) {
            n = Math.max(n, used.length + (used.length >> 1));
            used = new long[n];
            usedCold = new long[n];
            next = new int[n];
            still = new int[n / 2 + 1];
        }
        int rows = list.source.length;
        if (colour.length < rows) {
            colour = new int[Math.max(rows, Math.max(64, colour.length + (colour.length >> 1)))];
        }
        kinds = list.first.length - 1;
        if (more.length < kinds) {
            more = new int[kinds];
            fixed = new int[kinds];
            at = new int[kinds];
        }
        Arrays.fill(more, 0);
        Arrays.fill(fixed, 0);
    }

    /**
     * What follows are edges of another kind, which do not see the colours of the last.
     *
     * @param lockstep whether any of them is in lockstep
     */
    void beginKind(int of, boolean lockstep) {
        kindInWork = of;
        int n = lockstep ? 2 * slots : slots;
        Arrays.fill(used, 0, n, 0L);
        Arrays.fill(usedCold, 0, n, 0L);
        Arrays.fill(next, 0, n, 0);
        Arrays.fill(still, 0, slots, 0);
    }

    /**
     * Edge {@code m} binds two bodies that move; {@code isCold} if it is a contact without impulse.
     * Those in lockstep and those in domains do not see each other's colours.
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
        more[kindInWork] = Math.max(more[kindInWork], k + 1);
        colour[m] = 2 * MASKED + k;
    }

    /** Edge {@code m} binds {@code body} to something that does not move. */
    void addFixed(int m, int body) {
        int k = still[body]++;
        fixed[kindInWork] = Math.max(fixed[kindInWork], k + 1);
        colour[m] = -1 - k;
    }

    /** Gives each edge its place, and pads each colour of a batch to whole groups. */
    void finish(EdgeList list, Batches batches) {
        if (firstColour.length < batches.count + 1) {
            int n = batches.firstRow.length;
            firstColour = new int[n];
            firstContact = new int[n];
            firstFixed = new int[n];
            firstPlace = new int[n];
            endPlace = new int[n];
        }
        colours = 0;
        Arrays.fill(at, 0);
        for (int b = 0; b < batches.count; b++) {
            if (b == batches.divider) {
                // rows of doubles start anew
                end(list, true);
            }
            boolean isSingle = b < batches.divider;
            firstColour[b] = colours;
            for (int k = 1; k < kinds; k++) {
                place(list, k, isSingle, batches, b);
            }
            firstContact[b] = colours;
            firstPlace[b] = at[0];
            firstFixed[b] = -1;
            place(list, 0, isSingle, batches, b);
            firstFixed[b] = firstFixed[b] < 0 ? colours : firstFixed[b];
            endPlace[b] = at[0];
        }
        firstColour[batches.count] = colours;
        end(list, false);
        int doubles = firstColour[batches.divider];
        for (int c = 0; c < colours; c++) {
            pad(list.places(kind[c], c < doubles), c);
        }
    }

    private void end(EdgeList list, boolean isSingle) {
        for (int k = 0; k < kinds; k++) {
            list.places(k, isSingle).ensurePlaces(at[k]);
            at[k] = 0;
        }
    }

    /**
     * Gives the rows of a kind in a batch their places. Of a colour those of one point come first,
     * then those of two: a group has one kernel, that of its row with most points.
     */
    private void place(EdgeList list, int of, boolean isSingle, Batches batches, int batch) {
        int[] byBatch = batches.byBatch;
        int batchEnd = batches.firstRow[batch + 1];
        int from = firstFrom(byBatch, batches.firstRow[batch], batchEnd, list.first[of]);
        int to = firstFrom(byBatch, from, batchEnd, list.first[of + 1]);
        if (from == to) {
            return;
        }
        int names = 2 * MASKED + more[of] + fixed[of];
        if (tally.length < SORTS * names) {
            tally = new int[2 * SORTS * names];
        }
        Arrays.fill(tally, 0, SORTS * names, 0);
        int least = names;
        int most = 0;
        for (int k = from; k < to; k++) {
            int m = byBatch[k];
            int c = name(of, colour[m]);
            tally[SORTS * c + sort(list.variant[m])]++;
            least = Math.min(least, c);
            most = Math.max(most, c);
        }
        ensureColours(colours + most - least + 1);
        int group = list.places(of, isSingle).group();
        int next = at[of];
        for (int c = least; c <= most; c++) {
            int n = 0;
            for (int t = SORTS * c; t < SORTS * (c + 1); t++) {
                int rows = tally[t];
                tally[t] = next + n;
                n += rows;
            }
            if (n > 0) {
                if (of == 0 && c >= names - fixed[of] && firstFixed[batch] < 0) {
                    firstFixed[batch] = colours;
                }
                kind[colours] = of;
                start[colours] = next;
                next += (n + group - 1) / group * group;
                end[colours] = next;
                size[colours++] = n;
            }
        }
        at[of] = next;
        for (int k = from; k < to; k++) {
            int m = byBatch[k];
            list.place[m] = tally[SORTS * name(of, colour[m]) + sort(list.variant[m])]++;
        }
    }

    /** Where the edges from {@code m} on start in an ascending range of them. */
    private static int firstFrom(int[] edges, int from, int to, int m) {
        int low = from;
        int high = to;
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (edges[middle] < m) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low;
    }

    /** Rows of one kernel: of variant 1, of 2, of more. */
    private static int sort(int variant) {
        return variant <= 1 ? 0 : variant == 2 ? 1 : 2;
    }

    /** The colour's number among those of its kind, in the order of solving. */
    private int name(int of, int c) {
        return c >= 0 ? c : 2 * MASKED + more[of] - 1 - c;
    }

    private void ensureColours(int n) {
        if (start.length < n) {
            kind = Arrays.copyOf(kind, 2 * n);
            start = Arrays.copyOf(start, 2 * n);
            end = Arrays.copyOf(end, 2 * n);
            size = Arrays.copyOf(size, 2 * n);
        }
    }

    /** Rows of a colour to a block: a block for each worker, in whole groups of lanes. */
    public static int perBlock(int rows, int workers) {
        if (workers == 1) {
            return rows;
        }
        int groups = Blocks.count(Blocks.count(rows, workers), FEWEST_TO_A_BLOCK);
        return Math.min(MOST_TO_A_BLOCK, FEWEST_TO_A_BLOCK * groups);
    }

    /** The places of a colour that no row takes bind nothing to nothing. */
    private void pad(EdgePlaces rows, int c) {
        for (int j = start[c] + size[c]; j < end[c]; j++) {
            rows.pad(j);
        }
    }
}
