package dev.cairn.physics.joint;

/** What a joint does about one axis. */
final class AxisSettings {
    boolean isLocked;
    boolean isLimited;
    double lower;
    double upper;

    /** Value that a lock holds. */
    double held;

    boolean isDriven;
    double speed;
    double motorMost;

    boolean isSprung;
    double target;
    double stiffness;
    double damping;
    boolean isAbsolute;
    double springMost;

    AxisSettings copy() {
        AxisSettings c = new AxisSettings();
        c.isLocked = isLocked;
        c.isLimited = isLimited;
        c.lower = lower;
        c.upper = upper;
        c.held = held;
        c.isDriven = isDriven;
        c.speed = speed;
        c.motorMost = motorMost;
        c.isSprung = isSprung;
        c.target = target;
        c.stiffness = stiffness;
        c.damping = damping;
        c.isAbsolute = isAbsolute;
        c.springMost = springMost;
        return c;
    }

    /** The same for others to see; what is not there is 0. */
    AxisState view() {
        return new AxisState(
                isLocked,
                isLimited,
                isLimited ? lower : 0,
                isLimited ? upper : 0,
                isDriven,
                isDriven ? speed : 0,
                isDriven ? motorMost : 0,
                isSprung,
                isSprung ? target : 0,
                isSprung ? stiffness : 0,
                isSprung ? damping : 0,
                isSprung && isAbsolute,
                isSprung ? springMost : 0);
    }

    /** Numbers of {@link #exchange}: one to a field. */
    static final int NUMBERS = 14;

    /** All fields to numbers, or back. */
    void exchange(double[] n, int at, boolean back) {
        isLocked = flag(n, at, isLocked, back);
        isLimited = flag(n, at + 1, isLimited, back);
        lower = number(n, at + 2, lower, back);
        upper = number(n, at + 3, upper, back);
        held = number(n, at + 4, held, back);
        isDriven = flag(n, at + 5, isDriven, back);
        speed = number(n, at + 6, speed, back);
        motorMost = number(n, at + 7, motorMost, back);
        isSprung = flag(n, at + 8, isSprung, back);
        target = number(n, at + 9, target, back);
        stiffness = number(n, at + 10, stiffness, back);
        damping = number(n, at + 11, damping, back);
        isAbsolute = flag(n, at + 12, isAbsolute, back);
        springMost = number(n, at + 13, springMost, back);
    }

    private static double number(double[] n, int at, double now, boolean back) {
        if (!back) {
            n[at] = now;
        }
        return n[at];
    }

    private static boolean flag(double[] n, int at, boolean now, boolean back) {
        return number(n, at, now ? 1 : 0, back) != 0;
    }

    void free() {
        isLocked = false;
        isLimited = false;
        isDriven = false;
        isSprung = false;
    }

    void limit(String axis, double low, double high, double bound) {
        if (!(low <= high)) {
            throw new IllegalArgumentException(
                    "limits of "
                            + axis
                            + " are "
                            + low
                            + " and "
                            + high
                            + "; the lower one must not be above the upper one, and both be"
                            + " numbers");
        }
        boolean isLow = low != Double.NEGATIVE_INFINITY && low < -bound;
        if (isLow || (high != Double.POSITIVE_INFINITY && high > bound)) {
            throw new IllegalArgumentException(
                    "limits of "
                            + axis
                            + " are "
                            + low
                            + " and "
                            + high
                            + "; they must be from "
                            + -bound
                            + " to "
                            + bound
                            + ", or infinite for none");
        }
        isLocked = false;
        isLimited = true;
        lower = low;
        upper = high;
    }
}
