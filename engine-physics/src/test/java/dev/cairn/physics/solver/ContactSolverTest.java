package dev.cairn.physics.solver;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.job.Jobs;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.tuning.Tunable;
import dev.cairn.physics.tuning.Tuning;

import org.junit.jupiter.api.Test;

import java.lang.management.ManagementFactory;
import java.util.Random;

/**
 * Truths of resting and sliding contact: catalogue B1, B14, C2, C3, C4, C6, C12, E1; symmetry,
 * determinism, allocation.
 */
class ContactSolverTest {
    private static final double DEGREE = Math.PI / 180;

    /** A box on a plane through the origin that falls towards -x; returns {scene, box}. */
    private static SolverScene slope(double degrees, double mu) {
        SolverScene s = new SolverScene();
        double nx = -StrictMath.sin(degrees * DEGREE);
        double ny = StrictMath.cos(degrees * DEGREE);
        int plane = s.fixed();
        int box = s.box(1, 0.5, 0.5, 0.5, 0.5 * nx, 0.5 * ny, 0);
        s.orient(box, 0, 0, 1, degrees * DEGREE);
        s.boxOnPlane(plane, box, nx, ny, 0, 0, mu, 0);
        return s;
    }

    private static double along(SolverScene s, double degrees) {
        return -s.bodies.positionX[1] * StrictMath.cos(degrees * DEGREE)
                - s.bodies.positionY[1] * StrictMath.sin(degrees * DEGREE);
    }

    @Test
    void aBoxSlidesByTheClosedForm() {
        SolverScene s = slope(20, 0.2);
        s.run(2);
        double a = 9.81 * (StrictMath.sin(20 * DEGREE) - 0.2 * StrictMath.cos(20 * DEGREE));
        assertEquals(1, along(s, 20) / (2 * a), 1e-6, "distance over its closed form");
    }

    @Test
    void aBoxThatFrictionHoldsStaysWhereItIs() {
        SolverScene s = slope(20, 0.5);
        s.run(5);
        double settled = along(s, 20);
        s.run(55);
        assertEquals(settled, along(s, 20), 1e-6);
        assertEquals(0, along(s, 20), 1e-4);
        assertTrue(s.deepest() < 1e-6, "penetration " + s.deepest());
    }

    @Test
    void aBoxStopsAfterItsDistanceInAnyDirection() {
        for (double mu : new double[] {0.1, 0.5}) {
            for (int heading = 0; heading < 90; heading += 15) {
                SolverScene s = new SolverScene();
                int plane = s.fixed();
                int box = s.box(1, 0.5, 0.05, 0.5, 0, 0.05, 0);
                s.boxOnPlane(plane, box, 0, 1, 0, 0, mu, 0);
                s.run(1);
                double x = StrictMath.cos(heading * DEGREE);
                double z = StrictMath.sin(heading * DEGREE);
                double x0 = s.bodies.positionX[box];
                double z0 = s.bodies.positionZ[box];
                s.velocity(box, 2 * x, 0, 2 * z);
                s.run(3);
                double dx = s.bodies.positionX[box] - x0;
                double dz = s.bodies.positionZ[box] - z0;
                double truth = 4 / (2 * mu * 9.81);
                assertEquals(
                        truth, dx * x + dz * z, 2e-3 * truth, "mu " + mu + ", heading " + heading);
                assertEquals(0, dx * z - dz * x, 2e-3 * truth, "off the line, heading " + heading);
            }
        }
    }

    @Test
    void aSlidingBallRollsInTheEnd() {
        SolverScene s = new SolverScene();
        int plane = s.fixed();
        int ball = s.sphere(1, 0.1, 0, 0.1, 0);
        s.sphereOnPlane(plane, ball, 0, 1, 0, 0, 0.2, 0);
        s.velocity(ball, 5, 0, 0);
        s.run(1);
        assertEquals(25 / 7.0, s.bodies.velocityX[ball], 1e-9);
        assertEquals(-250 / 7.0, s.bodies.angularVelocityZ[ball], 1e-7);
        double t = 2 * 5 / (7 * 0.2 * 9.81);
        double truth = 5 * t - 0.5 * 0.2 * 9.81 * t * t + 25 / 7.0 * (1 - t);
        assertEquals(truth, s.bodies.positionX[ball], 1e-4);
    }

    @Test
    void aBallRollsDownASlopeByTheClosedForm() {
        SolverScene s = new SolverScene();
        s.gx = -9.81 * StrictMath.sin(20 * DEGREE);
        s.gy = -9.81 * StrictMath.cos(20 * DEGREE);
        int plane = s.fixed();
        int ball = s.sphere(1, 0.1, 0, 0.1, 0);
        s.sphereOnPlane(plane, ball, 0, 1, 0, 0, 0.6, 0);
        s.run(2);
        double truth = 5.0 / 7 * s.gx * 2;
        assertEquals(1, s.bodies.positionX[ball] / truth, 1e-6);
    }

    @Test
    void aBoxAtRestPressesWithItsWeight() {
        for (double mass : new double[] {1e-3, 1, 1e6}) {
            SolverScene s = new SolverScene();
            int plane = s.fixed();
            int box = s.box(mass, 0.5, 0.5, 0.5, 0, 0.5, 0);
            int row = s.boxOnPlane(plane, box, 0, 1, 0, 0, 0.6, 0);
            s.run(30);
            double weight = mass * 9.81 * SolverScene.TICK;
            for (int p = 0; p < 4; p++) {
                assertEquals(
                        weight / 4,
                        s.contacts.totalNormalImpulse[4 * row + p],
                        1e-6 * weight,
                        "point " + p);
            }
            assertEquals(0, s.bodies.velocityY[box], 1e-9);
            assertTrue(s.deepest() < 1e-6, "penetration " + s.deepest());
        }
    }

    private static SolverScene stack(int n, double jitter, Jobs jobs, Tuning settings) {
        SolverScene s = new SolverScene(settings, jobs);
        Random random = new Random(7);
        int below = s.fixed();
        for (int i = 0; i < n; i++) {
            double x = jitter * (random.nextDouble() - 0.5);
            double z = jitter * (random.nextDouble() - 0.5);
            int box = s.box(1, 0.5, 0.5, 0.5, x, i + 0.5, z);
            s.orient(box, 0, 1, 0, 10 * jitter * (random.nextDouble() - 0.5));
            if (i == 0) {
                s.boxOnPlane(below, box, 0, 1, 0, 0, 0.6, 0);
            } else {
                s.boxOnBox(below, box, 0.6, 0);
            }
            below = box;
        }
        return s;
    }

    @Test
    void tenCubesStandForAMinute() {
        try (Jobs jobs = Jobs.of(1)) {
            SolverScene s = stack(10, 0.002, jobs, SolverScene.DOUBLES);
            s.run(10);
            double x = s.bodies.positionX[10];
            double z = s.bodies.positionZ[10];
            s.run(50);
            double creep = Math.hypot(s.bodies.positionX[10] - x, s.bodies.positionZ[10] - z);
            assertTrue(creep < 1e-3, "creep of the top: " + creep);
            assertTrue(s.deepest() < 1e-5, "penetration " + s.deepest());
            assertEquals(9.5, s.bodies.positionY[10], 1e-3);
            for (int level = 0; level < 10; level++) {
                double force = 0;
                for (int p = 0; p < 4; p++) {
                    force += s.contacts.totalNormalImpulse[4 * level + p];
                }
                double weight = (10 - level) * 9.81 * SolverScene.TICK;
                assertEquals(weight, force, 1e-6 * weight, "force at level " + level);
            }
        }
    }

    @Test
    void withoutTheOffsetAStackSagsAsItsSpringsSay() {
        // s = W / (m_eff w²): two cubes meet at a corner with m_eff = 1/8 kg, w = 2 pi 30 Hz; the
        // ground is twice as stiff
        try (Jobs jobs = Jobs.of(1)) {
            SolverScene s = stack(4, 0, jobs, SolverScene.DOUBLES.with(Tunable.OFFSET_GAIN, 0));
            s.run(10);
            double w = 2 * Math.PI * 30;
            double[] overlap = new double[4];
            s.collide();
            for (int level = 1; level < 4; level++) {
                overlap[level] = -s.contacts.separation[4 * level];
                double truth = (4 - level) * 9.81 / 4 / (w * w / 8);
                assertEquals(truth, overlap[level], 0.02 * truth, "level " + level);
            }
        }
    }

    @Test
    void reportedImpulsesAreTheChangeOfMomentum() {
        try (Jobs jobs = Jobs.of(1)) {
            SolverScene s = stack(6, 0.05, jobs, SolverScene.DOUBLES);
            s.velocity(4, 3, 1, -2);
            s.spin(5, 1, -3, 2);
            for (int tick = 0; tick < 240; tick++) {
                BodyStore b = s.bodies;
                double[] before = new double[3 * b.slotCount];
                for (int i = 0; i < b.slotCount; i++) {
                    before[3 * i] = b.velocityX[i];
                    before[3 * i + 1] = b.velocityY[i];
                    before[3 * i + 2] = b.velocityZ[i];
                }
                s.tick(SolverScene.TICK);
                double[] impulse = new double[3 * b.slotCount];
                int row = 0;
                for (int c = 0; c < s.contacts.count; c++) {
                    if (s.contacts.pointCount[c] == 0) {
                        continue;
                    }
                    double normal = 0;
                    for (int p = 0; p < s.contacts.pointCount[c]; p++) {
                        normal += s.contacts.totalNormalImpulse[4 * c + p];
                    }
                    double[] n = {
                        s.contacts.normalX(c), s.contacts.normalY(c), s.contacts.normalZ(c)
                    };
                    for (int k = 0; k < 3; k++) {
                        double j = normal * n[k] + s.solver.totalFriction(row, k);
                        impulse[3 * s.contacts.bodyA[c] + k] -= j;
                        impulse[3 * s.contacts.bodyB[c] + k] += j;
                    }
                    row++;
                }
                for (int i = 1; i < b.slotCount; i++) {
                    double[] after = {b.velocityX[i], b.velocityY[i], b.velocityZ[i]};
                    for (int k = 0; k < 3; k++) {
                        double gravity = k == 1 ? -9.81 * SolverScene.TICK : 0;
                        assertEquals(
                                after[k] - before[3 * i + k] - gravity,
                                impulse[3 * i + k],
                                1e-12,
                                "tick " + tick + ", body " + i + ", axis " + k);
                    }
                }
            }
        }
    }

    @Test
    void contactsWithoutGravityKeepTheTotalMomentum() {
        SolverScene s = new SolverScene();
        s.gy = 0;
        Random random = new Random(11);
        int[] ball = new int[6];
        for (int i = 0; i < 6; i++) {
            ball[i] =
                    s.sphere(
                            1 + i,
                            0.3,
                            i * 0.5,
                            0.1 * random.nextDouble(),
                            0.1 * random.nextDouble());
            s.velocity(ball[i], 2 - i, random.nextDouble(), random.nextDouble());
            s.spin(ball[i], random.nextDouble(), random.nextDouble(), random.nextDouble());
        }
        for (int i = 0; i < 6; i++) {
            for (int j = i + 1; j < 6; j++) {
                s.sphereOnSphere(ball[i], ball[j], 0.5, i % 2 * 0.7);
            }
        }
        double[] before = momentum(s);
        s.run(2);
        assertArrayEquals(before, momentum(s), 1e-13 * 50);
    }

    private static double[] momentum(SolverScene s) {
        double[] p = new double[3];
        for (int i = 0; i < s.bodies.slotCount; i++) {
            p[0] += s.bodies.velocityX[i] / s.bodies.inverseMass[i];
            p[1] += s.bodies.velocityY[i] / s.bodies.inverseMass[i];
            p[2] += s.bodies.velocityZ[i] / s.bodies.inverseMass[i];
        }
        return p;
    }

    @Test
    void aMirroredSceneMovesAsTheMirrorImageToTheBit() {
        SolverScene s = mirrored(1);
        SolverScene t = mirrored(-1);
        for (int k = 0; k < 300; k++) {
            s.tick(SolverScene.TICK);
            t.tick(SolverScene.TICK);
        }
        for (int i = 1; i < s.bodies.slotCount; i++) {
            assertEquals(s.bodies.positionX[i], -t.bodies.positionX[i] + 0.0, "x of " + i);
            assertEquals(s.bodies.positionY[i], t.bodies.positionY[i], "y of " + i);
            assertEquals(s.bodies.velocityZ[i], t.bodies.velocityZ[i], "vz of " + i);
            assertEquals(s.bodies.angularVelocityX[i], t.bodies.angularVelocityX[i], "wx of " + i);
            assertEquals(
                    s.bodies.angularVelocityY[i],
                    -t.bodies.angularVelocityY[i] + 0.0,
                    "wy of " + i);
            assertEquals(s.bodies.orientationZ[i], -t.bodies.orientationZ[i] + 0.0, "qz of " + i);
        }
    }

    private static SolverScene mirrored(int side) {
        SolverScene s = new SolverScene();
        int ground = s.fixed();
        int[] ball = new int[5];
        for (int i = 0; i < 5; i++) {
            ball[i] = s.sphere(1 + 0.1 * i, 0.3, side * (0.13 * i), 0.4 + 0.62 * i, 0.05 * i);
            s.spin(ball[i], 0.5 + i, side * 0.3, side * (1.0 - i));
            s.velocity(ball[i], side * 0.2 * i, 0, 0.1);
            s.sphereOnPlane(ground, ball[i], 0, 1, 0, 0, 0.4, 0.3);
        }
        for (int i = 0; i < 5; i++) {
            for (int j = i + 1; j < 5; j++) {
                s.sphereOnSphere(ball[i], ball[j], 0.4, 0.3);
            }
        }
        return s;
    }

    @Test
    void theNumberOfWorkersDoesNotChangeABit() {
        double[] one = null;
        for (int workers = 1; workers <= 4; workers++) {
            try (Jobs jobs = workers == 1 ? Jobs.of(1) : Jobs.perturbed(workers, 42L + workers)) {
                SolverScene s = stack(40, 0.1, jobs, SolverScene.DOUBLES);
                for (int i = 0; i < 400; i++) {
                    int b = s.box(1, 0.1, 0.2, 0.3, 10 + i, 5, 0);
                    s.spin(b, 1, 2 + i, 3);
                }
                s.run(2);
                double[] state = new double[4 * s.bodies.slotCount];
                for (int i = 0; i < s.bodies.slotCount; i++) {
                    state[4 * i] = s.bodies.positionX[i];
                    state[4 * i + 1] = s.bodies.velocityY[i];
                    state[4 * i + 2] = s.bodies.orientationW[i];
                    state[4 * i + 3] = s.bodies.angularVelocityZ[i];
                }
                if (one == null) {
                    one = state;
                } else {
                    assertArrayEquals(one, state, "workers: " + workers);
                }
            }
        }
    }

    @Test
    void aStepAllocatesNothing() {
        try (Jobs jobs = Jobs.of(1)) {
            // without lanes: other tests in this JVM try several numbers of them, and leave type
            // profiles behind with which vectors are objects
            SolverScene s = stack(10, 0.002, jobs, SolverScene.DOUBLES.with(Tunable.LANES, 1));
            s.spin(s.box(1, 0.1, 0.2, 0.3, 50, 5, 0), 1, 2, 3);
            s.run(1);
            s.collide();
            var threads = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
            long least = Long.MAX_VALUE;
            for (int attempt = 0; attempt < 20; attempt++) {
                long before = threads.getCurrentThreadAllocatedBytes();
                for (int k = 0; k < 10; k++) {
                    s.solver.step(s.bodies, s.contacts, 0, -9.81, 0, SolverScene.TICK, jobs);
                }
                least = Math.min(least, threads.getCurrentThreadAllocatedBytes() - before);
            }
            assertEquals(0, least, "bytes in ten steps");
        }
    }

    @Test
    void settingsTeachTheirBounds() {
        var tooMany =
                assertThrows(
                        IllegalArgumentException.class,
                        () -> SolverScene.DOUBLES.with(Tunable.SUBSTEPS, 65));
        assertTrue(
                tooMany.getMessage().contains("substeps") && tooMany.getMessage().contains("65"));
        assertThrows(
                IllegalArgumentException.class,
                () -> SolverScene.DOUBLES.with(Tunable.OFFSET_GAIN, Double.NaN));
        assertThrows(
                IllegalArgumentException.class,
                () -> SolverScene.DOUBLES.with(Tunable.PUSH_SPEED, -1));
    }
}
