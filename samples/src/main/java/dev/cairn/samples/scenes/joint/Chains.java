package dev.cairn.samples.scenes.joint;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.joint.Joint;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;

import java.util.List;

/**
 * Chains, a bridge and a net.
 *
 * <p>Truth: no joint is ever open, whatever hangs on it.
 */
public final class Chains {
    private static final double LINK = 0.5;

    private Chains() {}

    /**
     * A chain by itself.
     *
     * @return its entry for the registry
     */
    public static SampleScene light() {
        return entry("chain", "Chain", "A chain swings from a peg.", 30, 1, 80);
    }

    /**
     * A chain with a heavy ball.
     *
     * @return its entry for the registry
     */
    public static SampleScene heavy() {
        return entry(
                "chain-heavy",
                "Chain with a heavy ball",
                "Ten links carry a ball of 100 times the mass of one; ratio=1000 is as good.",
                10,
                100,
                80);
    }

    private static SampleScene entry(
            String id, String title, String text, int links, double ratio, double degrees) {
        return new SampleScene(
                id,
                title,
                text,
                "joints",
                List.of(
                        Parameter.count("links", links, 1, 200, "links of 1 kg and 0.5 m"),
                        Parameter.real("ratio", ratio, 0.1, 10000, "mass of the ball, kg"),
                        Parameter.real("degrees", degrees, 0, 90, "from the vertical at first")),
                600,
                70,
                Chains::buildChain);
    }

    private static void buildChain(SceneBuilder scene) {
        int links = scene.count("links");
        double angle = Math.toRadians(scene.get("degrees"));
        double s = StrictMath.sin(angle);
        double c = StrictMath.cos(angle);
        double length = LINK * links;
        double top = length + 1;
        BodyRef last = scene.add(Sphere.of(0.03), Palette.body(3), Body.fixed().at(0, top, 0));
        Capsule shape = Capsule.of(0.05, 0.15);
        for (int k = 0; k < links; k++) {
            double r = LINK * (k + 0.5);
            BodyRef link =
                    scene.add(
                            shape,
                            Palette.body(k % 2),
                            Body.dynamic()
                                    .mass(1)
                                    .at(r * s, top - r * c, 0)
                                    .rotationAbout(0, 0, 1, angle));
            r = LINK * k;
            scene.world().add(Joint.ball(last, link).at(r * s, top - r * c, 0));
            last = link;
        }
        double r = length + 0.25;
        BodyRef ball =
                scene.add(
                        Sphere.of(0.25),
                        Palette.body(4),
                        Body.dynamic()
                                .mass(scene.get("ratio"))
                                .at(r * s, top - r * c, 0));
        scene.world().add(Joint.ball(last, ball).at(length * s, top - length * c, 0));
        scene.view(
                new SceneBuilder.View(0, 0.6 * length, 1.6 * length + 2, 0, 0.55 * length, 0));
        Gaps.watch(scene, "stretchRelative", LINK);
    }

    /**
     * A bridge of planks, and boxes that fall on it.
     *
     * @return its entry for the registry
     */
    public static SampleScene bridge() {
        return new SampleScene(
                "bridge",
                "Bridge",
                "Planks on hinges span a gap; boxes fall on them.",
                "joints",
                List.of(
                        Parameter.count("planks", 20, 2, 100, "planks of 0.5 m"),
                        Parameter.count("boxes", 5, 0, 50, "boxes that fall on it")),
                600,
                240,
                Chains::buildBridge);
    }

    private static void buildBridge(SceneBuilder scene) {
        int planks = scene.count("planks");
        double half = 0.5 * LINK * planks;
        double top = 3;
        Box plank = Box.of(0.24, 0.05, 0.8);
        BodyRef left = pier(scene, -half - 0.5, top);
        BodyRef last = left;
        for (int k = 0; k < planks; k++) {
            double x = -half + LINK * (k + 0.5);
            BodyRef next =
                    scene.add(plank, Palette.body(k % 2), Body.dynamic().mass(10).at(x, top, 0));
            scene.world().add(Joint.hinge(last, next).at(x - 0.25, top, 0).axis(0, 0, 1));
            last = next;
        }
        BodyRef right = pier(scene, half + 0.5, top);
        scene.world().add(Joint.hinge(last, right).at(half, top, 0).axis(0, 0, 1));
        for (int k = 0; k < scene.count("boxes"); k++) {
            scene.add(
                    Box.of(0.25, 0.25, 0.25),
                    Palette.body(4),
                    Body.dynamic().at(0.7 * (k % 5 - 2), top + 1 + 0.6 * (k / 5), 0));
        }
        scene.view(new SceneBuilder.View(0, 4.5, half + 6, 0, 2, 0));
        Gaps.watch(scene, "gapMetres", 1);
    }

    private static BodyRef pier(SceneBuilder scene, double x, double top) {
        return scene.add(
                Box.of(0.5, 0.5 * top, 1), Palette.body(3), Body.fixed().at(x, 0.5 * top - 0.05, 0));
    }

    /**
     * A net of balls that hangs by its edge.
     *
     * @return its entry for the registry
     */
    public static SampleScene grid() {
        return new SampleScene(
                "joint-grid",
                "Net of balls",
                "Balls on ball joints, a net that hangs by one edge; size=100 is Box3D's.",
                "joints",
                List.of(Parameter.count("size", 16, 2, 100, "balls along an edge")),
                300,
                90,
                Chains::buildGrid);
    }

    private static void buildGrid(SceneBuilder scene) {
        int n = scene.count("size");
        double pitch = 1;
        Sphere ball = Sphere.of(0.4);
        BodyRef[] row = new BodyRef[n];
        for (int i = 0; i < n; i++) {
            BodyRef left = null;
            for (int k = 0; k < n; k++) {
                double x = pitch * (k - 0.5 * n);
                double z = pitch * i;
                Body body = i == 0 ? Body.fixed() : Body.dynamic();
                BodyRef next = scene.add(ball, Palette.body((i + k) % 2), body.at(x, n, z));
                if (i > 0) {
                    scene.world().add(Joint.ball(row[k], next).at(x, n, z - 0.5 * pitch));
                    if (left != null) {
                        scene.world().add(Joint.ball(left, next).at(x - 0.5 * pitch, n, z));
                    }
                }
                row[k] = next;
                left = next;
            }
        }
        scene.view(new SceneBuilder.View(1.2 * n, 1.2 * n, 1.8 * n, 0, 0.6 * n, 0.3 * n));
        Gaps.watch(scene, "gapMetres", 1);
    }
}
