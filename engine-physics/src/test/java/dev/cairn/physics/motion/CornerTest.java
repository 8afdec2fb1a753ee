package dev.cairn.physics.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** A floor without end stays a floor beside walls that stand on it, in any direction. */
@Tag("compiled")
class CornerTest {
    private static final int SEED = 20261125;
    private static final double STEP = 1 / 60.0;
    private static final int WORLDS = 60;

    private static Shape shape(SplittableRandom r) {
        double size = r.nextDouble(.1, .6);
        return switch (r.nextInt(3)) {
            case 0 ->
                    Box.ofHalfExtents(size, size * r.nextDouble(.3, 1), size * r.nextDouble(.3, 1));
            case 1 -> Sphere.of(size);
            default -> Capsule.of(.5 * size, size);
        };
    }

    /** Runs a world to its end; returns the digest. */
    private static long run(int seed, int workers, int lanes) {
        SplittableRandom r = new SplittableRandom(seed);
        Vector3d up = new Vector3d(r.nextDouble(-1, 1), 1, r.nextDouble(-1, 1)).normalize();
        Quaterniond turn = new Quaterniond().rotationTo(new Vector3d(0, 1, 0), up);
        Vector3d gravity = new Vector3d(up).mul(-9.81);
        try (PhysicsWorld world =
                PhysicsWorld.builder()
                        .gravity(gravity.x, gravity.y, gravity.z)
                        .workers(workers)
                        .settings(PhysicsSettings.DEFAULT.withLanes(lanes))
                        .build()) {
            world.add(Body.fixed().shape(HalfSpace.of()).rotation(turn));
            int walls = 1 + r.nextInt(3);
            for (int k = 0; k < walls; k++) {
                Quaterniond wall = new Quaterniond(turn).rotateY(r.nextDouble(0, 6));
                Vector3d at = wall.transform(new Vector3d(0, 1, -1.5));
                world.add(
                        Body.fixed()
                                .shape(Box.ofHalfExtents(4, 1, .3))
                                .at(at.x, at.y, at.z)
                                .rotation(wall));
            }
            List<BodyRef> bodies = new ArrayList<>();
            for (int k = 0; k < 4; k++) {
                Vector3d at =
                        turn.transform(
                                new Vector3d(
                                        r.nextDouble(-1, 1), 3 + 1.5 * k, r.nextDouble(-1, 1)));
                bodies.add(
                        world.add(
                                Body.dynamic()
                                        .shape(shape(r))
                                        .at(at.x, at.y, at.z)
                                        .velocity(
                                                r.nextDouble(-4, 4),
                                                r.nextDouble(-4, 4),
                                                r.nextDouble(-4, 4))));
            }
            for (int tick = 0; tick < 180; tick++) {
                world.step(STEP);
                for (BodyRef body : bodies) {
                    double height = body.position().dot(up);
                    assertTrue(
                            height > 0,
                            "seed " + seed + " tick " + tick + ": a centre at " + height + " m");
                }
            }
            return world.digest();
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 4})
    void nobodySinksIntoTheFloorBesideAWall(int lanes) {
        for (int k = 0; k < WORLDS; k++) {
            long digest = run(SEED + k, 1, lanes);
            if (k % 20 == 0) {
                assertEquals(digest, run(SEED + k, 2, 8), "seed " + (SEED + k));
            }
        }
    }
}
