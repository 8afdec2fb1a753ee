package dev.cairn.physics.contact;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.shape.TriangleMesh;
import dev.cairn.physics.support.Scenes;

import org.joml.Vector3d;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.Random;

/** Contacts act when bodies meet, and whoever meets is seen. */
class SweepTest {
    /** F7: a ball at 1 to 1000 m/s past the edge of a box, at a clearance. */
    @Test
    void whatPassesAtAClearanceIsNotDeflected() {
        double r = .1;
        for (double clearance : new double[] {1e-8, 1e-6, 1e-4, 1e-2}) {
            for (double speed : new double[] {2, 20, 100, 1000}) {
                for (int kind = 0; kind < 2; kind++) {
                    try (PhysicsWorld world = Scenes.awake().workers(1).gravity(0, 0, 0).build()) {
                        world.add(Body.fixed().shape(Box.ofHalfExtents(.5, .5, .5)).at(0, -.5, 0));
                        Shape shape = kind == 0 ? Sphere.of(r) : Box.cubeOfHalfExtent(r);
                        BodyRef body =
                                world.add(
                                        Body.dynamic()
                                                .shape(shape)
                                                .at(-.5 - .31 * speed / 60, r + clearance, .1)
                                                .velocity(speed, 0, .1 * speed));
                        for (int tick = 0; tick < 60; tick++) {
                            world.step(Scenes.STEP);
                        }
                        Vector3d v = body.velocity();
                        String what = "kind " + kind + ", " + clearance + " m, " + speed + " m/s";
                        assertEquals(0, v.y, 0, what);
                        assertEquals(speed, v.x, 0, what);
                    }
                }
            }
        }
    }

    /** How many of some pass a fixed wall. */
    static int through(Shape shape, double speed, double thick, double spin, int runs, long seed) {
        Shape wall = thick > 0 ? Box.ofHalfExtents(thick / 2, 50, 50) : sheet();
        int passed = 0;
        for (int i = 0; i < runs; i++) {
            Random random = Scenes.random(seed + i);
            try (PhysicsWorld world = Scenes.awake().workers(1).gravity(0, 0, 0).build()) {
                world.add(Body.fixed().shape(wall));
                BodyRef body =
                        world.add(
                                Body.dynamic()
                                        .shape(shape)
                                        .at(-2 - random.nextDouble() * speed / 60, .3, .2)
                                        .rotationAbout(
                                                random.nextDouble() - .5,
                                                random.nextDouble() - .5,
                                                random.nextDouble() - .5,
                                                6 * random.nextDouble())
                                        .angularVelocity(
                                                spin * (random.nextDouble() - .5),
                                                spin * (random.nextDouble() - .5),
                                                spin * (random.nextDouble() - .5))
                                        .velocity(speed, 0, 0));
                for (int tick = 0; tick < 4 + 120 / speed + 1; tick++) {
                    world.step(Scenes.STEP);
                    if (body.position().x > thick / 2) {
                        passed++;
                        break;
                    }
                }
            }
        }
        return passed;
    }

    /** A square of triangles in the plane x = 0, with its front towards -x. */
    private static Shape sheet() {
        int n = 10;
        double[] vertices = new double[3 * (n + 1) * (n + 1)];
        int[] indices = new int[6 * n * n];
        for (int i = 0; i < vertices.length / 3; i++) {
            vertices[3 * i + 1] = i / (n + 1) * 10 - 50;
            vertices[3 * i + 2] = i % (n + 1) * 10 - 50;
        }
        for (int k = 0; k < n * n; k++) {
            int corner = k / n * (n + 1) + k % n;
            int[] square = {
                corner, corner + n + 2, corner + n + 1, corner, corner + 1, corner + n + 2
            };
            System.arraycopy(square, 0, indices, 6 * k, 6);
        }
        return TriangleMesh.of(vertices, indices);
    }

    /**
     * Rods, plates, bricks and capsules, turned and spinning anyhow, against thick and thin walls.
     */
    @Test
    void nothingPassesAWall() {
        search(1, 5);
    }

    @Test
    @Tag("soak")
    void nothingPassesAWallForLong() {
        search(100_000, 1000);
    }

    private static void search(long seed, int runs) {
        Shape[] shapes = {
            Box.ofHalfExtents(.5, .02, .02),
            Box.ofHalfExtents(.5, .5, .005),
            Box.ofHalfExtents(.1, .05, .03),
            Capsule.of(.02, .4)
        };
        for (Shape shape : shapes) {
            for (double speed : new double[] {20, 100, 1000, 10_000}) {
                for (double spin : new double[] {0, 20, 200}) {
                    for (double thick : new double[] {.1, .001, 0}) {
                        assertEquals(
                                0,
                                through(shape, speed, thick, spin, runs, seed),
                                shape + " at " + speed + " m/s, " + spin + " rad/s, " + thick);
                    }
                }
            }
        }
    }

    /**
     * A stick lies before a wall, at rest; a heavy ball strikes it within a tick so that it is far
     * behind the wall at the tick's end, unless somebody looks at where it went.
     */
    @Test
    void whatIsStruckDoesNotPassEither() {
        for (Shape wall : new Shape[] {Box.ofHalfExtents(.005, 50, 50), sheet(), HalfSpace.of()}) {
            int passed = 0;
            for (int i = 0; i < 40; i++) {
                passed += struckPasses(wall, Scenes.random(500 + i)) ? 1 : 0;
            }
            assertEquals(0, passed, wall.toString());
        }
    }

    private static boolean struckPasses(Shape wall, Random random) {
        try (PhysicsWorld world = Scenes.awake().workers(1).gravity(0, 0, 0).build()) {
            world.add(Body.fixed().shape(wall));
            // towards the wall: along x, or down to what has no end
            boolean isDown = wall instanceof HalfSpace;
            Vector3d to = isDown ? new Vector3d(0, -1, 0) : new Vector3d(1, 0, 0);
            double before = 1.5 + random.nextDouble();
            double turn = random.nextDouble() - .5 + (isDown ? Math.PI / 2 : 0);
            BodyRef stick =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.ofHalfExtents(.02, .3, .02))
                                    .at(-before * to.x, -before * to.y, 0)
                                    .rotationAbout(0, 0, 1, turn));
            double far = 5 + random.nextDouble();
            double aside = .4 * random.nextDouble() - .2;
            double speed = 300 + 700 * random.nextDouble();
            world.add(
                    Body.dynamic()
                            .shape(Sphere.of(.3))
                            .mass(1000)
                            .at(-far * to.x - aside * to.y, -far * to.y + aside * to.x, 0)
                            .velocity(speed * to.x, speed * to.y, 0));
            boolean passes = false;
            for (int tick = 0; tick < 3; tick++) {
                world.step(Scenes.STEP);
                passes |= stick.position().dot(to) > .005;
            }
            return passes;
        }
    }

    /**
     * A rod that spins and meets a ball within a tick: with its own share of gravity it moves as in
     * a world that has that gravity.
     */
    @Test
    void aBodysOwnGravityIsAsThatOfTheWorld() {
        for (double share : new double[] {0, 2, -3, 100}) {
            for (int i = 0; i < 10; i++) {
                Vector3d own = rodAndBall(-9.81, share, Scenes.random(70 + i));
                Vector3d all = rodAndBall(-9.81 * share, 1, Scenes.random(70 + i));
                assertEquals(0, own.distance(all), 1e-9, "gravity times " + share + ", " + i);
            }
        }
        for (double share : new double[] {5, 30, 100}) {
            double own = dropped(-9.81, share);
            double all = dropped(-9.81 * share, 1);
            assertEquals(all, own, 1e-9, "dropped, gravity times " + share);
        }
    }

    /** How high a rod is that was dropped, at a slant, on a floor that it meets within a tick. */
    private static double dropped(double gravity, double share) {
        try (PhysicsWorld world = Scenes.awake().workers(1).gravity(0, gravity, 0).build()) {
            Material hard = new Material(0, .9, 1000);
            world.add(Body.fixed().shape(Box.ofHalfExtents(5, .01, 5)).material(hard));
            BodyRef rod =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.ofHalfExtents(.2, .01, .01))
                                    .at(0, .3, 0)
                                    .rotationAbout(0, 0, 1, .4)
                                    .gravityScale(share)
                                    .material(hard));
            for (int tick = 0; tick < 8; tick++) {
                world.step(Scenes.STEP);
            }
            return rod.position().y;
        }
    }

    /** Where the ball is after a while. */
    private static Vector3d rodAndBall(double gravity, double share, Random random) {
        try (PhysicsWorld world = Scenes.awake().workers(1).gravity(0, gravity, 0).build()) {
            Material hard = new Material(0, 1, 1000);
            world.add(
                    Body.dynamic()
                            .shape(Box.ofHalfExtents(2, .02, .02))
                            .at(0, 0, 0)
                            .angularVelocity(0, 0, 100 + 50 * random.nextDouble())
                            .gravityScale(share)
                            .material(hard));
            BodyRef ball =
                    world.add(
                            Body.dynamic()
                                    .shape(Sphere.of(.1))
                                    .at(1 + .5 * random.nextDouble(), .6, 0)
                                    .gravityScale(share)
                                    .material(hard));
            for (int tick = 0; tick < 12; tick++) {
                world.step(Scenes.STEP);
            }
            return ball.position();
        }
    }

    /**
     * A body of two bars across each other that spins by two radians a tick: its contacts are those
     * of one moment, and its centre is in both.
     */
    @Test
    void bodiesOfSeveralShapesDoNotPassEither() {
        Shape[] walls = {Box.ofHalfExtents(.005, 50, 50), sheet(), HalfSpace.of()};
        for (Shape wall : walls) {
            int passed = 0;
            for (int i = 0; i < 100; i++) {
                passed += crossPasses(wall, Scenes.random(900 + i)) ? 1 : 0;
            }
            assertEquals(0, passed, wall.toString());
        }
    }

    private static boolean crossPasses(Shape wall, Random random) {
        try (PhysicsWorld world = Scenes.awake().workers(1).gravity(0, 0, 0).build()) {
            world.add(Body.fixed().shape(wall));
            boolean isDown = wall instanceof HalfSpace;
            Vector3d to = isDown ? new Vector3d(0, -1, 0) : new Vector3d(1, 0, 0);
            double before = .2 + .3 * random.nextDouble();
            double speed = 3 + 60 * random.nextDouble();
            double spin = 130;
            BodyRef cross =
                    world.add(
                            Body.dynamic()
                                    .collider(Collider.of(Box.ofHalfExtents(.06, .01, .01)))
                                    .collider(Collider.of(Box.ofHalfExtents(.01, .06, .01)))
                                    .at(-before * to.x, -before * to.y, 0)
                                    .velocity(speed * to.x, speed * to.y, 0)
                                    .angularVelocity(
                                            spin * (2 * random.nextDouble() - 1),
                                            spin * (2 * random.nextDouble() - 1),
                                            spin * (2 * random.nextDouble() - 1)));
            boolean passes = false;
            for (int tick = 0; tick < 20; tick++) {
                world.step(Scenes.STEP);
                passes |= cross.position().dot(to) > .005;
            }
            return passes;
        }
    }

    /** Fast bodies in a box: the same bits for any number of workers. */
    @Tag("compiled")
    @Test
    void theSameBitsForWorkers() {
        assertEquals(box(1, 1), box(2, 8));
    }

    private static long box(int workers, int lanes) {
        PhysicsSettings settings = PhysicsSettings.DEFAULT.withLanes(lanes);
        try (PhysicsWorld world = Scenes.awake().workers(workers).settings(settings).build()) {
            for (int side = -1; side <= 1; side += 2) {
                world.add(Body.fixed().shape(Box.ofHalfExtents(.005, 3, 3)).at(3 * side, 0, 0));
                world.add(Body.fixed().shape(Box.ofHalfExtents(3, .005, 3)).at(0, 3 * side, 0));
                world.add(Body.fixed().shape(Box.ofHalfExtents(3, 3, .005)).at(0, 0, 3 * side));
            }
            Random random = new Random(3);
            for (int i = 0; i < 30; i++) {
                world.add(
                        Scenes.any(random, i)
                                .at(
                                        4 * random.nextDouble() - 2,
                                        4 * random.nextDouble() - 2,
                                        4 * random.nextDouble() - 2)
                                .velocity(300 * random.nextGaussian(), 100, 50));
            }
            for (int tick = 0; tick < 60; tick++) {
                world.step(Scenes.STEP);
            }
            return world.digest();
        }
    }
}
