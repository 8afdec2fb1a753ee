package dev.cairn.samples.scenes.seam;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Cylinder;
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
 * Bodies slide along a wall of bricks, pressed against it by their way; beside it the same along a
 * smooth wall.
 *
 * <p>Truth: the smooth wall. No speed away from the wall, and the same velocity.
 */
public final class BrickWall {
    private static final double RADIUS = 0.3;

    /** From one course of bodies to the next, m. */
    private static final double LANE = 1.2;

    private static final int KINDS = 4;
    private static final int TICKS = 60;

    private BrickWall() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "brick-wall",
                "Wall of bricks",
                "What slides along a wall of bricks does as along a smooth one.",
                "levels",
                List.of(
                        Parameter.real("brick", 0.4, 0.2, 10, "length of a brick, m"),
                        Parameter.real("speed", 6, 1, 20, "speed along the wall, m/s"),
                        Parameter.real("friction", 0.1, 0, 1, "Coulomb coefficient")),
                TICKS,
                30,
                BrickWall::build);
    }

    private static void build(SceneBuilder scene) {
        double brick = scene.get("brick");
        double speed = scene.get("speed");
        Material surface = Palette.material(scene.get("friction"), 0);
        double way = speed * TICKS * SampleScene.STEP_SECONDS + 2;
        double high = KINDS * LANE;
        double course = brick / 2;
        for (int j = 0; j * course < high + 1; j++) {
            // every other course is moved by half a brick
            double from = j % 2 == 0 ? 0 : -brick / 2;
            for (int i = 0; (i - 2) * brick < way; i++) {
                scene.add(
                        Box.ofHalfExtents(brick / 2, course / 2, 0.1),
                        (i + j) % 2 == 0 ? Palette.STONE : Palette.body(7),
                        Body.fixed()
                                .at(from + (i - 0.5) * brick, (j + 0.5) * course, -0.1)
                                .material(surface));
            }
        }
        double apart = 4;
        scene.add(
                Box.ofHalfExtents(way / 2 + brick, high / 2 + 1, 0.1),
                Palette.STONE,
                Body.fixed().at(way / 2, high / 2, apart - 0.1).material(surface).name("smooth"));
        List<BodyRef> rough = new ArrayList<>();
        List<BodyRef> smooth = new ArrayList<>();
        for (int k = 0; k < KINDS; k++) {
            rough.add(put(scene, k, 0, speed, surface));
            smooth.add(put(scene, k, apart, speed, surface));
        }
        double[] worst = {0, 0};
        Vector3d v = new Vector3d();
        Vector3d truth = new Vector3d();
        scene.afterTick((tick, seconds) -> {
            for (int k = 0; k < KINDS; k++) {
                rough.get(k).velocity(v).sub(smooth.get(k).velocity(truth));
                worst[0] = Math.max(worst[0], Math.abs(v.z));
                worst[1] = Math.max(worst[1], v.length() / speed);
            }
        });
        scene.view(new SceneView(-4, high / 2 + 1, 8, 3, high / 2, 0));
        scene.error("kickMetresPerSecond", () -> worst[0]);
        scene.error("speedRelative", () -> worst[1]);
    }

    /** Without gravity, pushed against the wall by a constant force. */
    private static BodyRef put(
            SceneBuilder scene, int kind, double wall, double speed, Material surface) {
        Shape shape =
                switch (kind) {
                    case 0 -> Sphere.of(RADIUS);
                    case 1 -> Box.cubeOfHalfExtent(RADIUS);
                    case 2 -> Capsule.of(RADIUS, 0.15);
                    default -> Cylinder.of(RADIUS, 0.25);
                };
        BodyRef body =
                scene.add(
                        shape,
                        Palette.body(kind),
                        Body.dynamic()
                                .mass(1)
                                .gravityScale(0)
                                .at(0.2, (kind + 0.5) * LANE, wall + RADIUS)
                                .velocity(speed, 0, 0)
                                .material(surface));
        scene.beforeTick((tick, seconds) -> body.applyForce(0, 0, -SampleScene.GRAVITY));
        return body;
    }
}
