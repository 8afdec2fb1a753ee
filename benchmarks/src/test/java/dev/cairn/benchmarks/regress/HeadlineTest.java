package dev.cairn.benchmarks.regress;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.benchmarks.compare.Probe;

import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Map;

/** Verdicts follow the measured noise; figures are read off a curve as they are defined. */
class HeadlineTest {
    private static String verdict(Headline.Figure before, Headline.Figure now) {
        Headline old = new Headline("a", "m", Map.of("f", before));
        return new Headline("b", "m", Map.of("f", now)).against(old).getFirst().verdict();
    }

    private static Headline.Figure cost(double value, double noise) {
        return new Headline.Figure(value, noise, "us", null);
    }

    private static Headline.Figure digest(String digest) {
        return new Headline.Figure(null, 0, "", digest);
    }

    @Test
    void changeWithinThreeTimesTheNoiseIsNone() {
        // hypot(3 %, 4 %) = 5 %: up to 15 % is noise.
        assertEquals("same", verdict(cost(1, 0.03), cost(1.14, 0.04)));
        assertTrue(verdict(cost(1, 0.03), cost(1.16, 0.04)).startsWith("worse by 16.0 %"));
        assertTrue(verdict(cost(1, 0.001), cost(0.9, 0.001)).startsWith("better by 10.0 %"));
        assertEquals("same", verdict(cost(1, 0.0001), cost(1.049, 0.0001)));
    }

    @Test
    void computedFiguresMayNotChangeAtAll() {
        assertTrue(verdict(cost(1e-3, 0), cost(1.01e-3, 0)).startsWith("worse"));
        assertEquals("same", verdict(digest("00ff"), digest("00ff")));
        assertEquals("changed", verdict(digest("00ff"), digest("00fe")));
    }

    @Test
    void costsOfDifferentMachinesAreNotCompared() {
        Headline old = new Headline("a", "m", Map.of("f", cost(1, 0.01)));
        Headline now = new Headline("b", "other", Map.of("f", cost(2, 0.01)));
        assertEquals("other machine", now.against(old).getFirst().verdict());
    }

    @Test
    void figuresAreReadOffTheCurve() {
        List<Probe.Figures> curve =
                List.of(
                        new Probe.Figures(1, 1e-1, List.of(1.0, 1.0, 1.0)),
                        new Probe.Figures(2, 1e-3, List.of(2.0, 2.2, 1.8)),
                        new Probe.Figures(4, 1e-4, List.of(4.0, 4.0, 4.0)),
                        new Probe.Figures(8, Double.NaN, List.of(0.5, 0.5, 0.5)));
        assertEquals(2, Regress.costAt(curve, 1e-2).value());
        assertNull(Regress.costAt(curve, 1e-6).value());
        assertEquals(1e-3, Regress.errorWithin(curve, 3).value());
        // Median deviation of 1.8, 2, 2.2 is 0.2.
        assertEquals(
                1.2533 * 1.4826 * 0.2 / Math.sqrt(3) / 2,
                Regress.noise(List.of(2.0, 2.2, 1.8)),
                1e-12);
    }
}
