package dev.cairn.physics.joint;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/** Joints that break, go off and on, are retuned, and what cannot be a joint. */
final class JointLifeTest {
    private static final double STEP = 1 / 60.0;
    private static final double G = 9.81;

    private static PhysicsWorld world() {
        return PhysicsWorld.builder().workers(1).sleeping(false).build();
    }

    private static BodyRef peg(PhysicsWorld world) {
        return world.add(Body.fixed().shape(Sphere.of(0.05)).at(0, 5, 0));
    }

    private static BodyRef arm(PhysicsWorld world) {
        return world.add(
                Body.dynamic().shape(Box.ofHalfExtents(0.5, 0.05, 0.05)).mass(4).at(0.5, 5, 0));
    }

    /** It bears a hundredth more than its load, and breaks with a hundredth less, once. */
    @Test
    void breaksUnderItsLoad() {
        for (boolean byTorque : new boolean[] {false, true}) {
            for (boolean breaks : new boolean[] {false, true}) {
                try (PhysicsWorld world = world()) {
                    BodyRef arm = arm(world);
                    double load = byTorque ? 4 * G * 0.5 : 4 * G;
                    double bound = load * (breaks ? 0.99 : 1.01);
                    double other = Double.POSITIVE_INFINITY;
                    JointRef joint =
                            world.add(
                                    Joint.fixed(peg(world), arm)
                                            .at(0, 5, 0)
                                            .breakAt(
                                                    byTorque ? other : bound,
                                                    byTorque ? bound : other));
                    int events = 0;
                    for (int tick = 0; tick < 30; tick++) {
                        world.step(STEP);
                        for (int k = 0; k < world.joints().brokenCount(); k++) {
                            assertSame(joint, world.joints().broken(k));
                            assertEquals(0, tick, "in the first tick");
                            events++;
                        }
                    }
                    assertEquals(breaks ? 1 : 0, events, "events");
                    assertEquals(!breaks, joint.isEnabled());
                    assertTrue(joint.isAlive(), "a broken joint is off, not gone");
                    double y = arm.position(new Vector3d()).y;
                    assertEquals(breaks ? 5 - G * 29 * 30 * STEP * STEP / 2 : 5, y, 0.1);
                }
            }
        }
    }

    /** Off it lets the body fall as if there were none; on again it draws it back. */
    @Test
    void goesOffAndOn() {
        try (PhysicsWorld world = world()) {
            BodyRef ball = world.add(Body.dynamic().shape(Sphere.of(0.1)).at(0, 4, 0));
            JointRef joint = world.add(Joint.ball(peg(world), ball).at(0, 5, 0));
            world.step(STEP);
            joint.setEnabled(false);
            for (int tick = 0; tick < 30; tick++) {
                world.step(STEP);
            }
            assertEquals(4 - G * 0.25 / 2, ball.position(new Vector3d()).y, 1e-9, "falls");
            assertEquals(0, joint.force(new Vector3d()).length(), 0.0);
            joint.setEnabled(true);
            double before = joint.gap();
            for (int tick = 0; tick < 90; tick++) {
                world.step(STEP);
                double gap = joint.gap();
                assertTrue(before - gap < 3 * STEP + 1e-9, "drawn with at most 3 m/s");
                before = gap;
            }
            assertEquals(0, joint.gap(), 1e-9, "closed again");
        }
    }

    /** What is retuned before the first step is as what was made so. */
    @Test
    void retuningIsAsMakingItSo() {
        List<Consumer<JointRef>> tunes = new ArrayList<>();
        tunes.add(j -> {});
        tunes.add(j -> j.motor(JointAxis.TWIST, 2, 30));
        tunes.add(j -> j.limits(JointAxis.TWIST, -0.3, 0.1));
        tunes.add(j -> j.spring(JointAxis.TWIST, 0.2, 3, 0.5));
        List<Consumer<Joint>> made = new ArrayList<>();
        made.add(j -> {});
        made.add(j -> j.motor(2, 30));
        made.add(j -> j.limits(-0.3, 0.1));
        made.add(j -> j.spring(0.2, 3, 0.5));
        long plain = run(j -> {}, j -> {});
        for (int k = 0; k < tunes.size(); k++) {
            long expected = run(made.get(k), j -> {});
            assertEquals(expected, run(j -> {}, tunes.get(k)), "tune " + k);
            if (k > 0) {
                assertNotEquals(plain, expected, "tune " + k + " does something");
            }
        }
        Consumer<JointRef> back =
                j -> {
                    j.motor(JointAxis.TWIST, 2, 30);
                    j.motorOff(JointAxis.TWIST);
                };
        assertEquals(plain, run(j -> {}, back), "and back");
    }

    private static long run(Consumer<Joint> make, Consumer<JointRef> tune) {
        try (PhysicsWorld world = world()) {
            Joint joint = Joint.hinge(peg(world), arm(world)).at(0, 5, 0).axis(0, 0, 1);
            make.accept(joint);
            tune.accept(world.add(joint));
            for (int tick = 0; tick < 60; tick++) {
                world.step(STEP);
            }
            return world.digest();
        }
    }

    private static void refuses(String part, Runnable call) {
        RuntimeException e = assertThrows(RuntimeException.class, call::run);
        boolean isTyped =
                e instanceof IllegalArgumentException || e instanceof IllegalStateException;
        assertTrue(isTyped, "typed: " + e);
        assertTrue(e.getMessage().contains(part), "'" + e.getMessage() + "' tells " + part);
    }

    @Test
    void badInputIsRefused() {
        try (PhysicsWorld world = world();
                PhysicsWorld other = world()) {
            BodyRef peg = peg(world);
            BodyRef arm = arm(world);
            BodyRef gone = arm(world);
            gone.remove();
            BodyRef stranger = arm(other);
            double nan = Double.NaN;
            refuses("twice", () -> world.add(Joint.ball(arm, arm).at(0, 5, 0)));
            refuses("two fixed", () -> world.add(Joint.ball(peg, peg(world)).at(0, 5, 0)));
            refuses("no place", () -> world.add(Joint.ball(peg, arm)));
            refuses("no longer", () -> world.add(Joint.ball(peg, gone).at(0, 5, 0)));
            refuses("world", () -> world.add(Joint.ball(peg, stranger).at(0, 5, 0)));
            refuses("above", () -> Joint.hinge(peg, arm).limits(1, 0));
            refuses("limits", () -> Joint.hinge(peg, arm).limits(nan, 0));
            refuses("limits", () -> Joint.hinge(peg, arm).limits(-4, 0));
            refuses("length 0", () -> Joint.hinge(peg, arm).axis(0, 0, 0));
            refuses("axis", () -> Joint.hinge(peg, arm).axis(nan, 0, 0));
            refuses(
                    "along the axis",
                    () ->
                            world.add(
                                    Joint.wheel(peg, arm, 1, 1)
                                            .at(0, 5, 0)
                                            .axis(0, 1, 0)
                                            .secondAxis(0, -2, 0)));
            refuses("anchor", () -> Joint.ball(peg, arm).at(0, nan, 0));
            refuses("speed", () -> Joint.hinge(peg, arm).motor(nan, 1));
            refuses("most", () -> Joint.hinge(peg, arm).motor(1, -1));
            refuses("most", () -> Joint.hinge(peg, arm).motor(1, nan));
            refuses("hertz", () -> Joint.spring(peg, arm, 0, 1));
            refuses("dampingRatio", () -> Joint.spring(peg, arm, 1, -1));
            refuses("newtons", () -> Joint.ball(peg, arm).breakAt(0, 1));
            refuses("length", () -> Joint.rod(peg, arm).length(-1));
            refuses("length 0", () -> world.add(Joint.rod(peg, arm).at(0, 5, 0)));
            refuses("null", () -> Joint.ball(null, arm));
            assertEquals(0, world.joints().count(), "nothing was added");
            world.step(STEP);
        }
    }

    /** A joint whose anchors are 100 m apart draws its bodies together, and nothing explodes. */
    @Test
    void farAnchorsAreDrawnTogether() {
        try (PhysicsWorld world = world()) {
            world.setGravity(0, 0, 0);
            BodyRef a = world.add(Body.dynamic().shape(Sphere.of(0.2)));
            BodyRef b = world.add(Body.dynamic().shape(Sphere.of(0.2)).at(100, 0, 0));
            JointRef joint = world.add(Joint.ball(a, b).anchors(0, 0.2, 0, 100, -0.2, 0.1));
            double gap = joint.gap();
            for (int tick = 0; tick < 120; tick++) {
                world.step(STEP);
                double now = joint.gap();
                boolean isSlow = gap - now < 3 * STEP + 1e-6;
                assertTrue(now < gap + 1e-6 && isSlow, "gap " + now + " in tick " + tick);
                gap = now;
                assertTrue(world.kineticEnergy() < 50 * a.mass(), "energy");
            }
            assertTrue(gap < 95, "it comes nearer: " + gap);
        }
    }

    /** Rods of 1 and 1 m between posts that are 3 m apart: told by the gap, bounded, and still. */
    @Test
    void loopsThatCannotCloseAreTold() {
        try (PhysicsWorld world = world()) {
            BodyRef left = world.add(Body.fixed().shape(Sphere.of(0.05)).at(-1.5, 5, 0));
            BodyRef right = world.add(Body.fixed().shape(Sphere.of(0.05)).at(1.5, 5, 0));
            BodyRef ball = world.add(Body.dynamic().shape(Sphere.of(0.2)).mass(1).at(0.1, 5, 0));
            JointRef one = world.add(Joint.rod(left, ball).length(1));
            JointRef two = world.add(Joint.rod(right, ball).length(1));
            BodyRef square =
                    world.add(Body.dynamic().shape(Box.ofHalfExtents(0.5, 0.1, 0.1)).at(0, 8, 0));
            world.add(Joint.ball(left, square).anchors(-1.5, 5, 0, -0.5, 8, 0));
            world.add(Joint.ball(right, square).anchors(1.5, 5, 0, 0.5, 8, 0));
            for (int tick = 0; tick < 600; tick++) {
                world.step(STEP);
                double speed = ball.velocity(new Vector3d()).length();
                assertTrue(speed < 10, "speed " + speed + " in tick " + tick);
            }
            assertEquals(1, one.gap() + two.gap(), 0.05, "what lacks is told");
            double force = one.force(new Vector3d()).length();
            assertTrue(force < 1e7, "force " + force);
            assertTrue(square.velocity(new Vector3d()).length() < 10, "the square rests");
        }
    }

    /** A hub with very many arms is held, and takes no more than a hub's share to a joint. */
    @Test
    void thousandsOfJointsOnOneBody() {
        try (PhysicsWorld world = world()) {
            world.setGravity(0, -G, 0);
            BodyRef hub = world.add(Body.dynamic().shape(Sphere.of(1)).mass(1000).at(0, 5, 0));
            world.add(Joint.ball(peg(world), hub).at(0, 7, 0));
            int n = 10_000;
            double golden = Math.PI * (3 - Math.sqrt(5));
            for (int k = 0; k < n; k++) {
                double y = 1 - 2 * (k + 0.5) / n;
                double r = Math.sqrt(1 - y * y);
                double x = r * StrictMath.cos(golden * k);
                double z = r * StrictMath.sin(golden * k);
                BodyRef leaf =
                        world.add(
                                Body.dynamic()
                                        .shape(Sphere.of(0.01))
                                        .mass(0.01)
                                        .at(2 * x, 5 + 2 * y, 2 * z));
                world.add(Joint.ball(hub, leaf).at(x, 5 + y, z));
            }
            hub.setAngularVelocity(0, 0.2, 0);
            for (int tick = 0; tick < 3; tick++) {
                world.step(STEP);
            }
            double worst = 0;
            for (JointRef j : world.joints().all()) {
                worst = Math.max(worst, j.gap());
            }
            assertEquals(0, worst, 1e-9, "a joint opens");
            assertFalse(Double.isNaN(hub.position(new Vector3d()).y));
        }
    }
}
