package dev.cairn.core.state;

import java.util.Arrays;

/**
 * The heads of {@link DeltaWords} in few bits: a binary arithmetic coder (Rissanen and Langdon
 * 1979, Arithmetic coding) whose chances are the shares that were seen. The two halves of a head
 * are predicted from those of the head before, the byte with it from its kind; each bit from those
 * above it. Integers only, so that the bytes are the same on every machine.
 *
 * <pre>
 *   low          cut                 high      of the interval [low, high] a 1 takes the part up to
 *   |-- bit 1 ---|------ bit 0 -------|        the cut; bytes that both ends share are done with
 * </pre>
 *
 * It takes some 0.1 us for a head, so only short deltas are packed.
 */
final class PackedHeads {
    /** Longer ones are left as they are. */
    private static final int LONGEST = 4096;

    /** Kinds up to this one have a byte with them. */
    private static final int WITH_BYTE = 8;

    private static final byte[] NONE = {};

    /** A chance is of so many bits; above it in its number stands how often it was asked for. */
    private static final int CHANCE_BITS = 16;

    private static final int ONE = 1 << CHANCE_BITS;
    private static final int EVEN_CHANCE = ONE / 2;
    private static final int LEAST = 48;

    /** After so many a chance follows what comes at a steady rate. */
    private static final int STEADY = 40;

    /** By how often it was asked for: the share of what comes in a chance, of 65536. */
    private static final int[] RATE = new int[STEADY + 1];

    static {
        for (int n = 0; n <= STEADY; n++) {
            RATE[n] = 2 * ONE / (2 * n + 3);
        }
    }

    private byte[] bytes = NONE;
    private int size;
    private int at;
    private int low;
    private int high = -1;
    private int code;

    private final int[] codes = chances(16 * 16);
    private final int[] kinds = chances(16 * 16);
    private final int[] others = chances((WITH_BYTE + 1) * 256);

    private static int[] chances(int count) {
        int[] chances = new int[count];
        Arrays.fill(chances, EVEN_CHANCE);
        return chances;
    }

    static byte[] pack(byte[] heads, int length) {
        if (length == 0 || length > LONGEST) {
            return Arrays.copyOf(heads, length);
        }
        PackedHeads out = new PackedHeads();
        int last = 0;
        for (int i = 0; i < length; i++) {
            int head = heads[i] & 255;
            out.put(out.codes, last & 0xF0, 4, head >> 4);
            out.put(out.kinds, (last & 15) << 4, 4, head & 15);
            if ((head & 15) <= WITH_BYTE) {
                out.put(out.others, (head & 15) << 8, 8, heads[++i] & 255);
            }
            last = head;
        }
        out.write((out.low >>> 24) + 1); // behind it 0 is read
        return Arrays.copyOf(out.bytes, out.size);
    }

    static byte[] unpack(byte[] packed, int length) {
        if (length <= 0 || length > LONGEST) {
            if (length != packed.length) {
                throw new StateException(
                        "the delta is damaged: there are "
                                + packed.length
                                + " bytes of heads, and not "
                                + length);
            }
            return packed;
        }
        PackedHeads in = new PackedHeads();
        in.bytes = packed;
        in.size = packed.length;
        for (int i = 0; i < 4; i++) {
            in.code = (in.code << 8) | in.next();
        }
        byte[] heads = new byte[length];
        int last = 0;
        for (int i = 0; i < length; i++) {
            int head = in.get(in.codes, last & 0xF0, 4) << 4;
            head |= in.get(in.kinds, (last & 15) << 4, 4);
            heads[i] = (byte) head;
            if ((head & 15) <= WITH_BYTE && i + 1 < length) {
                heads[++i] = (byte) in.get(in.others, (head & 15) << 8, 8);
            }
            last = head;
        }
        return heads;
    }

    private void put(int[] chances, int from, int bits, int value) {
        int node = 1;
        for (int i = bits - 1; i >= 0; i--) {
            int bit = (value >>> i) & 1;
            put(chances, from + node, bit);
            node = 2 * node + bit;
        }
    }

    private int get(int[] chances, int from, int bits) {
        int node = 1;
        for (int i = 0; i < bits; i++) {
            node = 2 * node + get(chances, from + node);
        }
        return node - (1 << bits);
    }

    private void put(int[] chances, int place, int bit) {
        int cut = cut(chances[place]);
        if (bit == 1) {
            high = cut;
        } else {
            low = cut + 1;
        }
        learn(chances, place, bit);
        while ((low ^ high) >>> 24 == 0) {
            write(high >>> 24);
            low <<= 8;
            high = (high << 8) | 255;
        }
    }

    private int get(int[] chances, int place) {
        int cut = cut(chances[place]);
        int bit = Integer.compareUnsigned(code, cut) <= 0 ? 1 : 0;
        if (bit == 1) {
            high = cut;
        } else {
            low = cut + 1;
        }
        learn(chances, place, bit);
        while ((low ^ high) >>> 24 == 0) {
            low <<= 8;
            high = (high << 8) | 255;
            code = (code << 8) | next();
        }
        return bit;
    }

    private int cut(int chance) {
        long range = (high & 0xFFFF_FFFFL) - (low & 0xFFFF_FFFFL);
        return low + (int) ((range * (chance & (ONE - 1))) >>> CHANCE_BITS);
    }

    private static void learn(int[] chances, int place, int bit) {
        int now = chances[place];
        int seen = now >>> CHANCE_BITS;
        int chance = now & (ONE - 1);
        int gap = (bit == 1 ? ONE : 0) - chance;
        chance += (int) (((long) gap * RATE[seen]) >> CHANCE_BITS);
        chance = Math.min(Math.max(chance, LEAST), ONE - LEAST);
        chances[place] = (Math.min(seen + 1, STEADY) << CHANCE_BITS) | chance;
    }

    private void write(int octet) {
        if (size == bytes.length) {
            bytes = Arrays.copyOf(bytes, Math.max(64, 2 * size));
        }
        bytes[size++] = (byte) octet;
    }

    private int next() {
        return at < size ? bytes[at++] & 255 : 0;
    }
}
