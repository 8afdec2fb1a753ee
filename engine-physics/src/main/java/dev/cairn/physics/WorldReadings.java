package dev.cairn.physics;

import dev.cairn.core.ecs.Query;
import dev.cairn.core.ecs.World;
import dev.cairn.physics.body.Kinetics;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.Checks;
import dev.cairn.physics.state.CrushDetector;
import dev.cairn.physics.state.Digest;
import dev.cairn.physics.state.KineticSums;
import dev.cairn.physics.state.RigidBody;

import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;

/**
 * What can be read of a {@link PhysicsWorld}, and is not changed by that: bodies, sums, audits,
 * settings. Simulation thread.
 */
public abstract sealed class WorldReadings permits PhysicsWorld {
    final PhysicsSystem physics;
    final World ecs;
    private final Query bodies;

    boolean stepping;
    boolean closed;

    WorldReadings(PhysicsSystem physics, World ecs) {
        this.physics = physics;
        this.ecs = ecs;
        bodies = ecs.query(RigidBody.COMPONENT);
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
     * The bodies that were quarantined so far and are still there, in the order that it happened. A
     * body whose force, velocity or position is no longer a number that can be computed with is
     * stopped where it last was valid, and fixed there, so that its neighbours stay finite.
     *
     * @return a new list
     */
    public List<BodyRef> quarantined() {
        return physics.table.quarantined();
    }

    /**
     * The bodies that a kinematic one presses against a body that gives no way: what holds them on
     * both sides comes nearer. Their contacts overlap more and more, with impulses that stay
     * bounded, until they slip out or the user does something. Between steps; allocates.
     *
     * @return those of the last step, in the order of their contacts, each once
     */
    public List<BodyRef> crushed() {
        requireBetweenSteps("crushed");
        CrushDetector crush = new CrushDetector(physics.table.bodies, physics.contacts);
        List<BodyRef> found = new ArrayList<>();
        boolean any = physics.table.registry.kinematicCount > 0;
        for (int row = 0; any && row < physics.contacts.count; row++) {
            int slot = crush.crushed(row);
            if (slot >= 0 && !found.contains(physics.table.refs[slot])) {
                found.add(physics.table.refs[slot]);
            }
        }
        return found;
    }

    /**
     * The body of an entity.
     *
     * @param entity an entity
     * @return its body, or {@code null} if it has none
     */
    public @Nullable BodyRef bodyOf(long entity) {
        return closed || !ecs.isAlive(entity) ? null : physics.table.of(entity);
    }

    /**
     * All bodies, in slot order. Allocates.
     *
     * @return a new list
     */
    public List<BodyRef> bodies() {
        List<BodyRef> alive = new ArrayList<>();
        for (int slot = 0; slot < physics.table.bodies.slotCount; slot++) {
            if (physics.table.bodies.kind[slot] == BodyStore.FREE) {
                continue; // a free slot, or one of a collider
            }
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
        return bodies.entityCount();
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
        double[] sums = new double[KineticSums.ROOM];
        kinetics(sums);
        return Kinetics.of(sums);
    }

    /**
     * The same sums without garbage.
     *
     * @param sums receives the seven numbers in the order of {@link Kinetics}
     */
    public void kinetics(double[] sums) {
        KineticSums.sum(physics.table.bodies, sums);
    }

    /**
     * The potential energy of all dynamic bodies in the world's gravity, zero at the origin.
     * Between steps; does not allocate.
     *
     * @return J
     */
    public double potentialEnergy() {
        return KineticSums.potentialEnergy(
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
                    call + " was called during a step; call it between steps, when no body moves");
        }
    }

    void requireOpen(String call) {
        if (closed) {
            throw new IllegalStateException(
                    call + " was called on a world that is closed; build another one");
        }
    }
}
