package dev.cairn.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.ecs.Change;
import dev.cairn.core.ecs.Chunk;
import dev.cairn.core.ecs.ChunkSystem;
import dev.cairn.core.ecs.Observer;
import dev.cairn.core.ecs.Tick;
import dev.cairn.core.ecs.WorldFailedException;
import dev.cairn.core.ecs.WorldSystem;
import dev.cairn.core.ecs.access.Access;
import dev.cairn.core.ecs.access.SchedulingException;
import dev.cairn.core.ecs.component.Component;
import dev.cairn.core.ecs.component.DoubleField;
import dev.cairn.core.snapshot.Pose;
import dev.cairn.physics.body.BodyType;
import dev.cairn.physics.component.Force;
import dev.cairn.physics.component.Torque;
import dev.cairn.physics.component.Velocity;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.state.RigidBody;

import org.junit.jupiter.api.Test;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;

/** Systems of users and the physics in one schedule. */
class EcsMeetsPhysicsTest {
    private static final double STEP = 1.0 / 60;

    /** F = -k v in parallel, from the velocity of the last tick. */
    private record Drag(double k) implements ChunkSystem {
        private static final DoubleField VX = Velocity.COMPONENT.doubleField("vx");
        private static final DoubleField FX = Force.COMPONENT.doubleField("x");

        @Override
        public String name() {
            return "drag";
        }

        @Override
        public void describe(Access access) {
            access.in(Velocity.COMPONENT).out(Force.COMPONENT);
        }

        @Override
        public void run(Chunk chunk, Tick tick) {
            double[] v = chunk.in(VX);
            double[] f = chunk.out(FX);
            for (int row = 0; row < chunk.size(); row++) {
                f[row] = -k * v[row];
            }
        }
    }

    private record Script(String name, Consumer<Tick> body, String before) implements WorldSystem {
        @Override
        public void describe(Access access) {
            access.commands();
            if (!before.isEmpty()) {
                access.before(before);
            }
        }

        @Override
        public void run(Tick tick) {
            body.accept(tick);
        }
    }

    private record Parallel(Consumer<Tick> body) implements ChunkSystem {
        @Override
        public String name() {
            return "parallel";
        }

        @Override
        public void describe(Access access) {
            access.in(Pose.COMPONENT);
        }

        @Override
        public void run(Chunk chunk, Tick tick) {
            body.accept(tick);
        }
    }

    /** v' = v (1 - k h / m) in each tick. */
    @Test
    void aForceOfAParallelSystemActsInTheSameTick() {
        for (int workers = 1; workers <= 2; workers++) {
            try (PhysicsWorld world =
                    PhysicsWorld.builder()
                            .gravity(0, 0, 0)
                            .workers(workers)
                            .systems(new Drag(3))
                            .build()) {
                List<BodyRef> bodies = new ArrayList<>();
                for (int i = 0; i < 3000; i++) {
                    bodies.add(
                            world.add(
                                    Body.dynamic()
                                            .shape(Sphere.of(0.1))
                                            .mass(2)
                                            .at(i, 0, 0)
                                            .velocity(0, 0, 0)
                                            .with(Force.ZERO)));
                }
                bodies.get(2999).setVelocity(8, 0, 0);
                for (int tick = 0; tick < 60; tick++) {
                    world.step(STEP);
                }
                double expected = 8 * StrictMath.pow(1 - 3 * STEP / 2, 59);
                // the first tick still reads the velocity that the last one published
                assertEquals(expected, bodies.get(2999).velocity().x, 8 * 3 * STEP);
                assertEquals(0, bodies.get(0).velocity().x, 0.0);
            }
        }
    }

    @Test
    void aConstantForceHoldsAgainstGravityAndAnotherOneWakes() {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            BodyRef floating =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.cubeOfHalfExtent(0.5))
                                    .at(0, 5, 0)
                                    .with(new Force(0, 9.81 * 1000, 0)));
            world.add(Body.fixed().shape(HalfSpace.of()).at(0, -2, 0));
            BodyRef lying =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.cubeOfHalfExtent(0.5))
                                    .at(0, -1.5, 0)
                                    .with(Force.ZERO));
            for (int tick = 0; tick < 300; tick++) {
                world.step(STEP);
            }
            assertEquals(5, floating.position().y, 1e-12);
            assertTrue(lying.isAsleep());
            world.ecs().set(lying.entity(), new Force(20000, 0, 0));
            world.step(STEP);
            assertFalse(lying.isAsleep(), "another force wakes");
        }
    }

    @Test
    void torqueTurns() {
        try (PhysicsWorld world = PhysicsWorld.builder().gravity(0, 0, 0).workers(1).build()) {
            BodyRef body =
                    world.add(
                            Body.dynamic()
                                    .shape(Sphere.of(1))
                                    .inertia(2, 2, 2)
                                    .with(new Torque(0, 6, 0)));
            world.step(STEP);
            assertEquals(3 * STEP, body.angularVelocity().y, 1e-15);
        }
    }

    @Test
    void bodiesComeAndGoByCommands() {
        List<Long> handles = new ArrayList<>();
        List<Long> doomed = new ArrayList<>();
        Script spawner =
                new Script(
                        "spawner",
                        tick -> {
                            doomed.forEach(tick.commands()::delete);
                            doomed.clear();
                            Body ball = Body.dynamic().shape(Sphere.of(0.5)).at(0, 10, 0);
                            handles.add(tick.commands().spawn(new NewBody(ball)));
                        },
                        PhysicsWorld.SYSTEM);
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).systems(spawner).build()) {
            world.step(STEP);
            BodyRef ball = world.bodyOf(world.ecs().resolve(handles.get(0)));
            assertNotNull(ball);
            assertEquals(10, ball.position().y, 0.0);
            world.step(STEP);
            assertEquals(10 - 0.5 * 9.81 * STEP * STEP, ball.position().y, 1e-12);
            assertEquals(2, world.bodyCount());
            doomed.add(ball.entity());
            world.step(STEP);
            assertFalse(ball.isAlive());
            assertEquals(2, world.bodyCount());
            world.validate();
        }
    }

    private record Fuse(int shards) {}

    private static final Component<Fuse> FUSE = Component.of(Fuse.class);

    /** What bursts leaves shards: observers hear of bodies, and forks have the same ones. */
    @Test
    void observersHearOfBodiesAndForksTakeThemAlong() {
        Observer<Fuse> burst =
                new Observer<>() {
                    @Override
                    public void removed(Change<Fuse> change) {
                        Pose at = change.world().get(change.entity(), Pose.COMPONENT);
                        for (int i = 0; i < change.value().shards(); i++) {
                            Body shard = Body.dynamic().shape(Sphere.of(0.1));
                            change.commands().spawn(new NewBody(shard.at(at.x(), at.y() + i, 0)));
                        }
                    }
                };
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            world.ecs().observe(FUSE, burst);
            BodyRef bomb =
                    world.add(Body.dynamic().shape(Sphere.of(1)).at(4, 9, 0).with(new Fuse(3)));
            world.step(STEP);
            try (PhysicsWorld fork = world.fork()) {
                for (PhysicsWorld each : List.of(world, fork)) {
                    each.bodyOf(bomb.entity()).remove();
                    each.step(STEP);
                    assertEquals(3, each.bodyCount());
                    each.validate();
                    each.step(STEP);
                }
                assertEquals(world.digest(), fork.digest());
            }
        }
    }

    /** Of blocks that run in parallel; two systems change the same bodies. */
    @Test
    void bodiesChangeByCommandsFromAnySystem() throws IOException {
        Set<Long> digests = new HashSet<>();
        for (int workers = 1; workers <= 2; workers++) {
            List<Long> heavier = new ArrayList<>();
            Material ice = new Material(0.01, 0, 500);
            Weigher weigher = new Weigher();
            Script other =
                    new Script(
                            "other",
                            tick -> {
                                for (long entity : heavier) {
                                    tick.commands()
                                            .spawn(
                                                    new Body.Change(
                                                            entity, b -> b.setMass(b.mass() * 3)));
                                    tick.commands()
                                            .spawn(
                                                    new Body.Change(
                                                            entity, b -> b.setMaterial(ice)));
                                }
                                heavier.clear();
                            },
                            PhysicsWorld.SYSTEM);
            try (PhysicsWorld world =
                    PhysicsWorld.builder().workers(workers).systems(weigher, other).build()) {
                BodyRef ground =
                        world.add(Body.fixed().shape(Box.ofHalfExtents(900, 1, 9)).at(0, -1, 0));
                List<BodyRef> boxes = new ArrayList<>();
                for (int i = 0; i < 600; i++) {
                    boxes.add(
                            world.add(
                                    Body.dynamic()
                                            .shape(Box.cubeOfHalfExtent(0.5))
                                            .mass(1)
                                            .at(i, 0.5, i % 7)));
                }
                world.step(STEP);
                weigher.works = true;
                heavier.add(boxes.get(4).entity());
                heavier.add(boxes.get(599).entity());
                int entities = world.ecs().entityCount();
                world.step(STEP);
                weigher.works = false;
                assertEquals(entities, world.ecs().entityCount(), "who asked is gone");
                for (int i = 0; i < 600; i++) {
                    double mass = i == 4 || i == 599 ? 6 : 2;
                    if (i % 100 != 0) {
                        assertEquals(mass, boxes.get(i).mass(), 0.0, "box " + i);
                    }
                }
                assertEquals(BodyType.FIXED, boxes.get(100).type());
                assertEquals(ice, boxes.get(4).material());
                assertEquals(BodyType.FIXED, ground.type());
                world.step(STEP);
                world.validate();
                ByteArrayOutputStream bytes = new ByteArrayOutputStream();
                world.save().writeTo(bytes, PhysicsWorld.codecs());
                assertTrue(bytes.size() > 0);
                digests.add(world.digest());
            }
        }
        assertEquals(1, digests.size());
    }

    /** Doubles all masses, and fixes each hundredth body. */
    private static final class Weigher implements ChunkSystem {
        boolean works;

        @Override
        public String name() {
            return "weigher";
        }

        @Override
        public void describe(Access access) {
            access.in(RigidBody.COMPONENT, Velocity.COMPONENT).commands().before("other");
        }

        @Override
        public void run(Chunk chunk, Tick tick) {
            for (int row = 0; works && row < chunk.size(); row++) {
                long entity = chunk.entity(row);
                boolean fix = chunk.in(RigidBody.COMPONENT.intField("slot"))[row] % 100 == 1;
                tick.commands()
                        .spawn(
                                new Body.Change(
                                        entity,
                                        fix
                                                ? b -> b.setType(BodyType.FIXED)
                                                : b -> b.setMass(2 * b.mass())));
            }
        }
    }

    @Test
    void aChangeOfWhatIsGoneIsForgottenAndOneOfNoBodyIsRefused() {
        List<Runnable> done = new ArrayList<>();
        List<Consumer<Tick>> asked = new ArrayList<>();
        Script script =
                new Script(
                        "script",
                        tick -> {
                            asked.forEach(each -> each.accept(tick));
                            asked.clear();
                        },
                        PhysicsWorld.SYSTEM);
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).systems(script).build()) {
            BodyRef ball = world.add(Body.dynamic().shape(Sphere.of(0.5)));
            BodyRef stays = world.add(Body.dynamic().shape(Sphere.of(0.5)).at(5, 0, 0));
            long plain = world.ecs().spawn(Pose.at(0, 0, 0));
            asked.add(tick -> {
                tick.commands().delete(ball.entity());
                Body.Change change = new Body.Change(ball.entity(), b -> done.add(b::remove));
                tick.commands().spawn(change);
                tick.commands().spawn(new Body.Change(plain, b -> done.add(b::remove)));
                tick.commands().spawn(new Body.Change(stays.entity(), b -> b.setMass(7)));
            });
            IllegalArgumentException refusal =
                    assertThrows(IllegalArgumentException.class, () -> world.step(STEP));
            assertTrue(refusal.getMessage().contains("no body"), refusal.getMessage());
            assertTrue(done.isEmpty());
            assertFalse(world.hasFailed());
            world.step(STEP);
            assertEquals(7, stays.mass(), 0.0, "what was behind it comes with the next step");
        }
    }

    @Test
    void aPoseThatIsSetIsATeleport() {
        List<Long> movers = new ArrayList<>();
        Script door =
                new Script(
                        "door",
                        tick -> {
                            for (long entity : movers) {
                                tick.commands().set(entity, Pose.at(0, 50, 0));
                            }
                            movers.clear();
                        },
                        PhysicsWorld.SYSTEM);
        try (PhysicsWorld world =
                PhysicsWorld.builder().gravity(0, 0, 0).workers(1).systems(door).build()) {
            BodyRef body =
                    world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)).velocity(1, 0, 0));
            BodyRef wall = world.add(Body.fixed().shape(Box.cubeOfHalfExtent(0.5)).at(9, 0, 0));
            world.step(STEP);
            movers.add(body.entity());
            world.step(STEP);
            assertEquals(50, body.position().y, 0.0);
            world.step(STEP);
            assertEquals(STEP, body.position().x, 1e-15);
            assertEquals(1, world.ecs().get(body.entity(), Pose.COMPONENT).jumps());
            world.ecs().set(wall.entity(), Pose.at(0.5, 51, 0));
            world.step(STEP);
            assertEquals(51, wall.position().y, 0.0);
            world.validate();
            world.ecs().set(body.entity(), new Pose(0, 0, 0, 9, 9, 9, 9, 0));
            Throwable refusal = assertThrows(WorldFailedException.class, () -> world.step(STEP));
            assertTrue(refusal.getMessage().contains("Pose"), refusal.getMessage());
        }
    }

    @Test
    void orderIsAskedForByName() {
        for (String name : List.of("aaa", "zzz")) {
            BodyRef[] body = new BodyRef[1];
            Script push =
                    new Script(name, tick -> body[0].applyForce(1000, 0, 0), PhysicsWorld.SYSTEM);
            try (PhysicsWorld world = PhysicsWorld.builder().workers(1).systems(push).build()) {
                body[0] = world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)));
                world.step(STEP);
                assertEquals(STEP, body[0].velocity().x, 1e-15);
            }
        }
        assertThrows(
                SchedulingException.class,
                () ->
                        PhysicsWorld.builder()
                                .workers(1)
                                .systems(new Script("x", tick -> {}, "nobody"))
                                .build());
    }

    @Test
    void whatWouldRaceIsRefusedWithTheRemedyAndTheWorldGoesOn() {
        BodyRef[] body = new BodyRef[1];
        List<String> told = new ArrayList<>();
        Parallel bad =
                new Parallel(tick -> {
                    try {
                        body[0].applyForce(1, 0, 0);
                    } catch (IllegalStateException refusal) {
                        told.add(refusal.getMessage());
                    }
                });
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).systems(bad).build()) {
            body[0] = world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)));
            world.step(STEP);
            world.step(STEP);
            assertEquals(2, told.size());
            assertTrue(told.get(0).contains("component Force"), told.get(0));
            assertEquals(0, body[0].velocity().x, 0.0);
        }
    }

    @Test
    void queriesLoopInOneLine() {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            for (int i = 0; i < 5; i++) {
                world.add(Body.dynamic().shape(Sphere.of(0.1)).at(i, 0, 0));
            }
            double[] sum = new double[1];
            world.ecs()
                    .query(Pose.COMPONENT)
                    .forEach(e -> sum[0] += world.ecs().get(e, Pose.COMPONENT).x());
            assertEquals(10, sum[0], 0.0);
        }
    }
}
