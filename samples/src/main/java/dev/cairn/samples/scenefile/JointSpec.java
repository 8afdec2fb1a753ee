package dev.cairn.samples.scenefile;

import dev.cairn.physics.joint.AxisState;
import dev.cairn.physics.joint.Joint;
import dev.cairn.physics.joint.JointAxis;
import dev.cairn.physics.joint.JointRef;
import dev.cairn.physics.joint.Jointed;

import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * A joint of a scene. World frame, metres, radians. Immutable.
 *
 * @param kind one of {@link #KINDS}
 * @param name for people; may be empty
 * @param a index of the first entity
 * @param b index of the second one
 * @param parameters of a gear the teeth of both; of a pulley its two points and its ratio; of a
 *     path 1 if it is closed, else 0, and x, y, z of its points; else empty
 * @param place where it is
 * @param axes what it does about axes, where that is not what the kind does
 * @param length of a rod, rope or spring, m; 0 for that of the poses
 * @param collides whether the two collide
 * @param breakForce N, may be infinite
 * @param breakTorque N m, may be infinite
 * @param isOn whether it acts
 */
public record JointSpec(
        String kind,
        String name,
        int a,
        int b,
        List<Double> parameters,
        Place place,
        List<Axis> axes,
        double length,
        boolean collides,
        double breakForce,
        double breakTorque,
        boolean isOn) {
    /** The kinds, as files name them. */
    public static final List<String> KINDS =
            List.of(
                    "ball",
                    "hinge",
                    "slider",
                    "cylindrical",
                    "fixed",
                    "universal",
                    "rod",
                    "rope",
                    "spring",
                    "wheel",
                    "parallel",
                    "pull",
                    "gear",
                    "rack",
                    "pulley",
                    "path",
                    "generic");

    /** Stand in for bodies where only a joint's own numbers matter. */
    private static final Jointed NOBODY = () -> 0;

    private static final Jointed SOMEBODY = () -> 1;

    /** Copies the lists. */
    public JointSpec {
        parameters = List.copyOf(parameters);
        axes = List.copyOf(axes);
    }

    /**
     * Where a joint is.
     *
     * @param anchorA point of the first entity, world, m, or null for its centre of mass
     * @param anchorB point of the second entity, null if the other is
     * @param axis x axis of the frames
     * @param secondAxis what their y axis is chosen by, or null
     */
    public record Place(
            @Nullable Xyz anchorA, @Nullable Xyz anchorB, Xyz axis, @Nullable Xyz secondAxis) {
        /** The centres of mass, and x. */
        public static final Place DEFAULT = new Place(null, null, new Xyz(1, 0, 0), null);
    }

    /**
     * What a joint does about an axis.
     *
     * @param axis which one
     * @param state what
     */
    public record Axis(JointAxis axis, AxisState state) {}

    /**
     * A joint as the editor places it: what its kind does, and nothing else.
     *
     * @param kind one of {@link #KINDS}
     * @param a index of the first entity
     * @param b index of the second one
     * @param parameters as many as the kind wants
     * @param place where it is
     * @return a description
     */
    public static JointSpec of(String kind, int a, int b, List<Double> parameters, Place place) {
        double never = Double.POSITIVE_INFINITY;
        return new JointSpec(
                kind, "", a, b, parameters, place, List.of(), 0, false, never, never, true);
    }

    /**
     * The same between other entities.
     *
     * @param newA index of the first one
     * @param newB index of the second one
     * @return a copy
     */
    public JointSpec between(int newA, int newB) {
        return new JointSpec(
                kind,
                name,
                newA,
                newB,
                parameters,
                place,
                axes,
                length,
                collides,
                breakForce,
                breakTorque,
                isOn);
    }

    /**
     * The same with another name.
     *
     * @param value for people
     * @return a copy
     */
    public JointSpec withName(String value) {
        return new JointSpec(
                kind,
                value,
                a,
                b,
                parameters,
                place,
                axes,
                length,
                collides,
                breakForce,
                breakTorque,
                isOn);
    }

    /**
     * The same elsewhere.
     *
     * @param value where
     * @return a copy
     */
    public JointSpec withPlace(Place value) {
        return new JointSpec(
                kind,
                name,
                a,
                b,
                parameters,
                value,
                axes,
                length,
                collides,
                breakForce,
                breakTorque,
                isOn);
    }

    /**
     * The same with other numbers of its kind.
     *
     * @param numbers as many as before
     * @param newLength of a rod, rope or spring, m; 0 for that of the poses
     * @return a copy
     */
    public JointSpec measuring(List<Double> numbers, double newLength) {
        return new JointSpec(
                kind,
                name,
                a,
                b,
                numbers,
                place,
                axes,
                newLength,
                collides,
                breakForce,
                breakTorque,
                isOn);
    }

    /**
     * The same with other ends of it: what it bears, whether it acts, and whether the two collide.
     *
     * @param newForce N, may be infinite
     * @param newTorque N m, may be infinite
     * @param acts whether it acts
     * @param together whether the two collide
     * @return a copy
     */
    public JointSpec bearing(double newForce, double newTorque, boolean acts, boolean together) {
        return new JointSpec(
                kind,
                name,
                a,
                b,
                parameters,
                place,
                axes,
                length,
                together,
                newForce,
                newTorque,
                acts);
    }

    /**
     * What it does about an axis, be it said or the kind's.
     *
     * @param axis which one
     * @return what is in force
     */
    public AxisState settings(JointAxis axis) {
        return joint(NOBODY, SOMEBODY).settings(axis);
    }

    /**
     * The same doing something else about an axis.
     *
     * @param axis which one
     * @param state what is to be in force
     * @return a copy that names the axis only where that is not what the kind does
     * @throws IllegalArgumentException if a number is out of range
     */
    public JointSpec withAxis(JointAxis axis, AxisState state) {
        Joint changed = joint(NOBODY, SOMEBODY);
        apply(changed, axis, state);
        Joint plain = start(kind, NOBODY, SOMEBODY, parameters);
        List<Axis> others = new ArrayList<>();
        for (JointAxis each : JointAxis.values()) {
            if (!changed.settings(each).equals(plain.settings(each))) {
                others.add(new Axis(each, changed.settings(each)));
            }
        }
        return new JointSpec(
                kind,
                name,
                a,
                b,
                parameters,
                place,
                others,
                length,
                collides,
                breakForce,
                breakTorque,
                isOn);
    }

    /**
     * Describes a joint as it was made.
     *
     * @param joint which one
     * @param a index of its first entity
     * @param b index of its second one
     * @param bodyA its first body
     * @param bodyB its second one
     * @return the description
     */
    static JointSpec of(JointRef joint, int a, int b, Jointed bodyA, Jointed bodyB) {
        List<Double> parameters =
                Arrays.stream(joint.parameters())
                        .limit(
                                joint.kind().equals("path")
                                        ? Integer.MAX_VALUE
                                        : parameters(joint.kind()))
                        .boxed()
                        .toList();
        Joint plain = start(joint.kind(), bodyA, bodyB, parameters);
        List<Axis> axes = new ArrayList<>();
        for (JointAxis axis : JointAxis.values()) {
            AxisState state = joint.settings(axis);
            if (axis == JointAxis.DISTANCE && joint.kind().equals("rope")) {
                continue;
            }
            if (axis == JointAxis.DISTANCE && joint.kind().equals("spring")) {
                state = spring(state, 0);
            }
            if (!state.equals(plain.settings(axis))) {
                axes.add(new Axis(axis, state));
            }
        }
        return new JointSpec(
                joint.kind(),
                joint.name(),
                a,
                b,
                parameters,
                new Place(
                        xyz(joint.madeAt().anchorA()),
                        xyz(joint.madeAt().anchorB()),
                        new Xyz(
                                joint.madeAt().axis().x,
                                joint.madeAt().axis().y,
                                joint.madeAt().axis().z),
                        xyz(joint.madeAt().secondAxis())),
                axes,
                Math.max(0, joint.length()),
                joint.collides(),
                joint.breakForce(),
                joint.breakTorque(),
                joint.isEnabled());
    }

    private static AxisState spring(AxisState s, double target) {
        return new AxisState(
                s.isLocked(),
                s.isLimited(),
                s.lower(),
                s.upper(),
                s.isDriven(),
                s.speed(),
                s.motorMost(),
                s.isSprung(),
                target,
                s.stiffness(),
                s.damping(),
                s.isAbsolute(),
                s.springMost());
    }

    private static @Nullable Xyz xyz(@Nullable Vector3d v) {
        return v == null ? null : new Xyz(v.x, v.y, v.z);
    }

    /** How many parameters a kind has, but for a path, whose number is its own. */
    static int parameters(String kind) {
        return kind.equals("gear") ? 2 : kind.equals("pulley") ? 7 : 0;
    }

    /** A joint of a kind, with nothing said about it. */
    private static Joint start(String kind, Jointed a, Jointed b, List<Double> p) {
        return switch (kind) {
            case "ball" -> Joint.ball(a, b);
            case "hinge" -> Joint.hinge(a, b);
            case "slider" -> Joint.slider(a, b);
            case "cylindrical" -> Joint.cylindrical(a, b);
            case "fixed" -> Joint.fixed(a, b);
            case "universal" -> Joint.universal(a, b);
            case "rod" -> Joint.rod(a, b);
            case "rope" -> Joint.rope(a, b);
            case "spring" -> Joint.spring(a, b, 1, 0);
            case "wheel" -> Joint.wheel(a, b, 1, 1);
            case "parallel" -> Joint.parallel(a, b);
            case "pull" -> Joint.pull(a, b, 1, 1, Double.POSITIVE_INFINITY);
            case "gear" -> Joint.gear(a, b, p.get(0).intValue(), p.get(1).intValue());
            case "rack" -> Joint.rack(a, b);
            case "pulley" ->
                    Joint.pulley(
                            a,
                            b,
                            new Vector3d(p.get(0), p.get(1), p.get(2)),
                            new Vector3d(p.get(3), p.get(4), p.get(5)),
                            p.get(6));
            case "path" ->
                    Joint.path(
                            a,
                            b,
                            p.get(0) != 0,
                            p.stream().skip(1).mapToDouble(Double::doubleValue).toArray());
            default -> Joint.generic(a, b);
        };
    }

    /**
     * A description for the engine.
     *
     * @param bodyA the first body
     * @param bodyB the second one
     * @return what to add to the world
     * @throws IllegalArgumentException if a number is out of range
     */
    public Joint joint(Jointed bodyA, Jointed bodyB) {
        Joint joint = start(kind, bodyA, bodyB, parameters).name(name).collide(collides);
        Xyz pa = place.anchorA();
        Xyz pb = place.anchorB();
        if (pa != null && pb != null) {
            joint.anchors(pa.x(), pa.y(), pa.z(), pb.x(), pb.y(), pb.z());
        }
        joint.axis(place.axis().x(), place.axis().y(), place.axis().z());
        Xyz second = place.secondAxis();
        if (second != null) {
            joint.secondAxis(second.x(), second.y(), second.z());
        }
        for (Axis axis : axes) {
            apply(joint, axis.axis(), axis.state());
        }
        if (length > 0) {
            joint.length(length);
        }
        return joint.breakAt(breakForce, breakTorque);
    }

    private static void apply(Joint joint, JointAxis axis, AxisState s) {
        if (s.isLocked()) {
            joint.locked(axis);
            return;
        }
        joint.free(axis);
        if (s.isLimited()) {
            joint.limits(axis, s.lower(), s.upper());
        }
        if (s.isDriven()) {
            joint.motor(axis, s.speed(), s.motorMost());
        }
        if (s.isSprung()) {
            if (s.isAbsolute()) {
                joint.stiffness(axis, s.target(), s.stiffness(), s.damping());
            } else {
                joint.spring(axis, s.target(), s.stiffness(), s.damping());
            }
            joint.springMost(axis, s.springMost());
        }
    }
}
