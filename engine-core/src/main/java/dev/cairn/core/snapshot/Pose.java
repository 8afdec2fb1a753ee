package dev.cairn.core.snapshot;

import dev.cairn.core.ecs.component.Component;

/**
 * Where a body is and how it is turned. World frame, right-handed, y up, metres.
 *
 * @param x position, m
 * @param y position, m
 * @param z position, m
 * @param qx unit quaternion that turns body vectors into world vectors
 * @param qy unit quaternion
 * @param qz unit quaternion
 * @param qw unit quaternion, the real part
 * @param jumps number of teleports so far; a change means that nothing may be interpolated across
 */
public record Pose(
        double x, double y, double z, double qx, double qy, double qz, double qw, int jumps) {
    /** Key of this component. */
    public static final Component<Pose> COMPONENT = Component.of(Pose.class);

    /**
     * An unturned pose.
     *
     * @param x position, m
     * @param y position, m
     * @param z position, m
     * @return the pose, with no jumps
     */
    public static Pose at(double x, double y, double z) {
        return new Pose(x, y, z, 0, 0, 0, 1, 0);
    }
}
