package dev.cairn.samples.scenes.seam;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;

import org.joml.Vector3d;

import java.util.ArrayList;
import java.util.List;

/**
 * Elastic balls fly about in a box of thin walls, without gravity.
 *
 * <p>Truth: none leaves, and the energy is constant.
 */
public final class Gas {
    private static final double RADIUS = 0.2;
    private static final double PITCH = 1.1;

    private Gas() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "gas",
                "Gas",
                "Elastic balls fly about in a closed box; none leaves, and no energy is lost.",
                "collisions",
                List.of(
                        Parameter.count("edge", 5, 2, 10, "balls along an edge"),
                        Parameter.real("speed", 50, 1, 1000, "root of their mean square, m/s"),
                        Parameter.real("thickness", 0.1, 0.001, 1, "of the walls, m")),
                60,
                30,
                Gas::build);
    }

    private static void build(SceneBuilder scene) {
        int edge = scene.count("edge");
        double speed = scene.get("speed");
        double thick = scene.get("thickness") / 2;
        double half = edge * PITCH / 2;
        double middle = half + 2 * thick;
        scene.world().setGravity(0, 0, 0);
        Material surface = Palette.material(0, 1);
        for (int i = 0; i < 6; i++) {
            int axis = i / 2;
            double side = (i % 2 == 0 ? -1 : 1) * (half + thick);
            scene.add(
                    Box.ofHalfExtents(
                            axis == 0 ? thick : half + 2 * thick,
                            axis == 1 ? thick : half + 2 * thick,
                            axis == 2 ? thick : half + 2 * thick),
                    Palette.STONE,
                    Body.fixed()
                            .at(
                                    axis == 0 ? side : 0,
                                    middle + (axis == 1 ? side : 0),
                                    axis == 2 ? side : 0)
                            .material(surface));
        }
        List<BodyRef> balls = new ArrayList<>();
        double energy = 0;
        for (int i = 0; i < edge * edge * edge; i++) {
            int layer = i / (edge * edge);
            Vector3d v =
                    new Vector3d(scene.random(-1, 1), scene.random(-1, 1), scene.random(-1, 1))
                            .mul(speed);
            energy += v.lengthSquared() / 2;
            balls.add(
                    scene.add(
                            Sphere.of(RADIUS),
                            Palette.body(i),
                            Body.dynamic()
                                    .mass(1)
                                    .at(
                                            PITCH * (i % edge + 0.5) - half,
                                            middle + PITCH * (i / edge % edge + 0.5) - half,
                                            PITCH * (layer + 0.5) - half)
                                    .velocity(v)
                                    .material(surface)));
        }
        double start = energy;
        scene.view(new SceneView(0, middle, 4 * half, 0, middle, 0));
        scene.error(
                "leaked",
                () -> {
                    int out = 0;
                    for (BodyRef ball : balls) {
                        Vector3d p = ball.position().sub(0, middle, 0).absolute();
                        out += Math.max(p.x, Math.max(p.y, p.z)) < half ? 0 : 1;
                    }
                    return out;
                });
        scene.error(
                "energyRelative",
                () -> {
                    double now = 0;
                    for (BodyRef ball : balls) {
                        now += ball.velocity().lengthSquared() / 2;
                        now += ball.angularVelocity().lengthSquared() * 0.2 * RADIUS * RADIUS;
                    }
                    return Math.abs(now / start - 1);
                });
    }
}
