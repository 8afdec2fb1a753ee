package dev.cairn.samples.scenes.seam;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;

import java.util.List;

/**
 * A long rod spins so fast that it passes a quarter turn in a tick, and meets a ball.
 *
 * <p>Truth: the ball leaves with the impulse of two rigid bodies, {@code 2 w x/(1/m + 1/M + x²/I)}.
 */
public final class SpinningRod {
    private static final double HALF = 2;
    private static final double THIN = 0.02;
    private static final double RADIUS = 0.1;
    private static final double MASS = 10;

    private SpinningRod() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "spinning-rod",
                "Spinning rod",
                "A rod that spins fast meets a ball at the speed that it has there.",
                "collisions",
                List.of(
                        Parameter.real("spin", 120, 1, 1000, "of the rod, rad/s"),
                        Parameter.real("place", 1.7, 0.5, 1.9, "of the ball along the rod, m")),
                30,
                10,
                SpinningRod::build);
    }

    private static void build(SceneBuilder scene) {
        double spin = scene.get("spin");
        double place = scene.get("place");
        double height = 3;
        scene.world().setGravity(0, 0, 0);
        Material surface = Palette.material(0, 1);
        scene.add(
                Box.ofHalfExtents(HALF, THIN, THIN),
                Palette.body(1),
                Body.dynamic()
                        .mass(MASS)
                        .at(0, height, 0)
                        .angularVelocity(0, 0, spin)
                        .material(surface));
        BodyRef ball =
                scene.add(
                        Sphere.of(RADIUS),
                        Palette.body(2),
                        Body.dynamic().mass(1).at(0, height + place, 0).material(surface));
        double[] speed = {0};
        scene.afterTick((tick, seconds) -> {
            if (speed[0] == 0) {
                speed[0] = ball.velocity().length();
            }
        });
        // the ball's middle is the radius and half of the rod's width beside its axis
        double beside = RADIUS + THIN;
        double x = StrictMath.sqrt(place * place - beside * beside);
        double inertia = MASS * (HALF * HALF + THIN * THIN) / 3;
        double truth = 2 * spin * x / (1 + 1 / MASS + x * x / inertia);
        scene.view(new SceneView(0, height, 9, 0, height, 0));
        scene.error("impulseRelative", () -> speed[0] == 0 ? 0 : Math.abs(speed[0] / truth - 1));
    }
}
