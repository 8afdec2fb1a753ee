package dev.cairn.physics.narrowphase.wide;

import static dev.cairn.physics.narrowphase.wide.BoxBatch.*;

/**
 * The twin of {@link BoxFacesWide} without the Vector API: one pair after another, the same
 * operations in the same order, hence the same bits.
 */
final class BoxFacesScalar {
    private BoxFacesScalar() {}

    /** Fills the columns from ROWS to CORNER; reads FLIP, AXIS and SIGN. */
    static void corners(double[] t, int i) {
        boolean flip = t[FLIP + i] > 0;
        int axis = (int) t[AXIS + i];
        int low = axis == 0 ? 1 : 0;
        int high = axis == 2 ? 1 : 2;
        row(t, i, flip, axis, 0);
        row(t, i, flip, low, 1);
        row(t, i, flip, high, 2);
        double sx = Math.abs(t[ROWS + i]);
        double sy = Math.abs(t[ROWS + CAPACITY + i]);
        double sz = Math.abs(t[ROWS + 2 * CAPACITY + i]);
        int along = sx >= sy && sx >= sz ? 0 : sy >= sz ? 1 : 2;
        boolean odd = t[ROWS + along * CAPACITY + i] * t[SIGN + i] < 0;
        t[INCIDENT + i] = 2 * along + (odd ? 1 : 0);
        int half = (flip ? HALF_A : HALF_B) + i;
        for (int corner = 0; corner < 4; corner++) {
            // Bits of the corner are the signs on the axes beside the face's own.
            boolean first = (corner & 1) != 0;
            boolean second = (corner & 2) != 0;
            double x = place(t, half, along == 0 ? odd : first);
            double y = place(t, half + CAPACITY, along == 1 ? odd : along == 0 ? first : second);
            double z = place(t, half + 2 * CAPACITY, along == 2 ? odd : second);
            if (flip) {
                x -= t[CENTRE + i];
                y -= t[CENTRE + CAPACITY + i];
                z -= t[CENTRE + 2 * CAPACITY + i];
            }
            for (int r = 0; r < 3; r++) {
                int k = r == 0 ? axis : r == 1 ? low : high;
                int at = ROWS + 3 * r * CAPACITY + i;
                double p = t[at] * x + t[at + CAPACITY] * y + t[at + 2 * CAPACITY] * z;
                t[CORNER + POINT * corner + r * CAPACITY + i] =
                        flip ? p : p + t[CENTRE + k * CAPACITY + i];
            }
        }
        outside(t, i, CORNER + CAPACITY, HALF + CAPACITY, OUTSIDE);
        outside(t, i, CORNER + 2 * CAPACITY, HALF + 2 * CAPACITY, OUTSIDE + 2 * CAPACITY);
        t[ALIGNED + i] = -1;
    }

    /** A row of the rotation from the other box to the face's box, and that one's half extent. */
    private static void row(double[] t, int i, boolean flip, int axis, int r) {
        for (int c = 0; c < 3; c++) {
            t[ROWS + (3 * r + c) * CAPACITY + i] =
                    t[RELATIVE + (flip ? 3 * c + axis : 3 * axis + c) * CAPACITY + i];
        }
        t[HALF + r * CAPACITY + i] = t[(flip ? HALF_B : HALF_A) + axis * CAPACITY + i];
    }

    private static double place(double[] t, int half, boolean isHigh) {
        return isHigh ? t[half] : -t[half];
    }

    /** How far the outermost corners are beyond the sides on either of the two axes. */
    private static void outside(double[] t, int i, int corner, int half, int sides) {
        double high = t[corner + i];
        double below = high;
        for (int p = 1; p < 4; p++) {
            double at = t[corner + p * POINT + i];
            high = at > high ? at : high;
            below = at < below ? at : below;
        }
        t[sides + i] = high - t[half + i];
        t[sides + CAPACITY + i] = -below - t[half + i];
    }

    /** Turns points in CORNER into world axes and writes NORMAL. */
    static void world(double[] t, int i, int points) {
        boolean flip = t[FLIP + i] > 0;
        int axis = (int) t[AXIS + i];
        double sign = t[SIGN + i];
        double x = flip ? -sign * t[ROWS + i] : axis == 0 ? sign : 0;
        double y = flip ? -sign * t[ROWS + CAPACITY + i] : axis == 1 ? sign : 0;
        double z = flip ? -sign * t[ROWS + 2 * CAPACITY + i] : axis == 2 ? sign : 0;
        turn(t, i, x, y, z, NORMAL + i);
        for (int p = 0; p < points; p++) {
            int at = CORNER + POINT * p + i;
            double n = t[at];
            double u = t[at + CAPACITY];
            double v = t[at + 2 * CAPACITY];
            x = axis == 0 ? n : u;
            y = axis == 0 ? u : axis == 1 ? n : v;
            z = axis == 2 ? n : v;
            if (flip) {
                int r = RELATIVE + i;
                double ax =
                        t[r] * x + t[r + CAPACITY] * y + t[r + 2 * CAPACITY] * z + t[CENTRE + i];
                double ay =
                        t[r + 3 * CAPACITY] * x
                                + t[r + 4 * CAPACITY] * y
                                + t[r + 5 * CAPACITY] * z
                                + t[CENTRE + CAPACITY + i];
                z =
                        t[r + 6 * CAPACITY] * x
                                + t[r + 7 * CAPACITY] * y
                                + t[r + 8 * CAPACITY] * z
                                + t[CENTRE + 2 * CAPACITY + i];
                x = ax;
                y = ay;
            }
            turn(t, i, x, y, z, at);
        }
    }

    /** From A's axes into the world's. */
    private static void turn(double[] t, int i, double x, double y, double z, int to) {
        for (int k = 0; k < 3; k++) {
            int w = WORLD + 3 * k * CAPACITY + i;
            t[to + k * CAPACITY] = t[w] * x + t[w + CAPACITY] * y + t[w + 2 * CAPACITY] * z;
        }
    }
}
