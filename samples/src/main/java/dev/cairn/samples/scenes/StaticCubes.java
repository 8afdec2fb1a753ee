package dev.cairn.samples.scenes;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
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
 * A hundred static cubes. Truth: none moves, there is no contact, and a tick costs next to nothing.
 */
public final class StaticCubes {
    private static final int SIDE = 10;

    private StaticCubes() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "static-100",
                "A hundred static cubes",
                "Ten by ten static cubes. Nothing moves and nothing may cost time.",
                "grids",
                List.of(
                        Parameter.real(
                                "spacing", 1.5, 0.1, 100, "distance of the cubes' centres, m")),
                120,
                1,
                StaticCubes::build);
    }

    private static void build(SceneBuilder scene) {
        double spacing = scene.get("spacing");
        Box cube = Box.cubeOfHalfExtent(0.5);
        List<BodyRef> cubes = new ArrayList<>();
        List<Vector3d> starts = new ArrayList<>();
        for (int i = 0; i < SIDE * SIDE; i++) {
            int row = i / SIDE;
            double x = spacing * (i % SIDE - (SIDE - 1) / 2.0);
            double z = spacing * (row - (SIDE - 1) / 2.0);
            cubes.add(
                    scene.add(
                            cube,
                            Palette.body(i % SIDE + i / SIDE),
                            Body.fixed().at(x, 0.5, z).name("cube " + i)));
            starts.add(new Vector3d(x, 0.5, z));
        }
        double reach = spacing * SIDE;
        scene.view(new SceneView(0.5 * reach, 0.75 * reach, 1.1 * reach, 0, 0, 0.1 * reach));
        scene.error(
                "movedMetres",
                () -> {
                    double worst = 0;
                    for (int i = 0; i < starts.size(); i++) {
                        worst = Math.max(worst, cubes.get(i).position().distance(starts.get(i)));
                    }
                    return worst;
                });
    }
}
