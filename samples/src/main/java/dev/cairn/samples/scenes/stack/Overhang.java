package dev.cairn.samples.scenes.stack;

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
 * Planks that hang over the edge of a table by the harmonic series.
 *
 * <p>Truth: plank i from the top reaches beyond the one below by {@code f L/(2 i)}; with f &lt;= 1
 * all stand, with f &gt; 1 they tip (every centre of mass lies above an edge at f = 1).
 */
public final class Overhang {
    private static final double LENGTH = 2;
    private static final double HALF_HEIGHT = 0.1;
    private static final double TABLE = 1.5;

    private Overhang() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "overhang",
                "Overhang",
                "Six planks reach over the edge of a table by the harmonic series; with f above 1"
                        + " they tip.",
                "structures",
                List.of(
                        Parameter.count("planks", 6, 1, 30, "number of planks"),
                        Parameter.real(
                                "f", 0.98, 0.1, 1.2, "overhang over that at which they tip")),
                600,
                300,
                Overhang::build);
    }

    private static void build(SceneBuilder scene) {
        int planks = scene.count("planks");
        double f = scene.get("f");
        scene.floor(10, 6, 0.6, 0);
        scene.add(
                Box.ofHalfExtents(2, 0.5 * TABLE, 1),
                Palette.STONE,
                Body.fixed().at(-2, 0.5 * TABLE, 0).name("table"));
        Box shape = Box.ofHalfExtents(0.5 * LENGTH, HALF_HEIGHT, 0.4);
        List<BodyRef> pile = new ArrayList<>();
        double[] places = new double[planks];
        double x = -0.5 * LENGTH;
        for (int k = 0; k < planks; k++) {
            // the lowest is the planks-th from the top
            x += f * LENGTH / (2.0 * (planks - k));
            places[k] = x;
            pile.add(
                    scene.add(
                            shape,
                            Palette.body(k),
                            Body.dynamic()
                                    .at(x, TABLE + HALF_HEIGHT * (2 * k + 1), 0)
                                    .name("plank " + k)));
        }
        scene.view(new SceneView(3.2, 3.4, 7, 0.4, 1.9, 0));
        Vector3d at = new Vector3d();
        scene.error(
                "movedMetres",
                () -> {
                    double worst = 0;
                    for (int k = 0; k < planks; k++) {
                        pile.get(k).position(at);
                        worst =
                                Math.max(
                                        worst,
                                        at.distance(
                                                places[k], TABLE + HALF_HEIGHT * (2 * k + 1), 0));
                    }
                    return worst;
                });
    }
}
