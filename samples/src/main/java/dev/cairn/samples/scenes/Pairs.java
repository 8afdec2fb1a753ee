package dev.cairn.samples.scenes;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Contacts;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;

import org.joml.Vector3d;

import java.util.List;
import java.util.Locale;

/**
 * Three pairs in the air: a box into a box, a ball into a box, and two turned boxes whose bounding
 * boxes overlap while they do not touch. Truth: exactly two collisions. An upward force of {@code m
 * g} holds the bodies up.
 */
public final class Pairs {
    private static final double OVERLAP = 0.02;

    private Pairs() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "pairs-3",
                "Three pairs, two collisions",
                "Three hovering pairs: two touch, and of the third only the bounding boxes do. The"
                        + " collisions are printed.",
                "collisions",
                List.of(
                        Parameter.real(
                                "gap",
                                0.1,
                                0.03,
                                0.2,
                                "distance of the boxes that do not touch, m")),
                60,
                1,
                Pairs::build);
    }

    private static void build(SceneBuilder scene) {
        Shape cube = Box.cubeOfHalfExtent(0.5);
        Shape ball = Sphere.of(0.5);
        double y = 2;
        BodyRef[] bodies = {
            scene.add(cube, Palette.body(0), hovering(-3.5, y, "left box")),
            scene.add(cube, Palette.body(1), hovering(-3.5 + 1 - OVERLAP, y, "right box")),
            scene.add(
                    cube,
                    Palette.body(0),
                    hovering(2.2, y, "turned box").rotationAbout(0, 0, 1, Math.PI / 4)),
            scene.add(
                    ball,
                    Palette.body(1),
                    hovering(2.2 + StrictMath.sqrt(0.5) + 0.5 - OVERLAP, y, "ball")),
            // Two squares that stand on a corner: along the diagonal their faces are `gap` apart.
            scene.add(
                    cube,
                    Palette.body(2),
                    hovering(-0.6, y, "lower box").rotationAbout(0, 0, 1, Math.PI / 4)),
            scene.add(
                    cube,
                    Palette.body(3),
                    hovering(
                                    -0.6 + (1 + scene.get("gap")) * StrictMath.sqrt(0.5),
                                    y + (1 + scene.get("gap")) * StrictMath.sqrt(0.5),
                                    "upper box")
                            .rotationAbout(0, 0, 1, Math.PI / 4)),
        };
        scene.floor(12, 8, 0.6, 0);
        scene.view(new SceneView(-0.1, 2.4, 8, -0.1, 1.9, 0));

        scene.beforeTick((tick, seconds) -> {
            for (BodyRef body : bodies) {
                body.applyForce(0, body.mass() * SampleScene.GRAVITY, 0);
            }
        });
        Collisions collisions = new Collisions(scene);
        scene.afterTick(collisions::note);
        scene.error("collisionsOff", () -> Math.abs(collisions.count - 2));
    }

    private static Body hovering(double x, double y, String name) {
        return Body.dynamic().at(x, y, 0).mass(1).name(name);
    }

    /** Counts and prints what begins to touch. */
    private static final class Collisions {
        private final SceneBuilder scene;
        private int count;

        Collisions(SceneBuilder scene) {
            this.scene = scene;
        }

        void note(long tick, double seconds) {
            Contacts contacts = scene.world().contacts();
            Contacts.Events began = contacts.began();
            for (int e = 0; e < began.count(); e++) {
                count++;
                scene.remark(
                        "collision %d, tick %d: %s and %s%s"
                                .formatted(
                                        count,
                                        tick,
                                        began.bodyA(e).name(),
                                        began.bodyB(e).name(),
                                        details(contacts, began.bodyA(e), began.bodyB(e))));
            }
        }

        private static String details(Contacts contacts, BodyRef a, BodyRef b) {
            for (int c = 0; c < contacts.count(); c++) {
                if (contacts.bodyA(c).entity() == a.entity()
                        && contacts.bodyB(c).entity() == b.entity()) {
                    double deepest = 0;
                    for (int p = 0; p < contacts.pointCount(c); p++) {
                        deepest = Math.min(deepest, contacts.separation(c, p));
                    }
                    Vector3d n = contacts.normal(c, new Vector3d());
                    return String.format(
                            Locale.ROOT,
                            ", normal (%.3f, %.3f, %.3f), %d point(s), %.1f mm deep",
                            n.x,
                            n.y,
                            n.z,
                            contacts.pointCount(c),
                            -1000 * deepest);
                }
            }
            return "";
        }
    }
}
