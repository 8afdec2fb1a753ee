package dev.cairn.physics.joint;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;

import org.joml.Vector3d;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;

/**
 * Figures of eleven bodies with limits at every joint, thrown onto a floor each by itself, come to
 * rest and sleep. Nothing in their joints brakes them.
 */
final class RagdollSleepTest {
    private static final double STEP = 1 / 60.0;
    private static final int PARTS = 11;

    private final Vector3d a = new Vector3d();
    private final Vector3d b = new Vector3d();

    /** A figure with a velocity of its own. */
    private static final class Figure {
        final List<BodyRef> parts = new ArrayList<>();
        private final PhysicsWorld world;
        private final double speed;
        private final double aside;

        Figure(PhysicsWorld world, int number) {
            this.world = world;
            speed = 1.5 + 0.3 * (number % 7);
            aside = 0.4 * (number % 3);
            double x = 3 * (number % 10);
            double y = 1.2 + 0.02 * number;
            double z = 3.0 * (number / 10);
            BodyRef pelvis = part(Capsule.of(0.12, 0.08), 12, x, y, z, true);
            BodyRef chest = part(Capsule.of(0.14, 0.1), 20, x, y + 0.4, z, true);
            BodyRef head = part(Sphere.of(0.12), 5, x, y + 0.72, z, false);
            cone(pelvis, chest, x, y + 0.2, z, 0, 1, 0.4);
            cone(chest, head, x, y + 0.57, z, 0, 1, 0.6);
            for (int side = -1; side <= 1; side += 2) {
                double arm = z + 0.3 * side;
                BodyRef upper = limb(0.06, 2.5, x, y + 0.3, arm);
                BodyRef lower = limb(0.05, 1.5, x, y, arm);
                cone(chest, upper, x, y + 0.45, z + 0.24 * side, side, -1, 1.3);
                bend(upper, lower, x, y + 0.15, arm, 0, 2.2);
                double leg = z + 0.12 * side;
                BodyRef thigh = limb(0.08, 7, x, y - 0.28, leg);
                BodyRef shin = limb(0.06, 4, x, y - 0.58, leg);
                cone(pelvis, thigh, x, y - 0.13, leg, 0, -1, 0.9);
                bend(thigh, shin, x, y - 0.43, leg, -2.2, 0);
            }
        }

        private BodyRef limb(double r, double mass, double x, double y, double z) {
            return part(Capsule.of(r, 0.15 - r), mass, x, y, z, false);
        }

        private BodyRef part(Shape shape, double mass, double x, double y, double z, boolean lies) {
            Body body = Body.dynamic().shape(shape).mass(mass).at(x, y, z);
            body.velocity(speed, 0, aside);
            parts.add(world.add(lies ? body.rotationAbout(1, 0, 0, Math.PI / 2) : body));
            return parts.getLast();
        }

        private void cone(
                BodyRef a,
                BodyRef b,
                double x,
                double y,
                double z,
                double axisZ,
                double axisY,
                double angle) {
            Joint ball = Joint.ball(a, b).at(x, y, z).axis(0, axisY, axisZ).limits(0, angle);
            world.add(ball.limits(JointAxis.TWIST, -0.5, 0.5));
        }

        private void bend(
                BodyRef a, BodyRef b, double x, double y, double z, double from, double to) {
            world.add(Joint.hinge(a, b).at(x, y, z).axis(0, 0, 1).limits(from, to));
        }

        boolean isAsleep() {
            return parts.stream().allMatch(BodyRef::isAsleep);
        }
    }

    private static List<Figure> figures(PhysicsWorld world, int count) {
        world.add(
                Body.fixed()
                        .shape(Box.ofHalfExtents(80, 1, 80))
                        .at(0, -1, 0)
                        .material(Material.WOOD));
        List<Figure> figures = new ArrayList<>();
        for (int k = 0; k < count; k++) {
            figures.add(new Figure(world, k));
        }
        return figures;
    }

    private double gap(PhysicsWorld world) {
        double most = 0;
        for (JointRef joint : world.joints().all()) {
            most = Math.max(most, joint.anchorA(a).distance(joint.anchorB(b)));
        }
        return most;
    }

    /** One that sleeps has no velocity, and its state stays the same bit by bit. */
    @Test
    void whatSleepsIsLeftAlone() {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            List<Figure> figures = figures(world, 1);
            for (int tick = 0; tick < 240; tick++) {
                world.step(STEP);
            }
            figures.getFirst().parts.getFirst().sleep();
            world.step(STEP);
            assertTrue(figures.getFirst().isAsleep(), "all of it sleeps");
            assertEquals(PARTS, world.sleepEvents().asleepCount());
            long bits = world.digest();
            for (int tick = 0; tick < 60; tick++) {
                world.step(STEP);
            }
            assertEquals(bits, world.digest(), "nothing of it changes");
            figures.getFirst().parts.getLast().applyImpulse(0, 5, 0);
            world.step(STEP);
            assertEquals(0, world.sleepEvents().asleepCount(), "it wakes as a whole");
        }
    }

    /** Seen: 82 after 27 s, 95 after 60 s; the others' heads and legs still roll slowly. */
    @Test
    @Tag("soak")
    void ninetyOfAHundredSleepWithinAMinute() {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            List<Figure> figures = figures(world, 100);
            double widest = 0;
            for (int tick = 0; tick < 3600; tick++) {
                world.step(STEP);
                widest = tick % 10 == 0 ? Math.max(widest, gap(world)) : widest;
            }
            long asleep = figures.stream().filter(Figure::isAsleep).count();
            System.out.println(asleep + " of 100 figures asleep, gap " + widest);
            assertTrue(asleep >= 90, asleep + " of 100 asleep");
            assertTrue(widest < 3e-4, "gap " + widest);
        }
    }
}
