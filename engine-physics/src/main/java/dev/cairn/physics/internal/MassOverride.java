package dev.cairn.physics.internal;

/**
 * What of a body's mass the user gives instead of what follows from its shapes; NaN where nothing
 * is given. Immutable.
 *
 * @param kilograms mass, kg
 * @param xx inertia about the body's axes through the centre of mass, kg m²; given with the other
 *     entries
 * @param yy the same about y
 * @param zz the same about z
 * @param xy off-diagonal entry of the tensor, minus the integral of x y, kg m²
 * @param xz the same of x z
 * @param yz the same of y z
 * @param x centre of mass in the body's frame, m; given with y and z
 * @param y the same
 * @param z the same
 */
public record MassOverride(
        double kilograms,
        double xx,
        double yy,
        double zz,
        double xy,
        double xz,
        double yz,
        double x,
        double y,
        double z) {
    private static final double NO = Double.NaN;

    /** All follows from the shapes. */
    public static final MassOverride NONE = new MassOverride(NO, NO, NO, NO, 0, 0, 0, NO, NO, NO);

    /**
     * The same with a mass.
     *
     * @param value kg
     * @return a copy
     */
    public MassOverride withMass(double value) {
        return new MassOverride(value, xx, yy, zz, xy, xz, yz, x, y, z);
    }

    /**
     * The same with an inertia.
     *
     * @param aboutX kg m²
     * @param aboutY kg m²
     * @param aboutZ kg m²
     * @return a copy
     */
    public MassOverride withInertia(double aboutX, double aboutY, double aboutZ) {
        return new MassOverride(kilograms, aboutX, aboutY, aboutZ, 0, 0, 0, x, y, z);
    }

    /**
     * The same with a centre.
     *
     * @param bodyX m
     * @param bodyY m
     * @param bodyZ m
     * @return a copy
     */
    public MassOverride withCentre(double bodyX, double bodyY, double bodyZ) {
        return new MassOverride(kilograms, xx, yy, zz, xy, xz, yz, bodyX, bodyY, bodyZ);
    }

    /**
     * The same inertia with entries off the diagonal.
     *
     * @param newXy kg m²
     * @param newXz kg m²
     * @param newYz kg m²
     * @return a copy
     */
    public MassOverride withProducts(double newXy, double newXz, double newYz) {
        return new MassOverride(kilograms, xx, yy, zz, newXy, newXz, newYz, x, y, z);
    }

    /**
     * Whether there is a mass.
     *
     * @return false where it follows from volume and density
     */
    public boolean hasMass() {
        return !Double.isNaN(kilograms);
    }

    /**
     * Whether there is an inertia.
     *
     * @return false where it follows from shapes and mass
     */
    public boolean hasInertia() {
        return !Double.isNaN(xx);
    }

    /**
     * Whether there is a centre.
     *
     * @return false where it is that of the shapes
     */
    public boolean hasCentre() {
        return !Double.isNaN(x);
    }
}
