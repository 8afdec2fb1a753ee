package dev.cairn.samples.scenes.seam;

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
 * Balls pass the sides of posts at clearances from a hundredth of a metre down to a millionth.
 *
 * <p>Truth: they fall as if nothing were there.
 */
public final class NearMiss {
    private static final double RADIUS = 0.1;
    private static final int BALLS = 5;

    private NearMiss() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "near-miss",
                "Near miss",
                "Balls pass posts at a clearance and are not deflected.",
                "collisions",
                List.of(Parameter.real("speed", 20, 2, 1000, "speed, m/s")),
                15,
                8,
                NearMiss::build);
    }

    private static void build(SceneBuilder scene) {
        double speed = scene.get("speed");
        List<BodyRef> balls = new ArrayList<>();
        for (int i = 0; i < BALLS; i++) {
            double clearance = StrictMath.pow(10, -2 - i);
            double z = 3 * i;
            scene.add(
                    Box.ofHalfExtents(0.2, 2, 0.2),
                    Palette.STONE,
                    Body.fixed().at(0, 2, z - 0.2 - RADIUS - clearance));
            balls.add(
                    scene.add(
                            Sphere.of(RADIUS),
                            Palette.body(i),
                            Body.dynamic().at(-0.2 - 0.055 * speed, 3, z).velocity(speed, 0, 0)));
        }
        double[] worst = {0};
        scene.afterTick((tick, seconds) -> {
            for (BodyRef ball : balls) {
                var v = ball.velocity().sub(speed, -SampleScene.GRAVITY * seconds, 0);
                worst[0] = Math.max(worst[0], v.length());
            }
        });
        scene.view(new SceneView(-6, 5, 14, 0, 2, 6));
        scene.error("deflectionMetresPerSecond", () -> worst[0]);
    }
}
