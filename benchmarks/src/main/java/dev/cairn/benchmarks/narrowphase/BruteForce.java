package dev.cairn.benchmarks.narrowphase;

import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.polyhedron.Polyhedron;

import org.joml.Quaterniond;
import org.joml.Vector3d;

/** The depth of two overlapping polyhedra by trying every axis there is. */
final class BruteForce {
    private BruteForce() {}

    /** The largest separation over all face normals and edge pairs: minus the depth. */
    static double depth(PairSet set, int pair) {
        Polyhedron a = polyhedron(set.a[pair]);
        Polyhedron b = polyhedron(set.b[pair]);
        Quaterniond relative = set.turnA[pair].conjugate(new Quaterniond()).mul(set.turnB[pair]);
        Vector3d offset = set.turnA[pair].transformInverse(set.offset[pair], new Vector3d());
        Vector3d[] verticesA = vertices(a, new Quaterniond(), new Vector3d());
        Vector3d[] verticesB = vertices(b, relative, offset);
        double best = Double.NEGATIVE_INFINITY;
        for (int f = 0; f < a.faceCount(); f++) {
            Vector3d n = new Vector3d(a.normalX(f), a.normalY(f), a.normalZ(f));
            best = Math.max(best, along(n, verticesA, verticesB));
        }
        for (int f = 0; f < b.faceCount(); f++) {
            Vector3d n = new Vector3d(b.normalX(f), b.normalY(f), b.normalZ(f));
            best = Math.max(best, along(relative.transform(n).negate(), verticesA, verticesB));
        }
        for (int i = 0; i < a.edgeCount(); i++) {
            Vector3d u = edge(a, i, verticesA);
            for (int j = 0; j < b.edgeCount(); j++) {
                Vector3d n = u.cross(edge(b, j, verticesB), new Vector3d());
                if (n.lengthSquared() > 1e-16) {
                    n.normalize();
                    best = Math.max(best, along(n, verticesA, verticesB));
                    best = Math.max(best, along(n.negate(), verticesA, verticesB));
                }
            }
        }
        return best;
    }

    private static Polyhedron polyhedron(Shape shape) {
        return shape instanceof Box box ? Polyhedron.of(box) : Polyhedron.of((ConvexHull) shape);
    }

    private static Vector3d[] vertices(Polyhedron h, Quaterniond turn, Vector3d offset) {
        Vector3d[] placed = new Vector3d[h.vertexCount()];
        for (int v = 0; v < placed.length; v++) {
            placed[v] =
                    turn.transform(new Vector3d(h.vertexX(v), h.vertexY(v), h.vertexZ(v)))
                            .add(offset);
        }
        return placed;
    }

    private static Vector3d edge(Polyhedron h, int edge, Vector3d[] vertices) {
        return vertices[h.edgeTo(edge)].sub(vertices[h.edgeFrom(edge)], new Vector3d());
    }

    /** Separation along a unit vector from A to B. */
    private static double along(Vector3d n, Vector3d[] a, Vector3d[] b) {
        double far = Double.NEGATIVE_INFINITY;
        for (Vector3d p : a) {
            far = Math.max(far, n.dot(p));
        }
        double near = Double.POSITIVE_INFINITY;
        for (Vector3d p : b) {
            near = Math.min(near, n.dot(p));
        }
        return near - far;
    }
}
