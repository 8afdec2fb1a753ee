package dev.cairn.core.state;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * How the entries of two states correspond. Those at the beginning and at the end are the same by
 * name and kind; what lies between is in one of the states only, such as a table of entities that
 * was not there before. Of those that correspond some are longer in one state, and some hold rows
 * that lie elsewhere in the other one.
 *
 * <p>The wide layout has the entries that correspond, each as long as in the longer state, with
 * zeros behind the shorter one, or with room for the rows of both; in it two states can be
 * subtracted word by word.
 *
 * @param head entries that correspond at the beginning
 * @param before entries that only the first state has, behind them
 * @param after entries that only the second state has
 * @param tail entries that correspond at the end
 * @param resized of those that correspond and lie differently: number, length before, length after,
 *     number of its moves or -1
 * @param moves of rows
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
record Alignment(int head, int before, int after, int tail, int[] resized, List<RowMoves> moves) {
    /** Numbers to an entry of {@link #resized}. */
    static final int NUMBERS = 4;

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
        List<RowMoves> moves = new ArrayList<>();
        int section = -1;
        boolean hasMoves = false;
        for (int m = 0; m < head + tail; m++) {
            int ea = m < head ? m : a.entries - tail + m - head;
            int eb = m < head ? m : b.entries - tail + m - head;
            if (a.kinds[ea] == WorldState.SECTION) {
                RowMoves found = moves(a, ea, b, eb);
                hasMoves = found != null;
                section = ea - eb;
                if (found != null) {
                    moves.add(found);
                }
            }
            boolean moved =
                    hasMoves
                            && section == ea - eb
                            && a.kinds[ea] >= WorldState.INTS
                            && width(moves.getLast(), a.counts[ea], b.counts[eb]) > 0;
            if (moved || a.counts[ea] != b.counts[eb]) {
                if (resized.length == count) {
                    resized = Arrays.copyOf(resized, 2 * count + 8 * NUMBERS);
                }
                resized[count++] = m;
                resized[count++] = a.counts[ea];
                resized[count++] = b.counts[eb];
                resized[count++] = moved ? moves.size() - 1 : -1;
            }
        }
        return new Alignment(
                head,
                a.entries - head - tail,
                b.entries - head - tail,
                tail,
                Arrays.copyOf(resized, count),
                moves);
    }

    private static boolean same(WorldState a, int i, WorldState b, int k) {
        return a.kinds[i] == b.kinds[k] && a.names[i].equals(b.names[k]);
    }

    /** Where the rows of a section went, from the two columns that tell them apart. */
    private static @Nullable RowMoves moves(WorldState a, int ea, WorldState b, int eb) {
        if (a.counts[ea] == 0 || b.counts[eb] == 0) {
            return null;
        }
        long[] before = keys(a, ea);
        long[] after = keys(b, eb);
        return before == null || after == null ? null : RowMoves.between(before, after);
    }

    private static long @Nullable [] keys(WorldState s, int section) {
        int first = ints(s, section, section);
        int second = first < 0 ? first : ints(s, section, first);
        if (second < 0) {
            return null;
        }
        long[] keys = new long[s.counts[section]];
        for (int row = 0; row < keys.length; row++) {
            long a = (int) StateWriter.INT.get(s.bytes, s.at[first] + 4 * row);
            int b = (int) StateWriter.INT.get(s.bytes, s.at[second] + 4 * row);
            keys[row] = (a << 32) | (b & 0xFFFF_FFFFL);
        }
        return keys;
    }

    /** The next column of ints behind an entry with one element to a row; -1 if there is none. */
    private static int ints(WorldState s, int section, int behind) {
        int e = behind + 1;
        while (e < s.entries && s.kinds[e] != WorldState.SECTION) {
            if (s.kinds[e] == WorldState.INTS && s.counts[e] == s.counts[section]) {
                return e;
            }
            e++;
        }
        return -1;
    }

    /** Elements to a row, if a column of these lengths holds the rows; or 0. */
    static int width(RowMoves moves, int before, int after) {
        long rows = moves.rows(true, false);
        long width = rows == 0 ? 0 : before / rows;
        return width * rows == before && width * moves.rows(false, true) == after ? (int) width : 0;
    }

    boolean isInPlace() {
        return before == 0 && after == 0 && resized.length == 0;
    }

    /** Entries that correspond. */
    int count() {
        return head + tail;
    }

    /** Columns of the same rows have the same lengths mostly: those that differ are there once. */
    void write(StateOutput out) {
        out.writeShort(head);
        out.writeShort(before);
        out.writeShort(after);
        out.writeShort(tail);
        out.writeShort(moves.size());
        for (RowMoves one : moves) {
            out.writeShort(one.steps().length);
            for (int rows : one.steps()) {
                out.writeShort(rows);
            }
        }
        int count = resized.length / NUMBERS;
        int[] number = new int[count];
        int[] firsts = new int[count];
        int different = 0;
        for (int i = 0; i < count; i++) {
            int n = 0;
            while (n < different && !isLike(firsts[n], i)) {
                n++;
            }
            firsts[n] = n == different ? i : firsts[n];
            different += n == different ? 1 : 0;
            number[i] = n;
        }
        out.writeShort(different);
        for (int n = 0; n < different; n++) {
            int r = NUMBERS * firsts[n];
            int longer = resized[r + 2] - resized[r + 1];
            out.writeShort(resized[r + 1]);
            out.writeShort((longer << 1) ^ (longer >> 31));
            out.writeShort(resized[r + 3] + 1);
        }
        out.writeShort(count);
        for (int i = 0; i < count; i++) {
            out.writeShort(resized[NUMBERS * i] - (i == 0 ? 0 : resized[NUMBERS * (i - 1)]));
            out.writeShort(number[i]);
        }
    }

    private boolean isLike(int i, int k) {
        return Arrays.equals(
                resized,
                NUMBERS * i + 1,
                NUMBERS * i + NUMBERS,
                resized,
                NUMBERS * k + 1,
                NUMBERS * k + NUMBERS);
    }

    /** What {@link #write} wrote; of numbers that make no sense nothing else is so. */
    static Alignment read(StateInput in) {
        int head = in.readShort();
        int before = in.readShort();
        int after = in.readShort();
        int tail = in.readShort();
        int moved = in.need(1, in.readShort());
        List<RowMoves> moves = new ArrayList<>(moved);
        for (int i = 0; i < moved; i++) {
            int[] steps = new int[in.need(1, in.readShort())];
            for (int k = 0; k < steps.length; k++) {
                steps[k] = in.readShort();
            }
            moves.add(new RowMoves(steps));
        }
        int different = in.need(3, in.readShort());
        int[] lengths = new int[3 * different];
        for (int n = 0; n < lengths.length; n += 3) {
            lengths[n] = in.readShort();
            int longer = in.readShort();
            lengths[n + 1] = lengths[n] + ((longer >>> 1) ^ -(longer & 1));
            lengths[n + 2] = in.readShort() - 1;
        }
        int[] resized = new int[NUMBERS * in.need(2, in.readShort())];
        int last = 0;
        for (int r = 0; r < resized.length; r += NUMBERS) {
            last += in.readShort();
            resized[r] = last;
            int n = in.readShort();
            if (n < 0 || n >= different) {
                throw new StateException(
                        "the delta is damaged: lengths " + n + " are asked for, of " + different);
            }
            System.arraycopy(lengths, 3 * n, resized, r + 1, 3);
        }
        return new Alignment(head, before, after, tail, resized, moves);
    }

    /** The moves of an entry of {@link #resized}, by its place there; null for none. */
    @Nullable RowMoves movesAt(int r) {
        return r < resized.length && resized[r + 3] >= 0 ? moves.get(resized[r + 3]) : null;
    }

    /** Lays an entry out widely, behind what is there. */
    void widen(WorldState from, int entry, int r, boolean isBefore, WorldState to) {
        RowMoves moved = movesAt(r);
        if (moved != null) {
            int width = width(moved, resized[r + 1], resized[r + 2]);
            moved.lay(from, entry, width, isBefore, true, to);
        } else {
            to.append(from, entry, Math.max(resized[r + 1], resized[r + 2]));
        }
    }

    /** Lays a state out widely. */
    void widen(WorldState from, boolean isBefore, WorldState to) {
        to.clear();
        int only = isBefore ? before : after;
        int r = 0;
        for (int m = 0; m < count(); m++) {
            int e = m < head ? m : m + only;
            if (r < resized.length && resized[r] == m) {
                widen(from, e, r, isBefore, to);
                r += NUMBERS;
            } else {
                to.append(from, e, from.counts[e]);
            }
        }
    }

    /**
     * Lays a wide state out as one of the two.
     *
     * @param wide as {@link #widen} leaves it
     * @param only what only this state has; null for nothing
     * @param isBefore whether it is the first one
     */
    void narrow(WorldState wide, @Nullable WorldState only, boolean isBefore, WorldState to) {
        to.clear();
        int r = 0;
        for (int m = 0; m <= count(); m++) {
            for (int i = 0; m == head && only != null && i < only.entries; i++) {
                to.append(only, i, only.counts[i]);
            }
            if (m == count()) {
                return;
            }
            if (r == resized.length || resized[r] != m) {
                to.append(wide, m, wide.counts[m]);
                continue;
            }
            RowMoves moved = movesAt(r);
            if (moved != null) {
                int width = width(moved, resized[r + 1], resized[r + 2]);
                moved.lay(wide, m, width, isBefore, false, to);
            } else {
                to.append(wide, m, isBefore ? resized[r + 1] : resized[r + 2]);
            }
            r += NUMBERS;
        }
    }
}
