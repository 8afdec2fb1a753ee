package dev.cairn.core.state;

import org.jspecify.annotations.Nullable;

import java.util.Arrays;

/**
 * The numbers of a state by the names of their columns, for a {@link Predictor}. Whoever writes
 * changes a state in place, or a copy of the columns that are written. One thread.
 */
public final class StateColumns {
    private final WorldState state;

    /** Columns that were written, and by entry of the state which of these; null in place. */
    private final @Nullable WorldState copies;

    private final int[] copyOf;

    private StateColumns(WorldState state, @Nullable WorldState copies) {
        this.state = state;
        this.copies = copies;
        copyOf = new int[copies == null ? 0 : state.entries];
        Arrays.fill(copyOf, -1);
    }

    static StateColumns inPlace(WorldState state) {
        return new StateColumns(state, null);
    }

    static StateColumns copying(WorldState state) {
        return new StateColumns(state, new WorldState());
    }

    /** The one that predicts the state; null if there is none. */
    static @Nullable Predictor predictor(WorldState state) {
        for (int i = 0; i < state.objectCount; i++) {
            if (state.objects[i] instanceof Predictor known) {
                return known;
            }
        }
        return null;
    }

    /** Who has an entry: the state, or what was written. */
    WorldState holder(int entry) {
        return copies != null && copyOf[entry] >= 0 ? copies : state;
    }

    /** Number of an entry in its holder. */
    int place(int entry) {
        return copies != null && copyOf[entry] >= 0 ? copyOf[entry] : entry;
    }

    /**
     * The next section of a name.
     *
     * @param name as it was declared
     * @param behind a section, or -1
     * @return its number, -1 if there is none
     */
    public int section(String name, int behind) {
        for (int e = behind + 1; e < state.entries; e++) {
            if (state.kinds[e] == WorldState.SECTION && name.equals(state.names[e])) {
                return e;
            }
        }
        return -1;
    }

    /**
     * A column of longs or doubles.
     *
     * @param section number of its section
     * @param name as it was declared
     * @return its number, -1 if there is none
     */
    public int wide(int section, String name) {
        int e = find(section, name);
        boolean fits = e >= 0 && WorldState.WIDTH[state.kinds[e]] == 8;
        return fits && state.kinds[e] >= WorldState.INTS ? e : -1;
    }

    /**
     * A column of ints.
     *
     * @param section number of its section
     * @param name as it was declared
     * @return its number, -1 if there is none
     */
    public int ints(int section, String name) {
        int e = find(section, name);
        return e >= 0 && state.kinds[e] == WorldState.INTS ? e : -1;
    }

    /**
     * A column of bytes, or of booleans as 0 and 1.
     *
     * @param section number of its section
     * @param name as it was declared
     * @return its number, -1 if there is none
     */
    public int bytes(int section, String name) {
        int e = find(section, name);
        boolean fits = e >= 0 && WorldState.WIDTH[state.kinds[e]] == 1;
        return fits && state.kinds[e] >= WorldState.INTS ? e : -1;
    }

    /**
     * A column of references.
     *
     * @param section number of its section
     * @param name as it was declared
     * @return its number, -1 if there is none
     */
    public int objects(int section, String name) {
        int e = find(section, name);
        return e >= 0 && state.kinds[e] == WorldState.REFERENCES ? e : -1;
    }

    private int find(int section, String name) {
        int e = section + 1;
        while (section >= 0 && e < state.entries && state.kinds[e] != WorldState.SECTION) {
            if (name.equals(state.names[e])) {
                return e;
            }
            e++;
        }
        return -1;
    }

    /**
     * How many elements a column has.
     *
     * @param column its number; -1 has none
     * @return at least 0
     */
    public int count(int column) {
        return column < 0 ? 0 : state.counts[column];
    }

    /**
     * The next element in which a wide column differs from one of another state.
     *
     * @param column its number
     * @param other the other state
     * @param otherColumn number of the column there
     * @param from first element that is looked at
     * @return its index, -1 if there is none among those that both have
     */
    public int mismatch(int column, StateColumns other, int otherColumn, int from) {
        WorldState a = holder(column);
        WorldState b = other.holder(otherColumn);
        int i = a.at[place(column)] + 8 * from;
        int k = b.at[other.place(otherColumn)] + 8 * from;
        int length = 8 * (Math.min(count(column), other.count(otherColumn)) - from);
        int at = length <= 0 ? -1 : Arrays.mismatch(a.bytes, i, i + length, b.bytes, k, k + length);
        return at < 0 ? -1 : from + at / 8;
    }

    /**
     * An element of a wide column.
     *
     * @param column its number
     * @param i below count
     * @return all bits
     */
    public long bits(int column, int i) {
        WorldState s = holder(column);
        return (long) StateWriter.LONG.get(s.bytes, s.at[place(column)] + 8 * i);
    }

    /**
     * An element of a wide column.
     *
     * @param column its number
     * @param i below count
     * @return as a double
     */
    public double number(int column, int i) {
        return Double.longBitsToDouble(bits(column, i));
    }

    /**
     * Writes an element of a wide column.
     *
     * @param column its number
     * @param i below count
     * @param bits all bits
     */
    public void set(int column, int i, long bits) {
        if (copies != null && copyOf[column] < 0) {
            copyOf[column] = copies.entries;
            copies.append(state, column, state.counts[column]);
        }
        WorldState s = holder(column);
        StateWriter.LONG.set(s.bytes, s.at[place(column)] + 8 * i, bits);
    }

    /**
     * An element of a column of ints.
     *
     * @param column its number
     * @param i below count
     * @return its value
     */
    public int integer(int column, int i) {
        return (int) StateWriter.INT.get(state.bytes, state.at[column] + 4 * i);
    }

    /**
     * An element of a column of bytes.
     *
     * @param column its number
     * @param i below count
     * @return its value
     */
    public byte octet(int column, int i) {
        return state.bytes[state.at[column] + i];
    }

    /**
     * An element of a column of references.
     *
     * @param column its number
     * @param i below count
     * @return the object
     */
    public @Nullable Object object(int column, int i) {
        return state.objects[state.at[column] + i];
    }

    /**
     * What somebody knows about a state's numbers, so that a {@link StateDelta} need not tell it:
     * that two columns hold the same, that one is what another was a tick ago, or that a third
     * follows from both. A state that declares one by {@link StateVisitor#reference} is packed
     * before it is compared: numbers that can be predicted from others of the same state are
     * replaced by how far the guess is off. A wrong guess costs room and nothing else.
     *
     * <pre>
     *   before ─ pack ─▶ packed ──┐
     *                             xor ─▶ delta          of those rows only that have changed
     *   after  ─ pack ─▶ packed ──┘
     * </pre>
     *
     * <p>A remembered number needs no room though both directions must find it: let u be a number
     * and l what it was in the state before. Packed, the first state has them exchanged, and the
     * exclusive or of the l's is 0, that of the u's one word for both directions:
     *
     * <pre>
     *   first   l, u   as  u, l          l' = u, so  u ^ l' = 0
     *   second  l', u' as  l', u'                    l ^ u' leads from l to u' and back
     * </pre>
     *
     * <p>Without fields that change, so that any thread may ask; the same object in all states of a
     * kind of world.
     */
    public interface Predictor {
        /**
         * Which rows are packed: those of which it is worth it.
         *
         * @param before the first state
         * @param after the second state
         * @return ascending numbers, at least 0, that say something to this object; it is told them
         *     again with the delta
         */
        int[] rows(StateColumns before, StateColumns after);

        /**
         * Replaces numbers of some rows. Must not throw, whatever the state and the rows are: they
         * may come from damaged bytes.
         *
         * @param state one of the two
         * @param rows as {@link #rows} has told them, or of another delta
         * @param isFirst whether it is the first one
         */
        void pack(StateColumns state, int[] rows, boolean isFirst);

        /**
         * Finds them again, bit by bit: the inverse of {@link #pack}, and as sure.
         *
         * @param state packed
         * @param rows the same
         * @param isFirst the same
         */
        void unpack(StateColumns state, int[] rows, boolean isFirst);
    }
}
