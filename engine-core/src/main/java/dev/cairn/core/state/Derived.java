package dev.cairn.core.state;

import org.jspecify.annotations.Nullable;

import java.lang.invoke.MethodHandles;

/** A codec that follows from the class. */
record Derived<T>(Class<T> type, Parts.Part part) implements StateCodec<T> {
    /** Of an enum, an array of primitives or a record of such; null for other classes. */
    static @Nullable StateCodec<?> of(Class<?> type) {
        if (type.isRecord()) {
            try {
                return new RecordParts<>(MethodHandles.lookup(), type.asSubclass(Record.class));
            } catch (IllegalArgumentException other) {
                return null;
            }
        }
        Parts.Part part = Parts.whole(type);
        return part == null ? null : new Derived<>(type, part);
    }

    @Override
    public String name() {
        return part.name();
    }

    @Override
    public void write(T value, StateOutput out) {
        part.write(value, out);
    }

    @Override
    public T read(StateInput in) {
        Object value = part.read(in);
        if (value == null) {
            throw new StateException("there is no " + part.name());
        }
        return type.cast(value);
    }
}
