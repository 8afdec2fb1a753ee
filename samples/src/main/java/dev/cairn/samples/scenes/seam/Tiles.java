package dev.cairn.samples.scenes.seam;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;

import org.joml.Quaterniond;
import org.joml.Vector3d;

import java.util.ArrayList;
import java.util.List;

/**
 * A ball, a box, a capsule and a cylinder cross a floor of tiles; beside it the same on one slab.
 *
 * <p>Truth: the slab. No vertical speed that it does not give, and the same velocity, as long as
 * both are there: who rolls on after the end of the floor is no longer compared.
 */
public final class Tiles {
    private static final double RADIUS = 0.3;

    /** From one lane to the next, m. */
    private static final double LANE = 1.8;

    private static final int KINDS = 4;
    private static final int TICKS = 90;

    private Tiles() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "tiles",
                "Floor of tiles",
                "What crosses a floor of tiles does as on the slab beside it.",
                "levels",
                List.of(
                        Parameter.real("tile", 0.9, 0.3, 10, "edge of a tile, m"),
                        Parameter.real("speed", 9, 1, 20, "speed at the start, m/s"),
                        Parameter.real("friction", 0.1, 0, 1, "Coulomb coefficient")),
                TICKS,
                60,
                Tiles::build);
    }

    private static void build(SceneBuilder scene) {
        double tile = scene.get("tile");
        double speed = scene.get("speed");
        Material surface = Palette.material(scene.get("friction"), 0);
        double way = speed * TICKS * SampleScene.STEP_SECONDS + 2;
        double wide = KINDS * LANE;
        for (int i = 0; (i - 1) * tile < way; i++) {
            for (int j = 0; j * tile < wide + tile; j++) {
                scene.add(
                        Box.ofHalfExtents(tile / 2, 0.2, tile / 2),
                        (i + j) % 2 == 0 ? Palette.STONE : Palette.body(7),
                        Body.fixed()
                                .at((i - 0.5) * tile, -0.2, (j + 0.5) * tile)
                                .material(surface));
            }
        }
        scene.add(
                Box.ofHalfExtents(way / 2 + tile, 0.2, wide / 2),
                Palette.STONE,
                Body.fixed().at(way / 2, -0.2, -wide / 2 - 0.5).material(surface).name("slab"));
        List<BodyRef> onTiles = new ArrayList<>();
        List<BodyRef> onSlab = new ArrayList<>();
        for (int k = 0; k < KINDS; k++) {
            onTiles.add(put(scene, k, (k + 0.5) * LANE, speed, surface));
            onSlab.add(put(scene, k, (k + 0.5) * LANE - wide - 0.5, speed, surface));
        }
        double[] worst = {0, 0};
        Vector3d v = new Vector3d();
        Vector3d truth = new Vector3d();
        boolean[] isPast = new boolean[KINDS];
        scene.afterTick((tick, seconds) -> {
            for (int k = 0; k < KINDS; k++) {
                isPast[k] |=
                        onTiles.get(k).position(v).x > way || onSlab.get(k).position(v).x > way;
                if (isPast[k]) {
                    continue;
                }
                onTiles.get(k).velocity(v).sub(onSlab.get(k).velocity(truth));
                worst[0] = Math.max(worst[0], Math.abs(v.y));
                worst[1] = Math.max(worst[1], v.length() / speed);
            }
        });
        scene.view(new SceneView(-3, 4, 0, 4, 0, 0));
        scene.error("kickMetresPerSecond", () -> worst[0]);
        scene.error("speedRelative", () -> worst[1]);
    }

    private static BodyRef put(
            SceneBuilder scene, int kind, double z, double speed, Material surface) {
        Shape shape =
                switch (kind) {
                    case 0 -> Sphere.of(RADIUS);
                    case 1 -> Box.cubeOfHalfExtent(RADIUS);
                    case 2 -> Capsule.of(RADIUS, 0.3);
                    default -> Cylinder.of(RADIUS, 0.3);
                };
        // capsule and cylinder lie across the way
        Quaterniond across = new Quaterniond().rotationX(Math.PI / 2);
        Body body =
                Body.dynamic()
                        .at(0, RADIUS, z)
                        .rotation(kind < 2 ? new Quaterniond() : across)
                        .velocity(speed, 0, 0)
                        .angularVelocity(0, 0, kind == 1 ? 0 : -speed / RADIUS)
                        .material(surface);
        return scene.add(shape, Palette.body(kind), body);
    }
}
