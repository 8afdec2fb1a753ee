package dev.cairn.physics.narrowphase.mesh;

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
 * points of the face; therefore the normal is first leaned by {@link #LEAN} away from the ridge.
 *
 * <p>Source: local maxima of the separation of convex sets on the sphere of directions, as in D.
 * Gregorius, "The Separating Axis Test between Convex Polyhedra" (GDC 2013), where edges are pruned
 * by their arcs. One worker's; grows when there are more ridges than ever.
 */
final class CalmRidges {
    /** Tangent of the angle up to which flats are parallel to a face, and some room. */
    private static final double LEAN = 0.11;

    /**
     * Of a deepest point under the face's plane: how far it must be from the ridge, in its depths.
     * Below its plane a face tells the whole arc only up to the angle whose tangent that is, 89
     * degrees.
     */
    private static final double PER_DEPTH = 64;

    /** Keys of calm ridges, 0 where there is none, in an open table of a power of two. */
    private long[] keys = new long[128];

    private int count;

    void clear() {
        if (count > 0) {
            Arrays.fill(keys, 0);
            count = 0;
        }
    }

    /**
     * Looks at the ridges of a triangle.
     *
     * @param edges bit e for a ridge from corner e to the next
     * @param corner three times x, y, z, from the shape's centre, mesh axes, m
     * @param nx unit normal towards the shape
     * @param front 1, or -1 if the corners go round the normal clockwise
     * @param pair whose A is the shape, with its orientation in the mesh's axes
     */
    void look(
            TriangleSet set,
            int t,
            int edges,
            double[] corner,
            double nx,
            double ny,
            double nz,
            double front,
            Pair pair,
            double tolerance) {
        for (int e = 0; e < 3; e++) {
            if ((edges >> e & 1) != 0 && isCalm(e, corner, nx, ny, nz, front, pair, tolerance)) {
                add(key(set, t, e));
            }
        }
    }

    /** Which ridges of a triangle are not known to be calm. */
    int others(TriangleSet set, int t, int edges) {
        int left = edges;
        for (int e = 0; e < 3; e++) {
            if ((edges >> e & 1) != 0 && has(key(set, t, e))) {
                left &= ~(1 << e);
            }
        }
        return left;
    }

    private static boolean isCalm(
            int e, double[] c, double nx, double ny, double nz, double front, Pair p, double tol) {
        int a = 3 * e;
        int b = e == 2 ? 0 : a + 3;
        double ex = front * (c[b] - c[a]);
        double ey = front * (c[b + 1] - c[a + 1]);
        double ez = front * (c[b + 2] - c[a + 2]);
        // t = e x n / |e|: over the edge, for corners that go round n counter-clockwise
        double ox = ey * nz - ez * ny;
        double oy = ez * nx - ex * nz;
        double oz = ex * ny - ey * nx;
        double f = 1 / Math.sqrt(ox * ox + oy * oy + oz * oz);
        ox *= f;
        oy *= f;
        oz *= f;
        // -(n - LEAN t)
        double ux = LEAN * ox - nx;
        double uy = LEAN * oy - ny;
        double uz = LEAN * oz - nz;
        p.solidA.restart();
        int v =
                p.supportA(
                        p.w00 * ux + p.w10 * uy + p.w20 * uz,
                        p.w01 * ux + p.w11 * uy + p.w21 * uz,
                        p.w02 * ux + p.w12 * uy + p.w22 * uz,
                        0);
        double sx = p.vertexAX(v);
        double sy = p.vertexAY(v);
        double sz = p.vertexAZ(v);
        double x = p.w00 * sx + p.w01 * sy + p.w02 * sz - c[a];
        double y = p.w10 * sx + p.w11 * sy + p.w12 * sz - c[a + 1];
        double z = p.w20 * sx + p.w21 * sy + p.w22 * sz - c[a + 2];
        double depth = -(nx * x + ny * y + nz * z);
        return ox * x + oy * y + oz * z < -tol - PER_DEPTH * Math.max(0, depth);
    }

    /** A ridge by the numbers of its ends; not 0, for these differ. */
    private static long key(TriangleSet set, int t, int e) {
        int a = set.vertex(t, e);
        int b = set.vertex(t, e == 2 ? 0 : e + 1);
        return (long) Math.max(a, b) << 32 | Math.min(a, b);
    }

    private int slot(long key) {
        int mask = keys.length - 1;
        int at = (int) ((key * 0x9E3779B97F4A7C15L) >>> 40) & mask;
        while (keys[at] != 0 && keys[at] != key) {
            at = (at + 1) & mask;
        }
        return at;
    }

    private boolean has(long key) {
        return count > 0 && keys[slot(key)] == key;
    }

    private void add(long key) {
        if (2 * count >= keys.length) {
            long[] old = keys;
            keys = new long[2 * old.length];
            for (long k : old) {
                if (k != 0) {
                    keys[slot(k)] = k;
                }
            }
        }
        int at = slot(key);
        if (keys[at] != key) {
            keys[at] = key;
            count++;
        }
    }
}
