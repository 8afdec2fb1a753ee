package dev.cairn.physics;

import dev.cairn.core.ecs.EcsSystem;
import dev.cairn.core.ecs.World;
import dev.cairn.core.job.Jobs;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * A world of rigid bodies: an ECS world with the physics system in it.
 *
 * <p>SI units, right-handed, y up. One simulation thread calls everything here; the world's helpers work inside {@link
 * #step}. Steps allocate nothing once the arrays have grown.
 */
public final class PhysicsWorld implements AutoCloseable {
    private PhysicsWorld() {}

    /**
     * Starts the description of a world.
     *
     * @return a builder with the defaults
     */
    public static Builder builder() {
        return new Builder();
    }

    /**
     * Adds a body, between steps. It is in the ECS, with its {@code Pose}, at once.
     *
     * @param body what it is like
     * @return the body
     * @throws IllegalArgumentException if the description lacks a shape or its mass properties are not finite
     * @throws IllegalStateException if the world is closed or a step runs
     */
    public BodyRef add(Body body) {
        throw new UnsupportedOperationException();
    }

    /**
     * Runs one tick of all systems.
     *
     * @param stepSeconds s, finite, above 0
     * @throws IllegalArgumentException if stepSeconds is not
     * @throws IllegalStateException if the world is closed, has failed, or a step runs already
     */
    public void step(double stepSeconds) {
        throw new UnsupportedOperationException();
    }

    /**
     * The ECS world that holds the bodies' entities.
     *
     * @return the world
     */
    public World ecs() {
        throw new UnsupportedOperationException();
    }

    /**
     * The contacts and contact events of the last step.
     *
     * @return the same view each time
     */
    public Contacts contacts() {
        throw new UnsupportedOperationException();
    }

    /**
     * The bodies that were quarantined so far and are still there, in the order that it happened. A body whose force, velocity
     * or position is no longer a number that can be computed with is stopped where it last was valid, and fixed there, so that
     * its neighbours stay finite.
     *
     * @return a new list
     */
    public List<BodyRef> quarantined() {
        throw new UnsupportedOperationException();
    }

    /**
     * The body of an entity.
     *
     * @param entity an entity
     * @return its body, or {@code null} if it has none
     */
    public @Nullable BodyRef bodyOf(long entity) {
        throw new UnsupportedOperationException();
    }

    /**
     * The body of an index, in slot order, for loops over all bodies.
     *
     * @param index 0 to bodyCount - 1
     * @return the body
     */
    public BodyRef body(int index) {
        throw new UnsupportedOperationException();
    }

    /**
     * How many bodies there are, fixed ones included.
     *
     * @return the number
     */
    public int bodyCount() {
        throw new UnsupportedOperationException();
    }

    /**
     * A hash of the state: poses, velocities and contact impulses, bit by bit. Equal for any number of workers.
     *
     * @return 64 bits
     */
    public long digest() {
        throw new UnsupportedOperationException();
    }

    /**
     * The kinetic energy of all dynamic bodies.
     *
     * @return J
     */
    public double kineticEnergy() {
        return kinetics().kineticEnergy();
    }

    /**
     * Energy and momenta of all dynamic bodies. Allocates the result.
     *
     * @return the sums
     */
    public Kinetics kinetics() {
        throw new UnsupportedOperationException();
    }

    /**
     * Stops or resumes the physics system; the other systems run on.
     *
     * @param paused true to stop
     */
    public void setPaused(boolean paused) {
        throw new UnsupportedOperationException();
    }

    /**
     * Whether the physics system is stopped.
     *
     * @return true between setPaused(true) and setPaused(false)
     */
    public boolean isPaused() {
        throw new UnsupportedOperationException();
    }

    /**
     * Whether a system has thrown, so that no further step is possible.
     *
     * @return true after a failed step
     */
    public boolean hasFailed() {
        throw new UnsupportedOperationException();
    }

    /**
     * The settings of the step.
     *
     * @return the settings
     */
    public PhysicsSettings settings() {
        throw new UnsupportedOperationException();
    }

    /** Ends the world and its helpers. A second call does nothing. */
    @Override
    public void close() {
        throw new UnsupportedOperationException();
    }

    /** Describes a world. One thread at a time. */
    public static final class Builder {
        private Builder() {}

        /**
         * Sets the gravity; (0, -9.81, 0) by default.
         *
         * @param x m/s², finite
         * @param y m/s², finite
         * @param z m/s², finite
         * @return this
         */
        public Builder gravity(double x, double y, double z) {
            return this;
        }

        /**
         * Sets how many threads work at a step, the caller included; by default as many as there are processors. The results
         * do not depend on it.
         *
         * @param count 1 to {@link Jobs#MAX_WORKERS}
         * @return this
         */
        public Builder workers(int count) {
            return this;
        }

        /**
         * Gives the workers, instead of {@link #workers}. The caller closes them, after the world.
         *
         * @param value the workers
         * @return this
         */
        public Builder jobs(Jobs value) {
            return this;
        }

        /**
         * Sets the solver's sub-steps of a tick; 4 by default.
         *
         * @param count 1 to 64
         * @return this
         */
        public Builder substeps(int count) {
            return this;
        }

        /**
         * Sets all tunables.
         *
         * @param value the settings
         * @return this
         */
        public Builder settings(PhysicsSettings value) {
            return this;
        }

        /**
         * Sets the seed of the systems' random streams; 0 by default. The physics itself uses none.
         *
         * @param value any
         * @return this
         */
        public Builder seed(long value) {
            return this;
        }

        /**
         * Adds systems of the user to the schedule, beside the physics.
         *
         * @param values systems; the order of registration does not matter
         * @return this
         */
        public Builder systems(EcsSystem... values) {
            return this;
        }

        /**
         * Makes the world.
         *
         * @return an empty world
         */
        public PhysicsWorld build() {
            throw new UnsupportedOperationException();
        }
    }
}
