package dev.cairn.physics.solver.load;

import static dev.cairn.physics.solver.body.SolverBodies.norm;

import dev.cairn.core.job.BlockJob;
import dev.cairn.core.job.Blocks;
import dev.cairn.core.job.Jobs;
import dev.cairn.core.state.StateVisitor;
import dev.cairn.core.state.Stateful;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.row.EdgeList;
import dev.cairn.physics.tuning.Tunable;
import dev.cairn.physics.tuning.Tuning;

import java.util.Arrays;

/**
 * Load-proportional inertia: a body that rests under a load is solved as if it had the inertia of
 * that load.
 *
 * <p>Sweeps over contacts converge slowly where a heavy body rests on a light one, and a column of
 * soft contacts buckles under its own weight, because the springs are sized by the mass of one
 * body, not by what stands on it. So while a body is at rest its mass and inertia <i>in the
 * solver</i> are multiplied by {@code s = kappa load / weight}, and gravity is divided by {@code
 * s}: forces, impulses and everything static stay exactly what they were; only the answer to a
 * disturbance is slower. Hence the gates: a body that is hit, slips, accelerates, is deep inside
 * another or has nothing under it has (nearly) its own inertia at once, its neighbours to two
 * contacts with it, and gets the load's back slowly when all is still.
 *
 * <p>A body that touches nothing but what never moves is in no pile: it bears no load, and what it
 * did before counts only from the tick on in which another one joins it. So nothing that happens
 * elsewhere, and may make this work needed at all, is felt by it.
 *
 * <p>The load runs down in one sweep: bodies from the highest to the lowest, ties by slot, each
 * hands its weight and its load to what is under it, in proportion to the impulses of the last
 * tick. Loads run down over contacts; other kinds of constraints carry none yet. The order is a
 * function of the state alone. Speeds are measured by {@code sqrt(g r)} of the smaller body,
 * lengths by its radius, so that scenes of any size behave alike.
 *
 * <p>Simulation thread, what bodies and contacts tell by themselves in blocks; allocates only when
 * a store has grown. Source: own study.
 */
public final class LoadSweep implements Stateful {
    /** Contacts steeper than this (cosine with up) carry no load. */
    private static final double CARRIES = 0.2;

    /** A contact is closed within this share of the smaller inner radius. */
    private static final double CLOSED = 0.002;

    /** Overlap beyond this share of the smaller inner radius is not rest. */
    private static final double DEEP = 0.1;

    /** Closing speed of an impact over {@code sqrt(g r)}: 0.3 m/s for a cube of 1 m. */
    private static final double HIT = 0.135;

    /** Slip over {@code sqrt(g r)}: 0.1 m/s for a cube of 1 m. */
    private static final double SLIP = 0.045;

    /** A body that is disturbed keeps no more than so many times its own inertia. */
    private static final double LARGEST_FLOOR = 1000;

    private static final double DECAY = 0.7;

    /**
     * Share of the way to the load's inertia per tick. Faster, and piles that settle do not come to
     * rest: the gates make and unmake inertia in them.
     */
    private static final double RISE = 0.01;

    private static final double FALL = 0.1;

    /** Ticks of rest before the load counts. */
    public static final int HOLD = 18;

    /** {@link BodyStore#restTicks} of a body that has flown, or lain on what never moves. */
    private static final int ALONE = -1;

    private static final int HOPS = 2;
    private static final int BODIES_PER_BLOCK = 256;
    private static final int ROWS_PER_BLOCK = 512;
    private static final byte HURT = 1;
    private static final byte FALLS = 2;

    private final BlockJob measureJob = this::measure;
    private final BlockJob lookJob = this::look;
    private final BlockJob scaleJob = this::scale;

    private final HeightOrder order = new HeightOrder();
    private double[] load = {};
    private double[] reach = {};

    /** By body: {@link #HURT}, {@link #FALLS}, both, or 0 where nothing speaks against rest. */
    private byte[] reason = {};

    private byte[] next = {};

    /** By body: whether it touches another one that is dynamic or kinematic. */
    private boolean[] piled = {};

    /** Rows that carry a body: from {@code first} on, up to the next body's. */
    private int[] first = {};

    private int[] end = {};
    private int[] edge = {};

    /** By edge: the dynamic body that carries, or -1. */
    private int[] under = {};

    private int[] upper = {};
    private boolean raised;

    /** Whether a body is hurt, and whether a row carries another body than in the last tick. */
    private boolean hurt, moved;

    private boolean stale;

    /** Whether another state was restored since it ran. */
    private boolean renewed;

    private BodyStore bodies = new BodyStore();
    private ContactStore contacts = new ContactStore();
    private EdgeList list = new EdgeList();
    private int[] guide = {};
    private double upX, upY, upZ;
    private double gravity;
    private double stepSeconds;
    private Tuning settings = Tuning.DEFAULT;

    /**
     * Brings {@link BodyStore#inertiaScale} and {@link BodyStore#restTicks} of this tick up to
     * date.
     *
     * @param state its guide tells which bodies have contacts
     * @param stacked whether any two dynamic bodies touch
     * @param same whether rows and bodies are those of the last tick
     * @param jobs runs the blocks
     * @return false if nothing rests on anything that moves: all scales count as 1
     */
    public boolean run(
            BodyStore store,
            ContactStore contactStore,
            EdgeList rowList,
            SolverBodies state,
            double[] g,
            double step,
            Tuning solverSettings,
            boolean stacked,
            boolean same,
            Jobs jobs) {
        gravity = Math.sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
        if (!(gravity > 0) || !(stacked || raised)) {
            stale = true;
            raised = false;
            return false;
        }
        upX = -g[0] / gravity;
        upY = -g[1] / gravity;
        upZ = -g[2] / gravity;
        bodies = store;
        contacts = contactStore;
        list = rowList;
        guide = state.guide;
        stepSeconds = step;
        settings = solverSettings;
        ensureCapacity();
        int bodyBlocks = Blocks.count(bodies.slotCount, BODIES_PER_BLOCK);
        hurt = false;
        moved = false;
        boolean keeps = same && !stale && !renewed;
        jobs.run(measureJob, bodyBlocks);
        jobs.run(lookJob, Blocks.count(list.contacts, ROWS_PER_BLOCK));
        if (hurt) {
            spread();
        }
        if (!keeps || moved) {
            edges();
        }
        order.update(bodies, guide, keeps);
        descend();
        ground();
        raised = false;
        jobs.run(scaleJob, bodyBlocks);
        stale = false;
        renewed = false;
        return true;
    }

    /** Whether it ran in the last tick, and on what; lists and orders are made anew. */
    @Override
    public void state(StateVisitor s) {
        s.section("loads", this);
        stale = s.value("stale", stale);
        raised = s.value("raised", raised);
        renewed |= s.isRestoring();
    }

    private void ensureCapacity() {
        if (load.length < bodies.slotCount) {
            int n = bodies.kind.length;
            order.ensureCapacity(n);
            load = new double[n];
            reach = new double[n];
            reason = new byte[n];
            next = new byte[n];
            piled = new boolean[n];
            end = new int[n];
            first = new int[n + 1];
        }
        if (edge.length < list.source.length) {
            edge = new int[list.source.length];
            under = new int[edge.length];
            upper = new int[edge.length];
        }
    }

    /** Height, acceleration since the last tick, and largest speed of any point, of each body. */
    private void measure(int block, int worker) {
        BodyStore b = bodies;
        double inverse = 1 / (gravity * stepSeconds);
        int end = Blocks.end(block, BODIES_PER_BLOCK, b.slotCount);
        for (int i = Blocks.begin(block, BODIES_PER_BLOCK); i < end; i++) {
            reason[i] = 0;
            load[i] = 0;
            reach[i] = 0;
            if (b.kind[i] != BodyStore.DYNAMIC) {
                continue;
            }
            double vx = b.velocityX[i];
            double vy = b.velocityY[i];
            double vz = b.velocityZ[i];
            double wx = b.angularVelocityX[i];
            double wy = b.angularVelocityY[i];
            double wz = b.angularVelocityZ[i];
            double radius = b.outerRadius[i];
            reach[i] = norm(vx, vy, vz) + norm(wx, wy, wz) * radius;
            int o = 6 * i;
            double[] old = b.lastVelocity;
            boolean known = b.inertiaScale[i] > 0 && b.restTicks[i] != ALONE;
            piled[i] = false;
            if (known) {
                double a =
                        inverse
                                        * (norm(vx - old[o], vy - old[o + 1], vz - old[o + 2])
                                                + norm(
                                                                wx - old[o + 3],
                                                                wy - old[o + 4],
                                                                wz - old[o + 5])
                                                        * radius)
                                + pushed(i);
                b.unrest[i] = Math.max(a, DECAY * b.unrest[i]);
            } else {
                b.unrest[i] = pushed(i);
                b.restTicks[i] = b.inertiaScale[i] > 0 ? 0 : HOLD;
            }
            old[o] = vx;
            old[o + 1] = vy;
            old[o + 2] = vz;
            old[o + 3] = wx;
            old[o + 4] = wy;
            old[o + 5] = wz;
            order.height[i] = upX * b.positionX[i] + upY * b.positionY[i] + upZ * b.positionZ[i];
        }
    }

    /** What the force of this tick would do to a body alone, over gravity. */
    private double pushed(int i) {
        BodyStore b = bodies;
        return norm(b.forceX[i], b.forceY[i], b.forceZ[i]) * b.inverseMass[i] / gravity;
    }

    /** Marks disturbed bodies and carriers; a mark is the same whichever worker writes it. */
    private void look(int block, int worker) {
        int end = Blocks.end(block, ROWS_PER_BLOCK, list.contacts);
        for (int m = Blocks.begin(block, ROWS_PER_BLOCK); m < end; m++) {
            gate(m);
            int i = carried(m);
            if (upper[m] != i) {
                upper[m] = i;
                moved = true; // by whoever finds one
            }
        }
    }

    /** Marks the bodies of a contact that is of a pile; and that is hit, slips, or is deep. */
    private void gate(int m) {
        int source = list.source[m];
        int a = contacts.bodyA[source];
        int b = contacts.bodyB[source];
        if (bodies.isPile(a, b)) {
            piled[a] = true;
            piled[b] = true;
        }
        double radius = bodies.innerRadiusOfMoving(a, b);
        double unit = Math.sqrt(gravity * radius);
        int from = ContactStore.POINTS * source;
        int to = from + contacts.pointCount[source];
        boolean moving = reach[a] + reach[b] > SLIP * unit;
        for (int p = from; p < to; p++) {
            double s = contacts.separation[p];
            if (s < -DEEP * radius || (moving && disturbed(source, p, a, b, radius, unit))) {
                reason[a] = HURT;
                reason[b] = HURT;
                hurt = true; // by whoever finds one
                return;
            }
        }
    }

    private boolean disturbed(int source, int p, int a, int b, double radius, double unit) {
        BodyStore s = bodies;
        ContactStore c = contacts;
        double x = s.pointVelocityX(b, c.anchorBY(p), c.anchorBZ(p));
        double y = s.pointVelocityY(b, c.anchorBX(p), c.anchorBZ(p));
        double z = s.pointVelocityZ(b, c.anchorBX(p), c.anchorBY(p));
        x -= s.pointVelocityX(a, c.anchorAY(p), c.anchorAZ(p));
        y -= s.pointVelocityY(a, c.anchorAX(p), c.anchorAZ(p));
        z -= s.pointVelocityZ(a, c.anchorAX(p), c.anchorAY(p));
        double vn = x * c.normalX(source) + y * c.normalY(source) + z * c.normalZ(source);
        if (vn < -HIT * unit && c.separation[p] + vn * stepSeconds < 0) {
            return true;
        }
        double slip = SLIP * unit;
        return c.separation[p] < CLOSED * radius && x * x + y * y + z * z - vn * vn > slip * slip;
    }

    /** Neighbours of what is disturbed are, too. */
    private void spread() {
        for (int hop = 0; hop < HOPS; hop++) {
            boolean any = false;
            for (int m = 0; m < list.count; m++) {
                int a = list.slotA[m];
                int b = list.slotB[m];
                if ((a | b) >= 0 && reason[a] != reason[b]) {
                    next[a] = HURT;
                    next[b] = HURT;
                    any = true;
                }
            }
            if (!any) {
                return;
            }
            for (int i = 0; i < bodies.slotCount; i++) {
                reason[i] |= next[i];
                next[i] = 0;
            }
        }
    }

    /** Lists, for each body, the rows of the contacts that carry it. */
    private void edges() {
        int n = bodies.slotCount;
        Arrays.fill(first, 0, n + 1, 0);
        for (int m = 0; m < list.contacts; m++) {
            if (upper[m] >= 0) {
                first[upper[m] + 1]++;
            }
        }
        for (int i = 0; i < n; i++) {
            first[i + 1] += first[i];
            end[i] = first[i];
        }
        for (int m = 0; m < list.contacts; m++) {
            if (upper[m] >= 0) {
                int e = end[upper[m]]++;
                edge[e] = m;
                under[e] = list.slotA[m] == upper[m] ? list.slotB[m] : list.slotA[m];
            }
        }
    }

    /** The dynamic body that a row carries, or -1. */
    private int carried(int m) {
        int source = list.source[m];
        double up =
                upX * contacts.normalX(source)
                        + upY * contacts.normalY(source)
                        + upZ * contacts.normalZ(source);
        if (Math.abs(up) <= CARRIES) {
            return -1;
        }
        int a = contacts.bodyA[source];
        int b = contacts.bodyB[source];
        int above = up > 0 ? b : a;
        if (bodies.kind[above] != BodyStore.DYNAMIC) {
            return -1;
        }
        double limit = CLOSED * bodies.innerRadiusOfMoving(a, b);
        int end = ContactStore.POINTS * source + contacts.pointCount[source];
        for (int p = ContactStore.POINTS * source; p < end; p++) {
            if (contacts.separation[p] < limit || contacts.normalImpulse[p] > 0) {
                return above;
            }
        }
        return -1;
    }

    /** Hands weights and loads down. */
    private void descend() {
        for (int k = 0; k < order.count; k++) {
            int i = order.body[k];
            double lift = upX * bodies.forceX[i] + upY * bodies.forceY[i] + upZ * bodies.forceZ[i];
            double own = gravity * bodies.gravityScale[i] / bodies.inverseMass[i];
            double force = Math.max(0, load[i] + own - lift);
            double sum = 0;
            for (int e = first[i]; e < first[i + 1]; e++) {
                sum += list.impulse[edge[e]];
            }
            for (int e = first[i]; e < first[i + 1]; e++) {
                int j = under[e];
                if (j >= 0 && order.isBefore(i, j)) {
                    // in equal parts where nothing presses yet
                    double part =
                            sum > 0 ? list.impulse[edge[e]] / sum : 1.0 / (first[i + 1] - first[i]);
                    load[j] += force * part;
                }
            }
        }
    }

    /** Marks what stands on nothing: from the lowest up, ground is handed on by what touches it. */
    private void ground() {
        for (int k = order.count - 1; k >= 0; k--) {
            int i = order.body[k];
            if (!stands(i)) {
                reason[i] |= FALLS;
            }
        }
    }

    private boolean stands(int i) {
        for (int e = first[i]; e < first[i + 1]; e++) {
            int j = under[e];
            if (j < 0) {
                return true;
            }
            if (order.isBefore(i, j) && (reason[j] & FALLS) == 0) {
                return true;
            }
        }
        return false;
    }

    /** Once a body is in no pile, and no load is left; all are in none in a tick without loads. */
    public static void leave(BodyStore b, int i) {
        b.inertiaScale[i] = 1;
        b.restTicks[i] = ALONE;
    }

    private void scale(int block, int worker) {
        BodyStore b = bodies;
        boolean any = false;
        double limit = settings.get(Tunable.REST_ACCELERATION);
        int end = Blocks.end(block, BODIES_PER_BLOCK, b.slotCount);
        for (int i = Blocks.begin(block, BODIES_PER_BLOCK); i < end; i++) {
            if (b.kind[i] != BodyStore.DYNAMIC) {
                continue;
            }
            boolean flies = guide[i] == SolverBodies.FREE;
            if (flies || !(piled[i] || b.inertiaScale[i] > 1)) {
                leave(b, i);
                continue;
            }
            double own = gravity / b.inverseMass[i];
            double wanted = Math.max(1, settings.get(Tunable.LOAD_INERTIA) * load[i] / own);
            double floor =
                    Math.max(
                            1,
                            Math.min(LARGEST_FLOOR, settings.get(Tunable.INERTIA_FLOOR) * wanted));
            double unrest = b.unrest[i];
            wanted = floor + (wanted - floor) * Math.max(0, Math.min(1, 2 - 2 * unrest / limit));
            boolean still = reason[i] == 0 && !(unrest > limit);
            b.restTicks[i] = still ? Math.min(HOLD, b.restTicks[i] + 1) : 0;
            double s = b.inertiaScale[i];
            if (b.restTicks[i] < HOLD) {
                wanted = floor;
            }
            if ((reason[i] & FALLS) != 0) {
                s = 1;
            } else if (reason[i] != 0) {
                s = floor;
                b.unrest[i] = Math.max(unrest, 2 * limit);
            } else if (!(s > 0)) {
                s = wanted;
            } else if (pushed(i) > limit) {
                // what is pulled answers with its own mass from the first tick on
                s = floor;
            } else {
                s += (wanted > s ? RISE : FALL) * (wanted - s);
                s = s < 1.001 && wanted == 1 ? 1 : s;
            }
            b.inertiaScale[i] = s;
            any |= s > 1;
        }
        if (any) {
            raised = true; // by whoever finds one
        }
    }
}
