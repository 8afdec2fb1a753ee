package dev.cairn.core.ecs;

/**
 * Random numbers that are a pure function of (seed, tick, entity, stream, position). There is no
 * shared state, so the numbers do not depend on which worker draws them, or on what else draws.
 *
 * <p>The four words are folded into a key with the 64-bit finaliser of SplitMix64 (G. Steele, D.
 * Lea and C. Flood, "Fast splittable pseudorandom number generators", 2014), and the stream is the
 * SplitMix64 sequence from that key; the idea of a counter in place of a state is that of J. Salmon
 * et al., "Parallel random numbers: as easy as 1, 2, 3", 2011.
 *
 * <p>An object is a cursor for one thread. Nothing allocates. Not for secrets.
 */
public final class RandomStream {
    private static final long GAMMA = 0x9E3779B97F4A7C15L;
    private static final double DOUBLE_UNIT = 0x1.0p-53;
    private static final float FLOAT_UNIT = 0x1.0p-24f;

    private long state;

    /** A cursor at the beginning of the stream (0, 0, 0, 0). */
    public RandomStream() {
        reset(0, 0, 0, 0);
    }

    /**
     * Puts the cursor at the beginning of a stream.
     *
     * @param seed seed of the world
     * @param tick number of the tick
     * @param entity the entity, or any other number that tells draws apart
     * @param stream number of the use, so that two systems draw different numbers
     * @return this
     */
    public RandomStream reset(long seed, long tick, long entity, int stream) {
        long key = mix(seed + GAMMA);
        key = mix((key ^ tick) + GAMMA);
        key = mix((key ^ entity) + GAMMA);
        state = mix((key ^ stream) + GAMMA);
        return this;
    }

    static long mix(long word) {
        long z = word;
        z = (z ^ z >>> 30) * 0xBF58476D1CE4E5B9L;
        z = (z ^ z >>> 27) * 0x94D049BB133111EBL;
        return z ^ z >>> 31;
    }

    /**
     * The next number.
     *
     * @return 64 random bits
     */
    public long nextLong() {
        state += GAMMA;
        return mix(state);
    }

    /**
     * The next number below a bound, each equally often.
     *
     * @param bound the bound, positive
     * @return a number in {@code [0, bound)}
     * @throws IllegalArgumentException if the bound is not positive
     */
    public int nextInt(int bound) {
        if (bound <= 0) {
            throw new IllegalArgumentException("bound is " + bound + ", but must be at least 1");
        }
        // D. Lemire, "Fast random integer generation in an interval", 2019.
        long product = (nextLong() >>> 32) * bound;
        long low = product & 0xFFFF_FFFFL;
        if (low < bound) {
            long threshold = (1L << 32) % bound;
            while (low < threshold) {
                product = (nextLong() >>> 32) * bound;
                low = product & 0xFFFF_FFFFL;
            }
        }
        return (int) (product >>> 32);
    }

    /**
     * The next number in the unit interval.
     *
     * @return a multiple of 2^-53 in {@code [0, 1)}
     */
    public double nextDouble() {
        return (nextLong() >>> 11) * DOUBLE_UNIT;
    }

    /**
     * The next number of an interval.
     *
     * @param low lower end, finite
     * @param high upper end, finite, above {@code low}
     * @return a number in {@code [low, high)}
     * @throws IllegalArgumentException if the interval is empty or not finite
     */
    public double nextDouble(double low, double high) {
        if (!(low < high) || Double.isInfinite(high - low)) {
            throw new IllegalArgumentException(
                    "the interval is ["
                            + low
                            + ", "
                            + high
                            + "), but low must be below high and both finite");
        }
        double value = low + (high - low) * nextDouble();
        return value < high ? value : Math.nextDown(high);
    }

    /**
     * The next number in the unit interval.
     *
     * @return a multiple of 2^-24 in {@code [0, 1)}
     */
    public float nextFloat() {
        return (nextLong() >>> 40) * FLOAT_UNIT;
    }
}
