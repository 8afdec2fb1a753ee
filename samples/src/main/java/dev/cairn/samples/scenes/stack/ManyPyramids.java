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
 * A square of small pyramids, touching from the start. Truth: all stand as they were built.
 *
 * <p>With side 14 and base 10 it has the bodies of Box3D's benchmark {@code many_pyramids}: 14 x 14
 * pyramids of 55 unit boxes, density 100.
 */
public final class ManyPyramids {
    private static final double HALF = 0.5;
    private static final double AISLE = 4;

    private ManyPyramids() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "many-pyramids",
                "Many pyramids",
                "A square of pyramids of unit boxes, each one box thick, stands. With side=14"
                        + " base=10 it has the 10780 boxes of Box3D's many_pyramids.",
                "stacks",
                List.of(
                        Parameter.count("side", 3, 1, 40, "pyramids along x and along z"),
                        Parameter.count("base", 5, 1, 100, "boxes in a lowest row"),
                        Parameter.real("friction", 0.6, 0, 10, "Coulomb coefficient"),
                        Parameter.real("density", 100, 1e-3, 1e6, "density of the boxes, kg/m3")),
                100,
                100,
                ManyPyramids::build);
    }

    private static void build(SceneBuilder scene) {
        int side = scene.count("side");
        int base = scene.count("base");
        double friction = scene.get("friction");
        Material material = new Material(friction, 0, scene.get("density"));
        double pitchX = 2 * HALF * base + AISLE;
        double reach = side * Math.max(pitchX, AISLE);
        scene.floor(reach, reach, friction, 0);
        Box box = Box.cubeOfHalfExtent(HALF);
        List<BodyRef> boxes = new ArrayList<>();
        List<Vector3d> starts = new ArrayList<>();
        for (int p = 0; p < side * side; p++) {
            double x0 = pitchX * (p % side - (side - 1) / 2.0);
            int line = p / side;
            double z0 = AISLE * (line - (side - 1) / 2.0);
            for (int row = 0; row < base; row++) {
                for (int i = 0; i < base - row; i++) {
                    Vector3d at =
                            new Vector3d(
                                    x0 + (row + 1 - base) * HALF + 2 * HALF * i,
                                    (2 * row + 1) * HALF,
                                    z0);
                    boxes.add(
                            scene.add(
                                    box,
                                    Palette.body(p),
                                    Body.dynamic().at(at.x, at.y, at.z).material(material)));
                    starts.add(at);
                }
            }
        }
        scene.view(new SceneView(0.3 * reach, 0.4 * reach + 8, 0.7 * reach + 8, 0, 2, 0));
        scene.error(
                "driftMetres",
                () -> {
                    double worst = 0;
                    for (int i = 0; i < boxes.size(); i++) {
                        worst = Math.max(worst, boxes.get(i).position().distance(starts.get(i)));
                    }
                    return worst;
                });
    }
}
