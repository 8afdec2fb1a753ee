package dev.cairn.physics.sweep;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.narrowphase.NarrowPhase;
import dev.cairn.physics.shape.Box;

import org.junit.jupiter.api.Test;

/** A box that spins a hand's breadth above a plane: how long its corner takes to get there. */
class FirstMeetingTest {
    private static final double SECONDS = 1.0 / 60;
    private static final int MOST = 512;

    /** Spinning box at a height, and whether it meets the plane y = 0 within a tick. */
    private static FirstMeeting look(double height, double speed, double spin) {
        FirstMeeting search = new FirstMeeting(new NarrowPhase(), 128, 0x1p-16, MOST);
        Flight box = new Flight();
        box.shape = Box.ofHalfExtents(0.5, 0.5, 0.01);
        box.vy = -speed;
        box.wz = spin;
        box.begin(Math.sqrt(0.5001), false);
        Flight plane = new Flight();
        plane.begin(0, false);
        search.find(plane, box, 0, height, 0, 0, SECONDS, 1e-12, 1);
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
        FirstMeeting search = look(height, 0, 1e6);
        assertTrue(search.isUndecided);
        assertTrue(search.time > 0 && search.time < SECONDS, "at " + search.time + " s");
        // and it is not where it is slow enough to be followed
        FirstMeeting slow = look(height, 0, 100);
        assertFalse(slow.isUndecided);
    }
}
