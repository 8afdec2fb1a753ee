package dev.cairn.samples.scenes.joint;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.joint.Joint;
import dev.cairn.physics.joint.JointAxis;
import dev.cairn.physics.joint.JointRef;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;

import java.util.List;

/** A car of a box and four wheels that drives over bumps. Truth: no joint is ever open. */
public final class Car {
    private Car() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "car",
                "Car",
                "A car on four sprung wheels, steered in front and driven behind, drives over"
                        + " bumps.",
                "joints",
                List.of(Parameter.real("speed", 15, -60, 60, "of the driven wheels, rad/s")),
                480,
                200,
                Car::build);
    }

    private static void build(SceneBuilder scene) {
        scene.floor(30, 30, 0.9, 0);
        for (int k = 0; k < 10; k++) {
            scene.add(
                    Capsule.of(0.12, 1.5),
                    Palette.body(3),
                    Body.fixed()
                            .at(3 + 1.7 * k, -0.03, 0.4 * (k % 2))
                            .rotationAbout(1, 0, 0, 1.5707963));
        }
        BodyRef body =
                scene.add(
                        Box.ofHalfExtents(1.2, 0.25, 0.6),
                        Palette.body(1),
                        Body.dynamic().mass(800).at(-4, 0.75, 0));
        JointRef[] front = new JointRef[2];
        for (int k = 0; k < 4; k++) {
            double x = -4 + (k < 2 ? 0.8 : -0.8);
            double z = k % 2 == 0 ? 0.8 : -0.8;
            BodyRef wheel =
                    scene.add(
                            Sphere.of(0.35),
                            Palette.body(4),
                            Body.dynamic().mass(20).at(x, 0.36, z));
            Joint joint =
                    Joint.wheel(body, wheel, 2, 0.7)
                            .at(x, 0.36, z)
                            .axis(0, 0, 1)
                            .secondAxis(0, 1, 0)
                            .limits(JointAxis.Y, -0.15, 0.15);
            if (k < 2) {
                front[k] = scene.world().add(joint.spring(JointAxis.SWING_Y, 0, 8, 1));
            } else {
                scene.world().add(joint.motor(-scene.get("speed"), 400));
            }
        }
        scene.beforeTick((tick, seconds) -> {
            double steer = 0.12 * StrictMath.sin(0.8 * seconds);
            front[0].target(JointAxis.SWING_Y, steer);
            front[1].target(JointAxis.SWING_Y, steer);
        });
        scene.view(new SceneView(-2, 3, 7.5, 2.5, 0.4, 0));
        Gaps.watch(scene, "gapMetres", 1);
    }
}
