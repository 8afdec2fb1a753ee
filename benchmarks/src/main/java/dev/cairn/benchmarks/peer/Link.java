package dev.cairn.benchmarks.peer;

import static java.util.Objects.requireNonNull;

import dev.cairn.physics.joint.AxisState;
import dev.cairn.physics.joint.JointAxis;
import dev.cairn.physics.joint.JointRef;

import org.joml.Quaterniond;
import org.joml.Quaterniondc;
import org.joml.Vector3d;
import org.joml.Vector3dc;

import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * A joint as plain data: of a kind that most engines have, without limits, motors and springs. The
 * two bodies do not collide.
 *
 * @param kind what it leaves free
 * @param a index of the first body
 * @param b index of the second body
 * @param anchorA where it is on A, from the centre of mass, axes of the body, m
 * @param anchorB where it is on B, likewise
 * @param frameA how its axes are turned, bodyFromJoint; a hinge turns about x
 * @param frameB the same in B
 * @param length of a rod, m; below 0 for the other kinds
 */
public record Link(
        Kind kind,
        int a,
        int b,
        Vector3dc anchorA,
        Vector3dc anchorB,
        Quaterniondc frameA,
        Quaterniondc frameB,
        double length) {

    /** What two bodies may still do. */
    public enum Kind {
        /** They share a point. */
        BALL,
        /** They share a point and an axis. */
        HINGE,
        /** Two points keep their distance. */
        ROD
    }

    /**
     * Reads a joint of the world that the scene's script built, before the first tick.
     *
     * @param joint what to read
     * @param indexOf index of a body by its entity
     * @param bodies as the other engines are given them
     * @throws IllegalArgumentException if it is more than the other engines are given
     */
    static Link of(
            JointRef joint, Map<Long, Integer> indexOf, List<SceneDescription.Solid> bodies) {
        boolean isPlain =
                !joint.collides() && List.of("ball", "hinge", "rod").contains(joint.kind());
        for (JointAxis axis : JointAxis.values()) {
            if (axis != JointAxis.PATH) {
                AxisState state = joint.settings(axis);
                isPlain &= !state.isLimited() && !state.isDriven() && !state.isSprung();
            }
        }
        if (!isPlain) {
            throw new IllegalArgumentException(
                    joint
                            + ": other engines are given balls, hinges and rods without limits,"
                            + " motors and springs, whose bodies do not collide");
        }
        int a = requireNonNull(indexOf.get(joint.entityA()), "body A");
        int b = requireNonNull(indexOf.get(joint.entityB()), "body B");
        return new Link(
                Kind.valueOf(joint.kind().toUpperCase(Locale.ROOT)),
                a,
                b,
                anchor(bodies.get(a), joint.anchorA(new Vector3d())),
                anchor(bodies.get(b), joint.anchorB(new Vector3d())),
                frame(bodies.get(a), joint.frameA(new Quaterniond())),
                frame(bodies.get(b), joint.frameB(new Quaterniond())),
                joint.length());
    }

    private static Vector3d anchor(SceneDescription.Solid body, Vector3d world) {
        return body.rotation().transformInverse(world.sub(body.centre()));
    }

    private static Quaterniond frame(SceneDescription.Solid body, Quaterniond world) {
        return world.premul(body.rotation().conjugate(new Quaterniond()));
    }

    /** The point on A at the start, world, m. */
    Vector3d startA(SceneDescription scene) {
        return start(scene.bodies().get(a), anchorA);
    }

    /** The point on B at the start, world, m. */
    Vector3d startB(SceneDescription scene) {
        return start(scene.bodies().get(b), anchorB);
    }

    private static Vector3d start(SceneDescription.Solid body, Vector3dc anchor) {
        return body.rotation().transform(anchor, new Vector3d()).add(body.centre());
    }

    /** The x axis at the start, world. */
    Vector3d startAxis(SceneDescription scene) {
        return scene.bodies().get(a).rotation().transform(axisA());
    }

    /** The x axis, in A. */
    Vector3d axisA() {
        return frameA.transform(new Vector3d(1, 0, 0));
    }

    /** The x axis, in B. */
    Vector3d axisB() {
        return frameB.transform(new Vector3d(1, 0, 0));
    }

    /** The y axis, in A. */
    Vector3d normalA() {
        return frameA.transform(new Vector3d(0, 1, 0));
    }

    /** The y axis, in B. */
    Vector3d normalB() {
        return frameB.transform(new Vector3d(0, 1, 0));
    }
}
