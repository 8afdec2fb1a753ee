package dev.cairn.physics.solver.load;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.EdgeList;

import java.util.Arrays;

/**
 * Riders on accelerating bodies: islands that are at rest beside kinematic bodies, in ticks in
 * which those change their velocity.
 *
 * <p>Their load is another one in each sub-step: {@code m (g - a)}, with {@code m a h'} of
 * leverage, and a is known, since a kinematic body does what it is told. A soft contact answers a
 * load that changes by l with giving way, by {@code l/k}, and an offset learns of it in a second: a
 * rider would be off by {@code a/w²}, w = 2 pi/4 of a sub-step, all the way, and tilted. So before
 * each sub-step hard normals and friction are swept until they agree, as in a {@link StaticStart},
 * from the impulses of the sub-step before, and the offsets take the change of the load. Where that
 * leaves a body moving beside what carries it, because it slips, tips or is lifted off, all is as
 * before the sweeps, and the island is not asked again in this tick.
 *
 * <p>Found by the simulation thread; an island is swept by the worker that has its batch. Allocates
 * only when a store has grown. Source: own study.
 */
public final class CarriedIslands extends StaticStart {
    /**
     * Contacts of an island times sweeps in a sub-step, at most; the island's own, so that riders
     * elsewhere do not matter.
     */
    private static final int VISITS = 1 << 13;

    /** Speed over what gravity adds to it in a sub-step, up to which an island is in balance. */
    private static final double BALANCED = 1e-4;

    /** By place of rows in doubles and in floats: whether the row is of an island that rides. */
    private boolean[] doubles = {}, floats = {};

    /** By smallest slot of an island: whether it rides. */
    private boolean[] rides = {};

    /** By smallest slot: change of the frame's velocity over the tick, m/s, three numbers. */
    private double[] ramp = {};

    /** By contact: impulses before the sweeps. */
    private double[] old = {};

    /** What is left is gone in the next sub-step. */
    public CarriedIslands() {
        agrees = 1e-10;
    }

    @Override
    SweepLeaps leaps() {
        return new AitkenLeaps();
    }

    /**
     * Finds them.
     *
     * @param still speed beside what carries it below which a body may be at rest, m/s
     * @param gain what gravity adds to a speed in a sub-step, m/s
     * @param sweeps over an island in a sub-step, at most
     */
    public void seek(
            BodyStore b, ContactStore c, EdgeList list, double still, double gain, int sweeps) {
        found = false;
        if (!b.surging) {
            return;
        }
        loose = BALANCED * BALANCED * gain * gain;
        ensureCapacity(b);
        ensureRiders(b, c, list);
        gather(b, list);
        clear(b, list);
        for (int m = 0; m < list.count; m++) {
            int root = island[list.mover(m)];
            rowsOf[root]++;
            // for now: whether the island does not ride
            swept[root] |= m >= list.contacts || !joinsFrame(b, c, list, m, root);
            if (m < list.contacts && surges(b, c, list.source[m])) {
                rides[root] = true;
                pace(b, c, list.source[m], root);
            }
        }
        for (int m = 0; m < list.contacts; m++) {
            int root = island[list.mover(m)];
            int source = list.source[m];
            swept[root] |=
                    !rests(b, c.bodyA[source], root, still)
                            || !rests(b, c.bodyB[source], root, still)
                            || list.rows(m).settleMark[list.place[m]] != 0;
        }
        for (int m = 0; m < list.contacts; m++) {
            int root = island[list.mover(m)];
            rides[root] &= !swept[root] && VISITS / rowsOf[root] >= FEWEST;
            if (rides[root]) {
                (list.rows(m).isSingle ? floats : doubles)[list.place[m]] = true;
                found = true;
            }
        }
        for (int k = 0; k < slotsUsed; k++) {
            int i = slots[k];
            swept[i] = false;
            if (island[i] == i && rides[i]) {
                sweepsLeft[i] = Math.min(sweeps, VISITS / rowsOf[i]);
                reserve(i);
            }
        }
    }

    private void clear(BodyStore b, EdgeList list) {
        int n = b.slotCount;
        Arrays.fill(doubles, 0, list.doubles.places, false);
        Arrays.fill(floats, 0, list.floats.places, false);
        Arrays.fill(rides, 0, n, false);
        Arrays.fill(swept, 0, n, false);
        Arrays.fill(framed, 0, n, false);
        Arrays.fill(frame, 0, 3 * n, 0.0);
        Arrays.fill(ramp, 0, 3 * n, 0.0);
    }

    private void ensureRiders(BodyStore b, ContactStore c, EdgeList list) {
        if (rides.length < b.slotCount) {
            int n = b.kind.length;
            rides = new boolean[n];
            ramp = new double[3 * n];
        }
        if (doubles.length < list.doubles.places) {
            doubles = new boolean[list.doubles.settleMark.length];
        }
        if (floats.length < list.floats.places) {
            floats = new boolean[list.floats.settleMark.length];
        }
        if (old.length < IMPULSES * c.pointCount.length) {
            old = new double[IMPULSES * c.pointCount.length];
        }
    }

    /**
     * Whether a body rides. Its inertia is its own then: one that follows its load would want more
     * friction to be taken along than there is.
     */
    public boolean has(int slot) {
        return found && rides[island[slot]];
    }

    /** How what carries an island speeds up; another body that does so otherwise is no frame. */
    private void pace(BodyStore b, ContactStore c, int row, int root) {
        int k = b.kind[c.bodyA[row]] == BodyStore.KINEMATIC ? c.bodyA[row] : c.bodyB[row];
        for (int n = 0; n < 3; n++) {
            ramp[3 * root + n] = b.ramp[BodyStore.RAMP * k + n];
        }
    }

    private boolean rests(BodyStore b, int i, int root, double still) {
        if (b.kind[i] != BodyStore.DYNAMIC) {
            return true;
        }
        double x = b.velocityX[i] - frame(root, 0, -0.5);
        double y = b.velocityY[i] - frame(root, 1, -0.5);
        double z = b.velocityZ[i] - frame(root, 2, -0.5);
        double turn =
                SolverBodies.norm(
                        b.angularVelocityX[i], b.angularVelocityY[i], b.angularVelocityZ[i]);
        return !(b.belts > 0 && b.hasBelt[i])
                && SolverBodies.norm(x, y, z) + turn * b.outerRadius[i] < still;
    }

    /** With the velocity of the sub-step: {@code v + at dv}. */
    @Override
    double frame(int root, int k, double at) {
        return frame[3 * root + k] + at * ramp[3 * root + k];
    }

    @Override
    boolean has(ConstraintRows rows, int place) {
        return (rows.isSingle ? floats : doubles)[place];
    }

    /** All are swept in each sub-step. */
    @Override
    void open(ConstraintRows rows, SolverBodies bodies, int from, int to) {
        for (int j = from; j < to; j++) {
            for (int side = 0; side < 2 && has(rows, j); side++) {
                int at = rows.link[ConstraintRows.LINK * j + side];
                if (bodies.state[at + SolverBodies.MASS] != 0) {
                    swept[islandOf(at)] = false;
                }
            }
        }
    }

    @Override
    void keep(int contact, int k, double impulse) {
        old[IMPULSES * contact + k] = impulse;
    }

    @Override
    void leave(ConstraintRows rows, int place, boolean isBalanced) {
        if (!isBalanced) {
            (rows.isSingle ? floats : doubles)[place] = false;
        }
    }

    @Override
    double before(int contact, int k) {
        return old[IMPULSES * contact + k];
    }

    @Override
    double knew(ContactStore c, int point) {
        return c.preload[point];
    }
}
