package dev.cairn.samples.scenes.heap;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.shape.Box;
import dev.cairn.render.camera.CameraMount;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;

import org.joml.Matrix3d;
import org.joml.Vector3d;

import java.util.List;

/**
 * The "complex" case of the Gazebo boxes study (S. Peters 2014): a box of 0.1 x 0.4 x 0.9 m and 10
 * kg thrown up, turning about its middle axis with a slight wobble, for 10 s. Their z is y here.
 *
 * <p>Truths of a free body: the centre of mass follows its parabola, the angular momentum L stays
 * the same vector, the energy stays the same.
 */
public final class Tumble {
    private static final double MASS = 10;

    /** The box is in the air for 23 s, which is more than any run looks at. */
    private static final double HEIGHT = 2500;

    private Tumble() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "tumble",
                "Tumbling box",
                "A thrown box turns about its middle axis, which is unstable. A case of the Gazebo"
                        + " boxes study.",
                "motion",
                List.of(Parameter.real("spin", 5, 0, 100, "about the middle axis, rad/s")),
                600,
                60,
                Tumble::build);
    }

    private static void build(SceneBuilder scene) {
        scene.floor(40, 40, 0.5, 0);
        BodyRef box =
                scene.add(
                        Box.ofHalfExtents(0.05, 0.45, 0.2),
                        Palette.body(0),
                        Body.dynamic()
                                .at(0, HEIGHT, 0)
                                .mass(MASS)
                                .velocity(-2, 8, -2)
                                .angularVelocity(0.1, 0.1, -scene.get("spin"))
                                .with(new CameraMount(0, 0.7, 2.8, true))
                                .name("box"));
        scene.view(new SceneView(0, HEIGHT + 0.7, 2.8, 0, HEIGHT, 0));
        Watch watch = new Watch(box);
        scene.afterTick(watch::note);
        scene.error("momentumRelative", () -> watch.momentum);
        scene.error("energyRelative", () -> watch.energy);
        scene.error("positionMetres", () -> watch.position);
    }

    /** Largest errors so far. */
    private static final class Watch {
        private final BodyRef box;
        private final Vector3d v0;
        private final Vector3d x0;
        private final Vector3d momentum0;
        private final double energy0;
        private final Vector3d v = new Vector3d();
        private final Vector3d x = new Vector3d();
        private final Vector3d spin = new Vector3d();
        private final Vector3d spun = new Vector3d();
        private final Matrix3d inertia = new Matrix3d();
        private double momentum;
        private double energy;
        private double position;

        Watch(BodyRef box) {
            this.box = box;
            v0 = box.velocity();
            x0 = box.centreOfMass(new Vector3d());
            look();
            momentum0 = new Vector3d(spun);
            energy0 = energyNow();
        }

        private void look() {
            box.velocity(v);
            box.centreOfMass(x);
            box.angularVelocity(spin);
            box.inverseInertia(inertia).invert().transform(spin, spun);
        }

        private double energyNow() {
            return MASS * (v.lengthSquared() / 2 + SampleScene.GRAVITY * (x.y - x0.y))
                    + spin.dot(spun) / 2;
        }

        void note(long tick, double t) {
            look();
            momentum = Math.max(momentum, spun.distance(momentum0) / momentum0.length());
            energy = Math.max(energy, Math.abs(energyNow() - energy0) / energy0);
            x.sub(x0).sub(v0.x * t, v0.y * t - SampleScene.GRAVITY * t * t / 2, v0.z * t);
            position = Math.max(position, x.length());
        }
    }
}
