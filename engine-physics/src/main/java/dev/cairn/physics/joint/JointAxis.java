package dev.cairn.physics.joint;

/** A way in which the frame of a joint in body B can move against its frame in body A. */
public enum JointAxis {
    /** Along the x axis of A's frame, m. A slider slides along it. */
    X,

    /** Along the y axis of A's frame, m. The wheel of a car is sprung along it. */
    Y,

    /** Along the z axis of A's frame, m. */
    Z,

    /** Turn of B about the x axis of its own frame, rad, from -pi to pi. A hinge turns about it. */
    TWIST,

    /** Angle of B's x axis about the y axis of A's frame, rad. The wheel of a car is steered so. */
    SWING_Y,

    /** Angle of B's x axis about the z axis of A's frame, rad. */
    SWING_Z,

    /** Angle between the two x axes, rad, at least 0: limits make a cone. */
    CONE,

    /** Distance of the origins of the two frames, m. */
    DISTANCE
}
