package dev.cairn.render.app;

import dev.cairn.core.snapshot.SnapshotExchange;
import dev.cairn.core.snapshot.SnapshotExtra;
import dev.cairn.core.tick.TickLoop;
import dev.cairn.physics.DebugData;
import dev.cairn.physics.PhysicsWorld;

import org.jspecify.annotations.Nullable;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;

/**
 * The simulation thread of an application: makes the scene, steps it, publishes it, and ends with a
 * failure or when told to.
 */
final class Simulation {
    private static final long SHORTEST_PARK_NANOS = 50_000;
    private static final long LONGEST_PARK_NANOS = 2_000_000;

    /** What the thread asks of the application. */
    interface Host {
        PhysicsWorld createPhysics();

        /** Fills the scene. */
        void begin(PhysicsWorld physics);

        void update(double seconds);

        /** After the step, before it is published. */
        default void updated(double seconds) {}

        /** A tick has failed; whether the scene is to be made anew, rather than all to end. */
        default boolean beginsAgainAfter(RuntimeException failure) {
            return false;
        }
    }

    private final Host host;
    private final TickLoop loop;
    private final SnapshotExchange exchange = new SnapshotExchange();
    private final AtomicInteger singleSteps = new AtomicInteger();
    private final Thread thread;
    private volatile boolean paused;
    private volatile boolean stopping;
    private volatile boolean restarting;
    private final AtomicInteger debugMask = new AtomicInteger();
    private final SnapshotExtra debugData = this::debugData;
    private volatile long ticks;
    private volatile long steps;
    private volatile @Nullable Throwable failure;
    private long done;
    private long stepsDone;
    private @Nullable PhysicsWorld physics;

    /**
     * A thread that is not started yet.
     *
     * @param host whose scene it is
     * @param stepSeconds length of a tick
     * @param ticksInAll ends after so many as fast as it can; negative = in real time until {@link
     *     #stop}
     */
    Simulation(Host host, double stepSeconds, long ticksInAll) {
        this.host = host;
        this.loop = new TickLoop(stepSeconds, this::tickOrBeginAgain);
        this.thread = new Thread(() -> run(stepSeconds, ticksInAll), "cairn-simulation");
        // A scene that never returns from update must not keep the program alive once its window is
        // gone.
        thread.setDaemon(true);
    }

    void start() {
        thread.start();
    }

    private void run(double stepSeconds, long ticksInAll) {
        try {
            begin();
            if (ticksInAll >= 0) {
                while (ticks < ticksInAll && !stopping) {
                    tick(stepSeconds);
                }
            } else {
                runInRealTime(stepSeconds);
            }
        } catch (Throwable e) {
            failure = e;
        } finally {
            closeWorld();
        }
    }

    private void begin() {
        closeWorld();
        PhysicsWorld world = host.createPhysics();
        physics = world;
        done = 0;
        ticks = 0;
        steps = 0;
        stepsDone = 0;
        host.begin(world);
        publish(world);
    }

    private void closeWorld() {
        PhysicsWorld last = physics;
        physics = null;
        if (last != null) {
            last.close();
        }
    }

    private void publish(PhysicsWorld world) {
        exchange.publish(world.ecs(), debugMask.get() == 0 ? null : debugData);
    }

    private void beginAgainIfAsked() {
        if (restarting) {
            restarting = false;
            begin();
        }
    }

    private void runInRealTime(double stepSeconds) {
        long before = System.nanoTime();
        while (!stopping) {
            long now = System.nanoTime();
            loop.advance((now - before) * 1e-9);
            before = now;
            beginAgainIfAsked();
            double untilDue = (1 - loop.alpha()) * stepSeconds / Math.max(loop.timeScale(), 1e-3);
            LockSupport.parkNanos(
                    Math.clamp((long) (untilDue * 1e9), SHORTEST_PARK_NANOS, LONGEST_PARK_NANOS));
        }
    }

    private void tickOrBeginAgain(double seconds) {
        beginAgainIfAsked(); // what fails in here would fail again
        try {
            tick(seconds);
        } catch (RuntimeException failed) {
            if (!host.beginsAgainAfter(failed)) {
                throw failed;
            }
            restarting = true;
        }
    }

    private void tick(double seconds) {
        beginAgainIfAsked();
        PhysicsWorld world = physics;
        if (world == null) {
            throw new IllegalStateException("a tick before the scene was made");
        }
        boolean still = paused && !takeSingleStep();
        if (world.isPaused() != still) {
            world.setPaused(still);
        }
        if (!still) {
            host.update(seconds);
        }
        world.step(seconds);
        if (!still) {
            host.updated(seconds);
            steps = ++stepsDone;
        }
        publish(world);
        ticks = ++done;
    }

    private @Nullable Object debugData(@Nullable Object used) {
        PhysicsWorld world = physics;
        return world == null
                ? null
                : world.capture(used instanceof DebugData data ? data : new DebugData());
    }

    /** Makes the world anew before the next tick. Any thread. */
    void restart() {
        restarting = true;
    }

    /** Asks for debug data in the snapshots while any bit is set. Any thread. */
    void debug(int bit, boolean set) {
        debugMask.updateAndGet(mask -> set ? mask | bit : mask & ~bit);
    }

    int debugMask() {
        return debugMask.get();
    }

    private boolean takeSingleStep() {
        int asked = singleSteps.get();
        return asked > 0 && singleSteps.compareAndSet(asked, asked - 1);
    }

    /** Runs an action on the simulation thread before its next tick. Any thread. */
    void post(Runnable action) {
        loop.post(action);
    }

    void setPaused(boolean value) {
        singleSteps.set(0);
        paused = value;
    }

    boolean isPaused() {
        return paused;
    }

    void singleStep() {
        paused = true;
        singleSteps.incrementAndGet();
    }

    void setTimeScale(double value) {
        loop.setTimeScale(value);
    }

    double timeScale() {
        return loop.timeScale();
    }

    long ticks() {
        return ticks;
    }

    /** Ticks of this world in which its physics was not paused. */
    long steps() {
        return steps;
    }

    SnapshotExchange exchange() {
        return exchange;
    }

    /** Whether the thread has ended, by a failure or because all ticks are done. */
    boolean isOver() {
        return failure != null || !thread.isAlive();
    }

    /** Waits for the end. */
    void await() throws InterruptedException {
        thread.join();
    }

    /** Tells the thread to end and waits; after ten seconds the program goes on without it. */
    void stop() {
        stopping = true;
        LockSupport.unpark(thread);
        try {
            thread.join(10_000);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Throws what the thread failed with, if it failed. */
    void rethrow() {
        Throwable thrown = failure;
        switch (thrown) {
            case null -> {}
            case RuntimeException e -> throw e;
            case Error e -> throw e;
            default -> throw new IllegalStateException("the simulation failed: " + thrown, thrown);
        }
    }

    /** The failure in words, or null. */
    @Nullable String failureText() {
        Throwable thrown = failure;
        return thrown == null
                ? null
                : "The simulation stopped after " + ticks + " ticks: " + thrown;
    }
}
