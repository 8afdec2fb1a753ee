package dev.cairn.benchmarks.compare;

import dev.cairn.benchmarks.compare.measure.Case;
import dev.cairn.benchmarks.compare.measure.ColdStart;
import dev.cairn.benchmarks.peer.Engine;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;

/** Writes the report as one page that needs nothing else: well-formed XHTML, pictures inside. */
final class Page {
    private static final String STYLE =
            """
            body { font: 16px/1.5 sans-serif; color: #222; max-width: 66em; margin: 2em auto;
                   padding: 0 1em }
            h1, h2 { line-height: 1.2 } h2 { margin-top: 2.5em; border-top: 1px solid #ccc;
                   padding-top: 1em }
            img { width: 100%; max-width: 960px; min-width: 640px; display: block }
            table { border-collapse: collapse; font-size: 14px; margin: 1em 0 }
            th, td { padding: .2em .6em; text-align: right; border-bottom: 1px solid #ddd;
                   vertical-align: top; white-space: nowrap }
            th, .text { white-space: normal } th { border-bottom: 2px solid #888; font-weight: bold }
            table.facts th { border-bottom: 1px solid #ddd }
            table.points td:first-child { white-space: nowrap } table.points th { min-width: 4.5em }
            table.points th:nth-child(2) { min-width: 1em } .wide { overflow-x: auto }
            .text { text-align: left } .failed { color: #b00020 } summary { cursor: pointer }
            p.note { color: #555; font-size: 14px }
            """;

    private final Results results;
    private final Map<String, String> svgs = new LinkedHashMap<>();
    private final Html html = new Html();

    Page(Results results) {
        this.results = results;
    }

    /** Returns the diagrams by file name, once the page has been written. */
    Map<String, String> svgs() {
        return svgs;
    }

    String write() throws IOException {
        List<Case> scenes = results.scenes();
        html.add(
                """
                <!DOCTYPE html>
                <html xmlns="http://www.w3.org/1999/xhtml" lang="en">
                <head><meta charset="utf-8"/><title>Speed against error</title>
                <style>
                """);
        html.add(STYLE).add("</style></head>\n<body>\n");
        html.add("<h1>Rigid-body engines: speed against error</h1>\n");
        introduction();
        contents(scenes);
        new SceneTables(results).glance(html, scenes);
        for (Case scene : scenes) {
            scene(scene);
        }
        checks();
        budgets();
        cold();
        engines();
        facts("how", "How it was run", results.settings());
        facts("machine", "Machine", results.machine());
        html.add("</body>\n</html>\n");
        return html.toString();
    }

    private void introduction() {
        html.add(
                """
                <p>Every engine simulates the same scenes. Each point of a diagram is one engine
                with one number N of sub-steps per tick of 1/60 s; the curve joins its points from
                small N to large. <b>Down is more accurate, left is cheaper: better is
                down-left.</b> Both axes are logarithmic. A full line is the engine with its own
                default settings, a dashed one its best effort: what it offers for accuracy besides
                sub-steps. A cross at the top edge is a run that failed: it was too slow, crashed, or
                its error passed the scene's limit (fallen, flown apart); the list below the diagram
                says which. Errors below 1e-16, 0 among them, are drawn at 1e-16. Versions and settings are under <a href="#engines">Engines</a>.</p>
                """);
        html.add("<p>").say(headline()).add("</p>\n");
        html.add(
                """
                <p class="note">Scenes are built once, by Cairn's samples, and handed to all engines
                as numbers: poses, shapes, mass, inertia, friction, restitution. Errors are computed
                from the engines' poses by one piece of code, in runs of their own; overlaps are
                measured by an exact separating-axis test outside all engines. CPU time is that of
                the whole process, all threads and the garbage collector in it, the JIT compilers
                left out where the system tells them apart (Linux), without building the scene,
                without the first tick, per movable body. Sleeping and damping are off in all.</p>
                """);
    }

    /** Processor, JVM and engines in a line. */
    private String headline() {
        List<String> engines = new ArrayList<>();
        for (Engine engine : Engine.values()) {
            if (results.points().stream().anyMatch(point -> point.engine() == engine)) {
                engines.add(engine.title() + " (" + engine.version() + ")");
            }
        }
        Map<String, String> machine = results.machine();
        return "Measured on %s, %s cores, Java %s: %s."
                .formatted(
                        machine.getOrDefault("processor", "?"),
                        machine.getOrDefault("cores seen by the JVM", "?"),
                        Runtime.version().feature(),
                        String.join(", ", engines));
    }

    private void contents(List<Case> scenes) {
        html.add("<p><a href=\"#glance\">At a glance</a>");
        for (Case scene : scenes) {
            html.add(" · <a href=\"#" + scene.id() + "\">").say(scene.title()).add("</a>");
        }
        link("checks", "Does the instrument read right?", !Checks.of(results).isEmpty());
        link("budget", "Where the error comes from", !results.budgets().isEmpty());
        link("cold", "Cold start", !results.colds().isEmpty());
        link("engines", "Engines", true);
        link("how", "How it was run", true);
        link("machine", "Machine", true);
        html.add("</p>\n");
    }

    private void link(String id, String title, boolean there) {
        if (there) {
            html.add(" · <a href=\"#" + id + "\">").say(title).add("</a>");
        }
    }

    private void scene(Case scene) throws IOException {
        List<Results.Point> all = results.of(scene.id());
        html.add("<h2 id=\"" + scene.id() + "\">").say(scene.title()).add("</h2>\n<p>");
        html.say(scene.truth()).add("</p>\n<p class=\"note\">Scene <code>").say(scene.scene().id());
        html.add("</code> with ").say(all.getFirst().parameters()).add(", ");
        html.say(scene.ticks()).add(" ticks.</p>\n");
        Set<Integer> workers = new TreeSet<>();
        all.forEach(point -> workers.add(point.workers()));
        int first = workers.iterator().next();
        List<Results.Point> points =
                all.stream().filter(point -> point.workers() == first).toList();
        pictures(scene, points);
        SceneTables.failures(html, points);
        html.add("<details><summary>All numbers</summary>\n");
        SceneTables.points(html, scene, points);
        for (int count : workers) {
            if (count != first) {
                html.add("<p>" + count + " workers, times only; the errors are those above:</p>\n");
                SceneTables.points(
                        html,
                        scene,
                        all.stream().filter(point -> point.workers() == count).toList());
            }
        }
        html.add("<p class=\"note\">Touching pairs and contact points after the last tick, as the");
        html.add(" engine counts them; – where it does not say. * more than 5 % off the median of");
        html.add(" the column: not the same work, so compare the times with care. <b>Bold</b>: no");
        html.add(" other point is both cheaper and more accurate. CPU time of what was stopped as");
        html.add(" too slow is that of its error run, or of what was expected of it.</p>\n");
        html.add("</details>\n");
        scaling(scene, all, workers);
    }

    private void pictures(Case scene, List<Results.Point> points) throws IOException {
        picture(
                scene.id() + "-error",
                scene.title() + ": " + scene.error() + " against CPU time",
                Diagram.svg(points, scene.title(), scene.error(), point -> point.judged().error()));
        if (!scene.metric().equals(Case.REST_OVERLAP) && overlaps(points)) {
            picture(
                    scene.id() + "-overlap",
                    scene.title() + ": deepest overlap against CPU time",
                    Diagram.svg(
                            points,
                            scene.title() + ": overlap",
                            "deepest overlap of the whole run, m",
                            point -> point.judged().deepest()));
        }
    }

    /** Wall time over workers, at the number of sub-steps that all have. */
    private void scaling(Case scene, List<Results.Point> all, Set<Integer> workers)
            throws IOException {
        if (workers.size() < 2) {
            return;
        }
        int n = Schedule.scalingSubsteps(all.stream().map(Results.Point::substeps).toList());
        html.add("<h3>Scaling over workers, N = " + n + "</h3>\n");
        picture(
                scene.id() + "-scaling",
                scene.title() + ": wall time of a tick against workers",
                Charts.scaling(
                        scene.title() + ", N = " + n,
                        all.stream().filter(point -> point.substeps() == n).toList()));
        html.add("<p class=\"note\">Median wall time of a tick, median of the rounds; default");
        html.add(" settings; linear axes from 0. Engines that have no threads in the build used");
        html.add(" here are left out. On a machine with as many cores as workers, whatever else");
        html.add(" runs shows here first.</p>\n");
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
        html.picture(alt, svg);
    }

    private void checks() {
        List<Checks.Row> rows = Checks.of(results);
        if (rows.isEmpty()) {
            return;
        }
        html.add("<h2 id=\"checks\">Does the instrument read right?</h2>\n");
        html.add("<p>Cases whose error is known beforehand, by closed form or because somebody");
        html.add(" published it for the same engine, brought to the step used here. Order: the");
        html.add(" slope of the error between the two smallest steps up to N = 16.</p>\n");
        html.table(
                List.of(
                        " quantity",
                        " engine",
                        "N",
                        "expected",
                        "found",
                        "found / expected",
                        "order",
                        " where the expectation is from, and why the figure differs"));
        for (Checks.Row row : rows) {
            html.add("<tr>").words(row.what()).words(row.engine().title());
            html.cell(Integer.toString(row.substeps()));
            html.cell(Double.isNaN(row.expected()) ? "rounding" : Html.number(row.expected()));
            html.cell(row.found()).cell(row.found() / row.expected());
            html.cell(
                    Double.isNaN(row.order()) || Double.isNaN(row.expected())
                            ? "–"
                            // + 0.0: no minus before a zero
                            : String.format(
                                    Locale.ROOT, "%.2f", Math.rint(100 * row.order()) / 100 + 0.0));
            html.words(row.source()).add("</tr>\n");
        }
        html.endTable();
    }

    private void budgets() {
        if (results.budgets().isEmpty()) {
            return;
        }
        List<String> columns =
                List.of(Budget.BASE, Budget.CONTACTS, Budget.SOLVER, Budget.STEP, Budget.ALL);
        html.add("<h2 id=\"budget\">Where the error comes from</h2>\n");
        html.add("<p>Error of the default settings at N = 4, and what is left of it when one");
        html.add(" thing is refined: the narrow phase (contacts found in each sub-step, for");
        html.add(" engines that find them once a tick; the others do so anyway), the solver");
        html.add(" (8 x its iterations, where it has any), the step (16 x the sub-steps:");
        html.add(" integrator, and solver in time). The column with the smallest number names");
        html.add(" the part that the error is made of; where none helps, it is the model");
        html.add(" (margins, thresholds, pyramids of friction). – where the engine has no such");
        html.add(" thing, or was too slow.</p>\n");
        List<String> heads = new ArrayList<>(List.of(" scene", " error of", " engine"));
        heads.addAll(columns);
        html.table(heads);
        for (Budget budget : results.budgets()) {
            Case scene = Case.of(budget.scene());
            html.add("<tr>").words(scene.title()).words(scene.error());
            html.words(budget.engine().title());
            columns.forEach(column -> html.cell(budget.errors().get(column)));
            html.add("</tr>\n");
        }
        html.endTable();
    }

    private void cold() throws IOException {
        if (results.colds().isEmpty()) {
            return;
        }
        html.add("<h2 id=\"cold\">Cold start</h2>\n");
        html.add("<p>N = 4, one worker, default settings, each engine in a JVM of its own: the");
        html.add(" scene is stepped from the start on, over and over. CPU time is that of all");
        html.add(" threads, those of the JIT compilers among them. Settled: seconds since the");
        html.add(" JVM's start until the run of the scene from which on none takes more than 1.3");
        html.add(" times the last one; this program loads its classes and runs the scene's script");
        html.add(" before that, the same for all.</p>\n");
        for (Case scene : scenes(results.colds())) {
            cold(scene);
        }
    }

    private static List<Case> scenes(List<Results.Cold> colds) {
        return colds.stream().map(Results.Cold::scene).distinct().map(Case::of).toList();
    }

    private void cold(Case scene) throws IOException {
        List<Results.Cold> starts =
                results.colds().stream().filter(one -> one.scene().equals(scene.id())).toList();
        html.add("<h3>").say(scene.title()).add("</h3>\n");
        html.table(
                List.of(
                        " engine",
                        "first tick, ms",
                        "60 ticks, s",
                        "CPU, s",
                        scene.ticks() + " ticks, s",
                        "CPU, s",
                        "settled, s"));
        for (Results.Cold start : starts) {
            html.add("<tr>").words(start.engine().title());
            for (String name : ColdStart.NAMES) {
                html.cell(start.figures().get(name));
            }
            html.add("</tr>\n");
        }
        html.endTable();
        html.add("<p>Median time of a tick in spans of time; down is better.</p>\n");
        picture(
                scene.id() + "-cold-start",
                scene.title() + ": time of a tick from the start on",
                Charts.cold(scene.title(), starts));
    }

    private void engines() {
        html.add("<h2 id=\"engines\">Engines</h2>\n");
        html.table(List.of(" engine", " version", " kind", " N means", " set, and not set"));
        for (Engine engine : Engine.values()) {
            List<Results.Point> of =
                    results.points().stream().filter(point -> point.engine() == engine).toList();
            List<String> notes = new ArrayList<>();
            if (of.isEmpty()) {
                notes.add("not measured: not asked for, or not named by a property");
            }
            for (Results.Point point : of) {
                if (notes.isEmpty()) {
                    notes.addAll(point.judged().notes());
                }
            }
            if (!of.isEmpty() && of.stream().allMatch(point -> point.judged().missing())) {
                notes.add("not measured: " + of.getFirst().judged().failure());
            }
            html.add("<tr>").words(engine.title()).words(engine.version()).words(engine.kind());
            html.words(engine.knob()).add("<td class=\"text\">");
            html.add(String.join(";<br/>", notes.stream().map(Html::text).toList()));
            html.add("</td></tr>\n");
        }
        html.endTable();
    }

    private void facts(String id, String title, Map<String, String> facts) {
        html.add("<h2 id=\"" + id + "\">")
                .say(title)
                .add("</h2>\n<div class=\"wide\"><table class=\"facts\">\n");
        facts.forEach((name, value) -> {
            html.add("<tr><th class=\"text\">").say(name).add("</th>");
            html.words(value).add("</tr>\n");
        });
        html.add("</table></div>\n");
    }
}
