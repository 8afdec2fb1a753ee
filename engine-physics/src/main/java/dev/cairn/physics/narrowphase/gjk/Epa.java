package dev.cairn.physics.narrowphase.gjk;

import dev.cairn.physics.narrowphase.pair.Pair;

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
public final class Epa extends Polytope {
    /** Of the pair's scale: the gap between the bounds of the depth at which the search ends. */
    public static final double TOLERANCE = 0x1p-44;

    /** Unit axis from A to B along which the overlap is least. */
    public double axisX, axisY, axisZ;

    /** The support vertices along that axis. */
    public int vertexA, vertexB;

    /** Overlap of the cores along the axis, and a lower bound of the depth. */
    public double depth, lower;

    /** What rounding may have moved a plane by; grows as the smaller shape's part of the pair. */
    private double noise;

    /** These two may be coarser where time is weighed against error. */
    public int cap = 4 * MAX_POINTS;

    public double relativeTolerance = TOLERANCE;

    /** Of the depth: a gap that matters for shallow overlaps, where the tolerance is more. */
    public double share = Double.MAX_VALUE;

    public boolean capped;
    public int iterations;

    /** Of the pair's scale: what the planes of faces that {@link #load} takes may be off by. */
    private static final double THIN_NOISE = 0x1p-34;

    /** Runs from the simplex that {@link Gjk} ended with. */
    public void run(Pair pair, Gjk gjk) {
        start(pair, gjk);
        expand(pair, false);
    }

    /**
     * Takes over the polytope that an earlier run for the pair left, see {@link Polytope}; {@link
     * #lower} is then known, less what rounding may have added to it. False when there is none that
     * holds the origin.
     */
    public boolean recall(Pair pair, long[] memory, int at) {
        if (!load(pair, memory, at)) {
            return false;
        }
        lower = offset[nearest()] - THIN_NOISE * pair.scale;
        return true;
    }

    /**
     * Runs from there; false when the surface, which need not be convex, folded, or another cap was
     * met.
     */
    public boolean resume(Pair pair) {
        join();
        expand(pair, true);
        return !capped;
    }

    private void expand(Pair pair, boolean resumed) {
        capped = false;
        depth = Double.MAX_VALUE;
        double tolerance = relativeTolerance * pair.scale;
        noise = 0x1p-50 * pair.scale * (pair.scale / pair.small);
        for (iterations = 1; ; iterations++) {
            int near = nearest();
            lower = offset[near];
            double ax = nx[near];
            double ay = ny[near];
            double az = nz[near];
            boolean full = points == MAX_POINTS || freeCount + MAX_FACES - faces < 8;
            if (full || (resumed && !(lower > 0))) {
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
            boolean last = known(w);
            if (last || !grow(near, w, 0x1p-48 * pair.scale)) {
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
     * @param apart cosine of the angle between axes that count as different ones
     */
    public boolean another(double[] tried, int count, double apart) {
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

    private int add(Pair pair, double dx, double dy, double dz) {
        int hintA = points > 0 ? ia[points - 1] : 0;
        int hintB = points > 0 ? ib[points - 1] : 0;
        int va = pair.supportA(-dx, -dy, -dz, hintA);
        int vb = pair.supportB(dx, dy, dz, hintB);
        return put(pair, va, vb);
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
        use = independent(pair, use);
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
        double ux = Math.abs(x[3]);
        double uy = Math.abs(y[3]);
        double uz = Math.abs(z[3]);
        points = 3;
        add(pair, -ax, -ay, -az);
        double down = Math.abs(volume());
        boolean first = up > down;
        if (up == down) {
            // Of drums side by side the plane through the origin may halve the whole: then there is
            // no way back, and it is the places that are the same in the mirror image.
            boolean neither = ax * x[0] + ay * y[0] + az * z[0] == 0;
            first =
                    !neither
                            || outer(ux - Math.abs(x[3]), uy - Math.abs(y[3]), uz - Math.abs(z[3]));
        }
        if (first) {
            points = 3;
            put(pair, va, vb);
        }
    }

    private static boolean outer(double byX, double byY, double byZ) {
        return byX > 0 || (byX == 0 && (byY > 0 || (byY == 0 && byZ >= 0)));
    }
}
