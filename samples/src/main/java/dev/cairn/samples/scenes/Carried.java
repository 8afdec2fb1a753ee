package dev.cairn.samples.scenes;

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

import org.joml.Vector3d;

import java.util.List;

/**
 * Bodies on kinematic ones: a platform, a lift and a turntable.
 *
 * <p>Truths. Who starts with the platform's or the lift's velocity keeps his place on it. A ball
 * that rolls on a turntable circles at {@code k/(1 + k) = 2/7} of its rate, {@code k = 2/5}, about
 * a point that its start decides: with {@code W} the rate of the table, {@code a r x n + v = W x x}
 * at the contact for all times gives {@code dv/dt = 2/7 W x v}, a circle in the room whatever the
 * radius of the ball (R. H. Romer, "Motion of a sphere on a tilted turntable", 1981).
 */
public final class Carried {
    private static final double HALF = 0.25;

    private Carried() {}

    /**
     * Boxes on a platform that crosses a wall.
     *
     * @return its entry for the registry
     */
    public static SampleScene platform() {
        return new SampleScene(
                "platform",
                "Moving platform",
                "Boxes ride on a platform, side by side and on each other; a wall does not stop"
                        + " it.",
                "kinematic",
                List.of(
                        Parameter.real("speed", 1, 0, 20, "of the platform, m/s"),
                        Parameter.real("friction", 0.6, 0, 10, "Coulomb coefficient")),
                300,
                90,
                scene -> ride(scene, scene.get("speed"), 0));
    }

    /**
     * The same, upwards.
     *
     * @return its entry for the registry
     */
    public static SampleScene lift() {
        return new SampleScene(
                "lift",
                "Lift",
                "Boxes ride on a platform that rises at constant speed.",
                "kinematic",
                List.of(
                        Parameter.real("speed", 0.5, 0, 20, "of the platform, m/s"),
                        Parameter.real("friction", 0.6, 0, 10, "Coulomb coefficient")),
                300,
                90,
                scene -> ride(scene, 0, scene.get("speed")));
    }

    private static void ride(SceneBuilder scene, double vx, double vy) {
        Material material = Palette.material(scene.get("friction"), 0);
        BodyRef platform =
                scene.add(
                        Box.ofHalfExtents(2, 0.1, 1),
                        Palette.body(3),
                        Body.kinematic()
                                .at(0, 0.9, 0)
                                .velocity(vx, vy, 0)
                                .material(material)
                                .name("platform"));
        scene.add(
                Box.ofHalfExtents(0.1, 1.5, 1.5),
                Palette.body(4),
                Body.fixed().at(vx > 0 ? 4 : -4, 1.5, 0).material(material).name("wall"));
        BodyRef[] riders = new BodyRef[3];
        Vector3d[] start = new Vector3d[3];
        for (int i = 0; i < riders.length; i++) {
            start[i] = new Vector3d(i == 2 ? -1 : 0.7 * i - 1, 1 + HALF * (i == 2 ? 3 : 1), 0);
            riders[i] =
                    scene.add(
                            Box.cubeOfHalfExtent(HALF),
                            Palette.body(i),
                            Body.dynamic()
                                    .at(start[i])
                                    .velocity(vx, vy, 0)
                                    .material(material)
                                    .name("rider " + (i + 1)));
        }
        scene.view(new SceneView(4.5, 3, 6, 1.5, 1, 0));
        double x = platform.position().x;
        Ramp.Metric worst = new Ramp.Metric();
        Ramp.Metric stopped = new Ramp.Metric();
        scene.afterTick((tick, seconds) -> {
            stopped.raise(Math.abs(platform.position().x - x - vx * seconds));
            double way = platform.position().x - x;
            if (x + way + 2 < 3.9 || vx == 0) {
                for (int i = 0; i < riders.length; i++) {
                    Vector3d to = new Vector3d(way, vy * seconds, 0).add(start[i]);
                    worst.raise(riders[i].position().distance(to));
                }
            }
        });
        scene.error("platformMetres", stopped::get);
        scene.error("riderMetres", worst::get);
    }

    /**
     * A ball on a turntable.
     *
     * @return its entry for the registry
     */
    public static SampleScene turntable() {
        return new SampleScene(
                "turntable",
                "Turntable",
                "A ball that rolls on a turntable circles at 2/7 of its rate.",
                "kinematic",
                List.of(
                        Parameter.real("rate", 2, 0.1, 10, "of the table, rad/s"),
                        Parameter.real("radius", 1, 0.2, 3, "of the ball's circle, m"),
                        Parameter.real("friction", 1, 0, 10, "Coulomb coefficient")),
                600,
                120,
                Carried::turn);
    }

    private static void turn(SceneBuilder scene) {
        double rate = scene.get("rate");
        double radius = scene.get("radius");
        double ball = 0.1;
        Material material = Palette.material(scene.get("friction"), 0);
        scene.add(
                Box.ofHalfExtents(4, 0.1, 4),
                Palette.body(3),
                Body.kinematic()
                        .at(0, -0.1, 0)
                        .angularVelocity(0, rate, 0)
                        .material(material)
                        .name("turntable"));
        double slow = 2.0 / 7 * rate;
        BodyRef roller =
                scene.add(
                        Sphere.of(ball),
                        Palette.body(0),
                        Body.dynamic()
                                .at(radius, ball, 0)
                                .velocity(0, 0, -slow * radius)
                                .angularVelocity((rate - slow) * radius / ball, 0, 0)
                                .material(material)
                                .name("ball"));
        scene.view(new SceneView(0, 5, 5, 0, 0, 0));
        double[] angle = new double[2];
        Ramp.Metric off = new Ramp.Metric();
        scene.afterTick((tick, seconds) -> {
            Vector3d at = roller.position();
            double now = StrictMath.atan2(-at.z, at.x);
            double turned = now - angle[0];
            angle[1] += turned - 2 * Math.PI * Math.rint(turned / (2 * Math.PI));
            angle[0] = now;
            if (seconds > 1) {
                off.raise(Math.abs(angle[1] / (slow * seconds) - 1));
            }
        });
        scene.error("rateRelative", off::get);
    }
}
