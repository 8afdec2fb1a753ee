package dev.cairn.benchmarks;

import dev.cairn.physics.Body;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;

import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

import java.util.concurrent.TimeUnit;

/** One step of a standing pyramid of unit cubes, at 60 Hz, after two seconds of settling. */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
@Fork(value = 1, jvmArgsAppend = "--add-modules=jdk.incubator.vector")
public class WorldStep {

    private static final double STEP = 1.0 / 60.0;
    private static final int SETTLING_STEPS = 120;

    /** The pyramid. */
    @State(Scope.Thread)
    public static class Pyramid {
        /** Cubes in the lowest row. */
        @Param("20")
        public int base;

        /** Number of workers. */
        @Param({"1", "2"})
        public int workers;

        PhysicsWorld world = PhysicsWorld.builder().sleeping(false).workers(1).build();

        /** Builds it and lets it settle. */
        @Setup
        public void build() {
            world.close();
            world =
                    PhysicsWorld.builder()
                            .sleeping(false)
                            .gravity(0, -9.81, 0)
                            .workers(workers)
                            .build();
            world.add(Body.fixed().shape(Box.of(100, 1, 100)).at(0, -1, 0));
            for (int row = 0; row < base; row++) {
                for (int i = 0; i < base - row; i++) {
                    double x = i - 0.5 * (base - row - 1);
                    world.add(Body.dynamic().shape(Box.cube(0.5)).at(1.01 * x, row + 0.5, 0));
                }
            }
            for (int step = 0; step < SETTLING_STEPS; step++) {
                world.step(STEP);
            }
        }

        /** Ends the world. */
        @TearDown
        public void close() {
            world.close();
        }
    }

    /**
     * One step.
     *
     * @param state the pyramid
     * @return the number of contacts
     */
    @Benchmark
    public int pyramid(Pyramid state) {
        state.world.step(STEP);
        return state.world.contacts().count();
    }
}
