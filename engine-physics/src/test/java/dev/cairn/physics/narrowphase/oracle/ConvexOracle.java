package dev.cairn.physics.narrowphase.oracle;

import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.polyhedron.Polyhedron;

import org.joml.Quaterniondc;
import org.joml.Vector3d;

/**
 * Brute force over all features of two placed polyhedra: slow, simple, and nothing of the engine
 * but the input.
 */
public final class ConvexOracle {
    private ConvexOracle() {}

    /** A polyhedron in world axes. */
    public static final class Placed {
        final Vector3d[] vertices;
        final Vector3d[] normals;
        final int[][] loops;

        public Placed(Shape shape, Quaterniondc q, double dx, double dy, double dz) {
            Polyhedron h = polyhedron(shape);
            vertices = new Vector3d[h.vertexCount()];
            for (int v = 0; v < vertices.length; v++) {
                vertices[v] =
                        q.transform(new Vector3d(h.vertexX(v), h.vertexY(v), h.vertexZ(v)))
                                .add(dx, dy, dz);
            }
            loops = h.faceLoops();
            normals = new Vector3d[loops.length];
            for (int f = 0; f < loops.length; f++) {
                Vector3d n = new Vector3d();
                Vector3d o = vertices[loops[f][0]];
                for (int i = 1; i + 1 < loops[f].length; i++) {
                    n.add(
                            vertices[loops[f][i]]
                                    .sub(o, new Vector3d())
                                    .cross(vertices[loops[f][i + 1]].sub(o, new Vector3d())));
                }
                normals[f] = n.normalize();
            }
        }

        double highest(Vector3d n) {
            double best = -Double.MAX_VALUE;
            for (Vector3d v : vertices) {
                best = Math.max(best, v.dot(n));
            }
            return best;
        }

        double lowest(Vector3d n) {
            double best = Double.MAX_VALUE;
            for (Vector3d v : vertices) {
                best = Math.min(best, v.dot(n));
            }
            return best;
        }
    }

    public static Polyhedron polyhedron(Shape shape) {
        return shape instanceof Box box ? Polyhedron.of(box) : Polyhedron.of((ConvexHull) shape);
    }

    /**
     * The largest separation over all face normals and edge crosses: the signed distance when it is
     * not positive.
     */
    public static double separatingAxes(Placed a, Placed b) {
        double best = -Double.MAX_VALUE;
        for (Vector3d n : a.normals) {
            best = Math.max(best, b.lowest(n) - a.highest(n));
        }
        for (Vector3d n : b.normals) {
            best = Math.max(best, a.lowest(n) - b.highest(n));
        }
        for (int[] fa : a.loops) {
            for (int i = 0; i < fa.length; i++) {
                int a0 = fa[i];
                int a1 = fa[(i + 1) % fa.length];
                if (a0 > a1) {
                    continue;
                }
                Vector3d ea = a.vertices[a1].sub(a.vertices[a0], new Vector3d()).normalize();
                for (int[] fb : b.loops) {
                    for (int j = 0; j < fb.length; j++) {
                        int b0 = fb[j];
                        int b1 = fb[(j + 1) % fb.length];
                        if (b0 > b1) {
                            continue;
                        }
                        Vector3d n =
                                b.vertices[b1]
                                        .sub(b.vertices[b0], new Vector3d())
                                        .normalize()
                                        .cross(ea);
                        if (n.lengthSquared() > 1e-12) {
                            n.normalize();
                            best = Math.max(best, b.lowest(n) - a.highest(n));
                            best = Math.max(best, a.lowest(n) - b.highest(n));
                        }
                    }
                }
            }
        }
        return best;
    }

    /** Distance of two polyhedra that are apart: all edge pairs, all vertices over faces. */
    public static double distance(Placed a, Placed b) {
        double best = Math.min(overFaces(a, b), overFaces(b, a));
        for (int[] fa : a.loops) {
            for (int i = 0; i < fa.length; i++) {
                for (int[] fb : b.loops) {
                    for (int j = 0; j < fb.length; j++) {
                        best =
                                Math.min(
                                        best,
                                        segments(
                                                a.vertices[fa[i]],
                                                a.vertices[fa[(i + 1) % fa.length]],
                                                b.vertices[fb[j]],
                                                b.vertices[fb[(j + 1) % fb.length]]));
                    }
                }
            }
        }
        return best;
    }

    private static double overFaces(Placed a, Placed b) {
        double best = Double.MAX_VALUE;
        for (Vector3d v : a.vertices) {
            for (int f = 0; f < b.loops.length; f++) {
                double height = b.normals[f].dot(v) - b.highest(b.normals[f]);
                if (height >= 0 && height < best && inside(b, f, v)) {
                    best = height;
                }
            }
        }
        return best;
    }

    private static boolean inside(Placed b, int f, Vector3d v) {
        int[] loop = b.loops[f];
        for (int i = 0; i < loop.length; i++) {
            Vector3d o = b.vertices[loop[i]];
            Vector3d e = b.vertices[loop[(i + 1) % loop.length]].sub(o, new Vector3d());
            if (e.cross(b.normals[f]).dot(v.sub(o, new Vector3d())) > 0) {
                return false;
            }
        }
        return true;
    }

    private static double segments(Vector3d p, Vector3d p2, Vector3d q, Vector3d q2) {
        Vector3d u = p2.sub(p, new Vector3d());
        Vector3d v = q2.sub(q, new Vector3d());
        Vector3d r = q.sub(p, new Vector3d());
        double det = u.lengthSquared() * v.lengthSquared() - u.dot(v) * u.dot(v);
        double best = Double.MAX_VALUE;
        if (det > 0) {
            double s = (u.dot(r) * v.lengthSquared() - v.dot(r) * u.dot(v)) / det;
            double t = (u.dot(r) * u.dot(v) - v.dot(r) * u.lengthSquared()) / det;
            if (s >= 0 && s <= 1 && t >= 0 && t <= 1) {
                best = new Vector3d(r).fma(t, v).fma(-s, u).length();
            }
        }
        best = Math.min(best, Math.min(pointSegment(p, q, v), pointSegment(p2, q, v)));
        return Math.min(best, Math.min(pointSegment(q, p, u), pointSegment(q2, p, u)));
    }

    private static double pointSegment(Vector3d p, Vector3d q, Vector3d v) {
        Vector3d r = p.sub(q, new Vector3d());
        double t = Math.max(0, Math.min(1, r.dot(v) / v.lengthSquared()));
        return r.fma(-t, v).length();
    }

    /**
     * Signed distance of a point: over the faces inside; over faces, edges and vertices outside.
     */
    public static double pointDistance(Placed a, Vector3d c) {
        double height = -Double.MAX_VALUE;
        double best = Double.MAX_VALUE;
        for (int f = 0; f < a.loops.length; f++) {
            double above = a.normals[f].dot(c) - a.highest(a.normals[f]);
            height = Math.max(height, above);
            int[] loop = a.loops[f];
            if (above > 0 && inside(a, f, c)) {
                best = Math.min(best, above);
            }
            for (int i = 0; i < loop.length; i++) {
                Vector3d p = a.vertices[loop[i]];
                Vector3d e = a.vertices[loop[(i + 1) % loop.length]].sub(p, new Vector3d());
                best = Math.min(best, pointSegment(c, p, e));
            }
        }
        return height <= 0 ? height : best;
    }
}
