package dev.cairn.physics.solver;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;

import java.util.Arrays;

/**
 * Lists the contacts that have points, finds which bodies they bind, and gives them batches,
 * colours and places.
 *
 * <p>Most ticks have the contacts of the tick before: then all of it still holds, and a comparison
 * is what is paid; where only presses what did not, the batches hold, and the colours are made
 * anew. So all persists, and yet is a function of the present contacts alone. Simulation thread;
 * allocates only when a store has grown.
 */
final class Collector {
    private final Colouring colouring;
    private final Batches batches;

    /** By row: the slots of its bodies, -1 for one that does not move; whether it was cold. */
    private int[] slotA = {};

    private int[] slotB = {};
    private boolean[] cold = {};
    private int[] points = {};
    private int slots;
    private boolean together;
    private int workers;
    private int doublings;
    private boolean stacked;

    /** What of the rows of this tick is as it was: who touches whom, and what colours follow. */
    private boolean sameBodies;

    private boolean sameColours;
    private boolean samePoints;

    Collector(Colouring colouring, Batches batches) {
        this.colouring = colouring;
        this.batches = batches;
    }

    /**
     * Brings rows, guides, batches and colours up to date.
     *
     * @param guide receives who has contacts, see {@link SolverBodies#guide}
     * @param workerCount who may work at batches
     * @param extra doublings of sub-steps that an island may get
     * @param sag of a body on a soft contact, m
     * @return whether any two dynamic bodies touch
     */
    boolean run(
            BodyStore bodies,
            ContactStore contacts,
            ConstraintRows rows,
            int[] guide,
            int workerCount,
            int extra,
            double sag) {
        rows.ensureRows(contacts.activeCount);
        if (slotA.length < rows.source.length) {
            slotA = Arrays.copyOf(slotA, rows.source.length);
            slotB = Arrays.copyOf(slotB, rows.source.length);
            cold = Arrays.copyOf(cold, rows.source.length);
            points = Arrays.copyOf(points, rows.source.length);
        }
        int before = rows.count;
        list(bodies, contacts, rows);
        sameBodies &= rows.count == before && slots == bodies.slotCount;
        sameBodies &= together == rows.bouncing > 0 && workers == workerCount;
        sameBodies &= doublings == extra;
        if (!sameBodies) {
            slots = bodies.slotCount;
            together = rows.bouncing > 0;
            workers = workerCount;
            doublings = extra;
            bind(rows, guide);
            batches.cut(bodies, contacts, rows, guide, together, workerCount, extra, sag);
        } else if (extra > 0 && batches.recut(bodies, contacts, rows, together, workerCount, sag)) {
            sameColours = false;
        }
        if (!sameBodies || !sameColours) {
            colour(rows);
            colouring.finish(rows, batches);
        }
        if (!sameBodies || !sameColours || !samePoints) {
            link(rows);
        }
        return stacked;
    }

    /** Lists rows and those that bounce, and compares them with those of the last tick. */
    private void list(BodyStore bodies, ContactStore contacts, ConstraintRows rows) {
        byte[] kind = bodies.kind;
        int n = 0;
        int bouncing = 0;
        sameBodies = true;
        sameColours = true;
        samePoints = true;
        for (int i = 0; i < contacts.activeCount; i++) {
            int c = contacts.active[i];
            int count = contacts.pointCount[c];
            if (count == 0) {
                continue;
            }
            int a = contacts.bodyA[c];
            int b = contacts.bodyB[c];
            a = kind[a] == BodyStore.DYNAMIC ? a : -1;
            b = kind[b] == BodyStore.DYNAMIC ? b : -1;
            boolean isCold = (a | b) >= 0 && isCold(contacts, c, count);
            if (rows.source[n] != c || slotA[n] != a || slotB[n] != b) {
                sameBodies = false;
                rows.source[n] = c;
                slotA[n] = a;
                slotB[n] = b;
            }
            if (cold[n] != isCold) {
                sameColours = false;
                cold[n] = isCold;
            }
            if (points[n] != count) {
                samePoints = false;
                points[n] = count;
            }
            if (contacts.restitution[c] > 0) {
                rows.bouncer[bouncing++] = n;
            }
            n++;
        }
        rows.count = n;
        rows.bouncing = bouncing;
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

    private void bind(ConstraintRows rows, int[] guide) {
        Arrays.fill(guide, 0, slots, SolverBodies.FREE);
        stacked = false;
        for (int m = 0; m < rows.count; m++) {
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

    private void colour(ConstraintRows rows) {
        colouring.begin(slots, rows.source.length);
        for (int m = 0; m < rows.count; m++) {
            int a = slotA[m];
            int b = slotB[m];
            if ((a | b) >= 0) {
                colouring.add(m, a, b, cold[m], batches.isLockstep(m));
            } else {
                colouring.addFixed(m, Math.max(a, b));
            }
        }
    }

    private void link(ConstraintRows rows) {
        for (int m = 0; m < rows.count; m++) {
            int l = rows.place[m] * ConstraintRows.LINK;
            rows.link[l] = slotA[m] >= 0 ? SolverBodies.offset(slotA[m]) : 0;
            rows.link[l + 1] = slotB[m] >= 0 ? SolverBodies.offset(slotB[m]) : 0;
            rows.link[l + ConstraintRows.COUNT] = points[m];
            rows.link[l + ConstraintRows.SOURCE] = rows.source[m];
            rows.unloaded[rows.place[m]] = 0;
        }
    }
}
