package dev.cairn.physics.joint;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.ecs.Change;
import dev.cairn.core.ecs.Chunk;
import dev.cairn.core.ecs.ChunkSystem;
import dev.cairn.core.ecs.Observer;
import dev.cairn.core.ecs.Tick;
import dev.cairn.core.ecs.WorldSystem;
import dev.cairn.core.ecs.access.Access;
import dev.cairn.core.state.WorldState;
import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.NewBody;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.component.Velocity;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.state.RigidBody;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;

/** Joints that come, change and go by commands of systems, and what is told of them. */
final class JointCommandsTest {
    private static final double STEP = 1 / 60.0;
    private static final double G = 9.81;

    /** Does what is asked of it, once. */
    private static final class Script implements WorldSystem {
        final List<Consumer<Tick>> asked = new ArrayList<>();

        @Override
        public String name() {
            return "script";
        }

        @Override
        public void describe(Access access) {
            access.commands().before(PhysicsWorld.SYSTEM);
        }

        @Override
        public void run(Tick tick) {
            asked.forEach(each -> each.accept(tick));
            asked.clear();
        }
    }

    /** Hangs each hundredth body on the one before it, from blocks that run in parallel. */
    private static final class Hanger implements ChunkSystem {
        boolean works;

        @Override
        public String name() {
            return "hanger";
        }

        @Override
        public void describe(Access access) {
            access.in(RigidBody.COMPONENT, Velocity.COMPONENT).commands();
            access.before(PhysicsWorld.SYSTEM);
        }

        @Override
        public void run(Chunk chunk, Tick tick) {
            for (int row = 1; works && row < chunk.size(); row++) {
                if (row % 100 == 1) {
                    Jointed a = Jointed.of(chunk.entity(row - 1));
                    Jointed b = Jointed.of(chunk.entity(row));
                    tick.commands().spawn(new NewJoint(Joint.rod(a, b)));
                }
            }
        }
    }

    private static Body ball(double x, double y) {
        return Body.dynamic().shape(Sphere.of(0.1)).mass(1).at(x, y, 0);
    }

    private static PhysicsWorld world(Script script) {
        return PhysicsWorld.builder().workers(1).systems(script).build();
    }

    /** A chain whose bodies and joints are spawned in one tick moves as one that was added. */
    @Test
    void aChainOfOneTickMovesAsOneThatWasAdded() {
        Script script = new Script();
        try (PhysicsWorld added = world(new Script());
                PhysicsWorld asked = world(script)) {
            BodyRef last = added.add(Body.fixed().shape(Sphere.of(0.1)).at(0, 5, 0));
            for (int i = 1; i <= 8; i++) {
                BodyRef next = added.add(ball(i, 5));
                added.add(Joint.ball(last, next).at(i - 0.5, 5, 0));
                last = next;
            }
            List<Long> handles = new ArrayList<>();
            script.asked.add(tick -> {
                Body peg = Body.fixed().shape(Sphere.of(0.1)).at(0, 5, 0);
                long before = tick.commands().spawn(new NewBody(peg));
                for (int i = 1; i <= 8; i++) {
                    long next = tick.commands().spawn(new NewBody(ball(i, 5)));
                    Joint joint = Joint.ball(Jointed.of(before), Jointed.of(next));
                    handles.add(tick.commands().spawn(new NewJoint(joint.at(i - 0.5, 5, 0))));
                    before = next;
                }
            });
            asked.step(STEP);
            assertEquals(8, asked.joints().count());
            for (int i = 0; i < 8; i++) {
                long entity = asked.ecs().resolve(handles.get(i));
                JointRef joint = asked.joints().of(entity);
                assertNotNull(joint);
                assertEquals(entity, joint.entity());
                RigidJoint row = asked.ecs().get(entity, RigidJoint.COMPONENT);
                assertEquals(joint.entityA(), row.entityA());
                assertEquals(joint.entityB(), row.entityB());
                assertFalse(asked.ecs().has(entity, NewJoint.COMPONENT));
            }
            for (int tick = 0; tick < 200; tick++) {
                added.step(STEP);
                asked.step(STEP);
            }
            for (int i = 0; i <= 8; i++) {
                Vector3d here = added.bodies().get(i).position(new Vector3d());
                assertEquals(here, asked.bodies().get(i).position(new Vector3d()), "body " + i);
            }
        }
    }

    @Test
    void commandsOfBlocksGiveTheSameBitsForAnyNumberOfWorkers() {
        Set<Long> digests = new HashSet<>();
        for (int workers = 1; workers <= 3; workers++) {
            Hanger hanger = new Hanger();
            try (PhysicsWorld world =
                    PhysicsWorld.builder().workers(workers).systems(hanger).build()) {
                for (int i = 0; i < 3000; i++) {
                    world.add(ball(0.5 * i, 5 + i % 3).velocity(i % 5, 0, i % 7));
                }
                world.step(STEP);
                hanger.works = true;
                world.step(STEP);
                hanger.works = false;
                assertTrue(world.joints().count() >= 30, "" + world.joints().count());
                for (int tick = 0; tick < 20; tick++) {
                    world.step(STEP);
                }
                world.validate();
                digests.add(world.digest());
            }
        }
        assertEquals(1, digests.size());
    }

    /** Cut loose it falls as from rest: g t²/2; observers hear of it, and nobody lost anything. */
    @Test
    void deletingItsEntityCutsAJoint() {
        Script script = new Script();
        List<RigidJoint> told = new ArrayList<>();
        try (PhysicsWorld world = world(script)) {
            world.ecs()
                    .observe(
                            RigidJoint.COMPONENT,
                            new Observer<RigidJoint>() {
                                @Override
                                public void removed(Change<RigidJoint> change) {
                                    told.add(change.value());
                                }
                            });
            BodyRef peg = world.add(Body.fixed().shape(Sphere.of(0.1)).at(0, 5, 0));
            BodyRef ball = world.add(ball(0, 4));
            long entity = world.ecs().spawn(new NewJoint(Joint.rod(peg, ball)));
            world.step(STEP);
            double y = ball.position().y;
            assertEquals(1, world.joints().count());
            JointRef joint = world.joints().of(entity);
            for (int tick = 0; tick < 120; tick++) {
                world.step(STEP);
            }
            assertTrue(ball.isAsleep(), "it hangs still");
            script.asked.add(tick -> tick.commands().delete(entity));
            world.step(STEP);
            assertFalse(joint.isAlive());
            assertEquals(0, world.joints().count());
            assertEquals(0, world.joints().lostCount(), "who cut it knows");
            assertEquals(1, told.size());
            assertEquals(ball.entity(), told.get(0).entityB());
            y = ball.position().y;
            for (int tick = 0; tick < 30; tick++) {
                world.step(STEP);
            }
            assertEquals(y - G * 0.25 / 2, ball.position().y, 1e-9);
            assertNull(world.joints().of(entity));
            world.validate();

            // the reference does the same
            long second = world.ecs().spawn(new NewJoint(Joint.rod(peg, ball)));
            world.step(STEP);
            world.joints().of(second).remove();
            assertFalse(world.ecs().isAlive(second));
            assertEquals(2, told.size());
            world.step(STEP);
            assertEquals(0, world.joints().lostCount());
            assertEquals(0, world.joints().count());
        }
    }

    /** By a command, by its reference, and of a joint that is no entity. */
    @Test
    void aJointWhoseBodyGoesIsTold() {
        for (int way = 0; way < 4; way++) {
            Script script = new Script();
            List<RigidJoint> told = new ArrayList<>();
            try (PhysicsWorld world = world(script)) {
                world.ecs()
                        .observe(
                                RigidJoint.COMPONENT,
                                new Observer<RigidJoint>() {
                                    @Override
                                    public void removed(Change<RigidJoint> change) {
                                        told.add(change.value());
                                    }
                                });
                BodyRef a = world.add(ball(0, 5));
                BodyRef b = world.add(ball(1, 5));
                BodyRef c = world.add(ball(2, 5));
                world.ecs().spawn(new NewJoint(Joint.rod(b, c).name("stays")));
                boolean isEntity = way % 2 == 0;
                if (isEntity) {
                    world.ecs().spawn(new NewJoint(Joint.rod(a, b).name("goes")));
                } else {
                    world.add(Joint.rod(a, b).name("goes"));
                }
                world.step(STEP);
                assertEquals(2, world.joints().count());
                int entities = world.ecs().entityCount();
                if (way < 2) {
                    script.asked.add(tick -> tick.commands().delete(a.entity()));
                } else {
                    a.remove();
                }
                assertEquals(0, world.joints().lostCount());
                world.step(STEP);
                assertEquals(1, world.joints().lostCount(), "way " + way);
                JointRef lost = world.joints().lost(0);
                assertEquals("goes", lost.name());
                assertEquals(a.entity(), lost.entityA());
                assertFalse(lost.isAlive());
                assertEquals(isEntity ? 1 : 0, told.size());
                assertEquals(entities - (isEntity ? 2 : 1), world.ecs().entityCount());
                assertEquals(1, world.joints().count());
                world.step(STEP);
                assertEquals(0, world.joints().lostCount(), "once");
                assertEquals("stays", world.joints().all().get(0).name());
                world.validate();
            }
        }
    }

    /** At the worst moment: a body was removed, and nobody was told yet. */
    @Test
    void savedRestoredAndForkedItGoesOnAlike() throws IOException {
        Script script = new Script();
        try (PhysicsWorld world = world(script)) {
            BodyRef a = world.add(ball(0, 5));
            BodyRef b = world.add(ball(1, 5));
            BodyRef c = world.add(ball(2, 5));
            world.add(Body.fixed().shape(Box.ofHalfExtents(9, 1, 9)).at(0, -1, 0));
            world.ecs().spawn(new NewJoint(Joint.rod(a, b).name("first")));
            world.ecs().spawn(new NewJoint(Joint.rod(b, c).name("second")));
            world.step(STEP);
            world.add(ball(7, 7));
            a.remove();
            WorldState state = world.save();
            ByteArrayOutputStream bytes = new ByteArrayOutputStream();
            state.writeTo(bytes, PhysicsWorld.codecs());
            try (PhysicsWorld fork = world.fork();
                    PhysicsWorld read = world(new Script())) {
                read.restore(
                        WorldState.read(
                                new ByteArrayInputStream(bytes.toByteArray()),
                                PhysicsWorld.codecs()));
                for (int tick = 0; tick < 30; tick++) {
                    for (PhysicsWorld each : List.of(world, fork, read)) {
                        each.step(STEP);
                        assertEquals(tick == 0 ? 1 : 0, each.joints().lostCount());
                        assertEquals(1, each.joints().count());
                    }
                    assertEquals(world.digest(), fork.digest());
                    assertEquals(world.digest(), read.digest());
                    if (tick == 0) {
                        assertEquals("first", read.joints().lost(0).name());
                        WorldState told = world.save();
                        world.step(STEP);
                        assertEquals(0, world.joints().lostCount());
                        world.restore(told);
                        assertEquals("first", world.joints().lost(0).name(), "events come back");
                        JointRef second = world.joints().all().get(0);
                        assertSame(second, world.joints().of(second.entity()));
                    }
                }
            }
        }
    }

    @Test
    void changesAreMadeInOrderAndOfWhatIsGoneForgotten() {
        Script script = new Script();
        try (PhysicsWorld world = world(script)) {
            BodyRef peg = world.add(Body.fixed().shape(Sphere.of(0.1)).at(0, 5, 0));
            BodyRef ball = world.add(ball(1, 5));
            long entity = world.ecs().spawn(new NewJoint(Joint.hinge(peg, ball).at(0, 5, 0)));
            world.step(STEP);
            script.asked.add(tick -> {
                tick.commands().spawn(new JointChange(entity, j -> j.motor(JointAxis.TWIST, 9, 9)));
                tick.commands()
                        .spawn(
                                new JointChange(
                                        entity,
                                        j -> {
                                            double then = j.settings(JointAxis.TWIST).speed();
                                            j.motor(JointAxis.TWIST, then - 7, 1e9);
                                        }));
            });
            world.step(STEP);
            world.step(STEP);
            assertEquals(2, ball.angularVelocity().length(), 1e-9, "9 - 7 rad/s");
            script.asked.add(tick -> {
                tick.commands().delete(entity);
                tick.commands().spawn(new JointChange(entity, JointRef::remove));
            });
            world.step(STEP);
            assertEquals(0, world.joints().count());
            script.asked.add(tick ->
                    tick.commands().spawn(new JointChange(ball.entity(), JointRef::remove)));
            IllegalArgumentException refusal =
                    assertThrows(IllegalArgumentException.class, () -> world.step(STEP));
            assertTrue(refusal.getMessage().contains("no joint"), refusal.getMessage());
            assertFalse(world.hasFailed());
            world.step(STEP);
        }
    }

    @Test
    void whatCannotBeIsRefusedOrForgottenAndTheWorldGoesOn() {
        Script script = new Script();
        try (PhysicsWorld world = world(script)) {
            BodyRef a = world.add(ball(0, 5));
            BodyRef b = world.add(ball(1, 5));
            long plain = world.ecs().spawn(new Velocity(0, 0, 0, 0, 0, 0));
            script.asked.add(tick -> {
                tick.commands().delete(a.entity());
                tick.commands().spawn(new NewJoint(Joint.rod(a, b)));
            });
            int entities = world.ecs().entityCount();
            world.step(STEP);
            assertEquals(0, world.joints().count());
            assertEquals(entities - 1, world.ecs().entityCount(), "the joint's entity is gone");

            Joint noBody = Joint.rod(Jointed.of(plain), b);
            assertThrows(IllegalArgumentException.class, () -> world.add(noBody));
            BodyRef c = world.add(ball(3, 5));
            assertTrue(world.add(Joint.rod(Jointed.of(b.entity()), c)).isAlive());
            script.asked.add(tick -> {
                tick.commands().spawn(new NewJoint(Joint.rod(b, b)));
                tick.commands().spawn(new NewJoint(Joint.ball(b, c).at(2, 5, 0)));
            });
            assertThrows(IllegalArgumentException.class, () -> world.step(STEP));
            assertFalse(world.hasFailed());
            world.step(STEP);
            assertEquals(2, world.joints().count(), "what was behind it comes later");
            assertNotEquals(JointRef.NO_ENTITY, world.joints().all().get(1).entity());
            world.validate();
        }
        try (PhysicsWorld world =
                PhysicsWorld.builder().workers(1).settings(PhysicsSettings.DEFAULT).build()) {
            assertNull(world.joints().of(12345));
        }
    }
}
