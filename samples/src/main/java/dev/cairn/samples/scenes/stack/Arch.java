package dev.cairn.samples.scenes.stack;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;

import org.joml.Vector3d;

import java.util.ArrayList;
import java.util.List;

/**
 * A semicircular arch of wedges, without mortar.
 *
 * <p>Truth: with friction enough it stands while thickness over mean radius is at least 0.1075, and
 * falls below that (Milankovitch 1907; Heyman 1969).
 */
public final class Arch {
    private static final double RADIUS = 5;
    private static final double HALF_DEPTH = 0.5;

    /** The foot's height above the ground, so that a fall is seen. */
    private static final double FOOT = 1;

    private Arch() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "arch",
                "Arch",
                "An arch of wedges stands by its shape alone; below thickness=0.1075 it falls.",
                "structures",
                List.of(
                        Parameter.count("stones", 15, 5, 61, "number of wedges"),
                        Parameter.real("thickness", 0.2, 0.02, 0.5, "thickness over mean radius"),
                        Parameter.real("friction", 0.8, 0, 10, "Coulomb coefficient")),
                600,
                300,
                Arch::build);
    }

    private static void build(SceneBuilder scene) {
        int stones = scene.count("stones");
        double friction = scene.get("friction");
        double inner = RADIUS * (1 - 0.5 * scene.get("thickness"));
        double outer = RADIUS * (1 + 0.5 * scene.get("thickness"));
        scene.floor(12, 8, friction, 0);
        Box foot = Box.ofHalfExtents(1, 0.5 * FOOT, 1);
        for (int side = -1; side <= 1; side += 2) {
            scene.add(
                    foot,
                    Palette.STONE,
                    Body.fixed()
                            .at(side * (RADIUS + 0.2), 0.5 * FOOT, 0)
                            .material(Palette.material(friction, 0))
                            .name("abutment"));
        }
        double wedge = StrictMath.PI / stones;
        List<BodyRef> ring = new ArrayList<>();
        List<Vector3d> starts = new ArrayList<>();
        for (int i = 0; i < stones; i++) {
            double[] corners = new double[24];
            for (int k = 0; k < 8; k++) {
                double angle = wedge * (i + (k & 1));
                double r = (k & 2) == 0 ? inner : outer;
                corners[3 * k] = -r * StrictMath.cos(angle);
                corners[3 * k + 1] = FOOT + r * StrictMath.sin(angle);
                corners[3 * k + 2] = (k & 4) == 0 ? -HALF_DEPTH : HALF_DEPTH;
            }
            BodyRef stone =
                    scene.add(
                            ConvexHull.of(corners),
                            Palette.body(i),
                            Body.dynamic()
                                    .material(Palette.material(friction, 0))
                                    .name("stone " + i));
            ring.add(stone);
            starts.add(stone.centreOfMass(new Vector3d()));
        }
        scene.view(new SceneView(3, 4.5, 13, 0, 3, 0));
        Vector3d at = new Vector3d();
        scene.error(
                "movedMetres",
                () -> {
                    double worst = 0;
                    for (int i = 0; i < ring.size(); i++) {
                        worst =
                                Math.max(
                                        worst,
                                        ring.get(i).centreOfMass(at).distance(starts.get(i)));
                    }
                    return worst;
                });
    }
}
