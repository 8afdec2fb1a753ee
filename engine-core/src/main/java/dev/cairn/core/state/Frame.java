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
 *   n  objects    how many; of each: how many bytes, name of its codec, what it wrote
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
        List<byte[]> pool = out.pool();
        whole.writeInt(pool.size());
        for (byte[] object : pool) {
            whole.writeInt(object.length);
            whole.writeBytes(object, object.length);
        }
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
        in.readPool(codecs);
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
}
