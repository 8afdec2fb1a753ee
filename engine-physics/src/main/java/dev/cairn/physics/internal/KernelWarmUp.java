package dev.cairn.physics.internal;

import org.jspecify.annotations.Nullable;

import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.concurrent.locks.ReentrantLock;

/**
 * Runs kernels of the Vector API on made-up data until the compiler is done with them, without
 * being felt.
 *
 * <p>Code of the Vector API that is not compiled yet is some hundred times slower than scalar code,
 * and its vectors are objects on the heap. So a scene runs its scalar kernels until the wide ones
 * are ready; both give the same bits, so it does not matter to the result when the change comes.
 * Three rules keep the start cheap: the kernels of a scene are asked for only after it has wanted
 * them for a while, so that its scalar code is compiled first; one group of kernels at a time; and
 * a thread that rests three times as long as it works, at most a quarter of one core. While it
 * rests the compiler works: rounds in between would be slow for nothing.
 */
public abstract class KernelWarmUp {
    /** Ticks in which kernels must have been wanted: until then scalar code is being compiled. */
    private static final int PATIENCE_TICKS = 100;

    /** Work between two rests, s e-9. */
    private static final long SLICE_NANOS = 2_000_000;

    /** Rest over work. */
    private static final int REST = 3;

    /**
     * So many more fast rounds than {@link #PENALTY} times the slow ones there must have been. Who
     * interrupts the thread makes a round slow; a kernel that meets what it was not compiled for
     * makes many slow.
     */
    private static final int CALM = 200;

    private static final int PENALTY = 20;

    /** One group of kernels at a time. */
    private static final ReentrantLock TURN = new ReentrantLock(true);

    private final String name;
    private final int leastRounds;
    private final int mostRounds;
    private volatile @Nullable Thread thread;
    private volatile boolean isUrgent;
    private volatile boolean isOver;
    private volatile boolean isReady;

    /**
     * Kernels that nobody has asked for yet.
     *
     * @param name of the thread
     * @param leastRounds after which they may be used
     * @param mostRounds after which they are given up if they do not pay off
     */
    protected KernelWarmUp(String name, int leastRounds, int mostRounds) {
        this.name = name;
        this.leastRounds = leastRounds;
        this.mostRounds = mostRounds;
    }

    /**
     * Runs the kernels once on made-up data, as unlike from round to round as those of scenes.
     *
     * @param round from 0 on
     * @return whether they ran like compiled code
     */
    protected abstract boolean run(int round);

    /** Whether the kernels are worth it, by the best times so far. */
    protected abstract boolean paysOff();

    /** Told once, when they are not. */
    protected void giveUp() {}

    /** Told once, after the last round: the made-up data are not needed any more. */
    protected void end() {}

    /** Whether the kernels are compiled and worth using. Any thread. */
    public final boolean isReady() {
        return isReady;
    }

    /**
     * Whether the kernels are ready; begins to warm them up when they were wanted for a while. Any
     * thread; allocates when it begins.
     *
     * @param ticks in which the caller would have used them so far
     */
    public final boolean isReadyAfter(int ticks) {
        if (!isReady && ticks >= PATIENCE_TICKS) {
            begin();
        }
        return isReady;
    }

    /** Begins to warm up in the background, once. Any thread; allocates at the first call. */
    public final void begin() {
        if (thread == null) {
            start();
        }
    }

    private synchronized Thread start() {
        Thread known = thread;
        if (known != null) {
            return known;
        }
        Thread made = new Thread(this::inTurn, name);
        made.setDaemon(true);
        thread = made;
        made.start();
        return made;
    }

    /**
     * Waits until it is known whether the kernels are ready, without rests: about two seconds. Any
     * thread.
     *
     * @return {@link #isReady}
     */
    public final boolean finish() {
        if (!isOver) {
            isUrgent = true;
            Thread worker = start();
            LockSupport.unpark(worker);
            boolean interrupted = false;
            while (worker.isAlive()) {
                try {
                    worker.join();
                } catch (InterruptedException e) {
                    interrupted = true;
                }
            }
            if (interrupted) {
                Thread.currentThread().interrupt();
            }
        }
        return isReady;
    }

    private void inTurn() {
        boolean hasTurn = false;
        try {
            while (!hasTurn && !isUrgent) {
                hasTurn = TURN.tryLock(10, TimeUnit.MILLISECONDS);
            }
            rounds();
        } catch (InterruptedException e) {
            // Nobody interrupts this thread; if somebody does, the kernels stay as they are.
            Thread.currentThread().interrupt();
        } finally {
            end();
            isOver = true;
            if (hasTurn) {
                TURN.unlock();
            }
        }
    }

    private void rounds() {
        int calm = 0;
        long worked = 0;
        for (int round = 0; round < mostRounds; round++) {
            long start = System.nanoTime();
            calm = run(round) ? calm + 1 : Math.max(0, calm - PENALTY);
            worked += System.nanoTime() - start;
            if (round > leastRounds && calm >= CALM && paysOff()) {
                isReady = true;
                return;
            }
            if (worked > SLICE_NANOS && !isUrgent) {
                LockSupport.parkNanos(REST * worked);
                worked = 0;
            }
        }
        isReady = paysOff();
        if (!isReady) {
            giveUp();
        }
    }
}
