package dev.cairn.physics.solver.load;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.EdgeList;

import java.util.Arrays;

/**
 * The tick in which a load goes: the body that pressed on a body at rest was removed, or taken
 * away.
 *
 * <p>The warm start of that tick still holds the old load, and so do the offsets: they would throw
 * up what is left. So in the island of such a body the offsets start anew, and after the first warm
 * start the hard normals and the friction are swept until the impulses fit the load that is left.
 */
public final class Unloading {
    /** A load is gone if the body is pressed less by so many times its own weight. */
    private static final double SHARE = 0.5;

    private double[] now = {};
    private int[] contactsNow = {};
    private boolean[] marked = {};
    private boolean found;

    /**
     * Marks the rows of the islands that have lost a load.
     *
     * @param perImpulse force of a stored impulse, 1/s
     * @param g gravity, m/s²
     * @param same whether the rows are those of the last tick: then no body has lost a contact
     * @return whether there is one
     */
    public boolean find(BodyStore b, EdgeList list, double perImpulse, double g, boolean same) {
        if (same) {
            clear(list);
            return false;
        }
        if (now.length < b.slotCount) {
            now = new double[b.kind.length];
            contactsNow = new int[now.length];
            marked = new boolean[now.length];
        }
        Arrays.fill(now, 0, b.slotCount, 0.0);
        Arrays.fill(contactsNow, 0, b.slotCount, 0);
        for (int m = 0; m < list.contacts; m++) {
            list.rows(m).settleMark[list.place[m]] = 0;
            double force = list.impulse[m] * perImpulse;
            add(list.slotA[m], force);
            add(list.slotB[m], force);
        }
        boolean any = false;
        for (int i = 0; i < b.slotCount; i++) {
            boolean lost =
                    b.kind[i] == BodyStore.DYNAMIC
                            && contactsNow[i] < b.pressing[i]
                            && b.restTicks[i] >= LoadSweep.HOLD
                            && (b.pressed[i] - now[i]) * b.inverseMass[i] > SHARE * g;
            marked[i] = lost;
            any |= lost;
        }
        if (any) {
            spread(list);
        }
        found = any;
        return any;
    }

    private void add(int slot, double force) {
        if (slot >= 0) {
            now[slot] += force;
            contactsNow[slot]++;
        }
    }

    /** Takes the marks of the last tick away. */
    private void clear(EdgeList list) {
        if (found) {
            Arrays.fill(list.floats.settleMark, (byte) 0);
            Arrays.fill(list.doubles.settleMark, (byte) 0);
            found = false;
        }
    }

    /** Marks all that hangs together with a body that is marked. */
    private void spread(EdgeList list) {
        boolean again = true;
        for (boolean forward = true; again; forward = !forward) {
            again = false;
            for (int k = 0; k < list.count; k++) {
                int m = forward ? k : list.count - 1 - k;
                int i = list.slotA[m];
                int j = list.slotB[m];
                boolean first = i >= 0 && marked[i];
                boolean second = j >= 0 && marked[j];
                if (!first && !second) {
                    continue;
                }
                if (m < list.contacts) {
                    list.rows(m).settleMark[list.place[m]] = 1;
                }
                again |= (i >= 0 && !first) || (j >= 0 && !second);
                if (i >= 0) {
                    marked[i] = true;
                }
                if (j >= 0) {
                    marked[j] = true;
                }
            }
        }
    }

    /** Adds what the rows press with to the bodies that move; blocks of a colour. */
    public static void press(
            BodyStore b, ContactStore c, ConstraintRows rows, double perImpulse, int from, int to) {
        for (int j = from; j < to; j++) {
            int l = j * ConstraintRows.LINK;
            if (rows.link[l + ConstraintRows.COUNT] == 0) {
                continue;
            }
            int row = rows.link[l + ConstraintRows.SOURCE];
            double sum = force(c, row, perImpulse);
            if (sum > 0) {
                if (b.kind[c.bodyA[row]] == BodyStore.DYNAMIC) {
                    b.pressed[c.bodyA[row]] += sum;
                    b.pressing[c.bodyA[row]]++;
                }
                if (b.kind[c.bodyB[row]] == BodyStore.DYNAMIC) {
                    b.pressed[c.bodyB[row]] += sum;
                    b.pressing[c.bodyB[row]]++;
                }
            }
        }
    }

    private static double force(ContactStore c, int row, double perImpulse) {
        double sum = 0;
        int end = ContactStore.POINTS * row + c.pointCount[row];
        for (int p = ContactStore.POINTS * row; p < end; p++) {
            sum += c.normalImpulse[p];
        }
        return sum * perImpulse;
    }
}
