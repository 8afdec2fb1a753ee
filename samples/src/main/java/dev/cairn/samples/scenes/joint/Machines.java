package dev.cairn.samples.scenes.joint;

import dev.cairn.core.snapshot.Visual;
import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.joint.Joint;
import dev.cairn.physics.joint.JointAxis;
import dev.cairn.physics.joint.JointRef;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.render.mesh.Model;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;

import org.joml.Vector3d;

import java.util.ArrayList;
import java.util.List;

/**
 * A gear train with a rack and a pulley, a cradle on strings, and a rod that falls.
 *
 * <p>Truth: {@code n a + m b} of two gears stays 0 up to whole teeth and the rack goes {@code r a};
 * the last ball of the cradle rises as high as the first one came from; the rod obeys {@code a'' =
 * 3 g/(2 L) sin a}.
 */
public final class Machines {
    private static final double G = 9.81;

    private Machines() {}

    /**
     * Gears, a rack and a pulley.
     *
     * @return its entry for the registry
     */
    public static SampleScene gears() {
        return new SampleScene(
                "gears",
                "Gears, rack and pulley",
                "A motor turns a train of gears; the last one drives a rack up and down, and a"
                        + " pulley lifts a load.",
                "joints",
                List.of(Parameter.real("speed", 3, -20, 20, "of the motor, rad/s")),
                600,
                100,
                Machines::buildGears);
    }

    /** Every other gear is turned by half a tooth, so that teeth meet gaps. */
    private static BodyRef wheel(SceneBuilder scene, int teeth, double x, double y, int number) {
        double radius = 0.02 * teeth;
        double phase = number % 2 == 0 ? 0 : 0.5;
        return scene.add(
                Body.dynamic()
                        .shape(Cylinder.of(radius - 0.02, 0.06))
                        .mass(20 * radius)
                        .at(x, y, 0)
                        .rotationAbout(1, 0, 0, Math.PI / 2)
                        .name("gear of " + teeth),
                new Visual(Teeth.gear(teeth, radius, 0.06, phase, Palette.body(number))));
    }

    private static JointRef pin(
            SceneBuilder scene, BodyRef base, BodyRef wheel, double x, double y) {
        return scene.world().add(Joint.hinge(base, wheel).at(x, y, 0).axis(0, 0, 1));
    }

    private static void buildGears(SceneBuilder scene) {
        PhysicsWorld world = scene.world();
        scene.floor(4, 4, 0.6, 0);
        Box board = Box.ofHalfExtents(3, 1.75, 0.05);
        scene.add(
                board,
                Model.ground(board).color(Palette.STONE),
                Body.fixed().at(0.5, 1.75, -0.65).name("board"));
        BodyRef base =
                scene.add(
                        Box.ofHalfExtents(2.5, 0.1, 0.1),
                        Palette.body(3),
                        Body.fixed().at(0.6, 2, -0.5).name("beam"));
        scene.add(
                Cylinder.of(0.33, 0.05),
                Palette.body(3),
                Body.fixed().at(-1.15, 3.2, 0).rotationAbout(1, 0, 0, Math.PI / 2).name("pulley"));
        int[] teeth = {12, 30, 20};
        double[] at = {0, 0.84, 1.84};
        BodyRef[] wheel = new BodyRef[3];
        JointRef[] pin = new JointRef[3];
        for (int k = 0; k < 3; k++) {
            wheel[k] = wheel(scene, teeth[k], at[k], 2, k);
            pin[k] = pin(scene, base, wheel[k], at[k], 2);
            if (k > 0) {
                world.add(
                        Joint.gear(wheel[k - 1], wheel[k], teeth[k - 1], teeth[k])
                                .anchors(at[k - 1], 2, 0, at[k], 2, 0)
                                .axis(0, 0, 1));
            }
        }
        BodyRef rack =
                scene.add(
                        Body.dynamic()
                                .shape(Box.ofHalfExtents(0.9, 0.05, 0.06))
                                .mass(5)
                                .at(at[2] + 0.45, 2, 0)
                                .rotationAbout(0, 0, 1, Math.PI / 2)
                                .name("rack"),
                        new Visual(
                                Teeth.rack(
                                        0.04 * Math.PI, 0.9, 0.05, -0.08, 0.06, Palette.body(1))));
        JointRef slider = world.add(Joint.slider(base, rack).at(at[2] + 0.45, 2, 0).axis(0, 1, 0));
        world.add(
                Joint.rack(wheel[2], rack)
                        .anchors(at[2], 2, 0, at[2] + 0.4, 2, 0)
                        .axis(0, 0, 1)
                        .secondAxis(0, 1, 0));
        BodyRef load =
                scene.add(
                        Sphere.of(0.15),
                        Palette.body(4),
                        Body.dynamic().mass(6).at(-1.5, 1.2, 0).name("load"));
        BodyRef weight =
                scene.add(
                        Sphere.of(0.2),
                        Palette.body(4),
                        Body.dynamic().mass(11).at(-0.8, 1.8, 0).name("weight"));
        world.add(
                Joint.pulley(
                        load, weight, new Vector3d(-1.5, 3.2, 0), new Vector3d(-0.8, 3.2, 0), 1));
        world.add(Joint.rope(base, weight).anchors(-0.8, 2.1, -0.5, -0.8, 1.8, 0).length(1.6));
        scene.view(new SceneView(1.2, 2.5, 4.2, 0.55, 2, 0));
        double speed = scene.get("speed");
        scene.beforeTick((tick, seconds) ->
                pin[0].motor(
                        JointAxis.TWIST,
                        Math.floorMod(tick, 120) < 60 ? speed : -speed,
                        Double.POSITIVE_INFINITY));
        double[] worst = {0, 0};
        scene.afterTick((tick, seconds) -> {
            for (int k = 1; k < 3; k++) {
                double sum =
                        teeth[k - 1] * pin[k - 1].value(JointAxis.TWIST)
                                + teeth[k] * pin[k].value(JointAxis.TWIST);
                double off = Math.abs(Math.IEEEremainder(sum, 2 * Math.PI));
                worst[0] = Math.max(worst[0], off / teeth[k]);
            }
            double way = slider.value(JointAxis.X) / 0.4 - pin[2].value(JointAxis.TWIST);
            worst[1] = Math.max(worst[1], 0.4 * Math.abs(Math.IEEEremainder(way, 2 * Math.PI)));
        });
        scene.error("ratioRadians", () -> worst[0]);
        scene.error("rackMetres", () -> worst[1]);
        Gaps.watch(scene, "gapMetres", 1);
    }

    /**
     * Newton's cradle on strings.
     *
     * @return its entry for the registry
     */
    public static SampleScene cradle() {
        return new SampleScene(
                "newton-pendulums",
                "Newton's cradle on strings",
                "Elastic balls hang in a row, each on two strings; as many leave as come.",
                "joints",
                List.of(
                        Parameter.count("balls", 5, 2, 20, "number of balls"),
                        Parameter.real("degrees", 30, 1, 60, "of the first ball at its start")),
                600,
                60,
                Machines::buildCradle);
    }

    private static void buildCradle(SceneBuilder scene) {
        int count = scene.count("balls");
        double angle = Math.toRadians(scene.get("degrees"));
        double radius = 0.2;
        double pitch = 2 * radius + 1e-4;
        double length = 1.5;
        double top = 2.2;
        List<BodyRef> balls = new ArrayList<>();
        BodyRef frame =
                scene.add(
                        Box.ofHalfExtents(0.5 * pitch * count, 0.05, 0.05),
                        Palette.body(3),
                        Body.fixed().at(0, top + 0.3, 0));
        for (int k = 0; k < count; k++) {
            double x = pitch * (k - 0.5 * (count - 1));
            double s = k == 0 ? length * StrictMath.sin(angle) : 0;
            double c = k == 0 ? length * StrictMath.cos(angle) : length;
            BodyRef ball =
                    scene.add(
                            Sphere.of(radius),
                            Palette.body(k == 0 ? 0 : 1),
                            Body.dynamic().at(x - s, top - c, 0).material(Palette.material(0, 1)));
            for (int side = -1; side <= 1; side += 2) {
                scene.world()
                        .add(Joint.rod(frame, ball).anchors(x, top, 0.5 * side, x - s, top - c, 0));
            }
            balls.add(ball);
        }
        scene.view(new SceneView(1.2, 1.8, 5, 0, 1.4, 0));
        double wanted = length * (1 - StrictMath.cos(angle));
        double swing = 2 * Math.PI * Math.sqrt(length / G) * (1 + angle * angle / 16);
        double[] highest = {0, 0};
        Vector3d p = new Vector3d();
        scene.afterTick((tick, seconds) -> {
            // the last ball's first swing
            if (seconds < 0.7 * swing) {
                double height = balls.get(count - 1).position(p).y - (top - length);
                highest[0] = Math.max(highest[0], height);
                for (int k = 1; k < count - 1; k++) {
                    highest[1] = Math.max(highest[1], balls.get(k).position(p).y - (top - length));
                }
            }
        });
        scene.error("heightRelative", () -> highest[0] > 0 ? 1 - highest[0] / wanted : 0);
        scene.error("othersMetres", () -> highest[1]);
        Gaps.watch(scene, "gapMetres", 1);
    }

    /**
     * A rod on a hinge at its foot.
     *
     * @return its entry for the registry
     */
    public static SampleScene fallingRod() {
        return new SampleScene(
                "falling-rod",
                "Falling rod",
                "A rod of 1 m on a hinge at its foot falls over from 0.01 rad beside the vertical.",
                "joints",
                List.of(Parameter.real("angle", 0.01, 1e-6, 1.5, "at first, rad")),
                90,
                80,
                Machines::buildRod);
    }

    private static void buildRod(SceneBuilder scene) {
        double angle = scene.get("angle");
        double s = StrictMath.sin(angle);
        double c = StrictMath.cos(angle);
        double foot = 1.2;
        BodyRef base =
                scene.add(
                        Box.ofHalfExtents(0.2, 0.6, 0.2),
                        Palette.body(3),
                        Body.fixed().at(0, 0.5, 0));
        BodyRef rod =
                scene.add(
                        Capsule.of(0.01, 0.49),
                        Palette.body(0),
                        Body.dynamic()
                                .mass(1)
                                .at(0.5 * s, foot + 0.5 * c, 0)
                                .rotationAbout(0, 0, 1, -angle));
        // the hinge's own axis, so that the inertia about it is what the world has
        double inertia = 1 / rod.inverseInertia(new org.joml.Matrix3d()).m22() + 0.25;
        JointRef hinge = scene.world().add(Joint.hinge(base, rod).at(0, foot, 0).axis(0, 0, -1));
        scene.view(new SceneView(0.3, 1.6, 3, 0.3, 1.2, 0));
        double[] y = {angle, 0};
        double[] worst = {0};
        double start = scene.world().potentialEnergy();
        scene.afterTick((tick, seconds) -> {
            int steps = 400;
            double h = SampleScene.STEP_SECONDS / steps;
            for (int k = 0; k < steps; k++) {
                // velocity Verlet, of second order: its own error is below 1e-8 here
                y[1] += 0.5 * h * 0.5 * G / inertia * StrictMath.sin(y[0]);
                y[0] += h * y[1];
                y[1] += 0.5 * h * 0.5 * G / inertia * StrictMath.sin(y[0]);
            }
            double off = angle + hinge.value(JointAxis.TWIST) - y[0];
            worst[0] = Math.max(worst[0], Math.abs(Math.IEEEremainder(off, 2 * Math.PI)));
        });
        scene.error("angleRadians", () -> worst[0]);
        scene.error(
                "energyRelative",
                () ->
                        Math.abs(
                                (scene.world().kineticEnergy()
                                                + scene.world().potentialEnergy()
                                                - start)
                                        / start));
        Gaps.watch(scene, "gapMetres", 1);
    }
}
