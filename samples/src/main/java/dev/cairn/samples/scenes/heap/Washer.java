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
 * Boxes tumble in a drum, as in Box3D's benchmark {@code washer}: a drum of 36 panels at 25 degrees
 * a second, 20 x 20 x 20 boxes of 0.4 m.
 *
 * <p>Seen from the drum: the panels stand still and gravity turns the other way. Centrifugal and
 * Coriolis forces are left out; at 0.44 rad/s and 7 m they are below 0.14 g. No closed form:
 * nothing may overlap, nothing may leave.
 */
public final class Washer {
    private static final int PANELS = 36;
    private static final double HALF = 0.2;
    private static final double THICK = 0.5;

    private Washer() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "washer",
                "Washer",
                "Boxes tumble in a turning drum, seen from the drum: gravity turns. With side=20"
                        + " it has the 8000 boxes of Box3D's washer.",
                "piles",
                List.of(
                        Parameter.count("side", 5, 1, 30, "boxes along each axis"),
                        Parameter.real("speed", 25, 0, 360, "turn of the drum, degrees/s"),
                        Parameter.real("friction", 0.6, 0, 10, "Coulomb coefficient")),
                600,
                200,
                Washer::build);
    }

    private static final int DRUM = 0xB8BEC6;

    private static void build(SceneBuilder scene) {
        int side = scene.count("side");
        double friction = scene.get("friction");
        double pitch = 2.1 * HALF;
        // The cube of boxes just fits: half its diagonal, and a little air.
        double radius = 0.75 * side * pitch + 2 * HALF;
        double halfLength = side * pitch / 2 + HALF;
        double width = radius * StrictMath.tan(Math.PI / PANELS) + THICK * 0.1;
        Box panel = Box.ofHalfExtents(width, THICK, halfLength + THICK);
        for (int p = 0; p < PANELS; p++) {
            double angle = 2 * Math.PI * p / PANELS;
            double out = radius + THICK;
            scene.add(
                    panel,
                    DRUM,
                    Body.fixed()
                            .at(out * StrictMath.sin(angle), -out * StrictMath.cos(angle), 0)
                            .rotationAbout(0, 0, 1, angle)
                            .material(Palette.material(friction, 0)));
        }
        Box lid = Box.ofHalfExtents(radius + THICK, radius + THICK, THICK);
        for (int end = -1; end <= 1; end += 2) {
            scene.addGlass(
                    lid,
                    Body.fixed()
                            .at(0, 0, end * (halfLength + THICK))
                            .material(Palette.material(friction, 0)));
        }
        Box box = Box.cubeOfHalfExtent(HALF);
        for (int i = 0; i < side * side * side; i++) {
            int layer = i / (side * side);
            scene.add(
                    box,
                    Palette.body(i / side),
                    Body.dynamic()
                            .at(
                                    pitch * (i % side - (side - 1) / 2.0),
                                    pitch * (i / side % side - (side - 1) / 2.0),
                                    pitch * (layer - (side - 1) / 2.0))
                            .material(Palette.material(friction, 0)));
        }
        scene.view(new SceneView(0, 0, 3.2 * radius, 0, 0, 0));
        scene.gravityTurn(Math.toRadians(scene.get("speed")));
    }
}
