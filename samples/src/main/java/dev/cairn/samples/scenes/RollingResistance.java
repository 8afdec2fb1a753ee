package dev.cairn.samples.scenes;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.shape.Cylinder;
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
 * A ball, a roller and a larger ball roll until rolling friction has stopped them.
 *
 * <p>Truth: they lose speed at {@code a = (b/r) g/(1 + k)} with the arm b and {@code k = I/(m r²)},
 * 2/5 of a ball and 1/2 of a roller, and come to rest after {@code v²/(2 a)}.
 */
public final class RollingResistance {
    /** Of ball, roller and larger ball, m; inertia over m r². */
    private static final double[] RADIUS = {0.2, 0.2, 0.3};

    private static final double[] INERTIA = {0.4, 0.5, 0.4};

    private RollingResistance() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "rolling-resistance",
                "Rolling resistance",
                "A ball, a roller and a larger ball roll out: inertia and radius tell how far.",
                "friction",
                List.of(
                        Parameter.real("speed", 1.2, 0.1, 20, "speed at the start, m/s"),
                        Parameter.real("arm", 0.01, 1e-4, 0.1, "arm of rolling friction, m"),
                        Parameter.real("friction", 0.6, 0.1, 10, "Coulomb coefficient")),
                300,
                90,
                RollingResistance::build);
    }

    private static void build(SceneBuilder scene) {
        double speed = scene.get("speed");
        double arm = scene.get("arm");
        double friction = scene.get("friction");
        scene.floor(200, 5, friction, 0);
        List<BodyRef> bodies = new ArrayList<>();
        for (int i = 0; i < 3; i++) {
            double radius = RADIUS[i];
            Shape shape = i == 1 ? Cylinder.of(radius, 0.2) : Sphere.of(radius);
            bodies.add(
                    scene.add(
                            shape,
                            Palette.body(i),
                            Body.dynamic()
                                    .at(0, radius, 0.7 * (i - 1))
                                    .rotationAbout(1, 0, 0, i == 1 ? StrictMath.PI / 2 : 0)
                                    .velocity(speed, 0, 0)
                                    .angularVelocity(0, 0, -speed / radius)
                                    .material(Palette.material(friction, 0).withRollingArm(arm))
                                    .name(i == 0 ? "ball" : i == 1 ? "roller" : "larger ball")));
        }
        scene.view(new SceneView(3.0, 2.4, 3.0, 1.5, 0, 0));
        Ramp.Metric worst = new Ramp.Metric();
        Ramp.Metric distance = new Ramp.Metric();
        scene.afterTick((tick, seconds) -> {
            for (int i = 0; i < 3; i++) {
                double loss = arm / RADIUS[i] * SampleScene.GRAVITY / (1 + INERTIA[i]);
                double expected = Math.max(0, speed - loss * seconds);
                BodyRef body = bodies.get(i);
                worst.raise(Math.abs(body.velocity().x - expected) / speed);
                if (speed < loss * seconds) {
                    double path = speed * speed / (2 * loss);
                    distance.raise(Math.abs(body.position().x / path - 1));
                }
            }
        });
        scene.error("speedRelative", worst::get);
        scene.error("distanceRelative", distance::get);
    }
}
