package dev.cairn.samples.scenes.joint;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.joint.Joint;
import dev.cairn.physics.joint.JointAxis;
import dev.cairn.physics.joint.JointRef;
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
 * Mechanisms in a plane, a door and a robot's arm.
 *
 * <p>Truth: the slider of a crank of radius r and a rod of length l is at {@code r cos a + sqrt(l²
 * - r² sin² a)}; the end of a rocker is where two circles meet; a motor that holds an arm level
 * bears {@code m g L}.
 */
public final class Mechanisms {
    private static final double G = 9.81;

    private Mechanisms() {}

    /**
     * A crank that drives a slider.
     *
     * @return its entry for the registry
     */
    public static SampleScene sliderCrank() {
        return new SampleScene(
                "slider-crank",
                "Slider and crank",
                "A motor turns a crank that drives a slider; its place follows from the angle.",
                "joints",
                List.of(Parameter.real("speed", 4, 0.1, 30, "of the crank, rad/s")),
                600,
                30,
                Mechanisms::buildSliderCrank);
    }

    private static BodyRef bar(
            SceneBuilder scene, int color, double x0, double y0, double x1, double y1, double z) {
        double dx = x1 - x0;
        double dy = y1 - y0;
        double length = Math.sqrt(dx * dx + dy * dy);
        return scene.add(
                Box.ofHalfExtents(0.5 * length, 0.06, 0.04),
                Palette.body(color),
                Body.dynamic()
                        .mass(Math.rint(2e3 * length) / 1e3)
                        .at(0.5 * (x0 + x1), 0.5 * (y0 + y1), z)
                        .rotationAbout(0, 0, 1, StrictMath.atan2(dy, dx)));
    }

    private static BodyRef ground(SceneBuilder scene, double x, double y) {
        return scene.add(
                Box.ofHalfExtents(0.15, 0.15, 0.05), Palette.body(3), Body.fixed().at(x, y, -0.4));
    }

    private static void buildSliderCrank(SceneBuilder scene) {
        double r = 0.5;
        double l = 1.5;
        BodyRef base = ground(scene, 0, 2);
        BodyRef crank = bar(scene, 0, 0, 2, 0, 2.5, 0);
        double x = Math.sqrt(l * l - r * r);
        BodyRef rod = bar(scene, 1, 0, 2.5, x, 2, 0.2);
        BodyRef slider =
                scene.add(
                        Box.ofHalfExtents(0.2, 0.15, 0.1),
                        Palette.body(4),
                        Body.dynamic().mass(3).at(x, 2, 0.4));
        PhysicsWorld world = scene.world();
        world.add(Joint.generic(crank, slider).at(0, 0, 0)); // they pass each other
        world.add(
                Joint.hinge(base, crank)
                        .at(0, 2, 0)
                        .axis(0, 0, 1)
                        .motor(scene.get("speed"), Double.POSITIVE_INFINITY));
        world.add(Joint.hinge(crank, rod).at(0, 2.5, 0.1).axis(0, 0, 1));
        world.add(Joint.hinge(rod, slider).at(x, 2, 0.3).axis(0, 0, 1));
        world.add(Joint.slider(base, slider).at(x, 2, 0.4).axis(1, 0, 0));
        scene.view(new SceneView(0.8, 2.2, 4, 0.8, 2, 0));
        Vector3d p = new Vector3d();
        double[] worst = {0};
        scene.afterTick((tick, seconds) -> {
            crank.position(p);
            double sin = (p.y - 2) / (0.5 * r);
            double cos = p.x / (0.5 * r);
            double expected = r * cos + Math.sqrt(l * l - r * r * sin * sin);
            slider.position(p);
            worst[0] = Math.max(worst[0], Math.abs(p.x - expected));
        });
        scene.error("positionMetres", () -> worst[0]);
        Gaps.watch(scene, "gapMetres", 1);
    }

    /**
     * Two cranks and a coupler.
     *
     * @return its entry for the registry
     */
    public static SampleScene fourBar() {
        return new SampleScene(
                "four-bar",
                "Four bars",
                "A crank turns and a rocker rocks, tied by a coupler; the rocker's place follows"
                        + " from the crank's. Three of the rows are redundant.",
                "joints",
                List.of(Parameter.real("speed", 3, 0.1, 20, "of the crank, rad/s")),
                600,
                40,
                Mechanisms::buildFourBar);
    }

    private static void buildFourBar(SceneBuilder scene) {
        double crank = 0.5;
        double coupler = 1.8;
        double rocker = 1.2;
        double span = 2;
        double[] end = new double[2];
        meet(0, crank, coupler, span, 0, rocker, end);
        BodyRef left = ground(scene, 0, 2);
        BodyRef right = ground(scene, span, 2);
        BodyRef one = bar(scene, 0, 0, 2, 0, 2 + crank, 0);
        BodyRef two = bar(scene, 0, span, 2, end[0], 2 + end[1], 0);
        BodyRef rod = bar(scene, 1, 0, 2 + crank, end[0], 2 + end[1], 0.2);
        PhysicsWorld world = scene.world();
        world.add(Joint.generic(one, two).at(0, 0, 0)); // they pass each other
        world.add(
                Joint.hinge(left, one)
                        .at(0, 2, 0)
                        .axis(0, 0, 1)
                        .motor(scene.get("speed"), Double.POSITIVE_INFINITY));
        world.add(Joint.hinge(right, two).at(span, 2, 0).axis(0, 0, 1));
        world.add(Joint.hinge(one, rod).at(0, 2 + crank, 0.1).axis(0, 0, 1));
        world.add(Joint.hinge(two, rod).at(end[0], 2 + end[1], 0.1).axis(0, 0, 1));
        scene.view(new SceneView(1, 2.2, 4, 1, 2, 0));
        Vector3d p = new Vector3d();
        double[] worst = {0};
        scene.afterTick((tick, seconds) -> {
            one.position(p);
            meet(2 * p.x, 2 * (p.y - 2), coupler, span, 0, rocker, end);
            two.position(p);
            double dx = 2 * p.x - span - end[0];
            double dy = 2 * (p.y - 2) - end[1];
            worst[0] = Math.max(worst[0], Math.sqrt(dx * dx + dy * dy));
        });
        scene.error("positionMetres", () -> worst[0]);
        Gaps.watch(scene, "gapMetres", 1);
    }

    /** The upper point at a distance from each of two points. */
    private static void meet(
            double x0, double y0, double r0, double x1, double y1, double r1, double[] into) {
        double dx = x1 - x0;
        double dy = y1 - y0;
        double d = Math.sqrt(dx * dx + dy * dy);
        double along = (r0 * r0 - r1 * r1 + d * d) / (2 * d);
        double up = Math.sqrt(r0 * r0 - along * along);
        into[0] = x0 + (along * dx - up * dy) / d;
        into[1] = y0 + (along * dy + up * dx) / d;
    }

    /**
     * A door with a closer.
     *
     * @return its entry for the registry
     */
    public static SampleScene door() {
        return new SampleScene(
                "door",
                "Door",
                "A ball opens a door up to its limit; a spring closes it again. Beside it a motor"
                        + " holds an arm level, with the torque of its weight.",
                "joints",
                List.of(Parameter.real("speed", 6, 0, 30, "of the ball, m/s")),
                480,
                60,
                Mechanisms::buildDoor);
    }

    private static void buildDoor(SceneBuilder scene) {
        scene.floor(6, 6, 0.5, 0);
        BodyRef frame =
                scene.add(
                        Box.ofHalfExtents(0.1, 1.2, 0.1),
                        Palette.body(3),
                        Body.fixed().at(-0.7, 1.2, 0).name("post"));
        BodyRef leaf =
                scene.add(
                        Box.ofHalfExtents(0.5, 1, 0.04),
                        Palette.body(1),
                        Body.dynamic().mass(20).at(0, 1.1, 0).name("door"));
        scene.add(
                Sphere.of(0.15),
                Palette.body(4),
                Body.dynamic()
                        .mass(10)
                        .at(0.3, 1, 2)
                        .velocity(0, 1, -scene.get("speed"))
                        .name("ball"));
        JointRef hinge =
                scene.world()
                        .add(
                                Joint.hinge(frame, leaf)
                                        .at(-0.55, 1.1, 0)
                                        .axis(0, 1, 0)
                                        .limits(0, 1.8)
                                        .stiffness(JointAxis.TWIST, 0, 6, 4));
        BodyRef post =
                scene.add(
                        Box.ofHalfExtents(0.1, 0.8, 0.1),
                        Palette.body(3),
                        Body.fixed().at(2, 0.8, 0).name("stand"));
        BodyRef arm =
                scene.add(
                        Box.ofHalfExtents(0.5, 0.05, 0.05),
                        Palette.body(0),
                        Body.dynamic().mass(4).at(2.6, 1.5, 0).name("arm"));
        JointRef motor =
                scene.world()
                        .add(
                                Joint.hinge(post, arm)
                                        .at(2.1, 1.5, 0)
                                        .axis(0, 0, 1)
                                        .motor(0, Double.POSITIVE_INFINITY));
        scene.view(new SceneView(2, 2, 3.9, 0.75, 1.05, 0));
        double[] worst = {0, 0};
        Vector3d t = new Vector3d();
        scene.afterTick((tick, seconds) -> {
            double angle = hinge.value(JointAxis.TWIST);
            worst[0] = Math.max(worst[0], Math.max(-angle, angle - 1.8));
            worst[1] = Math.abs(motor.torque(t).z / (4 * G * 0.5) - 1);
        });
        scene.error("limitRadians", () -> worst[0]);
        scene.error("torqueRelative", () -> worst[1]);
    }

    /**
     * An arm of six hinges.
     *
     * @return its entry for the registry
     */
    public static SampleScene robotArm() {
        return new SampleScene(
                "robot-arm",
                "Robot's arm",
                "Six hinges with motors to a position wave a hand of ten times a link's mass.",
                "joints",
                List.of(Parameter.real("hertz", 8, 0.5, 60, "of the motors")),
                600,
                200,
                Mechanisms::buildRobotArm);
    }

    private static void buildRobotArm(SceneBuilder scene) {
        double hertz = scene.get("hertz");
        BodyRef last =
                scene.add(
                        Box.ofHalfExtents(0.3, 0.1, 0.3),
                        Palette.body(3),
                        Body.fixed().at(0, 0.1, 0));
        JointRef[] joints = new JointRef[6];
        for (int k = 0; k < 6; k++) {
            double y = 0.2 + 0.5 * k;
            boolean isHand = k == 5;
            BodyRef link =
                    scene.add(
                            Box.ofHalfExtents(isHand ? 0.15 : 0.07, 0.22, 0.07),
                            Palette.body(isHand ? 4 : k % 2),
                            Body.dynamic().mass(isHand ? 10 : 1).at(0, y + 0.25, 0));
            boolean turns = k == 0 || k == 3;
            joints[k] =
                    scene.world()
                            .add(
                                    Joint.hinge(last, link)
                                            .at(0, y, 0)
                                            .axis(0, turns ? 1 : 0, turns ? 0 : 1)
                                            .limits(-2, 2)
                                            .spring(0, hertz, 1)
                                            .springMost(JointAxis.TWIST, 500));
            last = link;
        }
        scene.view(new SceneView(1.8, 1.9, 4.2, 0, 0.3, 0));
        scene.beforeTick((tick, seconds) -> {
            for (int k = 0; k < 6; k++) {
                double wave = StrictMath.sin(1.5 * seconds + 0.6 * k);
                joints[k].target(JointAxis.TWIST, (k == 0 ? 1.2 : 0.5) * wave);
            }
        });
        Gaps.watch(scene, "gapMetres", 1);
    }
}
