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
 * velocities after them: with effective masses m, J and {@code D = S}, {@code F' = F mu N/(m D + mu
 * N), T' = T k R² mu N/(J D + k R² mu N)}, and one equation, {@code (F/(m D + mu N))² + s (R T/(J D
 * + k R² mu N))² = 1}, is left for {@code D >= 0}. Slide and spin alone each give a D that is not
 * too large; from the larger of them, Newton's method on one over the root of the left side has the
 * rest in three steps. (From 0 it is as good while R is some centimetres, but where all weight is
 * on one point R is next to 0, and the friction was up to six times what Coulomb allows.) Where the
 * left side is at most 1 at D = 0, the patch sticks.
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

    /** Of the mean mass: a mass that slips is no smaller, whatever rounding says. */
    public static final double LIGHT = 1e-6;

    private PatchFriction() {}

    /**
     * The mass of what slips, one for both tangents, so that it is braked along its slip.
     *
     * <p>A box is harder to move along than across where the friction also tips it: {@code K^-1} is
     * not a multiple of 1, and {@code l - K^-1 v}, drawn back to the limit, ends along {@code K^-1
     * v}. A box that slid askew was so turned aside by up to a tenth of its way. With one mass m
     * sweeps end where friction is along v, and they end for {@code m = 2/(k1 + k2)}, k the inverse
     * masses along the axes of K: {@code m = a - b²/a}, a the mean of the diagonal of {@code K^-1}
     * and b² what makes its axes differ.
     *
     * @param k11 of {@code K^-1}, kg
     * @param k12 see {@code k11}
     * @param k22 see {@code k11}
     */
    public static double mass(double k11, double k12, double k22) {
        double mean = 0.5 * (k11 + k22);
        double half = 0.5 * (k11 - k22);
        return Math.max(mean - (half * half + k12 * k12) / mean, LIGHT * mean);
    }

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
     * @param slide impulse that stops the slide
     * @param across impulse that stops the spin, times R and the root of s
     * @param whole {@code k R² mu N}
     */
    public static double give(
            double slide, double across, double whole, double mass, double inertia, double limit) {
        // no less than what the slide alone, or the spin alone, would leave
        double give =
                Math.max(Math.max((slide - limit) / mass, (across - whole) / (inertia + SHORT)), 0);
        for (int i = 0; i < STEPS; i++) {
            double u = 1 / (mass * give + limit);
            double w = 1 / (inertia * (give + SHORT) + whole + LEAST);
            double p = slide * u;
            double q = across * w;
            // (p² + q²) over the square of the larger
            double most = Math.max(p, q);
            double one = 1 / most;
            p *= one;
            q *= one;
            p *= p;
            q *= q;
            double h = p + q;
            give += h * (Math.sqrt(h) * most - 1) / (p * (mass * u) + q * (inertia * w));
            give = Math.max(give, 0);
        }
        return give;
    }
}
