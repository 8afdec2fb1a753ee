package dev.cairn.core.state;

import java.util.Arrays;

/**
 * The exclusive or of the numbers of two states in the wide layout (see {@link Alignment}), by
 * words of eight bytes. Of those that differ, one after the other, a head:
 *
 * <pre>
 *   upper  how many words are skipped before it, up to 13, 14 as in the {@link Skips pattern}
 *          before, 15 as a varint
 *   lower  kind:
 *          0 and a byte: which of the word's bytes are not 0; these
 *          1 to 8 and a byte: so many lower bytes, the highest one here; those above are 0
 *          9 the word that followed the word before when that was seen last
 *          10 words by even steps: how many, as a varint, and the first two with kinds of their own
 *          11 only byte 4
 *          12 to 15 and a byte: its place among those that were seen
 * </pre>
 *
 * The other bytes and varints lie behind each other in an array of their own: they are as good as
 * random. Heads and the bytes with them are not, see {@link PackedHeads}. Numbers that change
 * little have equal signs, exponents and first digits. What a body and its entity both hold changes
 * alike: such a word is told by where it was seen. Lists of slots that come or go as a whole are
 * equal numbers, or grow by the same step.
 */
final class DeltaWords {
    static final long ODD = 0x9E37_79B9_7F4A_7C15L;
    private static final byte[] NONE = {};

    /** Words that were seen, by the upper bits of a product; a power of two, at most 1024. */
    private static final int SEEN = 1024;

    private static final int SEEN_SHIFT = 54;
    private static final long[] NOT_USED = {};

    /** Kinds beside numbers of bytes, and codes of skips beside the skips themselves. */
    private static final int MASK = 0;

    private static final int FOLLOWS = 9;
    private static final int EVEN = 10;
    private static final int UPPER_BYTE = 11;
    private static final int PLACE = 12;
    private static final int PATTERN = 14;
    private static final int FAR = 15;

    /** Words by even steps that are worth being told so. */
    private static final int LEAST_EVEN = 6;

    /** Bytes and varints. */
    byte[] bytes = NONE;

    private int length;

    /** Heads, each with what is predicted of its word; packed in a delta that is complete. */
    byte[] heads = NONE;

    /** How many bytes these are when they are not packed. */
    int headLength;

    /** Sums of the words that differ, of both states. */
    long sumBefore;

    long sumAfter;

    /** Behind the last word that was written, in the wide layout. */
    private int last;

    private int at;
    private int headAt;
    private final long[] seen;
    private final Skips skips;

    /** By place of a word among those that were seen: that of the one after it, the last time. */
    private final int[] follower;

    private int lastSlot;

    /** Words that differ one after the other: those of the first state, exclusive ors. */
    private long[] before = NOT_USED;

    private long[] change = NOT_USED;

    /** Empty, to be added to. */
    DeltaWords() {
        this(NONE, 0, NONE, 0, 0, true);
    }

    DeltaWords(byte[] heads, int headLength, byte[] bytes, long sumBefore, long sumAfter) {
        this(heads, headLength, bytes, sumBefore, sumAfter, false);
    }

    private DeltaWords(
            byte[] heads, int headLength, byte[] bytes, long before, long after, boolean works) {
        seen = works ? new long[SEEN] : NOT_USED;
        skips = new Skips(works);
        follower = new int[seen.length];
        this.heads = heads;
        this.headLength = headLength;
        this.bytes = bytes;
        length = bytes.length;
        sumBefore = before;
        sumAfter = after;
    }

    /** Bytes in all. */
    int size() {
        return heads.length + bytes.length;
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
            if (end - w > before.length) {
                before = new long[2 * (end - w)];
                change = new long[2 * (end - w)];
            }
            for (int d = w; d < end; d++) {
                before[d - w] = word(a, ta, na, d);
                change[d - w] = before[d - w] ^ word(b, tb, nb, d);
            }
            runs(base + w, end - w);
            w = end;
        }
        return n;
    }

    /** Writes words that differ one after the other. */
    private void runs(int place, int n) {
        int i = 0;
        while (i < n) {
            int even = i;
            int end = evenEnd(even, n);
            while (end - even < LEAST_EVEN && end < n) {
                even = end - 1;
                end = evenEnd(even, n);
            }
            boolean isEven = end - even >= LEAST_EVEN;
            for (int to = isEven ? even : n; i < to; i++) {
                word(skip(place + i), change[i]);
            }
            if (isEven) {
                head(skip(place + even), EVEN);
                varint(end - even);
                word(0, change[even]);
                word(0, change[even + 1]);
                i = end;
                last = place + end;
            }
        }
        for (i = 0; i < n; i++) {
            sumBefore = mix(sumBefore, before[i]);
            sumAfter = mix(sumAfter, before[i] ^ change[i]);
        }
    }

    /** Behind the last word that goes on from a word and the next one by the same step. */
    private int evenEnd(int from, int n) {
        int i = from + 2;
        while (i < n && change[i] - change[i - 1] == change[from + 1] - change[from]) {
            i++;
        }
        return Math.min(i, n);
    }

    /** Words between the last one that was written and this one, which is written next. */
    private int skip(int place) {
        int skip = place - last;
        last = place + 1;
        return skip;
    }

    private static int words(WorldState s, int entry) {
        return (int) (((long) WorldState.WIDTH[s.kinds[entry]] * s.counts[entry] + 7) >> 3);
    }

    private static long word(WorldState s, int begin, int words, int w) {
        return w < words ? (long) StateWriter.LONG.get(s.bytes, begin + 8 * w) : 0;
    }

    private void head(int skip, int kind) {
        boolean isSeen = skip > 0 && skips.next(skip);
        int code = isSeen ? PATTERN : Math.min(skip, FAR);
        code = !isSeen && skip == PATTERN ? FAR : code;
        if (code == FAR) {
            varint(skip);
        }
        predicted((code << 4) | kind);
    }

    private void predicted(int octet) {
        if (headLength == heads.length) {
            heads = Arrays.copyOf(heads, Math.max(64, 2 * headLength));
        }
        heads[headLength++] = (byte) octet;
    }

    private void word(int skip, long x) {
        int slot = slot(x);
        int guess = follower[lastSlot];
        follow(slot);
        if (seen[slot] == x) {
            head(skip, guess == slot ? FOLLOWS : PLACE + (slot >> 8));
            if (guess != slot) {
                room(1);
                bytes[length++] = (byte) slot;
            }
            return;
        }
        seen[slot] = x;
        int mask = 0;
        for (int k = 0; k < 8; k++) {
            mask |= (x >>> (8 * k) & 255) != 0 ? 1 << k : 0;
        }
        int kind = kind(mask);
        head(skip, kind);
        room(9);
        int there = bytesOf(kind, mask);
        if (kind == MASK) {
            predicted(mask);
        } else if (kind <= Long.BYTES) {
            predicted((int) (x >>> (8 * kind - 8)));
            there >>= 1;
        }
        for (int k = 0; k < 8; k++) {
            if ((there >> k & 1) != 0) {
                bytes[length++] = (byte) (x >>> (8 * k));
            }
        }
    }

    /** Columns that change alike repeat each other from word to word. */
    private void follow(int slot) {
        follower[lastSlot] = slot;
        lastSlot = slot;
    }

    /** By which of its bytes are not 0. */
    private static int kind(int mask) {
        int upTo = 32 - Integer.numberOfLeadingZeros(mask);
        return mask == 1 << 4 ? UPPER_BYTE : Integer.bitCount(mask) < upTo - 1 ? MASK : upTo;
    }

    /** Which bytes of a word are there. */
    private static int bytesOf(int kind, int mask) {
        return kind == MASK ? mask : kind == UPPER_BYTE ? 1 << 4 : (1 << kind) - 1;
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
            bytes[length++] = (byte) (left | 128);
            left >>>= 7;
        }
        bytes[length++] = (byte) left;
    }

    private void room(int more) {
        if (bytes.length - length < more) {
            if (length > Integer.MAX_VALUE / 2) {
                throw new StateException(
                        "the difference of the states takes more than 1073741823 bytes; save them"
                                + " instead");
            }
            bytes = Arrays.copyOf(bytes, Math.max(64, 2 * bytes.length));
        }
    }

    /** No more than it takes; nothing can be added any more. */
    DeltaWords trimmed() {
        return new DeltaWords(
                PackedHeads.pack(heads, headLength),
                headLength,
                Arrays.copyOf(bytes, length),
                sumBefore,
                sumAfter);
    }

    /**
     * Applies it to a state in the wide layout.
     *
     * @param sum of the words that are to be changed, or the state is none of the two
     */
    void apply(WorldState wide, long sum) {
        byte[] plain = PackedHeads.unpack(heads, headLength);
        long found = walk(plain, wide, false);
        if (found != sum) {
            throw new StateException(
                    "the state is not the one that the delta starts from: the numbers that it"
                            + " changes are others; apply deltas in the order of their ticks, and"
                            + " revert them in the opposite order");
        }
        walk(plain, wide, true);
    }

    /** Goes over all words that differ; the sum of what they were. */
    private long walk(byte[] plain, WorldState wide, boolean writes) {
        // what threads share stays
        DeltaWords reader = new DeltaWords(plain, headLength, bytes, 0, 0, true);
        long sum = 0;
        long w = 0;
        while (reader.headAt < headLength) {
            int head = reader.readHead();
            w += reader.readSkip(head >> 4);
            int kind = head & 15;
            long run = kind == EVEN ? reader.readVarint() : 1;
            if (run == 0 || run > (wide.size >> 3) - w) {
                throw damaged(
                        "words up to " + (w + run) + " are to be changed, of " + (wide.size >> 3));
            }
            long x = 0;
            long step = 0;
            for (int i = 0; i < run; i++, w++) {
                int place = (int) (8 * w);
                long now = (long) StateWriter.LONG.get(wide.bytes, place);
                sum = mix(sum, now);
                long next = x + step;
                if (kind != EVEN || i < 2) {
                    next = reader.readWord(kind == EVEN ? reader.readHead() & 15 : kind);
                }
                step = next - x;
                x = next;
                if (writes) {
                    StateWriter.LONG.set(wide.bytes, place, now ^ x);
                }
            }
        }
        return sum;
    }

    private int readHead() {
        if (headAt >= headLength) {
            throw damaged("the heads end too early");
        }
        return heads[headAt++] & 255;
    }

    private long readSkip(int code) {
        if (code == 0) {
            return 0;
        }
        if (code == PATTERN) {
            return skips.next();
        }
        long skip = code == FAR ? readVarint() : code;
        if (skip > Integer.MAX_VALUE) {
            throw damaged(skip + " words are skipped");
        }
        skips.next((int) skip);
        return skip;
    }

    private long readWord(int kind) {
        if (kind >= PLACE || kind == FOLLOWS) {
            int slot = kind == FOLLOWS ? follower[lastSlot] : ((kind - PLACE) << 8) | readByte();
            follow(slot);
            return seen[slot];
        }
        if (kind == EVEN) {
            throw damaged("a word of even steps has steps");
        }
        int mask = bytesOf(kind, kind == MASK ? readHead() : 0);
        long x = 0;
        if (kind != MASK && kind <= Long.BYTES) {
            x = (long) readHead() << (8 * kind - 8);
            mask >>= 1;
        }
        for (int k = 0; k < 8; k++) {
            if ((mask >> k & 1) != 0) {
                x |= (long) readByte() << (8 * k);
            }
        }
        seen[slot(x)] = x;
        follow(slot(x));
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

    /**
     * Guesses how many words are skipped before the next one that differs. Columns of the same rows
     * change in the same places: after the same skip as before, the same ones follow.
     */
    private static final class Skips {
        private static final int LENGTH = 1024;
        private static final int PLACES = 256;
        private static final int[] NOT_USED = {};

        /** The last ones, in a ring. */
        private final int[] ring;

        /** Behind which one a skip was last, by the upper bits of a product; 0 for none. */
        private final int[] behind;

        private int count = 1;
        private int guess;

        Skips(boolean isUsed) {
            ring = isUsed ? new int[LENGTH] : NOT_USED;
            behind = isUsed ? new int[PLACES] : NOT_USED;
        }

        /** What is guessed; it comes true. */
        int next() {
            int skip = ring[guess & (LENGTH - 1)];
            next(skip);
            return skip;
        }

        /**
         * What comes next.
         *
         * @return whether it was guessed
         */
        boolean next(int skip) {
            int slot = (int) ((skip * ODD) >>> 56);
            boolean isGuessed = guess > 0 && ring[guess & (LENGTH - 1)] == skip;
            guess = isGuessed ? guess + 1 : behind[slot];
            ring[count++ & (LENGTH - 1)] = skip;
            behind[slot] = count;
            if (guess == count) {
                guess = 0;
            }
            return isGuessed;
        }
    }
}
