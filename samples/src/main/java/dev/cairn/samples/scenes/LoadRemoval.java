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
 * A heavy box on light ones is taken away.
 *
 * <p>Truth: nothing moves. A solver that remembers the old load as a warm start, or holds it by
 * overlap, shoots the light boxes up. Solver2D's scene WarmStartEnergy, with boxes.
 */
public final class LoadRemoval {
    private static final double HALF = 0.5;

    private LoadRemoval() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "load-removal",
                "Load taken away",
                "A box of 100 kg on five of 1 kg vanishes after four seconds; the five stay where"
                        + " they are.",
                "stacks",
                List.of(
                        Parameter.count("boxes", 5, 1, 40, "number of light boxes, 1 kg each"),
                        Parameter.real("load", 100, 1, 1e6, "mass of the heavy box, kg"),
                        Parameter.real("seconds", 4, 0.1, 60, "time at which it vanishes, s")),
                480,
                200,
                LoadRemoval::build);
    }

    private static void build(SceneBuilder scene) {
        int boxes = scene.count("boxes");
        scene.floor(6, 6, 0.6, 0);
        Box shape = Box.cubeOfHalfExtent(HALF);
        List<BodyRef> stack = new ArrayList<>();
        for (int k = 0; k < boxes; k++) {
            stack.add(
                    scene.add(
                            shape,
                            Palette.body(k),
                            Body.dynamic()
                                    .at(
                                            scene.random(-1e-3, 1e-3),
                                            k + HALF,
                                            scene.random(-1e-3, 1e-3))
                                    .rotationAbout(0, 1, 0, scene.random(-0.01, 0.01))
                                    .mass(1)
                                    .name("box " + k)));
        }
        BodyRef load =
                scene.add(
                        shape,
                        Palette.STONE,
                        Body.dynamic().at(0, boxes + HALF, 0).mass(scene.get("load")).name("load"));
        double distance = 5 + 1.4 * boxes;
        scene.view(
                new SceneView(
                        0.5 * distance, 0.3 * distance + 1, 0.8 * distance, 0, 0.5 * boxes, 0));

        double seconds = scene.get("seconds");
        scene.beforeTick((tick, end) -> {
            if (load.isAlive() && end > seconds) {
                load.remove();
            }
        });
        Ramp.Metric up = new Ramp.Metric();
        Ramp.Metric gap = new Ramp.Metric();
        Vector3d v = new Vector3d();
        scene.afterTick((tick, end) -> {
            if (load.isAlive()) {
                return;
            }
            double last = -HALF;
            for (int k = 0; k < boxes; k++) {
                up.raise(stack.get(k).velocity(v).y);
                double y = stack.get(k).position(v).y;
                gap.raise(y - last - 2 * HALF);
                last = y;
            }
        });
        scene.error("upMetresPerSecond", up::get);
        scene.error("gapMetres", gap::get);
    }
}
