package dev.cairn.samples.scenes.joint;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.joint.Joint;
import dev.cairn.physics.joint.JointAxis;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;

import java.util.List;

/** Figures of eleven bodies that fall on stairs. Truth: no joint is ever open. */
public final class Figures {
    private Figures() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "ragdolls",
                "Figures on stairs",
                "Figures with cones at hips and shoulders, hinges at knees and elbows, fall on"
                        + " stairs.",
                "joints",
                List.of(Parameter.count("figures", 20, 1, 200, "figures")),
                600,
                150,
                Figures::build);
    }

    private static void build(SceneBuilder scene) {
        scene.floor(12, 12, 0.6, 0);
        for (int k = 0; k < 8; k++) {
            scene.add(
                    Box.of(3, 0.2 * (8 - k), 0.4),
                    Palette.body(3),
                    Body.fixed().at(0, 0.2 * (8 - k), 0.8 * k - 3));
        }
        int count = scene.count("figures");
        for (int k = 0; k < count; k++) {
            double x = 1.2 * (k % 5 - 2);
            figure(scene, x, 4.5 + 2.2 * (k / 5), -2.4 + 0.3 * (k % 3), k);
        }
        scene.view(new SceneBuilder.View(6, 5, 9, 0, 1.5, 0));
        Gaps.watch(scene, "gapMetres", 1);
    }

    private static BodyRef part(SceneBuilder scene, Capsule shape, int color, double[] at) {
        return scene.add(
                shape,
                Palette.body(color),
                Body.dynamic().at(at[0], at[1], at[2]).angularVelocity(at[3], 0, at[4]));
    }

    /** A figure, its hip at a point. */
    static void figure(SceneBuilder scene, double x, double y, double z, int k) {
        PhysicsWorld world = scene.world();
        double spin = 0.4 * (k % 3 - 1);
        BodyRef hip =
                scene.add(Box.of(0.16, 0.1, 0.1), Palette.body(k % 5), Body.dynamic().at(x, y, z));
        BodyRef chest =
                scene.add(
                        Box.of(0.18, 0.2, 0.11),
                        Palette.body(k % 5),
                        Body.dynamic().at(x, y + 0.34, z).angularVelocity(spin, 0, 0));
        world.add(
                Joint.ball(hip, chest)
                        .at(x, y + 0.12, z)
                        .axis(0, 1, 0)
                        .limits(0, 0.6)
                        .limits(JointAxis.TWIST, -0.5, 0.5));
        BodyRef head =
                scene.add(
                        Sphere.of(0.12), Palette.body(k % 5 + 1), Body.dynamic().at(x, y + 0.7, z));
        world.add(Joint.ball(chest, head).at(x, y + 0.57, z).axis(0, 1, 0).limits(0, 0.7));
        for (int side = -1; side <= 1; side += 2) {
            limb(scene, hip, x + 0.1 * side, y - 0.12, z, 0.07, 0.14, k, -2.2, 0);
            limb(scene, chest, x + 0.26 * side, y + 0.48, z, 0.05, 0.1, k, 0, 2.2);
        }
    }

    /** Upper and lower part of a limb that hangs from a point. */
    private static void limb(
            SceneBuilder scene,
            BodyRef trunk,
            double x,
            double y,
            double z,
            double radius,
            double half,
            int k,
            double low,
            double high) {
        PhysicsWorld world = scene.world();
        Capsule shape = Capsule.of(radius, half);
        double length = 2 * (half + radius);
        BodyRef upper =
                part(scene, shape, k % 5, new double[] {x, y - 0.5 * length, z, 0, 0});
        BodyRef lower =
                part(scene, shape, k % 5 + 1, new double[] {x, y - 1.5 * length, z, 0, 0});
        world.add(Joint.ball(trunk, upper).at(x, y, z).axis(0, -1, 0).limits(0, 1.3));
        world.add(
                Joint.hinge(upper, lower)
                        .at(x, y - length, z)
                        .axis(1, 0, 0)
                        .limits(low, high));
    }
}
