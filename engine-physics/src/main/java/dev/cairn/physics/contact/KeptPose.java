package dev.cairn.physics.contact;

import dev.cairn.physics.internal.Poses;

/**
 * The pose of one collider seen from another one, kept to know how far they have moved since. Seen
 * from the reference no point of the other one, whose outer radius is R, has moved by more than
 *
 * <pre>|de| + 2 |dq| R &lt;= sqrt(2 (|de|^2 + 4 |dq|^2 R^2))</pre>
 *
 * where e is its centre, q its orientation (a unit quaternion, turned by 2 asin|sin| of at most 2
 * |dq|). Moves count from the pose that was kept; they do not add up. Stateless.
 */
final class KeptPose {
    /** Orientation of the other one seen from the reference, four numbers. */
    private static final int TURN = 0;

    /** Centre of the other one in the reference's axes, m, three numbers. */
    private static final int CENTRE = 4;

    /** 4 R squared, m2. */
    private static final int SPIN = 7;

    /** How many numbers there are. */
    static final int SIZE = 8;

    private KeptPose() {}

    /**
     * Keeps it.
     *
     * @param k receives it from {@code at} on
     * @param r the reference
     * @param i the other one
     * @param radius its outer radius, m
     */
    static void keep(double[] k, int at, Poses s, int r, int i, double radius) {
        double rx = s.orientationX[r];
        double ry = s.orientationY[r];
        double rz = s.orientationZ[r];
        double rw = s.orientationW[r];
        double ix = s.orientationX[i];
        double iy = s.orientationY[i];
        double iz = s.orientationZ[i];
        double iw = s.orientationW[i];
        k[at + TURN] = rw * ix - rx * iw - ry * iz + rz * iy;
        k[at + TURN + 1] = rw * iy - ry * iw - rz * ix + rx * iz;
        k[at + TURN + 2] = rw * iz - rz * iw - rx * iy + ry * ix;
        k[at + TURN + 3] = rw * iw + rx * ix + ry * iy + rz * iz;
        // e in the reference's axes, by v + 2 u x (u x v + w v) with u = -q
        double ex = s.apartX(r, i);
        double ey = s.apartY(r, i);
        double ez = s.apartZ(r, i);
        double tx = 2 * (rz * ey - ry * ez);
        double ty = 2 * (rx * ez - rz * ex);
        double tz = 2 * (ry * ex - rx * ey);
        k[at + CENTRE] = ex + rw * tx + (rz * ty - ry * tz);
        k[at + CENTRE + 1] = ey + rw * ty + (rx * tz - rz * tx);
        k[at + CENTRE + 2] = ez + rw * tz + (ry * tx - rx * ty);
        k[at + SPIN] = 4 * radius * radius;
    }

    /** The square of the bound of the move since, m2. */
    static double moved(double[] k, int at, Poses s, int r, int i) {
        double rx = s.orientationX[r];
        double ry = s.orientationY[r];
        double rz = s.orientationZ[r];
        double rw = s.orientationW[r];
        double ix = s.orientationX[i];
        double iy = s.orientationY[i];
        double iz = s.orientationZ[i];
        double iw = s.orientationW[i];
        double ex = s.apartX(r, i);
        double ey = s.apartY(r, i);
        double ez = s.apartZ(r, i);
        double qx = rw * ix - rx * iw - ry * iz + rz * iy - k[at + TURN];
        double qy = rw * iy - ry * iw - rz * ix + rx * iz - k[at + TURN + 1];
        double qz = rw * iz - rz * iw - rx * iy + ry * ix - k[at + TURN + 2];
        double qw = rw * iw + rx * ix + ry * iy + rz * iz - k[at + TURN + 3];
        double tx = 2 * (rz * ey - ry * ez);
        double ty = 2 * (rx * ez - rz * ex);
        double tz = 2 * (ry * ex - rx * ey);
        double cx = ex + rw * tx + (rz * ty - ry * tz) - k[at + CENTRE];
        double cy = ey + rw * ty + (rx * tz - rz * tx) - k[at + CENTRE + 1];
        double cz = ez + rw * tz + (ry * tx - rx * ty) - k[at + CENTRE + 2];
        return 2
                * ((cx * cx + cy * cy + cz * cz)
                        + k[at + SPIN] * (qx * qx + qy * qy + (qz * qz + qw * qw)));
    }
}
