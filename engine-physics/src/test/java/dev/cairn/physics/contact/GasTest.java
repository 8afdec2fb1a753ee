package dev.cairn.physics.contact;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.Material;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.support.Scenes;

import org.joml.Vector3d;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/**
 * A gas of elastic balls between walls: nobody leaves, energy is kept to rounding, and two that
 * have met part. Some balls are fast, some slow, so that a ball meets several others in a tick, and
 * in the tick in which it meets a slow one.
 */
class GasTest {
    private static final int TICKS = 300;
    private static final double RADIUS = 0.2;

    /** Of the exact events. */
    private static final int BALLS = 4;

    @Tag("compiled")
    @Test
    void keepsItsEnergy() {
        long digest = run(1, 1);
        assertEquals(digest, run(2, 4), "workers and lanes");
    }

    private static long run(int workers, int lanes) {
        PhysicsSettings settings =
                PhysicsSettings.DEFAULT
                        .withSleeping(false)
                        .withRestitutionThreshold(0)
                        .withLanes(lanes);
        try (PhysicsWorld world =
                PhysicsWorld.builder()
                        .gravity(0, 0, 0)
                        .settings(settings)
                        .workers(workers)
                        .build()) {
            Material surface = new Material(0, 1, 1000);
            for (int i = 0; i < 6; i++) {
                double[] at = new double[3];
                double[] half = {3.1, 3.1, 3.1};
                at[i / 2] = (i % 2 == 0 ? -1 : 1) * 3.05;
                half[i / 2] = 0.05;
                world.add(
                        Body.fixed()
                                .shape(Box.ofHalfExtents(half[0], half[1], half[2]))
                                .at(at[0], at[1], at[2])
                                .material(surface));
            }
            SplittableRandom random = new SplittableRandom(7);
            List<BodyRef> balls = new ArrayList<>();
            for (int i = 0; i < 125; i++) {
                double fast = 100 * random.nextDouble() * random.nextDouble();
                balls.add(
                        world.add(
                                Body.dynamic()
                                        .shape(Sphere.of(RADIUS))
                                        .mass(1)
                                        .at(i % 5 - 2, i / 5 % 5 - 2, i / 25 - 2)
                                        .velocity(
                                                fast * (2 * random.nextDouble() - 1),
                                                fast * (2 * random.nextDouble() - 1),
                                                fast * (2 * random.nextDouble() - 1))
                                        .material(surface)));
            }
            double start = world.kineticEnergy();
            for (int tick = 0; tick < TICKS; tick++) {
                world.step(Scenes.STEP);
            }
            double energy = world.kineticEnergy() / start - 1;
            assertTrue(Math.abs(energy) < 1e-11, "seed 7, energy is off by " + energy);
            for (BodyRef ball : balls) {
                Vector3d p = ball.position();
                double far = Math.max(Math.abs(p.x), Math.max(Math.abs(p.y), Math.abs(p.z)));
                assertTrue(far < 3 - RADIUS + 1e-9, "seed 7, a ball is at " + p);
            }
            return world.digest();
        }
    }

    /**
     * A fast ball strikes among slow ones, against the exact events of the tick: who meets first is
     * struck first, however slow, and changes whom the others meet.
     */
    @Test
    void impactsComeInTheOrderOfTheirTimes() {
        SplittableRandom random = new SplittableRandom(11);
        int several = 0;
        for (int run = 0; run < 4000; run++) {
            double e = random.nextBoolean() ? 1 : random.nextDouble(0.2, 1);
            double[][] p = new double[BALLS][];
            double[][] v = new double[BALLS][];
            for (int i = 0; i < BALLS; i++) {
                double speed = i == 0 ? random.nextDouble(40, 200) : random.nextDouble(1, 20);
                double[] to = around(random, 0.25);
                double[] way = unit(around(random, 1));
                // it is near the middle at some time of the tick
                double back = RADIUS + random.nextDouble() * speed * Scenes.STEP;
                p[i] = new double[3];
                v[i] = new double[3];
                for (int c = 0; c < 3; c++) {
                    p[i][c] = to[c] - (back + 0.2) * way[c];
                    v[i][c] = speed * way[c];
                }
            }
            try (PhysicsWorld world =
                    PhysicsWorld.builder()
                            .gravity(0, 0, 0)
                            .workers(1)
                            .settings(
                                    PhysicsSettings.DEFAULT
                                            .withSleeping(false)
                                            .withRestitutionThreshold(0))
                            .build()) {
                BodyRef[] balls = new BodyRef[BALLS];
                for (int i = 0; i < BALLS; i++) {
                    balls[i] =
                            world.add(
                                    Body.dynamic()
                                            .shape(Sphere.of(RADIUS))
                                            .mass(1)
                                            .at(p[i][0], p[i][1], p[i][2])
                                            .velocity(v[i][0], v[i][1], v[i][2])
                                            .material(new Material(0, e, 1000)));
                }
                int events = play(p, v, e);
                if (events < 0) {
                    continue;
                }
                several += events > 1 ? 1 : 0;
                world.step(Scenes.STEP);
                for (int i = 0; i < BALLS; i++) {
                    double off = balls[i].velocity().distance(v[i][0], v[i][1], v[i][2]);
                    assertEquals(0, off, 1e-7, "seed 11, run " + run + ", ball " + i);
                }
            }
        }
        assertTrue(several > 1000, "only " + several + " runs with several meetings");
    }

    /**
     * A ball passes over an edge on its way to another ball, which a bullet takes away before: it
     * meets nobody, and the edge does not turn it aside.
     */
    @Test
    void whoMeetsNobodyAfterAllIsNotDeflected() {
        for (double clearance : new double[] {1e-6, 1e-3, 1e-2}) {
            try (PhysicsWorld world =
                    PhysicsWorld.builder()
                            .gravity(0, 0, 0)
                            .workers(1)
                            .settings(
                                    PhysicsSettings.DEFAULT
                                            .withSleeping(false)
                                            .withRestitutionThreshold(0))
                            .build()) {
                BodyRef passes = world.add(ball(-0.3, 0, 0).velocity(20, 0, 0));
                world.add(
                        Body.fixed()
                                .shape(Box.ofHalfExtents(0.05, 0.05, 0.05))
                                .at(0, -RADIUS - clearance - 0.05, 0)
                                .material(new Material(0, 1, 1000)));
                BodyRef taken = world.add(ball(0.425, 0, 0));
                world.add(ball(0.425, 0, -1).velocity(0, 0, 200));
                world.step(Scenes.STEP);
                assertEquals(200, taken.velocity().z, 1e-9);
                assertEquals(new Vector3d(20, 0, 0), passes.velocity());
            }
        }
    }

    private static Body ball(double x, double y, double z) {
        return Body.dynamic()
                .shape(Sphere.of(RADIUS))
                .mass(1)
                .at(x, y, z)
                .material(new Material(0, 1, 1000));
    }

    /**
     * Exact events of equal balls in a tick; their number, or -1 where rounding decides, or the
     * fast ball strikes nobody.
     */
    private static int play(double[][] p, double[][] v, double e) {
        double left = Scenes.STEP;
        boolean isFast = false;
        for (int i = 0; i < BALLS; i++) {
            for (int j = 0; j < i; j++) {
                if (gap(p[i], p[j]) < 1e-3) {
                    return -1;
                }
            }
        }
        for (int events = 0; ; events++) {
            double first = Double.POSITIVE_INFINITY;
            double second = first;
            int a = 0;
            int b = 0;
            for (int i = 0; i < BALLS; i++) {
                for (int j = 0; j < i; j++) {
                    double t = meeting(p[i], v[i], p[j], v[j]);
                    if (t < first) {
                        second = first;
                        first = t;
                        a = i;
                        b = j;
                    } else {
                        second = Math.min(second, t);
                    }
                }
            }
            if (Math.abs(first - left) < 1e-6 || second - first < 1e-6 || events > 20) {
                return -1;
            }
            double t = Math.min(first, left);
            for (int i = 0; i < BALLS; i++) {
                for (int c = 0; c < 3; c++) {
                    p[i][c] += t * v[i][c];
                }
            }
            if (first > left) {
                return isFast ? events : -1;
            }
            isFast |= a == 0 || b == 0;
            left -= first;
            double[] n = unit(minus(p[b], p[a]));
            double closing = dot(minus(v[a], v[b]), n);
            if (closing < 0.1) {
                return -1;
            }
            for (int c = 0; c < 3; c++) {
                v[a][c] -= 0.5 * (1 + e) * closing * n[c];
                v[b][c] += 0.5 * (1 + e) * closing * n[c];
            }
        }
    }

    /** |d + u t| = 2 r, coming nearer. */
    private static double meeting(double[] p, double[] v, double[] q, double[] w) {
        double[] d = minus(p, q);
        double[] u = minus(v, w);
        double b = dot(d, u);
        double c = dot(d, d) - 4 * RADIUS * RADIUS;
        double root = b * b - dot(u, u) * c;
        return b < 0 && root > 0 ? c / (-b + Math.sqrt(root)) : Double.POSITIVE_INFINITY;
    }

    private static double gap(double[] p, double[] q) {
        double[] d = minus(p, q);
        return Math.sqrt(dot(d, d)) - 2 * RADIUS;
    }

    private static double[] around(SplittableRandom random, double far) {
        return new double[] {
            random.nextDouble(-far, far), random.nextDouble(-far, far), random.nextDouble(-far, far)
        };
    }

    private static double[] unit(double[] d) {
        double length = Math.sqrt(dot(d, d));
        return new double[] {d[0] / length, d[1] / length, d[2] / length};
    }

    private static double[] minus(double[] a, double[] b) {
        return new double[] {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }
}
