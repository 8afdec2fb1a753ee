package dev.cairn.benchmarks.compare;

import dev.cairn.benchmarks.compare.measure.Case;
import dev.cairn.benchmarks.compare.measure.ColdStart;
import dev.cairn.benchmarks.compare.measure.EngineProcess;
import dev.cairn.benchmarks.compare.measure.Protocol;
import dev.cairn.benchmarks.peer.Engine;

import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;

/** The command that measures nothing but the first seconds of a JVM, in turns. */
@Command(
        name = "start",
        mixinStandardHelpOptions = true,
        description = "What a fresh JVM takes for the first ticks of a scene, by engine.")
public final class Start implements Callable<Integer> {
    private static final double GRACE_SECONDS = 60;

    @Option(
            names = "--scenes",
            split = ",",
            paramLabel = "ID",
            description = "scenes of compare, default: falling-boxes,large-pyramid")
    private List<String> scenes = List.of("falling-boxes", "large-pyramid");

    @Option(
            names = "--engines",
            split = ",",
            paramLabel = "ID",
            description = "engines of compare, all that are there by default")
    private List<String> engines = List.of();

    @Option(
            names = "--seconds",
            paramLabel = "S",
            defaultValue = "30",
            description = "how long each is stepped from its JVM's start on, default 30")
    private double seconds = 30;

    @Option(
            names = "--rounds",
            paramLabel = "N",
            defaultValue = "1",
            description = "JVMs of each engine, default 1")
    private int rounds = 1;

    private Start() {}

    /**
     * Runs the command and ends the JVM with its status.
     *
     * @param args its options; {@code --help} lists them
     */
    public static void main(String[] args) {
        System.exit(new CommandLine(new Start()).execute(args));
    }

    @Override
    public Integer call() throws IOException {
        List<Case> cases;
        List<Engine> known;
        try {
            cases = scenes.stream().map(Case::of).toList();
            known =
                    engines.isEmpty()
                            ? Engine.available()
                            : engines.stream().map(Engine::of).toList();
        } catch (IllegalArgumentException misuse) {
            System.err.println(misuse.getMessage());
            return CommandLine.ExitCode.USAGE;
        }
        if (!(seconds > 0) || rounds < 1) {
            System.err.printf(
                    "--seconds %s, --rounds %d: want more than 0 s, 1 round or more%n",
                    seconds, rounds);
            return CommandLine.ExitCode.USAGE;
        }
        System.out.println(
                "scene           engine       first ms   60 ticks, CPU s    whole, CPU s  settled");
        Path logs = Files.createTempDirectory("cairn-start");
        for (Case scene : cases) {
            for (int round = 0; round < rounds; round++) {
                for (Engine engine : known) {
                    System.out.println(line(scene, engine, logs));
                }
            }
        }
        return CommandLine.ExitCode.OK;
    }

    private String line(Case scene, Engine engine, Path logs) {
        String names = "%-15s %-11s".formatted(scene.id(), engine.id());
        try (EngineProcess fresh = new EngineProcess(engine, logs, List.of())) {
            Protocol.Answer answer =
                    fresh.ask(
                            new Protocol.Request(
                                    Protocol.Kind.COLD,
                                    scene.id(),
                                    scene.settings(),
                                    Schedule.base(),
                                    seconds),
                            GRACE_SECONDS + 3 * seconds);
            return answer.failure() != null
                    ? names + " FAILED: " + answer.failure()
                    : names + shown(answer.errors());
        }
    }

    private static String shown(Map<String, Double> figures) {
        StringBuilder line = new StringBuilder();
        for (String name : ColdStart.NAMES) {
            Double value = figures.get(name);
            line.append("%9s".formatted(value == null ? "–" : Html.number(value)));
        }
        return line.toString();
    }
}
