package dev.cairn.samples.scenes;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.shape.Box;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;

import java.util.ArrayList;
import java.util.List;

/**
 * Crates on a conveyor belt, which is turned round after a while.
 *
 * <p>Truth: dragged with mu g, a crate has the belt's speed u after u/(mu g), and keeps it.
 */
public final class Conveyor {
    private static final double HALF_LENGTH = 32;
    private static final double HALF_THICK = 0.1;
    private static final double HALF = 0.25;

    /** Ticks after which the belt runs the other way. */
    private static final int TURN = 240;

    private Conveyor() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "conveyor",
                "Conveyor belt",
                "Crates are dragged along by a belt, which is turned round after four seconds.",
                "contacts",
                List.of(
                        Parameter.count("crates", 8, 1, 20, "number of crates"),
                        Parameter.real("speed", 1.5, 0.1, 3, "of the belt, m/s"),
                        Parameter.real("friction", 0.6, 0.2, 10, "Coulomb coefficient")),
                480,
                150,
                Conveyor::build);
    }

    private static Collider belt(double speed) {
        return Collider.of(Box.ofHalfExtents(HALF_LENGTH, HALF_THICK, 1))
                .surfaceVelocity(speed, 0, 0);
    }

    private static void build(SceneBuilder scene) {
        int count = scene.count("crates");
        double speed = scene.get("speed");
        double friction = scene.get("friction");
        scene.floor(34, 6, friction, 0);
        Body frame = Body.fixed().at(0, 1 - HALF_THICK, 0).name("belt");
        BodyRef belt =
                scene.addParts(
                        List.of(belt(speed)),
                        Palette.STONE,
                        frame.material(Palette.material(friction, 0)));
        List<BodyRef> crates = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            crates.add(
                    scene.add(
                            Box.cubeOfHalfExtent(HALF),
                            Palette.body(i),
                            Body.dynamic()
                                    .at(0.8 * (i - (count - 1) / 2.0), 1 + HALF, 0)
                                    .material(Palette.material(friction, 0))));
        }
        double[] now = {speed};
        scene.beforeTick((tick, seconds) -> {
            if (tick == TURN) {
                now[0] = -speed;
                belt.colliders().get(0).replace(belt(-speed));
            }
        });
        scene.view(new SceneView(3, 3.5, 8, 0, 1, 0));
        scene.error(
                "speedRelative",
                () -> {
                    double worst = 0;
                    for (BodyRef crate : crates) {
                        worst = Math.max(worst, Math.abs(crate.velocity().x - now[0]));
                    }
                    return worst / speed;
                });
    }
}
