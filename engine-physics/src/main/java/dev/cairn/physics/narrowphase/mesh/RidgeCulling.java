package dev.cairn.physics.narrowphase.mesh;

import dev.cairn.physics.narrowphase.pair.ContactTolerances;
import dev.cairn.physics.narrowphase.pair.Pair;
import dev.cairn.physics.shape.mesh.TriangleSet;

import java.util.Arrays;

/**
 * The ridges near a shape that it can't touch, known by one support point each, so that the general
 * narrow phase is asked only for triangles with another one.
 *
 * <p>Let two faces with normals n and m meet in a ridge, and let t be the direction in the first
 * face's plane that leads over the ridge. A contact of the ridge has a normal between n and m for
 * which the separation is the largest,
 *
 * <pre>
 *   s(a) = min over p in shape of (n cos a + t sin a) . (p - r),    r on the ridge
 *   s'(0) = t . (p - r),    p the deepest point along n
 * </pre>
 *
 * <p>and s rises to a maximum only once. So if the deepest point along n is still over the first
 * face, t . (p - r) &lt; 0, then s falls from the start, and what is touched is that face. The same
 * goes for the other face: if either of them says so, the ridge is calm. Contacts at a corner lie
 * within the polygon of the normals around it; on its rim, the ridges' arcs, the separation has its
 * maximum on one that isn't calm.
 *
 * <p>Flats of the shape that are nearly parallel to a face rest on it with points at the rim, as
 * points of the face. So a ridge is wholly calm if that holds for the normal leaned by {@link
 * #LEAN} away from it, too; else there may be such points, but no normal beside the face's.
 *
 * <p>Where that does not tell, {@link RidgeArc} finds the normal. A ridge is not touched then if it
 * leaves the shape apart, or if the shape is nearest to the ridge's line beyond a corner that is
 * calm: one that has a face whose deepest point is before both of the face's edges there. For all
 * normals m that the surface lets be at the corner are n cos a + (u t + v t') sin a with u, v not
 * negative, so that the separation falls from n on as it does along the edges.
 *
 * <p>Source: local maxima of the separation of convex sets on the sphere of directions, as in D.
 * Gregorius, "The Separating Axis Test between Convex Polyhedra" (GDC 2013), where edges are pruned
 * by their arcs. One worker's; grows when there are more ridges than ever.
 */
final class RidgeCulling {
    /** Tangent of the angle up to which flats are parallel to a face, and some room. */
    private static final double LEAN = 0.11;

    /**
     * Tangent of the angle between faces of which one is not here, 89 degrees; and the most that
     * counts for any.
     */
    private static final double STEEP = 64;

    /**
     * Numbers of a ridge: the normal of the face that saw it first, and of the angle between its
     * faces the tangent, what it is bounded by from the first face and from the other one, and with
     * what is flat from either; and how high above the nearer face it is met by what lies on it.
     */
    private static final int TANGENT = 3, FIRST = 4, OTHER = 5, FLATS = 6, MET = 7, NUMBERS = 8;

    /**
     * Of the inner radius: how deep in a face or a ridge a shape is at most that lies on it. What
     * is deeper may find its way out elsewhere.
     */
    static final double DEEP = 0.02;

    /** In place of a height: at another normal than those of the faces, and not here. */
    private static final double NEITHER = Double.NEGATIVE_INFINITY;

    /** Keys of ridges, 0 where there is none, in an open table of a power of two. */
    private long[] keys = new long[128];

    private double[] number = new double[128 * NUMBERS];
    private int count;

    private final Deepest deepest = new Deepest();
    private final RidgeArc arc = new RidgeArc();

    /** A place of the shape, from its centre, mesh axes, m. */
    private double sx, sy, sz;

    /** Of the edges of the triangle that was looked at last: what bounds the normals there. */
    private final double[] bound = new double[3];

    /** How high above a face its ridges are met by what lies on them; after {@link #own}. */
    double met;

    /** Over an edge: a unit vector in the triangle's plane. */
    private double ox, oy, oz;

    void clear() {
        if (count > 0) {
            Arrays.fill(keys, 0);
            count = 0;
        }
    }

    /** How far a shape's core reaches against a normal; {@link #look} at that face goes on. */
    double reach(Pair pair, double nx, double ny, double nz) {
        support(pair, -nx, -ny, -nz);
        return -(nx * sx + ny * sy + nz * sz);
    }

    /**
     * Looks at the ridges of a triangle, after {@link #reach} towards it.
     *
     * @param edges bit e for a ridge from corner e to the next; later questions are about these
     * @param c three times x, y, z, from the shape's centre, mesh axes, m
     * @param nx unit normal towards the shape
     * @param front 1, or -1 if the corners go round the normal clockwise
     * @param pair whose A is the shape, with its orientation in the mesh's axes
     */
    void look(
            TriangleSet set,
            int t,
            int edges,
            double[] c,
            double nx,
            double ny,
            double nz,
            double front,
            Pair pair,
            double tolerance) {
        if (edges == 0) {
            return;
        }
        double px = sx;
        double py = sy;
        double pz = sz;
        for (int e = 0; e < 3; e++) {
            over(c, e, nx, ny, nz, front);
            sx = px;
            sy = py;
            sz = pz;
            double normals = slope(c, 3 * e, nx, ny, nz, tolerance);
            bound[e] = normals;
            if ((edges >> e & 1) == 0) {
                continue;
            }
            double flats = 0;
            if (normals > 0) {
                // -(n - LEAN t)
                support(pair, LEAN * ox - nx, LEAN * oy - ny, LEAN * oz - nz);
                flats = slope(c, 3 * e, nx, ny, nz, tolerance);
            }
            add(key(set, t, e), nx, ny, nz, normals, flats);
        }
        for (int e = 0; e < 3; e++) {
            if (Math.min(bound[e], bound[e == 0 ? 2 : e - 1]) > STEEP) {
                add(corner(set.vertex(t, e)));
            }
        }
    }

    /** Into o: over the edge from corner e to the next. */
    private void over(double[] c, int e, double nx, double ny, double nz, double front) {
        int a = 3 * e;
        int b = e == 2 ? 0 : a + 3;
        double ex = front * (c[b] - c[a]);
        double ey = front * (c[b + 1] - c[a + 1]);
        double ez = front * (c[b + 2] - c[a + 2]);
        // e x n / |e|, for corners that go round n counter-clockwise
        ox = ey * nz - ez * ny;
        oy = ez * nx - ex * nz;
        oz = ex * ny - ey * nx;
        double f = 1 / Math.sqrt(ox * ox + oy * oy + oz * oz);
        ox *= f;
        oy *= f;
        oz *= f;
    }

    /** Puts the point of the shape that is farthest in a direction into s. */
    private void support(Pair pair, double ux, double uy, double uz) {
        deepest.find(pair, ux, uy, uz);
        sx = deepest.x;
        sy = deepest.y;
        sz = deepest.z;
    }

    /** Which ridges of a triangle are not known to be calm. */
    int others(TriangleSet set, int t, int edges) {
        int left = edges;
        for (int e = 0; e < 3; e++) {
            if ((edges >> e & 1) != 0) {
                int at = NUMBERS * slot(key(set, t, e));
                left &= number[at + FLATS] > number[at + TANGENT] ? ~(1 << e) : -1;
            }
        }
        return left;
    }

    /**
     * Which ridges of a triangle may be touched along a normal between those of their faces.
     *
     * @param c as for {@link #look}
     */
    int between(
            TriangleSet set,
            int t,
            int edges,
            double[] c,
            double nx,
            double ny,
            double nz,
            double front,
            Pair pair,
            Margin margin,
            double tolerance) {
        int left = edges;
        for (int e = 0; e < 3; e++) {
            if ((edges >> e & 1) != 0) {
                int at = NUMBERS * slot(key(set, t, e));
                double most = Math.max(number[at + FIRST], number[at + OTHER]);
                if (most > number[at + TANGENT]
                        || !isMet(set, t, e, at, c, nx, ny, nz, front, pair, margin, tolerance)) {
                    left &= ~(1 << e);
                }
            }
        }
        return left;
    }

    /** Whether a ridge that slopes do not tell of may be met; if not, this is noted. */
    private boolean isMet(
            TriangleSet set,
            int t,
            int e,
            int at,
            double[] c,
            double nx,
            double ny,
            double nz,
            double front,
            Pair pair,
            Margin margin,
            double tolerance) {
        if (pair.roundA && !pair.solidA.isThin()) {
            return true; // its rims have no corners to step over
        }
        over(c, e, nx, ny, nz, front);
        int next = e == 2 ? 0 : e + 1;
        int begin = front > 0 ? e : next;
        int end = front > 0 ? next : e;
        arc.ridge(c, 3 * begin, nx, ny, nz, ox, oy, oz);
        double tangent = number[at + TANGENT];
        if (!arc.find(pair, tangent) || arc.separation - pair.radiusA < -DEEP * pair.inner) {
            return true;
        }
        double mx = arc.cosine * nx + arc.sine * ox;
        double my = arc.cosine * ny + arc.sine * oy;
        double mz = arc.cosine * nz + arc.sine * oz;
        double dx = c[3 * end] - c[3 * begin];
        double dy = c[3 * end + 1] - c[3 * begin + 1];
        double dz = c[3 * end + 2] - c[3 * begin + 2];
        double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
        boolean isApart = arc.separation - pair.radiusA > margin.along(mx, my, mz);
        boolean isBefore = arc.to < -tolerance && isCalm(corner(set.vertex(t, begin)));
        boolean isBehind = arc.from > length + tolerance && isCalm(corner(set.vertex(t, end)));
        double last = 1 / Math.sqrt(1 + tangent * tangent);
        double other = arc.cosine * last + arc.sine * tangent * last;
        boolean isOwn = arc.cosine > other;
        double near = Math.max(arc.cosine, other);
        if (isApart || isBefore || isBehind) {
            number[at + MET] = NEITHER;
        } else if (pair.roundA
                || near < ContactTolerances.NEARLY_PARALLEL
                || !(isOwn || tangent < STEEP)) {
            return true;
        } else {
            number[at + MET] = arc.separation / near;
        }
        boolean isFirst = isFirst(at, nx, ny, nz);
        number[at + (isFirst == isOwn ? FIRST : OTHER)] = Double.MAX_VALUE;
        return false;
    }

    private boolean isFirst(int at, double nx, double ny, double nz) {
        return nx == number[at] && ny == number[at + 1] && nz == number[at + 2];
    }

    /**
     * At which ridges of a triangle its normal separates more than that of the other face.
     *
     * @param edges none of {@link #between}
     * @return 0 if at one of them the other face, at a larger angle than flats may have, does; -1
     *     if another one is met nevertheless
     */
    int own(TriangleSet set, int t, int edges, double nx, double ny, double nz) {
        int own = 0;
        boolean leans = false;
        met = Double.MAX_VALUE;
        for (int e = 0; e < 3; e++) {
            if ((edges >> e & 1) != 0) {
                int at = NUMBERS * slot(key(set, t, e));
                double[] n = number;
                if (n[at + MET] != NEITHER
                        && n[at + (isFirst(at, nx, ny, nz) ? FIRST : OTHER)] > n[at + TANGENT]) {
                    own |= 1 << e;
                    met = Math.min(met, n[at + MET]);
                } else {
                    leans |= n[at + TANGENT] > LEAN;
                }
            }
        }
        return !leans ? own : met < Double.MAX_VALUE ? -1 : 0;
    }

    /**
     * Up to the tangent of which angle the separation falls from a face on, over the edge at a
     * corner: for a place s of the shape, x before the edge and d below the face,
     *
     * <pre>
     *   s(a) &lt;= -d cos a - x sin a,    which falls while tan a &lt; x / d
     * </pre>
     *
     * @return 0 if it does not fall
     */
    private double slope(double[] c, int a, double nx, double ny, double nz, double tolerance) {
        double x = sx - c[a];
        double y = sy - c[a + 1];
        double z = sz - c[a + 2];
        double before = -(ox * x + oy * y + oz * z) - tolerance;
        double depth = -(nx * x + ny * y + nz * z);
        return !(before > 0) ? 0 : depth > 0 ? before / depth : Double.MAX_VALUE;
    }

    /** A ridge by the numbers of its ends; not 0, for these differ. */
    private static long key(TriangleSet set, int t, int e) {
        int a = set.vertex(t, e);
        int b = set.vertex(t, e == 2 ? 0 : e + 1);
        return (long) Math.max(a, b) << 32 | Math.min(a, b);
    }

    /** A corner by the number of its vertex. */
    private static long corner(int vertex) {
        return (vertex + 1L) << 32 | (vertex + 1L);
    }

    /** Whether a corner is one that was added. */
    private boolean isCalm(long corner) {
        return keys[slot(corner)] == corner;
    }

    private int slot(long key) {
        int mask = keys.length - 1;
        int at = (int) ((key * 0x9E3779B97F4A7C15L) >>> 40) & mask;
        while (keys[at] != 0 && keys[at] != key) {
            at = (at + 1) & mask;
        }
        return at;
    }

    /** A corner that can't be touched. */
    private void add(long corner) {
        if (2 * count >= keys.length) {
            grow();
        }
        int slot = slot(corner);
        if (keys[slot] != corner) {
            keys[slot] = corner;
            count++;
        }
    }

    /** A ridge seen from one face; seen from the other one, too, its angle is known. */
    private void add(long key, double nx, double ny, double nz, double normals, double flats) {
        if (2 * count >= keys.length) {
            grow();
        }
        int slot = slot(key);
        int at = NUMBERS * slot;
        double[] n = number;
        if (keys[slot] != key) {
            keys[slot] = key;
            count++;
            n[at] = nx;
            n[at + 1] = ny;
            n[at + 2] = nz;
            n[at + TANGENT] = STEEP;
            n[at + FIRST] = normals;
            n[at + OTHER] = 0;
            n[at + FLATS] = flats;
            n[at + MET] = Double.MAX_VALUE;
            return;
        }
        double cosine = n[at] * nx + n[at + 1] * ny + n[at + 2] * nz;
        double x = n[at + 1] * nz - n[at + 2] * ny;
        double y = n[at + 2] * nx - n[at] * nz;
        double z = n[at] * ny - n[at + 1] * nx;
        double sine = Math.sqrt(x * x + y * y + z * z);
        n[at + TANGENT] = sine < STEEP * cosine ? sine / cosine : STEEP;
        n[at + OTHER] = normals;
        n[at + FLATS] = Math.max(n[at + FLATS], flats);
    }

    private void grow() {
        long[] old = keys;
        double[] numbers = number;
        keys = new long[2 * old.length];
        number = new double[NUMBERS * keys.length];
        for (int i = 0; i < old.length; i++) {
            if (old[i] != 0) {
                int at = slot(old[i]);
                keys[at] = old[i];
                System.arraycopy(numbers, NUMBERS * i, number, NUMBERS * at, NUMBERS);
            }
        }
    }
}
