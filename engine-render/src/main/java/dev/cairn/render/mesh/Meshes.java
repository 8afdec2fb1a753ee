package dev.cairn.render.mesh;

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

import java.util.Collections;
import java.util.Map;
import java.util.WeakHashMap;

/** Meshes made by arithmetic: the primitives, and one for each shape of the physics. Any thread. */
public final class Meshes {
    /**
     * The cube from (-1, -1, -1) to (1, 1, 1); each face shows a texture once. All boxes are drawn
     * as this mesh, scaled.
     */
    public static final Mesh CUBE = cuboid("cube", 1, 1, 1);

    /**
     * The ball of radius 1, in 48 sectors and 24 stacks; a texture goes once around it, its upper
     * edge at +y.
     */
    public static final Mesh BALL = ball("ball", 48, 24);

    /** The cylinder of radius 1 from y = -1 to y = 1; flat caps, a smooth side. */
    public static final Mesh CYLINDER = RoundMeshes.turned("cylinder", 1, 48);

    /** The cone with its apex at y = 1 and its base, of radius 1, at y = -1. */
    public static final Mesh CONE = RoundMeshes.turned("cone", 0, 48);

    /** What is drawn of a half-space: a square of 2 km around the origin of its frame. */
    public static final Mesh GROUND = RoundMeshes.ground(1000);

    private static final Map<ConvexHull, Mesh> HULLS =
            Collections.synchronizedMap(new WeakHashMap<>());

    private static final Map<Shape, Mesh> SURFACES =
            Collections.synchronizedMap(new WeakHashMap<>());

    private Meshes() {}

    /**
     * The surface of a collision shape, in the shape's frame and at its size.
     *
     * @param shape which one
     * @return its mesh; the same object for the same hull
     */
    public static Mesh of(Shape shape) {
        return switch (shape) {
            case Box box -> box(box.halfX(), box.halfY(), box.halfZ());
            case Sphere sphere -> sphere(sphere.radius());
            case ConvexHull hull -> hull(hull);
            case Capsule capsule -> RoundMeshes.capsule(capsule.radius(), capsule.halfLength());
            case Cylinder c -> RoundMeshes.scaled(CYLINDER, c.radius(), c.halfHeight());
            case Cone c -> RoundMeshes.scaled(CONE, c.radius(), c.halfHeight());
            case HalfSpace ground -> GROUND;
            case TriangleMesh mesh -> triangles(mesh);
            case HeightField field -> ground(field);
            case Moved moved ->
                    RoundMeshes.placed(
                            of(moved.inner()),
                            moved.position(new Vector3d()),
                            moved.rotation(new Quaterniond()));
        };
    }

    /**
     * A block around the origin. For many blocks of different sizes use {@link Model#of(Shape)},
     * which scales one mesh.
     *
     * @param halfX half the width, m, &gt; 0
     * @param halfY half the height, m, &gt; 0
     * @param halfZ half the depth, m, &gt; 0
     * @return a new mesh; each face shows a texture once
     */
    public static Mesh box(double halfX, double halfY, double halfZ) {
        checkLength("halfX", halfX);
        checkLength("halfY", halfY);
        checkLength("halfZ", halfZ);
        return cuboid("box", halfX, halfY, halfZ);
    }

    /**
     * A ball around the origin.
     *
     * @param radius m, &gt; 0
     * @return a new mesh
     */
    public static Mesh sphere(double radius) {
        checkLength("radius", radius);
        float[] vertices = BALL.vertices();
        for (int i = 0; i < vertices.length; i += Mesh.FLOATS_PER_VERTEX) {
            for (int axis = 0; axis < 3; axis++) {
                vertices[i + axis] = (float) (vertices[i + axis] * radius);
            }
        }
        return Mesh.of("sphere", vertices, BALL.indices());
    }

    /**
     * A level rectangle around the origin that is seen from above.
     *
     * @param halfX half the width, m, &gt; 0
     * @param halfZ half the depth, m, &gt; 0
     * @return a new mesh; it shows a texture once, upright seen from +z
     */
    public static Mesh plane(double halfX, double halfZ) {
        checkLength("halfX", halfX);
        checkLength("halfZ", halfZ);
        MeshBuilder builder = new MeshBuilder();
        int a = builder.vertex(-halfX, 0, halfZ, 0, 1, 0, 0, 0);
        int b = builder.vertex(halfX, 0, halfZ, 0, 1, 0, 1, 0);
        int c = builder.vertex(halfX, 0, -halfZ, 0, 1, 0, 1, 1);
        int d = builder.vertex(-halfX, 0, -halfZ, 0, 1, 0, 0, 1);
        builder.triangle(a, b, c);
        builder.triangle(a, c, d);
        return builder.build(
                "plane",
                new double[] {
                    -halfX, 0, halfZ, halfX, 0, halfZ, halfX, 0, -halfZ, -halfX, 0, -halfZ
                });
    }

    /**
     * The surface of a convex hull, flat faces, in the frame of the points that it was made from.
     *
     * @param hull which one
     * @return the mesh; the same object each time
     */
    public static Mesh hull(ConvexHull hull) {
        return HULLS.computeIfAbsent(hull, key -> faces("hull", key.vertices(), key.faceLoops()));
    }

    /**
     * The surface of a mesh of the physics, flat faces, as it was given.
     *
     * @param surface which one
     * @return the mesh; the same object each time
     */
    public static Mesh triangles(TriangleMesh surface) {
        return SURFACES.computeIfAbsent(surface, s -> flat(surface));
    }

    /**
     * The triangles of a height field, each flat; without its holes.
     *
     * @param field which one
     * @return the mesh; the same object each time
     */
    public static Mesh ground(HeightField field) {
        return SURFACES.computeIfAbsent(field, f -> flat(field.toMesh()));
    }

    private static Mesh flat(TriangleMesh surface) {
        int[] corners = surface.indices();
        int[] left = surface.report().degenerate().stream().mapToInt(Integer::intValue).toArray();
        int[][] loops = new int[corners.length / 3 - left.length][];
        int at = 0;
        int skipped = 0;
        for (int t = 0; t < corners.length / 3; t++) {
            if (skipped < left.length && left[skipped] == t) {
                skipped++;
            } else {
                loops[at++] = new int[] {corners[3 * t], corners[3 * t + 1], corners[3 * t + 2]};
            }
        }
        return faces("triangles", surface.vertices(), loops);
    }

    /** Flat faces over shared points; texture coordinates are metres in the face's plane. */
    static Mesh faces(String name, double[] points, int[][] loops) {
        MeshBuilder builder = new MeshBuilder();
        double[] normal = new double[3];
        for (int[] loop : loops) {
            Polygons.normal(points, loop, loop.length, normal);
            int first = builder.vertexCount();
            for (int point : loop) {
                double x = points[3 * point];
                double y = points[3 * point + 1];
                double z = points[3 * point + 2];
                double ax = Math.abs(normal[0]);
                double ay = Math.abs(normal[1]);
                double az = Math.abs(normal[2]);
                double u = ax > ay && ax > az ? z : x;
                double v = ay >= ax && ay >= az ? z : y;
                builder.vertex(x, y, z, normal[0], normal[1], normal[2], u, v);
            }
            int[] corners = new int[3 * (loop.length - 2)];
            Polygons.triangulate(points, loop, loop.length, normal, corners);
            for (int i = 0; i < corners.length; i += 3) {
                builder.triangle(
                        first + corners[i], first + corners[i + 1], first + corners[i + 2]);
            }
        }
        return builder.build(name, points);
    }

    private static Mesh cuboid(String name, double hx, double hy, double hz) {
        MeshBuilder builder = new MeshBuilder();
        double[] points = new double[24];
        for (int i = 0; i < 8; i++) {
            points[3 * i] = (i & 1) == 0 ? -hx : hx;
            points[3 * i + 1] = (i & 2) == 0 ? -hy : hy;
            points[3 * i + 2] = (i & 4) == 0 ? -hz : hz;
        }
        // Normal, and the corners as seen from outside: lower left, lower right, upper right, upper
        // left.
        side(builder, points, 1, 0, 0, 5, 1, 3, 7);
        side(builder, points, -1, 0, 0, 0, 4, 6, 2);
        side(builder, points, 0, 1, 0, 6, 7, 3, 2);
        side(builder, points, 0, -1, 0, 0, 1, 5, 4);
        side(builder, points, 0, 0, 1, 4, 5, 7, 6);
        side(builder, points, 0, 0, -1, 1, 0, 2, 3);
        return builder.build(name, points);
    }

    private static void side(
            MeshBuilder builder, double[] p, int nx, int ny, int nz, int a, int b, int c, int d) {
        int first = builder.vertex(p[3 * a], p[3 * a + 1], p[3 * a + 2], nx, ny, nz, 0, 0);
        builder.vertex(p[3 * b], p[3 * b + 1], p[3 * b + 2], nx, ny, nz, 1, 0);
        builder.vertex(p[3 * c], p[3 * c + 1], p[3 * c + 2], nx, ny, nz, 1, 1);
        builder.vertex(p[3 * d], p[3 * d + 1], p[3 * d + 2], nx, ny, nz, 0, 1);
        builder.triangle(first, first + 1, first + 2);
        builder.triangle(first, first + 2, first + 3);
    }

    private static Mesh ball(String name, int sectors, int stacks) {
        MeshBuilder builder = new MeshBuilder();
        for (int stack = 0; stack <= stacks; stack++) {
            double v = (double) stack / stacks;
            double polar = Math.PI * v;
            for (int sector = 0; sector <= sectors; sector++) {
                double u = (double) sector / sectors;
                double angle = 2 * Math.PI * u;
                double x = Math.sin(polar) * Math.sin(angle);
                double y = Math.cos(polar);
                double z = Math.sin(polar) * Math.cos(angle);
                builder.vertex(x, y, z, x, y, z, u, 1 - v);
            }
        }
        for (int stack = 0; stack < stacks; stack++) {
            for (int sector = 0; sector < sectors; sector++) {
                int upper = stack * (sectors + 1) + sector;
                int lower = upper + sectors + 1;
                if (stack > 0) {
                    builder.triangle(upper, lower, upper + 1);
                }
                if (stack < stacks - 1) {
                    builder.triangle(upper + 1, lower, lower + 1);
                }
            }
        }
        return builder.build(name, null);
    }

    private static void checkLength(String name, double value) {
        if (!(value > 0) || Double.isInfinite(value)) {
            throw new IllegalArgumentException(
                    name + " is " + value + " m, expected > 0 and finite");
        }
    }
}
