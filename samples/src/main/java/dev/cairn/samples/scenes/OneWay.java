package dev.cairn.samples.scenes;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.collider.ContactHook;
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
 * A platform that lets through what comes from below, and carries what comes from above.
 *
 * <p>Truth: while a ball is under or in the platform nothing touches it, so it rises to {@code
 * v²/(2 g)} above where it was thrown; afterwards it rests on the platform.
 */
public final class OneWay {
    private static final double HALF_THICK = 0.05;
    private static final double RADIUS = 0.25;
    private static final double HEIGHT = 2;
    private static final double SUNK = 0.005;
    private static final double UPRIGHT = 0.7;
    private static final String NAME = "one-way";

    private OneWay() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "one-way",
                "One-way platform",
                "Balls are thrown through a platform from below and come to rest on it.",
                "contacts",
                List.of(
                        Parameter.count("balls", 6, 1, 40, "number of balls"),
                        Parameter.real("speed", 8, 7, 100, "of the throw, m/s")),
                400,
                60,
                OneWay::build);
    }

    /** Solid for what stands on it, or comes from above and has not sunk in. */
    private static void platform(ContactHook.Change contact) {
        boolean first = NAME.equals(contact.userDataA());
        if (!first && !NAME.equals(contact.userDataB())) {
            return;
        }
        double up = first ? contact.normalY() : -contact.normalY();
        boolean stands = contact.memory() == 1 || contact.separation() > -SUNK;
        boolean solid = up > UPRIGHT && stands;
        contact.remember(solid ? 1 : 0);
        if (!solid) {
            contact.disable();
        }
    }

    private static void build(SceneBuilder scene) {
        int count = scene.count("balls");
        double speed = scene.get("speed");
        scene.floor(12, 6, 0.6, 0);
        scene.world().collisions().setHook(OneWay::platform);
        Box slab = Box.ofHalfExtents(0.4 * count + 0.5, HALF_THICK, 1);
        scene.addParts(
                List.of(Collider.of(slab).userData(NAME)),
                Palette.STONE,
                Body.fixed().at(0, HEIGHT, 0).name("platform"));
        List<BodyRef> balls = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            double x = 0.8 * (i - (count - 1) / 2.0);
            balls.add(
                    scene.add(
                            Sphere.of(RADIUS),
                            Palette.body(i),
                            Body.dynamic()
                                    .at(x, RADIUS + 0.01, 0)
                                    .material(Palette.material(0.6, 0).withRollingArm(0.01))));
        }
        scene.beforeTick((tick, seconds) -> {
            if (tick == 1) {
                balls.forEach(ball -> ball.setVelocity(0, speed, 0));
            }
        });
        scene.view(new SceneView(2, 3.4, 8, 0, 1.6, 0));
        scene.error(
                "heightMetres",
                () -> {
                    double rest = HEIGHT + HALF_THICK + RADIUS;
                    double worst = 0;
                    for (BodyRef ball : balls) {
                        boolean still = ball.velocity().length() < 1e-3;
                        worst = still ? Math.max(worst, Math.abs(ball.position().y - rest)) : worst;
                    }
                    return worst;
                });
    }
}
