package dev.cairn.physics.contact;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Cone;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.support.Scenes;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** A platform that is open from below: any shape, turned anyhow, at any speed to 100 m/s. */
class OneWayTest {
    private static final long SEED = 25;
    private static final int TICKS = 120;

    private static Body body(SplittableRandom r) {
        Body body = Body.dynamic();
        double s = r.nextDouble(.15, .4);
        switch (r.nextInt(7)) {
            case 0 -> body.shape(Sphere.of(s));
            case 1 -> body.shape(Box.ofHalfExtents(s, r.nextDouble(.1, .4), .3));
            case 2 -> body.shape(Capsule.of(s, .3));
            case 3 -> body.shape(Cylinder.of(s, .3));
            case 4 -> body.shape(Cone.of(s, .5));
            case 5 -> {
                List<Vector3d> corners = new ArrayList<>();
                for (int i = 0; i < 12; i++) {
                    Vector3d corner =
                            new Vector3d(
                                    r.nextDouble(-1, 1), r.nextDouble(-1, 1), r.nextDouble(-1, 1));
                    corners.add(corner.normalize(s));
                }
                body.shape(ConvexHull.of(corners));
            }
            default ->
                    body.collider(Collider.of(Box.cubeOfHalfExtent(s)).at(-s, 0, 0))
                            .collider(Collider.of(Sphere.of(s)).at(s, 0, 0));
        }
        Quaterniond turn =
                new Quaterniond(
                                r.nextDouble(-1, 1),
                                r.nextDouble(-1, 1),
                                r.nextDouble(-1, 1),
                                r.nextDouble(-1, 1))
                        .normalize();
        return body.rotation(turn);
    }

    @Test
    void letsThroughFromBelowOnly() {
        SplittableRandom r = new SplittableRandom(SEED);
        for (int round = 0; round < 150; round++) {
            double speed = round % 3 == 0 ? r.nextDouble(2, 100) : r.nextDouble(2, 12);
            String what = "seed " + SEED + ", round " + round + ", " + speed + " m/s";
            try (PhysicsWorld world = Scenes.awake().gravity(0, 0, 0).workers(1).build()) {
                world.collisions().setHook(ContactHookTest.ONE_WAY);
                Collider plank = Collider.of(Box.ofHalfExtents(9, .05, 9)).at(0, -.05, 0);
                world.add(Body.fixed().collider(plank.userData("one-way")));
                double early = r.nextDouble(2, 4);
                Body body = body(r);
                BodyRef up = world.add(body.at(-4, -early, 0).velocity(0, speed, 0));
                BodyRef down = world.add(body.at(4, early, 0).velocity(0, -speed, 0));
                for (int i = 0; i < TICKS; i++) {
                    world.step(Scenes.STEP);
                    assertTrue(
                            down.centreOfMass(new Vector3d()).y > 0,
                            what + " fell through in tick " + i);
                }
                world.validate();
                // without gravity nothing but the platform can change a velocity
                assertEquals(speed, up.velocity().y, 1e-12 * speed, what);
                assertEquals(0, up.angularVelocity().length(), 1e-12, what);
                double way = speed * TICKS * Scenes.STEP - early;
                assertEquals(way, up.position().y, 1e-9, what);
            }
        }
    }
}
