package dev.cairn.physics.solver.refresh;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.body.SolverContext;
import dev.cairn.physics.solver.row.ConstraintRows;

import java.util.function.IntPredicate;

/**
 * What squeezes a light body does not throw it: of the impulses that its contacts kept from the
 * last tick, a share is left with which they change its velocity by no more than it has.
 *
 * <p>Problem: between two bodies of a hundred times its mass a body is held by impulses of which
 * each alone would give it hundreds of metres a second, and which balance. They are kept as numbers
 * along the normals. Where a normal has turned from one tick to the next, or a point is elsewhere
 * on the body, they do not balance any more, and one pass takes back a part of that only: a box of
 * 0.3 kg left a heap at 52 m/s, with 800 rad/s, and took the energy from the others, so that no
 * bound on the energy of an island sees it.
 *
 * <p>With W the change of velocity by all that was kept, v the velocity, f what gravity and forces
 * give in the sub-step, all in coordinates in which the kinetic energy is half a square, a body
 * keeps the share {@code k = min(1, (|v| + 10 |f|) / |W|)}; a contact that of its body with the
 * lesser one, so momentum stays. A body whose contacts balance has a W of the size of f, or of what
 * it really does, and keeps all.
 *
 * <p>Only bodies that touch one of four times their mass, and that no joint holds, whose impulses
 * contacts balance. One worker to a body. Allocates only while slots are added. Source: own study.
 */
public final class WarmStartLimit {
    /** How many times what gravity and forces give contacts may give a body at rest. */
    private static final double FORCES = 10;

    /** By slot: the share of its impulses that a body keeps; 0 until a light one is measured. */
    private double[] share = {};

    private final SolverContext tick;
    private final ConstraintRows rows;
    private final IntPredicate jointed;

    /**
     * Of the rows of one precision.
     *
     * @param jointed whether joints hold the body of a slot
     */
    public WarmStartLimit(SolverContext tick, ConstraintRows rows, IntPredicate jointed) {
        this.tick = tick;
        this.rows = rows;
        this.jointed = jointed;
    }

    public void ensureCapacity(int slots) {
        if (share.length < slots) {
            share = new double[Math.max(slots, share.length + (share.length >> 1))];
        }
    }

    /** Whether one of the contacts at places {@code from} to {@code to} is of a light body. */
    public boolean isNeeded(int from, int to) {
        for (int j = from; j < to && tick.hasLight; j++) {
            if (light(j) >= 0) {
                return true;
            }
        }
        return false;
    }

    /**
     * Limits the impulses of the rows from {@code from} to {@code to}, after they are filled and
     * before bodies get them. The bodies from {@code head} to {@code tail} have no others.
     */
    public void limit(int head, int tail, int from, int to, RefreshRow row) {
        if (!tick.hasLight) {
            return;
        }
        for (int k = head; k < tail; k++) {
            share[tick.order[k]] = 1;
        }
        for (int j = from; j < to; j++) {
            int slot = light(j);
            if (slot >= 0 && !jointed.test(slot)) {
                share[slot] = 0;
            }
        }
        boolean any = false;
        for (int k = head; k < tail; k++) {
            int i = tick.order[k];
            if (share[i] == 0) {
                share[i] = share(i);
                any |= share[i] < 1;
            }
        }
        for (int j = from; any && j < to; j++) {
            int l = j * ConstraintRows.LINK;
            double kept = Math.min(kept(rows.link[l]), kept(rows.link[l + 1]));
            if (kept < 1 && rows.points(j) > 0) {
                row.scale(rows, tick.body.warm, j, kept);
            }
        }
    }

    /** The slot of the body of a row that is light beside the other; -1 if neither is. */
    private int light(int j) {
        int a = rows.link[j * ConstraintRows.LINK];
        int b = rows.link[j * ConstraintRows.LINK + 1];
        // rows that fill groups of lanes up have no points
        if (rows.points(j) == 0 || !tick.body.isMoved(a) || !tick.body.isMoved(b)) {
            return -1;
        }
        int i = SolverBodies.slot(a);
        int k = SolverBodies.slot(b);
        if (SolverBodies.isLight(tick.bodies, i, k)) {
            return i;
        }
        return SolverBodies.isLight(tick.bodies, k, i) ? k : -1;
    }

    /** The share that a body at an offset of the state keeps. */
    private double kept(int offset) {
        return tick.body.isMoved(offset) ? share[SolverBodies.slot(offset)] : 1;
    }

    private double share(int i) {
        SolverBodies s = tick.body;
        BodyStore b = tick.bodies;
        if (rows.isSingle) {
            s.addWarm(i);
        }
        int o = SolverBodies.offset(i);
        int w = (i + 1) * SolverBodies.HALF;
        double inverse = s.state[o + SolverBodies.MASS];
        double size = square(s.warm, w, inverse);
        double speed = square(s.state, o + SolverBodies.V, inverse);
        // what the torque gives: L^T T, over the root of the mass
        double[] r = s.root;
        int q = (i + 1) * SolverBodies.ROOT;
        double turn = 0;
        for (int c = 0; c < 3; c++) {
            double t = r[q + c] * b.torqueX[i];
            t += r[q + 3 + c] * b.torqueY[i] + r[q + 6 + c] * b.torqueZ[i];
            turn += inverse * t * t;
        }
        double push = inverse * SolverBodies.norm(b.forceX[i], b.forceY[i], b.forceZ[i]);
        double fall = s.state[o + SolverBodies.GRAVITY] * tick.weight();
        fall *= Math.abs(b.gravityScale[i]);
        double given = tick.subStep * (fall + push + Math.sqrt(turn));
        double most = Math.sqrt(speed) + FORCES * given;
        return size > most * most ? most / Math.sqrt(size) : 1;
    }

    /** Square of a weighted velocity over the mass, so that it is one of speeds. */
    private static double square(double[] v, int o, double inverse) {
        double linear = v[o] * v[o] + v[o + 1] * v[o + 1] + v[o + 2] * v[o + 2];
        double turn = v[o + 3] * v[o + 3] + v[o + 4] * v[o + 4] + v[o + 5] * v[o + 5];
        return linear + inverse * turn;
    }
}
