package dev.cairn.physics.solver;

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
 * word. The colours are a function of the order of the contacts alone.
 *
 * <p>Source: E. Catto, Box3D's constraint graph (2025), but made anew each tick.
 */
final class Colouring {
    private static final int MASKED = 64;

    /** Colours in use, and the place where each starts; one more for the end of the last. */
    int colours;

    int[] start = {};

    private long[] used = {};
    private long[] usedCold = {};
    private int[] next = {};
    private int[] still = {};

    /** By row: its colour among those of its family. */
    private int[] colour = {};

    /** Rows of each colour by family: masked, masked and cold, more, against what does not move. */
    private final int[] masked = new int[MASKED];

    private final int[] cold = new int[MASKED];

    private int[] more = new int[16];
    private int[] fixed = new int[16];
    private int moreColours;
    private int fixedColours;

    void begin(int slots, int rows) {
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
        Arrays.fill(masked, 0);
        Arrays.fill(cold, 0);
        Arrays.fill(more, 0, moreColours, 0);
        Arrays.fill(fixed, 0, fixedColours, 0);
        moreColours = 0;
        fixedColours = 0;
    }

    /** Row {@code m} is a contact of two bodies that move; {@code isCold} if nothing presses. */
    void add(int m, int a, int b, boolean isCold) {
        long[] taken = isCold ? usedCold : used;
        long free = ~(taken[a] | taken[b]);
        if (free != 0) {
            long bit = Long.lowestOneBit(free);
            taken[a] |= bit;
            taken[b] |= bit;
            int c = Long.numberOfTrailingZeros(bit);
            colour[m] = isCold ? MASKED + c : c;
            (isCold ? cold : masked)[c]++;
            return;
        }
        int k = Math.max(next[a], next[b]);
        next[a] = k + 1;
        next[b] = k + 1;
        if (k >= moreColours) {
            moreColours = k + 1;
            if (k >= more.length) {
                more = Arrays.copyOf(more, 2 * k);
            }
        }
        colour[m] = 2 * MASKED + k;
        more[k]++;
    }

    /** Row {@code m} is a contact of {@code body} with something that does not move. */
    void addFixed(int m, int body) {
        int k = still[body]++;
        if (k >= fixedColours) {
            fixedColours = k + 1;
            if (k >= fixed.length) {
                fixed = Arrays.copyOf(fixed, 2 * k);
            }
        }
        colour[m] = -1 - k;
        fixed[k]++;
    }

    /** Gives each row its place, and pads each colour to whole groups. */
    void finish(ConstraintRows rows) {
        int most = 2 * MASKED + moreColours + fixedColours + 1;
        if (start.length < most) {
            start = new int[2 * most];
        }
        colours = 0;
        int at = 0;
        for (int k = 0; k < MASKED; k++) {
            at = open(cold, k, at, rows.lanes);
        }
        for (int k = 0; k < MASKED; k++) {
            at = open(masked, k, at, rows.lanes);
        }
        for (int k = 0; k < moreColours; k++) {
            at = open(more, k, at, rows.lanes);
        }
        for (int k = 0; k < fixedColours; k++) {
            at = open(fixed, k, at, rows.lanes);
        }
        start[colours] = at;
        rows.places = at;
        rows.ensurePlaces(at);
        for (int m = 0; m < rows.count; m++) {
            rows.place[m] = take(colour[m]);
        }
        pad(rows);
    }

    private int take(int c) {
        if (c < 0) {
            return fixed[-1 - c]++;
        }
        if (c < MASKED) {
            return masked[c]++;
        }
        return c < 2 * MASKED ? cold[c - MASKED]++ : more[c - 2 * MASKED]++;
    }

    /** Turns the number of rows of a colour into its first place; the end of its padding. */
    private int open(int[] tally, int k, int at, int lanes) {
        int n = tally[k];
        if (n == 0) {
            return at;
        }
        start[colours++] = at;
        tally[k] = at;
        return at + (n + lanes - 1) / lanes * lanes;
    }

    /** The places that no row takes bind nothing to nothing. */
    private void pad(ConstraintRows rows) {
        for (int c = 0; c < colours; c++) {
            int end = start[c + 1];
            int groupStart = end - rows.lanes;
            for (int j = groupStart; j < end; j++) {
                Arrays.fill(rows.link, j * ConstraintRows.LINK, (j + 1) * ConstraintRows.LINK, 0);
                rows.unloaded[j] = 0;
            }
        }
    }
}
