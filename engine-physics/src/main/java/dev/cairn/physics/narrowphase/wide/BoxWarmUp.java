package dev.cairn.physics.narrowphase.wide;

import org.jspecify.annotations.Nullable;

import java.util.Random;

/**
 * Runs the wide kernels of boxes and of round shapes in a thread of their own until the compiler is
 * done with them. Code of the Vector API that is not compiled yet is some hundred times slower than
 * scalar code, and its vectors are objects on the heap. The lanes give the same bits as the scalar
 * path, so it does not matter to the result when the change comes.
 */
public final class BoxWarmUp {
    private static final int LEAST = 12_000;
    private static final int MOST = 100_000;

    /** So many rounds in a row must be fast: none takes {@link #SLOW} times the best. */
    private static final int IN_A_ROW = 200;

    private static final int SLOW = 4;
    private static final Object LOCK = new Object();

    private static volatile @Nullable Thread thread;
    private static volatile boolean ready;

    private BoxWarmUp() {}

    /**
     * Whether the kernels are compiled; starts the thread at the first call. Any thread; allocates
     * at the first call only. Returns false on a machine without lanes.
     */
    public static boolean ready() {
        if (thread == null && BoxAxes.wide()) {
            begin();
        }
        return ready;
    }

    /**
     * Waits until the thread has come to its end, some seconds; for tests. Any thread.
     *
     * @return {@link #ready}
     * @throws InterruptedException if the caller is interrupted
     */
    public static boolean finish() throws InterruptedException {
        if (!ready() && BoxAxes.wide()) {
            begin().join();
        }
        return ready;
    }

    private static Thread begin() {
        synchronized (LOCK) {
            Thread known = thread;
            if (known != null) {
                return known;
            }
            Thread made = new Thread(BoxWarmUp::run, "cairn-warm-up-boxes");
            made.setDaemon(true);
            made.start();
            thread = made;
            return made;
        }
    }

    private static void run() {
        BoxBatch batch = new BoxBatch();
        RoundBatch pairs = new RoundBatch();
        RecycledBatch kept = new RecycledBatch();
        double[] numbers = new double[RecycledBatch.KEPT * RecycledBatch.CAPACITY];
        Random random = new Random(1);
        long scalar = Long.MAX_VALUE;
        long axes = Long.MAX_VALUE;
        long faces = Long.MAX_VALUE;
        long others = Long.MAX_VALUE;
        int hysteresis = 0;
        for (int round = 0; round < MOST; round++) {
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
            System.arraycopy(batch.data, 0, pairs.data, 0, RoundBatch.CAPACITY * 20);
            long fifth = System.nanoTime();
            pairs.run(RoundBatch.CAPACITY, true, true, 1, 1);
            pairs.run(RoundBatch.CAPACITY, true, false, 1, 1);
            pairs.run(RoundBatch.CAPACITY, false, true, 1, 1);
            pairs.run(RoundBatch.CAPACITY, false, false, 1, 1);
            // All parallel: these take another kernel.
            System.arraycopy(
                    pairs.data,
                    RoundBatch.TURN_A,
                    pairs.data,
                    RoundBatch.TURN_B,
                    4 * RoundBatch.CAPACITY);
            pairs.run(RoundBatch.CAPACITY, true, true, 1, 1);
            kept.run(RecycledBatch.CAPACITY, numbers, 0, 1, 1);
            long sixth = System.nanoTime();
            others = Math.min(others, sixth - fifth);
            int places = 1 + round % RecycledBatch.CAPACITY;
            int first = random.nextInt((RecycledBatch.CAPACITY - places) / RecycledBatch.ROWS + 1);
            kept.run(places, numbers, first * RecycledBatch.ROWS * RecycledBatch.KEPT, 1, 1);
            pairs.run(1 + round % RoundBatch.CAPACITY, round % 2 == 0, round % 4 < 2, 1, 1);
            scalar = Math.min(scalar, second - start);
            axes = Math.min(axes, third - second);
            faces = Math.min(faces, end - fourth);
            boolean isFast =
                    third - second < SLOW * axes
                            && end - fourth < SLOW * faces
                            && sixth - fifth < SLOW * others;
            hysteresis = isFast ? hysteresis + 1 : 0;
            // compiled, all after the axes costs no more than the scalar axes
            boolean paysOff = axes < scalar && faces < scalar && others < 2 * scalar;
            if (round > LEAST && paysOff && (hysteresis >= IN_A_ROW || round == MOST - 1)) {
                ready = true;
                return;
            }
        }
    }

    /** Pairs of unlike boxes in any pose. */
    private static void fill(double[] t, Random random) {
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
    private static void stack(double[] t, Random random, boolean isInside) {
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

    private static void turn(double[] t, int at, Random random) {
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
