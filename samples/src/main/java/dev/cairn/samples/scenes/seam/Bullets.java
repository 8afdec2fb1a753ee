package dev.cairn.samples.scenes.seam;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;

import java.util.ArrayList;
import java.util.List;

/**
 * Rods, plates, bricks, capsules and balls fly at a thin wall, turned and spinning anyhow.
 *
 * <p>Truth: none passes.
 */
public final class Bullets {
    private Bullets() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "bullets",
                "Bullets",
                "Rods, plates and bricks fly at a thin wall; none passes.",
                "collisions",
                List.of(
                        Parameter.count("bodies", 60, 1, 500, "number of bodies"),
                        Parameter.real("speed", 1000, 10, 10_000, "speed, m/s"),
                        Parameter.real("thickness", 0.001, 0.001, 1, "of the wall, m"),
                        Parameter.real("spin", 50, 0, 200, "largest spin, rad/s")),
                60,
                30,
                Bullets::build);
    }

    private static void build(SceneBuilder scene) {
        double speed = scene.get("speed");
        double thick = scene.get("thickness");
        double spin = scene.get("spin");
        int count = scene.count("bodies");
        double pitch = 1.5;
        int perRow = 10;
        double wide = pitch * perRow;
        double high = pitch * (2 + count / (double) perRow);
        scene.add(
                Box.ofHalfExtents(thick / 2, high / 2 + 20, wide),
                Palette.STONE,
                Body.fixed().at(0, high / 2, 0).name("wall"));
        List<BodyRef> bodies = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            Shape shape =
                    switch (i % 5) {
                        case 0 -> Box.ofHalfExtents(0.5, 0.02, 0.02);
                        case 1 -> Box.ofHalfExtents(0.3, 0.3, 0.005);
                        case 2 -> Box.ofHalfExtents(0.1, 0.05, 0.03);
                        case 3 -> Capsule.of(0.02, 0.3);
                        default -> Sphere.of(0.05);
                    };
            int row = i / perRow;
            bodies.add(
                    scene.add(
                            shape,
                            Palette.body(i),
                            Body.dynamic()
                                    .at(
                                            -2 - scene.random(0, 1) * speed / 60,
                                            2 + pitch * row,
                                            pitch * (i % perRow + 0.5) - wide / 2)
                                    .rotationAbout(
                                            scene.random(-0.5, 0.5),
                                            scene.random(-0.5, 0.5),
                                            1,
                                            scene.random(0, 6))
                                    .angularVelocity(
                                            scene.random(-spin / 2, spin / 2),
                                            scene.random(-spin / 2, spin / 2),
                                            scene.random(-spin / 2, spin / 2))
                                    .velocity(speed, 0, 0)));
        }
        scene.view(new SceneView(-8, high / 2, wide, 0, high / 2, 0));
        scene.error(
                "passed",
                () -> {
                    int passed = 0;
                    for (BodyRef body : bodies) {
                        passed += body.position().x > thick / 2 ? 1 : 0;
                    }
                    return passed;
                });
    }
}
