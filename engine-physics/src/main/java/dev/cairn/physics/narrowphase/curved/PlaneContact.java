package dev.cairn.physics.narrowphase.curved;

import dev.cairn.physics.narrowphase.clip.ContactPoints;
import dev.cairn.physics.narrowphase.clip.Overlay;
import dev.cairn.physics.narrowphase.clip.Patch;
import dev.cairn.physics.narrowphase.clip.Reduction;
import dev.cairn.physics.narrowphase.pair.FeatureIds;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.narrowphase.pair.Pair;

/**
 * Any shape against a half-space, in closed form: how far the shape reaches down is the distance,
 * and what it reaches down with is the manifold. The pair's first shape is the solid one, its
 * second one is not used.
 */
public final class PlaneContact {
    private final Pair pair;
    private final ContactPoints points;
    private final Patch patch = new Patch(), plane = new Patch();
    private final Overlay overlay = new Overlay();
    private final Reduction reduction = new Reduction();

    /** The outward normal of the half-space, world axes. */
    double normalX, normalY, normalZ;

    private double nx, ny, nz, height;

    PlaneContact(Pair pair, ContactPoints points) {
        this.pair = pair;
        this.points = points;
    }

    /**
     * Turns the normal, and finds the signed distance.
     *
     * @param ox centre of mass of the solid minus a point of the plane, world, m
     */
    double distance(double qx, double qy, double qz, double qw, double ox, double oy, double oz) {
        double s = 2 / (qx * qx + qy * qy + qz * qz + qw * qw);
        normalX = s * (qx * qy - qz * qw);
        normalY = 1 - s * (qx * qx + qz * qz);
        normalZ = s * (qy * qz + qx * qw);
        nx = pair.w00 * normalX + pair.w10 * normalY + pair.w20 * normalZ;
        ny = pair.w01 * normalX + pair.w11 * normalY + pair.w21 * normalZ;
        nz = pair.w02 * normalX + pair.w12 * normalY + pair.w22 * normalZ;
        height = normalX * ox + normalY * oy + normalZ * oz;
        return height - pair.reachA(-nx, -ny, -nz) - pair.radiusA;
    }

    /**
     * Fills the manifold as if the solid were the first shape.
     *
     * @param second whether the solid is the second shape: then the names say so
     */
    long run(
            double separation,
            boolean second,
            double margin,
            double hysteresis,
            long cache,
            Manifold out) {
        if (separation > margin) {
            return 0;
        }
        int last = (int) cache;
        patch.fill(pair, false, -nx, -ny, -nz);
        points.setAxis(-nx, -ny, -nz);
        if (!patch.line && patch.flat == Patch.NONE) {
            double reach = pair.radiusA + separation / 2;
            points.single(
                    -reach * nx, -reach * ny, -reach * nz, separation, FeatureIds.CLOSEST, out);
        } else {
            plane.ox = -height * nx;
            plane.oy = -height * ny;
            plane.oz = -height * nz;
            patch.kind = second ? FeatureIds.VERTEX_B : FeatureIds.VERTEX_A;
            patch.nameP = patch.kind | (patch.nameP & ~FeatureIds.VERTEX_B);
            patch.nameQ = patch.kind | (patch.nameQ & ~FeatureIds.VERTEX_B);
            overlay.begin(pair, plane, patch, nx, ny, nz, last);
            if (patch.flat == Patch.DISC && patch.flatter) {
                overlay.discOnPlane();
            } else {
                overlay.restOnPlane();
            }
            overlay.finish(margin);
            reduction.reduce(overlay.out, nx, ny, nz, 0.01 * hysteresis, hysteresis, last);
            points.take(overlay.out, nx, ny, nz, out);
            boolean disc = patch.flat == Patch.DISC && patch.flatter;
            out.patch = disc && out.pointCount == Manifold.POINTS ? Patch.DISC_SHARE : 0;
        }
        // As it is in the world, not turned to and fro.
        out.normalX = -normalX;
        out.normalY = -normalY;
        out.normalZ = -normalZ;
        // The points of the last tick stay while a deeper one is hardly deeper.
        double deepest = Double.MAX_VALUE;
        for (int i = 0; i < out.pointCount; i++) {
            deepest = Math.min(deepest, out.separation[i]);
        }
        out.bound = Math.abs(deepest - separation) + 0x1p-48 * (pair.scale + Math.abs(height));
        return key(FeatureIds.of(out));
    }

    /**
     * The key with which the next tick goes on.
     *
     * @param names of the points, as {@link FeatureIds} sums them up; 0 for none
     */
    public static long key(int names) {
        return names == 0 ? 0 : 1L << 62 | (names & 0xFFFFFFFFL);
    }

    /** One point below the lowest one of the solid, as if the solid were the first shape. */
    void witness(double separation, Manifold out) {
        int v = pair.supportA(-nx, -ny, -nz, 0);
        double reach = pair.radiusA + separation / 2;
        points.setAxis(-nx, -ny, -nz);
        points.single(
                pair.vertexAX(v) - reach * nx,
                pair.vertexAY(v) - reach * ny,
                pair.vertexAZ(v) - reach * nz,
                separation,
                FeatureIds.CLOSEST,
                out);
    }
}
