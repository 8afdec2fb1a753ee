package dev.cairn.physics.shape;

import java.math.BigInteger;

/**
 * On which side of a plane a point lies, decided exactly. A floating-point filter answers nearly
 * always; where its error bound does not decide, the determinant is computed without rounding.
 * Set-up only: the exact branch allocates.
 *
 * <p>Source of the bound: J. R. Shewchuk, "Adaptive precision floating-point arithmetic and fast
 * robust geometric predicates", Discrete and Computational Geometry 18 (1997), stage A of orient3d.
 */
final class Orientation {
    private static final double EPSILON = 0x1p-53;
    private static final double BOUND = (7 + 56 * EPSILON) * EPSILON;

    private Orientation() {}

    /**
     * The sign of the volume of the tetrahedron: positive when {@code d} is on the outer side of
     * triangle a, b, c, whose corners run counter-clockwise seen from outside.
     */
    static int sign(double[] p, int a, int b, int c, int d) {
        double ax = p[3 * a] - p[3 * d];
        double ay = p[3 * a + 1] - p[3 * d + 1];
        double az = p[3 * a + 2] - p[3 * d + 2];
        double bx = p[3 * b] - p[3 * d];
        double by = p[3 * b + 1] - p[3 * d + 1];
        double bz = p[3 * b + 2] - p[3 * d + 2];
        double cx = p[3 * c] - p[3 * d];
        double cy = p[3 * c + 1] - p[3 * d + 1];
        double cz = p[3 * c + 2] - p[3 * d + 2];
        double det = az * (bx * cy - cx * by) + bz * (cx * ay - ax * cy) + cz * (ax * by - bx * ay);
        double permanent =
                (Math.abs(bx * cy) + Math.abs(cx * by)) * Math.abs(az)
                        + (Math.abs(cx * ay) + Math.abs(ax * cy)) * Math.abs(bz)
                        + (Math.abs(ax * by) + Math.abs(bx * ay)) * Math.abs(cz);
        double bound = BOUND * permanent;
        if (det > bound) {
            return -1;
        }
        if (det < -bound) {
            return 1;
        }
        // Every product is zero: all four points in one axis plane, the usual case of a cap with
        // many corners.
        return permanent == 0 ? 0 : exact(p, a, b, c, d);
    }

    /**
     * In whole multiples of the least last place of all coordinates: the determinant has the sign
     * of that of the points. Not in {@code BigDecimal}, whose class alone takes the JVM a tenth of
     * a second to set up.
     */
    private static int exact(double[] p, int a, int b, int c, int d) {
        int unit = Math.min(Math.min(unit(p, a), unit(p, b)), Math.min(unit(p, c), unit(p, d)));
        BigInteger ax = difference(p, 3 * a, 3 * d, unit);
        BigInteger ay = difference(p, 3 * a + 1, 3 * d + 1, unit);
        BigInteger az = difference(p, 3 * a + 2, 3 * d + 2, unit);
        BigInteger bx = difference(p, 3 * b, 3 * d, unit);
        BigInteger by = difference(p, 3 * b + 1, 3 * d + 1, unit);
        BigInteger bz = difference(p, 3 * b + 2, 3 * d + 2, unit);
        BigInteger cx = difference(p, 3 * c, 3 * d, unit);
        BigInteger cy = difference(p, 3 * c + 1, 3 * d + 1, unit);
        BigInteger cz = difference(p, 3 * c + 2, 3 * d + 2, unit);
        BigInteger det =
                az.multiply(bx.multiply(cy).subtract(cx.multiply(by)))
                        .add(bz.multiply(cx.multiply(ay).subtract(ax.multiply(cy))))
                        .add(cz.multiply(ax.multiply(by).subtract(bx.multiply(ay))));
        return -det.signum();
    }

    /** Exponent of two of the least last place of a point's coordinates that are not 0. */
    private static int unit(double[] p, int point) {
        int least = Double.MAX_EXPONENT;
        for (int i = 3 * point; i < 3 * point + 3; i++) {
            least = p[i] == 0 ? least : Math.min(least, lastPlace(p[i]));
        }
        return least;
    }

    /** Exponent of two of the last of the 53 places of a number. */
    private static int lastPlace(double value) {
        return Math.max(Math.getExponent(value), Double.MIN_EXPONENT) - 52;
    }

    private static BigInteger difference(double[] p, int i, int j, int unit) {
        return whole(p[i], unit).subtract(whole(p[j], unit));
    }

    private static BigInteger whole(double value, int unit) {
        if (value == 0) {
            return BigInteger.ZERO;
        }
        int last = lastPlace(value);
        return BigInteger.valueOf((long) Math.scalb(value, -last)).shiftLeft(last - unit);
    }
}
