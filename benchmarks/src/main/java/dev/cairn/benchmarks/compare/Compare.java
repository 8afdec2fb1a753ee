package dev.cairn.benchmarks.compare;

import dev.cairn.benchmarks.Marked;
import dev.cairn.benchmarks.compare.measure.Case;
import dev.cairn.benchmarks.compare.measure.ColdStart;
import dev.cairn.benchmarks.peer.Engine;
import dev.cairn.benchmarks.peer.PeerSettings.Tuning;

import org.jspecify.annotations.Nullable;

import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.Callable;

/** The command that measures and writes the speed-against-error report. */
@Command(
        name = "compare",
        mixinStandardHelpOptions = true,
        sortOptions = false,
        description = "Measures speed against error: scenes x engines x workers x sub-steps.")
public final class Compare implements Callable<Integer> {
    private static final Marked PART = new Marked("compare");

    @Option(
            names = "--scenes",
            split = ",",
            paramLabel = "ID",
            description = "scenes; all by default, with --quick stack-4 and pyramid")
    private List<String> scenes = List.of();

    @Option(
            names = "--engines",
            split = ",",
            paramLabel = "ID",
            description =
                    "cairn, cairn-single, jolt, bullet, physx, ode4j, jbullet, box3d; all that are"
                            + " there by default")
    private List<String> engines = List.of();

    @Option(
            names = "--substeps",
            split = ",",
            paramLabel = "N",
            description = "sub-steps per tick; 1,2,4,8,16 by default, with --quick 1,4,16")
    private List<Integer> substeps = List.of();

    @Option(
            names = "--workers",
            split = ",",
            paramLabel = "N",
            description =
                    "threads; 1,2 by default, more than one in scenes of many bodies at N = 4;"
                            + " engines that cannot are left out above 1; with --quick 1")
    private List<Integer> workers = List.of();

    @Option(names = "--defaults-only", description = "leaves out the engines' best-effort settings")
    private boolean defaultsOnly;

    @Option(
            names = "--rounds",
            paramLabel = "N",
            description = "timed rounds, at most; 10, with --quick 3")
    private int rounds;

    @Option(
            names = "--patience",
            paramLabel = "SECONDS",
            description =
                    "CPU time after which an error run is stopped; by default 6, up to 20 in scenes"
                            + " of many bodies")
    private double patience;

    @Option(
            names = "--quick",
            description = "small scenes, few rounds: under two minutes, figures for orientation")
    private boolean quick;

    @Option(names = "--out", paramLabel = "DIR", description = "default: ${DEFAULT-VALUE}")
    private Path out = Path.of("results", "compare");

    @Option(
            names = "--readme",
            paramLabel = "FILE",
            description =
                    "also replaces the table in this page, docs/benchmarks.md, and draws the main"
                            + " diagram beside it, images/speed-against-error.svg")
    private @Nullable Path readme;

    private final PrintStream err = System.err;

    private Compare() {}

    /**
     * Runs the command and ends the JVM with its status.
     *
     * @param args its options; {@code --help} lists them
     */
    public static void main(String[] args) {
        System.setProperty("java.awt.headless", "true");
        System.exit(new CommandLine(new Compare()).execute(args));
    }

    @Override
    public Integer call() throws IOException {
        Plan plan;
        try {
            plan = plan();
        } catch (IllegalArgumentException misuse) {
            err.println(misuse.getMessage());
            return CommandLine.ExitCode.USAGE;
        }
        Files.createDirectories(out);
        Path page = readme;
        if (page != null) {
            try {
                // now, and not after an hour of measuring
                PART.replaced(PART.page(page), "");
            } catch (IllegalArgumentException unmarked) {
                err.printf("--readme %s: %s%n", page, unmarked.getMessage());
                return CommandLine.ExitCode.USAGE;
            }
        }
        Results results;
        try (CellStore store = new CellStore(out.resolve("cells.jsonl"), plan.setup())) {
            if (store.changed() != null) {
                err.printf("Starting over: since the last run in %s, %s%n", out, store.changed());
            }
            Campaign campaign = new Campaign(plan, out, store);
            double seconds = campaign.estimate();
            err.printf(
                    Locale.ROOT,
                    "About %.0f min. Can be stopped at any time; the same command goes on.%s%n",
                    Math.ceil(seconds / 60),
                    store.size() == 0 ? "" : " Kept from before: " + store.size() + " cells.");
            try (Reporter reporter = new Reporter(err, seconds)) {
                results = campaign.run(reporter::done);
            }
        }
        Path report = write(results);
        if (page != null) {
            readme(new ReadmePart(results), page);
        }
        summary(results);
        System.out.println(report.toAbsolutePath());
        return CommandLine.ExitCode.OK;
    }

    private Path write(Results results) throws IOException {
        Page page = new Page(results);
        Path report = out.resolve("report.html");
        Files.writeString(report, page.write(), StandardCharsets.UTF_8);
        for (Map.Entry<String, String> svg : page.svgs().entrySet()) {
            Files.writeString(out.resolve(svg.getKey()), svg.getValue(), StandardCharsets.UTF_8);
        }
        results.writeCsv(out.resolve("results.csv"));
        results.writeJson(out.resolve("results.json"));
        return report;
    }

    private static void readme(ReadmePart part, Path page) throws IOException {
        Path picture = page.resolveSibling(Path.of("images", "speed-against-error.svg"));
        Files.createDirectories(picture.toAbsolutePath().getParent());
        Files.writeString(picture, part.picture(), StandardCharsets.UTF_8);
        Files.writeString(
                page, PART.replaced(PART.page(page), part.table()), StandardCharsets.UTF_8);
    }

    private Plan plan() {
        List<String> chosen = scenes;
        if (chosen.isEmpty()) {
            chosen =
                    quick
                            ? List.of("stack-4", "pyramid")
                            : Case.all().stream().map(Case::id).toList();
        }
        List<Integer> steps = substeps;
        if (steps.isEmpty()) {
            steps = quick ? List.of(1, 4, 16) : List.of(1, 2, 4, 8, 16);
        }
        positive("--substeps", steps);
        positive("--workers", workers);
        List<Integer> threads = workers;
        if (threads.isEmpty()) {
            boolean two = !quick && Runtime.getRuntime().availableProcessors() > 1;
            threads = two ? List.of(1, 2) : List.of(1);
        }
        return new Plan(
                chosen.stream()
                        .map(Case::of)
                        .map(one -> quick ? one.with(one.quick()) : one)
                        .toList(),
                engines.isEmpty() ? Engine.available() : engines.stream().map(Engine::of).toList(),
                defaultsOnly ? List.of(Tuning.DEFAULT) : List.of(Tuning.values()),
                threads,
                steps.stream().sorted().distinct().toList(),
                rounds > 0 ? rounds : quick ? 3 : 10,
                0.03,
                quick ? 0.3 : 1,
                quick ? 0.8 : 15,
                patience > 0 ? patience : quick ? 4 : 6,
                quick ? 2 : 30,
                !quick);
    }

    private static void positive(String option, List<Integer> values) {
        for (int value : values) {
            if (value < 1) {
                throw new IllegalArgumentException(
                        "%s %d: counts start at 1".formatted(option, value));
            }
        }
    }

    private void summary(Results results) {
        for (Results.Point point : results.points()) {
            String failure = point.failure();
            System.out.printf(
                    Locale.ROOT,
                    "%-14s%-21s w%d N%-3d %s%n",
                    point.scene(),
                    point.title(),
                    point.workers(),
                    point.substeps(),
                    failure != null
                            ? "FAILED: " + failure
                            : "error %s, overlap %s m, %s us per body and tick"
                                    .formatted(
                                            shown(point.judged().error()),
                                            shown(point.judged().deepest()),
                                            Html.number(point.cpuMicros())));
        }
        for (Results.Cold start : results.colds()) {
            System.out.printf(
                    Locale.ROOT,
                    "%-14s%-21s cold start: first tick %s ms, 60 ticks %s s, %d ticks %s s, CPU %s"
                            + " s, settled after %s s%n",
                    start.scene(),
                    start.engine().title(),
                    shown(start.figures().get(ColdStart.FIRST_TICK)),
                    shown(start.figures().get(ColdStart.SIXTY)),
                    Case.of(start.scene()).ticks(),
                    shown(start.figures().get(ColdStart.SCENE)),
                    shown(start.figures().get(ColdStart.SCENE_CPU)),
                    shown(start.figures().get(ColdStart.SETTLED)));
        }
    }

    private static String shown(@Nullable Double value) {
        return value == null ? "?" : Html.number(value);
    }
}
