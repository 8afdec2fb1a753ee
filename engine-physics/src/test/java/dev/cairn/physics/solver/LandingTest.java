package dev.cairn.physics.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.Random;

/**
 * A tilted block lands on an edge, at any time within a tick, without gravity and without a bounce:
 * the impulse that stops the edge, in closed form, at its own time.
 */
final class LandingTest {
    private static final long SEED = 20261123;
    private static final double TICK = 1.0 / 60;

    @ParameterizedTest
    @ValueSource(doubles = {0, 20})
    void anEdgeThatLandsIsStoppedAtItsOwnTime(double friction) {
        System.out.println("seed " + SEED);
        Random random = new Random(SEED);
        for (int n = 0; n < 50; n++) {
            double wide = 0.1 + 0.1 * random.nextDouble();
            double tall = 0.2 + 0.2 * random.nextDouble();
            double tilt = 0.2 + 0.8 * random.nextDouble();
            double mass = 1 + random.nextInt(5);
            double speed = 1 + random.nextDouble();
            double time = TICK * (0.05 + 0.9 * random.nextDouble());
            // from the edge that is lowest to the centre of mass
            double x = -wide * Math.cos(tilt) + tall * Math.sin(tilt);
            double y = wide * Math.sin(tilt) + tall * Math.cos(tilt);
            Material surface = new Material(friction, 0, 1000);
            try (PhysicsWorld world =
                    PhysicsWorld.builder()
                            .gravity(0, 0, 0)
                            .settings(PhysicsSettings.DEFAULT.withSleeping(false))
                            .build()) {
                world.add(Body.fixed().shape(Box.of(9, 1, 9)).at(0, -1, 0).material(surface));
                BodyRef block =
                        world.add(
                                Body.dynamic()
                                        .shape(Box.of(wide, tall, 0.3))
                                        .mass(mass)
                                        .at(x, y + speed * time, 0)
                                        .rotationAbout(0, 0, 1, -tilt)
                                        .velocity(0, -speed, 0)
                                        .material(surface));
                world.step(TICK);
                // K J = (0, speed), K = 1/m + (r x .)^2 / I with r = -(x, y); J along y only
                // without friction
                double inertia = mass * (wide * wide + tall * tall) / 3;
                double kxx = 1 / mass + y * y / inertia;
                double kxy = -x * y / inertia;
                double kyy = 1 / mass + x * x / inertia;
                double sticks = friction > 0 ? 1 : 0;
                double jy = speed / (kyy - sticks * kxy * kxy / kxx);
                double jx = -sticks * kxy / kxx * jy;
                double spin = (-x * jy + y * jx) / inertia;
                double vx = jx / mass;
                double vy = jy / mass - speed;
                String what = n + ": at " + time / TICK;
                assertEquals(vx, block.velocity().x, 1e-11, what);
                assertEquals(vy, block.velocity().y, 1e-11, what);
                assertEquals(spin, block.angularVelocity().z, 1e-10, what);
                double after = TICK - time;
                assertEquals(x + after * vx, block.position().x, 1e-12, what);
                assertEquals(y + after * vy, block.position().y, 1e-12, what);
                double turned = 2 * Math.atan2(block.orientation().z, block.orientation().w);
                assertEquals(after * spin - tilt, turned, 1e-11, what);
            }
        }
    }
}
