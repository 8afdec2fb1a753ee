package dev.cairn.physics.joint;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.PhysicsWorldBuilder;
import dev.cairn.physics.body.Kinetics;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Sphere;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;

/** Joints as a user meets them: what they hold, what they conserve, how they come and go. */
final class JointsTest {
    private static final double STEP = 1 / 60.0;
    private static final double G = 9.81;

    private static PhysicsWorldBuilder still() {
        return PhysicsWorld.builder().workers(1).sleeping(false);
    }

    /** A chain of capsules, hung up at one end, out sideways; a ball at the other. */
    static List<JointRef> chain(PhysicsWorld world, int links, double ball, double slant) {
        List<JointRef> joints = new ArrayList<>();
        double c = StrictMath.cos(slant);
        double s = StrictMath.sin(slant);
        BodyRef last = world.add(Body.fixed().shape(Sphere.of(0.01)).at(0, 10, 1));
        for (int k = 0; k < links; k++) {
            double r = 0.5 * k + 0.25;
            BodyRef link =
                    world.add(
                            Body.dynamic()
                                    .shape(Capsule.of(0.05, 0.15))
                                    .mass(1)
                                    .at(r * s, 10 - r * c, 0)
                                    .rotationAbout(0, 0, 1, slant));
            r = 0.5 * k;
            joints.add(world.add(Joint.ball(last, link).at(r * s, 10 - r * c, 0)));
            last = link;
        }
        double r = 0.5 * links;
        BodyRef end =
                world.add(
                        Body.dynamic()
                                .shape(Sphere.of(0.2))
                                .mass(ball)
                                .at((r + 0.2) * s, 10 - (r + 0.2) * c, 0));
        joints.add(world.add(Joint.ball(last, end).at(r * s, 10 - r * c, 0)));
        return joints;
    }

    @Test
    void heavyEndsDoNotStretchChains() {
        for (double ball : new double[] {100, 1000}) {
            for (double slant : new double[] {0, 1.5}) {
                try (PhysicsWorld world = still().build()) {
                    List<JointRef> joints = chain(world, 10, ball, slant);
                    double worst = 0;
                    double start = world.potentialEnergy();
                    for (int tick = 0; tick < 600; tick++) {
                        world.step(STEP);
                        for (JointRef j : joints) {
                            worst = Math.max(worst, j.gap());
                        }
                    }
                    double drift = world.kineticEnergy() + world.potentialEnergy() - start;
                    // the links swing among each other, and strike
                    assertTrue(drift < 1e-4 * 5 * ball * G, "energy " + drift);
                    assertEquals(0, worst, 1e-9, "a link opens");
                    Vector3d f = joints.get(0).force(new Vector3d());
                    if (slant == 0) {
                        assertEquals((10 + ball) * G, f.y, 1e-6 * ball * G, "what hangs on it");
                    }
                }
            }
        }
    }

    @Test
    void freeSystemsKeepTheirMomenta() {
        try (PhysicsWorld world = still().gravity(0, 0, 0).build()) {
            List<BodyRef> bodies = new ArrayList<>();
            for (int k = 0; k < 6; k++) {
                bodies.add(
                        world.add(
                                Body.dynamic()
                                        .shape(Box.ofHalfExtents(0.3, 0.1 + 0.02 * k, 0.2))
                                        .mass(1 + k)
                                        .at(k, 0.1 * k, 0)
                                        .velocity(0, k % 3 - 1, 0.3 * k)
                                        .angularVelocity(1, 0.2 * k, -1)));
            }
            Joint[] kinds = {
                Joint.ball(bodies.get(0), bodies.get(1)),
                Joint.hinge(bodies.get(1), bodies.get(2)).axis(1, 1, 0).limits(-0.5, 0.5),
                Joint.slider(bodies.get(2), bodies.get(3)).axis(0, 1, 0).motor(0.2, 5),
                Joint.universal(bodies.get(3), bodies.get(4)).axis(1, 0, 0),
                Joint.fixed(bodies.get(4), bodies.get(5))
            };
            for (int k = 0; k < kinds.length; k++) {
                world.add(kinds[k].at(k + 0.5, 0.1 * k, 0));
            }
            Kinetics before = world.kinetics();
            for (int tick = 0; tick < 600; tick++) {
                world.step(STEP);
            }
            Kinetics after = world.kinetics();
            double worst = 0;
            for (JointRef j : world.joints().all()) {
                worst = Math.max(worst, j.gap());
            }
            assertEquals(0, worst, 1e-12, "a joint opens");
            assertEquals(before.momentumX(), after.momentumX(), 1e-12);
            assertEquals(before.momentumY(), after.momentumY(), 1e-12);
            assertEquals(before.momentumZ(), after.momentumZ(), 1e-12);
            assertEquals(before.angularMomentumX(), after.angularMomentumX(), 1e-10);
            assertEquals(before.angularMomentumY(), after.angularMomentumY(), 1e-10);
            assertEquals(before.angularMomentumZ(), after.angularMomentumZ(), 1e-10);
        }
    }

    @Test
    void endsWithItsBody() {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            List<JointRef> joints = chain(world, 3, 1, 0.5);
            BodyRef link = world.bodyOf(joints.get(1).entityB());
            world.step(STEP);
            link.remove();
            world.step(STEP);
            assertTrue(joints.get(0).isAlive());
            assertFalse(joints.get(1).isAlive());
            assertFalse(joints.get(2).isAlive());
            assertEquals(2, world.joints().count());
            assertThrows(IllegalStateException.class, () -> joints.get(1).gap());
            joints.get(0).remove();
            assertFalse(joints.get(0).isAlive());
            world.step(STEP);
        }
    }

    /** It swings out on its hinges' friction, sleeps, and wakes when it is pushed. */
    @Test
    void sleepsAndWakes() {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            BodyRef peg = world.add(Body.fixed().shape(Sphere.of(0.05)).at(0, 3, 1));
            BodyRef arm =
                    world.add(Body.dynamic().shape(Box.ofHalfExtents(0.1, 0.5, 0.1)).at(0, 2.5, 0));
            BodyRef other =
                    world.add(Body.dynamic().shape(Box.ofHalfExtents(0.1, 0.5, 0.1)).at(0, 1.4, 0));
            world.add(Joint.hinge(peg, arm).at(0, 3, 0).axis(0, 0, 1).motor(0, 3));
            world.add(Joint.hinge(arm, other).at(0, 1.95, 0).axis(0, 0, 1).motor(0, 3));
            arm.applyImpulse(20, 0, 0);
            int ticks = 0;
            while (!arm.isAsleep() && ticks < 1200) {
                world.step(STEP);
                ticks++;
            }
            assertTrue(arm.isAsleep() && other.isAsleep(), "sleeps");
            other.applyImpulse(20, 0, 0);
            world.step(STEP);
            assertFalse(arm.isAsleep(), "wakes with what hangs on it");
        }
    }

    /** The same bits for workers and lanes: chains and a net, that fall onto boxes. */
    @Test
    void sameBits() {
        long expected = 0;
        for (int workers = 1; workers <= 3; workers++) {
            try (PhysicsWorld world = still().workers(workers).build()) {
                world.add(Body.fixed().shape(Box.ofHalfExtents(50, 1, 50)).at(0, -1, 0));
                for (int c = 0; c < 12; c++) {
                    BodyRef last = null;
                    for (int k = 0; k < 30; k++) {
                        BodyRef link =
                                world.add(
                                        Body.dynamic()
                                                .shape(Capsule.of(0.08, 0.1))
                                                .at(0.4 * k, 0.5 + 0.3 * c, 0.3 * (c % 3))
                                                .velocity(0, 0.1 * (k % 7), 0.2 * (k % 5)));
                        if (last != null) {
                            world.add(
                                    Joint.ball(last, link)
                                            .at(0.4 * k - 0.2, 0.5 + 0.3 * c, 0.3 * (c % 3)));
                        }
                        last = link;
                    }
                }
                for (int tick = 0; tick < 60; tick++) {
                    world.step(STEP);
                }
                double worst = 0;
                for (JointRef j : world.joints().all()) {
                    worst = Math.max(worst, j.gap());
                }
                assertEquals(0, worst, 1e-9, "a link opens");
                expected = expected == 0 ? world.digest() : expected;
                assertEquals(expected, world.digest(), workers + " workers");
            }
        }
    }
}
