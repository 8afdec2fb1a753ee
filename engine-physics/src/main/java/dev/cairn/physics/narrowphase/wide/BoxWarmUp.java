package dev.cairn.physics.narrowphase.wide;

import dev.cairn.physics.internal.KernelWarmUp;

import java.util.SplittableRandom;

/** Warms up the wide kernels of boxes. */
public final class BoxWarmUp extends KernelWarmUp {
    private static final BoxWarmUp KERNELS = new BoxWarmUp();

    /** A round is slow when it takes so many times the best. */
    private static final int SLOW = 4;

    private final BoxBatch batch = new BoxBatch();
    private final SplittableRandom random = new SplittableRandom(1);
    private long scalar = Long.MAX_VALUE;
    private long axes = Long.MAX_VALUE;
    private long faces = Long.MAX_VALUE;

    private BoxWarmUp() {
        super("cairn-warm-up-boxes", 6_000, 100_000);
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
        fill(batch.data, random);
        if (round % 3 == 1) {
            stack(batch.data, random, round % 2 == 0);
        }
        long start = System.nanoTime();
        BoxAxes.scalar(batch, BoxBatch.CAPACITY);
        long second = System.nanoTime();
        BoxAxes.faces(batch, BoxBatch.CAPACITY);
        BoxAxes.edges(batch, round % 4 == 0 ? random.nextInt() & round : -1);
        long third = System.nanoTime();
        choose(batch.data, round);
        long fourth = System.nanoTime();
        BoxAxes.choose(batch, BoxBatch.CAPACITY);
        BoxAxes.corners(batch, BoxBatch.CAPACITY);
        BoxAxes.clipAligned(batch, BoxBatch.CAPACITY);
        BoxAxes.crossings(batch, -1);
        BoxAxes.world(batch, BoxBatch.CAPACITY);
        long end = System.nanoTime();
        scalar = Math.min(scalar, second - start);
        axes = Math.min(axes, third - second);
        faces = Math.min(faces, end - fourth);
        return third - second < SLOW * axes && end - fourth < SLOW * faces;
    }

    /** Compiled, all that follows the axes costs no more than the scalar axes. */
    @Override
    protected boolean paysOff() {
        return axes < scalar && faces < 1.5 * scalar;
    }

    /** Pairs of unlike boxes in any pose. */
    private static void fill(double[] t, SplittableRandom random) {
        for (int i = 0; i < BoxBatch.CAPACITY; i++) {
            turn(t, BoxBatch.TURN_A + i, random);
            turn(t, BoxBatch.TURN_B + i, random);
            for (int k = 0; k < 3; k++) {
                int column = k * BoxBatch.CAPACITY + i;
                t[BoxBatch.OFFSET + column] = 2 * random.nextDouble() - 1;
                t[BoxBatch.HALF_A + column] = 0.5 + random.nextDouble();
                t[BoxBatch.HALF_B + column] = 0.5 + random.nextDouble();
            }
        }
    }

    /** Boxes on boxes that stand straight, as most of a scene do: inside, or across one side. */
    private static void stack(double[] t, SplittableRandom random, boolean isInside) {
        for (int i = 0; i < BoxBatch.CAPACITY; i++) {
            for (int k = 0; k < 4; k++) {
                int column = k * BoxBatch.CAPACITY + i;
                t[BoxBatch.TURN_A + column] = k == 3 ? 1 : 0;
                t[BoxBatch.TURN_B + column] = k == 3 ? 1 : 0;
            }
            int y = BoxBatch.CAPACITY + i;
            int z = 2 * BoxBatch.CAPACITY + i;
            t[BoxBatch.HALF_B + i] = t[BoxBatch.HALF_A + i] - 0.2;
            t[BoxBatch.HALF_B + z] = t[BoxBatch.HALF_A + z] - 0.2;
            t[BoxBatch.OFFSET + i] = isInside ? 0 : 0.3 + 0.1 * random.nextDouble();
            t[BoxBatch.OFFSET + y] = t[BoxBatch.HALF_A + y] + t[BoxBatch.HALF_B + y] - 0.01;
            t[BoxBatch.OFFSET + z] = 0;
        }
    }

    /** A random orientation, in columns of a batch's length. */
    private static void turn(double[] t, int at, SplittableRandom random) {
        double x = random.nextDouble() - 0.5;
        double y = random.nextDouble() - 0.5;
        double z = random.nextDouble() - 0.5;
        double w = 0.5 + random.nextDouble();
        double size = Math.sqrt(x * x + y * y + z * z + w * w);
        t[at] = x / size;
        t[at + BoxBatch.CAPACITY] = y / size;
        t[at + 2 * BoxBatch.CAPACITY] = z / size;
        t[at + 3 * BoxBatch.CAPACITY] = w / size;
    }

    /** Any face will do. */
    private static void choose(double[] t, int round) {
        for (int i = 0; i < BoxBatch.CAPACITY; i++) {
            t[BoxBatch.FLIP + i] = (i + round) % 2;
            t[BoxBatch.AXIS + i] = (i + round) % 3;
            t[BoxBatch.SIGN + i] = i % 4 < 2 ? 1 : -1;
        }
    }
}
