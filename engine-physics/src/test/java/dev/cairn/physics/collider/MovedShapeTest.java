package dev.cairn.physics.collider;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Cone;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.HeightField;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.shape.TriangleMesh;
import dev.cairn.physics.support.Scenes;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/**
 * A shape that is moved in its body, where the body is placed so that the shape is where it was: it
 * touches with the same surface, so the truths of the shape itself hold to the same error.
 */
class MovedShapeTest {
    private static final double TICK = 1 / 60.0;
    private static final double G = 9.81;
    private static final double RADIUS = 0.1;

    /** Tip to centre of mass of a top, m, and its moments, kg m². */
    private static final double LENGTH = 0.1;

    private static final double INERTIA = 0.0025;

    /** How a shape is moved in its body. */
    enum Move {
        NOT(0, 0, 0, new Quaterniond()),
        SHIFTED(0.3, -0.2, 0.1, new Quaterniond()),
        TURNED(0.3, -0.2, 0.1, new Quaterniond().rotationYXZ(0.4, 1.1, -0.7));
        private final double x, y, z;
        private final Quaterniond turn;

        Move(double x, double y, double z, Quaterniond turn) {
            this.x = x;
            this.y = y;
            this.z = z;
            this.turn = turn;
        }

        Shape shape(Shape shape) {
            return shape.moved(x, y, z, turn);
        }

        /** A body whose shape is at a place, turned by {@code q}. */
        Body body(Shape shape, double px, double py, double pz, Quaterniond q) {
            Quaterniond body = q.mul(turn.conjugate(new Quaterniond()), new Quaterniond());
            Vector3d shift = body.transform(new Vector3d(x, y, z));
            return Body.dynamic()
                    .shape(shape(shape))
                    .at(px - shift.x, py - shift.y, pz - shift.z)
                    .rotation(body);
        }

        Body body(Shape shape, double px, double py, double pz) {
            return body(shape, px, py, pz, new Quaterniond());
        }

        /** Where the y axis of the shape points. */
        Vector3d axis(BodyRef ref) {
            return ref.orientation().mul(turn).transform(new Vector3d(0, 1, 0));
        }
    }

    private static PhysicsWorld world(double gx, double gy) {
        return PhysicsWorld.builder()
                .gravity(gx, gy, 0)
                .workers(1)
                .settings(PhysicsSettings.DEFAULT.withRestitutionThreshold(0).withSleeping(false))
                .build();
    }

    private static Material surface(double friction, double restitution) {
        return new Material(friction, restitution, 1000);
    }

    private static void floor(PhysicsWorld world, Material surface) {
        world.add(Body.fixed().shape(Box.ofHalfExtents(50, 1, 50)).at(0, -1, 0).material(surface));
    }

    private static void run(PhysicsWorld world, int ticks) {
        for (int tick = 0; tick < ticks; tick++) {
            world.step(TICK);
        }
    }

    @Test
    void aMoveThatChangesNothingIsTheShapeItself() {
        List<Shape> all = new ArrayList<>(List.of(Scenes.kinds()));
        all.add(HeightField.of(2, 2, 1, 1, new double[] {0, 1, 2, 0}));
        all.add(TriangleMesh.of(new double[] {0, 0, 0, 0, 0, 1, 1, 0, 0}, new int[] {0, 1, 2}));
        for (Class<?> kind : Shape.class.getPermittedSubclasses()) {
            // a half-space has no place in a body
            assertTrue(
                    kind == HalfSpace.class || all.stream().anyMatch(kind::isInstance),
                    kind.getSimpleName());
        }
        for (Shape shape : all) {
            assertSame(shape, shape.moved(0, 0, 0, new Quaterniond()));
        }
    }

    /** A world of all kinds; what is shifted by nothing, or there and back, has the same bits. */
    @Test
    void worldsOfShapesMovedByNothingHaveTheirDigests() {
        long[] digests = new long[3];
        for (int way = 0; way < digests.length; way++) {
            try (PhysicsWorld world = world(0, -G)) {
                world.add(Body.fixed().shape(HalfSpace.of()));
                Random random = new Random(5);
                Shape[] kinds = Scenes.kinds();
                for (int i = 0; i < 3 * kinds.length; i++) {
                    Shape kind = kinds[i % kinds.length];
                    Shape shape =
                            switch (way) {
                                case 0 -> kind;
                                case 1 -> kind.moved(0, 0, 0, new Quaterniond());
                                default ->
                                        kind.moved(0.5, 0, 2, new Quaterniond())
                                                .moved(-0.5, 0, -2, new Quaterniond());
                            };
                    world.add(
                            Body.dynamic()
                                    .shape(shape)
                                    .at(0.3 * (i % 5), 1 + 0.7 * (i / 3), 0.2 * (i % 2))
                                    .rotationAbout(1, random.nextDouble(), 0, random.nextDouble()));
                }
                run(world, 90);
                digests[way] = world.digest();
            }
        }
        assertEquals(digests[0], digests[1], "moved by nothing");
        assertEquals(digests[0], digests[2], "moved there and back");
    }

    @ParameterizedTest
    @EnumSource(Move.class)
    void ballsPlayBilliards(Move move) {
        Random random = new Random(3);
        for (int n = 0; n < 20; n++) {
            double speed = 5 + 20 * random.nextDouble();
            double miss = 1.9 * RADIUS * random.nextDouble();
            double gap = 0.2 + 0.1 * random.nextDouble();
            try (PhysicsWorld world = world(0, 0)) {
                Sphere ball = Sphere.of(RADIUS);
                Body cue = move.body(ball, -gap - 2 * RADIUS, miss, 0).velocity(speed, 0, 0);
                BodyRef a = world.add(cue.mass(1).material(surface(0, 0.9)));
                BodyRef b = world.add(move.body(ball, 0, 0, 0).mass(3).material(surface(0, 0.9)));
                run(world, 12);
                double along = Math.sqrt(4 * RADIUS * RADIUS - miss * miss) / (2 * RADIUS);
                double aside = -miss / (2 * RADIUS);
                double impulse = 1.9 * speed * along / (1 + 1 / 3.0);
                double off =
                        b.velocity().distance(impulse * along / 3, impulse * aside / 3, 0)
                                + a.velocity()
                                        .distance(speed - impulse * along, -impulse * aside, 0);
                assertEquals(0, off, 1e-12 * speed, "miss " + miss);
            }
        }
    }

    @ParameterizedTest
    @EnumSource(Move.class)
    void newtonsCradlePassesItsSpeedOn(Move move) {
        try (PhysicsWorld world = world(0, 0)) {
            BodyRef[] balls = new BodyRef[5];
            for (int i = 0; i < balls.length; i++) {
                Body body = move.body(Sphere.of(RADIUS), 2 * RADIUS * i - (i == 0 ? 0.1 : 0), 0, 0);
                balls[i] = world.add(body.velocity(i == 0 ? 2 : 0, 0, 0).material(surface(0, 1)));
            }
            run(world, 30);
            for (int i = 0; i < balls.length; i++) {
                assertEquals(i == 4 ? 2 : 0, balls[i].velocity().x, 1e-12, "ball " + i);
            }
        }
    }

    @ParameterizedTest
    @EnumSource(Move.class)
    void aBallBouncesToItsHeight(Move move) {
        try (PhysicsWorld world = world(0, -G)) {
            floor(world, surface(0, 0.8));
            Body body = move.body(Sphere.of(RADIUS), 0, 1 + RADIUS, 0).material(surface(0, 0.8));
            BodyRef ball = world.add(body);
            run(world, 50);
            double v = ball.velocity().y;
            double height = ball.centreOfMass(new Vector3d()).y - RADIUS + v * v / (2 * G);
            assertEquals(0.64, height, 1e-12, "after one bounce");
        }
    }

    @ParameterizedTest
    @EnumSource(Move.class)
    void aBallRollsDownASlope(Move move) {
        double angle = StrictMath.toRadians(20);
        try (PhysicsWorld world = world(G * StrictMath.sin(angle), -G * StrictMath.cos(angle))) {
            floor(world, surface(0.6, 0));
            Body body = move.body(Sphere.of(RADIUS), 0, RADIUS, 0).material(surface(0.6, 0));
            BodyRef ball = world.add(body);
            run(world, 120);
            double truth = 0.5 * G * StrictMath.sin(angle) / 1.4 * 4;
            assertEquals(truth, ball.centreOfMass(new Vector3d()).x, 1e-9);
        }
    }

    private static Shape hull(int sides) {
        double[] corners = new double[3 * sides + 3];
        for (int i = 0; i < sides; i++) {
            double angle = 2 * Math.PI * i / sides;
            corners[3 * i] = 0.05 * StrictMath.cos(angle);
            corners[3 * i + 1] = LENGTH / 0.75;
            corners[3 * i + 2] = 0.05 * StrictMath.sin(angle);
        }
        return ConvexHull.of(corners);
    }

    /** A top of 1 kg on its tip in the origin: a hull, or a cone, which has its tip up. */
    private static BodyRef top(
            PhysicsWorld world, Move move, Shape shape, double tilt, Vector3d spin, Material m) {
        Vector3d axis = new Vector3d(StrictMath.sin(tilt), StrictMath.cos(tilt), 0);
        Vector3d v = spin.cross(new Vector3d(axis).mul(LENGTH), new Vector3d());
        boolean isCone = shape instanceof Cone;
        double up = isCone ? LENGTH / 1.5 : 0;
        Quaterniond q = new Quaterniond().rotationZ(isCone ? Math.PI - tilt : -tilt);
        return world.add(
                move.body(shape, up * axis.x, up * axis.y, 0, q)
                        .mass(1)
                        .inertia(INERTIA, INERTIA, INERTIA)
                        .angularVelocity(spin.x, spin.y, spin.z)
                        .velocity(v.x, v.y, v.z)
                        .material(m));
    }

    /** Largest change of the tilt of a top that precesses steadily, in two seconds, rad. */
    private static double precession(Move move, Shape shape, boolean onPlane) {
        double tilt = StrictMath.toRadians(30);
        double spin = 300;
        double a = (INERTIA + LENGTH * LENGTH) * StrictMath.cos(tilt);
        double b = INERTIA * spin;
        double rate = 2 * G * LENGTH / (b + Math.sqrt(b * b - 4 * a * G * LENGTH));
        Vector3d axis = new Vector3d(StrictMath.sin(tilt), StrictMath.cos(tilt), 0);
        Vector3d w = new Vector3d(0, rate, 0).fma(spin - rate * StrictMath.cos(tilt), axis);
        try (PhysicsWorld world = world(0, -G)) {
            if (onPlane) {
                world.add(Body.fixed().shape(HalfSpace.of()).material(surface(1, 0)));
            } else {
                floor(world, surface(1, 0));
            }
            BodyRef top = top(world, move, shape, tilt, w, surface(1, 0));
            double worst = 0;
            for (int tick = 0; tick < 120; tick++) {
                world.step(TICK);
                double up = Math.abs(move.axis(top).y);
                worst = Math.max(worst, Math.abs(StrictMath.acos(up) - tilt));
            }
            return worst;
        }
    }

    @ParameterizedTest
    @EnumSource(Move.class)
    void aHeavyTopKeepsItsTilt(Move move) {
        for (Shape shape : new Shape[] {hull(16), Cone.of(0.05, LENGTH / 1.5)}) {
            for (boolean onPlane : new boolean[] {false, true}) {
                double itself = precession(Move.NOT, shape, onPlane);
                assertTrue(itself < 2e-4, () -> "tilt off by " + itself);
                assertEquals(itself, precession(move, shape, onPlane), 1e-12, shape.toString());
            }
        }
    }

    /** Energy of a top whose tip slips, after each tick of two seconds, J. */
    private static double[] slips(Move move) {
        try (PhysicsWorld world = world(0, -G)) {
            floor(world, surface(0.3, 0));
            Vector3d spin = new Vector3d(StrictMath.sin(0.5236), StrictMath.cos(0.5236), 0).mul(40);
            BodyRef top = top(world, move, hull(16), 0.5236, spin, surface(0.3, 0));
            double[] energy = new double[120];
            for (int tick = 0; tick < energy.length; tick++) {
                energy[tick] = world.kineticEnergy() + G * top.centreOfMass(new Vector3d()).y;
                world.step(TICK);
            }
            return energy;
        }
    }

    @ParameterizedTest
    @EnumSource(Move.class)
    void aSlippingTopGainsNoEnergy(Move move) {
        double[] energy = slips(move);
        double least = energy[0];
        for (int tick = 0; tick < energy.length; tick++) {
            least = Math.min(least, energy[tick]);
            assertTrue(energy[tick] <= least + 1e-3 * energy[0], "gains at tick " + tick);
        }
        assertTrue(least < 0.95 * energy[0], "it must slip");
        assertArrayEquals(slips(Move.NOT), energy, 1e-11);
    }

    /**
     * A coin of 32 sides slides and spins: velocity and spin after each tick. It is turned a little
     * from where its corners mirror each other: there rounding decides which four points hold it.
     */
    private static double[] coin(Move move) {
        int sides = 32;
        double[] corners = new double[6 * sides];
        for (int i = 0; i < 2 * sides; i++) {
            double a = 2 * Math.PI * (i / 2 + 0.5) / sides;
            corners[3 * i] = RADIUS * StrictMath.cos(a);
            corners[3 * i + 1] = i % 2 == 0 ? -0.01 : 0.01;
            corners[3 * i + 2] = RADIUS * StrictMath.sin(a);
        }
        try (PhysicsWorld world = world(0, -G)) {
            floor(world, surface(0.3, 0));
            BodyRef coin =
                    world.add(
                            move.body(
                                            ConvexHull.of(corners),
                                            0,
                                            0.01,
                                            0,
                                            new Quaterniond().rotationY(0.05))
                                    .velocity(1, 0, 0)
                                    .angularVelocity(0, 1 / RADIUS, 0)
                                    .material(surface(0.3, 0)));
            double[] state = new double[60];
            for (int tick = 0; tick < 20; tick++) {
                world.step(TICK);
                state[3 * tick] = coin.velocity().x;
                state[3 * tick + 1] = coin.velocity().z;
                state[3 * tick + 2] = RADIUS * coin.angularVelocity().y;
            }
            return state;
        }
    }

    @ParameterizedTest
    @EnumSource(Move.class)
    void aCoinSlidesAndSpins(Move move) {
        assertArrayEquals(coin(Move.NOT), coin(move), 1e-12);
    }
}
