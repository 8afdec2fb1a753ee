package dev.cairn.samples.scenes;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.shape.Box;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;

import java.util.List;

/**
 * A box of 20 m on two of 1 m, 8000 times as heavy as each.
 *
 * <p>Truth: it rests on them, 1 m above the ground. Solver2D's HighMassRatio 2 and 3.
 */
public final class BigOnSmall {
    private BigOnSmall() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "big-on-small",
                "Big on small",
                "A box of 8000 t rests on two boxes of 1 t; with drop=6 it falls on them.",
                "stacks",
                List.of(
                        Parameter.real("drop", 0, 0, 20, "height of the fall, m"),
                        Parameter.real("size", 20, 2.5, 100, "edge of the big box, m")),
                600,
                300,
                BigOnSmall::build);
    }

    private static void build(SceneBuilder scene) {
        double size = scene.get("size");
        scene.floor(2 * size, 2 * size, 0.6, 0);
        Box small = Box.cubeOfHalfExtent(0.5);
        double reach = 0.45 * size;
        BodyRef left = scene.add(small, Palette.body(0), Body.dynamic().at(-reach, 0.5, 0));
        BodyRef right = scene.add(small, Palette.body(1), Body.dynamic().at(reach, 0.5, 0));
        BodyRef big =
                scene.add(
                        Box.cubeOfHalfExtent(0.5 * size),
                        Palette.STONE,
                        Body.dynamic().at(0, 1 + 0.5 * size + scene.get("drop"), 0));
        scene.view(new SceneView(0.35 * size, 0.05 * size, 2.2 * size, 0, 0.42 * size, 0));
        Ramp.Metric deepest = new Ramp.Metric();
        scene.afterTick((tick, seconds) -> deepest.raise(1 + 0.5 * size - big.position().y));
        scene.error("sagMetres", () -> 1 + 0.5 * size - big.position().y);
        scene.error("deepestMetres", deepest::get);
        scene.error(
                "smallSagMetres",
                () -> Math.max(0.5 - left.position().y, 0.5 - right.position().y));
    }
}
