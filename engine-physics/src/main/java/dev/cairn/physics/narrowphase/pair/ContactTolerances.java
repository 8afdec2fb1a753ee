package dev.cairn.physics.narrowphase.pair;

/**
 * What all kinds of pairs allow, so that contacts of one body look alike. Lengths are fractions of
 * the smaller inner radius of a pair.
 */
public final class ContactTolerances {
    /**
     * What one face, or one kind of contact, must be better by to replace that of the last tick.
     */
    public static final double HYSTERESIS = 1e-3;

    /** Corners this near to a side plane count as on it, so that flush boxes keep their names. */
    public static final double ON_PLANE = 1e-5;

    /**
     * The same for a corner that was a point of the last tick: it leaves the plane later than it
     * came, so that boxes that sway a little keep their names too.
     */
    public static final double STILL_ON_PLANE = 1e-3;

    /** In half lengths from the middle of an edge: edges cross up to there. */
    public static final double CROSSING_END = 1 + 2e-9;

    /** Cosine of 0.1 rad: nearer axes are the same direction, seen through rounding. */
    public static final double NEARLY_PARALLEL = 0.995;

    private ContactTolerances() {}

    /**
     * What the points of a face may tell the depth wrong by, m, before a point contact replaces
     * them.
     *
     * @param wasPoint the contact of the last tick was such a point
     */
    public static double depthError(boolean wasPoint, double hysteresis, double depth) {
        double far = Math.abs(depth);
        return wasPoint ? 0.5 * hysteresis + 0.05 * far : 1.5 * hysteresis + 0.15 * far;
    }
}
