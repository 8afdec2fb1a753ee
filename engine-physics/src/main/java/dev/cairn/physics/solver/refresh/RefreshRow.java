package dev.cairn.physics.solver.refresh;

import static dev.cairn.physics.solver.row.ConstraintRows.*;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.kernel.PrepareRow;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.SubStep;

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

    /**
     * How far from the patch's middle friction acts at a point, over its own distance; -1: no
     * friction.
     */
    static final int SHARE = 9;

    /** Start of the points, {@link #NUMBERS} each: anchors of A and B, then these. */
    static final int POINTS = 10;

    static final int NUMBERS = 8;

    /** Of a point: its separation, m; the load that its contact knows. */
    static final int GAPS = 6;

    static final int LOADS = 7;

    private final DenseRow row = new DenseRow();
    private final RoundTurn roundA = new RoundTurn(1), roundB = new RoundTurn(-1);

    /** The fields of the row, and the points of now. */
    private final double[] r = row.r, at = row.at;

    /** The points of the two bodies were apart when the tick began, and so were their centres. */
    private boolean isApart;

    private double apartX, apartY, apartZ;

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

    /** Writes the loads that a contact knows to its record. */
    static void know(ContactStore c, int source, double[] record, int k) {
        int first = ContactStore.POINTS * source;
        for (int i = 0; i < c.pointCount[source]; i++) {
            record[k + POINTS + NUMBERS * i + LOADS] = c.preload[first + i];
        }
    }

    /** What the contacts know is of sub-steps of another length. */
    static void scaleLoads(ContactStore c, int source, double[] record, int k, double scale) {
        int first = ContactStore.POINTS * source;
        for (int i = 0; i < c.pointCount[source]; i++) {
            c.preload[first + i] *= scale;
            record[k + POINTS + NUMBERS * i + LOADS] *= scale;
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
     * Tells which points go with the axis of a round body; before {@link #place}.
     *
     * @param turn turns of bodies since the tick's start, nine numbers each
     * @param rounds what was kept of round sides
     * @param ra where the turn of A is, if its points go with its axis, else -1
     * @param xa what was kept of A
     * @param rb the turn of B
     * @param xb what was kept of B
     */
    void swing(double[] turn, double[] rounds, int ra, int xa, int rb, int xb) {
        roundA.set(turn, ra, rounds, xa);
        roundB.set(turn, rb, rounds, xb);
    }

    /** Tells whether the points of two bodies are apart when the tick begins; before a place. */
    void apart(boolean value, BodyStore b, int i, int j) {
        isApart = value;
        if (value) {
            apartX = b.positionX[j] - b.positionX[i];
            apartY = b.positionY[j] - b.positionY[i];
            apartZ = b.positionZ[j] - b.positionZ[i];
        }
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
        turn(turn, ra, record, q, 0, n);
        turn(turn, rb, record, q, 3, n);
        roundA.move(record, q, at, 0, n, nx, ny, nz);
        roundB.move(record, q, at, 3, n, nx, ny, nz);
        for (int i = 0; i < NUMBERS * n; i += NUMBERS, q += NUMBERS) {
            double dx = (at[i + 3] - record[q + 3]) - (at[i] - record[q]);
            double dy = (at[i + 4] - record[q + 4]) - (at[i + 1] - record[q + 1]);
            double dz = (at[i + 5] - record[q + 5]) - (at[i + 2] - record[q + 2]);
            at[i + GAPS] = record[q + GAPS] + (dx * nx + dy * ny + dz * nz);
            if (isApart) {
                dx = at[i + 3] - at[i] + apartX;
                dy = at[i + 4] - at[i + 1] + apartY;
                dz = at[i + 5] - at[i + 2] + apartZ;
            }
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

    /**
     * Turns the points of one body, if there is a turn. Each kind of way has a loop of its own here
     * and in {@link RoundTurn}: in one loop for all the compiler made a copy of it for each mix of
     * ways, for half a second.
     *
     * @param part 0 for A, 3 for B
     */
    private void turn(double[] turn, int m, double[] record, int first, int part, int n) {
        int q = first + part;
        int end = NUMBERS * n;
        if (m < 0) {
            for (int i = part; i < end; i += NUMBERS, q += NUMBERS) {
                at[i] = record[q];
                at[i + 1] = record[q + 1];
                at[i + 2] = record[q + 2];
            }
            return;
        }
        for (int i = part; i < end; i += NUMBERS, q += NUMBERS) {
            double x = record[q];
            double y = record[q + 1];
            double z = record[q + 2];
            at[i] = turn[m] * x + turn[m + 1] * y + turn[m + 2] * z;
            at[i + 1] = turn[m + 3] * x + turn[m + 4] * y + turn[m + 5] * z;
            at[i + 2] = turn[m + 6] * x + turn[m + 7] * y + turn[m + 8] * z;
        }
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
        boolean hasFriction = share >= 0;
        for (int i = 0; i < 3; i++) {
            r[i] = record[k + i];
            r[TANGENT1 + i] = record[k + TANGENTS + i];
            r[TANGENT2 + i] = record[k + TANGENTS + 3 + i];
        }
        r[MASS_A] = ma;
        r[MASS_B] = mb;
        if (hasFriction && n == 1) {
            row.centre(fixed ? 0.5 * at[GAPS] : 0);
        } else if (hasFriction) {
            boolean guided = bodies.isGuided(a) || bodies.isGuided(b);
            row.centre(n, fixed, guided, fixed ? 0 : row.moved(bodies.state, a, b), share);
        }
        row.side(bodies.root, a, 0, n, hasFriction);
        row.side(bodies.root, b, 3, n, hasFriction);
        row.points(record, k, n, ma + mb, sub.stiffness(fixed), rows.settleMark[j] != 0);
        if (hasFriction) {
            row.block(ma + mb, n > 1);
        }
        read(rows, rows.base(j), n, hasFriction);
        r[LAMBDA + 2] = r[TWIST_MASS] > 0 ? r[LAMBDA + 2] : 0;
        write(rows, rows.base(j), a, b, n, hasFriction, turned);
    }

    /** Adds the impulses of the row that was filled last to the warm start of its bodies. */
    void warm(ConstraintRows rows, SolverBodies bodies, int j, double[] record, int k) {
        int n = rows.points(j);
        boolean hasFriction = record[k + SHARE] >= 0;
        row.warm(bodies.warm, rows.link[j * LINK], -1, 0, n, hasFriction);
        row.warm(bodies.warm, rows.link[j * LINK + 1], 1, 3, n, hasFriction);
    }

    /** Whether the row at place {@code j} begins without impulses, so that nothing is warm. */
    boolean isCold(ConstraintRows rows, int j) {
        int o = rows.base(j);
        int n = rows.points(j);
        boolean hasFriction = rows.get(o + FRICTION * rows.lanes) > 0;
        read(rows, o, n, hasFriction);
        double sum = 0;
        for (int i = 0; hasFriction && i < 3; i++) {
            sum += Math.abs(r[LAMBDA + i]);
        }
        for (int i = 0; i < n; i++) {
            sum += r[POINT + i * POINT_FIELDS + IMPULSE];
        }
        return sum == 0;
    }

    /** Writes what can have changed. */
    private void write(
            ConstraintRows rows, int o, int a, int b, int n, boolean hasFriction, boolean turned) {
        for (int i = 0; i < n; i++) {
            int q = POINT + i * POINT_FIELDS;
            // a static body has no lever
            write(rows, o, a == 0 ? q + ARM_B : q, b == 0 ? 3 : a == 0 ? 4 : 7);
            if (b == 0) {
                write(rows, o, q + MASS, 1);
            }
            write(rows, o, q + SEPARATION, 1);
        }
        write(rows, o, GAP, n);
        if (!hasFriction) {
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

    private void read(ConstraintRows rows, int o, int n, boolean hasFriction) {
        for (int i = 0; i < n; i++) {
            copy(rows, o, POINT + i * POINT_FIELDS + IMPULSE, 1);
        }
        if (hasFriction) {
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
     * Takes the impulses of the row at place {@code j} out of the warm start of a body or both.
     *
     * @param ofA of A
     * @param ofB of B
     */
    void takeOut(ConstraintRows rows, double[] warm, int j, boolean ofA, boolean ofB) {
        int o = rows.base(j);
        int n = rows.points(j);
        boolean hasFriction = rows.get(o + FRICTION * rows.lanes) > 0;
        copy(rows, o, 0, 3);
        copy(rows, o, MASS_A, 2);
        read(rows, o, n, hasFriction);
        int field = ofA ? ARM_A : ARM_B;
        int count = ofA && ofB ? 6 : 3;
        for (int i = 0; i < n; i++) {
            copy(rows, o, POINT + i * POINT_FIELDS + field, count);
        }
        if (hasFriction) {
            copy(rows, o, TANGENT1, 6);
            copy(rows, o, ofA ? LEVER : LEVER + 6, 2 * count);
            copy(rows, o, TWIST + field, count);
        }
        if (ofA) {
            row.warm(warm, rows.link[j * LINK], 1, 0, n, hasFriction);
        }
        if (ofB) {
            row.warm(warm, rows.link[j * LINK + 1], -1, 3, n, hasFriction);
        }
    }

    /** Scales the impulses of the row at place {@code j}, and what they do to its bodies. */
    void scale(ConstraintRows rows, double[] warm, int j, double share) {
        boolean rolls = rows.rolling.has(j);
        if (rolls) {
            rows.rolling.addWarm(rows, warm, j, j, -1);
            rows.rolling.scale(j, share);
            rows.rolling.addWarm(rows, warm, j, j, 1);
        }
        takeOut(rows, warm, j, true, true);
        int o = rows.base(j);
        int n = rows.points(j);
        boolean hasFriction = rows.get(o + FRICTION * rows.lanes) > 0;
        for (int i = 0; i < n; i++) {
            int q = POINT + i * POINT_FIELDS + IMPULSE;
            r[q] *= share;
            write(rows, o, q, 1);
        }
        for (int i = 0; i < 3 && hasFriction; i++) {
            r[LAMBDA + i] *= share;
            write(rows, o, LAMBDA + i, 1);
        }
        row.warm(warm, rows.link[j * LINK], -1, 0, n, hasFriction);
        row.warm(warm, rows.link[j * LINK + 1], 1, 3, n, hasFriction);
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
