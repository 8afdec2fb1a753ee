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
        double at = (index + 0.5) / sub.count - 0.5;
        islands.open(rows, bodies, from, to);
        for (int j = from; j < to; j++) {
            int root = islands.has(rows, j) ? root(rows, bodies.state, islands, j) : -1;
            if (root >= 0 && islands.begins(root)) {
                SweepLeaps leaps = islands.leaps(root);
                list(rows, bodies.state, islands, root, j, to, leaps);
                sweep(rows, bodies.state, sub, islands, root, leaps, scratch.doubles);
                boolean isBalanced = isAtRest(bodies.state, islands, root, at, leaps);
                for (int k = 0; k < leaps.rows; k++) {
                    islands.leave(rows, leaps.place[k], isBalanced);
                    if (isBalanced) {
                        preload(rows, bodies.state, contacts, sub, islands, leaps.place[k]);
                    } else {
                        forget(rows, bodies, islands, leaps.place[k]);
                    }
                }
            }
        }
    }

    /** Lists the rows and bodies of an island. */
    private static void list(
            ConstraintRows rows,
            double[] body,
            StaticStart islands,
            int root,
            int from,
            int to,
            SweepLeaps leaps) {
        for (int j = from; j < to; j++) {
            if (!islands.has(rows, j) || root(rows, body, islands, j) != root) {
                continue;
            }
            keep(rows, islands, j);
            leaps.place[leaps.rows++] = j;
            for (int side = 0; side < 2; side++) {
                int at = rows.link[j * LINK + side];
                if (body[at + MASS] != 0 && islands.takes(SolverBodies.slot(at))) {
                    leaps.body[leaps.bodies++] = at;
                }
            }
        }
        for (int k = 0; k < leaps.bodies; k++) {
            islands.putBack(SolverBodies.slot(leaps.body[k]));
        }
    }

    /** Sweeps an island until its impulses agree, or for as often as it may be. */
    private static void sweep(
            ConstraintRows rows,
            double[] body,
            SubStep sub,
            StaticStart islands,
            int root,
            SweepLeaps leaps,
            double[] st) {
        read(rows, body, leaps, true);
        for (int left = islands.sweeps(root); left > 0; left--) {
            double change = 0;
            double largest = 0;
            for (int k = 0; k < leaps.rows; k++) {
                int j = leaps.place[k];
                change = Math.max(change, again(rows, body, sub, j, st));
                int points = rows.link[j * LINK + ConstraintRows.COUNT];
                double load = RowArithmetic.largest(rows.doubles, rows.base(j), rows.lanes, points);
                largest = Math.max(largest, load);
            }
            if (leaps.areDone(change, largest, islands.agrees)) {
                return;
            }
            if (left > 1) {
                read(rows, body, leaps, false);
                leaps.leap(change);
                write(rows, body, leaps);
            }
        }
    }

    private static void read(
            ConstraintRows rows, double[] body, SweepLeaps leaps, boolean isStart) {
        double[] d = rows.doubles;
        int lanes = rows.lanes;
        for (int k = 0; k < leaps.rows; k++) {
            int o = rows.base(leaps.place[k]);
            int points = rows.link[leaps.place[k] * LINK + ConstraintRows.COUNT];
            int n = SweepLeaps.COUNTED * k;
            for (int p = 0; p < ContactStore.POINTS; p++) {
                tell(leaps, n + p, p < points ? d[impulse(o, lanes, p)] : 0, isStart);
            }
            int f = o + ConstraintRows.LAMBDA * lanes;
            tell(leaps, n + ContactStore.POINTS, d[f], isStart);
            tell(leaps, n + ContactStore.POINTS + 1, d[f + lanes], isStart);
            tell(leaps, leaps.twist(k), d[f + 2 * lanes], isStart);
        }
        for (int k = 0; k < leaps.bodies; k++) {
            for (int i = 0; i < SweepLeaps.SPEEDS; i++) {
                tell(leaps, leaps.speed(k) + i, body[leaps.body[k] + i], isStart);
            }
        }
    }

    private static void tell(SweepLeaps leaps, int at, double value, boolean isStart) {
        if (isStart) {
            leaps.start(at, value);
        } else {
            leaps.end(at, value);
        }
    }

    private static void write(ConstraintRows rows, double[] body, SweepLeaps leaps) {
        double[] d = rows.doubles;
        int lanes = rows.lanes;
        for (int k = 0; k < leaps.rows; k++) {
            int o = rows.base(leaps.place[k]);
            int n = SweepLeaps.COUNTED * k;
            for (int p = 0; p < rows.link[leaps.place[k] * LINK + ConstraintRows.COUNT]; p++) {
                d[impulse(o, lanes, p)] = /*(float)*/ leaps.next(n + p);
            }
            int f = o + ConstraintRows.LAMBDA * lanes;
            d[f] = /*(float)*/ leaps.next(n + ContactStore.POINTS);
            d[f + lanes] = /*(float)*/ leaps.next(n + ContactStore.POINTS + 1);
            d[f + 2 * lanes] = /*(float)*/ leaps.next(leaps.twist(k));
        }
        for (int k = 0; k < leaps.bodies; k++) {
            for (int i = 0; i < SweepLeaps.SPEEDS; i++) {
                body[leaps.body[k] + i] = /*(float)*/ leaps.next(leaps.speed(k) + i);
            }
        }
    }

    private static int impulse(int o, int lanes, int point) {
        int q = ConstraintRows.POINT + point * ConstraintRows.POINT_FIELDS;
        return o + (q + ConstraintRows.IMPULSE) * lanes;
    }

    private static boolean isAtRest(
            double[] body, StaticStart islands, int root, double at, SweepLeaps leaps) {
        double most = 0;
        for (int k = 0; k < leaps.bodies; k++) {
            most = Math.max(most, speed(body, leaps.body[k], islands, root, at));
        }
        return islands.isStill(most);
    }

    /** Square of the speed that a body has left, its turn weighed in: {@code v² + w'²/m}. */
    private static double speed(double[] body, int o, StaticStart islands, int root, double at) {
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

    /** One more sweep over a row of an island that starts; the largest change of an impulse. */
    private static double again(
            ConstraintRows rows, double[] body, SubStep sub, int j, double[] st) {
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
        return change;
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
