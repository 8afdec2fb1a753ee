package dev.cairn.physics.motion;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.tuning.Precision;

import org.joml.Vector3d;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/**
 * Rolling friction, beside Coulomb's law: a torque of up to b N about axes in the contact plane,
 * and of up to 2/3 mu b N about the normal of a point.
 */
class RollingTest {
    private static final double TICK = 1 / 60.0;
    private static final double G = 9.81;
    private static final double RADIUS = 0.1;

    /** Inertia over m R²: ball, cylinder, hoop. */
    private static final double[] INERTIAS = {0.4, 0.5, 1};

    private static PhysicsSettings settings(int substeps, Precision precision) {
        return PhysicsSettings.DEFAULT
                .withSubsteps(substeps)
                .withPrecision(precision)
                .withSleeping(false);
    }

    /** A world whose floor is inclined towards +x. */
    private static PhysicsWorld world(int substeps, Precision precision, double slope) {
        PhysicsWorld world =
                PhysicsWorld.builder()
                        .gravity(G * StrictMath.sin(slope), -G * StrictMath.cos(slope), 0)
                        .workers(1)
                        .settings(settings(substeps, precision))
                        .build();
        world.add(Body.fixed().shape(HalfSpace.of()).material(material(0.6, 0)));
        return world;
    }

    private static Material material(double friction, double arm) {
        return new Material(friction, 0, 1000, arm);
    }

    /** Of 1 kg, rolling along x; of the inertia of a cylinder it is one, on its side. */
    private static BodyRef roller(PhysicsWorld world, double inertia, double arm, double speed) {
        Body body =
                Body.dynamic()
                        .mass(1)
                        .at(0, RADIUS, 0)
                        .velocity(speed, 0, 0)
                        .angularVelocity(0, 0, -speed / RADIUS)
                        .material(material(0.6, arm));
        double i = inertia * RADIUS * RADIUS;
        return world.add(
                inertia == 0.5
                        ? body.shape(Cylinder.of(RADIUS, 0.2))
                                .rotationAbout(1, 0, 0, StrictMath.PI / 2)
                        : body.shape(Sphere.of(RADIUS)).inertia(i, i, i));
    }

    private static void run(PhysicsWorld world, double seconds) {
        for (long n = Math.round(seconds / TICK); n > 0; n--) {
            world.step(TICK);
        }
    }

    /** {@code v = v0 - t (b/R) g/(1 + I/(m R²))}, and then it stays. */
    @Test
    void aRollSlowsDownEvenlyAndEnds() {
        double arm = 0.002;
        for (double inertia : INERTIAS) {
            for (int substeps : new int[] {1, 4, 16}) {
                try (PhysicsWorld world = world(substeps, Precision.DOUBLE, 0)) {
                    BodyRef body = roller(world, inertia, arm, 1);
                    String what = "inertia " + inertia + ", sub-steps " + substeps;
                    double loss = arm / RADIUS * G / (1 + inertia);
                    for (int n = 1; n * TICK < 1 / loss; n++) {
                        world.step(TICK);
                        assertEquals(1 - loss * n * TICK, body.velocity().x, 1e-11, what);
                    }
                    run(world, 0.1);
                    Vector3d end = body.position();
                    assertEquals(1, end.x / (0.5 / loss), 1e-11, what);
                    run(world, 10);
                    assertEquals(end.x, body.position().x, 1e-13, what);
                    assertEquals(0, body.position().z, 1e-11, what);
                }
            }
        }
    }

    /** A disc of radius b: {@code w = w0 - t (2/3) mu b m g / I}, and then it stays. */
    @Test
    void aSpinAboutTheNormalSlowsDownEvenlyAndEnds() {
        double arm = 0.002;
        double loss = 2.0 / 3 * 0.6 * arm * G / (0.4 * RADIUS * RADIUS);
        for (int substeps : new int[] {1, 4, 16}) {
            for (Precision precision : new Precision[] {Precision.DOUBLE, Precision.SINGLE}) {
                try (PhysicsWorld world = world(substeps, precision, 0)) {
                    double exact = precision == Precision.DOUBLE ? 1e-11 : 1e-4;
                    BodyRef ball = roller(world, 0.4, arm, 0);
                    ball.setAngularVelocity(0, 10, 0);
                    for (int n = 1; n * TICK < 10 / loss; n++) {
                        world.step(TICK);
                        double spin = 10 - loss * n * TICK;
                        assertEquals(spin, ball.angularVelocity().y, exact, "tick " + n);
                    }
                    run(world, 0.1);
                    assertEquals(0, ball.angularVelocity().length(), exact, "rest " + precision);
                    assertEquals(0, Math.hypot(ball.position().x, ball.position().z), 1e-12);
                }
            }
        }
    }

    @Test
    void aRollSlowsDownInSinglePrecision() {
        for (double inertia : INERTIAS) {
            try (PhysicsWorld world = world(4, Precision.SINGLE, 0)) {
                BodyRef body = roller(world, inertia, 0.002, 1);
                double loss = 0.02 * G / (1 + inertia);
                run(world, 1 / loss + 0.1);
                assertEquals(1, body.position().x / (0.5 / loss), 1e-5, "inertia " + inertia);
            }
        }
    }

    /** {@code tan a < b/R}: nothing moves; above {@code a = g (sin - b/R cos)/(1 + I/(m R²))}. */
    @Test
    void aRollBeginsWhereTheSlopeIsSteepEnough() {
        for (double inertia : INERTIAS) {
            for (double share : new double[] {0.5, 0.99, 1.01, 2}) {
                double slope = StrictMath.atan(0.1 * share);
                try (PhysicsWorld world = world(4, Precision.DOUBLE, slope)) {
                    BodyRef body = roller(world, inertia, 0.1 * RADIUS, 0);
                    String what = "inertia " + inertia + ", share " + share;
                    run(world, 2);
                    if (share < 1) {
                        Vector3d start = body.position();
                        run(world, 58);
                        assertEquals(0, body.position().x - start.x, 1e-15, what);
                        assertEquals(0, body.position().z - start.z, 1e-15, what);
                    } else {
                        double gain = StrictMath.sin(slope) - 0.1 * StrictMath.cos(slope);
                        double expected = 2 * G * gain / (1 + inertia);
                        assertEquals(1, body.velocity().x / expected, 1e-11, what);
                    }
                }
            }
        }
    }

    /** On a slope with the other sub-steps, or another tick, it holds what it held. */
    @Test
    void aBallAtRestOnASlopeStaysWhenTheStepChanges() {
        try (PhysicsWorld world = world(4, Precision.DOUBLE, StrictMath.atan(0.09))) {
            BodyRef ball = roller(world, 0.4, 0.1 * RADIUS, 0);
            run(world, 2);
            Vector3d start = ball.position();
            world.setSubsteps(8);
            run(world, 1);
            for (int tick = 0; tick < 60; tick++) {
                world.step(TICK / 2);
            }
            world.setSubsteps(2);
            run(world, 1);
            assertEquals(0, ball.position().x - start.x, 1e-9, "m");
        }
    }

    /** Kinetic energy of a ball on a level floor. */
    private static double kinetic(BodyRef ball, double inertia) {
        return 0.5 * ball.mass() * ball.velocity().lengthSquared()
                + 0.5 * inertia * ball.angularVelocity().lengthSquared();
    }

    @Test
    void aBallThatSlipsAndSpinsNeverGainsEnergy() {
        Random random = new Random(7);
        double inertia = 0.4 * RADIUS * RADIUS;
        for (double arm : new double[] {1e-6, 0.003, 0.05, 1e6}) {
            for (int run = 0; run < 12; run++) {
                try (PhysicsWorld world = world(1 << run % 4, Precision.DOUBLE, 0)) {
                    BodyRef ball = roller(world, 0.4, arm, 0);
                    run(world, 0.5);
                    ball.setVelocity(3 * random.nextGaussian(), 0, 3 * random.nextGaussian());
                    ball.setAngularVelocity(
                            60 * random.nextGaussian(),
                            60 * random.nextGaussian(),
                            60 * random.nextGaussian());
                    double start = kinetic(ball, inertia);
                    double energy = start;
                    for (int tick = 0; tick < 300; tick++) {
                        world.step(TICK);
                        double now = kinetic(ball, inertia);
                        assertTrue(
                                now < energy + 1e-12 * start,
                                "arm " + arm + ", tick " + tick + ": " + (now - energy) + " J");
                        energy = now;
                    }
                }
            }
        }
    }

    /** Ten kinds of drops of a box, and where they end, summed up. */
    private static Vector3d boxes(double arm, int substeps) {
        Vector3d sum = new Vector3d();
        double hx = 0.1;
        double hy = 0.2;
        double hz = 0.15;
        for (int run = 0; run < 10; run++) {
            Random random = new Random(run);
            try (PhysicsWorld world = world(substeps, Precision.DOUBLE, 0)) {
                BodyRef box =
                        world.add(
                                Body.dynamic()
                                        .shape(Box.ofHalfExtents(hx, hy, hz))
                                        .mass(3)
                                        .at(0, 0.35, 0)
                                        .rotationAbout(1, 2, 3, run * random.nextDouble())
                                        .velocity(random.nextGaussian(), 0, 0)
                                        .material(material(0.5, arm)));
                double lowest = Double.POSITIVE_INFINITY;
                double start = boxEnergy(box, hx, hy, hz);
                double energy = start;
                for (int tick = 0; tick < 240; tick++) {
                    world.step(TICK);
                    double now = boxEnergy(box, hx, hy, hz);
                    // what landings gain without rolling friction, too, is 0.5 J at one sub-step
                    assertTrue(
                            now - energy < (substeps == 1 ? 1 : 0.05),
                            "arm " + arm + ", run " + run + ": " + (now - energy) + " J");
                    energy = now;
                    lowest = Math.min(lowest, box.position().y);
                }
                assertTrue(energy < start, "energy");
                assertTrue(lowest > 0.09, "a box sank to " + lowest);
                sum.add(box.position());
            }
        }
        return sum;
    }

    private static double boxEnergy(BodyRef box, double hx, double hy, double hz) {
        Vector3d w = box.orientation().transformInverse(box.angularVelocity());
        double m = box.mass();
        double spin =
                w.x * w.x * (hy * hy + hz * hz)
                        + w.y * w.y * (hx * hx + hz * hz)
                        + w.z * w.z * (hx * hx + hy * hy);
        return m * (0.5 * box.velocity().lengthSquared() + spin / 6 + G * box.position().y);
    }

    /** From hardly any to as good as glued: it tips less and less, and nothing explodes. */
    @Test
    void boxesTipAndSettleWithAnyArm() {
        for (int substeps : new int[] {1, 4}) {
            Vector3d none = boxes(0, substeps);
            double off = none.distance(boxes(1e-12, substeps));
            assertTrue(off < 1e-5, "with an arm of 1e-12 m off by " + off);
            for (double arm : new double[] {1e-3, 0.01, 0.1, 1, 1e6}) {
                boxes(arm, substeps);
            }
        }
    }

    /** A face that slides holds its tilt by its normals; only friction stops it. */
    @Test
    void aBoxSlidesAsWithoutAnArm() {
        double[] end = new double[3];
        double[] arms = {0, 1e-4, 0.02};
        for (int n = 0; n < 3; n++) {
            try (PhysicsWorld world = world(4, Precision.DOUBLE, 0)) {
                BodyRef box =
                        world.add(
                                Body.dynamic()
                                        .shape(Box.ofHalfExtents(0.2, 0.05, 0.2))
                                        .at(0, 0.05, 0)
                                        .velocity(3, 0, 0)
                                        .material(material(0.6, arms[n])));
                run(world, 2);
                end[n] = box.position().x;
            }
        }
        assertEquals(end[0], end[1], 1e-9, "m");
        assertEquals(end[0], end[2], 1e-9, "m");
    }

    /** Bound only by friction, a ball with an arm without end slides down a slope like a box. */
    @Test
    void aBallThatCannotRollSlides() {
        double slope = StrictMath.toRadians(50);
        try (PhysicsWorld world = world(4, Precision.DOUBLE, slope)) {
            BodyRef ball = roller(world, 0.4, 1e6, 0);
            run(world, 1);
            double expected = G * (StrictMath.sin(slope) - 0.6 * StrictMath.cos(slope));
            assertEquals(1, ball.velocity().x / expected, 1e-9);
            assertEquals(0, ball.angularVelocity().length(), 1e-9, "rad/s");
        }
        try (PhysicsWorld world = world(4, Precision.DOUBLE, StrictMath.toRadians(25))) {
            BodyRef ball = roller(world, 0.4, 1e6, 0);
            run(world, 1);
            assertEquals(0, ball.position().x, 1e-9, "m");
        }
    }

    /** Momentum and angular momentum about the origin, of balls. */
    private static double[] momenta(List<BodyRef> balls) {
        Vector3d p = new Vector3d();
        Vector3d l = new Vector3d();
        for (BodyRef ball : balls) {
            Vector3d v = ball.velocity().mul(ball.mass());
            p.add(v);
            l.add(ball.position().cross(v));
            l.fma(0.4 * ball.mass() * RADIUS * RADIUS, ball.angularVelocity());
        }
        return new double[] {p.x, p.y, p.z, l.x, l.y, l.z};
    }

    /**
     * Balls that fly together and press, spinning, until they part: what one gets another loses.
     */
    @Test
    void momentaStay() {
        for (double arm : new double[] {0.003, 0.05, 1e6}) {
            Random random = new Random(3);
            try (PhysicsWorld world =
                    PhysicsWorld.builder()
                            .gravity(0, 0, 0)
                            .workers(1)
                            .settings(settings(4, Precision.DOUBLE))
                            .build()) {
                List<BodyRef> balls = new ArrayList<>();
                for (int i = 0; i < 27; i++) {
                    Vector3d at = new Vector3d(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1).mul(0.25);
                    Vector3d v = new Vector3d(at).mul(-2);
                    balls.add(
                            world.add(
                                    Body.dynamic()
                                            .shape(Sphere.of(RADIUS))
                                            .mass(1 + i % 4)
                                            .at(at.x, at.y, at.z)
                                            .velocity(v.x, v.y, v.z)
                                            .angularVelocity(
                                                    20 * random.nextGaussian(),
                                                    20 * random.nextGaussian(),
                                                    20 * random.nextGaussian())
                                            .material(material(0.5, arm))));
                }
                double[] start = momenta(balls);
                run(world, 2);
                assertArrayEquals(start, momenta(balls), 1e-12, "arm " + arm);
            }
        }
    }

    /** A heap of balls that were let fall; the world is the caller's to close. */
    private static List<BodyRef> heap(PhysicsWorld world, double arm, long seed) {
        world.add(Body.fixed().shape(HalfSpace.of()).material(material(0.5, 0)));
        Random random = new Random(seed);
        List<BodyRef> balls = new ArrayList<>();
        for (int i = 0; i < 200; i++) {
            balls.add(
                    world.add(
                            Body.dynamic()
                                    .shape(Sphere.of(RADIUS))
                                    .at(
                                            0.22 * (i % 4 - 1.5) + 0.02 * random.nextDouble(),
                                            0.15 + 0.23 * (i / 16),
                                            0.22 * (i / 4 % 4 - 1.5) + 0.02 * random.nextDouble())
                                    .material(material(0.5, arm))));
        }
        return balls;
    }

    private static PhysicsWorld world(int lanes, int workers, Precision precision) {
        return PhysicsWorld.builder()
                .gravity(0, -G, 0)
                .workers(workers)
                .settings(settings(4, precision).withLanes(lanes))
                .build();
    }

    /** Where a spin about the normal is not braked, a ball that spins carries others round. */
    @Tag("compiled")
    @Test
    void heapsComeToRest() {
        for (long seed : new long[] {23, 35, 38}) {
            try (PhysicsWorld world = world(0, 2, Precision.AUTO)) {
                List<BodyRef> balls = heap(world, 0.02, seed);
                run(world, 12);
                double fastest = 0;
                for (BodyRef ball : balls) {
                    fastest = Math.max(fastest, ball.velocity().length());
                }
                assertEquals(0, fastest, 1e-4, "seed " + seed);
            }
        }
    }

    /** Mean height of the balls, at rest. */
    @Test
    void aHeapIsSteeperAndComesToRest() {
        double[] height = new double[3];
        double[] arms = {0, 0.005, 0.02};
        for (int n = 0; n < 3; n++) {
            try (PhysicsWorld world = world(0, 2, Precision.AUTO)) {
                List<BodyRef> balls = heap(world, arms[n], 11);
                run(world, 12);
                double fastest = 0;
                for (BodyRef ball : balls) {
                    height[n] += ball.position().y / balls.size();
                    fastest = Math.max(fastest, ball.velocity().length());
                }
                if (n > 0) {
                    assertTrue(fastest < 1e-4, "moves at " + fastest + " m/s, arm " + arms[n]);
                }
            }
        }
        assertTrue(height[0] < RADIUS + 1e-3, "without it is a carpet: " + height[0]);
        assertTrue(height[1] > height[0] + 0.003, "arm R/20: " + height[1]);
        assertTrue(height[2] > height[0] + 0.03, "arm R/5: " + height[2]);
    }

    @Tag("compiled")
    @Test
    void aHeapHasTheSameBitsForAnyLanesAndWorkers() {
        for (Precision precision : new Precision[] {Precision.DOUBLE, Precision.SINGLE}) {
            long[] reference = null;
            for (int lanes : new int[] {1, 4, 8}) {
                for (int workers : new int[] {1, 3}) {
                    if (lanes == 4 && workers == 1) {
                        continue;
                    }
                    try (PhysicsWorld world = world(lanes, workers, precision)) {
                        heap(world, 0.01, 11);
                        long[] digests = new long[90];
                        for (int tick = 0; tick < digests.length; tick++) {
                            world.step(TICK);
                            digests[tick] = world.digest();
                        }
                        if (reference == null) {
                            reference = digests;
                        }
                        assertArrayEquals(
                                reference, digests, lanes + " lanes, " + workers + " workers");
                    }
                }
            }
        }
    }

    /** It falls asleep where it was held, holds while it sleeps, and again when it was woken. */
    @Test
    void aBallSleepsOnASlope() {
        double slope = StrictMath.atan(0.05);
        try (PhysicsWorld world =
                PhysicsWorld.builder()
                        .gravity(G * StrictMath.sin(slope), -G * StrictMath.cos(slope), 0)
                        .workers(1)
                        .build()) {
            world.add(Body.fixed().shape(HalfSpace.of()).material(material(0.6, 0)));
            BodyRef ball = roller(world, 0.4, 0.1 * RADIUS, 0);
            run(world, 5);
            assertTrue(ball.isAsleep(), "asleep");
            ball.applyImpulse(0.3, 0, 0);
            run(world, 0.1);
            assertTrue(ball.velocity().x > 0.1, "it rolls");
            run(world, 5);
            assertTrue(ball.isAsleep(), "asleep again");
            assertTrue(ball.position().x > 0.02, "it has rolled");
        }
    }
}
