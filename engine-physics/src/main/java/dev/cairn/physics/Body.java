package dev.cairn.physics;

import dev.cairn.core.ecs.component.Component;
import dev.cairn.physics.body.BodyType;
import dev.cairn.physics.body.BodyVectors;
import dev.cairn.physics.body.Lock;
import dev.cairn.physics.collider.Filter;
import dev.cairn.physics.component.Velocity;
import dev.cairn.physics.internal.Checks;
import dev.cairn.physics.internal.MassOverride;
import dev.cairn.physics.internal.Rotations;
import dev.cairn.physics.shape.MassProperties;
import dev.cairn.physics.shape.Shape;

import org.joml.Quaterniondc;
import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/**
 * The description of a body to be, for {@link PhysicsWorld#add}. A builder that can be used again:
 * the world copies what it says. {@link #at} and {@link #rotation} place the frame that the shape
 * was made in. One thread at a time.
 */
public final class Body implements BodyVectors<Body> {
    final BodyType type;
    @Nullable Shape shape;
    double x;
    double y;
    double z;
    double qx;
    double qy;
    double qz;
    double qw = 1;
    Material material = Material.DEFAULT;
    Filter filter = Filter.ALL;
    MassOverride given = MassOverride.NONE;
    double vx;
    double vy;
    double vz;
    double wx;
    double wy;
    double wz;
    final List<Collider> colliders = new ArrayList<>();
    final List<Record> components = new ArrayList<>();
    String name = "";
    boolean maySleep = true;
    double gravityScale = 1;
    double linearDamping;
    double angularDamping;
    double speedLimit = Double.POSITIVE_INFINITY;
    int locks;

    @Nullable Object userData;

    private Body(BodyType type) {
        this.type = type;
    }

    /**
     * A body that forces and contacts move.
     *
     * @return a new description
     */
    public static Body dynamic() {
        return new Body(BodyType.DYNAMIC);
    }

    /**
     * A body that moves as it is told, by {@link #velocity} or {@link BodyRef#moveTo}: a platform,
     * a lift, a turntable, a hand. It pushes and carries what it touches with the velocity of its
     * surface, and nothing stops it: neither a wall nor what is between it and a wall.
     *
     * @return a new description
     */
    public static Body kinematic() {
        return new Body(BodyType.KINEMATIC);
    }

    /**
     * A body that never moves of itself and that nothing moves.
     *
     * @return a new description
     */
    public static Body fixed() {
        return new Body(BodyType.FIXED);
    }

    /**
     * Sets the collision shape. Required, unless there is a {@link #collider}.
     *
     * @param value the shape; shared, not copied (shapes are immutable)
     * @return this
     */
    public Body shape(Shape value) {
        shape = Checks.notNull("shape", value);
        return this;
    }

    /**
     * Adds a shape with a place, material and filter of its own. A body has what {@link #shape} and
     * all calls of this say, in this order; its mass is that of all together.
     *
     * @param value the collider
     * @return this
     */
    public Body collider(Collider value) {
        colliders.add(Checks.notNull("collider", value));
        return this;
    }

    /** All that the body is made of, with material and filter. */
    List<Collider> parts() {
        List<Collider> parts = new ArrayList<>();
        if (shape != null) {
            parts.add(Collider.of(shape).orElse(material, filter));
        }
        for (Collider collider : colliders) {
            parts.add(collider.orElse(material, filter));
        }
        return parts;
    }

    @Override
    public Body at(double worldX, double worldY, double worldZ) {
        Checks.finite("x", worldX);
        Checks.finite("y", worldY);
        Checks.finite("z", worldZ);
        x = worldX;
        y = worldY;
        z = worldZ;
        return this;
    }

    /**
     * Turns the shape's frame; no rotation by default.
     *
     * @param worldFromBody unit quaternion, its length within 1e-6 of 1; it is normalised, unless
     *     only the last digits of its length differ
     * @return this
     * @throws IllegalArgumentException if it is not finite or not of unit length
     */
    public Body rotation(Quaterniondc worldFromBody) {
        Checks.notNull("rotation", worldFromBody);
        double inverse =
                Rotations.inverseLength(
                        "rotation",
                        worldFromBody.x(),
                        worldFromBody.y(),
                        worldFromBody.z(),
                        worldFromBody.w());
        qx = worldFromBody.x() * inverse;
        qy = worldFromBody.y() * inverse;
        qz = worldFromBody.z() * inverse;
        qw = worldFromBody.w() * inverse;
        return this;
    }

    @Override
    public Body rotationAbout(double axisX, double axisY, double axisZ, double radians) {
        Checks.finite("axisX", axisX);
        Checks.finite("axisY", axisY);
        Checks.finite("axisZ", axisZ);
        Checks.finite("radians", radians);
        double largest = Math.max(Math.abs(axisX), Math.max(Math.abs(axisY), Math.abs(axisZ)));
        if (largest == 0) {
            throw new IllegalArgumentException(
                    "axis is (0, 0, 0); it must have a direction: pass (0, 1, 0) to turn about y");
        }
        double ax = axisX / largest;
        double ay = axisY / largest;
        double az = axisZ / largest;
        double scale = StrictMath.sin(0.5 * radians) / Math.sqrt(ax * ax + ay * ay + az * az);
        qx = ax * scale;
        qy = ay * scale;
        qz = az * scale;
        qw = StrictMath.cos(0.5 * radians);
        return this;
    }

    /**
     * Sets friction, restitution and density; {@link Material#DEFAULT} by default.
     *
     * @param value the material
     * @return this
     */
    public Body material(Material value) {
        material = Checks.notNull("material", value);
        return this;
    }

    /**
     * Says what the body collides with; {@link Filter#ALL} by default.
     *
     * @param value the filter
     * @return this
     */
    public Body filter(Filter value) {
        filter = Checks.notNull("filter", value);
        return this;
    }

    /**
     * States the mass, instead of the material's density times the shape's volume.
     *
     * @param kilograms finite, above 0
     * @return this
     * @throws IllegalArgumentException if it is not; a body that shall not move is a {@link
     *     #fixed()} one
     */
    public Body mass(double kilograms) {
        if (!(kilograms > 0) || kilograms == Double.POSITIVE_INFINITY) {
            throw new IllegalArgumentException(
                    "mass is "
                            + kilograms
                            + " kg; it must be finite and greater than 0. For a body that nothing"
                            + " moves use Body.fixed()");
        }
        given = given.withMass(kilograms);
        return this;
    }

    @Override
    public Body inertia(double xx, double yy, double zz) {
        Checks.inertia(xx, yy, zz);
        given = given.withInertia(xx, yy, zz);
        return this;
    }

    @Override
    public Body centreOfMass(double bodyX, double bodyY, double bodyZ) {
        given =
                given.withCentre(
                        Checks.finite("centre x", bodyX),
                        Checks.finite("centre y", bodyY),
                        Checks.finite("centre z", bodyZ));
        return this;
    }

    /**
     * The same with all entries of the tensor: what the products of inertia are not 0 of.
     *
     * @param xx about the shape's x axis, kg m², finite, above 0
     * @param yy about the shape's y axis
     * @param zz about the shape's z axis
     * @param xy minus the integral of x y, kg m², finite
     * @param xz minus the integral of x z
     * @param yz minus the integral of y z
     * @return this
     * @throws IllegalArgumentException as {@link #inertia(double, double, double)}
     */
    public Body inertia(double xx, double yy, double zz, double xy, double xz, double yz) {
        Checks.inertia(xx, yy, zz);
        Checks.finite("sum of the products of inertia", xy + xz + yz);
        given = given.withInertia(xx, yy, zz).withProducts(xy, xz, yz);
        return this;
    }

    /**
     * States mass, centre of mass and inertia: of a solid that the shapes only come near to, such
     * as {@code Decomposition.massProperties}.
     *
     * @param value in the body's frame
     * @return this
     * @throws IllegalArgumentException as the methods that state one of them
     */
    public Body massProperties(MassProperties value) {
        MassProperties p = Checks.notNull("massProperties", value);
        return mass(p.mass())
                .centreOfMass(p.comX(), p.comY(), p.comZ())
                .inertia(p.ixx(), p.iyy(), p.izz(), p.ixy(), p.ixz(), p.iyz());
    }

    @Override
    public Body velocity(double worldX, double worldY, double worldZ) {
        Checks.finite("vx", worldX);
        Checks.finite("vy", worldY);
        Checks.finite("vz", worldZ);
        vx = worldX;
        vy = worldY;
        vz = worldZ;
        return this;
    }

    @Override
    public Body angularVelocity(double worldX, double worldY, double worldZ) {
        Checks.finite("wx", worldX);
        Checks.finite("wy", worldY);
        Checks.finite("wz", worldZ);
        wx = worldX;
        wy = worldY;
        wz = worldZ;
        return this;
    }

    /**
     * Adds components to the body's entity, beside {@code Pose}, {@link Velocity} and what says
     * that there is a body.
     *
     * @param values components of the user, one of a type
     * @return this
     */
    public Body with(Record... values) {
        Checks.notNull("components", values);
        for (Record value : values) {
            Checks.notNull("component", value);
        }
        components.addAll(List.of(values));
        return this;
    }

    /**
     * Sets how much of the world's gravity acts on the body; 1 by default.
     *
     * @param factor finite; 0 for a body that floats, below 0 for one that rises
     * @return this
     */
    public Body gravityScale(double factor) {
        gravityScale = Checks.finite("gravityScale", factor);
        return this;
    }

    /**
     * Lets velocity and angular momentum decay as {@code exp(-rate t)}, whatever the length of the
     * tick; 0 by default. A body that falls so reaches {@code g / linear}.
     *
     * @param linear rate of the velocity, 1/s, 0 to 1e6
     * @param angular rate of the angular velocity, 1/s, 0 to 1e6
     * @return this
     */
    public Body damping(double linear, double angular) {
        linearDamping = Checks.between("linear damping", linear, 0, 1e6);
        angularDamping = Checks.between("angular damping", angular, 0, 1e6);
        return this;
    }

    /**
     * Limits the speed of the centre of mass at the end of each tick; there is no limit by default.
     *
     * @param metresPerSecond above 0; infinite for none
     * @return this
     */
    public Body speedLimit(double metresPerSecond) {
        speedLimit = Checks.limit("speedLimit", metresPerSecond);
        return this;
    }

    /**
     * Takes degrees of freedom from the body; none by default. See {@link Lock} for what a contact
     * does with a locked body.
     *
     * @param values the ones to take; they replace those of an earlier call
     * @return this
     */
    public Body lock(Lock... values) {
        locks = Lock.bits(values);
        return this;
    }

    /**
     * Says whether the body may fall asleep once it has come to rest; true by default. One that may
     * not keeps awake what it touches.
     *
     * @param value false to keep the body awake
     * @return this
     */
    public Body canSleep(boolean value) {
        maySleep = value;
        return this;
    }

    /**
     * Hangs any object of the user on the body; {@code null} by default. The physics never looks at
     * it.
     *
     * @param value anything
     * @return this
     */
    public Body userData(@Nullable Object value) {
        userData = value;
        return this;
    }

    /**
     * Names the body for messages and tools; empty by default.
     *
     * @param value any text
     * @return this
     */
    public Body name(String value) {
        name = Checks.notNull("name", value);
        return this;
    }

    /**
     * A change of a body that is there, as a component of an entity of its own: asked for in a
     * step, made when the step ends. So any system changes type, mass, material and whatever else
     * {@link BodyRef} can: {@code tick.commands().spawn(new Body.Change(entity, body ->
     * body.setMass(80)))}. Changes are made in the order of their commands, each by itself, so two
     * systems may change one body. The entity that asked is gone then. What was asked for a body
     * that was deleted in the same step is forgotten with it.
     *
     * @param entity of the body
     * @param change what to do; the step throws what it throws, and changes behind it are made when
     *     the next step ends
     */
    public record Change(long entity, Consumer<BodyRef> change) {
        /** The component key. */
        public static final Component<Change> COMPONENT = Component.of(Change.class);

        /** Refuses null. */
        public Change {
            Checks.notNull("change", change);
        }
    }
}
