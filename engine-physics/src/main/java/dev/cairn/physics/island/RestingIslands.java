package dev.cairn.physics.island;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.EdgeSource;

/**
 * Which islands may sleep, as wholes or but for bodies that go on moving, by the rule in the
 * package's essay.
 *
 * <p>Simulation thread; allocates only when slots are added.
 */
final class RestingIslands {
    /** A heap sleeps beside those of its bodies that move if they are one, or one in so many. */
    private static final int MOVERS = 16;

    private static final int NONE = -1;

    private final RestDetector detector;
    private final BodyStore bodies;
    private final EdgeSource[] edges;
    private final Islands islands = new Islands();

    /** Of the island of a root: whether a body in it forbids that it sleeps. */
    private boolean[] restless = {};

    /** Whether a body in it is not at rest by itself. */
    private boolean[] isHeap = {};

    /** How many in it are not even still. */
    private int[] movers = {};

    /** How many bodies it has, with those asleep that it touches. */
    private int[] size = {};

    /** The first of it that lies down. */
    private int[] head = {};

    RestingIslands(RestDetector detector, BodyStore bodies, EdgeSource... edges) {
        this.detector = detector;
        this.bodies = bodies;
        this.edges = edges;
    }

    void ensureSlots(int n) {
        islands.ensureSlots(n);
        restless = new boolean[n];
        isHeap = new boolean[n];
        movers = new int[n];
        size = new int[n];
        head = new int[n];
    }

    /**
     * Finds them.
     *
     * @param awake slots of the awake bodies, ascending
     * @param count how many there are
     * @param besideSleepers whether any body sleeps
     */
    void find(int[] awake, int count, boolean besideSleepers) {
        islands.build(bodies, edges, awake, count);
        for (int i = 0; i < count; i++) {
            int s = awake[i];
            restless[s] = false;
            isHeap[s] = false;
            movers[s] = 0;
            size[s] = 0;
            head[s] = NONE;
        }
        for (int i = 0; i < count; i++) {
            classify(awake[i]);
        }
        if (besideSleepers) {
            countSleepers();
        }
        for (int k = 1; k < edges.length; k++) {
            bind(edges[k]);
        }
        if (bodies.driven > 0) {
            for (EdgeSource source : edges) {
                markRestless(source);
            }
        }
    }

    /** Whether a body falls asleep now; asked once of each, in ascending order. */
    boolean sleeps(int s) {
        int root = islands.root(s);
        if (restless[root]
                || (isHeap[root] && size[root] == 1)
                || movers[root] > Math.max(1, size[root] / MOVERS)
                || (movers[root] > 0 && !detector.isStaying(s))) {
            return false;
        }
        if (head[root] == NONE) {
            head[root] = s;
        }
        return true;
    }

    /** The first of the sleepers of a body's island. */
    int head(int s) {
        return head[islands.root(s)];
    }

    /** Finds the islands only, and returns the name of a body's. */
    int link(int s, int[] awake, int count) {
        islands.build(bodies, edges, awake, count);
        return islands.root(s);
    }

    /** Name of the island of a body. */
    int root(int s) {
        return islands.root(s);
    }

    /** What a body that is awake means to its island, by the rule in the package's essay. */
    private void classify(int s) {
        int root = islands.root(s);
        size[root]++;
        if (detector.rests[s] && (islands.touched(s) || still(s))) {
            return;
        }
        isHeap[root] = true;
        if (detector.isStill(s)) {
            return;
        }
        movers[root]++;
        restless[root] |= !detector.maySleep[s];
    }

    /**
     * What is bound to a body that moves by another edge than a contact does not sleep beside it.
     */
    private void bind(EdgeSource source) {
        for (int i = 0; i < source.edges(); i++) {
            int a = source.edgeA(i);
            if (a >= 0) {
                bind(a);
                bind(source.edgeB(i));
            }
        }
    }

    private void bind(int s) {
        if (bodies.kind[s] == BodyStore.DYNAMIC && !detector.rests[s] && !detector.isStill(s)) {
            restless[islands.root(s)] = true;
        }
    }

    /** A body that touches a sleeping one counts as one among others, too. */
    private void countSleepers() {
        byte[] kind = bodies.kind;
        EdgeSource contacts = edges[0];
        for (int i = 0; i < contacts.edges(); i++) {
            int a = contacts.edgeA(i);
            if (a < 0) {
                continue;
            }
            int b = contacts.edgeB(i);
            if (kind[a] == BodyStore.DYNAMIC && kind[b] == BodyStore.ASLEEP) {
                size[islands.root(a)]++;
            } else if (kind[b] == BodyStore.DYNAMIC && kind[a] == BodyStore.ASLEEP) {
                size[islands.root(b)]++;
            }
        }
    }

    /** What touches a body that moves of itself does not rest, however slow that is. */
    private void markRestless(EdgeSource source) {
        byte[] kind = bodies.kind;
        for (int i = 0; i < source.edges(); i++) {
            int a = source.edgeA(i);
            if (a < 0) {
                continue;
            }
            int b = source.edgeB(i);
            boolean runs = source.runs(i);
            if (kind[a] == BodyStore.DYNAMIC && (runs || bodies.isMoved(b))) {
                restless[islands.root(a)] = true;
            } else if (kind[b] == BodyStore.DYNAMIC && (runs || bodies.isMoved(a))) {
                restless[islands.root(b)] = true;
            }
        }
    }

    private boolean still(int s) {
        BodyStore b = bodies;
        return b.velocityX[s] == 0
                && b.velocityY[s] == 0
                && b.velocityZ[s] == 0
                && b.angularVelocityX[s] == 0
                && b.angularVelocityY[s] == 0
                && b.angularVelocityZ[s] == 0;
    }
}
