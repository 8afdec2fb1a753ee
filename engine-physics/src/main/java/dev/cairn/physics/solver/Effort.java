package dev.cairn.physics.solver;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.island.Islands;

/**
 * How much work an island gets: how often its sub-steps are doubled.
 *
 * <p>Problem: a soft contact gives by {@code l / k} under a load {@code l}, and {@code k} grows
 * with the square of the sub-steps. What gives by a thousandth of a cube gives by half of a card of
 * 2 mm: a house of cards falls before offsets have learnt of its load, while for the cubes beside
 * it four sub-steps are plenty. So the residual of an island is its largest overlap over the inner
 * radius of the bodies there. Above {@value #STRAINED} its sub-steps are doubled, as often as would
 * bring that down if overlap fell with their square; below a sixteenth of that for {@value
 * #PATIENCE} ticks they are halved once, which lets it rise by four times and stay below. A body
 * that touches something for the first time is judged by the sag of its own weight, {@code g/w^2}
 * with the soft contact's {@code w}: after a tick it would be too late for the cards.
 *
 * <p>A function of the contacts and of the efforts before, by island: nothing else in the world
 * changes it, nor do workers or lanes. Islands that join take the largest effort among theirs.
 * Simulation thread; allocates only when slots are added.
 */
final class Effort {
    /** Overlap over inner radius. */
    static final double STRAINED = 0.01;

    /** Of the stiffness, when sub-steps are halved. */
    private static final double SOFTENED = 0.75;

    private static final double IDLE = STRAINED / 16;
    static final int PATIENCE = 30;

    /**
     * By slot of an island's root: its residual, and the largest effort and haste of its bodies.
     */
    private double[] strain = {};

    private byte[] effort = {};
    private byte[] idle = {};

    /**
     * Decides on the effort of this tick.
     *
     * @param list lists the contacts
     * @param islands of these contacts
     * @param bound bodies with contacts
     * @param most doublings
     * @param sag of a body of any mass on a soft contact without extra effort, m
     * @return whether it differs for any body from that of the last tick
     */
    boolean update(
            BodyStore b,
            ContactStore c,
            RowList list,
            Islands islands,
            int[] bound,
            int count,
            int most,
            double sag) {
        if (strain.length < b.slotCount) {
            strain = new double[b.kind.length];
            effort = new byte[b.kind.length];
            idle = new byte[b.kind.length];
        }
        for (int k = 0; k < count; k++) {
            strain[bound[k]] = 0;
            effort[bound[k]] = 0;
            idle[bound[k]] = Byte.MAX_VALUE;
        }
        for (int k = 0; k < count; k++) {
            int i = bound[k];
            int root = islands.root(i);
            int own = b.effort[i] >= 0 ? b.effort[i] : raised(0, sag / b.innerRadius[i], most);
            effort[root] = (byte) Math.max(effort[root], own);
            idle[root] = (byte) Math.min(idle[root], b.idleTicks[i]);
        }
        for (int m = 0; m < list.count; m++) {
            look(b, c, list.source[m], islands);
        }
        boolean changed = false;
        for (int k = 0; k < count; k++) {
            int i = bound[k];
            if (islands.root(i) == i) {
                decide(i, most);
            }
        }
        for (int k = 0; k < count; k++) {
            int i = bound[k];
            int root = islands.root(i);
            changed |= b.effort[i] != effort[root];
            b.effort[i] = effort[root];
            b.idleTicks[i] = idle[root];
        }
        return changed;
    }

    /**
     * Share of a resting point's gap that its offset takes in the last tick before contacts grow
     * soft, so that they hold the load that they held; 0 in all others.
     */
    static double softened(BodyStore b, ContactStore c, int row) {
        return isLeaving(b, c.bodyA[row]) || isLeaving(b, c.bodyB[row]) ? SOFTENED : 0;
    }

    private static boolean isLeaving(BodyStore b, int i) {
        return b.effort[i] > 0 && b.idleTicks[i] == PATIENCE;
    }

    /** The largest effort of all; 0 if there is only one. */
    int most(BodyStore b, int[] bound, int count, int paces) {
        int most = 0;
        for (int k = 0; k < count && paces > 1; k++) {
            most = Math.max(most, b.effort[bound[k]]);
        }
        return most;
    }

    private void look(BodyStore b, ContactStore c, int row, Islands islands) {
        int i = c.bodyA[row];
        int j = c.bodyB[row];
        double radius = Double.POSITIVE_INFINITY;
        int bodyThatMoves = i;
        if (b.kind[i] == BodyStore.DYNAMIC) {
            radius = b.innerRadius[i];
        }
        if (b.kind[j] == BodyStore.DYNAMIC) {
            radius = Math.min(radius, b.innerRadius[j]);
            bodyThatMoves = j;
        }
        double deepest = 0;
        int first = ContactStore.POINTS * row;
        for (int p = first; p < first + c.pointCount[row]; p++) {
            deepest = Math.max(deepest, -c.separation[p]);
        }
        int root = islands.root(bodyThatMoves);
        strain[root] = Math.max(strain[root], deepest / radius);
    }

    /** Overlap falls by four times with each doubling. */
    private static byte raised(int effort, double strain, int most) {
        int e = effort;
        for (double left = strain; left > STRAINED && e < most; left /= 4) {
            e++;
        }
        return (byte) e;
    }

    private void decide(int root, int most) {
        if (strain[root] > STRAINED) {
            idle[root] = 0;
            effort[root] = raised(effort[root], strain[root], most);
        } else if (idle[root] == PATIENCE) {
            idle[root] = 0;
            effort[root]--;
        } else if (strain[root] < IDLE && effort[root] > 0) {
            idle[root]++;
        } else {
            idle[root] = 0;
        }
    }
}
