package dev.cairn.core.tick;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;

/** Real time is fed in as numbers; powers of two make the expected counts exact. */
class TickLoopTest {

    private static final double STEP = 1.0 / 64.0;

    private int steps;
    private final TickLoop loop = new TickLoop(STEP, () -> steps++);

    /** However real time is cut, the steps are its whole multiples of the step. */
    @Property(tries = 200)
    void stepsAreTheWholeMultiplesOfTheStepHoweverTimeIsCut(
            @ForAll @Size(max = 50) List<@IntRange(max = 128) Integer> pieces) {
        int[] ran = new int[1];
        TickLoop cut = new TickLoop(STEP, () -> ran[0]++);
        long units = 0; // of 1/512 s; a piece is at most the clamp of 1/4 s
        int returned = 0;
        for (int piece : pieces) {
            units += piece;
            returned += cut.advance(piece / 512.0);
            assertEquals(units / 8, ran[0]);
            assertEquals((units % 8) / 8.0, cut.alpha());
        }
        assertEquals(ran[0], returned);
        assertEquals(ran[0], cut.stepCount());
        assertEquals(0.0, cut.droppedSeconds());
    }

    @Test
    void aMinuteAtSixtyHertzIsThreeThousandSixHundredSteps() {
        int[] ran = new int[1];
        TickLoop sixty = new TickLoop(1.0 / 60.0, () -> ran[0]++);
        for (int frame = 0; frame < 3600; frame++) {
            assertEquals(1, sixty.advance(1.0 / 60.0));
        }
        assertEquals(3600, ran[0]);
    }

    @Test
    void theStepGetsItsSize() {
        List<Double> sizes = new ArrayList<>();
        new TickLoop(STEP, (double seconds) -> sizes.add(seconds)).advance(3 * STEP);
        assertEquals(List.of(STEP, STEP, STEP), sizes);
    }

    @Test
    void aStallIsClampedAndCounted() {
        assertEquals(16, loop.advance(1000.0)); // 0.25 s
        assertEquals(999.75, loop.droppedSeconds());
        assertEquals(0, loop.advance(0.0));
        TickLoop wide = new TickLoop(STEP, seconds -> {}, 2.0);
        assertEquals(128, wide.advance(10.0));
        assertEquals(8.0, wide.droppedSeconds());
    }

    @Test
    void timeThatElapsesWhilePausedIsNotMadeUp() {
        loop.advance(1.5 * STEP);
        loop.pause();
        assertTrue(loop.isPaused());
        for (int frame = 0; frame < 10; frame++) {
            assertEquals(0, loop.advance(0.2));
            assertEquals(0.5, loop.alpha());
        }
        loop.resume();
        assertFalse(loop.isPaused());
        assertEquals(0, loop.advance(0.25 * STEP));
        assertEquals(1, loop.advance(0.25 * STEP));
        assertEquals(2, steps);
    }

    @Test
    void eachSingleStepIsOneStep() {
        loop.pause();
        loop.singleStep();
        loop.singleStep();
        assertEquals(2, loop.advance(0.2));
        assertEquals(0, loop.advance(0.2));
        loop.singleStep();
        assertEquals(1, loop.advance(0.0));
        assertEquals(3, steps);
        assertTrue(loop.isPaused());
    }

    @Test
    void aSingleStepOfARunningLoopPausesIt() {
        loop.singleStep();
        assertTrue(loop.isPaused());
        assertEquals(1, loop.advance(0.2));
        assertEquals(0, loop.advance(0.2));
    }

    @Test
    void singleStepsThatDidNotRunAreVoidAfterResume() {
        loop.singleStep();
        loop.resume();
        assertEquals(0, loop.advance(0.0));
        loop.pause();
        assertEquals(0, loop.advance(0.2));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.0, 0.125, 0.25, 1.0, 2.0, 64.0})
    void slowMotionScalesTheNumberOfStepsAndNotTheirSize(double scale) {
        loop.setTimeScale(scale);
        assertEquals(scale, loop.timeScale());
        int ran = 0;
        for (int frame = 0; frame < 64; frame++) {
            ran += loop.advance(STEP);
        }
        assertEquals((int) (64 * scale), ran);
        assertEquals(STEP, loop.stepSeconds());
    }

    @Test
    void aStepMayPauseTheLoopAndTheDueStepsStayDue() {
        TickLoop[] self = new TickLoop[1];
        self[0] =
                new TickLoop(
                        STEP,
                        () -> {
                            if (self[0].stepCount() == 2) {
                                self[0].pause();
                            }
                        });
        assertEquals(2, self[0].advance(5 * STEP));
        assertEquals(0, self[0].advance(5 * STEP));
        self[0].resume();
        assertEquals(3, self[0].advance(0.0));
    }

    @Test
    void alphaStaysBelowOne() {
        loop.advance(Math.nextDown(STEP));
        assertEquals(0, steps);
        assertTrue(loop.alpha() < 1.0 && loop.alpha() > 0.999);
    }

    @Test
    void aStepThatThrowsCountsAndTheOthersStayDue() {
        IllegalStateException broken = new IllegalStateException("broken");
        TickLoop[] self = new TickLoop[1];
        self[0] =
                new TickLoop(
                        STEP,
                        () -> {
                            if (self[0].stepCount() == 2) {
                                throw broken;
                            }
                        });
        assertSame(
                broken, assertThrows(IllegalStateException.class, () -> self[0].advance(5 * STEP)));
        assertEquals(2, self[0].stepCount());
        assertEquals(3, self[0].advance(0.0));
    }

    @Test
    void postedActionsRunInOrderBeforeTheStepAlsoWhilePaused() {
        StringBuilder order = new StringBuilder();
        TickLoop traced = new TickLoop(STEP, () -> order.append('s'));
        traced.post(() -> order.append('a'));
        traced.post(() -> {
            order.append('b');
            traced.post(() -> order.append('c')); // after the next step
        });
        traced.advance(2 * STEP);
        assertEquals("absc" + "s", order.toString());
        traced.pause();
        traced.post(() -> order.append('d'));
        traced.post(traced::resume);
        assertEquals(1, traced.advance(STEP));
        assertEquals("abscsds", order.toString());
    }

    @ParameterizedTest
    @ValueSource(
            doubles = {
                0.0,
                -0.0,
                -1.0,
                Double.NaN,
                Double.POSITIVE_INFINITY,
                Double.NEGATIVE_INFINITY
            })
    void badTimesAreRefusedWithNameAndValue(double seconds) {
        assertRefused("stepSeconds is " + seconds, () -> new TickLoop(seconds, () -> {}));
        assertRefused(
                "maxElapsedSeconds is " + seconds, () -> new TickLoop(STEP, s -> {}, seconds));
        if (seconds != 0.0) {
            assertRefused("elapsedRealSeconds is " + seconds, () -> loop.advance(seconds));
            assertRefused("timeScale is " + seconds, () -> loop.setTimeScale(seconds));
        }
        assertRefused("timeScale is 65.0", () -> loop.setTimeScale(65.0));
        assertEquals(1.0, loop.timeScale());
        assertEquals(0.0, loop.alpha());
        assertEquals(0, steps);
    }

    private static void assertRefused(String part, Runnable call) {
        IllegalArgumentException thrown = assertThrows(IllegalArgumentException.class, call::run);
        assertTrue(thrown.getMessage().contains(part), thrown.getMessage());
    }

    @Test
    void nullActionsAreRefused() {
        assertThrows(NullPointerException.class, () -> new TickLoop(STEP, (Runnable) null));
        assertThrows(NullPointerException.class, () -> loop.post(null));
    }

    @Test
    void advancingAllocatesNothing() {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long id = Thread.currentThread().threadId();
        run(10_000);
        long before = threads.getThreadAllocatedBytes(id);
        long again = threads.getThreadAllocatedBytes(id);
        run(10_000);
        long after = threads.getThreadAllocatedBytes(id);
        assertEquals(again - before, after - again);
        assertEquals(2 * 10_000 * 5 / 4, steps);
    }

    private void run(int frames) {
        for (int frame = 0; frame < frames; frame++) {
            loop.advance(1.25 * STEP);
        }
    }
}
