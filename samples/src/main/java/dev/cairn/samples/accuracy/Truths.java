package dev.cairn.samples.accuracy;

import org.joml.Quaterniond;
import org.joml.Quaterniondc;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** Mathematics of the truths, apart from the engine. Stateless. */
final class Truths {
    private Truths() {}

    /**
     * Complete elliptic integral of the first kind by the arithmetic-geometric mean (Gauss 1799):
     * {@code K(k) = pi / (2 agm(1, sqrt(1 - k²)))}.
     *
     * @param complement {@code 1 - k²}, which keeps its digits near the separatrix
     */
    static double ellipticK(double complement) {
        double a = 1;
        double b = StrictMath.sqrt(complement);
        while (StrictMath.abs(a - b) > 1e-16 * a) {
            double mean = 0.5 * (a + b);
            b = StrictMath.sqrt(a * b);
            if (mean == a) {
                break;
            }
            a = mean;
        }
        return StrictMath.PI / (2 * a);
    }

    /**
     * Period of the body-frame angular velocity of a free body (Landau and Lifshitz, Mechanics, §
     * 37): {@code 4 K(k) / p} with {@code p² = (I3 - I2)(L² - 2 E I1) / (I1 I2 I3)} and {@code 1 -
     * k² = (I3 - I1)(L² - 2 E I2) / ((I3 - I2)(L² - 2 E I1))}; where {@code L² < 2 E I2}, axes 1
     * and 3 change their roles.
     *
     * @param inertia principal moments, the second between the others
     * @param w angular velocity along the principal axes, rad/s
     */
    static double period(double[] inertia, double[] w) {
        double i2 = inertia[1];
        // L² - 2 E I2, summed so that nothing cancels
        double middle =
                inertia[0] * (inertia[0] - i2) * w[0] * w[0]
                        + inertia[2] * (inertia[2] - i2) * w[2] * w[2];
        int first = (middle < 0) == (inertia[0] < inertia[2]) ? 2 : 0;
        double i1 = inertia[first];
        double i3 = inertia[2 - first];
        double low = i2 * (i2 - i1) * w[1] * w[1] + i3 * (i3 - i1) * w[2 - first] * w[2 - first];
        double complement = (i3 - i1) * middle / ((i3 - i2) * low);
        return 4 * ellipticK(complement) / StrictMath.sqrt((i3 - i2) * low / (i1 * i2 * i3));
    }

    /** Angle of the turn between two orientations, rad; exact for small angles. */
    static double angle(Quaterniondc a, Quaterniondc b) {
        Quaterniond d = new Quaterniond(a).conjugate().mul(b);
        double v = StrictMath.sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
        return 2 * StrictMath.atan2(v, StrictMath.abs(d.w));
    }

    /** Orientation after a turn by {@code radians} about a unit axis. */
    static Quaterniond turned(Vector3dc axis, double radians) {
        double s = StrictMath.sin(0.5 * radians);
        return new Quaterniond(
                axis.x() * s, axis.y() * s, axis.z() * s, StrictMath.cos(0.5 * radians));
    }

    /** World angular momentum R I R^T w of a body with principal moments along its own axes. */
    static Vector3d momentum(double[] inertia, Quaterniondc q, Vector3dc w) {
        Vector3d body = q.transformInverse(w, new Vector3d());
        body.mul(inertia[0], inertia[1], inertia[2]);
        return q.transform(body);
    }

    /** Rotational energy of such a body. */
    static double energy(double[] inertia, Quaterniondc q, Vector3dc w) {
        Vector3d body = q.transformInverse(w, new Vector3d());
        return 0.5
                * (inertia[0] * body.x * body.x
                        + inertia[1] * body.y * body.y
                        + inertia[2] * body.z * body.z);
    }
}
