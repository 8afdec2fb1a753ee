package dev.cairn.samples.scenes;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Shape;
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
 * Work for the broad phase, and for nothing else: a lattice of fixed boxes, and balls and spinning
 * boxes that fall through its shafts, close by fixed boxes and touching none.
 *
 * <p>Truth: {@code y0 - g t²/2}, straight down.
 */
public final class Shafts {
    private static final double PITCH = 1.2;
    private static final double HALF = 0.3;
    private static final double RADIUS = 0.25;
    private static final double SMALL = 0.15;

    /** From each other in a shaft, m. They fall alike, so it stays. */
    private static final double APART = 2;

    private static final double SPIN = 3;

    private Shafts() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "shafts",
                "Shafts",
                "Balls and boxes fall through a lattice of fixed boxes and touch nothing.",
                "motion",
                List.of(
                        Parameter.count("side", 9, 2, 100, "fixed boxes along each side"),
                        Parameter.count("bodies", 2, 1, 100, "bodies in each shaft")),
                120,
                60,
                Shafts::build);
    }

    private static void build(SceneBuilder scene) {
        int side = scene.count("side");
        int each = scene.count("bodies");
        double middle = 0.5 * PITCH * (side - 1);
        Box pillar = Box.cubeOfHalfExtent(HALF);
        for (int i = 0; i < side * side * side; i++) {
            int line = i / side;
            int layer = line / side;
            double x = PITCH * (i % side) - middle;
            double y = PITCH * (line % side);
            double z = PITCH * layer - middle;
            scene.add(pillar, Palette.STONE, Body.fixed().at(x, y, z));
        }
        List<BodyRef> bodies = new ArrayList<>();
        List<Vector3d> starts = new ArrayList<>();
        double top = PITCH * side;
        for (int i = 0; i < (side - 1) * (side - 1); i++) {
            int line = i / (side - 1);
            double x = PITCH * (i % (side - 1) + 0.5) - middle;
            double z = PITCH * (line + 0.5) - middle;
            for (int k = 0; k < each; k++) {
                Shape shape = (i + k) % 2 == 0 ? Sphere.of(RADIUS) : Box.cubeOfHalfExtent(SMALL);
                Vector3d start = new Vector3d(x, top + APART * k + scene.random(0, 1), z);
                bodies.add(
                        scene.add(
                                shape,
                                Palette.body(i + k),
                                Body.dynamic()
                                        .at(start.x, start.y, start.z)
                                        .angularVelocity(SPIN, 0.5 * SPIN, -SPIN)));
                starts.add(start);
            }
        }
        scene.view(new SceneView(1.1 * top, 1.2 * top, 1.6 * top, 0, 0.5 * top, 0));
        double[] worst = {0};
        Vector3d at = new Vector3d();
        scene.afterTick((tick, seconds) -> {
            double fallen = 0.5 * SampleScene.GRAVITY * seconds * seconds;
            for (int i = 0; i < bodies.size(); i++) {
                bodies.get(i).position(at);
                worst[0] = Math.max(worst[0], at.add(0, fallen, 0).distance(starts.get(i)));
            }
        });
        scene.error("offMetres", () -> worst[0]);
    }
}
