package dev.cairn.physics.joint;

import dev.cairn.core.state.StateInput;
import dev.cairn.core.state.StateOutput;
import dev.cairn.physics.internal.Checks;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

import java.util.Arrays;

/**
 * What a joint tells of itself: what it was made as, where it stands, what it bears. Read-outs are
 * those of the last step.
 *
 * <p>Simulation thread, between steps.
 */
public abstract sealed class JointReadings permits JointRef {
    final Joints joints;
    final String name;
    final String kind;
    final long entityA;
    final long entityB;
    final long entity;
    final JointAxis main;
    double length;
    final JointPlace place;
    final AxisSettings[] axes;

    /** See {@code JointStore.parameter}; the world completes them. */
    final double[] parameters;

    int index;
    int stamp;

    JointReadings(Joints joints, Joint joint, long entityA, long entityB, long entity) {
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

    @SuppressWarnings("NullAway") // nobody sees it before a world has made its own of it
    JointReadings(StateInput in) {
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
    JointReadings(Joints joints, JointReadings twin) {
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

    /** Writes what is not among the settings of the axes. */
    final void write(StateOutput out) {
        out.writeString(name);
        out.writeString(kind);
        out.writeLong(entityA);
        out.writeLong(entityB);
        out.writeLong(entity);
        out.writeString(main.name());
        out.writeDouble(length);
        out.writeInt(index);
        out.writeInt(stamp);
        write(place.anchorA(), out);
        write(place.anchorB(), out);
        write(place.axis(), out);
        write(place.secondAxis(), out);
        out.writeDoubles(parameters);
    }

    private static void write(@Nullable Vector3d v, StateOutput out) {
        out.writeDoubles(v == null ? new double[0] : new double[] {v.x, v.y, v.z});
    }

    private static @Nullable Vector3d vector(StateInput in) {
        double[] v = in.readDoubles();
        return v.length == 0 ? null : new Vector3d(v[0], v[1], v[2]);
    }

    final boolean isOf(Joints owner) {
        return joints == owner;
    }

    /** Whether this is the same joint in another world. */
    final boolean isTwin(JointReadings other) {
        return index == other.index
                && stamp == other.stamp
                && entityA == other.entityA
                && entityB == other.entityB
                && entity == other.entity
                && kind.equals(other.kind)
                && name.equals(other.name);
    }

    final int alive() {
        if (!isAlive()) {
            throw new IllegalStateException(
                    this
                            + " is no longer in its world; ask isAlive() before you use a joint"
                            + " that may be gone");
        }
        return index;
    }

    /**
     * Whether the joint is still in its world; it may be off.
     *
     * @return false once it or one of its bodies was removed
     */
    public final boolean isAlive() {
        return joints.store.stamp[index] == stamp && joints.isThere(index);
    }

    /**
     * The name that the description gave.
     *
     * @return the name, empty if none was given
     */
    public final String name() {
        return name;
    }

    /**
     * What kind of joint the description was made as.
     *
     * @return for example "hinge"
     */
    public final String kind() {
        return kind;
    }

    /**
     * Entity of the first body.
     *
     * @return its id; {@code PhysicsWorld.bodyOf} tells the body
     */
    public final long entityA() {
        return entityA;
    }

    /**
     * Entity of the second body.
     *
     * @return its id
     */
    public final long entityB() {
        return entityB;
    }

    /**
     * Entity of the joint itself, if it was made by {@link NewJoint}.
     *
     * @return its id, or {@link JointRef#NO_ENTITY} for a joint that {@code PhysicsWorld.add} made
     */
    public final long entity() {
        return entity;
    }

    /**
     * Whether the joint acts.
     *
     * @return false while it is off, or after it broke
     */
    public final boolean isEnabled() {
        return joints.store.isEnabled[alive()];
    }

    /**
     * The force of the joint on B, mean of the last sub-step.
     *
     * @param destination receives N, world
     * @return destination
     */
    public final Vector3d force(Vector3d destination) {
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
    public final Vector3d torque(Vector3d destination) {
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
    public final double value(JointAxis axis) {
        Joint.index(axis, kind);
        return joints.values.of(joints, alive(), axis);
    }

    /**
     * How far the joint is from what it should be: the largest of what its locked axes lack, and of
     * what its limited ones are beyond their limits.
     *
     * @return m, an angle counting as that of 1 m
     */
    public final double gap() {
        return joints.values.gap(joints, alive());
    }

    /**
     * Where the joint was put when it was made.
     *
     * @return the place
     */
    public final JointPlace madeAt() {
        return place;
    }

    /**
     * What gears, racks and pulleys are made with.
     *
     * @return a copy: of a gear the teeth of A and of B; of a rack the pinion's radius, with a sign
     *     that tells its side; of a pulley the two points and the ratio; of a path 1 if it is
     *     closed, else 0, then x, y, z of its points as they were given; else zeros
     */
    public final double[] parameters() {
        return parameters.clone();
    }

    /**
     * The length of a rod, rope, spring, or of a pulley's rope.
     *
     * @return m; below 0 for joints of other kinds
     */
    public final double length() {
        return length;
    }

    /**
     * Where the joint is on A.
     *
     * @param destination receives the point, world, m, now
     * @return destination
     */
    public final Vector3d anchorA(Vector3d destination) {
        return joints.frames.point(
                joints, alive(), true, Checks.notNull("destination", destination));
    }

    /**
     * Where the joint is on B.
     *
     * @param destination receives the point, world, m, now
     * @return destination
     */
    public final Vector3d anchorB(Vector3d destination) {
        return joints.frames.point(
                joints, alive(), false, Checks.notNull("destination", destination));
    }

    /**
     * How the joint's frame in A is turned; its x axis is that of a hinge.
     *
     * @param destination receives the rotation, world from frame, now
     * @return destination
     */
    public final Quaterniond frameA(Quaterniond destination) {
        return joints.frames.turn(
                joints, alive(), true, Checks.notNull("destination", destination));
    }

    /**
     * How the joint's frame in B is turned.
     *
     * @param destination receives the rotation, world from frame, now
     * @return destination
     */
    public final Quaterniond frameB(Quaterniond destination) {
        return joints.frames.turn(
                joints, alive(), false, Checks.notNull("destination", destination));
    }

    /**
     * What the joint does about an axis.
     *
     * @param axis which one
     * @return the settings in force; allocates
     */
    public final AxisState settings(JointAxis axis) {
        alive();
        return axes[Checks.notNull("axis", axis).index].view();
    }

    /**
     * Whether the two bodies collide.
     *
     * @return what {@link Joint#collide} said
     */
    public final boolean collides() {
        return joints.store.collides[alive()];
    }

    /**
     * The force under which the joint breaks.
     *
     * @return N, infinite for none
     */
    public final double breakForce() {
        return joints.store.breakForce[alive()];
    }

    /**
     * The torque under which the joint breaks.
     *
     * @return N m, infinite for none
     */
    public final double breakTorque() {
        return joints.store.breakTorque[alive()];
    }

    @Override
    public final String toString() {
        return kind + " joint" + (name.isEmpty() ? " " + index : " '" + name + "'");
    }
}
