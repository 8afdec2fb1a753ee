package dev.cairn.physics.contact;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.support.Scenes;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.SplittableRandom;

/**
 * Boxes that tumble and strike each other at 40 and 300 m/s: a mirrored world has mirrored bits.
 */
class MirroredImpactTest {
    @Tag("compiled")
    @Test
    void mirroredImpactsHaveMirroredBits() {
        StringBuilder who = new StringBuilder();
        for (int seed = 1; seed <= 200; seed++) {
            double speed = seed % 4 == 0 ? 300 : 40;
            Vector3d[] one = fall(1, speed, seed);
            Vector3d[] other = fall(-1, speed, seed);
            boolean differs = false;
            for (int i = 0; i < one.length; i++) {
                // velocities are vectors, spins turn the other way round
                int m = i % 2 == 0 ? -1 : 1;
                differs |=
                        one[i].x != m * other[i].x
                                || one[i].y != -m * other[i].y
                                || one[i].z != -m * other[i].z;
            }
            if (differs) {
                who.append(' ').append(seed);
            }
        }
        assertEquals("", who.toString(), "not mirrored, by seed");
    }

    /** Velocity and angular velocity of both, half a second after. */
    private static Vector3d[] fall(int side, double speed, int seed) {
        SplittableRandom random = new SplittableRandom(seed);
        PhysicsSettings settings = PhysicsSettings.DEFAULT.withLanes(seed % 2 == 0 ? 1 : 8);
        try (PhysicsWorld world =
                Scenes.awake().workers(1).gravity(0, -9.81, 0).settings(settings).build()) {
            BodyRef[] bodies = new BodyRef[2];
            for (int i = 0; i < 2; i++) {
                Quaterniond q = Scenes.turn(random);
                bodies[i] =
                        world.add(
                                Body.dynamic()
                                        .shape(Box.ofHalfExtents(0.25, 0.375, 0.5))
                                        .at(
                                                side * 0.4 * (random.nextDouble() - 0.5),
                                                5 * i,
                                                0.4 * (random.nextDouble() - 0.5))
                                        .velocity(0, -speed * i, 0)
                                        .rotation(new Quaterniond(q.x, side * q.y, side * q.z, q.w))
                                        .angularVelocity(
                                                10 * random.nextDouble() - 5,
                                                side * (10 * random.nextDouble() - 5),
                                                side * (10 * random.nextDouble() - 5)));
            }
            for (int tick = 0; tick < 30; tick++) {
                world.step(Scenes.STEP);
            }
            return new Vector3d[] {
                bodies[0].velocity(), bodies[0].angularVelocity(),
                bodies[1].velocity(), bodies[1].angularVelocity()
            };
        }
    }
}
