package dev.cairn.samples.scenes.level;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.shape.TriangleMesh;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;

import java.util.ArrayList;
import java.util.List;

/**
 * A house as one mesh: two floors, walls with doors and windows, a flight of stairs, a ramp. Balls,
 * boxes and capsules of the size of people come down the stairs.
 *
 * <p>Truth: nobody is below the ground floor, whose height is 0.
 */
public final class House {
    private static final int STEPS = 16;
    private static final double RISE = 0.2, TREAD = 0.3, UPPER = STEPS * RISE;
    private static final Shape[] KINDS = {
        Sphere.of(.3), Box.ofHalfExtents(.25, .3, .2), Capsule.of(.25, .5)
    };

    private House() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "level",
                "House of triangles",
                "Balls, boxes and capsules tumble down the stairs of a house that is one mesh.",
                "levels",
                List.of(Parameter.count("bodies", 60, 1, 600, "number of bodies")),
                480,
                240,
                House::build);
    }

    static TriangleMesh mesh() {
        Surfaces s = new Surfaces();
        s.block(-10, -.5, -8, 10, 0, 8);
        // outer walls, with a door at the foot of the stairs, and windows
        s.block(-10, 0, -8, 10, 1, -7.7).block(-10, 2, -8, 10, 5, -7.7);
        for (int i = 0; i < 6; i++) {
            s.block(-10 + 3.8 * i, 1, -8, -9 + 3.8 * i, 2, -7.7);
        }
        s.block(-10, 0, -7.7, -9.7, 5, 8).block(9.7, 0, -7.7, 10, 2.2, 8);
        // the upper floor, with the landing of the stairs at x = -3
        s.block(-9.7, UPPER - .25, -7.7, -3, UPPER, 2);
        for (int i = 0; i < STEPS - 1; i++) {
            s.block(-3 + TREAD * i, 0, -3, -3 + TREAD * (i + 1), UPPER - RISE * (i + 1), 0);
        }
        // a banister, and a ramp beside the stairs
        s.block(-3, UPPER, -7.7, -2.8, UPPER + .8, -3).block(-3, UPPER, 0, -2.8, UPPER + .8, 2);
        int a = s.vertex(-3, 0, 0);
        int b = s.vertex(2, 0, 0);
        int c = s.vertex(-3, UPPER, 0);
        int d = s.vertex(-3, 0, 2);
        int e = s.vertex(2, 0, 2);
        int f = s.vertex(-3, UPPER, 2);
        s.triangle(a, c, b);
        s.triangle(d, e, f);
        s.quad(c, f, e, b);
        // pillars
        for (int i = 0; i < 3; i++) {
            s.block(4 + 2 * i, 0, -5, 4.4 + 2 * i, 2, -4.6);
        }
        return s.mesh();
    }

    private static void build(SceneBuilder scene) {
        scene.add(
                mesh(),
                Palette.STONE,
                Body.fixed().material(Palette.material(0.5, 0)).name("house"));
        int count = scene.count("bodies");
        List<BodyRef> bodies = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            int column = i % 12;
            int rank = column / 4;
            int layer = i / 12;
            bodies.add(
                    scene.add(
                            KINDS[i % KINDS.length],
                            Palette.body(i),
                            Body.dynamic()
                                    .at(
                                            -3.6 - .9 * (column % 4) + scene.random(-.05, .05),
                                            UPPER + 1 + 1.7 * layer,
                                            -2.5 + rank + scene.random(-.05, .05))
                                    .velocity(3 + scene.random(0, 1), 0, 0)
                                    .material(Palette.material(0.3, 0))));
        }
        scene.view(new SceneView(9, 9, 12, -1, 1, -1));
        scene.error(
                "belowFloorMetres",
                () -> {
                    double worst = 0;
                    for (BodyRef body : bodies) {
                        boolean isIn =
                                Math.abs(body.position().x) < 10 && Math.abs(body.position().z) < 8;
                        worst = isIn ? Math.max(worst, -body.position().y) : worst;
                    }
                    return worst;
                });
    }
}
