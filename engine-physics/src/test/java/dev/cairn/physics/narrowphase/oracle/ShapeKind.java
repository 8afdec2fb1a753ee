package dev.cairn.physics.narrowphase.oracle;

import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Cone;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.HeightField;
import dev.cairn.physics.shape.Moved;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.shape.TriangleMesh;

import org.joml.Quaterniond;
import org.joml.Vector3d;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.WeakHashMap;

/** The kinds of shapes and all pairs of them; random ones, and their scaled and mirrored twins. */
public enum ShapeKind {
    BALL,
    CAPSULE,
    CYLINDER,
    CONE,
    BOX,
    HULL,
    HALF_SPACE;

    /** The points that hulls were made of: {@link ConvexHull#vertices} gives rounded ones. */
    private static final Map<ConvexHull, double[]> POINTS = new WeakHashMap<>();

    /** Two kinds, the first of which does not come after the second. */
    public record Two(ShapeKind a, ShapeKind b) {
        @Override
        public String toString() {
            return a + " and " + b;
        }
    }

    /** All pairs but that of two half-spaces. */
    public static List<Two> pairs() {
        List<Two> all = new ArrayList<>();
        for (ShapeKind a : values()) {
            for (ShapeKind b : values()) {
                if (a.ordinal() <= b.ordinal() && a != HALF_SPACE) {
                    all.add(new Two(a, b));
                }
            }
        }
        return all;
    }

    /** About 0.2 to 3 m, up to ten times as long as wide; one in four is moved within its body. */
    public Shape shape(SplittableRandom r) {
        double size = Scene.logUniform(r, .2, 3);
        double other = size * Scene.logUniform(r, .1, 3);
        Shape plain =
                switch (this) {
                    case BALL -> Sphere.of(size);
                    case CAPSULE -> Capsule.of(size, other);
                    case CYLINDER -> Cylinder.of(size, other);
                    case CONE -> Cone.of(size, other);
                    case BOX -> Box.ofHalfExtents(size, other, size * Scene.logUniform(r, .1, 3));
                    case HULL -> hull(r, 4 + r.nextInt(12), size);
                    case HALF_SPACE -> HalfSpace.of();
                };
        return this != HALF_SPACE && r.nextInt(4) == 0
                ? plain.moved(r.nextDouble(), r.nextDouble(), r.nextDouble(), Scene.turn(r))
                : plain;
    }

    private static ConvexHull hull(SplittableRandom r, int points, double size) {
        double[] xyz = new double[3 * points];
        for (int i = 0; i < points; i++) {
            Vector3d p = Scene.direction(r).mul(size * (.5 + .5 * r.nextDouble()));
            xyz[3 * i] = p.x;
            xyz[3 * i + 1] = p.y;
            xyz[3 * i + 2] = p.z;
        }
        return hull(xyz);
    }

    /** A hull that can be {@link #scaled} and {@link #mirrored}. */
    public static ConvexHull hull(double[] xyz) {
        ConvexHull hull = ConvexHull.of(xyz);
        POINTS.put(hull, xyz);
        return hull;
    }

    /** The radius of a ball around a shape; 0 for a half-space, which has none. */
    public static double size(Shape shape) {
        return shape instanceof HalfSpace ? 0 : shape.outerRadius();
    }

    public static double size(Scene s) {
        return size(s.a) + size(s.b);
    }

    /** The shape with all its lengths times a factor. */
    public static Shape scaled(Shape shape, double f) {
        return switch (shape) {
            case Sphere b -> Sphere.of(f * b.radius());
            case Capsule c -> Capsule.of(f * c.radius(), f * c.halfLength());
            case Cylinder c -> Cylinder.of(f * c.radius(), f * c.halfHeight());
            case Cone c -> Cone.of(f * c.radius(), f * c.halfHeight());
            case Box b -> Box.ofHalfExtents(f * b.halfX(), f * b.halfY(), f * b.halfZ());
            case ConvexHull h -> {
                double[] xyz = POINTS.get(h).clone();
                for (int i = 0; i < xyz.length; i++) {
                    xyz[i] *= f;
                }
                yield hull(xyz);
            }
            case HalfSpace h -> h;
            case TriangleMesh mesh -> throw new IllegalArgumentException("no solid: " + mesh);
            case HeightField field -> throw new IllegalArgumentException("no solid: " + field);
            case Moved m -> {
                Vector3d at = m.position(new Vector3d()).mul(f);
                yield scaled(m.inner(), f).moved(at.x, at.y, at.z, m.rotation(new Quaterniond()));
            }
        };
    }

    /** The mirror image with x negated, which for most is the shape itself. */
    public static Shape mirrored(Shape shape) {
        return mirrored(shape, 0);
    }

    /** The mirror image with one coordinate negated. */
    public static Shape mirrored(Shape shape, int axis) {
        return switch (shape) {
            case ConvexHull h -> {
                double[] xyz = POINTS.get(h).clone();
                for (int i = axis; i < xyz.length; i += 3) {
                    xyz[i] = -xyz[i];
                }
                yield hull(xyz);
            }
            case Moved m -> {
                Vector3d at = mirrored(m.position(new Vector3d()), axis);
                Quaterniond q = mirrored(m.rotation(new Quaterniond()), axis);
                yield mirrored(m.inner(), axis).moved(at.x, at.y, at.z, q);
            }
            default -> shape;
        };
    }

    public static Quaterniond mirrored(Quaterniond q, int axis) {
        double x = axis == 0 ? q.x : -q.x;
        double y = axis == 1 ? q.y : -q.y;
        double z = axis == 2 ? q.z : -q.z;
        return new Quaterniond(x, y, z, q.w);
    }

    public static Vector3d mirrored(Vector3d v, int axis) {
        return new Vector3d(v).setComponent(axis, -v.get(axis));
    }

    public static Scene scaled(Scene s, double f) {
        Scene t = new Scene(scaled(s.a, f), scaled(s.b, f));
        t.qa = s.qa;
        t.qb = s.qb;
        t.d = s.d.mul(f, new Vector3d());
        return t;
    }

    public static Scene mirrored(Scene s) {
        return mirrored(s, 0);
    }

    public static Scene mirrored(Scene s, int axis) {
        Scene t = new Scene(mirrored(s.a, axis), mirrored(s.b, axis));
        t.qa = mirrored(s.qa, axis);
        t.qb = mirrored(s.qb, axis);
        t.d = mirrored(s.d, axis);
        return t;
    }
}
