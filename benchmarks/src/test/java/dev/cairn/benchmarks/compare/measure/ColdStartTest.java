package dev.cairn.benchmarks.compare.measure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Map;

/** Figures of a start are those of the ticks that they are made of. */
final class ColdStartTest {
    @Test
    void figuresAreSumsOfTicks() {
        ColdStart start = new ColdStart(100);
        double now = 500;
        for (int tick = 0; tick < 300; tick++) {
            // 40 ms at first, 14 in the second run, 10 in the third
            double took = tick < 100 ? 40 : tick < 200 ? 14 : 10;
            now += took;
            double cpu = (tick + 1) * 0.05;
            start.add(now, took, () -> cpu);
        }
        Map<String, Double> figures = start.figures();
        assertEquals(40, figures.get(ColdStart.FIRST_TICK));
        assertEquals(60 * 0.04, figures.get(ColdStart.SIXTY), 1e-12);
        assertEquals(60 * 0.05, figures.get(ColdStart.SIXTY_CPU), 1e-12);
        assertEquals(100 * 0.04, figures.get(ColdStart.SCENE), 1e-12);
        assertEquals(100 * 0.05, figures.get(ColdStart.SCENE_CPU), 1e-12);
        // 14 is more than 1.3 times 10: from the third run on
        assertEquals(0.5 + 4 + 1.4, figures.get(ColdStart.SETTLED), 1e-12);
    }

    @Test
    void whatWasNotReachedIsNotTold() {
        ColdStart start = new ColdStart(100);
        for (int tick = 0; tick < 59; tick++) {
            start.add(tick, 1, () -> 0);
        }
        assertEquals(List.of(ColdStart.FIRST_TICK), List.copyOf(start.figures().keySet()));
        assertNull(start.figures().get(ColdStart.SETTLED));
    }

    @Test
    void theCurveIsOfMediansOfSpans() {
        ColdStart start = new ColdStart(100);
        double[][] ticks = {{100, 9}, {105, 5}, {109, 1}, {200, 2}, {201, 7}};
        for (double[] tick : ticks) {
            start.add(tick[0], tick[1], () -> 0);
        }
        // two spans: from 100 ms to 110 ms, and from 200 ms on
        assertEquals(List.of(109.0, 5.0, 201.0, 7.0), start.thinned());
    }
}
