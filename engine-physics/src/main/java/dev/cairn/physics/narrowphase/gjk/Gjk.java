package dev.cairn.physics.narrowphase.gjk;

import dev.cairn.physics.narrowphase.pair.Pair;

/**
 * The distance of two convex cores: the point of the Minkowski difference D = B - A nearest to the
 * origin, by Gilbert-Johnson-Keerthi. The nearest point of the simplex is found by its features in
 * turn (point, edge, face), each with its own well-conditioned formula; a face gives its direction
 * as a cross product, so that near touching no digits cancel.
 *
 * <p>Ends when the duality gap closes, when a support point repeats, or when a step does not
 * improve (then the previous simplex stays). A simplex that holds the origin, or a distance at the
 * level of rounding, is an overlap: {@link Epa} then decides, with one signed answer on both sides
 * of touching.
 */
public final class Gjk {
    public static final int CAP = 96;

    /** Relative duality gap, of the squared distance, at which the search ends. */
    public static final double TOLERANCE = 0x1p-48;

    /** Of the pair's scale: nearer than rounding can tell, {@link Epa} decides. */
    static final double TOUCHING = 0x1p-42;

    /** Of the pair's scale, and of the distance: a gap between the bounds that is no rounding. */
    private static final double STALLED = 0x1p-40, STALLED_PART = 0x1p-20;

    /** How often the search starts again from where it stalled. */
    private static final int AGAIN = 3;

    /** These two may be coarser where time is weighed against error. */
    public int cap = CAP;

    public double tolerance = TOLERANCE;

    final double[] wx = new double[4], wy = new double[4], wz = new double[4];
    public final int[] ia = new int[4], ib = new int[4];

    /** Barycentric weights of the simplex points. */
    public final double[] weight = new double[4];

    /** Points in the simplex. */
    public int count;

    /** From the nearest point of A to the nearest point of B. */
    public double vx, vy, vz;

    /** Length of v, an upper bound of the distance; and the best lower bound. */
    public double distance, lower;

    /** The cores touch or overlap; v is then meaningless. */
    public boolean overlap;

    /** The lower bound passed the limit; nothing else is exact then. */
    public boolean beyond;

    public boolean capped;
    public int iterations;

    private double bestSquare, bestX, bestY, bestZ;
    private int bestCount;
    private final int[] bestIndex = new int[4];
    private final double[] bestWeight = new double[4];

    /**
     * Runs from a start direction, any vector from A towards B; stops early when farther apart than
     * {@code limit}.
     */
    public void run(Pair pair, double sx, double sy, double sz, double limit) {
        once(pair, sx, sy, sz, limit);
        int steps = iterations;
        for (int i = 0; i < AGAIN && stalled(pair); i++) {
            once(pair, vx, vy, vz, limit);
            steps += iterations;
        }
        iterations = steps;
    }

    /**
     * The bounds do not meet: the simplex became a sliver, whose plane has lost its digits. From
     * the direction found so far other points come first.
     */
    private boolean stalled(Pair pair) {
        boolean round = pair.roundA || pair.roundB;
        double gap = distance - lower;
        return !(overlap || beyond || capped || round || tolerance > TOLERANCE)
                && gap > STALLED * pair.scale
                && gap > STALLED_PART * distance;
    }

    private void once(Pair pair, double sx, double sy, double sz, double limit) {
        overlap = false;
        beyond = false;
        capped = false;
        lower = -Double.MAX_VALUE;
        count = 1;
        boolean zero = sx == 0 && sy == 0 && sz == 0;
        add(pair, 0, zero ? 1 : sx, sy, sz, 0, 0);
        weight[0] = 1;
        vx = wx[0];
        vy = wy[0];
        vz = wz[0];
        loop(pair, limit);
    }

    /**
     * Runs from the simplex of another run, as {@link #key} told it; false when the key does not
     * name vertices of this pair, or lead nowhere. A simplex of another pose costs time, never
     * correctness.
     */
    public boolean runFrom(long key, Pair pair, double limit) {
        int points = (int) (key >>> 62);
        for (int i = 0; i < points; i++) {
            int va = (int) (key >>> (20 * i)) & 0x3FF;
            int vb = (int) (key >>> (20 * i + 10)) & 0x3FF;
            if (va >= pair.a.vertexCount() || vb >= pair.b.vertexCount()) {
                return false;
            }
            put(pair, i, va, vb);
        }
        if (points == 0) {
            return false;
        }
        overlap = false;
        beyond = false;
        capped = false;
        lower = -Double.MAX_VALUE;
        bestSquare = Double.MAX_VALUE;
        bestCount = 0;
        if (points == 3) {
            triangle(0, 1, 2);
        } else if (points == 2) {
            segment(0, 1);
        } else {
            point(0);
        }
        take();
        loop(pair, limit);
        return !stalled(pair);
    }

    /**
     * The vertices of the simplex of shapes that are apart, for {@link #runFrom}; 0 if too many.
     */
    public long key() {
        long key = (long) count << 62;
        for (int i = 0; i < count; i++) {
            if (count > 3 || ia[i] > 0x3FF || ib[i] > 0x3FF) {
                return 0;
            }
            key |= ((long) ib[i] << 10 | ia[i]) << (20 * i);
        }
        return key;
    }

    private void loop(Pair pair, double limit) {
        double touching = TOUCHING * pair.scale;
        for (iterations = 1; iterations <= cap; iterations++) {
            double square = vx * vx + vy * vy + vz * vz;
            distance = Math.sqrt(square);
            if (distance <= touching) {
                overlap = true;
                return;
            }
            if (step(pair, square, limit)) {
                // What stalls without a plane between the cores is not known to be apart.
                overlap |= lower <= 0;
                return;
            }
        }
        capped = true;
        overlap = lower <= 0;
    }

    /** One step; true when done. */
    private boolean step(Pair pair, double square, double limit) {
        int at = count;
        if (at == 4) {
            overlap = true;
            return true;
        }
        add(pair, at, vx, vy, vz, ia[at - 1], ib[at - 1]);
        double along = vx * wx[at] + vy * wy[at] + vz * wz[at];
        lower = Math.max(lower, along / distance);
        if (lower > limit) {
            beyond = true;
            return true;
        }
        if (square - along <= tolerance * square || known(at)) {
            return true;
        }
        bestSquare = Double.MAX_VALUE;
        bestCount = 0;
        if (at == 3) {
            if (tetrahedron(pair.scale)) {
                count = 4;
                overlap = true;
                return true;
            }
        } else if (at == 2) {
            triangle(0, 1, 2);
        } else {
            segment(0, 1);
        }
        // Nothing of the simplex can be nearer than a plane that separates: a sliver lost its
        // normal. Round shapes refine what is left; polyhedra go on.
        boolean certain = (pair.roundA || pair.roundB) && lower > TOUCHING * pair.scale;
        boolean lost = certain && bestSquare < lower * lower * (1 - 0x1p-20);
        if (lost || !(bestSquare < square)) {
            return true;
        }
        take();
        return false;
    }

    private void add(Pair pair, int at, double x, double y, double z, int hintA, int hintB) {
        put(pair, at, pair.supportA(x, y, z, hintA), pair.supportB(-x, -y, -z, hintB));
    }

    private void put(Pair pair, int at, int va, int vb) {
        pair.vertexB(vb);
        ia[at] = va;
        ib[at] = vb;
        wx[at] = pair.px - pair.vertexAX(va);
        wy[at] = pair.py - pair.vertexAY(va);
        wz[at] = pair.pz - pair.vertexAZ(va);
    }

    private boolean known(int at) {
        for (int i = 0; i < at; i++) {
            if (ia[i] == ia[at] && ib[i] == ib[at]) {
                return true;
            }
        }
        return false;
    }

    /**
     * Keeps the points of the best feature. Indices ascend, so the copies do not overwrite what is
     * still needed.
     */
    private void take() {
        count = bestCount;
        for (int i = 0; i < bestCount; i++) {
            int from = bestIndex[i];
            wx[i] = wx[from];
            wy[i] = wy[from];
            wz[i] = wz[from];
            ia[i] = ia[from];
            ib[i] = ib[from];
            weight[i] = bestWeight[i];
        }
        vx = bestX;
        vy = bestY;
        vz = bestZ;
    }

    private boolean better(double x, double y, double z) {
        double square = x * x + y * y + z * z;
        if (square < bestSquare) {
            bestSquare = square;
            bestX = x;
            bestY = y;
            bestZ = z;
            return true;
        }
        return false;
    }

    private void point(int i) {
        if (better(wx[i], wy[i], wz[i])) {
            bestCount = 1;
            bestIndex[0] = i;
            bestWeight[0] = 1;
        }
    }

    private void segment(int i, int j) {
        double ex = wx[j] - wx[i];
        double ey = wy[j] - wy[i];
        double ez = wz[j] - wz[i];
        double t = -(wx[i] * ex + wy[i] * ey + wz[i] * ez);
        double square = ex * ex + ey * ey + ez * ez;
        if (t <= 0) {
            point(i);
        } else if (t >= square) {
            point(j);
        } else {
            t /= square;
            double x = wx[i] + t * ex;
            double y = wy[i] + t * ey;
            double z = wz[i] + t * ez;
            // What rounding left along the edge would count by the edge's length near touching.
            double rest = (x * ex + y * ey + z * ez) / square;
            if (better(x - rest * ex, y - rest * ey, z - rest * ez)) {
                bestCount = 2;
                bestIndex[0] = i;
                bestIndex[1] = j;
                bestWeight[0] = 1 - t;
                bestWeight[1] = t;
            }
        }
    }

    private void triangle(int i, int j, int k) {
        double ex = wx[j] - wx[i];
        double ey = wy[j] - wy[i];
        double ez = wz[j] - wz[i];
        double fx = wx[k] - wx[i];
        double fy = wy[k] - wy[i];
        double fz = wz[k] - wz[i];
        double nx = ey * fz - ez * fy;
        double ny = ez * fx - ex * fz;
        double nz = ex * fy - ey * fx;
        double square = nx * nx + ny * ny + nz * nz;
        double rx = -wx[i];
        double ry = -wy[i];
        double rz = -wz[i];
        double v = nx * (ry * fz - rz * fy) + ny * (rz * fx - rx * fz) + nz * (rx * fy - ry * fx);
        double w = nx * (ey * rz - ez * ry) + ny * (ez * rx - ex * rz) + nz * (ex * ry - ey * rx);
        double u = square - v - w;
        double flat = 0x1p-90 * (ex * ex + ey * ey + ez * ez) * (fx * fx + fy * fy + fz * fz);
        if (square <= flat) {
            segment(i, j);
            segment(i, k);
            segment(j, k);
        } else if (u >= 0 && v >= 0 && w >= 0) {
            double t = (nx * wx[i] + ny * wy[i] + nz * wz[i]) / square;
            if (better(t * nx, t * ny, t * nz)) {
                bestCount = 3;
                bestIndex[0] = i;
                bestIndex[1] = j;
                bestIndex[2] = k;
                bestWeight[0] = u / square;
                bestWeight[1] = v / square;
                bestWeight[2] = w / square;
            }
        } else {
            if (u < 0) {
                segment(j, k);
            }
            if (v < 0) {
                segment(i, k);
            }
            if (w < 0) {
                segment(i, j);
            }
        }
    }

    /** True when the tetrahedron 0, 1, 2, 3 holds the origin; else the best feature is found. */
    private boolean tetrahedron(double scale) {
        boolean outside = side(0, 1, 2, 3, scale);
        outside |= side(0, 1, 3, 2, scale);
        outside |= side(0, 2, 3, 1, scale);
        outside |= side(1, 2, 3, 0, scale);
        return !outside;
    }

    /**
     * Whether face i, j, k has the origin on the side away from point l; then its nearest feature
     * competes.
     */
    private boolean side(int i, int j, int k, int l, double scale) {
        double ex = wx[j] - wx[i];
        double ey = wy[j] - wy[i];
        double ez = wz[j] - wz[i];
        double fx = wx[k] - wx[i];
        double fy = wy[k] - wy[i];
        double fz = wz[k] - wz[i];
        double nx = ey * fz - ez * fy;
        double ny = ez * fx - ex * fz;
        double nz = ex * fy - ey * fx;
        double toPoint = nx * (wx[l] - wx[i]) + ny * (wy[l] - wy[i]) + nz * (wz[l] - wz[i]);
        double toOrigin = -(nx * wx[i] + ny * wy[i] + nz * wz[i]);
        double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
        if (Math.abs(toPoint) > 0x1p-50 * scale * length && (toPoint > 0) == (toOrigin >= 0)) {
            return false;
        }
        if (toOrigin == 0 && Math.abs(toPoint) > 0) {
            return false;
        }
        triangle(i, j, k);
        return true;
    }
}
