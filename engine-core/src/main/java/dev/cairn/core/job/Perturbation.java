package dev.cairn.core.job;

/**
 * Seeded disturbance of the schedule, for tests. Each worker draws from a stream of its own.
 *
 * <p>The generator is the finaliser of SplitMix64 (Steele, Lea, Flood: Fast Splittable Pseudorandom
 * Number Generators, 2014) over a counter.
 */
final class Perturbation {

    private static final long GOLDEN = 0x9E3779B97F4A7C15L;
    private static final int MAX_SPINS = 256;

    private final long[] counters;

    Perturbation(int workers, long seed) {
        counters = new long[workers * Lines.LINE];
        for (int worker = 0; worker < workers; worker++) {
            counters[worker * Lines.LINE] = mix(seed + worker * GOLDEN);
        }
    }

    /** Spins for a drawn time; once in a while yields the core. */
    @SuppressWarnings("ThreadPriorityCheck") // disturbing the scheduler is the purpose
    void disturb(int worker) {
        long draw = mix(counters[worker * Lines.LINE] += GOLDEN);
        int spins = (int) (draw >>> 32) & MAX_SPINS - 1;
        for (int i = 0; i < spins; i++) {
            Thread.onSpinWait();
        }
        if ((draw & 7) == 0) {
            Thread.yield();
        }
    }

    private static long mix(long z) {
        z = (z ^ z >>> 30) * 0xBF58476D1CE4E5B9L;
        z = (z ^ z >>> 27) * 0x94D049BB133111EBL;
        return z ^ z >>> 31;
    }
}
