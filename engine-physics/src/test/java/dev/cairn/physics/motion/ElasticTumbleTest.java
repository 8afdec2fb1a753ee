package dev.cairn.physics.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Cone;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Shape;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

import java.util.Random;

/**
 * Bodies with unlike moments that tumble and bounce without friction and with restitution 1 keep
 * their energy: nothing takes any.
 */
class ElasticTumbleTest {
    private static final long SEED = 20261128;

    private static final int TICKS = 240;

    @Test
    void aPlateKeepsItsEnergy() {
        tumble(Box.ofHalfExtents(0.3, 0.05, 0.2));
    }

    @Test
    void aConeKeepsItsEnergy() {
        tumble(Cone.of(0.3, 0.2));
    }

    @Test
    void aCapsuleKeepsItsEnergy() {
        tumble(Capsule.of(0.1, 0.4));
    }

    /** It begins to turn when it is struck, in some sub-step of a tick. */
    @Test
    void aBoxThatFallsWithoutSpinKeepsItsEnergy() {
        tumble(Box.ofHalfExtents(0.9, 0.22, 0.22), 0);
    }

    private static void tumble(Shape shape) {
        tumble(shape, 5);
    }

    private static void tumble(Shape shape, double spin) {
        for (int n = 0; n < 20; n++) {
            double[] off = new double[1];
            long digest = run(shape, spin, n, 1, 1, off);
            // rounding of some thousand sub-steps
            assertEquals(0, off[0], 1e-12, "seed " + SEED + ", throw " + n);
            if (n < 3) {
                assertEquals(digest, run(shape, spin, n, 4, 2, off), "other lanes, workers");
            }
        }
    }

    /** Returns the digest after the last tick; the largest change of the energy, as a share. */
    private static long run(Shape shape, double spin, int n, int lanes, int workers, double[] off) {
        Random random = new Random(SEED + n);
        Quaterniond turn =
                new Quaterniond(
                                random.nextGaussian(),
                                random.nextGaussian(),
                                random.nextGaussian(),
                                random.nextGaussian())
                        .normalize();
        Material material = new Material(0, 1, 800);
        try (PhysicsWorld world =
                PhysicsWorld.builder()
                        .settings(PhysicsSettings.DEFAULT.withLanes(lanes))
                        .workers(workers)
                        .sleeping(false)
                        .build()) {
            world.add(Body.fixed().shape(HalfSpace.of()).material(material));
            BodyRef body =
                    world.add(
                            Body.dynamic()
                                    .shape(shape)
                                    .at(0, 1.5, 0)
                                    .rotation(turn)
                                    .material(material));
            body.setAngularVelocity(
                    new Vector3d(
                            spin * random.nextGaussian(),
                            spin * random.nextGaussian(),
                            spin * random.nextGaussian()));
            double start = world.kineticEnergy() + world.potentialEnergy();
            off[0] = 0;
            for (int tick = 0; tick < TICKS; tick++) {
                world.step(1.0 / 60);
                double now = world.kineticEnergy() + world.potentialEnergy();
                off[0] = Math.max(off[0], Math.abs(now / start - 1));
            }
            return world.digest();
        }
    }
}
