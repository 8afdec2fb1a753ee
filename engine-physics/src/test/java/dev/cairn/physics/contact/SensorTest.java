package dev.cairn.physics.contact;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.ColliderRef;
import dev.cairn.physics.ContactListener;
import dev.cairn.physics.Contacts;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.WorldQueries;
import dev.cairn.physics.query.Hit;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.support.Scenes;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.List;

class SensorTest {
    private static Body gate(double halfX, double halfY) {
        return Body.fixed().collider(Collider.of(Box.ofHalfExtents(halfX, halfY, 2)).sensor(true));
    }

    /** Entered and left once each, in the tick in which the ball's surface crosses the gate's. */
    @Test
    void whoGoesThroughEntersAndLeaves() {
        try (PhysicsWorld world = Scenes.awake().gravity(0, 0, 0).workers(1).build()) {
            BodyRef gate = world.add(gate(.5, 2));
            BodyRef ball =
                    world.add(Body.dynamic().shape(Sphere.of(.25)).at(-3, 0, 0).velocity(1, 0, 0));
            int entered = -1;
            int left = -1;
            for (int i = 1; i <= 300; i++) {
                world.step(Scenes.STEP);
                if (world.contacts().entered().count() > 0) {
                    assertEquals(-1, entered);
                    entered = i;
                    assertSame(gate, world.contacts().entered().bodyA(0));
                    assertSame(ball, world.contacts().entered().bodyB(0));
                }
                if (world.contacts().left().count() > 0) {
                    assertEquals(-1, left);
                    left = i;
                }
                assertEquals(0, world.contacts().count());
            }
            assertEquals(Math.ceil(60 * (3 - .75)), entered, 1);
            assertEquals(Math.ceil(60 * (3 + .75)), left, 1);
            assertEquals(1, ball.velocity().x, 0);
        }
    }

    /** At 600 m/s it is through a gate of 2 mm within a tick, wherever in the tick that is. */
    @ParameterizedTest
    @ValueSource(doubles = {20, 60, 200, 600})
    void whoFliesThroughWithinATickIsSeen(double speed) {
        for (int shift = 0; shift < 7; shift++) {
            try (PhysicsWorld world = Scenes.awake().gravity(0, 0, 0).workers(1).build()) {
                world.add(gate(.001, 2));
                double from = -30 - shift / 7. * speed / 60;
                world.add(
                        Body.dynamic().shape(Sphere.of(.02)).at(from, 0, 0).velocity(speed, 0, 0));
                world.add(
                        Body.dynamic().shape(Sphere.of(.02)).at(from, 3, 0).velocity(speed, 0, 0));
                int entered = 0;
                int left = 0;
                for (int i = 0; i * speed < 60 * 60; i++) {
                    world.step(Scenes.STEP);
                    entered += world.contacts().entered().count();
                    left += world.contacts().left().count();
                    world.validate();
                }
                assertEquals(1, entered, "the one that does not pass by, from " + from);
                assertEquals(1, left);
            }
        }
    }

    /** An eye of radius 1 on a kinematic body flies over what stands still, sleeps, and moves. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 6, 300})
    void aSensorOnAKinematicBodySeesAllKinds(double speed) {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(90, .5, 90)).at(0, -3.6, 0));
            Body cube = Body.fixed().shape(Box.cubeOfHalfExtent(.5));
            world.add(cube.at(4, 0, 0).name("fixed"));
            world.add(Body.kinematic().shape(Box.cubeOfHalfExtent(.5)).at(8, 0, 0).name("moved"));
            Body heap = Body.dynamic().shape(Box.ofHalfExtents(.5, 1.6, .5)).at(12, -1.5, 0);
            BodyRef sleeper = world.add(heap.name("asleep"));
            for (int i = 0; i < 120; i++) {
                world.step(Scenes.STEP);
            }
            assertTrue(sleeper.isAsleep());
            Collider eye = Collider.of(Sphere.of(1)).sensor(true);
            BodyRef flier = world.add(Body.kinematic().collider(eye).velocity(speed, 0, 0));
            List<String> seen = new ArrayList<>();
            List<Double> where = new ArrayList<>();
            world.contacts()
                    .listen(
                            new ContactListener() {
                                @Override
                                public void entered(ColliderRef sensor, ColliderRef visitor) {
                                    seen.add("in " + visitor.body().name());
                                    where.add(flier.position().x);
                                }

                                @Override
                                public void left(ColliderRef sensor, ColliderRef visitor) {
                                    seen.add("out " + visitor.body().name());
                                    where.add(flier.position().x);
                                }
                            });
            for (int i = 0; i < Math.round(16 / speed / Scenes.STEP) + 1; i++) {
                world.step(Scenes.STEP);
                world.validate();
            }
            assertEquals(6, seen.size(), seen.toString());
            for (int k = 0; k < 3; k++) {
                String name = List.of("fixed", "moved", "asleep").get(k);
                double in = where.get(seen.indexOf("in " + name));
                double out = where.get(seen.indexOf("out " + name));
                assertEquals(4 * (k + 1) - 1.5, in, 2.1 * speed * Scenes.STEP, name);
                assertEquals(4 * (k + 1) + 1.5, out, 2.1 * speed * Scenes.STEP, name);
            }
            assertTrue(sleeper.isAsleep(), "it wakes nobody");
        }
    }

    @Test
    void aSensorSeesAllKindsAndTellsAlsoOfRemoval() {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(9, .5, 9)).at(0, -.5, 0));
            BodyRef sleeper =
                    world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(.5)).at(2, .5, 0));
            BodyRef pole = world.add(Body.fixed().shape(Box.ofHalfExtents(.1, 3, .1)).at(-2, 3, 0));
            for (int i = 0; i < 120; i++) {
                world.step(Scenes.STEP);
            }
            assertTrue(sleeper.isAsleep());
            BodyRef zone =
                    world.add(
                            Body.fixed()
                                    .collider(Collider.of(Box.ofHalfExtents(4, 1, 4)).sensor(true))
                                    .at(0, 1.2, 0));
            world.step(Scenes.STEP);
            assertEquals(2, world.contacts().entered().count());
            assertTrue(sleeper.isAsleep(), "it wakes nobody");
            for (int i = 0; i < 60; i++) {
                world.step(Scenes.STEP);
                assertEquals(0, world.contacts().entered().count());
                assertEquals(0, world.contacts().left().count());
            }
            pole.remove();
            world.step(Scenes.STEP);
            assertEquals(1, world.contacts().left().count());
            assertSame(pole, world.contacts().left().bodyB(0));
            zone.teleport(0, 9, 0);
            world.step(Scenes.STEP);
            assertEquals(1, world.contacts().left().count());
            assertSame(sleeper, world.contacts().left().bodyB(0));
            zone.teleport(0, 1.2, 0);
            world.step(Scenes.STEP);
            assertEquals(1, world.contacts().entered().count());
            zone.remove();
            world.step(Scenes.STEP);
            assertEquals(1, world.contacts().left().count());
            world.validate();
        }
    }

    @Test
    void aSensorOnABodyWeighsNothingAndQueriesLookThroughIt() {
        try (PhysicsWorld world = Scenes.awake().gravity(0, 0, 0).workers(1).build()) {
            BodyRef guard =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.cubeOfHalfExtent(.5))
                                    .collider(Collider.of(Sphere.of(4)).sensor(true)));
            assertEquals(1000, guard.mass(), 1e-9);
            BodyRef thief = world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(.5)).at(6, 0, 0));
            world.step(Scenes.STEP);
            assertEquals(0, world.contacts().entered().count());
            guard.setVelocity(6, 0, 0);
            int entered = 0;
            for (int i = 0; i < 40; i++) {
                world.step(Scenes.STEP);
                entered += world.contacts().entered().count();
            }
            assertEquals(1, entered);
            Hit hit = new Hit();
            WorldQueries queries = world.queries();
            assertNull(queries.rayCast(0, -9, 2.5, 0, 1, 0, 8, hit));
            assertSame(guard, queries.withSensors(true).rayCast(4, -9, 2.5, 0, 1, 0, 9, hit));
            assertFalse(thief.colliders().get(0).isSensor());
            assertThrows(
                    IllegalArgumentException.class, () -> Collider.of(HalfSpace.of()).sensor(true));
        }
    }

    /** A ball that falls h arrives at sqrt(2 g h); it is stopped by m v (1 + e). */
    @Test
    void aHitTellsSpeedImpulsePointAndNormal() {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            world.contacts().setHitSpeed(1);
            world.add(Body.fixed().shape(Box.ofHalfExtents(5, .5, 5)).at(0, -.5, 0));
            BodyRef ball = world.add(Body.dynamic().shape(Sphere.of(.5)).at(1, 5.5, 2));
            int[] told = new int[2];
            world.contacts()
                    .listen(
                            new ContactListener() {
                                @Override
                                public void hit(Contacts.Hits hits, int hit) {
                                    told[0]++;
                                    double v = Math.sqrt(2 * 9.81 * 5);
                                    assertEquals(v, hits.approachSpeed(hit), .2);
                                    double j = ball.mass() * v;
                                    assertEquals(j, hits.impulse(hit), .03 * j);
                                    Vector3d at = hits.point(hit, new Vector3d());
                                    assertEquals(0, at.distance(1, 0, 2), .1);
                                    Vector3d n = hits.normal(hit, new Vector3d());
                                    double up = hits.bodyB(hit) == ball ? 1 : -1;
                                    assertEquals(up, n.y, 1e-9);
                                }

                                @Override
                                public void began(ColliderRef a, ColliderRef b) {
                                    told[1]++;
                                }
                            });
            for (int i = 0; i < 120; i++) {
                world.step(Scenes.STEP);
            }
            assertEquals(1, told[0]);
            assertEquals(1, told[1]);
            assertEquals(1, ball.contacts().length);
            assertSame(ball, world.contacts().bodyB(ball.contacts()[0]));
        }
    }
}
