package dev.cairn.samples;

import dev.cairn.physics.BodyRef;

import org.joml.Matrix3d;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

/**
 * Pulls a body by a spring between a point of it and a point in space. Simulation thread.
 *
 * <p>The spring is chosen by how the point answers, not by the mass of the body: with the point's
 * effective mass M = (1/m - [r] I⁻¹ [r])⁻¹, the force M (w² d - 2 w v) + weight is a critically
 * damped spring of angular frequency w whatever is pulled, and w h = 0.25 at 60 ticks a second is
 * well within what a force that is constant over a tick can hold (w h &lt; 1).
 */
final class Hand {
    private static final double FREQUENCY = 15;

    /** Part of the spin that is taken away, 1/s, so that what hangs from the hand calms down. */
    private static final double SPIN_DAMPING = 2;

    /** The strongest pull, in weights. */
    private static final double MOST_WEIGHTS = 100;

    private static final double NEAREST = 0.5;

    private @Nullable BodyRef body;
    private @Nullable BodyRef named;
    private String name = "";
    private boolean pulling;
    private double distance;
    private final Vector3d local = new Vector3d();
    private final Vector3d target = new Vector3d();
    private final Vector3d point = new Vector3d();
    private final Vector3d arm = new Vector3d();
    private final Vector3d velocity = new Vector3d();
    private final Vector3d spin = new Vector3d();
    private final Vector3d force = new Vector3d();
    private final Quaterniond turn = new Quaterniond();
    private final Matrix3d inverseInertia = new Matrix3d();
    private final Matrix3d cross = new Matrix3d();
    private final Matrix3d answer = new Matrix3d();

    void grab(BodyRef what, double atDistance, Vector3d localPoint) {
        body = what;
        local.set(localPoint);
        distance = atDistance;
        pulling = !what.isFixed();
        place();
        target.set(point);
    }

    void release() {
        pulling = false;
        if (body != null && !body.isAlive()) {
            body = null;
        }
    }

    void scroll(double steps) {
        distance = Math.max(NEAREST, distance * Math.pow(1.1, steps));
    }

    void aim(Vector3d eye, Vector3d direction) {
        target.set(direction).mul(distance).add(eye);
    }

    /** Finds the point that is held, in world coordinates. */
    private void place() {
        BodyRef held = body;
        if (held != null) {
            held.orientation(turn).transform(local, point);
            point.add(held.position(arm));
        }
    }

    /** Applies the force of one tick. */
    void apply() {
        BodyRef held = body;
        if (held == null || !pulling) {
            return;
        }
        if (!held.isAlive() || held.isFixed()) {
            body = null;
            pulling = false;
            return;
        }
        place();
        held.centreOfMass(arm).sub(point).negate();
        held.angularVelocity(spin).cross(arm, velocity);
        velocity.add(held.velocity(force));
        double mass = held.mass();
        held.inverseInertia(inverseInertia);
        // K = 1/m - [r] I⁻¹ [r]
        skew(arm, cross);
        answer.set(cross).mul(inverseInertia).mul(cross).scale(-1);
        answer.m00 += 1 / mass;
        answer.m11 += 1 / mass;
        answer.m22 += 1 / mass;
        answer.invert();
        force.set(target).sub(point).mul(FREQUENCY * FREQUENCY);
        force.fma(-2 * FREQUENCY, velocity);
        answer.transform(force);
        force.y += mass * SampleScene.GRAVITY;
        double most = MOST_WEIGHTS * mass * SampleScene.GRAVITY;
        if (force.length() > most) {
            force.normalize(most);
        }
        held.applyForceAt(force.x, force.y, force.z, point.x, point.y, point.z);
        inverseInertia.invert().transform(spin).mul(-SPIN_DAMPING);
        held.applyTorque(spin.x, spin.y, spin.z);
    }

    /** The matrix of r x. */
    private static void skew(Vector3d r, Matrix3d dest) {
        // JOML's constructor order is by columns.
        dest.set(0, r.z, -r.y, -r.z, 0, r.x, r.y, -r.x, 0);
    }

    void describe(SandboxState state) {
        BodyRef held = body;
        if (held == null || !held.isAlive()) {
            state.held = "";
            state.pulling = false;
            return;
        }
        if (held != named) {
            named = held;
            String own = held.name();
            name = own.isEmpty() ? "body " + held.entity() : own;
        }
        state.held = name;
        state.heldIsFixed = held.isFixed();
        state.heldMass = held.isFixed() ? Double.POSITIVE_INFINITY : held.mass();
        state.heldSpeed = held.velocity(velocity).length();
        held.position(state.heldAt);
        state.pulling = pulling;
        place();
        state.pullFrom.set(point);
        state.pullTo.set(target);
    }
}
