package dev.cairn.benchmarks.regress;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;

/** Verdicts follow the runs; figures are read off a curve as they are defined. */
class HeadlineTest {
    private static final Regress.Subject SUBJECT = new Regress.Subject("s", Map.of(), 1e-2, 3);
    private static final String COST = "s cost@1e-02";
    private static final String ERROR = "s err@3us";

    /** One point of N = 4 with these costs. */
    private static Headline of(double error, double... micros) {
        return of("m", new Headline.Point("s", 4, error, boxed(micros)));
    }

    private static Headline of(String machine, Headline.Point... points) {
        return new Headline("c", machine, List.of(points), Map.of("d", "00ff"), Map.of());
    }

    private static List<Double> boxed(double... values) {
        return Arrays.stream(values).boxed().toList();
    }

    private static @Nullable String verdict(Headline before, Headline now, String name) {
        for (Headline.Line line : now.against(before, List.of(SUBJECT))) {
            if (line.name().equals(name)) {
                return line.verdict();
            }
        }
        return null;
    }

    @Test
    void aCostHasChangedIfAllRunsAreBeyondAllOthers() {
        Headline before = of(1e-3, 1.0, 1.02, 0.98, 1.01, 0.99);
        assertEquals("same", verdict(before, of(1e-3, 1.5, 1.6, 1.4, 1.5, 1.02), COST));
        assertEquals("worse by 50.0 %", verdict(before, of(1e-3, 1.5, 1.6, 1.4, 1.5, 1.03), COST));
        assertEquals("better by 20.0 %", verdict(before, of(1e-3, 0.8, 0.7, 0.9, 0.8, 0.8), COST));
        // apart, but by less than 3 %
        assertEquals("same", verdict(before, of(1e-3, 1.024, 1.025, 1.026, 1.025, 1.025), COST));
        assertEquals("too few runs to tell", verdict(of(1e-3, 1, 1, 1), of(1e-3, 2, 2, 2), COST));
    }

    @Test
    void alarmsWithoutAChangeAreRare() {
        long seed = 20261122;
        System.out.println("seed " + seed);
        SplittableRandom random = new SplittableRandom(seed);
        int alarms = 0;
        int trials = 3_000;
        for (int trial = 0; trial < trials; trial++) {
            double[][] runs = new double[2][5];
            for (double[] side : runs) {
                // A long tail to the slow side, as a busy machine has it: 20 % of noise.
                Arrays.setAll(side, i -> 1 + 0.2 * -Math.log(random.nextDouble()));
            }
            String verdict = verdict(of(1e-3, runs[0]), of(1e-3, runs[1]), COST);
            alarms += "same".equals(verdict) ? 0 : 1;
        }
        // 2 of 252 orders
        assertEquals(2.0 / 252, alarms / (double) trials, 0.006);
    }

    @Test
    void whatIsComputedMayNotChangeAtAll() {
        Headline before = of(1e-3, 1);
        String name = "s error, N = 4";
        assertEquals("worse by 1.0 %", verdict(before, of(1.01e-3, 1), name));
        assertEquals("same", verdict(before, of(1e-3, 1), name));
        assertEquals("same", verdict(before, of(1e-3, 1), "digest d"));
        Headline other = new Headline("c", "m", before.points(), Map.of("d", "00fe"), Map.of());
        assertEquals("changed", verdict(before, other, "digest d"));
    }

    @Test
    void costsOfDifferentMachinesAreNotCompared() {
        Headline.Point point = new Headline.Point("s", 4, 1e-3, boxed(1, 1, 1, 1, 1));
        assertEquals("other machine", verdict(of("m", point), of("other", point), COST));
    }

    @Test
    void figuresAreReadOffTheCurveRunByRun() {
        Headline headline =
                of(
                        "m",
                        new Headline.Point("s", 1, 1e-1, boxed(1, 1.1)),
                        new Headline.Point("s", 2, 1e-3, boxed(2, 3.2)),
                        new Headline.Point("s", 4, 1e-4, boxed(4, 4.1)),
                        new Headline.Point("s", 8, null, boxed(0.5, 0.5)));
        Map<String, Headline.Figure> figures = headline.figures(List.of(SUBJECT));
        assertEquals(boxed(2, 3.2), runs(figures, COST));
        // The second run finds N = 2 beyond the budget of 3.
        assertEquals(boxed(1e-3, 1e-1), runs(figures, ERROR));
    }

    private static List<Double> runs(Map<String, Headline.Figure> figures, String name) {
        Headline.Figure figure = figures.get(name);
        return figure == null ? List.of() : new ArrayList<>(figure.runs());
    }

    @Test
    void aFigureThatIsNoLongerReachedIsWorse() {
        assertEquals(
                "worse: not reached any more",
                verdict(of(1e-3, 1, 1, 1, 1, 1), of(1e-1, 1, 1, 1, 1, 1), COST));
    }

    @Test
    void runsAddUp() {
        Headline both = of(1e-3, 1, 2).with(of(1e-3, 3));
        assertEquals(3, both.runs());
        assertEquals(boxed(1, 2, 3), both.points().getFirst().micros());
    }

    @Test
    void startsAreFiguresRunByRun() {
        String name = "start s";
        List<Headline> each = new ArrayList<>();
        for (double seconds : new double[] {2.0, 2.2, 2.1, 1.9, 2.0}) {
            each.add(new Headline("c", "m", List.of(), Map.of(), Map.of(name, List.of(seconds))));
        }
        Headline before = each.stream().reduce(Headline::with).orElseThrow();
        assertEquals(boxed(2.0, 2.2, 2.1, 1.9, 2.0), runs(before.figures(List.of(SUBJECT)), name));
        Headline now =
                new Headline(
                        "c", "m", List.of(), Map.of(), Map.of(name, boxed(3, 3.1, 3, 2.9, 3.2)));
        assertEquals("worse by 50.0 %", verdict(before, now, name));
    }
}
