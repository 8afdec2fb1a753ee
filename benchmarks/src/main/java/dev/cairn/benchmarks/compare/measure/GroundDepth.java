package dev.cairn.benchmarks.compare.measure;

import dev.cairn.physics.BodyRef;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.HeightField;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.shape.TriangleMesh;

import org.joml.Intersectiond;
import org.joml.Quaterniondc;
import org.joml.Vector3d;
import org.joml.Vector3dc;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.List;

/**
 * How deep bodies are in a ground of triangles, from poses and shapes alone, in double. The ground
 * is what fixed bodies with a mesh or a height field are; it must be the graph of a height over x
 * and z, with nothing but ground below it.
 *
 * <p>A point p with a radius r around it is r - d deep if it is above the ground and r + d if it is
 * below, where d is its distance from the triangles. A ball is one such point, a capsule {@value
 * #ALONG} along its axis (exact at its ends), of boxes and hulls the corners are, with radius 0.
 * Corners of the ground within a box or a hull count by the nearest of its faces. So what is missed
 * is an edge of a body across an edge of the ground, with no corner of either inside the other.
 *
 * <p>One thread; allocates.
 */
final class GroundDepth {
    private static final int ALONG = 9;
    private static final int MOST_CELLS = 256;

    private final List<Vector3d> corners = new ArrayList<>();
    private final Grid grid;
    private final IdentityHashMap<Shape, Form> forms = new IdentityHashMap<>();
    private final Vector3d nearest = new Vector3d();

    /** Takes the ground as it lies now; empty if none of the bodies is any. */
    GroundDepth(List<BodyRef> bodies) {
        for (BodyRef body : bodies) {
            if (body.isFixed()) {
                switch (body.shape()) {
                    case TriangleMesh mesh -> add(mesh, body);
                    case HeightField field -> add(field.toMesh(), body);
                    default -> {
                        // no surface: its overlaps are those of convex shapes
                    }
                }
            }
        }
        grid = new Grid(corners);
    }

    private void add(TriangleMesh mesh, BodyRef body) {
        double[] xyz = mesh.vertices();
        Vector3d at = new Vector3d(body.position());
        for (int corner : mesh.indices()) {
            Vector3d p = new Vector3d(xyz[3 * corner], xyz[3 * corner + 1], xyz[3 * corner + 2]);
            corners.add(body.orientation().transform(p).add(at));
        }
    }

    /** The deepest of those that move, m; 0 without a ground. */
    double deepest(List<BodyRef> bodies) {
        double deepest = 0;
        if (!corners.isEmpty()) {
            for (BodyRef body : bodies) {
                if (!body.isFixed()) {
                    deepest =
                            Math.max(
                                    deepest,
                                    depth(body.shape(), body.position(), body.orientation()));
                }
            }
        }
        return deepest;
    }

    /** The depth of one shape whose frame is there, m, at least 0. */
    double depth(Shape shape, Vector3dc position, Quaterniondc rotation) {
        Form form = forms.computeIfAbsent(shape, Form::of);
        double deepest = 0;
        Vector3d low = new Vector3d(Double.POSITIVE_INFINITY);
        Vector3d high = new Vector3d(Double.NEGATIVE_INFINITY);
        for (Vector3d point : form.points) {
            Vector3d p = rotation.transform(point, new Vector3d()).add(position);
            low.min(p);
            high.max(p);
            deepest = Math.max(deepest, ofPoint(p, form.radius));
        }
        if (form.planes.length > 0) {
            Vector3d local = new Vector3d();
            for (int triangle : grid.around(low.x, low.z, high.x, high.z)) {
                for (int c = 0; c < 3; c++) {
                    local.set(corners.get(3 * triangle + c)).sub(position);
                    deepest = Math.max(deepest, form.inside(rotation.transformInverse(local)));
                }
            }
        }
        return deepest;
    }

    private double ofPoint(Vector3d p, double radius) {
        double above = Double.NaN;
        for (int triangle : grid.around(p.x, p.z, p.x, p.z)) {
            double height = heightAt(triangle, p.x, p.z);
            above = Double.isNaN(height) ? above : p.y - height;
        }
        if (Double.isNaN(above) || (above >= 0 && radius == 0)) {
            return 0; // beside the ground, or a corner above it
        }
        // No triangle is nearer than those within the distance straight up or down.
        double reach = Math.max(radius, Math.abs(above));
        double distance = reach;
        for (int triangle : grid.around(p.x - reach, p.z - reach, p.x + reach, p.z + reach)) {
            distance = Math.min(distance, distance(triangle, p));
        }
        return above < 0 ? radius + distance : radius - distance;
    }

    private double distance(int triangle, Vector3d p) {
        Vector3d a = corners.get(3 * triangle);
        Vector3d b = corners.get(3 * triangle + 1);
        Vector3d c = corners.get(3 * triangle + 2);
        Intersectiond.findClosestPointOnTriangle(a, b, c, p, nearest);
        return nearest.distance(p);
    }

    /** The height of a triangle at a place, NaN beside it. */
    private double heightAt(int triangle, double x, double z) {
        Vector3d a = corners.get(3 * triangle);
        Vector3d b = corners.get(3 * triangle + 1);
        Vector3d c = corners.get(3 * triangle + 2);
        double whole = (b.x - a.x) * (c.z - a.z) - (c.x - a.x) * (b.z - a.z);
        double u = ((x - a.x) * (c.z - a.z) - (c.x - a.x) * (z - a.z)) / whole;
        double v = ((b.x - a.x) * (z - a.z) - (x - a.x) * (b.z - a.z)) / whole;
        double slack = 1e-9; // on an edge either of its triangles will do
        boolean isBeside = !(u >= -slack && v >= -slack && u + v <= 1 + slack);
        return isBeside ? Double.NaN : a.y + u * (b.y - a.y) + v * (c.y - a.y);
    }

    /** A shape as points with a radius; planes (outward normal, offset) of polytopes. */
    @SuppressWarnings("ArrayRecordComponent") // never compared
    private record Form(List<Vector3d> points, double radius, double[][] planes) {
        static Form of(Shape shape) {
            return switch (shape) {
                case Sphere ball ->
                        new Form(List.of(new Vector3d()), ball.radius(), new double[0][]);
                case Capsule capsule -> {
                    List<Vector3d> axis = new ArrayList<>();
                    for (int i = 0; i < ALONG; i++) {
                        double along = 2.0 * i / (ALONG - 1) - 1;
                        axis.add(new Vector3d(0, along * capsule.halfLength(), 0));
                    }
                    yield new Form(axis, capsule.radius(), new double[0][]);
                }
                case Box box -> of(hull(box));
                case ConvexHull hull -> of(hull);
                default ->
                        throw new IllegalArgumentException(
                                "the depth in a ground of triangles is measured of balls, boxes,"
                                        + " capsules and hulls; there is a "
                                        + shape.getClass().getSimpleName()
                                        + ". Let a hull stand for it.");
            };
        }

        private static ConvexHull hull(Box box) {
            double[] xyz = new double[24];
            for (int i = 0; i < 8; i++) {
                xyz[3 * i] = (i & 1) == 0 ? box.halfX() : -box.halfX();
                xyz[3 * i + 1] = (i & 2) == 0 ? box.halfY() : -box.halfY();
                xyz[3 * i + 2] = (i & 4) == 0 ? box.halfZ() : -box.halfZ();
            }
            return ConvexHull.of(xyz);
        }

        private static Form of(ConvexHull hull) {
            double[] xyz = hull.vertices();
            List<Vector3d> points = new ArrayList<>();
            for (int i = 0; i < xyz.length; i += 3) {
                points.add(new Vector3d(xyz[i], xyz[i + 1], xyz[i + 2]));
            }
            int[][] loops = hull.faceLoops();
            double[][] planes = new double[loops.length][];
            for (int f = 0; f < loops.length; f++) {
                Vector3d normal = new Vector3d();
                int[] loop = loops[f];
                for (int i = 0; i < loop.length; i++) {
                    Vector3d from = points.get(loop[i]);
                    Vector3d to = points.get(loop[(i + 1) % loop.length]);
                    normal.add(from.cross(to, new Vector3d()));
                }
                normal.normalize();
                planes[f] =
                        new double[] {
                            normal.x, normal.y, normal.z, normal.dot(points.get(loop[0]))
                        };
            }
            return new Form(points, 0, planes);
        }

        /** How far a point of the shape's frame is behind the nearest plane; negative outside. */
        double inside(Vector3dc p) {
            double least = Double.POSITIVE_INFINITY;
            for (double[] plane : planes) {
                least =
                        Math.min(
                                least,
                                plane[3] - plane[0] * p.x() - plane[1] * p.y() - plane[2] * p.z());
            }
            return least;
        }
    }

    /** Triangles by squares of the plane of x and z. */
    private static final class Grid {
        private final double lowX, lowZ, cellX, cellZ;
        private final int side;
        private final List<List<Integer>> cells = new ArrayList<>();
        private final int[] seen;
        private int round;

        Grid(List<Vector3d> corners) {
            Vector3d low = new Vector3d(Double.POSITIVE_INFINITY);
            Vector3d high = new Vector3d(Double.NEGATIVE_INFINITY);
            for (Vector3d corner : corners) {
                low.min(corner);
                high.max(corner);
            }
            int count = corners.size() / 3;
            side = Math.clamp((int) Math.sqrt(count), 1, MOST_CELLS);
            lowX = low.x;
            lowZ = low.z;
            cellX = (high.x - low.x) / side;
            cellZ = (high.z - low.z) / side;
            seen = new int[count];
            for (int i = 0; i < side * side; i++) {
                cells.add(new ArrayList<>());
            }
            for (int t = 0; t < count; t++) {
                Vector3d a = corners.get(3 * t);
                Vector3d b = corners.get(3 * t + 1);
                Vector3d c = corners.get(3 * t + 2);
                int toX = column(Math.max(a.x, Math.max(b.x, c.x)));
                int toZ = row(Math.max(a.z, Math.max(b.z, c.z)));
                for (int z = row(Math.min(a.z, Math.min(b.z, c.z))); z <= toZ; z++) {
                    for (int x = column(Math.min(a.x, Math.min(b.x, c.x))); x <= toX; x++) {
                        cells.get(z * side + x).add(t);
                    }
                }
            }
        }

        private int column(double x) {
            return Math.clamp((int) Math.floor((x - lowX) / cellX), 0, side - 1);
        }

        private int row(double z) {
            return Math.clamp((int) Math.floor((z - lowZ) / cellZ), 0, side - 1);
        }

        /** The triangles of the squares that a rectangle meets, each once. */
        int[] around(double fromX, double fromZ, double toX, double toZ) {
            int[] found = new int[16];
            int n = 0;
            round++;
            for (int z = row(fromZ); z <= row(toZ); z++) {
                for (int x = column(fromX); x <= column(toX); x++) {
                    for (int t : cells.get(z * side + x)) {
                        if (seen[t] != round) {
                            seen[t] = round;
                            found = n == found.length ? Arrays.copyOf(found, 2 * n) : found;
                            found[n++] = t;
                        }
                    }
                }
            }
            return Arrays.copyOf(found, n);
        }
    }
}
