package dev.cairn.physics.contact;

import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.narrowphase.pair.Manifold;

/**
 * The order of a contact's points, in which they are swept and added up: the deepest last, whose
 * speed a sweep then leaves right; of points as deep as each other the nearer to A's centre first.
 * It is chosen when the names of the points change, so that depths that change by rounding do not
 * change it. It follows from depths and distances alone, so a contact in a mirror has the mirrored
 * order; a mirror turns the order of names round.
 *
 * <p>One instance per worker.
 */
final class PointOrder {
    /** Each place has the point of its number. */
    private static final int ASCENDING = 0b11_10_01_00;

    private final double[] number = new double[ContactStore.POINTS];
    private final int[] name = new int[ContactStore.POINTS];

    /**
     * The order of a contact's points.
     *
     * @param m the points in order of names
     * @return for each place the number of a point, two bits each, the first one lowest
     */
    static int of(Manifold m) {
        int points = m.pointCount;
        int order = 0;
        int places = 0;
        for (int left = (1 << points) - 1; left != 0; places++) {
            int first = Integer.numberOfTrailingZeros(left);
            for (int p = first + 1; p < points; p++) {
                if ((left >> p & 1) != 0 && isBefore(m, p, first)) {
                    first = p;
                }
            }
            order |= first << (2 * places);
            left &= ~(1 << first);
        }
        return order | (ASCENDING & (-1 << (2 * places)));
    }

    /**
     * The order that the points of a row have.
     *
     * @param first place of its first point
     */
    static int of(int[] feature, int first, int points) {
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

    private static boolean isBefore(Manifold m, int p, int q) {
        double higher = m.separation[p] - m.separation[q];
        return higher > 0 || (higher == 0 && square(m, p) < square(m, q));
    }

    private static double square(Manifold m, int p) {
        return m.pointX[p] * m.pointX[p] + m.pointY[p] * m.pointY[p] + m.pointZ[p] * m.pointZ[p];
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
