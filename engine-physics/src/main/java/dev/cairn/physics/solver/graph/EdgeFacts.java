package dev.cairn.physics.solver.graph;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.EdgeSource;
import dev.cairn.physics.solver.body.SolverBodies;

import java.util.Arrays;

/**
 * What the edges of a tick are, by their numbers in their sources, kind after kind: read once.
 *
 * <p>Problem: what a contact says lies in several cache lines, which the worker that solved it last
 * has written. One thread that asks all contacts waits for each of them, and that does not get less
 * with more workers. So all workers read, in blocks, and the lists that one thread makes of it find
 * some bytes an edge side by side.
 */
final class EdgeFacts {
    /** Numbers beyond that mix: the order is another one then, and as much the same for all. */
    private static final int PART_BITS = 21;

    /** Slots of the bodies; that of A is -1 if the edge is not solved, or nothing of it moves. */
    int[] bodyA = {};

    int[] bodyB = {};

    /** Which of the kernels of its kind it needs; of a contact: its points. */
    int[] variant = {};

    /** Of a contact: the sum of its normal impulses at the end of the last tick, N s. */
    double[] impulse = {};

    /** Whether it is a contact with restitution. */
    boolean[] bounces = {};

    /** Of edges between the same two bodies: by which parts, and which triangle, they are told. */
    long[] part = {};

    /** Whether a body that moves touches one that is much heavier; cleared by who reads it. */
    boolean hasLight;

    /** Whether any body is of parts, or has a surface of triangles: else no two are of one pair. */
    boolean hasParts;

    void ensureCapacity(int edges) {
        if (bodyA.length < edges) {
            bodyA = Arrays.copyOf(bodyA, edges);
            bodyB = Arrays.copyOf(bodyB, edges);
            variant = Arrays.copyOf(variant, edges);
            impulse = Arrays.copyOf(impulse, edges);
            bounces = Arrays.copyOf(bounces, edges);
            part = Arrays.copyOf(part, edges);
        }
    }

    /** Reads contact {@code i} of those that are awake. */
    void readContact(ContactStore contacts, BodyStore bodies, int i) {
        read(contacts, bodies, i, i);
        if (bodyA[i] < 0) {
            return;
        }
        int row = contacts.active[i];
        int points = contacts.pointCount[row];
        int a = bodyA[i];
        int b = bodyB[i];
        if (bodies.kind[a] == bodies.kind[b]
                && (SolverBodies.isLight(bodies, a, b) || SolverBodies.isLight(bodies, b, a))) {
            hasLight = true; // by whoever finds one
        }
        double sum = 0;
        int first = ContactStore.POINTS * row;
        for (int p = first; p < first + points; p++) {
            sum += contacts.normalImpulse[p];
        }
        impulse[i] = sum;
        variant[i] = points;
        bounces[i] = contacts.restitution[row] > 0;
        part[i] = hasParts ? part(contacts, row) : 0;
    }

    private static long part(ContactStore c, int row) {
        return ((long) c.colliderA[row] << (2 * PART_BITS))
                ^ ((long) c.colliderB[row] << PART_BITS)
                ^ (c.triangle(row) + 1);
    }

    /** Reads the edges of a kind beside contacts; they follow from {@code first} on. */
    void readKind(EdgeSource edges, BodyStore bodies, int first) {
        for (int i = 0; i < edges.edges(); i++) {
            read(edges, bodies, i, first + i);
            impulse[first + i] = 0;
            variant[first + i] = 1;
            bounces[first + i] = false;
            part[first + i] = 0;
        }
    }

    private void read(EdgeSource edges, BodyStore bodies, int i, int edge) {
        int a = edges.edgeA(i);
        int b = a < 0 ? -1 : edges.edgeB(i);
        boolean moves =
                a >= 0
                        && (bodies.kind[a] == BodyStore.DYNAMIC
                                || bodies.kind[b] == BodyStore.DYNAMIC);
        bodyA[edge] = moves ? a : -1;
        bodyB[edge] = b;
    }
}
