package dev.cairn.physics.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** Truths of impacts: catalogue B2, B4, B5, B7, B9, B10. */
class ImpactTest {
    @Test
    void aBallBouncesToTheSquareOfItsRestitution() {
        for (double e : new double[] {0.5, 0.8, 1}) {
            SolverScene s = new SolverScene();
            int ground = s.fixed();
            int ball = s.sphere(1, 0.1, 0, 1.1, 0);
            s.sphereOnPlane(ground, ball, 0, 1, 0, 0, 0.3, e);
            double start = s.energy();
            double height = 1;
            int wanted = e < 0.6 ? 3 : 5;
            int bounces = 0;
            boolean rising = false;
            for (int k = 0; k < 600 && bounces < wanted; k++) {
                s.tick(SolverScene.TICK);
                assertTrue(
                        s.energy() <= start * (1 + 1e-12), "energy rose at tick " + k + ", e " + e);
                double v = s.bodies.velocityY[ball];
                if (!rising && v > 0) {
                    rising = true;
                    bounces++;
                    height *= e * e;
                    double top = s.bodies.positionY[ball] - 0.1 + v * v / (2 * 9.81);
                    assertEquals(height, top, 1e-10 * height, "bounce " + bounces + ", e " + e);
                } else if (v < 0) {
                    rising = false;
                }
            }
            assertTrue(bounces == wanted, "bounces: " + bounces);
        }
    }

    @Test
    void aBallMeetsTheGroundInTime() {
        // impacts at t0 (1 + 2 sum e^j): after the third, at a time in flight, the path is the
        // analytic one
        SolverScene s = new SolverScene();
        int ground = s.fixed();
        int ball = s.sphere(1, 0.1, 0, 1.1, 0);
        s.sphereOnPlane(ground, ball, 0, 1, 0, 0, 0, 0.9);
        double t0 = Math.sqrt(2 / 9.81);
        double third = t0 * (1 + 2 * 0.9 + 2 * 0.81);
        int ticks = (int) Math.ceil((third + 0.1) * 60);
        for (int k = 0; k < ticks; k++) {
            s.tick(SolverScene.TICK);
        }
        double flown = ticks / 60.0 - third;
        double up = 0.9 * 0.9 * 0.9 * 9.81 * t0;
        assertEquals(
                0.1 + up * flown - 0.5 * 9.81 * flown * flown, s.bodies.positionY[ball], 1e-10);
    }

    @Test
    void aBallComesToRestWhenItsBouncesDo() {
        SolverScene s = new SolverScene();
        int ground = s.fixed();
        int ball = s.sphere(1, 0.1, 0, 1.1, 0);
        s.sphereOnPlane(ground, ball, 0, 1, 0, 0, 0, 0.5);
        s.run(1.5);
        assertEquals(0.1, s.bodies.positionY[ball], 1e-3);
        s.run(8);
        assertEquals(0.1, s.bodies.positionY[ball], 1e-6);
        assertEquals(0, s.bodies.velocityY[ball], 1e-6);
    }

    @Test
    void aFlatCubeBouncesWithoutTurning() {
        for (double start : new double[] {5.5, 5.5003, 7.123}) {
            SolverScene s = new SolverScene();
            int ground = s.fixed();
            int box = s.box(500, 0.5, 0.5, 0.5, 0, start, 0);
            s.boxOnPlane(ground, box, 0, 1, 0, 0, 0.5, 1);
            double energy = s.energy();
            s.run(10);
            assertEquals(energy, s.energy(), 1e-9 * energy, "energy from " + start);
            assertEquals(0, s.bodies.angularVelocityX[box], 1e-9);
        }
    }

    @Test
    void unequalBallsPartByTheLawsOfMomentumAndEnergy() {
        for (double m : new double[] {1, 10, 100, 1000, 1e6}) {
            SolverScene s = new SolverScene();
            s.gy = 0;
            int a = s.sphere(1, 0.1, 0, 0, 0);
            int b = s.sphere(m, 0.1, 0.5, 0, 0);
            s.velocity(a, 1, 0, 0);
            s.sphereOnSphere(a, b, 0.5, 1);
            s.run(1);
            assertEquals((1 - m) / (1 + m), s.bodies.velocityX[a], 1e-13, "light ball, M " + m);
            assertEquals(2 / (1 + m), s.bodies.velocityX[b], 1e-13, "heavy ball, M " + m);
        }
    }

    @Test
    void newtonsCradlePassesTheImpulseOn() {
        for (double gap : new double[] {1e-4, 0}) {
            SolverScene s = new SolverScene();
            s.gy = 0;
            int[] ball = new int[5];
            for (int i = 0; i < 5; i++) {
                ball[i] = s.sphere(1, 0.1, i * (0.2 + gap) + (i == 0 ? -0.1 : 0), 0, 0);
            }
            s.velocity(ball[0], 1, 0, 0);
            for (int i = 0; i < 4; i++) {
                s.sphereOnSphere(ball[i], ball[i + 1], 0, 1);
            }
            s.run(0.5);
            for (int i = 0; i < 4; i++) {
                assertEquals(0, s.bodies.velocityX[ball[i]], 1e-10, "ball " + i + ", gap " + gap);
            }
            assertEquals(1, s.bodies.velocityX[ball[4]], 1e-10, "last ball, gap " + gap);
        }
    }

    @Test
    void anObliqueBallSlidesOrGrips() {
        for (double vt : new double[] {0.1, 0.5, 1, 2, 5}) {
            SolverScene s = new SolverScene();
            s.gy = 0;
            int ground = s.fixed();
            int ball = s.sphere(1, 0.1, 0, 0.2, 0);
            s.velocity(ball, vt, -1, 0);
            s.sphereOnPlane(ground, ball, 0, 1, 0, 0, 0.3, 0.8);
            s.run(0.25);
            double grip = 0.3 * 1.8;
            double after = grip >= 2.0 / 7 * vt ? 5.0 / 7 * vt : vt - grip;
            assertEquals(0.8, s.bodies.velocityY[ball], 1e-10);
            assertEquals(after, s.bodies.velocityX[ball], 1e-10 * vt, "vt " + vt);
            assertEquals(
                    -2.5 * (vt - after) / 0.1,
                    s.bodies.angularVelocityZ[ball],
                    1e-8,
                    "spin, vt " + vt);
        }
    }

    @Test
    void aRodThatFallsOnItsEndTurns() {
        // J = (1 + e) v / (1/m + (L/2 cos th)² / I): the lever is what 1/mA + 1/mB leaves out
        for (double e : new double[] {0.5, 1}) {
            double angle = Math.PI / 6;
            double inertia = 1.0 / 12;
            SolverScene s = new SolverScene();
            s.gy = 0;
            s.margin = 0.2;
            int ground = s.fixed();
            int rod = s.body(1, 1e-3, inertia, inertia);
            s.half.set(rod, new double[] {0.5, 0, 0});
            s.at(rod, 0, 0.5 * StrictMath.sin(angle) + 0.001, 0);
            s.orient(rod, 0, 0, 1, angle);
            s.velocity(rod, 0, -2, 0);
            s.boxOnPlane(ground, rod, 0, 1, 0, 0, 0, e);
            s.tick(1.0 / 240);
            double arm = 0.5 * StrictMath.cos(angle);
            double impulse = (1 + e) * 2 / (1 + arm * arm / inertia);
            assertEquals(-2 + impulse, s.bodies.velocityY[rod], 1e-9, "e " + e);
            assertEquals(-impulse * arm / inertia, s.bodies.angularVelocityZ[rod], 1e-8, "e " + e);
        }
    }
}
