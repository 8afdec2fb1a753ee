package dev.cairn.benchmarks;

import dev.cairn.core.state.WorldState;
import dev.cairn.physics.Body;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;

import org.openjdk.jmh.annotations.AuxCounters;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Arrays;
import java.util.concurrent.TimeUnit;

/**
 * What a frame of a rollback costs in which the oldest input was predicted wrongly: back by eight
 * ticks, and again up to now, each tick saved. Piles of four boxes, awake, on one core.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 5, time = 2)
@Measurement(iterations = 5, time = 2)
@Fork(1)
public class RollbackFrame {
    private static final int TICKS = 8;
    private static final int HIGH = 4;

    /** In piles. */
    @Param("500")
    public int bodies;

    private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    private final WorldState[] past = new WorldState[TICKS];
    private PhysicsWorld world = PhysicsWorld.builder().workers(1).build();

    /** CPU time of the thread, which a busy machine does not lengthen. */
    @AuxCounters(AuxCounters.Type.EVENTS)
    @State(Scope.Thread)
    public static class Cpu {
        /** Mean of a frame, µs; JMH shows the sum over its iterations. */
        public double cpuMicros;

        private long nanos;
        private long frames;

        /** None yet. */
        @Setup(Level.Iteration)
        public void clear() {
            nanos = 0;
            frames = 0;
        }

        void add(long taken) {
            nanos += taken;
            frames++;
            cpuMicros = nanos / 1e3 / frames;
        }
    }

    /** Piles at rest, awake. */
    @Setup(Level.Trial)
    public void build() {
        Arrays.setAll(past, i -> new WorldState());
        world.close();
        world = PhysicsWorld.builder().workers(1).sleeping(false).build();
        world.add(Body.fixed().shape(Box.ofHalfExtents(100, 1, 100)).at(0, -1, 0));
        for (int i = 0; i < bodies; i++) {
            int pile = i / HIGH;
            world.add(
                    Body.dynamic()
                            .shape(Box.cubeOfHalfExtent(0.5))
                            .at(pile % 12 * 2 - 12, 0.5 + i % HIGH, pile / 12 * 2));
        }
        for (int tick = 0; tick < 30; tick++) {
            world.step(1.0 / 60);
        }
        world.save(past[0]);
    }

    /** The world ends. */
    @TearDown(Level.Trial)
    public void close() {
        world.close();
    }

    /** Eight ticks again. */
    @Benchmark
    public PhysicsWorld eightTicksAgain(Cpu cpu) {
        long before = threads.getCurrentThreadCpuTime();
        world.restore(past[0]);
        for (WorldState state : past) {
            world.save(state);
            world.step(1.0 / 60);
        }
        cpu.add(threads.getCurrentThreadCpuTime() - before);
        return world;
    }
}
