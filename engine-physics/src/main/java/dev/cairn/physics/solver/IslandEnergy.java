package dev.cairn.physics.solver;

import static dev.cairn.physics.solver.body.SolverBodies.MASS;
import static dev.cairn.physics.solver.body.SolverBodies.V;

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
 * around, the velocities relative to the common centre of mass are scaled, so that momentum stays.
 * The sums run over slots, so they depend on the island alone. What is at rest, slides or falls
 * loses energy, by what gravity adds in a sub-step, and is left as it is.
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
    private static final int STRIDE = 12;

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

    /** End of a sub-step, of the bodies of whole islands from {@code head} to {@code tail}. */
    void bound(SolverContext tick, int head, int tail) {
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
        for (int k = head; k < tail; k++) {
            int i = tick.order[k];
            int at = STRIDE * islands.root(i);
            if (tick.body.guide[i] < 0
                    && sums[at + TURN] > FAR * FAR
                    && sums[at + NOW] > (1 + GROSS) * sums[at + FREE]) {
                cut(tick, i, at);
            }
        }
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
        double outside = 0;
        for (int c = 0; c < 3; c++) {
            outside += Math.abs(sums[at + PUSH + c]);
        }
        double excess = sums[at + NOW] - sums[at + FREE];
        if (outside > sums[at + SIZE]) {
            double mass = 1 / v[o + MASS];
            int g = MotionRecord.STRIDE * i + MotionRecord.FREE;
            if (twice(v, o + V, mass) > twice(s.motion, g, mass)) {
                double k = Math.sqrt(Math.max(0, 1 - excess / sums[at + GAINED]));
                scale(v, o + V, 0, 0, 0, k);
            }
        } else {
            double one = 1 / sums[at + TOTAL_MASS];
            double x = one * sums[at + MOMENTUM];
            double y = one * sums[at + MOMENTUM + 1];
            double z = one * sums[at + MOMENTUM + 2];
            double common = sums[at + TOTAL_MASS] * (x * x + y * y + z * z);
            double own = sums[at + NOW] - common;
            double k = own > 0 ? Math.sqrt(Math.max(0, 1 - excess / own)) : 1;
            scale(v, o + V, x, y, z, k);
        }
        if (tick.bodies.motionFlags[i] != 0) {
            AxisLocks.lock(tick.bodies, v, o);
        }
    }

    private static void scale(double[] v, int o, double x, double y, double z, double k) {
        v[o] = x + k * (v[o] - x);
        v[o + 1] = y + k * (v[o + 1] - y);
        v[o + 2] = z + k * (v[o + 2] - z);
        v[o + 3] *= k;
        v[o + 4] *= k;
        v[o + 5] *= k;
    }
}
