package dev.cairn.core.state;

import org.jspecify.annotations.Nullable;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.lang.foreign.MemorySegment;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Objects;
import java.util.concurrent.atomic.AtomicReference;
import java.util.zip.CRC32C;

/**
 * All that the next tick of a world depends on, as a value: save it, and restore it as often as you
 * like, into the world that it came from or into another one.
 *
 * <p>A state is no part of the world: what the world does later does not change it. Objects that
 * never change (shapes, filters) and objects of the user are kept by reference. One thread at a
 * time; a state that nobody saves into may be restored by many threads into a world each.
 */
public final class WorldState {
    static final byte SECTION = 0;
    static final byte INT = 1;
    static final byte LONG = 2;
    static final byte DOUBLE = 3;
    static final byte BOOLEAN = 4;
    static final byte REFERENCE = 5;
    static final byte INTS = 6;
    static final byte LONGS = 7;
    static final byte DOUBLES = 8;
    static final byte FLOATS = 9;
    static final byte BYTES = 10;
    static final byte BOOLEANS = 11;
    static final byte REFERENCES = 12;

    static final String[] KIND_NAMES = {
        "section",
        "int",
        "long",
        "double",
        "boolean",
        "reference",
        "int[]",
        "long[]",
        "double[]",
        "float[]",
        "byte[]",
        "boolean[]",
        "reference[]"
    };

    /** Bytes to an element, by kind; 0 for what lies among the objects. */
    static final int[] WIDTH = {0, 4, 8, 8, 1, 0, 4, 8, 8, 4, 1, 1, 0};

    private static final int FIRST_BYTES = 1 << 12;
    private static final int FIRST_ENTRIES = 64;

    /** Numbers, each entry from a multiple of eight on. */
    byte[] bytes = new byte[FIRST_BYTES];

    MemorySegment memory = MemorySegment.ofArray(bytes);
    int size;

    @Nullable Object[] objects = new Object[FIRST_ENTRIES];
    int objectCount;

    /**
     * By entry: name and kind; where it begins among bytes or objects; how many elements. Of a
     * section: how many rows it has, see {@link StateVisitor#rows}.
     */
    String[] names = new String[FIRST_ENTRIES];

    byte[] kinds = new byte[FIRST_ENTRIES];
    int[] at = new int[FIRST_ENTRIES];
    int[] counts = new int[FIRST_ENTRIES];
    int entries;

    boolean isRead;

    private @Nullable WorldState spare;

    private final StateWriter writer = new StateWriter(this);

    /** One that no thread uses now: several may restore the same state. */
    private final AtomicReference<@Nullable StateReader> spareReader = new AtomicReference<>();

    /** Nothing yet. */
    public WorldState() {}

    /**
     * Takes over all that something declares, in place of what was held before. Allocates only
     * while buffers grow.
     *
     * @param root what is saved
     */
    public void save(Stateful root) {
        Objects.requireNonNull(root, "root must not be null");
        int before = objectCount;
        isRead = false;
        size = 0;
        objectCount = 0;
        entries = 0;
        root.state(writer);
        if (objectCount < before) {
            Arrays.fill(objects, objectCount, before, null);
        }
    }

    /**
     * Takes over all that another state holds. Allocates only while buffers grow.
     *
     * @param other what this state shall be; stays as it is
     */
    public void set(WorldState other) {
        Objects.requireNonNull(other, "other must not be null");
        if (other == this) {
            return;
        }
        clear();
        isRead = other.isRead;
        ensureBytes(other.size);
        System.arraycopy(other.bytes, 0, bytes, 0, other.size);
        size = other.size;
        ensureObjects(other.objectCount);
        System.arraycopy(other.objects, 0, objects, 0, other.objectCount);
        objectCount = other.objectCount;
        for (int e = 0; e < other.entries; e++) {
            add(other.names[e], other.kinds[e], other.at[e], other.counts[e]);
        }
    }

    /** Nothing yet; room stays. */
    void clear() {
        Arrays.fill(objects, 0, objectCount, null);
        isRead = false;
        size = 0;
        objectCount = 0;
        entries = 0;
    }

    /** An entry of another state, behind those that are here: longer by zeros, or cut. */
    void append(WorldState from, int entry, int count) {
        append(from, entry, Math.min(count, from.counts[entry]), count);
    }

    /** The same, of whose elements only the first ones are taken. */
    void append(WorldState from, int entry, int least, int count) {
        byte kind = from.kinds[entry];
        int width = WIDTH[kind];
        if (kind == SECTION) {
            add(from.names[entry], kind, size, count);
        } else if (width == 0) {
            ensureObjects(objectCount + count);
            System.arraycopy(from.objects, from.at[entry], objects, objectCount, least);
            Arrays.fill(objects, objectCount + least, objectCount + count, null);
            add(from.names[entry], kind, objectCount, count);
            objectCount += count;
        } else {
            long end = size + ((long) width * count + 7 & -8L);
            ensureBytes(end);
            System.arraycopy(from.bytes, from.at[entry], bytes, size, width * least);
            Arrays.fill(bytes, size + width * least, (int) end, (byte) 0);
            add(from.names[entry], kind, size, count);
            size = (int) end;
        }
    }

    /** Room to lay this state out anew; used by deltas. */
    WorldState spare() {
        if (spare == null) {
            spare = new WorldState();
        }
        return spare;
    }

    /**
     * Restores what came from bytes, and if it does not fit, what was there before; a state of this
     * process is only restored.
     *
     * @param root what is restored
     * @param keeps whether there is something to keep
     * @throws StateException if it is the state of something else
     */
    public void restoreOrKeep(Stateful root, boolean keeps) {
        WorldState back = null;
        if (isRead && keeps) {
            back = new WorldState();
            back.save(root);
        }
        try {
            restore(root);
        } catch (RuntimeException refusal) {
            if (back != null) {
                back.restore(root);
            }
            throw refusal instanceof StateException told
                    ? told
                    : new StateException(
                            "the state is not one of such a world: " + refusal, refusal);
        }
    }

    /**
     * Gives back all that was saved. Allocates nothing where the same was restored before.
     *
     * @param root of the same kind as what was saved
     * @throws StateException if this is no state of such a thing
     */
    public void restore(Stateful root) {
        Objects.requireNonNull(root, "root must not be null");
        if (isEmpty()) {
            throw new StateException("the state is empty: save something into it first");
        }
        StateReader spare = spareReader.getAndSet(null);
        StateReader reader = spare != null ? spare : new StateReader(this);
        reader.begin();
        root.state(reader);
        reader.end();
        spareReader.set(reader);
    }

    /**
     * Writes the state as bytes that are the same on every machine, with a sum that tells damage.
     *
     * @param out where to; stays open
     * @param codecs write the objects, for example {@code PhysicsWorld.codecs()}
     * @throws IOException if writing fails
     * @throws StateException naming the field that holds an object without a codec
     */
    public void writeTo(OutputStream out, StateCodecs codecs) throws IOException {
        StateBytes.write(this, out, codecs);
    }

    /**
     * The same to a file, in place of what it held.
     *
     * @param file the file
     * @param codecs write the objects
     * @throws IOException if writing fails
     */
    public void writeTo(Path file, StateCodecs codecs) throws IOException {
        try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(file))) {
            writeTo(out, codecs);
        }
    }

    /**
     * Reads what {@link #writeTo} wrote, and no more. Takes as much memory as there are bytes, and
     * a small multiple of it, whatever they say.
     *
     * @param in where from; stays open
     * @param codecs read the objects
     * @return the state
     * @throws IOException if reading fails
     * @throws StateException if the bytes are damaged, incomplete, or of another version
     */
    public static WorldState read(InputStream in, StateCodecs codecs) throws IOException {
        return StateBytes.read(in, codecs);
    }

    /**
     * The same from a file.
     *
     * @param file the file
     * @param codecs read the objects
     * @return the state
     * @throws IOException if reading fails
     */
    public static WorldState read(Path file, StateCodecs codecs) throws IOException {
        try (InputStream in = new BufferedInputStream(Files.newInputStream(file))) {
            return read(in, codecs);
        }
    }

    /**
     * Whether it came from bytes, so that who restores it may want a way back.
     *
     * @return false for what was saved in this process
     */
    public boolean isRead() {
        return isRead;
    }

    /**
     * Whether nothing was saved.
     *
     * @return true until the first save
     */
    public boolean isEmpty() {
        return entries == 0;
    }

    /**
     * How much memory the numbers take, beside the objects.
     *
     * @return bytes
     */
    public long byteCount() {
        return size;
    }

    /**
     * The first thing in which two states differ: the field, its index and both values. Objects are
     * compared by {@code equals}.
     *
     * @param other another one
     * @return a sentence, or null if they are equal
     */
    public @Nullable String difference(WorldState other) {
        return Differences.first(this, other);
    }

    /**
     * The first difference among the columns of one part of the world.
     *
     * @param other another one
     * @param section name of the part, such as {@code bodies}
     * @return as {@link #difference(WorldState)}
     */
    public @Nullable String difference(WorldState other, String section) {
        return Differences.within(this, other, section + ".");
    }

    /**
     * Whether two states are equal in every bit.
     *
     * @param other another one
     * @return true if {@link #difference} finds nothing
     */
    public boolean matches(WorldState other) {
        return difference(other) == null;
    }

    /**
     * How many columns and single numbers it holds, for tools that compare runs.
     *
     * @return the number; columns of references are among them
     */
    public int columnCount() {
        return entries;
    }

    /**
     * What a column is called.
     *
     * @param index 0 to columnCount - 1
     * @return such as {@code bodies.positionX}
     */
    public String columnName(int index) {
        return path(Objects.checkIndex(index, entries));
    }

    /**
     * A sum of a column's bits.
     *
     * @param index 0 to columnCount - 1
     * @return CRC-32C of its bytes; of references only how many there are
     */
    public int columnSum(int index) {
        int e = Objects.checkIndex(index, entries);
        int width = WIDTH[kinds[e]];
        if (width == 0) {
            return counts[e];
        }
        CRC32C sum = new CRC32C();
        sum.update(bytes, at[e], width * counts[e]);
        return (int) sum.getValue();
    }

    /** Elements of another state's entry, into the entry that was appended last. */
    void put(WorldState from, int entry, int source, int target, int count) {
        int last = entries - 1;
        int width = WIDTH[kinds[last]];
        if (width == 0) {
            System.arraycopy(
                    from.objects, from.at[entry] + source, objects, at[last] + target, count);
        } else {
            System.arraycopy(
                    from.bytes,
                    from.at[entry] + width * source,
                    bytes,
                    at[last] + width * target,
                    width * count);
        }
    }

    /** Room for more bytes; the segment follows. */
    void ensureBytes(long needed) {
        if (needed > bytes.length) {
            if (needed > Integer.MAX_VALUE - 64) {
                throw new StateException(
                        "the state needs "
                                + needed
                                + " bytes; at most 2147483583 are possible: make the world"
                                + " smaller");
            }
            long wanted = Math.max(needed, bytes.length + (bytes.length >> 1));
            bytes = Arrays.copyOf(bytes, (int) Math.min(Integer.MAX_VALUE - 64, wanted));
            memory = MemorySegment.ofArray(bytes);
        }
    }

    void ensureObjects(int needed) {
        if (needed > objects.length) {
            objects = Arrays.copyOf(objects, Math.max(needed, 2 * objects.length));
        }
    }

    /** A new entry of the table of contents. */
    void add(String name, byte kind, int begin, int count) {
        if (entries == names.length) {
            int n = 2 * entries;
            names = Arrays.copyOf(names, n);
            kinds = Arrays.copyOf(kinds, n);
            at = Arrays.copyOf(at, n);
            counts = Arrays.copyOf(counts, n);
        }
        names[entries] = name;
        kinds[entries] = kind;
        at[entries] = begin;
        counts[entries] = count;
        entries++;
    }

    /** Section and field, such as {@code bodies.positionX}. */
    String path(int entry) {
        int section = entry;
        while (section > 0 && kinds[section] != SECTION) {
            section--;
        }
        boolean isAlone = kinds[entry] == SECTION || kinds[section] != SECTION;
        return isAlone ? names[entry] : names[section] + "." + names[entry];
    }
}
