package dev.cairn.physics;

import dev.cairn.core.ecs.EcsSystem;
import dev.cairn.core.ecs.Query;
import dev.cairn.core.ecs.World;
import dev.cairn.core.ecs.component.Component;
import dev.cairn.core.job.Jobs;
import dev.cairn.core.snapshot.Pose;
import dev.cairn.core.snapshot.Visual;
import dev.cairn.core.state.StateCodec;
import dev.cairn.core.state.StateCodecs;
import dev.cairn.core.state.StateException;
import dev.cairn.core.state.StateVisitor;
import dev.cairn.core.state.Stateful;
import dev.cairn.core.state.WorldState;
import dev.cairn.physics.body.BodyRemovedException;
import dev.cairn.physics.collider.Filter;
import dev.cairn.physics.component.Force;
import dev.cairn.physics.component.Torque;
import dev.cairn.physics.component.Velocity;
import dev.cairn.physics.internal.Checks;
import dev.cairn.physics.joint.Joint;
import dev.cairn.physics.joint.JointChange;
import dev.cairn.physics.joint.JointRef;
import dev.cairn.physics.joint.Jointed;
import dev.cairn.physics.joint.Joints;
import dev.cairn.physics.joint.NewJoint;
import dev.cairn.physics.joint.RigidJoint;
import dev.cairn.physics.prediction.BodyPredictor;
import dev.cairn.physics.profile.StepProfile;
import dev.cairn.physics.shape.ShapeCodecs;
import dev.cairn.physics.state.RigidBody;
import dev.cairn.physics.state.SupportLoads;

import org.joml.Vector3dc;

import java.util.ArrayList;
import java.util.List;

/**
 * A world of rigid bodies: an ECS world with the physics system in it.
 *
 * <p>SI units, right-handed, y up. One simulation thread calls everything here; the world's helpers
 * work inside {@link #step}. Steps allocate nothing once the arrays have grown.
 */
public final class PhysicsWorld extends WorldReadings implements AutoCloseable {
    /** The name of the physics in the schedule, for {@code Access.before} and {@code after}. */
    public static final String SYSTEM = PhysicsSystem.NAME;

    private final Query newcomers;
    private final Query changes;
    private final Collisions collisions;

    private final Joints joints;
    private final EcsSystem[] systems;
    private final Stateful whole = this::state;

    PhysicsWorld(PhysicsSystem physics, World ecs, EcsSystem... systems) {
        super(physics, ecs);
        this.systems = systems;
        physics.table.registry.bind(ecs);
        physics.profile.watch(ecs.profile());
        ecs.watch(Pose.COMPONENT);
        newcomers = ecs.query(NewBody.COMPONENT);
        changes = ecs.query(Body.Change.COMPONENT);
        collisions = new Collisions(this);
        joints = new Joints(physics.joints, physics.table.bodies, new JointHost(), ecs);
        physics.jointList = joints;
    }

    /**
     * Starts the description of a world.
     *
     * @return a builder with the defaults
     */
    public static PhysicsWorldBuilder builder() {
        return new PhysicsWorldBuilder();
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
        public boolean isAlive(int slot, long entity) {
            return physics.table.isAlive(slot, entity);
        }

        @Override
        public int slotOf(String name, Jointed body) {
            Jointed given = Checks.notNull(name, body);
            Jointed named = given instanceof Jointed.ByEntity ? bodyOf(given.entity()) : given;
            if (!(named instanceof BodyRef ref) || !ref.isOf(physics.table)) {
                throw new IllegalArgumentException(
                        name
                                + " is "
                                + body
                                + ", which is no body of this world; pass what add(Body) returned");
            }
            return ref.alive();
        }

        @Override
        public long bodiesBorn() {
            return physics.table.born;
        }

        @Override
        public void wake(int slot) {
            physics.table.sleepers.wake(slot);
        }

        @Override
        public void apart(int a, int b) {
            physics.table.collision.rules.apart(a, b);
        }

        @Override
        public void together(int a, int b) {
            physics.table.collision.rules.together(a, b);
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
        physics.table.access.takePoses();
        adopt();
        change();
        joints.endStep();
        physics.view.tell();
    }

    /** Makes bodies of the entities with {@link NewBody}, in order of their rows. */
    private void adopt() {
        for (long entity : newcomers.entities()) {
            Body body = ecs.get(entity, NewBody.COMPONENT).body();
            ecs.remove(entity, NewBody.COMPONENT);
            physics.table.add(body, entity);
        }
    }

    /** Makes the changes that were asked for by {@link Body.Change}, in order of their rows. */
    private void change() {
        for (long entity : changes.entities()) {
            Body.Change change = ecs.get(entity, Body.Change.COMPONENT);
            ecs.delete(entity);
            if (!ecs.isAlive(change.entity())) {
                continue; // it was deleted in the same step
            }
            BodyRef body = physics.table.of(change.entity());
            if (body == null) {
                throw new IllegalArgumentException(
                        "a Body.Change names entity "
                                + change.entity()
                                + ", which is no body; pass BodyRef.entity()");
            }
            change.change().accept(body);
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
     * The rules about which bodies collide, beside the filters of colliders.
     *
     * @return the same object each time
     */
    public Collisions collisions() {
        return collisions;
    }

    /**
     * The clock of the physics step's stages and of all systems; off until it is enabled.
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
     * The bodies that fell asleep and those that woke.
     *
     * @return the same view each time
     */
    public SleepEvents sleepEvents() {
        return physics.sleepView;
    }

    /**
     * Saves all that the next step depends on: bodies, colliders, shapes, joints, contacts with
     * what is remembered of them, which bodies sleep, events of the last step, tick, entities with
     * all components. Not saved are functions and listeners (filters of pairs, contact hooks),
     * resources and whether the physics is paused; objects of the user are kept by reference.
     * Between steps.
     *
     * @return a new state
     * @throws IllegalStateException during a step, or if the world is closed
     */
    public WorldState save() {
        WorldState state = new WorldState();
        save(state);
        return state;
    }

    /**
     * The same into a state that may be there already. Allocates only while its buffers grow.
     *
     * @param into what to fill
     * @return {@code into}
     */
    public WorldState save(WorldState into) {
        requireBetweenSteps("save");
        Checks.notNull("into", into).save(whole);
        return into;
    }

    /**
     * Goes on from a state that was saved here, or in another world with the same systems and
     * settings; workers and lanes may differ. Every later step has the same bits as it had there.
     * References to bodies, colliders and joints that were there when it was saved name them again;
     * those to later ones are dead. Listeners hear nothing of it. Between steps.
     *
     * @param state what to restore
     * @throws StateException if it is the state of something else; the world is as before if that
     *     is told by its settings, or the state came from bytes, and else needs another state
     * @throws IllegalStateException during a step, or if the world is closed
     */
    public void restore(WorldState state) {
        requireBetweenSteps("restore");
        Checks.notNull("state", state).restoreOrKeep(whole, !hasFailed());
    }

    /**
     * How a state of such a world becomes bytes: {@code state.writeTo(file,
     * PhysicsWorld.codecs())}. Columns of components need no more, where {@link World#codecs} says
     * so; other objects of the user need codecs of their own, by {@code with(..)}.
     *
     * @param components those that entities may have beside the ones of this module
     * @return codecs of shapes, filters, components and references
     */
    public static StateCodecs codecs(Component<?>... components) {
        List<Component<?>> all = new ArrayList<>(List.of(components));
        all.addAll(List.of(Pose.COMPONENT, Visual.COMPONENT, Velocity.COMPONENT));
        all.addAll(List.of(Force.COMPONENT, Torque.COMPONENT));
        all.addAll(List.of(RigidBody.COMPONENT, NewBody.COMPONENT, Body.Change.COMPONENT));
        all.addAll(List.of(RigidJoint.COMPONENT, NewJoint.COMPONENT, JointChange.COMPONENT));
        return World.codecs(all.toArray(new Component<?>[0]))
                .with(ShapeCodecs.all().toArray(new StateCodec<?>[0]))
                .with(Collider.CODEC, BodyRef.CODEC, ColliderRef.CODEC, PhysicsSettings.CODEC)
                .with(Filter.CODEC, Joints.codec(), Joints.curveCodec(), BodyPredictor.CODEC);
    }

    /**
     * A second world in the same state, which goes on by itself: with the systems, observers,
     * resources, pair filter and contact hook of this one, and without its listeners. Both use the
     * same workers, so they must be stepped one after the other. Close it when it is done.
     *
     * @return another world; {@link #bodyOf} finds its bodies by their entities
     */
    public PhysicsWorld fork() {
        return fork(ecs.jobs());
    }

    /**
     * The same with workers of its own, so that it can be stepped while others are.
     *
     * @param jobs its workers; the caller closes them, after the world
     * @return another world
     */
    public PhysicsWorld fork(Jobs jobs) {
        requireBetweenSteps("fork");
        PhysicsWorld twin =
                builder()
                        .settings(physics.settings)
                        .seed(ecs.seed())
                        .systems(systems)
                        .jobs(jobs)
                        .build();
        twin.physics.hooks.set(physics.hooks.get());
        twin.physics.table.collision.askAs(physics.table.collision);
        twin.ecs.putResourcesOf(ecs);
        twin.ecs.putObserversOf(ecs);
        twin.restore(save());
        return twin;
    }

    /** Settings are compared first: nothing has changed when they are refused. */
    private void state(StateVisitor s) {
        s.section("physicsWorld", this);
        PhysicsSettings saved = s.reference("settings", physics.settings);
        if (!physics.settings.isLike(saved)) {
            throw new StateException(
                    "the state is of a world with "
                            + saved
                            + ", and this one has "
                            + physics.settings
                            + "; build the world with the settings of the state");
        }
        s.reference("predictor", BodyPredictor.INSTANCE);
        ecs.state(s);
        physics.state(s);
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
            physics.table.registry.clearAllForces();
        }
        ecs.schedule().setEnabled(PhysicsSystem.NAME, !paused);
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
        physics.setSubsteps(count);
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
     * Changes the gravity, between steps. All bodies wake if it is another one. Of a weaker one, or
     * one along another direction, contacts hold less from the start, so that what is at rest stays
     * there; that looks at all contacts.
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
            physics.wakeAll();
            weaken(x, y, z);
        }
        physics.gravityX = x;
        physics.gravityY = y;
        physics.gravityZ = z;
    }

    /** What contacts know of loads goes with the gravity, as far as it becomes less. */
    private void weaken(double x, double y, double z) {
        double gx = physics.gravityX;
        double gy = physics.gravityY;
        double gz = physics.gravityZ;
        double share = (x * gx + y * gy + z * gz) / (gx * gx + gy * gy + gz * gz);
        // of none before it is no number, and nothing is known; a gravity that turns slowly is no
        // weaker one, and contacts learn of it from tick to tick
        if (share < 0.999) {
            SupportLoads.weaken(physics.table.contacts, Math.max(0, share));
        }
    }

    /**
     * Changes the gravity, between steps.
     *
     * @param gravity m/s², finite
     */
    public void setGravity(Vector3dc gravity) {
        Checks.notNull("gravity", gravity);
        setGravity(gravity.x(), gravity.y(), gravity.z());
    }
}
