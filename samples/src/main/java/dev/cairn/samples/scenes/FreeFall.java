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
 * Bodies thrown upwards, spinning, that touch nothing.
 *
 * <p>Truth: the centre of mass follows {@code x0 + v0 t + g t²/2}, whatever the body's spin.
 */
public final class FreeFall {
    private FreeFall() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "free-fall",
                "Free fall",
                "Five spinning bodies fly their parabolas side by side, until the first lands.",
                "motion",
                List.of(
                        Parameter.real("speed", 8, 0, 100, "speed upwards at the start, m/s"),
                        Parameter.real("spin", 6, 0, 50, "angular speed at the start, rad/s"),
                        Parameter.real("height", 1.5, 0.5, 1e6, "height of the start, m")),
                90,
                60,
                FreeFall::build);
    }

    private static void build(SceneBuilder scene) {
        scene.floor(12, 8, 0.6, 0);
        Shape box = Box.ofHalfExtents(0.5, 0.2, 0.3);
        Shape ball = Sphere.of(0.3);
        double speed = scene.get("speed");
        double spin = scene.get("spin");
        double height = scene.get("height");
        List<Flight> flights = new ArrayList<>();
        for (int i = 0; i < 5; i++) {
            double x = 2.2 * (i - 2);
            double vx = 0.5 * (i - 2);
            double vy = speed * (0.6 + 0.1 * i);
            BodyRef body =
                    scene.add(
                            i % 2 == 0 ? box : ball,
                            Palette.body(i),
                            Body.dynamic()
                                    .at(x, height, 0)
                                    .velocity(vx, vy, 0)
                                    .angularVelocity(spin * 0.48, spin * 0.64, spin * 0.6)
                                    .name("body " + i));
            flights.add(new Flight(body, x, height, vx, vy));
        }
        scene.view(new SceneView(0, 3.2, 13.5, 0, 2.6, 0));

        Ramp.Metric worst = new Ramp.Metric();
        scene.afterTick((tick, seconds) -> {
            double error = 0;
            for (int i = 0; i < flights.size(); i++) {
                double one = flights.get(i).error(seconds);
                if (Double.isNaN(one)) {
                    return;
                }
                error = Math.max(error, one);
            }
            worst.set(Double.isNaN(worst.get()) ? error : Math.max(error, worst.get()));
        });
        scene.error("positionMetres", worst::get);
    }

    /** One body and its parabola. */
    private static final class Flight {
        private final BodyRef body;
        private final double x;
        private final double y;
        private final double vx;
        private final double vy;
        private final Vector3d at = new Vector3d();

        Flight(BodyRef body, double x, double y, double vx, double vy) {
            this.body = body;
            this.x = x;
            this.y = y;
            this.vx = vx;
            this.vy = vy;
        }

        /** Metres off the parabola, or NaN once it comes near the ground. */
        double error(double seconds) {
            double expectedX = x + vx * seconds;
            double expectedY = y + vy * seconds - SampleScene.GRAVITY * seconds * seconds / 2;
            if (expectedY < 0.75) {
                return Double.NaN;
            }
            body.centreOfMass(at);
            return StrictMath.sqrt(
                    (at.x - expectedX) * (at.x - expectedX)
                            + (at.y - expectedY) * (at.y - expectedY)
                            + at.z * at.z);
        }
    }
}
