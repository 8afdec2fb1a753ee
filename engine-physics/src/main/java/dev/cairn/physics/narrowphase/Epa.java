package dev.cairn.physics.narrowphase;

/**
 * The depth of two overlapping polyhedra: the face of the Minkowski difference D = B - A nearest to
 * the origin, by an expanding polytope. Distances are signed: a face that the origin is above comes
 * first, so the start polytope need not hold the origin, and shapes that in truth are a rounding
 * error apart get a small positive separation from the same loop.
 *
 * <p>A new point removes every face that it sees or that its plane contains, found by flood fill
 * with the one predicate that also defines the horizon; so no new face is a sliver of zero area.
 * Any support value along a unit axis bounds the depth from above, the nearest face bounds it from
 * below; the best of the former is the answer and their difference is the gap.
 */
final class Epa {
    private static final int MAX_POINTS = 160;

    /** Of the pair's scale: the gap between the bounds of the depth at which the search ends. */
    static final double TOLERANCE = 0x1p-44;

    private static final int MAX_FACES = 2 * MAX_POINTS;

    /** Unit axis from A to B along which the overlap is least. */
    double axisX, axisY, axisZ;

    /** The support vertices along that axis. */
    int vertexA, vertexB;

    /** Overlap of the cores along the axis, and a lower bound of the depth. */
    double depth, lower;

    /** What rounding may have moved a plane by; grows as the smaller shape's part of the pair. */
    private double noise;

    /** These two may be coarser where time is weighed against error. */
    int cap = 4 * MAX_POINTS;

    double relativeTolerance = TOLERANCE;

    /** See {@link Safeguard}. */
    boolean knownPoints = true, independentStart = true, oneLoop = true, shortestSide = true;

    /** Of the depth: a gap that matters for shallow overlaps, where the tolerance is more. */
    double share = Double.MAX_VALUE;

    boolean capped;
    int iterations;

    private final double[] x = new double[MAX_POINTS],
            y = new double[MAX_POINTS],
            z = new double[MAX_POINTS];
    private final int[] ia = new int[MAX_POINTS], ib = new int[MAX_POINTS];
    private int points;

    private final int[] corner = new int[3 * MAX_FACES], twin = new int[3 * MAX_FACES];
    private final double[] nx = new double[MAX_FACES],
            ny = new double[MAX_FACES],
            nz = new double[MAX_FACES],
            offset = new double[MAX_FACES];
    private final boolean[] alive = new boolean[MAX_FACES];
    private final int[] mark = new int[MAX_FACES];
    private int faces, round;
    private final int[] free = new int[MAX_FACES];
    private int freeCount;
    private final int[] stack = new int[MAX_FACES];
    private final int[] removed = new int[MAX_FACES];
    private int removedCount;
    private final int[] coneAt = new int[MAX_POINTS];
    private final int[] rimFrom = new int[3 * MAX_FACES],
            rimTo = new int[3 * MAX_FACES],
            rimFace = new int[3 * MAX_FACES];
    private int rimCount;

    /** Runs from the simplex that {@link Gjk} ended with. */
    void run(Pair pair, Gjk gjk) {
        capped = false;
        depth = Double.MAX_VALUE;
        start(pair, gjk);
        double tolerance = relativeTolerance * pair.scale;
        noise = 0x1p-50 * pair.scale * (pair.scale / pair.small);
        for (iterations = 1; ; iterations++) {
            int near = nearest();
            lower = offset[near];
            double ax = nx[near];
            double ay = ny[near];
            double az = nz[near];
            if (points == MAX_POINTS || freeCount + MAX_FACES - faces < 8) {
                capped = true;
                return;
            }
            int w = add(pair, ax, ay, az);
            double reach = ax * x[w] + ay * y[w] + az * z[w];
            if (reach < depth) {
                depth = reach;
                axisX = -ax;
                axisY = -ay;
                axisZ = -az;
                vertexA = ia[w];
                vertexB = ib[w];
            }
            double enough = Math.max(TOLERANCE * pair.scale, Math.min(tolerance, share * depth));
            if (reach - lower <= enough || depth - lower <= enough) {
                points--;
                return;
            }
            if (iterations >= cap) {
                capped = true;
                return;
            }
            boolean last = knownPoints && known(w);
            if (last || !expand(near, w, 0x1p-48 * pair.scale)) {
                // A face of the difference itself, or a sliver: the reach is its distance, its
                // plane had lost digits.
                capped |= !last;
                points--;
                offset[near] = reach;
            }
        }
    }

    /**
     * The nearest face whose normal is not near any of those tried, if it is nearer than the answer
     * or up to rounding as near: where a better axis may hide when shapes are very unequal, or
     * after a cap was met.
     *
     * @param tried x, y and z of the axes tried; receives the one found
     * @param count number of axes tried
     * @param apart cosine of the angle between axes that count as different ones
     */
    boolean another(double[] tried, int count, double apart) {
        double least = depth + noise;
        int best = -1;
        for (int f = 0; f < faces; f++) {
            if (alive[f] && (offset[f] < least || (offset[f] == least && older(f, best)))) {
                double nearby = -1;
                for (int i = 0; i < 3 * count; i += 3) {
                    double dot = nx[f] * tried[i] + ny[f] * tried[i + 1] + nz[f] * tried[i + 2];
                    nearby = Math.max(nearby, -dot);
                }
                if (nearby < apart) {
                    least = offset[f];
                    best = f;
                }
            }
        }
        if (best >= 0) {
            tried[3 * count] = -nx[best];
            tried[3 * count + 1] = -ny[best];
            tried[3 * count + 2] = -nz[best];
        }
        return best >= 0;
    }

    private int nearest() {
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
    private boolean older(int f, int than) {
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

    private int add(Pair pair, double dx, double dy, double dz) {
        int hintA = points > 0 ? ia[points - 1] : 0;
        int hintB = points > 0 ? ib[points - 1] : 0;
        int va = pair.supportA(-dx, -dy, -dz, hintA);
        int vb = pair.supportB(dx, dy, dz, hintB);
        return put(pair, va, vb);
    }

    private int put(Pair pair, int va, int vb) {
        pair.vertexB(vb);
        ia[points] = va;
        ib[points] = vb;
        x[points] = pair.px - pair.vertexAX(va);
        y[points] = pair.py - pair.vertexAY(va);
        z[points] = pair.pz - pair.vertexAZ(va);
        return points++;
    }

    private boolean known(int w) {
        for (int i = 0; i < w; i++) {
            if (ia[i] == ia[w] && ib[i] == ib[w]) {
                return true;
            }
        }
        return false;
    }

    /**
     * Four points that span a volume: GJK's as far as they are independent, then supports at right
     * angles to them.
     */
    private void start(Pair pair, Gjk gjk) {
        points = 0;
        faces = 0;
        freeCount = 0;
        int use = gjk.count;
        for (int i = 0; i < use; i++) {
            ia[i] = gjk.ia[i];
            ib[i] = gjk.ib[i];
            x[i] = gjk.wx[i];
            y[i] = gjk.wy[i];
            z[i] = gjk.wz[i];
        }
        points = use;
        use = independentStart ? independent(pair, use) : use;
        points = use;
        if (use < 2) {
            secondPoint(pair);
        }
        if (use < 3) {
            thirdPoint(pair);
        }
        if (use < 4) {
            fourthPoint(pair);
        }
        boolean below = volume() < 0;
        int p = below ? 0 : 1;
        int q = below ? 1 : 0;
        face(p, q, 2);
        face(q, p, 3);
        face(2, q, 3);
        face(p, 2, 3);
        link(0, 1, 2, 3);
        link(1, 0, 3, 2);
        link(2, 0, 1, 3);
        link(3, 0, 2, 1);
    }

    /** How many of the first points span something, up to rounding. */
    private int independent(Pair pair, int count) {
        int use = count;
        if (use == 4 && Math.abs(volume()) <= 0x1p-20 * pair.inner * area2()) {
            use = 3;
        }
        if (use >= 3 && area2() <= 0x1p-20 * pair.inner * length01()) {
            use = 2;
        }
        if (use >= 2 && length01() <= 0x1p-20 * pair.inner) {
            use = 1;
        }
        return use;
    }

    private void link(int f, int t0, int t1, int t2) {
        twin[3 * f] = t0;
        twin[3 * f + 1] = t1;
        twin[3 * f + 2] = t2;
    }

    private double length01() {
        double ex = x[1] - x[0];
        double ey = y[1] - y[0];
        double ez = z[1] - z[0];
        return Math.sqrt(ex * ex + ey * ey + ez * ez);
    }

    private double normalX() {
        return (y[1] - y[0]) * (z[2] - z[0]) - (z[1] - z[0]) * (y[2] - y[0]);
    }

    private double normalY() {
        return (z[1] - z[0]) * (x[2] - x[0]) - (x[1] - x[0]) * (z[2] - z[0]);
    }

    private double normalZ() {
        return (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]);
    }

    private double area2() {
        double ax = normalX();
        double ay = normalY();
        double az = normalZ();
        return Math.sqrt(ax * ax + ay * ay + az * az);
    }

    /** Positive when point 3 is above triangle 0, 1, 2. */
    private double volume() {
        return normalX() * (x[3] - x[0]) + normalY() * (y[3] - y[0]) + normalZ() * (z[3] - z[0]);
    }

    /**
     * 1 when a direction leads from the first point back towards the origin, else -1: of two
     * opposite ones the mirror image then tries the image of the same one first.
     */
    private double back(double dx, double dy, double dz) {
        return dx * x[0] + dy * y[0] + dz * z[0] <= 0 ? 1 : -1;
    }

    private void secondPoint(Pair pair) {
        double best = -1;
        int bestA = 0;
        int bestB = 0;
        for (int i = 0; i < 6; i++) {
            double sx = i < 2 ? 1 : 0;
            double sy = i >= 2 && i < 4 ? 1 : 0;
            double sz = i >= 4 ? 1 : 0;
            double s = (i & 1) == 0 ? back(sx, sy, sz) : -back(sx, sy, sz);
            points = 1;
            add(pair, s * sx, s * sy, s * sz);
            double length = length01();
            if (length > best) {
                best = length;
                bestA = ia[1];
                bestB = ib[1];
            }
        }
        points = 1;
        put(pair, bestA, bestB);
    }

    private void thirdPoint(Pair pair) {
        double ex = x[1] - x[0];
        double ey = y[1] - y[0];
        double ez = z[1] - z[0];
        double best = -1;
        int bestA = 0;
        int bestB = 0;
        for (int i = 0; i < 6; i++) {
            double px = i < 2 ? 0 : i < 4 ? -ez : ey;
            double py = i < 2 ? ez : i < 4 ? 0 : -ex;
            double pz = i < 2 ? -ey : i < 4 ? ex : 0;
            double s = (i & 1) == 0 ? back(px, py, pz) : -back(px, py, pz);
            points = 2;
            add(pair, s * px, s * py, s * pz);
            double area = area2();
            if (area > best) {
                best = area;
                bestA = ia[2];
                bestB = ib[2];
            }
        }
        points = 2;
        put(pair, bestA, bestB);
    }

    private void fourthPoint(Pair pair) {
        double nX = normalX();
        double nY = normalY();
        double nZ = normalZ();
        double s = back(nX, nY, nZ);
        double ax = s * nX;
        double ay = s * nY;
        double az = s * nZ;
        points = 3;
        add(pair, ax, ay, az);
        double up = Math.abs(volume());
        int va = ia[3];
        int vb = ib[3];
        points = 3;
        add(pair, -ax, -ay, -az);
        if (up >= Math.abs(volume())) {
            points = 3;
            put(pair, va, vb);
        }
    }

    private int face(int a, int b, int c) {
        int f = freeCount > 0 ? free[--freeCount] : faces++;
        corner[3 * f] = a;
        corner[3 * f + 1] = b;
        corner[3 * f + 2] = c;
        // Across the shortest side, whose digits count most; named in the order of their age, so
        // that the mirror image has the mirrored bits.
        int p = Math.min(a, Math.min(b, c));
        int r = Math.max(a, Math.max(b, c));
        int q = a + b + c - p - r;
        int i = p;
        int j = q;
        if (shortestSide) {
            double pq = square(p, q);
            double qr = square(q, r);
            double rp = square(r, p);
            boolean first = pq <= qr && pq <= rp;
            boolean second = !first && qr <= rp;
            i = first ? p : second ? q : r;
            j = first ? q : second ? r : p;
        }
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
    private boolean expand(int first, int w, double tolerance) {
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
        if ((oneLoop && !oneLoop()) || rimCount > freeCount + removedCount + MAX_FACES - faces) {
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
}
