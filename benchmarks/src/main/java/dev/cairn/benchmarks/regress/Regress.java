package dev.cairn.benchmarks.regress;

import com.google.gson.GsonBuilder;

import dev.cairn.benchmarks.compare.Probe;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneOptions;
import dev.cairn.samples.SceneRegistry;

import org.jspecify.annotations.Nullable;

import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.stream.Stream;

/** The command that measures the headline figures and compares them with earlier ones. */
@Command(
        name = "regress",
        mixinStandardHelpOptions = true,
        description = "Headline figures of this commit, beside those of an earlier one.")
public final class Regress implements Callable<Integer> {
    private static final List<Integer> SUBSTEPS = List.of(1, 2, 4, 8, 16);
    private static final int DIGEST_TICKS = 120;

    /** What is judged: a scene of the report, the error wanted, the cost allowed. */
    private record Subject(
            String scene, Map<String, String> settings, double tolerance, double budgetMicros) {}

    private static final List<Subject> SUBJECTS =
            List.of(
                    new Subject("slope", Map.of(), 1e-3, 4),
                    new Subject("bounce", Map.of(), 1e-3, 4),
                    new Subject("stack-4", Map.of(), 1e-4, 8),
                    new Subject("pyramid", Map.of("base", "15"), 1e-2, 8),
                    new Subject("pile-boxes", Map.of("side", "5", "layers", "4"), 5e-3, 8));

    @Option(
            names = "--folder",
            paramLabel = "DIR",
            description = "where the figures are kept, default: ${DEFAULT-VALUE}")
    private Path folder = Path.of("results", "regress");

    @Option(
            names = "--against",
            paramLabel = "FILE",
            description = "figures to compare with; by default the newest of another commit")
    private @Nullable Path against;

    @Option(
            names = "--rounds",
            paramLabel = "N",
            defaultValue = "9",
            description = "timed rounds, default: ${DEFAULT-VALUE}")
    private int rounds = 9;

    private final PrintStream err = System.err;

    private Regress() {}

    /**
     * Runs the command and ends the JVM with its status: 0 whatever the figures are.
     *
     * @param args its options; {@code --help} lists them
     */
    public static void main(String[] args) {
        System.exit(new CommandLine(new Regress()).execute(args));
    }

    @Override
    public Integer call() throws IOException {
        Files.createDirectories(folder);
        Headline now = new Headline(commit(), machine(), figures());
        Path file = folder.resolve(now.commit().replace("+", "-changed") + ".json");
        Path before = against != null ? against : newestBut(file);
        Files.writeString(file, new GsonBuilder().setPrettyPrinting().create().toJson(now) + "\n");
        System.out.println(file);
        if (before == null) {
            System.out.println("nothing to compare with yet");
            return CommandLine.ExitCode.OK;
        }
        Headline earlier =
                new GsonBuilder()
                        .create()
                        .fromJson(Files.readString(before, StandardCharsets.UTF_8), Headline.class);
        System.out.printf("%ncommit %s against %s%n%n", now.commit(), earlier.commit());
        System.out.println("| figure | before | now | |\n|---|---|---|---|");
        for (Headline.Line line : now.against(earlier)) {
            System.out.printf(
                    "| %s | %s | %s | %s |%n",
                    line.name(), line.before(), line.now(), line.verdict());
        }
        return CommandLine.ExitCode.OK;
    }

    private Map<String, Headline.Figure> figures() {
        Probe probe = new Probe();
        Map<String, Headline.Figure> figures = new LinkedHashMap<>();
        for (Subject subject : SUBJECTS) {
            err.println(subject.scene());
            // The first run of each warms up; its times are thrown away.
            probe.run(subject.scene(), subject.settings(), 4, 3, 0.5);
            List<Probe.Figures> curve = new ArrayList<>();
            for (int n : SUBSTEPS) {
                curve.add(probe.run(subject.scene(), subject.settings(), n, rounds, 0.1));
            }
            String name = subject.scene() + subject.settings().values();
            figures.put(
                    String.format(Locale.ROOT, "%s cost@%.0e", name, subject.tolerance()),
                    costAt(curve, subject.tolerance()));
            figures.put(
                    String.format(Locale.ROOT, "%s err@%.0f us", name, subject.budgetMicros()),
                    errorWithin(curve, subject.budgetMicros()));
        }
        for (String scene : List.of("pyramid", "room", "pile-mixed")) {
            figures.put("digest " + scene, new Headline.Figure(null, 0, "", digest(scene)));
        }
        return figures;
    }

    /** Returns the cheapest cost of those that reach an error. */
    static Headline.Figure costAt(List<Probe.Figures> curve, double tolerance) {
        Double best = null;
        double noise = 0;
        for (Probe.Figures point : curve) {
            double cost = median(point.cpuMicros());
            if (point.error() <= tolerance && (best == null || cost < best)) {
                best = cost;
                noise = noise(point.cpuMicros());
            }
        }
        return new Headline.Figure(best, noise, "us per body and tick", null);
    }

    /** Returns the smallest error of those that cost no more than allowed. */
    static Headline.Figure errorWithin(List<Probe.Figures> curve, double budget) {
        Double best = null;
        for (Probe.Figures point : curve) {
            if (median(point.cpuMicros()) <= budget && (best == null || point.error() < best)) {
                best = Double.isNaN(point.error()) ? best : Double.valueOf(point.error());
            }
        }
        return new Headline.Figure(best, 0, "", null);
    }

    static double median(List<Double> values) {
        double[] sorted = values.stream().mapToDouble(Double::doubleValue).sorted().toArray();
        int n = sorted.length;
        return n % 2 == 1 ? sorted[n / 2] : (sorted[n / 2 - 1] + sorted[n / 2]) / 2;
    }

    /**
     * Returns the standard error of the median as a share: 1.4826 x the median deviation is the
     * standard deviation of what is normally distributed, and the median's error is 1.2533 x that
     * over the root of the number (Kenney and Keeping 1962).
     */
    static double noise(List<Double> values) {
        double median = median(values);
        double deviation = median(values.stream().map(value -> Math.abs(value - median)).toList());
        return 1.2533 * 1.4826 * deviation / Math.sqrt(values.size()) / median;
    }

    private static String digest(String id) {
        SampleScene scene = SceneRegistry.get(id);
        try (PhysicsWorld world =
                PhysicsWorld.builder()
                        .gravity(0, -SampleScene.GRAVITY, 0)
                        .workers(1)
                        .sleeping(false)
                        .build()) {
            SceneBuilder built = scene.build(new SceneBuilder(world, SceneOptions.defaults(scene)));
            for (int tick = 0; tick < DIGEST_TICKS; tick++) {
                built.beforeTick();
                world.step(SampleScene.STEP_SECONDS);
                built.afterTick();
            }
            return String.format(Locale.ROOT, "%016x", world.digest());
        }
    }

    private static String commit() {
        String hash = git("rev-parse", "--short=12", "HEAD");
        return hash.isEmpty()
                ? "unknown"
                : hash + (git("status", "--porcelain", "-uno").isEmpty() ? "" : "+");
    }

    /** Returns what git prints, or nothing where there is no git. */
    private static String git(String... arguments) {
        List<String> command = new ArrayList<>(List.of("git"));
        command.addAll(Arrays.asList(arguments));
        try {
            Process process =
                    new ProcessBuilder(command)
                            .redirectError(ProcessBuilder.Redirect.DISCARD)
                            .start();
            return new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8)
                    .strip();
        } catch (IOException absent) {
            return "";
        }
    }

    private static String machine() {
        return System.getProperty("os.arch")
                + ", Java "
                + Runtime.version()
                + ", "
                + Runtime.getRuntime().availableProcessors()
                + " cores";
    }

    private @Nullable Path newestBut(Path file) throws IOException {
        Path newest = null;
        try (Stream<Path> files = Files.list(folder)) {
            for (Path one : (Iterable<Path>) files::iterator) {
                if (one.toString().endsWith(".json")
                        && !one.equals(file)
                        && (newest == null
                                || Files.getLastModifiedTime(one)
                                                .compareTo(Files.getLastModifiedTime(newest))
                                        > 0)) {
                    newest = one;
                }
            }
        }
        return newest;
    }
}
