package dev.cairn.physics.sweep;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.narrowphase.NarrowPhase;
import dev.cairn.physics.shape.Box;

import org.junit.jupiter.api.Test;

import java.util.SplittableRandom;

/** A box that spins a hand's breadth above a plane: how long its corner takes to get there. */
class TimeOfImpactTest {
    private static final double SECONDS = 1.0 / 60;
    private static final int MOST = 512;

    /** Spinning box at a height, and whether it meets the plane y = 0 within a tick. */
    private static TimeOfImpact look(double height, double speed, double spin) {
        TimeOfImpact search = new TimeOfImpact(new NarrowPhase(), 128, 0x1p-16, MOST);
        Flight box = new Flight();
        box.shape = Box.ofHalfExtents(0.5, 0.5, 0.01);
        box.vy = -speed;
        box.wz = spin;
        box.begin(Math.sqrt(0.5001), false);
        Flight plane = new Flight();
        plane.begin(0, false);
        search.of(plane, box, 0, height, 0, 1e-12).find(0, SECONDS, 1);
        return search;
    }

    @Test
    void cornerMeetsThePlane() {
        // lowest point of a turning square: y - (cos a + sin a)/2 = 0
        double spin = 20;
        double meets = look(0.6, 0, spin).time;
        double a = spin * meets;
        assertEquals(0.6, 0.5 * (StrictMath.cos(a) + StrictMath.sin(a)), 1e-11);
    }

    @Test
    void whoTurnsTooOftenIsLeftInTheAir() {
        // the corner passes 0.1 mm above the plane, a million radians a second
        double height = StrictMath.sqrt(0.5) + 1e-4;
        TimeOfImpact search = look(height, 0, 1e6);
        assertTrue(search.isUndecided);
        assertTrue(search.time > 0 && search.time < SECONDS, "at " + search.time + " s");
        // and it is not where it is slow enough to be followed
        TimeOfImpact slow = look(height, 0, 100);
        assertFalse(slow.isUndecided);
    }

    @Test
    void whoIsHeldApartByAnAxisDoesNotMeet() {
        long seed = 20;
        SplittableRandom random = new SplittableRandom(seed);
        int passing = 0;
        int meeting = 0;
        for (int i = 0; i < 4000; i++) {
            TimeOfImpact search = new TimeOfImpact(new NarrowPhase(), 128, 0x1p-16, MOST);
            Flight a = turning(random);
            Flight b = turning(random);
            double[] from = direction(random);
            double far = random.nextDouble(0.6, 1.6);
            double x = far * from[0];
            double y = far * from[1];
            double z = far * from[2];
            double[] n = direction(random);
            for (int k = 0; k < 3; k++) {
                n[k] = from[k] + 0.3 * n[k];
            }
            double s = 1 / Math.sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
            boolean passes =
                    search.of(a, b, x, y, z, 1e-9)
                            .arePassing(SECONDS, s * n[0], s * n[1], s * n[2]);
            boolean meets = search.of(a, b, x, y, z, 0).find(0, SECONDS, 1);
            String which = "seed " + seed + ", run " + i;
            assertFalse(passes && (meets || search.isUndecided), which);
            passing += passes ? 1 : 0;
            meeting += meets ? 1 : 0;
        }
        assertTrue(passing > 1000, "passing " + passing + ", seed " + seed);
        assertTrue(meeting > 1000, "meeting " + meeting + ", seed " + seed);
    }

    /**
     * Who overlaps at the end has met; who is held apart by an axis that turns to there has not.
     */
    @Test
    void whatIsSeenAtTheEndTellsWhatWasBefore() {
        long seed = 21;
        SplittableRandom random = new SplittableRandom(seed);
        int met = 0;
        int apart = 0;
        for (int i = 0; i < 4000; i++) {
            TimeOfImpact search = new TimeOfImpact(new NarrowPhase(), 128, 0x1p-16, MOST);
            Flight a = turning(random);
            Flight b = turning(random);
            double[] n = direction(random);
            double far = random.nextDouble(0.9, 1.6);
            double x = far * n[0];
            double y = far * n[1];
            double z = far * n[2];
            search.of(a, b, x, y, z, 1e-9);
            boolean isApart = search.gap(0) > 0;
            boolean haveMet = search.haveMet(SECONDS, n[0], n[1], n[2]);
            boolean around = !haveMet && search.areHeldApart(n[0], n[1], n[2]);
            boolean meets = search.of(a, b, x, y, z, 0).find(0, SECONDS, 1);
            String which = "seed " + seed + ", run " + i;
            assertFalse(isApart && haveMet && !meets && !search.isUndecided, which + ": met");
            assertFalse(around && (meets || search.isUndecided), which + ": held apart");
            met += isApart && haveMet ? 1 : 0;
            apart += around ? 1 : 0;
        }
        assertTrue(met > 200, "met " + met + ", seed " + seed);
        assertTrue(apart > 1000, "held apart " + apart + ", seed " + seed);
    }

    /** A box of about a metre that turns by up to 2.5 rad a tick, and flies as far. */
    private static Flight turning(SplittableRandom random) {
        Flight f = new Flight();
        double x = random.nextDouble(0.1, 0.5);
        double y = random.nextDouble(0.1, 0.5);
        double z = random.nextDouble(0.1, 0.5);
        f.shape = Box.ofHalfExtents(x, y, z);
        double[] v = direction(random);
        double[] w = direction(random);
        double speed = random.nextDouble(30);
        double spin = random.nextDouble(150);
        f.vx = speed * v[0];
        f.vy = speed * v[1];
        f.vz = speed * v[2];
        f.wx = spin * w[0];
        f.wy = spin * w[1];
        f.wz = spin * w[2];
        f.ay = -random.nextDouble(100);
        double[] axis = direction(random);
        double half = random.nextDouble(Math.PI);
        double s = Math.sin(half);
        f.turned(s * axis[0], s * axis[1], s * axis[2], Math.cos(half));
        f.begin(Math.sqrt(x * x + y * y + z * z), false);
        return f;
    }

    private static double[] direction(SplittableRandom random) {
        double z = random.nextDouble(-1, 1);
        double angle = random.nextDouble(2 * Math.PI);
        double r = Math.sqrt(1 - z * z);
        return new double[] {r * Math.cos(angle), r * Math.sin(angle), z};
    }
}
