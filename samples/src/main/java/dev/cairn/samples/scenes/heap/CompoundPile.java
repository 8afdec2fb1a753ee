package dev.cairn.samples.scenes.heap;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Shape;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;

import org.joml.Quaterniond;

import java.util.ArrayList;
import java.util.List;

/**
 * Tables, chairs and jacks fall on a heap, get a kick, and come to rest again. No closed form: what
 * can be said is that nothing overlaps, that the floor carries them all, and that it ends.
 */
public final class CompoundPile {
    private static final Quaterniond ALONG_X = new Quaterniond().rotateZ(Math.PI / 2);
    private static final Quaterniond ALONG_Z = new Quaterniond().rotateX(Math.PI / 2);

    /** Tick of the kick, and speed that it gives, m/s. */
    private static final int KICK = 240;

    private static final double SPEED = 2;

    private CompoundPile() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "compound-pile",
                "Pile of furniture",
                "Tables, chairs and jacks, bodies of three to six shapes, fall on a heap, are"
                        + " kicked, and come to rest.",
                "piles",
                List.of(
                        Parameter.count("bodies", 36, 3, 3000, "number of bodies"),
                        Parameter.real("friction", 0.6, 0, 10, "Coulomb coefficient")),
                700,
                230,
                CompoundPile::build);
    }

    private static void build(SceneBuilder scene) {
        double friction = scene.get("friction");
        int count = scene.count("bodies");
        int side = Math.max(1, (int) Math.round(Math.sqrt(count / 4.0)));
        scene.floor(2 * side + 4, 2 * side + 4, friction, 0);
        List<BodyRef> pile = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            double x = 1.4 * (i % side - (side - 1) / 2.0) + scene.random(-0.1, 0.1);
            double z = 1.4 * (i / side % side - (side - 1) / 2.0) + scene.random(-0.1, 0.1);
            int layer = i / (side * side);
            double y = 0.8 + 1.3 * layer;
            Quaterniond turn =
                    new Quaterniond()
                            .rotateXYZ(
                                    scene.random(-0.5, 0.5),
                                    scene.random(-3, 3),
                                    scene.random(-0.5, 0.5));
            Body body =
                    Body.dynamic()
                            .at(x, y, z)
                            .rotation(turn)
                            .material(Palette.material(friction, 0));
            pile.add(scene.addParts(parts(i % 3), Palette.body(i), body));
        }
        scene.beforeTick((tick, seconds) -> {
            if (tick == KICK) {
                for (BodyRef body : pile) {
                    body.applyImpulse(0, SPEED * body.mass(), 0);
                }
            }
        });
        double far = 3 + 1.6 * side;
        scene.view(new SceneView(0.6 * far, 0.8 * far, far, 0, 0.6, 0));
    }

    private static List<Collider> parts(int kind) {
        return switch (kind) {
            case 0 -> table();
            case 1 -> chair();
            default -> jack();
        };
    }

    private static List<Collider> table() {
        List<Collider> parts = new ArrayList<>();
        parts.add(Collider.of(Box.ofHalfExtents(0.6, 0.04, 0.4)).at(0, 0.3, 0));
        legs(parts, 0.54, 0.34);
        return parts;
    }

    private static List<Collider> chair() {
        List<Collider> parts = new ArrayList<>();
        parts.add(Collider.of(Box.ofHalfExtents(0.3, 0.04, 0.3)).at(0, 0.3, 0));
        parts.add(Collider.of(Box.ofHalfExtents(0.3, 0.3, 0.04)).at(0, 0.64, -0.26));
        legs(parts, 0.24, 0.24);
        return parts;
    }

    private static void legs(List<Collider> parts, double x, double z) {
        Box leg = Box.ofHalfExtents(0.04, 0.26, 0.04);
        for (int i = 0; i < 4; i++) {
            parts.add(Collider.of(leg).at(i < 2 ? -x : x, 0, i % 2 == 0 ? -z : z));
        }
    }

    private static List<Collider> jack() {
        Shape bar = Capsule.of(0.1, 0.3);
        return List.of(
                Collider.of(bar),
                Collider.of(bar).rotation(ALONG_X),
                Collider.of(bar).rotation(ALONG_Z));
    }
}
