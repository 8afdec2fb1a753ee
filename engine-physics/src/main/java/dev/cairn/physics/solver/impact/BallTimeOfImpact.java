package dev.cairn.physics.solver.impact;

/**
 * When two balls meet, whose distance vector is a parabola: the root of {@code |p + v t + a t²/2| =
 * R}, by that without acceleration and Newton's method from there.
 */
final class BallTimeOfImpact {
    /** Three are enough but for paths that graze. */
    private static final int NEWTON_STEPS = 20;

    /** Speed of the distance at the time found, negative. */
    double speed;

    /**
     * Seconds until they meet, which may be a little before 0.
     *
     * @param far R, below the distance now
     * @param h seconds of the sub-step
     * @return NaN if they do not meet within about the sub-step
     */
    double find(
            double px,
            double py,
            double pz,
            double vx,
            double vy,
            double vz,
            double ax,
            double ay,
            double az,
            double far,
            double h) {
        double closing = px * vx + py * vy + pz * vz;
        double length = Math.sqrt(px * px + py * py + pz * pz);
        double vv = vx * vx + vy * vy + vz * vz;
        // |p + v t|² = R²
        double square = closing * closing - vv * (length - far) * (length + far);
        double t = 0;
        if (closing < 0 && square > 0) {
            t = (length - far) * (length + far) / (Math.sqrt(square) - closing);
        } else if (ax == 0 && ay == 0 && az == 0) {
            return Double.NaN;
        }
        speed = 0;
        double last = Double.POSITIVE_INFINITY;
        for (int n = 0; n < NEWTON_STEPS && Math.abs(last) > 1e-16 * h; n++) {
            double x = px + t * (vx + 0.5 * t * ax);
            double y = py + t * (vy + 0.5 * t * ay);
            double z = pz + t * (vz + 0.5 * t * az);
            double r = Math.sqrt(x * x + y * y + z * z);
            speed = (x * (vx + t * ax) + y * (vy + t * ay) + z * (vz + t * az)) / r;
            last = (far - r) / speed;
            if (!(speed < 0) || !(Math.abs(t + last) <= 2 * h)) {
                return Double.NaN;
            }
            t += last;
        }
        return t;
    }
}
