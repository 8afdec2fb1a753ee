package dev.cairn.core.state;

import org.jspecify.annotations.Nullable;

import java.util.Arrays;

/**
 * Entries that only one of two states has, packed as what differs from zeros.
 *
 * @param names of each
 * @param kinds of each
 * @param counts elements of each
 * @param words numbers
 * @param objects references
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
record PackedEntries(
        String[] names, byte[] kinds, int[] counts, DeltaWords words, @Nullable Object[] objects) {
    /** Memory of an entry beside what it holds: its name is shared. */
    private static final int ENTRY_BYTES = 9;

    /** None of a number of 0: null. */
    static @Nullable PackedEntries of(StateColumns columns, int first, int count) {
        if (count == 0) {
            return null;
        }
        DeltaWords words = new DeltaWords();
        WorldState nothing = new WorldState();
        WorldState part = new WorldState();
        int word = 0;
        for (int i = 0; i < count; i++) {
            WorldState from = columns.holder(first + i);
            int e = columns.place(first + i);
            part.append(from, e, from.counts[e]);
            nothing.append(from, e, 0);
            if (WorldState.WIDTH[from.kinds[e]] != 0) {
                word += words.add(word, nothing, i, part, i);
            }
        }
        return new PackedEntries(
                Arrays.copyOf(part.names, count),
                Arrays.copyOf(part.kinds, count),
                Arrays.copyOf(part.counts, count),
                words.trimmed(),
                Arrays.copyOf(part.objects, part.objectCount));
    }

    /** Bytes of numbers, unpacked. */
    long size() {
        long size = 0;
        for (int e = 0; e < kinds.length; e++) {
            size += (long) WorldState.WIDTH[kinds[e]] * counts[e] + 7 & -8L;
        }
        return size;
    }

    /** What it takes in memory, bytes. */
    long byteCount() {
        return (long) ENTRY_BYTES * kinds.length + words.size() + 8L * objects.length;
    }

    /** The entries, as they were. */
    WorldState unpack() {
        WorldState part = new WorldState();
        part.ensureBytes(size());
        part.ensureObjects(objects.length);
        for (int e = 0; e < kinds.length; e++) {
            int width = WorldState.WIDTH[kinds[e]];
            boolean isObject = width == 0 && kinds[e] != WorldState.SECTION;
            part.add(names[e], kinds[e], isObject ? part.objectCount : part.size, counts[e]);
            part.size += width * counts[e] + 7 & -8;
            part.objectCount += isObject ? counts[e] : 0;
        }
        System.arraycopy(objects, 0, part.objects, 0, objects.length);
        words.apply(part, words.sumBefore);
        return part;
    }
}
