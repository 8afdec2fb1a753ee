package dev.cairn.core.state;

import java.util.function.BiConsumer;
import java.util.function.Function;

/**
 * How objects of one class become bytes and come back. States within a process need none: they keep
 * objects by reference.
 *
 * @param <T> the class
 */
public interface StateCodec<T> {
    /**
     * A codec of two functions.
     *
     * @param type as {@link #type}
     * @param name as {@link #name}
     * @param writing as {@link #write}
     * @param reading as {@link #read}
     * @param <T> the class
     * @return the codec
     */
    static <T> StateCodec<T> of(
            Class<T> type,
            String name,
            BiConsumer<T, StateOutput> writing,
            Function<StateInput, T> reading) {
        return new FunctionCodec<>(type, name, writing, reading);
    }

    /**
     * The class whose objects it writes; those of subclasses it does not.
     *
     * @return the class
     */
    Class<T> type();

    /**
     * What the bytes call it; the same in every version that is to read them.
     *
     * @return a name that no other codec has
     */
    String name();

    /**
     * Writes an object.
     *
     * @param value the object
     * @param out takes numbers, texts and further objects
     */
    void write(T value, StateOutput out);

    /**
     * Makes an object of what {@link #write} wrote, and reads no more than that. May throw any
     * exception for what is no such thing.
     *
     * @param in gives it back in the same order
     * @return an object that no later tick can tell from the one that was written
     */
    T read(StateInput in);
}
