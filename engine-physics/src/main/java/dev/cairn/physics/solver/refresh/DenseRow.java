package dev.cairn.physics.solver.refresh;

import static dev.cairn.physics.solver.refresh.RefreshRow.GAPS;
import static dev.cairn.physics.solver.refresh.RefreshRow.LOADS;
import static dev.cairn.physics.solver.refresh.RefreshRow.NUMBERS;
import static dev.cairn.physics.solver.row.ConstraintRows.*;

import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.kernel.PrepareRow;
import dev.cairn.physics.solver.kernel.WarmStart;

import java.util.Arrays;

/**
 * One row whose fields lie together, in double, made from the points of now. The arithmetic is that
 * of {@link PrepareRow}, operation by operation.
 */
final class DenseRow {
    private static final int CENTRE = NUMBERS * ContactStore.POINTS;

    /** The row: a field after the other. */
    final double[] r = new double[FIELDS];

    /** The points of now: anchors of A and B, separation; then the centre of the patch. */
    final double[] at = new double[CENTRE + 6];

    /** How far the bodies have parted along the normal since the tick's start, m. */
    double moved(double[] s, int a, int b) {
        int i = a + SolverBodies.P;
        int k = b + SolverBodies.P;
        return r[0] * (s[k] - s[i]) + r[1] * (s[k + 1] - s[i + 1]) + r[2] * (s[k + 2] - s[i + 2]);
    }

    /** The centre of a patch of one point. */
    void centre(double shift) {
        r[REACH] = 0;
        for (int k = 0; k < 3; k++) {
            at[CENTRE + k] = at[k] - shift * r[k];
            at[CENTRE + 3 + k] = at[3 + k] + shift * r[k];
        }
    }

    /** The patch's centre. */
    void centre(int n, boolean fixed, boolean guided, double moved, double share) {
        int own = own();
        double spread = 0;
        double least = at[GAPS];
        for (int q = own + NUMBERS; q < NUMBERS * n; q += NUMBERS) {
            double x = at[q] - at[own];
            double y = at[q + 1] - at[own + 1];
            double z = at[q + 2] - at[own + 2];
            spread = Math.max(spread, x * x + y * y + z * z);
            least = Math.min(least, at[q - own + GAPS]);
        }
        double nearest = guided ? Math.max(0, least) : 0;
        double fade = PrepareRow.FADE * Math.sqrt(spread);
        double sum = 0;
        double shift = 0;
        double ax = 0;
        double ay = 0;
        double az = 0;
        double bx = 0;
        double by = 0;
        double bz = 0;
        for (int q = 0; q < NUMBERS * n; q += NUMBERS) {
            double gap = at[q + GAPS] + moved;
            double w = PrepareRow.weight(gap - nearest, fade);
            sum += w;
            shift += w * (0.5 * (fixed ? gap : 0));
            ax += w * at[q];
            ay += w * at[q + 1];
            az += w * at[q + 2];
            bx += w * at[q + 3];
            by += w * at[q + 4];
            bz += w * at[q + 5];
        }
        double one = 1 / sum;
        shift *= one;
        at[CENTRE] = ax * one;
        at[CENTRE + 1] = ay * one;
        at[CENTRE + 2] = az * one;
        at[CENTRE + 3] = bx * one;
        at[CENTRE + 4] = by * one;
        at[CENTRE + 5] = bz * one;
        reach(n, own, share);
        for (int k = 0; k < 3; k++) {
            at[CENTRE + k] -= shift * r[k];
            at[CENTRE + 3 + k] += shift * r[k];
        }
    }

    /**
     * On which body distances of points are measured: on one that moves, since the points of the
     * other stay where they were while it turns.
     */
    private int own() {
        return r[MASS_A] == 0 ? 3 : 0;
    }

    /** How far the points are from their middle. */
    private void reach(int n, int own, double share) {
        for (int i = 0; i < n; i++) {
            int q = NUMBERS * i + own;
            double x = at[q] - at[CENTRE + own];
            double y = at[q + 1] - at[CENTRE + own + 1];
            double z = at[q + 2] - at[CENTRE + own + 2];
            r[REACH + i] = Math.sqrt(x * x + y * y + z * z) * share;
        }
    }

    /**
     * Levers of one body: {@code L^T (r x u)} of the points and of the patch's centre, {@code L^T
     * n}; all zero for static bodies. One point has no twist.
     *
     * @param part 0 for A, 3 for B
     */
    void side(double[] root, int body, int part, int n, boolean hasFriction) {
        int k = (body >> 4) * SolverBodies.ROOT;
        int p = part;
        int q = POINT + (part == 0 ? ARM_A : ARM_B);
        int lever = LEVER + 2 * part;
        if (body == 0) {
            for (int i = 0; i < n; i++) {
                Arrays.fill(r, q + i * POINT_FIELDS, q + i * POINT_FIELDS + 3, 0.0);
            }
            Arrays.fill(r, lever, lever + 6, 0.0);
            Arrays.fill(r, TWIST + part, TWIST + part + 3, 0.0);
            return;
        }
        for (int i = 0; i < n; i++) {
            arm(root, k, p, 0, q);
            p += NUMBERS;
            q += POINT_FIELDS;
        }
        if (hasFriction) {
            arm(root, k, CENTRE + part, TANGENT1, lever);
            arm(root, k, CENTRE + part, TANGENT2, lever + 3);
        }
        if (hasFriction && n > 1) {
            weigh(root, k, r[0], r[1], r[2], TWIST + part);
        }
    }

    /** Writes {@code L^T (r x u)}, r at {@code at[p]}, u a field of the row. */
    private void arm(double[] root, int k, int p, int u, int out) {
        double rx = at[p];
        double ry = at[p + 1];
        double rz = at[p + 2];
        double ux = r[u];
        double uy = r[u + 1];
        double uz = r[u + 2];
        weigh(root, k, ry * uz - rz * uy, rz * ux - rx * uz, rx * uy - ry * ux, out);
    }

    /** Writes {@code L^T v}. */
    private void weigh(double[] root, int k, double x, double y, double z, int out) {
        r[out] = root[k] * x + root[k + 3] * y + root[k + 6] * z;
        r[out + 1] = root[k + 1] * x + root[k + 4] * y + root[k + 7] * z;
        r[out + 2] = root[k + 2] * x + root[k + 5] * y + root[k + 8] * z;
    }

    void points(double[] record, int k, int n, double masses, double stiffness, boolean settles) {
        for (int i = 0; i < n; i++) {
            int q = POINT + i * POINT_FIELDS;
            double w = masses + (dot(q + ARM_A, q + ARM_A) + dot(q + ARM_B, q + ARM_B));
            double mass = w > 0 ? 1 / w : 0;
            double stiff = mass * stiffness;
            double known = settles ? 0 : record[k + RefreshRow.POINTS + NUMBERS * i + LOADS];
            double gap = at[NUMBERS * i + GAPS] - (stiff > 0 ? known / stiff : 0);
            r[q + MASS] = mass;
            r[q + SEPARATION] = gap;
            r[GAP + i] = gap;
        }
    }

    /** Tangent block and twist at the patch's centre. */
    void block(double masses, boolean wide) {
        int b = LEVER + 6;
        double k11 = masses + dot(LEVER, LEVER) + dot(b, b);
        double k22 = masses + dot(LEVER + 3, LEVER + 3) + dot(b + 3, b + 3);
        double k12 = dot(LEVER, LEVER + 3) + dot(b, b + 3);
        double det = 1 / (k11 * k22 - k12 * k12);
        r[BLOCK] = k22 * det;
        r[BLOCK + 1] = -k12 * det;
        r[BLOCK + 2] = k11 * det;
        double twist = wide ? dot(TWIST, TWIST) + dot(TWIST + 3, TWIST + 3) : 0;
        r[TWIST_MASS] = twist > 0 ? 1 / twist : 0;
    }

    private double dot(int i, int j) {
        return r[i] * r[j] + r[i + 1] * r[j + 1] + r[i + 2] * r[j + 2];
    }

    /**
     * Adds the impulses to the warm start of a body, see {@link WarmStart}.
     *
     * @param sign -1 for A, 1 for B; the other way round takes them out
     * @param part 0 for A, 3 for B
     */
    void warm(double[] warm, int body, double sign, int part, int n, boolean hasFriction) {
        if (body == 0) {
            return;
        }
        int w = body >> 1;
        double m = r[part == 0 ? MASS_A : MASS_B];
        double x = warm[w + 3];
        double y = warm[w + 4];
        double z = warm[w + 5];
        double sum = 0;
        for (int q = POINT + part; q < POINT + n * POINT_FIELDS; q += POINT_FIELDS) {
            double impulse = sign * r[q - part + IMPULSE];
            x += impulse * r[q];
            y += impulse * r[q + 1];
            z += impulse * r[q + 2];
            sum += impulse;
        }
        double f = m * sum;
        double f1 = hasFriction ? sign * r[LAMBDA] : 0;
        double f2 = hasFriction ? sign * r[LAMBDA + 1] : 0;
        double f3 = hasFriction ? sign * r[LAMBDA + 2] : 0;
        double g1 = m * f1;
        double g2 = m * f2;
        // zeros leave positive
        for (int k = 0; k < 3; k++) {
            double v = warm[w + k] + f * r[k] + 0.0;
            warm[w + k] = hasFriction ? v + g1 * r[TANGENT1 + k] + g2 * r[TANGENT2 + k] : v;
        }
        x += 0.0;
        y += 0.0;
        z += 0.0;
        if (hasFriction) {
            int lever = LEVER + 2 * part;
            int t = TWIST + part;
            x = x + f1 * r[lever] + f2 * r[lever + 3] + f3 * r[t];
            y = y + f1 * r[lever + 1] + f2 * r[lever + 4] + f3 * r[t + 1];
            z = z + f1 * r[lever + 2] + f2 * r[lever + 5] + f3 * r[t + 2];
        }
        warm[w + 3] = x;
        warm[w + 4] = y;
        warm[w + 5] = z;
    }
}
