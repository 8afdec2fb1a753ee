package dev.cairn.physics.body;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.Random;

/** Gravity scale, damping, locks and limits of speed against closed forms. */
class MotionLimitsTest {
    private static final double TICK = 1.0 / 60;
    private static final double G = 9.81;
    private static final long SEED = 20261122;

    private static PhysicsWorld world(double gravity) {
        return PhysicsWorld.builder().gravity(0, -gravity, 0).sleeping(false).build();
    }

    private static void run(PhysicsWorld world, int ticks) {
        for (int tick = 0; tick < ticks; tick++) {
            world.step(TICK);
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {-1, 0, 0.165, 1, 3})
    void gravityScaleIsAFactorOnTheParabola(double scale) {
        try (PhysicsWorld world = world(G)) {
            BodyRef ball =
                    world.add(Body.dynamic().shape(Sphere.of(0.5)).gravityScale(scale).at(0, 5, 0));
            run(world, 90);
            assertEquals(5 - 0.5 * scale * G * 1.5 * 1.5, ball.position().y, 1e-11);
            assertEquals(-scale * G * 1.5, ball.velocity().y, 1e-12);
        }
    }

    @Test
    void aBodyWithHalfTheGravityPressesWithHalfItsWeight() {
        try (PhysicsWorld world = world(G)) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(5, 1, 5)).at(0, -1, 0));
            BodyRef cube =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.cubeOfHalfExtent(0.5))
                                    .mass(2)
                                    .gravityScale(0.5)
                                    .at(0, 0.5, 0));
            run(world, 120);
            for (int tick = 0; tick < 30; tick++) {
                cube.applyForce(0, 0.5 * 2 * G + 1, 0);
                world.step(TICK);
            }
            // 1 N more than its weight lifts 2 kg at 0.5 m/s²
            assertEquals(0.25, cube.velocity().y, 1e-6);
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-9, 0.1, 2, 50, 1e4, 1e6})
    void aDampedFallIsTheClosedFormWhateverTheTick(double c) {
        for (double tick : new double[] {1.0 / 60, 0.1, 0.5}) {
            try (PhysicsWorld world = world(G)) {
                BodyRef ball =
                        world.add(
                                Body.dynamic()
                                        .shape(Sphere.of(0.5))
                                        .damping(c, 0)
                                        .velocity(4, 3, 0));
                int ticks = (int) Math.round(1 / tick);
                for (int n = 0; n < ticks; n++) {
                    world.step(tick);
                }
                double t = ticks * tick;
                // v' = -g - c v
                double e = StrictMath.exp(-c * t);
                double lost = -StrictMath.expm1(-c * t) / c;
                double x = 4 * lost;
                double y = (3 + G / c) * lost - G / c * t;
                if (c < 1e-6) {
                    y = 3 * t - 0.5 * G * t * t;
                }
                assertEquals(x, ball.position().x, 1e-8 * Math.abs(x) + 1e-13, "x, tick " + tick);
                assertEquals(y, ball.position().y, 2e-8, "y, tick " + tick);
                assertEquals(4 * e, ball.velocity().x, 1e-12 * 4, "vx, tick " + tick);
            }
        }
    }

    @Test
    void aDampedTumbleRunsThroughTheFreeOneSlowerAndSlower() {
        double c = 0.7;
        int ticks = 120;
        double t = ticks * TICK;
        double own = -StrictMath.expm1(-c * t) / c;
        Body body =
                Body.dynamic()
                        .shape(Box.ofHalfExtents(0.05, 0.2, 0.45))
                        .inertia(1, 1.5, 2)
                        .angularVelocity(1, 2, 3);
        try (PhysicsWorld free = world(0);
                PhysicsWorld damped = world(0)) {
            BodyRef truth = free.add(body);
            for (int n = 0; n < ticks; n++) {
                free.step(own / ticks);
            }
            BodyRef slowed = damped.add(body.damping(0, c));
            run(damped, ticks);
            Quaterniond d = truth.orientation().conjugate().mul(slowed.orientation());
            assertEquals(0, 2 * Math.sqrt(d.x * d.x + d.y * d.y + d.z * d.z), 1e-9, "attitude");
            Vector3d expected = truth.angularVelocity().mul(StrictMath.exp(-c * t));
            assertEquals(0, slowed.angularVelocity().distance(expected), 1e-10, "spin");
        }
    }

    @Test
    void dampingActsOnBodiesWithContactsToo() {
        // two balls side by side in flight have a gap's contact, so they take the sub-steps
        try (PhysicsWorld world = world(G)) {
            BodyRef[] balls = new BodyRef[2];
            for (int n = 0; n < 2; n++) {
                balls[n] =
                        world.add(
                                Body.dynamic()
                                        .shape(Sphere.of(0.5))
                                        .damping(2, 3)
                                        .angularVelocity(5, 0, 0)
                                        .velocity(4, 3, 0)
                                        .at(0, 0, 1.005 * n));
            }
            run(world, 60);
            double lost = -StrictMath.expm1(-2) / 2;
            for (BodyRef ball : balls) {
                assertEquals(4 * lost, ball.position().x, 1e-12);
                assertEquals((3 + G / 2) * lost - G / 2, ball.position().y, 1e-12);
                assertEquals(5 * StrictMath.exp(-3), ball.angularVelocity().x, 1e-12);
                double angle = -5 * StrictMath.expm1(-3) / 3;
                assertEquals(StrictMath.sin(0.5 * angle), ball.orientation().x, 1e-12);
            }
        }
    }

    @Test
    void aPlaneWorldStaysInItsPlaneToTheBit() {
        System.out.println("seed " + SEED);
        Random random = new Random(SEED);
        try (PhysicsWorld world = world(G)) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(100, 1, 20)).at(0, -1, 0));
            BodyRef[] all = new BodyRef[30];
            for (int n = 0; n < all.length; n++) {
                all[n] =
                        world.add(
                                Body.dynamic()
                                        .shape(
                                                n % 3 == 0
                                                        ? Sphere.of(0.3)
                                                        : Box.ofHalfExtents(0.3, 0.2, 0.4))
                                        .lock(Lock.MOVE_Z, Lock.TURN_X, Lock.TURN_Y)
                                        .at(random.nextDouble(), 1 + 0.8 * n, 0.01 * (n % 5))
                                        .rotationAbout(0, 0, 1, random.nextDouble()));
            }
            run(world, 240);
            for (int n = 0; n < all.length; n++) {
                assertEquals(0.01 * (n % 5), all[n].position().z, "z of " + n);
                Vector3d w = all[n].angularVelocity();
                assertEquals(0, Math.abs(w.x) + Math.abs(w.y), "turns of " + n);
                // unit quaternions about z: x and y are 0 up to rounding of their products
                Quaterniond q = all[n].orientation();
                assertEquals(0, Math.abs(q.x) + Math.abs(q.y), 1e-15, "attitude of " + n);
                assertTrue(all[n].position().y > 0.15, "above the ground: " + all[n].position());
            }
        }
    }

    @Test
    void aLockedTurnLeavesTheInertiaOfTheOtherAxes() {
        // a tilted box about the world's y axis: w = torque t / I_yy, I_yy = (R I R^T)_yy
        try (PhysicsWorld world = world(0)) {
            BodyRef box =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.ofHalfExtents(0.5, 0.2, 0.1))
                                    .inertia(1, 2, 2.5)
                                    .rotationAbout(1, 0, 0, 0.4)
                                    .lock(Lock.TURN_X, Lock.TURN_Z));
            double sin = StrictMath.sin(0.4);
            double inertia = 2 * (1 - sin * sin) + 2.5 * sin * sin;
            for (int tick = 0; tick < 60; tick++) {
                box.applyTorque(3, 2, 1);
                world.step(TICK);
            }
            assertEquals(2 / inertia, box.angularVelocity().y, 1e-13);
            Quaterniond turned =
                    new Quaterniond()
                            .rotateY(0.5 * 2 / inertia)
                            .mul(new Quaterniond().rotationX(0.4));
            Quaterniond d = turned.conjugate().mul(box.orientation());
            assertEquals(0, Math.sqrt(d.x * d.x + d.y * d.y + d.z * d.z), 1e-13);
        }
    }

    @Test
    void aBodyThatMayNotTurnSlidesWhereItWouldTip() {
        // mu 1 on 40°: a block three times as high as wide tips over; locked, it stays
        double angle = Math.toRadians(40);
        for (boolean locked : new boolean[] {false, true}) {
            try (PhysicsWorld world =
                    PhysicsWorld.builder()
                            .gravity(G * StrictMath.sin(angle), -G * StrictMath.cos(angle), 0)
                            .sleeping(false)
                            .build()) {
                Material rough = new Material(1, 0, 1000);
                world.add(
                        Body.fixed()
                                .shape(Box.ofHalfExtents(20, 1, 20))
                                .at(0, -1, 0)
                                .material(rough));
                Body block =
                        Body.dynamic()
                                .shape(Box.ofHalfExtents(0.1, 0.3, 0.1))
                                .at(0, 0.3, 0)
                                .material(rough);
                if (locked) {
                    block.lock(Lock.TURN_X, Lock.TURN_Y, Lock.TURN_Z);
                }
                BodyRef ref = world.add(block);
                run(world, 120);
                double upright = 1 - 2 * Math.pow(ref.orientation().z, 2);
                if (locked) {
                    assertEquals(1, upright);
                    assertEquals(0, ref.velocity().length(), 1e-9, "held by friction");
                    assertEquals(0, ref.position().x, 1e-3);
                } else {
                    assertTrue(upright < 0.5, "tips over, cosine of its angle " + upright);
                }
            }
        }
    }

    @Test
    void aLiftOnlyMovesUpAndDown() {
        try (PhysicsWorld world = world(G)) {
            BodyRef lift =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.ofHalfExtents(1, 0.1, 1))
                                    .mass(100)
                                    .gravityScale(0)
                                    .lock(
                                            Lock.MOVE_X,
                                            Lock.MOVE_Z,
                                            Lock.TURN_X,
                                            Lock.TURN_Y,
                                            Lock.TURN_Z));
            BodyRef ball = world.add(Body.dynamic().shape(Sphere.of(0.2)).mass(10).at(0.7, 1, 0.3));
            run(world, 240);
            Vector3d p = lift.position();
            assertEquals(0, p.x);
            assertEquals(0, p.z);
            // a weight of 10 kg on 110 kg
            double momentum = 100 * lift.velocity().y + 10 * ball.velocity().y;
            assertEquals(-10 * G * 4, momentum, 1e-9 * 10 * G * 4);
            assertEquals(lift.velocity().y, ball.velocity().y, 1e-3, "the ball rides on it");
        }
    }

    @Test
    void aLimitCutsTheSpeedAndKeepsTheDirection() {
        try (PhysicsWorld world = world(G)) {
            BodyRef ball =
                    world.add(
                            Body.dynamic().shape(Sphere.of(0.5)).speedLimit(5).velocity(30, 40, 0));
            world.step(TICK);
            assertEquals(5, ball.velocity().length(), 1e-12);
            run(world, 600);
            assertEquals(5, ball.velocity().length(), 1e-12);
            assertTrue(ball.velocity().y < -4.9, "falls in the end");
            ball.setSpeedLimit(Double.POSITIVE_INFINITY);
            run(world, 60);
            assertTrue(ball.velocity().length() > 14);
        }
    }

    @Test
    void aLimitHoldsForABodyOnTheGroundToo() {
        try (PhysicsWorld world = world(G)) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(50, 1, 50)).at(0, -1, 0));
            BodyRef cube =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.cubeOfHalfExtent(0.5))
                                    .speedLimit(2)
                                    .at(0, 0.5, 0));
            for (int tick = 0; tick < 120; tick++) {
                cube.applyForce(20 * cube.mass(), 0, 0);
                world.step(TICK);
                assertTrue(cube.velocity().length() <= 2 * (1 + 1e-15), "tick " + tick);
            }
            assertEquals(2, cube.velocity().x, 1e-9, "pulled by more than friction holds");
        }
    }

    @Test
    void settersWakeAndTeach() {
        try (PhysicsWorld world = PhysicsWorld.builder().gravity(0, -G, 0).sleeping(true).build()) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(5, 1, 5)).at(0, -1, 0));
            BodyRef cube = world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)).at(0, 0.5, 0));
            run(world, 120);
            assertTrue(cube.isAsleep());
            cube.setGravityScale(-1);
            run(world, 60);
            assertTrue(cube.position().y > 4, "rises: " + cube.position());
            cube.setLocks(Lock.MOVE_Y);
            double y = cube.position().y;
            run(world, 10);
            assertEquals(y, cube.position().y);
            cube.setLocks();
            cube.setDamping(1e6, 0);
            run(world, 2);
            assertEquals(0, cube.velocity().length(), 1e-4);
            teaches("linear damping is -1.0; it must be from 0", () -> cube.setDamping(-1, 0));
            teaches("gravityScale is NaN", () -> cube.setGravityScale(Double.NaN));
            teaches("speedLimit is 0.0; it must be greater", () -> cube.setSpeedLimit(0));
            teaches("angular damping is NaN", () -> Body.dynamic().damping(0, Double.NaN));
        }
    }

    private static void teaches(String text, Runnable call) {
        String message = assertThrows(IllegalArgumentException.class, call::run).getMessage();
        assertTrue(message.contains(text), message);
    }
}
