package dev.cairn.physics.tuning;

/**
 * In what numbers the contacts of a tick are solved. Positions and velocities of bodies are doubles
 * in either case, and so is all of the collision.
 */
public enum Precision {
    /**
     * The default: {@link #SINGLE} for the contacts of islands of more than 1024, {@link #DOUBLE}
     * for all others. A few sweeps bring a large island within some 1e-4 of its solution, and
     * rounding to floats is not seen beside that; what a few bodies do is right to the last digits
     * of a double.
     */
    AUTO(Tunable.LARGE_ISLAND),

    /** Errors of the order of 1e-16 of what moves. */
    DOUBLE(Integer.MAX_VALUE),

    /**
     * Rows and changes of velocity are floats: twice as many contacts to a vector, half the memory.
     * A change of a velocity has an error of some 1e-7 of itself; what is at rest stays at rest.
     * For bodies from 0.1 mm to 1 km.
     */
    SINGLE(0);

    private final int floatsFrom;

    Precision(int floatsFrom) {
        this.floatsFrom = floatsFrom;
    }

    /**
     * What stands in the tuning for this precision.
     *
     * @return a value of {@link Tunable#FLOATS_FROM}
     */
    public int floatsFrom() {
        return floatsFrom;
    }

    /**
     * The precision that a tuning says.
     *
     * @param floatsFrom a value of {@link Tunable#FLOATS_FROM}
     * @return {@link #AUTO} for what is neither all nor nothing
     */
    public static Precision of(int floatsFrom) {
        return floatsFrom == 0 ? SINGLE : floatsFrom == Integer.MAX_VALUE ? DOUBLE : AUTO;
    }
}
