package dev.cairn.physics;

/**
 * In what numbers the contacts of a tick are solved. Positions and velocities of bodies are doubles
 * in either case, and so is all of the collision.
 */
public enum Precision {
    /** The default: errors of the order of 1e-16 of what moves. */
    DOUBLE,

    /**
     * Rows and changes of velocity are floats: twice as many contacts to a vector, half the memory.
     * A change of a velocity has an error of some 1e-7 of itself; what is at rest stays at rest.
     * For bodies from 0.1 mm to 1 km.
     */
    SINGLE
}
