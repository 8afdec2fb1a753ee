package dev.cairn.samples.scenes;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;

import java.util.List;

/**
 * A ball rolls down a slope.
 *
 * <p>Truth, for drop 0: a solid sphere ({@code I = 2/5 m r²}) rolls with {@code a = 5/7 g sin} if
 * {@code mu >= 2/7 tan}, else it slips with {@code a = g (sin - mu cos)}.
 */
public final class SlopeBall {
    private SlopeBall() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "slope-ball",
                "Basketball on a slope",
                "A ball with size, mass and bounce of a basketball rolls down a slope of 15"
                        + " degrees; with drop > 0 it bounces.",
                "slopes",
                List.of(
                        Parameter.real("angle", 15, 0, 60, "inclination, degrees"),
                        Parameter.real("mass", 0.62, 1e-3, 1e6, "mass of the ball, kg"),
                        Parameter.real("radius", 0.12, 0.01, 1, "radius of the ball, m"),
                        Parameter.real(
                                "friction", 0.6, 0, 10, "Coulomb coefficient of ball and slope"),
                        Parameter.real("restitution", 0.75, 0, 1, "coefficient of restitution"),
                        Parameter.real("drop", 0, 0, 20, "height of the fall, m; truths need 0"),
                        Parameter.real(
                                "length", 12, 4, 1000, "length of the slope below the start, m")),
                150,
                90,
                SlopeBall::build);
    }

    private static void build(SceneBuilder scene) {
        double friction = scene.get("friction");
        double restitution = scene.get("restitution");
        double drop = scene.get("drop");
        double radius = scene.get("radius");
        Ramp ramp =
                new Ramp(
                        scene, scene.get("angle"), scene.get("length"), 1.5, friction, restitution);
        BodyRef ball =
                scene.add(
                        Sphere.of(radius),
                        Palette.BASKETBALL,
                        Body.dynamic()
                                .at(ramp.x(0, radius), ramp.y(0, radius) + drop, 0)
                                .mass(scene.get("mass"))
                                .material(Palette.material(friction, restitution))
                                .name("ball"));
        ramp.look(scene, 1.4, 3.4);

        boolean rolls = friction >= 2.0 / 7 * ramp.sin() / ramp.cos();
        double acceleration =
                SampleScene.GRAVITY
                        * (rolls ? 5.0 / 7 * ramp.sin() : ramp.sin() - friction * ramp.cos());
        Ramp.Tracker tracker = ramp.new Tracker(ball);
        Ramp.Metric relative = new Ramp.Metric();
        if (drop == 0 && acceleration > 0) {
            scene.afterTick((tick, seconds) -> {
                if (ramp.carries(tracker.place(), radius)) {
                    double expected = acceleration * seconds * seconds / 2;
                    relative.set(Math.abs(tracker.travelled() - expected) / expected);
                }
            });
        }
        scene.error("rollRelative", relative::get);
    }
}
