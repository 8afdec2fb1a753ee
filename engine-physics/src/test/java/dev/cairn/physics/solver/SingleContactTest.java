package dev.cairn.physics.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.job.Jobs;
import dev.cairn.physics.tuning.Tunable;
import dev.cairn.physics.tuning.Tuning;

import org.junit.jupiter.api.Test;

/** A contact that is alone is swept until it agrees. */
class SingleContactTest {
    private static final double SLOPE = Math.toRadians(20);
    private static final double FRICTION = 0.2;
    private static final double SPEED = 5;

    private static SolverScene scene(int sweeps, double slope, Jobs jobs) {
        Tuning settings = SolverScene.DOUBLES.with(Tunable.LONE_SWEEPS, sweeps);
        SolverScene s = new SolverScene(settings, jobs);
        s.gx = 9.81 * Math.sin(slope);
        s.gy = -9.81 * Math.cos(slope);
        return s;
    }

    private static int box(SolverScene s) {
        int plane = s.fixed();
        int box = s.box(2, 0.5, 0.2, 0.4, 0, 0.2, 0);
        s.boxOnPlane(plane, box, 0, 1, 0, 0, FRICTION, 0);
        return box;
    }

    /** Error of the speed after 1 s of a slide from rest; a = g (sin - mu cos). */
    private static double slide(int sweeps) {
        try (Jobs jobs = Jobs.of(1)) {
            SolverScene s = scene(sweeps, SLOPE, jobs);
            int box = box(s);
            s.run(1);
            double speed = 9.81 * (Math.sin(SLOPE) - FRICTION * Math.cos(SLOPE));
            return Math.abs(s.bodies.velocityX[box] / speed - 1);
        }
    }

    @Test
    void aSlideBeginsWithTheRightFriction() {
        double with = slide(32);
        double without = slide(0);
        assertTrue(with < 1e-12, "relative error of the speed: " + with);
        assertTrue(without > 10 * with, "the sweeps make no difference: " + without);
    }

    /** It stops after v²/(2 mu g), which is inside a sub-step. */
    @Test
    void aSlideEndsAtItsOwnTime() {
        try (Jobs jobs = Jobs.of(1)) {
            SolverScene s = scene(32, 0, jobs);
            int box = box(s);
            s.velocity(box, SPEED, 0, 0);
            s.run(4);
            double way = SPEED * SPEED / (2 * FRICTION * 9.81);
            assertEquals(way, s.bodies.positionX[box], 1e-9 * way);
            assertEquals(0, s.bodies.velocityX[box], 1e-9);
        }
    }

    /** In each tick the reported impulses are what changed the momentum, less gravity. */
    @Test
    void whatTheSweepsDoIsReported() {
        try (Jobs jobs = Jobs.of(1)) {
            SolverScene s = scene(32, SLOPE, jobs);
            int box = box(s);
            s.velocity(box, 0, 0, 1);
            double mass = 1 / s.bodies.inverseMass[box];
            for (int tick = 0; tick < 60; tick++) {
                double vx = s.bodies.velocityX[box];
                double vy = s.bodies.velocityY[box];
                double vz = s.bodies.velocityZ[box];
                s.tick(SolverScene.TICK);
                double pressed = 0;
                for (int p = 0; p < s.contacts.pointCount[0]; p++) {
                    pressed += s.contacts.totalNormalImpulse[p];
                }
                double weight = mass * 9.81 * SolverScene.TICK;
                double dx = mass * (s.bodies.velocityX[box] - vx - s.gx * SolverScene.TICK);
                double dy = mass * (s.bodies.velocityY[box] - vy - s.gy * SolverScene.TICK);
                assertEquals(dy, pressed, 1e-13 * weight, "normal impulse of tick " + tick);
                double dz = mass * (s.bodies.velocityZ[box] - vz);
                String friction = "friction impulse of tick " + tick;
                assertEquals(dx, s.solver.totalFriction(0, 0), 1e-13 * weight, friction);
                assertEquals(dz, s.solver.totalFriction(0, 2), 1e-13 * weight, friction);
            }
        }
    }
}
