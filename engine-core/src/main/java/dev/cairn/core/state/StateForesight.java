package dev.cairn.core.state;

/**
 * What somebody knows about a state's numbers, so that a {@link StateDelta} need not tell it: that
 * two columns hold the same, that one is what another was a tick ago, or that a third follows from
 * both. A state that declares one by {@link StateVisitor#reference} is packed before it is
 * compared: numbers that can be foreseen from others of the same state are replaced by how far the
 * guess is off. A wrong guess costs room and nothing else.
 *
 * <pre>
 *   before ─ pack ─▶ packed ──┐
 *                             xor ─▶ delta          of those rows only that have changed
 *   after  ─ pack ─▶ packed ──┘
 * </pre>
 *
 * <p>A remembered number needs no room though both directions must find it: let u be a number and l
 * what it was in the state before. Packed, the first state has them exchanged, and the exclusive or
 * of the l's is 0, that of the u's one word for both directions:
 *
 * <pre>
 *   first   l, u   as  u, l          l' = u, so  u ^ l' = 0
 *   second  l', u' as  l', u'                    l ^ u' leads from l to u' and back
 * </pre>
 *
 * <p>Without fields that change, so that any thread may ask; the same object in all states of a
 * kind of world.
 */
public interface StateForesight {
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
     * Replaces numbers of some rows. Must not throw, whatever the state and the rows are: they may
     * come from damaged bytes.
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
