package dev.cairn.system;

import dev.cairn.core.ecs.Chunk;
import dev.cairn.core.ecs.ChunkSystem;
import dev.cairn.core.ecs.Query;
import dev.cairn.core.ecs.Tick;
import dev.cairn.core.ecs.World;
import dev.cairn.core.ecs.WorldSystem;
import dev.cairn.core.ecs.access.Access;
import dev.cairn.core.ecs.component.Component;
import dev.cairn.core.ecs.component.DoubleField;
import dev.cairn.core.job.BlockJob;
import dev.cairn.core.snapshot.SnapshotExchange;
import dev.cairn.core.state.StateCodecs;
import dev.cairn.core.state.WorldState;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.component.Force;
import dev.cairn.physics.component.Velocity;

import java.io.OutputStream;
import java.nio.file.Path;
import java.util.List;

/**
 * What the snippets of a page for users take as given: a class for each page that needs one, by the
 * name of its file. {@code DocsTest} compiles each snippet as a member of it.
 */
@SuppressWarnings("NullAway") // nobody runs the snippets
public final class SnippetContexts {
    private SnippetContexts() {}

    /** What most pages speak of. */
    public static class Common {
        protected PhysicsWorld world;
        protected BodyRef crate;
    }

    /** docs/joints.md. */
    public static class Joints extends Common {
        protected BodyRef frame;
        protected BodyRef door;
    }

    /** docs/levels.md. */
    public static class Levels extends Common {
        protected double[] vertices;
        protected int[] indices;
    }

    /** docs/jobs.md. */
    public static class Jobs extends Common {
        protected BlockJob integrate;
        protected BlockJob collide;
        protected int bodies;
        protected int pairs;
    }

    /** docs/ecs.md. */
    public static class Ecs {
        /** A body at rest. */
        public record Asleep() {}

        protected static final Component<Asleep> ASLEEP = Component.of(Asleep.class);
        protected static final Component<Force> FORCE = Force.COMPONENT;
        protected static final Component<Velocity> VELOCITY = Velocity.COMPONENT;
        protected static final DoubleField FX = FORCE.doubleField("x");
        protected static final DoubleField VX = VELOCITY.doubleField("x");
        protected World world;
        protected Query windy;
        protected SnapshotExchange exchange;
        protected double h;
        protected WorldSystem physics;
        protected int gusts;

        /** Does nothing. */
        public static class DragSystem implements ChunkSystem {
            @Override
            public void describe(Access access) {}

            @Override
            public void run(Chunk chunk, Tick tick) {}
        }

        /** Does nothing either. */
        public static final class BuoyancySystem extends DragSystem {}
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
        protected PhysicsWorld otherWorld;
        protected WorldState state;
        protected WorldState before;
        protected WorldState after;
        protected OutputStream out;
        protected StateCodecs codecs;
        protected Path file;
        protected Push push;
        protected Push received;
        protected int own;
        protected int other;
        protected long tick;
        protected long wanted;

        /** Plays a branch to its end. */
        protected double play(PhysicsWorld fork, int number) {
            return number;
        }
    }
}
