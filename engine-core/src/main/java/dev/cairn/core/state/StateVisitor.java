package dev.cairn.core.state;

import org.jspecify.annotations.Nullable;

/**
 * Walks over everything that the next tick depends on: to save it, or to restore it. Who holds such
 * a thing declares it in one place, a method {@link Stateful#state} that hands each of its fields
 * to one of these and keeps what comes back:
 *
 * <pre>{@code
 * public void state(StateVisitor s) {
 *     s.section("clock", this);
 *     count = s.value("count", count);
 *     times = s.array("times", times, count);
 * }
 * }</pre>
 *
 * <p>When it saves, what comes back is what was given; when it restores, it is what was saved. So
 * nothing can be saved and not restored. The fields come in the same order in both directions; an
 * {@code if} may ask for what has come before. Nothing allocates once buffers are large enough.
 */
public interface StateVisitor {
    /**
     * Whether values come back that are others than those given.
     *
     * @return true while restoring
     */
    boolean isRestoring();

    /**
     * What follows belongs to another object.
     *
     * @param name for messages; a constant
     * @param owner whose fields follow
     */
    void section(String name, Object owner);

    /**
     * Tells, directly behind {@link #section}, that arrays of the object hold rows, of one or of
     * several elements each, which keep their order while some leave and others come. The first two
     * arrays of ints with one element to a row tell which row is which. A {@link StateDelta} does
     * not take rows for new ones that have only moved up then; nothing else depends on it.
     *
     * @param count how many rows there are, when it saves
     */
    default void rows(int count) {}

    /**
     * A number.
     *
     * @param name of the field; a constant
     * @param now its value
     * @return what the field shall hold
     */
    int value(String name, int now);

    /**
     * A number of rows, before room for them is made: when it restores, one that the arrays of this
     * object are too short for is refused.
     *
     * @param name of the field; a constant
     * @param now its value
     * @return what the field shall hold
     * @throws StateException if the state is damaged
     */
    default int count(String name, int now) {
        return value(name, now);
    }

    /**
     * A number.
     *
     * @param name of the field; a constant
     * @param now its value
     * @return what the field shall hold
     */
    long value(String name, long now);

    /**
     * A number; all bits of it.
     *
     * @param name of the field; a constant
     * @param now its value
     * @return what the field shall hold
     */
    double value(String name, double now);

    /**
     * A switch.
     *
     * @param name of the field; a constant
     * @param now its value
     * @return what the field shall hold
     */
    boolean value(String name, boolean now);

    /**
     * An object that does not change, or that may be shared by all states that know it.
     *
     * @param name of the field; a constant
     * @param now the object
     * @param <T> its type
     * @return what the field shall hold
     */
    <T extends @Nullable Object> T reference(String name, T now);

    /**
     * The first elements of an array. Those behind them are set to 0, false or null when it is
     * restored, as they are in an array that was never used.
     *
     * @param name of the field; a constant
     * @param now the array, of primitives or references
     * @param count elements that count
     * @param <A> type of the array
     * @return what the field shall hold: the same array unless it is too short
     */
    default <A> A array(String name, A now, int count) {
        return array(name, now, 0, count, count, true);
    }

    /**
     * A range of an array.
     *
     * @param name of the field; a constant
     * @param now the array, of primitives or references
     * @param from first element that counts
     * @param count elements that count
     * @param room length that the array shall have at least after restoring
     * @param clears whether elements behind the range are set to 0, false or null when it is
     *     restored; those of an array of references always are
     * @param <A> type of the array
     * @return what the field shall hold: the same array unless it is too short
     */
    <A> A array(String name, A now, int from, int count, int room, boolean clears);
}
