package dev.cairn.physics.solver.refresh;

import static dev.cairn.physics.solver.refresh.RefreshKind.AIMED;
import static dev.cairn.physics.solver.refresh.RefreshKind.APART;
import static dev.cairn.physics.solver.refresh.RefreshKind.OF_A;
import static dev.cairn.physics.solver.refresh.RefreshKind.OF_B;
import static dev.cairn.physics.solver.refresh.RefreshKind.STAYS_A;
import static dev.cairn.physics.solver.refresh.RefreshKind.STAYS_B;
import static dev.cairn.physics.solver.refresh.RefreshKind.SWINGS_A;
import static dev.cairn.physics.solver.refresh.RefreshKind.SWINGS_B;
import static dev.cairn.physics.solver.refresh.RefreshKind.TOLD;
import static dev.cairn.physics.solver.refresh.RefreshKind.TURNS_A;
import static dev.cairn.physics.solver.refresh.RefreshKind.TURNS_B;
import static dev.cairn.physics.solver.row.ConstraintRows.LINK;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.Surface;
import dev.cairn.physics.solver.body.Rotation;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.SubStep;

import java.util.Arrays;

/**
 * Levers of bodies that turn, or pass each other, within a tick: renewed in each sub-step, after
 * the bodies have moved and before the relax pass.
 *
 * <p>Problem: rows are filled from the contact points of the tick's start. A top at 300 rad/s turns
 * by 5 rad in a tick, a rocking block shortens its lever by some percent, and two bodies that pass
 * each other take their impulses at two points that drift apart, which makes angular momentum. So a
 * body that turns gets the root of its present inertia, and a row of such a body, or of two that
 * pass each other, gets levers of now: corners turn with their body, points of solids of revolution
 * go with their axis and those of balls with their centre ({@link RoundTurn}), and two bodies that
 * move share one point, that of the round one. Then no angular momentum is made. The points of two
 * that meet within the tick are apart as it begins ({@code MeetingContact}), and brought together
 * from the first sub-step on. Normals and tangents stay those of the tick's start. Two bodies that
 * bounce keep their points, unless they meet within the tick and are not both balls.
 *
 * <p>A body that is slower than 0.045 of {@code sqrt(g r)} (0.1 m/s for a cube of 1 m) is left
 * alone, so that what rests or creeps pays one comparison a row; without gravity all that moves is
 * renewed. A row keeps its impulses and totals; its share in the warm start is taken out before and
 * put in after, by colour, so that the result does not depend on the workers.
 */
public final class JacobianRefresh {
    /** Speed over {@code sqrt(g r)} up to which levers may age by a tick. */
    static final double SLOW = 0.045;

    /** Way in a tick over the outer radius beyond which levers do not age by a tick at all. */
    private static final double FAR = 0.1;

    /** Turn in a sub-step, rad, after which the root of a body that stood still is not its own. */
    private static final double STRUCK = 0.05;

    /** Numbers to a row in {@link #kept}. */
    private static final int KEPT = RefreshRow.RECORD;

    /** By slot: whether the body's root is renewed; its orientation at the start, 4 to a slot. */
    boolean[] turns = {};

    private double[] start = {};

    /** Turn since the start as a matrix, 9 to a slot. */
    private double[] turn = {};

    /** By place: 0, or that the row is renewed, and how; its first levers are kept. */
    private int[] renewed = {};

    private double[] kept = {};

    /** By place, for A and for B: what {@link RoundTurn} keeps. */
    private double[] rounds = {};

    /** By slot: whether a row of the body is renewed. */
    private boolean[] hasRenewedRow = {};

    /** By slot: whether the body turns since an impact within the tick; its rows do not know. */
    private boolean[] struck = {};

    public void ensureCapacity(int slots) {
        if (turns.length < slots) {
            int n = Math.max(slots, turns.length + (turns.length >> 1));
            turns = Arrays.copyOf(turns, n);
            start = Arrays.copyOf(start, 4 * n);
            turn = Arrays.copyOf(turn, 9 * n);
            hasRenewedRow = Arrays.copyOf(hasRenewedRow, n);
            struck = Arrays.copyOf(struck, n);
        }
    }

    /**
     * Decides whether a body with contacts turns in this tick, or moves so far that a contact may
     * turn it far: a rod that falls does not turn before it lands on its tip. Not a ball, whose
     * points do not move with it. Blocks of bodies.
     *
     * @param step length of the tick, s; 0 if a contact of the body has restitution
     */
    public void look(BodyStore b, int i, double gravity, double step, boolean isBall) {
        double x = b.angularVelocityX[i];
        double y = b.angularVelocityY[i];
        double z = b.angularVelocityZ[i];
        double far = b.outerRadius[i];
        double slow = SLOW * SLOW * gravity * b.innerRadius[i];
        hasRenewedRow[i] = false;
        double u = b.velocityX[i];
        double v = b.velocityY[i];
        double w = b.velocityZ[i];
        boolean isFar = (u * u + v * v + w * w) * (step * step) > FAR * FAR * (far * far);
        turns[i] = !isBall && (isFar || (x * x + y * y + z * z) * (far * far) > slow);
        if (turns[i]) {
            turnAlways(b, i);
        }
    }

    /** A body's root is renewed in each sub-step, as joints hang on it; after {@link #look}. */
    public void turnAlways(BodyStore b, int i) {
        turns[i] = true;
        struck[i] = false;
        start[4 * i] = b.orientationX[i];
        start[4 * i + 1] = b.orientationY[i];
        start[4 * i + 2] = b.orientationZ[i];
        start[4 * i + 3] = b.orientationW[i];
    }

    /** Levers of a kinematic body do not turn with it within the tick. */
    public void keep(int slot) {
        turns[slot] = false;
        hasRenewedRow[slot] = false;
    }

    /**
     * Makes room for the rows of a tick.
     *
     * @param curved whether points of any may go with an axis
     */
    public void ensurePlaces(ConstraintRows rows, boolean curved) {
        if (renewed.length < rows.settleMark.length) {
            // With the rows, so that a scene that gets wilder later allocates nothing.
            renewed = new int[rows.settleMark.length];
            kept = new double[rows.settleMark.length * KEPT];
        }
        int wanted = curved ? renewed.length * 2 * RoundTurn.NUMBERS : 0;
        if (rounds.length < wanted) {
            rounds = new double[wanted];
        }
    }

    /**
     * Finds the rows to renew; ranges of places. Whose row is renewed is written by all alike.
     *
     * @return whether there is one
     */
    public boolean find(
            ConstraintRows rows, ContactStore c, BodyStore b, double gravity, int from, int to) {
        boolean any = false;
        for (int place = from; place < to; place++) {
            renewed[place] = 0;
            int l = place * ConstraintRows.LINK;
            if (rows.link[l + ConstraintRows.COUNT] == 0) {
                continue;
            }
            int source = rows.link[l + ConstraintRows.SOURCE];
            int i = c.bodyA[source];
            int j = c.bodyB[source];
            boolean movesA = rows.link[l] != 0;
            boolean movesB = rows.link[l + 1] != 0;
            if ((movesA && turns[i])
                    || (movesB && turns[j])
                    || (movesA
                            && movesB
                            && c.restitution[source] == 0
                            && RefreshKind.passes(b, i, j, gravity))) {
                renewed[place] = RefreshKind.of(rows, c, b, turns, place, movesA, movesB);
                any = true;
                RefreshRow.keep(c, source, kept, KEPT * place);
                if ((renewed[place] & SWINGS_A) != 0) {
                    RoundTurn.keep(b, i, c.colliderA[source], rounds, roundA(place));
                }
                if ((renewed[place] & SWINGS_B) != 0) {
                    RoundTurn.keep(b, j, c.colliderB[source], rounds, roundB(place));
                }
                if (movesA) {
                    hasRenewedRow[i] = true;
                }
                if (movesB) {
                    hasRenewedRow[j] = true;
                }
            }
        }
        return any;
    }

    /**
     * Gives rows of bodies that meet within the tick, and so press at points that are apart as it
     * begins, one point from the first sub-step on; ranges of places, after {@link #find}.
     */
    public void meet(
            ConstraintRows rows,
            SolverBodies s,
            BodyStore b,
            ContactStore c,
            SubStep sub,
            int from,
            int to,
            RefreshRow row) {
        for (int j = from; j < to; j++) {
            int how = renewed[j];
            if ((how & APART) == 0 || !row.isCold(rows, j)) {
                continue;
            }
            int k = j * KEPT;
            int source = rows.link[j * LINK + ConstraintRows.SOURCE];
            double shareA = RefreshKind.share(how, OF_B);
            double shareB = RefreshKind.share(how, OF_A);
            row.swing(turn, rounds, -1, roundA(j), -1, roundB(j));
            row.apart(true, b, c.bodyA[source], c.bodyB[source]);
            row.place(rows, s.state, j, kept, k, turn, -1, -1, shareA, shareB);
            row.fill(rows, s, j, kept, k, false, sub);
        }
    }

    /**
     * Says that none of a range of rows is renewed, if none can be: none of their bodies turns, and
     * even two of the fastest would not pass each other fast enough. So what rests or creeps pays
     * by body, not by row.
     *
     * @param order lists the bodies of the rows, from {@code head} to {@code tail}
     */
    public boolean isCalm(
            BodyStore b, int[] order, int head, int tail, double gravity, int from, int to) {
        double fastest = 0;
        double least = Double.POSITIVE_INFINITY;
        for (int k = head; k < tail; k++) {
            int i = order[k];
            if (turns[i]) {
                return false;
            }
            double x = b.velocityX[i];
            double y = b.velocityY[i];
            double z = b.velocityZ[i];
            fastest = Math.max(fastest, x * x + y * y + z * z);
            least = Math.min(least, b.innerRadius[i]);
        }
        // |vj - vi| <= 2 max |v|, with room for rounding
        if (!(5 * fastest <= SLOW * SLOW * gravity * least)) {
            return false;
        }
        Arrays.fill(renewed, from, to, 0);
        return true;
    }

    /** Whether a body turns in this tick, or may. */
    public boolean turns(int slot) {
        return turns[slot];
    }

    /** Whether a row of a body is renewed. */
    public boolean hasRenewedRow(int slot) {
        return hasRenewedRow[slot];
    }

    private static int roundA(int place) {
        return 2 * RoundTurn.NUMBERS * place;
    }

    private static int roundB(int place) {
        return roundA(place) + RoundTurn.NUMBERS;
    }

    /**
     * Takes the impulses of a row out of the bodies' warm start. A body that turns begins with
     * none, see {@link #body}.
     */
    private static void unload(ConstraintRows rows, double[] warm, int j, int how, RefreshRow row) {
        if ((how & (STAYS_A | STAYS_B)) != 0) {
            row.takeOut(rows, warm, j, (how & STAYS_A) != 0, (how & STAYS_B) != 0);
            if (rows.rolling.has(j)) {
                rows.rolling.addWarm(rows, warm, j, j, -1);
            }
        }
    }

    /**
     * Gives a body that turns the root of its present inertia; blocks of bodies. A body that did
     * not turn when the tick began does from here on if an impact has turned it by far in this
     * sub-step.
     *
     * @param seconds length of the sub-step, s
     */
    public void body(SolverBodies s, BodyStore b, int i, double seconds) {
        int o = SolverBodies.offset(i);
        int w = (i + 1) * SolverBodies.HALF;
        double x = s.world(i, o + 3, 0);
        double y = s.world(i, o + 3, 1);
        double z = s.world(i, o + 3, 2);
        if (!turns[i]) {
            if (s.axes.isIsotropic(i)
                    || !((x * x + y * y + z * z) * (seconds * seconds) > STRUCK * STRUCK)) {
                System.arraycopy(s.state, o, s.mark, w, 6);
                return;
            }
            turnAlways(b, i);
            struck[i] = true;
        }
        s.rootOfInertia(b, i, s.state[o + SolverBodies.GRAVITY]);
        s.weigh(i, x, y, z);
        Arrays.fill(s.state, o + SolverBodies.P + 3, o + SolverBodies.P + 6, 0.0);
        System.arraycopy(s.state, o, s.mark, w, 6);
        if (!struck[i]) {
            Arrays.fill(s.warm, w, w + 6, 0.0);
        }
        turned(b, i);
    }

    /** {@code q q0^-1} as a matrix. */
    private void turned(BodyStore b, int i) {
        double px = -start[4 * i];
        double py = -start[4 * i + 1];
        double pz = -start[4 * i + 2];
        double pw = start[4 * i + 3];
        double bx = b.orientationX[i];
        double by = b.orientationY[i];
        double bz = b.orientationZ[i];
        double bw = b.orientationW[i];
        double x = bw * px + bx * pw + (by * pz - bz * py);
        double y = bw * py + by * pw + (bz * px - bx * pz);
        double z = bw * pz + bz * pw + (bx * py - by * px);
        double w = bw * pw - (bx * px + by * py + bz * pz);
        int r = 9 * i;
        turn[r] = 1 - 2 * (y * y + z * z);
        turn[r + 1] = 2 * (x * y - w * z);
        turn[r + 2] = 2 * (x * z + w * y);
        turn[r + 3] = 2 * (x * y + w * z);
        turn[r + 4] = 1 - 2 * (x * x + z * z);
        turn[r + 5] = 2 * (y * z - w * x);
        turn[r + 6] = 2 * (x * z - w * y);
        turn[r + 7] = 2 * (y * z + w * x);
        turn[r + 8] = 1 - 2 * (x * x + y * y);
    }

    /**
     * Where the corner of a body is with which it stands on a static one, from its centre of mass.
     *
     * @param source row of the contact in the store
     * @param place of its row, which is renewed
     * @param point of the contact
     * @param i slot of the body
     * @param side 1 if the body is the second of the contact, else -1
     * @param arm receives the corner at the tick's start, world axes, then in the body
     * @return its gap at the tick's start, m, or NaN if it is not always the same point of the body
     */
    public double corner(
            BodyStore b,
            ContactStore c,
            int source,
            int place,
            int point,
            int i,
            double side,
            double[] arm) {
        boolean second = side > 0;
        byte own = second ? c.surfaceB[source] : c.surfaceA[source];
        byte other = second ? c.surfaceA[source] : c.surfaceB[source];
        if (!Surface.isFlat(other)
                || !Surface.isCorner(own, c.feature[ContactStore.POINTS * source + point], second)
                || (b.motionFlags[i] & ~BodyStore.DAMPED) != 0) {
            return Double.NaN;
        }
        int k = KEPT * place + RefreshRow.POINTS + RefreshRow.NUMBERS * point;
        double gap = kept[k + RefreshRow.GAPS];
        int a = side > 0 ? k + 3 : k;
        double half = 0.5 * side * gap;
        arm[0] = kept[a] + half * c.normalX(source);
        arm[1] = kept[a + 1] + half * c.normalY(source);
        arm[2] = kept[a + 2] + half * c.normalZ(source);
        double x = start[4 * i];
        double y = start[4 * i + 1];
        double z = start[4 * i + 2];
        double w = start[4 * i + 3];
        for (int axis = 0; axis < 3; axis++) {
            double sum = 0;
            for (int n = 0; n < 3; n++) {
                sum += arm[n] * Rotation.axis(x, y, z, w, axis, n);
            }
            arm[3 + axis] = sum;
        }
        return gap;
    }

    /** Gives the contacts their first levers back. */
    public void restore(ConstraintRows rows, ContactStore c, int from, int to) {
        for (int j = from; j < to; j++) {
            int how = renewed[j];
            if (how == 0) {
                continue;
            }
            int first = ContactStore.POINTS * rows.link[j * LINK + ConstraintRows.SOURCE];
            int q = j * KEPT + RefreshRow.POINTS;
            for (int p = first; p < first + rows.points(j); p++, q += RefreshRow.NUMBERS) {
                c.separation[p] = kept[q + RefreshRow.GAPS];
                if ((how & TOLD) != 0) {
                    System.arraycopy(
                            kept, q, c.anchors, ContactStore.anchor(p), ContactStore.ANCHORS);
                }
            }
        }
    }

    /**
     * Fills the rows anew; their impulses leave the warm start with the old levers and come back
     * with the new ones. Blocks of a colour.
     *
     * @param index of the sub-step
     */
    public void rows(
            ConstraintRows rows,
            SolverBodies s,
            BodyStore b,
            ContactStore c,
            SubStep sub,
            int index,
            int from,
            int to,
            RefreshRow row) {
        boolean isLast = index == sub.count - 1;
        for (int j = from; j < to; j++) {
            int how = renewed[j];
            if (how == 0) {
                continue;
            }
            unload(rows, s.warm, j, how, row);
            int k = j * KEPT;
            int source = rows.link[j * LINK + ConstraintRows.SOURCE];
            if (index == 0 && sub.fillScale != 1) {
                RefreshRow.scaleLoads(c, source, kept, k, sub.fillScale);
            }
            if ((how & AIMED) != 0) {
                RefreshRow.aim(c, source, kept, k);
            }
            int ra = (how & TURNS_A) != 0 ? 9 * SolverBodies.slot(rows.link[j * LINK]) : -1;
            int rb = (how & TURNS_B) != 0 ? 9 * SolverBodies.slot(rows.link[j * LINK + 1]) : -1;
            double shareA = RefreshKind.share(how, OF_B);
            double shareB = RefreshKind.share(how, OF_A);
            row.swing(
                    turn,
                    rounds,
                    (how & SWINGS_A) != 0 ? 9 * SolverBodies.slot(rows.link[j * LINK]) : -1,
                    roundA(j),
                    (how & SWINGS_B) != 0 ? 9 * SolverBodies.slot(rows.link[j * LINK + 1]) : -1,
                    roundB(j));
            row.apart((how & APART) != 0, b, c.bodyA[source], c.bodyB[source]);
            row.place(rows, s.state, j, kept, k, turn, ra, rb, shareA, shareB);
            if ((how & TOLD) != 0 || isLast) {
                row.tell(c, source, (how & TOLD) != 0);
            }
            row.fill(rows, s, j, kept, k, index == 0 || (how & AIMED) != 0, sub);
            row.warm(rows, s, j, kept, k);
            if (rows.rolling.has(j)) {
                rows.rolling.renew(rows, s, c, j);
            }
        }
    }

    /**
     * The rim with which a body stands on a static one, see {@link Rim}.
     *
     * @param source row of the contact in the store
     * @param place of its row
     * @param i slot of the body
     * @param side 1 if the body is the second of the contact, else -1
     * @param rim receives it
     * @return whether there is one
     */
    public boolean rim(
            BodyStore b, ContactStore c, int source, int place, int i, int side, Rim rim) {
        boolean second = side > 0;
        if ((renewed[place] & (second ? SWINGS_B : SWINGS_A)) == 0
                || !Surface.isFlat(second ? c.surfaceA[source] : c.surfaceB[source])
                || b.motionFlags[i] != 0) {
            return false;
        }
        int round = second ? roundB(place) : roundA(place);
        return rim.find(
                kept, KEPT * place, c.pointCount[source], rounds, round, start, 4 * i, side);
    }

    /** Contacts know of other loads than when their rows were found. */
    public void know(ConstraintRows rows, ContactStore c, int from, int to) {
        for (int j = from; j < to; j++) {
            if (renewed[j] != 0) {
                RefreshRow.know(
                        c,
                        rows.link[j * ConstraintRows.LINK + ConstraintRows.SOURCE],
                        kept,
                        KEPT * j);
            }
        }
    }
}
