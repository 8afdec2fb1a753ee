package dev.cairn.physics.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.solver.body.FreeRotation;
import dev.cairn.physics.solver.body.PrincipalAxes;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

import java.util.Arrays;
import java.util.Random;

/** Free rotation against a Runge-Kutta reference, its constants, and speeds without measure. */
class FreeRotationTest {
    private static final long SEED = 20261122;

    private final BodyStore bodies = new BodyStore();
    private final PrincipalAxes axes = new PrincipalAxes();
    private final double[] w = new double[3];

    /** A body whose principal axes are turned by {@code frame} against its own. */
    private void body(double[] moments, Quaterniond frame, Quaterniond orientation, Vector3d spin) {
        bodies.ensureCapacity(1);
        axes.ensureCapacity(1);
        double[] m = new double[9];
        for (int k = 0; k < 3; k++) {
            Vector3d e = new Vector3d(k == 0 ? 1 : 0, k == 1 ? 1 : 0, k == 2 ? 1 : 0);
            frame.transform(e);
            for (int r = 0; r < 3; r++) {
                for (int c = 0; c < 3; c++) {
                    m[3 * r + c] += moments[k] * e.get(r) * e.get(c);
                }
            }
        }
        bodies.inertiaXX[0] = m[0];
        bodies.inertiaXY[0] = m[1];
        bodies.inertiaXZ[0] = m[2];
        bodies.inertiaYY[0] = m[4];
        bodies.inertiaYZ[0] = m[5];
        bodies.inertiaZZ[0] = m[8];
        bodies.orientationX[0] = orientation.x;
        bodies.orientationY[0] = orientation.y;
        bodies.orientationZ[0] = orientation.z;
        bodies.orientationW[0] = orientation.w;
        axes.update(bodies, 0);
        w[0] = spin.x;
        w[1] = spin.y;
        w[2] = spin.z;
    }

    private Quaterniond orientation() {
        return new Quaterniond(
                bodies.orientationX[0],
                bodies.orientationY[0],
                bodies.orientationZ[0],
                bodies.orientationW[0]);
    }

    private Vector3d momentum() {
        Vector3d b = orientation().conjugate().transform(new Vector3d(w[0], w[1], w[2]));
        Vector3d l =
                new Vector3d(
                        bodies.inertiaXX[0] * b.x
                                + bodies.inertiaXY[0] * b.y
                                + bodies.inertiaXZ[0] * b.z,
                        bodies.inertiaXY[0] * b.x
                                + bodies.inertiaYY[0] * b.y
                                + bodies.inertiaYZ[0] * b.z,
                        bodies.inertiaXZ[0] * b.x
                                + bodies.inertiaYZ[0] * b.y
                                + bodies.inertiaZZ[0] * b.z);
        return orientation().transform(l);
    }

    private double energy() {
        return 0.5 * momentum().dot(w[0], w[1], w[2]);
    }

    private static Quaterniond turned(Random random) {
        return new Quaterniond(
                        random.nextGaussian(),
                        random.nextGaussian(),
                        random.nextGaussian(),
                        random.nextGaussian())
                .normalize();
    }

    /** Attitude after a second by the classical Runge-Kutta method, in principal axes. */
    private static Quaterniond reference(double[] moments, Quaterniond start, Vector3d spin) {
        int steps = 20000;
        double h = 1.0 / steps;
        double[] s = {start.x, start.y, start.z, start.w, 0, 0, 0};
        Vector3d b = new Quaterniond(start).conjugate().transform(new Vector3d(spin));
        s[4] = b.x;
        s[5] = b.y;
        s[6] = b.z;
        for (int n = 0; n < steps; n++) {
            double[] k1 = rate(moments, s);
            double[] k2 = rate(moments, plus(s, 0.5 * h, k1));
            double[] k3 = rate(moments, plus(s, 0.5 * h, k2));
            double[] k4 = rate(moments, plus(s, h, k3));
            for (int i = 0; i < 7; i++) {
                s[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
            }
        }
        return new Quaterniond(s[0], s[1], s[2], s[3]).normalize();
    }

    private static double[] plus(double[] s, double h, double[] k) {
        double[] r = s.clone();
        for (int i = 0; i < 7; i++) {
            r[i] += h * k[i];
        }
        return r;
    }

    private static double[] rate(double[] i, double[] s) {
        double x = s[4];
        double y = s[5];
        double z = s[6];
        return new double[] {
            0.5 * (s[3] * x + s[1] * z - s[2] * y),
            0.5 * (s[3] * y + s[2] * x - s[0] * z),
            0.5 * (s[3] * z + s[0] * y - s[1] * x),
            -0.5 * (s[0] * x + s[1] * y + s[2] * z),
            (i[1] - i[2]) * y * z / i[0],
            (i[2] - i[0]) * z * x / i[1],
            (i[0] - i[1]) * x * y / i[2]
        };
    }

    private static double angle(Quaterniond a, Quaterniond b) {
        Quaterniond d = new Quaterniond(a).conjugate().mul(b);
        return 2 * Math.sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
    }

    private double error(double[] moments, Random random, int steps) {
        Quaterniond frame = turned(random);
        Quaterniond start = turned(random);
        Vector3d spin =
                new Vector3d(random.nextGaussian(), random.nextGaussian(), random.nextGaussian())
                        .mul(2);
        body(moments, frame, start, spin);
        Quaterniond truth = reference(moments, new Quaterniond(start).mul(frame), spin);
        FreeRotation.turn(bodies, 0, axes.data, w, 0, 1.0 / steps, steps);
        return angle(truth, orientation().mul(frame));
    }

    @Test
    void threeMomentsAreOfTheSixthOrder() {
        System.out.println("seed " + SEED);
        Random random = new Random(SEED);
        for (int n = 0; n < 10; n++) {
            double[] moments = {1, 1.2 + 0.6 * random.nextDouble(), 0};
            moments[2] = moments[1] + 0.9 * random.nextDouble();
            long seed = random.nextLong();
            double coarse = error(moments, new Random(seed), 24);
            double fine = error(moments, new Random(seed), 48);
            double slope = StrictMath.log(coarse / fine) / StrictMath.log(2);
            assertTrue(slope > 5.8, n + ": errors " + coarse + ", " + fine + ", order " + slope);
        }
    }

    @Test
    void twoEqualMomentsAreExactInOneStep() {
        System.out.println("seed " + SEED);
        Random random = new Random(SEED);
        double[][] all = {{1, 1, 0.3}, {1, 1.9, 1}, {1.9, 1, 1}, {2, 2, 3.999}};
        for (double[] moments : all) {
            // the reference's own error is some 1e-13
            assertEquals(0, error(moments, random, 1), 1e-11, Arrays.toString(moments));
        }
    }

    @Test
    void momentumAndEnergyStayAtAnySpeed() {
        System.out.println("seed " + SEED);
        Random random = new Random(SEED);
        for (double speed = 1e-8; speed < 1e7; speed *= 10) {
            for (double[] moments :
                    new double[][] {
                        {1, 2, 2.9}, {1, 1, 1.5}, {1e-3, 1, 1.0005}, {1e-8, 1, 1 + 5e-9}
                    }) {
                Vector3d spin =
                        new Vector3d(
                                random.nextGaussian(),
                                random.nextGaussian(),
                                random.nextGaussian());
                body(moments, turned(random), turned(random), spin.normalize(speed));
                Vector3d l = momentum();
                double e = energy();
                FreeRotation.turn(bodies, 0, axes.data, w, 0, 1.0 / 240, 240);
                // each step rounds w = I^-1 L anew, with moments 1 : 1e8 at worst
                double bar = moments[0] < 1e-3 ? 1e-8 : 2e-12;
                assertEquals(0, momentum().distance(l) / l.length(), bar, "L at " + speed);
                assertEquals(1, energy() / e, 5 * bar, "E at " + speed + " rad/s");
                assertEquals(1, orientation().lengthSquared(), 1e-14, "norm at " + speed);
            }
        }
    }

    /** Its axis goes round the momentum at L/A, A the moment across, however fast it whirls. */
    @Test
    void aNeedleThatWhirlsTumblesSlowly() {
        double[] moments = {1e-6, 1, 1.0005};
        for (double whirl = 1e5; whirl < 1e10; whirl *= 10) {
            body(moments, new Quaterniond(), new Quaterniond(), new Vector3d(whirl, 0.5, 0.3));
            Vector3d l = momentum();
            Vector3d axis = new Vector3d(1, 0, 0);
            double angle = l.length() / 60 * 0.5 * (1 + 1 / 1.0005);
            new Quaterniond().rotateAxis(angle, new Vector3d(l).normalize()).transform(axis);
            FreeRotation.turn(bodies, 0, axes.data, w, 0, 1.0 / 240, 4);
            Vector3d now = orientation().transform(new Vector3d(1, 0, 0));
            // the moments across differ by 5e-4
            assertEquals(0, now.distance(axis), 1e-3, "at " + whirl + " rad/s");
        }
    }
}
