package dev.cairn.physics.narrowphase.mesh;

import dev.cairn.physics.narrowphase.pair.Pair;

/**
 * Along which normal between those of its two faces a ridge separates a shape most, and where along
 * the ridge the shape is nearest then. Seen along the ridge, a point of the shape is a place (h,
 * x), h above the first face and x over the ridge, and the separation is
 *
 * <pre>
 *   s(a) = min over p in shape of  h cos a + x sin a,    0 &lt;= a &lt;= angle between the faces
 * </pre>
 *
 * <p>A point that is deepest on the rising side and one that is deepest on the falling side bound
 * it from above; where the two are equal, the deepest point is either one of them, and the maximum
 * is found, or takes the place of one (the method of cutting planes, J. E. Kelley, 1960, in one
 * dimension). One worker's.
 */
final class RidgeArc {
    /** Steps; a shape with corners needs two or three. */
    private static final int MOST = 8;

    /** Of the shape's size: what heights of one point may differ by. */
    private static final double ROUNDING = 1e-12;

    /** Sine of the angle up to which a flat lies on the ridge. */
    private static final double FLAT = 1e-3;

    /** Cosine and sine of the angle of the normal that separates most. */
    double cosine, sine;

    /** The separation along it, of the shape's core, m. */
    double separation;

    /** Where along the ridge the shape may be nearest, from the first corner on, m. */
    double from, to;

    private final Deepest deepest = new Deepest();

    /** Height and side of a point on the rising part, of one on the falling part, and along. */
    private double h1, x1, y1, h2, x2, y2, h, x, y;

    /** Of the angle between the faces. */
    private double lastCosine, lastSine;

    private Pair pair = Pair.NONE;

    /** The frame: a corner of the ridge, the face's normal, over the ridge, along it. */
    private double cx, cy, cz, nx, ny, nz, ox, oy, oz, ex, ey, ez;

    /**
     * Chooses the ridge.
     *
     * @param c corners of the face, from the shape's centre, mesh axes, m
     * @param a where in c the ridge begins
     * @param normalX unit normal of the face
     * @param overX unit vector in the face over the ridge
     */
    void ridge(
            double[] c,
            int a,
            double normalX,
            double normalY,
            double normalZ,
            double overX,
            double overY,
            double overZ) {
        cx = c[a];
        cy = c[a + 1];
        cz = c[a + 2];
        nx = normalX;
        ny = normalY;
        nz = normalZ;
        ox = overX;
        oy = overY;
        oz = overZ;
        // from the beginning of the ridge, for corners that go round n counter-clockwise
        ex = ny * oz - nz * oy;
        ey = nz * ox - nx * oz;
        ez = nx * oy - ny * ox;
    }

    /**
     * Finds the maximum.
     *
     * @param own whose A is the shape, with its orientation in the mesh's axes
     * @param tangent of the angle between the faces
     * @return false if it is not known: of a shape that is in deep there may be two
     */
    boolean find(Pair own, double tangent) {
        pair = own;
        lastCosine = 1 / Math.sqrt(1 + tangent * tangent);
        lastSine = tangent * lastCosine;
        look(1, 0, 0);
        h1 = h;
        x1 = x;
        y1 = y;
        look(lastCosine, lastSine, 0);
        h2 = h;
        x2 = x;
        y2 = y;
        if (!(x1 > 0)) {
            if (rise(h1, x1, lastCosine, lastSine) > 0) {
                return false; // in deep: it rises again
            }
            cosine = 1;
            sine = 0;
        } else if (!(rise(h2, x2, lastCosine, lastSine) < 0)) {
            if (x2 < 0) {
                return false;
            }
            cosine = lastCosine;
            sine = lastSine;
        } else if (!climb()) {
            return false;
        }
        separation = Math.min(h1 * cosine + x1 * sine, h2 * cosine + x2 * sine);
        double up = Math.max(0, rise(h1, x1, cosine, sine));
        double down = Math.max(0, -rise(h2, x2, cosine, sine));
        double at = up + down > 0 ? (y1 * down + y2 * up) / (up + down) : 0.5 * (y1 + y2);
        from = at;
        to = at;
        flat(-FLAT);
        flat(FLAT);
        return true;
    }

    /** A third point that is as deep, up to a tilt, makes a flat. */
    private void flat(double tilt) {
        look(cosine, sine, tilt);
        boolean isKnown = (h == h1 && x == x1 && y == y1) || (h == h2 && x == x2 && y == y2);
        if (!isKnown) {
            from = Math.min(from, y);
            to = Math.max(to, y);
        }
    }

    private boolean climb() {
        double rounding = ROUNDING * pair.small;
        for (int i = 0; i < MOST; i++) {
            // where both are equally high, unless one of them has its maximum before
            direct(x1 - x2, h2 - h1);
            if (x1 <= x2 || rise(h1, x1, cosine, sine) <= 0) {
                direct(h1, x1);
            } else if (rise(h2, x2, cosine, sine) >= 0) {
                direct(h2, x2);
            }
            double most = Math.min(h1 * cosine + x1 * sine, h2 * cosine + x2 * sine);
            look(cosine, sine, 0);
            if (h * cosine + x * sine >= most - rounding) {
                return true;
            }
            if (rise(h, x, cosine, sine) > 0) {
                if (x < 0) {
                    return false;
                }
                h1 = h;
                x1 = x;
                y1 = y;
            } else {
                if (rise(h, x, lastCosine, lastSine) > 0) {
                    return false;
                }
                h2 = h;
                x2 = x;
                y2 = y;
            }
        }
        return false;
    }

    private void direct(double c, double s) {
        double f = 1 / Math.sqrt(c * c + s * s);
        cosine = c * f;
        sine = s * f;
    }

    /** How the separation from a point goes with the angle. */
    private static double rise(double h, double x, double c, double s) {
        return x * c - h * s;
    }

    /** The deepest point along a normal at an angle, tilted along the ridge. */
    private void look(double c, double s, double tilt) {
        deepest.find(
                pair,
                -(c * nx + s * ox + tilt * ex),
                -(c * ny + s * oy + tilt * ey),
                -(c * nz + s * oz + tilt * ez));
        double px = deepest.x - cx;
        double py = deepest.y - cy;
        double pz = deepest.z - cz;
        h = nx * px + ny * py + nz * pz;
        x = ox * px + oy * py + oz * pz;
        y = ex * px + ey * py + ez * pz;
    }
}
