package dev.cairn.physics.solver.kernel;

/**
 * What an evenly pressed patch can do against sliding and spinning at once.
 *
 * <p>Problem: a disc that slides at v and spins at w is braked in a different direction at every
 * point. Bounded apart, its slide and its spin stop one after the other; really they stop together,
 * with {@code v/(r w) = 0.653}. Let N be the normal impulse, R the patch's radius ({@code 3/2} of
 * the mean distance of its area from its middle), {@code x = |v|, y = R w, e = x/y}. Then
 *
 * <pre>F = mu N x/S,  T = mu N k R y/S,  S² = x² + s y²</pre>
 *
 * where k falls from 2/3 (spin alone) to 1/4 (slide alone) and s from 1 to 1/4. Both follow the one
 * function {@code g(e)}: k = 1/4 + 5/12 g, s = 1/4 + 3/4 g, with {@code 1/g = 1 + e² (1 + 0.97 e² +
 * 2 e⁶)} while the centre of rotation is in the patch, {@code e² < 1.1}, and {@code 8 e² - 2.6}
 * beyond. The ends are exact to second order in e and 1/e; k is right to 1 %.
 *
 * <p>The impulses F, T that would stop everything are scaled back such that the law holds for the
 * velocities after them: with the effective masses M (of both tangents, 2 x 2) and J, and {@code D
 * = S},
 *
 * <pre>
 *   F' = mu N (D M + mu N)^-1 F,      T' = k R² mu N (J D + k R² mu N)^-1 T,
 *   |F'/mu N|² + s (R T/(J D + k R² mu N))² = 1
 * </pre>
 *
 * <p>so F' is opposite to the slip that is left, however the body is turned: a box is harder to
 * move along than across where friction also tips it, and F itself, drawn back to mu N, is along M
 * v. (A box that slid askew was turned aside by up to a tenth of its way.) Slide and spin alone
 * each give a D that is not too large; from the larger of them, Newton's method on one over the
 * root of the left side has the rest in three steps. (From 0 it is as good while R is some
 * centimetres, but where all weight is on one point R is next to 0, and the friction was up to six
 * times what Coulomb allows.) Where the left side is at most 1 at D = 0, the patch sticks.
 *
 * <p>Source: quadrature over the disc; P. D. Weidman and C. P. Malhotra, "On the terminal motion of
 * sliding spinning disks with uniform Coulomb friction", Physica D 233 (2007); own fit.
 */
public final class PatchFriction {
    /** R over the mean distance. */
    public static final double RADIUS = 1.5;

    /** {@code k = FAR + NEAR g}, {@code s = FAR + CLOSE g}. */
    public static final double FAR = 0.25;

    public static final double NEAR = 5.0 / 12;
    public static final double CLOSE = 0.75;

    /** a and b of g. */
    public static final double FOURTH = 0.97;

    public static final double EIGHTH = 2;

    /** e² where the centre of rotation leaves the patch, and g beyond. */
    public static final double TURNING = 1.1;

    public static final double FAST = 8;
    public static final double LESS = 2.6;

    /** Keeps what is 0 from being divided by 0. */
    public static final double LEAST = Double.MIN_NORMAL;

    /** The same for a length or a speed; the inverse is finite. */
    public static final double SHORT = Double.MIN_NORMAL * 100;

    /**
     * Shares of its limits, of the slide squared, up to which a patch surely sticks: inside of the
     * ellipse of {@link #holds}.
     */
    public static final double SURE_SLIDE = 0.75;

    public static final double SURE_SPIN = 0.374;

    public static final int STEPS = 3;

    /**
     * A contact whose friction starts with more than four times what its normals now allow,
     * squared, has the warm start of an impact. What it loses of it pushes the bodies along the
     * normal too, so that the two have to agree anew, as in a contact that begins: else a cluster
     * of boxes gained energy.
     */
    public static final double STALE = 16;

    private PatchFriction() {}

    /**
     * Whether a patch sticks beyond any doubt, of rounding too; most of those at rest do.
     *
     * @param slide square of the impulse that stops the slide
     * @param spin impulse that stops the spin, without its sign
     * @param limit square of mu N
     * @param bound mu N times the mean distance
     */
    public static boolean isStuck(double slide, double spin, double limit, double bound) {
        return slide <= limit * SURE_SLIDE && spin <= bound * SURE_SPIN;
    }

    /**
     * Whether a patch sticks for certain: it does inside of the smallest of the law's ellipses.
     *
     * @param reach mean distance
     */
    public static boolean holds(
            double slide, double spin, double limit, double bound, double reach) {
        double rim = spin / (reach + SHORT);
        return slide <= limit && spin <= bound && 9 * slide + 16 * (rim * rim) <= 9 * limit;
    }

    /**
     * g at the velocities that the impulses stop.
     *
     * @param slide impulse that stops the slide
     * @param spin impulse that stops the spin, without its sign
     * @param reach mean distance
     */
    public static double share(
            double slide, double spin, double reach, double mass, double inertia) {
        // x = |v| / (R w), |v| = F/m, w = T/J, R = RADIUS reach
        double x = slide * (inertia / (mass * (reach + SHORT))) / (spin * RADIUS + LEAST);
        double e = x * x;
        return 1 / (e < TURNING ? 1 + e * (1 + e * (FOURTH + e * e * EIGHTH)) : FAST * e - LESS);
    }

    /**
     * D: the slip that is left, m/s. Squares are taken of ratios up to 1 only: a patch whose weight
     * is on one point is as good as without a radius, and its numbers may be of any size.
     *
     * @param f1 impulse that stops the slide, along the first tangent
     * @param f2 the same, along the second
     * @param across impulse that stops the spin, times R and the root of s
     * @param whole {@code k R² mu N}
     * @param mean half the trace of M
     * @param half half the difference of its diagonal
     * @param skew its entry beside the diagonal
     */
    public static double give(
            double f1,
            double f2,
            double across,
            double whole,
            double mean,
            double half,
            double skew,
            double inertia,
            double limit) {
        double slide = Math.sqrt(f1 * f1 + f2 * f2);
        double stiff = mean + Math.sqrt(half * half + skew * skew);
        // no less than what the slide alone, or the spin alone, would leave
        double give =
                Math.max(
                        Math.max((slide - limit) / stiff, (across - whole) / (inertia + SHORT)), 0);
        for (int i = 0; i < STEPS; i++) {
            double u = 1 / (mean * give + limit);
            double w = 1 / (inertia * (give + SHORT) + whole + LEAST);
            // (D M + mu N)^-1 = u ((1, 0; 0, 1) - (b1, b2; b2, -b1))/(1 - b1² - b2²)
            double b1 = give * u * half;
            double b2 = give * u * skew;
            double one = u / (1 - (b1 * b1 + b2 * b2));
            double p1 = one * ((1 - b1) * f1 - b2 * f2);
            double p2 = one * ((1 + b1) * f2 - b2 * f1);
            double q = across * w;
            // all squares over that of the largest
            double most = Math.max(Math.max(Math.abs(p1), Math.abs(p2)), q);
            double scale = 1 / most;
            p1 *= scale;
            p2 *= scale;
            q *= scale;
            double h = p1 * p1 + p2 * p2 + q * q;
            double y1 = (1 - b1) * p1 - b2 * p2;
            double y2 = (1 + b1) * p2 - b2 * p1;
            double z1 = (mean + half) * p1 + skew * p2;
            double z2 = (mean - half) * p2 + skew * p1;
            double fall = one * (y1 * z1 + y2 * z2) + q * q * (inertia * w);
            give += h * (Math.sqrt(h) * most - 1) / fall;
            give = Math.max(give, 0);
        }
        return give;
    }
}
