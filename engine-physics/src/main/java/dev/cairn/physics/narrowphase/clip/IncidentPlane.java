package dev.cairn.physics.narrowphase.clip;

import dev.cairn.physics.narrowphase.pair.Pair;
import dev.cairn.physics.shape.polyhedron.Polyhedron;

/** The plane of a face of one polyhedron in the frame of the other; computed when it is needed. */
final class IncidentPlane {
    /** Cosine of planes that are too steep for a height above a point. */
    private static final double STEEP = 0x1p-10;

    private boolean known;

    /** Its unit normal and offset, m. */
    double x, y, z, offset;

    /** Another face is to come. */
    void forget() {
        known = false;
    }

    /** Chooses a face of the other shape, which is A when flipped. */
    void set(Pair p, boolean flip, Polyhedron other, int face) {
        if (known) {
            return;
        }
        known = true;
        double mx = other.normalX(face);
        double my = other.normalY(face);
        double mz = other.normalZ(face);
        if (flip) {
            x = p.r00 * mx + p.r10 * my + p.r20 * mz;
            y = p.r01 * mx + p.r11 * my + p.r21 * mz;
            z = p.r02 * mx + p.r12 * my + p.r22 * mz;
            offset = other.offset(face) - (mx * p.dx + my * p.dy + mz * p.dz);
        } else {
            x = p.r00 * mx + p.r01 * my + p.r02 * mz;
            y = p.r10 * mx + p.r11 * my + p.r12 * mz;
            z = p.r20 * mx + p.r21 * my + p.r22 * mz;
            offset = other.offset(face) + (x * p.dx + y * p.dy + z * p.dz);
        }
    }

    /**
     * How far above a point the plane is, along a unit normal, m; NaN when the plane is too steep.
     */
    double above(double px, double py, double pz, double nx, double ny, double nz) {
        double cosine = x * nx + y * ny + z * nz;
        if (!(cosine <= -STEEP)) {
            return Double.NaN;
        }
        return (offset - (x * px + y * py + z * pz)) / cosine;
    }
}
