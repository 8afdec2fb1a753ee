package dev.cairn.physics.shape.decomposition;

import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.DegenerateShapeException;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;

/**
 * What of a solid is in a convex cell: the polygons of its surface there, and those corners of the
 * cell that are inside it. Its extreme points are among their corners, so no cut has to be closed
 * by a face. Immutable; polygons are shared with the piece that it was cut from.
 */
final class Piece {
    /** Convex, not always flat to the last bit; three numbers for each corner, m. */
    final double[][] polygon;

    /** The triangle that each polygon is of. */
    final int[] source;

    /** Corners of the cell that are inside the solid; three numbers each. */
    private final double[] corners;

    /** The cell is above all of these. */
    private final double[][] cell;

    private Piece(double[][] polygon, int[] source, double[] corners, double[][] cell) {
        this.polygon = polygon;
        this.source = source;
        this.corners = corners;
        this.cell = cell;
    }

    /** All of a solid, in its box with some room about it, whose corners are outside. */
    static Piece of(Solid solid) {
        double[][] polygon = new double[solid.count][];
        int[] source = new int[solid.count];
        for (int t = 0; t < solid.count; t++) {
            polygon[t] = java.util.Arrays.copyOfRange(solid.corner, 9 * t, 9 * t + 9);
            source[t] = t;
        }
        double[][] cell = new double[6][4];
        double room = solid.size / 64;
        for (int axis = 0; axis < 3; axis++) {
            cell[2 * axis][axis] = 1;
            cell[2 * axis][3] = solid.box[axis] - room;
            cell[2 * axis + 1][axis] = -1;
            cell[2 * axis + 1][3] = -solid.box[axis + 3] - room;
        }
        return new Piece(polygon, source, new double[0], cell);
    }

    /**
     * The piece above and the one below a plane.
     *
     * @return null if all is on one side
     */
    Piece @Nullable [] cut(Solid solid, Solid.Probe probe, double[] plane) {
        double[] cap = cap(solid, probe, plane);
        double[] below = {-plane[0], -plane[1], -plane[2], -plane[3]};
        Piece[] both = {side(solid, plane, cap), side(solid, below, cap)};
        return both[0].isEmpty() || both[1].isEmpty() ? null : both;
    }

    private boolean isEmpty() {
        return polygon.length == 0 && corners.length < 12;
    }

    private Piece side(Solid solid, double[] plane, double[] cap) {
        List<double[]> kept = new ArrayList<>();
        int[] from = new int[polygon.length];
        for (int i = 0; i < polygon.length; i++) {
            double[] part = part(solid, i, plane);
            if (part.length > 0) {
                from[kept.size()] = source[i];
                kept.add(part);
            }
        }
        double[][] planes = java.util.Arrays.copyOf(cell, cell.length + 1);
        planes[cell.length] = plane;
        return new Piece(
                kept.toArray(new double[0][]),
                java.util.Arrays.copyOf(from, kept.size()),
                cornersAbove(solid, plane, cap),
                planes);
    }

    /** What of a polygon is above; one that lies in the plane is where the solid below it is. */
    private double[] part(Solid solid, int i, double[] plane) {
        double[] p = polygon[i];
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < p.length; k += 3) {
            double h = Planes.height(plane, p[k], p[k + 1], p[k + 2]);
            low = Math.min(low, h);
            high = Math.max(high, h);
        }
        if (low >= -solid.snap && high <= solid.snap) {
            int n = 3 * source[i];
            double facing =
                    solid.normal[n] * plane[0]
                            + solid.normal[n + 1] * plane[1]
                            + solid.normal[n + 2] * plane[2];
            return facing < 0 ? p : new double[0];
        }
        if (low >= -solid.snap) {
            return p;
        }
        return high <= solid.snap ? new double[0] : Planes.clip(p, plane, 1, solid.snap);
    }

    private double[] cornersAbove(Solid solid, double[] plane, double[] cap) {
        double[] all = new double[corners.length + cap.length];
        int count = 0;
        for (int k = 0; k < corners.length; k += 3) {
            if (Planes.height(plane, corners[k], corners[k + 1], corners[k + 2]) >= -solid.snap) {
                System.arraycopy(corners, k, all, count, 3);
                count += 3;
            }
        }
        System.arraycopy(cap, 0, all, count, cap.length);
        return java.util.Arrays.copyOf(all, count + cap.length);
    }

    /** The corners that a plane gives the cell and that are inside the solid. */
    private double[] cap(Solid solid, Solid.Probe probe, double[] plane) {
        double[] middle = {
            0.5 * (solid.box[0] + solid.box[3]),
            0.5 * (solid.box[1] + solid.box[4]),
            0.5 * (solid.box[2] + solid.box[5])
        };
        double[] section = Planes.square(plane, middle, 4 * solid.size);
        for (int i = 0; i < cell.length && section.length > 0; i++) {
            section = Planes.clip(section, cell[i], 1, solid.snap);
        }
        double[] inside = new double[section.length];
        int count = 0;
        for (int k = 0; k < section.length; k += 3) {
            double x = section[k];
            double y = section[k + 1];
            double z = section[k + 2];
            if (probe.isInside(x, y, z)
                    && probe.distance(x, y, z, 0, Double.POSITIVE_INFINITY) > 4 * solid.snap) {
                inside[count++] = x;
                inside[count++] = y;
                inside[count++] = z;
            }
        }
        return java.util.Arrays.copyOf(inside, count);
    }

    /** All points whose hull is that of the piece. */
    double[] points() {
        int size = corners.length;
        for (double[] p : polygon) {
            size += p.length;
        }
        double[] all = new double[size];
        System.arraycopy(corners, 0, all, 0, corners.length);
        int at = corners.length;
        for (double[] p : polygon) {
            System.arraycopy(p, 0, all, at, p.length);
            at += p.length;
        }
        return all;
    }

    /** The same with each n-th polygon only: what a plane is tried on. */
    Piece thinned(int most) {
        if (polygon.length <= most) {
            return this;
        }
        double[][] some = new double[most][];
        int[] from = new int[most];
        for (int i = 0; i < most; i++) {
            int k = (int) ((long) i * polygon.length / most);
            some[i] = polygon[k];
            from[i] = source[k];
        }
        return new Piece(some, from, corners, cell);
    }

    /**
     * The hull of points; null if they have no volume.
     *
     * @param tolerance what may be left out, m; more where there are too many corners
     */
    static @Nullable ConvexHull hull(double[] points, double tolerance) {
        for (double coarse = tolerance; points.length >= 12; coarse = 2 * coarse) {
            try {
                return ConvexHull.of(points, coarse);
            } catch (DegenerateShapeException flat) {
                if (flat.reason() != DegenerateShapeException.Reason.TOO_COMPLEX) {
                    return null;
                }
            }
        }
        return null;
    }
}
