package dev.cairn.physics.contact;

import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.Poses;
import dev.cairn.physics.narrowphase.pair.Manifold;

/**
 * The order of a contact's points, in which they are swept and added up: the deepest last, whose
 * speed a sweep then leaves right; of points as deep as each other the nearer to the centre first,
 * that of a body that moves; of those the one nearest to the point before it, so that a sweep goes
 * round the patch; of those the one less far along the body's x, y or z axis. What differs by
 * rounding is the same. So it follows from where the points are on the body, and not from the
 * shapes that make it, or where it is. It is chosen when the names of the points change, so depths
 * that change do not change it.
 *
 * <p>One instance per worker.
 */
public final class PointOrder {
    /** Each place has the point of its number. */
    static final int ASCENDING = 0b11_10_01_00;

    /** Of the distance from the centre: lengths that are rounding. */
    private static final double ROUNDING = 0x1p-36;

    private final double[] number = new double[ContactStore.POINTS];
    private final int[] name = new int[ContactStore.POINTS];
    private final double[] separation = new double[ContactStore.POINTS];
    private final double[] square = new double[ContactStore.POINTS];

    /** From the centre, in the axes of the body. */
    private final double[] local = new double[3 * ContactStore.POINTS];

    private double qx, qy, qz, qw;

    /** Nothing told yet. */
    public PointOrder() {}

    /** Chooses the axes: a body's. */
    public void of(Poses s, int body) {
        qx = s.orientationX[body];
        qy = s.orientationY[body];
        qz = s.orientationZ[body];
        qw = s.orientationW[body];
    }

    /**
     * Tells of a point.
     *
     * @param x from the body's centre, world axes, m; likewise y and z
     */
    public void put(int point, double depth, double x, double y, double z) {
        separation[point] = depth;
        square[point] = x * x + y * y + z * z;
        // v' = v + 2 w (v x q) + 2 (v x q) x q, the turn back
        double tx = 2 * (y * qz - z * qy);
        double ty = 2 * (z * qx - x * qz);
        double tz = 2 * (x * qy - y * qx);
        local[3 * point] = x + qw * tx + ty * qz - tz * qy;
        local[3 * point + 1] = y + qw * ty + tz * qx - tx * qz;
        local[3 * point + 2] = z + qw * tz + tx * qy - ty * qx;
    }

    /**
     * The order of points that were told of.
     *
     * @param points how many
     * @return for each place the number of a point, two bits each, the first one lowest
     */
    public int order(int points) {
        int order = 0;
        int places = 0;
        int before = -1;
        for (int left = (1 << points) - 1; left != 0; places++) {
            int first = Integer.numberOfTrailingZeros(left);
            for (int p = first + 1; p < points; p++) {
                if ((left >> p & 1) != 0 && isBefore(p, first, before)) {
                    first = p;
                }
            }
            order |= first << (2 * places);
            left &= ~(1 << first);
            before = first;
        }
        return order | (ASCENDING & (-1 << (2 * places)));
    }

    /** Whether p comes before q, behind a point, or as the first one if that is -1. */
    private boolean isBefore(int p, int q, int before) {
        double higher = separation[p] - separation[q];
        if (higher * higher > ROUNDING * ROUNDING * square[p]) {
            return higher > 0;
        }
        double nearer = square[q] - square[p];
        if (Math.abs(nearer) > ROUNDING * square[p]) {
            return nearer > 0;
        }
        double closer = before < 0 ? 0 : apart(q, before) - apart(p, before);
        if (Math.abs(closer) > ROUNDING * square[p]) {
            return closer > 0;
        }
        for (int axis = 0; axis < 3; axis++) {
            double along = local[3 * p + axis] - local[3 * q + axis];
            if (along * along > ROUNDING * ROUNDING * square[p]) {
                return along < 0;
            }
        }
        return false;
    }

    /** Square of the distance of two points, m². */
    private double apart(int p, int q) {
        double x = local[3 * p] - local[3 * q];
        double y = local[3 * p + 1] - local[3 * q + 1];
        double z = local[3 * p + 2] - local[3 * q + 2];
        return x * x + y * y + z * z;
    }

    /**
     * The order that the points of a row have.
     *
     * @param first place of its first point
     */
    public static int of(int[] feature, int first, int points) {
        int order = ASCENDING & (-1 << (2 * points));
        for (int p = 0; p < points; p++) {
            int rank = 0;
            for (int q = 0; q < points; q++) {
                int least = Integer.compareUnsigned(feature[first + q], feature[first + p]);
                rank += least < 0 || (least == 0 && q < p) ? 1 : 0;
            }
            order |= rank << (2 * p);
        }
        return order;
    }

    /** Puts the points, which are in order of names, into an order. */
    void arrange(Manifold m, int order) {
        int points = m.pointCount;
        int mask = (1 << (2 * points)) - 1;
        if (((order ^ ASCENDING) & mask) == 0) {
            return;
        }
        arrange(m.pointX, points, order);
        arrange(m.pointY, points, order);
        arrange(m.pointZ, points, order);
        arrange(m.separation, points, order);
        System.arraycopy(m.feature, 0, name, 0, points);
        for (int p = 0; p < points; p++) {
            m.feature[p] = name[(order >> (2 * p)) & 3];
        }
    }

    private void arrange(double[] to, int points, int order) {
        System.arraycopy(to, 0, number, 0, points);
        for (int p = 0; p < points; p++) {
            to[p] = number[(order >> (2 * p)) & 3];
        }
    }
}
