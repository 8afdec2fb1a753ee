package dev.cairn.samples.scenes;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;

import java.util.ArrayList;
import java.util.List;

/**
 * Few bodies in a world of many fixed ones: a square of fixed boxes, 10 m apart, and balls that
 * fall onto some of them. A fixed body that nothing touches should cost nothing.
 *
 * <p>Truth: a ball rests at the height of its box's top and its own radius. After Box3D's benchmark
 * {@code large_world}, which has 1000 x 1000 boxes and drops 100 balls every five steps.
 */
public final class LargeWorld {
    private static final double PITCH = 10;
    private static final double HALF = 0.5;
    private static final double RADIUS = 0.25;
    private static final double DROP = 0.5;

    /** A fall of half a metre takes 0.32 s; bounces there are none. */
    private static final double RESTS_SECONDS = 1.5;

    private LargeWorld() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "large-world",
                "Large world",
                "Balls fall onto some of many fixed boxes. After Box3D's large_world.",
                "motion",
                List.of(
                        Parameter.count("side", 20, 1, 1000, "fixed boxes along x and along z"),
                        Parameter.count("balls", 20, 1, 10_000, "balls, at most one per box")),
                150,
                60,
                LargeWorld::build);
    }

    private static void build(SceneBuilder scene) {
        int side = scene.count("side");
        int boxes = side * side;
        int count = Math.min(boxes, scene.count("balls"));
        Box box = Box.cubeOfHalfExtent(HALF);
        Sphere sphere = Sphere.of(RADIUS);
        List<BodyRef> balls = new ArrayList<>();
        for (int i = 0; i < boxes; i++) {
            int line = i / side;
            double x = PITCH * (i % side - (side - 1) / 2.0);
            double z = PITCH * (line - (side - 1) / 2.0);
            scene.add(
                    box,
                    Palette.STONE,
                    Body.fixed().at(x, -HALF, z).material(Palette.material(0.6, 0)));
            // spread evenly over the boxes, each on one of its own
            long before = (long) i * count / boxes;
            if ((i + 1L) * count / boxes > before) {
                balls.add(
                        scene.add(
                                sphere,
                                Palette.body((int) before),
                                Body.dynamic()
                                        .at(x, RADIUS + DROP, z)
                                        .material(Palette.material(0.6, 0))));
            }
        }
        double reach = PITCH * side;
        scene.view(new SceneView(0.2 * reach, 0.1 * reach + 4, 0.3 * reach + 4, 0, 0, 0));
        double[] worst = {0};
        scene.afterTick((tick, seconds) -> {
            for (int i = 0; seconds > RESTS_SECONDS && i < balls.size(); i++) {
                worst[0] = Math.max(worst[0], Math.abs(balls.get(i).position().y() - RADIUS));
            }
        });
        scene.error("sagMetres", () -> worst[0]);
    }
}
