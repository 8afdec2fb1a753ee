package dev.cairn.physics.narrowphase.gjk;

import dev.cairn.physics.narrowphase.pair.Pair;

import java.util.Arrays;

/**
 * A polytope inside the Minkowski difference D = B - A of two shapes, whose points are pairs of
 * their vertices: what {@link Epa} expands.
 *
 * <p>A tick later the same pairs of vertices are points of the difference still, at other places.
 * Where every face then has the origin on its inner side, the surface is star-shaped about the
 * origin, convex or not (it is a covering of the sphere of directions, which has no other than
 * itself), so the ball about the origin that touches the nearest face is inside D, and its radius
 * is a lower bound of the depth at the new pose. That is what {@link #load} is for.
 */
public class Polytope {
    static final int MAX_POINTS = 160;
    static final int MAX_FACES = 2 * MAX_POINTS;

    /** Numbers in which {@link #save} remembers a polytope. */
    public static final int SIZE = 15;

    /** Points and faces of a polytope that can be remembered: 4 bits name a corner. */
    private static final int SAVED_POINTS = 16;

    /** Points to a number, and faces, and where those begin. */
    private static final int PER_POINTS = 2,
            PER_FACES = 5,
            FACES_AT = 1 + SAVED_POINTS / PER_POINTS;

    /** Of the squares of two sides of a face: with less area its normal has lost digits. */
    private static final double SLIVER = 0x1p-16;

    final double[] x = new double[MAX_POINTS],
            y = new double[MAX_POINTS],
            z = new double[MAX_POINTS];
    final int[] ia = new int[MAX_POINTS], ib = new int[MAX_POINTS];
    int points;

    final int[] corner = new int[3 * MAX_FACES], twin = new int[3 * MAX_FACES];
    final double[] nx = new double[MAX_FACES],
            ny = new double[MAX_FACES],
            nz = new double[MAX_FACES],
            offset = new double[MAX_FACES];
    final boolean[] alive = new boolean[MAX_FACES];
    final int[] mark = new int[MAX_FACES];
    int faces;

    private int round;

    /** The last face made has too little area. */
    private boolean thin;

    /** The face to the left of a side, by its corners. */
    private final int[] sides = new int[SAVED_POINTS * SAVED_POINTS];

    final int[] free = new int[MAX_FACES];
    int freeCount;
    final int[] stack = new int[MAX_FACES];
    final int[] removed = new int[MAX_FACES];
    int removedCount;
    final int[] coneAt = new int[MAX_POINTS];
    final int[] rimFrom = new int[3 * MAX_FACES],
            rimTo = new int[3 * MAX_FACES],
            rimFace = new int[3 * MAX_FACES];
    int rimCount;

    int nearest() {
        int best = -1;
        double least = Double.POSITIVE_INFINITY;
        for (int f = 0; f < faces; f++) {
            if (alive[f] && (offset[f] < least || (offset[f] == least && older(f, best)))) {
                least = offset[f];
                best = f;
            }
        }
        return Math.max(best, 0);
    }

    /**
     * Whether a face is the first of two that are equally near: by the age of its corners, which in
     * the mirror image is the same, while the places of faces are not.
     */
    boolean older(int f, int than) {
        return than >= 0 && age(f) < age(than);
    }

    private int age(int f) {
        int a = corner[3 * f];
        int b = corner[3 * f + 1];
        int c = corner[3 * f + 2];
        int least = Math.min(a, Math.min(b, c));
        int most = Math.max(a, Math.max(b, c));
        return (least << 16) + ((a + b + c - least - most) << 8) + most;
    }

    int put(Pair pair, int va, int vb) {
        pair.vertexB(vb);
        ia[points] = va;
        ib[points] = vb;
        x[points] = pair.px - pair.vertexAX(va);
        y[points] = pair.py - pair.vertexAY(va);
        z[points] = pair.pz - pair.vertexAZ(va);
        return points++;
    }

    boolean known(int w) {
        for (int i = 0; i < w; i++) {
            if (ia[i] == ia[w] && ib[i] == ib[w]) {
                return true;
            }
        }
        return false;
    }

    void link(int f, int t0, int t1, int t2) {
        twin[3 * f] = t0;
        twin[3 * f + 1] = t1;
        twin[3 * f + 2] = t2;
    }

    int face(int a, int b, int c) {
        int f = freeCount > 0 ? free[--freeCount] : faces++;
        corner[3 * f] = a;
        corner[3 * f + 1] = b;
        corner[3 * f + 2] = c;
        // Across the shortest side, whose digits count most; named in the order of their age, so
        // that the mirror image has the mirrored bits.
        int p = Math.min(a, Math.min(b, c));
        int r = Math.max(a, Math.max(b, c));
        int q = a + b + c - p - r;
        double pq = square(p, q);
        double qr = square(q, r);
        double rp = square(r, p);
        boolean first = pq <= qr && pq <= rp;
        boolean second = !first && qr <= rp;
        int i = first ? p : second ? q : r;
        int j = first ? q : second ? r : p;
        int k = p + q + r - i - j;
        boolean even = (i == a && j == b) || (i == b && j == c) || (i == c && j == a);
        double ex = x[j] - x[i];
        double ey = y[j] - y[i];
        double ez = z[j] - z[i];
        double gx = x[k] - x[i];
        double gy = y[k] - y[i];
        double gz = z[k] - z[i];
        double ux = ey * gz - ez * gy;
        double uy = ez * gx - ex * gz;
        double uz = ex * gy - ey * gx;
        double length = Math.sqrt(ux * ux + uy * uy + uz * uz);
        double inverse = length > 0 ? (even ? 1 : -1) / length : 0;
        thin = length <= SLIVER * (ex * ex + ey * ey + ez * ez + (gx * gx + gy * gy + gz * gz));
        nx[f] = ux * inverse;
        ny[f] = uy * inverse;
        nz[f] = uz * inverse;
        offset[f] =
                length > 0 ? nx[f] * x[i] + ny[f] * y[i] + nz[f] * z[i] : Double.POSITIVE_INFINITY;
        alive[f] = true;
        mark[f] = 0;
        return f;
    }

    private double square(int i, int j) {
        double ex = x[j] - x[i];
        double ey = y[j] - y[i];
        double ez = z[j] - z[i];
        return ex * ex + ey * ey + ez * ez;
    }

    /**
     * Replaces the faces that a point sees by a cone; false when rounding left a horizon that is
     * not one loop.
     */
    boolean grow(int first, int w, double tolerance) {
        round++;
        int top = 0;
        removedCount = 0;
        rimCount = 0;
        stack[top++] = first;
        mark[first] = round;
        while (top > 0) {
            int f = stack[--top];
            removed[removedCount++] = f;
            for (int k = 0; k < 3; k++) {
                int other = twin[3 * f + k];
                if (mark[other] != round && sees(other, w, tolerance)) {
                    mark[other] = round;
                    stack[top++] = other;
                }
            }
        }
        for (int i = 0; i < removedCount; i++) {
            rim(removed[i]);
        }
        if (!oneLoop() || rimCount > freeCount + removedCount + MAX_FACES - faces) {
            return false;
        }
        for (int i = 0; i < removedCount; i++) {
            alive[removed[i]] = false;
            free[freeCount++] = removed[i];
        }
        for (int i = 0; i < rimCount; i++) {
            int f = face(rimFrom[i], rimTo[i], w);
            int other = rimFace[i];
            twin[3 * f] = other;
            for (int k = 0; k < 3; k++) {
                if (corner[3 * other + k] == rimTo[i]) {
                    twin[3 * other + k] = f;
                }
            }
            coneAt[rimFrom[i]] = f;
        }
        for (int i = 0; i < rimCount; i++) {
            int f = coneAt[rimFrom[i]];
            int after = coneAt[rimTo[i]];
            twin[3 * f + 1] = after;
            twin[3 * after + 2] = f;
        }
        return true;
    }

    private boolean sees(int f, int w, double tolerance) {
        return offset[f] == Double.POSITIVE_INFINITY
                || nx[f] * x[w] + ny[f] * y[w] + nz[f] * z[w] - offset[f] > -tolerance;
    }

    private void rim(int f) {
        for (int k = 0; k < 3; k++) {
            int other = twin[3 * f + k];
            if (mark[other] != round) {
                rimFrom[rimCount] = corner[3 * f + k];
                rimTo[rimCount] = corner[3 * f + (k + 1) % 3];
                rimFace[rimCount++] = other;
            }
        }
    }

    private boolean oneLoop() {
        if (rimCount < 3) {
            return false;
        }
        for (int i = 0; i < points; i++) {
            coneAt[i] = -1;
        }
        for (int i = 0; i < rimCount; i++) {
            if (coneAt[rimFrom[i]] >= 0) {
                return false;
            }
            coneAt[rimFrom[i]] = i;
        }
        int at = 0;
        for (int steps = 1; steps <= rimCount; steps++) {
            int next = coneAt[rimTo[at]];
            if (next < 0) {
                return false;
            }
            if (next == 0) {
                return steps == rimCount;
            }
            at = next;
        }
        return false;
    }

    /** Finds the neighbours of all faces, which {@link #load} leaves out. */
    void join() {
        for (int f = 0; f < faces; f++) {
            for (int k = 0; k < 3; k++) {
                sides[SAVED_POINTS * corner[3 * f + k] + corner[3 * f + (k + 1) % 3]] = f;
            }
        }
        for (int f = 0; f < faces; f++) {
            for (int k = 0; k < 3; k++) {
                twin[3 * f + k] =
                        sides[SAVED_POINTS * corner[3 * f + (k + 1) % 3] + corner[3 * f + k]];
            }
        }
    }

    /** Forgets what a place remembers. */
    public static void forget(long[] memory, int at) {
        memory[at] = 0;
    }

    /** Remembers the polytope, or nothing when it is too large. */
    public void save(long[] memory, int at) {
        memory[at] = 0;
        int used = 0;
        int kept = 0;
        Arrays.fill(coneAt, 0, points, -1);
        for (int f = 0; f < faces; f++) {
            if (!alive[f]) {
                continue;
            }
            long packed = 0;
            for (int k = 0; k < 3; k++) {
                int p = corner[3 * f + k];
                if (coneAt[p] < 0) {
                    if (used == SAVED_POINTS) {
                        return;
                    }
                    coneAt[p] = used;
                    long pair = (long) ia[p] << 16 | ib[p];
                    int w = at + 1 + used / PER_POINTS;
                    memory[w] = (used & 1) == 0 ? pair : memory[w] | pair << 32;
                    used++;
                }
                packed |= (long) coneAt[p] << (4 * k);
            }
            int w = at + FACES_AT + kept / PER_FACES;
            int shift = 12 * (kept % PER_FACES);
            memory[w] = shift == 0 ? packed : memory[w] | packed << shift;
            kept++;
        }
        memory[at] = (long) used << 8 | kept;
    }

    /**
     * Takes over a polytope of another pose, or of another pair; false when the memory is empty or
     * the origin is not on the inner side of every face, by more than rounding.
     */
    boolean load(Pair pair, long[] memory, int at) {
        int used = (int) memory[at] >>> 8 & 0xFF;
        int kept = (int) memory[at] & 0xFF;
        if (used == 0) {
            return false;
        }
        points = 0;
        faces = 0;
        freeCount = 0;
        for (int i = 0; i < used; i++) {
            long two = memory[at + 1 + i / PER_POINTS] >>> (32 * (i & 1));
            int va = (int) (two >>> 16) & 0xFFFF;
            int vb = (int) two & 0xFFFF;
            if (va >= pair.a.vertexCount() || vb >= pair.b.vertexCount()) {
                return false;
            }
            put(pair, va, vb);
        }
        for (int i = 0; i < kept; i++) {
            long packed = memory[at + FACES_AT + i / PER_FACES] >>> (12 * (i % PER_FACES));
            int a = (int) packed & 0xF;
            int b = (int) (packed >>> 4) & 0xF;
            int c = (int) (packed >>> 8) & 0xF;
            if (!(offset[face(a, b, c)] > 0) || thin) {
                return false;
            }
        }
        return true;
    }
}
