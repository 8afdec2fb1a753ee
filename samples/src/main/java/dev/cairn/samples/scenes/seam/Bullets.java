package dev.cairn.samples.scenes.seam;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
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
 * Rods, plates, bricks, capsules and balls fly at a thin wall, turned and spinning anyhow.
 *
 * <p>Truth: none passes.
 */
public final class Bullets {
    private Bullets() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "bullets",
                "Bullets",
                "Rods, plates and bricks fly at a thin wall; none passes.",
                "collisions",
                List.of(
                        Parameter.count("bodies", 60, 1, 500, "number of bodies"),
                        Parameter.real("speed", 1000, 10, 10_000, "speed, m/s"),
                        Parameter.real("thickness", 0.001, 0.001, 1, "of the wall, m"),
                        Parameter.real("spin", 50, 0, 200, "largest spin, rad/s")),
                60,
                30,
                Bullets::build);
    }

    private static void build(SceneBuilder scene) {
        double speed = scene.get("speed");
        double thick = scene.get("thickness");
        double spin = scene.get("spin");
        int count = scene.count("bodies");
        double pitch = 1.5;
        int perRow = 10;
        double wide = pitch * perRow;
        double high = pitch * (2 + count / (double) perRow);
        scene.add(
                Box.ofHalfExtents(thick / 2, high / 2 + 20, wide),
                Palette.STONE,
                Body.fixed().at(0, high / 2, 0).name("wall"));
        List<BodyRef> bodies = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            Shape shape =
                    switch (i % 5) {
                        case 0 -> Box.ofHalfExtents(0.5, 0.02, 0.02);
                        case 1 -> Box.ofHalfExtents(0.3, 0.3, 0.005);
                        case 2 -> Box.ofHalfExtents(0.1, 0.05, 0.03);
                        case 3 -> Capsule.of(0.02, 0.3);
                        default -> Sphere.of(0.05);
                    };
            int row = i / perRow;
            bodies.add(
                    scene.add(
                            shape,
                            Palette.body(i),
                            Body.dynamic()
                                    .at(
                                            -2 - scene.random(0, 1) * speed / 60,
                                            2 + pitch * row,
                                            pitch * (i % perRow + 0.5) - wide / 2)
                                    .rotationAbout(
                                            scene.random(-0.5, 0.5),
                                            scene.random(-0.5, 0.5),
                                            1,
                                            scene.random(0, 6))
                                    .angularVelocity(
                                            scene.random(-spin / 2, spin / 2),
                                            scene.random(-spin / 2, spin / 2),
                                            scene.random(-spin / 2, spin / 2))
                                    .velocity(speed, 0, 0)));
        }
        scene.view(new SceneView(-8, high / 2, wide, 0, high / 2, 0));
        Passes passes = new Passes(bodies, thick / 2, high / 2, high / 2 + 20, wide);
        scene.afterTick((tick, seconds) -> passes.look());
        scene.error("passed", () -> passes.count);
    }

    /** Counts who comes out behind the wall having been before it, and not round its edge. */
    private static final class Passes {
        private final List<BodyRef> bodies;
        private final double face;
        private final double middle;
        private final double halfHigh;
        private final double halfWide;
        private final double[] before;
        private final Vector3d at = new Vector3d();
        private int count;

        Passes(List<BodyRef> bodies, double face, double middle, double halfHigh, double halfWide) {
            this.bodies = bodies;
            this.face = face;
            this.middle = middle;
            this.halfHigh = halfHigh;
            this.halfWide = halfWide;
            before = new double[3 * bodies.size()];
            for (int i = 0; i < bodies.size(); i++) {
                note(i);
            }
        }

        private void note(int i) {
            bodies.get(i).position(at);
            before[3 * i] = at.x;
            before[3 * i + 1] = at.y;
            before[3 * i + 2] = at.z;
        }

        void look() {
            for (int i = 0; i < bodies.size(); i++) {
                double x = before[3 * i];
                double y = before[3 * i + 1];
                double z = before[3 * i + 2];
                note(i);
                if (x <= face && at.x > face) {
                    double way = (face - x) / (at.x - x);
                    double high = Math.abs(y + way * (at.y - y) - middle);
                    boolean meets = high < halfHigh && Math.abs(z + way * (at.z - z)) < halfWide;
                    count += meets ? 1 : 0;
                }
            }
        }
    }
}
