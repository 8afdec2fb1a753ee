package dev.cairn.physics.contact.impact;

import dev.cairn.physics.internal.Rotations;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.mesh.TriangleSet;
import dev.cairn.physics.shape.polyhedron.Polyhedron;
import dev.cairn.physics.sweep.Flight;
import dev.cairn.physics.sweep.TimeOfImpact;

/**
 * Whether a solid passes a surface of triangles that stands: along its way it meets none of those
 * in the box around the way. One worker's; allocates only when more triangles are found than ever.
 */
final class TrianglePass {
    /** Of more triangles than these it is not asked. */
    private static final int MOST = 256;

    /** Normals that are tried, and the cosine of the angle between two that are one. */
    private static final int NORMALS = 8;

    private static final double SAME = 1 - 1e-6;

    private final TriangleSet.Found found = new TriangleSet.Found();
    private final ConvexHull shape = ConvexHull.triangle();
    private final Polyhedron triangle = Polyhedron.of(shape);
    private final Flight stands = new Flight();
    private final double[] box = new double[6], corner = new double[9], out = new double[3];

    private final double[] normal = new double[3 * NORMALS];
    private int normals;

    /** World from triangles. */
    private double qx, qy, qz, qw;

    /** Chooses how the surface lies: world from triangles, unit quaternion. */
    TrianglePass turned(double x, double y, double z, double w) {
        qx = x;
        qy = y;
        qz = z;
        qw = w;
        return this;
    }

    /**
     * Whether all is passed; false also where that is not known.
     *
     * @param solid on its way
     * @param x from the surface's origin to the solid's centre at the start, world, m
     * @param outer radius of the solid, m
     * @param step length of the tick, s
     * @param met nearer than that counts as met, m
     */
    boolean passes(
            TriangleSet set,
            Flight solid,
            double x,
            double y,
            double z,
            double outer,
            double step,
            double met,
            TimeOfImpact search) {
        span(solid, x, y, z, outer + met, step);
        set.find(box, found);
        if (found.count > MOST) {
            return false;
        }
        stands.shape = shape;
        stands.turned(qx, qy, qz, qw).lever(0, 0, 0).begin(0, true);
        findNormals(set);
        for (int i = 0; i < found.count; i++) {
            set.corners(found.triangle[i], corner);
            double gx = (corner[0] + corner[3] + corner[6]) / 3;
            double gy = (corner[1] + corner[4] + corner[7]) / 3;
            double gz = (corner[2] + corner[5] + corner[8]) / 3;
            triangle.setTriangle(corner, gx, gy, gz);
            Rotations.rotate(qx, qy, qz, qw, gx, gy, gz, out);
            search.of(solid, stands, out[0] - x, out[1] - y, out[2] - z, met);
            if (!isHeldApart(search, step)
                    && (search.find(0, step, outer) || search.isUndecided || search.capped)) {
                return false;
            }
        }
        return true;
    }

    /** What passes a face as closely as rounding tells is held apart by its normal, or another. */
    private boolean isHeldApart(TimeOfImpact search, double step) {
        for (int k = 0; k < 3 * normals; k += 3) {
            if (search.arePassing(step, -normal[k], -normal[k + 1], -normal[k + 2])) {
                return true;
            }
        }
        return false;
    }

    /** Some of the triangles' normals, each once, world. */
    private void findNormals(TriangleSet set) {
        normals = 0;
        for (int i = 0; i < found.count && normals < NORMALS; i++) {
            set.corners(found.triangle[i], corner);
            double ux = corner[3] - corner[0];
            double uy = corner[4] - corner[1];
            double uz = corner[5] - corner[2];
            double vx = corner[6] - corner[0];
            double vy = corner[7] - corner[1];
            double vz = corner[8] - corner[2];
            double nx = uy * vz - uz * vy;
            double ny = uz * vx - ux * vz;
            double nz = ux * vy - uy * vx;
            double one = 1 / Math.sqrt(nx * nx + ny * ny + nz * nz);
            Rotations.rotate(qx, qy, qz, qw, one * nx, one * ny, one * nz, out);
            boolean isNew = true;
            for (int k = 0; k < 3 * normals && isNew; k += 3) {
                double dot = out[0] * normal[k] + out[1] * normal[k + 1] + out[2] * normal[k + 2];
                isNew = dot < SAME;
            }
            if (isNew) {
                System.arraycopy(out, 0, normal, 3 * normals++, 3);
            }
        }
    }

    /** The box around the way, in the axes of the triangles. */
    private void span(Flight solid, double x, double y, double z, double outer, double step) {
        double bend =
                Math.sqrt(solid.ax * solid.ax + solid.ay * solid.ay + solid.az * solid.az)
                        * (step * step / 8);
        double lever =
                Math.sqrt(
                        solid.armX * solid.armX
                                + solid.armY * solid.armY
                                + solid.armZ * solid.armZ);
        double wide = outer + bend + 2 * lever;
        Rotations.rotate(-qx, -qy, -qz, qw, x, y, z, out);
        double sx = out[0];
        double sy = out[1];
        double sz = out[2];
        solid.move(step);
        Rotations.rotate(-qx, -qy, -qz, qw, x + solid.x, y + solid.y, z + solid.z, out);
        box[0] = Math.min(sx, out[0]) - wide;
        box[1] = Math.min(sy, out[1]) - wide;
        box[2] = Math.min(sz, out[2]) - wide;
        box[3] = Math.max(sx, out[0]) + wide;
        box[4] = Math.max(sy, out[1]) + wide;
        box[5] = Math.max(sz, out[2]) + wide;
    }
}
