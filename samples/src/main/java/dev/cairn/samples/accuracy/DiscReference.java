package dev.cairn.samples.accuracy;

/**
 * A disc of unit radius's worth of rim speed that slides and spins on a plane under even pressure
 * and Coulomb friction: friction's force and torque by quadrature over the disc, motion by
 * Runge-Kutta steps of 0.1 ms. Lengths in radii.
 */
final class DiscReference {
    private static final int RINGS = 24;
    private static final int SECTORS = 48;
    private static final double STEP = 1e-4;

    /** Friction's deceleration of a block, mu g, m/s². */
    private final double deceleration;

    private double slide;
    private double rim;
    private double force;
    private double torque;

    /**
     * @param slide speed of the centre, m/s
     * @param rim speed of the rim about the centre, r w, m/s
     * @param deceleration mu g, m/s²
     */
    DiscReference(double slide, double rim, double deceleration) {
        this.slide = slide;
        this.rim = rim;
        this.deceleration = deceleration;
    }

    void advance(double seconds) {
        int steps = (int) StrictMath.ceil(seconds / STEP);
        double h = seconds / steps;
        for (int n = 0; n < steps && slide > 0; n++) {
            // midpoint rule; v' = -mu g f, (r w)' = -2 mu g t, since I = m r²/2
            average(slide, rim);
            double middleSlide = slide - 0.5 * h * deceleration * force;
            double middleRim = rim - h * deceleration * torque;
            average(middleSlide, middleRim);
            slide = Math.max(0, slide - h * deceleration * force);
            rim = Math.max(0, rim - 2 * h * deceleration * torque);
        }
    }

    /** Means over the disc of the slip's direction along v, and of its moment. */
    private void average(double v, double u) {
        force = 0;
        torque = 0;
        for (int i = 0; i < RINGS; i++) {
            // rings of equal area
            double r = StrictMath.sqrt((i + 0.5) / RINGS);
            for (int k = 0; k < SECTORS; k++) {
                double a = 2 * StrictMath.PI * (k + 0.5) / SECTORS;
                double x = r * StrictMath.cos(a);
                double z = r * StrictMath.sin(a);
                double sx = v - u * z;
                double sz = u * x;
                double s = StrictMath.sqrt(sx * sx + sz * sz);
                if (s > 0) {
                    force += sx / s;
                    torque += (x * sz - z * sx) / s;
                }
            }
        }
        force /= RINGS * SECTORS;
        torque /= RINGS * SECTORS;
    }

    double slide() {
        return slide;
    }

    double rim() {
        return rim;
    }
}
