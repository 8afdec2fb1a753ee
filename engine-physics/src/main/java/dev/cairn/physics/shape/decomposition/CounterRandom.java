package dev.cairn.physics.shape.decomposition;

/**
 * Random numbers that are a function of a seed and a counter, so that none depends on what was
 * drawn before.
 *
 * <p>Source of the mixing: G. L. Steele, D. Lea, C. H. Flood, "Fast splittable pseudorandom number
 * generators", OOPSLA (2014), by D. Stafford's constants.
 */
final class CounterRandom {
    private static final long GOLDEN = 0x9E3779B97F4A7C15L;

    private CounterRandom() {}

    static long mix(long seed, long counter) {
        long z = seed + GOLDEN * (counter + 1);
        z = (z ^ (z >>> 30)) * 0xBF58476D1CE4E5B9L;
        z = (z ^ (z >>> 27)) * 0x94D049BB133111EBL;
        return z ^ (z >>> 31);
    }

    /** In [0, 1). */
    static double share(long seed, long counter) {
        return (mix(seed, counter) >>> 11) * 0x1p-53;
    }
}
