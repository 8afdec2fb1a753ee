package dev.cairn.samples.scenes.heap;

import dev.cairn.physics.Body;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;

import java.util.ArrayList;
import java.util.List;

/**
 * Bodies fall into a pit and come to rest, each in its own way. No closed form: what can be said is
 * that nothing overlaps and nothing leaves.
 *
 * <p>{@code convex-pile} has the hulls of Box3D's benchmark (32 random points on a sphere) and
 * {@code junkyard} the rocks of another, in a pit of its size; the cylinder that stirs there is
 * left out. Their random numbers are not Box3D's.
 */
public final class Pile {
    private static final double WALL = 0.5;
    private static final int HULL_POINTS = 32;
    private static final int HULL_KINDS = 8;

    private Pile() {}

    /**
     * Spheres.
     *
     * @return its entry for the registry
     */
    public static SampleScene spheres() {
        return scene("pile-spheres", "Pile of spheres", 5, 4, Kind.SPHERES);
    }

    /**
     * Boxes.
     *
     * @return its entry for the registry
     */
    public static SampleScene boxes() {
        return scene("pile-boxes", "Pile of boxes", 5, 4, Kind.BOXES);
    }

    /**
     * Spheres, boxes, capsules and hulls in turn.
     *
     * @return its entry for the registry
     */
    public static SampleScene mixed() {
        return scene("pile-mixed", "Pile of mixed shapes", 5, 4, Kind.MIXED);
    }

    /**
     * Capsules and cylinders in turn.
     *
     * @return its entry for the registry
     */
    public static SampleScene rounds() {
        return scene("pile-rounds", "Pile of capsules, cylinders", 5, 4, Kind.ROUNDS);
    }

    /**
     * Hulls of 32 points; side=8 layers=80 are Box3D's 5120.
     *
     * @return its entry for the registry
     */
    public static SampleScene hulls() {
        return scene("convex-pile", "Pile of convex hulls", 3, 6, Kind.HULLS);
    }

    /**
     * Rocks in a wide pit; side=21 layers=24 are Box3D's 10584.
     *
     * @return its entry for the registry
     */
    public static SampleScene junkyard() {
        return scene("junkyard", "Junkyard", 6, 2, Kind.ROCKS);
    }

    private enum Kind {
        SPHERES,
        BOXES,
        MIXED,
        ROUNDS,
        HULLS,
        ROCKS
    }

    private static SampleScene scene(String id, String title, int side, int layers, Kind kind) {
        double radius =
                switch (kind) {
                    case HULLS -> 2;
                    case ROCKS -> 1.5;
                    default -> 0.5;
                };
        return new SampleScene(
                id,
                title,
                "Layers of bodies fall into a pit and come to rest.",
                "piles",
                List.of(
                        Parameter.count("side", side, 1, 60, "bodies along x and along z"),
                        Parameter.count("layers", layers, 1, 200, "layers"),
                        Parameter.real("radius", radius, 0.01, 10, "half a body's size, m"),
                        Parameter.real("drop", 0.5, 0, 20, "fall of the lowest layer, m"),
                        Parameter.real("friction", 0.6, 0, 10, "Coulomb coefficient")),
                500,
                300,
                builder -> build(builder, kind));
    }

    private static void build(SceneBuilder scene, Kind kind) {
        int side = scene.count("side");
        int layers = scene.count("layers");
        double radius = scene.get("radius");
        double friction = scene.get("friction");
        double pitch = 2.2 * radius;
        double half = side * pitch / 2;
        // Box3D's junkyard leaves about half of the pit's floor free: +-50 m for 21 rocks of 3 m.
        double pit = kind == Kind.ROCKS ? 1.44 * half : half;
        double high = Math.max(4 * radius, layers * pitch);
        pit(scene, pit, high, friction);
        List<Shape> shapes = shapes(scene, kind, radius);
        int count = 0;
        for (int layer = 0; layer < layers; layer++) {
            for (int i = 0; i < side * side; i++) {
                double shake = 0.05 * radius;
                double x = pitch * (i % side - (side - 1) / 2.0) + scene.random(-shake, shake);
                int line = i / side;
                double z = pitch * (line - (side - 1) / 2.0) + scene.random(-shake, shake);
                double y = radius + scene.get("drop") + layer * pitch;
                scene.add(
                        shapes.get(count % shapes.size()),
                        Palette.body(count),
                        Body.dynamic().at(x, y, z).material(Palette.material(friction, 0)));
                count++;
            }
        }
        // The near corner of a wide heap and the upper layers of a high one just fit the picture.
        double middle = 0.4 * layers * pitch;
        double reach = 1.5 * pit + layers * pitch;
        scene.view(new SceneView(0.45 * reach, middle + 0.55 * reach, 0.7 * reach, 0, middle, 0));
    }

    /** A floor and four walls, inner half width `half`; the walls are of glass. */
    private static void pit(SceneBuilder scene, double half, double high, double friction) {
        scene.floor(half + 2 * WALL, half + 2 * WALL, friction, 0);
        for (int wall = 0; wall < 4; wall++) {
            double sign = wall % 2 == 0 ? 1 : -1;
            double at = sign * (half + WALL);
            boolean alongX = wall < 2;
            Box slab =
                    alongX
                            ? Box.ofHalfExtents(WALL, high / 2, half + 2 * WALL)
                            : Box.ofHalfExtents(half + 2 * WALL, high / 2, WALL);
            scene.addGlass(
                    slab,
                    Body.fixed()
                            .at(alongX ? at : 0, high / 2, alongX ? 0 : at)
                            .material(Palette.material(friction, 0)));
        }
    }

    private static List<Shape> shapes(SceneBuilder scene, Kind kind, double radius) {
        List<Shape> shapes = new ArrayList<>();
        if (kind == Kind.SPHERES || kind == Kind.MIXED) {
            shapes.add(Sphere.of(radius));
        }
        if (kind == Kind.BOXES || kind == Kind.MIXED) {
            shapes.add(Box.cubeOfHalfExtent(0.8 * radius));
        }
        if (kind == Kind.MIXED || kind == Kind.ROUNDS) {
            shapes.add(Capsule.of(0.5 * radius, 0.5 * radius));
        }
        if (kind == Kind.ROUNDS) {
            shapes.add(Cylinder.of(0.7 * radius, 0.7 * radius));
        }
        if (kind == Kind.HULLS || kind == Kind.MIXED || kind == Kind.ROCKS) {
            // Rocks are the same for each of them in Box3D's junkyard; here are a few kinds.
            int points = kind == Kind.ROCKS ? HULL_POINTS / 2 : HULL_POINTS;
            for (int k = 0; k < (kind == Kind.MIXED ? 1 : HULL_KINDS); k++) {
                shapes.add(hull(scene, radius, points));
            }
        }
        return shapes;
    }

    /**
     * A hull of points drawn evenly from a sphere: the z of such points is uniform (Archimedes).
     */
    private static ConvexHull hull(SceneBuilder scene, double radius, int points) {
        double[] xyz = new double[3 * points];
        for (int p = 0; p < points; p++) {
            double z = scene.random(-1, 1);
            double angle = scene.random(0, 2 * Math.PI);
            double r = StrictMath.sqrt(1 - z * z);
            xyz[3 * p] = radius * r * StrictMath.cos(angle);
            xyz[3 * p + 1] = radius * r * StrictMath.sin(angle);
            xyz[3 * p + 2] = radius * z;
        }
        return ConvexHull.of(xyz);
    }
}
