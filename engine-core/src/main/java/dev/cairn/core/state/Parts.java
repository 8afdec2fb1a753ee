package dev.cairn.core.state;

import org.jspecify.annotations.Nullable;

import java.lang.reflect.Array;
import java.util.Map;
import java.util.Objects;
import java.util.function.BiConsumer;
import java.util.function.Function;

/** The types that a record is made of: primitives, texts, constants, arrays of primitives. */
final class Parts {
    private static final Map<Class<?>, Part> PRIMITIVES =
            Map.of(
                    double.class,
                    number("double", (v, o) -> o.writeDouble((double) v), StateInput::readDouble),
                    float.class,
                    number(
                            "float",
                            (v, o) -> o.writeInt(Float.floatToRawIntBits((float) v)),
                            in -> Float.intBitsToFloat(in.readInt())),
                    long.class,
                    number("long", (v, o) -> o.writeLong((long) v), StateInput::readLong),
                    int.class,
                    number("int", (v, o) -> o.writeInt((int) v), StateInput::readInt),
                    short.class,
                    number(
                            "short",
                            (v, o) -> o.writeInt((short) v),
                            in -> (short) within(in.readInt(), Short.MIN_VALUE, Short.MAX_VALUE)),
                    char.class,
                    number(
                            "char",
                            (v, o) -> o.writeInt((char) v),
                            in -> (char) within(in.readInt(), 0, Character.MAX_VALUE)),
                    byte.class,
                    number(
                            "byte",
                            (v, o) -> o.writeBytes(new byte[] {(byte) v}, 1),
                            in -> in.readBytes(1)[0]),
                    boolean.class,
                    number("boolean", (v, o) -> o.writeBoolean((boolean) v), Parts::flag));

    private Parts() {}

    /** How values of one type, within a record, become bytes. */
    interface Part {
        /** The type, as another program would know it. */
        String name();

        /** Writes a value, which is null only where {@link OrNull} takes it. */
        void write(Object value, StateOutput out);

        /** Reads a value of this type; what is none ends with a {@link StateException}. */
        @Nullable Object read(StateInput in);
    }

    private static Part number(
            String name, BiConsumer<Object, StateOutput> writing, Function<StateInput, Object> r) {
        return new Plain(name, writing, r);
    }

    private static int within(int value, int least, int most) {
        if (value < least || value > most) {
            throw new StateException(
                    "there is " + value + " where a number of " + least + " to " + most + " is");
        }
        return value;
    }

    private static boolean flag(StateInput in) {
        int value = in.readBytes(1)[0];
        if (value != 0 && value != 1) {
            throw new StateException("there is " + value + " where a 0 or a 1 must be");
        }
        return value == 1;
    }

    /** Of a type, or null if it is none of these. */
    static @Nullable Part of(Class<?> type) {
        Part primitive = PRIMITIVES.get(type);
        if (primitive != null) {
            return primitive;
        }
        if (type == String.class) {
            return new OrNull(
                    new Plain(
                            "String", (v, o) -> o.writeString((String) v), StateInput::readString));
        }
        Part whole = whole(type);
        return whole == null ? null : new OrNull(whole);
    }

    /** Of an enumeration or an array of primitives, or null. */
    static @Nullable Part whole(Class<?> type) {
        if (type.isEnum()) {
            return new Constant(type);
        }
        return type.isArray() && type.getComponentType().isPrimitive()
                ? new Elements(type.getComponentType())
                : null;
    }

    /** Two functions. */
    private record Plain(
            String name,
            BiConsumer<Object, StateOutput> writing,
            Function<StateInput, Object> reading)
            implements Part {
        @Override
        public void write(Object value, StateOutput out) {
            writing.accept(value, out);
        }

        @Override
        public Object read(StateInput in) {
            return reading.apply(in);
        }
    }

    /** A value that may be null. */
    record OrNull(Part part) implements Part {
        @Override
        public String name() {
            return part.name();
        }

        @Override
        public void write(@Nullable Object value, StateOutput out) {
            out.writeBoolean(value != null);
            if (value != null) {
                part.write(value, out);
            }
        }

        @Override
        public @Nullable Object read(StateInput in) {
            return flag(in) ? part.read(in) : null;
        }
    }

    /** A constant of an enumeration, by its name. */
    private record Constant(Class<?> type) implements Part {
        @Override
        public String name() {
            return type.getName();
        }

        @Override
        public void write(Object value, StateOutput out) {
            out.writeString(((Enum<?>) value).name());
        }

        @Override
        public Object read(StateInput in) {
            String name = in.readString();
            for (Object constant : type.getEnumConstants()) {
                if (((Enum<?>) constant).name().equals(name)) {
                    return constant;
                }
            }
            throw new StateException(
                    "there is no constant '" + name + "' any more, or the bytes are damaged");
        }
    }

    /** An array of primitives. */
    private record Elements(Class<?> type) implements Part {
        @Override
        public String name() {
            return type.getName() + "[]";
        }

        private Part element() {
            return Objects.requireNonNull(PRIMITIVES.get(type), "a primitive");
        }

        /** Bytes of an element at least. */
        private int width() {
            return type == byte.class || type == boolean.class
                    ? 1
                    : type == double.class || type == long.class ? 8 : 4;
        }

        @Override
        public void write(Object value, StateOutput out) {
            int length = Array.getLength(value);
            out.writeInt(length);
            Part element = element();
            for (int i = 0; i < length; i++) {
                element.write(Array.get(value, i), out);
            }
        }

        @Override
        public Object read(StateInput in) {
            int length = in.need(width(), in.readInt());
            Object array = Array.newInstance(type, length);
            Part element = element();
            for (int i = 0; i < length; i++) {
                Array.set(array, i, element.read(in));
            }
            return array;
        }
    }
}
