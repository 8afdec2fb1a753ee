package dev.cairn.physics.joint;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.state.WorldState;
import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.body.Kinetics;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.HashSet;
import java.util.Set;

/** Beads on wires, against closed forms. */
final class PathJointTest {
    private static final double STEP = 1 / 60.0;
    private static final double G = 9.81;

    private static PhysicsWorld world(int workers) {
        return PhysicsWorld.builder().workers(workers).sleeping(false).build();
    }

    private static BodyRef peg(PhysicsWorld world) {
        return world.add(
                Body.fixed().shape(Sphere.of(0.05)).at(3, 5, -2).rotationAbout(1, 2, 3, 0.7));
    }

    private static BodyRef bead(PhysicsWorld world, double x, double y, double z) {
        return world.add(Body.dynamic().shape(Sphere.of(0.1)).mass(2).at(x, y, z));
    }

    /** A circle about (0, 2, 0) in the plane of x and y. */
    private static double[] circle(int points, double radius) {
        double[] p = new double[3 * points];
        for (int i = 0; i < points; i++) {
            double angle = 2 * Math.PI * i / points;
            p[3 * i] = radius * StrictMath.sin(angle);
            p[3 * i + 1] = 2 - radius * StrictMath.cos(angle);
        }
        return p;
    }

    /** A bead on a straight wire: s = g t² sin(a)/2, as on a slider; the wire bears m g cos(a). */
    @Test
    void aStraightWireIsASlider() {
        double sin = 0.6;
        double cos = 0.8;
        try (PhysicsWorld world = world(1);
                PhysicsWorld sliding = world(1)) {
            BodyRef bead = bead(world, 0, 9, 0);
            JointRef joint = world.add(Joint.path(peg(world), bead, false, 0, 9, 0, 80, 9 - 60, 0));
            assertEquals(0, joint.value(JointAxis.PATH), 1e-15);
            BodyRef other = bead(sliding, 0, 9, 0);
            sliding.add(Joint.slider(peg(sliding), other).at(0, 9, 0).axis(cos, -sin, 0));
            for (int tick = 1; tick <= 180; tick++) {
                world.step(STEP);
                sliding.step(STEP);
                double way = 0.5 * G * sin * tick * tick * STEP * STEP;
                assertEquals(way, joint.value(JointAxis.PATH), 1e-11 * (1 + way));
                assertEquals(0, bead.position().distance(other.position()), 1e-10);
                assertEquals(2 * G * cos, joint.force(new Vector3d()).length(), 1e-9);
            }
            assertEquals(0, joint.gap(), 1e-12);
        }
    }

    /** On a circle it is a pendulum: the period is 2 pi sqrt(R/g)/agm(1, cos(a/2)). */
    @Test
    void aCircleIsAPendulum() {
        for (double degrees : new double[] {10, 90, 170}) {
            double radius = 1.5;
            double amplitude = Math.toRadians(degrees);
            double a = 1;
            double b = StrictMath.cos(amplitude / 2);
            for (int k = 0; k < 10; k++) {
                double mean = 0.5 * (a + b);
                b = Math.sqrt(a * b);
                a = mean;
            }
            double period = 2 * Math.PI * Math.sqrt(radius / G) / a;
            try (PhysicsWorld world = world(1)) {
                BodyRef bead =
                        bead(
                                world,
                                radius * StrictMath.sin(amplitude),
                                2 - radius * StrictMath.cos(amplitude),
                                0);
                world.add(Joint.path(peg(world), bead, true, circle(128, radius)));
                double energy = world.kineticEnergy() + world.potentialEnergy();
                double first = 0;
                double last = 0;
                int crossings = 0;
                double x = 1;
                double v = 0;
                double lost = 0;
                double off = 0;
                for (int tick = 1; tick <= 1800; tick++) {
                    world.step(STEP);
                    Vector3d p = bead.position();
                    double now = world.kineticEnergy() + world.potentialEnergy();
                    lost = Math.max(lost, Math.abs(now - energy) / (2 * G * radius));
                    off = Math.max(off, Math.abs(p.distance(0, 2, 0) - radius));
                    if (x < 0 && p.x >= 0) {
                        // the root of a cubic through both ends
                        last = (tick - 1) * STEP + root(x, v * STEP, p.x, bead.velocity().x * STEP);
                        first = crossings == 0 ? last : first;
                        crossings++;
                    }
                    x = p.x;
                    v = bead.velocity().x;
                }
                double seen = (last - first) / (crossings - 1);
                String text = degrees + " degrees: period " + (seen / period - 1);
                System.out.println(text + ", height " + lost + ", off " + off / radius);
                assertEquals(1, seen / period, 1e-5, text);
                assertTrue(lost < 1e-5, "height lost " + lost);
                assertTrue(off < 1e-6, "off the circle " + off);
            }
        }
    }

    /** Where the cubic with these values and slopes at 0 and 1 is 0, as a share of the tick. */
    private static double root(double y0, double d0, double y1, double d1) {
        double low = 0;
        double high = 1;
        for (int k = 0; k < 60; k++) {
            double t = 0.5 * (low + high);
            double s = 1 - t;
            double y =
                    s * s * (1 + 2 * t) * y0
                            + t * s * s * d0
                            + t * t * (3 - 2 * t) * y1
                            - t * t * s * d1;
            if (y < 0) {
                low = t;
            } else {
                high = t;
            }
        }
        return low * STEP;
    }

    /** At its lower end a bead rests, and the end bears it: the whole joint m g upwards. */
    @Test
    void endsAreLimits() {
        try (PhysicsWorld world = world(1)) {
            BodyRef bead = bead(world, 0.5, 4, 0);
            JointRef joint =
                    world.add(Joint.path(peg(world), bead, false, 0, 4.5, 0, 1, 3.5, 0, 2, 4, 1));
            double length = joint.settings(JointAxis.PATH).upper();
            joint.limits(JointAxis.PATH, 0.1, 0.9);
            double most = 0;
            for (int tick = 0; tick < 240; tick++) {
                world.step(STEP);
                most = Math.max(most, joint.value(JointAxis.PATH));
            }
            assertEquals(0.9, joint.value(JointAxis.PATH), 1e-9);
            assertEquals(0.9, most, 1e-6);
            Vector3d force = joint.force(new Vector3d());
            assertEquals(0, force.distance(0, 2 * G, 0), 1e-8, "" + force);
            joint.limits(JointAxis.PATH, 0, length);
            joint.motor(JointAxis.PATH, 0.5, 100);
            for (int tick = 0; tick < 400; tick++) {
                world.step(STEP);
            }
            assertEquals(length, joint.value(JointAxis.PATH), 1e-8, "the motor pushes to the end");
            assertEquals(0, bead.position().distance(2, 4, 1), 1e-8, "the last point");
        }
    }

    /** Driven round and round: the way is v t, laps and all, and the ring holds m v²/R. */
    @Test
    void aMotorDrivesItRoundTheRing() {
        try (PhysicsWorld world =
                PhysicsWorld.builder().workers(1).sleeping(false).gravity(0, 0, 0).build()) {
            BodyRef bead = bead(world, 0, 1, 0);
            JointRef joint = world.add(Joint.path(peg(world), bead, true, circle(64, 1)));
            joint.motor(JointAxis.PATH, 3, Double.POSITIVE_INFINITY);
            double lap = 2 * Math.PI;
            world.step(STEP);
            double start = joint.value(JointAxis.PATH);
            for (int tick = 1; tick <= 600; tick++) {
                world.step(STEP);
                assertEquals(start + 3 * tick * STEP, joint.value(JointAxis.PATH), 1e-7);
            }
            assertTrue(joint.value(JointAxis.PATH) > 4 * lap);
            assertEquals(2 * 9, joint.force(new Vector3d()).length(), 0.05);
            assertEquals(3, bead.velocity().length(), 1e-6);
            // with 4 N at most it slows as 4/2 m/s²
            joint.motor(JointAxis.PATH, -3, 4);
            world.step(STEP);
            double v = bead.velocity().length();
            for (int tick = 0; tick < 30; tick++) {
                world.step(STEP);
            }
            assertEquals(v - 2 * 30 * STEP, bead.velocity().length(), 1e-4);
        }
    }

    /** A ring that floats, with its bead: all sums stay. */
    @Test
    void aFreeRingKeepsMomentumAndEnergy() {
        try (PhysicsWorld world =
                PhysicsWorld.builder().workers(1).sleeping(false).gravity(0, 0, 0).build()) {
            BodyRef ring =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.ofHalfExtents(0.3, 0.4, 0.5))
                                    .mass(3)
                                    .at(0, 2, 0)
                                    .angularVelocity(0.3, 0.2, 1.5));
            BodyRef bead = bead(world, 1, 2, 0);
            JointRef joint = world.add(Joint.path(ring, bead, true, circle(96, 1)));
            for (int tick = 0; tick < 10; tick++) {
                world.step(STEP);
            }
            double energy = world.kineticEnergy();
            Kinetics then = world.kinetics();
            double worst = 0;
            for (int tick = 0; tick < 600; tick++) {
                world.step(STEP);
                Kinetics now = world.kinetics();
                worst = Math.max(worst, Math.abs(now.kineticEnergy() / energy - 1));
                assertEquals(then.momentumX(), now.momentumX(), 1e-12);
                assertEquals(then.momentumY(), now.momentumY(), 1e-12);
                assertEquals(then.momentumZ(), now.momentumZ(), 1e-12);
                assertEquals(then.angularMomentumX(), now.angularMomentumX(), 1e-10);
                assertEquals(then.angularMomentumY(), now.angularMomentumY(), 1e-10);
                assertEquals(then.angularMomentumZ(), now.angularMomentumZ(), 1e-10);
            }
            System.out.println("free ring: energy " + worst);
            assertTrue(worst < 1e-5, "energy " + worst);
            assertTrue(Math.abs(joint.value(JointAxis.PATH)) > 1, "it moves along");
        }
    }

    /** Where the wire crosses itself the bead goes straight on: round both loops, then again. */
    @Test
    void itKeepsItsBranchWhereTheWireCrossesItself() {
        int n = 96;
        double[] p = new double[3 * n];
        for (int i = 0; i < n; i++) {
            double angle = 2 * Math.PI * i / n + 0.7;
            p[3 * i] = 2 * StrictMath.sin(angle);
            p[3 * i + 1] = 2 * StrictMath.sin(angle) * StrictMath.cos(angle);
        }
        try (PhysicsWorld world =
                PhysicsWorld.builder().workers(1).sleeping(false).gravity(0, 0, 0).build()) {
            BodyRef bead = bead(world, p[0], p[1], 0);
            JointRef joint = world.add(Joint.path(peg(world), bead, true, p));
            joint.motor(JointAxis.PATH, 4, Double.POSITIVE_INFINITY);
            int right = 0;
            int left = 0;
            for (int tick = 0; tick < 600; tick++) {
                double before = bead.position().x;
                world.step(STEP);
                double now = bead.position().x;
                right += before < 0 && now >= 0 ? 1 : 0;
                left += before >= 0 && now < 0 ? 1 : 0;
                assertTrue(joint.gap() < 1e-9, "gap " + joint.gap());
            }
            // 40 m along loops whose two halves are 6.1 m each
            assertEquals(3, right, 1.0);
            assertEquals(3, left, 1.0);
        }
    }

    @Test
    void theSameBitsForWorkersAndAfterRestoring() throws IOException {
        Set<Long> digests = new HashSet<>();
        for (int workers = 1; workers <= 3; workers++) {
            try (PhysicsWorld world = world(workers)) {
                BodyRef peg = peg(world);
                world.add(Body.fixed().shape(Box.ofHalfExtents(9, 1, 9)).at(0, -1, 0));
                BodyRef last = null;
                for (int i = 0; i < 12; i++) {
                    BodyRef bead = bead(world, 1.2 * StrictMath.sin(i), 2, 0.3 * i);
                    double[] ring = circle(16, 1.2);
                    for (int k = 2; k < ring.length; k += 3) {
                        ring[k] = 0.3 * i + 0.1 * Math.sin(k);
                    }
                    world.add(Joint.path(peg, bead, i % 2 == 0, ring).at(0, 0.8, 0.3 * i));
                    if (last != null && i % 3 != 0) {
                        world.add(Joint.rope(last, bead).length(1.5));
                    }
                    last = bead;
                }
                for (int tick = 0; tick < 60; tick++) {
                    world.step(STEP);
                }
                for (JointRef joint : world.joints().all()) {
                    joint.gap(); // asking changes nothing
                    joint.anchorA(new Vector3d());
                }
                ByteArrayOutputStream bytes = new ByteArrayOutputStream();
                world.save().writeTo(bytes, PhysicsWorld.codecs());
                try (PhysicsWorld fork = world.fork();
                        PhysicsWorld read = world(1)) {
                    read.restore(
                            WorldState.read(
                                    new ByteArrayInputStream(bytes.toByteArray()),
                                    PhysicsWorld.codecs()));
                    for (int tick = 0; tick < 40; tick++) {
                        world.step(STEP);
                        fork.step(STEP);
                        read.step(STEP);
                        assertEquals(world.digest(), fork.digest(), "tick " + tick);
                        assertEquals(world.digest(), read.digest(), "tick " + tick);
                    }
                }
                digests.add(world.digest());
            }
        }
        assertEquals(1, digests.size());
    }

    @Test
    void mistakesAreTold() {
        try (PhysicsWorld world = world(1)) {
            BodyRef peg = peg(world);
            BodyRef bead = bead(world, 0, 0, 0);
            double[][] wrong = {{}, {1, 2, 3}, {1, 2, 3, 4}, {0, 0, 0, 0, 0, 0}};
            for (double[] points : wrong) {
                assertThrows(
                        IllegalArgumentException.class, () -> Joint.path(peg, bead, false, points));
            }
            assertThrows(
                    IllegalArgumentException.class,
                    () -> Joint.path(peg, bead, true, 0, 0, 0, 1, 0, 0));
            assertThrows(
                    IllegalArgumentException.class,
                    () -> Joint.path(peg, bead, true, 0, 0, 0, 1, 0, Double.NaN, 3, 3, 3));
            Joint hinge = Joint.hinge(peg, bead).at(0, 0, 0);
            IllegalArgumentException refusal =
                    assertThrows(
                            IllegalArgumentException.class,
                            () -> hinge.limits(JointAxis.PATH, 0, 1));
            assertTrue(refusal.getMessage().contains("hinge"), refusal.getMessage());
            assertFalse(hinge.settings(JointAxis.PATH).isLimited());
            JointRef made = world.add(hinge);
            assertThrows(IllegalArgumentException.class, () -> made.value(JointAxis.PATH));
            assertThrows(IllegalArgumentException.class, () -> made.motor(JointAxis.PATH, 1, 1));
        }
    }
}
