package dev.cairn.benchmarks.compare;

import dev.cairn.benchmarks.peer.Engine;
import dev.cairn.benchmarks.peer.Peer;

import org.jspecify.annotations.Nullable;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;

/** Writes the report as one page that needs nothing else: well-formed XHTML, pictures inside. */
final class Page {
    private static final String STYLE =
            """
            body { font: 16px/1.5 sans-serif; color: #222; max-width: 60em; margin: 2em auto;
                   padding: 0 1em }
            h1, h2 { line-height: 1.2 } h2 { margin-top: 2.5em; border-top: 1px solid #ccc;
                   padding-top: 1em }
            img { max-width: 100%; display: block }
            table { border-collapse: collapse; font-size: 14px; margin: 1em 0 }
            th, td { padding: .2em .7em; text-align: right; border-bottom: 1px solid #ddd;
                   vertical-align: top }
            th { border-bottom: 2px solid #888; font-weight: bold }
            .text { text-align: left } .failed { color: #b00020 }
            .best { font-weight: bold } p.note { color: #555; font-size: 14px }
            """;

    /** Engines whose contact counts differ by more than this share do not do the same work. */
    private static final double DIFFERENT = 0.05;

    private final Results results;
    private final Map<String, String> svgs = new LinkedHashMap<>();
    private final StringBuilder html = new StringBuilder();

    Page(Results results) {
        this.results = results;
    }

    /** Returns the diagrams by file name, once the page has been written. */
    Map<String, String> svgs() {
        return svgs;
    }

    String write() throws IOException {
        html.append(
                """
                <!DOCTYPE html>
                <html xmlns="http://www.w3.org/1999/xhtml" lang="en">
                <head><meta charset="utf-8"/><title>Speed against error</title>
                <style>
                """);
        html.append(STYLE).append("</style></head>\n<body>\n");
        html.append("<h1>Rigid-body engines: speed against error</h1>\n");
        html.append(
                """
                <p>Every engine simulates the same scenes. Each point below is one engine with one
                number N of sub-steps per tick of 1/60 s; the curve joins its points from small N
                to large. <b>Down is more accurate, left is cheaper: better is down-left.</b>
                Both axes are logarithmic. A full line is the engine with its own default settings,
                a dashed one its best effort: what its documentation offers for accuracy. A cross
                at the top edge is a run that failed; the table below the diagram says why.</p>
                """);
        how();
        Set<String> scenes = new LinkedHashSet<>();
        results.points().forEach(point -> scenes.add(point.scene()));
        for (String scene : scenes) {
            scene(Case.of(scene));
        }
        checks();
        budgets();
        cold();
        engines();
        facts("How it was run", results.settings());
        facts("Machine", results.machine());
        html.append("</body>\n</html>\n");
        return html.toString();
    }

    private void how() {
        html.append(
                """
                <p class="note">Scenes are built once, by Cairn's samples, and handed to all engines
                as numbers: poses, shapes, mass, inertia, friction, restitution. Errors are computed
                from the engines' poses by one piece of code, in runs of their own; overlaps are
                measured by an exact separating-axis test outside all engines. CPU time is that of
                the whole process, all threads and the garbage collector in it, the JIT compilers
                left out where the system tells them apart (Linux), without building the scene,
                without the first tick, per movable body. Sleeping and damping are off in all.
                What else was set is listed under “Engines”.</p>
                """);
    }

    private void scene(Case scene) throws IOException {
        List<Results.Point> all = results.of(scene.id());
        html.append("<h2 id=\"").append(scene.id()).append("\">");
        html.append(text(scene.title())).append("</h2>\n<p>").append(text(scene.truth()));
        html.append("</p>\n<p class=\"note\">Scene <code>").append(text(scene.scene().id()));
        html.append("</code> with ").append(text(all.getFirst().parameters()));
        html.append(", ").append(all.getFirst().judged().ticks() > 0 ? "" : "up to ");
        html.append(scene.ticks()).append(" ticks.</p>\n");
        Set<Integer> workers = new TreeSet<>();
        all.forEach(point -> workers.add(point.workers()));
        for (int count : workers) {
            List<Results.Point> points =
                    all.stream().filter(point -> point.workers() == count).toList();
            if (count == workers.iterator().next()) {
                pictures(scene, points);
            } else {
                html.append("<h3>").append(count).append(" workers</h3>\n");
            }
            table(scene, points);
        }
        scaling(scene, all, workers);
    }

    private void pictures(Case scene, List<Results.Point> points) throws IOException {
        picture(
                scene.id() + "-error",
                scene.title() + ": " + scene.error() + " against CPU time",
                Diagram.svg(points, scene.error(), point -> point.judged().error()));
        if (!scene.metric().equals(Case.REST_OVERLAP) && overlaps(points)) {
            picture(
                    scene.id() + "-overlap",
                    scene.title() + ": deepest overlap against CPU time",
                    Diagram.svg(points, "deepest overlap, m", point -> point.judged().deepest()));
        }
    }

    /** Wall time over workers, at the number of sub-steps nearest to 4 that all have. */
    private void scaling(Case scene, List<Results.Point> all, Set<Integer> workers)
            throws IOException {
        if (workers.size() < 2) {
            return;
        }
        int substeps = all.getFirst().substeps();
        for (Results.Point point : all) {
            substeps = point.substeps() <= 4 ? Math.max(substeps, point.substeps()) : substeps;
        }
        int n = substeps;
        html.append("<h3>Scaling over workers, N = ").append(n).append("</h3>\n");
        picture(
                scene.id() + "-scaling",
                scene.title() + ": wall time of a tick against workers",
                Charts.scaling(all.stream().filter(point -> point.substeps() == n).toList()));
        html.append("<p class=\"note\">An engine with a single point has no threads in the build");
        html.append(" that is used here. Default settings.</p>\n");
    }

    private static boolean overlaps(List<Results.Point> points) {
        for (Results.Point point : points) {
            Double deepest = point.judged().deepest();
            if (point.failure() == null && deepest != null && deepest > 0) {
                return true;
            }
        }
        return false;
    }

    private void picture(String name, String alt, String svg) {
        svgs.put(name + ".svg", svg);
        html.append("<img alt=\"").append(text(alt)).append("\" src=\"data:image/svg+xml;base64,");
        html.append(Base64.getEncoder().encodeToString(svg.getBytes(StandardCharsets.UTF_8)));
        html.append("\"/>\n");
    }

    private void table(Case scene, List<Results.Point> points) {
        html.append("<table><tr><th class=\"text\">engine</th><th>N</th><th>");
        html.append(text(scene.error())).append("</th><th>deepest overlap, m</th>");
        html.append("<th>contacts</th><th>points</th><th>CPU µs per body and tick</th>");
        html.append("<th>lowest … highest round</th>");
        html.append("<th>tick ms, median</th><th>99 %</th></tr>\n");
        int usual = usualPairs(points);
        for (Results.Point point : points) {
            Protocol.Answer judged = point.judged();
            html.append("<tr><td class=\"text\">");
            html.append(onFront(point, points) ? "<b>" : "").append(text(point.title()));
            html.append(onFront(point, points) ? "</b>" : "")
                    .append("</td><td>")
                    .append(point.substeps())
                    .append("</td>");
            String failure = point.failure();
            if (failure != null) {
                html.append("<td class=\"text failed\" colspan=\"4\">").append(text(failure));
                html.append("</td>");
            } else {
                cell(judged.error());
                cell(judged.deepest());
                count(judged.pairs(), usual);
                count(judged.points(), Peer.UNKNOWN);
            }
            cell(point.cpuMicros());
            html.append("<td>").append(number(point.cpuLow())).append(" … ");
            html.append(number(point.cpuHigh())).append("</td>");
            cell(point.medianMillis());
            cell(point.p99Millis());
            html.append("</tr>\n");
        }
        html.append("</table>\n");
        html.append("<p class=\"note\">contacts, points: touching pairs and contact points after");
        html.append(" the last tick, as the engine counts them; – where it does not say.");
        html.append(" * more than 5 % off the median of the column: not the same work, so do not");
        html.append(" compare the times. <b>Bold</b>: no other point is both cheaper and more");
        html.append(" accurate. CPU time of what was stopped as too slow is its wall time.</p>\n");
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

    private void checks() {
        List<Checks.Row> rows = Checks.of(results);
        if (rows.isEmpty()) {
            return;
        }
        html.append("<h2>Does the instrument read right?</h2>\n");
        html.append("<p>Cases whose error is known beforehand, by closed form or because somebody");
        html.append(" published it for the same engine, brought to the step used here. Order: the");
        html.append(" slope of the error between the two smallest steps up to N = 16.</p>\n");
        html.append("<table><tr><th class=\"text\">quantity</th><th class=\"text\">engine</th>");
        html.append("<th>N</th><th>expected</th><th>found</th><th>found / expected</th>");
        html.append("<th>order</th><th class=\"text\">where the expectation is from</th></tr>\n");
        for (Checks.Row row : rows) {
            html.append("<tr><td class=\"text\">").append(text(row.what()));
            html.append("</td><td class=\"text\">").append(text(row.engine().title()));
            html.append("</td><td>").append(row.substeps()).append("</td>");
            cell(row.expected());
            cell(row.found());
            cell(row.found() / row.expected());
            cell(row.order());
            html.append("<td class=\"text\">").append(text(row.source())).append("</td></tr>\n");
        }
        html.append("</table>\n");
    }

    private void budgets() {
        if (results.budgets().isEmpty()) {
            return;
        }
        List<String> columns =
                List.of(Budget.BASE, Budget.CONTACTS, Budget.SOLVER, Budget.STEP, Budget.ALL);
        html.append("<h2>Where the error comes from</h2>\n");
        html.append("<p>Error of the default settings at N = 4, and what is left of it when one");
        html.append(" thing is refined: the narrow phase (contacts found in each sub-step, for");
        html.append(" engines that find them once a tick; the others do so anyway), the solver");
        html.append(" (8 x its iterations, where it has any), the step (16 x the sub-steps:");
        html.append(" integrator, and solver in time). The column with the smallest number names");
        html.append(" the part that the error is made of; where none helps, it is the model");
        html.append(" (margins, thresholds, pyramids of friction).</p>\n");
        html.append("<table><tr><th class=\"text\">scene</th><th class=\"text\">engine</th>");
        columns.forEach(column -> html.append("<th>").append(text(column)).append("</th>"));
        html.append("</tr>\n");
        for (Budget budget : results.budgets()) {
            html.append("<tr><td class=\"text\">").append(text(Case.of(budget.scene()).title()));
            html.append("</td><td class=\"text\">").append(text(budget.engine().title()));
            html.append("</td>");
            columns.forEach(column -> cell(budget.errors().get(column)));
            html.append("</tr>\n");
        }
        html.append("</table>\n");
    }

    private void cold() throws IOException {
        if (results.colds().isEmpty()) {
            return;
        }
        html.append("<h2 id=\"cold\">Cold start</h2>\n");
        html.append(
                "<p>Scene “pyramid”, N = 4, one worker, default settings: the median time of a");
        html.append(
                " tick in spans of time since the start of the JVM. The curve begins where the");
        html.append(" engine has built the scene; this program loads its classes and runs the");
        html.append(" scene's script before that, the same for all.</p>\n");
        picture("cold-start", "Cold start: time of a tick", Charts.cold(results.colds()));
    }

    private void engines() {
        html.append("<h2>Engines</h2>\n<table><tr><th class=\"text\">engine</th>");
        html.append("<th class=\"text\">version</th><th class=\"text\">kind</th>");
        html.append(
                "<th class=\"text\">N means</th><th class=\"text\">set, and not set</th></tr>\n");
        for (Engine engine : Engine.values()) {
            List<Results.Point> of =
                    results.points().stream().filter(point -> point.engine() == engine).toList();
            if (of.isEmpty()) {
                continue;
            }
            List<String> notes = new ArrayList<>();
            for (Results.Point point : of) {
                if (notes.isEmpty()) {
                    notes.addAll(point.judged().notes());
                }
            }
            if (of.stream().allMatch(point -> point.judged().missing())) {
                notes.add("not measured: " + of.getFirst().judged().failure());
            }
            html.append("<tr>");
            for (String words : List.of(engine.title(), engine.version(), engine.kind())) {
                html.append("<td class=\"text\">").append(text(words)).append("</td>");
            }
            html.append("<td class=\"text\">").append(text(engine.knob())).append("</td>");
            html.append("<td class=\"text\">");
            html.append(String.join(";<br/>", notes.stream().map(Page::text).toList()));
            html.append("</td></tr>\n");
        }
        html.append("</table>\n");
    }

    private void facts(String title, Map<String, String> facts) {
        html.append("<h2>").append(text(title)).append("</h2>\n<table>\n");
        facts.forEach((name, value) ->
                html.append("<tr><th class=\"text\">")
                        .append(text(name))
                        .append("</th><td class=\"text\">")
                        .append(text(value))
                        .append("</td></tr>\n"));
        html.append("</table>\n");
    }

    private void cell(@Nullable Double value) {
        html.append("<td>").append(value == null ? "–" : number(value)).append("</td>");
    }

    /** Writes a count, with a star if it is off the usual one. */
    private void count(int value, int usual) {
        boolean off =
                usual >= 0
                        && value >= 0
                        && Math.abs(value - usual) > DIFFERENT * Math.max(1, usual);
        html.append("<td>").append(value < 0 ? "–" : Integer.toString(value));
        html.append(off ? "*" : "").append("</td>");
    }

    /** Returns the median of the contact counts that are known, or unknown. */
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

    /** Three digits, without an exponent where that is short. */
    static String number(double value) {
        if (Double.isNaN(value)) {
            return "–";
        }
        double size = Math.abs(value);
        if (size == 0) {
            return "0";
        }
        if (size >= 1e-3 && size < 1e5) {
            int digits = Math.clamp(2 - (int) Math.floor(StrictMath.log10(size)), 0, 5);
            return String.format(Locale.ROOT, "%." + digits + "f", value);
        }
        return String.format(Locale.ROOT, "%.2e", value);
    }

    private static String text(Object value) {
        return value.toString()
                .replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;");
    }
}
