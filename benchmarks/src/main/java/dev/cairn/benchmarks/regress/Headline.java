package dev.cairn.benchmarks.regress;

import dev.cairn.benchmarks.Spread;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;

/**
 * What was measured of one commit, run after run, and the figures that follow from it.
 *
 * @param commit its hash, with a plus sign if files have changed since
 * @param machine processor and JVM, because costs depend on them
 * @param points errors and costs
 * @param digests of the state after some scenes, by scene
 * @param starts figures of a fresh JVM by name, s, one number per run
 */
record Headline(
        String commit,
        String machine,
        List<Point> points,
        Map<String, String> digests,
        Map<String, List<Double>> starts) {
    /** Changes below this are not called a change, however well they are told apart. */
    private static final double LEAST = 0.03;

    /** Runs are enough if chance alone separates them no oftener than once in so many times. */
    private static final double ENOUGH = 100;

    /**
     * A scene with one number of sub-steps.
     *
     * @param subject name of the scene with its parameters
     * @param substeps N
     * @param error of the scene, or null where it fails; the same in every run
     * @param micros CPU time per body and tick, one number per run
     */
    record Point(String subject, int substeps, @Nullable Double error, List<Double> micros) {}

    /**
     * One figure; smaller is better.
     *
     * @param runs a number per run, infinite where it was not reached; one if it is not timed
     * @param unit its unit
     * @param timed whether it depends on a clock
     */
    record Figure(List<Double> runs, String unit, boolean timed) {
        double median() {
            return Spread.median(runs);
        }
    }

    /** A line of the comparison. */
    record Line(String name, String before, String now, String verdict) {}

    /** Returns this with the runs of another measurement of the same commit. */
    Headline with(Headline more) {
        List<Point> merged = new ArrayList<>();
        for (int i = 0; i < points.size(); i++) {
            List<Double> micros = new ArrayList<>(points.get(i).micros());
            micros.addAll(more.points.get(i).micros());
            Point point = points.get(i);
            merged.add(new Point(point.subject(), point.substeps(), point.error(), micros));
        }
        Map<String, List<Double>> began = new TreeMap<>();
        starts.forEach((name, runs) -> {
            List<Double> all = new ArrayList<>(runs);
            all.addAll(more.starts.getOrDefault(name, List.of()));
            began.put(name, all);
        });
        return new Headline(commit, machine, merged, digests, began);
    }

    int runs() {
        return points.isEmpty() ? 0 : points.getFirst().micros().size();
    }

    /** Returns the figures by name. */
    Map<String, Figure> figures(List<Regress.Subject> subjects) {
        Map<String, Figure> figures = new LinkedHashMap<>();
        for (Regress.Subject subject : subjects) {
            List<Point> curve =
                    points.stream().filter(one -> one.subject().equals(subject.name())).toList();
            List<Double> costs = new ArrayList<>();
            List<Double> errors = new ArrayList<>();
            for (int run = 0; run < runs(); run++) {
                costs.add(costAt(curve, run, subject.tolerance()));
                errors.add(errorWithin(curve, run, subject.budgetMicros()));
            }
            figures.put(
                    "%s cost@%.0e".formatted(subject.name(), subject.tolerance()),
                    new Figure(costs, "us", true));
            figures.put(
                    "%s err@%.0fus".formatted(subject.name(), subject.budgetMicros()),
                    new Figure(errors, "", true));
            for (Point point : curve) {
                if (point.substeps() == 4) {
                    double error = point.error() == null ? Double.POSITIVE_INFINITY : point.error();
                    figures.put(
                            subject.name() + " error, N = 4",
                            new Figure(List.of(error), "", false));
                }
            }
        }
        starts.forEach((name, runs) -> figures.put(name, new Figure(runs, "s", true)));
        return figures;
    }

    /** Returns the cheapest cost of a run that reaches an error. */
    static double costAt(List<Point> curve, int run, double tolerance) {
        double best = Double.POSITIVE_INFINITY;
        for (Point point : curve) {
            Double error = point.error();
            if (error != null && error <= tolerance) {
                best = Math.min(best, point.micros().get(run));
            }
        }
        return best;
    }

    /** Returns the smallest error within a cost. */
    static double errorWithin(List<Point> curve, int run, double budget) {
        double best = Double.POSITIVE_INFINITY;
        for (Point point : curve) {
            Double error = point.error();
            if (error != null && point.micros().get(run) <= budget) {
                best = Math.min(best, error);
            }
        }
        return best;
    }

    List<Line> against(Headline earlier, List<Regress.Subject> subjects) {
        List<Line> lines = new ArrayList<>();
        Map<String, Figure> old = earlier.figures(subjects);
        figures(subjects)
                .forEach((name, now) -> {
                    Figure before = old.get(name);
                    lines.add(
                            new Line(
                                    name,
                                    before == null ? "–" : show(before),
                                    show(now),
                                    before == null ? "new" : verdict(before, now, earlier)));
                });
        new TreeMap<>(digests)
                .forEach((scene, digest) -> {
                    String before = earlier.digests.get(scene);
                    lines.add(
                            new Line(
                                    "digest " + scene,
                                    before == null ? "–" : before,
                                    digest,
                                    before == null
                                            ? "new"
                                            : Objects.equals(before, digest) ? "same" : "changed"));
                });
        return lines;
    }

    private String verdict(Figure before, Figure now, Headline earlier) {
        if (!now.timed()) {
            return change(before.median(), now.median(), 1e-9);
        }
        if (!machine.equals(earlier.machine)) {
            return "other machine";
        }
        if (orders(before.runs().size(), now.runs().size()) < ENOUGH) {
            return "too few runs to tell";
        }
        return apart(before.runs(), now.runs()) || apart(now.runs(), before.runs())
                ? change(before.median(), now.median(), LEAST)
                : "same";
    }

    private static boolean apart(List<Double> low, List<Double> high) {
        double most = low.stream().mapToDouble(Double::doubleValue).max().orElseThrow();
        return high.stream().mapToDouble(Double::doubleValue).min().orElseThrow() > most;
    }

    /** In how many orders so many runs of two kinds can come, if they do not differ. */
    private static double orders(int a, int b) {
        double orders = 1;
        for (int i = 1; i <= b; i++) {
            orders *= (a + i) / (double) i;
        }
        return orders;
    }

    private static String change(double before, double now, double least) {
        if (now == before || Math.abs(now - before) <= least * before) {
            return "same";
        }
        if (Double.isInfinite(before) || Double.isInfinite(now)) {
            return now < before ? "better: reached now" : "worse: not reached any more";
        }
        return "%s by %.1f %%"
                .formatted(now < before ? "better" : "worse", 100 * Math.abs(now / before - 1));
    }

    /** The median; of what is timed, with the lowest and highest run. */
    private static String show(Figure figure) {
        double median = figure.median();
        if (Double.isInfinite(median)) {
            return "not reached";
        }
        double low = figure.runs().stream().mapToDouble(Double::doubleValue).min().orElse(median);
        double high = figure.runs().stream().mapToDouble(Double::doubleValue).max().orElse(median);
        String range = low == high ? "" : " (%.3g to %.3g)".formatted(low, high);
        return "%.3g%s%s".formatted(median, figure.unit().isEmpty() ? "" : " ", figure.unit())
                + range;
    }
}
