package dev.cairn.physics.narrowphase;

import dev.cairn.physics.shape.Shape;

/**
 * Collides pairs of convex shapes. One instance per worker: it owns all scratch memory and is not
 * thread-safe.
 */
public final class NarrowPhase {
    /** Creates the scratch of one worker. */
    public NarrowPhase() {}

    /**
     * Finds the contact of a pair.
     *
     * @param a first shape
     * @param b second shape
     * @param qAx orientation of A, world from body, unit quaternion
     * @param qAy orientation of A
     * @param qAz orientation of A
     * @param qAw orientation of A
     * @param qBx orientation of B, world from body, unit quaternion
     * @param qBy orientation of B
     * @param qBz orientation of B
     * @param qBw orientation of B
     * @param dx centre of mass of B minus that of A, world axes, m
     * @param dy see {@code dx}
     * @param dz see {@code dx}
     * @param margin points up to this far apart are reported, m, not negative
     * @param cache the word that the last call for this pair in this order returned; 0 if there is
     *     none
     * @param out receives the contact
     * @return the word to pass next time
     */
    public long collide(
            Shape a,
            Shape b,
            double qAx,
            double qAy,
            double qAz,
            double qAw,
            double qBx,
            double qBy,
            double qBz,
            double qBw,
            double dx,
            double dy,
            double dz,
            double margin,
            long cache,
            Manifold out) {
        throw new UnsupportedOperationException();
    }

    /**
     * The signed distance of two shapes: how far apart they are, or minus the length of the
     * shortest move that separates them.
     *
     * @param a first shape
     * @param b second shape
     * @param qAx orientation of A, world from body, unit quaternion
     * @param qAy orientation of A
     * @param qAz orientation of A
     * @param qAw orientation of A
     * @param qBx orientation of B, world from body, unit quaternion
     * @param qBy orientation of B
     * @param qBz orientation of B
     * @param qBw orientation of B
     * @param dx centre of mass of B minus that of A, world axes, m
     * @param dy see {@code dx}
     * @param dz see {@code dx}
     * @return m
     */
    public double distance(
            Shape a,
            Shape b,
            double qAx,
            double qAy,
            double qAz,
            double qAw,
            double qBx,
            double qBy,
            double qBz,
            double qBw,
            double dx,
            double dy,
            double dz) {
        throw new UnsupportedOperationException();
    }
}
