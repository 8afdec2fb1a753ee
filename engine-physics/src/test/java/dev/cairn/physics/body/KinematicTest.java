package dev.cairn.physics.body;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Contacts;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.PhysicsWorldBuilder;
import dev.cairn.physics.component.Velocity;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** Kinematic bodies go where they are told, and take along what stands on them. */
class KinematicTest {
    private static final double STEP = 1.0 / 60;
    private static final double HALF = 0.25;

    private static PhysicsWorldBuilder awake(int workers, int lanes) {
        return PhysicsWorld.builder()
                .workers(workers)
                .settings(PhysicsSettings.DEFAULT.withSleeping(false).withLanes(lanes));
    }

    private static BodyRef platform(PhysicsWorld world) {
        return world.add(Body.kinematic().shape(Box.ofHalfExtents(2, 0.1, 2)).name("platform"));
    }

    private static BodyRef rider(PhysicsWorld world) {
        return world.add(
                Body.dynamic()
                        .shape(Box.cubeOfHalfExtent(HALF))
                        .at(0, 0.1 + HALF, 0)
                        .name("rider"));
    }

    @ParameterizedTest
    @CsvSource({
        "1, 0, 0, 0",
        "3, 0, 0, 0",
        "40, 0, 9, 0",
        "0, 2, 0, 0",
        "0, -2, 0, 0",
        "1, 1, -1, 0",
        "40, 0, 9, 4"
    })
    void whoRidesAtThePlatformsSpeedKeepsHisPlace(double vx, double vy, double vz, int lanes) {
        try (PhysicsWorld world = awake(1, Math.max(1, lanes)).build()) {
            BodyRef platform = platform(world);
            List<BodyRef> riders = new ArrayList<>(List.of(rider(world)));
            for (int k = 0; k < 3; k++) {
                Body box = Body.dynamic().shape(Box.cubeOfHalfExtent(HALF));
                riders.add(world.add(box.at(1, 0.1 + HALF * (1 + 2 * k), 0)));
            }
            Vector3d[] start = riders.stream().map(BodyRef::position).toArray(Vector3d[]::new);
            platform.setVelocity(vx, vy, vz);
            riders.forEach(rider -> rider.setVelocity(vx, vy, vz));
            for (int tick = 1; tick <= 600; tick++) {
                world.step(STEP);
                double t = tick * STEP;
                assertEquals(vx * t, platform.position().x, 1e-11);
                for (int k = 0; k < start.length; k++) {
                    Vector3d to = platform.position().add(start[k]);
                    assertEquals(0, to.distance(riders.get(k).position()), 1e-9, "rider " + k);
                }
            }
        }
    }

    /**
     * Friction holds up to 0.6 g = 5.9 m/s², and the foot of three boxes up to g/3. Rests that are
     * left at once, even pulls, and pulls that change all the time, along, up, and both.
     */
    @ParameterizedTest
    @CsvSource({
        "5, 0, 1, COSINE, 1",
        "0, 5, 1, COSINE, 1",
        "5, 0, 1, SINE, 4",
        "3, 3, 1, EVEN, 1",
        "2, 1, 3, COSINE, 1",
        "2, 1, 3, SINE, 8",
        "2, 1, 2, EVEN, 1"
    })
    void whoStandsOnAPlatformThatSpeedsUpIsTakenAlong(
            double x, double y, int boxes, String pull, int lanes) {
        try (PhysicsWorld world = awake(1, lanes).build()) {
            BodyRef platform = platform(world);
            List<BodyRef> riders = new ArrayList<>();
            for (int k = 0; k < boxes; k++) {
                Body box = Body.dynamic().shape(Box.cubeOfHalfExtent(HALF));
                riders.add(world.add(box.at(0, 0.1 + HALF * (1 + 2 * k), 0)));
            }
            Vector3d[] start = riders.stream().map(BodyRef::position).toArray(Vector3d[]::new);
            for (int tick = 1; tick <= 300; tick++) {
                double t = tick * STEP;
                // of x'' = 1, cos t, sin t
                double way =
                        switch (pull) {
                            case "EVEN" -> t * t / 2;
                            case "COSINE" -> 1 - StrictMath.cos(t);
                            default -> t - StrictMath.sin(t);
                        };
                platform.moveTo(x * way, y * way, 0);
                world.step(STEP);
                for (int k = 0; k < boxes; k++) {
                    Vector3d to = platform.position().add(start[k]);
                    double off = to.distance(riders.get(k).position());
                    assertEquals(0, off, 1e-9, "rider " + k + " in tick " + tick);
                }
            }
        }
    }

    /** Coulomb: at 8 m/s² it slips, and comes after with 0.6 g. */
    @Test
    void whoCannotBeHeldSlips() {
        try (PhysicsWorld world = awake(1, 1).build()) {
            BodyRef platform =
                    world.add(
                            Body.kinematic().shape(Box.ofHalfExtents(9, 0.1, 2)).name("platform"));
            Body flat = Body.dynamic().shape(Box.ofHalfExtents(0.5, 0.05, 0.5)).at(0, 0.15, 0);
            BodyRef rider = world.add(flat);
            for (int tick = 1; tick <= 60; tick++) {
                double t = tick * STEP;
                platform.moveTo(4 * t * t, 0, 0);
                world.step(STEP);
                // x = a t²/2; a sub-step h is gone at the speed of its end, a h t/2 at most ahead
                double ahead = 0.3 * 9.81 * t * STEP / 4;
                assertEquals(0.3 * 9.81 * t * t, rider.position().x, ahead);
                assertEquals(0.15, rider.position().y, 1e-3);
            }
        }
    }

    /** Riders that stand, lean and slip: the same bits for all workers and lanes. */
    @Tag("compiled")
    @Test
    void ridersAreTheSameForWorkersAndLanes() {
        Set<Long> digests = new HashSet<>();
        for (int lanes : new int[] {1, 4, 8}) {
            for (int workers = 1; workers <= 3; workers += 2) {
                try (PhysicsWorld world = awake(workers, lanes).build()) {
                    BodyRef platform =
                            world.add(Body.kinematic().shape(Box.ofHalfExtents(9, 0.1, 9)));
                    for (int i = 0; i < 60; i++) {
                        Material m = Material.DEFAULT.withFriction(i % 4 == 0 ? 0.05 : 0.6);
                        Body box = Body.dynamic().shape(Box.cubeOfHalfExtent(HALF)).material(m);
                        double y = 0.1 + HALF * (1 + 2 * (i / 36));
                        world.add(box.at(i % 6 - 2.5, y, i / 6 % 6 - 2.5));
                    }
                    for (int tick = 1; tick <= 60; tick++) {
                        double t = 3 * tick * STEP;
                        platform.moveTo(0.3 * (1 - StrictMath.cos(t)), 0.1 * StrictMath.sin(t), 0);
                        world.step(STEP);
                    }
                    world.validate();
                    digests.add(world.digest());
                }
            }
        }
        assertEquals(1, digests.size());
    }

    /** What rides far away costs a rider nothing: not a bit of its way. */
    @Test
    void whatRidesElsewhereDoesNotMatter() {
        long[] alone = wayOfRiders(0);
        long[] among = wayOfRiders(600);
        assertArrayEquals(alone, among);
    }

    private static long[] wayOfRiders(int others) {
        try (PhysicsWorld world = awake(1, 1).build()) {
            Body plate = Body.kinematic().shape(Box.ofHalfExtents(20, 0.1, 20));
            List<BodyRef> plates = List.of(world.add(plate), world.add(plate.at(100, 0, 0)));
            List<BodyRef> riders = new ArrayList<>();
            Body box = Body.dynamic().shape(Box.cubeOfHalfExtent(HALF));
            for (int k = 0; k < 3; k++) {
                riders.add(world.add(box.at(0.05 * k, 0.1 + HALF * (1 + 2 * k), 0)));
            }
            for (int i = 0; i < others; i++) {
                world.add(box.at(90 + i % 30 * 0.7, 0.1 + HALF, i / 30 * 0.7 - 9));
            }
            long[] way = new long[3 * 40];
            for (int tick = 0; tick < 40; tick++) {
                double t = (tick + 1) * STEP;
                plates.get(0).moveTo(t * t, 0, 0);
                plates.get(1).moveTo(100 + t * t, 0, 0);
                world.step(STEP);
                for (int k = 0; k < 3; k++) {
                    way[3 * tick + k] = Double.doubleToLongBits(riders.get(k).position().x);
                }
            }
            return way;
        }
    }

    /** Between two targets at one speed, and a third: no velocity beyond those. */
    @Test
    void aSpeedThatJumpsJumps() {
        try (PhysicsWorld world = awake(1, 1).gravity(0, 0, 0).build()) {
            Material elastic = Material.DEFAULT.withRestitution(1).withFriction(0);
            Body racket = Body.kinematic().shape(Box.ofHalfExtents(0.1, 1, 1)).material(elastic);
            BodyRef hand = world.add(racket);
            Body ball = Body.dynamic().shape(Sphere.of(0.1)).at(0.23, 0, 0).material(elastic);
            BodyRef struck = world.add(ball);
            world.step(STEP);
            hand.moveTo(0.1, 0, 0);
            world.step(STEP);
            // v' = 2 V - v
            assertEquals(2 * 0.1 / STEP, struck.velocity().x, 1e-9);
        }
    }

    /** An even turn up: what lies at the axis turns with it. */
    @Test
    void aTurntableThatSpeedsUpTakesAlongWhatLiesAtItsAxis() {
        try (PhysicsWorld world = awake(1, 1).build()) {
            BodyRef table = platform(world);
            BodyRef box = rider(world);
            for (int tick = 1; tick <= 300; tick++) {
                double t = tick * STEP;
                table.moveTo(0, 0, 0, new Quaterniond().rotationY(t * t / 4));
                world.step(STEP);
                Quaterniond off = table.orientation().conjugate().mul(box.orientation());
                assertEquals(0, Math.hypot(off.x, Math.hypot(off.y, off.z)), 1e-9);
            }
        }
    }

    @Test
    void targetsAreReachedToTheBitAndHoldForOneTick() {
        try (PhysicsWorld world = awake(1, 1).build()) {
            BodyRef hand = world.add(Body.kinematic().shape(Box.cubeOfHalfExtent(1)).at(1, 2, 3));
            Quaterniond turned = new Quaterniond().rotationXYZ(0.3, -0.2, 0.1);
            hand.moveTo(1.1, 2.2, 3.3, turned);
            world.step(STEP);
            assertEquals(new Vector3d(1.1, 2.2, 3.3), hand.position());
            Quaterniond q = hand.orientation();
            assertEquals(0, Math.abs(q.dot(turned) - 1), 1e-15);
            assertEquals(0.1 / STEP, hand.velocity().x, 1e-12);
            assertEquals(
                    hand.velocity().x,
                    world.ecs().get(hand.entity(), Velocity.COMPONENT).vx(),
                    0.0);
            world.step(STEP);
            assertEquals(new Vector3d(1.1, 2.2, 3.3), hand.position());
            assertEquals(new Vector3d(), hand.velocity());
            assertEquals(q, hand.orientation());
            hand.setAngularVelocity(0, 2, 0);
            hand.moveTo(0, 0, 0, new Quaterniond());
            hand.teleport(5, 5, 5);
            world.step(STEP);
            assertEquals(5, hand.position().x, 0.0, "a teleport ends the target");
        }
    }

    /** dv/dt = 2/7 W x v, see the scene of the same name. */
    @Test
    void aBallOnATurntableCirclesAtTwoSeventhsOfItsRate() {
        double rate = 2;
        double slow = 2.0 / 7 * rate;
        try (PhysicsWorld world = awake(1, 1).build()) {
            Material rough = Material.DEFAULT.withFriction(1);
            world.add(
                    Body.kinematic()
                            .shape(Box.ofHalfExtents(4, 0.1, 4))
                            .at(0, -0.1, 0)
                            .angularVelocity(0, rate, 0)
                            .material(rough));
            BodyRef ball =
                    world.add(
                            Body.dynamic()
                                    .shape(Sphere.of(0.1))
                                    .at(1, 0.1, 0)
                                    .velocity(0, 0, -slow)
                                    .angularVelocity((rate - slow) / 0.1, 0, 0)
                                    .material(rough));
            double angle = 0;
            double last = 0;
            int ticks = (int) (2 * 2 * Math.PI / slow / STEP);
            for (int tick = 0; tick < ticks; tick++) {
                world.step(STEP);
                double now = StrictMath.atan2(-ball.position().z, ball.position().x);
                double turned = now - last;
                angle += turned - 2 * Math.PI * Math.rint(turned / (2 * Math.PI));
                last = now;
            }
            assertEquals(1, angle / (slow * ticks * STEP), 1e-4);
            assertEquals(1, Math.hypot(ball.position().x, ball.position().z), 0.03);
        }
    }

    @Test
    void aWallDoesNotStopItAndWhatIsCrushedStaysFinite() {
        try (PhysicsWorld world = awake(1, 1).build()) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(0.5, 2, 2)).at(2, 0, 0));
            world.add(Body.fixed().shape(Box.ofHalfExtents(9, 0.5, 9)).at(0, -0.5, 0));
            BodyRef press =
                    world.add(
                            Body.kinematic()
                                    .shape(Box.ofHalfExtents(1, 0.5, 1))
                                    .at(-2, 0.5, 0)
                                    .velocity(1, 0, 0));
            BodyRef box = world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)).at(0, 0.5, 0));
            boolean told = false;
            double largest = 0;
            for (int tick = 1; tick <= 300; tick++) {
                world.step(STEP);
                assertEquals(-2 + tick * STEP, press.position().x, 1e-12);
                assertTrue(box.position().isFinite());
                told |= world.crushed().contains(box);
                if (tick < 55) {
                    assertEquals(List.of(), world.crushed());
                }
                Contacts contacts = world.contacts();
                for (int c = 0; c < contacts.count(); c++) {
                    for (int p = 0; p < contacts.pointCount(c); p++) {
                        largest = Math.max(largest, contacts.normalImpulse(c, p));
                    }
                }
            }
            assertTrue(told, "the box was between press and wall");
            // 1000 kg between 1 m/s and a wall
            assertTrue(largest < 1e6, "impulse " + largest);
            assertEquals(List.of(), world.quarantined());
        }
    }

    @Test
    void whatItHitsLeavesAtTheSpeedOfItsSurface() {
        try (PhysicsWorld world = awake(1, 1).gravity(0, 0, 0).build()) {
            Material elastic = Material.DEFAULT.withRestitution(1).withFriction(0);
            world.add(
                    Body.kinematic()
                            .shape(Box.ofHalfExtents(0.1, 1, 1))
                            .velocity(2, 0, 0)
                            .material(elastic));
            BodyRef ball =
                    world.add(
                            Body.dynamic()
                                    .shape(Sphere.of(0.1))
                                    .at(1, 0, 0)
                                    .velocity(-1, 0, 0)
                                    .material(elastic));
            for (int tick = 0; tick < 60; tick++) {
                world.step(STEP);
            }
            // v' = 2 V - v
            assertEquals(5, ball.velocity().x, 1e-9);
        }
    }

    @Test
    void whatRestsOnASlowOneStaysAwakeAndWakesWhenItStarts() {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            BodyRef platform = platform(world);
            BodyRef rider = rider(world);
            for (int tick = 0; tick < 300; tick++) {
                world.step(STEP);
            }
            assertTrue(rider.isAsleep(), "on a platform that stands still");
            assertFalse(platform.isAsleep());
            platform.setVelocity(1e-4, 0, 0);
            for (int tick = 0; tick < 300; tick++) {
                world.step(STEP);
                assertFalse(rider.isAsleep(), "on one that creeps");
            }
            assertEquals(platform.position().x, rider.position().x, 1e-6);
            world.validate();
        }
    }

    @Tag("compiled")
    @ParameterizedTest
    @CsvSource({"2, 1", "2, 8", "3, 0"})
    void theSameBitsForAnyWorkersAndLanes(int workers, int lanes) {
        assertEquals(crowd(1, 1), crowd(workers, lanes));
    }

    /** A paddle in a heap on a turntable, a lift under another heap, small islands beside. */
    private static long crowd(int workers, int lanes) {
        try (PhysicsWorld world = awake(workers, lanes).build()) {
            world.add(Body.fixed().shape(Box.ofHalfExtents(40, 0.5, 40)).at(0, -3, 0));
            world.add(
                    Body.kinematic()
                            .shape(Box.ofHalfExtents(3, 0.1, 3))
                            .angularVelocity(0, 1, 0)
                            .at(0, -0.1, 0));
            BodyRef lift =
                    world.add(Body.kinematic().shape(Box.ofHalfExtents(2, 0.1, 2)).at(8, 0, 0));
            for (int i = 0; i < 90; i++) {
                double x = 0.6 * (i % 5) - 1.2;
                double z = 0.6 * (i / 5 % 5) - 1.2;
                double y = 0.3 + 0.55 * (i / 25);
                Body body =
                        Body.dynamic()
                                .shape(i % 3 == 0 ? Sphere.of(0.25) : Box.cubeOfHalfExtent(0.25));
                Material m = Material.DEFAULT.withRestitution(i % 4 == 0 ? 0.5 : 0);
                world.add(body.material(m).at(x + (i % 2 == 0 ? 0 : 8), y, z));
            }
            for (int tick = 1; tick <= 60; tick++) {
                lift.moveTo(8, 0.3 * StrictMath.sin(tick * 0.1), 0);
                world.step(STEP);
            }
            world.validate();
            return world.digest();
        }
    }

    @Test
    void whatCannotBeIsRefused() {
        try (PhysicsWorld world = awake(1, 1).build()) {
            BodyRef box = world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(1)));
            BodyRef hand = world.add(Body.kinematic().shape(Box.cubeOfHalfExtent(1)).at(5, 0, 0));
            assertThrows(IllegalStateException.class, () -> box.moveTo(0, 0, 0));
            assertThrows(IllegalArgumentException.class, () -> hand.moveTo(Double.NaN, 0, 0));
            assertThrows(IllegalArgumentException.class, () -> hand.setVelocity(1e60, 0, 0));
            assertThrows(
                    IllegalArgumentException.class,
                    () ->
                            world.add(
                                    Body.kinematic()
                                            .shape(Box.cubeOfHalfExtent(1))
                                            .velocity(0, 1e300, 0)));
            assertThrows(IllegalArgumentException.class, () -> hand.moveTo(null));
            assertThrows(IllegalStateException.class, () -> hand.applyForce(1, 2, 3));
            assertThrows(IllegalStateException.class, () -> hand.applyImpulse(1, 2, 3));
            world.step(STEP);
            assertEquals(new Vector3d(5, 0, 0), hand.position());
            assertEquals(Double.POSITIVE_INFINITY, hand.mass());
        }
    }

    /** Two presses close in on a box, pass the place where it fits, and part again. */
    @ParameterizedTest
    @CsvSource({"0.2, 1", "1, 1", "1, 4", "10, 1", "50, 8"})
    void aBoxBetweenTwoPressesGetsABoundedImpulse(double speed, int lanes) {
        try (PhysicsWorld world = awake(1, lanes).gravity(0, 0, 0).build()) {
            Body press = Body.kinematic().shape(Box.ofHalfExtents(0.5, 2, 2));
            BodyRef left = world.add(press.at(-1.5, 0, 0).velocity(speed, 0, 0));
            BodyRef right = world.add(press.at(1.5, 0, 0).velocity(-speed, 0, 0));
            BodyRef box = world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)));
            int closing = (int) Math.max(1, 0.8 / speed / STEP);
            boolean told = false;
            for (int tick = 0; tick < 2 * closing + 30; tick++) {
                if (tick == closing) {
                    left.setVelocity(-speed, 0, 0);
                    right.setVelocity(speed, 0, 0);
                }
                world.step(STEP);
                world.validate();
                assertEquals(-left.position().x, right.position().x, 1e-9);
                assertTrue(box.position().isFinite(), "tick " + tick);
                told |= world.crushed().contains(box);
                Contacts contacts = world.contacts();
                for (int c = 0; c < contacts.count(); c++) {
                    for (int p = 0; p < contacts.pointCount(c); p++) {
                        double impulse = contacts.normalImpulse(c, p);
                        // of one point in a tick, whatever the speed of the presses
                        assertTrue(impulse < 250 * box.mass(), "impulse " + impulse);
                    }
                }
            }
            assertTrue(told, "the box was crushed");
            assertEquals(List.of(), world.crushed());
            assertEquals(List.of(), world.quarantined());
            assertTrue(box.velocity().length() < speed + 20, "let go at " + box.velocity());
        }
    }
}
