package dev.cairn.samples.scenes.level;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Cone;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.HeightField;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.shape.TriangleMesh;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;

import org.joml.Quaterniond;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleBinaryOperator;

/**
 * Bodies of all kinds poured over hills: a wide country, and a small one with waves.
 *
 * <p>Truth: nobody goes below the ground. Its height is known, so how far a body's centre is below
 * it is, too.
 */
public final class Hills {
    private static final Shape[] KINDS = {
        Sphere.of(.25),
        Box.ofHalfExtents(.3, .2, .25),
        Capsule.of(.18, .2),
        Cylinder.of(.25, .2),
        Cone.of(.3, .25),
        Box.cubeOfHalfExtent(.2)
    };

    private static final int SIDES = 16;
    private static final Parameter HULLS =
            Parameter.count("hulls", 0, 0, 1, "1 if hulls stand for cylinders and cones");

    private Hills() {}

    /**
     * A country of hills within a rim.
     *
     * @return its entry for the registry
     */
    public static SampleScene terrain() {
        return new SampleScene(
                "terrain",
                "Hills",
                "Bodies of all kinds rain on a height field and roll into the valleys.",
                "levels",
                List.of(
                        Parameter.count("bodies", 200, 1, 10_000, "number of bodies"),
                        Parameter.count("squares", 128, 16, 512, "along a side of the country"),
                        HULLS),
                300,
                200,
                scene -> {
                    HeightField field = field(24, scene.count("squares"), Hills::country);
                    Body ground = Body.fixed().at(-24, 0, -24);
                    build(scene, field, ground, 24, Hills::country);
                });
    }

    /**
     * A tray with waves.
     *
     * @return its entry for the registry
     */
    public static SampleScene meshDrop() {
        return new SampleScene(
                "mesh-drop",
                "Tray with waves",
                "Bodies of all kinds fall into a tray whose ground is waves of triangles.",
                "levels",
                List.of(
                        Parameter.count("bodies", 150, 1, 4000, "number of bodies"),
                        Parameter.count("squares", 40, 16, 200, "along a side of the tray"),
                        HULLS),
                300,
                150,
                scene -> {
                    int squares = scene.count("squares");
                    TriangleMesh mesh = new Surfaces().grid(6, squares, Hills::waves).mesh();
                    build(scene, mesh, Body.fixed(), 6, Hills::waves);
                });
    }

    private static double country(double x, double z) {
        double r = Math.max(Math.abs(x), Math.abs(z)) - 20;
        double hills = StrictMath.sin(.31 * x + .4) * StrictMath.cos(.27 * z);
        double bumps = StrictMath.sin(1.3 * x) * StrictMath.sin(1.1 * z + .3);
        return 1.6 * hills + .25 * bumps + (r > 0 ? r * r : 0);
    }

    private static double waves(double x, double z) {
        double r = Math.max(Math.abs(x), Math.abs(z)) - 4.5;
        return .3 * StrictMath.cos(1.7 * x) * StrictMath.cos(1.7 * z) + (r > 0 ? 2 * r * r : 0);
    }

    /** The same shapes with hulls of {@value #SIDES} sides in place of cylinder and cone. */
    private static Shape[] kindsOfHulls() {
        return new Shape[] {
            KINDS[0], KINDS[1], KINDS[2], frustum(.25, .25, .2), frustum(.3, 0, .25), KINDS[5]
        };
    }

    /** A hull within a round one along y; a cone if the radius at its top is 0. */
    private static ConvexHull frustum(double bottom, double top, double halfHeight) {
        double[] xyz = new double[6 * SIDES];
        for (int i = 0; i < 2 * SIDES; i++) {
            double angle = 2 * Math.PI * (i >> 1) / SIDES;
            double radius = i % 2 == 0 ? bottom : top;
            xyz[3 * i] = radius * StrictMath.cos(angle);
            xyz[3 * i + 1] = i % 2 == 0 ? -halfHeight : halfHeight;
            xyz[3 * i + 2] = radius * StrictMath.sin(angle);
        }
        return ConvexHull.of(xyz);
    }

    /** The graph of a function of x and z, n by n cells; its frame begins at (-half, -half). */
    private static HeightField field(double half, int n, DoubleBinaryOperator height) {
        double step = 2 * half / n;
        double[] heights = new double[(n + 1) * (n + 1)];
        for (int j = 0; j <= n; j++) {
            for (int i = 0; i <= n; i++) {
                heights[j * (n + 1) + i] = height.applyAsDouble(i * step - half, j * step - half);
            }
        }
        return HeightField.of(n + 1, n + 1, step, step, heights);
    }

    private static void build(
            SceneBuilder scene,
            Shape shape,
            Body ground,
            double half,
            DoubleBinaryOperator height) {
        int count = scene.count("bodies");
        Shape[] kinds = scene.count("hulls") == 1 ? kindsOfHulls() : KINDS;
        scene.add(shape, Palette.STONE, ground.material(Palette.material(0.6, 0)).name("ground"));
        double wide = .7 * half;
        int side = (int) Math.min(Math.ceil(Math.sqrt(count)), 2 * wide / 1.1);
        List<BodyRef> bodies = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            double x = wide * (2 * (i % side + scene.random(.45, .55)) / side - 1);
            double z = wide * (2 * (i / side % side + scene.random(.45, .55)) / side - 1);
            int layer = i / (side * side);
            Quaterniond turn =
                    new Quaterniond()
                            .rotateXYZ(
                                    scene.random(-1, 1), scene.random(-3, 3), scene.random(-1, 1));
            bodies.add(
                    scene.add(
                            kinds[i % kinds.length],
                            Palette.body(i),
                            Body.dynamic()
                                    .at(x, height.applyAsDouble(x, z) + 1 + 1.1 * layer, z)
                                    .rotation(turn)
                                    .material(Palette.material(0.6, 0))));
        }
        scene.view(new SceneView(.75 * half, .7 * half, 1.05 * half, 0, 0, 0));
        scene.error(
                "belowGroundMetres",
                () -> {
                    double worst = 0;
                    for (BodyRef body : bodies) {
                        double x = body.position().x;
                        double z = body.position().z;
                        double below = height.applyAsDouble(x, z) - body.position().y;
                        worst = Math.max(worst, below);
                    }
                    return worst;
                });
    }
}
