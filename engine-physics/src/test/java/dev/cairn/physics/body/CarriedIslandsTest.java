package dev.cairn.physics.body;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Cylinder;

import org.joml.Vector3d;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;

/**
 * Who is put down on a platform, at its velocity, keeps his place on it while friction allows:
 * whether it stands, starts in that tick, some ticks later, or has been under way for long.
 */
class CarriedIslandsTest {
    private static final double STEP = 1.0 / 60;
    private static final double G = 9.81;
    private static final int TICKS = 90;
    private static final double TURN = 24 * STEP;

    /** Of a platform, x''/a: 1; cos t; 1, then -1, then 0. */
    private enum Pull {
        EVEN,
        COSINE,
        STOPS;

        double way(double t) {
            double late = Math.max(0, t - TURN);
            return switch (this) {
                case EVEN -> t * t / 2;
                case COSINE -> 1 - StrictMath.cos(t);
                case STOPS -> late < TURN ? t * t / 2 - late * late : TURN * TURN;
            };
        }

        double speed(double t) {
            return switch (this) {
                case EVEN -> t;
                case COSINE -> StrictMath.sin(t);
                case STOPS -> Math.max(0, Math.min(t, 2 * TURN - t));
            };
        }
    }

    /** A platform that starts in a tick, and who is put down on it in another one. */
    private static final class Ride {
        final SplittableRandom r;
        final int start;
        final int put;
        final Pull pull;
        final double[] a = new double[3];
        final List<BodyRef> riders = new ArrayList<>();

        Ride(long seed, int storeys) {
            r = new SplittableRandom(seed);
            start = r.nextInt(20);
            put = r.nextInt(10) < 5 ? Math.max(0, start - r.nextInt(4)) : r.nextInt(40);
            pull = Pull.values()[r.nextInt(3)];
            double angle = r.nextDouble(2 * Math.PI);
            a[1] = r.nextInt(2) * r.nextDouble(-3, 4);
            // half of what friction bears; and n storeys tip at h/(n h), four of a hexagon's six
            // corners, which is what a contact has, at half of that
            double most = Math.min(0.3, 0.45 / storeys);
            double along = r.nextDouble(most) * (G - Math.abs(a[1]));
            a[0] = along * StrictMath.cos(angle);
            a[2] = along * StrictMath.sin(angle);
        }

        double way(int tick) {
            return pull.way(Math.max(0, tick - start) * STEP);
        }

        double speed(int tick) {
            return pull.speed(Math.max(0, tick - start) * STEP);
        }
    }

    private static Body plate(SplittableRandom r) {
        Body plate = Body.kinematic();
        int parts = r.nextInt(2) == 0 ? 1 : 4;
        for (int i = 0; i < parts; i++) {
            double x = parts == 1 ? 0 : 2 * i - 3;
            plate.collider(Collider.of(Box.ofHalfExtents(4.0 / parts, 0.1, 4)).at(x, 0, 0));
        }
        return plate;
    }

    /** All are of height 2 h, and as wide. */
    private static Body rider(SplittableRandom r, double h) {
        return switch (r.nextInt(4)) {
            case 0 -> Body.dynamic().shape(Cylinder.of(h, h));
            case 1 -> {
                List<Vector3d> corners = new ArrayList<>();
                for (int i = 0; i < 6; i++) {
                    double x = h * StrictMath.cos(i * Math.PI / 3);
                    double z = h * StrictMath.sin(i * Math.PI / 3);
                    corners.add(new Vector3d(x, -h, z));
                    corners.add(new Vector3d(x, h, z));
                }
                yield Body.dynamic().shape(ConvexHull.of(corners));
            }
            case 2 -> {
                Collider half = Collider.of(Box.ofHalfExtents(h / 2, h, h));
                yield Body.dynamic().collider(half.at(-h / 2, 0, 0)).collider(half.at(h / 2, 0, 0));
            }
            default -> Body.dynamic().shape(Box.cubeOfHalfExtent(h));
        };
    }

    /** Steps all ticks; returns the largest way that a rider is off his place, m. */
    private static double run(PhysicsWorld world, Ride ride, int most) {
        BodyRef platform = world.add(plate(ride.r));
        double h = ride.r.nextDouble(0.1, 0.4);
        List<Vector3d> places = new ArrayList<>();
        double off = 0;
        for (int tick = 0; tick < TICKS; tick++) {
            for (int k = tick == ride.put ? 1 + ride.r.nextInt(4) : 0; k > 0; k--) {
                double v = ride.speed(tick);
                for (int i = 0, storeys = 1 + ride.r.nextInt(most); i < storeys; i++) {
                    Vector3d at = new Vector3d(k - 2.5, 0.1 + h * (1 + 2 * i), k - 2.2);
                    Vector3d p = platform.position().add(at);
                    Body body = rider(ride.r, h).at(p.x, p.y, p.z);
                    body.velocity(v * ride.a[0], v * ride.a[1], v * ride.a[2]);
                    ride.riders.add(world.add(body));
                    places.add(at);
                }
            }
            double way = ride.way(tick + 1);
            platform.moveTo(way * ride.a[0], way * ride.a[1], way * ride.a[2]);
            world.step(STEP);
            for (int k = 0; k < places.size(); k++) {
                Vector3d to = platform.position().add(places.get(k));
                off = Math.max(off, to.distance(ride.riders.get(k).position()));
            }
        }
        return off;
    }

    private static PhysicsWorld world(int workers, int lanes) {
        return PhysicsWorld.builder()
                .workers(workers)
                .settings(PhysicsSettings.DEFAULT.withSleeping(false).withLanes(lanes))
                .build();
    }

    private static void ride(long seed, int most) {
        try (PhysicsWorld world = world(1, 1 + 3 * (int) (seed % 2))) {
            double off = run(world, new Ride(seed, most), most);
            assertEquals(0, off, 1e-9, "seed " + seed);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3})
    void whoIsPutDownKeepsHisPlace(int most) {
        for (long seed = 0; seed < 80; seed++) {
            ride(seed, most);
        }
    }

    @Tag("soak")
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3})
    void whoIsPutDownKeepsHisPlaceInAllRides(int most) {
        for (long seed = 80; seed < 1500; seed++) {
            ride(seed, most);
        }
    }

    @Tag("compiled")
    @Test
    void theSameBitsForWorkersAndLanes() {
        for (long seed = 0; seed < 2; seed++) {
            Set<Long> digests = new HashSet<>();
            for (int lanes : new int[] {1, 4, 8}) {
                for (int workers = 1; workers <= 3; workers += 2) {
                    try (PhysicsWorld world = world(workers, lanes)) {
                        run(world, new Ride(seed, 3), 3);
                        world.validate();
                        digests.add(world.digest());
                    }
                }
            }
            assertEquals(1, digests.size(), "seed " + seed);
        }
    }

    /** A floor that becomes kinematic under who rests on it: a copy of the world goes on alike. */
    @Test
    void aFloorThatBecomesAPlatformIsOneInACopyToo() {
        try (PhysicsWorld world = world(1, 1)) {
            BodyRef floor = world.add(Body.fixed().shape(Box.ofHalfExtents(9, .1, 9)));
            BodyRef box = world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(.3)).at(0, .41, 0));
            for (int tick = 0; tick < 60; tick++) {
                if (tick == 20) {
                    floor.setType(BodyType.KINEMATIC);
                }
                world.step(STEP);
            }
            try (PhysicsWorld copy = world.fork()) {
                for (int tick = 0; tick < 60; tick++) {
                    for (PhysicsWorld each : List.of(world, copy)) {
                        BodyRef platform = each.bodies().get(0);
                        if (tick > 20) {
                            platform.setVelocity(1, 0, 0);
                        }
                        each.step(STEP);
                    }
                    assertEquals(world.digest(), copy.digest(), "tick " + tick);
                }
            }
            assertEquals(.4, box.position().y, 1e-3);
        }
    }

    /** Speeds in multiples of what a rider is thick in a tick: nobody flies into the platform. */
    @ParameterizedTest
    @CsvSource({"-4, .05", "-8, .05", "-40, .1", "-100, .3", "8, .05", "100, .1"})
    void aFastLiftLosesNobody(double speed, double h) {
        for (int parts = 1; parts <= 2; parts++) {
            try (PhysicsWorld world = world(1, 1)) {
                Body plate = Body.kinematic().velocity(0, speed, 0);
                for (int i = 0; i < parts; i++) {
                    plate.collider(Collider.of(Box.ofHalfExtents(2, .1, 2)).at(4 * i, 0, 0));
                }
                BodyRef lift = world.add(plate);
                Body box = Body.dynamic().shape(Box.ofHalfExtents(.5, h, .5)).at(1, .1 + h, 0);
                BodyRef rider = world.add(box.velocity(0, speed, 0));
                for (int tick = 0; tick < 120; tick++) {
                    world.step(STEP);
                    Vector3d to = lift.position().add(1, .1 + h, 0);
                    assertEquals(0, to.distance(rider.position()), 1e-9, "tick " + tick);
                }
            }
        }
    }

    /** Up to Coulomb's bound: speeds up, slows down and stops at 0.95 mu g. */
    @ParameterizedTest
    @ValueSource(ints = {1, 3})
    void almostAllFrictionIsThere(int storeys) {
        double a = 0.95 * 0.6 * G / storeys;
        try (PhysicsWorld world = world(1, 1)) {
            BodyRef platform = world.add(Body.kinematic().shape(Box.ofHalfExtents(9, .1, 2)));
            List<BodyRef> riders = new ArrayList<>();
            for (int k = 0; k < storeys; k++) {
                Body box = Body.dynamic().shape(Box.ofHalfExtents(.4, .1, .4));
                riders.add(world.add(box.at(0, .2 + .2 * k, 0)));
            }
            for (int tick = 0; tick < TICKS; tick++) {
                platform.moveTo(a * Pull.STOPS.way((tick + 1) * STEP), 0, 0);
                world.step(STEP);
                for (int k = 0; k < storeys; k++) {
                    Vector3d to = platform.position().add(0, .2 + .2 * k, 0);
                    assertEquals(0, to.distance(riders.get(k).position()), 1e-9, "tick " + tick);
                }
            }
        }
    }
}
