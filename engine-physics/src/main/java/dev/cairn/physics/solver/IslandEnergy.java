package dev.cairn.physics.solver;

import static dev.cairn.physics.solver.body.SolverBodies.MASS;
import static dev.cairn.physics.solver.body.SolverBodies.V;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.JointStore;
import dev.cairn.physics.island.Islands;
import dev.cairn.physics.solver.body.AxisLocks;
import dev.cairn.physics.solver.body.DrivenSides;
import dev.cairn.physics.solver.body.MotionRecord;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.body.SolverContext;
import dev.cairn.physics.solver.graph.Batches;
import dev.cairn.physics.solver.joint.Assemblies;
import dev.cairn.physics.solver.joint.Assembly;
import dev.cairn.physics.solver.row.EdgeList;
import dev.cairn.physics.solver.row.SubStep;

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
 * does not reach its top, it loses in the next.
 *
 * <p>And those with joints or something that is driven, where contacts, limits and drives may
 * contradict each other. With u the speed of what is driven, M the mass of the island and W what
 * its motors and springs may give, {@code E > 1.05 ((sqrt(E0) + 4 u sqrt(M/2))² + W)}: velocities
 * that rows allow are the nearest, and one with what drives is among them, or one that a lever
 * makes some times as fast. What joints hold together is scaled as one, so they still hold. One
 * worker to an island. Allocates only while slots are added. Source: own study.
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

    /** The same of an island with joints or driven bodies, over what may have come from outside. */
    private static final double LOOSE = 0.05;

    /** How much faster than a driven body it may make others by levers, in a sub-step. */
    private static final double LEVERAGE = 4;

    /** Numbers to an island, at its smallest slot. */
    private static final int STRIDE = 11;

    /** Twice the energy without contacts, with them, and of those that gained. */
    private static final int FREE = 0;

    private static final int NOW = 1;
    private static final int GAINED = 2;

    /** Mass, impulse of the contacts, and up to which size that is none. */
    private static final int TOTAL_MASS = 3;

    private static final int PUSH = 4;
    private static final int SIZE = 7;

    /** Square of the largest turn of a body in the sub-step, rad. */
    private static final int TURN = 8;

    /** Twice the energy that motors and springs may have given, and that there may be. */
    private static final int GIVEN = 9;

    private static final int MOST = 10;

    private double[] sums = {};

    /** By smallest slot of an island: whether a body of it turns, and whether it has joints. */
    private boolean[] turning = {};

    private boolean[] joined = {};

    /** By smallest slot: speed of the fastest surface of a body that is driven, m/s. */
    private double[] drive = {};

    /** By smallest slot: whether constraints of unknown kind may do work. */
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
        boolean any = list.first[1] < list.count || sides.count() > 0 || tick.bodies.belts > 0;
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
            joined[i] = false;
            works[i] = false;
            drive[i] = 0;
        }
        for (int k = 0; k < batches.boundCount; k++) {
            int i = batches.bound[k];
            if (turns.test(i)) {
                turning[islands.root(i)] = true;
            }
        }
        for (int kind = 0; kind < list.kinds.length; kind++) {
            boolean[] what = list.kinds[kind].source() instanceof JointStore ? joined : works;
            for (int m = list.first[kind + 1]; m < list.first[kind + 2]; m++) {
                what[islands.root(list.mover(m))] = true;
            }
        }
        findDrives(tick, list, sides);
    }

    private void findDrives(SolverContext tick, EdgeList list, DrivenSides sides) {
        BodyStore b = tick.bodies;
        for (int k = 0; k < sides.count(); k++) {
            int mover = list.mover(sides.edge(k));
            int i = sides.slot(k);
            double x = b.angularVelocityX[i];
            double y = b.angularVelocityY[i];
            double spin = SolverBodies.norm(x, y, b.angularVelocityZ[i]);
            double far =
                    SolverBodies.norm(b.apartX(i, mover), b.apartY(i, mover), b.apartZ(i, mover));
            drive(mover, 0.5 * sides.twiceFastest(tick.body, k) + spin * far);
        }
        double[] belt = tick.contacts.belt;
        for (int m = 0; b.belts > 0 && m < list.contacts; m++) {
            int c = 3 * list.source[m];
            boolean has = b.hasBelt[list.mover(m)];
            has |= list.isBetweenMovers(m) && b.hasBelt[list.slotB[m]];
            drive(list.mover(m), has ? SolverBodies.norm(belt[c], belt[c + 1], belt[c + 2]) : 0);
        }
    }

    /** Something that moves at a speed of its own drives the island of a body. */
    private void drive(int slot, double speed) {
        int root = islands.root(slot);
        drive[root] = Math.max(drive[root], speed);
    }

    private void begin(Islands ofTick, int slots) {
        islands = ofTick;
        if (turning.length < slots) {
            int n = Math.max(slots, Math.max(64, turning.length + (turning.length >> 1)));
            sums = new double[STRIDE * n];
            turning = new boolean[n];
            joined = new boolean[n];
            works = new boolean[n];
            drive = new double[n];
        }
    }

    /** Whether the island of a root has a bound. */
    private boolean isBound(int root) {
        return !works[root] && (turning[root] || isOpen(root));
    }

    /** Whether energy may come from joints or what is driven. */
    private boolean isOpen(int root) {
        return joined[root] || drive[root] > 0;
    }

    /**
     * Before bodies move: how much of the sub-step each of them moves, 1 for nearly all. What a
     * bias pass gives to an island that turns far is not all taken back, and a movement is energy,
     * too: a needle of a micrometre was put up by 7 mm in one tick. So the island moves no farther
     * than with the energy that it has without contacts.
     */
    void pace(SolverContext tick, SubStep sub, Assemblies assemblies, int b, int head, int tail) {
        double[] pace = tick.body.pace;
        boolean any = false;
        for (int k = head; k < tail; k++) {
            int i = tick.order[k];
            any |= isOpen(islands.root(i)) || tick.body.turnsFar(i, tick.subStep);
            pace[i] = 1;
        }
        if (!any) {
            return;
        }
        sum(tick, assemblies, b, head, tail);
        double far = SolverBodies.FAR_TURN * SolverBodies.FAR_TURN;
        double push = sub.pushSpeed * sub.pushSpeed;
        for (int k = head; k < tail; k++) {
            int i = tick.order[k];
            int root = islands.root(i);
            int at = STRIDE * root;
            boolean isOpen = isOpen(root);
            // what overlaps is pushed out without a speed
            double most = sums[at + MOST] + (isOpen ? push * sums[at + TOTAL_MASS] : 0);
            if ((isOpen || sums[at + TURN] > far) && sums[at + NOW] > most) {
                pace[i] = Math.sqrt(most / sums[at + NOW]);
            }
        }
    }

    private void sum(SolverContext tick, Assemblies assemblies, int b, int head, int tail) {
        for (int k = head; k < tail; k++) {
            int at = STRIDE * tick.order[k];
            Arrays.fill(sums, at, at + STRIDE, 0.0);
        }
        for (int k = head; k < tail; k++) {
            int i = tick.order[k];
            int root = islands.root(i);
            if (isBound(root)) {
                add(tick.body, i, STRIDE * root, tick.subStep);
            }
        }
        for (int a = assemblies.first(b); a < assemblies.first(b + 1); a++) {
            Assembly assembly = assemblies.at(a);
            sums[STRIDE * islands.root(assembly.body[0]) + GIVEN] += 2 * assembly.given;
        }
        for (int k = head; k < tail; k++) {
            int root = tick.order[k];
            int at = STRIDE * root;
            double most = sums[at + FREE];
            if (isOpen(root)) {
                double driven = LEVERAGE * drive[root] * Math.sqrt(sums[at + TOTAL_MASS]);
                most = (Math.sqrt(most) + driven) * (Math.sqrt(most) + driven) + sums[at + GIVEN];
            }
            sums[at + MOST] = most;
        }
    }

    /** End of a sub-step, of the bodies of whole islands from {@code head} to {@code tail}. */
    void bound(
            SolverContext tick,
            Assemblies assemblies,
            int b,
            int head,
            int tail,
            WorkerScratch own) {
        sum(tick, assemblies, b, head, tail);
        for (int k = head; k < tail; k++) {
            int i = tick.order[k];
            int root = islands.root(i);
            if (tick.body.guide[i] >= 0 || !gains(root)) {
                continue;
            }
            if (isPushed(STRIDE * root)) {
                cut(tick, i, root);
            } else if (root == i) {
                cutInner(tick, root, head, tail, own);
            }
        }
    }

    /** Nothing is around: what the motion is beside that of one rigid body pays. */
    private void cutInner(SolverContext tick, int root, int head, int tail, WorkerScratch own) {
        if (own.island.length < tail - head) {
            own.island = new int[2 * (tail - head)];
        }
        int n = 0;
        for (int k = head; k < tail; k++) {
            if (islands.root(tick.order[k]) == root) {
                own.island[n++] = tick.order[k];
            }
        }
        double kinetic = 0.5 * sums[STRIDE * root + NOW];
        double excess = kinetic - 0.5 * sums[STRIDE * root + MOST];
        own.inner.cut(tick, own.island, n, excess, kinetic, true);
        for (int k = 0; k < n; k++) {
            lock(tick, own.island[k]);
        }
    }

    private boolean gains(int root) {
        int at = STRIDE * root;
        if (isOpen(root)) {
            return sums[at + NOW] > (1 + LOOSE) * sums[at + MOST];
        }
        return sums[at + TURN] > FAR * FAR && sums[at + NOW] > (1 + GROSS) * sums[at + MOST];
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

    /** What gained pays; what joints hold together is scaled as one. */
    private void cut(SolverContext tick, int i, int root) {
        double[] v = tick.body.state;
        int o = SolverBodies.offset(i) + V;
        int at = STRIDE * root;
        double mass = 1 / v[SolverBodies.offset(i) + MASS];
        int g = MotionRecord.STRIDE * i + MotionRecord.FREE;
        boolean all = joined[root];
        if (all || twice(v, o, mass) > twice(tick.body.motion, g, mass)) {
            double excess = sums[at + NOW] - sums[at + MOST];
            double k = Math.sqrt(Math.max(0, 1 - excess / sums[at + (all ? NOW : GAINED)]));
            for (int c = 0; c < 6; c++) {
                v[o + c] *= k;
            }
        }
        lock(tick, i);
    }

    private static void lock(SolverContext tick, int i) {
        if (tick.bodies.motionFlags[i] != 0) {
            AxisLocks.lock(tick.bodies, tick.body.state, SolverBodies.offset(i));
        }
    }
}
