package dev.cairn.benchmarks;

import static dev.cairn.benchmarks.EcsModel.DRAG;
import static dev.cairn.benchmarks.EcsModel.STEP;

import com.artemis.Aspect;
import com.artemis.ComponentMapper;
import com.artemis.WorldConfigurationBuilder;
import com.artemis.systems.IteratingSystem;

import dev.cairn.benchmarks.EcsModel.ArtemisPosition;
import dev.cairn.benchmarks.EcsModel.ArtemisVelocity;
import dev.cairn.benchmarks.EcsModel.MutablePosition;
import dev.cairn.benchmarks.EcsModel.MutableVelocity;
import dev.cairn.benchmarks.EcsModel.Position;
import dev.cairn.benchmarks.EcsModel.Velocity;
import dev.cairn.core.ecs.Chunk;
import dev.cairn.core.ecs.ChunkSystem;
import dev.cairn.core.ecs.Tick;
import dev.cairn.core.ecs.World;
import dev.cairn.core.ecs.access.Access;
import dev.cairn.core.ecs.component.FloatField;
import dev.dominion.ecs.api.Dominion;

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
 * One tick that writes two components of every entity: velocity is damped, position moves by it.
 * Six {@code float} are read and six written per entity, by all engines alike.
 */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(
        value = 1,
        jvmArgsAppend = {"--add-modules=jdk.incubator.vector", "-Xms4g", "-Xmx4g"})
public class EcsIterate {

    /** How Cairn's system declares what it writes. */
    public enum Writing {
        /** Next state beside the published one, which is read: every row is written. */
        BESIDE,
        /** As {@code BESIDE}, with the published values copied first, for partial writers. */
        BESIDE_COPIED,
        /** Next state over the published one, as the rivals do. */
        IN_PLACE
    }

    /** Moves the rows of a chunk. */
    private record Motion(Writing writing) implements ChunkSystem {
        @Override
        public void describe(Access access) {
            switch (writing) {
                case BESIDE -> access.writesAll(EcsModel.POSITION, EcsModel.VELOCITY);
                case BESIDE_COPIED -> access.out(EcsModel.POSITION, EcsModel.VELOCITY);
                case IN_PLACE -> access.inPlace(EcsModel.POSITION, EcsModel.VELOCITY);
            }
        }

        @Override
        public String name() {
            return "Motion";
        }

        @Override
        public void run(Chunk chunk, Tick tick) {
            int rows = chunk.size();
            advance(chunk, rows, EcsModel.PX, EcsModel.VX);
            advance(chunk, rows, EcsModel.PY, EcsModel.VY);
            advance(chunk, rows, EcsModel.PZ, EcsModel.VZ);
        }

        private static void advance(Chunk chunk, int rows, FloatField p, FloatField v) {
            EcsModel.advance(rows, chunk.in(p), chunk.in(v), chunk.out(p), chunk.out(v));
        }
    }

    /** A world of Cairn. */
    @State(Scope.Thread)
    public static class Cairn {
        /** Number of entities. */
        @Param({"10000", "1000000"})
        public int entities;

        /** Number of workers; 1 is the figure to compare with the others. */
        @Param({"1", "2"})
        public int workers;

        /** How the system writes. */
        @Param({"BESIDE", "BESIDE_COPIED", "IN_PLACE"})
        public Writing writing = Writing.BESIDE;

        World world = World.builder().build();

        /** Fills the world. */
        @Setup
        public void fill() {
            world.close();
            world = World.builder().systems(new Motion(writing)).workers(workers).build();
            for (int i = 0; i < entities; i++) {
                world.spawn(new Position(i, i, i), new Velocity(1, 2, 3));
            }
        }

        /** Ends the world. */
        @TearDown
        public void close() {
            world.close();
        }
    }

    /** No engine: the same loop over one array by field, for what the memory allows. */
    @State(Scope.Thread)
    public static class Arrays {
        /** Number of entities. */
        @Param({"10000", "1000000"})
        public int entities;

        /** {@code BESIDE} or {@code IN_PLACE}. */
        @Param({"BESIDE", "IN_PLACE"})
        public Writing writing = Writing.BESIDE;

        float[][] published = new float[6][];
        float[][] next = new float[6][];

        /** Fills the arrays. */
        @Setup
        public void fill() {
            for (int field = 0; field < 6; field++) {
                published[field] = new float[entities];
                next[field] = writing == Writing.IN_PLACE ? published[field] : new float[entities];
                for (int i = 0; i < entities; i++) {
                    published[field][i] = field < 3 ? i : field - 2;
                }
            }
        }
    }

    /** A world of Dominion. */
    @State(Scope.Thread)
    public static class DominionWorld {
        /** Number of entities. */
        @Param({"10000", "1000000"})
        public int entities;

        Dominion world = Dominion.create();

        /** Fills the world. */
        @Setup
        public void fill() {
            for (int i = 0; i < entities; i++) {
                world.createEntity(new MutablePosition(i, i, i), new MutableVelocity(1, 2, 3));
            }
        }

        /** Ends the world. */
        @TearDown
        public void close() {
            world.close();
        }
    }

    /** Artemis-odb's system of the same work. */
    public static final class ArtemisMotion extends IteratingSystem {
        private ComponentMapper<ArtemisPosition> positions;
        private ComponentMapper<ArtemisVelocity> velocities;

        /** Makes the system. */
        @SuppressWarnings({"NullAway", "unchecked"}) // Artemis injects the mappers
        public ArtemisMotion() {
            super(Aspect.all(ArtemisPosition.class, ArtemisVelocity.class));
        }

        @Override
        protected void process(int entity) {
            ArtemisPosition position = positions.get(entity);
            ArtemisVelocity velocity = velocities.get(entity);
            velocity.x *= DRAG;
            velocity.y *= DRAG;
            velocity.z *= DRAG;
            position.x += velocity.x * STEP;
            position.y += velocity.y * STEP;
            position.z += velocity.z * STEP;
        }
    }

    /** A world of Artemis-odb. */
    @State(Scope.Thread)
    public static class ArtemisWorld {
        /** Number of entities. */
        @Param({"10000", "1000000"})
        public int entities;

        com.artemis.World world =
                new com.artemis.World(
                        new WorldConfigurationBuilder().with(new ArtemisMotion()).build());

        /** Fills the world. */
        @Setup
        public void fill() {
            ComponentMapper<ArtemisPosition> positions = world.getMapper(ArtemisPosition.class);
            ComponentMapper<ArtemisVelocity> velocities = world.getMapper(ArtemisVelocity.class);
            for (int i = 0; i < entities; i++) {
                int entity = world.create();
                ArtemisPosition position = positions.create(entity);
                position.x = i;
                position.y = i;
                position.z = i;
                ArtemisVelocity velocity = velocities.create(entity);
                velocity.x = 1;
                velocity.y = 2;
                velocity.z = 3;
            }
            world.process();
        }

        /** Ends the world. */
        @TearDown
        public void close() {
            world.dispose();
        }
    }

    /**
     * One whole tick of Cairn.
     *
     * @param state the world
     * @return the tick's number
     */
    @Benchmark
    public long cairn(Cairn state) {
        state.world.step(STEP);
        return state.world.tickNumber();
    }

    /**
     * One pass over plain arrays.
     *
     * @param state the arrays
     * @return the arrays written
     */
    @Benchmark
    public Object arrays(Arrays state) {
        float[][] from = state.published;
        float[][] to = state.next;
        for (int axis = 0; axis < 3; axis++) {
            EcsModel.advance(state.entities, from[axis], from[axis + 3], to[axis], to[axis + 3]);
        }
        state.published = to;
        state.next = from;
        return to;
    }

    /**
     * One pass of Dominion.
     *
     * @param state the world
     * @return the world
     */
    @Benchmark
    public Object dominion(DominionWorld state) {
        for (var row : state.world.findEntitiesWith(MutablePosition.class, MutableVelocity.class)) {
            MutablePosition position = row.comp1();
            MutableVelocity velocity = row.comp2();
            velocity.x *= DRAG;
            velocity.y *= DRAG;
            velocity.z *= DRAG;
            position.x += velocity.x * STEP;
            position.y += velocity.y * STEP;
            position.z += velocity.z * STEP;
        }
        return state.world;
    }

    /**
     * One process call of Artemis-odb.
     *
     * @param state the world
     * @return the world
     */
    @Benchmark
    public Object artemis(ArtemisWorld state) {
        state.world.process();
        return state.world;
    }
}
