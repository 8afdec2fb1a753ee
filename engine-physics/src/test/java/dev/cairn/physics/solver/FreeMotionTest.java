package dev.cairn.physics.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.job.Jobs;
import dev.cairn.physics.tuning.Tunable;

import org.junit.jupiter.api.Test;

/** Truths of free motion: catalogue A1 to A4, A6, A7, A8. */
class FreeMotionTest {
    private static final double[] TICKS = {1 / 60.0, 1 / 120.0, 1 / 240.0};

    private static SolverScene space() {
        SolverScene s = new SolverScene();
        s.gy = 0;
        return s;
    }

    private static SolverScene scene(int substeps) {
        SolverScene s =
                new SolverScene(SolverScene.DOUBLES.with(Tunable.SUBSTEPS, substeps), Jobs.of(1));
        s.gy = 0;
        return s;
    }

    @Test
    void aThrownBodyFollowsItsParabola() {
        for (double tick : TICKS) {
            SolverScene s = new SolverScene();
            s.gy = -9.8;
            int b = s.box(10, 0.05, 0.2, 0.45, 0, 0, 0);
            s.velocity(b, -2, 8, 2);
            double worst = 0;
            for (int k = 1; k <= Math.round(10 / tick); k++) {
                s.tick(tick);
                double t = k * tick;
                worst = Math.max(worst, Math.abs(s.bodies.positionX[b] + 2 * t));
                worst = Math.max(worst, Math.abs(s.bodies.positionY[b] - (8 * t - 4.9 * t * t)));
                worst = Math.max(worst, Math.abs(s.bodies.positionZ[b] - 2 * t));
            }
            assertTrue(worst < 1e-12, "tick " + tick + ": off the parabola by " + worst + " m");
        }
    }

    @Test
    void tenKilometresASecondChangeNothingAboutIt() {
        SolverScene s = new SolverScene();
        int b = s.sphere(3, 0.2, 0, 0, 0);
        s.velocity(b, -10000, 7000.123, 8000.77);
        s.bodies.forceX[b] = 12;
        double worst = 0;
        for (int k = 1; k <= 600; k++) {
            s.tick(SolverScene.TICK);
            double t = k / 60.0;
            worst = Math.max(worst, Math.abs(s.bodies.positionX[b] - (-10000 * t + 2 * t * t)));
            worst =
                    Math.max(
                            worst,
                            Math.abs(s.bodies.positionY[b] - (7000.123 * t - 0.5 * 9.81 * t * t)));
            worst = Math.max(worst, Math.abs(s.bodies.positionZ[b] - 8000.77 * t));
        }
        assertTrue(worst < 1e-9, "off the parabola by " + worst + " m");
    }

    @Test
    void aSphereTurnsByRateTimesTime() {
        SolverScene s = space();
        int b = s.sphere(1, 0.1, 0, 0, 0);
        s.spin(b, 30, 0, 40);
        s.run(1);
        double half = StrictMath.IEEEremainder(25, 2 * Math.PI);
        double sign = s.bodies.orientationW[b] * StrictMath.cos(half) > 0 ? 1 : -1;
        assertEquals(StrictMath.cos(half), sign * s.bodies.orientationW[b], 1e-12);
        assertEquals(0.6 * StrictMath.sin(half), sign * s.bodies.orientationX[b], 1e-12);
        assertEquals(0.8 * StrictMath.sin(half), sign * s.bodies.orientationZ[b], 1e-12);
    }

    @Test
    void aSpinAboutAStableAxisKeepsItsRate() {
        SolverScene s = space();
        int b = s.box(10, 0.05, 0.2, 0.45, 0, 0, 0);
        s.spin(b, 0.5, 0, 0);
        s.run(10);
        assertEquals(StrictMath.sin(2.5), s.bodies.orientationX[b], 1e-13);
        assertEquals(StrictMath.cos(2.5), s.bodies.orientationW[b], 1e-13);
    }

    @Test
    void aTumblingBoxKeepsMomentumAndEnergy() {
        SolverScene s = space();
        int b = s.box(10, 0.05, 0.2, 0.45, 0, 0, 0);
        s.spin(b, 0.1, 5, 0.1);
        double[] before = s.spinMomentum(b);
        double energy = s.kinetic(b);
        double size =
                Math.sqrt(before[0] * before[0] + before[1] * before[1] + before[2] * before[2]);
        for (int k = 0; k < 600; k++) {
            s.tick(SolverScene.TICK);
            double[] now = s.spinMomentum(b);
            for (int j = 0; j < 3; j++) {
                assertEquals(before[j], now[j], 1e-12 * size, "angular momentum at tick " + k);
            }
            assertEquals(energy, s.kinetic(b), 1e-12 * energy, "energy at tick " + k);
        }
    }

    @Test
    void dzhanibekovsNutFlipsOnTime() {
        // A4: I = (1, 2, 3), w = (0.01, 10, 0.01): w2 changes sign twice in 5.5061681108 s
        SolverScene s = space();
        int b = s.body(1, 1, 2, 3);
        s.spin(b, 0.01, 10, 0.01);
        double last = 10;
        double lastTime = 0;
        double first = 0;
        int flips = 0;
        double third = 0;
        for (int k = 1; k <= 60 * 20; k++) {
            s.tick(SolverScene.TICK);
            double[] r = s.rotation(b);
            double w2 =
                    r[1] * s.bodies.angularVelocityX[b]
                            + r[4] * s.bodies.angularVelocityY[b]
                            + r[7] * s.bodies.angularVelocityZ[b];
            double t = k * SolverScene.TICK;
            if (w2 * last < 0) {
                flips++;
                double cross = lastTime + (t - lastTime) * last / (last - w2);
                if (flips == 1) {
                    first = cross;
                } else if (flips == 3) {
                    third = cross;
                }
            }
            last = w2;
            lastTime = t;
        }
        assertTrue(flips >= 3, "flips: " + flips);
        assertEquals(5.5061681108, third - first, 0.01);
    }

    @Test
    void theErrorOfTumblingFallsWithTheSixthPowerOfTheStep() {
        double[] truth = tumble(16);
        double coarse = distance(tumble(1), truth);
        double fine = distance(tumble(2), truth);
        double order = StrictMath.log(coarse / fine) / StrictMath.log(2);
        assertTrue(order > 5.8, "order " + order);
        double usual = distance(tumble(4), truth);
        assertTrue(usual < 1e-11, "error at 240 Hz: " + usual);
    }

    private static double[] tumble(int substeps) {
        SolverScene s = scene(substeps);
        int b = s.body(1, 1, 1.5, 2);
        s.spin(b, 1, 2, 3);
        s.run(10);
        return new double[] {
            s.bodies.orientationX[b],
            s.bodies.orientationY[b],
            s.bodies.orientationZ[b],
            s.bodies.orientationW[b]
        };
    }

    private static double distance(double[] p, double[] q) {
        double plus = 0;
        double minus = 0;
        for (int k = 0; k < 4; k++) {
            plus += (p[k] - q[k]) * (p[k] - q[k]);
            minus += (p[k] + q[k]) * (p[k] + q[k]);
        }
        return 2 * Math.sqrt(Math.min(plus, minus));
    }

    @Test
    void aConstantTorqueGivesItsAngularMomentum() {
        SolverScene s = space();
        int b = s.body(1, 1, 2, 3);
        s.bodies.torqueX[b] = 1;
        s.bodies.torqueY[b] = 0.5;
        s.bodies.torqueZ[b] = 0.2;
        s.run(5);
        double[] l = s.spinMomentum(b);
        assertEquals(5, l[0], 1e-12);
        assertEquals(2.5, l[1], 1e-12);
        assertEquals(1, l[2], 1e-12);
    }

    @Test
    void aBodyWithSkewInertiaTumblesLikeItsTurnedTwin() {
        // the same tensor, given in axes turned by 0.7 rad about (1, 2, 3): the motion in the world
        // is the same
        SolverScene s = space();
        int plain = s.body(1, 1, 1.5, 2);
        s.spin(plain, 1, 2, 3);
        int skew = s.body(1, 1, 1.5, 2);
        s.orient(skew, 1, 2, 3, -0.7);
        double[] r = s.rotation(skew);
        // inertia in the skew body's axes: R^T diag R
        double[] d = {1, 1.5, 2};
        double[][] m = new double[3][3];
        double[][] inverse = new double[3][3];
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                for (int k = 0; k < 3; k++) {
                    m[i][j] += r[3 * k + i] * d[k] * r[3 * k + j];
                    inverse[i][j] += r[3 * k + i] / d[k] * r[3 * k + j];
                }
            }
        }
        s.bodies.inertiaXX[skew] = m[0][0];
        s.bodies.inertiaYY[skew] = m[1][1];
        s.bodies.inertiaZZ[skew] = m[2][2];
        s.bodies.inertiaXY[skew] = m[0][1];
        s.bodies.inertiaXZ[skew] = m[0][2];
        s.bodies.inertiaYZ[skew] = m[1][2];
        s.bodies.inverseInertiaXX[skew] = inverse[0][0];
        s.bodies.inverseInertiaYY[skew] = inverse[1][1];
        s.bodies.inverseInertiaZZ[skew] = inverse[2][2];
        s.bodies.inverseInertiaXY[skew] = inverse[0][1];
        s.bodies.inverseInertiaXZ[skew] = inverse[0][2];
        s.bodies.inverseInertiaYZ[skew] = inverse[1][2];
        s.spin(skew, 1, 2, 3);
        double[] before = s.spinMomentum(skew);
        s.run(5);
        double[] after = s.spinMomentum(skew);
        for (int j = 0; j < 3; j++) {
            assertEquals(before[j], after[j], 1e-11);
        }
        // axes may come in another order, so the two splittings differ by their error only
        assertEquals(s.bodies.angularVelocityX[plain], s.bodies.angularVelocityX[skew], 2e-3);
        assertEquals(s.bodies.angularVelocityY[plain], s.bodies.angularVelocityY[skew], 2e-3);
        assertEquals(s.bodies.angularVelocityZ[plain], s.bodies.angularVelocityZ[skew], 2e-3);
    }
}
