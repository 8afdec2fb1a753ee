package dev.cairn.core.state;

import java.lang.invoke.MethodHandles;
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
        return new StateCodecs.Functions<>(type, name, writing, reading);
    }

    /**
     * A codec of a record that follows from its components: primitives, texts, constants of enums,
     * arrays of primitives, and records of such; all but primitives may be null. The names and
     * types of the components are written once with the records, and a record whose components are
     * others by then is refused with the name of the first that differs.
     *
     * @param type the record
     * @param <T> the record
     * @return the codec, under the name of the class
     * @throws IllegalArgumentException if there is a component of another type, or the module of
     *     the record keeps it from us
     */
    static <T extends Record> StateCodec<T> ofRecord(Class<T> type) {
        return ofRecord(MethodHandles.lookup(), type);
    }

    /**
     * The same for records in a named module that is not open to {@code dev.cairn.core}.
     *
     * @param lookup {@code MethodHandles.lookup()} of a class in the package of the record
     * @param type the record
     * @param <T> the record
     * @return the codec, under the name of the class
     * @throws IllegalArgumentException if there is a component of another type, or it is not
     *     reached
     */
    static <T extends Record> StateCodec<T> ofRecord(MethodHandles.Lookup lookup, Class<T> type) {
        return new RecordParts<>(lookup, type);
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
