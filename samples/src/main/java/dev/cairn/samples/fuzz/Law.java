package dev.cairn.samples.fuzz;

/** What no world may break. */
public enum Law {
    /** Kinetic and potential energy are never above what they were at the start. */
    ENERGY("gain over the energy at the start", 1e-4),
    /** Momentum is kept where nothing is around. */
    MOMENTUM("change over the sum of the sizes of momenta", 1e-9),
    /** Angular momentum is kept where nothing is around. */
    ANGULAR("change over the sum of the sizes of angular momenta", 0.02),
    /** Nobody is wholly outside of a closed room, or below the floor. */
    WALLS("centre beyond a wall, in outer radii", 1),
    /** No centre of mass is beyond a wall, not even for a tick. */
    SINK("centre beyond a wall, in outer radii", 0),
    /** What has rested for a second overlaps by less than a share of its size. */
    OVERLAP("deepest overlap over the least inner radius", 0.1),
    /** What has rested in every visible sense for three seconds sleeps. */
    SLEEP("bodies awake", 0),
    /** No joint is apart. */
    GAP("gap of a joint, rad, or over the lesser outer radius of its bodies", 1e-3),
    /** The same bits for any number of workers and lanes. */
    BITS("ticks with other bits", 0),
    /** Nothing that was finite is quarantined. */
    FINITE("bodies in quarantine", 0),
    /** No step fails. */
    FAILURE("steps that failed", 0);

    private final String measure;
    private final double bound;

    Law(String measure, double bound) {
        this.measure = measure;
        this.bound = bound;
    }

    /** What is measured. */
    public String measure() {
        return measure;
    }

    /** Above which the law is broken. */
    public double bound() {
        return bound;
    }
}
