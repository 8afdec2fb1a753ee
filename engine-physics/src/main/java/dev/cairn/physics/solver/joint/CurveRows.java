package dev.cairn.physics.solver.joint;

import dev.cairn.physics.internal.Curve;
import dev.cairn.physics.internal.JointStore;

/**
 * Rows of a joint whose B slides on a curve that is fixed in A's frame.
 *
 * <p>With r the nearest point of the curve to B's origin p, t its direction, and n, {@code t × n}
 * at right angles to that, the two rows of the path measure
 *
 * <pre>
 * c = n (p - r),    c' = n p'   where p is on the curve
 * </pre>
 *
 * <p>and the row along it the length of the curve up to r, which changes by {@code t p'}. The force
 * acts at p on both bodies.
 *
 * <p>The nearest point is sought from where it was, so that a curve may cross itself, and n is what
 * it was, without its part along t: so it never flips. Both are kept in {@link
 * JointStore#parameter}: the parameter on the curve, then n in A's frame. Source of the second: R.
 * L. Bishop, "There is more than one way to frame a curve" (1975).
 */
final class CurveRows {
    private final double[] at = new double[Curve.AT];
    private double w;

    /** Tangent and the two normals, in A's frame. */
    private final double[] t = new double[3];

    private final double[] n = new double[3];
    private final double[] o = new double[3];
    private final double[] p = new double[3];

    /** Finds the nearest point, after {@link JointMath#look}. */
    private Curve look(JointMath m, JointStore s, int j) {
        Curve curve = s.curve[j];
        if (curve == null) {
            throw new IllegalStateException("joint " + j + " has a row along a path, and no path");
        }
        int q = JointStore.PARAMETERS * j;
        for (int k = 0; k < 3; k++) {
            p[k] =
                    m.gap[0] * m.axesA[3 * k]
                            + m.gap[1] * m.axesA[3 * k + 1]
                            + m.gap[2] * m.axesA[3 * k + 2];
            n[k] = s.parameter[q + 1 + k];
        }
        w = curve.follow(p[0], p[1], p[2], s.parameter[q], at);
        double length = Math.sqrt(at[3] * at[3] + at[4] * at[4] + at[5] * at[5]);
        for (int k = 0; k < 3; k++) {
            t[k] = at[3 + k] / length;
        }
        square(n, t);
        o[0] = t[1] * n[2] - t[2] * n[1];
        o[1] = t[2] * n[0] - t[0] * n[2];
        o[2] = t[0] * n[1] - t[1] * n[0];
        return curve;
    }

    /** Takes the part along t from n; another direction if nothing is left. */
    private static void square(double[] n, double[] t) {
        for (int round = 0; round < 2; round++) {
            double dot = n[0] * t[0] + n[1] * t[1] + n[2] * t[2];
            double x = n[0] - dot * t[0];
            double y = n[1] - dot * t[1];
            double z = n[2] - dot * t[2];
            double length = Math.sqrt(x * x + y * y + z * z);
            if (length > 1e-3 || round == 1) {
                n[0] = x / length;
                n[1] = y / length;
                n[2] = z / length;
                return;
            }
            boolean isX = Math.abs(t[0]) <= Math.abs(t[1]) && Math.abs(t[0]) <= Math.abs(t[2]);
            boolean isY = !isX && Math.abs(t[1]) <= Math.abs(t[2]);
            n[0] = isX ? 1 : 0;
            n[1] = isY ? 1 : 0;
            n[2] = isX || isY ? 0 : 1;
        }
    }

    /** A sub-step begins: the next search begins here. */
    void advance(JointMath m, JointStore s, int j) {
        if (s.curve[j] == null) {
            return;
        }
        look(m, s, j);
        int q = JointStore.PARAMETERS * j;
        s.parameter[q] = w;
        System.arraycopy(n, 0, s.parameter, q + 1, 3);
    }

    double measure(JointMath m, JointStore s, int j, int law) {
        Curve curve = look(m, s, j);
        if (law == JointStore.ALONG) {
            return curve.along(w);
        }
        double[] e = law == JointStore.PATH ? n : o;
        return e[0] * (p[0] - at[0]) + e[1] * (p[1] - at[1]) + e[2] * (p[2] - at[2]);
    }

    /** Direction of a row's force, world. */
    void direction(JointMath m, JointStore s, int j, int law, double[] into) {
        look(m, s, j);
        double[] e = law == JointStore.ALONG ? t : law == JointStore.PATH ? n : o;
        for (int k = 0; k < 3; k++) {
            into[k] = e[0] * m.axesA[k] + e[1] * m.axesA[3 + k] + e[2] * m.axesA[6 + k];
        }
    }
}
