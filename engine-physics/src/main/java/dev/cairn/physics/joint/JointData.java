package dev.cairn.physics.joint;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.Curve;
import dev.cairn.physics.internal.JointStore;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

/**
 * What can be drawn of a world's joints, copied so that another thread may look at it. World frame,
 * SI units. {@link Joints#capture} fills it, as {@code PhysicsWorld.capture} does.
 *
 * <p>One thread at a time; the arrays belong to the object and are at least as long as the count
 * says.
 */
public final class JointData {
    /** Numbers to a joint in {@link #points}. */
    public static final int POINTS = 12;

    /** Numbers to a joint in {@link #axes}. */
    public static final int AXES = 12;

    /** Numbers to a joint in {@link #loads}. */
    public static final int LOADS = 6;

    /** Numbers to a joint in {@link #limits}. */
    public static final int LIMITS = 3;

    private int count;
    private double[] points = {};
    private double[] axes = {};
    private double[] loads = {};
    private double[] limits = {};
    private @Nullable JointAxis[] limited = {};
    private boolean[] enabled = {};
    private @Nullable Curve[] curves = {};
    private final double[] room = new double[Curve.AT];
    private final Vector3d point = new Vector3d();
    private final Quaterniond turn = new Quaterniond();

    /** No joints. */
    public JointData() {}

    void fill(Joints joints, JointRef[] refs) {
        JointStore s = joints.store;
        if (enabled.length < s.count) {
            int n = s.count + (s.count >> 1);
            points = new double[POINTS * n];
            axes = new double[AXES * n];
            loads = new double[LOADS * n];
            limits = new double[LIMITS * n];
            limited = new @Nullable JointAxis[n];
            enabled = new boolean[n];
            curves = new @Nullable Curve[n];
        }
        count = 0;
        for (int j = 0; j < s.count; j++) {
            if (joints.isThere(j)) {
                fill(joints, refs[j], j);
                count++;
            }
        }
    }

    private void fill(Joints joints, JointRef ref, int j) {
        JointStore s = joints.store;
        int at = POINTS * count;
        centre(joints.bodies, s.bodyA[j], at);
        write(points, at + 3, joints.frames.point(joints, j, true, point));
        write(points, at + 6, joints.frames.point(joints, j, false, point));
        centre(joints.bodies, s.bodyB[j], at + 9);
        at = AXES * count;
        for (int side = 0; side < 2; side++) {
            joints.frames.turn(joints, j, side == 0, turn);
            write(axes, at + 6 * side, turn.transform(point.set(1, 0, 0)));
            write(axes, at + 6 * side + 3, turn.transform(point.set(0, 1, 0)));
        }
        System.arraycopy(s.reaction, 6 * j, loads, LOADS * count, LOADS);
        enabled[count] = s.isEnabled[j];
        curves[count] = s.curve[j];
        limited[count] = null;
        for (JointAxis axis : JointAxis.ALL) {
            AxisSettings a = ref.axes[axis.index];
            if (a.isLimited) {
                limited[count] = axis;
                limits[LIMITS * count] = a.lower;
                limits[LIMITS * count + 1] = a.upper;
                limits[LIMITS * count + 2] = joints.values.of(joints, j, axis);
                break;
            }
        }
    }

    private void centre(BodyStore b, int slot, int at) {
        points[at] = b.positionX[slot];
        points[at + 1] = b.positionY[slot];
        points[at + 2] = b.positionZ[slot];
    }

    private static void write(double[] into, int at, Vector3d v) {
        into[at] = v.x;
        into[at + 1] = v.y;
        into[at + 2] = v.z;
    }

    /**
     * How many joints there are.
     *
     * @return the number, those that are off included
     */
    public int count() {
        return count;
    }

    /**
     * Where joints are.
     *
     * @return {@link #POINTS} to a joint: A's centre of mass, the joint's point on A, that on B,
     *     B's centre of mass; m
     */
    public double[] points() {
        return points;
    }

    /**
     * How joints are turned.
     *
     * @return {@link #AXES} to a joint: x and y axis of the frame in A, then in B
     */
    public double[] axes() {
        return axes;
    }

    /**
     * What joints bear.
     *
     * @return {@link #LOADS} to a joint: force on B in N, torque on B in N m
     */
    public double[] loads() {
        return loads;
    }

    /**
     * The first limit of each joint.
     *
     * @return {@link #LIMITS} to a joint: lower, upper, and where it stands; m or rad
     */
    public double[] limits() {
        return limits;
    }

    /**
     * Which axis {@link #limits} is about.
     *
     * @param joint 0 to count - 1
     * @return the axis, or null of a joint without limits
     */
    public @Nullable JointAxis limited(int joint) {
        return limited[joint];
    }

    /**
     * The curve of a path, as points that are the same parameter apart.
     *
     * @param joint 0 to count - 1
     * @param into receives x, y, z of as many points as it has room for, world, m
     * @return whether the joint is a path
     */
    public boolean path(int joint, double[] into) {
        Curve curve = curves[joint];
        if (curve == null) {
            return false;
        }
        int last = into.length / 3 - 1;
        int p = POINTS * joint + 3;
        int x = AXES * joint;
        for (int i = 0; i <= last; i++) {
            curve.at(curve.parameter((double) i / last), room);
            for (int k = 0; k < 3; k++) {
                int u = (k + 1) % 3;
                int w = (k + 2) % 3;
                double z = axes[x + u] * axes[x + 3 + w] - axes[x + w] * axes[x + 3 + u];
                into[3 * i + k] =
                        points[p + k]
                                + room[0] * axes[x + k]
                                + room[1] * axes[x + 3 + k]
                                + room[2] * z;
            }
        }
        return true;
    }

    /**
     * Which joints act.
     *
     * @return false for those that are off or broken
     */
    public boolean[] enabled() {
        return enabled;
    }
}
