package dev.cairn.samples.scenes;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;

import java.util.ArrayList;
import java.util.List;

/**
 * Balls that slide until they roll, one without spin, one with backspin that comes back.
 *
 * <p>Truth: {@code v = (5 v0 + 2 r w0)/7} from the time {@code 2 (v0 - r w0)/(7 mu g)} on, whatever
 * the friction.
 */
public final class SlipToRoll {
    private static final double RADIUS = 0.2;

    private SlipToRoll() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "slip-to-roll",
                "Slip to roll",
                "Balls slide, and then roll at a speed that friction cannot choose; one has so much"
                        + " backspin that it comes back.",
                "friction",
                List.of(
                        Parameter.real("speed", 4, 0.1, 50, "speed at the start, m/s"),
                        Parameter.real(
                                "backspin", 70, 0, 500, "backspin of the second ball, rad/s"),
                        Parameter.real("friction", 0.2, 0.01, 10, "Coulomb coefficient")),
                300,
                45,
                SlipToRoll::build);
    }

    private static void build(SceneBuilder scene) {
        double speed = scene.get("speed");
        double friction = scene.get("friction");
        scene.floor(200, 5, friction, 0);
        Sphere ball = Sphere.of(RADIUS);
        List<BodyRef> balls = new ArrayList<>();
        double[] expected = new double[2];
        double latest = 0;
        for (int i = 0; i < 2; i++) {
            double spin = i == 0 ? 0 : -scene.get("backspin");
            expected[i] = (5 * speed + 2 * RADIUS * spin) / 7;
            latest =
                    Math.max(
                            latest,
                            2 * (speed - RADIUS * spin) / (7 * friction * SampleScene.GRAVITY));
            balls.add(
                    scene.add(
                            ball,
                            Palette.body(i),
                            Body.dynamic()
                                    .at(0, RADIUS, i == 0 ? -0.5 : 0.5)
                                    .velocity(speed, 0, 0)
                                    .angularVelocity(0, 0, -spin)
                                    .material(Palette.material(friction, 0))
                                    .name("ball " + i)));
        }
        scene.view(new SceneView(2.6, 1.8, 4.6, 1.6, 0.1, 0));
        double from = latest + 0.1;
        Ramp.Metric worst = new Ramp.Metric();
        scene.afterTick((tick, seconds) -> {
            if (seconds > from) {
                for (int i = 0; i < 2; i++) {
                    worst.raise(Math.abs(balls.get(i).velocity().x / expected[i] - 1));
                }
            }
        });
        scene.error("speedRelative", worst::get);
    }
}
