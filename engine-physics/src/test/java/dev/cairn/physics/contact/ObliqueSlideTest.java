package dev.cairn.physics.contact;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.support.Scenes;

import org.joml.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * A block that slides keeps its line, whatever way it is turned to it, and is braked by mu g.
 *
 * <p>Friction is opposite to the slip, and the pressure of a block that does not turn is heavier in
 * front, on the line itself, so nothing turns it. A long block tips more easily across than along:
 * friction that goes by what would stop it pushed the block aside, by up to 0.4 of 5 m/s.
 */
class ObliqueSlideTest {
    private static final double GRAVITY = 9.81;
    private static final double SPEED = 5;
    private static final double[] ANGLES = {0, 0.2, 0.5, 0.8, 1.1, 2.5};

    private enum Block {
        LONG,
        THIN,
        SKEW,
        PARTS;

        Body plan() {
            return switch (this) {
                case LONG -> Body.dynamic().shape(Box.ofHalfExtents(0.3, 0.2, 0.15));
                case THIN -> Body.dynamic().shape(Box.ofHalfExtents(0.5, 0.2, 0.13));
                case SKEW -> Body.dynamic().shape(ConvexHull.of(skew()));
                case PARTS ->
                        Body.dynamic()
                                .collider(
                                        Collider.of(Box.ofHalfExtents(0.15, 0.2, 0.15))
                                                .at(-0.15, 0, 0))
                                .collider(
                                        Collider.of(Box.ofHalfExtents(0.15, 0.2, 0.15))
                                                .at(0.15, 0, 0));
            };
        }
    }

    /** A prism over a parallelogram. */
    private static double[] skew() {
        double[] corners = {-0.3, -0.15, 0.1, -0.15, 0.3, 0.15, -0.1, 0.15};
        double[] xyz = new double[24];
        for (int i = 0; i < 8; i++) {
            xyz[3 * i] = corners[2 * (i / 2)];
            xyz[3 * i + 1] = i % 2 == 0 ? -0.2 : 0.2;
            xyz[3 * i + 2] = corners[2 * (i / 2) + 1];
        }
        return xyz;
    }

    @ParameterizedTest
    @EnumSource(Block.class)
    void keepsItsLine(Block block) {
        for (double friction : new double[] {0.05, 0.3, 0.6}) {
            for (double angle : ANGLES) {
                slide(block, friction, angle, angle > 1);
            }
        }
    }

    private static void slide(Block block, double friction, double angle, boolean onSlab) {
        double x = StrictMath.cos(angle);
        double z = StrictMath.sin(angle);
        Material surface = new Material(friction, 0, 1000);
        try (PhysicsWorld world = Scenes.awake().workers(1).gravity(0, -GRAVITY, 0).build()) {
            world.add(
                    (onSlab
                                    ? Body.fixed().shape(Box.ofHalfExtents(50, 1, 50)).at(0, -1, 0)
                                    : Body.fixed().shape(HalfSpace.of()))
                            .material(surface));
            BodyRef body =
                    world.add(
                            block.plan()
                                    .material(surface)
                                    .at(0, 0.2, 0)
                                    .velocity(SPEED * x, 0, SPEED * z));
            Vector3d v = new Vector3d();
            for (int tick = 1; tick <= 40; tick++) {
                world.step(Scenes.STEP);
                double speed = SPEED - friction * GRAVITY * tick * Scenes.STEP;
                if (speed < 0.2) {
                    break;
                }
                body.velocity(v);
                String where =
                        block + ", friction " + friction + ", angle " + angle + ", tick " + tick;
                assertEquals(speed, x * v.x + z * v.z, 1e-9, "speed along: " + where);
                assertEquals(0, x * v.z - z * v.x, 1e-9, "speed aside: " + where);
            }
        }
    }
}
