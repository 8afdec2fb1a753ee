package dev.cairn.samples.scenes.joint;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.joint.Joint;
import dev.cairn.physics.joint.JointAxis;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.samples.Palette;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;

import org.joml.Vector3d;

import java.util.List;

/**
 * Beads on wires that are bent to cycloids.
 *
 * <p>Truth: from wherever a bead starts, its period is {@code 4 pi sqrt(R/g)}, R the radius of the
 * wheel that draws the cycloid (C. Huygens, "Horologium oscillatorium", 1673).
 */
public final class Tautochrone {
    private static final double G = 9.81;
    private static final double RADIUS = 0.5;
    private static final int POINTS = 96;

    /** Angle of the wheel at the wire's end; at 0 the cycloid has a cusp. */
    private static final double END = 0.25;

    private static final double[] START = {0.7, 1.5, 2.4};

    private Tautochrone() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "tautochrone",
                "Tautochrone",
                "Beads on cycloids start at different heights, and come to the bottom together.",
                "joints",
                List.of(),
                1200,
                30,
                Tautochrone::build);
    }

    private static double x(double angle) {
        return RADIUS * (angle - StrictMath.sin(angle) - Math.PI);
    }

    private static double y(double angle) {
        return 0.3 + RADIUS * (1 + StrictMath.cos(angle));
    }

    private static double[] wire(double z) {
        double[] points = new double[3 * POINTS];
        for (int i = 0; i < POINTS; i++) {
            double angle = END + (2 * Math.PI - 2 * END) * i / (POINTS - 1);
            points[3 * i] = x(angle);
            points[3 * i + 1] = y(angle);
            points[3 * i + 2] = z;
        }
        return points;
    }

    private static void build(SceneBuilder scene) {
        PhysicsWorld world = scene.world();
        double period = 4 * Math.PI * Math.sqrt(RADIUS / G);
        Vector3d p = new Vector3d();
        Vector3d v = new Vector3d();
        // the worst of all beads: period, height lost
        double[] worst = {0, 0};
        for (int k = 0; k < START.length; k++) {
            double z = 0.5 * (k - 1);
            BodyRef post =
                    scene.add(
                            Sphere.of(0.03),
                            Palette.body(3),
                            Body.fixed().at(x(END) - 0.3, y(END), z));
            BodyRef bead =
                    scene.add(
                            Sphere.of(0.08),
                            Palette.body(k),
                            Body.dynamic().mass(1).at(x(START[k]), y(START[k]), z));
            // no bead comes to its ends, and without limits the steps are of fourth order
            Joint joint = Joint.path(post, bead, false, wire(z)).free(JointAxis.PATH);
            world.add(joint.name("wire " + k));
            double top = y(START[k]);
            // first crossing, crossings, x and its speed before
            double[] s = {0, 0, 0, 0};
            scene.afterTick((tick, seconds) -> {
                bead.position(p);
                bead.velocity(v);
                double height = p.y + v.lengthSquared() / (2 * G);
                worst[1] = Math.max(worst[1], Math.abs(height - top));
                if (s[2] < 0 && p.x >= 0) {
                    double h = SampleScene.STEP_SECONDS;
                    double t = seconds - h + h * Pendulums.root(s[2], h * s[3], p.x, h * v.x);
                    s[0] = s[1] == 0 ? t : s[0];
                    if (s[1] > 0) {
                        double seen = (t - s[0]) / s[1];
                        worst[0] = Math.max(worst[0], Math.abs(seen / period - 1));
                    }
                    s[1]++;
                }
                s[2] = p.x;
                s[3] = v.x;
            });
        }
        scene.view(new SceneView(0.6, 1.4, 3.2, 0, 0.7, 0));
        scene.error("periodRelative", () -> worst[0]);
        scene.error("heightLostMetres", () -> worst[1]);
    }
}
