package dev.cairn.samples.overlap;

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
import org.joml.Quaterniondc;
import org.joml.Vector3d;
import org.joml.Vector3dc;

import java.util.ArrayList;
import java.util.List;

/**
 * A shape at a pose, as plain world-frame geometry in double, for {@link Penetration}: a sphere, or
 * a convex polytope with its vertices, outward face normals with their plane offsets, and edge
 * directions. Parallel directions are kept once, so a box has 6 planes and 3 edge directions.
 * Capsules, cylinders and cones are two {@link #discs} and all between them, with a radius around
 * it; a half-space is one plane. Computed anew from pose and shape, by none of the engine's code.
 */
final class Solid {
    /** Directions whose cross product is shorter than this count as parallel. */
    private static final double PARALLEL = 1e-9;

    /** Radius of a sphere; 0 for a polytope. */
    final double radius;

    /** Centre of a sphere, or mean of a polytope's vertices. */
    final double[] centre = new double[3];

    /** Vertices, 3 numbers each. */
    final double[] vertices;

    /**
     * Planes: outward unit normal and offset, 4 numbers each; a point x is inside where n.x <=
     * offset.
     */
    final double[] planes;

    /** Edge directions, unit, 3 numbers each, no two parallel. */
    final double[] edges;

    /** Corners of each plane's face, as vertex numbers, counter-clockwise from outside. */
    final int[][] faces;

    /**
     * Two discs with the same axis: centre and radius of each, then the unit axis; 11 numbers.
     * Empty for other shapes.
     */
    double[] discs = {};

    /** The radius around the discs. */
    double around;

    /** A single plane that bounds an endless body. */
    boolean endless;

    /** Lower corner of the bounding box. */
    final double[] low = new double[3];

    /** Upper corner of the bounding box. */
    final double[] high = new double[3];

    private Solid(
            double radius, double[] vertices, double[] planes, double[] edges, int[][] faces) {
        this.radius = radius;
        this.vertices = vertices;
        this.planes = planes;
        this.edges = edges;
        this.faces = faces;
    }

    /** Returns a shape whose frame is at a pose. */
    static Solid of(Shape shape, Vector3dc position, Quaterniondc rotation) {
        return switch (shape) {
            case Sphere sphere -> sphere(position, sphere.radius());
            case Box box -> polytope(corners(box), BOX_FACES, position, rotation);
            case ConvexHull hull -> polytope(hull.vertices(), hull.faceLoops(), position, rotation);
            case Capsule c -> turned(c.halfLength(), 0, 0, c.radius(), position, rotation);
            case Cylinder c ->
                    turned(c.halfHeight(), c.radius(), c.radius(), 0, position, rotation);
            case Cone c -> turned(c.halfHeight(), c.radius(), 0, 0, position, rotation);
            case HalfSpace ground -> below(position, rotation);
            case TriangleMesh mesh ->
                    throw new IllegalArgumentException(mesh + " has no inside; leave it out");
            case HeightField field ->
                    throw new IllegalArgumentException(field + " is no solid; leave it out");
            case Moved moved ->
                    of(
                            moved.inner(),
                            rotation.transform(moved.position(new Vector3d())).add(position),
                            rotation.mul(moved.rotation(new Quaterniond()), new Quaterniond()));
        };
    }

    /** What lies between a disc at y = -half and one at y = half, and a radius around it. */
    private static Solid turned(
            double half,
            double lower,
            double upper,
            double around,
            Vector3dc position,
            Quaterniondc rotation) {
        Solid solid = new Solid(0, new double[0], new double[0], new double[0], new int[0][]);
        Vector3d axis = rotation.transform(new Vector3d(0, 1, 0));
        solid.around = around;
        solid.discs =
                new double[] {
                    position.x() - half * axis.x,
                    position.y() - half * axis.y,
                    position.z() - half * axis.z,
                    lower,
                    position.x() + half * axis.x,
                    position.y() + half * axis.y,
                    position.z() + half * axis.z,
                    upper,
                    axis.x,
                    axis.y,
                    axis.z
                };
        for (int i = 0; i < 3; i++) {
            double x = i == 0 ? 1 : 0;
            double y = i == 1 ? 1 : 0;
            double z = i == 2 ? 1 : 0;
            solid.centre[i] = position.get(i);
            solid.low[i] = solid.min(x, y, z);
            solid.high[i] = solid.max(x, y, z);
        }
        return solid;
    }

    private static Solid below(Vector3dc position, Quaterniondc rotation) {
        Vector3d n = rotation.transform(new Vector3d(0, 1, 0));
        double[] plane = {n.x, n.y, n.z, n.dot(position)};
        Solid solid = new Solid(0, new double[0], plane, new double[0], new int[0][]);
        solid.endless = true;
        for (int i = 0; i < 3; i++) {
            solid.centre[i] = position.get(i);
            solid.low[i] = Double.NEGATIVE_INFINITY;
            solid.high[i] = Double.POSITIVE_INFINITY;
        }
        return solid;
    }

    private static Solid sphere(Vector3dc position, double radius) {
        Solid solid = new Solid(radius, new double[0], new double[0], new double[0], new int[0][]);
        for (int axis = 0; axis < 3; axis++) {
            double c = position.get(axis);
            solid.centre[axis] = c;
            solid.low[axis] = c - radius;
            solid.high[axis] = c + radius;
        }
        return solid;
    }

    /** Corner i has the signs of the bits of i: bit 0 is x, bit 1 is y, bit 2 is z. */
    private static double[] corners(Box box) {
        double[] corners = new double[24];
        for (int i = 0; i < 8; i++) {
            corners[3 * i] = (i & 1) == 0 ? -box.halfX() : box.halfX();
            corners[3 * i + 1] = (i & 2) == 0 ? -box.halfY() : box.halfY();
            corners[3 * i + 2] = (i & 4) == 0 ? -box.halfZ() : box.halfZ();
        }
        return corners;
    }

    private static final int[][] BOX_FACES = {
        {0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}
    };

    private static Solid polytope(
            double[] local, int[][] faces, Vector3dc position, Quaterniondc rotation) {
        double[] world = new double[local.length];
        Vector3d point = new Vector3d();
        for (int i = 0; i < local.length; i += 3) {
            rotation.transform(point.set(local[i], local[i + 1], local[i + 2])).add(position);
            world[i] = point.x;
            world[i + 1] = point.y;
            world[i + 2] = point.z;
        }
        double[] planes = new double[4 * faces.length];
        List<double[]> edges = new ArrayList<>();
        for (int f = 0; f < faces.length; f++) {
            plane(world, faces[f], planes, 4 * f);
            for (int k = 0; k < faces[f].length; k++) {
                addDirection(
                        edges, difference(world, faces[f][(k + 1) % faces[f].length], faces[f][k]));
            }
        }
        double[] directions = new double[3 * edges.size()];
        for (int e = 0; e < edges.size(); e++) {
            System.arraycopy(edges.get(e), 0, directions, 3 * e, 3);
        }
        Solid solid = new Solid(0, world, planes, directions, faces);
        solid.bound();
        return solid;
    }

    private void bound() {
        for (int axis = 0; axis < 3; axis++) {
            double sum = 0;
            low[axis] = Double.POSITIVE_INFINITY;
            high[axis] = Double.NEGATIVE_INFINITY;
            for (int i = axis; i < vertices.length; i += 3) {
                sum += vertices[i];
                low[axis] = Math.min(low[axis], vertices[i]);
                high[axis] = Math.max(high[axis], vertices[i]);
            }
            centre[axis] = 3 * sum / vertices.length;
        }
    }

    /** Newell's normal of a face loop, and the plane through its outermost corner. */
    private static void plane(double[] vertices, int[] loop, double[] planes, int at) {
        double nx = 0;
        double ny = 0;
        double nz = 0;
        for (int k = 0; k < loop.length; k++) {
            int a = 3 * loop[k];
            int b = 3 * loop[(k + 1) % loop.length];
            // Relative to the first corner, so that faces far from the origin keep their digits.
            int o = 3 * loop[0];
            double ax = vertices[a] - vertices[o];
            double ay = vertices[a + 1] - vertices[o + 1];
            double az = vertices[a + 2] - vertices[o + 2];
            double bx = vertices[b] - vertices[o];
            double by = vertices[b + 1] - vertices[o + 1];
            double bz = vertices[b + 2] - vertices[o + 2];
            nx += ay * bz - az * by;
            ny += az * bx - ax * bz;
            nz += ax * by - ay * bx;
        }
        double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
        planes[at] = nx / length;
        planes[at + 1] = ny / length;
        planes[at + 2] = nz / length;
        double offset = Double.NEGATIVE_INFINITY;
        for (int corner : loop) {
            offset =
                    Math.max(
                            offset,
                            planes[at] * vertices[3 * corner]
                                    + planes[at + 1] * vertices[3 * corner + 1]
                                    + planes[at + 2] * vertices[3 * corner + 2]);
        }
        planes[at + 3] = offset;
    }

    private static double[] difference(double[] vertices, int to, int from) {
        double x = vertices[3 * to] - vertices[3 * from];
        double y = vertices[3 * to + 1] - vertices[3 * from + 1];
        double z = vertices[3 * to + 2] - vertices[3 * from + 2];
        double length = Math.sqrt(x * x + y * y + z * z);
        return new double[] {x / length, y / length, z / length};
    }

    private static void addDirection(List<double[]> directions, double[] d) {
        for (double[] known : directions) {
            double x = known[1] * d[2] - known[2] * d[1];
            double y = known[2] * d[0] - known[0] * d[2];
            double z = known[0] * d[1] - known[1] * d[0];
            if (x * x + y * y + z * z < PARALLEL * PARALLEL) {
                return;
            }
        }
        directions.add(d);
    }

    /** Returns the largest value of d.x over the solid's points x; d is of unit length. */
    double max(double dx, double dy, double dz) {
        double best = Double.NEGATIVE_INFINITY;
        if (radius > 0) {
            return dx * centre[0] + dy * centre[1] + dz * centre[2] + radius;
        }
        if (discs.length > 0) {
            double along = dx * discs[8] + dy * discs[9] + dz * discs[10];
            double x = dx - along * discs[8];
            double y = dy - along * discs[9];
            double z = dz - along * discs[10];
            double across = Math.sqrt(x * x + y * y + z * z);
            for (int i = 0; i < 8; i += 4) {
                best =
                        Math.max(
                                best,
                                dx * discs[i]
                                        + dy * discs[i + 1]
                                        + dz * discs[i + 2]
                                        + discs[i + 3] * across);
            }
            return best + around;
        }
        for (int i = 0; i < vertices.length; i += 3) {
            best = Math.max(best, dx * vertices[i] + dy * vertices[i + 1] + dz * vertices[i + 2]);
        }
        return best;
    }

    /** Returns the smallest value of d.x over the solid's points x; d is of unit length. */
    double min(double dx, double dy, double dz) {
        return -max(-dx, -dy, -dz);
    }

    /** Says whether the bounding boxes of two solids share a point. */
    boolean mayTouch(Solid other) {
        return low[0] <= other.high[0]
                && other.low[0] <= high[0]
                && low[1] <= other.high[1]
                && other.low[1] <= high[1]
                && low[2] <= other.high[2]
                && other.low[2] <= high[2];
    }
}
