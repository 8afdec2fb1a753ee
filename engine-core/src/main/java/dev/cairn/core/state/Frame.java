package dev.cairn.core.state;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.zip.CRC32;
import java.util.zip.CRC32C;

/**
 * What bytes of one kind are wrapped in, so that damage and other versions are told; numbers with
 * their least significant byte first:
 *
 * <pre>
 *   8  magic: seven letters and the version
 *   8  length of what follows, without the sums
 *   n  objects    a pool; of each: name of its codec, what it wrote
 *      rest       what the kind asks for, and numbers of objects
 *   8  CRC-32C and CRC-32 of these n bytes
 * </pre>
 *
 * <p>Immutable; any thread.
 *
 * @param magic eight letters of ASCII; the last one is the version
 * @param what it is, for messages
 */
public record Frame(String magic, String what) {
    private static final int LETTERS = 8;
    private static final int HEAD = LETTERS + 8;

    /**
     * Of a kind of bytes.
     *
     * @throws IllegalArgumentException if there are not eight letters
     */
    public Frame {
        if (magic.length() != LETTERS) {
            throw new IllegalArgumentException(
                    "magic is '" + magic + "'; it must be " + LETTERS + " letters of ASCII");
        }
    }

    /**
     * Wraps what is written.
     *
     * @param to where to; stays open
     * @param codecs write the objects
     * @param content writes
     * @throws IOException if writing fails
     * @throws StateException if there is an object without a codec
     */
    public void write(OutputStream to, StateCodecs codecs, Consumer<StateOutput> content)
            throws IOException {
        StateOutput out = new StateOutput(codecs);
        content.accept(out);
        byte[] rest = out.toBytes();
        StateOutput whole = new StateOutput(codecs);
        Pool.write(out.pool(), whole);
        whole.writeBytes(rest, rest.length);
        byte[] all = whole.toBytes();
        StateOutput frame = new StateOutput(codecs);
        frame.writeBytes(letters(), LETTERS);
        frame.writeLong(all.length);
        to.write(frame.toBytes());
        to.write(all);
        StateOutput end = new StateOutput(codecs);
        end.writeLong(sum(all));
        to.write(end.toBytes());
        to.flush();
    }

    /**
     * Reads what was wrapped, and no more. Takes as much memory as there are bytes, and a small
     * multiple of it, whatever they say.
     *
     * @param from where from; stays open
     * @param codecs read the objects
     * @param content reads all that was written, in the same order
     * @param <T> what is read
     * @return what {@code content} has made
     * @throws IOException if reading fails
     * @throws StateException if the bytes are damaged, incomplete, or of another version
     */
    public <T> T read(InputStream from, StateCodecs codecs, Function<StateInput, T> content)
            throws IOException {
        byte[] head = from.readNBytes(HEAD);
        byte[] letters = letters();
        if (head.length < HEAD || !Arrays.equals(head, 0, LETTERS - 1, letters, 0, LETTERS - 1)) {
            throw new StateException(
                    "these are no bytes of a "
                            + what
                            + ": they do not begin with "
                            + magic.substring(0, LETTERS - 1)
                            + "; pass what writeTo wrote");
        }
        if (head[LETTERS - 1] != letters[LETTERS - 1]) {
            throw new StateException(
                    "the bytes are of version '"
                            + (char) head[LETTERS - 1]
                            + "' of the format, and this program reads version '"
                            + magic.charAt(LETTERS - 1)
                            + "'");
        }
        long length = new StateInput(head, LETTERS, HEAD).readLong();
        if (length < 0 || length > Integer.MAX_VALUE - 64) {
            throw new StateException(
                    "the length of the "
                            + what
                            + " is given as "
                            + length
                            + " bytes; it must be 0 to 2147483583: the bytes are damaged");
        }
        byte[] all = from.readNBytes((int) length); // grows with what is there
        byte[] tail = from.readNBytes(8);
        if (all.length < length || tail.length < 8) {
            throw new StateException(
                    "the "
                            + what
                            + " ends after "
                            + (all.length + tail.length)
                            + " bytes of "
                            + (length + 8)
                            + "; it is not complete");
        }
        if (new StateInput(tail, 0, 8).readLong() != sum(all)) {
            throw new StateException(
                    "the sum of the bytes of the "
                            + what
                            + " is not the one that was written with them: they are damaged");
        }
        StateInput in = new StateInput(all, 0, all.length);
        Pool.read(in, codecs);
        T result = content.apply(in);
        in.requireEnd();
        return result;
    }

    private byte[] letters() {
        return magic.getBytes(StandardCharsets.US_ASCII);
    }

    private static long sum(byte[] bytes) {
        CRC32C castagnoli = new CRC32C();
        castagnoli.update(bytes);
        CRC32 other = new CRC32();
        other.update(bytes);
        return castagnoli.getValue() << 32 | other.getValue();
    }

    /**
     * The objects of a frame, as many small ones that are alike: each as the bytes in which it
     * differs from the one before it that is as long.
     *
     * <pre>
     *   how many; of each: how many bytes; until these are complete: how many are as in the one before,
     *   how many follow that are not, these
     * </pre>
     *
     * All numbers are short ones, see {@link StateOutput#writeShort}.
     */
    private static final class Pool {
        /** Longer objects are there as they are: few bytes never stand for many. */
        private static final int LONGEST = 256;

        /** Equal bytes that are worth an interruption. */
        private static final int GAP = 3;

        private Pool() {}

        static void write(List<byte[]> objects, StateOutput out) {
            out.writeShort(objects.size());
            byte[] last = {};
            for (byte[] object : objects) {
                out.writeShort(object.length);
                if (object.length > LONGEST) {
                    out.writeBytes(object, object.length);
                } else {
                    write(
                            last.length == object.length ? last : new byte[object.length],
                            object,
                            out);
                    last = object;
                }
            }
        }

        private static void write(byte[] last, byte[] object, StateOutput out) {
            int at = 0;
            while (at < object.length) {
                int same = Arrays.mismatch(last, at, last.length, object, at, object.length);
                same = same < 0 ? object.length - at : same;
                int from = at + same;
                at = end(last, object, from);
                out.writeShort(same);
                out.writeShort(at - from);
                out.writeBytes(Arrays.copyOfRange(object, from, at), at - from);
            }
        }

        /** Behind bytes that differ, with few equal ones among them. */
        private static int end(byte[] last, byte[] object, int from) {
            int to = from;
            for (int i = from; i < object.length && i - to < GAP; i++) {
                to = last[i] == object[i] ? to : i + 1;
            }
            return to;
        }

        static void read(StateInput in, StateCodecs codecs) {
            int count = in.need(1, in.readShort());
            byte[] last = {};
            for (int i = 0; i < count; i++) {
                int length = in.readShort();
                if (length < 0 || length > LONGEST) { // below 0 is refused
                    in.add(in.readBytes(length), i, codecs);
                } else {
                    last =
                            read(
                                    Arrays.copyOf(
                                            last.length == length ? last : new byte[0], length),
                                    in);
                    in.add(last, i, codecs);
                }
            }
        }

        private static byte[] read(byte[] object, StateInput in) {
            int at = 0;
            while (at < object.length) {
                int same = in.readShort();
                int other = in.need(1, in.readShort());
                int left = object.length - at;
                if (same < 0 || same > left || other > left - same || same + other == 0) {
                    throw new StateException(
                            "an object of "
                                    + object.length
                                    + " bytes goes on with "
                                    + same
                                    + " and "
                                    + other
                                    + " at "
                                    + at
                                    + "; the bytes are damaged");
                }
                System.arraycopy(in.readBytes(other), 0, object, at + same, other);
                at += same + other;
            }
            return object;
        }
    }
}
