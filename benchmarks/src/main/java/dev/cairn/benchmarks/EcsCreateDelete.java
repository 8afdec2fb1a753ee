package dev.cairn.benchmarks;

import com.artemis.Aspect;
import com.artemis.ComponentMapper;
import com.artemis.WorldConfigurationBuilder;

import dev.cairn.benchmarks.EcsModel.ArtemisPosition;
import dev.cairn.benchmarks.EcsModel.ArtemisVelocity;
import dev.cairn.benchmarks.EcsModel.MutablePosition;
import dev.cairn.benchmarks.EcsModel.MutableVelocity;
import dev.cairn.benchmarks.EcsModel.Position;
import dev.cairn.benchmarks.EcsModel.Velocity;
import dev.cairn.core.ecs.World;
import dev.dominion.ecs.api.Dominion;
import dev.dominion.ecs.api.Entity;

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

/**
 * Creates entities with two components, all six {@code float} of them set, then deletes all of them
 * in order of creation. The world lives on, so its tables have their size after the first round.
 * Artemis-odb defers both to its {@code process}, which is part of the measurement.
 */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(
        value = 1,
        jvmArgsAppend = {"--add-modules=jdk.incubator.vector", "-Xms4g", "-Xmx4g"})
public class EcsCreateDelete {

    /** The number of entities, for all engines. */
    @State(Scope.Thread)
    public static class Size {
        /** Number of entities. */
        @Param("100000")
        public int entities;
    }

    /** A world of Cairn. */
    @State(Scope.Thread)
    public static class Cairn {
        final World world = World.builder().workers(1).build();
        long[] made = {};

        /**
         * Makes room for the handles.
         *
         * @param size the number of entities
         */
        @Setup
        public void fill(Size size) {
            made = new long[size.entities];
        }

        /** Ends the world. */
        @TearDown
        public void close() {
            world.close();
        }
    }

    /** A world of Dominion. */
    @State(Scope.Thread)
    public static class DominionWorld {
        final Dominion world = Dominion.create();
        Entity[] made = {};

        /**
         * Makes room for the handles.
         *
         * @param size the number of entities
         */
        @Setup
        public void fill(Size size) {
            made = new Entity[size.entities];
        }

        /** Ends the world. */
        @TearDown
        public void close() {
            world.close();
        }
    }

    /** A world of Artemis-odb, with the one subscription that any system over them would make. */
    @State(Scope.Thread)
    public static class ArtemisWorld {
        final com.artemis.World world =
                new com.artemis.World(new WorldConfigurationBuilder().build());
        final ComponentMapper<ArtemisPosition> positions = world.getMapper(ArtemisPosition.class);
        final ComponentMapper<ArtemisVelocity> velocities = world.getMapper(ArtemisVelocity.class);
        int[] made = {};

        /**
         * Makes room for the handles.
         *
         * @param size the number of entities
         */
        @Setup
        @SuppressWarnings("unchecked") // a generic array of Artemis
        public void fill(Size size) {
            made = new int[size.entities];
            world.getAspectSubscriptionManager()
                    .get(Aspect.all(ArtemisPosition.class, ArtemisVelocity.class));
        }

        /** Ends the world. */
        @TearDown
        public void close() {
            world.dispose();
        }
    }

    /**
     * Cairn, immediate.
     *
     * @param state the world
     * @return the number of entities left
     */
    @Benchmark
    public int cairn(Cairn state) {
        World world = state.world;
        long[] made = state.made;
        for (int i = 0; i < made.length; i++) {
            made[i] = world.spawn(new Position(i, i, i), new Velocity(1, 2, 3));
        }
        for (long entity : made) {
            world.delete(entity);
        }
        return world.entityCount();
    }

    /**
     * Dominion, immediate.
     *
     * @param state the world
     * @return the world
     */
    @Benchmark
    public Object dominion(DominionWorld state) {
        Dominion world = state.world;
        Entity[] made = state.made;
        for (int i = 0; i < made.length; i++) {
            made[i] =
                    world.createEntity(new MutablePosition(i, i, i), new MutableVelocity(1, 2, 3));
        }
        for (Entity entity : made) {
            world.deleteEntity(entity);
        }
        return world;
    }

    /**
     * Artemis-odb, deferred.
     *
     * @param state the world
     * @return the world
     */
    @Benchmark
    public Object artemis(ArtemisWorld state) {
        com.artemis.World world = state.world;
        int[] made = state.made;
        for (int i = 0; i < made.length; i++) {
            int entity = world.create();
            ArtemisPosition position = state.positions.create(entity);
            position.x = i;
            position.y = i;
            position.z = i;
            ArtemisVelocity velocity = state.velocities.create(entity);
            velocity.x = 1;
            velocity.y = 2;
            velocity.z = 3;
            made[i] = entity;
        }
        world.process();
        for (int entity : made) {
            world.delete(entity);
        }
        world.process();
        return world;
    }
}
