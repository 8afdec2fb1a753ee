package dev.cairn.physics;

import dev.cairn.physics.body.BodyRemovedException;
import dev.cairn.physics.body.BodyType;
import dev.cairn.physics.body.Lock;
import dev.cairn.physics.internal.Checks;
import dev.cairn.physics.internal.MassOverride;
import dev.cairn.physics.joint.Jointed;
import dev.cairn.physics.shape.Shape;

import org.joml.Matrix3d;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

/**
 * What can be read of a body in a world; {@link BodyRef} also changes it. All values are in world
 * axes and SI units; positions named so are those of the origin of the frame that the shape was
 * made in, unless a name says centre of mass.
 *
 * <p>Simulation thread. Methods that take a destination do not allocate. Every method but {@link
 * #entity}, {@link #isAlive}, {@link #name} and {@link #toString} throws {@link
 * BodyRemovedException} once the body is gone.
 */
public abstract sealed class BodyState implements Jointed permits BodyRef {
    final BodyTable table;
    private final int slot;
    private final long entity;
    private final String name;

    BodyState(BodyTable table, int slot, long entity, String name) {
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
     * The mass that was stated, instead of that of the shapes.
     *
     * @return kg; NaN if it follows from shapes and densities
     */
    public double statedMass() {
        return table.collision.stated(alive()).kilograms();
    }

    /**
     * The inertia that was stated, instead of that of the shapes, about the shape's axes.
     *
     * @param destination receives kg m²; NaN if it follows from shapes and mass
     * @return destination
     */
    public Vector3d statedInertia(Vector3d destination) {
        MassOverride m = table.collision.stated(alive());
        return Checks.notNull("destination", destination).set(m.xx(), m.yy(), m.zz());
    }

    /**
     * The entries off the diagonal of the inertia that was stated.
     *
     * @param destination receives xy, xz, yz in kg m²; 0 if none were
     * @return destination
     */
    public Vector3d statedProducts(Vector3d destination) {
        MassOverride m = table.collision.stated(alive());
        return Checks.notNull("destination", destination).set(m.xy(), m.xz(), m.yz());
    }

    /**
     * The centre of mass that was stated, instead of that of the shapes.
     *
     * @param destination receives m, in the body's frame; NaN if it follows from the shapes
     * @return destination
     */
    public Vector3d statedCentreOfMass(Vector3d destination) {
        MassOverride m = table.collision.stated(alive());
        return Checks.notNull("destination", destination).set(m.x(), m.y(), m.z());
    }

    /**
     * Whether the body may fall asleep, see {@link Body#canSleep}.
     *
     * @return true for most
     */
    public boolean canSleep() {
        return !table.staysAwake[alive()];
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
     * Whether the body sleeps: it has come to rest, and costs nothing until something happens to
     * it.
     *
     * @return true between falling asleep and waking; always false for a fixed body
     */
    public boolean isAsleep() {
        return table.access.isAsleep(alive());
    }

    /**
     * What moves the body.
     *
     * @return fixed also for one that was quarantined
     */
    public BodyType type() {
        return table.access.type(alive());
    }

    /**
     * The inertia about the centre of mass, in the axes of the shape's frame; of a fixed or
     * kinematic body that of its shape, which has no effect.
     *
     * @param destination receives kg m²
     * @return destination
     */
    public Matrix3d inertia(Matrix3d destination) {
        return table.access.inertia(alive(), Checks.notNull("destination", destination));
    }

    /**
     * How much of the world's gravity acts on the body.
     *
     * @return 1 for most
     */
    public double gravityScale() {
        return table.bodies.gravityScale[alive()];
    }

    /**
     * The rate at which velocity decays.
     *
     * @return 1/s; 0 for most
     */
    public double linearDamping() {
        return table.bodies.linearDamping[alive()];
    }

    /**
     * The rate at which angular momentum decays.
     *
     * @return 1/s; 0 for most
     */
    public double angularDamping() {
        return table.bodies.angularDamping[alive()];
    }

    /**
     * The largest speed of the centre of mass at the end of a tick.
     *
     * @return m/s; infinite for most
     */
    public double speedLimit() {
        return table.bodies.speedLimit[alive()];
    }

    /**
     * The degrees of freedom that the body does not have. Allocates.
     *
     * @return a new array, in the order of {@link Lock}
     */
    public Lock[] locks() {
        return Lock.of(table.bodies.motionFlags[alive()]);
    }

    /**
     * What the user hung on the body.
     *
     * @return the object, or {@code null}
     */
    public @Nullable Object userData() {
        return table.userData[alive()];
    }

    int slot() {
        return slot;
    }

    /** The slot, for a call that changes the body. */
    final int changed(String call) {
        if (!table.world().isSerial()) {
            throw new IllegalStateException(
                    call
                            + " of "
                            + this
                            + " was called where blocks run in parallel, and the result would"
                            + " depend on who comes first; let the system write the component Force"
                            + " or Torque of the entity, record tick.commands(), or make it a"
                            + " WorldSystem that runs before \"physics\"");
        }
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

    final int alive() {
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
