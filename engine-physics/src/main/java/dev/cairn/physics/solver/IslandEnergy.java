package dev.cairn.physics.solver;

import static dev.cairn.physics.solver.body.SolverBodies.MASS;
import static dev.cairn.physics.solver.body.SolverBodies.V;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.island.Islands;
import dev.cairn.physics.solver.body.AxisLocks;
import dev.cairn.physics.solver.body.DrivenSides;
import dev.cairn.physics.solver.body.MotionRecord;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.body.SolverContext;
import dev.cairn.physics.solver.graph.Batches;
import dev.cairn.physics.solver.row.EdgeList;

import java.util.Arrays;
import java.util.function.IntPredicate;

/**
 * The contacts of an island do no work to speak of: at the end of a sub-step its bodies have at
 * most 2e-3 more kinetic energy than velocities and forces without the contacts have.
 *
 * <p>Problem: as in {@code single.EnergyBound}, for bodies with several contacts. Where bodies turn
 * far within a sub-step, impulses are given with levers of one pose and taken back with those of
 * another; worlds of a few slender boxes gained up to 1e4 times their energy.
 *
 * <p>With {@code E} the sum at the end and {@code E0} that without contacts, {@code E > 1.002 E0}:
 * where the island rests on something that does not move, the bodies that have gained pay. All
 * their velocities are scaled by {@code k}, {@code k² = 1 - (E - E0)/Eg}, with {@code Eg} the
 * energy of those; what does not approach a surface does not approach it then. Where nothing is
 * around, what is scaled are the velocities relative to those of one rigid body of the same mass,
 * momentum {@code M V} and angular momentum {@code J W} about the common centre of mass X,
 *
 * <pre>
 *   v' = u + k (v - u),  w' = W + k (w - W),   u = V + W x (x - X),   k² = 1 - (E - E0)/(E - Eu)
 * </pre>
 *
 * with its energy Eu: the rest has no momentum and no angular momentum, so both stay. Where that is
 * not enough, as with a body alone, W is zero, and energy goes before angular momentum. The sums
 * run over slots, so they depend on the island alone. What is at rest, slides or falls loses
 * energy, by what gravity adds in a sub-step, and is left as it is.
 *
 * <p>Only islands of which a body turns when the tick begins, or moves far, and one turns by more
 * than 0.05 rad in the sub-step: what a column that lands gains in one sub-step, since one sweep
 * does not reach its top, it loses in the next. Not those with constraints of other kinds or with
 * kinematic bodies, since they do work. One worker to an island. Allocates only while slots are
 * added. Source: own study.
 */
final class IslandEnergy {
    /**
     * Gain of a sub-step, over its energy, that is left alone. The cut is no impulse, so it breaks
     * the balance of momentum and impulses, which is exact otherwise: it is for what would blow up,
     * by factors, not for what one sweep gains in a heap that falls, up to 1e-3.
     */
    private static final double GROSS = 2e-3;

    /** A sum of impulses that counts as none: over the sum of sizes, and over that of momenta. */
    private static final double NONE = 1e-9;

    private static final double NOISE = 1e-13;

    /** Turn in a sub-step, rad, up to which levers are right enough. */
    private static final double FAR = 0.05;

    /** Numbers to an island, at its smallest slot. */
    private static final int STRIDE = 28;

    /** Twice the energy without contacts, with them, and of those that gained. */
    private static final int FREE = 0;

    private static final int NOW = 1;
    private static final int GAINED = 2;

    /** Mass, momentum, impulse of the contacts, and up to which size that is none. */
    private static final int TOTAL_MASS = 3;

    private static final int MOMENTUM = 4;
    private static final int PUSH = 7;
    private static final int SIZE = 10;

    /** Square of the largest turn of a body in the sub-step, rad. */
    private static final int TURN = 11;

    /** Mass times place, angular momentum and inertia; about the island's smallest slot. */
    private static final int PLACE = 12;

    private static final int ANGULAR = 15;
    private static final int INERTIA = 18;

    /** Of the rigid body: where its centre is, how it turns, and the share k of what is left. */
    private static final int CENTRE = PLACE;

    private static final int SPIN = ANGULAR;
    private static final int SHARE = 27;

    private double[] sums = {};

    /** By smallest slot of an island: whether a body of it turns, and whether it may do work. */
    private boolean[] turning = {};

    private boolean[] works = {};
    private Islands islands = new Islands();

    /**
     * Finds, as a tick begins, the islands whose energy is bounded in it.
     *
     * @param tick told whether there is any, see {@link SolverBodies#boundsEnergy}
     * @param turns whether the body of a slot turns, and may turn far
     */
    void find(
            SolverContext tick,
            Batches batches,
            EdgeList list,
            DrivenSides sides,
            IntPredicate turns) {
        boolean any = false;
        for (int k = 0; k < batches.boundCount && !any; k++) {
            any = turns.test(batches.bound[k]);
        }
        tick.body.boundsEnergy = any;
        if (!any) {
            return;
        }
        begin(batches.islands(list), tick.bodies.slotCount);
        for (int k = 0; k < batches.boundCount; k++) {
            int i = batches.bound[k];
            turning[i] = false;
            works[i] = false;
        }
        for (int k = 0; k < batches.boundCount; k++) {
            int i = batches.bound[k];
            if (turns.test(i)) {
                turning[islands.root(i)] = true;
            }
        }
        // constraints of other kinds may do work, and so do bodies that are driven
        for (int m = list.first[1]; m < list.count; m++) {
            exempt(list.mover(m));
        }
        for (int k = 0; k < sides.count(); k++) {
            exempt(list.mover(sides.edge(k)));
        }
        boolean[] hasBelt = tick.bodies.hasBelt;
        for (int m = 0; tick.bodies.belts > 0 && m < list.contacts; m++) {
            if (hasBelt[list.mover(m)] || (list.isBetweenMovers(m) && hasBelt[list.slotB[m]])) {
                exempt(list.mover(m));
            }
        }
    }

    private void begin(Islands ofTick, int slots) {
        islands = ofTick;
        if (turning.length < slots) {
            int n = Math.max(slots, Math.max(64, turning.length + (turning.length >> 1)));
            sums = new double[STRIDE * n];
            turning = new boolean[n];
            works = new boolean[n];
        }
    }

    /** The island of a body does work. */
    private void exempt(int slot) {
        works[islands.root(slot)] = true;
    }

    /**
     * Before bodies move: how much of the sub-step each of them moves, 1 for nearly all. What a
     * bias pass gives to an island that turns far is not all taken back, and a movement is energy,
     * too: a needle of a micrometre was put up by 7 mm in one tick. So the island moves no farther
     * than with the energy that it has without contacts.
     */
    void pace(SolverContext tick, int head, int tail) {
        double[] pace = tick.body.pace;
        boolean any = false;
        for (int k = head; k < tail; k++) {
            any |= tick.body.turnsFar(tick.order[k], tick.subStep);
            pace[tick.order[k]] = 1;
        }
        if (!any) {
            return;
        }
        sum(tick, head, tail);
        double far = SolverBodies.FAR_TURN * SolverBodies.FAR_TURN;
        for (int k = head; k < tail; k++) {
            int i = tick.order[k];
            int at = STRIDE * islands.root(i);
            double most = sums[at + FREE];
            if (sums[at + TURN] > far && sums[at + NOW] > most) {
                pace[i] = Math.sqrt(most / sums[at + NOW]);
            }
        }
    }

    private void sum(SolverContext tick, int head, int tail) {
        for (int k = head; k < tail; k++) {
            int at = STRIDE * tick.order[k];
            Arrays.fill(sums, at, at + STRIDE, 0.0);
        }
        for (int k = head; k < tail; k++) {
            int i = tick.order[k];
            int root = islands.root(i);
            if (turning[root] && !works[root]) {
                add(tick.body, i, STRIDE * root, tick.subStep);
            }
        }
    }

    /** End of a sub-step, of the bodies of whole islands from {@code head} to {@code tail}. */
    void bound(SolverContext tick, int head, int tail) {
        sum(tick, head, tail);
        boolean any = false;
        for (int k = head; k < tail; k++) {
            int i = tick.order[k];
            int at = STRIDE * islands.root(i);
            if (gains(at) && !isPushed(at)) {
                addPlaces(tick, i, islands.root(i));
                any = true;
            }
        }
        for (int k = head; k < tail && any; k++) {
            int i = tick.order[k];
            if (islands.root(i) == i && gains(STRIDE * i) && !isPushed(STRIDE * i)) {
                solidify(STRIDE * i);
            }
        }
        for (int k = head; k < tail; k++) {
            int i = tick.order[k];
            int at = STRIDE * islands.root(i);
            if (tick.body.guide[i] < 0 && gains(at)) {
                cut(tick, i, at);
            }
        }
    }

    private boolean gains(int at) {
        return sums[at + TURN] > FAR * FAR && sums[at + NOW] > (1 + GROSS) * sums[at + FREE];
    }

    /** Whether something that does not move has pushed an island. */
    private boolean isPushed(int at) {
        double outside = 0;
        for (int c = 0; c < 3; c++) {
            outside += Math.abs(sums[at + PUSH + c]);
        }
        return outside > sums[at + SIZE];
    }

    private void add(SolverBodies s, int i, int at, double h) {
        double[] v = s.state;
        int o = SolverBodies.offset(i);
        double x = h * s.world(i, o + V + 3, 0);
        double y = h * s.world(i, o + V + 3, 1);
        double z = h * s.world(i, o + V + 3, 2);
        sums[at + TURN] = Math.max(sums[at + TURN], x * x + y * y + z * z);
        int g = MotionRecord.STRIDE * i + MotionRecord.FREE;
        double mass = 1 / v[o + MASS];
        double now = twice(v, o + V, mass);
        double free = twice(s.motion, g, mass);
        sums[at + FREE] += free;
        sums[at + NOW] += now;
        sums[at + GAINED] += now > free ? now : 0;
        sums[at + TOTAL_MASS] += mass;
        for (int c = 0; c < 3; c++) {
            double push = mass * (v[o + V + c] - s.motion[g + c]);
            sums[at + MOMENTUM + c] += mass * v[o + V + c];
            sums[at + PUSH + c] += push;
            sums[at + SIZE] += NONE * Math.abs(push) + NOISE * mass * Math.abs(v[o + V + c]);
        }
    }

    /** Twice the kinetic energy of velocities that are weighted as the state is. */
    private static double twice(double[] v, int o, double mass) {
        double linear = v[o] * v[o] + v[o + 1] * v[o + 1] + v[o + 2] * v[o + 2];
        double turn = v[o + 3] * v[o + 3] + v[o + 4] * v[o + 4] + v[o + 5] * v[o + 5];
        return mass * linear + turn;
    }

    private void cut(SolverContext tick, int i, int at) {
        SolverBodies s = tick.body;
        double[] v = s.state;
        int o = SolverBodies.offset(i);
        if (isPushed(at)) {
            double mass = 1 / v[o + MASS];
            int g = MotionRecord.STRIDE * i + MotionRecord.FREE;
            if (twice(v, o + V, mass) > twice(s.motion, g, mass)) {
                double excess = sums[at + NOW] - sums[at + FREE];
                double k = Math.sqrt(Math.max(0, 1 - excess / sums[at + GAINED]));
                for (int c = 0; c < 6; c++) {
                    v[o + V + c] *= k;
                }
            }
        } else {
            scale(tick, i, islands.root(i));
        }
        if (tick.bodies.motionFlags[i] != 0) {
            AxisLocks.lock(tick.bodies, v, o);
        }
    }

    /** From the smallest slot of an island to a body, along an axis, m. */
    private static double apart(SolverContext tick, int root, int i, int axis) {
        double[] v = tick.body.state;
        double moved =
                v[SolverBodies.offset(i) + SolverBodies.P + axis]
                        - v[SolverBodies.offset(root) + SolverBodies.P + axis];
        BodyStore b = tick.bodies;
        double start =
                axis == 0 ? b.apartX(root, i) : axis == 1 ? b.apartY(root, i) : b.apartZ(root, i);
        return start + moved;
    }

    private void addPlaces(SolverContext tick, int i, int root) {
        SolverBodies s = tick.body;
        double[] v = s.state;
        int at = STRIDE * root;
        int o = SolverBodies.offset(i) + V;
        double mass = 1 / v[SolverBodies.offset(i) + MASS];
        double x = apart(tick, root, i, 0);
        double y = apart(tick, root, i, 1);
        double z = apart(tick, root, i, 2);
        sums[at + PLACE] += mass * x;
        sums[at + PLACE + 1] += mass * y;
        sums[at + PLACE + 2] += mass * z;
        sums[at + ANGULAR] += mass * (y * v[o + 2] - z * v[o + 1]);
        sums[at + ANGULAR + 1] += mass * (z * v[o] - x * v[o + 2]);
        sums[at + ANGULAR + 2] += mass * (x * v[o + 1] - y * v[o]);
        steiner(at, mass, x, y, z);
        // with L L^T = I^-1 and 1/s² of the columns, L = (s e): I = sum e e^T / s², I w = sum e u/s
        double[] r = s.root;
        int k = (i + 1) * SolverBodies.ROOT;
        for (int c = 0; c < 3; c++) {
            double moment = r[k + 9 + c];
            for (int a = 0; a < 3; a++) {
                double e = moment * r[k + 3 * a + c];
                sums[at + ANGULAR + a] += e * v[o + 3 + c];
                for (int d = 0; d < 3; d++) {
                    sums[at + INERTIA + 3 * a + d] += e * (moment * r[k + 3 * d + c]);
                }
            }
        }
    }

    /** Adds the inertia {@code m (x² - x x^T)} of a mass at a place. */
    private void steiner(int at, double mass, double x, double y, double z) {
        int j = at + INERTIA;
        sums[j] += mass * (y * y + z * z);
        sums[j + 4] += mass * (x * x + z * z);
        sums[j + 8] += mass * (x * x + y * y);
        sums[j + 1] -= mass * x * y;
        sums[j + 3] -= mass * x * y;
        sums[j + 2] -= mass * x * z;
        sums[j + 6] -= mass * x * z;
        sums[j + 5] -= mass * y * z;
        sums[j + 7] -= mass * y * z;
    }

    /** Finds the rigid body of an island, and the share of the rest that is left. */
    private void solidify(int at) {
        double mass = sums[at + TOTAL_MASS];
        double one = 1 / mass;
        double x = one * sums[at + PLACE];
        double y = one * sums[at + PLACE + 1];
        double z = one * sums[at + PLACE + 2];
        double px = sums[at + MOMENTUM];
        double py = sums[at + MOMENTUM + 1];
        double pz = sums[at + MOMENTUM + 2];
        double lx = sums[at + ANGULAR] - (y * pz - z * py);
        double ly = sums[at + ANGULAR + 1] - (z * px - x * pz);
        double lz = sums[at + ANGULAR + 2] - (x * py - y * px);
        steiner(at, -mass, x, y, z);
        int j = at + INERTIA;
        double a = sums[j];
        double b = sums[j + 1];
        double c = sums[j + 2];
        double d = sums[j + 4];
        double e = sums[j + 5];
        double f = sums[j + 8];
        double det = a * (d * f - e * e) - b * (b * f - c * e) + c * (b * e - c * d);
        double by = det > 0 ? 1 / det : 0;
        double wx = by * ((d * f - e * e) * lx + (c * e - b * f) * ly + (b * e - c * d) * lz);
        double wy = by * ((c * e - b * f) * lx + (a * f - c * c) * ly + (b * c - a * e) * lz);
        double wz = by * ((b * e - c * d) * lx + (b * c - a * e) * ly + (a * d - b * b) * lz);
        double flight = one * (px * px + py * py + pz * pz);
        double spin = wx * lx + wy * ly + wz * lz;
        double excess = sums[at + NOW] - sums[at + FREE];
        double own = sums[at + NOW] - flight - spin;
        if (!(own > excess)) {
            // a lone body, whose turning itself has gained
            own += spin;
            wx = wy = wz = 0;
        }
        sums[at + SHARE] = own > 0 ? Math.sqrt(Math.max(0, 1 - excess / own)) : 1;
        sums[at + CENTRE] = x;
        sums[at + CENTRE + 1] = y;
        sums[at + CENTRE + 2] = z;
        sums[at + SPIN] = wx;
        sums[at + SPIN + 1] = wy;
        sums[at + SPIN + 2] = wz;
    }

    /** Scales what the velocities of a body are besides those of the rigid body. */
    private void scale(SolverContext tick, int i, int root) {
        double[] v = tick.body.state;
        int at = STRIDE * root;
        int o = SolverBodies.offset(i) + V;
        double x = apart(tick, root, i, 0) - sums[at + CENTRE];
        double y = apart(tick, root, i, 1) - sums[at + CENTRE + 1];
        double z = apart(tick, root, i, 2) - sums[at + CENTRE + 2];
        double wx = sums[at + SPIN];
        double wy = sums[at + SPIN + 1];
        double wz = sums[at + SPIN + 2];
        double one = 1 / sums[at + TOTAL_MASS];
        double share = sums[at + SHARE];
        double vx = one * sums[at + MOMENTUM] + (wy * z - wz * y);
        double vy = one * sums[at + MOMENTUM + 1] + (wz * x - wx * z);
        double vz = one * sums[at + MOMENTUM + 2] + (wx * y - wy * x);
        v[o] = vx + share * (v[o] - vx);
        v[o + 1] = vy + share * (v[o + 1] - vy);
        v[o + 2] = vz + share * (v[o + 2] - vz);
        double[] r = tick.body.root;
        int k = (i + 1) * SolverBodies.ROOT;
        for (int c = 0; c < 3; c++) {
            // L^-1 W
            double u = r[k + 9 + c] * (r[k + c] * wx + r[k + 3 + c] * wy + r[k + 6 + c] * wz);
            v[o + 3 + c] = u + share * (v[o + 3 + c] - u);
        }
    }
}
