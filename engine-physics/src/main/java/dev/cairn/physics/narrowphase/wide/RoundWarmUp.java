package dev.cairn.physics.narrowphase.wide;

import dev.cairn.physics.internal.KernelWarmUp;

import java.util.SplittableRandom;

/** Warms up the wide kernels of balls and capsules. */
public final class RoundWarmUp extends KernelWarmUp {
    private static final RoundWarmUp KERNELS = new RoundWarmUp();

    /** A round is slow when it takes so many times the best. */
    private static final int SLOW = 4;

    /** Compiled, five runs of a batch take some microseconds; interpreted some milliseconds. */
    private static final long COMPILED_NANOS = 100_000;

    private final RoundBatch pairs = new RoundBatch();
    private final SplittableRandom random = new SplittableRandom(1);
    private long best = Long.MAX_VALUE;

    private RoundWarmUp() {
        super("cairn-warm-up-round", 6_000, 100_000);
    }

    /**
     * Whether the kernels are compiled; begins with that once they were wanted for long enough. Any
     * thread. False on a machine without lanes.
     *
     * @param ticks in which the caller would have used them so far
     */
    public static boolean ready(int ticks) {
        return BoxAxes.wide() && KERNELS.isReadyAfter(ticks);
    }

    /**
     * Waits until they are compiled, some seconds. Any thread.
     *
     * @return {@link #ready}
     */
    public static boolean await() {
        return BoxAxes.wide() && KERNELS.finish();
    }

    @Override
    protected boolean run(int round) {
        double[] t = pairs.data;
        for (int i = 0; i < 20 * RoundBatch.CAPACITY; i++) {
            t[i] = 0.5 + random.nextDouble();
        }
        for (int i = 0; i < RoundBatch.CAPACITY; i++) {
            BoxWarmUp.turn(t, RoundBatch.TURN_A + i, random);
            BoxWarmUp.turn(t, RoundBatch.TURN_B + i, random);
            for (int k = 0; k < 3; k++) {
                t[RoundBatch.OFFSET + k * RoundBatch.CAPACITY + i] = 2 * random.nextDouble() - 1;
            }
        }
        long start = System.nanoTime();
        pairs.run(RoundBatch.CAPACITY, true, true, 1, 1);
        pairs.run(RoundBatch.CAPACITY, true, false, 1, 1);
        pairs.run(RoundBatch.CAPACITY, false, true, 1, 1);
        pairs.run(RoundBatch.CAPACITY, false, false, 1, 1);
        // All parallel: these take another kernel.
        System.arraycopy(t, RoundBatch.TURN_A, t, RoundBatch.TURN_B, 4 * RoundBatch.CAPACITY);
        pairs.run(RoundBatch.CAPACITY, true, true, 1, 1);
        long took = System.nanoTime() - start;
        pairs.run(1 + round % RoundBatch.CAPACITY, round % 2 == 0, round % 4 < 2, 1, 1);
        best = Math.min(best, took);
        return took < SLOW * best;
    }

    @Override
    protected boolean paysOff() {
        return best < COMPILED_NANOS;
    }
}
