package dev.cairn.physics.shape.revolution;

/**
 * What a solid of revolution is made of: the convex hull of two discs about the y axis, relative to
 * the centre of mass, and a ball that is swept over it. A disc of radius 0 is a point.
 */
public final class Discs {
    /** Heights of the discs along y, m. */
    public final double low, high;

    /** Their radii, m. */
    public final double lowRadius, highRadius;

    /** Radius of the ball, m. */
    public final double round;

    /**
     * Two discs and a ball.
     *
     * @param low height of the lower disc, m
     * @param lowRadius its radius, m
     * @param high height of the upper disc, m
     * @param highRadius its radius, m
     * @param round radius of the ball, m
     */
    public Discs(double low, double lowRadius, double high, double highRadius, double round) {
        this.low = low;
        this.lowRadius = lowRadius;
        this.high = high;
        this.highRadius = highRadius;
        this.round = round;
    }

    /**
     * Of a shape.
     *
     * @param shape any solid of revolution
     * @return the same each time
     */
    public static Discs of(Revolved shape) {
        return shape.discs;
    }

    /** Whether the upper end is a tip. */
    public boolean hasTip() {
        return highRadius == 0 && lowRadius > 0 && round == 0;
    }
}
