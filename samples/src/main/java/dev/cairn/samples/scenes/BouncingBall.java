package dev.cairn.samples.scenes;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;

import org.joml.Vector3d;

import java.util.List;

/**
 * A ball falls onto a plate and bounces.
 *
 * <p>Truth: parabolas between instants of impact, at each of which the speed is multiplied by -e.
 * The metric is the root of the mean squared height error relative to the height of the fall, over
 * the time in which the closed form still bounces above a tenth of that height.
 */
public final class BouncingBall {
    private static final double RADIUS = 0.1;
    private static final double LOWEST_APEX = 0.1;

    private BouncingBall() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "bouncing-ball",
                "Bouncing ball",
                "A ball falls onto a plate and bounces; every apex is e² of the one before.",
                "motion",
                List.of(
                        Parameter.real("height", 1, 0.01, 1000, "height of the fall, m"),
                        Parameter.real("restitution", 0.7, 0, 1, "coefficient of restitution")),
                120,
                30,
                BouncingBall::build);
    }

    private static void build(SceneBuilder scene) {
        double height = scene.get("height");
        double e = scene.get("restitution");
        scene.floor(4, 4, 0, e);
        BodyRef ball =
                scene.add(
                        Sphere.of(RADIUS),
                        Palette.BASKETBALL,
                        Body.dynamic()
                                .at(0, RADIUS + height, 0)
                                .mass(1)
                                .material(Palette.material(0, e))
                                .name("ball"));
        scene.view(new SceneView(0, 0.8 * height, 2.5 * height + 1, 0, 0.5 * height, 0));
        Vector3d at = new Vector3d();
        double[] sums = new double[2];
        scene.afterTick((tick, seconds) -> {
            double truth = height(height, e, seconds);
            if (Double.isNaN(truth)) {
                return;
            }
            double off = ball.centreOfMass(at).y - RADIUS - truth;
            sums[0] += off * off;
            sums[1]++;
        });
        scene.error(
                "heightRelative",
                () -> sums[1] == 0 ? Double.NaN : StrictMath.sqrt(sums[0] / sums[1]) / height);
    }

    /**
     * The height above rest by the closed form.
     *
     * @param height of the fall, m
     * @param e coefficient of restitution
     * @param seconds since the start
     * @return metres, or NaN once the bounces are low
     */
    public static double height(double height, double e, double seconds) {
        double g = SampleScene.GRAVITY;
        double impact = StrictMath.sqrt(2 * height / g);
        if (seconds <= impact) {
            return height - g * seconds * seconds / 2;
        }
        double apex = height * e * e;
        double left = seconds - impact;
        while (apex > LOWEST_APEX * height) {
            double speed = StrictMath.sqrt(2 * g * apex);
            double flight = 2 * speed / g;
            if (left <= flight) {
                return speed * left - g * left * left / 2;
            }
            left -= flight;
            apex *= e * e;
        }
        return Double.NaN;
    }
}
