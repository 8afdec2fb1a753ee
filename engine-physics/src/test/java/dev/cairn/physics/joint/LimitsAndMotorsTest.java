package dev.cairn.physics.joint;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** Limits, motors and springs against what statics and the closed form want. */
final class LimitsAndMotorsTest {
    private static final double STEP = 1 / 60.0;
    private static final double G = 9.81;
    private static final double FOREVER = Double.POSITIVE_INFINITY;

    private static PhysicsWorld world(int substeps) {
        return PhysicsWorld.builder().workers(1).substeps(substeps).sleeping(false).build();
    }

    private static void run(PhysicsWorld world, double seconds) {
        for (int tick = 0; tick < Math.round(seconds / STEP); tick++) {
            world.step(STEP);
        }
    }

    private static BodyRef peg(PhysicsWorld world) {
        return world.add(Body.fixed().shape(Sphere.of(0.05)).at(0, 0, 1));
    }

    /** A level arm of 1 m and 4 kg, whose end is at the origin. */
    private static BodyRef arm(PhysicsWorld world) {
        return world.add(
                Body.dynamic().shape(Box.ofHalfExtents(0.5, 0.05, 0.05)).mass(4).at(0.5, 0, 0));
    }

    /** An arm falls from 0.7 rad above level onto its limit, and bears its weight. */
    @Test
    void hingeLimitsBearWhatStaticsWants() {
        for (double edge : new double[] {0, -0.5}) {
            try (PhysicsWorld world = world(4)) {
                BodyRef arm = arm(world);
                JointRef hinge =
                        world.add(
                                Joint.hinge(peg(world), arm)
                                        .at(0, 0, 0)
                                        .axis(0, 0, 1)
                                        .limits(edge, 1));
                arm.setAngularVelocity(0, 0, 2);
                for (int tick = 0; tick < 300; tick++) {
                    world.step(STEP);
                    double angle = hinge.value(JointAxis.TWIST);
                    assertTrue(angle > edge - 1e-9 && angle < 1 + 1e-9, "angle " + angle);
                }
                assertEquals(edge, hinge.value(JointAxis.TWIST), 1e-9, "it lies on its limit");
                double expected = 4 * G * 0.5 * StrictMath.cos(edge);
                double torque = hinge.torque(new Vector3d()).z;
                assertEquals(expected, torque, 1e-6 * expected, "torque");
                assertEquals(4 * G, hinge.force(new Vector3d()).y, 1e-6 * 4 * G, "force");
            }
        }
    }

    @Test
    void sliderLimitsBearTheWeight() {
        try (PhysicsWorld world = world(4)) {
            BodyRef box = world.add(Body.dynamic().shape(Box.ofHalfExtents(0.2, 0.2, 0.2)).mass(3));
            JointRef slider =
                    world.add(
                            Joint.slider(peg(world), box)
                                    .at(0, 0, 0)
                                    .axis(0, 1, 0)
                                    .limits(-0.3, 0.1));
            box.setVelocity(0, 3, 0);
            double highest = 0;
            for (int tick = 0; tick < 120; tick++) {
                world.step(STEP);
                double way = slider.value(JointAxis.X);
                highest = Math.max(highest, way);
                assertTrue(way > -0.3 - 1e-9 && way < 0.1 + 1e-9, "way " + way);
            }
            // it falls for at most three of the four sub-steps after it was stopped
            assertEquals(0.1, highest, G * STEP * STEP / 2, "it came to its upper limit");
            assertEquals(3 * G, slider.force(new Vector3d()).y, 1e-6 * 3 * G);
        }
    }

    @Test
    void conesAndTwistsAreKept() {
        try (PhysicsWorld world = world(4)) {
            BodyRef bar =
                    world.add(Body.dynamic().shape(Box.ofHalfExtents(0.05, 0.5, 0.05)).mass(2));
            bar.teleport(0, -0.5, 0);
            JointRef ball =
                    world.add(
                            Joint.ball(peg(world), bar)
                                    .at(0, 0, 0)
                                    .axis(1, 1, 0)
                                    .limits(0, 0.4)
                                    .limits(JointAxis.TWIST, -0.2, 0.3));
            bar.setAngularVelocity(3, 5, 6);
            double cone = 0;
            double least = 0;
            double most = 0;
            for (int tick = 0; tick < 600; tick++) {
                world.step(STEP);
                cone = Math.max(cone, ball.value(JointAxis.CONE));
                double twist = ball.value(JointAxis.TWIST);
                least = Math.min(least, twist);
                most = Math.max(most, twist);
                assertTrue(ball.gap() < 1e-7, "gap " + ball.gap() + " in tick " + tick);
            }
            assertEquals(0.4, cone, 1e-7, "the cone was reached, and not left");
            assertEquals(-0.2, least, 1e-7, "the lower twist was reached, and not left");
            assertEquals(0.3, most, 1e-7, "the upper twist was reached, and not left");
        }
    }

    /** A bar whose rest is outside its cone leans on it. */
    @Test
    void conesBearWhatStaticsWants() {
        try (PhysicsWorld world = world(4)) {
            BodyRef arm = arm(world);
            JointRef ball =
                    world.add(Joint.ball(peg(world), arm).at(0, 0, 0).axis(1, 0, 0).limits(0, 0.4));
            run(world, 8);
            assertEquals(0.4, ball.value(JointAxis.CONE), 1e-9);
            double expected = 4 * G * 0.5 * StrictMath.cos(0.4);
            double torque = ball.torque(new Vector3d()).length();
            assertEquals(expected, torque, 1e-6 * expected);
        }
    }

    /** A fly-wheel gains torque over inertia, then keeps the speed that is wanted. */
    @Test
    void motorsGiveNoMoreThanTheyMay() {
        try (PhysicsWorld world = world(4)) {
            world.setGravity(0, 0, 0);
            BodyRef wheel = world.add(Body.dynamic().shape(Sphere.of(0.5)).mass(10));
            double inertia = 0.4 * 10 * 0.25;
            JointRef hinge =
                    world.add(
                            Joint.hinge(peg(world), wheel)
                                    .at(0, 0, 0)
                                    .axis(0, 0, 1)
                                    .motor(6, 2 * inertia));
            run(world, 2);
            assertEquals(4, wheel.angularVelocity(new Vector3d()).z, 1e-9, "2 rad/s² for 2 s");
            assertEquals(2 * inertia, hinge.torque(new Vector3d()).z, 1e-9);
            run(world, 2);
            assertEquals(6, wheel.angularVelocity(new Vector3d()).z, 1e-9, "the speed wanted");
            assertEquals(0, hinge.torque(new Vector3d()).z, 1e-9);
            hinge.motor(JointAxis.TWIST, -6, 3 * inertia);
            run(world, 1);
            assertEquals(3, wheel.angularVelocity(new Vector3d()).z, 1e-9, "3 rad/s² back");
            hinge.motorOff(JointAxis.TWIST);
            run(world, 1);
            assertEquals(3, wheel.angularVelocity(new Vector3d()).z, 1e-9, "runs on");
        }
    }

    /** A brake that is too weak lets the box sink with the rest of its weight. */
    @Test
    void weakBrakesSlip() {
        try (PhysicsWorld world = world(4)) {
            BodyRef box = world.add(Body.dynamic().shape(Box.ofHalfExtents(0.2, 0.2, 0.2)).mass(3));
            JointRef slider =
                    world.add(
                            Joint.slider(peg(world), box)
                                    .at(0, 0, 0)
                                    .axis(0, 1, 0)
                                    .motor(0, 0.75 * 3 * G));
            run(world, 1);
            assertEquals(-0.25 * G, box.velocity(new Vector3d()).y, 1e-9);
            assertEquals(0.75 * 3 * G, slider.force(new Vector3d()).y, 1e-9);
            slider.motor(JointAxis.X, 0, FOREVER);
            double before = slider.value(JointAxis.X);
            run(world, 1);
            assertEquals(before, slider.value(JointAxis.X), 1e-9, "a strong one holds at once");
        }
    }

    /** {@code x = m g/k} for a motor to a position; between bodies and for a turn. */
    @Test
    void springsYieldByTheWeight() {
        try (PhysicsWorld world = world(4)) {
            BodyRef box = world.add(Body.dynamic().shape(Box.ofHalfExtents(0.2, 0.2, 0.2)).mass(3));
            JointRef slider =
                    world.add(
                            Joint.slider(peg(world), box)
                                    .at(0, 0, 0)
                                    .axis(0, 1, 0)
                                    .spring(0.2, 2, 1));
            run(world, 8);
            double w = 2 * Math.PI * 2;
            assertEquals(0.2 - G / (w * w), slider.value(JointAxis.X), 1e-9);
            slider.target(JointAxis.X, -0.1);
            run(world, 8);
            assertEquals(-0.1 - G / (w * w), slider.value(JointAxis.X), 1e-9);
        }
    }

    /** Two bodies on a spring swing with its frequency, less (w h)²/12 of the midpoint rule. */
    @Test
    void springsKeepTheirFrequency() {
        double[] error = new double[2];
        for (int k = 0; k < 2; k++) {
            try (PhysicsWorld world = world(4 << k)) {
                world.setGravity(0, 0, 0);
                BodyRef one = world.add(Body.dynamic().shape(Sphere.of(0.1)).mass(1));
                BodyRef two = world.add(Body.dynamic().shape(Sphere.of(0.1)).mass(3).at(2, 0, 0));
                world.add(Joint.spring(one, two, 1, 0).length(1.5));
                double largest = 0;
                for (int tick = 0; tick < 615; tick++) {
                    world.step(STEP);
                    largest = Math.max(largest, Math.abs(apart(one, two) - 1.5));
                }
                assertEquals(0.5, largest, 1e-4, "amplitude");
                // 10.25 periods: it goes through its rest, and what phase lacks is seen best
                double x = apart(one, two) - 1.5;
                error[k] = StrictMath.asin(x / 0.5) / (10.25 * 2 * Math.PI);
                double wh = 2 * Math.PI * STEP / (4 << k);
                assertEquals(wh * wh / 12, error[k], 0.02 * wh * wh / 12, "frequency");
            }
        }
        assertEquals(4, error[0] / error[1], 0.1, "of second order");
    }

    private static double apart(BodyRef a, BodyRef b) {
        return a.position(new Vector3d()).distance(b.position(new Vector3d()));
    }

    /** {@code x = exp(-z w t)(cos wd t + z w/wd sin wd t)}, {@code wd = w sqrt(1 - z²)}. */
    @Test
    void springsKeepTheirDampingRatio() {
        for (double z : new double[] {0.05, 0.3, 0.9}) {
            try (PhysicsWorld world = world(4)) {
                world.setGravity(0, 0, 0);
                BodyRef one = world.add(Body.dynamic().shape(Sphere.of(0.1)).mass(1));
                BodyRef two = world.add(Body.dynamic().shape(Sphere.of(0.1)).mass(3).at(2, 0, 0));
                world.add(Joint.spring(one, two, 1, z).length(1.5));
                double w = 2 * Math.PI;
                double wd = w * Math.sqrt(1 - z * z);
                for (int tick = 1; tick <= 240; tick++) {
                    world.step(STEP);
                    double t = tick * STEP;
                    double x =
                            0.5
                                    * StrictMath.exp(-z * w * t)
                                    * (StrictMath.cos(wd * t)
                                            + z * w / wd * StrictMath.sin(wd * t));
                    // (w h)²/12 of the phase, 1.4e-3 rad after four periods
                    assertEquals(1.5 + x, apart(one, two), 0.5 * 1.6e-3, "ratio " + z);
                }
            }
        }
    }

    /** Springs far stiffer than the sub-step can follow neither explode nor gain. */
    @Test
    void stiffSpringsAreStable() {
        for (double hertz : new double[] {60, 1000, 1e5}) {
            for (double ratio : new double[] {0, 1}) {
                try (PhysicsWorld world = world(4)) {
                    BodyRef bob = world.add(Body.dynamic().shape(Sphere.of(0.1)).at(1, 0, 1));
                    world.add(Joint.spring(peg(world), bob, hertz, ratio));
                    double start = world.kineticEnergy() + world.potentialEnergy();
                    for (int tick = 0; tick < 300; tick++) {
                        world.step(STEP);
                        double gain = world.kineticEnergy() + world.potentialEnergy() - start;
                        assertTrue(
                                gain < 0.01 * bob.mass() * G,
                                hertz + " Hz, ratio " + ratio + " gains " + gain);
                    }
                }
            }
        }
    }
}
