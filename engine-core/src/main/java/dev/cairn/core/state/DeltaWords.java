package dev.cairn.core.state;

import java.util.Arrays;

/**
 * The exclusive or of the numbers of two states in the wide layout (see {@link Alignment}), by
 * words of eight bytes: runs of words that differ, and how many are skipped before each.
 *
 * <pre>
 *   run   2 skipped + (1 if it is longer than one word), as a varint; then its length, if longer
 *   word  a byte that tells which of its bytes are not 0, and these
 *         or 0 and its place among those that were seen
 * </pre>
 *
 * Numbers that change little have equal signs, exponents and first digits. What a body and its
 * entity both hold changes alike: such a word is told by where it was seen.
 */
final class DeltaWords {
    private static final long ODD = 0x9E37_79B9_7F4A_7C15L;
    private static final byte[] NONE = {};

    /** Words that were seen, by the upper bits of a product; a power of two, at most 256. */
    private static final int SEEN = 256;

    private static final int SEEN_SHIFT = 56;
    private static final long[] NOT_USED = {};

    byte[] bytes = NONE;
    int size;

    /** Sums of the words that differ, of both states. */
    long sumBefore;

    long sumAfter;

    /** Behind the last word that was written, in the wide layout. */
    private int last;

    private int at;
    private final long[] seen;

    DeltaWords() {
        this(NONE, 0, 0, true);
    }

    DeltaWords(byte[] bytes, long sumBefore, long sumAfter) {
        this(bytes, sumBefore, sumAfter, false);
    }

    private DeltaWords(byte[] bytes, long sumBefore, long sumAfter, boolean isUsed) {
        seen = isUsed ? new long[SEEN] : NOT_USED;
        this.bytes = bytes;
        size = bytes.length;
        this.sumBefore = sumBefore;
        this.sumAfter = sumAfter;
    }

    /**
     * Adds what differs in an entry.
     *
     * @param base its first word in the wide layout
     * @param i its number in the first state
     * @param k its number in the second state
     * @return words that it takes in the wide layout
     */
    int add(int base, WorldState a, int i, WorldState b, int k) {
        int na = words(a, i);
        int nb = words(b, k);
        int common = Math.min(na, nb);
        int n = Math.max(na, nb);
        int ta = a.at[i];
        int tb = b.at[k];
        int w = 0;
        while (w < n) {
            if (w < common) {
                int from = 8 * w;
                int to = 8 * common;
                int differs =
                        Arrays.mismatch(a.bytes, ta + from, ta + to, b.bytes, tb + from, tb + to);
                w = differs < 0 ? common : w + differs / 8;
            }
            while (w >= common && w < n && word(a, ta, na, w) == word(b, tb, nb, w)) {
                w++;
            }
            int end = w;
            while (end < n && word(a, ta, na, end) != word(b, tb, nb, end)) {
                end++;
            }
            if (end > w) {
                varint(2L * (base + w - last) + (end - w > 1 ? 1 : 0));
                if (end - w > 1) {
                    varint(end - w);
                }
                last = base + end;
                for (; w < end; w++) {
                    put(word(a, ta, na, w), word(b, tb, nb, w));
                }
            }
        }
        return n;
    }

    private static int words(WorldState s, int entry) {
        return (int) (((long) WorldState.WIDTH[s.kinds[entry]] * s.counts[entry] + 7) >> 3);
    }

    private static long word(WorldState s, int begin, int words, int w) {
        return w < words ? (long) StateWriter.LONG.get(s.bytes, begin + 8 * w) : 0;
    }

    private void put(long before, long after) {
        sumBefore = mix(sumBefore, before);
        sumAfter = mix(sumAfter, after);
        long x = before ^ after;
        room(9);
        int place = size++;
        int slot = slot(x);
        if (seen[slot] == x) {
            bytes[place] = 0;
            bytes[size++] = (byte) slot;
            return;
        }
        seen[slot] = x;
        int mask = 0;
        for (int k = 0; k < 8; k++, x >>>= 8) {
            if ((x & 255) != 0) {
                mask |= 1 << k;
                bytes[size++] = (byte) x;
            }
        }
        bytes[place] = (byte) mask;
    }

    private static long mix(long sum, long word) {
        return Long.rotateLeft((sum ^ word) * ODD, 29);
    }

    private static int slot(long word) {
        return (int) ((word * ODD) >>> SEEN_SHIFT);
    }

    private void varint(long value) {
        room(5);
        long left = value;
        while (left >>> 7 != 0) {
            bytes[size++] = (byte) (left | 128);
            left >>>= 7;
        }
        bytes[size++] = (byte) left;
    }

    private void room(int more) {
        if (bytes.length - size < more) {
            if (size > Integer.MAX_VALUE / 2) {
                throw new StateException(
                        "the difference of the states takes more than 1073741823 bytes; save them"
                                + " instead");
            }
            bytes = Arrays.copyOf(bytes, Math.max(64, 2 * bytes.length));
        }
    }

    /** No more than it takes; nothing can be added any more. */
    DeltaWords trimmed() {
        return new DeltaWords(Arrays.copyOf(bytes, size), sumBefore, sumAfter);
    }

    /**
     * Applies it to a state in the wide layout.
     *
     * @param sum of the words that are to be changed, or the state is none of the two
     */
    void apply(WorldState wide, long sum) {
        long found = walk(wide, false);
        if (found != sum) {
            throw new StateException(
                    "the state is not the one that the delta starts from: the numbers that it"
                            + " changes are others; apply deltas in the order of their ticks, and"
                            + " revert them in the opposite order");
        }
        walk(wide, true);
    }

    /** Goes over all words that differ; the sum of what they were. */
    private long walk(WorldState wide, boolean writes) {
        DeltaWords reader = new DeltaWords(bytes, 0, 0, true); // what threads share stays
        long sum = 0;
        long w = 0;
        while (reader.at < size) {
            long skipped = reader.readVarint();
            w += skipped >> 1;
            long run = (skipped & 1) == 0 ? 1 : reader.readVarint();
            if (run > (wide.size >> 3) - w) {
                throw damaged(
                        "words up to " + (w + run) + " are to be changed, of " + (wide.size >> 3));
            }
            for (long end = w + run; w < end; w++) {
                int place = (int) (8 * w);
                long now = (long) StateWriter.LONG.get(wide.bytes, place);
                sum = mix(sum, now);
                long x = reader.readWord();
                if (writes) {
                    StateWriter.LONG.set(wide.bytes, place, now ^ x);
                }
            }
        }
        return sum;
    }

    private long readWord() {
        int mask = readByte();
        if (mask == 0) {
            return seen[readByte() & (SEEN - 1)];
        }
        long x = 0;
        for (int k = 0; k < 8; k++) {
            if ((mask >> k & 1) != 0) {
                x |= (long) readByte() << (8 * k);
            }
        }
        seen[slot(x)] = x;
        return x;
    }

    private long readVarint() {
        long value = 0;
        for (int shift = 0; shift < 35; shift += 7) {
            int next = readByte();
            value |= (long) (next & 127) << shift;
            if (next < 128) {
                return value;
            }
        }
        throw damaged("a number is too large");
    }

    private int readByte() {
        if (at >= bytes.length) {
            throw damaged("the words end too early");
        }
        return bytes[at++] & 255;
    }

    private static StateException damaged(String how) {
        return new StateException("the delta is damaged: " + how);
    }
}
