package dev.cairn.physics.motion;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.support.Scenes;

import org.joml.Vector3d;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.Random;

/** What crosses the seams of a floor does as on one plane; and a step that is one trips. */
class SeamTest {
    /** Vertical speed that a seam may give, m/s. */
    private static final double KICK = 1e-6;

    /** Other differences of velocity, m/s. */
    private static final double SPEED = 1e-6;

    private static final int TICKS = 60;

    private static double[] compare(
            TileRuns.Start start, TileRuns.Floor floor, TileRuns.Floor truth, int ticks) {
        double[] run = TileRuns.run(start, floor, ticks, Scenes.awake().workers(1));
        double[] slab = TileRuns.run(start, truth, ticks, Scenes.awake().workers(1));
        return TileRuns.differences(run, slab);
    }

    private static void check(String what, double[] d) {
        String found =
                String.format(
                        "%s: height %.1e, way %.1e, kick %.1e, speed %.1e, spin %.1e",
                        what, d[0], d[1], d[2], d[3], d[4]);
        assertTrue(d[2] < KICK, found);
        assertTrue(d[3] < SPEED, found);
    }

    @Test
    void everyShapeAtEverySpeedAsOnASlab() {
        for (String kind : TileRuns.KINDS) {
            for (double speed : new double[] {2, 5, 9, 20}) {
                TileRuns.Start start =
                        new TileRuns.Start(kind, .35, speed, .37, .2, 0, .1, .11, .23);
                TileRuns.Floor tiles = new TileRuns.Floor(.9, 0, 0, 0);
                check(
                        kind + " at " + speed + " m/s",
                        compare(start, tiles, new TileRuns.Floor(0, 0, 0, 0), 90));
            }
        }
    }

    @Test
    void alongASeamAndOverCorners() {
        for (String kind : TileRuns.KINDS) {
            for (double heading : new double[] {0, Math.PI / 4, Math.PI / 2}) {
                for (double z : new double[] {0, 1e-9, -1e-4, .3}) {
                    TileRuns.Start start =
                            new TileRuns.Start(kind, .3, 4, heading, 0, 0, .05, 0, z);
                    check(
                            kind + " heading " + heading + " from " + z,
                            compare(
                                    start,
                                    new TileRuns.Floor(.6, 0, 0, 0),
                                    new TileRuns.Floor(TileRuns.PLANE, 0, 0, 0),
                                    TICKS));
                }
            }
        }
    }

    @Test
    void anyBodyOnAnyTiles() {
        search(0, 300);
    }

    @Test
    @Tag("soak")
    void anyBodyOnAnyTilesForLong() {
        search(1_000_000, 10_000);
    }

    private static void search(long first, int runs) {
        for (long seed = first; seed < first + runs; seed++) {
            Random random = Scenes.random(seed);
            TileRuns.Start start = any(random);
            double tile = tile(random, start);
            double far = random.nextInt(3) == 0 ? 1e4 : 0;
            double[] d =
                    compare(
                            start,
                            new TileRuns.Floor(tile, far, 0, -far / 3, bond(random)),
                            new TileRuns.Floor(TileRuns.PLANE, far, 0, -far / 3),
                            TICKS);
            check("seed " + seed + " " + start + " tiles " + tile, d);
        }
    }

    /** Any body, any speed from 1 to 20 m/s, any line of travel. */
    static TileRuns.Start any(Random random) {
        return new TileRuns.Start(
                TileRuns.KINDS[random.nextInt(TileRuns.KINDS.length)],
                .1 + .6 * random.nextDouble(),
                StrictMath.pow(20, random.nextDouble()),
                2 * Math.PI * random.nextDouble(),
                2 * Math.PI * random.nextDouble(),
                random.nextBoolean() ? 0 : 4 * random.nextDouble() - 2,
                random.nextInt(4) == 0 ? 0 : .5 * random.nextDouble(),
                random.nextDouble(),
                random.nextDouble());
    }

    /** Tiles in rows one behind the other, or shifted. */
    static double bond(Random random) {
        return random.nextBoolean() ? 0 : random.nextDouble();
    }

    /** A tile from 0.1 to 10 m, but not thousands of them. */
    static double tile(Random random, TileRuns.Start start) {
        double least = Math.max(.1, .02 * start.speed());
        return least * StrictMath.pow(10 / least, random.nextDouble());
    }

    /** A cube of 1 m at 3 m/s against a tile that is higher: it stops or is thrown. */
    @Test
    void aRealStepTrips() {
        for (double step : new double[] {2e-3, .01, .1}) {
            try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
                Material ice = new Material(0, 0, 1000);
                for (int i = -2; i < 6; i++) {
                    double top = i >= 2 ? step : 0;
                    world.add(
                            Body.fixed()
                                    .shape(Box.ofHalfExtents(.5, .5, 2))
                                    .material(ice)
                                    .at(i, top - .5, 0));
                }
                BodyRef cube =
                        world.add(
                                Body.dynamic()
                                        .shape(Box.cubeOfHalfExtent(.5))
                                        .material(ice)
                                        .at(0, .5, 0)
                                        .velocity(3, 0, 0));
                for (int tick = 0; tick < 60; tick++) {
                    world.step(Scenes.STEP);
                }
                Vector3d at = cube.position();
                assertTrue(at.x < 2 && cube.velocity().x < 2, "step " + step + " m: " + at);
            }
        }
    }

    /** A ball rolls down from one level of tiles to the next, and does not fly on. */
    @Test
    void aStepDownIsFallenDown() {
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            for (int i = -2; i < 8; i++) {
                double top = i >= 2 ? -.2 : 0;
                world.add(Body.fixed().shape(Box.ofHalfExtents(.5, .5, 2)).at(i, top - .5, 0));
            }
            BodyRef ball =
                    world.add(
                            Body.dynamic()
                                    .shape(Sphere.of(.3))
                                    .at(0, .3, 0)
                                    .velocity(2, 0, 0)
                                    .angularVelocity(0, 0, -2 / .3));
            for (int tick = 0; tick < 120; tick++) {
                world.step(Scenes.STEP);
            }
            assertEquals(.1, ball.position().y, 1e-3);
        }
    }

    /** Any number of workers and lanes, the same bits. */
    @Tag("compiled")
    @Test
    void theSameBitsForWorkersAndLanes() {
        double[] truth = null;
        for (int workers = 1; workers <= 2; workers++) {
            for (int lanes : new int[] {1, 8}) {
                double[] run = crowd(workers, lanes);
                if (truth == null) {
                    truth = run;
                }
                assertArrayEquals(truth, run, workers + " workers, " + lanes + " lanes");
            }
        }
    }

    /** A world that is saved while bodies cross seams goes on with the same bits. */
    @Test
    void aSavedWorldGoesOnOverTheSeams() {
        TileRuns.Start start = new TileRuns.Start("cube", .3, 6, .4, .2, 1, .2, .1, .1);
        try (PhysicsWorld world = Scenes.awake().workers(1).build()) {
            TileRuns.floor(world, start, new TileRuns.Floor(.5, 0, 0, 0), 60);
            world.add(TileRuns.body(start, new TileRuns.Floor(.5, 0, 0, 0)));
            for (int tick = 0; tick < 25; tick++) {
                world.step(Scenes.STEP);
            }
            try (PhysicsWorld twin = world.fork()) {
                for (int tick = 0; tick < 25; tick++) {
                    world.step(Scenes.STEP);
                    twin.step(Scenes.STEP);
                    assertEquals(world.digest(), twin.digest(), "tick " + tick);
                }
            }
        }
    }

    private static double[] crowd(int workers, int lanes) {
        PhysicsSettings settings = PhysicsSettings.DEFAULT.withLanes(lanes);
        try (PhysicsWorld world = Scenes.awake().workers(workers).settings(settings).build()) {
            for (int i = -10; i < 10; i++) {
                for (int j = -10; j < 10; j++) {
                    world.add(
                            Body.fixed()
                                    .shape(Box.ofHalfExtents(.3, .3, .3))
                                    .at(.6 * i, -.3, .6 * j));
                }
            }
            Random random = new Random(7);
            BodyRef[] bodies = new BodyRef[40];
            for (int i = 0; i < bodies.length; i++) {
                bodies[i] = world.add(Scenes.any(random, i));
            }
            double[] all = new double[3 * bodies.length];
            for (int tick = 0; tick < 90; tick++) {
                world.step(Scenes.STEP);
            }
            for (int i = 0; i < bodies.length; i++) {
                Vector3d p = bodies[i].position();
                all[3 * i] = p.x;
                all[3 * i + 1] = p.y;
                all[3 * i + 2] = p.z;
            }
            return all;
        }
    }
}
