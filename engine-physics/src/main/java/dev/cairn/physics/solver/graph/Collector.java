package dev.cairn.physics.solver.graph;

import dev.cairn.core.job.BlockJob;
import dev.cairn.core.job.Blocks;
import dev.cairn.core.job.Jobs;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.RowList;

import java.util.Arrays;

/**
 * Lists the contacts that have points, finds which bodies they bind, and gives them batches,
 * colours and places.
 *
 * <p>Most ticks have the contacts of the tick before: then all of it still holds, and a comparison
 * is what is paid; where only presses what did not, the batches hold, and the colours are made
 * anew. So all persists, and yet is a function of the present contacts alone. Simulation thread,
 * the comparison in blocks; allocates only when a store has grown.
 */
public final class Collector {
    private static final int CONTACTS_PER_BLOCK = 1024;

    private final Colouring colouring;
    private final Batches batches;
    private final PairOrder order = new PairOrder();

    /** By row: the slots of its bodies, -1 for one that does not move; whether it was cold. */
    private int[] slotA = {};

    private int[] slotB = {};
    private boolean[] cold = {};
    private boolean[] bounces = {};
    private int[] points = {};

    /** By active contact of the last tick: its row in the store; its place in the list, or -1. */
    private int[] listed = {};

    private int[] at = {};
    private int active;

    private final BlockJob compare = this::compare;
    private BodyStore bodies = new BodyStore();
    private ContactStore contacts = new ContactStore();
    private int slots;
    private boolean together;

    /** Contacts with restitution. */
    private int bouncing;

    private int workers;
    private boolean stacked;

    /** What of the rows of this tick is as it was: who touches whom, and what colours follow. */
    private boolean sameList;

    private boolean sameBodies;

    private boolean sameColours;
    private boolean samePoints;

    public Collector(Colouring colouring, Batches batches) {
        this.colouring = colouring;
        this.batches = batches;
    }

    /**
     * Brings rows, guides, batches and colours up to date.
     *
     * @param guide receives who has contacts, see {@link SolverBodies#guide}
     * @param workerCount who may work at batches
     * @param floatsFrom rows of an island that are floats if there are as many
     * @param jobs runs the comparison
     * @return whether any two dynamic bodies touch
     */
    public boolean run(
            BodyStore bodyStore,
            ContactStore contactStore,
            RowList list,
            int[] guide,
            int workerCount,
            int floatsFrom,
            Jobs jobs) {
        bodies = bodyStore;
        contacts = contactStore;
        ensureRows(list);
        sameColours = true;
        samePoints = true;
        sameList = active == contacts.activeCount;
        if (sameList) {
            jobs.run(compare, Blocks.count(active, CONTACTS_PER_BLOCK));
        }
        sameBodies = sameList || list(list);
        sameBodies &= slots == bodies.slotCount;
        sameBodies &= together == bouncing > 0 && workers == workerCount;
        if (!sameBodies) {
            slots = bodies.slotCount;
            together = bouncing > 0;
            workers = workerCount;
            bind(list, guide);
            batches.cut(bodies, contacts, list, guide, together, workerCount, floatsFrom);
        }
        if (!sameList) {
            listBouncers(list);
        }
        if (!sameBodies || !sameColours) {
            colour(list);
        }
        if (!sameBodies || !sameColours || !samePoints) {
            colouring.finish(list, batches, points);
            link(list);
        }
        return stacked;
    }

    /** Whether the contacts with points, and their bodies, are those of the tick before. */
    public boolean isSame() {
        return sameBodies;
    }

    private void ensureRows(RowList list) {
        list.ensureCapacity(contacts.activeCount);
        int n = list.source.length;
        if (slotA.length < n) {
            slotA = Arrays.copyOf(slotA, n);
            slotB = Arrays.copyOf(slotB, n);
            cold = Arrays.copyOf(cold, n);
            bounces = Arrays.copyOf(bounces, n);
            points = Arrays.copyOf(points, n);
            listed = Arrays.copyOf(listed, n);
            at = Arrays.copyOf(at, n);
        }
    }

    /** Compares a range of contacts with the list; what differs is told by whoever finds it. */
    private void compare(int block, int worker) {
        byte[] kind = bodies.kind;
        int end = Blocks.end(block, CONTACTS_PER_BLOCK, active);
        for (int i = Blocks.begin(block, CONTACTS_PER_BLOCK); i < end; i++) {
            int c = contacts.active[i];
            int n = at[i];
            int count = contacts.pointCount[c];
            if (listed[i] != c || count > 0 != n >= 0) {
                sameList = false;
                return;
            }
            if (n < 0) {
                continue;
            }
            int a = contacts.bodyA[c];
            int b = contacts.bodyB[c];
            a = kind[a] == BodyStore.DYNAMIC ? a : -1;
            b = kind[b] == BodyStore.DYNAMIC ? b : -1;
            if (slotA[n] != a || slotB[n] != b || bounces[n] != contacts.restitution[c] > 0) {
                sameList = false;
                return;
            }
            boolean isCold = (a | b) >= 0 && isCold(contacts, c, count);
            if (cold[n] != isCold) {
                sameColours = false;
                cold[n] = isCold;
            }
            if (points[n] != count) {
                samePoints = false;
                points[n] = count;
            }
        }
    }

    /** Lists rows and those that bounce; whether they are those of the last tick. */
    private boolean list(RowList list) {
        byte[] kind = bodies.kind;
        boolean same = true;
        int n = 0;
        bouncing = 0;
        active = contacts.activeCount;
        for (int i = 0; i < active; i++) {
            listed[i] = contacts.active[i];
            at[i] = -1;
        }
        order.sort(contacts, bodies.slotCount);
        for (; n < order.count; n++) {
            int i = order.index[n];
            int c = contacts.active[i];
            at[i] = n;
            int a = contacts.bodyA[c];
            int b = contacts.bodyB[c];
            a = kind[a] == BodyStore.DYNAMIC ? a : -1;
            b = kind[b] == BodyStore.DYNAMIC ? b : -1;
            boolean isCold = (a | b) >= 0 && isCold(contacts, c, contacts.pointCount[c]);
            same &= list.source[n] == c && slotA[n] == a && slotB[n] == b;
            sameColours &= cold[n] == isCold;
            samePoints &= points[n] == contacts.pointCount[c];
            list.source[n] = c;
            slotA[n] = a;
            slotB[n] = b;
            cold[n] = isCold;
            points[n] = contacts.pointCount[c];
            bounces[n] = contacts.restitution[c] > 0;
            if (bounces[n]) {
                bouncing++;
            }
        }
        same &= list.count == n;
        list.count = n;
        return same;
    }

    /** Whether a contact had no impulse at the end of the last tick; most such have a gap. */
    private static boolean isCold(ContactStore c, int row, int points) {
        int p = ContactStore.POINTS * row;
        double sum = 0;
        for (int end = p + points; p < end; p++) {
            sum += c.normalImpulse[p];
        }
        return sum == 0;
    }

    private void bind(RowList list, int[] guide) {
        Arrays.fill(guide, 0, slots, SolverBodies.FREE);
        stacked = false;
        for (int m = 0; m < list.count; m++) {
            int a = slotA[m];
            int b = slotB[m];
            if ((a | b) >= 0) {
                guide[a] = SolverBodies.BOUND;
                guide[b] = SolverBodies.BOUND;
                stacked = true;
            } else {
                int i = Math.max(a, b);
                guide[i] = guide[i] == SolverBodies.FREE ? m : SolverBodies.BOUND;
            }
        }
    }

    /** Tells the rows of either precision which of them bounce. */
    private void listBouncers(RowList list) {
        list.floats.bouncing = 0;
        list.doubles.bouncing = 0;
        for (int m = 0; m < list.count && bouncing > 0; m++) {
            if (bounces[m]) {
                ConstraintRows rows = list.rows(m);
                rows.bouncer[rows.bouncing++] = m;
            }
        }
    }

    private void colour(RowList list) {
        colouring.begin(slots, list.source.length);
        for (int m = 0; m < list.count; m++) {
            int a = slotA[m];
            int b = slotB[m];
            if ((a | b) >= 0) {
                colouring.add(m, a, b, cold[m], batches.isLockstep(m));
            } else {
                colouring.addFixed(m, Math.max(a, b));
            }
        }
    }

    private void link(RowList list) {
        for (int m = 0; m < list.count; m++) {
            int l = list.place[m] * ConstraintRows.LINK;
            ConstraintRows rows = list.rows(m);
            rows.link[l] = slotA[m] >= 0 ? SolverBodies.offset(slotA[m]) : 0;
            rows.link[l + 1] = slotB[m] >= 0 ? SolverBodies.offset(slotB[m]) : 0;
            rows.link[l + ConstraintRows.COUNT] = points[m];
            rows.link[l + ConstraintRows.SOURCE] = list.source[m];
            rows.unloaded[list.place[m]] = 0;
        }
    }
}
