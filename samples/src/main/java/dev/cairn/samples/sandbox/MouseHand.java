package dev.cairn.samples.sandbox;

import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.body.BodyType;
import dev.cairn.physics.hand.Hand;
import dev.cairn.samples.replay.Act.What;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

/**
 * What the mouse has taken in the window: the engine's {@link Hand}, which pulls towards a point at
 * a distance on the ray through the mouse. What cannot be pulled is only told about. Simulation
 * thread.
 */
final class MouseHand {
    private static final double NEAREST = 0.5;

    private final Diary diary;
    private @Nullable Hand hand;
    private @Nullable BodyRef body;
    private @Nullable BodyRef named;
    private String name = "";
    private double distance;
    private final Vector3d local = new Vector3d();
    private final Vector3d target = new Vector3d();
    private final Vector3d point = new Vector3d();
    private final Vector3d scratch = new Vector3d();
    private final Quaterniond turn = new Quaterniond();

    MouseHand(Diary diary) {
        this.diary = diary;
    }

    void grab(PhysicsWorld world, BodyRef what, double atDistance, Vector3d localPoint) {
        release();
        body = what;
        local.set(localPoint);
        distance = atDistance;
        target.set(place());
        if (what.type() == BodyType.DYNAMIC) {
            Hand taken = new Hand(world);
            taken.grab(what, point);
            diary.add(What.GRAB, what.entity(), point.x, point.y, point.z);
            hand = taken;
        }
    }

    void release() {
        Hand taken = hand;
        if (taken != null) {
            taken.release();
            diary.add(What.RELEASE);
        }
        hand = null;
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
    private Vector3d place() {
        BodyRef held = body;
        if (held != null) {
            held.orientation(turn).transform(local, point);
            point.add(held.position(scratch));
        }
        return point;
    }

    /** Pulls for one tick. */
    void apply() {
        Hand taken = hand;
        if (taken != null && !taken.isHolding()) {
            release();
            body = null;
        } else if (taken != null) {
            taken.pull(target.x, target.y, target.z);
            diary.add(What.PULL, 0, target.x, target.y, target.z);
        }
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
            name = own.isEmpty() ? held.toString() : own;
        }
        state.held = name;
        state.heldIsFixed = held.isFixed();
        state.heldMass = held.isFixed() ? Double.POSITIVE_INFINITY : held.mass();
        state.heldSpeed = held.velocity(scratch).length();
        held.position(state.heldAt);
        state.pulling = hand != null;
        state.pullFrom.set(place());
        state.pullTo.set(target);
    }
}
