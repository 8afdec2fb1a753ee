package dev.cairn.physics.joint;

/** A way in which the frame of a joint in body B can move against its frame in body A. */
public enum JointAxis {
    /** Along the x axis of A's frame, m. A slider slides along it. */
    X(0, false),

    /** Along the y axis of A's frame, m. The wheel of a car is sprung along it. */
    Y(1, false),

    /** Along the z axis of A's frame, m. */
    Z(2, false),

    /** Turn of B about the x axis of its own frame, rad, from -pi to pi. A hinge turns about it. */
    TWIST(3, true),

    /** Angle of B's x axis about the y axis of A's frame, rad. The wheel of a car is steered so. */
    SWING_Y(4, true),

    /** Angle of B's x axis about the z axis of A's frame, rad. */
    SWING_Z(5, true),

    /** Angle between the two x axes, rad, at least 0: limits make a cone. */
    CONE(6, true),

    /** Distance of the origins of the two frames, m. */
    DISTANCE(7, false),

    /** Length of the curve of {@link Joint#path} from its first point on, m; laps count. */
    PATH(8, false);

    /** All of them, without a copy. */
    static final JointAxis[] ALL = values();

    /** Where an axis lies in tables by axis. */
    final int index;

    /** Whether it is measured in rad, not in m. */
    final boolean isAngle;

    JointAxis(int index, boolean isAngle) {
        this.index = index;
        this.isAngle = isAngle;
    }
}
