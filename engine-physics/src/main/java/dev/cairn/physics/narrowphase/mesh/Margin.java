package dev.cairn.physics.narrowphase.mesh;

/**
 * Up to which separation a shape's points are reported: what it comes nearer along the normal while
 * points are looked for, and what is added in all directions. What slides or rolls along a surface
 * does not come nearer to it, however fast it is. One worker's; axes of the mesh.
 */
final class Margin {
    /** Added along every normal, m. */
    private double all;

    /** How far the shape goes, m. */
    double driftX, driftY, driftZ;

    /** What a face that is touched reports in all directions, as a half-space does, m. */
    double ofFace;

    /**
     * Chooses.
     *
     * @param inAllDirections m
     * @param x how far the shape goes, m
     * @param face what is reported of a face of which any point is, m
     */
    void set(double inAllDirections, double x, double y, double z, double face) {
        all = inAllDirections;
        ofFace = face;
        driftX = x;
        driftY = y;
        driftZ = z;
    }

    /**
     * Along a normal.
     *
     * @param nx unit vector from the surface to the shape
     */
    double along(double nx, double ny, double nz) {
        return all + Math.max(0, closing(nx, ny, nz));
    }

    /** How far the shape goes against a normal, m. */
    double closing(double nx, double ny, double nz) {
        return -(driftX * nx + driftY * ny + driftZ * nz);
    }

    /** Along any normal at most. */
    double most() {
        return all + Math.sqrt(driftX * driftX + driftY * driftY + driftZ * driftZ);
    }

    /** Widens the box of a shape by where it will be. */
    void widen(double[] box) {
        for (int axis = 0; axis < 3; axis++) {
            double drift = axis == 0 ? driftX : axis == 1 ? driftY : driftZ;
            box[axis] += Math.min(0, drift) - all;
            box[axis + 3] += Math.max(0, drift) + all;
        }
    }
}
