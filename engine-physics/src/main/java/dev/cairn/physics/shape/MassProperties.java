package dev.cairn.physics.shape;

/**
 * Mass, centre of mass and inertia of a solid of uniform density.
 *
 * @param mass kg, positive
 * @param comX centre of mass in the shape frame, m
 * @param comY centre of mass in the shape frame, m
 * @param comZ centre of mass in the shape frame, m
 * @param ixx inertia about the centre of mass in shape axes, kg m²: the integral of (y² + z²)
 * @param iyy the integral of (x² + z²), kg m²
 * @param izz the integral of (x² + y²), kg m²
 * @param ixy off-diagonal entry of the tensor, minus the integral of x y, kg m²
 * @param ixz off-diagonal entry of the tensor, minus the integral of x z, kg m²
 * @param iyz off-diagonal entry of the tensor, minus the integral of y z, kg m²
 */
public record MassProperties(
        double mass,
        double comX,
        double comY,
        double comZ,
        double ixx,
        double iyy,
        double izz,
        double ixy,
        double ixz,
        double iyz) {
    /**
     * Of a body of the same form that is heavier or lighter.
     *
     * @param factor of mass and inertia, positive
     * @return with the same centre
     */
    public MassProperties times(double factor) {
        return new MassProperties(
                factor * mass,
                comX,
                comY,
                comZ,
                factor * ixx,
                factor * iyy,
                factor * izz,
                factor * ixy,
                factor * ixz,
                factor * iyz);
    }
}
