package dev.cairn.samples.editor;

import dev.cairn.physics.joint.AxisState;
import dev.cairn.render.ui.Ui;

import java.util.Arrays;
import java.util.List;

/**
 * What a joint does about one axis, as fields: free, locked or limited, a motor, a spring. Angles
 * are shown in degrees. Window thread; makes no garbage while nothing is typed.
 */
final class AxisFields {
    /** By the number of the axis. */
    static final String[] TITLES = {
        "way along x",
        "way along y",
        "way along z",
        "twist about x",
        "swing about y",
        "swing about z",
        "cone about x",
        "distance",
        "way along the path"
    };

    private static final String[] SHORT = {
        "x", "y", "z", "twist", "sw. y", "sw. z", "cone", "dist.", "path"
    };

    private static final int FIRST_ANGLE = 3;
    private static final int LAST_ANGLE = 6;
    private static final List<String> STATES = List.of("free", "locked", "limited");
    private static final int LOCKED = 1;
    private static final int LIMITED = 2;
    private static final List<String> SPRINGS = List.of("frequency", "stiffness");

    /** Limits at first: nothing is beyond them. */
    private static final double ANGLE = Math.PI;

    private static final double WAY = 1;

    private static final String[] STATE = names(" is");
    private static final String[] LOWER = names(" from");
    private static final String[] UPPER = names(" up to");
    private static final String[] MOTOR = names(": a motor");
    private static final String[] SPEED = names(" speed");
    private static final String[] MOTOR_MOST = names(" most");
    private static final String[] SPRING = names(": a spring");
    private static final String[] TARGET = names(" target");
    private static final String[] BY = names(" by");
    private static final String[] HERTZ = names(" Hz");
    private static final String[] RATIO = names(" ratio");
    private static final String[] STIFFNESS = names(" stiff");
    private static final String[] DAMPING = names(" damp");
    private static final String[] SPRING_MOST = names(" most of it");
    private static final String UNITS = "degrees, N m; most 0: no bound";
    private static final String WAYS = "m, N; most 0: no bound";

    private static final AxisState LOCK =
            new AxisState(true, false, 0, 0, false, 0, 0, false, 0, 0, 0, false, 0);

    private final Fields fields;

    AxisFields(Fields fields) {
        this.fields = fields;
    }

    private static String[] names(String word) {
        return Arrays.stream(SHORT).map(axis -> axis + word).toArray(String[]::new);
    }

    static boolean isAngle(int axis) {
        return axis >= FIRST_ANGLE && axis <= LAST_ANGLE;
    }

    /** A largest force, 0 for none. */
    static double most(Ui ui, Fields fields, String label, double most) {
        double shown = Double.isInfinite(most) ? 0 : most;
        double typed = fields.number(ui, label, shown);
        return typed == shown ? most : typed > 0 ? typed : Double.POSITIVE_INFINITY;
    }

    /** Degrees of an angle, metres of a way, without the rounding that nobody typed. */
    private double number(Ui ui, int axis, String label, double value) {
        if (!isAngle(axis)) {
            return fields.number(ui, label, value);
        }
        double shown = Math.rint(Math.toDegrees(value) * 1e9) / 1e9;
        double typed = fields.number(ui, label, shown);
        return typed == shown ? value : Math.toRadians(typed);
    }

    /**
     * The fields of an axis.
     *
     * @param axis its number
     * @param old what is in force
     * @return the same object if nothing was typed
     */
    AxisState draw(Ui ui, int axis, AxisState old) {
        int present = old.isLocked() ? LOCKED : old.isLimited() ? LIMITED : 0;
        int state = ui.choice(STATE[axis], STATES, present);
        if (state != present) {
            double most = isAngle(axis) ? ANGLE : WAY;
            boolean isLimited = state == LIMITED;
            return state == LOCKED
                    ? LOCK
                    : limited(old, isLimited, isLimited ? -most : 0, isLimited ? most : 0);
        }
        if (old.isLocked()) {
            return old;
        }
        if (old.isLimited()) {
            double lower = number(ui, axis, LOWER[axis], old.lower());
            double upper = number(ui, axis, UPPER[axis], old.upper());
            if (lower != old.lower() || upper != old.upper()) {
                return limited(old, true, lower, upper);
            }
        }
        ui.label(isAngle(axis) ? UNITS : WAYS);
        AxisState driven = motor(ui, axis, old);
        return driven.equals(old) ? spring(ui, axis, old) : driven;
    }

    private static AxisState limited(AxisState s, boolean is, double lower, double upper) {
        return new AxisState(
                false,
                is,
                lower,
                upper,
                s.isDriven(),
                s.speed(),
                s.motorMost(),
                s.isSprung(),
                s.target(),
                s.stiffness(),
                s.damping(),
                s.isAbsolute(),
                s.springMost());
    }

    private AxisState motor(Ui ui, int axis, AxisState s) {
        boolean has = ui.checkbox(MOTOR[axis], s.isDriven());
        if (has != s.isDriven()) {
            return driven(s, has, 0, has ? Double.POSITIVE_INFINITY : 0);
        }
        if (!has) {
            return s;
        }
        double speed = number(ui, axis, SPEED[axis], s.speed());
        double most = most(ui, fields, MOTOR_MOST[axis], s.motorMost());
        return speed == s.speed() && most == s.motorMost() ? s : driven(s, true, speed, most);
    }

    private static AxisState driven(AxisState s, boolean is, double speed, double most) {
        return new AxisState(
                false,
                s.isLimited(),
                s.lower(),
                s.upper(),
                is,
                speed,
                most,
                s.isSprung(),
                s.target(),
                s.stiffness(),
                s.damping(),
                s.isAbsolute(),
                s.springMost());
    }

    private AxisState spring(Ui ui, int axis, AxisState s) {
        boolean has = ui.checkbox(SPRING[axis], s.isSprung());
        if (has != s.isSprung()) {
            return has
                    ? sprung(s, true, 0, 1, 1, false, Double.POSITIVE_INFINITY)
                    : sprung(s, false, 0, 0, 0, false, 0);
        }
        if (!has) {
            return s;
        }
        double target = number(ui, axis, TARGET[axis], s.target());
        boolean absolute = ui.choice(BY[axis], SPRINGS, s.isAbsolute() ? 1 : 0) == 1;
        if (absolute != s.isAbsolute()) {
            return sprung(s, true, target, absolute ? 1000 : 1, 1, absolute, s.springMost());
        }
        double k = fields.number(ui, (absolute ? STIFFNESS : HERTZ)[axis], s.stiffness());
        double d = fields.number(ui, (absolute ? DAMPING : RATIO)[axis], s.damping());
        double most = most(ui, fields, SPRING_MOST[axis], s.springMost());
        boolean same =
                target == s.target()
                        && k == s.stiffness()
                        && d == s.damping()
                        && most == s.springMost();
        return same ? s : sprung(s, true, target, k, d, absolute, most);
    }

    private static AxisState sprung(
            AxisState s,
            boolean is,
            double target,
            double k,
            double d,
            boolean absolute,
            double most) {
        return new AxisState(
                false,
                s.isLimited(),
                s.lower(),
                s.upper(),
                s.isDriven(),
                s.speed(),
                s.motorMost(),
                is,
                target,
                k,
                d,
                absolute,
                most);
    }
}
