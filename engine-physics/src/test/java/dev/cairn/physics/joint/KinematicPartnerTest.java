package dev.cairn.physics.joint;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;
import java.util.function.BiFunction;

/** What hangs on a kinematic body by a joint moves as that body says. */
class KinematicPartnerTest {
    private static final double STEP = 1.0 / 60;
    private static final double G = 9.81;

    private static final List<BiFunction<BodyRef, BodyRef, Joint>> KINDS =
            List.of(
                    (k, b) -> Joint.ball(k, b).at(1, 0, 0),
                    (k, b) -> Joint.fixed(k, b).at(0.5, 0, 0),
                    (k, b) -> Joint.fixed(b, k).at(0.5, 0, 0),
                    (k, b) -> Joint.hinge(k, b).axis(0, 1, 0).at(0.5, 0, 0));

    private static PhysicsWorld world(int workers) {
        return PhysicsWorld.builder().workers(workers).sleeping(false).build();
    }

    private static Body box(double x, double y) {
        return Body.dynamic().shape(Box.cubeOfEdge(0.2)).at(x, y, 0);
    }

    /** Uniform motion needs no force. */
    @ParameterizedTest
    @ValueSource(doubles = {0.1, 5, 40})
    void goesAlong(double speed) {
        for (BiFunction<BodyRef, BodyRef, Joint> kind : KINDS) {
            try (PhysicsWorld world = world(1)) {
                world.setGravity(0, 0, 0);
                BodyRef carrier =
                        world.add(Body.kinematic().shape(Sphere.of(0.1)).velocity(speed, 0, 0));
                BodyRef body = world.add(box(1, 0).velocity(speed, 0, 0));
                JointRef joint = world.add(kind.apply(carrier, body));
                for (int t = 0; t < 120; t++) {
                    world.step(STEP);
                    assertTrue(joint.gap() < 1e-12, joint.kind() + " " + joint.gap());
                }
                Vector3d v = body.velocity(new Vector3d());
                assertEquals(0, v.distance(speed, 0, 0), 1e-12 * speed, joint.kind());
                assertEquals(0, joint.force(new Vector3d()).length(), 1e-9, joint.kind());
            }
        }
    }

    /** The joint's force is that of the circle, {@code m w² r}. */
    @ParameterizedTest
    @ValueSource(doubles = {0.1, 3, 20})
    void goesAround(double spin) {
        for (BiFunction<BodyRef, BodyRef, Joint> kind : KINDS) {
            try (PhysicsWorld world = world(1)) {
                world.setGravity(0, 0, 0);
                BodyRef carrier =
                        world.add(
                                Body.kinematic().shape(Sphere.of(0.1)).angularVelocity(0, spin, 0));
                BodyRef body =
                        world.add(box(1, 0).velocity(0, 0, -spin).angularVelocity(0, spin, 0));
                JointRef joint = world.add(kind.apply(carrier, body));
                for (int t = 0; t < 60; t++) {
                    world.step(STEP);
                    assertTrue(joint.gap() < 1e-10, joint.kind() + " " + joint.gap());
                }
                Vector3d at = body.position(new Vector3d());
                assertEquals(1, at.length(), 1e-3, joint.kind());
                // the hinge at half the radius swings out and in by what its start lacks
                double share = joint.kind().equals("hinge") ? 0.02 : 1e-3;
                double force = body.mass() * spin * spin;
                assertEquals(
                        force, joint.force(new Vector3d()).length(), share * force, joint.kind());
            }
        }
    }

    /**
     * In a wagon that speeds up by a, a plumb line hangs still at the angle {@code atan(a/g)}; the
     * wagon is moved by its places, {@code a t²/2}.
     */
    @Test
    void aPlumbLineInAWagonThatSpeedsUp() {
        double a = 3;
        double angle = Math.atan(a / G);
        try (PhysicsWorld world = world(1)) {
            BodyRef wagon = world.add(Body.kinematic().shape(Sphere.of(0.1)));
            double x = -Math.sin(angle);
            double y = -Math.cos(angle);
            BodyRef plumb = world.add(box(x, y));
            JointRef joint = world.add(Joint.ball(wagon, plumb).at(0, 0, 0));
            for (int t = 1; t <= 120; t++) {
                double time = t * STEP;
                double way = 0.5 * a * time * time;
                wagon.moveTo(way, 0, 0);
                world.step(STEP);
                Vector3d at = plumb.position(new Vector3d()).sub(way, 0, 0);
                assertEquals(0, at.distance(x, y, 0), 1e-11, "tick " + t);
                assertTrue(joint.gap() < 1e-10, "tick " + t);
            }
        }
    }

    /** A lift that starts at once takes what hangs on it along, and then bears its weight. */
    @Test
    void aLiftThatStarts() {
        long digest = 0;
        for (int workers = 1; workers <= 2; workers++) {
            try (PhysicsWorld world = world(workers)) {
                BodyRef lift = world.add(Body.kinematic().shape(Sphere.of(0.1)));
                BodyRef load = world.add(box(0, -1));
                BodyRef under = world.add(box(0, -2));
                JointRef upper = world.add(Joint.ball(lift, load).at(0, 0, 0));
                world.add(Joint.ball(load, under).at(0, -1, 0));
                for (int t = 0; t < 90; t++) {
                    if (t == 30) {
                        lift.setVelocity(0, 4, 0);
                    }
                    world.step(STEP);
                    assertTrue(upper.gap() < 1e-10, "tick " + t);
                }
                assertEquals(4, under.velocity(new Vector3d()).y, 1e-6);
                double weight = G * (load.mass() + under.mass());
                assertEquals(weight, upper.force(new Vector3d()).length(), 1e-6 * weight);
                digest = workers == 1 ? world.digest() : digest;
                assertEquals(digest, world.digest(), "workers " + workers);
            }
        }
    }

    @Test
    void whatSleepsWakesWhenItsPartnerMoves() {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            BodyRef lift = world.add(Body.kinematic().shape(Sphere.of(0.1)));
            BodyRef load = world.add(box(0, -1));
            world.add(Joint.ball(lift, load).at(0, 0, 0));
            for (int t = 0; t < 120; t++) {
                world.step(STEP);
            }
            assertTrue(load.isAsleep());
            lift.setVelocity(0, 1, 0);
            for (int t = 0; t < 60; t++) {
                world.step(STEP);
            }
            assertFalse(load.isAsleep());
            assertEquals(0, load.position(new Vector3d()).y, 1e-3);
        }
    }
}
