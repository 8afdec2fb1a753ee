package dev.cairn.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.HashSet;
import java.util.Set;

class ConveyorTest {
    private static Collider belt(double speed) {
        return Collider.of(Box.ofHalfExtents(40, .5, 2)).at(0, -.5, 0).surfaceVelocity(speed, 0, 0);
    }

    private static void step(PhysicsWorld world, int ticks) {
        for (int i = 0; i < ticks; i++) {
            world.step(Scenes.STEP);
        }
        world.validate();
    }

    /** Coulomb: it is dragged with mu g, and so reaches u after u/(mu g), u²/(2 mu g) behind. */
    @ParameterizedTest
    @ValueSource(doubles = {.5, 1, 3})
    void aBoxReachesTheSpeedOfTheBelt(double speed) {
        for (int boxes = 1; boxes <= 3; boxes++) {
            try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
                world.add(Body.fixed().collider(belt(speed)));
                BodyRef box =
                        world.add(
                                Body.dynamic().shape(Box.ofHalfExtents(.4, .2, .4)).at(-9, .2, 0));
                for (int i = 1; i < boxes; i++) {
                    world.add(
                            Body.dynamic()
                                    .shape(Box.ofHalfExtents(.3, .2, .3))
                                    .at(-9, .2 + .4 * i, 0));
                }
                step(world, 840);
                assertEquals(speed, box.velocity().x, 1e-9, boxes + " boxes");
                assertEquals(0, box.velocity().z, 1e-9);
                assertEquals(.2, box.position().y, 2e-3);
                if (boxes == 1) {
                    double lag = speed * speed / (2 * .6 * 9.81);
                    assertEquals(-9 + speed * 14 - lag, box.position().x, .02 * speed);
                }
            }
        }
    }

    /** A solid ball that is dragged from rest rolls at last at 2/7 of the belt's speed. */
    @Test
    void aBallRollsOnIt() {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            world.add(Body.fixed().collider(belt(2)));
            BodyRef ball = world.add(Body.dynamic().shape(Sphere.of(.25)).at(0, .25, 0));
            step(world, 240);
            assertEquals(2 * 2 / 7., ball.velocity().x, 1e-3);
            // what touches goes with the belt
            double touching = ball.velocity().x + ball.angularVelocity().z * .25;
            assertEquals(2, touching, 1e-6);
        }
    }

    /** A belt drags and pushes nothing away: at its end face it does nothing along the normal. */
    @Test
    void itsEndPushesNothing() {
        try (PhysicsWorld world = Scenes.awake().gravity(0, 0, 0).workers(1).build()) {
            world.add(Body.fixed().collider(belt(5)));
            BodyRef box =
                    world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(.4)).at(40.4, -.5, 0));
            step(world, 120);
            assertEquals(0, box.velocity().length(), 1e-9);
        }
    }

    @Test
    void aTurnedBeltRunsAlongItself() {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            world.add(Body.fixed().collider(belt(1)).rotation(new Quaterniond().rotateY(.5)));
            BodyRef box =
                    world.add(Body.dynamic().shape(Box.ofHalfExtents(.4, .2, .4)).at(0, .2, 0));
            step(world, 600);
            Vector3d along = new Vector3d(1, 0, 0).rotateY(.5);
            assertEquals(0, box.velocity().sub(along).length(), 1e-9);
        }
    }

    /** A belt on a cart that moves: what lies on it goes with the sum of the two. */
    @ParameterizedTest
    @ValueSource(doubles = {-.75, 0, .5})
    void aBeltOnAMovingCartAddsItsSpeed(double cartSpeed) {
        Vector3d along = new Vector3d(1.25, 0, 0).rotateY(.5).add(cartSpeed, 0, .25);
        Set<Long> digests = new HashSet<>();
        for (int lanes : new int[] {1, 4, 8}) {
            for (boolean target : new boolean[] {false, true}) {
                try (PhysicsWorld world =
                        Scenes.awake()
                                .settings(
                                        PhysicsSettings.DEFAULT
                                                .withSleeping(false)
                                                .withLanes(lanes))
                                .workers(1 + lanes / 4)
                                .build()) {
                    Quaterniond turn = new Quaterniond().rotateY(.5);
                    BodyRef cart =
                            world.add(
                                    Body.kinematic()
                                            .collider(belt(1.25))
                                            .rotation(turn)
                                            .velocity(cartSpeed, 0, .25));
                    BodyRef box =
                            world.add(
                                    Body.dynamic()
                                            .shape(Box.ofHalfExtents(.4, .2, .4))
                                            .at(0, .2, 0));
                    for (int tick = 1; tick <= 600; tick++) {
                        if (target) {
                            double t = tick * Scenes.STEP;
                            cart.moveTo(cartSpeed * t, 0, .25 * t, turn);
                        }
                        world.step(Scenes.STEP);
                    }
                    assertEquals(0, box.velocity().sub(along).length(), 1e-9, "lanes " + lanes);
                    assertEquals(10 * cartSpeed, cart.position().x, 1e-9, "it drives nobody");
                    if (!target) {
                        digests.add(world.digest());
                    }
                }
            }
        }
        assertEquals(1, digests.size());
    }

    @Test
    void aBeltThatStartsWakesWhoIsOnIt() {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            BodyRef line = world.add(Body.fixed().collider(belt(0)));
            BodyRef box =
                    world.add(Body.dynamic().shape(Box.ofHalfExtents(.4, .2, .4)).at(0, .2, 0));
            step(world, 120);
            assertTrue(box.isAsleep());
            line.colliders().get(0).replace(belt(1));
            step(world, 600);
            assertFalse(box.isAsleep());
            assertEquals(1, box.velocity().x, 1e-9);
            line.colliders().get(0).replace(belt(0));
            step(world, 200);
            assertEquals(0, box.velocity().x, 1e-6);
        }
    }

    @Test
    void theSameBitsForWorkersAndLanes() {
        Set<Long> digests = new HashSet<>();
        for (int workers = 1; workers <= 2; workers++) {
            for (int lanes : new int[] {1, 4, 8}) {
                try (PhysicsWorld world =
                        Scenes.awake()
                                .settings(
                                        PhysicsSettings.DEFAULT
                                                .withSleeping(false)
                                                .withLanes(lanes))
                                .workers(workers)
                                .build()) {
                    world.add(Body.fixed().collider(belt(2)));
                    for (int i = 0; i < 60; i++) {
                        Shape shape = i % 3 == 0 ? Sphere.of(.3) : Box.ofHalfExtents(.3, .2, .4);
                        world.add(
                                Body.dynamic()
                                        .shape(shape)
                                        .at(.5 * (i % 12) - 3, .4 + .7 * (i / 12), .2 * (i % 5)));
                    }
                    step(world, 180);
                    digests.add(world.digest());
                }
            }
        }
        assertEquals(1, digests.size());
    }
}
