package dev.cairn.core.state;

import java.util.function.BiConsumer;
import java.util.function.Function;

/** A codec of two functions. */
record FunctionCodec<T>(
        Class<T> type,
        String name,
        BiConsumer<T, StateOutput> writing,
        Function<StateInput, T> reading)
        implements StateCodec<T> {
    @Override
    public void write(T value, StateOutput out) {
        writing.accept(value, out);
    }

    @Override
    public T read(StateInput in) {
        return reading.apply(in);
    }
}
