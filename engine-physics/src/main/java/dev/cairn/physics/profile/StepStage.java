package dev.cairn.physics.profile;

/** The stages of a physics step, in the order in which they run; {@link StepProfile} times them. */
public enum StepStage {
    /** Bodies whose entity is gone leave, new fixed ones are placed. */
    BODIES,
    /** Boxes follow their bodies. */
    BOUNDS,
    /** The broad phase finds pairs of boxes that overlap. */
    PAIRS,
    /** Rows of pairs that parted leave, new ones are appended. */
    ROWS,
    /** The narrow phase finds contact points. */
    POINTS,
    /** The contact solver moves the bodies. */
    SOLVE,
    /** Poses and velocities go to the ECS. */
    PUBLISH,
    /** Touches that began and ended are listed. */
    TOUCH
}
