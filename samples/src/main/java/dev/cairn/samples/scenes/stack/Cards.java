package dev.cairn.samples.scenes.stack;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.shape.Box;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;

import org.joml.Vector3d;

import java.util.ArrayList;
import java.util.List;

/**
 * A house of cards, 2 mm thin.
 *
 * <p>Truth: with friction 0.7 it stands (Solver2D's CardHouse, cards of half 0.1 x 0.001 x 0.2 m,
 * leaning by 25°). Each pair leans against each other; a level card lies on two peaks.
 */
public final class Cards {
    private static final double HALF_THICKNESS = 0.001;
    private static final double HALF_LENGTH = 0.2;
    private static final double HALF_WIDTH = 0.1;
    private static final double LEAN = StrictMath.toRadians(25);

    private static final int TOWER = 10;
    private static final int ABREAST = 10;

    private Cards() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "cards",
                "House of cards",
                "Cards of 2 mm stand on five levels, held by friction alone.",
                "structures",
                List.of(
                        Parameter.count("levels", 5, 1, 12, "levels of the house"),
                        Parameter.real("friction", 0.7, 0, 10, "Coulomb coefficient"),
                        Parameter.count(
                                "cubes", 0, 0, 10_000, "cubes of 1 m that stand behind, in tens")),
                600,
                1,
                Cards::build);
    }

    private static void build(SceneBuilder scene) {
        int levels = scene.count("levels");
        double friction = scene.get("friction");
        int towers = (scene.count("cubes") + TOWER - 1) / TOWER;
        int deep = (towers + ABREAST - 1) / ABREAST;
        scene.floor(deep == 0 ? 6 : 2 * ABREAST, 4 + 4 * deep, friction, 0);
        Box card = Box.ofHalfExtents(HALF_THICKNESS, HALF_LENGTH, HALF_WIDTH);
        double sin = StrictMath.sin(LEAN);
        double cos = StrictMath.cos(LEAN);
        // half the box that a leaning card fills
        double wide = HALF_LENGTH * sin + HALF_THICKNESS * cos;
        double high = HALF_LENGTH * cos + HALF_THICKNESS * sin;
        // feet of neighbours are 2 mm apart; level cards reach over the outer corners of the peaks
        double pitch = 4 * wide + 0.002;
        Box level = Box.ofHalfExtents(0.5 * pitch - 0.0005, HALF_THICKNESS, HALF_WIDTH);
        List<BodyRef> all = new ArrayList<>();
        List<Vector3d> starts = new ArrayList<>();
        double y = 0;
        for (int row = 0; row < levels; row++) {
            int pairs = levels - row;
            for (int i = 0; i < pairs; i++) {
                double middle = pitch * (i - 0.5 * (pairs - 1));
                for (int side = -1; side <= 1; side += 2) {
                    all.add(
                            scene.add(
                                    card,
                                    Palette.body(row),
                                    Body.dynamic()
                                            .at(middle + side * wide, y + high, 0)
                                            .rotationAbout(0, 0, 1, side * LEAN)
                                            .material(Palette.material(friction, 0))
                                            .name("leaning card")));
                }
            }
            y += 2 * high;
            for (int i = 0; i + 1 < pairs; i++) {
                all.add(
                        scene.add(
                                level,
                                Palette.body(row + 3),
                                Body.dynamic()
                                        .at(pitch * (i - 0.5 * (pairs - 2)), y + HALF_THICKNESS, 0)
                                        .material(Palette.material(friction, 0))
                                        .name("level card")));
            }
            y += 2 * HALF_THICKNESS;
        }
        for (BodyRef body : all) {
            starts.add(body.position());
        }
        scene.view(
                new SceneView(
                        0.25 * levels, 0.28 * levels, 0.5 * levels + 0.4, 0, 0.17 * levels, 0));
        towers(scene, friction);
        Vector3d at = new Vector3d();
        scene.error(
                "movedMetres",
                () -> {
                    double worst = 0;
                    for (int i = 0; i < all.size(); i++) {
                        worst = Math.max(worst, all.get(i).position(at).distance(starts.get(i)));
                    }
                    return worst;
                });
    }

    /** They need no more than the usual sub-steps: what they cost tells who pays for the cards. */
    private static void towers(SceneBuilder scene, double friction) {
        Box cube = Box.cubeOfHalfExtent(0.5);
        for (int i = 0; i < scene.count("cubes"); i++) {
            int tower = i / TOWER;
            scene.add(
                    cube,
                    Palette.body(i),
                    Body.dynamic()
                            .at(
                                    3 * (tower % ABREAST - 0.5 * (ABREAST - 1)),
                                    i % TOWER + 0.5,
                                    -3 - 3 * (tower / ABREAST))
                            .material(Palette.material(friction, 0))
                            .name("cube"));
        }
    }
}
