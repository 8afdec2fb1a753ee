package dev.cairn.physics.joint;

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
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.shape.TriangleMesh;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.List;

/**
 * Heavy bodies on light ones that joints hold fall on the ground: what is light is not pushed into
 * it, joints stay closed, energy only falls, and what has come to rest stands where it should. A
 * sweep gives a wheel what stops the wheel, and joints hand on the rest: with 200 times the wheels'
 * mass the cart went through the floor with them.
 */
final class StandingMachinesTest {
    private static final double STEP = 1.0 / 60;
    private static final double G = 9.81;
    private static final double WHEEL = 0.2;

    /** A body on four wheels, let fall: flat, and on its nose. */
    @Tag("compiled")
    @ParameterizedTest(name = "{0} times the mass, tilted by {1}, on triangles {2}")
    @CsvSource({
        "2, 0, false",
        "20, 0, false",
        "200, 0, false",
        "200, 0, true",
        "1000, 0, false",
        "2, 0.4, false",
        "20, 0.4, false",
        "200, 0.4, false",
        "200, 0.4, true"
    })
    void aCartLandsOnItsWheels(double ratio, double tilt, boolean onTriangles) {
        long digest = 0;
        for (int lanes : new int[] {1, 4, 8}) {
            long seen = run(ratio, tilt, onTriangles, lanes == 1 ? 1 : 2, lanes);
            assertEquals(digest == 0 ? seen : digest, seen, lanes + " lanes");
            digest = seen;
        }
    }

    private static long run(
            double ratio, double tilt, boolean onTriangles, int workers, int lanes) {
        try (PhysicsWorld world =
                PhysicsWorld.builder()
                        .gravity(0, -G, 0)
                        .workers(workers)
                        .settings(PhysicsSettings.DEFAULT.withSleeping(false).withLanes(lanes))
                        .build()) {
            world.add(Body.fixed().shape(onTriangles ? square() : HalfSpace.of()));
            double density = 1000;
            Shape disc = Cylinder.of(WHEEL, 0.05);
            double wheelMass = Math.PI * WHEEL * WHEEL * 0.1 * density;
            BodyRef box =
                    world.add(
                            turned(Body.dynamic(), tilt, 0, 0, 0, 0)
                                    .shape(Box.ofHalfExtents(0.8, 0.15, 0.3))
                                    .mass(ratio * wheelMass));
            List<BodyRef> wheels = new ArrayList<>();
            List<JointRef> hinges = new ArrayList<>();
            for (int k = 0; k < 4; k++) {
                double x = k < 2 ? 0.6 : -0.6;
                double z = k % 2 == 0 ? 0.36 : -0.36;
                Body wheel = turned(Body.dynamic(), tilt, x, -0.15, z, Math.PI / 2).shape(disc);
                wheels.add(world.add(wheel.mass(wheelMass)));
                Vector3d at = wheels.get(k).position(new Vector3d());
                hinges.add(
                        world.add(
                                Joint.hinge(box, wheels.get(k))
                                        .at(at.x, at.y, at.z)
                                        .axis(0, 0, 1)));
            }
            double start = world.kineticEnergy() + world.potentialEnergy();
            for (int t = 0; t < 300; t++) {
                world.step(STEP);
                String what = "tick " + t;
                for (int k = 0; k < 4; k++) {
                    double y = wheels.get(k).position(new Vector3d()).y;
                    assertTrue(y > 0.5 * WHEEL, what + ": wheel " + k + " is at " + y);
                    assertTrue(hinges.get(k).gap() < 1e-3 * WHEEL, what + hinges.get(k).gap());
                }
                double energy = world.kineticEnergy() + world.potentialEnergy();
                assertTrue(energy < start * (1 + 1e-4), what + ": " + energy + " J of " + start);
            }
            // it stands on its wheels, by which the body's height is known
            assertEquals(WHEEL + 0.15, box.position(new Vector3d()).y, 0.01 * WHEEL);
            return world.digest();
        }
    }

    /** At a place of the cart, which is tilted about z and one metre up. */
    private static Body turned(
            Body body, double tilt, double x, double y, double z, double aboutX) {
        double c = Math.cos(tilt);
        double s = Math.sin(tilt);
        Quaterniond q = new Quaterniond().rotateZ(tilt).rotateX(aboutX);
        return body.at(c * x - s * y, 1.4 + s * x + c * y, z).rotation(q);
    }

    /** Two triangles, 40 m wide, facing up. */
    private static Shape square() {
        return TriangleMesh.of(
                new double[] {-20, 0, -20, -20, 0, 20, 20, 0, 20, 20, 0, -20},
                new int[] {0, 1, 2, 0, 2, 3});
    }

    /** A ball of 20 and of 400 times its foot, fixed on it, dropped by half a metre. */
    @ParameterizedTest(name = "links of {0} kg")
    @CsvSource({"1", "0.05"})
    void aHeavyBallOnALightFootStandsOnIt(double footMass) {
        try (PhysicsWorld world =
                PhysicsWorld.builder().gravity(0, -G, 0).sleeping(false).build()) {
            world.add(Body.fixed().shape(HalfSpace.of()));
            BodyRef foot =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.ofHalfExtents(0.3, 0.02, 0.3))
                                    .mass(footMass)
                                    .at(0, 0.52, 0));
            BodyRef ball = world.add(Body.dynamic().shape(Sphere.of(0.2)).mass(20).at(0, 0.74, 0));
            JointRef joint = world.add(Joint.fixed(foot, ball).at(0, 0.54, 0));
            for (int t = 0; t < 400; t++) {
                world.step(STEP);
                double y = foot.position(new Vector3d()).y;
                assertTrue(y > 0.01, "tick " + t + ": the foot is at " + y);
                assertTrue(joint.gap() < 1e-4, "tick " + t + ": " + joint.gap());
            }
            assertEquals(0.02, foot.position(new Vector3d()).y, 1e-3);
        }
    }

    /**
     * A car on soft springs falls on the stops of its suspension with its driven wheels spinning.
     * The stops catch it once, and it drives off as its motors want: {@code a = 2 T/r / (M + 4 (m +
     * I/r^2))} with two motors of T.
     */
    @ParameterizedTest
    @ValueSource(ints = {2, 3, 4, 5, 6, 8, 16})
    void aCarThatFallsOnItsStopsDrivesOff(int substeps) {
        double radius = 0.35;
        double mass = 800;
        double wheelMass = 20;
        double torque = 400;
        double start = 0.75;
        try (PhysicsWorld world = world(substeps)) {
            world.add(Body.fixed().shape(HalfSpace.of()).material(new Material(0.9, 0, 1000)));
            Body chassis = Body.dynamic().shape(Box.ofHalfExtents(1.2, 0.25, 0.6)).mass(mass);
            BodyRef car = world.add(chassis.at(0, start, 0));
            for (int k = 0; k < 4; k++) {
                double x = k < 2 ? 0.8 : -0.8;
                double z = k % 2 == 0 ? 0.8 : -0.8;
                Body wheel = Body.dynamic().shape(Sphere.of(radius)).mass(wheelMass);
                wheel.material(new Material(0.9, 0, 1000));
                Joint joint =
                        Joint.wheel(car, world.add(wheel.at(x, radius + 0.01, z)), 2, 0.7)
                                .at(x, radius + 0.01, z)
                                .axis(0, 0, 1)
                                .secondAxis(0, 1, 0)
                                .limits(JointAxis.Y, -0.15, 0.15);
                world.add(
                        k < 2
                                ? joint.spring(JointAxis.SWING_Y, 0, 8, 1)
                                : joint.motor(-15, torque));
            }
            double speed = 0;
            for (int t = 1; t <= 60; t++) {
                world.step(STEP);
                double y = car.position(new Vector3d()).y;
                assertTrue(y < start, "tick " + t + ": it was thrown up to " + y);
                speed = t == 40 ? car.velocity(new Vector3d()).x : speed;
            }
            double inertia = 0.4 * wheelMass; // of a ball, over r^2
            double acceleration = 2 * torque / radius / (mass + 4 * (wheelMass + inertia));
            double gained = car.velocity(new Vector3d()).x - speed;
            assertEquals(acceleration * 20 * STEP, gained, 0.03 * acceleration * 20 * STEP);
        }
    }

    /**
     * A ball of up to a hundred times its mass falls by 0.85 m on an arm that lies on the stop of
     * its hinge. Nothing gives way, so it stays there; what the overlap of the hit is pushed out by
     * is all that comes back.
     */
    @ParameterizedTest(name = "{0} times the mass, {1} sub-steps")
    @CsvSource({"1, 4", "10, 2", "10, 4", "10, 16", "100, 4", "100, 8"})
    void aHeavyBallStaysOnAnArmAtItsStop(double mass, int substeps) {
        try (PhysicsWorld world = world(substeps)) {
            BodyRef post =
                    world.add(Body.fixed().shape(Box.ofHalfExtents(0.05, 0.05, 0.05)).at(0, 1, 0));
            Body beam = Body.dynamic().shape(Box.ofHalfExtents(0.5, 0.05, 0.1)).mass(1);
            BodyRef arm = world.add(beam.at(0.6, 1, 0));
            world.add(Joint.hinge(post, arm).at(0.05, 1, 0).axis(0, 0, 1).limits(0, 1));
            BodyRef ball = world.add(Body.dynamic().shape(Sphere.of(0.1)).mass(mass).at(0.8, 2, 0));
            double before = world.kineticEnergy() + world.potentialEnergy();
            for (int t = 1; t <= 150; t++) {
                world.step(STEP);
                double energy = world.kineticEnergy() + world.potentialEnergy();
                double most = before + 0.02 * mass * G * 0.85;
                assertTrue(energy <= most, "tick " + t + ": " + energy + " J after " + before);
                double y = ball.position(new Vector3d()).y;
                assertTrue(y > 1.1, "tick " + t + ": the ball is at " + y);
                double up = ball.velocity(new Vector3d()).y;
                assertTrue(up < 0.1 * Math.sqrt(2 * G * 0.85), "tick " + t + ": up at " + up);
                before = energy;
            }
            assertEquals(1.15, ball.position(new Vector3d()).y, 0.2 * 0.1);
        }
    }

    private static PhysicsWorld world(int substeps) {
        return PhysicsWorld.builder()
                .gravity(0, -G, 0)
                .settings(PhysicsSettings.DEFAULT.withSubsteps(substeps))
                .sleeping(false)
                .build();
    }
}
