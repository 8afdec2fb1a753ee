package dev.cairn.physics.joint;

import dev.cairn.core.state.StateCodec;
import dev.cairn.core.state.StateInput;
import dev.cairn.core.state.StateOutput;
import dev.cairn.physics.internal.Checks;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;

import java.util.Arrays;

/**
 * A joint in a world. Read-outs are those of the last step.
 *
 * <p>Simulation thread, between steps. What only changes numbers of a motor, spring or limit that
 * the joint has does not allocate, so it may be called in every tick; it wakes the bodies if
 * anything is other than before. Every method but {@link #isAlive}, {@link #name}, {@link #kind},
 * {@link #entity}, those of the bodies' entities and {@link #toString} throws {@link
 * IllegalStateException} once the joint is gone: it was removed, or one of its bodies was.
 */
public final class JointRef {
    /** {@link #entity} of a joint that has none. */
    public static final long NO_ENTITY = 0;

    private final Joints joints;
    private final String name;
    private final String kind;
    private final long entityA;
    private final long entityB;
    private final long entity;
    private final JointAxis main;
    private double length;
    private final JointPlace place;
    final AxisSettings[] axes;

    /** See {@code JointStore.parameter}; the world completes them. */
    final double[] parameters;

    int index;
    int stamp;
    private final RowList rows = new RowList();

    JointRef(Joints joints, Joint joint, long entityA, long entityB, long entity) {
        this.joints = joints;
        name = joint.name;
        kind = joint.kind;
        this.entityA = entityA;
        this.entityB = entityB;
        this.entity = entity;
        main = joint.main;
        length = joint.length;
        place = joint.place();
        parameters = joint.parameters.clone();
        axes = joint.copyAxes();
    }

    /** What is not among the settings of the axes; a world makes a reference of its own of it. */
    static final StateCodec<JointRef> CODEC =
            StateCodec.of(
                    JointRef.class,
                    "joint",
                    (ref, out) -> {
                        out.writeString(ref.name);
                        out.writeString(ref.kind);
                        out.writeLong(ref.entityA);
                        out.writeLong(ref.entityB);
                        out.writeLong(ref.entity);
                        out.writeString(ref.main.name());
                        out.writeDouble(ref.length);
                        out.writeInt(ref.index);
                        out.writeInt(ref.stamp);
                        write(ref.place.anchorA(), out);
                        write(ref.place.anchorB(), out);
                        write(ref.place.axis(), out);
                        write(ref.place.secondAxis(), out);
                        out.writeDoubles(ref.parameters);
                    },
                    JointRef::new);

    private static void write(@Nullable Vector3d v, StateOutput out) {
        out.writeDoubles(v == null ? new double[0] : new double[] {v.x, v.y, v.z});
    }

    private static @Nullable Vector3d vector(StateInput in) {
        double[] v = in.readDoubles();
        return v.length == 0 ? null : new Vector3d(v[0], v[1], v[2]);
    }

    @SuppressWarnings("NullAway") // nobody sees it before a world has made its own of it
    private JointRef(StateInput in) {
        joints = null;
        name = in.readString();
        kind = in.readString();
        entityA = in.readLong();
        entityB = in.readLong();
        entity = in.readLong();
        main = JointAxis.valueOf(in.readString());
        length = in.readDouble();
        index = in.readInt();
        stamp = in.readInt();
        place = new JointPlace(vector(in), vector(in), vector(in), vector(in));
        parameters = in.readDoubles();
        axes = new AxisSettings[Joint.AXES];
        Arrays.setAll(axes, k -> new AxisSettings());
    }

    /** The same joint in another world. */
    JointRef(Joints joints, JointRef twin) {
        this.joints = joints;
        name = twin.name;
        kind = twin.kind;
        entityA = twin.entityA;
        entityB = twin.entityB;
        entity = twin.entity;
        main = twin.main;
        length = twin.length;
        place = twin.place;
        parameters = twin.parameters.clone();
        axes = new AxisSettings[twin.axes.length];
        for (int k = 0; k < axes.length; k++) {
            axes[k] = twin.axes[k].copy();
        }
        index = twin.index;
        stamp = twin.stamp;
    }

    boolean isOf(Joints owner) {
        return joints == owner;
    }

    /** Whether this is the same joint in another world. */
    boolean isTwin(JointRef other) {
        return index == other.index
                && stamp == other.stamp
                && entityA == other.entityA
                && entityB == other.entityB
                && entity == other.entity
                && kind.equals(other.kind)
                && name.equals(other.name);
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

    private int alive() {
        if (!isAlive()) {
            throw new IllegalStateException(
                    this
                            + " is no longer in its world; ask isAlive() before you use a joint"
                            + " that may be gone");
        }
        return index;
    }

    private int changed(String call) {
        joints.host.requireBetweenSteps(call);
        return alive();
    }

    /**
     * Whether the joint is still in its world; it may be off.
     *
     * @return false once it or one of its bodies was removed
     */
    public boolean isAlive() {
        return joints.store.stamp[index] == stamp && joints.isThere(index);
    }

    /**
     * The name that the description gave.
     *
     * @return the name, empty if none was given
     */
    public String name() {
        return name;
    }

    /**
     * What kind of joint the description was made as.
     *
     * @return for example "hinge"
     */
    public String kind() {
        return kind;
    }

    /**
     * Entity of the first body.
     *
     * @return its id; {@code PhysicsWorld.bodyOf} tells the body
     */
    public long entityA() {
        return entityA;
    }

    /**
     * Entity of the second body.
     *
     * @return its id
     */
    public long entityB() {
        return entityB;
    }

    /**
     * Entity of the joint itself, if it was made by {@link NewJoint}.
     *
     * @return its id, or {@link #NO_ENTITY} for a joint that {@code PhysicsWorld.add} made
     */
    public long entity() {
        return entity;
    }

    /**
     * Whether the joint acts.
     *
     * @return false while it is off, or after it broke
     */
    public boolean isEnabled() {
        return joints.store.isEnabled[alive()];
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
     * The force of the joint on B, mean of the last sub-step.
     *
     * @param destination receives N, world
     * @return destination
     */
    public Vector3d force(Vector3d destination) {
        int k = 6 * alive();
        double[] r = joints.store.reaction;
        return Checks.notNull("destination", destination).set(r[k], r[k + 1], r[k + 2]);
    }

    /**
     * The torque of the joint on B, beside that of {@link #force} at B's origin, mean of the last
     * sub-step.
     *
     * @param destination receives N m, world
     * @return destination
     */
    public Vector3d torque(Vector3d destination) {
        int k = 6 * alive() + 3;
        double[] r = joints.store.reaction;
        return Checks.notNull("destination", destination).set(r[k], r[k + 1], r[k + 2]);
    }

    /**
     * Where the joint stands about an axis.
     *
     * @param axis which one
     * @return m or rad, now
     */
    public double value(JointAxis axis) {
        Joint.index(axis, kind);
        return joints.values.of(joints, alive(), axis);
    }

    /**
     * How far the joint is from what it should be: the largest of what its locked axes lack, and of
     * what its limited ones are beyond their limits.
     *
     * @return m, an angle counting as that of 1 m
     */
    public double gap() {
        return joints.values.gap(joints, alive());
    }

    /**
     * Where the joint was put when it was made.
     *
     * @return the place
     */
    public JointPlace madeAt() {
        return place;
    }

    /**
     * What gears, racks and pulleys are made with.
     *
     * @return a copy: of a gear the teeth of A and of B; of a rack the pinion's radius, with a sign
     *     that tells its side; of a pulley the two points and the ratio; of a path 1 if it is
     *     closed, else 0, then x, y, z of its points as they were given; else zeros
     */
    public double[] parameters() {
        return parameters.clone();
    }

    /**
     * The length of a rod, rope, spring, or of a pulley's rope.
     *
     * @return m; below 0 for joints of other kinds
     */
    public double length() {
        return length;
    }

    /**
     * Where the joint is on A.
     *
     * @param destination receives the point, world, m, now
     * @return destination
     */
    public Vector3d anchorA(Vector3d destination) {
        return joints.frames.point(
                joints, alive(), true, Checks.notNull("destination", destination));
    }

    /**
     * Where the joint is on B.
     *
     * @param destination receives the point, world, m, now
     * @return destination
     */
    public Vector3d anchorB(Vector3d destination) {
        return joints.frames.point(
                joints, alive(), false, Checks.notNull("destination", destination));
    }

    /**
     * How the joint's frame in A is turned; its x axis is that of a hinge.
     *
     * @param destination receives the rotation, world from frame, now
     * @return destination
     */
    public Quaterniond frameA(Quaterniond destination) {
        return joints.frames.turn(
                joints, alive(), true, Checks.notNull("destination", destination));
    }

    /**
     * How the joint's frame in B is turned.
     *
     * @param destination receives the rotation, world from frame, now
     * @return destination
     */
    public Quaterniond frameB(Quaterniond destination) {
        return joints.frames.turn(
                joints, alive(), false, Checks.notNull("destination", destination));
    }

    /**
     * What the joint does about an axis.
     *
     * @param axis which one
     * @return the settings in force; allocates
     */
    public AxisState settings(JointAxis axis) {
        alive();
        return axes[Checks.notNull("axis", axis).index].view();
    }

    /**
     * Whether the two bodies collide.
     *
     * @return what {@link Joint#collide} said
     */
    public boolean collides() {
        return joints.store.collides[alive()];
    }

    /**
     * The force under which the joint breaks.
     *
     * @return N, infinite for none
     */
    public double breakForce() {
        return joints.store.breakForce[alive()];
    }

    /**
     * The torque under which the joint breaks.
     *
     * @return N m, infinite for none
     */
    public double breakTorque() {
        return joints.store.breakTorque[alive()];
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

    @Override
    public String toString() {
        return kind + " joint" + (name.isEmpty() ? " " + index : " '" + name + "'");
    }
}
