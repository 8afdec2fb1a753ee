package dev.cairn.physics.joint;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** What each kind lets free and what it holds. */
final class JointKindsTest {
    private static final double STEP = 1 / 60.0;
    private static final double G = 9.81;

    private static PhysicsWorld world() {
        return PhysicsWorld.builder().workers(1).sleeping(false).build();
    }

    private static void run(PhysicsWorld world, double seconds) {
        for (int tick = 0; tick < Math.round(seconds / STEP); tick++) {
            world.step(STEP);
        }
    }

    private static BodyRef peg(PhysicsWorld world, double y) {
        return world.add(Body.fixed().shape(Sphere.of(0.05)).at(0, y, 0));
    }

    /** It falls freely, is caught, and hangs. */
    @Test
    void ropesCatchAndHang() {
        try (PhysicsWorld world = world()) {
            BodyRef ball = world.add(Body.dynamic().shape(Sphere.of(0.1)).mass(2).at(0, 4.9, 0));
            JointRef rope = world.add(Joint.rope(peg(world, 5), ball).length(1.5));
            double caught = Math.sqrt(2 * 1.4 / G);
            for (int tick = 1; tick <= 240; tick++) {
                world.step(STEP);
                double t = tick * STEP;
                double length = rope.value(JointAxis.DISTANCE);
                assertTrue(length < 1.5 + 1e-9, "length " + length);
                if (t < caught) {
                    assertEquals(0.1 + G * t * t / 2, length, 1e-9, "free fall");
                    assertEquals(0, rope.force(new Vector3d()).length(), 0.0);
                }
            }
            assertEquals(1.5, rope.value(JointAxis.DISTANCE), 1e-9);
            assertEquals(2 * G, rope.force(new Vector3d()).y, 1e-6 * 2 * G);
        }
    }

    /** The hand draws a box up, sinks by g/w², and is no stronger than it may be. */
    @Test
    void handsPull() {
        try (PhysicsWorld world = world()) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(5, 1, 5)).at(0, -1, 0));
            BodyRef box =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.ofHalfExtents(0.25, 0.25, 0.25))
                                    .mass(2)
                                    .at(0, 0.25, 0));
            JointRef hand =
                    world.add(
                            Joint.pull(peg(world, 9), box, 3, 1, 50)
                                    .anchors(0, 0.25, 0, 0, 0.25, 0));
            hand.moveTo(0, 2, 0);
            run(world, 4);
            double w = 2 * Math.PI * 3;
            assertEquals(2 - G / (w * w), box.position(new Vector3d()).y, 1e-6);
            assertEquals(2 * G, hand.force(new Vector3d()).y, 1e-5);
            box.setMass(200);
            hand.moveTo(0, 5, 0);
            for (int tick = 0; tick < 240; tick++) {
                world.step(STEP);
                double force = hand.force(new Vector3d()).length();
                assertTrue(force <= 50 * (1 + 1e-9), "force " + force);
            }
            assertEquals(0.25, box.position(new Vector3d()).y, 1e-3, "too heavy: on the floor");
            assertEquals(50, hand.force(new Vector3d()).y, 1e-6, "with all it has");
            hand.moveTo(3, 3, 3);
            run(world, 0.5);
            assertTrue(hand.force(new Vector3d()).length() <= 50 * (1 + 1e-9), "in any direction");
        }
    }

    /** A wheel that hangs: its suspension gives way by g/w², its motor turns it. */
    @Test
    void wheelsAreSprungDrivenAndSteered() {
        try (PhysicsWorld world = world()) {
            BodyRef wheel = world.add(Body.dynamic().shape(Sphere.of(0.3)).mass(20).at(0, 4, 0));
            JointRef joint =
                    world.add(
                            Joint.wheel(peg(world, 5), wheel, 2, 0.5)
                                    .at(0, 4, 0)
                                    .axis(0, 0, 1)
                                    .secondAxis(0, 1, 0)
                                    .motor(10, 3)
                                    .spring(JointAxis.SWING_Y, 0.3, 5, 1));
            double inertia = 0.4 * 20 * 0.09;
            run(world, 1);
            Vector3d w = wheel.angularVelocity(new Vector3d());
            run(world, 7);
            double hz = 2 * Math.PI * 2;
            assertEquals(-G / (hz * hz), joint.value(JointAxis.Y), 1e-6, "suspension");
            assertEquals(0.3, joint.value(JointAxis.SWING_Y), 1e-6, "steering");
            wheel.angularVelocity(w);
            assertEquals(10, w.length(), 1e-6, "spin");
            Vector3d axle =
                    new Vector3d(StrictMath.sin(0.3), 0, StrictMath.cos(0.3)).mul(w.length());
            assertEquals(0, axle.distance(w), 1e-5, "about its own axle " + w);
            assertTrue(inertia > 0 && joint.gap() < 1e-9, "gap " + joint.gap());
        }
    }

    /** Of a free cylindrical joint the way and the turn go on as they began. */
    @Test
    void cylindersSlideAndTurn() {
        try (PhysicsWorld world = world()) {
            world.setGravity(0, 0, 0);
            BodyRef rod =
                    world.add(Body.dynamic().shape(Box.ofHalfExtents(0.5, 0.1, 0.2)).at(0, 5, 0));
            JointRef joint =
                    world.add(Joint.cylindrical(peg(world, 5), rod).at(0, 5, 0).axis(1, 0, 0));
            rod.setVelocity(0.5, 3, 0);
            rod.setAngularVelocity(1, 2, 0);
            run(world, 2);
            assertEquals(1, joint.value(JointAxis.X), 1e-9, "way");
            assertEquals(2, joint.value(JointAxis.TWIST), 1e-9, "turn");
            assertEquals(0, rod.position(new Vector3d()).y - 5, 1e-12);
        }
    }

    /** {@code tan b = tan a cos d}: the law of Hooke's joint, of two shafts at an angle d. */
    @Test
    void universalJointsTransmitByHookesLaw() {
        try (PhysicsWorld world = world()) {
            world.setGravity(0, 0, 0);
            double d = 0.6;
            double c = StrictMath.cos(d);
            double s = StrictMath.sin(d);
            BodyRef in =
                    world.add(
                            Body.dynamic().shape(Box.ofHalfExtents(0.4, 0.1, 0.1)).at(-0.5, 0, 0));
            BodyRef out =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.ofHalfExtents(0.4, 0.1, 0.1))
                                    .at(0.5 * c, 0.5 * s, 0)
                                    .rotationAbout(0, 0, 1, d));
            BodyRef base = peg(world, 5);
            JointRef drive =
                    world.add(
                            Joint.hinge(base, in)
                                    .at(-1, 0, 0)
                                    .axis(1, 0, 0)
                                    .motor(1.3, Double.POSITIVE_INFINITY));
            JointRef driven = world.add(Joint.hinge(base, out).at(c, s, 0).axis(c, s, 0));
            // cross: one pin along z on the input, one in the plane on the output
            JointRef cross =
                    world.add(
                            Joint.universal(in, out)
                                    .at(0, 0, 0)
                                    .axis(0, 0, 1)
                                    .secondAxis(-s, c, 0));
            for (int tick = 0; tick < 300; tick++) {
                world.step(STEP);
                double a = drive.value(JointAxis.TWIST);
                double b = driven.value(JointAxis.TWIST);
                // the pin of the input is at a; that of the output stays at a right angle
                double left = StrictMath.sin(b) * StrictMath.cos(a);
                double right = StrictMath.cos(b) * StrictMath.sin(a) * c;
                double other = StrictMath.cos(b) * StrictMath.sin(a) / c;
                double error = Math.min(Math.abs(left - right), Math.abs(left * 1 - other));
                assertEquals(0, error, 1e-9, "a " + a + ", b " + b);
                assertTrue(cross.gap() < 1e-9, "gap");
            }
        }
    }

    /** A body that is kept upright falls and turns about the upright axis only. */
    @Test
    void parallelKeepsUpright() {
        try (PhysicsWorld world = world()) {
            BodyRef box =
                    world.add(Body.dynamic().shape(Box.ofHalfExtents(0.1, 0.5, 0.2)).at(3, 5, 0));
            JointRef joint =
                    world.add(Joint.parallel(peg(world, 9), box).at(3, 5, 0).axis(0, 1, 0));
            box.setAngularVelocity(1, 2, 3);
            run(world, 1);
            Vector3d up = box.orientation(new Quaterniond()).transform(new Vector3d(0, 1, 0));
            assertEquals(1, up.y, 1e-12, "upright");
            assertEquals(2, joint.value(JointAxis.TWIST), 1e-9, "turns on");
            assertEquals(5 - G / 2, box.position(new Vector3d()).y, 1e-9, "falls");
            assertEquals(0, joint.force(new Vector3d()).length(), 1e-9, "without a force");
        }
    }

    /** Two bodies that are as one fall and turn as one body of both masses does. */
    @Test
    void fixedBodiesAreAsOne() {
        try (PhysicsWorld world = world()) {
            world.setGravity(0, 0, 0);
            BodyRef[] half = new BodyRef[2];
            for (int k = 0; k < 2; k++) {
                half[k] =
                        world.add(
                                Body.dynamic()
                                        .shape(Box.ofHalfExtents(0.5, 0.2, 0.1))
                                        .mass(3)
                                        .at(k - 0.5, 0, 0));
            }
            JointRef joint = world.add(Joint.fixed(half[0], half[1]).at(0, 0, 0));
            BodyRef whole =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.ofHalfExtents(1, 0.2, 0.1))
                                    .mass(6)
                                    .at(0, 5, 0));
            Vector3d spin = new Vector3d(0.7, 1.1, 1.9);
            whole.setAngularVelocity(spin);
            for (int k = 0; k < 2; k++) {
                half[k].setAngularVelocity(spin);
                half[k].setVelocity(spin.cross(new Vector3d(k - 0.5, 0, 0), new Vector3d()));
            }
            for (int tick = 0; tick < 300; tick++) {
                world.step(STEP);
                Quaterniond a = whole.orientation(new Quaterniond());
                Quaterniond b = half[0].orientation(new Quaterniond());
                double angle = a.conjugate().mul(b).angle();
                angle = Math.min(angle, 2 * Math.PI - angle);
                assertEquals(0, angle, 1e-3, "they turn as one, tick " + tick);
                assertTrue(joint.gap() < 1e-12, "gap " + joint.gap());
            }
        }
    }
}
