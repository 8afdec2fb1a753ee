package dev.cairn.physics.joint;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.body.Lock;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Pendulums against the elliptic integral of their period. */
final class PendulumTest {
    private static final double G = 9.81;
    private static final double STEP = 1 / 60.0;

    /** {@code T = 2 pi sqrt(I/m g L)/agm(1, cos(a/2))}. */
    static double period(double inertia, double mass, double length, double amplitude) {
        double a = 1;
        double b = StrictMath.cos(amplitude / 2);
        while (Math.abs(a - b) > 1e-15) {
            double mean = (a + b) / 2;
            b = Math.sqrt(a * b);
            a = mean;
        }
        return 2 * Math.PI * Math.sqrt(inertia / (mass * G * length)) / a;
    }

    @ParameterizedTest
    @CsvSource({"ball, 10", "ball, 90", "ball, 170", "hinge, 120", "rod, 150"})
    void keepsTimeAndHeight(String kind, double degrees) {
        double amplitude = StrictMath.toRadians(degrees);
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).sleeping(false).build()) {
            boolean isArm = kind.equals("hinge");
            BodyRef peg = world.add(Body.fixed().shape(Sphere.of(0.05)).at(0, 0, isArm ? 1 : 0));
            Shape shape = isArm ? Box.ofHalfExtents(0.05, 0.5, 0.05) : Sphere.of(0.1);
            double length = isArm ? 0.5 : 1;
            double x = length * StrictMath.sin(amplitude);
            double y = -length * StrictMath.cos(amplitude);
            BodyRef bob =
                    world.add(
                            Body.dynamic()
                                    .shape(shape)
                                    .mass(2)
                                    .at(x, y, 0)
                                    .rotationAbout(0, 0, 1, amplitude));
            double inertia = 2 * length * length;
            if (kind.equals("rod")) {
                world.add(Joint.rod(peg, bob));
            } else {
                inertia += 1 / bob.inverseInertia(new org.joml.Matrix3d()).m22();
                world.add(
                        isArm
                                ? Joint.hinge(peg, bob).at(0, 0, 0).axis(0, 0, 1)
                                : Joint.ball(peg, bob).at(0, 0, 0));
            }
            double expected = period(inertia, 2, length, amplitude);
            double start = world.kineticEnergy() + world.potentialEnergy();
            double lost = 0;
            double first = 0;
            double last = 0;
            int count = 0;
            Vector3d p = new Vector3d();
            Vector3d v = new Vector3d();
            double x0 = x;
            double v0 = 0;
            for (int tick = 1; tick <= 1500; tick++) {
                world.step(STEP);
                bob.position(p);
                bob.velocity(v);
                double energy = world.kineticEnergy() + world.potentialEnergy();
                lost = Math.max(lost, Math.abs(energy - start) / (2 * G * length));
                if (x0 < 0 && p.x >= 0) {
                    double t = STEP * (tick - 1 + root(x0, STEP * v0, p.x, STEP * v.x));
                    first = count == 0 ? t : first;
                    last = t;
                    count++;
                }
                x0 = p.x;
                v0 = v.x;
            }
            double period = (last - first) / (count - 1);
            assertEquals(1, period / expected, 1e-6);
            assertTrue(lost < 1e-6, () -> "height lost, relative");
        }
    }

    /** Root in [0, 1] of the cubic with these ends and slopes. */
    private static double root(double a, double da, double b, double db) {
        double low = 0;
        double high = 1;
        for (int k = 0; k < 60; k++) {
            double s = 0.5 * (low + high);
            double r = 1 - s;
            double f =
                    (1 + 2 * s) * r * r * a
                            + s * r * r * da
                            + s * s * (3 - 2 * s) * b
                            - s * s * r * db;
            low = f < 0 ? s : low;
            high = f < 0 ? high : s;
        }
        return 0.5 * (low + high);
    }

    /**
     * A pendulum under a trolley that may only go along x: the rail does no work, and momentum
     * along it is kept.
     */
    @Test
    void underATrolleyOnARail() {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).sleeping(false).build()) {
            BodyRef trolley =
                    world.add(Body.dynamic().shape(Box.cubeOfEdge(0.2)).mass(2).at(0, 2, 0));
            trolley.setLocks(Lock.MOVE_Y, Lock.MOVE_Z, Lock.TURN_X, Lock.TURN_Y, Lock.TURN_Z);
            BodyRef bob = world.add(Body.dynamic().shape(Sphere.of(0.05)).mass(1).at(0.5, 1, 0));
            JointRef joint = world.add(Joint.ball(trolley, bob).at(0, 2, 0));
            double energy = world.kineticEnergy() + world.potentialEnergy();
            for (int t = 1; t <= 300; t++) {
                world.step(1.0 / 60);
                Vector3d at = trolley.position(new Vector3d());
                assertEquals(2, at.y, 0, "tick " + t);
                assertTrue(joint.gap() < 1e-10, "tick " + t + ": " + joint.gap());
                double momentum =
                        2 * trolley.velocity(new Vector3d()).x + bob.velocity(new Vector3d()).x;
                assertEquals(0, momentum, 1e-11, "tick " + t);
                double now = world.kineticEnergy() + world.potentialEnergy();
                assertEquals(energy, now, 1e-3, "tick " + t);
            }
        }
    }
}
