package dev.cairn.benchmarks.compare;

import dev.cairn.benchmarks.compare.measure.Case;
import dev.cairn.benchmarks.peer.Engine;

import java.io.IOException;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** What the docs show of a report: one diagram, and a table of a few scenes. */
final class ReadmePart {
    /** Scenes of the table, those that were measured; whether the error is a length in m. */
    private static final List<String> SCENES =
            List.of("large-pyramid", "pyramid", "pile-mixed", "stack-4", "bouncing");

    private static final List<String> DIAGRAMS = List.of("pyramid", "stack-4");

    private final Results results;

    ReadmePart(Results results) {
        this.results = results;
    }

    /** The main diagram as SVG: the pyramid's, or that of the first scene. */
    String picture() throws IOException {
        Case scene = results.scenes().getFirst();
        for (String id : DIAGRAMS.reversed()) {
            scene = results.of(id).isEmpty() ? scene : Case.of(id);
        }
        List<Results.Point> points = results.of(scene.id());
        int workers = points.getFirst().workers();
        return Diagram.svg(
                points.stream().filter(point -> point.workers() == workers).toList(),
                scene.title(),
                scene.error(),
                point -> point.judged().error());
    }

    /** Rows of engines, two columns per scene: default settings, one number of sub-steps. */
    String table() {
        int n = results.usualSubsteps();
        List<Case> scenes =
                results.scenes().stream().filter(one -> SCENES.contains(one.id())).toList();
        scenes = scenes.isEmpty() ? results.scenes() : scenes;
        StringBuilder text = new StringBuilder("| engine |");
        StringBuilder rule = new StringBuilder("|---|");
        for (Case scene : scenes) {
            text.append(" %s: %s | µs per body and tick |".formatted(scene.title(), scene.error()));
            rule.append("---|---|");
        }
        text.append('\n').append(rule).append('\n');
        Map<Engine, List<String>> rows = new EnumMap<>(Engine.class);
        for (Case scene : scenes) {
            List<Results.Point> column = column(scene, n);
            double least = least(column, true);
            double cheapest = least(column, false);
            for (Results.Point point : column) {
                rows.computeIfAbsent(point.engine(), _ -> new ArrayList<>());
            }
            rows.forEach((engine, cells) -> cells.add(cells(engine, column, least, cheapest)));
        }
        rows.forEach((engine, cells) -> {
            text.append("| %s %s |".formatted(engine.title(), engine.version()));
            cells.forEach(text::append);
            text.append('\n');
        });
        return text.append('\n').append(how(n)).append('\n').toString();
    }

    private String how(int n) {
        Map<String, String> machine = results.machine();
        return String.format(
                Locale.ROOT,
                "N = %d sub-steps or what comes closest, one worker, default settings, sleeping"
                    + " off; medians of %s rounds; on %s, %s cores, Java %s. Bold: the least of a"
                    + " column.",
                n,
                rounds(),
                machine.getOrDefault("processor", "?"),
                machine.getOrDefault("cores seen by the JVM", "?"),
                Runtime.version().feature());
    }

    private String rounds() {
        int least = Integer.MAX_VALUE;
        int most = 0;
        for (Results.Point point : results.points()) {
            int count = point.rounds().size();
            most = Math.max(most, count);
            least = count > 0 ? Math.min(least, count) : least;
        }
        return least < most ? least + " to " + most : Integer.toString(most);
    }

    private List<Results.Point> column(Case scene, int n) {
        List<Results.Point> all = results.of(scene.id());
        int workers = all.getFirst().workers();
        return all.stream()
                .filter(point -> point.substeps() == n && point.workers() == workers)
                .filter(point -> !point.best())
                .toList();
    }

    private static double least(List<Results.Point> column, boolean ofErrors) {
        double least = Double.POSITIVE_INFINITY;
        for (Results.Point point : column) {
            Double error = point.judged().error();
            if (point.failure() == null && error != null) {
                least = Math.min(least, ofErrors ? error : point.cpuMicros());
            }
        }
        return least;
    }

    private static String cells(
            Engine engine, List<Results.Point> column, double least, double cheapest) {
        for (Results.Point point : column) {
            if (point.engine() == engine) {
                Double error = point.judged().error();
                if (point.failure() != null || error == null) {
                    return " %s | – |"
                            .formatted(Results.slow(point.judged()) ? "too slow" : "fails");
                }
                return " %s | %s |"
                        .formatted(
                                bold(Html.number(error), error <= least),
                                bold(
                                        Html.number(point.cpuMicros()),
                                        point.cpuMicros() <= cheapest));
            }
        }
        return " – | – |";
    }

    private static String bold(String text, boolean bold) {
        return bold ? "**" + text + "**" : text;
    }
}
