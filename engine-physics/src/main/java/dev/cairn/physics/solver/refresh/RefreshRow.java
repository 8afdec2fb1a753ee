package dev.cairn.physics.solver.refresh;

import static dev.cairn.physics.solver.row.ConstraintRows.ARM_A;
import static dev.cairn.physics.solver.row.ConstraintRows.ARM_B;
import static dev.cairn.physics.solver.row.ConstraintRows.BLOCK;
import static dev.cairn.physics.solver.row.ConstraintRows.FIELDS;
import static dev.cairn.physics.solver.row.ConstraintRows.FRICTION;
import static dev.cairn.physics.solver.row.ConstraintRows.GAP;
import static dev.cairn.physics.solver.row.ConstraintRows.IMPULSE;
import static dev.cairn.physics.solver.row.ConstraintRows.LAMBDA;
import static dev.cairn.physics.solver.row.ConstraintRows.LEVER;
import static dev.cairn.physics.solver.row.ConstraintRows.LINK;
import static dev.cairn.physics.solver.row.ConstraintRows.MASS;
import static dev.cairn.physics.solver.row.ConstraintRows.MASS_A;
import static dev.cairn.physics.solver.row.ConstraintRows.MASS_B;
import static dev.cairn.physics.solver.row.ConstraintRows.POINT;
import static dev.cairn.physics.solver.row.ConstraintRows.POINT_FIELDS;
import static dev.cairn.physics.solver.row.ConstraintRows.REACH;
import static dev.cairn.physics.solver.row.ConstraintRows.SEPARATION;
import static dev.cairn.physics.solver.row.ConstraintRows.TANGENT1;
import static dev.cairn.physics.solver.row.ConstraintRows.TANGENT2;
import static dev.cairn.physics.solver.row.ConstraintRows.TWIST;
import static dev.cairn.physics.solver.row.ConstraintRows.TWIST_MASS;

import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.kernel.PrepareRow;
import dev.cairn.physics.solver.kernel.WarmStart;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.SubStep;

import java.util.Arrays;

/**
 * Fills one row anew within a tick, when its levers have moved: impulses and totals stay, and the
 * impulses are added to the bodies' warm start.
 *
 * <p>Problem: in a heap that moves most rows are renewed in each sub-step; the fields of a row lie
 * in as many cache lines, and contacts lie in another order than rows. So what the contact knows is
 * kept in a record of the row, all is made in a row that lies together, in double, and only what
 * can have changed is written back. The arithmetic is that of {@link PrepareRow}, operation by
 * operation.
 *
 * <p>One thread at a time. Allocates when it is made.
 */
public final class RefreshRow {
    /** A record: unit normal, tangents, see {@link #SHARE}, points. */
    static final int RECORD = 10 + 8 * ContactStore.POINTS;

    static final int TANGENTS = 3;

    /** How far from the patch's middle a point rubs, over its own distance; -1: no friction. */
    static final int SHARE = 9;

    /** Start of the points, {@link #NUMBERS} each: anchors of A and B, then these. */
    static final int POINTS = 10;

    static final int NUMBERS = 8;

    /** Of a point: its separation, m; the load that its contact knows. */
    static final int GAPS = 6;

    static final int LOADS = 7;

    /** The row: a field after the other. */
    private final double[] r = new double[FIELDS];

    /** The points of now: anchors of A and B, separation; then the centre of the patch. */
    private final double[] at = new double[NUMBERS * ContactStore.POINTS + 6];

    private static final int CENTRE = NUMBERS * ContactStore.POINTS;

    /** Writes the record of a contact. */
    static void keep(ContactStore c, int source, double[] record, int k) {
        aim(c, source, record, k);
        record[k + SHARE] = c.friction(source) > 0 ? PrepareRow.share(c, source) : -1;
        int first = ContactStore.POINTS * source;
        int q = k + POINTS;
        for (int p = first; p < first + c.pointCount[source]; p++, q += NUMBERS) {
            System.arraycopy(c.anchors, ContactStore.anchor(p), record, q, ContactStore.ANCHORS);
            record[q + GAPS] = c.separation[p];
            record[q + LOADS] = c.preload[p];
        }
    }

    /** Writes the normal of a contact to its record, and tangents. */
    static void aim(ContactStore c, int source, double[] record, int k) {
        double x = c.normalX(source);
        double y = c.normalY(source);
        double z = c.normalZ(source);
        record[k] = x;
        record[k + 1] = y;
        record[k + 2] = z;
        PrepareRow.tangents(record, k + TANGENTS - TANGENT1, 1, x, y, z);
    }

    /**
     * Moves the points with their bodies.
     *
     * @param turn turns of bodies since the tick's start, nine numbers each
     * @param ra where the turn of A is, if its points turn, else -1
     * @param rb the same of B
     * @param shareA share of the way between the points of two bodies that A's goes to B's
     */
    void place(
            ConstraintRows rows,
            double[] state,
            int j,
            double[] record,
            int k,
            double[] turn,
            int ra,
            int rb,
            double shareA,
            double shareB) {
        int pa = rows.link[j * LINK] + SolverBodies.P;
        int pb = rows.link[j * LINK + 1] + SolverBodies.P;
        double mx = state[pb] - state[pa];
        double my = state[pb + 1] - state[pa + 1];
        double mz = state[pb + 2] - state[pa + 2];
        double nx = record[k];
        double ny = record[k + 1];
        double nz = record[k + 2];
        int n = rows.points(j);
        int q = k + POINTS;
        for (int i = 0; i < NUMBERS * n; i += NUMBERS, q += NUMBERS) {
            turn(turn, ra, record, q, i);
            turn(turn, rb, record, q + 3, i + 3);
            double dx = (at[i + 3] - record[q + 3]) - (at[i] - record[q]);
            double dy = (at[i + 4] - record[q + 4]) - (at[i + 1] - record[q + 1]);
            double dz = (at[i + 5] - record[q + 5]) - (at[i + 2] - record[q + 2]);
            at[i + GAPS] = record[q + GAPS] + (dx * nx + dy * ny + dz * nz);
            dx += mx;
            dy += my;
            dz += mz;
            at[i] += shareA * dx;
            at[i + 1] += shareA * dy;
            at[i + 2] += shareA * dz;
            at[i + 3] -= shareB * dx;
            at[i + 4] -= shareB * dy;
            at[i + 5] -= shareB * dz;
        }
    }

    /** Turns a vector of the record, if there is a turn. */
    private void turn(double[] turn, int m, double[] record, int q, int out) {
        double x = record[q];
        double y = record[q + 1];
        double z = record[q + 2];
        if (m < 0) {
            at[out] = x;
            at[out + 1] = y;
            at[out + 2] = z;
            return;
        }
        at[out] = turn[m] * x + turn[m + 1] * y + turn[m + 2] * z;
        at[out + 1] = turn[m + 3] * x + turn[m + 4] * y + turn[m + 5] * z;
        at[out + 2] = turn[m + 6] * x + turn[m + 7] * y + turn[m + 8] * z;
    }

    /** Writes where the points are now to a contact. */
    void tell(ContactStore c, int source, boolean anchors) {
        int first = ContactStore.POINTS * source;
        for (int i = 0; i < c.pointCount[source]; i++) {
            int q = NUMBERS * i;
            c.separation[first + i] = at[q + GAPS];
            if (anchors) {
                int p = ContactStore.anchor(first + i);
                System.arraycopy(at, q, c.anchors, p, ContactStore.ANCHORS);
            }
        }
    }

    /**
     * Fills the row at place {@code j} for the points of now.
     *
     * @param record of the row, from {@code k} on
     * @param turned whether the tangents are others than the row's
     */
    void fill(
            ConstraintRows rows,
            SolverBodies bodies,
            int j,
            double[] record,
            int k,
            boolean turned,
            SubStep sub) {
        int a = rows.link[j * LINK];
        int b = rows.link[j * LINK + 1];
        int n = rows.points(j);
        double ma = bodies.state[a + SolverBodies.MASS];
        double mb = bodies.state[b + SolverBodies.MASS];
        boolean fixed = ma == 0 || mb == 0;
        double share = record[k + SHARE];
        boolean rough = share >= 0;
        for (int i = 0; i < 3; i++) {
            r[i] = record[k + i];
            r[TANGENT1 + i] = record[k + TANGENTS + i];
            r[TANGENT2 + i] = record[k + TANGENTS + 3 + i];
        }
        r[MASS_A] = ma;
        r[MASS_B] = mb;
        if (rough && n == 1) {
            centre(fixed ? 0.5 * at[GAPS] : 0);
        } else if (rough) {
            centre(n, fixed, fixed ? 0 : moved(bodies.state, a, b));
        }
        side(bodies.root, a, 0, n, rough);
        side(bodies.root, b, 3, n, rough);
        points(record, k, n, ma + mb, sub.stiffness(fixed), rows.unloaded[j] != 0);
        if (rough) {
            reach(n, share);
            block(ma + mb, n > 1);
        }
        read(rows, rows.base(j), n, rough);
        r[LAMBDA + 2] = r[TWIST_MASS] > 0 ? r[LAMBDA + 2] : 0;
        write(rows, rows.base(j), a, b, n, rough, turned);
        warm(bodies.warm, a, -1, 0, n, rough);
        warm(bodies.warm, b, 1, 3, n, rough);
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

    /** The centre of a patch of one point. */
    private void centre(double shift) {
        for (int k = 0; k < 3; k++) {
            at[CENTRE + k] = at[k] - shift * r[k];
            at[CENTRE + 3 + k] = at[3 + k] + shift * r[k];
        }
    }

    /** The patch's centre. */
    private void centre(int n, boolean fixed, double moved) {
        double spread = 0;
        for (int q = NUMBERS; q < NUMBERS * n; q += NUMBERS) {
            double x = at[q] - at[0];
            double y = at[q + 1] - at[1];
            double z = at[q + 2] - at[2];
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
        for (int q = 0; q < NUMBERS * n; q += NUMBERS) {
            double gap = at[q + GAPS] + moved;
            double w = gap <= fade || fade == 0 ? 1 : Math.max(2 - gap / fade, 1e-10);
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
        at[CENTRE] = ax * one - shift * r[0];
        at[CENTRE + 1] = ay * one - shift * r[1];
        at[CENTRE + 2] = az * one - shift * r[2];
        at[CENTRE + 3] = bx * one + shift * r[0];
        at[CENTRE + 4] = by * one + shift * r[1];
        at[CENTRE + 5] = bz * one + shift * r[2];
    }

    /** How far the points are from the centre. */
    private void reach(int n, double share) {
        for (int i = 0; i < n; i++) {
            int q = NUMBERS * i;
            double x = at[q] - at[CENTRE];
            double y = at[q + 1] - at[CENTRE + 1];
            double z = at[q + 2] - at[CENTRE + 2];
            r[REACH + i] = Math.sqrt(x * x + y * y + z * z) * share;
        }
    }

    /**
     * Levers of one body: {@code L^T (r x u)} of the points and of the patch's centre, {@code L^T
     * n}; all zero for what does not move. One point has no twist.
     *
     * @param part 0 for A, 3 for B
     */
    private void side(double[] root, int body, int part, int n, boolean rough) {
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
        if (rough) {
            arm(root, k, CENTRE + part, TANGENT1, lever);
            arm(root, k, CENTRE + part, TANGENT2, lever + 3);
        }
        if (rough && n > 1) {
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

    private void points(
            double[] record, int k, int n, double masses, double stiffness, boolean unloaded) {
        for (int i = 0; i < n; i++) {
            int q = POINT + i * POINT_FIELDS;
            double w = masses + (dot(q + ARM_A, q + ARM_A) + dot(q + ARM_B, q + ARM_B));
            double mass = w > 0 ? 1 / w : 0;
            double stiff = mass * stiffness;
            double known = unloaded ? 0 : record[k + POINTS + NUMBERS * i + LOADS];
            double gap = at[NUMBERS * i + GAPS] - (stiff > 0 ? known / stiff : 0);
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

    /**
     * Adds the impulses to the warm start of a body, see {@link WarmStart}.
     *
     * @param sign -1 for A, 1 for B; the other way round takes them out
     * @param part 0 for A, 3 for B
     */
    private void warm(double[] warm, int body, double sign, int part, int n, boolean rough) {
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
        double f1 = rough ? sign * r[LAMBDA] : 0;
        double f2 = rough ? sign * r[LAMBDA + 1] : 0;
        double f3 = rough ? sign * r[LAMBDA + 2] : 0;
        double g1 = m * f1;
        double g2 = m * f2;
        // zeros leave positive
        for (int k = 0; k < 3; k++) {
            double v = warm[w + k] + f * r[k] + 0.0;
            warm[w + k] = rough ? v + g1 * r[TANGENT1 + k] + g2 * r[TANGENT2 + k] : v;
        }
        x += 0.0;
        y += 0.0;
        z += 0.0;
        if (rough) {
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

    /**
     * Takes the impulses of the row at place {@code j} out of the warm start of a body or both.
     *
     * @param ofA of A
     * @param ofB of B
     */
    void takeOut(ConstraintRows rows, double[] warm, int j, boolean ofA, boolean ofB) {
        int o = rows.base(j);
        int n = rows.points(j);
        boolean rough = rows.get(o + FRICTION * rows.lanes) > 0;
        copy(rows, o, 0, 3);
        copy(rows, o, MASS_A, 2);
        read(rows, o, n, rough);
        int field = ofA ? ARM_A : ARM_B;
        int count = ofA && ofB ? 6 : 3;
        for (int i = 0; i < n; i++) {
            copy(rows, o, POINT + i * POINT_FIELDS + field, count);
        }
        if (rough) {
            copy(rows, o, TANGENT1, 6);
            copy(rows, o, ofA ? LEVER : LEVER + 6, 2 * count);
            copy(rows, o, TWIST + field, count);
        }
        if (ofA) {
            warm(warm, rows.link[j * LINK], 1, 0, n, rough);
        }
        if (ofB) {
            warm(warm, rows.link[j * LINK + 1], -1, 3, n, rough);
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
