package dev.cairn.samples.fuzz;

import dev.cairn.samples.scenefile.SceneFile;
import dev.cairn.samples.scenefile.SceneWriter;

import me.tongfei.progressbar.ConsoleProgressBarConsumer;
import me.tongfei.progressbar.ProgressBar;
import me.tongfei.progressbar.ProgressBarBuilder;
import me.tongfei.progressbar.ProgressBarStyle;

import org.jspecify.annotations.Nullable;

import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

import java.io.IOException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;

/** {@code samples fuzz}: draws worlds, runs them, and tells which laws they break. Main thread. */
@Command(
        name = "samples fuzz",
        mixinStandardHelpOptions = true,
        sortOptions = false,
        usageHelpWidth = 100,
        description = {
            "Draws random small worlds, runs them, and looks whether energy, momenta, walls,",
            "overlaps, sleep and bits are as they must be. A world that breaks a law is made as",
            "small as it goes and written as a scene file, which --scene-file opens.",
        },
        footer = {
            "",
            "Examples:",
            "  samples fuzz --seed 7 --worlds 10000",
            "  samples fuzz --seed 7 --world 1234        (one world again)",
            "  samples fuzz --seed 7 --seconds 600 --family HOUSE",
            "",
            "Exit codes: 0 no law broken; 1 a law is broken; 2 the options make no sense."
        })
public final class FuzzCommand {
    private static final int BAR_WIDTH = 100;

    /** Every so many worlds are run a second time for their bits. */
    private static final int BITS_EVERY = 16;

    @Option(names = "--seed", description = "Seed of the worlds; 1 by default.")
    long seed = 1;

    @Option(names = "--worlds", description = "How many worlds; 1000 by default.")
    long worlds = 1000;

    @Option(names = "--seconds", description = "Ends after so many seconds; no end by default.")
    double seconds = Double.POSITIVE_INFINITY;

    @Option(names = "--world", paramLabel = "INDEX", description = "Run this world only.")
    @Nullable Long world;

    @Option(
            names = "--family",
            description = "Only worlds of HOUSE, ROOM, SPACE, WIDE, LEVEL or MACHINE.")
    @Nullable Family family;

    @Option(names = "--law", description = "Look at this law only.")
    @Nullable Law law;

    @Option(
            names = "--keep",
            paramLabel = "N",
            description = "Failing worlds that are made small and written; 5 by default.")
    int keep = 5;

    @Option(
            names = "--to",
            paramLabel = "FOLDER",
            description = "Where they are written; ./fuzz by default.")
    Path folder = Path.of("fuzz");

    private int kept;

    private FuzzCommand() {}

    /**
     * Runs the command.
     *
     * @param arguments what follows the word fuzz
     * @param out standard output: what was found
     * @param err standard error: progress and refusals
     * @param terminal whether a person watches, who gets a progress bar
     * @return the exit code: 0 no law broken; 1 one is; 2 the options make no sense
     */
    public static int run(String[] arguments, PrintStream out, PrintStream err, boolean terminal) {
        FuzzCommand command = new FuzzCommand();
        CommandLine line = new CommandLine(command).setCaseInsensitiveEnumValuesAllowed(true);
        try {
            CommandLine.ParseResult parsed = line.parseArgs(arguments);
            if (parsed.isUsageHelpRequested()) {
                line.usage(out);
                return 0;
            }
            if (command.worlds < 1 || !(command.seconds > 0) || command.keep < 0) {
                throw new IllegalArgumentException(
                        "--worlds %d --seconds %s --keep %d: expected at least 1, above 0, at least 0"
                                .formatted(command.worlds, command.seconds, command.keep));
            }
            return command.run(out, err, terminal);
        } catch (CommandLine.ParameterException | IllegalArgumentException wrong) {
            err.println(wrong.getMessage() + "; samples fuzz --help lists the options");
            return 2;
        }
    }

    private int run(PrintStream out, PrintStream err, boolean terminal) {
        Tally tally = new Tally();
        long from = world == null ? 0 : world;
        long to = world == null ? worlds : world + 1;
        long start = System.nanoTime();
        long done = 0;
        double spent = 0;
        try (ProgressBar bar = terminal ? bar(to - from, err) : null) {
            for (long i = from; i < to && spent < seconds; i++) {
                FuzzWorld fuzz = WorldGenerator.world(seed, i, family);
                Map<Law, Breach> broken = Laws.broken(fuzz, i % BITS_EVERY == 0 || world != null);
                if (law != null) {
                    broken.keySet().removeIf(other -> other != law);
                }
                tally.add(fuzz, broken);
                tell(fuzz, broken, out);
                done++;
                spent = (System.nanoTime() - start) * 1e-9;
                if (bar != null) {
                    bar.step();
                    bar.setExtraMessage(" %d broke a law".formatted(tally.failing()));
                }
            }
        }
        out.println();
        out.print(tally.markdown());
        out.printf(
                "%nseed %d: %d worlds in %.0f s, %d broke a law%n",
                seed, done, spent, tally.failing());
        return tally.failing() == 0 ? 0 : 1;
    }

    private void tell(FuzzWorld fuzz, Map<Law, Breach> broken, PrintStream out) {
        for (Breach breach : broken.values()) {
            out.printf(
                    "world %d, %s, %d bodies: %s%n",
                    fuzz.index(), fuzz.family(), fuzz.movers(), breach);
        }
        if (broken.isEmpty() || kept >= keep) {
            return;
        }
        kept++;
        Breach first = broken.values().iterator().next();
        FuzzWorld least = Shrinker.shrink(fuzz, first);
        Breach still = Laws.broken(least, first.law() == Law.BITS).get(first.law());
        Path file = folder.resolve("%d-%d.json".formatted(fuzz.seed(), fuzz.index()));
        SceneFile scene = least.scene();
        SceneFile told =
                scene.withDescription(
                        "%s; family %s, ticks %s of %s s, sleep %s"
                                .formatted(
                                        still == null ? first : still,
                                        least.family(),
                                        least.pace(),
                                        scene.tick().seconds(),
                                        least.sleeping() ? "on" : "off"));
        try {
            Files.createDirectories(folder);
        } catch (IOException unwritable) {
            throw new UncheckedIOException(
                    "--to %s: the folder could not be made: %s"
                            .formatted(folder, unwritable.getMessage()),
                    unwritable);
        }
        SceneWriter.write(told, file);
        out.printf(
                "  as small as it goes, %d bodies: %s%n  written: %s%n",
                least.movers(), still == null ? first : still, file);
    }

    private static ProgressBar bar(long worlds, PrintStream err) {
        return new ProgressBarBuilder()
                .setTaskName("worlds")
                .setInitialMax(worlds)
                .setStyle(ProgressBarStyle.ASCII)
                .setUpdateIntervalMillis(200)
                .setConsumer(new ConsoleProgressBarConsumer(err, BAR_WIDTH))
                .build();
    }
}
