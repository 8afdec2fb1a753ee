package dev.cairn.benchmarks.regress;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;

import dev.cairn.benchmarks.Main;
import dev.cairn.benchmarks.Spread;
import dev.cairn.benchmarks.compare.measure.ColdStart;
import dev.cairn.benchmarks.compare.measure.Probe;
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
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
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

    /** What a fresh JVM begins with, for how long, and what of that is told. */
    private static final String START_SCENE = "pile-mixed";

    private static final double START_SECONDS = 10;

    private static final List<String> START_FIGURES =
            List.of(ColdStart.SIXTY, ColdStart.SIXTY_CPU, ColdStart.SCENE, ColdStart.SCENE_CPU);

    /** What is judged: a scene of the report, the error wanted, the cost allowed. */
    record Subject(
            String scene, Map<String, String> settings, double tolerance, double budgetMicros) {
        String name() {
            return scene + (settings.isEmpty() ? "" : new TreeMap<>(settings).toString());
        }
    }

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
            names = "--runs",
            paramLabel = "N",
            defaultValue = "5",
            description = "runs, each in a JVM of its own, default: ${DEFAULT-VALUE}")
    private int runs = 5;

    @Option(
            names = "--rounds",
            paramLabel = "N",
            defaultValue = "3",
            description = "timed rounds of a run, default: ${DEFAULT-VALUE}")
    private int rounds = 3;

    @Option(names = "--add", description = "adds runs to those that this commit has already")
    private boolean add;

    @Option(
            names = "--one-run",
            hidden = true,
            paramLabel = "FILE",
            description = "measures once, in this JVM, and writes the figures to this file")
    private @Nullable Path oneRun;

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
        if (runs < 1 || rounds < 1) {
            err.printf("--runs %d, --rounds %d: counts start at 1%n", runs, rounds);
            return CommandLine.ExitCode.USAGE;
        }
        if (oneRun != null) {
            write(measure(), oneRun);
            return CommandLine.ExitCode.OK;
        }
        Files.createDirectories(folder);
        Path file = folder.resolve(commit().replace("+", "-changed") + ".json");
        Headline now = add && Files.exists(file) ? read(file) : null;
        for (int run = 0; run < runs; run++) {
            err.printf("run %d of %d%n", run + 1, runs);
            Headline one = fork();
            now = now == null ? one : now.with(one);
        }
        write(Objects.requireNonNull(now), file);
        Path before = against != null ? against : newestBut(file);
        System.out.println(file);
        if (before == null) {
            System.out.println("nothing to compare with yet");
            return CommandLine.ExitCode.OK;
        }
        Headline earlier = read(before);
        System.out.printf(
                "%ncommit %s, %d runs, against %s, %d runs; us: microseconds of CPU per body and"
                        + " tick%n%n",
                now.commit(), now.runs(), earlier.commit(), earlier.runs());
        System.out.println("| figure | before | now | |\n|---|---|---|---|");
        for (Headline.Line line : now.against(earlier, SUBJECTS)) {
            System.out.printf(
                    "| %s | %s | %s | %s |%n",
                    line.name(), line.before(), line.now(), line.verdict());
        }
        return CommandLine.ExitCode.OK;
    }

    private static Headline read(Path file) throws IOException {
        Headline known =
                new Gson().fromJson(Files.readString(file, StandardCharsets.UTF_8), Headline.class);
        if (known == null || known.points() == null || known.starts() == null) {
            throw new IOException(file + " holds no figures of this version of regress");
        }
        return known;
    }

    private static void write(Headline headline, Path file) throws IOException {
        Files.writeString(
                file, new GsonBuilder().setPrettyPrinting().create().toJson(headline) + "\n");
    }

    /** Measures in a JVM of its own: another one compiles the same code in another order. */
    private Headline fork() throws IOException {
        Path file = Files.createTempFile("regress", ".json");
        try {
            List<String> command = new ArrayList<>();
            command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
            command.addAll(Probe.JVM_FLAGS);
            command.addAll(List.of("-cp", System.getProperty("java.class.path")));
            command.addAll(List.of(Main.class.getName(), "regress"));
            command.addAll(List.of("--rounds", Integer.toString(rounds)));
            command.addAll(List.of("--one-run", file.toString()));
            int status = new ProcessBuilder(command).inheritIO().start().waitFor();
            if (status != 0) {
                throw new IOException("a run ended with status " + status);
            }
            return read(file);
        } catch (InterruptedException stop) {
            Thread.currentThread().interrupt();
            throw new IOException("interrupted", stop);
        } finally {
            Files.delete(file);
        }
    }

    private Headline measure() {
        Probe probe = new Probe();
        // before anything else: this JVM is fresh only once
        Map<String, List<Double>> starts = new TreeMap<>();
        probe.start(START_SCENE, START_SECONDS)
                .forEach((name, value) -> {
                    if (START_FIGURES.contains(name)) {
                        starts.put("start " + START_SCENE + " " + name, List.of(value));
                    }
                });
        List<Headline.Point> points = new ArrayList<>();
        for (Subject subject : SUBJECTS) {
            // The first run of each warms up; its times are thrown away.
            probe.run(subject.scene(), subject.settings(), 4, 3, 0.5);
            for (int n : SUBSTEPS) {
                Probe.Figures found =
                        probe.run(subject.scene(), subject.settings(), n, rounds, 0.1);
                points.add(
                        new Headline.Point(
                                subject.name(),
                                n,
                                Double.isNaN(found.error()) ? null : found.error(),
                                List.of(Spread.median(found.cpuMicros()))));
            }
        }
        Map<String, String> digests = new TreeMap<>();
        for (String scene : List.of("pyramid", "room", "pile-mixed")) {
            digests.put(scene, digest(scene));
        }
        return new Headline(commit(), machine(), points, digests, starts);
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
        return Probe.processor()
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
