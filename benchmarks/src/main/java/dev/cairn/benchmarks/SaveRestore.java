package dev.cairn.benchmarks;

import dev.cairn.core.state.WorldState;
import dev.cairn.physics.Body;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;

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

import java.util.concurrent.TimeUnit;

/** A world of awake bodies, saved into a state that is there, and restored from it. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class SaveRestore {
    /** Each box lies on the floor: one contact of four points to a body. */
    @Param("1000")
    public int bodies;

    private PhysicsWorld world = PhysicsWorld.builder().workers(1).build();
    private WorldState state = new WorldState();

    /** Bodies at rest, awake. */
    @Setup(Level.Trial)
    public void build() {
        world.close();
        world = PhysicsWorld.builder().workers(1).sleeping(false).build();
        world.add(Body.fixed().shape(Box.ofHalfExtents(100, 1, 100)).at(0, -1, 0));
        for (int i = 0; i < bodies; i++) {
            world.add(
                    Body.dynamic()
                            .shape(Box.cubeOfHalfExtent(0.5))
                            .at(i % 40 * 2 - 40, 0.5, i / 40 * 2));
        }
        for (int tick = 0; tick < 30; tick++) {
            world.step(1.0 / 60);
        }
        state = world.save();
    }

    /** The world ends. */
    @TearDown(Level.Trial)
    public void close() {
        world.close();
    }

    /** All columns into one block of bytes. */
    @Benchmark
    public WorldState save() {
        return world.save(state);
    }

    /** And back. */
    @Benchmark
    public WorldState restore() {
        world.restore(state);
        return state;
    }
}
