package dev.cairn.core.state;

import org.jspecify.annotations.Nullable;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Gives back what a {@link StateOutput} took. Whatever the bytes are, it reads within them, and
 * allocates no more than a small multiple of them. One thread.
 */
public final class StateInput {
    private final byte[] bytes;
    private final List<Object> objects;
    private int at;
    private final int end;

    StateInput(byte[] bytes, int from, int to) {
        this(bytes, from, to, new ArrayList<>());
    }

    private StateInput(byte[] bytes, int from, int to, List<Object> objects) {
        this.objects = objects;
        this.bytes = bytes;
        at = from;
        end = to;
    }

    /**
     * Reads a number.
     *
     * @return what was written
     */
    public int readInt() {
        need(4, 1);
        int value = 0;
        for (int i = 0; i < 4; i++) {
            value |= (bytes[at++] & 255) << (8 * i);
        }
        return value;
    }

    /**
     * Reads a number.
     *
     * @return what was written
     */
    public long readLong() {
        long low = readInt() & 0xFFFF_FFFFL;
        return low | (long) readInt() << 32;
    }

    /**
     * Reads a number.
     *
     * @return what was written, all bits of it
     */
    public double readDouble() {
        return Double.longBitsToDouble(readLong());
    }

    /**
     * Reads a switch.
     *
     * @return what was written
     */
    public boolean readBoolean() {
        need(1, 1);
        return bytes[at++] != 0;
    }

    /**
     * Reads a text.
     *
     * @return what was written
     */
    public String readString() {
        int length = readInt();
        need(1, length);
        String text = new String(bytes, at, length, StandardCharsets.UTF_8);
        at += length;
        return text;
    }

    /**
     * Reads numbers.
     *
     * @return what was written
     */
    public double[] readDoubles() {
        double[] values = new double[need(8, readInt())];
        for (int i = 0; i < values.length; i++) {
            values[i] = readDouble();
        }
        return values;
    }

    /**
     * Reads numbers.
     *
     * @return what was written
     */
    public int[] readInts() {
        int[] values = new int[need(4, readInt())];
        for (int i = 0; i < values.length; i++) {
            values[i] = readInt();
        }
        return values;
    }

    /**
     * Reads an object.
     *
     * @param type what it must be
     * @param <T> that class
     * @return what was written
     */
    public <T> T readObject(Class<T> type) {
        T value = readNullable(type);
        if (value == null) {
            throw new StateException("there is no " + type.getName() + " where one must be");
        }
        return value;
    }

    /**
     * Reads an object that may be null.
     *
     * @param type what it must be
     * @param <T> that class
     * @return what was written
     */
    public <T> @Nullable T readNullable(Class<T> type) {
        return readNullable(type, readInt());
    }

    /** What {@link StateOutput#writeObjectShort} wrote. */
    @Nullable Object readShortObject() {
        return readNullable(Object.class, readShort() - 1);
    }

    private <T> @Nullable T readNullable(Class<T> type, int number) {
        if (number == -1) {
            return null;
        }
        if (number < 0 || number >= objects.size()) {
            throw new StateException(
                    "object " + number + " is asked for, of " + objects.size() + " so far");
        }
        Object value = objects.get(number);
        if (!type.isInstance(value)) {
            throw new StateException(
                    "object "
                            + number
                            + " is a "
                            + value.getClass().getName()
                            + " where a "
                            + type.getName()
                            + " must be");
        }
        return type.cast(value);
    }

    /**
     * Reads a state.
     *
     * @return what was written
     */
    public WorldState readState() {
        return StateBytes.parse(this);
    }

    /**
     * Reads a difference of states.
     *
     * @return what was written
     */
    public StateDelta readDelta() {
        return DeltaBytes.parse(this);
    }

    /**
     * Refuses a number of elements that there are no bytes for, before room for them is made.
     *
     * @param width least bytes of an element, at least 1
     * @param count how many are told
     * @return count
     * @throws StateException if it is negative or the bytes end before
     */
    public int requireCount(int width, int count) {
        return need(width, count);
    }

    /** An object of the pool, which may refer to those before. */
    void add(byte[] object, int number, StateCodecs codecs) {
        StateInput own = new StateInput(object, 0, object.length, objects);
        Object value = codecs.read(own);
        if (own.left() > 0) {
            throw new StateException(
                    "object "
                            + number
                            + " has "
                            + own.left()
                            + " bytes more than its codec reads; it is of another version");
        }
        objects.add(value);
    }

    /** Bytes that are left. */
    int left() {
        return end - at;
    }

    /** What {@link StateOutput#writeShort} wrote. */
    int readShort() {
        int value = 0;
        for (int shift = 0; shift < 35; shift += 7) {
            need(1, 1);
            int next = bytes[at++];
            value |= (next & 127) << shift;
            if (next >= 0) {
                return value;
            }
        }
        throw new StateException("a number takes more than five bytes; the bytes are damaged");
    }

    byte[] readBytes(int count) {
        need(1, count);
        at += count;
        return Arrays.copyOfRange(bytes, at - count, at);
    }

    /** Refuses bytes that nobody has asked for. */
    void requireEnd() {
        if (at != end) {
            throw new StateException(
                    "there are " + (end - at) + " bytes behind the end; they are damaged");
        }
    }

    /** Refuses a number of elements that there are no bytes for. */
    int need(int width, int count) {
        if (count < 0 || (long) width * count > end - at) {
            throw new StateException(
                    "the bytes end: "
                            + count
                            + " elements of "
                            + width
                            + " bytes are expected and "
                            + (end - at)
                            + " bytes are left");
        }
        return count;
    }
}
