package dev.cairn.physics.solver.impact;

import static dev.cairn.physics.solver.row.ConstraintRows.FRICTION;
import static dev.cairn.physics.solver.row.ConstraintRows.GAP;
import static dev.cairn.physics.solver.row.ConstraintRows.IMPULSE;
import static dev.cairn.physics.solver.row.ConstraintRows.LAMBDA;
import static dev.cairn.physics.solver.row.ConstraintRows.LINK;
import static dev.cairn.physics.solver.row.ConstraintRows.MASS_A;
import static dev.cairn.physics.solver.row.ConstraintRows.MASS_B;
import static dev.cairn.physics.solver.row.ConstraintRows.POINT;
import static dev.cairn.physics.solver.row.ConstraintRows.SUM;
import static dev.cairn.physics.solver.row.ConstraintRows.TOTAL;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.solver.body.AxisLocks;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.body.SolverContext;
import dev.cairn.physics.solver.kernel.PrepareRow;
import dev.cairn.physics.solver.kernel.ScalarFriction;
import dev.cairn.physics.solver.kernel.WarmStart;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.EdgeList;
import dev.cairn.physics.solver.row.RowWindow;

import java.util.Arrays;

/**
 * Impacts of ball on ball, as of billiard balls: at the time when their distance is the sum of
 * their radii, along the line between their centres then.
 *
 * <p>The general way of {@link Impacts} keeps the normal of the tick's start. Two balls that meet
 * off centre turn about each other while they approach, so that normal is a little wrong, and an
 * impulse along it, at two points that are not one, makes angular momentum. Here the relative path
 * {@code p + v t + a t²/2} is followed to {@code |..| = R}, and the row is aimed along it.
 *
 * <p>Balls that meet at the same time, as a cue ball meets two that touch, are struck together:
 * Newton's law for each pair, {@code v'_i >= -e v_i, l_i >= 0}, by steps that all pairs take at
 * once, so that what is symmetric stays symmetric. Pairs that pass each other without meeting get a
 * gap that the contact solver will not foresee to close.
 */
public final class BallImpacts {
    private static final int SWEEPS = 400;

    /** Share of a sub-step that is rounding. */
    private static final double SOON = Impacts.SOON;

    private final Impacts impacts;
    private final BallTimeOfImpact meeting = new BallTimeOfImpact();
    private final RowWindow window = new RowWindow();

    /** Share of a gap that is rounding. */
    private double soon;

    private final double[] acceleration = new double[6];

    /** The pairs that are struck together, by index among the bouncing rows. */
    private int[] pair = new int[8];

    /** Of each: normal at the impact, and gap along it at the tick's start. */
    private double[] normal = new double[24];

    private double[] gap = new double[8];

    /**
     * Of each: closing speed to reach, less what acceleration adds until the impact; impulse; and
     * change of the impulse in this sweep.
     */
    private double[] goal = new double[8];

    private double[] impulse = new double[8];
    private double[] change = new double[8];

    /** Velocities of both bodies before the impact, 12 to a pair. */
    private double[] before = new double[96];

    private int count;

    private final TurnedRows turned = new TurnedRows();

    // the step in work
    private ConstraintRows rows = new EdgeList().doubles;
    private SolverBodies bodies = new SolverBodies();
    private BodyStore store = new BodyStore();
    private ContactStore contacts = new ContactStore();
    private double[] g = {};

    /** The bouncing rows of the batch in work are those up to the end. */
    private int[] bouncer = {};

    private int end;
    private double h;
    private double threshold;

    public BallImpacts(Impacts impacts) {
        this.impacts = impacts;
    }

    void begin(
            ConstraintRows constraintRows,
            SolverContext tick,
            int[] bouncing,
            int bouncersEnd,
            double subStep,
            double restitutionThreshold) {
        turned.ensureCapacity(constraintRows.list.source.length);
        rows = constraintRows;
        bodies = tick.body;
        store = tick.bodies;
        contacts = tick.contacts;
        g = tick.gravity;
        bouncer = bouncing;
        end = bouncersEnd;
        h = subStep;
        soon = rows.isSingle ? Impacts.SOON_SINGLE : Impacts.SOON;
        threshold = restitutionThreshold;
    }

    /** End of the tick, when the rows are stored. */
    void report() {
        turned.report(rows, contacts);
    }

    /** Whether a bouncing row is one of two balls. */
    boolean isPair(int row) {
        return isPair(store, contacts, rows.list.source[row]);
    }

    /** The same of a row in the store. */
    static boolean isPair(BodyStore bodies, ContactStore contacts, int row) {
        return bodies.isBall[contacts.bodyA[row]] && bodies.isBall[contacts.bodyB[row]];
    }

    /**
     * Handles the impact of a pair, and those of later ones that meet a body of it at the same
     * time.
     *
     * @param k index among the bouncing rows
     * @return whether there was one
     */
    boolean visit(int k) {
        double time = timeOfImpact(bouncer[k]);
        if (time == Double.POSITIVE_INFINITY) {
            return false;
        }
        count = 0;
        take(k, time);
        for (int i = 0; i < count; i++) {
            for (int other = k + 1; other < end; other++) {
                if (touches(pair[i], other)
                        && isNew(other)
                        && isPair(bouncer[other])
                        && Math.abs(timeOfImpact(bouncer[other]) - time) <= SOON * h) {
                    take(other, time);
                }
            }
        }
        strike(time);
        return true;
    }

    private boolean isNew(int k) {
        for (int i = 0; i < count; i++) {
            if (pair[i] == k) {
                return false;
            }
        }
        return true;
    }

    private boolean touches(int k, int other) {
        int i = rows.list.place[bouncer[k]] * LINK;
        int j = rows.list.place[bouncer[other]] * LINK;
        int a = rows.link[i];
        int b = rows.link[i + 1];
        int c = rows.link[j];
        int d = rows.link[j + 1];
        return (a != 0 && (a == c || a == d)) || (b != 0 && (b == c || b == d));
    }

    /**
     * Time at which the balls of a row meet within the sub-step, faster than the threshold;
     * infinite where they do not.
     */
    private double timeOfImpact(int row) {
        int source = rows.list.source[row];
        int a = contacts.bodyA[source];
        int b = contacts.bodyB[source];
        int l = rows.list.place[row] * LINK;
        double[] s = bodies.state;
        int i = rows.link[l];
        int j = rows.link[l + 1];
        impacts.accelerate(i, g, acceleration, 0);
        impacts.accelerate(j, g, acceleration, 3);
        double px = distance(store.apartX(a, b), i, j, 0);
        double py = distance(store.apartY(a, b), i, j, 1);
        double pz = distance(store.apartZ(a, b), i, j, 2);
        double vx = s[j] - s[i];
        double vy = s[j + 1] - s[i + 1];
        double vz = s[j + 2] - s[i + 2];
        double ax = acceleration[3] - acceleration[0];
        double ay = acceleration[4] - acceleration[1];
        double az = acceleration[5] - acceleration[2];
        double far = store.innerRadius[a] + store.innerRadius[b];
        // what lies before their last impacts is no part of their paths
        double since = Math.max(impacts.since(i), impacts.since(j));
        px += since * (vx + 0.5 * since * ax);
        py += since * (vy + 0.5 * since * ay);
        pz += since * (vz + 0.5 * since * az);
        vx += since * ax;
        vy += since * ay;
        vz += since * az;
        double closing = px * vx + py * vy + pz * vz;
        double length = Math.sqrt(px * px + py * py + pz * pz);
        if (length <= far) {
            return closing < -threshold * length ? since : missed(row, length - far, since);
        }
        double t = meeting.find(px, py, pz, vx, vy, vz, ax, ay, az, far, h);
        if (!(since + t <= h)) {
            return missed(row, length - far, since);
        }
        if (meeting.speed < -threshold) {
            return since + Math.max(0, t);
        }
        separate(row, -(since + t) * alongNormal(row));
        return Double.POSITIVE_INFINITY;
    }

    private double distance(double apart, int i, int j, int axis) {
        int p = SolverBodies.P + axis;
        return apart + (bodies.state[j + p] - bodies.state[i + p]);
    }

    /**
     * Makes the separation of a pair that does not meet as large as it is, and so large that its
     * speed along the row's normal leaves it open: the balls are further apart than along a normal
     * that has aged.
     *
     * @param gap distance of the surfaces at {@code since}
     */
    private double missed(int row, double gap, double since) {
        double speed = alongNormal(row);
        double open = Math.max(gap - since * speed, -h * speed * (1 + soon));
        if (separation(row) < open) {
            separate(row, open);
        }
        return Double.POSITIVE_INFINITY;
    }

    /** Speed of separation along the row's normal at the end of the sub-step. */
    private double alongNormal(int row) {
        int place = rows.list.place[row];
        int o = rows.base(place);
        double[] s = bodies.state;
        int i = rows.link[place * LINK];
        int j = rows.link[place * LINK + 1];
        double speed = 0;
        for (int k = 0; k < 3; k++) {
            double v = s[j + k] - s[i + k] + h * (acceleration[3 + k] - acceleration[k]);
            speed += rows.get(o + k * rows.lanes) * v;
        }
        return speed;
    }

    /** Separation of a row along its normal at the start of the sub-step. */
    private double separation(int row) {
        return rows.get(rows.base(rows.list.place[row]) + GAP * rows.lanes) + parted(row);
    }

    /** How far the bodies of a row have parted along its normal since the tick's start, m. */
    private double parted(int row) {
        int l = rows.list.place[row] * LINK;
        int o = rows.base(rows.list.place[row]);
        int i = rows.link[l] + SolverBodies.P;
        int j = rows.link[l + 1] + SolverBodies.P;
        double sum = 0;
        for (int k = 0; k < 3; k++) {
            sum += rows.get(o + k * rows.lanes) * (bodies.state[j + k] - bodies.state[i + k]);
        }
        return sum;
    }

    /** The same however often: how often a pair is asked hangs on what else meets. */
    private void separate(int row, double value) {
        int o = rows.base(rows.list.place[row]);
        rows.put(o + GAP * rows.lanes, value - parted(row));
        rows.put(o + (POINT + ConstraintRows.SEPARATION) * rows.lanes, value);
    }

    /** Adds a pair to those that are struck: its normal, its goal, its impulses of before. */
    private void take(int k, double time) {
        if (count == pair.length) {
            int n = 2 * count;
            pair = Arrays.copyOf(pair, n);
            normal = Arrays.copyOf(normal, 3 * n);
            gap = Arrays.copyOf(gap, n);
            goal = Arrays.copyOf(goal, n);
            impulse = Arrays.copyOf(impulse, n);
            change = Arrays.copyOf(change, n);
            before = Arrays.copyOf(before, 12 * n);
        }
        int row = bouncer[k];
        int source = rows.list.source[row];
        int l = rows.list.place[row] * LINK;
        int i = rows.link[l];
        int j = rows.link[l + 1];
        double[] s = bodies.state;
        int a = contacts.bodyA[source];
        int b = contacts.bodyB[source];
        impacts.accelerate(i, g, acceleration, 0);
        impacts.accelerate(j, g, acceleration, 3);
        double px = distance(store.apartX(a, b), i, j, 0);
        double py = distance(store.apartY(a, b), i, j, 1);
        double pz = distance(store.apartZ(a, b), i, j, 2);
        double ax = acceleration[3] - acceleration[0];
        double ay = acceleration[4] - acceleration[1];
        double az = acceleration[5] - acceleration[2];
        double mx = time * (s[j] - s[i] + 0.5 * time * ax);
        double my = time * (s[j + 1] - s[i + 1] + 0.5 * time * ay);
        double mz = time * (s[j + 2] - s[i + 2] + 0.5 * time * az);
        px += mx;
        py += my;
        pz += mz;
        double inverse = 1 / Math.sqrt(px * px + py * py + pz * pz);
        px *= inverse;
        py *= inverse;
        pz *= inverse;
        normal[3 * count] = px;
        normal[3 * count + 1] = py;
        normal[3 * count + 2] = pz;
        int p = SolverBodies.P;
        gap[count] =
                -(px * (s[j + p] - s[i + p] + mx)
                        + py * (s[j + p + 1] - s[i + p + 1] + my)
                        + pz * (s[j + p + 2] - s[i + p + 2] + mz));
        double early = time * (px * ax + py * ay + pz * az);
        double speed = px * (s[j] - s[i]) + py * (s[j + 1] - s[i + 1]) + pz * (s[j + 2] - s[i + 2]);
        goal[count] = -contacts.restitution[source] * Math.min(0, speed + early) - early;
        impulse[count] = 0;
        pair[count++] = k;
    }

    private void strike(double time) {
        double[] s = bodies.state;
        for (int n = 0; n < count; n++) {
            int l = rows.list.place[bouncer[pair[n]]] * LINK;
            System.arraycopy(s, rows.link[l], before, 12 * n, 6);
            System.arraycopy(s, rows.link[l + 1], before, 12 * n + 6, 6);
            aim(n);
        }
        solve();
        for (int n = 0; n < count; n++) {
            friction(n);
        }
        for (int n = 0; n < count; n++) {
            int l = rows.list.place[bouncer[pair[n]]] * LINK;
            for (int side = 0; side < 2; side++) {
                int at = rows.link[l + side];
                if (isFirst(n, side, at)) {
                    AxisLocks.lock(store, s, at);
                    impacts.shift(at, before, 12 * n + 6 * side, time);
                }
            }
        }
    }

    /** Whether a body of the struck pairs is met for the first time. */
    private boolean isFirst(int n, int side, int at) {
        for (int m = 0; m <= n; m++) {
            int l = rows.list.place[bouncer[pair[m]]] * LINK;
            for (int other = 0; other < (m < n ? 2 : side); other++) {
                if (rows.link[l + other] == at) {
                    return false;
                }
            }
        }
        return true;
    }

    /** Turns a row to the normal of the impact; its impulses so far leave the warm start. */
    private void aim(int n) {
        int row = bouncer[pair[n]];
        int source = rows.list.source[row];
        ConstraintRows look = window.open(rows, rows.list.place[row]);
        int place = window.place();
        int o = look.base(place);
        int lanes = look.lanes;
        double[] d = look.doubles;
        rows.drags.give(look, place, rows.list.place[row]);
        WarmStart.addNormals(look, bodies.warm, place, o, -1);
        WarmStart.addFriction(look, bodies.warm, place, o, -1);
        d[o + (POINT + IMPULSE) * lanes] = 0;
        for (int k = 0; k < 3; k++) {
            d[o + (LAMBDA + k) * lanes] = 0;
        }
        d[o + GAP * lanes] = gap[n];
        int p = ContactStore.POINTS * source;
        contacts.separation[p] = gap[n];
        double x = normal[3 * n];
        double y = normal[3 * n + 1];
        double z = normal[3 * n + 2];
        contacts.setNormal(source, x, y, z);
        double ra = store.innerRadius[contacts.bodyA[source]];
        double rb = store.innerRadius[contacts.bodyB[source]];
        contacts.setAnchors(p, ra * x, ra * y, ra * z, -rb * x, -rb * y, -rb * z);
        boolean again = d[o + SUM * lanes] != 0;
        if (again) {
            turned.takeOut(row, d, o, lanes);
        }
        PrepareRow.aim(look, bodies, contacts, place, source);
        if (again) {
            turned.turnFriction(d, o, lanes);
        }
        window.close(rows, rows.list.place[row]);
        rows.drags.hide(rows, rows.list.place[row], rows.list.place[row] + 1);
        rows.rolling.aim(rows, bodies, contacts, rows.list.place[row]);
    }

    /** {@code v_i >= goal_i, l_i >= 0}, complementary: one pair at once, more by common steps. */
    private void solve() {
        double[] s = bodies.state;
        int most = 1;
        for (int n = 0; n < count; n++) {
            int neighbours = 1;
            for (int m = 0; m < count; m++) {
                neighbours += m != n && touches(pair[n], pair[m]) ? 1 : 0;
            }
            most = Math.max(most, neighbours);
        }
        for (int sweep = 0; sweep < (most == 1 ? 1 : SWEEPS); sweep++) {
            double largest = 0;
            double sum = 0;
            for (int n = 0; n < count; n++) {
                int place = rows.list.place[bouncer[pair[n]]];
                int o = rows.base(place);
                int i = rows.link[place * LINK];
                int j = rows.link[place * LINK + 1];
                double v =
                        normal[3 * n] * (s[j] - s[i])
                                + normal[3 * n + 1] * (s[j + 1] - s[i + 1])
                                + normal[3 * n + 2] * (s[j + 2] - s[i + 2]);
                double w =
                        most
                                * (rows.get(o + MASS_A * rows.lanes)
                                        + rows.get(o + MASS_B * rows.lanes));
                change[n] = Math.max(0, impulse[n] + (goal[n] - v) / w) - impulse[n];
                impulse[n] += change[n];
                largest = Math.max(largest, Math.abs(change[n]));
                sum += impulse[n];
            }
            for (int n = 0; n < count; n++) {
                push(n, change[n]);
            }
            if (largest <= 1e-16 * sum) {
                return;
            }
        }
    }

    private void push(int n, double l) {
        double[] s = bodies.state;
        int place = rows.list.place[bouncer[pair[n]]];
        int o = rows.base(place);
        int i = rows.link[place * LINK];
        int j = rows.link[place * LINK + 1];
        double a = l * rows.get(o + MASS_A * rows.lanes);
        double b = l * rows.get(o + MASS_B * rows.lanes);
        for (int c = 0; c < 3; c++) {
            double x = normal[3 * n + c];
            if (i != 0) {
                s[i + c] -= a * x;
            }
            if (j != 0) {
                s[j + c] += b * x;
            }
        }
    }

    /** Friction of a pair, bounded by its impulse, and its totals. */
    private void friction(int n) {
        ConstraintRows look = window.open(rows, rows.list.place[bouncer[pair[n]]]);
        int place = window.place();
        int o = look.base(place);
        int lanes = look.lanes;
        double[] d = look.doubles;
        d[o + SUM * lanes] += impulse[n];
        if (d[o + FRICTION * lanes] > 0) {
            int i = look.link[place * LINK];
            int j = look.link[place * LINK + 1];
            d[o + (POINT + IMPULSE) * lanes] = impulse[n];
            ScalarFriction.solve(d, o, lanes, bodies.state, i, j, 1);
            for (int k = 0; k < 3; k++) {
                d[o + (TOTAL + k) * lanes] += d[o + (LAMBDA + k) * lanes];
                d[o + (LAMBDA + k) * lanes] = 0;
            }
            d[o + (POINT + IMPULSE) * lanes] = 0;
        }
        window.close(rows, rows.list.place[bouncer[pair[n]]]);
    }
}
