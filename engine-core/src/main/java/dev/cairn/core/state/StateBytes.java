package dev.cairn.core.state;

import org.jspecify.annotations.Nullable;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.lang.foreign.MemorySegment;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.zip.CRC32;
import java.util.zip.CRC32C;

/**
 * The bytes of a state, the same on every machine; numbers with their least significant byte first.
 *
 * <pre>
 *   8  "CAIRNST1"                        the last one is the version
 *   8  length of what follows, without the sums
 *   n  objects    how many; of each: how many bytes, name of its codec, what it wrote
 *      contents   how many; of each: kind, name, how many elements
 *      numbers    how many bytes; as they lie in memory, each entry from a multiple of 8 on
 *      references how many; of each: number of the object, or -1
 *   8  CRC-32C and CRC-32 of these n bytes
 * </pre>
 */
final class StateBytes {
    private static final byte[] MAGIC = "CAIRNST1".getBytes(StandardCharsets.US_ASCII);
    private static final int HEAD = MAGIC.length + 8;

    private StateBytes() {}

    static void write(WorldState s, OutputStream to, StateCodecs codecs) throws IOException {
        StateOutput out = new StateOutput(codecs);
        out.writeInt(s.entries);
        for (int e = 0; e < s.entries; e++) {
            out.writeInt(s.kinds[e]);
            out.writeString(s.names[e]);
            out.writeInt(s.counts[e]);
        }
        out.writeInt(s.size);
        out.writeBytes(s.bytes, s.size);
        out.writeInt(s.objectCount);
        for (int i = 0; i < s.objectCount; i++) {
            object(s, i, out);
        }
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
        frame.writeBytes(MAGIC, MAGIC.length);
        frame.writeLong(all.length);
        to.write(frame.toBytes());
        to.write(all);
        StateOutput end = new StateOutput(codecs);
        end.writeLong(sum(all));
        to.write(end.toBytes());
        to.flush();
    }

    private static void object(WorldState s, int i, StateOutput out) {
        try {
            out.writeObject(s.objects[i]);
        } catch (StateException refusal) {
            int e = s.entries - 1;
            while (!(WorldState.WIDTH[s.kinds[e]] == 0
                    && s.kinds[e] != WorldState.SECTION
                    && s.at[e] <= i)) {
                e--;
            }
            throw new StateException(s.path(e) + ": " + refusal.getMessage(), refusal);
        }
    }

    private static long sum(byte[] bytes) {
        CRC32C castagnoli = new CRC32C();
        castagnoli.update(bytes);
        CRC32 other = new CRC32();
        other.update(bytes);
        return castagnoli.getValue() << 32 | other.getValue();
    }

    static WorldState read(InputStream from, StateCodecs codecs) throws IOException {
        byte[] head = from.readNBytes(HEAD);
        if (head.length < HEAD || !Arrays.equals(head, 0, 7, MAGIC, 0, 7)) {
            throw new StateException(
                    "these are no bytes of a state: they do not begin with CAIRNST; pass what"
                            + " WorldState.writeTo wrote");
        }
        if (head[7] != MAGIC[7]) {
            throw new StateException(
                    "the bytes are of version '"
                            + (char) head[7]
                            + "' of the format, and this program reads version '"
                            + (char) MAGIC[7]
                            + "'");
        }
        long length = new StateInput(head, MAGIC.length, HEAD).readLong();
        if (length < 0 || length > Integer.MAX_VALUE - 64) {
            throw new StateException(
                    "the length of the state is given as "
                            + length
                            + " bytes; it must be 0 to 2147483583: the bytes are damaged");
        }
        byte[] all = from.readNBytes((int) length); // grows with what is there
        byte[] tail = from.readNBytes(8);
        if (all.length < length || tail.length < 8) {
            throw new StateException(
                    "the state ends after "
                            + (all.length + tail.length)
                            + " bytes of "
                            + (length + 8)
                            + "; it is not complete");
        }
        if (new StateInput(tail, 0, 8).readLong() != sum(all)) {
            throw new StateException(
                    "the sum of the state's bytes is not the one that was written with them: they"
                            + " are damaged");
        }
        return parse(new StateInput(all, 0, all.length), codecs);
    }

    /** What the sum has let pass; the bytes may still be of another version, or made by hand. */
    static WorldState parse(StateInput in, StateCodecs codecs) {
        in.readPool(codecs);
        WorldState s = new WorldState();
        int entries = in.need(9, in.readInt());
        long bytes = 0;
        long objects = 0;
        for (int e = 0; e < entries; e++) {
            int kind = in.readInt();
            if (kind < 0 || kind >= WorldState.WIDTH.length) {
                throw new StateException("entry " + e + " is of the unknown kind " + kind);
            }
            String name = in.readString();
            int count = in.readInt();
            boolean isOne = kind > WorldState.SECTION && kind <= WorldState.REFERENCE;
            if (count < 0 || (isOne && count != 1) || (kind == WorldState.SECTION && count != 0)) {
                throw new StateException(
                        "entry " + e + ", " + name + ", has " + count + " elements");
            }
            int width = WorldState.WIDTH[kind];
            boolean isObject = width == 0;
            s.add(name, (byte) kind, (int) (isObject ? objects : bytes), count);
            if (kind == WorldState.SECTION) {
                continue;
            }
            objects += isObject ? count : 0;
            bytes += (long) width * count + 7 & -8L;
            if (bytes > Integer.MAX_VALUE || objects > Integer.MAX_VALUE) {
                throw new StateException("entry " + e + ", " + name + ", is too long");
            }
        }
        int size = in.readInt();
        if (size != bytes) {
            throw new StateException(
                    "there are " + size + " bytes of numbers where contents ask for " + bytes);
        }
        s.bytes = in.readBytes(size);
        s.memory = MemorySegment.ofArray(s.bytes);
        s.size = size;
        int count = in.need(4, in.readInt());
        if (count != objects) {
            throw new StateException(
                    "there are " + count + " references where contents ask for " + objects);
        }
        @Nullable Object[] all = new Object[Math.max(16, count)];
        for (int i = 0; i < count; i++) {
            all[i] = in.readNullable(Object.class);
        }
        s.objects = all;
        s.objectCount = count;
        if (!in.isAtEnd()) {
            throw new StateException("there are bytes behind the end of the state");
        }
        s.isRead = true;
        return s;
    }
}
