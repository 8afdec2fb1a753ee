package dev.cairn.samples.sandbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.samples.replay.Act;

import org.junit.jupiter.api.Test;

/** What is remembered of what was done, for how long. */
class DiaryTest {
    private static final int TICKS = 5000;

    private static Diary filled(boolean all) {
        Diary diary = new Diary();
        if (all) {
            diary.keepAll();
        }
        diary.begin(0);
        for (long tick = 1; tick <= TICKS; tick++) {
            diary.add(Act.What.KICK, tick, 0, 1, 0);
            diary.ticked(tick, 7 * tick);
            diary.forgetUpTo(tick - 500);
        }
        return diary;
    }

    @Test
    void aWholeRunIsKeptIfItIsWanted() {
        Diary diary = filled(true);
        for (long tick = 1; tick <= TICKS; tick++) {
            assertTrue(diary.hasSeen(tick), "tick " + tick);
            assertEquals(7 * tick, diary.digest(tick));
            assertEquals(1, diary.before(tick).size(), "tick " + tick);
        }
        // another future: what came after did not happen
        diary.came(2000);
        diary.add(Act.What.KICK, 9, 0, 1, 0);
        diary.ticked(2001, 3);
        assertEquals(3, diary.digest(2001));
        assertEquals(9, diary.before(2001).getFirst().entity());
        assertEquals(0, diary.before(2002).size());
        assertEquals(1, diary.before(2000).size());
    }

    @Test
    void elseTheLastSecondsAreKept() {
        Diary diary = filled(false);
        assertTrue(diary.hasSeen(TICKS));
        assertFalse(diary.hasSeen(1));
        assertEquals(0, diary.before(100).size());
        assertEquals(1, diary.before(TICKS - 400).size());
    }
}
