package dev.cairn.benchmarks.regress;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/**
 * The figures of one commit.
 *
 * @param commit its hash, with a plus sign if files have changed since
 * @param machine processor and JVM, because costs depend on them
 * @param figures by name
 */
record Headline(String commit, String machine, Map<String, Figure> figures) {
    private static final double NOISE_MULTIPLE = 3;

    /**
     * Changes below this are not told from noise, however quiet the rounds were: another JVM
     * compiles the same code in another order.
     */
    private static final double LEAST = 0.05;

    /**
     * One figure; smaller is better.
     *
     * @param value the number, or null if it was not reached
     * @param noise its standard error as a share; 0 for what is computed and not timed
     * @param unit its unit
     * @param digest instead of a number, or null
     */
    record Figure(@Nullable Double value, double noise, String unit, @Nullable String digest) {}

    /** A line of the comparison. */
    record Line(String name, String before, String now, String verdict) {}

    List<Line> against(Headline earlier) {
        List<Line> lines = new ArrayList<>();
        figures.forEach((name, now) -> {
            Figure before = earlier.figures.get(name);
            lines.add(
                    new Line(
                            name,
                            before == null ? "–" : show(before),
                            show(now),
                            before == null ? "new" : verdict(before, now, earlier)));
        });
        return lines;
    }

    private String verdict(Figure before, Figure now, Headline earlier) {
        if (now.digest() != null || before.digest() != null) {
            return Objects.equals(now.digest(), before.digest()) ? "same" : "changed";
        }
        Double old = before.value();
        Double value = now.value();
        if (old == null || value == null) {
            return old == null && value == null ? "same" : old == null ? "better" : "worse";
        }
        boolean timed = now.noise() > 0 || before.noise() > 0;
        if (timed && !machine.equals(earlier.machine)) {
            return "other machine";
        }
        double tolerance =
                timed
                        ? Math.max(LEAST, NOISE_MULTIPLE * Math.hypot(before.noise(), now.noise()))
                        : 1e-9;
        double change = value / old - 1;
        if (Math.abs(change) <= tolerance || value.equals(old)) {
            return "same";
        }
        return "%s by %.1f %% (noise %.1f %%)"
                .formatted(
                        change < 0 ? "better" : "worse", 100 * Math.abs(change), 100 * tolerance);
    }

    private static String show(Figure figure) {
        if (figure.digest() != null) {
            return figure.digest();
        }
        return figure.value() == null
                ? "not reached"
                : "%.3g %s".formatted(figure.value(), figure.unit());
    }
}
