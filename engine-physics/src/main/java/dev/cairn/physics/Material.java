package dev.cairn.physics;

import dev.cairn.core.state.StateInput;
import dev.cairn.core.state.StateOutput;
import dev.cairn.physics.collider.Mix;
import dev.cairn.physics.internal.Checks;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * What a body's surface and substance are like. Immutable; any thread.
 *
 * <p>Two materials meet with the friction {@code sqrt(a * b)} and the larger restitution, unless
 * one names another rule (see {@link Mix}), and with the larger rolling arm of the two.
 *
 * <p>Rolling friction is Coulomb's (1785): a contact that is pressed with the force N resists
 * rolling with a torque of up to {@code b N} about axes in the contact plane, b being a length, the
 * arm. A ball or wheel of radius R that rolls freely on a level floor then loses speed at {@code
 * (b/R) g/(1 + I/(m R²))}, comes to rest, and stays at rest on slopes up to {@code tan a = b/R}:
 * b/R is what tables call the coefficient of rolling resistance. Typical arms: steel on steel half
 * a millimetre, elm on lignum vitae 0.8 mm (Coulomb); a car tyre, R 0.3 m, of coefficient 0.01, 3
 * mm. A single point (of a ball, a capsule) also resists a spin about its normal, as an evenly
 * pressed disc of radius b: with a torque of up to {@code 2/3 mu b N}. By default it is 0, as if
 * bodies and floors were perfectly hard: balls roll until something stops them, and a heap of them
 * spreads.
 *
 * @param friction Coulomb coefficient, dimensionless, finite, at least 0
 * @param restitution Newton's coefficient of restitution, 0 (no bounce) to 1 (bounces to its
 *     height)
 * @param density kg/m³, finite, above 0; unused where a body states its mass
 * @param rollingArm arm of rolling friction, m, finite, at least 0
 * @param frictionMix how the friction of two materials becomes one
 * @param restitutionMix how the restitution of two materials becomes one
 * @param surfaceX velocity at which the surface runs along, see {@link #withSurfaceVelocity}; axes
 *     of the body, m/s, finite
 * @param surfaceY the same along y
 * @param surfaceZ the same along z
 */
public record Material(
        double friction,
        double restitution,
        double density,
        double rollingArm,
        Mix frictionMix,
        Mix restitutionMix,
        double surfaceX,
        double surfaceY,
        double surfaceZ) {
    /** Friction 0.6, no bounce, the density of water: what a body is made of if nothing is said. */
    public static final Material DEFAULT = new Material(0.6, 0, 1000);

    /** Dry pine: friction 0.5, restitution 0.2, 600 kg/m³. */
    public static final Material WOOD = new Material(0.5, 0.2, 600);

    /** Clean steel: friction 0.7, restitution 0.3, 7850 kg/m³. */
    public static final Material STEEL = new Material(0.7, 0.3, 7850);

    /** Wet ice: friction 0.03, restitution 0.05, 917 kg/m³. */
    public static final Material ICE = new Material(0.03, 0.05, 917);

    /** Bouncy rubber: friction 1, restitution 0.8, 1100 kg/m³. */
    public static final Material RUBBER = new Material(1, 0.8, 1100);

    /**
     * Checks the values.
     *
     * @throws IllegalArgumentException if a value is out of its range; the message names value and
     *     range
     */
    public Material {
        Checks.atLeastZero("friction", friction);
        Checks.between("restitution", restitution, 0, 1);
        Checks.positive("density", density);
        Checks.atLeastZero("rollingArm", rollingArm);
        Checks.notNull("frictionMix", frictionMix);
        Checks.notNull("restitutionMix", restitutionMix);
        Checks.finite("surfaceVelocity x", surfaceX);
        Checks.finite("surfaceVelocity y", surfaceY);
        Checks.finite("surfaceVelocity z", surfaceZ);
    }

    /**
     * A material that is mixed by the default rules.
     *
     * @param friction Coulomb coefficient, at least 0
     * @param restitution 0 to 1
     * @param density kg/m³, above 0
     * @param rollingArm m, at least 0
     */
    public Material(double friction, double restitution, double density, double rollingArm) {
        this(friction, restitution, density, rollingArm, Mix.DEFAULT, Mix.DEFAULT, 0, 0, 0);
    }

    /**
     * A material without rolling friction.
     *
     * @param friction Coulomb coefficient, at least 0
     * @param restitution 0 to 1
     * @param density kg/m³, above 0
     */
    public Material(double friction, double restitution, double density) {
        this(friction, restitution, density, 0);
    }

    /**
     * This material with another friction.
     *
     * @param value Coulomb coefficient, at least 0
     * @return a new material
     */
    public Material withFriction(double value) {
        return with(value, restitution, density, rollingArm, frictionMix, restitutionMix);
    }

    /**
     * This material with another restitution.
     *
     * @param value 0 to 1
     * @return a new material
     */
    public Material withRestitution(double value) {
        return with(friction, value, density, rollingArm, frictionMix, restitutionMix);
    }

    /**
     * This material with another density.
     *
     * @param value kg/m³, above 0
     * @return a new material
     */
    public Material withDensity(double value) {
        return with(friction, restitution, value, rollingArm, frictionMix, restitutionMix);
    }

    /**
     * This material with another rolling friction.
     *
     * @param value arm, m, at least 0
     * @return a new material
     */
    public Material withRollingArm(double value) {
        return with(friction, restitution, density, value, frictionMix, restitutionMix);
    }

    /**
     * This material with other rules of mixing.
     *
     * @param ofFriction rule of friction
     * @param ofRestitution rule of restitution
     * @return a new material
     */
    public Material withMix(Mix ofFriction, Mix ofRestitution) {
        return with(friction, restitution, density, rollingArm, ofFriction, ofRestitution);
    }

    /** The same surface velocity, anything else. */
    private Material with(double f, double r, double d, double arm, Mix ofF, Mix ofR) {
        return new Material(f, r, d, arm, ofF, ofR, surfaceX, surfaceY, surfaceZ);
    }

    /**
     * This material with a surface that runs along, as a conveyor belt's, while the body stays:
     * what touches it is dragged, by friction, up to this velocity against the body. A dynamic body
     * is pushed the other way. Of the velocity only what is along a contact acts. A {@link
     * Collider#surfaceVelocity} goes before it.
     *
     * @param bodyX axes of the body, m/s, finite
     * @param bodyY axes of the body, m/s, finite
     * @param bodyZ axes of the body, m/s, finite
     * @return a new material
     */
    public Material withSurfaceVelocity(double bodyX, double bodyY, double bodyZ) {
        return new Material(
                friction,
                restitution,
                density,
                rollingArm,
                frictionMix,
                restitutionMix,
                bodyX,
                bodyY,
                bodyZ);
    }

    /**
     * This material with a surface that runs along.
     *
     * @param body axes of the body, m/s, finite
     * @return a new material
     */
    public Material withSurfaceVelocity(Vector3dc body) {
        Checks.notNull("body", body);
        return withSurfaceVelocity(body.x(), body.y(), body.z());
    }

    /**
     * The velocity at which the surface runs along.
     *
     * @param destination receives m/s, axes of the body; 0 for most
     * @return destination
     */
    public Vector3d surfaceVelocity(Vector3d destination) {
        return destination.set(surfaceX, surfaceY, surfaceZ);
    }

    /**
     * The friction of two materials that meet: {@code sqrt(a.friction * b.friction)}, or what the
     * stronger of their rules says.
     *
     * @param a one material
     * @param b the other
     * @return the mixed Coulomb coefficient
     */
    public static double mixFriction(Material a, Material b) {
        int rules = a.frictionMix.strength() | b.frictionMix.strength() << 4;
        return Mix.of(rules, a.friction, b.friction, Math.sqrt(a.friction * b.friction));
    }

    /**
     * The restitution of two materials that meet: the larger one, or what the stronger of their
     * rules says.
     *
     * @param a one material
     * @param b the other
     * @return the mixed coefficient of restitution
     */
    public static double mixRestitution(Material a, Material b) {
        int rules = a.restitutionMix.strength() | b.restitutionMix.strength() << 4;
        double larger = Math.max(a.restitution, b.restitution);
        return Mix.of(rules, a.restitution, b.restitution, larger);
    }

    /**
     * The rolling friction of two materials that meet: the larger arm, which is that of the softer.
     *
     * @param a one material
     * @param b the other
     * @return the mixed arm, m
     */
    public static double mixRollingArm(Material a, Material b) {
        return Math.max(a.rollingArm, b.rollingArm);
    }

    void write(StateOutput out) {
        out.writeDouble(friction);
        out.writeDouble(restitution);
        out.writeDouble(density);
        out.writeDouble(rollingArm);
        out.writeString(frictionMix.name());
        out.writeString(restitutionMix.name());
        out.writeDouble(surfaceX);
        out.writeDouble(surfaceY);
        out.writeDouble(surfaceZ);
    }

    /** What {@link #write} wrote. */
    static Material read(StateInput in) {
        return new Material(
                in.readDouble(),
                in.readDouble(),
                in.readDouble(),
                in.readDouble(),
                Mix.valueOf(in.readString()),
                Mix.valueOf(in.readString()),
                in.readDouble(),
                in.readDouble(),
                in.readDouble());
    }
}
