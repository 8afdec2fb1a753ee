package dev.cairn.samples.scenes;

import dev.cairn.physics.Body;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.DegenerateShapeException;
import dev.cairn.render.mesh.Mesh;
import dev.cairn.render.mesh.Model;
import dev.cairn.render.mesh.ObjFormatException;
import dev.cairn.render.mesh.ObjReader;
import dev.cairn.samples.Palette;
import dev.cairn.samples.Parameter;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneView;
import dev.cairn.samples.UsageException;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/**
 * Some copies of an {@code .obj} file fall onto a plane. The mesh is what is drawn; its convex hull
 * is what collides. Without a file, a hull of random points takes its place.
 */
public final class ObjDrop {
    private static final int POINTS = 32;

    private ObjDrop() {}

    /**
     * The scene.
     *
     * @return its entry for the registry
     */
    public static SampleScene scene() {
        return new SampleScene(
                "obj-drop",
                "Dropped mesh",
                "Copies of the mesh of --obj fall onto a plane, each as the convex hull of its"
                        + " vertices.",
                "collisions",
                List.of(
                        Parameter.count("copies", 5, 1, 500, "number of bodies"),
                        Parameter.real("size", 1.5, 0.01, 100, "largest extent after scaling, m"),
                        Parameter.real("height", 1, 0, 100, "free fall of the lowest body, m"),
                        Parameter.real("friction", 0.6, 0, 10, "Coulomb coefficient"),
                        Parameter.real("restitution", 0, 0, 1, "coefficient of restitution")),
                300,
                240,
                ObjDrop::build);
    }

    private static void build(SceneBuilder scene) {
        double size = scene.get("size");
        double friction = scene.get("friction");
        double restitution = scene.get("restitution");
        scene.floor(6 * size, 6 * size, friction, restitution);
        Path file = scene.obj();
        Mesh mesh = file == null ? null : read(file);
        double[] points = mesh == null ? pebble(scene) : mesh.points();
        double factor = size / extent(points);
        for (int i = 0; i < points.length; i++) {
            points[i] *= factor;
        }
        ConvexHull hull = hull(points, file);
        Model model = mesh == null ? Model.of(hull) : Model.of(mesh).scale(factor);
        Vector3d middle = hull.centreOfMass(new Vector3d());
        double height = scene.get("height") + hull.outerRadius();
        for (int i = 0; i < scene.count("copies"); i++) {
            Quaterniond turned = randomRotation(scene);
            // The hull turns about its centre of mass; `at` wants where its own origin goes.
            Vector3d origin = turned.transform(new Vector3d(middle)).negate();
            scene.add(
                    hull,
                    model.color(Palette.body(i)),
                    Body.dynamic()
                            .at(
                                    origin.x + size * scene.random(-0.4, 0.4),
                                    origin.y + height + 2.05 * hull.outerRadius() * i,
                                    origin.z + size * scene.random(-0.4, 0.4))
                            .rotation(turned)
                            .material(Palette.material(friction, restitution))
                            .name("copy " + i));
        }
        scene.view(new SceneView(1.9 * size, 2.1 * size, 4.7 * size, 0, 0.5 * size, 0));
    }

    private static Mesh read(Path file) {
        if (!Files.isRegularFile(file)) {
            throw new UsageException(
                    "--obj %s: there is no such file; name a Wavefront .obj".formatted(file));
        }
        try {
            return ObjReader.read(file);
        } catch (ObjFormatException | UncheckedIOException broken) {
            throw new UsageException("--obj " + broken.getMessage(), broken);
        }
    }

    private static ConvexHull hull(double[] points, @Nullable Path file) {
        try {
            return ConvexHull.of(points);
        } catch (DegenerateShapeException flat) {
            throw new UsageException(
                    "--obj %s: no convex hull: %s".formatted(file, flat.getMessage()), flat);
        }
    }

    private static double extent(double[] points) {
        double largest = 0;
        for (int axis = 0; axis < 3; axis++) {
            double low = Double.POSITIVE_INFINITY;
            double high = Double.NEGATIVE_INFINITY;
            for (int i = axis; i < points.length; i += 3) {
                low = Math.min(low, points[i]);
                high = Math.max(high, points[i]);
            }
            largest = Math.max(largest, high - low);
        }
        return largest > 0 ? largest : 1;
    }

    /** Points on the unit sphere, by rejection from the cube. */
    private static double[] pebble(SceneBuilder scene) {
        double[] points = new double[3 * POINTS];
        for (int i = 0; i < POINTS; ) {
            double x = scene.random(-1, 1);
            double y = scene.random(-1, 1);
            double z = scene.random(-1, 1);
            double length = StrictMath.sqrt(x * x + y * y + z * z);
            if (length > 0.1 && length <= 1) {
                points[3 * i] = x / length;
                points[3 * i + 1] = 0.7 * y / length;
                points[3 * i + 2] = z / length;
                i++;
            }
        }
        return points;
    }

    /** A uniform rotation, by rejection from the four-dimensional cube. */
    private static Quaterniond randomRotation(SceneBuilder scene) {
        while (true) {
            double x = scene.random(-1, 1);
            double y = scene.random(-1, 1);
            double z = scene.random(-1, 1);
            double w = scene.random(-1, 1);
            double square = x * x + y * y + z * z + w * w;
            if (square > 0.01 && square <= 1) {
                double length = StrictMath.sqrt(square);
                return new Quaterniond(x / length, y / length, z / length, w / length);
            }
        }
    }
}
