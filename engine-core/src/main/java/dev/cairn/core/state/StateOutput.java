package dev.cairn.core.state;

import org.jspecify.annotations.Nullable;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.List;

/**
 * Takes what is to become bytes: numbers with their least significant byte first, texts, objects.
 * An object that is written several times is there once. One thread.
 */
public final class StateOutput {
    private final StateCodecs codecs;
    private final IdentityHashMap<Object, Integer> numbers = new IdentityHashMap<>();

    /** By object: its bytes, written by its codec. */
    private final List<byte[]> pool = new ArrayList<>();

    private byte[] bytes = new byte[256];
    private int size;

    StateOutput(StateCodecs codecs) {
        this.codecs = codecs;
    }

    /**
     * Writes a number.
     *
     * @param value any
     */
    public void writeInt(int value) {
        byte[] to = room(4);
        for (int i = 0; i < 4; i++) {
            to[size++] = (byte) (value >>> (8 * i));
        }
    }

    /**
     * Writes a number.
     *
     * @param value any
     */
    public void writeLong(long value) {
        writeInt((int) value);
        writeInt((int) (value >>> 32));
    }

    /**
     * Writes all bits of a number.
     *
     * @param value any
     */
    public void writeDouble(double value) {
        writeLong(Double.doubleToRawLongBits(value));
    }

    /**
     * Writes a switch.
     *
     * @param value any
     */
    public void writeBoolean(boolean value) {
        room(1)[size++] = (byte) (value ? 1 : 0);
    }

    /**
     * Writes a text.
     *
     * @param text any that is well formed
     * @throws StateException if there is half a pair of surrogates in it, which no bytes can keep
     */
    public void writeString(String text) {
        requireWhole(text);
        byte[] utf8 = text.getBytes(StandardCharsets.UTF_8);
        writeInt(utf8.length);
        writeBytes(utf8, utf8.length);
    }

    private static void requireWhole(String text) {
        for (int i = 0; i < text.length(); i++) {
            char letter = text.charAt(i);
            if (Character.isSurrogate(letter)) {
                if (Character.charCount(text.codePointAt(i)) == 1) {
                    throw new StateException(
                            "the character at "
                                    + i
                                    + " of a text is half a pair of surrogates (0x"
                                    + Integer.toHexString(letter)
                                    + "), which is no character; take it out");
                }
                i++;
            }
        }
    }

    /**
     * Writes numbers and how many there are.
     *
     * @param values any
     */
    public void writeDoubles(double[] values) {
        writeInt(values.length);
        for (double value : values) {
            writeDouble(value);
        }
    }

    /**
     * Writes numbers and how many there are.
     *
     * @param values any
     */
    public void writeInts(int[] values) {
        writeInt(values.length);
        for (int value : values) {
            writeInt(value);
        }
    }

    /**
     * Writes an object by its codec.
     *
     * @param value the object, or null
     * @throws StateException if there is no codec for its class
     */
    public void writeObject(@Nullable Object value) {
        writeInt(value == null ? -1 : number(value));
    }

    /**
     * Writes a whole state; its objects by their codecs.
     *
     * @param state any
     * @throws StateException naming the field that holds an object without a codec
     */
    public void writeState(WorldState state) {
        StateBytes.contents(state, this);
    }

    /**
     * Writes a difference of states; its objects by their codecs.
     *
     * @param delta any
     * @throws StateException if there is an object without a codec
     */
    public void writeDelta(StateDelta delta) {
        DeltaBytes.contents(delta, this);
    }

    /** An object whose number is short. */
    void writeObjectShort(@Nullable Object value) {
        writeShort(value == null ? 0 : number(value) + 1);
    }

    /** A number that is small mostly: seven bits to a byte, the lowest ones first. */
    void writeShort(int value) {
        int left = value;
        while (left >>> 7 != 0) {
            room(1)[size++] = (byte) (left | 128);
            left >>>= 7;
        }
        room(1)[size++] = (byte) left;
    }

    void writeBytes(byte[] from, int count) {
        System.arraycopy(from, 0, room(count), size, count);
        size += count;
    }

    /** The number of an object in the pool, which what it refers to precedes. */
    private int number(Object value) {
        Integer known = numbers.get(value);
        if (known != null) {
            return known;
        }
        byte[] before = bytes;
        int at = size;
        bytes = new byte[64];
        size = 0;
        codecs.write(value, this);
        byte[] own = Arrays.copyOf(bytes, size);
        bytes = before;
        size = at;
        pool.add(own);
        numbers.put(value, pool.size() - 1);
        return pool.size() - 1;
    }

    /** All objects so far. */
    List<byte[]> pool() {
        return pool;
    }

    byte[] toBytes() {
        return Arrays.copyOf(bytes, size);
    }

    private byte[] room(int more) {
        if (more > bytes.length - size) {
            long wanted = Math.max((long) size + more, 2L * bytes.length);
            if (size + (long) more > Integer.MAX_VALUE - 64) {
                throw new StateException("the bytes of a state would be more than 2147483583");
            }
            bytes = Arrays.copyOf(bytes, (int) Math.min(wanted, Integer.MAX_VALUE - 64));
        }
        return bytes;
    }
}
