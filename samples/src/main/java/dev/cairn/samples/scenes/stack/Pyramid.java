package dev.cairn.samples.scenes.stack;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.shape.Box;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;

import org.joml.Vector3d;

import java.util.ArrayList;
import java.util.List;

/**
 * A wall-like pyramid of unit boxes, touching from the start. Truth: it stands as it was built.
 *
 * <p>With base 100 it is Box3D's benchmark {@code large_pyramid}: 5050 boxes, density 100, friction
 * 0.6, ground 400 x 1 x 400 m.
 */
public final class Pyramid {
    private static final double HALF = 0.5;

    private Pyramid() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "pyramid",
                "Pyramid",
                "A pyramid of unit boxes, one box thick, stands. With base=100 it is Box3D's"
                        + " large_pyramid, 5050 boxes.",
                "stacks",
                List.of(
                        Parameter.count("base", 20, 1, 400, "boxes in the lowest row"),
                        Parameter.real("friction", 0.6, 0, 10, "Coulomb coefficient"),
                        Parameter.real("density", 100, 1e-3, 1e6, "density of the boxes, kg/m3")),
                200,
                200,
                Pyramid::build);
    }

    private static void build(SceneBuilder scene) {
        int base = scene.count("base");
        double friction = scene.get("friction");
        Material material = new Material(friction, 0, scene.get("density"));
        scene.floor(200, 200, friction, 0);
        Box box = Box.cubeOfHalfExtent(HALF);
        List<BodyRef> boxes = new ArrayList<>();
        List<Vector3d> starts = new ArrayList<>();
        for (int row = 0; row < base; row++) {
            for (int i = 0; i < base - row; i++) {
                double x = (row + 1 - base) * HALF + 2 * HALF * i;
                double y = (2 * row + 1) * HALF;
                boxes.add(
                        scene.add(
                                box,
                                Palette.body(row),
                                Body.dynamic().at(x, y, 0).material(material)));
                starts.add(new Vector3d(x, y, 0));
            }
        }
        scene.view(new SceneView(0.48 * base, 0.55 * base + 1, 1.3 * base + 3, 0, 0.45 * base, 0));
        scene.error(
                "driftMetres",
                () -> {
                    double worst = 0;
                    for (int i = 0; i < boxes.size(); i++) {
                        worst = Math.max(worst, boxes.get(i).position().distance(starts.get(i)));
                    }
                    return worst;
                });
        scene.error(
                "sagMetres",
                () -> {
                    double worst = 0;
                    for (int i = 0; i < boxes.size(); i++) {
                        worst = Math.max(worst, starts.get(i).y - boxes.get(i).position().y);
                    }
                    return worst;
                });
    }
}
