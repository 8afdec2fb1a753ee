package dev.cairn.physics;

import dev.cairn.physics.collider.Filter;
import dev.cairn.physics.internal.Checks;
import dev.cairn.physics.joint.Jointed;
import dev.cairn.physics.shape.Shape;

import org.joml.Matrix3d;
import org.joml.Quaterniond;
import org.joml.Quaterniondc;
import org.joml.Vector3d;

import java.util.List;

/**
 * A body in a world. All values are in world axes and SI units; positions named so are those of the
 * origin of the frame that the shape was made in, unless a name says centre of mass.
 *
 * <p>Simulation thread only, and not from inside the physics step: a method that changes the body
 * throws {@link IllegalStateException} there, on any thread. Methods that take a destination or
 * primitives do not allocate. Every method but {@link #entity}, {@link #isAlive}, {@link #name} and
 * {@link #toString} throws {@link BodyRemovedException} once the body is gone. Forces and torques
 * add up and act over the whole next step, then are cleared; impulses act at once. On fixed bodies
 * forces and impulses have no effect.
 */
public final class BodyRef implements Jointed {
    private final BodyTable table;
    private final int slot;
    private final long entity;
    private final String name;

    BodyRef(BodyTable table, int slot, long entity, String name) {
        this.table = table;
        this.slot = slot;
        this.entity = entity;
        this.name = name;
    }

    /**
     * The body's ECS entity.
     *
     * @return its id
     */
    @Override
    public long entity() {
        return entity;
    }

    /**
     * The name that the description gave, for messages and tools.
     *
     * @return the name, empty if none was given
     */
    public String name() {
        return name;
    }

    /**
     * Whether the body is still in its world.
     *
     * @return false once it was removed, or its entity deleted, or the world closed
     */
    public boolean isAlive() {
        return table.isAlive(slot, entity);
    }

    /**
     * Whether nothing moves the body: it was made so, or it was quarantined.
     *
     * @return true for infinite mass
     */
    public boolean isFixed() {
        return table.access.isFixed(alive());
    }

    /**
     * The collision shape.
     *
     * @return the shape that the description gave
     */
    public Shape shape() {
        return table.access.shape(alive());
    }

    /**
     * The material.
     *
     * @return the one that the description gave
     */
    public Material material() {
        return table.access.material(alive());
    }

    /**
     * The mass.
     *
     * @return kg; positive infinity for a fixed body
     */
    public double mass() {
        return table.access.mass(alive());
    }

    /**
     * The inverse of the inertia about the centre of mass, in world axes.
     *
     * @param destination receives 1/(kg m²); all 0 for a fixed body
     * @return destination
     */
    public Matrix3d inverseInertia(Matrix3d destination) {
        return table.access.inverseInertia(alive(), Checks.notNull("destination", destination));
    }

    /**
     * Where the origin of the shape's frame is.
     *
     * @return a new vector, m
     */
    public Vector3d position() {
        return position(new Vector3d());
    }

    /**
     * Where the origin of the shape's frame is.
     *
     * @param destination receives m
     * @return destination
     */
    public Vector3d position(Vector3d destination) {
        return table.access.position(alive(), Checks.notNull("destination", destination));
    }

    /**
     * Where the centre of mass is.
     *
     * @param destination receives m
     * @return destination
     */
    public Vector3d centreOfMass(Vector3d destination) {
        return table.access.centreOfMass(alive(), Checks.notNull("destination", destination));
    }

    /**
     * How the body is turned.
     *
     * @return a new unit quaternion, worldFromBody
     */
    public Quaterniond orientation() {
        return orientation(new Quaterniond());
    }

    /**
     * How the body is turned.
     *
     * @param destination receives the unit quaternion worldFromBody
     * @return destination
     */
    public Quaterniond orientation(Quaterniond destination) {
        return table.access.orientation(alive(), Checks.notNull("destination", destination));
    }

    /**
     * The velocity of the centre of mass.
     *
     * @return a new vector, m/s
     */
    public Vector3d velocity() {
        return velocity(new Vector3d());
    }

    /**
     * The velocity of the centre of mass.
     *
     * @param destination receives m/s
     * @return destination
     */
    public Vector3d velocity(Vector3d destination) {
        return table.access.velocity(alive(), Checks.notNull("destination", destination));
    }

    /**
     * The angular velocity.
     *
     * @return a new vector, rad/s
     */
    public Vector3d angularVelocity() {
        return angularVelocity(new Vector3d());
    }

    /**
     * The angular velocity.
     *
     * @param destination receives rad/s
     * @return destination
     */
    public Vector3d angularVelocity(Vector3d destination) {
        return table.access.angularVelocity(alive(), Checks.notNull("destination", destination));
    }

    /**
     * Pushes at the centre of mass during the next step.
     *
     * @param fx N, finite
     * @param fy N, finite
     * @param fz N, finite
     */
    public void applyForce(double fx, double fy, double fz) {
        table.access.applyForce(changed("applyForce"), fx, fy, fz);
    }

    /**
     * Pushes at a point during the next step.
     *
     * @param fx N, finite
     * @param fy N, finite
     * @param fz N, finite
     * @param px point, world, m, finite
     * @param py point, world, m, finite
     * @param pz point, world, m, finite
     */
    public void applyForceAt(double fx, double fy, double fz, double px, double py, double pz) {
        table.access.applyForceAt(changed("applyForceAt"), fx, fy, fz, px, py, pz);
    }

    /**
     * Turns during the next step.
     *
     * @param tx N m, finite
     * @param ty N m, finite
     * @param tz N m, finite
     */
    public void applyTorque(double tx, double ty, double tz) {
        table.access.applyTorque(changed("applyTorque"), tx, ty, tz);
    }

    /**
     * Changes the velocity at once.
     *
     * @param jx impulse at the centre of mass, N s, finite
     * @param jy N s, finite
     * @param jz N s, finite
     */
    public void applyImpulse(double jx, double jy, double jz) {
        table.access.applyImpulse(changed("applyImpulse"), jx, jy, jz);
    }

    /**
     * Changes velocity and angular velocity at once.
     *
     * @param jx impulse, N s, finite
     * @param jy N s, finite
     * @param jz N s, finite
     * @param px point that it acts at, world, m, finite
     * @param py point, world, m, finite
     * @param pz point, world, m, finite
     */
    public void applyImpulseAt(double jx, double jy, double jz, double px, double py, double pz) {
        table.access.applyImpulseAt(changed("applyImpulseAt"), jx, jy, jz, px, py, pz);
    }

    /**
     * Changes the angular velocity at once.
     *
     * @param lx angular impulse, N m s, finite
     * @param ly N m s, finite
     * @param lz N m s, finite
     */
    public void applyAngularImpulse(double lx, double ly, double lz) {
        table.access.applyAngularImpulse(changed("applyAngularImpulse"), lx, ly, lz);
    }

    /**
     * Sets how much of the world's gravity acts on the body, and wakes it.
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
     * Whether the body sleeps: it has come to rest, and costs nothing until something happens to
     * it.
     *
     * @return true between falling asleep and waking; always false for a fixed body
     */
    public boolean isAsleep() {
        return table.access.isAsleep(alive());
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
        return table.view().of(alive());
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
     * Changes whom the body collides with, all its colliders. Contacts that the new filter refuses
     * end in the next step, and are told as ended; who rested on the body wakes.
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

    int slot() {
        return slot;
    }

    boolean isOf(BodyTable other) {
        return table == other;
    }

    /** The slot, for a call that changes the body. */
    private int changed(String call) {
        if (table.isStepping) {
            throw new IllegalStateException(
                    call
                            + " of "
                            + this
                            + " was called while the physics step runs, which reads and writes all"
                            + " bodies; call it between steps, or from a system before or after"
                            + " the physics");
        }
        return alive();
    }

    void requireBetweenSteps(String call) {
        changed(call);
    }

    /** The slot; throws if the body is gone. */
    int alive() {
        if (!table.isAlive(slot, entity)) {
            throw new BodyRemovedException(
                    this
                            + " is no longer in its world; ask isAlive() before you use a body that"
                            + " may be gone");
        }
        return slot;
    }

    @Override
    public String toString() {
        return name.isEmpty() ? "body in slot " + slot : "body '" + name + "' in slot " + slot;
    }
}
