package dev.cairn.physics.shape.decomposition;

import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.polyhedron.Polyhedron;

import org.joml.Vector3d;

/**
 * How far points are from a hull that leaves some of them out. The distance from a convex set is
 * convex, so of all places in the hull of the points, a point is the farthest.
 */
final class Shortfall {
    private Shortfall() {}

    /** The largest distance, m; points within {@code snap} of the hull are in it. */
    static double of(double[] points, ConvexHull hull, double snap) {
        Polyhedron faces = Polyhedron.of(hull);
        Vector3d com = hull.centreOfMass(new Vector3d());
        double[] corners = hull.vertices();
        int[][] loops = hull.faceLoops();
        double[] triangle = new double[9];
        double most = 0;
        for (int k = 0; k < points.length; k += 3) {
            double x = points[k] - com.x;
            double y = points[k + 1] - com.y;
            double z = points[k + 2] - com.z;
            double height = 0;
            for (int f = 0; f < faces.faceCount(); f++) {
                double along = faces.normalX(f) * x + faces.normalY(f) * y + faces.normalZ(f) * z;
                height = Math.max(height, along - faces.offset(f));
            }
            if (height <= snap) {
                continue;
            }
            double best = Double.POSITIVE_INFINITY;
            for (int[] loop : loops) {
                for (int i = 1; i + 1 < loop.length; i++) {
                    System.arraycopy(corners, 3 * loop[0], triangle, 0, 3);
                    System.arraycopy(corners, 3 * loop[i], triangle, 3, 3);
                    System.arraycopy(corners, 3 * loop[i + 1], triangle, 6, 3);
                    double square =
                            Planes.squareToTriangle(
                                    triangle, 0, points[k], points[k + 1], points[k + 2]);
                    best = Math.min(best, square);
                }
            }
            most = Math.max(most, Math.sqrt(best));
        }
        return most;
    }
}
