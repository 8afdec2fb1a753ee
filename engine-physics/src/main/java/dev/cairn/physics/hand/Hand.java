package dev.cairn.physics.hand;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Collider;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.body.BodyType;
import dev.cairn.physics.internal.Checks;
import dev.cairn.physics.joint.Joint;
import dev.cairn.physics.joint.JointAxis;
import dev.cairn.physics.joint.JointRef;
import dev.cairn.physics.shape.Sphere;

import org.joml.Matrix3d;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;

/**
 * Takes a body at a point and pulls that point to where it is told, by a spring with a largest
 * force: what a mouse does with a body, or a gripper.
 *
 * <p>The spring is critically damped for the body's own mass m and bears its weight, so that a body
 * that hangs freely comes to rest at the target: {@code k = m w²}, {@code d = 2 m w}, drawn to
 * {@code target - g/w²}. What hangs on the body by joints makes it sag.
 *
 * <p>Simulation thread, between steps. {@link #grab} and {@link #release} allocate, {@link #pull}
 * does not. A hand that holds something has one small fixed sensor in the world.
 */
public final class Hand {
    /** Angular frequency of the spring, rad/s. */
    private static final double FREQUENCY = 15;

    /** Part of the spin that is taken away, 1/s, so that what hangs from the hand calms down. */
    private static final double SPIN_DAMPING = 5;

    /** The strongest pull, in weights of 9.81 m/s². */
    private static final double MOST_WEIGHTS = 100;

    private static final double WEIGHT = 9.81;

    private final PhysicsWorld world;
    private @Nullable BodyRef held;
    private @Nullable BodyRef anchor;
    private @Nullable JointRef joint;
    private final Vector3d local = new Vector3d();
    private final Vector3d gravity = new Vector3d();
    private final Vector3d spin = new Vector3d();
    private final Quaterniond turn = new Quaterniond();
    private final Matrix3d inertia = new Matrix3d();

    /**
     * An empty hand.
     *
     * @param world whose bodies it takes
     */
    public Hand(PhysicsWorld world) {
        this.world = Checks.notNull("world", world);
    }

    /**
     * Takes a body; what was held is let go.
     *
     * @param body a dynamic one
     * @param point of the body, world, m, finite; the hand is there at first
     * @throws IllegalArgumentException if the body is not dynamic
     * @throws IllegalStateException if the body is gone, or a step runs
     */
    public void grab(BodyRef body, Vector3dc point) {
        Checks.notNull("body", body);
        Checks.notNull("point", point);
        if (body.type() != BodyType.DYNAMIC) {
            throw new IllegalArgumentException(
                    body + " is " + body.type() + "; a hand moves dynamic bodies only");
        }
        release();
        BodyRef at =
                world.add(
                        Body.fixed()
                                .collider(Collider.of(Sphere.of(0.01)).sensor(true))
                                .at(point.x(), point.y(), point.z())
                                .name("hand"));
        double mass = body.mass();
        double k = mass * FREQUENCY * FREQUENCY;
        double d = 2 * mass * FREQUENCY;
        double most = MOST_WEIGHTS * mass * WEIGHT;
        joint =
                world.add(
                        Joint.pull(at, body, 1, 1, most)
                                .at(point.x(), point.y(), point.z())
                                .stiffness(JointAxis.X, 0, k, d)
                                .stiffness(JointAxis.Y, 0, k, d)
                                .stiffness(JointAxis.Z, 0, k, d)
                                .name("hand"));
        anchor = at;
        held = body;
        body.orientation(turn).conjugate();
        turn.transform(local.set(point).sub(body.position(spin)));
        pull(point.x(), point.y(), point.z());
    }

    /**
     * Pulls the point that is held; once before each tick. Nothing if the hand is empty.
     *
     * @param x where it shall be, world, m, finite
     * @param y same
     * @param z same
     */
    public void pull(double x, double y, double z) {
        JointRef spring = joint;
        BodyRef body = held;
        if (spring == null || body == null || !isHolding()) {
            return;
        }
        world.gravity(gravity).div(-FREQUENCY * FREQUENCY);
        spring.moveTo(x + gravity.x, y + gravity.y, z + gravity.z);
        body.angularVelocity(spin);
        body.inverseInertia(inertia).invert().transform(spin).mul(-SPIN_DAMPING);
        body.applyTorque(spin.x, spin.y, spin.z);
    }

    /**
     * Pulls the point that is held; once before each tick. Nothing if the hand is empty.
     *
     * @param point where it shall be, world, m, finite
     */
    public void pull(Vector3dc point) {
        pull(point.x(), point.y(), point.z());
    }

    /** Lets go. Nothing if the hand is empty, or the world is closed. */
    public void release() {
        BodyRef at = anchor;
        if (at != null && at.isAlive()) {
            at.remove();
        }
        anchor = null;
        joint = null;
        held = null;
    }

    /**
     * Whether there is something in the hand.
     *
     * @return false before it has taken something, and after that was let go, removed or fixed
     */
    public boolean isHolding() {
        JointRef spring = joint;
        BodyRef body = held;
        return spring != null
                && body != null
                && spring.isAlive()
                && body.type() == BodyType.DYNAMIC;
    }

    /**
     * What is held.
     *
     * @return the body, or null
     */
    public @Nullable BodyRef body() {
        return isHolding() ? held : null;
    }

    /**
     * Where the body is held.
     *
     * @param destination receives the point, world, m, now; unchanged if the hand is empty
     * @return destination
     */
    public Vector3d point(Vector3d destination) {
        BodyRef body = held;
        Checks.notNull("destination", destination);
        if (body != null && isHolding()) {
            body.orientation(turn).transform(local, destination).add(body.position(spin));
        }
        return destination;
    }

    /**
     * The force on the body, mean of the last sub-step.
     *
     * @param destination receives N, world; 0 if the hand is empty
     * @return destination
     */
    public Vector3d force(Vector3d destination) {
        JointRef spring = joint;
        Checks.notNull("destination", destination);
        return spring != null && isHolding() ? spring.force(destination) : destination.set(0, 0, 0);
    }
}
