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

/** Eighteen cubes, nine columns of two, dropped onto a plane. Truth: they stand where they fell. */
public final class CubesOnPlane {
    private static final int SIDE = 3;
    private static final int LAYERS = 2;
    private static final double HALF = 0.5;
    private static final double CALM = 2;

    private CubesOnPlane() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "cubes-18",
                "Eighteen cubes on a plane",
                "Nine columns of two unit cubes fall a little way onto a plane, and stand.",
                "stacks",
                List.of(
                        Parameter.real(
                                "drop",
                                0.2,
                                0,
                                10,
                                "free fall of the lower cubes, and between the layers, m"),
                        Parameter.real("spacing", 1.6, 1.001, 10, "distance of the columns, m"),
                        Parameter.real("friction", 0.6, 0, 10, "Coulomb coefficient"),
                        Parameter.real("mass", 1, 1e-3, 1e6, "mass of each cube, kg")),
                240,
                200,
                CubesOnPlane::build);
    }

    private static void build(SceneBuilder scene) {
        double drop = scene.get("drop");
        double spacing = scene.get("spacing");
        double friction = scene.get("friction");
        double mass = scene.get("mass");
        scene.floor(SIDE * spacing, SIDE * spacing, friction, 0);
        Box cube = Box.cubeOfHalfExtent(HALF);
        List<BodyRef> cubes = new ArrayList<>();
        for (int layer = 0; layer < LAYERS; layer++) {
            for (int i = 0; i < SIDE * SIDE; i++) {
                int row = i / SIDE;
                cubes.add(
                        scene.add(
                                cube,
                                Palette.body(i + layer),
                                Body.dynamic()
                                        .at(
                                                spacing * (i % SIDE - (SIDE - 1) / 2.0),
                                                HALF + layer + (layer + 1) * drop,
                                                spacing * (row - (SIDE - 1) / 2.0))
                                        .mass(mass)
                                        .material(Palette.material(friction, 0))
                                        .name("cube " + cubes.size())));
            }
        }
        double reach = SIDE * spacing;
        scene.view(new SceneView(0.9 * reach, 0.9 * reach, 1.5 * reach, 0, 0.6, 0));

        double calm = StrictMath.sqrt(2 * LAYERS * drop / SampleScene.GRAVITY) + CALM;
        List<Vector3d> rest = new ArrayList<>();
        scene.afterTick((tick, seconds) -> {
            if (rest.isEmpty() && seconds >= calm) {
                for (BodyRef body : cubes) {
                    rest.add(body.position());
                }
            }
        });
        scene.error(
                "sagMetres",
                () -> {
                    double worst = 0;
                    for (int i = 0; i < cubes.size(); i++) {
                        int layer = i / (SIDE * SIDE);
                        double height = HALF + layer;
                        worst = Math.max(worst, Math.abs(cubes.get(i).position().y - height));
                    }
                    return rest.isEmpty() ? Double.NaN : worst;
                });
        scene.error(
                "creepMetres",
                () -> {
                    double worst = 0;
                    for (int i = 0; i < rest.size(); i++) {
                        Vector3d moved = cubes.get(i).position().sub(rest.get(i));
                        worst =
                                Math.max(
                                        worst,
                                        StrictMath.sqrt(moved.x * moved.x + moved.z * moved.z));
                    }
                    return rest.isEmpty() ? Double.NaN : worst;
                });
    }
}
