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

/**
 * Structures that joints hold more often than they can move: straight bridges, which to first order
 * can sag and to second order cannot, and nets. They stay closed to 1e-3 of a link, and gain at
 * most 1e-4 of their energy.
 */
final class ClosedStructuresTest {
    private static final double STEP = 1 / 60.0;
    private static final int PLANKS = 6;

    /** Length of a plank; the mesh of the net is half of it, m. */
    private static final double LINK = 1;

    private static final int KNOTS = 3;

    @Test
    void bridgesOfHingesBear() {
        staysClosed(world -> bridge(world, true), 240);
    }

    @Test
    void bridgesOfPairsOfBallJointsBear() {
        staysClosed(world -> bridge(world, false), 240);
    }

    @Test
    void netsHangByTwoCorners() {
        staysClosed(ClosedStructuresTest::net, 240);
    }

    /**
     * A plank on two hinges has ten rows for six ways to move. A box of twice its mass falls onto
     * it beside the middle: nothing is thrown up, and at rest the two bear its weight by the law of
     * levers, with no force along their axes that statics does not tell.
     */
    @Test
    void redundantHingesBearWhatFalls() {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).sleeping(false).build()) {
            BodyRef plank =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.ofHalfExtents(0.23, 0.04, 0.6))
                                    .mass(10)
                                    .at(0, 0, 0));
            JointRef[] hinge = new JointRef[2];
            for (int k = 0; k < 2; k++) {
                double x = 0.25 * (2 * k - 1);
                BodyRef post = world.add(Body.fixed().shape(Sphere.of(0.02)).at(2 * x, 0, 1));
                hinge[k] = world.add(Joint.hinge(post, plank).at(x, 0, 0).axis(0, 0, 1));
            }
            BodyRef box =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.ofHalfExtents(0.1, 0.2, 0.1))
                                    .mass(20)
                                    .at(0.05, 0.5, 0.1));
            double start = world.kineticEnergy() + world.potentialEnergy();
            for (int tick = 0; tick < 300; tick++) {
                world.step(STEP);
                double gain = world.kineticEnergy() + world.potentialEnergy() - start;
                assertTrue(gain < 1e-6 * start, "energy gained " + gain + " in tick " + tick);
                for (JointRef j : hinge) {
                    assertTrue(j.gap() < 1e-9, "gap " + j.gap() + " in tick " + tick);
                }
            }
            Vector3d left = hinge[0].force(new Vector3d());
            Vector3d right = hinge[1].force(new Vector3d());
            double at = box.position(new Vector3d()).x;
            double load = 20 * 9.81;
            assertEquals(5 * 9.81 + load * (0.5 - at / 0.5), left.y, 1e-3 * load, "left");
            assertEquals(5 * 9.81 + load * (0.5 + at / 0.5), right.y, 1e-3 * load, "right");
            assertEquals(0, left.z, 1e-3 * load, "along the axis");
        }
    }

    /** A bridge of twenty planks that sags, under three boxes of twice their mass. */
    @Test
    void saggingBridgesStayClosed() {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).sleeping(false).build()) {
            int n = 20;
            double bend = 0.35;
            double radius = 0.25 / StrictMath.sin(bend / n);
            double inner = radius * StrictMath.cos(bend / n);
            double end = radius * StrictMath.sin(bend);
            double up = radius * StrictMath.cos(bend);
            BodyRef last = world.add(Body.fixed().shape(Sphere.of(0.1)).at(-end - 0.3, 0, 0));
            for (int k = 0; k < n; k++) {
                double a = bend * (2 * k + 1 - n) / n;
                double s = StrictMath.sin(a);
                double c = StrictMath.cos(a);
                BodyRef next =
                        world.add(
                                Body.dynamic()
                                        .shape(Box.ofHalfExtents(0.23, 0.04, 0.6))
                                        .mass(10)
                                        .at(inner * s, up - inner * c, 0)
                                        .rotationAbout(0, 0, 1, a));
                world.add(
                        Joint.hinge(last, next)
                                .at(inner * s - 0.25 * c, up - inner * c - 0.25 * s, 0)
                                .axis(0, 0, 1));
                last = next;
            }
            BodyRef post = world.add(Body.fixed().shape(Sphere.of(0.1)).at(end + 0.3, 0, 0));
            world.add(Joint.hinge(last, post).at(end, 0, 0).axis(0, 0, 1));
            for (int k = 0; k < 3; k++) {
                world.add(
                        Body.dynamic()
                                .shape(Box.ofHalfExtents(0.2, 0.2, 0.2))
                                .mass(20)
                                .at(1.3 * k - 1.2, 0.8, 0.1));
            }
            double start = world.kineticEnergy() + world.potentialEnergy();
            for (int tick = 0; tick < 240; tick++) {
                world.step(STEP);
                for (JointRef j : world.joints().all()) {
                    assertTrue(j.gap() < 1e-9, "gap " + j.gap() + " in tick " + tick);
                }
                double gain = world.kineticEnergy() + world.potentialEnergy() - start;
                assertTrue(gain < 1e-3 * Math.abs(start), "energy " + gain + " in tick " + tick);
            }
        }
    }

    private interface Scene {
        void build(PhysicsWorld world);
    }

    private static void staysClosed(Scene scene, int ticks) {
        long digest = run(scene, 1, ticks);
        assertEquals(digest, run(scene, 2, ticks), "two workers");
    }

    private static long run(Scene scene, int workers, int ticks) {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(workers).sleeping(false).build()) {
            scene.build(world);
            double start = world.kineticEnergy() + world.potentialEnergy();
            for (int tick = 0; tick < ticks; tick++) {
                world.step(STEP);
                double gap = 0;
                for (JointRef j : world.joints().all()) {
                    gap = Math.max(gap, j.gap());
                }
                // 1e-3 of a link
                assertTrue(gap < 1e-3 * LINK, "gap " + gap + " in tick " + tick);
                double gain = world.kineticEnergy() + world.potentialEnergy() - start;
                // a single round of Newton's method closes to second order in the sub-step
                assertTrue(gain < 1e-4 * start, "energy gained " + gain + " in tick " + tick);
            }
            return world.digest();
        }
    }

    /** Planks in a straight line between two piers, and a box of four times their mass above. */
    private static void bridge(PhysicsWorld world, boolean isHinged) {
        BodyRef last = world.add(Body.fixed().shape(Box.ofHalfExtents(0.5, 0.1, 1)).at(-1, 3, 0));
        for (int k = 0; k <= PLANKS; k++) {
            BodyRef next =
                    k == PLANKS
                            ? world.add(
                                    Body.fixed().shape(Box.ofHalfExtents(0.5, 0.1, 1)).at(k, 3, 0))
                            : world.add(
                                    Body.dynamic()
                                            .shape(Box.ofHalfExtents(0.45, 0.05, 1))
                                            .mass(5)
                                            .at(k, 3, 0));
            double x = k - 0.5;
            if (isHinged) {
                world.add(Joint.hinge(last, next).at(x, 3, 0).axis(0, 0, 1));
            } else {
                world.add(Joint.ball(last, next).at(x, 3, -0.9));
                world.add(Joint.ball(last, next).at(x, 3, 0.9));
            }
            last = next;
        }
        world.add(
                Body.dynamic().shape(Box.ofHalfExtents(0.3, 0.3, 0.3)).mass(20).at(2.6, 4.5, 0.1));
    }

    /** Knots in a level square, that falls and swings by two of its corners. */
    private static void net(PhysicsWorld world) {
        BodyRef[] before = new BodyRef[KNOTS];
        double d = 0.5;
        for (int row = 0; row < KNOTS; row++) {
            BodyRef left = null;
            for (int k = 0; k < KNOTS; k++) {
                boolean isFixed = row == 0 && (k == 0 || k == KNOTS - 1);
                BodyRef knot =
                        isFixed
                                ? world.add(
                                        Body.fixed().shape(Sphere.of(0.05)).at(k * d, 5, row * d))
                                : world.add(
                                        Body.dynamic()
                                                .shape(Sphere.of(0.1))
                                                .mass(1)
                                                .at(k * d, 5, row * d));
                if (left != null) {
                    world.add(Joint.ball(left, knot).at(k * d - d / 2, 5, row * d));
                }
                if (row > 0) {
                    world.add(Joint.ball(before[k], knot).at(k * d, 5, row * d - d / 2));
                }
                before[k] = knot;
                left = knot;
            }
        }
    }
}
