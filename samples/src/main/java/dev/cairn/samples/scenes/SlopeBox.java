package dev.cairn.samples.scenes;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.shape.Box;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;

import java.util.List;

/**
 * A box is thrown onto a slope, slides and is stopped by friction.
 *
 * <p>Truth, for restitution 0: flight for {@code sqrt(2 drop / g)}; an impact whose friction takes
 * {@code mu} times the normal speed off the speed along the slope; then {@code a = g (sin - mu
 * cos)} until rest, or for ever. With drop 0 and speed 0 that is the textbook's {@code s = a t²/2},
 * or no motion at all when {@code mu >= tan}.
 */
public final class SlopeBox {
    private static final double HALF_LENGTH = 0.25;
    private static final double HALF_HEIGHT = 0.15;

    private SlopeBox() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "slope-box",
                "Box on a slope",
                "A 1 kg box is dropped onto a slope of 20 degrees with some speed, slides, and is"
                        + " stopped by friction.",
                "slopes",
                List.of(
                        Parameter.real("angle", 20, 0, 60, "inclination, degrees"),
                        Parameter.real("mass", 1, 1e-3, 1e6, "mass of the box, kg"),
                        Parameter.real(
                                "friction", 0.5, 0, 10, "Coulomb coefficient of box and slope"),
                        Parameter.real(
                                "restitution",
                                0,
                                0,
                                1,
                                "coefficient of restitution; truths need 0"),
                        Parameter.real("drop", 0.5, 0, 20, "height of the fall, m"),
                        Parameter.real(
                                "speed", 3, 0, 30, "speed along the slope at the start, m/s"),
                        Parameter.real(
                                "length", 12, 4, 1000, "length of the slope below the start, m")),
                240,
                60,
                SlopeBox::build);
    }

    private static void build(SceneBuilder scene) {
        double friction = scene.get("friction");
        double restitution = scene.get("restitution");
        double drop = scene.get("drop");
        double speed = scene.get("speed");
        Ramp ramp =
                new Ramp(scene, scene.get("angle"), scene.get("length"), 2, friction, restitution);
        Body body =
                ramp.push(ramp.align(Body.dynamic()), speed)
                        .at(ramp.x(0, HALF_HEIGHT), ramp.y(0, HALF_HEIGHT) + drop, 0)
                        .mass(scene.get("mass"))
                        .material(Palette.material(friction, restitution))
                        .name("box");
        BodyRef box =
                scene.add(
                        Box.ofHalfExtents(HALF_LENGTH, HALF_HEIGHT, HALF_LENGTH),
                        Palette.body(0),
                        body);
        ramp.look(scene, 2.2, 6.5);

        Truth truth = new Truth(ramp, friction, drop, speed);
        Ramp.Tracker tracker = ramp.new Tracker(box);
        Ramp.Metric metres = new Ramp.Metric();
        Ramp.Metric relative = new Ramp.Metric();
        if (restitution == 0) {
            scene.afterTick((tick, seconds) -> {
                if (ramp.carries(tracker.place(), HALF_LENGTH)) {
                    double expected = truth.distance(seconds);
                    double error = Math.abs(tracker.travelled() - expected);
                    metres.set(error);
                    relative.set(expected > 0 ? error / expected : Double.NaN);
                }
            });
        }
        scene.error("distanceMetres", metres::get);
        scene.error("distanceRelative", relative::get);
    }

    /** The closed form. */
    private static final class Truth {
        private final double flight;
        private final double impactSpeed;
        private final double impactDistance;
        private final double fall;
        private final double pull;
        private final double speed;

        Truth(Ramp ramp, double friction, double drop, double speed) {
            double gravity = SampleScene.GRAVITY;
            this.speed = speed;
            this.fall = gravity * ramp.sin();
            this.flight = StrictMath.sqrt(2 * drop / gravity);
            this.impactDistance = speed * flight + fall * flight * flight / 2;
            double normalSpeed = gravity * ramp.cos() * flight;
            this.impactSpeed = Math.max(0, speed + fall * flight - friction * normalSpeed);
            this.pull = gravity * (ramp.sin() - friction * ramp.cos());
        }

        /** Metres along the slope after some seconds. */
        double distance(double seconds) {
            if (seconds <= flight) {
                return speed * seconds + fall * seconds * seconds / 2;
            }
            double sliding = seconds - flight;
            if (pull <= 0) {
                // Friction wins: it stops, and stays.
                sliding = impactSpeed == 0 ? 0 : Math.min(sliding, impactSpeed / -pull);
            }
            return impactDistance + impactSpeed * sliding + pull * sliding * sliding / 2;
        }
    }
}
