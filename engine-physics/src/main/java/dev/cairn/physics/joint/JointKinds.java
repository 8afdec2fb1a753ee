package dev.cairn.physics.joint;

import dev.cairn.physics.internal.Checks;
import dev.cairn.physics.internal.Curve;

import org.joml.Vector3dc;

/** The kinds of joints, each with what it locks: where the description of a joint begins. */
public abstract sealed class JointKinds permits Joint {
    JointKinds() {}

    /**
     * A ball in a socket: the two bodies share a point.
     *
     * @param a the first body
     * @param b the second one
     * @return a description; {@link Joint#limits} are those of the cone about {@link Joint#axis}
     */
    public static Joint ball(Jointed a, Jointed b) {
        return new Joint("ball", a, b, JointAxis.CONE, JointAxis.X, JointAxis.Y, JointAxis.Z);
    }

    /**
     * A hinge: B turns about one axis of A.
     *
     * @param a the first body
     * @param b the second one
     * @return a description; limits, motor and spring are about the angle
     */
    public static Joint hinge(Jointed a, Jointed b) {
        return new Joint(
                "hinge",
                a,
                b,
                JointAxis.TWIST,
                JointAxis.X,
                JointAxis.Y,
                JointAxis.Z,
                JointAxis.SWING_Y,
                JointAxis.SWING_Z);
    }

    /**
     * A slider: B moves along one axis of A and does not turn.
     *
     * @param a the first body
     * @param b the second one
     * @return a description; limits, motor and spring are about the way
     */
    public static Joint slider(Jointed a, Jointed b) {
        return new Joint(
                "slider",
                a,
                b,
                JointAxis.X,
                JointAxis.Y,
                JointAxis.Z,
                JointAxis.TWIST,
                JointAxis.SWING_Y,
                JointAxis.SWING_Z);
    }

    /**
     * A rod in a tube: B moves along one axis of A and turns about it.
     *
     * @param a the first body
     * @param b the second one
     * @return a description; limits, motor and spring are about the way
     */
    public static Joint cylindrical(Jointed a, Jointed b) {
        return new Joint(
                "cylindrical",
                a,
                b,
                JointAxis.X,
                JointAxis.Y,
                JointAxis.Z,
                JointAxis.SWING_Y,
                JointAxis.SWING_Z);
    }

    /**
     * The two bodies are as one.
     *
     * @param a the first body
     * @param b the second one
     * @return a description
     */
    public static Joint fixed(Jointed a, Jointed b) {
        return new Joint(
                "fixed",
                a,
                b,
                JointAxis.X,
                JointAxis.X,
                JointAxis.Y,
                JointAxis.Z,
                JointAxis.TWIST,
                JointAxis.SWING_Y,
                JointAxis.SWING_Z);
    }

    /**
     * A universal joint (Hooke, Cardan): an axis of A and one of B meet at a right angle, {@link
     * Joint#axis} and {@link Joint#secondAxis}.
     *
     * @param a the first body
     * @param b the second one
     * @return a description
     */
    public static Joint universal(Jointed a, Jointed b) {
        Joint j =
                new Joint("universal", a, b, JointAxis.CONE, JointAxis.X, JointAxis.Y, JointAxis.Z);
        j.axes[Joint.CROSS].isLocked = true;
        return j;
    }

    /**
     * A rod without mass: two points keep their distance.
     *
     * @param a the first body
     * @param b the second one
     * @return a description; the points are the centres of mass if none are given
     */
    public static Joint rod(Jointed a, Jointed b) {
        return new Joint("rod", a, b, JointAxis.DISTANCE, JointAxis.DISTANCE);
    }

    /**
     * A rope without mass: two points come no further apart.
     *
     * @param a the first body
     * @param b the second one
     * @return a description; the points are the centres of mass if none are given
     */
    public static Joint rope(Jointed a, Jointed b) {
        Joint j = new Joint("rope", a, b, JointAxis.DISTANCE);
        j.of(JointAxis.DISTANCE).isLimited = true;
        return j;
    }

    /**
     * A spring without mass between two points.
     *
     * @param a the first body
     * @param b the second one
     * @param hertz frequency with which the two would swing on it, Hz, above 0
     * @param dampingRatio 0 for none, 1 where it just does not swing any more
     * @return a description; the points are the centres of mass if none are given
     */
    public static Joint spring(Jointed a, Jointed b, double hertz, double dampingRatio) {
        Joint j = new Joint("spring", a, b, JointAxis.DISTANCE);
        return j.spring(JointAxis.DISTANCE, 0, hertz, dampingRatio);
    }

    /**
     * The wheel of a car: it turns about {@link Joint#axis}, is sprung along {@link
     * Joint#secondAxis}, and is steered about that.
     *
     * @param a the car
     * @param b the wheel
     * @param hertz of the suspension, Hz, above 0
     * @param dampingRatio of the suspension
     * @return a description; the motor is about the spin; {@link JointAxis#SWING_Y} steers
     */
    public static Joint wheel(Jointed a, Jointed b, double hertz, double dampingRatio) {
        Joint j =
                new Joint(
                        "wheel",
                        a,
                        b,
                        JointAxis.TWIST,
                        JointAxis.X,
                        JointAxis.Z,
                        JointAxis.SWING_Y,
                        JointAxis.SWING_Z);
        return j.spring(JointAxis.Y, 0, hertz, dampingRatio);
    }

    /**
     * Keeps an axis of B parallel to that of A, and leaves the rest alone.
     *
     * @param a the first body
     * @param b the second one
     * @return a description
     */
    public static Joint parallel(Jointed a, Jointed b) {
        return new Joint("parallel", a, b, JointAxis.TWIST, JointAxis.SWING_Y, JointAxis.SWING_Z);
    }

    /**
     * Draws a point of B to a point of A by a spring, as a hand does; {@link JointRef#moveTo} moves
     * the point.
     *
     * @param a mostly a fixed body
     * @param b what is drawn
     * @param hertz of the spring, Hz, above 0
     * @param dampingRatio of the spring
     * @param mostNewtons largest force, in whatever direction, N, above 0; may be infinite
     * @return a description
     */
    public static Joint pull(
            Jointed a, Jointed b, double hertz, double dampingRatio, double mostNewtons) {
        Joint j = new Joint("pull", a, b, JointAxis.X);
        j.isRound = true;
        for (JointAxis axis : new JointAxis[] {JointAxis.X, JointAxis.Y, JointAxis.Z}) {
            j.spring(axis, 0, hertz, dampingRatio);
            j.of(axis).springMost = Checks.limit("mostNewtons", mostNewtons);
        }
        return j;
    }

    /**
     * All axes are free, to be locked, limited, driven and sprung one by one. One that is left so
     * only keeps its two bodies from colliding.
     *
     * @param a the first body
     * @param b the second one
     * @return a description
     */
    public static Joint generic(Jointed a, Jointed b) {
        return new Joint("generic", a, b, JointAxis.X);
    }

    /**
     * Two gears in mesh, whose axes are parallel to {@link Joint#axis}. They are carried by joints
     * of their own, mostly hinges, at the two {@link Joint#anchors}; these may move, as in a
     * planetary gear. Teeth pass a force along the pitch circles.
     *
     * @param a the first gear
     * @param b the second one
     * @param teethA number of A's teeth; negative if they are inside of a ring
     * @param teethB number of B's teeth; not {@code -teethA}
     * @return a description; give it the two centres by {@link Joint#anchors}
     */
    public static Joint gear(Jointed a, Jointed b, int teethA, int teethB) {
        if (teethA == 0 || teethB == 0 || teethA + teethB == 0) {
            throw new IllegalArgumentException(
                    "gears have "
                            + teethA
                            + " and "
                            + teethB
                            + " teeth; neither may be 0, nor one the negative of the other");
        }
        return tied(new Joint("gear", a, b, JointAxis.TWIST), Joint.GEAR, teethA, teethB);
    }

    /**
     * A pinion that drives a rack, or the other way round. Each is carried by a joint of its own,
     * mostly a hinge with {@link Joint#axis} and a slider along {@link Joint#secondAxis}. The
     * pinion's radius is the distance of the two {@link Joint#anchors} at a right angle to both.
     *
     * @param pinion the gear, A
     * @param rack the rack, B
     * @return a description; give it the pinion's centre and a point of the rack by {@link
     *     Joint#anchors}
     */
    public static Joint rack(Jointed pinion, Jointed rack) {
        return tied(new Joint("rack", pinion, rack, JointAxis.TWIST), Joint.RACK);
    }

    /**
     * A rope that runs from A over two points of the world to B: {@code |A - over A| + ratio |B -
     * over B|} grows no further than it is when the joint is added.
     *
     * @param a hangs at one end
     * @param b hangs at the other end
     * @param overA where the rope leaves towards A, world, m, finite
     * @param overB where it leaves towards B, world, m, finite
     * @param ratio how much more the part at B counts, as in a tackle; above 0
     * @return a description; the points are the centres of mass if none are given
     */
    public static Joint pulley(
            Jointed a, Jointed b, Vector3dc overA, Vector3dc overB, double ratio) {
        Joint j = new Joint("pulley", a, b, JointAxis.DISTANCE);
        Joint.set(j.parameters, "overA", overA.x(), overA.y(), overA.z());
        double[] second = new double[3];
        Joint.set(second, "overB", overB.x(), overB.y(), overB.z());
        System.arraycopy(second, 0, j.parameters, 3, 3);
        j.parameters[6] = Checks.positive("ratio", ratio);
        j.axes[Joint.PULLEY].isLimited = true;
        return j;
    }

    /**
     * A path: a point of B slides on a curve that is fixed to A, as a bead on a wire, and B turns
     * as it likes. The curve is the smooth one through the points (a cubic spline); two points are
     * a straight wire. Its ends are limits, unless others are given.
     *
     * @param a carries the curve
     * @param b slides on it, by the point {@link Joint#at}, or its centre of mass if none is given;
     *     what is off the curve is drawn to the nearest point of it
     * @param closed whether the curve comes back to its first point
     * @param points x, y, z of each, world, with A where it is when the joint is added, m, finite;
     *     at least two, three of a closed one; neighbours apart
     * @return a description; limits, motor and spring are about the way along the curve, {@link
     *     JointAxis#PATH}
     */
    public static Joint path(Jointed a, Jointed b, boolean closed, double... points) {
        Curve curve = new Curve(closed, points);
        Joint j = new Joint("path", a, b, JointAxis.PATH);
        j.parameters = new double[1 + points.length];
        j.parameters[0] = closed ? 1 : 0;
        System.arraycopy(points, 0, j.parameters, 1, points.length);
        j.axes[Joint.RAIL].isLocked = true;
        if (!closed) {
            j.limits(0, curve.length());
        }
        return j;
    }

    private static Joint tied(Joint j, int to, double... values) {
        j.axes[to].isLocked = true;
        System.arraycopy(values, 0, j.parameters, 0, values.length);
        return j;
    }
}
