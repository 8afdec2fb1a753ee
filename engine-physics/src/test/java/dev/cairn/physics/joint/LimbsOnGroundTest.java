package dev.cairn.physics.joint;

import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Shape;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/**
 * A heavy body with six light limbs falls on them: a limb that has come to the limit of its joint,
 * with the ground on its other side, stops the whole body. Contacts that are solved with joints
 * alone let it give way past its limit, and limits then press it into the ground.
 */
final class LimbsOnGroundTest {
    private static final double STEP = 1.0 / 60;
    private static final double HALF = 0.08;
    private static final double RADIUS = 0.018;
    private static final double MOST = 0.2;

    @ParameterizedTest(name = "{0} times the mass of a limb")
    @ValueSource(doubles = {2, 20, 200})
    void noLimbIsPressedIntoTheGround(double ratio) {
        for (int n = 0; n < 12; n++) {
            drop(ratio, new Random(n));
        }
    }

    private static void drop(double ratio, Random random) {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).sleeping(false).build()) {
            world.add(Body.fixed().shape(HalfSpace.of()));
            Quaterniond turn =
                    new Quaterniond(
                                    random.nextGaussian(),
                                    random.nextGaussian(),
                                    random.nextGaussian(),
                                    random.nextGaussian())
                            .normalize();
            Vector3d centre = new Vector3d(0, 0.4, 0);
            Vector3d speed = new Vector3d(2 * random.nextGaussian(), -6, 2 * random.nextGaussian());
            BodyRef box =
                    world.add(
                            moving(Box.ofHalfExtents(HALF, HALF, HALF), centre, turn, speed)
                                    .mass(0.08 * ratio));
            List<BodyRef> limbs = new ArrayList<>();
            List<JointRef> joints = new ArrayList<>();
            for (int k = 0; k < 6; k++) {
                Vector3d way = new Vector3d();
                way.setComponent(k / 2, k % 2 == 0 ? 1 : -1);
                Quaterniond along = new Quaterniond(turn).rotateTo(new Vector3d(0, 1, 0), way);
                turn.transform(way);
                Vector3d at = new Vector3d(way).mul(2.2 * HALF).add(centre);
                BodyRef limb =
                        world.add(moving(Capsule.of(RADIUS, HALF), at, along, speed).mass(0.08));
                at.set(way).mul(HALF).add(centre);
                limbs.add(limb);
                joints.add(
                        world.add(
                                Joint.ball(box, limb)
                                        .at(at.x, at.y, at.z)
                                        .axis(way.x, way.y, way.z)
                                        .limits(0, MOST)));
            }
            double start = world.kineticEnergy() + world.potentialEnergy();
            for (int t = 0; t < 60; t++) {
                world.step(STEP);
                look(limbs, joints, "tick " + t);
                double energy = world.kineticEnergy() + world.potentialEnergy();
                assertTrue(energy < start * (1 + 1e-4), t + ": " + energy + " J of " + start);
            }
        }
    }

    private static void look(List<BodyRef> limbs, List<JointRef> joints, String when) {
        Vector3d other = new Vector3d();
        for (int k = 0; k < limbs.size(); k++) {
            String what = when + ", limb " + k + ": ";
            double height = limbs.get(k).position(new Vector3d()).y;
            assertTrue(height > 0, what + "is at " + height);
            JointRef joint = joints.get(k);
            double apart = joint.anchorA(new Vector3d()).distance(joint.anchorB(other));
            assertTrue(apart < 1e-3 * HALF, what + "is apart by " + apart);
        }
    }

    private static Body moving(Shape shape, Vector3d at, Quaterniond turn, Vector3d speed) {
        return Body.dynamic()
                .shape(shape)
                .at(at.x, at.y, at.z)
                .rotation(turn)
                .velocity(speed.x, speed.y, speed.z);
    }
}
