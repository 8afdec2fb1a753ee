package dev.cairn.samples.scenes;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.render.mesh.Model;
import dev.cairn.render.mesh.Texture;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;

import org.joml.Vector3d;

import java.util.ArrayList;
import java.util.List;

/**
 * Elastic balls in a row on a smooth floor, a tenth of a millimetre apart.
 *
 * <p>Truth: as many leave as came, with the same speed, and the others stand still.
 */
public final class Cradle {
    private static final double RADIUS = 0.25;
    private static final double GAP = 1e-4;
    private static final double RUN = 1.2;

    private Cradle() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "cradle",
                "Newton's cradle",
                "Elastic balls roll into a row on a frictionless floor; as many leave as came.",
                "impacts",
                List.of(
                        Parameter.count("balls", 5, 2, 20, "number of balls"),
                        Parameter.count("coming", 2, 1, 19, "how many of them come in"),
                        Parameter.real("speed", 1, 0.2, 10, "their speed, m/s")),
                240,
                110,
                Cradle::build);
    }

    private static final int COMING = 0xE3A88A;
    private static final int WAITING = 0xC9CED6;

    private static void build(SceneBuilder scene) {
        int count = scene.count("balls");
        int coming = Math.min(scene.count("coming"), count - 1);
        double speed = scene.get("speed");
        scene.floor(8, 4, 0, 0);
        Sphere ball = Sphere.of(RADIUS);
        Model steel = Model.of(ball).texture(Texture.bareMetal());
        List<BodyRef> balls = new ArrayList<>();
        double pitch = 2 * RADIUS + GAP;
        for (int i = 0; i < count; i++) {
            boolean moves = i < coming;
            balls.add(
                    scene.add(
                            ball,
                            steel.color(moves ? COMING : WAITING),
                            Body.dynamic()
                                    .at(
                                            pitch * (i - 0.5 * (count - 1)) - (moves ? RUN : 0),
                                            RADIUS,
                                            0)
                                    .velocity(moves ? speed : 0, 0, 0)
                                    .material(Palette.material(0, 1))
                                    .name("ball " + i)));
        }
        scene.view(new SceneView(0.6, 1.0, 2.9, 0.1, 0.22, 0));
        double after = (RUN + 4 * GAP * count) / speed + SampleScene.STEP_SECONDS;
        Ramp.Metric worst = new Ramp.Metric();
        Vector3d v = new Vector3d();
        scene.afterTick((tick, seconds) -> {
            if (seconds > after) {
                for (int i = 0; i < count; i++) {
                    double expected = i >= count - coming ? speed : 0;
                    worst.raise(balls.get(i).velocity(v).distance(expected, 0, 0));
                }
            }
        });
        scene.error("speedMetresPerSecond", worst::get);
    }
}
