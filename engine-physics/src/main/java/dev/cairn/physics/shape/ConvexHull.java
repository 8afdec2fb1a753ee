package dev.cairn.physics.shape;

import dev.cairn.physics.shape.polyhedron.Polyhedral;
import dev.cairn.physics.shape.polyhedron.Polyhedron;

import org.joml.Vector3d;
import org.joml.Vector3dc;

import java.util.Arrays;
import java.util.List;

/**
 * The convex hull of a set of points. Coplanar faces are merged, points inside are dropped.
 * Collision geometry is relative to the centre of mass; {@link #vertices} gives the corners in the
 * frame of the input.
 */
public final class ConvexHull extends Polyhedral implements Shape {
    /** At density 1, in the frame of the input. */
    private final MassProperties unit;

    /** Corners in the frame of the input, x, y, z, ... */
    private final double[] corners;

    private ConvexHull(Polyhedron polyhedron, MassProperties unit, double[] corners) {
        super(polyhedron);
        this.unit = unit;
        this.corners = corners;
    }

    /**
     * A triangle without thickness, for the engine, which collides surfaces with it: it moves its
     * corners from one collision to the next. Of no use to others, for a body needs a volume.
     *
     * @return a new shape; of two that meet, the other one is the smaller
     */
    public static ConvexHull triangle() {
        MassProperties nothing = new MassProperties(0, 0, 0, 0, 0, 0, 0, 0, 0, 0);
        return new ConvexHull(Polyhedron.triangle(), nothing, new double[9]);
    }

    /**
     * The hull of points given as x, y, z, x, y, z, ...
     *
     * @param xyz three numbers per point, m; at least 4 points; duplicates are fine; not kept
     * @return the shape
     * @throws DegenerateShapeException if there are fewer than four points, a coordinate is not
     *     finite, the points coincide or lie on a line or in a plane, or the hull has more than
     *     {@value Polyhedron#MAX_VERTICES} vertices
     * @throws IllegalArgumentException if the array is null or its length no multiple of three
     */
    public static ConvexHull of(double[] xyz) {
        return of(xyz, 0);
    }

    /**
     * A hull of fewer corners: points that are less than a tolerance above the faces of the hull of
     * the others may be left out. It is inside the hull of all points.
     *
     * @param xyz as of {@link #of(double[])}
     * @param tolerance m, at least 0; more than 1/32 of the points' thickness counts as that
     * @return the shape
     * @throws DegenerateShapeException as there
     * @throws IllegalArgumentException as there, or if the tolerance is negative or NaN
     */
    public static ConvexHull of(double[] xyz, double tolerance) {
        if (!(tolerance >= 0)) {
            throw new IllegalArgumentException(
                    "tolerance is " + tolerance + " m; it must be at least 0");
        }
        if (xyz == null) {
            throw new IllegalArgumentException("xyz is null; give three numbers per point");
        }
        double[] points = xyz.clone();
        QuickHull hull = QuickHull.of(points, tolerance);
        int[][] loops = FaceMerger.loops(hull);
        int[] kept =
                Arrays.stream(loops).flatMapToInt(Arrays::stream).sorted().distinct().toArray();
        if (kept.length > Polyhedron.MAX_VERTICES) {
            throw new DegenerateShapeException(
                    DegenerateShapeException.Reason.TOO_COMPLEX,
                    "the hull has "
                            + kept.length
                            + " vertices, at most "
                            + Polyhedron.MAX_VERTICES
                            + " are possible; thin out the points");
        }
        MassProperties unit = Solids.integrate(points, loops);
        double[] corners = new double[3 * kept.length];
        for (int v = 0; v < kept.length; v++) {
            System.arraycopy(points, 3 * kept[v], corners, 3 * v, 3);
        }
        for (int[] loop : loops) {
            for (int i = 0; i < loop.length; i++) {
                loop[i] = Arrays.binarySearch(kept, loop[i]);
            }
        }
        return restored(corners, unit, loops);
    }

    /** Of corners, mass properties at density 1 and faces that a hull has told. */
    static ConvexHull restored(double[] corners, MassProperties unit, int[][] loops) {
        int count = corners.length / 3;
        double[][] relative = new double[3][count];
        for (int v = 0; v < count; v++) {
            relative[0][v] = corners[3 * v] - unit.comX();
            relative[1][v] = corners[3 * v + 1] - unit.comY();
            relative[2][v] = corners[3 * v + 2] - unit.comZ();
        }
        Polyhedron polyhedron = new Polyhedron(relative[0], relative[1], relative[2], loops);
        return new ConvexHull(polyhedron, unit, corners);
    }

    /**
     * The hull of points.
     *
     * @param points at least 4, m; not kept
     * @return the shape
     * @throws DegenerateShapeException as {@link #of(double[])}
     * @throws IllegalArgumentException if the list or a point is null
     */
    public static ConvexHull of(List<? extends Vector3dc> points) {
        if (points == null) {
            throw new IllegalArgumentException("points is null; give at least 4 points");
        }
        double[] xyz = new double[3 * points.size()];
        for (int i = 0; i < points.size(); i++) {
            Vector3dc p = points.get(i);
            if (p == null) {
                throw new IllegalArgumentException(
                        "point " + i + " of " + points.size() + " is null; leave it out");
            }
            xyz[3 * i] = p.x();
            xyz[3 * i + 1] = p.y();
            xyz[3 * i + 2] = p.z();
        }
        return of(xyz);
    }

    /**
     * The corners in the frame of the input.
     *
     * @return a new array x, y, z, ... in the order that {@link #faceLoops} speaks of, m
     */
    public double[] vertices() {
        return corners.clone();
    }

    /**
     * The faces as loops of vertex indices, counter-clockwise seen from outside.
     *
     * @return a new array of new arrays, one per face
     */
    public int[][] faceLoops() {
        return Polyhedron.of(this).faceLoops();
    }

    @Override
    public double volume() {
        return unit.mass();
    }

    @Override
    public MassProperties massProperties(double density) {
        Checks.density(density);
        return unit.times(density);
    }

    @Override
    public double innerRadius() {
        // a triangle is a part of something larger
        return unit.mass() > 0 ? Polyhedron.of(this).innerRadius() : Double.POSITIVE_INFINITY;
    }

    @Override
    public double outerRadius() {
        return Polyhedron.of(this).outerRadius();
    }

    @Override
    public Vector3d centreOfMass(Vector3d dest) {
        return dest.set(unit.comX(), unit.comY(), unit.comZ());
    }

    @Override
    public void bounds(double qx, double qy, double qz, double qw, double[] dest, int offset) {
        Polyhedron.of(this).bounds(qx, qy, qz, qw, dest, offset);
    }

    @Override
    public String toString() {
        return "ConvexHull[vertices="
                + Polyhedron.of(this).vertexCount()
                + ", faces="
                + Polyhedron.of(this).faceCount()
                + ", volume="
                + volume()
                + "]";
    }
}
