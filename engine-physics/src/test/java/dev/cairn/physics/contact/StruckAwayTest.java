package dev.cairn.physics.contact;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.support.Scenes;

import org.joml.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * A ball on its way to another is struck away from it within the tick: they do not meet, and do
 * nothing to each other.
 */
class StruckAwayTest {
    private static final double RADIUS = 0.1;
    private static final double GAP = 0.02;
    private static final double SLOW = 5;

    @ParameterizedTest
    @ValueSource(doubles = {200, 500, 5000})
    void whoIsStruckAwayMeetsNobody(double speed) {
        Material elastic = new Material(0, 1, 1000);
        try (PhysicsWorld world = Scenes.awake().workers(1).gravity(0, 0, 0).build()) {
            BodyRef rests = world.add(ball(0, 0).material(elastic));
            double x = -2 * RADIUS - GAP;
            BodyRef comes = world.add(ball(x, 0).velocity(SLOW, 0, 0).material(elastic));
            // they would meet after 4 ms; it is struck at right angles after 1 ms
            double early = 0.001;
            BodyRef strikes =
                    world.add(
                            ball(x + SLOW * early, -2 * RADIUS - speed * early)
                                    .velocity(0, speed, 0)
                                    .material(elastic));
            world.step(Scenes.STEP);
            world.step(Scenes.STEP);
            assertEquals(new Vector3d(), rests.velocity(), "who was not met");
            Vector3d v = comes.velocity();
            assertEquals(SLOW, v.x, 1e-9, "along the old way");
            // equal masses exchange what they have along the line of centres
            assertEquals(speed, v.y, 1e-9 * speed);
            assertEquals(0, strikes.velocity().length(), 1e-9 * speed);
        }
    }

    private static Body ball(double x, double y) {
        return Body.dynamic().shape(Sphere.of(RADIUS)).at(x, y, 0);
    }
}
