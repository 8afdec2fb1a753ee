package dev.cairn.samples.scenes.joint;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.joint.Joint;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;

import java.util.List;

/**
 * Chains, one of them with a heavy end.
 *
 * <p>Truth: no joint is ever open, whatever hangs on it.
 */
public final class Chains {
    private static final double LINK = 0.5;

    private Chains() {}

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

    /**
     * A long chain.
     *
     * @return its entry for the registry
     */
    public static SampleScene plain() {
        return entry(
                "chain", "Chain", "Forty links swing by one end and do not stretch.", 40, 1, 80);
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
                        Body.dynamic().mass(scene.get("ratio")).at(r * s, top - r * c, 0));
        scene.world().add(Joint.ball(last, ball).at(length * s, top - length * c, 0));
        scene.view(new SceneView(0, 0.6 * length, 1.6 * length + 2, 0, 0.55 * length, 0));
        Gaps.watch(scene, "stretchRelative", LINK);
    }
}
