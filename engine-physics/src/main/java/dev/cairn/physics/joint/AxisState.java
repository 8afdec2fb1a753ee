package dev.cairn.physics.joint;

/**
 * What a joint does about an axis; {@link JointRef#settings} tells it.
 *
 * @param isLocked whether it is held
 * @param isLimited whether it has limits
 * @param lower limit, m or rad, or minus infinity
 * @param upper limit, m or rad, or infinity
 * @param isDriven whether it has a motor
 * @param speed of the motor, m/s or rad/s
 * @param motorMost largest force or torque of the motor, N or N m
 * @param isSprung whether it has a spring
 * @param target of the spring, m or rad
 * @param stiffness of the spring: Hz, or where {@code isAbsolute} N/m or N m/rad
 * @param damping of the spring: damping ratio, or where {@code isAbsolute} N s/m or N m s/rad
 * @param isAbsolute whether the spring was given by stiffness and damping
 * @param springMost largest force or torque of the spring, N or N m
 */
public record AxisState(
        boolean isLocked,
        boolean isLimited,
        double lower,
        double upper,
        boolean isDriven,
        double speed,
        double motorMost,
        boolean isSprung,
        double target,
        double stiffness,
        double damping,
        boolean isAbsolute,
        double springMost) {
    /** An axis about which nothing is done. */
    public static final AxisState FREE =
            new AxisState(false, false, 0, 0, false, 0, 0, false, 0, 0, 0, false, 0);
}
