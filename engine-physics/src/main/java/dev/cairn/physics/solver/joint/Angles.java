package dev.cairn.physics.solver.joint;

/**
 * The angle of a direction, by arithmetic and square roots alone: the same bits on every machine.
 */
public final class Angles {
    private static final double QUARTER = 0.5 * Math.PI;

    private Angles() {}

    /**
     * Angle of the direction (cos, sin), which need not be of length 1.
     *
     * @return rad, from -pi to pi; 0 for no direction
     */
    public static double of(double sin, double cos) {
        double s = Math.abs(sin);
        double c = Math.abs(cos);
        if (!(s + c > 0)) {
            return 0;
        }
        double a = s <= c ? arc(s / c) : QUARTER - arc(c / s);
        a = cos < 0 ? Math.PI - a : a;
        return sin < 0 ? -a : a;
    }

    /** The difference of two angles, to within half a turn of 0. */
    public static double wrap(double x) {
        return Math.abs(x) > Math.PI ? Math.IEEEremainder(x, 2 * Math.PI) : x;
    }

    /**
     * Arc of a tangent from 0 to 1: halved three times, {@code tan(a/2) = t/(1 + sqrt(1 + t²))}, to
     * below 0.1; then the series, whose next term is below 1e-19.
     */
    private static double arc(double tangent) {
        double t = tangent;
        double scale = 1;
        while (t > 0.1) {
            t = t / (1 + Math.sqrt(1 + t * t));
            scale *= 2;
        }
        double y = t * t;
        double sum = 1 / 17.0;
        for (int k = 15; k >= 1; k -= 2) {
            sum = 1.0 / k - y * sum;
        }
        return scale * t * sum;
    }
}
