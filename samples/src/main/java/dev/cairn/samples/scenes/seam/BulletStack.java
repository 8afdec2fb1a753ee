package dev.cairn.samples.scenes.seam;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;

import java.util.ArrayList;
import java.util.List;

/**
 * A bullet strikes five boxes that lie side by side, without gravity.
 *
 * <p>Truth: momentum is constant, and the centre of all goes on as if nothing had happened: a
 * bullet that is stopped for the rest of a tick lags.
 */
public final class BulletStack {
    private static final double RADIUS = 0.05;
    private static final double MASS = 0.1;
    private static final double EDGE = 0.3;
    private static final int BOXES = 5;

    private BulletStack() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "bullet-stack",
                "Bullet into a stack",
                "A bullet strikes five boxes; momentum and the way of all go on.",
                "collisions",
                List.of(Parameter.real("speed", 300, 1, 10_000, "speed, m/s")),
                30,
                10,
                BulletStack::build);
    }

    private static void build(SceneBuilder scene) {
        double speed = scene.get("speed");
        double height = 2;
        scene.world().setGravity(0, 0, 0);
        Material surface = Palette.material(0, 0);
        List<BodyRef> bodies = new ArrayList<>();
        double start = -EDGE / 2 - RADIUS - 2.4 * speed * SampleScene.STEP_SECONDS;
        bodies.add(
                scene.add(
                        Sphere.of(RADIUS),
                        Palette.body(3),
                        Body.dynamic()
                                .mass(MASS)
                                .at(start, height, 0)
                                .velocity(speed, 0, 0)
                                .material(surface)));
        double sum = MASS * start;
        for (int i = 0; i < BOXES; i++) {
            bodies.add(
                    scene.add(
                            Box.cubeOfHalfExtent(EDGE / 2),
                            Palette.body(i),
                            Body.dynamic().mass(1).at(EDGE * i, height, 0).material(surface)));
            sum += EDGE * i;
        }
        double first = sum;
        double[] time = {0};
        scene.afterTick((tick, seconds) -> time[0] = seconds);
        scene.view(new SceneView(-2, height + 1, 5, 1, height, 0));
        scene.error(
                "momentumRelative",
                () -> {
                    double p = MASS * bodies.get(0).velocity().x;
                    for (int i = 1; i < bodies.size(); i++) {
                        p += bodies.get(i).velocity().x;
                    }
                    return Math.abs(p / (MASS * speed) - 1);
                });
        scene.error(
                "lagMetres",
                () -> {
                    double x = MASS * bodies.get(0).position().x;
                    for (int i = 1; i < bodies.size(); i++) {
                        x += bodies.get(i).position().x;
                    }
                    return Math.abs(first + MASS * speed * time[0] - x) / MASS;
                });
    }
}
