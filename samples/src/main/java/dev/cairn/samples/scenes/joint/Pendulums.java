package dev.cairn.samples.scenes.joint;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.joint.Joint;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;

import org.joml.Vector3d;

import java.util.List;

/**
 * Pendulums on rods without mass.
 *
 * <p>Truth: the period of one is {@code 2 pi sqrt(L/g)/agm(1, cos(a/2))}, by the arithmetic and
 * geometric mean (C. F. Gauss), and its energy stays. Two on each other keep their energy, and for
 * two seconds follow the equations of two point masses, here by the classical Runge-Kutta method in
 * steps of 0.1 ms.
 */
public final class Pendulums {
    private static final double G = 9.81;
    private static final double RADIUS = 0.1;

    private Pendulums() {}

    /**
     * One pendulum.
     *
     * @return its entry for the registry
     */
    public static SampleScene single() {
        return new SampleScene(
                "pendulum",
                "Pendulum",
                "A ball on a rod swings; its period and its height are compared with the truth.",
                "joints",
                List.of(Parameter.real("degrees", 90, 1, 175, "amplitude, degrees")),
                1200,
                40,
                Pendulums::buildSingle);
    }

    /**
     * Two on each other.
     *
     * @return its entry for the registry
     */
    public static SampleScene twofold() {
        return new SampleScene(
                "double-pendulum",
                "Double pendulum",
                "Two balls on rods, one hung on the other: chaos that keeps its energy.",
                "joints",
                List.of(Parameter.real("degrees", 120, 1, 179, "angle of both rods, degrees")),
                1200,
                60,
                Pendulums::buildTwofold);
    }

    private static BodyRef ball(SceneBuilder scene, double x, double y, int color) {
        return scene.add(
                Sphere.of(RADIUS), Palette.body(color), Body.dynamic().mass(1).at(x, y, 0));
    }

    private static void buildSingle(SceneBuilder scene) {
        double amplitude = Math.toRadians(scene.get("degrees"));
        BodyRef peg = scene.add(Sphere.of(0.03), Palette.body(3), Body.fixed().at(0, 2, 0));
        BodyRef bob = ball(scene, StrictMath.sin(amplitude), 2 - StrictMath.cos(amplitude), 0);
        PhysicsWorld world = scene.world();
        world.add(Joint.rod(peg, bob));
        scene.view(new SceneView(0, 2, 4, 0, 1.6, 0));
        double a = 1;
        double b = StrictMath.cos(amplitude / 2);
        for (int k = 0; k < 10; k++) {
            double mean = 0.5 * (a + b);
            b = Math.sqrt(a * b);
            a = mean;
        }
        double period = 2 * Math.PI / Math.sqrt(G) / a;
        double start = world.potentialEnergy();
        // first crossing, last crossing, crossings, x and its speed before, loss
        double[] s = {0, 0, 0, 0, 0, 0};
        Vector3d p = new Vector3d();
        Vector3d v = new Vector3d();
        scene.afterTick((tick, seconds) -> {
            bob.position(p);
            bob.velocity(v);
            if (s[3] < 0 && p.x >= 0) {
                double h = SampleScene.STEP_SECONDS;
                double t = seconds - h + h * root(s[3], h * s[4], p.x, h * v.x);
                s[0] = s[2] == 0 ? t : s[0];
                s[1] = t;
                s[2]++;
            }
            s[3] = p.x;
            s[4] = v.x;
            double energy = world.kineticEnergy() + world.potentialEnergy();
            s[5] = Math.max(s[5], Math.abs(energy - start) / (2 * G));
        });
        scene.error(
                "periodRelative",
                () -> s[2] < 2 ? Double.NaN : Math.abs((s[1] - s[0]) / (s[2] - 1) / period - 1));
        scene.error("heightLostRelative", () -> s[5]);
    }

    /** Root in [0, 1] of the cubic with these ends and slopes. */
    static double root(double a, double da, double b, double db) {
        double low = 0;
        double high = 1;
        for (int k = 0; k < 60; k++) {
            double s = 0.5 * (low + high);
            double r = 1 - s;
            double f = (1 + 2 * s) * r * r * a + s * r * r * da + s * s * (3 - 2 * s) * b;
            f -= s * s * r * db;
            low = f < 0 ? s : low;
            high = f < 0 ? high : s;
        }
        return 0.5 * (low + high);
    }

    private static void buildTwofold(SceneBuilder scene) {
        double angle = Math.toRadians(scene.get("degrees"));
        double x = StrictMath.sin(angle);
        double y = StrictMath.cos(angle);
        BodyRef peg = scene.add(Sphere.of(0.03), Palette.body(3), Body.fixed().at(0, 2.5, 0));
        BodyRef one = ball(scene, x, 2.5 - y, 0);
        BodyRef two = ball(scene, 2 * x, 2.5 - 2 * y, 1);
        PhysicsWorld world = scene.world();
        world.add(Joint.rod(peg, one));
        world.add(Joint.rod(one, two));
        world.collisions().exclude(peg, two);
        scene.view(new SceneView(0, 2.5, 6, 0, 2.3, 0));
        double start = world.potentialEnergy();
        double[] truth = {angle, angle, 0, 0};
        // loss, worst angle
        double[] s = {0, 0};
        Vector3d p = new Vector3d();
        Vector3d q = new Vector3d();
        scene.afterTick((tick, seconds) -> {
            double energy = world.kineticEnergy() + world.potentialEnergy();
            s[0] = Math.max(s[0], Math.abs(energy - start) / (5 * G));
            if (seconds <= 2) {
                for (int k = 0; k < 167; k++) {
                    rungeKutta(truth, SampleScene.STEP_SECONDS / 167);
                }
                one.position(p);
                two.position(q).sub(p);
                double first = StrictMath.atan2(p.x, 2.5 - p.y);
                double second = StrictMath.atan2(q.x, -q.y);
                s[1] = Math.max(s[1], Math.abs(turn(first - truth[0])));
                s[1] = Math.max(s[1], Math.abs(turn(second - truth[1])));
            }
        });
        scene.error("energyRelative", () -> s[0]);
        scene.error("angleRadians", () -> s[1]);
    }

    private static double turn(double angle) {
        return Math.IEEEremainder(angle, 2 * Math.PI);
    }

    /** Two angles from the vertical, then their speeds; rods of 1 m, balls of 1 kg. */
    private static void rungeKutta(double[] y, double h) {
        double[] sum = y.clone();
        double[] at = y.clone();
        double[] weight = {h / 6, h / 3, h / 3, h / 6};
        double[] step = {h / 2, h / 2, h, 0};
        for (int stage = 0; stage < 4; stage++) {
            double[] d = derivative(at);
            for (int k = 0; k < 4; k++) {
                sum[k] += weight[stage] * d[k];
                at[k] = y[k] + step[stage] * d[k];
            }
        }
        System.arraycopy(sum, 0, y, 0, 4);
    }

    private static double[] derivative(double[] y) {
        double d = y[0] - y[1];
        double sin = StrictMath.sin(d);
        double cos = StrictMath.cos(d);
        double n = 3 - StrictMath.cos(2 * d);
        double one =
                -3 * G * StrictMath.sin(y[0])
                        - G * StrictMath.sin(y[0] - 2 * y[1])
                        - 2 * sin * (y[3] * y[3] + y[2] * y[2] * cos);
        double two = 2 * sin * (2 * y[2] * y[2] + 2 * G * StrictMath.cos(y[0]) + y[3] * y[3] * cos);
        return new double[] {y[2], y[3], one / n, two / n};
    }
}
