package dev.cairn.physics.solver;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.job.Jobs;
import dev.cairn.physics.tuning.Tunable;
import dev.cairn.physics.tuning.Tuning;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** A kind of constraint beside contacts: what it is told, and that it is solved with them. */
final class KindsTest {
    private static final double G = 9.81;

    private static SolverScene scene(Rods rods, int lanes, Jobs jobs) {
        Tuning settings = SolverScene.DOUBLES.with(Tunable.LANES, lanes);
        return new SolverScene(new ContactSolver(settings, rods.kind(lanes)), jobs);
    }

    /** A rod of 1 m, 0.1 rad from the vertical: {@code T = 2 pi sqrt(L/g) (1 + a²/16)}. */
    @Test
    void pendulumKeepsItsTime() {
        Rods rods = new Rods();
        SolverScene s = scene(rods, 1, Jobs.of(1));
        int peg = s.fixed();
        double angle = 0.1;
        int bob = s.sphere(2, 0.1, StrictMath.sin(angle), -StrictMath.cos(angle), 0);
        rods.add(peg, bob, 1);
        double period = 2 * Math.PI / Math.sqrt(G) * (1 + angle * angle / 16);
        int ticks = 0;
        double last = 0;
        double crossed = 0;
        int crossings = 0;
        while (crossings < 9) {
            last = s.bodies.positionX[bob];
            s.tick(SolverScene.TICK);
            ticks++;
            double now = s.bodies.positionX[bob];
            if (last < 0 != now < 0) {
                crossings++;
                crossed = SolverScene.TICK * (ticks - now / (now - last));
            }
            double x = s.bodies.positionX[bob];
            double y = s.bodies.positionY[bob];
            assertEquals(1, Math.sqrt(x * x + y * y), 1e-3, "the rod stretches");
        }
        // a quarter, then eight halves
        assertEquals(4.25 * period, crossed, 0.01 * period);
        assertEquals(2 * G * SolverScene.TICK / 4, Math.abs(rods.impulse[0]), 2e-3, "tension");
    }

    /** Two bodies on a rod, nothing else: momentum and angular momentum stay. */
    @Test
    void whirlsForEver() {
        Rods rods = new Rods();
        SolverScene s = scene(rods, 4, Jobs.of(1));
        s.gy = 0;
        int a = s.sphere(1, 0.1, -1.5, 0, 0);
        int b = s.sphere(3, 0.1, 0.5, 0, 0);
        s.velocity(a, 0, -3, 0);
        s.velocity(b, 0, 1, 0);
        rods.add(a, b, 2);
        for (int tick = 0; tick < 600; tick++) {
            s.tick(SolverScene.TICK);
            assertEquals(0, s.bodies.velocityY[a] + 3 * s.bodies.velocityY[b], 1e-12);
            double x = s.bodies.positionX[b] - s.bodies.positionX[a];
            double y = s.bodies.positionY[b] - s.bodies.positionY[a];
            // as soft as a contact: v²/r of each over the square of its frequency
            assertEquals(2, Math.sqrt(x * x + y * y), 3e-3);
        }
    }

    /** A net of balls with rods on a floor: neither lanes nor workers change a bit. */
    @Tag("compiled")
    @Test
    void sameBits() {
        double[] expected = net(1, 1);
        assertTrue(Double.isFinite(expected[0]));
        for (int lanes : new int[] {1, 4, 8}) {
            for (int workers = 1; workers <= 2; workers++) {
                assertArrayEquals(expected, net(lanes, workers), lanes + ", " + workers);
            }
        }
    }

    /** Some hundred rods, cut into domains, and a ball on a peg of its own. */
    private static double[] net(int lanes, int workers) {
        Rods rods = new Rods();
        try (Jobs jobs = Jobs.of(workers)) {
            SolverScene s = scene(rods, lanes, jobs);
            int floor = s.fixed();
            int n = 24;
            int[] ball = new int[n * n];
            for (int k = 0; k < n * n; k++) {
                ball[k] = s.sphere(1, 0.2, k % n, 0.2 + 0.01 * (k % 7), k / n);
                s.sphereOnPlane(floor, ball[k], 0, 1, 0, 0, 0.5, 0);
                if (k % n > 0) {
                    rods.add(ball[k - 1], ball[k], 1);
                }
                if (k >= n && k % 3 == 0) {
                    rods.add(ball[k], ball[k - n], 1);
                }
            }
            int bob = s.sphere(1, 0.2, 100, -1, 0);
            rods.add(s.fixed(), bob, 100);
            s.velocity(ball[n / 2], 3, 2, 1);
            for (int tick = 0; tick < 40; tick++) {
                s.tick(SolverScene.TICK);
            }
            double[] all = new double[3 * n * n + 3];
            for (int k = 0; k < n * n; k++) {
                all[3 * k] = s.bodies.positionX[ball[k]];
                all[3 * k + 1] = s.bodies.positionY[ball[k]];
                all[3 * k + 2] = s.bodies.positionZ[ball[k]];
            }
            all[3 * n * n] = s.bodies.positionX[bob];
            all[3 * n * n + 1] = s.bodies.positionY[bob];
            return all;
        }
    }
}
