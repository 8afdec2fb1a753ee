package dev.cairn.physics.narrowphase.mesh;

import dev.cairn.physics.narrowphase.clip.Clipper;
import dev.cairn.physics.narrowphase.clip.Overlay;
import dev.cairn.physics.narrowphase.clip.Patch;
import dev.cairn.physics.narrowphase.pair.Axes;
import dev.cairn.physics.narrowphase.pair.Pair;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Shape;

/**
 * What a shape touches a triangle with, seen along the triangle's normal: the face, disc or line
 * that looks at it, cut by its sides. Where the normal is known to be the one that separates most,
 * that is the contact, without a search for an axis. One worker's; grows with the largest face.
 */
final class RimPoints {
    private final Pair pair = new Pair();
    private final Patch triangle = new Patch(), patch = new Patch();
    private final Overlay overlay = new Overlay();
    private final Clipper clipper = new Clipper();

    /**
     * Cuts.
     *
     * @param view the triangle, about its middle, axes of the mesh
     * @param front 1 if the shape is in front, else -1
     * @param shape not a ball, with its orientation
     * @param gx the triangle's middle from the shape's centre, m
     * @param nx unit normal towards the shape
     * @param margin points up to this far apart are of interest, m
     * @return corners on the shape, from the triangle's middle, with names as of triangle and shape
     */
    Clipper cut(
            ConvexHull view,
            double front,
            Shape shape,
            double qx,
            double qy,
            double qz,
            double qw,
            double gx,
            double gy,
            double gz,
            double nx,
            double ny,
            double nz,
            double margin) {
        pair.set(view, shape, 0, 0, 0, 1, qx, qy, qz, qw, -gx, -gy, -gz);
        if (pair.roundB) {
            triangle.fill(pair, false, nx, ny, nz);
            patch.fill(pair, true, -nx, -ny, -nz);
            overlay.begin(pair, triangle, patch, nx, ny, nz, 0);
            overlay.run();
            overlay.finish(margin);
            return overlay.out;
        }
        double x = -(pair.r00 * nx + pair.r10 * ny + pair.r20 * nz);
        double y = -(pair.r01 * nx + pair.r11 * ny + pair.r21 * nz);
        double z = -(pair.r02 * nx + pair.r12 * ny + pair.r22 * nz);
        int face = Axes.faceToward(pair.b, pair.b.support(x, y, z), x, y, z);
        clipper.clip(pair, false, front > 0 ? 0 : 1, face, margin, 0);
        return clipper;
    }
}
