package dev.cairn.physics.contact.impact;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.sweep.Flight;

/**
 * Bodies that were struck and then are left to the solver, against what does not answer.
 *
 * <p>Problem: an impact at t is a change of velocity now and a shift of the start, so that a body
 * flies along the parabola that leads to where it is then. That start is below the floor on which
 * the body lies at t, by {@code a t²/2}. Before t that means nothing. But in the sub-step in which
 * the contact presses, a body moves by the velocity at its end and not along a parabola: what was
 * to come back to the floor stayed below it. In ticks of 1/30 s with one sub-step that is 5 mm.
 *
 * <p>So with u the time from the start of that sub-step to t, the body starts {@code a u²/2} higher
 * along the normals of its contacts: then the straight line of the solver leads to where it is at
 * t.
 *
 * <p>One thread; allocates only when something grows.
 */
final class LeftBodies {
    /** Time, and acceleration in flight. */
    private static final int STRIDE = 4;

    private final ColliderStore colliders;
    private final ContactStore contacts;
    private final StruckBodies bodies;
    private final double[] way = new double[3];
    private int[] list = {};
    private double[] left = {};
    private int count;

    LeftBodies(ColliderStore colliders, ContactStore contacts, StruckBodies bodies) {
        this.colliders = colliders;
        this.contacts = contacts;
        this.bodies = bodies;
    }

    void clear() {
        count = 0;
        int slots = colliders.bodies.slotCount;
        if (list.length < slots) {
            list = new int[slots + (slots >> 1)];
            left = new double[STRIDE * list.length];
        }
    }

    /** A body is left to the solver at a time, s. */
    void add(int body, Flight f, double time) {
        int at = STRIDE * count;
        list[count++] = body;
        left[at] = time;
        left[at + 1] = f.ax;
        left[at + 2] = f.ay;
        left[at + 3] = f.az;
    }

    /**
     * Moves the starts of all, when no one is followed any more.
     *
     * @param subStep of the solver, s
     */
    void settle(double subStep) {
        for (int i = 0; i < count; i++) {
            double time = left[STRIDE * i];
            double u = time - subStep * Math.floor(time / subStep);
            lift(list[i], STRIDE * i + 1, 0.5 * u * u);
        }
        count = 0;
    }

    private void lift(int body, int a, double half) {
        for (int c = 0; c < 3; c++) {
            way[c] = 0;
        }
        for (int link = bodies.head[body]; link >= 0; link = bodies.next[link]) {
            int row = link >> 1;
            int other = contacts.bodyA[row] == body ? contacts.bodyB[row] : contacts.bodyA[row];
            if (contacts.isSolved(row) && colliders.bodies.kind[other] != BodyStore.DYNAMIC) {
                double sign = contacts.bodyB[row] == body ? 1 : -1;
                double x = sign * contacts.normalX(row);
                double y = sign * contacts.normalY(row);
                double z = sign * contacts.normalZ(row);
                double miss =
                        -half * (x * left[a] + y * left[a + 1] + z * left[a + 2])
                                - (x * way[0] + y * way[1] + z * way[2]);
                if (miss > 0) {
                    way[0] += miss * x;
                    way[1] += miss * y;
                    way[2] += miss * z;
                }
            }
        }
        if (way[0] == 0 && way[1] == 0 && way[2] == 0) {
            return;
        }
        colliders.bodies.move(body, way[0], way[1], way[2]);
        for (int link = bodies.head[body]; link >= 0; link = bodies.next[link]) {
            int row = link >> 1;
            double sign = contacts.bodyB[row] == body ? 1 : -1;
            double apart =
                    sign
                            * (contacts.normalX(row) * way[0]
                                    + contacts.normalY(row) * way[1]
                                    + contacts.normalZ(row) * way[2]);
            int first = ContactStore.POINTS * row;
            for (int p = first; p < first + contacts.pointCount[row]; p++) {
                contacts.separation[p] += apart;
            }
        }
    }
}
