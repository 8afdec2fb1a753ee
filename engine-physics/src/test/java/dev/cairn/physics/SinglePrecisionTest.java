package dev.cairn.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.support.Scenes;
import dev.cairn.physics.tuning.Precision;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/**
 * Contacts in single precision: what they may not touch keeps its bits, what they hold is held, and
 * nothing in them depends on the size of the numbers.
 */
class SinglePrecisionTest {
    private static final long SEED = 20;

    private static PhysicsWorld world(Precision precision, int lanes) {
        PhysicsSettings settings =
                PhysicsSettings.DEFAULT.withPrecision(precision).withLanes(lanes);
        return PhysicsWorld.builder()
                .gravity(0, -10, 0)
                .workers(1)
                .settings(settings)
                .sleeping(false)
                .build();
    }

    private static List<BodyRef> heap(PhysicsWorld world, int boxes, double density) {
        world.add(
                Body.fixed()
                        .shape(Box.ofHalfExtents(20, 0.5, 20))
                        .at(0, -0.5, 0)
                        .material(new Material(0.5, 0, 1000)));
        Random random = new Random(SEED);
        List<BodyRef> heap = new ArrayList<>();
        for (int i = 0; i < boxes; i++) {
            heap.add(
                    world.add(
                            Body.dynamic()
                                    .shape(Box.cubeOfHalfExtent(0.25))
                                    .at(
                                            0.3 * random.nextGaussian(),
                                            0.3 + 0.6 * i,
                                            0.3 * random.nextGaussian())
                                    .rotationAbout(1, 0, 0, random.nextDouble())
                                    .material(new Material(0.5, 0, density))));
        }
        return heap;
    }

    /**
     * What rests is carried in the first sub-step of a tick, too, whose warm start is still beside
     * that of doubles then: if it counted as falling, what it is struck by would bounce by a
     * sub-step's gravity too high or too low, 40 mm after a second.
     */
    @Test
    void aBallBouncesFromWhatRestsAsInDoubles() {
        for (int k = 0; k < 40; k++) {
            double height = 2.5 + 0.02 * k; // so the ball lands in any sub-step
            double expected = bounce(height, Precision.DOUBLE, 1);
            double found = bounce(height, Precision.SINGLE, 1);
            assertEquals(expected, found, 3e-4, "from " + height);
            assertEquals(found, bounce(height, Precision.SINGLE, 8), 0, "8 lanes, " + height);
        }
    }

    private static double bounce(double height, Precision precision, int lanes) {
        try (PhysicsWorld world = world(precision, lanes)) {
            Material bouncing = new Material(0.5, 0.8, 1000);
            world.add(
                    Body.fixed()
                            .shape(Box.ofHalfExtents(20, 1, 20))
                            .at(0, -1, 0)
                            .material(bouncing));
            world.add(
                    Body.dynamic()
                            .shape(Box.ofHalfExtents(1, 0.5, 1))
                            .at(0, 0.5, 0)
                            .material(bouncing));
            BodyRef ball =
                    world.add(
                            Body.dynamic()
                                    .shape(Sphere.of(0.3))
                                    .at(0.1, height, 0.2)
                                    .material(bouncing));
            for (int tick = 0; tick < 80; tick++) {
                world.step(1 / 60.0);
            }
            return ball.position().y();
        }
    }

    /** Flight is no contact's matter: a body that tumbles keeps the bits of double precision. */
    @Test
    void flightHasTheSameBits() {
        Vector3d[] at = {new Vector3d(), new Vector3d()};
        Quaterniond[] turned = {new Quaterniond(), new Quaterniond()};
        for (int i = 0; i < 2; i++) {
            try (PhysicsWorld world = world(i == 0 ? Precision.DOUBLE : Precision.SINGLE, 1)) {
                heap(world, 8, 1000); // something that does touch
                BodyRef body =
                        world.add(
                                Body.dynamic()
                                        .shape(Box.ofHalfExtents(0.1, 0.2, 0.3))
                                        .at(50, 500, 0)
                                        .velocity(1, 2, 3)
                                        .angularVelocity(7, 1, -3));
                for (int tick = 0; tick < 300; tick++) {
                    world.step(Scenes.STEP);
                }
                body.position(at[i]);
                turned[i].set(body.orientation());
            }
        }
        assertEquals(at[0], at[1]);
        assertEquals(turned[0], turned[1]);
    }

    /**
     * Masses times a power of two: the same path, to the bit. Patches whose weight is all on one
     * point are among it, where a square would be too small for a float.
     */
    @ParameterizedTest(name = "density times 2^{0}")
    @ValueSource(ints = {-10, 10, 20})
    void massesThatAreScaledMoveAlike(int power) {
        double[] paths = new double[2];
        for (int i = 0; i < 2; i++) {
            try (PhysicsWorld world = world(Precision.SINGLE, i == 0 ? 1 : 4)) {
                List<BodyRef> heap = heap(world, 12, Math.scalb(1000, i * power));
                Vector3d at = new Vector3d();
                for (int tick = 0; tick < 240; tick++) {
                    world.step(1 / 64.0);
                    for (BodyRef body : heap) {
                        body.position(at);
                        paths[i] = 31 * paths[i] % 1000 + at.x + at.y + at.z;
                    }
                }
            }
        }
        assertEquals(paths[0], paths[1], "seed " + SEED);
    }

    /**
     * The state of a body that touches is a double, too: what no contact changes keeps its bits. A
     * third of a metre a second is no float.
     */
    @Test
    void whatSlidesWithoutFrictionKeepsItsSpeed() {
        try (PhysicsWorld world = world(Precision.SINGLE, 0)) {
            Material ice = new Material(0, 0, 1000);
            world.add(
                    Body.fixed()
                            .shape(Box.ofHalfExtents(20, 0.5, 20))
                            .at(0, -0.5, 0)
                            .material(ice));
            BodyRef body =
                    world.add(
                            Body.dynamic()
                                    .shape(Box.cubeOfHalfExtent(0.25))
                                    .at(0, 0.25, 0)
                                    .material(ice)
                                    .velocity(1 / 3.0, 0, 0));
            for (int tick = 0; tick < 120; tick++) {
                world.step(1 / 64.0);
            }
            assertEquals(1 / 3.0, body.velocity(new Vector3d()).x);
            assertEquals(120 / 64.0 / 3, body.position(new Vector3d()).x, 1e-13, "m");
        }
    }

    /** Ten cubes stand, to what catalogue case E1 asks of double precision. */
    @Test
    void aStackStands() {
        try (PhysicsWorld world = world(Precision.SINGLE, 0)) {
            List<BodyRef> stack = Scenes.stack(world, 10);
            for (int tick = 0; tick < 1200; tick++) {
                world.step(Scenes.STEP);
            }
            Vector3d at = new Vector3d();
            Vector3d velocity = new Vector3d();
            for (int i = 0; i < stack.size(); i++) {
                stack.get(i).velocity(velocity);
                assertTrue(velocity.length() < 1e-6, "cube " + i + ": " + velocity.length());
            }
            stack.getLast().position(at);
            stack.getFirst().position(velocity);
            assertEquals(9, (at.y - velocity.y) / (2 * velocity.y), 1e-5, "heights of a cube");
        }
    }
}
