package dev.cairn.physics.island;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.support.MixedHeap;
import dev.cairn.physics.support.Scenes;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/** Heaps that are still but for a creep sleep, also beside a body that goes on moving. */
@Tag("compiled")
class HeapSleepTest {
    private static final long SEED = 11;
    private static final int HEAPS = 4;

    private static PhysicsWorld world(int workers, int lanes) {
        return PhysicsWorld.builder()
                .workers(workers)
                .settings(PhysicsSettings.DEFAULT.withLanes(lanes))
                .build();
    }

    private static double[] stone(Random random, double size) {
        double[] points = new double[3 * 14];
        for (int i = 0; i < 14; i++) {
            double x = random.nextGaussian();
            double y = random.nextGaussian();
            double z = random.nextGaussian();
            double length = Math.sqrt(x * x + y * y + z * z);
            points[3 * i] = size * x / length;
            points[3 * i + 1] = size * y / length;
            points[3 * i + 2] = size * z / length;
        }
        return points;
    }

    /**
     * A hundred stones in a pit come to rest in some 4 s; they creep for longer than anyone waits.
     */
    @Test
    void stonesInAPitSleep() {
        System.out.println("seed " + SEED);
        long one = stones(1, 1);
        assertEquals(one, stones(2, 8), "the same bits for any workers and lanes");
    }

    private static long stones(int workers, int lanes) {
        Random random = new Random(SEED);
        try (PhysicsWorld world = world(workers, lanes)) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(10, 1, 10)).at(0, -1, 0));
            for (int side = -1; side <= 1; side += 2) {
                world.add(Body.fixed().shape(Box.ofHalfExtents(0.5, 5, 3)).at(2.5 * side, 5, 0));
                world.add(Body.fixed().shape(Box.ofHalfExtents(3, 5, 0.5)).at(0, 5, 2.5 * side));
            }
            List<BodyRef> stones = new ArrayList<>();
            for (int i = 0; i < 100; i++) {
                double size = 0.15 + 0.25 * random.nextDouble();
                stones.add(
                        world.add(
                                Body.dynamic()
                                        .shape(ConvexHull.of(stone(random, size)))
                                        .at(
                                                3 * random.nextDouble() - 1.5,
                                                0.6 + 0.1 * i,
                                                3 * random.nextDouble() - 1.5)));
            }
            Scenes.run(world, 900);
            world.validate();
            assertTrue(Scenes.allAsleep(stones), "asleep after 15 s");
            long digest = world.digest();
            Scenes.run(world, 60);
            assertEquals(digest, world.digest(), "a heap asleep changes nothing");
            return digest;
        }
    }

    /**
     * A ball rolls without slip at 5 mm/s over a plank that carries a stack, too. The plank falls
     * asleep with a tilt of some micrometres a metre, and the ball rolls down that slope.
     */
    @Test
    void whatIsStillSleepsBesideABallThatRolls() {
        try (PhysicsWorld world = world(1, 1)) {
            Scenes.ground(world);
            List<BodyRef> still = new ArrayList<>();
            still.add(
                    world.add(
                            Body.dynamic()
                                    .shape(Box.ofHalfExtents(2, 0.1, 0.5))
                                    .mass(100)
                                    .at(0, 0.1, 0)));
            for (int i = 0; i < 4; i++) {
                still.add(
                        world.add(
                                Body.dynamic()
                                        .shape(Box.cubeOfHalfExtent(0.2))
                                        .at(1.5, 0.4 + 0.4 * i, 0)));
            }
            double speed = 5e-3;
            BodyRef ball =
                    world.add(
                            Body.dynamic()
                                    .shape(Sphere.of(0.2))
                                    .mass(1)
                                    .at(-1, 0.4, 0)
                                    .velocity(speed, 0, 0)
                                    .angularVelocity(0, 0, -speed / 0.2));
            Scenes.run(world, 180);
            double x = ball.position().x;
            double v = ball.velocity().x;
            assertEquals(speed, v, 0.1 * speed, "it has rolled while the stack settled");
            for (int tick = 0; tick < 1020; tick++) {
                assertTrue(Scenes.allAsleep(still), "asleep after 3 s, tick " + tick);
                assertFalse(ball.isAsleep(), "the ball goes on");
                world.step(Scenes.STEP);
            }
            // A ball on a slope without slip: a = 5/7 g sin(tilt)
            double a = -5.0 / 7 * 9.81 * 2 * still.get(0).orientation().z;
            assertEquals(x + v * 17 + 0.5 * a * 17 * 17, ball.position().x, 1e-5);
        }
    }

    /**
     * A plank over a block of 0.6 m, and a ball as heavy as the plank that rolls outwards: they tip
     * when the ball is as far beyond the block's edge as the plank's middle is before it. Asleep,
     * the plank may learn of that half a half-thickness late.
     */
    @Test
    void aPlankTipsUnderABallThatRollsThoughItSleeps() {
        try (PhysicsWorld world = world(1, 1)) {
            Scenes.ground(world);
            world.add(Body.fixed().shape(Box.ofHalfExtents(0.3, 0.5, 0.5)).at(0, 0.5, 0));
            double half = 0.05;
            BodyRef plank =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.ofHalfExtents(1.5, half, 0.3))
                                    .mass(10)
                                    .at(0, 1.05, 0));
            double speed = 0.02;
            BodyRef ball =
                    world.add(
                            Body.dynamic()
                                    .shape(Sphere.of(0.1))
                                    .mass(10)
                                    .at(0.2, 1.2, 0)
                                    .velocity(speed, 0, 0)
                                    .angularVelocity(0, 0, -speed / 0.1));
            boolean slept = false;
            while (ball.position().x < 0.6 - 1e-3) {
                world.step(Scenes.STEP);
                slept |= plank.isAsleep();
                assertEquals(0, plank.orientation().z, 2e-3, "level at " + ball.position().x);
            }
            assertTrue(slept, "the plank slept on the way");
            while (Math.abs(plank.orientation().z) < 0.1) {
                world.step(Scenes.STEP);
                assertTrue(
                        Math.abs(plank.orientation().z) > 5e-3
                                || ball.position().x < 0.6 + half + 0.05,
                        "tips at " + ball.position().x);
            }
        }
    }

    /**
     * What jams between two sleepers is squeezed harder than between two that give way, and balls
     * spin on their places for ever: neither is a reason to wake a heap. From second 15 to 30
     * bodies sleep for four fifths of the time (a fifth before that was so).
     */
    @Test
    void heapsGoOnSleeping() {
        long asleep = 0;
        for (long seed = 1; seed <= HEAPS; seed++) {
            try (PhysicsWorld world = world(1, 1)) {
                List<BodyRef> bodies = MixedHeap.drop(world, seed, 5, 4);
                Scenes.run(world, 900);
                for (int second = 0; second < 15; second++) {
                    Scenes.run(world, 60);
                    asleep += bodies.stream().filter(BodyRef::isAsleep).count();
                }
            }
        }
        assertTrue(asleep > 0.6 * HEAPS * 15 * 100, asleep + " with seeds 1 to " + HEAPS);
    }

    private static final class Stack implements AutoCloseable {
        final PhysicsWorld world = world(1, 1);
        final List<BodyRef> boxes = new ArrayList<>();

        Stack() {
            Scenes.ground(world);
            for (int i = 0; i < 3; i++) {
                boxes.add(
                        world.add(
                                Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)).at(0, 0.5 + i, 0)));
            }
            Scenes.run(world, 180);
            assertTrue(Scenes.allAsleep(boxes));
        }

        void roll(double speed) {
            world.add(
                    Body.dynamic()
                            .shape(Sphere.of(0.5))
                            .mass(300)
                            .at(-1.02, 0.5, 0)
                            .velocity(speed, 0, 0)
                            .angularVelocity(0, 0, -speed / 0.5));
        }

        @Override
        public void close() {
            world.close();
        }
    }

    /** A ball as heavy as a third of a box comes to touch a stack at 2 cm/s: it turns round. */
    @Test
    void aSoftTouchWakesNobody() {
        try (Stack stack = new Stack()) {
            stack.roll(0.02);
            for (int tick = 0; tick < 300; tick++) {
                stack.world.step(Scenes.STEP);
                assertTrue(Scenes.allAsleep(stack.boxes), "tick " + tick);
            }
        }
        try (Stack stack = new Stack()) {
            stack.roll(2);
            Scenes.run(stack.world, 3);
            assertFalse(stack.boxes.get(0).isAsleep(), "a blow wakes");
        }
    }

    /** On ice a soft touch wakes, too: without friction nothing holds the box, and both go on. */
    @Test
    void aSoftTouchOnIceIsFelt() {
        Material ice = new Material(0, 0, 1000);
        double speed = 0.03;
        try (PhysicsWorld world = world(1, 1)) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(9, 1, 9)).at(0, -1, 0).material(ice));
            BodyRef box =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.cubeOfHalfExtent(0.5))
                                    .at(0, 0.5, 0)
                                    .material(ice));
            Scenes.run(world, 180);
            assertTrue(box.isAsleep());
            BodyRef other =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.cubeOfHalfExtent(0.5))
                                    .at(-1.02, 0.5, 0)
                                    .velocity(speed, 0, 0)
                                    .material(ice));
            Scenes.run(world, 90);
            assertEquals(speed / 2, box.velocity().x, 1e-3 * speed);
            assertEquals(speed / 2, other.velocity().x, 1e-3 * speed);
        }
    }

    /**
     * A plank lies on a block of 0.2 m, asleep. A box of a tenth of its weight is put down at its
     * end, softly: 0.1 x 1.4 m beyond the block's edge are more than the plank's own 0.1 m.
     */
    @Test
    void aSmallLoadAtALongLeverWakes() {
        try (PhysicsWorld world = world(1, 1)) {
            Scenes.ground(world);
            world.add(Body.fixed().shape(Box.ofHalfExtents(0.1, 0.5, 0.5)).at(0, 0.5, 0));
            BodyRef plank =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.ofHalfExtents(1.6, 0.05, 0.3))
                                    .mass(100)
                                    .at(0, 1.05, 0));
            Scenes.run(world, 180);
            assertTrue(plank.isAsleep());
            world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.1)).mass(10).at(1.5, 1.2, 0));
            Scenes.run(world, 120);
            assertTrue(Math.abs(plank.orientation().z) > 0.05, "the plank tips");
        }
    }
}
