package dev.cairn.render.app;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.input.Bindings;
import dev.cairn.render.input.Key;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** An entity that the user controls: keys that are held push it, a key that is pressed kicks it. */
class ControlTest {
    private static final double STEP = 1.0 / 60;

    @Test
    void keysDriveAnEntity() {
        try (PhysicsWorld world = PhysicsWorld.builder().gravity(0, 0, 0).workers(1).build()) {
            Scene scene = new Scene(world, new Camera(), new Bindings(), "control");
            BodyRef ball = scene.add(Body.dynamic().shape(Sphere.of(0.5)).mass(2));
            Bindings keys = scene.bindings();
            keys.onHold(Key.RIGHT, "drive").onKey(Key.J, "jump", () -> ball.applyImpulse(0, 6, 0));
            keys.press(Key.RIGHT);
            run(world, keys, ball);
            // v = F t / m = 4 N 1 s / 2 kg; x = v t / 2, within the step of any integrator.
            assertEquals(2, ball.velocity(new Vector3d()).x, 1e-12);
            double driven = ball.position(new Vector3d()).x;
            assertEquals(1, driven, 2 * STEP / 2);
            keys.release(Key.RIGHT);
            keys.press(Key.J);
            keys.release(Key.J);
            run(world, keys, ball);
            assertEquals(driven + 2, ball.position(new Vector3d()).x, 1e-12);
            assertEquals(3, ball.position(new Vector3d()).y, 1e-12);
            // Another key from now on.
            keys.rebind("drive", Key.L);
            keys.press(Key.RIGHT);
            run(world, keys, ball);
            assertEquals(2, ball.velocity(new Vector3d()).x, 1e-12);
            keys.press(Key.L);
            run(world, keys, ball);
            assertEquals(4, ball.velocity(new Vector3d()).x, 1e-12);
        }
    }

    /** One second. */
    private static void run(PhysicsWorld world, Bindings keys, BodyRef ball) {
        for (int tick = 0; tick < 60; tick++) {
            if (keys.isHeld("drive")) {
                ball.applyForce(4, 0, 0);
            }
            world.step(STEP);
        }
    }
}
