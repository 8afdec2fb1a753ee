package dev.cairn.system;

import dev.cairn.core.ecs.Chunk;
import dev.cairn.core.ecs.ChunkSystem;
import dev.cairn.core.ecs.Query;
import dev.cairn.core.ecs.Tick;
import dev.cairn.core.ecs.World;
import dev.cairn.core.ecs.access.Access;
import dev.cairn.core.ecs.component.Component;
import dev.cairn.core.ecs.component.DoubleField;
import dev.cairn.core.job.BlockJob;
import dev.cairn.core.snapshot.SnapshotExchange;
import dev.cairn.core.state.StateCodecs;
import dev.cairn.core.state.WorldState;
import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.component.Force;
import dev.cairn.physics.component.Velocity;
import dev.cairn.physics.shape.Box;

import java.io.OutputStream;
import java.lang.reflect.Constructor;
import java.lang.reflect.Method;
import java.nio.file.Path;
import java.util.List;

/**
 * What the snippets of a page for users take as given: a class for each page that needs one, by the
 * name of its file. {@code DocsTest} compiles each snippet as a member of it and runs it, in a JVM
 * of its own, by {@link #main}.
 */
public final class SnippetContexts {
    private SnippetContexts() {}

    /** Runs the snippets of the classes that are named, each in a context of its own. */
    public static void main(String[] names) throws Exception {
        for (String name : names) {
            Constructor<?> made = Class.forName(name).getDeclaredConstructor();
            made.setAccessible(true);
            try (AutoCloseable context = (AutoCloseable) made.newInstance()) {
                for (Method method : context.getClass().getDeclaredMethods()) {
                    if (method.getName().equals("snippet")) {
                        method.setAccessible(true);
                        method.invoke(context);
                        System.out.println("ran " + name);
                    }
                }
            }
        }
    }

    /** What most pages speak of. */
    public static class Common implements AutoCloseable {
        protected final PhysicsWorld world =
                PhysicsWorld.builder().gravity(0, -9.81, 0).workers(1).build();
        protected final BodyRef floor =
                world.add(Body.fixed().shape(Box.ofHalfExtents(50, 1, 50)).at(0, -1, 0));
        protected final BodyRef crate = world.add(aBox().at(0, 0.5, 0));

        /** Of one metre. */
        protected static Body aBox() {
            return Body.dynamic().shape(Box.cubeOfEdge(1));
        }

        @Override
        public void close() {
            world.close();
        }
    }

    /** docs/joints.md. */
    public static class Joints extends Common {
        protected final BodyRef frame =
                world.add(Body.fixed().shape(Box.ofHalfExtents(0.1, 1, 0.1)).at(0, 1, 0));
        protected final BodyRef door =
                world.add(Body.dynamic().shape(Box.ofHalfExtents(0.4, 0.9, 0.05)).at(0.6, 1, 0));
    }

    /** docs/levels.md. */
    public static class Levels extends Common {
        protected final double[] vertices = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
        protected final int[] indices = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    }

    /** docs/jobs.md. */
    public static class Jobs extends Common {
        protected final BlockJob integrate = (block, worker) -> {};
        protected final BlockJob collide = (block, worker) -> {};
        protected final int bodies = 1000;
        protected final int pairs = 100;
    }

    /** docs/ecs.md. */
    public static class Ecs implements AutoCloseable {
        /** A body at rest. */
        public record Asleep() {}

        protected static final Component<Asleep> ASLEEP = Component.of(Asleep.class);
        protected static final Component<Force> FORCE = Force.COMPONENT;
        protected static final Component<Velocity> VELOCITY = Velocity.COMPONENT;
        protected static final DoubleField FX = FORCE.doubleField("x");
        protected static final DoubleField VX = VELOCITY.doubleField("vx");
        protected final World world = World.builder().workers(1).build();
        protected final Query windy = world.query(FORCE).exclude(ASLEEP);
        protected final SnapshotExchange exchange = new SnapshotExchange();
        protected final double h = 1.0 / 60;
        protected final StepSystem physics = new StepSystem();
        protected int gusts;

        @Override
        public void close() {
            world.close();
        }

        /** Does nothing. */
        public static class DragSystem implements ChunkSystem {
            @Override
            public void describe(Access access) {}

            @Override
            public void run(Chunk chunk, Tick tick) {}
        }

        /** Does nothing either. */
        public static final class BuoyancySystem extends DragSystem {}

        /** Nor does this one. */
        public static final class StepSystem extends DragSystem {}
    }

    /** docs/state.md. */
    public static class State extends Common {
        /** What a player does. */
        public record Push(double newtonSeconds) {
            /** Nothing. */
            public static final Push NONE = new Push(0);
        }

        /** What is done in a run. */
        public record Act(double newtonSeconds) {}

        /** A component. */
        public record Wind(float x) {}

        /** Another one. */
        public record Animal(String name) {}

        /** How they act. */
        public static final class Game {
            private Game() {}

            /** Of all players. */
            public static void apply(PhysicsWorld world, long tick, List<Push> pushes) {}

            /** Of a run. */
            public static void apply(PhysicsWorld world, Act act) {}
        }

        /** Does nothing. */
        public static final class FarmSystem extends Ecs.DragSystem {}

        protected static final Component<Animal> ANIMAL = Component.of(Animal.class);
        protected final WorldState before = world.save();
        protected final WorldState state = world.save();
        protected final WorldState after = stepped();
        protected final PhysicsWorld otherWorld = world.fork();
        protected final OutputStream out = OutputStream.nullOutputStream();
        protected final StateCodecs codecs = PhysicsWorld.codecs().derived(Act.class);
        protected final Path file = Path.of("run.cairn");
        protected final Push push = new Push(1);
        protected final Push received = new Push(2);
        protected final int own = 0;
        protected final int other = 1;
        protected final long tick = 1;
        protected final long wanted = 1;

        private WorldState stepped() {
            world.step(1.0 / 60);
            return world.save();
        }

        @Override
        public void close() {
            otherWorld.close();
            super.close();
        }

        /** Plays a branch to its end. */
        protected double play(PhysicsWorld fork, int number) {
            return number;
        }
    }
}
