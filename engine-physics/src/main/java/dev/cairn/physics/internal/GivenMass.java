package dev.cairn.physics.internal;

/**
 * What of a body's mass the user gives instead of what follows from its shapes; NaN where nothing
 * is given. Immutable.
 *
 * @param kilograms mass, kg
 * @param xx inertia about the body's axes through the centre of mass, kg m²; given with yy and zz
 * @param yy the same about y
 * @param zz the same about z
 * @param x centre of mass in the body's frame, m; given with y and z
 * @param y the same
 * @param z the same
 */
public record GivenMass(
        double kilograms, double xx, double yy, double zz, double x, double y, double z) {
    private static final double NO = Double.NaN;

    /** All follows from the shapes. */
    public static final GivenMass NONE = new GivenMass(NO, NO, NO, NO, NO, NO, NO);

    /**
     * The same with a mass.
     *
     * @param value kg
     * @return a copy
     */
    public GivenMass withMass(double value) {
        return new GivenMass(value, xx, yy, zz, x, y, z);
    }

    /**
     * The same with an inertia.
     *
     * @param aboutX kg m²
     * @param aboutY kg m²
     * @param aboutZ kg m²
     * @return a copy
     */
    public GivenMass withInertia(double aboutX, double aboutY, double aboutZ) {
        return new GivenMass(kilograms, aboutX, aboutY, aboutZ, x, y, z);
    }

    /**
     * The same with a centre.
     *
     * @param bodyX m
     * @param bodyY m
     * @param bodyZ m
     * @return a copy
     */
    public GivenMass withCentre(double bodyX, double bodyY, double bodyZ) {
        return new GivenMass(kilograms, xx, yy, zz, bodyX, bodyY, bodyZ);
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
