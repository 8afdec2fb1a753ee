package dev.cairn.samples.scenes.heap;

import dev.cairn.physics.Body;
import dev.cairn.physics.shape.Box;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;

import java.util.List;

/**
 * Boxes poured into a pit.
 *
 * <p>Truth: after a while nothing moves and nothing overlaps.
 */
public final class BoxPit {
    private static final double HALF = 0.5;

    /** Pitch of the lattice that the boxes fall from, m. */
    private static final double PITCH = 1.75;

    private BoxPit() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "pile",
                "Pile",
                "256 boxes fall into a pit and come to rest in a heap.",
                "piles",
                List.of(
                        Parameter.count("boxes", 256, 1, 20000, "number of boxes"),
                        Parameter.count("width", 4, 1, 100, "boxes along each side of a layer"),
                        Parameter.real("friction", 0.6, 0, 10, "Coulomb coefficient"),
                        Parameter.real("drop", 1, 0, 20, "height of the lowest layer, m")),
                720,
                700,
                BoxPit::build);
    }

    private static void build(SceneBuilder scene) {
        int count = scene.count("boxes");
        int width = scene.count("width");
        double friction = scene.get("friction");
        double inside = 0.5 * width * PITCH + 1.5;
        scene.floor(inside + 12, inside + 12, friction, 0);
        // half the height of the walls: the loose heap fills about 0.6 of its room
        double wall = 0.5 + 0.5 * count / (2.4 * inside * inside);
        Box side = Box.ofHalfExtents(inside + 2 * HALF, wall, HALF);
        Box between = Box.ofHalfExtents(inside, wall, HALF);
        for (int i = 0; i < 4; i++) {
            double x = (i % 2 == 0 ? 0 : i - 2) * (inside + HALF);
            double z = (i % 2 == 0 ? i - 1 : 0) * (inside + HALF);
            scene.addGlass(
                    i % 2 == 0 ? side : between,
                    Body.fixed()
                            .at(x, wall, z)
                            .rotationAbout(0, 1, 0, i % 2 == 0 ? 0 : StrictMath.PI / 2)
                            .material(Palette.material(friction, 0))
                            .name("wall"));
        }
        Box shape = Box.cubeOfHalfExtent(HALF);
        for (int k = 0; k < count; k++) {
            int layer = k / (width * width);
            double x = (k % width - 0.5 * (width - 1)) * PITCH;
            double z = (k / width % width - 0.5 * (width - 1)) * PITCH;
            scene.add(
                    shape,
                    Palette.body(layer),
                    Body.dynamic()
                            .at(
                                    x + scene.random(-0.2, 0.2),
                                    HALF + scene.get("drop") + PITCH * layer,
                                    z + scene.random(-0.2, 0.2))
                            .rotationAbout(
                                    1,
                                    scene.random(-1, 1),
                                    scene.random(-1, 1),
                                    scene.random(-3, 3))
                            .material(Palette.material(friction, 0)));
        }
        double distance = 2.2 * inside + 7;
        scene.view(new SceneView(0.45 * distance, 0.9 * distance, 0.7 * distance, 0, 1, 0));
        scene.error("kineticJoulesPerBox", () -> scene.world().kineticEnergy() / count);
        scene.error("overlapMetres", () -> overlap(scene));
    }

    /** Deepest overlap that the engine itself knows of. */
    private static double overlap(SceneBuilder scene) {
        double deepest = 0;
        var contacts = scene.world().contacts();
        for (int c = 0; c < contacts.count(); c++) {
            for (int p = 0; p < contacts.pointCount(c); p++) {
                deepest = Math.max(deepest, -contacts.separation(c, p));
            }
        }
        return deepest;
    }
}
