package dev.cairn.physics.solver;

import static dev.cairn.physics.solver.ConstraintRows.ARM_A;
import static dev.cairn.physics.solver.ConstraintRows.ARM_B;
import static dev.cairn.physics.solver.ConstraintRows.BLOCK;
import static dev.cairn.physics.solver.ConstraintRows.FIELDS;
import static dev.cairn.physics.solver.ConstraintRows.FRICTION;
import static dev.cairn.physics.solver.ConstraintRows.GAP;
import static dev.cairn.physics.solver.ConstraintRows.IMPULSE;
import static dev.cairn.physics.solver.ConstraintRows.LAMBDA;
import static dev.cairn.physics.solver.ConstraintRows.LEVER;
import static dev.cairn.physics.solver.ConstraintRows.LINK;
import static dev.cairn.physics.solver.ConstraintRows.MASS;
import static dev.cairn.physics.solver.ConstraintRows.MASS_A;
import static dev.cairn.physics.solver.ConstraintRows.MASS_B;
import static dev.cairn.physics.solver.ConstraintRows.POINT;
import static dev.cairn.physics.solver.ConstraintRows.POINT_FIELDS;
import static dev.cairn.physics.solver.ConstraintRows.REACH;
import static dev.cairn.physics.solver.ConstraintRows.SEPARATION;
import static dev.cairn.physics.solver.ConstraintRows.TANGENT1;
import static dev.cairn.physics.solver.ConstraintRows.TANGENT2;
import static dev.cairn.physics.solver.ConstraintRows.TWIST;
import static dev.cairn.physics.solver.ConstraintRows.TWIST_MASS;

import dev.cairn.physics.internal.ContactStore;

import java.util.Arrays;

/**
 * Fills one row anew within a tick, when its levers have moved: impulses and totals stay, and the
 * impulses are added to the bodies' warm start.
 *
 * <p>Problem: in a heap that moves most rows are renewed in each sub-step, and the fields of a row
 * lie in as many cache lines. So what is read is what the row alone knows, its impulses; all is
 * made in a row that lies together, in double, and only what can have changed is written back. The
 * arithmetic is that of {@link PrepareRow}, operation by operation.
 *
 * <p>One thread at a time. Allocates when it is made.
 */
final class RenewRow {
    /** The row: a field after the other. */
    private final double[] r = new double[FIELDS];

    /** Where the centre of the patch is from A and from B. */
    private final double[] centre = new double[6];

    /**
     * Fills the row at place {@code j} of contact {@code source}, whose anchors and separations are
     * those of now.
     *
     * @param tangent holds the tangents, six numbers from {@code at} on
     * @param turned whether they are others than the row's
     * @param preloadScale of the tick's start
     */
    void run(
            ConstraintRows rows,
            SolverBodies bodies,
            ContactStore c,
            int j,
            int source,
            double[] tangent,
            int at,
            boolean turned,
            SubStep sub,
            double preloadScale) {
        int a = rows.link[j * LINK];
        int b = rows.link[j * LINK + 1];
        int n = c.pointCount[source];
        double ma = bodies.state[a + SolverBodies.MASS];
        double mb = bodies.state[b + SolverBodies.MASS];
        boolean fixed = ma == 0 || mb == 0;
        boolean rough = c.friction(source) > 0;
        r[0] = c.normalX(source);
        r[1] = c.normalY(source);
        r[2] = c.normalZ(source);
        r[MASS_A] = ma;
        r[MASS_B] = mb;
        for (int k = 0; k < 6; k++) {
            r[TANGENT1 + k] = tangent[at + k];
        }
        if (rough && n == 1) {
            centre(c, source, fixed ? 0.5 * c.separation[ContactStore.POINTS * source] : 0);
        } else if (rough) {
            centre(c, source, n, fixed, fixed ? 0 : moved(bodies.state, a, b));
        }
        side(bodies.root, a, c, source, 0, n, rough);
        side(bodies.root, b, c, source, 3, n, rough);
        for (int i = 0; i < n; i++) {
            c.preload[ContactStore.POINTS * source + i] *= preloadScale;
        }
        points(c, source, n, ma + mb, sub.stiffness(fixed), rows.unloaded[j] != 0);
        if (rough) {
            block(ma + mb, n > 1);
        }
        read(rows, rows.base(j), n, rough);
        write(rows, rows.base(j), a, b, n, rough, turned);
        warm(bodies.warm, a, b, n, rough);
    }

    /** Writes what can have changed. */
    private void write(
            ConstraintRows rows, int o, int a, int b, int n, boolean rough, boolean turned) {
        for (int i = 0; i < n; i++) {
            int q = POINT + i * POINT_FIELDS;
            // what does not move has no lever
            write(rows, o, a == 0 ? q + ARM_B : q, b == 0 ? 3 : a == 0 ? 4 : 7);
            if (b == 0) {
                write(rows, o, q + MASS, 1);
            }
            write(rows, o, q + SEPARATION, 1);
        }
        write(rows, o, GAP, n);
        if (!rough) {
            return;
        }
        if (turned) {
            write(rows, o, TANGENT1, 6);
        }
        write(rows, o, BLOCK, 3);
        write(rows, o, a == 0 ? LEVER + 6 : LEVER, a == 0 || b == 0 ? 6 : 12);
        write(rows, o, REACH, n);
        if (n > 1) {
            write(rows, o, LAMBDA + 2, 2);
            write(rows, o, a == 0 ? TWIST + 3 : TWIST, a == 0 || b == 0 ? 3 : 6);
        }
    }

    /** How far the bodies have parted along the normal since the tick's start, m. */
    private double moved(double[] s, int a, int b) {
        int i = a + SolverBodies.P;
        int k = b + SolverBodies.P;
        return r[0] * (s[k] - s[i]) + r[1] * (s[k + 1] - s[i + 1]) + r[2] * (s[k + 2] - s[i + 2]);
    }

    /** The same of one point. */
    private void centre(ContactStore c, int source, double shift) {
        int p = ContactStore.anchor(ContactStore.POINTS * source);
        for (int k = 0; k < 3; k++) {
            centre[k] = c.anchors[p + k] - shift * r[k];
            centre[3 + k] = c.anchors[p + 3 + k] + shift * r[k];
        }
        reach(c, source, p, 1);
    }

    /** The patch's centre and how far its points are from it. */
    private void centre(ContactStore c, int source, int n, boolean fixed, double moved) {
        int first = ContactStore.POINTS * source;
        double[] at = c.anchors;
        int k = ContactStore.anchor(first);
        double spread = 0;
        for (int i = 1; i < n; i++) {
            int p = k + i * ContactStore.ANCHORS;
            double x = at[p] - at[k];
            double y = at[p + 1] - at[k + 1];
            double z = at[p + 2] - at[k + 2];
            spread = Math.max(spread, x * x + y * y + z * z);
        }
        double fade = PrepareRow.FADE * Math.sqrt(spread);
        double sum = 0;
        double shift = 0;
        double ax = 0;
        double ay = 0;
        double az = 0;
        double bx = 0;
        double by = 0;
        double bz = 0;
        for (int i = 0; i < n; i++) {
            int p = k + i * ContactStore.ANCHORS;
            double gap = c.separation[first + i] + moved;
            double w = gap <= fade || fade == 0 ? 1 : Math.max(2 - gap / fade, 1e-10);
            sum += w;
            shift += w * (0.5 * (fixed ? gap : 0));
            ax += w * at[p];
            ay += w * at[p + 1];
            az += w * at[p + 2];
            bx += w * at[p + 3];
            by += w * at[p + 4];
            bz += w * at[p + 5];
        }
        double one = 1 / sum;
        shift *= one;
        centre[0] = ax * one - shift * r[0];
        centre[1] = ay * one - shift * r[1];
        centre[2] = az * one - shift * r[2];
        centre[3] = bx * one + shift * r[0];
        centre[4] = by * one + shift * r[1];
        centre[5] = bz * one + shift * r[2];
        reach(c, source, k, n);
    }

    private void reach(ContactStore c, int source, int k, int n) {
        double share = PrepareRow.share(c, source);
        for (int i = 0; i < n; i++) {
            int p = k + i * ContactStore.ANCHORS;
            double x = c.anchors[p] - centre[0];
            double y = c.anchors[p + 1] - centre[1];
            double z = c.anchors[p + 2] - centre[2];
            r[REACH + i] = Math.sqrt(x * x + y * y + z * z) * share;
        }
    }

    /**
     * Levers of one body: {@code L^T (r x u)} of the points and of the patch's centre, {@code L^T
     * n}; all zero for what does not move. One point has no twist.
     *
     * @param part 0 for A, 3 for B
     */
    private void side(
            double[] root, int body, ContactStore c, int source, int part, int n, boolean rough) {
        int k = (body >> 4) * SolverBodies.ROOT;
        int p = ContactStore.anchor(ContactStore.POINTS * source) + part;
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
            arm(root, k, c.anchors, p, 0, q);
            p += ContactStore.ANCHORS;
            q += POINT_FIELDS;
        }
        if (rough) {
            arm(root, k, centre, part, TANGENT1, lever);
            arm(root, k, centre, part, TANGENT2, lever + 3);
        }
        if (rough && n > 1) {
            weigh(root, k, r[0], r[1], r[2], TWIST + part);
        }
    }

    /** Writes {@code L^T (r x u)}, r at {@code at[p]}, u a field of the row. */
    private void arm(double[] root, int k, double[] at, int p, int u, int out) {
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

    private void points(
            ContactStore c, int source, int n, double masses, double stiffness, boolean unloaded) {
        int p = ContactStore.POINTS * source;
        for (int i = 0; i < n; i++, p++) {
            int q = POINT + i * POINT_FIELDS;
            double w = masses + (dot(q + ARM_A, q + ARM_A) + dot(q + ARM_B, q + ARM_B));
            double mass = w > 0 ? 1 / w : 0;
            double k = mass * stiffness;
            double known = unloaded ? 0 : c.preload[p];
            double gap = c.separation[p] - (k > 0 ? known / k : 0);
            r[q + MASS] = mass;
            r[q + SEPARATION] = gap;
            r[GAP + i] = gap;
        }
    }

    /** Tangent block and twist at the patch's centre. */
    private void block(double masses, boolean wide) {
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

    private void read(ConstraintRows rows, int o, int n, boolean rough) {
        for (int i = 0; i < n; i++) {
            copy(rows, o, POINT + i * POINT_FIELDS + IMPULSE, 1);
        }
        if (rough) {
            copy(rows, o, LAMBDA, 3);
            r[LAMBDA + 2] = r[TWIST_MASS] > 0 ? r[LAMBDA + 2] : 0;
        }
    }

    private void write(ConstraintRows rows, int o, int field, int count) {
        int lanes = rows.lanes;
        if (rows.isSingle) {
            float[] f = rows.floats;
            for (int k = field; k < field + count; k++) {
                f[o + k * lanes] = (float) r[k];
            }
        } else {
            double[] d = rows.doubles;
            for (int k = field; k < field + count; k++) {
                d[o + k * lanes] = r[k];
            }
        }
    }

    /** Adds the impulses to the bodies' warm start, see {@link WarmStart}. */
    private void warm(double[] warm, int a, int b, int n, boolean rough) {
        double sum = 0;
        for (int i = 0; i < n; i++) {
            int q = POINT + i * POINT_FIELDS;
            double impulse = r[q + IMPULSE];
            if (impulse != 0) {
                WarmStart.turn(warm, a, b, r, q + ARM_A, q + ARM_B, 1, impulse);
                sum += impulse;
            }
        }
        double ma = r[MASS_A];
        double mb = r[MASS_B];
        if (sum != 0) {
            WarmStart.push(warm, a, b, ma * sum, mb * sum, r[0], r[1], r[2]);
        }
        WarmStart.positive(warm, a);
        WarmStart.positive(warm, b);
        if (rough) {
            rub(warm, a, b, 1);
        }
    }

    /** What the friction of the row does, times {@code sign}. */
    private void rub(double[] warm, int a, int b, double sign) {
        double f1 = sign * r[LAMBDA];
        double f2 = sign * r[LAMBDA + 1];
        double f3 = sign * r[LAMBDA + 2];
        if (f1 == 0 && f2 == 0 && f3 == 0) {
            return;
        }
        double ma = r[MASS_A];
        double mb = r[MASS_B];
        int t = TANGENT1;
        WarmStart.push(warm, a, b, ma * f1, mb * f1, r[t], r[t + 1], r[t + 2]);
        t = TANGENT2;
        WarmStart.push(warm, a, b, ma * f2, mb * f2, r[t], r[t + 1], r[t + 2]);
        WarmStart.turn(warm, a, b, r, LEVER, LEVER + 6, 1, f1);
        WarmStart.turn(warm, a, b, r, LEVER + 3, LEVER + 9, 1, f2);
        WarmStart.turn(warm, a, b, r, TWIST, TWIST + 3, 1, f3);
    }

    /** Takes the impulses of the row at place {@code j} out of its bodies' warm start. */
    void takeOut(ConstraintRows rows, double[] warm, int j) {
        int a = rows.link[j * LINK];
        int b = rows.link[j * LINK + 1];
        int o = rows.base(j);
        int lanes = rows.lanes;
        copy(rows, o, 0, 3);
        copy(rows, o, MASS_A, 2);
        double sum = 0;
        for (int i = 0; i < rows.points(j); i++) {
            int q = POINT + i * POINT_FIELDS;
            double impulse = -rows.get(o + (q + IMPULSE) * lanes);
            if (impulse != 0) {
                copy(rows, o, q, ARM_B + 3);
                WarmStart.turn(warm, a, b, r, q + ARM_A, q + ARM_B, 1, impulse);
                sum += impulse;
            }
        }
        if (sum != 0) {
            double ma = r[MASS_A] * sum;
            double mb = r[MASS_B] * sum;
            WarmStart.push(warm, a, b, ma, mb, r[0], r[1], r[2]);
        }
        if (rows.get(o + FRICTION * lanes) > 0) {
            copy(rows, o, LAMBDA, 3);
            if (r[LAMBDA] != 0 || r[LAMBDA + 1] != 0 || r[LAMBDA + 2] != 0) {
                copy(rows, o, TANGENT1, 6);
                copy(rows, o, LEVER, TWIST + 6 - LEVER);
                rub(warm, a, b, -1);
            }
        }
    }

    private void copy(ConstraintRows rows, int o, int field, int count) {
        int lanes = rows.lanes;
        if (rows.isSingle) {
            float[] f = rows.floats;
            for (int k = field; k < field + count; k++) {
                r[k] = f[o + k * lanes];
            }
        } else {
            double[] d = rows.doubles;
            for (int k = field; k < field + count; k++) {
                r[k] = d[o + k * lanes];
            }
        }
    }
}
