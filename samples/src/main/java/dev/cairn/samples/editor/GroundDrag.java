package dev.cairn.samples.editor;

import dev.cairn.samples.scenefile.Xyz;

/**
 * Moves a thing in the level plane through the point by which it was taken, so that this point
 * stays under the cursor. World frame, metres. Immutable.
 *
 * @param taken the point by which it was taken
 * @param from where the thing was then
 */
record GroundDrag(Xyz taken, Xyz from) {
    /** A ray that meets the plane farther away says nothing useful: it is close to the horizon. */
    static final double FARTHEST = 500;

    /**
     * Where the thing is wanted.
     *
     * @param eye where the ray of the cursor begins
     * @param along its direction, unit
     * @param now where the thing is; the answer where the ray does not meet the plane
     * @param grid positions are multiples of this along x and z; 0 = any
     * @return its new place; the height is that of now
     */
    Xyz to(Xyz eye, Xyz along, Xyz now, double grid) {
        // eye.y + t along.y = taken.y
        double t = (taken.y() - eye.y()) / along.y();
        if (!(t > 0 && t <= FARTHEST)) {
            return now;
        }
        double x = from.x() + eye.x() + t * along.x() - taken.x();
        double z = from.z() + eye.z() + t * along.z() - taken.z();
        return new Xyz(snap(x, grid), now.y(), snap(z, grid));
    }

    static double snap(double value, double grid) {
        return grid > 0 ? Math.rint(value / grid) * grid : value;
    }
}
