package dev.cairn.physics.joint;

import dev.cairn.core.state.StateCodec;
import dev.cairn.core.state.StateInput;
import dev.cairn.physics.internal.Checks;

import org.joml.Vector3dc;

/**
 * A joint in a world. Read-outs are those of the last step.
 *
 * <p>Simulation thread, between steps. What only changes numbers of a motor, spring or limit that
 * the joint has does not allocate, so it may be called in every tick; it wakes the bodies if
 * anything is other than before. Every method but {@link #isAlive}, {@link #name}, {@link #kind},
 * {@link #entity}, those of the bodies' entities and {@link #toString} throws {@link
 * IllegalStateException} once the joint is gone: it was removed, or one of its bodies was.
 */
public final class JointRef extends JointReadings {
    /** {@link #entity} of a joint that has none. */
    public static final long NO_ENTITY = 0;

    /** What is not among the settings of the axes; a world makes a reference of its own of it. */
    static final StateCodec<JointRef> CODEC =
            StateCodec.of(JointRef.class, "joint", JointReadings::write, JointRef::new);

    private final RowList rows = new RowList();

    JointRef(Joints joints, Joint joint, long entityA, long entityB, long entity) {
        super(joints, joint, entityA, entityB, entity);
    }

    private JointRef(StateInput in) {
        super(in);
    }

    /** The same joint in another world. */
    JointRef(Joints joints, JointRef twin) {
        super(joints, twin);
    }

    /** The length of a rod, rope or spring is known. */
    void resolveLength(double distance) {
        if (main != JointAxis.DISTANCE) {
            return;
        }
        double wanted = length > 0 ? length : distance;
        length = wanted;
        if (kind.equals("pulley")) {
            axes[Joint.PULLEY].lower = Double.NEGATIVE_INFINITY;
            axes[Joint.PULLEY].upper = wanted;
            return;
        }
        AxisSettings s = axes[main.index];
        if (s.isLocked && !(wanted > 0)) {
            throw new IllegalArgumentException(
                    "rod joint has the length 0; give two points apart, or use Joint.ball");
        }
        s.held = wanted;
        if (kind.equals("rope")) {
            s.lower = Double.NEGATIVE_INFINITY;
            s.upper = wanted;
        }
        s.target = s.isSprung ? wanted : s.target;
    }

    private int changed(String call) {
        joints.host.requireBetweenSteps(call);
        return alive();
    }

    /**
     * Switches the joint on or off.
     *
     * @param value true for on
     * @throws IllegalStateException while a step runs
     */
    public void setEnabled(boolean value) {
        int j = changed("setEnabled");
        if (joints.store.isEnabled[j] != value) {
            joints.store.isEnabled[j] = value;
            joints.store.clear(j);
            joints.store.revision++;
            joints.separate(j);
            joints.wake(j);
        }
    }

    /**
     * Takes the joint out of the world.
     *
     * @throws IllegalStateException while a step runs
     */
    public void remove() {
        joints.remove(changed("remove"));
    }

    /**
     * Moves the point of A.
     *
     * @param x world, m, finite
     * @param y world, m, finite
     * @param z world, m, finite
     * @throws IllegalStateException while a step runs
     */
    public void moveTo(double x, double y, double z) {
        int j = changed("moveTo");
        Checks.finite("x", x);
        Checks.finite("y", y);
        Checks.finite("z", z);
        joints.moveTo(j, x, y, z);
    }

    /**
     * Moves the point of A.
     *
     * @param point world, m, finite
     */
    public void moveTo(Vector3dc point) {
        moveTo(point.x(), point.y(), point.z());
    }

    // Retuning ------------------------------------------------------------------------------------

    private AxisSettings of(JointAxis axis) {
        return axes[Joint.index(axis, kind)];
    }

    private void retune(int j, boolean isOther) {
        if (!isOther) {
            return;
        }
        rows.compile(axes);
        if (!rows.fits(joints.store, j)) {
            joints.store.resize(j, rows.count);
        }
        rows.write(joints.store, j);
        joints.wake(j);
    }

    /**
     * Changes the motor of an axis, or gives it one.
     *
     * @param axis which one
     * @param speed m/s or rad/s, finite
     * @param most largest force or torque, N or N m, above 0; may be infinite
     * @throws IllegalStateException while a step runs
     */
    public void motor(JointAxis axis, double speed, double most) {
        int j = changed("motor");
        AxisSettings s = of(axis);
        Checks.finite("speed", speed);
        Checks.limit("most", most);
        boolean isOther = !s.isDriven || s.isLocked || s.speed != speed || s.motorMost != most;
        s.isLocked = false;
        s.isDriven = true;
        s.speed = speed;
        s.motorMost = most;
        retune(j, isOther);
    }

    /**
     * Takes the motor of an axis away.
     *
     * @param axis which one
     * @throws IllegalStateException while a step runs
     */
    public void motorOff(JointAxis axis) {
        int j = changed("motorOff");
        AxisSettings s = of(axis);
        boolean isOther = s.isDriven;
        s.isDriven = false;
        retune(j, isOther);
    }

    /**
     * Changes where the spring of an axis draws to.
     *
     * @param axis which one, with a spring
     * @param target m or rad, finite
     * @throws IllegalStateException while a step runs, or if the axis has no spring
     */
    public void target(JointAxis axis, double target) {
        int j = changed("target");
        AxisSettings s = of(axis);
        if (!s.isSprung) {
            throw new IllegalStateException(
                    "axis " + axis + " of " + this + " has no spring; call spring(..) first");
        }
        Checks.finite("target", target);
        boolean isOther = s.target != target;
        s.target = target;
        retune(j, isOther);
    }

    /**
     * Changes the spring of an axis, or gives it one.
     *
     * @param axis which one
     * @param target m or rad, finite
     * @param hertz Hz, above 0
     * @param dampingRatio at least 0
     * @throws IllegalStateException while a step runs
     */
    public void spring(JointAxis axis, double target, double hertz, double dampingRatio) {
        int j = changed("spring");
        AxisSettings s = of(axis);
        Checks.finite("target", target);
        Checks.positive("hertz", hertz);
        Checks.atLeastZero("dampingRatio", dampingRatio);
        s.springMost = s.isSprung ? s.springMost : Double.POSITIVE_INFINITY;
        s.isLocked = false;
        s.isSprung = true;
        s.isAbsolute = false;
        s.target = target;
        s.stiffness = hertz;
        s.damping = dampingRatio;
        retune(j, true);
    }

    /**
     * Changes the limits of an axis, or gives it some.
     *
     * @param axis which one
     * @param lower m, or rad from -pi to pi, or minus infinity
     * @param upper m, or rad from -pi to pi, or infinity; not below lower
     * @throws IllegalStateException while a step runs
     */
    public void limits(JointAxis axis, double lower, double upper) {
        int j = changed("limits");
        of(axis).limit(axis.toString(), lower, upper, axis.isAngle ? Math.PI : Double.MAX_VALUE);
        retune(j, true);
    }

    /**
     * Changes the load under which the joint breaks.
     *
     * @param newtons N, above 0; may be infinite
     * @param newtonMetres N m, above 0; may be infinite
     * @throws IllegalStateException while a step runs
     */
    public void breakAt(double newtons, double newtonMetres) {
        int j = changed("breakAt");
        Checks.limit("newtons", newtons);
        Checks.limit("newtonMetres", newtonMetres);
        boolean isOther =
                joints.store.breakForce[j] != newtons
                        || joints.store.breakTorque[j] != newtonMetres;
        joints.store.breakForce[j] = newtons;
        joints.store.breakTorque[j] = newtonMetres;
        if (isOther) {
            joints.wake(j); // it may be too little for what the joint bears
        }
    }
}
