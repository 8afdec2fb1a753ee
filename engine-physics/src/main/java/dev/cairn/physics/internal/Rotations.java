package dev.cairn.physics.internal;

/** Quaternions as users pass them, and the rotation of a vector. */
public final class Rotations {
    /** How far from 1 the length of a quaternion may be to be taken as rounding. */
    public static final double TOLERANCE = 1e-6;

    /** Four units in the last place of 1. */
    private static final double ROUNDING = 0x1p-50;

    private static final double TWO_OVER_PI = 2 / Math.PI;

    /** A quarter turn in two parts: the first has 33 bits, so its multiples are exact. */
    private static final double QUARTER_HIGH = 0x1.921fb544p0, QUARTER_LOW = 0x1.0b4611a626331p-34;

    private Rotations() {}

    /**
     * The turn by w t: cosine and sine of the half angle h by their series, after the quarter turns
     * in it are taken off. Only with + - * / and sqrt, so with the same bits everywhere.
     *
     * @param spin length of w, rad/s, above 0
     * @param out receives the unit quaternion x, y, z, w
     */
    public static void turn(double wx, double wy, double wz, double spin, double t, double[] out) {
        double half = 0.5 * spin * t;
        double quarters = Math.rint(half * TWO_OVER_PI);
        double h = half - quarters * QUARTER_HIGH - quarters * QUARTER_LOW;
        double s = h * h;
        double sine = series(s, 1) * h;
        double cosine = series(s, 0);
        long quadrant = (long) quarters & 3;
        double c = (quadrant & 1) == 0 ? cosine : sine;
        double d = (quadrant & 1) == 0 ? sine : cosine;
        c = quadrant == 1 || quadrant == 2 ? -c : c;
        d = quadrant >= 2 ? -d : d;
        out[0] = d * wx / spin;
        out[1] = d * wy / spin;
        out[2] = d * wz / spin;
        out[3] = c;
    }

    /** 1 - s/(o+1)(o+2) (1 - s/(o+3)(o+4) (…)): cosine for o = 0, sine over its angle for 1. */
    private static double series(double s, int o) {
        double sum = 1;
        for (int i = 16 + o; i > o; i -= 2) {
            sum = 1 - s / (i * (i - 1)) * sum;
        }
        return sum;
    }

    /**
     * The factor that makes a quaternion a unit one, if it is one but for rounding.
     *
     * @return the factor, 1 if the length is 1 but for the last bits
     */
    public static double inverseLength(String name, double x, double y, double z, double w) {
        double length = Math.sqrt(x * x + y * y + z * z + w * w);
        if (!(Math.abs(length - 1) <= TOLERANCE)) {
            throw new IllegalArgumentException(
                    name
                            + " is the quaternion ("
                            + x
                            + ", "
                            + y
                            + ", "
                            + z
                            + ", "
                            + w
                            + ") of length "
                            + length
                            + "; the length must be within "
                            + TOLERANCE
                            + " of 1: normalise it first");
        }
        // A quaternion that is normalised but for rounding is kept bit for bit, so that what one
        // body says of its orientation turns another one into exactly the same.
        return Math.abs(length - 1) <= ROUNDING ? 1 : 1 / length;
    }

    /**
     * Rotates (vx, vy, vz) by the unit quaternion: v + 2 w (q x v) + 2 q x (q x v).
     *
     * @param out receives the vector, from index 0 on
     */
    public static void rotate(
            double qx,
            double qy,
            double qz,
            double qw,
            double vx,
            double vy,
            double vz,
            double[] out) {
        double tx = 2 * (qy * vz - qz * vy);
        double ty = 2 * (qz * vx - qx * vz);
        double tz = 2 * (qx * vy - qy * vx);
        out[0] = vx + qw * tx + (qy * tz - qz * ty);
        out[1] = vy + qw * ty + (qz * tx - qx * tz);
        out[2] = vz + qw * tz + (qx * ty - qy * tx);
    }

    /**
     * The turn b, and then a: the product a b.
     *
     * @param o where b begins
     * @param out receives x, y, z, w
     */
    public static void multiply(double[] a, double[] b, int o, double[] out) {
        double x = b[o];
        double y = b[o + 1];
        double z = b[o + 2];
        double w = b[o + 3];
        out[0] = a[3] * x + a[0] * w + a[1] * z - a[2] * y;
        out[1] = a[3] * y - a[0] * z + a[1] * w + a[2] * x;
        out[2] = a[3] * z + a[0] * y - a[1] * x + a[2] * w;
        out[3] = a[3] * w - a[0] * x - a[1] * y - a[2] * z;
    }
}
