package dev.cairn.physics.shape.revolution;

/**
 * A solid of revolution about the y axis of its frame. The narrow phase reads what it is made of
 * with {@link Discs#of}; that is no part of what a user of the shape sees.
 */
public abstract class Revolved {
    /** Relative to the centre of mass. */
    final Discs discs;

    protected Revolved(Discs discs) {
        this.discs = discs;
    }
}
