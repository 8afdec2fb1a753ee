package dev.cairn.samples.scenes.joint;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.joint.Joint;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;

import org.jspecify.annotations.Nullable;

import java.util.List;

/**
 * What joints hold more often than it can move: a bridge of planks between two piers, and a net.
 *
 * <p>Truth: no joint is ever apart by more than a thousandth of its link.
 */
public final class Nets {
    private static final double MESH = 1;

    private Nets() {}

    /**
     * A bridge of planks under boxes.
     *
     * @return its entry for the registry
     */
    public static SampleScene bridge() {
        return new SampleScene(
                "bridge",
                "Bridge",
                "Planks of 0.5 m on hinges between two piers; boxes fall onto them.",
                "joints",
                List.of(
                        Parameter.count("planks", 20, 2, 100, "planks of 10 kg"),
                        Parameter.count("boxes", 6, 0, 50, "boxes of 20 kg"),
                        Parameter.real(
                                "slack", 0.02, 0.005, 0.2, "how much longer it is than straight")),
                600,
                200,
                Nets::buildBridge);
    }

    /** Hinges on an arc of a circle, so that the planks are longer than the straight line. */
    private static void buildBridge(SceneBuilder scene) {
        int planks = scene.count("planks");
        double half = 0.25;
        // a chain of chords hangs from (-r sin t, 0) to (r sin t, 0), t of half of the arc
        double slack = scene.get("slack");
        double low = 0;
        double high = 1.5;
        for (int k = 0; k < 60; k++) {
            double t = 0.5 * (low + high);
            boolean isLess = planks * StrictMath.sin(t / planks) < (1 + slack) * StrictMath.sin(t);
            low = isLess ? t : low;
            high = isLess ? high : t;
        }
        double t = 0.5 * (low + high);
        double radius = half / StrictMath.sin(t / planks);
        double span = radius * StrictMath.sin(t);
        double top = 4;
        scene.floor(span, span, 0.6, 0);
        BodyRef last = pier(scene, -span, top);
        for (int k = 0; k < planks; k++) {
            double angle = t * (2 * k + 1 - planks) / planks;
            // the middle of a chord is nearer to the circle's centre than its ends
            double inner = radius * StrictMath.cos(t / planks);
            double x = inner * StrictMath.sin(angle);
            double y = top + radius * StrictMath.cos(t) - inner * StrictMath.cos(angle);
            BodyRef plank =
                    scene.add(
                            Box.ofHalfExtents(half - 0.02, 0.04, 0.6),
                            Palette.body(k % 2),
                            Body.dynamic().mass(10).at(x, y, 0).rotationAbout(0, 0, 1, angle));
            join(
                    scene,
                    last,
                    plank,
                    x - half * StrictMath.cos(angle),
                    y - half * StrictMath.sin(angle));
            last = plank;
        }
        join(scene, last, pier(scene, span, top), span, top);
        for (int k = 0; k < scene.count("boxes"); k++) {
            scene.add(
                    Box.ofHalfExtents(0.2, 0.2, 0.2),
                    Palette.body(4),
                    Body.dynamic()
                            .mass(20)
                            .at(
                                    0.55 * span * ((k * 0.618033988749895) % 1 * 2 - 1),
                                    top + 1 + k,
                                    0.1));
        }
        scene.view(
                new SceneView(
                        0.35 * span, top + 0.3 * span, 1.05 * span + 2, 0, top - 0.06 * span, 0));
        Gaps.watchPoints(scene);
    }

    private static BodyRef pier(SceneBuilder scene, double x, double top) {
        double side = x < 0 ? -0.5 : 0.5;
        return scene.add(
                Box.ofHalfExtents(0.48, 0.5 * top, 0.8),
                Palette.body(3),
                Body.fixed().at(x + side, 0.5 * top, 0));
    }

    private static void join(SceneBuilder scene, BodyRef a, BodyRef b, double x, double y) {
        scene.world().add(Joint.hinge(a, b).at(x, y, 0).axis(0, 0, 1));
    }

    /**
     * A net of balls, hung up by its upper edge.
     *
     * @return its entry for the registry
     */
    public static SampleScene grid() {
        return new SampleScene(
                "joint-grid",
                "Grid of joints",
                "A square net of balls, tied to their neighbours by ball joints, swings down from"
                        + " its upper edge.",
                "joints",
                List.of(Parameter.count("side", 12, 2, 100, "balls along an edge")),
                300,
                90,
                Nets::buildGrid);
    }

    private static void buildGrid(SceneBuilder scene) {
        int n = scene.count("side");
        double top = n + 1;
        @Nullable BodyRef[] before = new @Nullable BodyRef[n];
        for (int row = 0; row < n; row++) {
            BodyRef left = null;
            for (int k = 0; k < n; k++) {
                Body body = row == 0 ? Body.fixed() : Body.dynamic().mass(1);
                double x = MESH * (k - 0.5 * (n - 1));
                double z = MESH * row;
                BodyRef knot =
                        scene.add(Sphere.of(0.4), Palette.body((row + k) % 2), body.at(x, top, z));
                if (left != null && row > 0) {
                    scene.world().add(Joint.ball(left, knot).at(x - 0.5 * MESH, top, z));
                }
                BodyRef above = before[k];
                if (above != null) {
                    scene.world().add(Joint.ball(above, knot).at(x, top, z - 0.5 * MESH));
                }
                before[k] = knot;
                left = knot;
            }
        }
        scene.view(new SceneView(n, top, 1.5 * n + 6, 0, 0.6 * top, 0));
        Gaps.watchPoints(scene);
    }
}
