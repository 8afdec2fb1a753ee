package dev.cairn.render.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import dev.cairn.core.snapshot.Pose;
import dev.cairn.core.snapshot.Visual;
import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.input.Bindings;
import dev.cairn.render.mesh.Model;
import dev.cairn.render.mesh.ModelGroup;

import org.junit.jupiter.api.Test;

import java.util.List;

/** What is added to a scene carries its look. */
class SceneTest {
    @Test
    void aGroupOfModelsIsALookToo() {
        try (PhysicsWorld physics = PhysicsWorld.builder().build()) {
            Scene scene = new Scene(physics, new Camera(), new Bindings(), "test");
            ModelGroup look =
                    new ModelGroup(
                            List.of(
                                    Model.of(Box.cubeOfHalfExtent(1)),
                                    Model.of(Sphere.of(0.5)).color(0xFF0000)));
            Body body = Body.dynamic().shape(Box.cubeOfHalfExtent(1)).at(0, 2, 0);
            BodyRef crate = scene.add(body, look);
            assertSame(look, physics.ecs().get(crate.entity(), Visual.COMPONENT).model());
            long sign = scene.addVisual(Pose.at(1, 2, 3), look);
            assertSame(look, physics.ecs().get(sign, Visual.COMPONENT).model());
            assertEquals(3, physics.ecs().get(sign, Pose.COMPONENT).z());
            assertThrows(NullPointerException.class, () -> scene.add(body, (ModelGroup) null));
            assertEquals(1, physics.bodyCount());
        }
    }
}
