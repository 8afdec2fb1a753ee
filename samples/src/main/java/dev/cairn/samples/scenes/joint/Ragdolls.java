package dev.cairn.samples.scenes.joint;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.joint.Joint;
import dev.cairn.physics.joint.JointAxis;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;

import java.util.List;

/**
 * Figures of eleven bodies fall down stairs and come to rest.
 *
 * <p>Truth: no joint is ever apart by more than a thousandth of its link of 0.3 m.
 */
public final class Ragdolls {
    private static final int STEPS = 12;

    private Ragdolls() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "ragdolls",
                "Ragdolls",
                "Figures of eleven bodies with limits at every joint fall down stairs.",
                "joints",
                List.of(Parameter.count("figures", 20, 1, 100, "how many")),
                600,
                150,
                Ragdolls::build);
    }

    private static void build(SceneBuilder scene) {
        scene.floor(20, 20, 0.6, 0);
        for (int k = 0; k < STEPS; k++) {
            double height = 0.25 * (STEPS - k);
            scene.add(
                    Box.ofHalfExtents(0.25, 0.5 * height, 4),
                    Palette.STONE,
                    Body.fixed().at(-3 + 0.5 * k, 0.5 * height, 0));
        }
        for (int k = 0; k < scene.count("figures"); k++) {
            int row = k / 5;
            figure(scene, -2.5 + 0.6 * (k % 3), 4.2 + 1.1 * row, -3 + 1.5 * (k % 5), k);
        }
        scene.view(new SceneView(4.2, 4.2, 6.6, -0.9, 1.1, -0.1));
        Gaps.watchPoints(scene);
    }

    private static void figure(SceneBuilder scene, double x, double y, double z, int color) {
        BodyRef pelvis = part(scene, Capsule.of(0.12, 0.08), 12, x, y, z, true, color);
        BodyRef chest = part(scene, Capsule.of(0.14, 0.1), 20, x, y + 0.4, z, true, color);
        BodyRef head =
                scene.add(
                        Sphere.of(0.12),
                        Palette.body(color),
                        Body.dynamic().mass(5).at(x, y + 0.72, z).velocity(1.5, 0, 0));
        cone(scene, pelvis, chest, x, y + 0.2, z, 0, 1, 0.4);
        cone(scene, chest, head, x, y + 0.57, z, 0, 1, 0.6);
        for (int side = -1; side <= 1; side += 2) {
            double out = z + 0.24 * side;
            BodyRef upper = limb(scene, 0.06, 2.5, x, y + 0.3, z + 0.3 * side, color);
            BodyRef lower = limb(scene, 0.05, 1.5, x, y, z + 0.3 * side, color);
            cone(scene, chest, upper, x, y + 0.45, out, side, -1, 1.3);
            bend(scene, upper, lower, x, y + 0.15, z + 0.3 * side, -2.2, 0);
            BodyRef thigh = limb(scene, 0.08, 7, x, y - 0.28, z + 0.12 * side, color);
            BodyRef shin = limb(scene, 0.06, 4, x, y - 0.58, z + 0.12 * side, color);
            cone(scene, pelvis, thigh, x, y - 0.13, z + 0.12 * side, 0, -1, 0.9);
            bend(scene, thigh, shin, x, y - 0.43, z + 0.12 * side, 0, 2.2);
        }
    }

    private static BodyRef limb(
            SceneBuilder scene, double r, double mass, double x, double y, double z, int color) {
        return part(scene, Capsule.of(r, 0.15 - r), mass, x, y, z, false, color);
    }

    private static BodyRef part(
            SceneBuilder scene,
            Capsule shape,
            double mass,
            double x,
            double y,
            double z,
            boolean lies,
            int color) {
        Body body = Body.dynamic().mass(mass).at(x, y, z).velocity(1.5, 0, 0);
        return scene.add(
                shape, Palette.body(color), lies ? body.rotationAbout(1, 0, 0, Math.PI / 2) : body);
    }

    /** A ball joint that lets B swing and twist within limits about an axis in the y-z plane. */
    private static void cone(
            SceneBuilder scene,
            BodyRef a,
            BodyRef b,
            double x,
            double y,
            double z,
            double axisZ,
            double axisY,
            double angle) {
        scene.world()
                .add(
                        Joint.ball(a, b)
                                .at(x, y, z)
                                .axis(0, axisY, axisZ)
                                .limits(0, angle)
                                .limits(JointAxis.TWIST, -0.5, 0.5));
    }

    private static void bend(
            SceneBuilder scene,
            BodyRef a,
            BodyRef b,
            double x,
            double y,
            double z,
            double from,
            double to) {
        scene.world().add(Joint.hinge(a, b).at(x, y, z).axis(0, 0, 1).limits(-to, -from));
    }
}
