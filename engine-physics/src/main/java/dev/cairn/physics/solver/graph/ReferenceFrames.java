package dev.cairn.physics.solver.graph;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.EdgeSource;
import dev.cairn.physics.island.Islands;
import dev.cairn.physics.solver.row.EdgeList;

import java.util.Arrays;

/**
 * Islands that are carried evenly, on a belt of tiles, a train or a lift, are solved in the frame
 * of reference of what carries them, in which it stands still.
 *
 * <p>Problem: laws of motion are the same in each frame that moves evenly (Galileo), and those of a
 * solver are not, if it knows of bodies that stand still: a body on a single contact with one of
 * them gets its closed forms, what rests gets its load's inertia, a contact does no work, and a
 * tick's way tells whether levers are renewed. On a floor that moved at a walking pace a box slid
 * and rolled by other rules than on the ground.
 *
 * <p>So for the solve the velocity of the carrier is taken from the bodies of an island, and the
 * carrier is as good as fixed; afterwards it is added again, and with it the way of the tick. That
 * is for islands whose every contact with what does not answer is with kinematic bodies of one and
 * the same velocity, which do not turn, speed up, or have a surface that runs. Joints to these, and
 * whatever is told of the world at rest (damping, locked axes, a limit of speed), keep an island in
 * the world's frame.
 *
 * <p>Simulation thread. Allocates only while the number of bodies grows; worlds in which no body is
 * driven pay one comparison.
 */
public final class ReferenceFrames {
    /** No carrier yet. */
    private static final int NONE = -1;

    /** The island has no frame of its own. */
    private static final int WORLD = -2;

    private final Islands islands = new Islands();

    /** Contacts, and the edges of other kinds. */
    private EdgeSource[] sources = {};

    /** Dynamic bodies that are awake. */
    private int[] slots = {};

    /** By slot: the body whose velocity is that of the island's frame, or below 0. */
    private int[] carrier = {};

    private BodyStore bodies = new BodyStore();

    private int count;
    private boolean found;

    /** No frames yet. */
    public ReferenceFrames() {}

    /** Finds the frames of a tick, and goes over to them. */
    public void enter(BodyStore b, EdgeSource contacts, EdgeList list) {
        bodies = b;
        found = isAnyCarried(contacts);
        if (!found) {
            return;
        }
        list(contacts, list);
        gather();
        for (int k = 0; k < sources.length; k++) {
            choose(sources[k], k == 0);
        }
        for (int k = 0; k < count; k++) {
            int i = slots[k];
            if (b.motionFlags[i] != 0 || (b.belts > 0 && b.hasBelt[i])) {
                carrier[islands.root(i)] = WORLD;
            }
        }
        for (int k = 0; k < count; k++) {
            int of = carrier[islands.root(slots[k])];
            carrier[slots[k]] = of >= 0 && b.isMoved(of) ? of : WORLD;
        }
        shift(-1);
    }

    /**
     * Goes back to the frame of the world.
     *
     * @param stepSeconds length of the tick, s
     */
    public void leave(double stepSeconds) {
        if (!found) {
            return;
        }
        shift(1);
        BodyStore b = bodies;
        for (int k = 0; k < count; k++) {
            int c = carrier[slots[k]];
            if (c >= 0) {
                b.move(
                        slots[k],
                        stepSeconds * b.velocityX[c],
                        stepSeconds * b.velocityY[c],
                        stepSeconds * b.velocityZ[c]);
            }
        }
    }

    /**
     * Whether a body is solved in a frame of its own: then what carries it stands still.
     *
     * @param slot of a dynamic body
     */
    boolean has(int slot) {
        return found && carrier[slot] >= 0;
    }

    private boolean isAnyCarried(EdgeSource contacts) {
        for (int i = 0; bodies.driven > 0 && i < contacts.edges(); i++) {
            int a = contacts.edgeA(i);
            if (a >= 0 && (bodies.isMoved(a) || bodies.isMoved(contacts.edgeB(i)))) {
                return true;
            }
        }
        return false;
    }

    private void gather() {
        int n = bodies.slotCount;
        if (carrier.length < n) {
            carrier = new int[bodies.kind.length];
            slots = new int[bodies.kind.length];
        }
        islands.ensureSlots(carrier.length);
        Arrays.fill(carrier, 0, n, NONE);
        count = 0;
        for (int i = 0; i < n; i++) {
            if (bodies.kind[i] == BodyStore.DYNAMIC) {
                slots[count++] = i;
            }
        }
        islands.build(bodies, sources, slots, count);
    }

    private void list(EdgeSource contacts, EdgeList list) {
        if (sources.length != 1 + list.kinds.length) {
            sources = new EdgeSource[1 + list.kinds.length];
        }
        sources[0] = contacts;
        for (int k = 1; k < sources.length; k++) {
            sources[k] = list.kinds[k - 1].source();
        }
    }

    /** Notes what carries each island. */
    private void choose(EdgeSource edges, boolean areContacts) {
        byte[] kind = bodies.kind;
        for (int i = 0; i < edges.edges(); i++) {
            int a = edges.edgeA(i);
            if (a < 0) {
                continue;
            }
            int b = edges.edgeB(i);
            boolean movesA = kind[a] == BodyStore.DYNAMIC;
            if (movesA == (kind[b] == BodyStore.DYNAMIC)) {
                if (movesA && edges.runs(i)) {
                    carrier[islands.root(a)] = WORLD;
                }
                continue;
            }
            int root = islands.root(movesA ? a : b);
            int other = movesA ? b : a;
            int before = carrier[root];
            if (!areContacts || edges.runs(i) || !isEven(other)) {
                carrier[root] = WORLD;
            } else if (before == NONE) {
                carrier[root] = other;
            } else if (before >= 0 && !isAlike(before, other)) {
                carrier[root] = WORLD;
            }
        }
    }

    /** Whether what does not answer neither turns nor speeds up. */
    private boolean isEven(int slot) {
        BodyStore b = bodies;
        if (b.kind[slot] != BodyStore.KINEMATIC) {
            return true;
        }
        boolean speedsUp = b.surges[slot];
        for (int n = 0; n < BodyStore.RAMP; n++) {
            speedsUp |= b.ramp[BodyStore.RAMP * slot + n] != 0;
        }
        return !speedsUp
                && b.angularVelocityX[slot] == 0
                && b.angularVelocityY[slot] == 0
                && b.angularVelocityZ[slot] == 0;
    }

    /** Whether two bodies that do not answer have one velocity. */
    private boolean isAlike(int i, int j) {
        BodyStore b = bodies;
        boolean moves = b.isMoved(i);
        return moves == b.isMoved(j)
                && (!moves
                        || (b.velocityX[i] == b.velocityX[j]
                                && b.velocityY[i] == b.velocityY[j]
                                && b.velocityZ[i] == b.velocityZ[j]));
    }

    /** Adds the velocity of the frames to that of bodies, or takes it. */
    private void shift(int sign) {
        BodyStore b = bodies;
        for (int k = 0; k < count; k++) {
            int i = slots[k];
            int c = carrier[i];
            if (c < 0) {
                continue;
            }
            double x = sign * b.velocityX[c];
            double y = sign * b.velocityY[c];
            double z = sign * b.velocityZ[c];
            b.velocityX[i] += x;
            b.velocityY[i] += y;
            b.velocityZ[i] += z;
            // the load sweep looks at the change since the last tick
            b.lastVelocity[6 * i] += x;
            b.lastVelocity[6 * i + 1] += y;
            b.lastVelocity[6 * i + 2] += z;
        }
    }
}
