package dev.cairn.render.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import dev.cairn.core.snapshot.Pose;
import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.input.Bindings;
import dev.cairn.render.input.Control;
import dev.cairn.render.input.Controllable;
import dev.cairn.render.input.Key;
import dev.cairn.render.input.MouseButton;
import dev.cairn.render.mesh.Meshes;
import dev.cairn.render.mesh.Model;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;

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

    private static void drive(Scene scene, int ticks) {
        for (int tick = 0; tick < ticks; tick++) {
            scene.drive(STEP);
            scene.bindings().endTick();
            scene.physics().step(STEP);
        }
    }

    /** The camera looks along +x, so away is +x and right is +z. */
    @Test
    void aControllableEntityIsDrivenWithoutCode() {
        try (PhysicsWorld world = PhysicsWorld.builder().gravity(0, 0, 0).workers(1).build()) {
            Camera camera = new Camera().lookAt(-9, 4, 0, 0, 0, 0);
            Scene scene = new Scene(world, camera, new Bindings(), "control");
            Bindings keys = scene.bindings();
            int[] flown = new int[1];
            keys.onKey(Key.UP, "look up", () -> flown[0]++);
            Control spin =
                    new Control(
                            null,
                            MouseButton.MIDDLE,
                            Control.Effect.TURN,
                            Control.Axes.WORLD,
                            0,
                            3,
                            0);
            List<Control> controls = new ArrayList<>(Controllable.arrows(4, 5).controls());
            controls.add(spin);
            BodyRef box =
                    scene.add(
                            Body.dynamic()
                                    .shape(Box.ofHalfExtents(0.2, 0.3, 0.7))
                                    .mass(7)
                                    .with(new Controllable(controls)));
            drive(scene, 1);
            keys.press(Key.UP);
            keys.press(Key.RIGHT);
            drive(scene, 60);
            assertEquals(0, flown[0], "its keys are its own");
            assertEquals(0, keys.keys("look up").length);
            // v = a t whatever the mass
            Vector3d v = box.velocity(new Vector3d());
            assertEquals(4, v.x, 1e-12);
            assertEquals(0, v.y, 1e-12);
            assertEquals(4, v.z, 1e-12);
            keys.release(Key.UP);
            keys.release(Key.RIGHT);
            keys.press(Key.RIGHT_CONTROL);
            keys.release(Key.RIGHT_CONTROL);
            drive(scene, 30);
            assertEquals(5, box.velocity(new Vector3d()).y, 1e-12, "one press is one kick");
            keys.press(MouseButton.MIDDLE);
            drive(scene, 60);
            // About a principal axis: w = a t.
            assertEquals(3, box.angularVelocity(new Vector3d()).y, 1e-9);
            world.ecs().remove(box.entity(), Controllable.COMPONENT);
            drive(scene, 1);
            keys.press(Key.UP);
            assertEquals(1, flown[0], "the keys are free again");
            drive(scene, 5);
            assertEquals(4, box.velocity(new Vector3d()).x, 1e-12);
        }
    }

    @Test
    void aControllableEntityWithoutABodyMovesItsPose() {
        try (PhysicsWorld world = PhysicsWorld.builder().gravity(0, 0, 0).workers(1).build()) {
            Scene scene =
                    new Scene(
                            world, new Camera().lookAt(0, 4, 9, 0, 0, 0), new Bindings(), "poses");
            long sign = scene.addVisual(Pose.at(1, 2, 3), Model.of(Meshes.CUBE));
            world.ecs()
                    .add(
                            sign,
                            new Controllable(
                                    List.of(
                                            Control.of(Key.I, Control.Effect.PUSH, 0, 0, -2),
                                            Control.of(Key.O, Control.Effect.KICK, 0, 1, 0),
                                            Control.of(
                                                    Key.U, Control.Effect.TURN, 0, Math.PI, 0))));
            scene.bindings().press(Key.I);
            scene.bindings().press(Key.O);
            scene.bindings().press(Key.U);
            drive(scene, 30);
            Pose seen = world.ecs().get(sign, Pose.COMPONENT);
            assertEquals(1, seen.x(), 1e-12);
            assertEquals(3, seen.y(), 1e-12);
            assertEquals(2, seen.z(), 1e-12);
            // A quarter turn.
            assertEquals(Math.sqrt(0.5), seen.qy(), 1e-12);
        }
    }

    @Test
    void aControlNamesWhatIsWrongWithIt() {
        assertThrows(
                IllegalArgumentException.class,
                () -> new Control(null, null, Control.Effect.PUSH, Control.Axes.VIEW, 0, 1, 0));
        assertThrows(
                IllegalArgumentException.class,
                () -> Control.of(Key.A, Control.Effect.PUSH, Double.NaN, 0, 0));
    }
}
