package dev.cairn.physics.solver.row;

/**
 * Coefficients of a soft constraint over one sub-step: an implicit spring and damper, written so
 * that mass does not appear.
 *
 * <p>With {@code w = 2 pi hertz, a1 = 2 zeta + h w, a2 = h w a1, a3 = 1/(1 + a2)}: bias rate {@code
 * w/a1}, mass scale {@code a2 a3}, impulse scale {@code a3}. Source: E. Catto, "Soft Constraints",
 * GDC 2011, and his Soft Step solver of 2023.
 */
final class Softness {
    /** 1/s. */
    double biasRate;

    /** Share of the effective mass. */
    double massScale;

    /** Share of the accumulated impulse that leaks. */
    double impulseScale;

    /** Follows a change of stiffness, damping or sub-step. */
    void set(double hertz, double dampingRatio, double h) {
        double w = 2 * Math.PI * hertz;
        double a1 = 2 * dampingRatio + h * w;
        double a2 = h * w * a1;
        double a3 = 1 / (1 + a2);
        biasRate = w / a1;
        massScale = a2 * a3;
        impulseScale = a3;
    }
}
