package dev.cairn.physics.narrowphase.oracle;

import org.joml.Vector3d;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * The largest separation of two polyhedra over all face normals and all pairs of edges whose arcs
 * on the Gauss map cross; those that nearly cross are tried by brute force too. Fast enough for
 * hulls of a hundred vertices.
 */
public final class GaussMapOracle {
    private GaussMapOracle() {}

    /** An edge with the normals of its two faces. */
    private record Edge(Vector3d from, Vector3d to, Vector3d left, Vector3d right) {}

    private static List<Edge> edges(ConvexOracle.Placed p, double sign) {
        Map<Long, Integer> faceOf = new HashMap<>();
        for (int f = 0; f < p.loops.length; f++) {
            int[] loop = p.loops[f];
            for (int i = 0; i < loop.length; i++) {
                faceOf.put((long) loop[i] << 32 | loop[(i + 1) % loop.length], f);
            }
        }
        List<Edge> all = new ArrayList<>();
        faceOf.forEach((key, face) -> {
            int from = (int) (key >> 32);
            int to = (int) (long) key;
            if (from < to) {
                int other = faceOf.get((long) to << 32 | from);
                all.add(
                        new Edge(
                                p.vertices[from],
                                p.vertices[to],
                                new Vector3d(p.normals[face]).mul(sign),
                                new Vector3d(p.normals[other]).mul(sign)));
            }
        });
        return all;
    }

    public static double depth(ConvexOracle.Placed a, ConvexOracle.Placed b) {
        double best = -Double.MAX_VALUE;
        for (Vector3d n : a.normals) {
            best = Math.max(best, b.lowest(n) - a.highest(n));
        }
        for (Vector3d n : b.normals) {
            best = Math.max(best, a.lowest(n) - b.highest(n));
        }
        List<Edge> ofB = edges(b, -1);
        Vector3d n = new Vector3d();
        Vector3d back = new Vector3d();
        for (Edge e : edges(a, 1)) {
            Vector3d u = e.to.sub(e.from, new Vector3d()).normalize();
            for (Edge f : ofB) {
                Vector3d v = f.to.sub(f.from, new Vector3d()).normalize();
                // The arcs of A's normals and of B's, turned, cross: each has its ends on either
                // side of the other's plane.
                double c = f.left.dot(u);
                double d = f.right.dot(u);
                double g = e.left.dot(v);
                double h = e.right.dot(v);
                if (c * d > 1e-12 || g * h > 1e-12) {
                    continue;
                }
                u.cross(v, n);
                if (n.lengthSquared() < 1e-12) {
                    continue;
                }
                n.normalize();
                n.negate(back);
                best = Math.max(best, b.lowest(n) - a.highest(n));
                best = Math.max(best, b.lowest(back) - a.highest(back));
            }
        }
        return best;
    }
}
