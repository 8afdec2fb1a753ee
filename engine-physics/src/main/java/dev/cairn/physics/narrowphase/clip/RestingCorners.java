package dev.cairn.physics.narrowphase.clip;

import dev.cairn.physics.narrowphase.pair.FeatureIds;

/**
 * Which corners of an uneven region a body rests on. Seen along the normal, with its gap as a
 * height, each corner is a point in space; a body whose weight passes through a point q of the
 * plane comes to rest on that triangle of the points' lower hull which is above q. It is found by
 * exchange, as in the dual simplex method: of a triangle around q, the corner that is farthest
 * below its plane replaces one, so that the new triangle is around q again.
 */
final class RestingCorners {
    /** Up to how many exchanges; each lowers the plane at q, so the search ends by itself. */
    private static final int EXCHANGES = 64;

    private final int[] t = new int[3];
    private double[] u = {}, v = {};
    private Clipper c = new Clipper();
    private double qu, qv;

    /** Of the plane through the triangle: height at q, and its slopes. */
    private double atQ, slopeU, slopeV;

    /**
     * Exchanges corners of a four until a body rests on it.
     *
     * @param u coordinates of the clipper's corners in the plane
     * @param qu where the weight passes
     * @param four indices; what it holds at the end is in no order
     * @param tie corners this much below a triangle are in its plane, m
     * @param level heights up to this are alike where the fourth corner is chosen, m
     * @return whether anything was exchanged
     */
    boolean settle(
            Clipper c,
            double[] u,
            double[] v,
            double qu,
            double qv,
            int[] four,
            double tie,
            double level,
            int last) {
        this.c = c;
        this.u = u;
        this.v = v;
        this.qu = qu;
        this.qv = qv;
        if (!start(four) || !plane()) {
            return false;
        }
        boolean changed = false;
        for (int i = 0; i < EXCHANGES; i++) {
            int below = farthestBelow(tie);
            if (below < 0 || !exchange(below)) {
                break;
            }
            changed = true;
        }
        if (!changed) {
            return false;
        }
        four[0] = t[0];
        four[1] = t[1];
        four[2] = t[2];
        four[3] = fourth(level, last);
        return true;
    }

    /** Of the triangles of the four that are around q the one that is lowest there. */
    private boolean start(int[] four) {
        int best = -1;
        double lowest = 0;
        for (int without = 0; without < 4; without++) {
            pick(four, without);
            if (isAround(t[0], t[1], t[2]) && plane() && (best < 0 || atQ < lowest)) {
                best = without;
                lowest = atQ;
            }
        }
        if (best >= 0) {
            pick(four, best);
        }
        return best >= 0;
    }

    private void pick(int[] four, int without) {
        int n = 0;
        for (int i = 0; i < 4; i++) {
            if (i != without) {
                t[n++] = four[i];
            }
        }
    }

    private boolean isAround(int a, int b, int d) {
        double ab = turn(a, b);
        double bd = turn(b, d);
        double da = turn(d, a);
        return (ab >= 0 && bd >= 0 && da >= 0) || (ab <= 0 && bd <= 0 && da <= 0);
    }

    /** Twice the area of the triangle of q and two corners, signed. */
    private double turn(int a, int b) {
        return (u[a] - qu) * (v[b] - qv) - (v[a] - qv) * (u[b] - qu);
    }

    /** The plane through the triangle; false when that is no wider than a line. */
    private boolean plane() {
        int a = t[0];
        double bu = u[t[1]] - u[a];
        double bv = v[t[1]] - v[a];
        double du = u[t[2]] - u[a];
        double dv = v[t[2]] - v[a];
        double b = c.separation[t[1]] - c.separation[a];
        double d = c.separation[t[2]] - c.separation[a];
        double det = bu * dv - bv * du;
        if (Math.abs(det) <= 0x1p-40 * (bu * bu + bv * bv + du * du + dv * dv)) {
            return false;
        }
        slopeU = (b * dv - d * bv) / det;
        slopeV = (bu * d - du * b) / det;
        atQ = c.separation[a] + slopeU * (qu - u[a]) + slopeV * (qv - v[a]);
        return true;
    }

    private double above(int i) {
        return c.separation[i] - (atQ + slopeU * (u[i] - qu) + slopeV * (v[i] - qv));
    }

    private int farthestBelow(double tie) {
        double least = -tie;
        int found = -1;
        for (int i = 0; i < c.count; i++) {
            double h = above(i);
            if (h < least) {
                least = h;
                found = i;
            }
        }
        return found;
    }

    /** Puts a corner in the place of that without which the triangle is around q. */
    private boolean exchange(int i) {
        for (int k = 0; k < 3; k++) {
            int old = t[k];
            t[k] = i;
            if (isAround(t[0], t[1], t[2]) && plane()) {
                return true;
            }
            t[k] = old;
        }
        return false;
    }

    /** The deepest corner if it is not there yet, else the one that the body would tip on next. */
    private int fourth(double level, int last) {
        int deepest = 0;
        for (int i = 1; i < c.count; i++) {
            deepest = c.separation[i] < c.separation[deepest] ? i : deepest;
        }
        if (!isCorner(deepest)) {
            return deepest;
        }
        int best = t[0];
        double most = 0;
        for (int i = 0; i < c.count; i++) {
            if (!isCorner(i)) {
                double kept = FeatureIds.contains(last, c.feature[i]) ? 2 : 1;
                double score = kept * beyond(i) / (Math.max(0, above(i)) + level);
                if (score > most) {
                    most = score;
                    best = i;
                }
            }
        }
        return best;
    }

    private boolean isCorner(int i) {
        return i == t[0] || i == t[1] || i == t[2];
    }

    /** How far a corner is outside of the triangle, beyond the side that it is farthest from. */
    private double beyond(int i) {
        double most = 0;
        for (int k = 0; k < 3; k++) {
            int a = t[k];
            int b = t[(k + 1) % 3];
            int d = t[(k + 2) % 3];
            double eu = u[b] - u[a];
            double ev = v[b] - v[a];
            double side = eu * (v[d] - v[a]) - ev * (u[d] - u[a]);
            double at = eu * (v[i] - v[a]) - ev * (u[i] - u[a]);
            double far = (side > 0 ? -at : at) / Math.sqrt(eu * eu + ev * ev);
            most = Math.max(most, far);
        }
        return most;
    }
}
