package dev.cairn.physics;

import dev.cairn.core.ecs.EcsSystem;
import dev.cairn.core.ecs.World;
import dev.cairn.core.job.Jobs;
import dev.cairn.physics.internal.Checks;
import dev.cairn.physics.joint.Joint;
import dev.cairn.physics.joint.JointRef;
import dev.cairn.physics.joint.Jointed;
import dev.cairn.physics.joint.Joints;
import dev.cairn.physics.state.Digest;

import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;

/**
 * A world of rigid bodies: an ECS world with the physics system in it.
 *
 * <p>SI units, right-handed, y up. One simulation thread calls everything here; the world's helpers
 * work inside {@link #step}. Steps allocate nothing once the arrays have grown.
 */
public final class PhysicsWorld implements AutoCloseable {
    final PhysicsSystem physics;
    private final World ecs;
    private boolean stepping;
    private boolean closed;

    private final Joints joints;

    private PhysicsWorld(PhysicsSystem physics, World ecs) {
        this.physics = physics;
        this.ecs = ecs;
        physics.table.bind(ecs);
        joints = new Joints(physics.joints, physics.table.bodies, new JointHost());
        physics.jointList = joints;
    }

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
     * @throws IllegalArgumentException if the description lacks a shape or its mass properties are
     *     not finite
     * @throws IllegalStateException if the world is closed or a step runs
     */
    public BodyRef add(Body body) {
        Checks.notNull("body", body);
        requireOpen("add");
        if (stepping || physics.isRunning()) {
            throw new IllegalStateException(
                    "add was called during a step; add bodies between steps, or spawn plain"
                            + " entities with tick.commands()");
        }
        return physics.table.add(body);
    }

    /**
     * Adds a joint, between steps. Its bodies wake.
     *
     * @param joint what it is like
     * @return the joint
     * @throws IllegalArgumentException if both bodies are one or neither moves, a body is of
     *     another world, or the joint has no place
     * @throws BodyRemovedException if a body is gone
     * @throws IllegalStateException if the world is closed or a step runs
     */
    public JointRef add(Joint joint) {
        return joints.add(joint);
    }

    /**
     * The joints, and which of them broke in the last step.
     *
     * @return the same object each time
     */
    public Joints joints() {
        return joints;
    }

    /** What joints need of this world. */
    private final class JointHost implements Joints.Host {
        @Override
        public int slotOf(String name, Jointed body) {
            if (!(Checks.notNull(name, body) instanceof BodyRef ref) || !ref.isOf(physics.table)) {
                throw new IllegalArgumentException(
                        name
                                + " is "
                                + body
                                + ", which is no body of this world; pass what add(Body) returned");
            }
            return ref.alive();
        }

        @Override
        public void wake(int slot) {
            physics.table.sleepers.wake(slot);
        }

        @Override
        public void requireBetweenSteps(String call) {
            PhysicsWorld.this.requireBetweenSteps(call);
        }
    }

    /**
     * Runs one tick of all systems.
     *
     * @param stepSeconds s, finite, above 0
     * @throws IllegalArgumentException if stepSeconds is not
     * @throws IllegalStateException if the world is closed, has failed, or a step runs already
     */
    public void step(double stepSeconds) {
        requireOpen("step");
        if (stepping) {
            throw new IllegalStateException(
                    "step was called during a step; a system must not step the world that runs it");
        }
        Checks.positive("stepSeconds", stepSeconds);
        stepping = true;
        try {
            ecs.step(stepSeconds);
        } finally {
            stepping = false;
        }
    }

    /**
     * The ECS world that holds the bodies' entities.
     *
     * @return the world
     */
    public World ecs() {
        return ecs;
    }

    /**
     * The contacts and contact events of the last step.
     *
     * @return the same view each time
     */
    public Contacts contacts() {
        return physics.view;
    }

    /**
     * Contacts that the solver takes at once. Any thread.
     *
     * @return 1 if it is scalar, else 4, 8 or 16
     */
    public int lanes() {
        return physics.lanes();
    }

    /**
     * The clock of the physics step's stages; off until it is enabled.
     *
     * @return the same object each time
     */
    public StepProfile profile() {
        return physics.profile;
    }

    /**
     * Makes what answers questions about places: rays, moving shapes, nearest bodies, overlaps.
     * Make one and keep it.
     *
     * @return a new one, for one thread
     */
    public WorldQueries queries() {
        return new WorldQueries(this);
    }

    /**
     * Who fell asleep and who woke.
     *
     * @return the same view each time
     */
    public SleepEvents sleepEvents() {
        return physics.sleepView;
    }

    /**
     * The bodies that were quarantined so far and are still there, in the order that it happened. A
     * body whose force, velocity or position is no longer a number that can be computed with is
     * stopped where it last was valid, and fixed there, so that its neighbours stay finite.
     *
     * @return a new list
     */
    public List<BodyRef> quarantined() {
        List<BodyRef> list = new ArrayList<>(physics.table.quarantined);
        list.removeIf(ref -> !ref.isAlive());
        return list;
    }

    /**
     * The body of an entity.
     *
     * @param entity an entity
     * @return its body, or {@code null} if it has none
     */
    public @Nullable BodyRef bodyOf(long entity) {
        if (closed || !ecs.isAlive(entity) || !ecs.has(entity, RigidBody.COMPONENT)) {
            return null;
        }
        BodyRef ref = physics.table.refs[ecs.get(entity, RigidBody.COMPONENT).slot()];
        return ref.entity() == entity ? ref : null;
    }

    /**
     * All bodies, in slot order. Allocates.
     *
     * @return a new list
     */
    public List<BodyRef> bodies() {
        List<BodyRef> alive = new ArrayList<>();
        for (int slot = 0; slot < physics.table.bodies.slotCount; slot++) {
            BodyRef ref = physics.table.refs[slot];
            if (ref.isAlive()) {
                alive.add(ref);
            }
        }
        return alive;
    }

    /**
     * How many bodies there are, fixed ones included.
     *
     * @return the number
     */
    public int bodyCount() {
        return ecs.query(RigidBody.COMPONENT).entityCount();
    }

    /**
     * A hash of the state: poses, velocities, impulses of contacts and joints, and sleep, bit by
     * bit. Equal for any number of workers.
     *
     * @return 64 bits
     */
    public long digest() {
        return Digest.of(
                physics.table.bodies, physics.contacts, physics.table.sleepers, physics.joints);
    }

    /**
     * Checks the state that the next step starts from, for a report of a fault: motions, boxes,
     * contacts, impulses and islands. Between steps; costs about as much as a step, and allocates.
     *
     * @throws IllegalStateException telling what is wrong and where, the value, its bound and what
     *     to do; or if the world is closed or a step runs
     */
    public void validate() {
        requireBetweenSteps("validate");
        physics.table.validate();
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
        return Kinetics.of(physics.table.bodies);
    }

    /**
     * The potential energy of all dynamic bodies in the world's gravity, zero at the origin.
     * Between steps; does not allocate.
     *
     * @return J
     */
    public double potentialEnergy() {
        return Kinetics.potentialEnergy(
                physics.table.bodies, physics.gravityX, physics.gravityY, physics.gravityZ);
    }

    /**
     * Copies contacts and bodies for another thread to look at. Between steps; allocates only while
     * their numbers grow.
     *
     * @param into what to fill
     * @return {@code into}
     */
    public DebugData capture(DebugData into) {
        Checks.notNull("into", into).fill(physics);
        return into;
    }

    /**
     * Stops or resumes the physics system; the other systems run on. Forces that were applied
     * meanwhile are forgotten.
     *
     * @param paused true to stop
     */
    public void setPaused(boolean paused) {
        requireOpen("setPaused");
        if (!paused && isPaused()) {
            physics.table.clearAllForces();
        }
        ecs.schedule().setEnabled(PhysicsSystem.NAME, !paused);
    }

    /**
     * Whether the physics system is stopped.
     *
     * @return true between setPaused(true) and setPaused(false)
     */
    public boolean isPaused() {
        return !ecs.schedule().isEnabled(PhysicsSystem.NAME);
    }

    /**
     * Whether a system has thrown, so that no further step is possible.
     *
     * @return true after a failed step
     */
    public boolean hasFailed() {
        return ecs.hasFailed();
    }

    /**
     * The settings of the step.
     *
     * @return the settings
     */
    public PhysicsSettings settings() {
        return physics.settings;
    }

    /**
     * Changes the number of sub-steps of the solver from the next step on, between steps. Contacts
     * keep their impulses.
     *
     * @param count 1 to 64
     * @throws IllegalArgumentException if it is out of range
     * @throws IllegalStateException inside a step
     */
    public void setSubsteps(int count) {
        requireBetweenSteps("setSubsteps");
        physics.settings = physics.settings.withSubsteps(count);
        physics.solver.setSubsteps(count);
    }

    /** Ends the world and its helpers. A second call does nothing. */
    @Override
    public void close() {
        if (closed) {
            return;
        }
        ecs.close();
        closed = true;
        physics.table.close();
    }

    /**
     * Changes the gravity, between steps. All bodies wake if it is another one.
     *
     * @param x m/s², finite
     * @param y m/s², finite
     * @param z m/s², finite
     */
    public void setGravity(double x, double y, double z) {
        Checks.finite("gravity x", x);
        Checks.finite("gravity y", y);
        Checks.finite("gravity z", z);
        requireOpen("setGravity");
        if (x != physics.gravityX || y != physics.gravityY || z != physics.gravityZ) {
            physics.table.sleepers.wakeAll(physics.table.bodies.slotCount);
        }
        physics.gravityX = x;
        physics.gravityY = y;
        physics.gravityZ = z;
    }

    /**
     * The gravity in force.
     *
     * @param destination receives m/s²
     * @return destination
     */
    public Vector3d gravity(Vector3d destination) {
        Checks.notNull("destination", destination);
        return destination.set(physics.gravityX, physics.gravityY, physics.gravityZ);
    }

    void requireBetweenSteps(String call) {
        requireOpen(call);
        if (stepping || physics.isRunning()) {
            throw new IllegalStateException(
                    call + " was called during a step; call it between steps, when nobody moves");
        }
    }

    private void requireOpen(String call) {
        if (closed) {
            throw new IllegalStateException(
                    call + " was called on a world that is closed; build another one");
        }
    }

    /** Describes a world. One thread at a time. */
    public static final class Builder {
        private double gravityX;
        private double gravityY = -9.81;
        private double gravityZ;
        private @Nullable Jobs jobs;
        private int workers;
        private PhysicsSettings settings = PhysicsSettings.DEFAULT;
        private long seed;
        private final List<EcsSystem> systems = new ArrayList<>();

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
            Checks.finite("gravity x", x);
            Checks.finite("gravity y", y);
            Checks.finite("gravity z", z);
            gravityX = x;
            gravityY = y;
            gravityZ = z;
            return this;
        }

        /**
         * Sets how many threads work at a step, the caller included; by default as many as there
         * are processors. The results do not depend on it.
         *
         * @param count 1 to {@link Jobs#MAX_WORKERS}
         * @return this
         */
        public Builder workers(int count) {
            workers = Checks.between("workers", count, 1, Jobs.MAX_WORKERS);
            jobs = null;
            return this;
        }

        /**
         * Gives the workers, instead of {@link #workers}. The caller closes them, after the world.
         *
         * @param value the workers
         * @return this
         */
        public Builder jobs(Jobs value) {
            jobs = Checks.notNull("jobs", value);
            return this;
        }

        /**
         * Sets the solver's sub-steps of a tick; 4 by default.
         *
         * @param count 1 to 64
         * @return this
         */
        public Builder substeps(int count) {
            settings = settings.withSubsteps(count);
            return this;
        }

        /**
         * Says whether bodies that have come to rest fall asleep; true by default. A body asleep
         * costs nothing and wakes as soon as anything happens to it. Measurements of accuracy want
         * false, so that what they see at rest is the solver's doing.
         *
         * @param value false to keep all bodies awake
         * @return this
         */
        public Builder sleeping(boolean value) {
            settings = settings.withSleeping(value);
            return this;
        }

        /**
         * Sets all tunables.
         *
         * @param value the settings
         * @return this
         */
        public Builder settings(PhysicsSettings value) {
            settings = Checks.notNull("settings", value);
            return this;
        }

        /**
         * Sets the seed of the systems' random streams; 0 by default. The physics itself uses none.
         *
         * @param value any
         * @return this
         */
        public Builder seed(long value) {
            seed = value;
            return this;
        }

        /**
         * Adds systems of the user to the schedule, beside the physics.
         *
         * @param values systems; the order of registration does not matter
         * @return this
         */
        public Builder systems(EcsSystem... values) {
            Checks.notNull("systems", values);
            for (EcsSystem system : values) {
                systems.add(Checks.notNull("system", system));
            }
            return this;
        }

        /**
         * Makes the world.
         *
         * @return an empty world
         */
        public PhysicsWorld build() {
            PhysicsSystem physics = new PhysicsSystem(settings, gravityX, gravityY, gravityZ);
            List<EcsSystem> all = new ArrayList<>(systems);
            all.add(physics);
            World.Builder builder =
                    World.builder().systems(all.toArray(new EcsSystem[0])).seed(seed);
            if (jobs != null) {
                builder.jobs(jobs);
            } else {
                builder.workers(workers == 0 ? Jobs.defaultWorkers() : workers);
            }
            return new PhysicsWorld(physics, builder.build());
        }
    }
}
