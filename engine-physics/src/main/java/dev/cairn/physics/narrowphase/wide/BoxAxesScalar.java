package dev.cairn.physics.narrowphase.wide;

import static dev.cairn.physics.narrowphase.wide.BoxBatch.*;

/**
 * The twin of {@link BoxAxesWide} without the Vector API: one pair after another, the same
 * operations in the same order, hence the same bits.
 */
final class BoxAxesScalar {
    private BoxAxesScalar() {}

    static void run(double[] t, int count) {
        for (int i = 0; i < count; i++) {
            world(t, i);
            relative(t, i);
            facesOfA(t, i);
            facesOfB(t, i);
            t[SEPARATION_EDGE + i] = -Double.MAX_VALUE;
            t[SIGNED_SQUARE + i] = -Double.MAX_VALUE;
            t[SQUARE + i] = 1;
            t[EDGE + i] = -1;
            for (int j = 0; j < 3; j++) {
                edges(t, i, j, j == 0 ? 1 : 0, j == 2 ? 1 : 2);
            }
            t[SEPARATION_EDGE + i] /= Math.sqrt(t[SQUARE + i]);
        }
    }

    /** Rotation matrix of A and the offset in its frame. */
    private static void world(double[] t, int i) {
        double x = t[TURN_A + i];
        double y = t[TURN_A + CAPACITY + i];
        double z = t[TURN_A + 2 * CAPACITY + i];
        double w = t[TURN_A + 3 * CAPACITY + i];
        double s = 2 / (x * x + y * y + z * z + w * w);
        double w00 = 1 - s * (y * y + z * z);
        double w01 = s * (x * y - z * w);
        double w02 = s * (x * z + y * w);
        double w10 = s * (x * y + z * w);
        double w11 = 1 - s * (x * x + z * z);
        double w12 = s * (y * z - x * w);
        double w20 = s * (x * z - y * w);
        double w21 = s * (y * z + x * w);
        double w22 = 1 - s * (x * x + y * y);
        t[WORLD + i] = w00;
        t[WORLD + CAPACITY + i] = w01;
        t[WORLD + 2 * CAPACITY + i] = w02;
        t[WORLD + 3 * CAPACITY + i] = w10;
        t[WORLD + 4 * CAPACITY + i] = w11;
        t[WORLD + 5 * CAPACITY + i] = w12;
        t[WORLD + 6 * CAPACITY + i] = w20;
        t[WORLD + 7 * CAPACITY + i] = w21;
        t[WORLD + 8 * CAPACITY + i] = w22;
        double dx = t[OFFSET + i];
        double dy = t[OFFSET + CAPACITY + i];
        double dz = t[OFFSET + 2 * CAPACITY + i];
        t[CENTRE + i] = w00 * dx + w10 * dy + w20 * dz;
        t[CENTRE + CAPACITY + i] = w01 * dx + w11 * dy + w21 * dz;
        t[CENTRE + 2 * CAPACITY + i] = w02 * dx + w12 * dy + w22 * dz;
    }

    /** Rotation matrix from B's axes to A's. */
    private static void relative(double[] t, int i) {
        double ax = t[TURN_A + i];
        double ay = t[TURN_A + CAPACITY + i];
        double az = t[TURN_A + 2 * CAPACITY + i];
        double aw = t[TURN_A + 3 * CAPACITY + i];
        double bx = t[TURN_B + i];
        double by = t[TURN_B + CAPACITY + i];
        double bz = t[TURN_B + 2 * CAPACITY + i];
        double bw = t[TURN_B + 3 * CAPACITY + i];
        double x = aw * bx - ax * bw - ay * bz + az * by;
        double y = aw * by + ax * bz - ay * bw - az * bx;
        double z = aw * bz - ax * by + ay * bx - az * bw;
        double w = aw * bw + ax * bx + ay * by + az * bz;
        double s = 2 / (x * x + y * y + z * z + w * w);
        t[RELATIVE + i] = 1 - s * (y * y + z * z);
        t[RELATIVE + CAPACITY + i] = s * (x * y - z * w);
        t[RELATIVE + 2 * CAPACITY + i] = s * (x * z + y * w);
        t[RELATIVE + 3 * CAPACITY + i] = s * (x * y + z * w);
        t[RELATIVE + 4 * CAPACITY + i] = 1 - s * (x * x + z * z);
        t[RELATIVE + 5 * CAPACITY + i] = s * (y * z - x * w);
        t[RELATIVE + 6 * CAPACITY + i] = s * (x * z - y * w);
        t[RELATIVE + 7 * CAPACITY + i] = s * (y * z + x * w);
        t[RELATIVE + 8 * CAPACITY + i] = 1 - s * (x * x + y * y);
    }

    private static void facesOfA(double[] t, int i) {
        double hx = t[HALF_B + i];
        double hy = t[HALF_B + CAPACITY + i];
        double hz = t[HALF_B + 2 * CAPACITY + i];
        double most = -Double.MAX_VALUE;
        double face = 0;
        for (int k = 0; k < 3; k++) {
            int row = RELATIVE + 3 * k * CAPACITY + i;
            double along = t[CENTRE + k * CAPACITY + i];
            double extent =
                    Math.abs(t[row]) * hx
                            + Math.abs(t[row + CAPACITY]) * hy
                            + Math.abs(t[row + 2 * CAPACITY]) * hz;
            double s = Math.abs(along) - (t[HALF_A + k * CAPACITY + i] + extent);
            if (s > most) {
                most = s;
                face = along >= 0 ? 2 * k + 1 : 2 * k;
            }
        }
        t[SEPARATION_A + i] = most;
        t[FACE_A + i] = face;
    }

    private static void facesOfB(double[] t, int i) {
        double hx = t[HALF_A + i];
        double hy = t[HALF_A + CAPACITY + i];
        double hz = t[HALF_A + 2 * CAPACITY + i];
        double dx = t[CENTRE + i];
        double dy = t[CENTRE + CAPACITY + i];
        double dz = t[CENTRE + 2 * CAPACITY + i];
        double most = -Double.MAX_VALUE;
        double face = 0;
        for (int k = 0; k < 3; k++) {
            double x = t[RELATIVE + k * CAPACITY + i];
            double y = t[RELATIVE + (3 + k) * CAPACITY + i];
            double z = t[RELATIVE + (6 + k) * CAPACITY + i];
            double along = dx * x + dy * y + dz * z;
            double extent = Math.abs(x) * hx + Math.abs(y) * hy + Math.abs(z) * hz;
            double s = Math.abs(along) - (t[HALF_B + k * CAPACITY + i] + extent);
            if (s > most) {
                most = s;
                face = along >= 0 ? 2 * k : 2 * k + 1;
            }
        }
        t[SEPARATION_B + i] = most;
        t[FACE_B + i] = face;
    }

    /** Edge direction j of B with the three of A; k and l are B's other axes. */
    private static void edges(double[] t, int i, int j, int k, int l) {
        double x = t[RELATIVE + j * CAPACITY + i];
        double y = t[RELATIVE + (3 + j) * CAPACITY + i];
        double z = t[RELATIVE + (6 + j) * CAPACITY + i];
        double ux = t[RELATIVE + k * CAPACITY + i];
        double uy = t[RELATIVE + (3 + k) * CAPACITY + i];
        double uz = t[RELATIVE + (6 + k) * CAPACITY + i];
        double vx = t[RELATIVE + l * CAPACITY + i];
        double vy = t[RELATIVE + (3 + l) * CAPACITY + i];
        double vz = t[RELATIVE + (6 + l) * CAPACITY + i];
        double dx = t[CENTRE + i];
        double dy = t[CENTRE + CAPACITY + i];
        double dz = t[CENTRE + 2 * CAPACITY + i];
        double ax = t[HALF_A + i];
        double ay = t[HALF_A + CAPACITY + i];
        double az = t[HALF_A + 2 * CAPACITY + i];
        double h1 = t[HALF_B + k * CAPACITY + i];
        double h2 = t[HALF_B + l * CAPACITY + i];
        edge(
                t,
                i,
                j,
                y * y + z * z,
                Math.abs(dz * y - dy * z)
                        - ay * Math.abs(z)
                        - az * Math.abs(y)
                        - h1 * Math.abs(uz * y - uy * z)
                        - h2 * Math.abs(vz * y - vy * z));
        edge(
                t,
                i,
                3 + j,
                x * x + z * z,
                Math.abs(dx * z - dz * x)
                        - ax * Math.abs(z)
                        - az * Math.abs(x)
                        - h1 * Math.abs(ux * z - uz * x)
                        - h2 * Math.abs(vx * z - vz * x));
        edge(
                t,
                i,
                6 + j,
                x * x + y * y,
                Math.abs(dy * x - dx * y)
                        - ax * Math.abs(y)
                        - ay * Math.abs(x)
                        - h1 * Math.abs(uy * x - ux * y)
                        - h2 * Math.abs(vy * x - vx * y));
    }

    private static void edge(double[] t, int i, int pair, double square, double along) {
        double s = along * Math.abs(along);
        if (square > BoxAxes.PARALLEL && s * t[SQUARE + i] > t[SIGNED_SQUARE + i] * square) {
            t[SEPARATION_EDGE + i] = along;
            t[SIGNED_SQUARE + i] = s;
            t[SQUARE + i] = square;
            t[EDGE + i] = pair;
        }
    }
}
