package dev.cairn.core.state;

import org.jspecify.annotations.Nullable;

import java.lang.invoke.MethodHandles;
import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import java.util.function.BiConsumer;
import java.util.function.Function;

/**
 * Which objects can be written: texts, boxed numbers, constants of enumerations that were named
 * here, and whatever has a {@link StateCodec}. Only such classes can come out of bytes. Immutable;
 * any thread.
 */
public final class StateCodecs {
    private final Map<Class<?>, StateCodec<?>> byType;
    private final Map<String, StateCodec<?>> byName;

    /** What every program has. */
    public static final StateCodecs STANDARD =
            new StateCodecs(Map.of(), Map.of())
                    .with(
                            codec(
                                    String.class,
                                    (v, out) -> out.writeString(v),
                                    StateInput::readString),
                            codec(Integer.class, (v, out) -> out.writeInt(v), StateInput::readInt),
                            codec(Long.class, (v, out) -> out.writeLong(v), StateInput::readLong),
                            codec(
                                    Double.class,
                                    (v, out) -> out.writeDouble(v),
                                    StateInput::readDouble),
                            codec(
                                    Boolean.class,
                                    (v, out) -> out.writeBoolean(v),
                                    StateInput::readBoolean));

    private static <T> StateCodec<T> codec(
            Class<T> type, BiConsumer<T, StateOutput> writing, Function<StateInput, T> reading) {
        return StateCodec.of(type, type.getSimpleName(), writing, reading);
    }

    private StateCodecs(Map<Class<?>, StateCodec<?>> byType, Map<String, StateCodec<?>> byName) {
        this.byType = byType;
        this.byName = byName;
    }

    /**
     * These and more.
     *
     * @param more codecs of other classes, or in place of those that are there
     * @return new codecs
     */
    public StateCodecs with(StateCodec<?>... more) {
        Map<Class<?>, StateCodec<?>> types = new HashMap<>(byType);
        Map<String, StateCodec<?>> names = new HashMap<>(byName);
        for (StateCodec<?> codec : more) {
            types.put(codec.type(), codec);
            names.put(codec.name(), codec);
        }
        return new StateCodecs(types, names);
    }

    /**
     * These, for columns with constants of an enumeration.
     *
     * @param type the enumeration
     * @param <E> the same
     * @return new codecs
     */
    public <E extends Enum<E>> StateCodecs withEnum(Class<E> type) {
        return with(
                new Derived<>(type, Objects.requireNonNull(Parts.whole(type), "an enumeration")));
    }

    /**
     * These, and codecs that follow from classes themselves: records by their components as {@link
     * StateCodec#ofRecord} does, enums by the names of their constants, arrays of primitives. Other
     * classes, and those that have a codec, are left as they are: what has none is refused when it
     * would be written.
     *
     * @param types classes of the objects that are to be written
     * @return new codecs
     */
    public StateCodecs derived(Class<?>... types) {
        StateCodecs all = this;
        for (Class<?> type : types) {
            StateCodec<?> codec = all.byType.containsKey(type) ? null : Derived.of(type);
            if (codec != null) {
                all = all.with(codec);
            }
        }
        return all;
    }

    void write(Object value, StateOutput out) {
        Class<?> type =
                value instanceof Enum<?> constant ? constant.getDeclaringClass() : value.getClass();
        StateCodec<?> codec = byType.get(type);
        if (codec == null) {
            throw new StateException(
                    "the state holds an object of "
                            + type.getTypeName()
                            + ", and there is no codec that writes it; add one by"
                            + " StateCodecs.with(..)"
                            + (type.isRecord() ? ", which StateCodec.ofRecord makes" : ""));
        }
        out.writeString(codec.name());
        writeBy(codec, value, out);
    }

    private static <T> void writeBy(StateCodec<T> codec, Object value, StateOutput out) {
        codec.write(codec.type().cast(value), out);
    }

    /** An object; every failure is a StateException. */
    Object read(StateInput in) {
        String name = in.readString();
        StateCodec<?> codec = byName.get(name);
        if (codec == null) {
            throw new StateException(
                    "the state holds an object that was written as '"
                            + name
                            + "', and no codec has this name; add the one that wrote it");
        }
        try {
            return codec.read(in);
        } catch (StateException told) {
            throw told;
        } catch (RuntimeException failure) {
            throw new StateException(
                    "an object that was written as '" + name + "' cannot be made: " + failure,
                    failure);
        }
    }

    /** A codec of two functions. */
    record Functions<T>(
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
}
