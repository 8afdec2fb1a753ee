package dev.cairn.physics.joint;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.body.Kinetics;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.Sphere;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** Gears, racks and pulleys: what they tie, and the forces that statics wants. */
final class GearsTest {
    private static final double STEP = 1 / 60.0;
    private static final double G = 9.81;
    private static final double FOREVER = Double.POSITIVE_INFINITY;

    private static PhysicsWorld world() {
        return PhysicsWorld.builder().workers(1).sleeping(false).build();
    }

    private static BodyRef wheel(PhysicsWorld world, double radius, double x) {
        return world.add(
                Body.dynamic()
                        .shape(Cylinder.of(radius, 0.1))
                        .mass(5)
                        .at(x, 0, 0)
                        .rotationAbout(1, 0, 0, Math.PI / 2));
    }

    private static BodyRef housing(PhysicsWorld world) {
        return world.add(Body.fixed().shape(Sphere.of(0.1)).at(0, 0, -3));
    }

    /** {@code 20 a + 50 b} stays 0 for a minute; a load is borne by the motor as teeth have it. */
    @Test
    void gearsKeepTheirRatio() {
        try (PhysicsWorld world = world()) {
            BodyRef base = housing(world);
            BodyRef small = wheel(world, 0.2, 0);
            BodyRef large = wheel(world, 0.5, 0.7);
            JointRef one =
                    world.add(Joint.hinge(base, small).at(0, 0, 0).axis(0, 0, 1).motor(7, FOREVER));
            JointRef two =
                    world.add(Joint.hinge(base, large).at(0.7, 0, 0).axis(0, 0, 1).motor(0, 12));
            JointRef gear =
                    world.add(
                            Joint.gear(small, large, 20, 50)
                                    .anchors(0, 0, 0, 0.7, 0, 0)
                                    .axis(0, 0, 1));
            for (int tick = 1; tick <= 3600; tick++) {
                world.step(STEP);
                double sum = 20 * one.value(JointAxis.TWIST) + 50 * two.value(JointAxis.TWIST);
                assertEquals(0, Math.IEEEremainder(sum, 2 * Math.PI), 1e-9, "tick " + tick);
                double turned = one.value(JointAxis.TWIST) - 7 * tick * STEP;
                assertEquals(0, Math.IEEEremainder(turned, 2 * Math.PI), 1e-9, "the motor");
            }
            assertEquals(-2.8, large.angularVelocity(new Vector3d()).z, 1e-9, "7 x 20/50");
            assertEquals(12 * 0.4, one.torque(new Vector3d()).z, 1e-6, "torque of the motor");
            assertEquals(12 / 0.5, gear.force(new Vector3d()).length(), 1e-6, "force of teeth");
            assertEquals(0, gear.gap(), 1e-12);
        }
    }

    /** A planet between sun and ring on a carrier that floats freely: Willis' equation. */
    @Test
    void planetaryGearsKeepRatioAndAngularMomentum() {
        try (PhysicsWorld world = world()) {
            world.setGravity(0, 0, 0);
            BodyRef carrier =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.ofHalfExtents(0.4, 0.05, 0.05))
                                    .mass(2)
                                    .at(0, 0, 1));
            BodyRef sun = wheel(world, 0.2, 0);
            BodyRef ring = wheel(world, 0.6, 0);
            BodyRef planet = wheel(world, 0.2, 0.4);
            for (BodyRef[] pair :
                    new BodyRef[][] {{carrier, sun}, {carrier, ring}, {carrier, planet}}) {
                double x = pair[1] == planet ? 0.4 : 0;
                world.add(Joint.hinge(pair[0], pair[1]).at(x, 0, 0).axis(0, 0, 1));
            }
            world.collisions().exclude(sun, ring);
            world.add(Joint.gear(sun, planet, 20, 20).anchors(0, 0, 0, 0.4, 0, 0).axis(0, 0, 1));
            world.add(Joint.gear(planet, ring, 20, -60).anchors(0.4, 0, 0, 0, 0, 0).axis(0, 0, 1));
            sun.setAngularVelocity(0, 0, 9);
            world.step(STEP);
            Kinetics before = world.kinetics();
            for (int tick = 0; tick < 600; tick++) {
                world.step(STEP);
                double s = sun.angularVelocity(new Vector3d()).z;
                double r = ring.angularVelocity(new Vector3d()).z;
                double c = carrier.angularVelocity(new Vector3d()).z;
                assertEquals(-3 * (r - c), s - c, 1e-9, "Willis: (s - c)/(r - c) = -60/20");
            }
            Kinetics after = world.kinetics();
            assertEquals(before.angularMomentumZ(), after.angularMomentumZ(), 1e-10);
            assertEquals(before.momentumX(), after.momentumX(), 1e-12);
            assertEquals(before.kineticEnergy(), after.kineticEnergy(), 1e-9, "energy");
            for (JointRef j : world.joints().all()) {
                assertEquals(0, j.gap(), 1e-12, j.toString());
            }
        }
    }

    /** The rack goes r times the angle, one way below the pinion and the other way above. */
    @Test
    void racksFollowTheirPinion() {
        for (double side : new double[] {-0.25, 0.25}) {
            try (PhysicsWorld world = world()) {
                BodyRef base = housing(world);
                BodyRef pinion = wheel(world, 0.2, 0);
                BodyRef rack =
                        world.add(
                                Body.dynamic()
                                        .shape(Box.ofHalfExtents(2, 0.1, 0.1))
                                        .mass(8)
                                        .at(0, side, 1));
                JointRef hinge =
                        world.add(
                                Joint.hinge(base, pinion)
                                        .at(0, 0, 0)
                                        .axis(0, 0, 1)
                                        .motor(-3, FOREVER));
                JointRef slider = world.add(Joint.slider(base, rack).at(0, side, 1).axis(1, 0, 0));
                JointRef teeth =
                        world.add(
                                Joint.rack(pinion, rack)
                                        .anchors(0, 0, 0, 0.3, side, 0)
                                        .axis(0, 0, 1)
                                        .secondAxis(1, 0, 0));
                for (int tick = 1; tick <= 300; tick++) {
                    world.step(STEP);
                    // v = w × r: at (0, side) it is -w side
                    assertEquals(3 * side * tick * STEP, slider.value(JointAxis.X), 1e-9);
                }
                assertTrue(hinge.isAlive());
                assertEquals(0, teeth.gap(), 1e-12);
            }
        }
    }

    /** {@code T = g (1 + k)/(1/m + k²/n)} of a machine of Atwood with a tackle of ratio k. */
    @Test
    void pulleysShareTheirRope() {
        for (double k : new double[] {1, 2}) {
            try (PhysicsWorld world = world()) {
                double m = 3;
                double n = 5;
                BodyRef left = world.add(Body.dynamic().shape(Sphere.of(0.2)).mass(m).at(-1, 0, 0));
                BodyRef right = world.add(Body.dynamic().shape(Sphere.of(0.2)).mass(n).at(1, 0, 0));
                Vector3d overLeft = new Vector3d(-1, 20, 0);
                Vector3d overRight = new Vector3d(1, 20, 0);
                JointRef rope = world.add(Joint.pulley(left, right, overLeft, overRight, k));
                assertEquals(20 + k * 20, rope.length(), 1e-12);
                double tension = G * (1 + k) / (1 / m + k * k / n);
                for (int tick = 1; tick <= 90; tick++) {
                    world.step(STEP);
                    double t = tick * STEP;
                    double y = left.position(new Vector3d()).y;
                    assertEquals((tension / m - G) * t * t / 2, y, 1e-9, "left, " + k);
                    assertEquals(-y / k, right.position(new Vector3d()).y, 1e-9, "right, " + k);
                }
                assertEquals(k * tension, rope.force(new Vector3d()).y, 1e-6);
                right.setVelocity(0, 30, 0);
                world.step(STEP);
                assertEquals(0, rope.force(new Vector3d()).length(), 0.0, "a rope does not push");
            }
        }
    }

    @Test
    void whatCannotMeshIsRefused() {
        try (PhysicsWorld world = world()) {
            BodyRef a = wheel(world, 0.2, 0);
            BodyRef b = wheel(world, 0.2, 0.5);
            Vector3d over = new Vector3d();
            refuses("teeth", () -> Joint.gear(a, b, 0, 5));
            refuses("teeth", () -> Joint.gear(a, b, 5, -5));
            refuses("no place", () -> world.add(Joint.gear(a, b, 5, 6)));
            refuses(
                    "one axis",
                    () ->
                            world.add(
                                    Joint.gear(a, b, 5, 6)
                                            .anchors(0, 0, 0, 0, 0, 1)
                                            .axis(0, 0, 1)));
            refuses(
                    "radius",
                    () ->
                            world.add(
                                    Joint.rack(a, b)
                                            .anchors(0, 0, 0, 1, 0, 0)
                                            .axis(0, 0, 1)
                                            .secondAxis(1, 0, 0)));
            refuses("ratio", () -> Joint.pulley(a, b, over, over, 0));
            assertEquals(0, world.joints().count());
        }
    }

    private static void refuses(String part, Runnable call) {
        IllegalArgumentException e = assertThrows(IllegalArgumentException.class, call::run);
        assertTrue(String.valueOf(e.getMessage()).contains(part), e.toString());
    }
}
