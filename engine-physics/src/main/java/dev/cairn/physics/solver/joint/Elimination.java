package dev.cairn.physics.solver.joint;

import java.util.Arrays;

/**
 * In which order bodies and joints of an assembly are eliminated, and what that fills.
 *
 * <p>The graph has a node for each body and each joint, and a joint is the neighbour of its bodies.
 * The node with the fewest neighbours goes first (minimum degree; W. Tinney, J. Walker 1967), the
 * lower number among equals. In a tree that is always a leaf, so nothing is filled and the work is
 * linear (D. Baraff, "Linear-Time Dynamics using Lagrange Multipliers", 1996). A joint alone has no
 * pivot, and one on bodies that other joints hold already has hardly any: it waits until the bodies
 * that have gone on its sides can move in as many ways as it has rows.
 *
 * <p>Made when the graph of joints changes; allocates.
 */
final class Elimination {
    /** More blocks than so many to a node do not pay. */
    private static final int DENSE = 100;

    /** With more, it costs many times what a few rounds of conjugate gradients do. */
    private static final int FILLED = 6;

    /** A joint that is held comes after all that are not. */
    private static final int HELD = 1 << 24;

    /** Bodies, then joints; unknowns of each. */
    final int nodes;

    final int[] size;

    /** By node: its place in the order; and the node at each place. */
    final int[] place;

    final int[] node;

    /**
     * By place: its first neighbour among those that are eliminated later; one more for the end.
     */
    final int[] first;

    /** The places of these neighbours, ascending. */
    int[] later = new int[64];

    /** By place: first unknown, and where its diagonal block begins; one more for the end. */
    final int[] unknown;

    final int[] diagonal;

    /** By neighbour: where the block of it and the node begins, a row of the neighbour's each. */
    int[] block = new int[64];

    /** By place: its first {@link #update}; in the order of pairs of neighbours, i not below j. */
    final int[] firstUpdate;

    /** Where the block of each pair of neighbours begins. */
    int[] update = new int[64];

    /** Numbers of all blocks. */
    int entries;

    /** Whether it pays. */
    final boolean isSparse;

    /** Whether so much is filled that a few rounds of conjugate gradients cost a fraction. */
    final boolean isFilled;

    /** Pairs of neighbours that went together. */
    private long pairs;

    private final int bodies;
    private final int[] ends;

    /** By body: that stands for those that have gone with it; ways in which these can move. */
    private final int[] cluster;

    private final int[] ways;
    private int[][] near;
    private int[] degree;

    /** By node: the one that it was seen beside last. */
    private int[] seen;

    /** Nodes by their keys, old ones too; by node: the last of its keys in it. */
    private final KeyQueue queue = new KeyQueue();

    private long[] queued = {};

    /**
     * Orders an assembly.
     *
     * @param bodies how many
     * @param rows of each joint
     * @param ends body A and body B of each joint, -1 for one that does not move
     */
    Elimination(int bodies, int[] rows, int[] ends) {
        this.bodies = bodies;
        this.ends = ends;
        cluster = new int[bodies];
        ways = new int[bodies];
        Arrays.fill(cluster, -1);
        nodes = bodies + rows.length;
        size = new int[nodes];
        place = new int[nodes];
        node = new int[nodes];
        first = new int[nodes + 1];
        unknown = new int[nodes + 1];
        diagonal = new int[nodes];
        firstUpdate = new int[nodes + 1];
        near = new int[nodes][];
        degree = new int[nodes];
        seen = new int[nodes];
        Arrays.fill(seen, -1);
        Arrays.fill(size, 0, bodies, BlockFactors.BODY);
        System.arraycopy(rows, 0, size, bodies, rows.length);
        for (int i = 0; i < nodes; i++) {
            near[i] = new int[4];
        }
        for (int j = 0; j < rows.length; j++) {
            for (int side = 0; side < 2; side++) {
                if (ends[2 * j + side] >= 0) {
                    connect(bodies + j, ends[2 * j + side]);
                    connect(ends[2 * j + side], bodies + j);
                }
            }
        }
        isSparse = order() && lay();
        isFilled = pairs > (long) FILLED * nodes;
        near = new int[0][];
        degree = new int[0];
        seen = new int[0];
        queued = new long[0];
        queue.clear();
    }

    private void connect(int i, int k) {
        for (int e = 0; e < degree[i]; e++) {
            if (near[i][e] == k) {
                return;
            }
        }
        append(i, k);
    }

    /** Neighbours of a node are neighbours of each other from now on. */
    private void tie(int i) {
        int[] around = near[i];
        for (int e = 0; e < degree[i]; e++) {
            int k = around[e];
            seen[k] = k;
            for (int f = 0; f < degree[k]; f++) {
                seen[near[k][f]] = k;
            }
            for (int f = 0; f < degree[i]; f++) {
                if (seen[around[f]] != k) {
                    append(k, around[f]);
                }
            }
        }
    }

    private void append(int i, int k) {
        if (degree[i] == near[i].length) {
            near[i] = Arrays.copyOf(near[i], 2 * degree[i]);
        }
        near[i][degree[i]++] = k;
    }

    private void disconnect(int i, int k) {
        int at = 0;
        while (near[i][at] != k) {
            at++;
        }
        near[i][at] = near[i][--degree[i]];
    }

    /** Key of a node in the queue: fewer neighbours first, then the lower number. */
    private long key(int i) {
        int waits = i >= bodies && isHeld(i) ? HELD : 0;
        return (long) (degree[i] + waits) << 32 | i;
    }

    private int root(int body) {
        int i = body;
        while (cluster[i] != i) {
            cluster[i] = cluster[cluster[i]];
            i = cluster[i];
        }
        return i;
    }

    /** Whether the bodies that have gone cannot move in as many ways as a joint has rows. */
    private boolean isHeld(int joint) {
        int free = 0;
        int last = -1;
        for (int side = 0; side < 2; side++) {
            int b = ends[2 * (joint - bodies) + side];
            int r = b >= 0 && cluster[b] >= 0 ? root(b) : -1;
            free += r >= 0 && r != last ? ways[r] : 0;
            last = r;
        }
        return free < size[joint];
    }

    /** A node has gone: bodies count their ways, a joint ties them together and takes its rows. */
    private void leave(int i) {
        if (i < bodies) {
            cluster[i] = i;
            ways[i] = BlockFactors.BODY;
            return;
        }
        int last = -1;
        for (int side = 0; side < 2; side++) {
            int b = ends[2 * (i - bodies) + side];
            int r = b >= 0 && cluster[b] >= 0 ? root(b) : -1;
            if (r < 0 || r == last) {
                continue;
            }
            if (last >= 0) {
                cluster[last] = r;
                ways[r] += ways[last];
            }
            last = r;
        }
        ways[last] = Math.max(0, ways[last] - size[i]);
    }

    /** Queues a node that has not gone by its present key, unless it is there by that. */
    private void enqueue(int i) {
        long key = key(i);
        if (queued[i] != key) {
            queued[i] = key;
            queue.add(key);
        }
    }

    private boolean order() {
        boolean[] isGone = new boolean[nodes];
        queued = new long[nodes];
        Arrays.fill(queued, -1);
        for (int i = 0; i < bodies; i++) {
            enqueue(i);
        }
        int done = 0;
        int links = 0;
        while (!queue.isEmpty()) {
            long next = queue.remove();
            int i = (int) next;
            if (isGone[i]) {
                continue;
            }
            if (next != key(i)) {
                enqueue(i);
                continue;
            }
            isGone[i] = true;
            leave(i);
            place[i] = done;
            node[done++] = i;
            first[done] = links + degree[i];
            pairs += degree[i] * (degree[i] + 1L) / 2;
            if (links + degree[i] > DENSE * nodes || pairs > (long) DENSE * nodes) {
                return false;
            }
            if (later.length < links + degree[i]) {
                later = Arrays.copyOf(later, 2 * (links + degree[i]));
            }
            for (int e = 0; e < degree[i]; e++) {
                int k = near[i][e];
                later[links++] = k;
                disconnect(k, i);
            }
            tie(i);
            for (int e = 0; e < degree[i]; e++) {
                enqueue(near[i][e]);
            }
        }
        return true;
    }

    /** Gives blocks their places. */
    private boolean lay() {
        block = new int[Math.max(1, first[nodes])];
        long total = 0;
        long updates = 0;
        for (int p = 0; p < nodes; p++) {
            int n = size[node[p]];
            unknown[p + 1] = unknown[p] + n;
            for (int e = first[p]; e < first[p + 1]; e++) {
                later[e] = place[later[e]];
            }
            Arrays.sort(later, first[p], first[p + 1]);
            diagonal[p] = (int) total;
            total += (long) n * n;
            long d = (long) first[p + 1] - first[p];
            for (int e = first[p]; e < first[p + 1]; e++) {
                block[e] = (int) total;
                total += (long) size[node[later[e]]] * n;
            }
            updates += d * (d + 1) / 2;
        }
        if (total > Integer.MAX_VALUE / 2) {
            return false;
        }
        entries = (int) total;
        update = new int[(int) Math.max(1, updates)];
        int u = 0;
        for (int p = 0; p < nodes; p++) {
            firstUpdate[p] = u;
            for (int e = first[p]; e < first[p + 1]; e++) {
                for (int f = first[p]; f <= e; f++) {
                    update[u++] = at(later[e], later[f]);
                }
            }
        }
        firstUpdate[nodes] = u;
        return true;
    }

    /** Unknowns of the node that has most. */
    int largest() {
        int most = 0;
        for (int n : size) {
            most = Math.max(most, n);
        }
        return most;
    }

    /** Where the block of two places begins: it lies with the earlier one. */
    int at(int later, int earlier) {
        return later == earlier ? diagonal[later] : block[find(later, earlier)];
    }

    private int find(int wanted, int p) {
        return Arrays.binarySearch(later, first[p], first[p + 1], wanted);
    }
}
