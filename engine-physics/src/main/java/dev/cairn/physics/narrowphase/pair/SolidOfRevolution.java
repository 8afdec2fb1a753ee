package dev.cairn.physics.narrowphase.pair;

import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.revolution.Discs;
import dev.cairn.physics.shape.revolution.Revolved;

/**
 * The core of a round shape: the convex hull of two discs about the y axis, relative to the centre
 * of mass. A disc of radius 0 is a point, and both discs may coincide: the core of a ball is a
 * point, that of a capsule a segment, and a cone has a disc and an apex. The shape is its core with
 * a ball of radius {@link #round} swept over it.
 *
 * <p>Support points are numbered in the order in which they were asked for, so that GJK and EPA
 * recognise them as they recognise vertices; equal points have equal numbers.
 */
public final class SolidOfRevolution {
    /** More than one run of GJK and one of EPA can ask for. */
    private static final int MOST = 512;

    /** Heights of the discs along y, and their radii, m. */
    public double low, high, lowRadius, highRadius;

    /** Radius around the core. */
    public double round;

    /** Along the outward normals of the side: its y component, and the one across. */
    public double sideAlong, sideAcross;

    private final double[] x = new double[MOST], y = new double[MOST], z = new double[MOST];
    private int count;

    /** Takes over a ball, capsule, cylinder or cone; false for other shapes. */
    boolean set(Shape shape) {
        count = 0;
        if (shape instanceof Revolved revolved) {
            Discs discs = Discs.of(revolved);
            low = discs.low;
            high = discs.high;
            lowRadius = discs.lowRadius;
            highRadius = discs.highRadius;
            round = discs.round;
        } else {
            low = 0;
            high = 0;
            lowRadius = 0;
            highRadius = 0;
            round = shape.outerRadius();
        }
        double rise = high - low;
        double taper = lowRadius - highRadius;
        double length = Math.sqrt(rise * rise + taper * taper);
        sideAlong = length > 0 ? taper / length : 0;
        sideAcross = length > 0 ? rise / length : 1;
        return true;
    }

    /** A ball's core. */
    public boolean isPoint() {
        return low == high;
    }

    /** A point or a segment: without discs. */
    public boolean isThin() {
        return lowRadius == 0 && highRadius == 0;
    }

    /** How far the core reaches along a direction of its frame. */
    double reach(double dx, double dy, double dz) {
        double across = Math.sqrt(dx * dx + dz * dz);
        return Math.max(high * dy + highRadius * across, low * dy + lowRadius * across);
    }

    /** The number of the point of the core that is farthest in a direction; ties go to the top. */
    int support(double dx, double dy, double dz) {
        double across = Math.sqrt(dx * dx + dz * dz);
        boolean top = high * dy + highRadius * across >= low * dy + lowRadius * across;
        double radius = top ? highRadius : lowRadius;
        // Exactly along the axis the centre of the disc is a support point as good as any.
        double scale = across > 0 ? radius / across : 0;
        return number(dx * scale, top ? high : low, dz * scale);
    }

    private int number(double px, double py, double pz) {
        for (int i = count - 1; i >= 0; i--) {
            if (x[i] == px && y[i] == py && z[i] == pz) {
                return i;
            }
        }
        int at = count < MOST ? count++ : MOST - 1;
        x[at] = px;
        y[at] = py;
        z[at] = pz;
        return at;
    }

    /** Whether a point is the tip of a cone. */
    public boolean isTip(int point) {
        return y[point] == high && highRadius == 0 && lowRadius > 0;
    }

    double x(int point) {
        return x[point];
    }

    double y(int point) {
        return y[point];
    }

    double z(int point) {
        return z[point];
    }

    /** Forgets the numbers. */
    public void restart() {
        count = 0;
    }
}
