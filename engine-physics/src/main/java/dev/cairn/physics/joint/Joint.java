package dev.cairn.physics.joint;

import dev.cairn.physics.internal.Checks;
import dev.cairn.physics.internal.Curve;
import dev.cairn.physics.internal.JointStore;

import org.joml.Vector3d;
import org.joml.Vector3dc;

import java.util.Arrays;

/**
 * Describes a joint: two bodies, a place, and what they may still do to each other. {@code
 * PhysicsWorld.add} makes it; the description may be used again.
 *
 * <pre>{@code
 * JointRef hinge = world.add(Joint.hinge(frame, door).at(0, 1, 0).axis(0, 1, 0).limits(0, 2));
 * }</pre>
 *
 * <p>Places and axes are in the world, in the poses that the bodies have when the joint is added;
 * all angles and ways are 0 then. Angles are those of B against A, right-handed. Methods return the
 * description itself, throw {@link IllegalArgumentException} for what is not a number or out of
 * range, and may be called in any order. One thread at a time.
 */
public final class Joint extends JointKinds {
    /** Beyond the axes of {@link JointAxis}: the cross of a universal joint. */
    static final int CROSS = JointAxis.values().length;

    final Jointed a;
    final Jointed b;

    /** What gears, racks and pulleys tie. */
    static final int GEAR = CROSS + 1;

    static final int RACK = CROSS + 2;
    static final int PULLEY = CROSS + 3;

    /** What keeps a point on a path. */
    static final int RAIL = CROSS + 4;

    /** How many settings a joint has: one to an axis, and these. */
    static final int AXES = CROSS + 5;

    final AxisSettings[] axes = new AxisSettings[AXES];

    /** What {@link #limits}, {@link #motor} and {@link #spring} without an axis are about. */
    final JointAxis main;

    final String kind;
    String name = "";
    boolean isPlaced;
    final double[] anchorA = new double[3];
    final double[] anchorB = new double[3];
    final double[] x = {1, 0, 0};
    final double[] y = new double[3];
    boolean hasSecond;
    boolean collides;

    /** Whether the springs along x, y and z have their largest force together. */
    boolean isRound;

    double breakForce = Double.POSITIVE_INFINITY;
    double breakTorque = Double.POSITIVE_INFINITY;

    /** See {@link JointRef#parameters}. */
    double[] parameters = new double[JointStore.PARAMETERS];

    /** Length of a rod, rope or spring; below 0 for that of the moment when it is added. */
    double length = -1;

    Joint(String kind, Jointed a, Jointed b, JointAxis main, JointAxis... locked) {
        this.kind = kind;
        this.a = Checks.notNull("a", a);
        this.b = Checks.notNull("b", b);
        this.main = main;
        for (int i = 0; i < axes.length; i++) {
            axes[i] = new AxisSettings();
        }
        for (JointAxis axis : locked) {
            of(axis).isLocked = true;
        }
    }

    AxisSettings of(JointAxis axis) {
        return axes[index(axis, kind)];
    }

    /** Where the settings of an axis are that a kind has; the way along a path is that of paths. */
    static int index(JointAxis axis, String kind) {
        if (Checks.notNull("axis", axis) == JointAxis.PATH && !kind.equals("path")) {
            throw new IllegalArgumentException(
                    "a "
                            + kind
                            + " joint has no axis PATH; that is the way along the curve of a"
                            + " Joint.path");
        }
        return axis.index;
    }

    boolean hasCurve() {
        return kind.equals("path");
    }

    /** The curve of a path, world. */
    Curve curve() {
        return new Curve(parameters[0] != 0, Arrays.copyOfRange(parameters, 1, parameters.length));
    }

    // Place ---------------------------------------------------------------------------------------

    /**
     * Puts the joint at a point that both bodies share.
     *
     * @param px world, m, finite
     * @param py world, m, finite
     * @param pz world, m, finite
     * @return this
     */
    public Joint at(double px, double py, double pz) {
        return anchors(px, py, pz, px, py, pz);
    }

    /**
     * Puts the joint at a point that both bodies share.
     *
     * @param point world, m, finite
     * @return this
     */
    public Joint at(Vector3dc point) {
        Checks.notNull("point", point);
        return at(point.x(), point.y(), point.z());
    }

    /**
     * Gives each body a point of its own.
     *
     * @param ax of A, world, m, finite
     * @param ay of A
     * @param az of A
     * @param bx of B, world, m, finite
     * @param by of B
     * @param bz of B
     * @return this
     */
    public Joint anchors(double ax, double ay, double az, double bx, double by, double bz) {
        set(anchorA, "anchor of A", ax, ay, az);
        set(anchorB, "anchor of B", bx, by, bz);
        isPlaced = true;
        return this;
    }

    /**
     * Gives each body a point of its own.
     *
     * @param a of A, world, m, finite
     * @param b of B, world, m, finite
     * @return this
     */
    public Joint anchors(Vector3dc a, Vector3dc b) {
        Checks.notNull("a", a);
        Checks.notNull("b", b);
        return anchors(a.x(), a.y(), a.z(), b.x(), b.y(), b.z());
    }

    /**
     * Chooses the x axis of the frames: that of a hinge or slider; (1, 0, 0) at first.
     *
     * @param ax world, any length but 0
     * @param ay world
     * @param az world
     * @return this
     */
    public Joint axis(double ax, double ay, double az) {
        direction(x, "axis", ax, ay, az);
        return this;
    }

    /**
     * Chooses the x axis of the frames.
     *
     * @param axis world, any length but 0
     * @return this
     */
    public Joint axis(Vector3dc axis) {
        Checks.notNull("axis", axis);
        return axis(axis.x(), axis.y(), axis.z());
    }

    /**
     * Chooses the y axis of the frames; what of it lies along {@link #axis} is left out. By default
     * some direction that is at right angles to that.
     *
     * @param ax world, any length but 0
     * @param ay world
     * @param az world
     * @return this
     */
    public Joint secondAxis(double ax, double ay, double az) {
        direction(y, "second axis", ax, ay, az);
        hasSecond = true;
        return this;
    }

    /**
     * Chooses the y axis of the frames.
     *
     * @param axis world, any length but 0
     * @return this
     */
    public Joint secondAxis(Vector3dc axis) {
        Checks.notNull("axis", axis);
        return secondAxis(axis.x(), axis.y(), axis.z());
    }

    static void set(double[] into, String name, double px, double py, double pz) {
        into[0] = Checks.finite(name + " x", px);
        into[1] = Checks.finite(name + " y", py);
        into[2] = Checks.finite(name + " z", pz);
    }

    private static void direction(double[] into, String name, double px, double py, double pz) {
        double length = Math.sqrt(px * px + py * py + pz * pz);
        // what is of length 1 but for rounding stays bit for bit
        length = Math.abs(length - 1) <= 0x1p-50 ? 1 : length;
        if (!(length > 0) || length == Double.POSITIVE_INFINITY) {
            throw new IllegalArgumentException(
                    name
                            + " is ("
                            + px
                            + ", "
                            + py
                            + ", "
                            + pz
                            + "); it must be finite and not of length 0");
        }
        set(into, name, px / length, py / length, pz / length);
    }

    // Axes ----------------------------------------------------------------------------------------

    /**
     * Lets an axis free, without limits, motor and spring.
     *
     * @param axis which one
     * @return this
     */
    public Joint free(JointAxis axis) {
        axes[Checks.notNull("axis", axis).index].free();
        return this;
    }

    /**
     * Locks an axis.
     *
     * @param axis which one
     * @return this
     */
    public Joint locked(JointAxis axis) {
        of(axis).free();
        of(axis).isLocked = true;
        return this;
    }

    /**
     * Limits the axis that the kind is about.
     *
     * @param lower rad or m, or minus infinity
     * @param upper rad or m, or infinity; not below lower
     * @return this
     */
    public Joint limits(double lower, double upper) {
        return limits(main, lower, upper);
    }

    /**
     * Limits an axis.
     *
     * @param axis which one
     * @param lower m, or rad from -pi to pi, or minus infinity
     * @param upper m, or rad from -pi to pi, or infinity; not below lower
     * @return this
     */
    public Joint limits(JointAxis axis, double lower, double upper) {
        of(axis).limit(axis.toString(), lower, upper, axis.isAngle ? Math.PI : Double.MAX_VALUE);
        return this;
    }

    /**
     * Drives the axis that the kind is about.
     *
     * @param speed m/s or rad/s, finite
     * @param most largest force or torque, N or N m, above 0; may be infinite
     * @return this
     */
    public Joint motor(double speed, double most) {
        return motor(main, speed, most);
    }

    /**
     * Drives an axis; with a speed of 0 it is a brake.
     *
     * @param axis which one
     * @param speed m/s or rad/s, finite
     * @param most largest force or torque, N or N m, above 0; may be infinite
     * @return this
     */
    public Joint motor(JointAxis axis, double speed, double most) {
        AxisSettings s = of(axis);
        s.isLocked = false;
        s.isDriven = true;
        s.speed = Checks.finite("speed", speed);
        s.motorMost = Checks.limit("most", most);
        return this;
    }

    /**
     * Draws the axis that the kind is about to a value, by a spring: a motor to a position.
     *
     * @param target m or rad, finite
     * @param hertz Hz, above 0
     * @param dampingRatio at least 0
     * @return this
     */
    public Joint spring(double target, double hertz, double dampingRatio) {
        return spring(main, target, hertz, dampingRatio);
    }

    /**
     * Draws an axis to a value by a spring that is given by the frequency with which the two bodies
     * alone would swing on it.
     *
     * @param axis which one
     * @param target m or rad, finite
     * @param hertz Hz, above 0
     * @param dampingRatio at least 0
     * @return this
     */
    public Joint spring(JointAxis axis, double target, double hertz, double dampingRatio) {
        return spring(
                axis,
                target,
                Checks.positive("hertz", hertz),
                Checks.atLeastZero("dampingRatio", dampingRatio),
                false);
    }

    /**
     * Draws an axis to a value by a spring that is given by its stiffness.
     *
     * @param axis which one
     * @param target m or rad, finite
     * @param stiffness N/m or N m/rad, at least 0
     * @param damping N s/m or N m s/rad, at least 0
     * @return this
     */
    public Joint stiffness(JointAxis axis, double target, double stiffness, double damping) {
        return spring(
                axis,
                target,
                Checks.atLeastZero("stiffness", stiffness),
                Checks.atLeastZero("damping", damping),
                true);
    }

    private Joint spring(JointAxis axis, double target, double k, double d, boolean absolute) {
        AxisSettings s = of(axis);
        s.springMost = s.isSprung ? s.springMost : Double.POSITIVE_INFINITY;
        s.isLocked = false;
        s.isSprung = true;
        s.target = Checks.finite("target", target);
        s.stiffness = k;
        s.damping = d;
        s.isAbsolute = absolute;
        return this;
    }

    /**
     * Bounds what the spring of an axis can do; after {@link #spring}.
     *
     * @param axis which one
     * @param most N or N m, above 0; may be infinite
     * @return this
     */
    public Joint springMost(JointAxis axis, double most) {
        of(axis).springMost = Checks.limit("most", most);
        return this;
    }

    /**
     * Sets the length of a rod, a rope or a spring; by default it is that of the moment in which
     * the joint is added.
     *
     * @param metres m, above 0
     * @return this
     */
    public Joint length(double metres) {
        length = Checks.positive("length", metres);
        return this;
    }

    // Other ---------------------------------------------------------------------------------------

    /**
     * Says whether the two bodies collide; by default they do not.
     *
     * @param value true if they do
     * @return this
     */
    public Joint collide(boolean value) {
        collides = value;
        return this;
    }

    /**
     * Lets the joint break under a load.
     *
     * @param newtons largest force, N, above 0; may be infinite
     * @param newtonMetres largest torque, N m, above 0; may be infinite
     * @return this
     */
    public Joint breakAt(double newtons, double newtonMetres) {
        breakForce = Checks.limit("newtons", newtons);
        breakTorque = Checks.limit("newtonMetres", newtonMetres);
        return this;
    }

    /**
     * Names the joint, for messages and tools.
     *
     * @param value any
     * @return this
     */
    public Joint name(String value) {
        name = Checks.notNull("name", value);
        return this;
    }

    /** Whether it is a rod, rope, spring or pulley, which may be without a place. */
    boolean isDistance() {
        return main == JointAxis.DISTANCE;
    }

    JointPlace place() {
        return new JointPlace(
                isPlaced ? new Vector3d(anchorA) : null,
                isPlaced ? new Vector3d(anchorB) : null,
                new Vector3d(x),
                hasSecond ? new Vector3d(y) : null);
    }

    /**
     * What the description says of an axis.
     *
     * @param axis which one
     * @return its settings; the length of rods, ropes and springs is not in them
     */
    public AxisState settings(JointAxis axis) {
        return axes[Checks.notNull("axis", axis).index].view();
    }

    AxisSettings[] copyAxes() {
        AxisSettings[] copy = new AxisSettings[axes.length];
        Arrays.setAll(copy, i -> axes[i].copy());
        return copy;
    }
}
