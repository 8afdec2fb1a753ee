package dev.cairn.benchmarks.compare;

import dev.cairn.benchmarks.compare.measure.Case;
import dev.cairn.benchmarks.compare.measure.Protocol;
import dev.cairn.benchmarks.peer.Engine;
import dev.cairn.benchmarks.peer.Peer;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** The report's tables about scenes: all at a glance, a scene's points, its failures. */
final class SceneTables {
    /** Engines whose contact counts differ by more than this share do not do the same work. */
    private static final double DIFFERENT = 0.05;

    private final Results results;

    SceneTables(Results results) {
        this.results = results;
    }

    /** Error and CPU time of all scenes and engines: default settings, one N, first workers. */
    void glance(Html html, List<Case> scenes) {
        int n = results.usualSubsteps();
        List<Engine> engines =
                results.points().stream().map(Results.Point::engine).distinct().sorted().toList();
        html.add(
                "<h2 id=\"glance\">At a glance: N = "
                        + n
                        + ", default settings, one worker</h2>\n");
        html.add(
                "<p>Error above, CPU time in µs per body and tick below; smaller is better in"
                        + " both.");
        html.add(
                " <b>Bold</b>: the smallest of the row. A scene's name leads to its"
                        + " diagram.</p>\n");
        List<String> columns = new ArrayList<>(List.of(" scene", " error of"));
        engines.forEach(engine -> columns.add(engine.title()));
        html.table(columns);
        for (Case scene : scenes) {
            Map<Engine, Results.Point> row = new LinkedHashMap<>();
            int most = 0;
            List<Results.Point> points = results.of(scene.id());
            for (Results.Point point : points) {
                most = point.substeps() <= n ? Math.max(most, point.substeps()) : most;
            }
            int workers = points.getFirst().workers();
            for (Results.Point point : points) {
                if (point.substeps() == most && point.workers() == workers && !point.best()) {
                    row.put(point.engine(), point);
                }
            }
            html.add("<tr><td class=\"text\"><a href=\"#" + scene.id() + "\">").say(scene.title());
            html.add("</a></td>").words(scene.error());
            double least = least(row, true);
            double cheapest = least(row, false);
            for (Engine engine : engines) {
                glance(html, row.get(engine), least, cheapest);
            }
            html.add("</tr>\n");
        }
        html.endTable();
    }

    private static double least(Map<Engine, Results.Point> row, boolean ofErrors) {
        double least = Double.POSITIVE_INFINITY;
        for (Results.Point point : row.values()) {
            Double error = point.judged().error();
            if (point.failure() == null && error != null) {
                least = Math.min(least, ofErrors ? error : point.cpuMicros());
            }
        }
        return least;
    }

    private static void glance(
            Html html, Results.@Nullable Point point, double least, double cheapest) {
        Double error = point == null ? null : point.judged().error();
        if (point == null || point.judged().missing()) {
            html.cell("–");
        } else if (point.failure() != null || error == null) {
            html.add(
                    "<td class=\"failed\">"
                            + (Results.slow(point.judged()) ? "too slow" : "failed"));
            html.add("</td>");
        } else {
            html.add("<td>").add(bold(Html.number(error), error <= least)).add("<br/>");
            html.add(bold(Html.number(point.cpuMicros()), point.cpuMicros() <= cheapest));
            html.add("</td>");
        }
    }

    private static String bold(String text, boolean bold) {
        return bold ? "<b>" + text + "</b>" : text;
    }

    /** What failed, each once, with the numbers of sub-steps. */
    static void failures(Html html, List<Results.Point> points) {
        Map<String, Map<String, List<String>>> failed = new LinkedHashMap<>();
        for (Results.Point point : points) {
            if (point.failure() != null) {
                failed.computeIfAbsent(point.title(), _ -> new LinkedHashMap<>())
                        .computeIfAbsent(point.failure(), _ -> new ArrayList<>())
                        .add(Integer.toString(point.substeps()));
            }
        }
        if (failed.isEmpty()) {
            html.add("<p class=\"note\">No run failed.</p>\n");
            return;
        }
        html.add("<p>Failed:</p>\n<ul class=\"failed\">\n");
        failed.forEach((title, reasons) -> {
            List<String> why = new ArrayList<>();
            reasons.forEach((reason, substeps) ->
                    why.add("N = " + String.join(", ", substeps) + ": " + reason));
            html.add("<li>").say(title + " – " + String.join("; ", why)).add("</li>\n");
        });
        html.add("</ul>\n");
    }

    /** A row per point. */
    static void points(Html html, Case scene, List<Results.Point> points) {
        html.table(
                "points",
                List.of(
                        " engine",
                        "N",
                        scene.error(),
                        "deepest overlap, m",
                        "touching pairs",
                        "contact points",
                        "CPU µs per body and tick",
                        "lowest … highest round",
                        "rounds",
                        "wall ms of a tick, median",
                        "99th percentile"));
        int usual = usualPairs(points);
        for (Results.Point point : points) {
            Protocol.Answer judged = point.judged();
            html.add("<tr><td class=\"text\">")
                    .add(bold(Html.text(point.title()), onFront(point, points)));
            html.add("</td>").cell(Integer.toString(point.substeps()));
            String failure = point.failure();
            if (failure != null) {
                html.add("<td class=\"text failed\" colspan=\"4\">").say(failure).add("</td>");
            } else {
                html.cell(judged.error()).cell(judged.deepest());
                html.cell(count(judged.pairs(), usual)).cell(count(judged.points(), Peer.UNKNOWN));
            }
            html.cell(point.cpuMicros());
            html.cell(
                    Double.isNaN(point.cpuLow())
                            ? "–"
                            : Html.number(point.cpuLow()) + " … " + Html.number(point.cpuHigh()));
            html.cell(Integer.toString(point.rounds().size()));
            html.cell(point.medianMillis()).cell(point.p99Millis()).add("</tr>\n");
        }
        html.endTable();
    }

    /** Says whether no other point is at least as good in both and better in one. */
    private static boolean onFront(Results.Point point, List<Results.Point> points) {
        Double error = point.judged().error();
        if (point.failure() != null || error == null || Double.isNaN(point.cpuMicros())) {
            return false;
        }
        for (Results.Point other : points) {
            Double rival = other.judged().error();
            if (other.failure() == null
                    && rival != null
                    && rival <= error
                    && other.cpuMicros() <= point.cpuMicros()
                    && (rival < error || other.cpuMicros() < point.cpuMicros())) {
                return false;
            }
        }
        return true;
    }

    /** A count, with a star if it is off the usual one. */
    private static String count(int value, int usual) {
        boolean off =
                usual >= 0
                        && value >= 0
                        && Math.abs(value - usual) > DIFFERENT * Math.max(1, usual);
        return (value < 0 ? "–" : Integer.toString(value)) + (off ? "*" : "");
    }

    /** The median of the contact counts that are known, or unknown. */
    private static int usualPairs(List<Results.Point> points) {
        int[] known =
                points.stream()
                        .filter(point -> point.failure() == null)
                        .mapToInt(point -> point.judged().pairs())
                        .filter(pairs -> pairs >= 0)
                        .sorted()
                        .toArray();
        return known.length == 0 ? Peer.UNKNOWN : known[known.length / 2];
    }
}
