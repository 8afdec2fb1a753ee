package dev.cairn.physics.rest;

import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.HalfSpace;

import org.joml.Quaterniond;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.Arrays;
import java.util.Random;

/**
 * Cards that fall flat, of a fifth of a millimetre to one: the sag of a soft contact is a good part
 * of them. They slept in it, with half of their thickness in the floor, or not at all.
 */
class ThinTest {
    @ParameterizedTest
    @ValueSource(doubles = {1e-4, 2e-4, 5e-4})
    void aCardSleepsOnTheFloorAndNotInIt(double halfHeight) {
        for (int seed = 0; seed < 4; seed++) {
            Random random = new Random(seed);
            Material material = new Material(0.5, 0.1, 1000);
            try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
                world.add(Body.fixed().shape(HalfSpace.of()).material(material));
                Quaterniond turn =
                        new Quaterniond()
                                .rotateX(0.1 * random.nextGaussian())
                                .rotateZ(0.1 * random.nextGaussian());
                BodyRef card =
                        world.add(
                                Body.dynamic()
                                        .shape(Box.ofHalfExtents(0.02, halfHeight, 0.015))
                                        .at(0, 0.2, 0)
                                        .rotation(turn)
                                        .material(material));
                for (int tick = 0; tick < 300; tick++) {
                    world.step(1.0 / 60);
                }
                assertTrue(card.isAsleep(), "seed " + seed);
                double overlap = Overlap.deepest(world) / halfHeight;
                assertTrue(overlap < 0.05, () -> "overlap over half the height: " + overlap);
            }
        }
    }

    /** The deepest point of a rim runs around it: discs swayed for ever, and sank in by that. */
    @ParameterizedTest
    @CsvSource({"12, false", "25, false", "25, true", "60, false", "60, true"})
    void aCoinComesToRestOnTheFloorAndNotInIt(double radiusOverHalfHeight, boolean onSlab) {
        for (int seed = 0; seed < 8; seed++) {
            Random random = new Random(seed);
            Material material = new Material(0.5, 0, 1000);
            try (PhysicsWorld world = PhysicsWorld.builder().workers(1).sleeping(false).build()) {
                Body floor =
                        onSlab
                                ? Body.fixed().shape(Box.ofHalfExtents(30, 1, 30)).at(0.3, -1, 0.2)
                                : Body.fixed().shape(HalfSpace.of());
                world.add(floor.material(material));
                double radius = 0.005 * StrictMath.pow(10, random.nextDouble());
                double halfHeight = radius / radiusOverHalfHeight;
                Quaterniond turn =
                        new Quaterniond()
                                .rotateY(6 * random.nextDouble())
                                .rotateX(0.2 * random.nextGaussian())
                                .rotateZ(0.2 * random.nextGaussian());
                BodyRef coin =
                        world.add(
                                Body.dynamic()
                                        .shape(Cylinder.of(radius, halfHeight))
                                        .at(0, 2 * radius, 0)
                                        .rotation(turn)
                                        .material(material));
                for (int tick = 0; tick < 240; tick++) {
                    world.step(1.0 / 60);
                }
                String which = "seed " + seed;
                double speed = coin.velocity().length() + radius * coin.angularVelocity().length();
                assertTrue(speed < 1e-3 * radius, () -> which + ", speed " + speed);
                double overlap = Overlap.deepest(world) / halfHeight;
                assertTrue(overlap < 0.05, () -> which + ", overlap over half height " + overlap);
            }
        }
    }

    /** Corners of a plate whose underside is no plane, mm. */
    private static final double[] UNEVEN = {
        0.7412, 15.2707, 14.5627, -0.6472, 8.8204, 17.0969, 0.5993, -9.0839, 14.4143, -0.4918,
        -10.3770, 16.8871, 0.8055, 17.0456, -11.4080, -0.6202, 15.7818, -12.8047, 0.6840, -11.7608,
        -18.0723, -0.6508, -8.8540, -19.8949
    };

    /**
     * It stands on three corners, of which one bears a fiftieth of the weight and stayed a fifth of
     * the half thickness in the floor: each push was taken back that did not lift the corner which
     * bears most.
     */
    @Test
    void aCornerThatHardlyPressesIsPushedOutOfTheFloor() {
        double[] corners = Arrays.stream(UNEVEN).map(x -> 1e-3 * x).toArray();
        Material material = new Material(0.7, 0, 7000);
        double worst = 0;
        for (int n = 0; n < 12; n++) {
            try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
                world.add(Body.fixed().shape(HalfSpace.of()).material(material));
                BodyRef plate =
                        world.add(
                                Body.dynamic()
                                        .shape(ConvexHull.of(corners))
                                        .at(0, 0.06 + 0.002 * n, 0.03)
                                        .velocity(3.7, -4.4, -5.5)
                                        .material(material));
                for (int tick = 0; tick < 360; tick++) {
                    world.step(1.0 / 60);
                }
                assertTrue(plate.isAsleep(), "throw " + n);
                worst = Math.max(worst, Overlap.deepest(world) / 7e-4);
            }
        }
        System.out.println("overlap over half the height: " + worst);
        assertTrue(worst < 0.1, "overlap over half the height: " + worst);
    }
}
