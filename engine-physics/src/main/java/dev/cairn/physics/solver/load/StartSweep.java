package dev.cairn.physics.solver.load;

import static dev.cairn.physics.solver.body.SolverBodies.MASS;
import static dev.cairn.physics.solver.kernel.CommonStep.NONE;
import static dev.cairn.physics.solver.row.ConstraintRows.FRICTION;
import static dev.cairn.physics.solver.row.ConstraintRows.LINK;

import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.kernel.RowArithmetic;
import dev.cairn.physics.solver.kernel.ScalarFriction;
import dev.cairn.physics.solver.kernel.ScalarNormals;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.Scratch;
import dev.cairn.physics.solver.row.SubStep;

/** The rows of islands that start at rest, swept until they agree, see {@link StaticStart}. */
public final class StartSweep implements StartPass {
    @Override
    public void start(
            ConstraintRows rows,
            SolverBodies bodies,
            ContactStore contacts,
            SubStep sub,
            int index,
            StaticStart islands,
            int from,
            int to,
            Scratch scratch) {
        double[] body = bodies.state;
        double at = (index + 0.5) / sub.count - 0.5;
        islands.open(rows, bodies, from, to);
        for (int j = from; j < to; j++) {
            if (islands.has(rows, j)) {
                keep(rows, islands, j);
            }
        }
        boolean again = true;
        for (int sweep = 0; again; sweep++) {
            for (int j = from; j < to; j++) {
                if (islands.has(rows, j)) {
                    again(rows, body, sub, islands, j, scratch.doubles);
                }
            }
            again = false;
            for (int j = from; j < to; j++) {
                if (islands.has(rows, j)) {
                    again |= islands.goesOn(root(rows, body, islands, j), sweep);
                }
            }
            if (again && StaticStart.isLookedAt(sweep)) {
                leap(rows, body, islands, sweep, from, to);
            }
        }
        for (int j = from; j < to; j++) {
            if (islands.has(rows, j)) {
                int l = j * LINK;
                int root = root(rows, body, islands, j);
                islands.moves(root, speed(body, rows.link[l], islands, root, at));
                islands.moves(root, speed(body, rows.link[l + 1], islands, root, at));
            }
        }
        for (int j = from; j < to; j++) {
            if (!islands.has(rows, j)) {
                continue;
            }
            boolean isBalanced = islands.isBalanced(root(rows, body, islands, j));
            islands.leave(rows, j, isBalanced);
            if (isBalanced) {
                preload(rows, body, contacts, sub, islands, j);
            } else {
                forget(rows, bodies, islands, j);
            }
        }
    }

    /**
     * Remembers impulses and velocities, or goes on from there as the last sweep did: velocities
     * are linear in impulses, so that both stay in step.
     */
    private static void leap(
            ConstraintRows rows, double[] body, StaticStart islands, int sweep, int from, int to) {
        boolean leaps = StaticStart.leaps(sweep);
        for (int pass = leaps ? 0 : 1; pass < 2; pass++) {
            for (int j = from; j < to; j++) {
                int root = islands.has(rows, j) ? root(rows, body, islands, j) : -1;
                if (root < 0 || !islands.isOpen(root)) {
                    continue;
                }
                if (pass == 0) {
                    bound(rows, islands, root, j);
                } else {
                    leap(rows, islands, root, j, leaps);
                    leap(body, islands, root, rows.link[j * LINK], sweep);
                    leap(body, islands, root, rows.link[j * LINK + 1], sweep);
                }
            }
        }
    }

    /** No normal impulse may become negative. */
    private static void bound(ConstraintRows rows, StaticStart islands, int root, int j) {
        int o = rows.base(j);
        for (int p = 0; p < rows.link[j * LINK + ConstraintRows.COUNT]; p++) {
            int q = o + (ConstraintRows.POINT + p * ConstraintRows.POINT_FIELDS) * rows.lanes;
            double impulse = rows.doubles[q + ConstraintRows.IMPULSE * rows.lanes];
            islands.bound(root, rows.link[j * LINK + ConstraintRows.SOURCE], p, impulse);
        }
    }

    private static void leap(
            ConstraintRows rows, StaticStart islands, int root, int j, boolean leaps) {
        double[] d = rows.doubles;
        int lanes = rows.lanes;
        int o = rows.base(j);
        int source = rows.link[j * LINK + ConstraintRows.SOURCE];
        for (int p = 0; p < rows.link[j * LINK + ConstraintRows.COUNT]; p++) {
            int q = o + (ConstraintRows.POINT + p * ConstraintRows.POINT_FIELDS) * lanes;
            int at = q + ConstraintRows.IMPULSE * lanes;
            d[at] = /*(float)*/ islands.impulse(root, source, p, d[at], leaps);
        }
        for (int f = 0; f < 3; f++) {
            int at = o + (ConstraintRows.LAMBDA + f) * lanes;
            int k = ContactStore.POINTS + f;
            d[at] = /*(float)*/ islands.impulse(root, source, k, d[at], leaps);
        }
    }

    private static void leap(double[] body, StaticStart islands, int root, int at, int sweep) {
        int slot = SolverBodies.slot(at);
        if (body[at + MASS] == 0 || !islands.takes(slot, sweep)) {
            return;
        }
        boolean leaps = StaticStart.leaps(sweep);
        for (int k = 0; k < 6; k++) {
            body[at + k] = /*(float)*/ islands.speed(root, slot, k, body[at + k], leaps);
        }
    }

    /** Square of the speed that a body has left, its turn weighed in: {@code v² + w'²/m}. */
    private static double speed(double[] body, int o, StaticStart islands, int root, double at) {
        if (body[o + MASS] == 0) {
            return 0;
        }
        double x = body[o] - /*(float)*/ islands.frame(root, 0, at);
        double y = body[o + 1] - /*(float)*/ islands.frame(root, 1, at);
        double z = body[o + 2] - /*(float)*/ islands.frame(root, 2, at);
        double v = x * x + y * y + z * z;
        double w =
                body[o + 3] * body[o + 3] + body[o + 4] * body[o + 4] + body[o + 5] * body[o + 5];
        return v + w * body[o + MASS];
    }

    private static void keep(ConstraintRows rows, StaticStart islands, int j) {
        double[] d = rows.doubles;
        int lanes = rows.lanes;
        int o = rows.base(j);
        int source = rows.link[j * LINK + ConstraintRows.SOURCE];
        for (int p = 0; p < rows.link[j * LINK + ConstraintRows.COUNT]; p++) {
            int q = o + (ConstraintRows.POINT + p * ConstraintRows.POINT_FIELDS) * lanes;
            islands.keep(source, p, d[q + ConstraintRows.IMPULSE * lanes]);
        }
        for (int f = 0; f < 3; f++) {
            double impulse = d[o + (ConstraintRows.LAMBDA + f) * lanes];
            islands.keep(source, ContactStore.POINTS + f, impulse);
        }
    }

    /** Row and bodies as they were before the sweeps. */
    private static void forget(
            ConstraintRows rows, SolverBodies bodies, StaticStart islands, int j) {
        double[] d = rows.doubles;
        int lanes = rows.lanes;
        int source = rows.link[j * LINK + ConstraintRows.SOURCE];
        int o = rows.base(j);
        for (int p = 0; p < rows.link[j * LINK + ConstraintRows.COUNT]; p++) {
            int q = o + (ConstraintRows.POINT + p * ConstraintRows.POINT_FIELDS) * lanes;
            d[q + ConstraintRows.IMPULSE * lanes] = /*(float)*/ islands.before(source, p);
        }
        for (int f = 0; f < 3; f++) {
            d[o + (ConstraintRows.LAMBDA + f) * lanes] =
                    /*(float)*/ islands.before(source, ContactStore.POINTS + f);
        }
        double[] body = bodies.state;
        for (int side = 0; side < 2; side++) {
            int at = rows.link[j * LINK + side];
            for (int k = 0; k < 6 && body[at + MASS] != 0; k++) {
                body[at + k] = /*(float)*/ bodies.mark[at / 2 + k];
            }
        }
    }

    private static int root(ConstraintRows rows, double[] body, StaticStart islands, int j) {
        int a = rows.link[j * LINK];
        return islands.islandOf(body[a + MASS] == 0 ? rows.link[j * LINK + 1] : a);
    }

    /** One more sweep over a row of an island that starts. */
    private static void again(
            ConstraintRows rows,
            double[] body,
            SubStep sub,
            StaticStart islands,
            int j,
            double[] st) {
        int root = root(rows, body, islands, j);
        if (!islands.isOpen(root)) {
            return;
        }
        double[] d = rows.doubles;
        int lanes = rows.lanes;
        int a = rows.link[j * LINK];
        int b = rows.link[j * LINK + 1];
        int n = rows.link[j * LINK + ConstraintRows.COUNT];
        int o = rows.base(j);
        ScalarNormals.hardenAll(d, o, lanes, n, sub, st);
        ScalarNormals.sweep(d, o, lanes, body, a, b, n, sub.sweeps, NONE, st);
        double change = 0;
        for (int p = 0; p < n; p++) {
            change = Math.max(change, Math.abs(st[Scratch.CHANGE + p]));
        }
        if (d[o + FRICTION * lanes] > 0) {
            int f = o + ConstraintRows.LAMBDA * lanes;
            double x = d[f];
            double y = d[f + lanes];
            double twist = d[f + 2 * lanes];
            ScalarFriction.solve(d, o, lanes, body, a, b, n);
            change = Math.max(change, Math.abs(d[f] - x));
            change = Math.max(change, Math.abs(d[f + lanes] - y));
            double radius = radius(d, o, lanes, n);
            if (radius > 0) {
                // as a force at the patch's rim
                change = Math.max(change, Math.abs(d[f + 2 * lanes] - twist) / radius);
            }
        }
        islands.note(root, change, RowArithmetic.largest(d, o, lanes, n));
    }

    /** Of a patch, m: the distance of its farthest point from its middle; 0 if it has one point. */
    private static double radius(double[] d, int o, int lanes, int points) {
        double most = 0;
        for (int p = 0; p < points; p++) {
            most = Math.max(most, d[o + (ConstraintRows.REACH + p) * lanes]);
        }
        return most;
    }

    /** The springs of the points hold the additional load: {@code offset = impulse/k}. */
    private static void preload(
            ConstraintRows rows,
            double[] body,
            ContactStore contacts,
            SubStep sub,
            StaticStart islands,
            int j) {
        double[] d = rows.doubles;
        int lanes = rows.lanes;
        int l = j * LINK;
        int o = rows.base(j);
        double stiffness =
                sub.stiffness(body[rows.link[l] + MASS] == 0 || body[rows.link[l + 1] + MASS] == 0);
        for (int p = 0; p < rows.link[l + ConstraintRows.COUNT]; p++) {
            int q = o + (ConstraintRows.POINT + p * ConstraintRows.POINT_FIELDS) * lanes;
            double k = d[q + ConstraintRows.MASS * lanes] * stiffness;
            double impulse = d[q + ConstraintRows.IMPULSE * lanes];
            int source = rows.link[l + ConstraintRows.SOURCE];
            double more = impulse - /*(float)*/ islands.before(source, p);
            double offset = k > 0 ? more / k : 0;
            if (k > 0 && sub.offsetGain > 0) {
                // of the sub-step before, as all that contacts know
                int point = ContactStore.POINTS * source + p;
                double load = /*(float)*/ (islands.knew(contacts, point) + more);
                contacts.preload[point] = load > 0 ? load / sub.fillScale : 0;
            }
            d[o + (ConstraintRows.GAP + p) * lanes] -= offset;
            d[q + ConstraintRows.SEPARATION * lanes] -= offset;
        }
    }
}
