package dev.cairn.core.ecs.storage;

import org.jspecify.annotations.Nullable;

/**
 * The 64-bit hash behind digests and checked mode: the round and the avalanche of xxHash64 (Y.
 * Collet, 2014, BSD specification) over whole words, in four independent lanes so that the
 * multiplications overlap. NaNs are canonical, as their sign and payload depend on the CPU.
 */
public final class Hash {
    public static final long START = 0x27D4EB2F165667C5L;

    private static final long P1 = 0x9E3779B185EBCA87L;
    private static final long P2 = 0xC2B2AE3D27D4EB4FL;
    private static final long P3 = 0x165667B19E3779F9L;

    private Hash() {}

    private static long round(long lane, long word) {
        return Long.rotateLeft(lane + word * P2, 31) * P1;
    }

    /** Adds one word to a hash. */
    public static long mix(long hash, long word) {
        return avalanche(round(hash, word) ^ hash);
    }

    private static long avalanche(long hash) {
        long h = hash;
        h ^= h >>> 33;
        h *= P2;
        h ^= h >>> 29;
        h *= P3;
        return h ^ h >>> 32;
    }

    private static long merge(long a, long b, long c, long d, int count) {
        long sum =
                Long.rotateLeft(a, 1)
                        + Long.rotateLeft(b, 7)
                        + Long.rotateLeft(c, 12)
                        + Long.rotateLeft(d, 18);
        return avalanche(sum + count);
    }

    public static long of(String text) {
        long hash = START;
        for (int i = 0; i < text.length(); i++) {
            hash = mix(hash, text.charAt(i));
        }
        return hash;
    }

    /** The first rows of a column of any kind. */
    public static long of(Object column, int count) {
        return switch (column) {
            case double[] doubles -> of(doubles, count);
            case float[] floats -> of(floats, count);
            case long[] longs -> of(longs, count);
            case int[] ints -> of(ints, count);
            default -> of((Object[]) column, count);
        };
    }

    public static long of(double[] column, int count) {
        long a = P1;
        long b = P2;
        long c = P3;
        long d = START;
        int row = 0;
        for (; row <= count - 4; row += 4) {
            a = round(a, Double.doubleToLongBits(column[row]));
            b = round(b, Double.doubleToLongBits(column[row + 1]));
            c = round(c, Double.doubleToLongBits(column[row + 2]));
            d = round(d, Double.doubleToLongBits(column[row + 3]));
        }
        for (; row < count; row++) {
            a = round(a, Double.doubleToLongBits(column[row]));
        }
        return merge(a, b, c, d, count);
    }

    public static long of(float[] column, int count) {
        long a = P1;
        long b = P2;
        long c = P3;
        long d = START;
        int row = 0;
        for (; row <= count - 4; row += 4) {
            a = round(a, Float.floatToIntBits(column[row]));
            b = round(b, Float.floatToIntBits(column[row + 1]));
            c = round(c, Float.floatToIntBits(column[row + 2]));
            d = round(d, Float.floatToIntBits(column[row + 3]));
        }
        for (; row < count; row++) {
            a = round(a, Float.floatToIntBits(column[row]));
        }
        return merge(a, b, c, d, count);
    }

    public static long of(long[] column, int count) {
        long a = P1;
        long b = P2;
        long c = P3;
        long d = START;
        int row = 0;
        for (; row <= count - 4; row += 4) {
            a = round(a, column[row]);
            b = round(b, column[row + 1]);
            c = round(c, column[row + 2]);
            d = round(d, column[row + 3]);
        }
        for (; row < count; row++) {
            a = round(a, column[row]);
        }
        return merge(a, b, c, d, count);
    }

    public static long of(int[] column, int count) {
        long a = P1;
        long b = P2;
        long c = P3;
        long d = START;
        int row = 0;
        for (; row <= count - 4; row += 4) {
            a = round(a, column[row]);
            b = round(b, column[row + 1]);
            c = round(c, column[row + 2]);
            d = round(d, column[row + 3]);
        }
        for (; row < count; row++) {
            a = round(a, column[row]);
        }
        return merge(a, b, c, d, count);
    }

    /**
     * References have no bits that two JVMs agree on. Strings, enum constants and boxed numbers
     * count by value, anything else by whether it is there.
     */
    public static long of(Object[] column, int count) {
        long hash = START;
        for (int row = 0; row < count; row++) {
            hash = mix(hash, word(column[row]));
        }
        return hash;
    }

    private static long word(@Nullable Object value) {
        return switch (value) {
            case null -> 0;
            case String text -> of(text);
            case Enum<?> constant -> of(constant.name());
            case Double number -> Double.doubleToLongBits(number);
            case Float number -> Float.floatToIntBits(number);
            case Number number when value.getClass().getModule() == Object.class.getModule() ->
                    number.longValue();
            case Boolean flag -> flag ? 2 : 3;
            case Character letter -> letter;
            default -> 1;
        };
    }
}
