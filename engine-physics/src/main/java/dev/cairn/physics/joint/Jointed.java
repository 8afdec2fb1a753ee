package dev.cairn.physics.joint;

/** What a joint may hold: the bodies of a world. Not for others to implement. */
public interface Jointed {
    /**
     * The body's ECS entity.
     *
     * @return its id
     */
    long entity();
}
