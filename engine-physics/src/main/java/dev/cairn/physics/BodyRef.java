package dev.cairn.physics;

import dev.cairn.core.state.StateCodec;
import dev.cairn.physics.body.BodyForces;
import dev.cairn.physics.body.BodyRemovedException;
import dev.cairn.physics.body.BodyType;
import dev.cairn.physics.body.Lock;
import dev.cairn.physics.collider.Filter;
import dev.cairn.physics.internal.Checks;
import dev.cairn.physics.shape.Shape;

import org.joml.Quaterniondc;
import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;

import java.util.List;

/**
 * A body in a world: reads it, see {@link BodyState}, and changes it. All values are in world axes
 * and SI units; positions named so are those of the origin of the frame that the shape was made in,
 * unless a name says centre of mass.
 *
 * <p>Simulation thread only, and not from inside the physics step: a method that changes the body
 * throws {@link IllegalStateException} there, on any thread. Methods that take a destination or
 * primitives do not allocate. Every method but {@link #entity}, {@link #isAlive}, {@link #name} and
 * {@link #toString} throws {@link BodyRemovedException} once the body is gone. Forces and torques
 * add up and act over the whole next step, then are cleared; impulses act at once. On fixed bodies
 * forces and impulses have no effect.
 */
public final class BodyRef extends BodyState implements BodyForces {
    /** In bytes a reference is a name and a place; a world makes its own of it. */
    static final StateCodec<BodyRef> CODEC =
            StateCodec.of(
                    BodyRef.class,
                    "body",
                    (ref, out) -> {
                        out.writeInt(ref.slot());
                        out.writeLong(ref.entity());
                        out.writeString(ref.name());
                    },
                    in -> ofNoWorld(in.readInt(), in.readLong(), in.readString()));

    BodyRef(BodyTable table, int slot, long entity, String name) {
        super(table, slot, entity, name);
    }

    @SuppressWarnings("NullAway") // nobody sees it before a world has made its own of it
    private static BodyRef ofNoWorld(int slot, long entity, String name) {
        return new BodyRef(null, slot, entity, name);
    }

    @Override
    public void applyForce(double fx, double fy, double fz) {
        table.forces.applyForce(pushed("applyForce"), fx, fy, fz);
    }

    @Override
    public void applyForceAt(double fx, double fy, double fz, double px, double py, double pz) {
        table.forces.applyForceAt(pushed("applyForceAt"), fx, fy, fz, px, py, pz);
    }

    @Override
    public void applyTorque(double tx, double ty, double tz) {
        table.forces.applyTorque(pushed("applyTorque"), tx, ty, tz);
    }

    @Override
    public void applyImpulse(double jx, double jy, double jz) {
        table.forces.applyImpulse(pushed("applyImpulse"), jx, jy, jz);
    }

    @Override
    public void applyImpulseAt(double jx, double jy, double jz, double px, double py, double pz) {
        table.forces.applyImpulseAt(pushed("applyImpulseAt"), jx, jy, jz, px, py, pz);
    }

    @Override
    public void applyAngularImpulse(double lx, double ly, double lz) {
        table.forces.applyAngularImpulse(pushed("applyAngularImpulse"), lx, ly, lz);
    }

    private int pushed(String call) {
        int s = changed(call);
        table.access.needsDynamic(s, call);
        return s;
    }

    /**
     * Sets how much of the world's gravity acts on the body, and wakes it. Where it becomes less,
     * contacts that hold the body up hold less, so that it stays; that looks at all contacts.
     *
     * @param factor finite; see {@link Body#gravityScale}
     */
    public void setGravityScale(double factor) {
        table.access.setGravityScale(changed("setGravityScale"), factor);
    }

    /**
     * Sets the rates at which velocity and angular momentum decay, and wakes the body.
     *
     * @param linear 1/s, 0 to 1e6; see {@link Body#damping}
     * @param angular 1/s, 0 to 1e6
     */
    public void setDamping(double linear, double angular) {
        table.access.setDamping(changed("setDamping"), linear, angular);
    }

    /**
     * Limits the speed of the centre of mass at the end of each tick, and wakes the body.
     *
     * @param metresPerSecond above 0; infinite for none
     */
    public void setSpeedLimit(double metresPerSecond) {
        table.access.setSpeedLimit(changed("setSpeedLimit"), metresPerSecond);
    }

    /**
     * Takes degrees of freedom from the body, gives it the others back, and wakes it.
     *
     * @param locks the ones it shall not have; none to give all back
     */
    public void setLocks(Lock... locks) {
        table.access.setLocks(changed("setLocks"), locks);
    }

    /**
     * Sets the velocity of the centre of mass.
     *
     * @param vx m/s, finite
     * @param vy m/s, finite
     * @param vz m/s, finite
     * @throws IllegalStateException if the body is fixed
     */
    public void setVelocity(double vx, double vy, double vz) {
        table.access.setVelocity(changed("setVelocity"), vx, vy, vz);
    }

    /**
     * Sets the velocity of the centre of mass.
     *
     * @param velocity m/s, finite
     * @throws IllegalStateException if the body is fixed
     */
    public void setVelocity(Vector3dc velocity) {
        Checks.notNull("velocity", velocity);
        setVelocity(velocity.x(), velocity.y(), velocity.z());
    }

    /**
     * Sets the angular velocity.
     *
     * @param wx rad/s, finite
     * @param wy rad/s, finite
     * @param wz rad/s, finite
     * @throws IllegalStateException if the body is fixed
     */
    public void setAngularVelocity(double wx, double wy, double wz) {
        table.access.setAngularVelocity(changed("setAngularVelocity"), wx, wy, wz);
    }

    /**
     * Sets the angular velocity.
     *
     * @param velocity rad/s, finite
     * @throws IllegalStateException if the body is fixed
     */
    public void setAngularVelocity(Vector3dc velocity) {
        Checks.notNull("velocity", velocity);
        setAngularVelocity(velocity.x(), velocity.y(), velocity.z());
    }

    /**
     * Puts the origin of the shape's frame elsewhere, at once; orientation and velocities stay.
     * {@code Pose.jumps} counts it, so that pictures do not smear. Allocates.
     *
     * @param x m, finite
     * @param y m, finite
     * @param z m, finite
     */
    public void teleport(double x, double y, double z) {
        table.access.teleport(changed("teleport"), x, y, z);
    }

    /**
     * Puts the origin of the shape's frame elsewhere, at once; orientation and velocities stay.
     * Allocates.
     *
     * @param position m, finite
     */
    public void teleport(Vector3dc position) {
        Checks.notNull("position", position);
        teleport(position.x(), position.y(), position.z());
    }

    /**
     * Puts the shape's frame elsewhere, at once; velocities stay. Allocates.
     *
     * @param position m, finite
     * @param rotation unit quaternion worldFromBody, its length within 1e-6 of 1
     */
    public void teleport(Vector3dc position, Quaterniondc rotation) {
        Checks.notNull("position", position);
        teleport(position.x(), position.y(), position.z(), rotation);
    }

    /**
     * Moves a kinematic body: at the end of the next tick the origin of its shape's frame is here,
     * to the bit, and its orientation is as it is now. On the way it moves at constant speed, and
     * carries and pushes what it touches with that. Without another target, or a velocity, it
     * stands still from then on.
     *
     * @param x m, finite
     * @param y m, finite
     * @param z m, finite
     * @throws IllegalStateException if the body is not kinematic
     */
    public void moveTo(double x, double y, double z) {
        table.access.moveTo(changed("moveTo"), x, y, z);
    }

    /**
     * Moves and turns a kinematic body: at the end of the next tick its shape's frame is here, to
     * the bit. It turns the shorter way, at constant angular velocity about the centre of mass.
     *
     * @param x m, finite
     * @param y m, finite
     * @param z m, finite
     * @param rotation unit quaternion worldFromBody, its length within 1e-6 of 1
     * @throws IllegalStateException if the body is not kinematic
     */
    public void moveTo(double x, double y, double z, Quaterniondc rotation) {
        table.access.moveTo(changed("moveTo"), x, y, z, Checks.notNull("rotation", rotation));
    }

    /**
     * Moves a kinematic body, see {@link #moveTo(double, double, double)}.
     *
     * @param position m, finite
     */
    public void moveTo(Vector3dc position) {
        Checks.notNull("position", position);
        moveTo(position.x(), position.y(), position.z());
    }

    /**
     * Moves and turns a kinematic body, see {@link #moveTo(double, double, double, Quaterniondc)}.
     *
     * @param position m, finite
     * @param rotation unit quaternion worldFromBody, its length within 1e-6 of 1
     */
    public void moveTo(Vector3dc position, Quaterniondc rotation) {
        Checks.notNull("position", position);
        moveTo(position.x(), position.y(), position.z(), rotation);
    }

    /**
     * Makes the body one of another type, at once. It keeps its place, its shape and what was
     * stated of its mass; one that becomes fixed loses its velocity. Wakes it and what it touches.
     *
     * @param type the new one
     * @throws IllegalArgumentException if its shape cannot move and it shall be dynamic
     */
    public void setType(BodyType type) {
        table.changes.setType(changed("setType"), Checks.notNull("type", type));
    }

    /**
     * Gives the body another shape, at once. The frame stays where it is; mass, centre and inertia
     * follow the shape but for what was stated. Contacts begin without impulses. Wakes the body and
     * what it touches.
     *
     * <p>A {@link dev.cairn.physics.shape.HeightField} that differs from the present one in its
     * samples and cells only is an edit: it stays where it is placed, contacts keep their impulses,
     * and only bodies that sleep where it differs wake.
     *
     * @param shape the new one; shared, not copied
     * @throws IllegalArgumentException if a dynamic body cannot have it
     * @throws IllegalStateException if the body has several colliders: replace one of these
     */
    public void setShape(Shape shape) {
        table.changes.setShape(changed("setShape"), Checks.notNull("shape", shape));
    }

    /**
     * Gives the body another material: friction, restitution and rolling of all its contacts, and
     * the density, if no mass was stated. Wakes the body and what it touches.
     *
     * @param material the new one
     */
    public void setMaterial(Material material) {
        table.changes.setMaterial(changed("setMaterial"), Checks.notNull("material", material));
    }

    /**
     * States the mass, see {@link Body#mass}; inertia follows unless it was stated. Velocities
     * stay. Wakes the body and what it touches. What holds a body up that becomes lighter holds
     * less, so that it stays where it is. Looks at all contacts.
     *
     * @param kilograms finite, above 0
     */
    public void setMass(double kilograms) {
        table.changes.setMass(changed("setMass"), Checks.positive("mass", kilograms));
    }

    /**
     * States the inertia about the centre of mass, see {@link Body#inertia}. Velocities stay. Wakes
     * the body and what it touches.
     *
     * @param xx about the shape's x axis, kg m², finite, above 0
     * @param yy about the shape's y axis, kg m², finite, above 0
     * @param zz about the shape's z axis, kg m², finite, above 0
     */
    public void setInertia(double xx, double yy, double zz) {
        table.changes.setInertia(changed("setInertia"), xx, yy, zz);
    }

    /**
     * States the inertia about the centre of mass, see {@link Body#inertia}.
     *
     * @param principal about the shape's axes, kg m², each finite, above 0
     */
    public void setInertia(Vector3dc principal) {
        Checks.notNull("principal", principal);
        setInertia(principal.x(), principal.y(), principal.z());
    }

    /**
     * States the centre of mass, see {@link Body#centreOfMass}. The frame stays where it is, and
     * each point of the body keeps its velocity. Wakes the body and what it touches. Allocates.
     *
     * @param bodyX in the body's frame, m, finite
     * @param bodyY in the body's frame, m, finite
     * @param bodyZ in the body's frame, m, finite
     */
    public void setCentreOfMass(double bodyX, double bodyY, double bodyZ) {
        table.changes.setCentreOfMass(changed("setCentreOfMass"), bodyX, bodyY, bodyZ);
    }

    /**
     * States the centre of mass, see {@link Body#centreOfMass}.
     *
     * @param body in the body's frame, m, finite
     */
    public void setCentreOfMass(Vector3dc body) {
        Checks.notNull("body", body);
        setCentreOfMass(body.x(), body.y(), body.z());
    }

    /**
     * Says whether the body may fall asleep, see {@link Body#canSleep}; one that may not wakes.
     *
     * @param value false to keep it awake
     */
    public void setCanSleep(boolean value) {
        table.changes.setCanSleep(changed("setCanSleep"), value);
    }

    /**
     * Hangs any object of the user on the body.
     *
     * @param value anything, or {@code null}
     */
    public void setUserData(@Nullable Object value) {
        table.userData[changed("setUserData")] = value;
    }

    /**
     * Puts the shape's frame elsewhere, at once; velocities stay. {@code Pose.jumps} counts it.
     * Allocates.
     *
     * @param x m, finite
     * @param y m, finite
     * @param z m, finite
     * @param rotation unit quaternion worldFromBody, its length within 1e-6 of 1
     */
    public void teleport(double x, double y, double z, Quaterniondc rotation) {
        table.access.teleport(changed("teleport"), x, y, z, Checks.notNull("rotation", rotation));
    }

    /**
     * Wakes the body and all that it hangs together with, at once. Forces, impulses, velocities and
     * teleports do so of themselves, if they change anything.
     */
    public void wake() {
        table.access.wake(changed("wake"));
    }

    /**
     * Puts the body and all that it hangs together with by contacts to sleep at once, whatever they
     * do: their velocities are lost. Nothing happens to a fixed body, or one that sleeps already.
     *
     * @throws IllegalStateException if the world was built with {@code sleeping(false)}
     */
    public void sleep() {
        table.access.sleep(changed("sleep"));
    }

    /**
     * The colliders of the body: most have one. Allocates.
     *
     * @return a new list, in the order in which they were given
     */
    public List<ColliderRef> colliders() {
        return table.collision.list(alive());
    }

    /**
     * The body's contacts in the last step. Allocates; its cost is that of a walk over all
     * contacts.
     *
     * @return their numbers in {@link PhysicsWorld#contacts}, ascending
     */
    public int[] contacts() {
        return table.contactsOf.apply(alive());
    }

    /**
     * Adds a collider to the body; mass, centre and inertia follow, unless they were given. The
     * body's frame stays where it is, and each of its points keeps its velocity.
     *
     * @param collider what it is like; what it does not say is as of the body's first one
     * @return the collider
     * @throws IllegalArgumentException if the body would have no finite mass
     */
    public ColliderRef add(Collider collider) {
        int slot = changed("add");
        return table.collision.add(slot, Checks.notNull("collider", collider));
    }

    /**
     * Changes what the body collides with, all its colliders. Contacts that the new filter refuses
     * end in the next step, and are told as ended; bodies that rested on it wake.
     *
     * @param filter the new one
     */
    public void setFilter(Filter filter) {
        table.collision.setFilters(changed("setFilter"), filter);
    }

    /**
     * Takes the body and its entity out of the world, between steps. Its contacts end with the next
     * step.
     *
     * @throws IllegalStateException while a step runs
     */
    public void remove() {
        table.access.remove(changed("remove"));
    }

    boolean isOf(BodyTable other) {
        return table == other;
    }

    void requireBetweenSteps(String call) {
        changed(call);
    }
}
