package dev.cairn.physics.joint;

/** What a joint may hold: the bodies of a world. Not for others to implement; see {@link #of}. */
public interface Jointed {
    /**
     * The body's ECS entity.
     *
     * @return its id
     */
    long entity();

    /**
     * Names a body by its entity, as systems know it; whether there is such a body is asked when
     * the joint is made.
     *
     * @param entity of a body, or in a {@link NewJoint} the handle of a body's spawn in the same
     *     step
     * @return what a description takes as a body
     */
    static Jointed of(long entity) {
        return new ByEntity(entity);
    }

    /**
     * A body that is named by its entity.
     *
     * @param entity its id, or a handle
     */
    record ByEntity(long entity) implements Jointed {}
}
