package dev.cairn.physics.internal;

/**
 * How far what rests sinks into a soft contact, and how fast it comes out again: the contact learns
 * a share of its overlap in each tick.
 *
 * <p>The sag goes by the sub-step alone, some 70 micrometres at 1/240 s; so of a thing that is thin
 * it is a good part. If it lies alone, its contact learns as much faster as the sag is larger than
 * what does not show, up to five times; in a stack, loads that one tick learnt would swing.
 */
public final class Sag {
    /** Over the inner radius: what does not show. */
    public static final double SHOWS = 0.01;

    private static final int MOST = 5;

    private Sag() {}

    /**
     * How many times as fast a contact of a body learns.
     *
     * @param sag of what rests on a static body, m
     * @param innerRadius of the body, m
     * @return 1 for all but thin bodies
     */
    public static int times(double sag, double innerRadius) {
        double share = SHOWS * innerRadius;
        return sag < MOST * share ? Math.max(1, (int) (sag / share)) : MOST;
    }
}
