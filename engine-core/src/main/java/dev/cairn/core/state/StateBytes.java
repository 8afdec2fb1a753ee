package dev.cairn.core.state;

import org.jspecify.annotations.Nullable;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.lang.foreign.MemorySegment;

/**
 * The bytes of a state, the same on every machine, in a {@link Frame}:
 *
 * <pre>
 *   contents   how many; of each: kind, name, how many elements, or rows of a section
 *   numbers    how many bytes; as they lie in memory, each entry from a multiple of 8 on
 *   references how many; of each: number of the object, or -1
 * </pre>
 */
final class StateBytes {
    private static final Frame FRAME = new Frame("CAIRNST3", "state");

    private StateBytes() {}

    static void write(WorldState s, OutputStream to, StateCodecs codecs) throws IOException {
        FRAME.write(to, codecs, out -> contents(s, out));
    }

    static WorldState read(InputStream from, StateCodecs codecs) throws IOException {
        return FRAME.read(from, codecs, StateBytes::parse);
    }

    static void contents(WorldState s, StateOutput out) {
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

    /** What the sum has let pass; the bytes may still be of another version, or made by hand. */
    static WorldState parse(StateInput in) {
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
            if (count < 0 || (isOne && count != 1)) {
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
        s.isRead = true;
        return s;
    }
}
