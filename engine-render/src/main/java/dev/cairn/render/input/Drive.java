package dev.cairn.render.input;

import dev.cairn.core.ecs.World;
import dev.cairn.core.snapshot.Pose;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.body.BodyType;

import org.joml.Matrix3d;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/**
 * Does to an entity what a {@link Control} asks for, so that it can be done again from what was
 * written down. Simulation thread, before a step.
 */
public final class Drive {
    private final PhysicsWorld physics;
    private final Vector3d vector = new Vector3d();
    private final Quaterniond turn = new Quaterniond();
    private final Matrix3d inertia = new Matrix3d();

    /** Is told of all that controls do. Simulation thread. */
    @FunctionalInterface
    public interface Listener {
        /**
         * Something is done; the numbers are those of {@link Drive#apply}.
         *
         * @param entity what it is done to
         * @param effect what is done
         * @param x along the world's axes, in the unit of the effect
         * @param y same
         * @param z same
         * @param seconds length of the coming tick
         */
        void driven(
                long entity, Control.Effect effect, double x, double y, double z, double seconds);
    }

    /**
     * For one world.
     *
     * @param physics which
     */
    public Drive(PhysicsWorld physics) {
        this.physics = physics;
    }

    /**
     * Pushes a body, or moves the pose of an entity without one; nothing happens to fixed and
     * kinematic bodies and to what is nowhere.
     *
     * @param entity alive
     * @param effect what is done
     * @param x along the world's axes, in the unit of the effect
     * @param y same
     * @param z same
     * @param seconds length of the coming tick
     */
    public void apply(
            long entity, Control.Effect effect, double x, double y, double z, double seconds) {
        vector.set(x, y, z);
        BodyRef body = physics.bodyOf(entity);
        if (body == null) {
            move(entity, effect, seconds);
        } else if (body.type() == BodyType.DYNAMIC) {
            push(body, effect);
        }
    }

    private void push(BodyRef body, Control.Effect effect) {
        switch (effect) {
            case PUSH -> {
                vector.mul(body.mass());
                body.applyForce(vector.x, vector.y, vector.z);
            }
            case TURN -> {
                // T = I a
                body.inverseInertia(inertia).invert().transform(vector);
                body.applyTorque(vector.x, vector.y, vector.z);
            }
            case KICK -> {
                vector.mul(body.mass());
                body.applyImpulse(vector.x, vector.y, vector.z);
            }
        }
    }

    private void move(long entity, Control.Effect effect, double seconds) {
        World ecs = physics.ecs();
        if (!ecs.has(entity, Pose.COMPONENT)) {
            return; // It is nowhere, so it cannot go anywhere.
        }
        Pose at = ecs.get(entity, Pose.COMPONENT);
        turn.set(at.qx(), at.qy(), at.qz(), at.qw());
        double share = effect == Control.Effect.KICK ? 1 : seconds;
        vector.mul(share);
        if (effect == Control.Effect.TURN) {
            double angle = vector.length();
            if (angle > 0) {
                vector.div(angle);
                turn.premul(new Quaterniond().fromAxisAngleRad(vector.x, vector.y, vector.z, angle))
                        .normalize();
            }
            vector.zero();
        }
        ecs.set(
                entity,
                new Pose(
                        at.x() + vector.x,
                        at.y() + vector.y,
                        at.z() + vector.z,
                        turn.x,
                        turn.y,
                        turn.z,
                        turn.w,
                        at.jumps()));
    }
}
