package dev.cairn.samples.accuracy;

import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.tuning.Precision;
import dev.cairn.physics.tuning.Tunable;
import dev.cairn.samples.accuracy.AccuracyCase.Effort;

import me.tongfei.progressbar.ConsoleProgressBarConsumer;
import me.tongfei.progressbar.ProgressBar;
import me.tongfei.progressbar.ProgressBarBuilder;
import me.tongfei.progressbar.ProgressBarStyle;

import org.jspecify.annotations.Nullable;

import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

import java.io.IOException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** {@code samples accuracy}: runs the cases and writes the table. Main thread. */
@Command(
        name = "samples accuracy",
        mixinStandardHelpOptions = true,
        sortOptions = false,
        usageHelpWidth = 100,
        description = {
            "Compares Cairn with closed forms at 1, 2, 4, 8 and 16 sub-steps, and prints the"
                    + " table.",
            "Without names: every case but the long ones."
        })
public final class AccuracyCommand {
    /** Numbers of sub-steps of the table. */
    static final int[] SUBSTEPS = {1, 2, 4, 8, 16};

    /** Where the bars are. */
    static final int DEFAULT_SUBSTEPS = 4;

    private static final int BAR_WIDTH = 100;

    @Parameters(
            arity = "0..*",
            paramLabel = "CASE",
            description = "Cases or groups, such as B2 or E; all by default.")
    List<String> names = new ArrayList<>();

    @Option(names = "--quick", description = "Only cases that take less than a second or two.")
    boolean quick;

    @Option(names = "--long", description = "The long cases too: some minutes more.")
    boolean all;

    @Option(
            names = "--direct-from",
            paramLabel = "N",
            description =
                    "Bodies from end to end of a slender island at rest from which on it is solved"
                            + " directly, 0 for never; 24 by default, as in the tables.")
    int directFrom = PhysicsSettings.DEFAULT.tuning().count(Tunable.DIRECT_FROM);

    @Option(
            names = "--precision",
            paramLabel = "auto|double|single",
            description =
                    "Numbers that contacts are solved in; auto by default, as in the tables: floats"
                            + " for islands of more than 1024 contacts.")
    Precision precision = Precision.AUTO;

    @Option(names = "--list", description = "Print the cases and end.")
    boolean list;

    @Option(
            names = "--write",
            paramLabel = "FILE.md",
            description =
                    "Put the tables into a Markdown file, below its line <!-- accuracy -->, and the"
                            + " numbers beside it into a .csv file.")
    @Nullable Path write;

    private AccuracyCommand() {}

    /**
     * Runs the command.
     *
     * @param arguments what follows the word accuracy
     * @param out standard output: the table
     * @param err standard error: progress and refusals
     * @param terminal whether a person watches, who gets a progress bar
     * @return the exit code: 0 done, whether the bars hold or not; 2 the options make no sense
     */
    public static int run(String[] arguments, PrintStream out, PrintStream err, boolean terminal) {
        AccuracyCommand command = new AccuracyCommand();
        CommandLine line = new CommandLine(command).setCaseInsensitiveEnumValuesAllowed(true);
        try {
            CommandLine.ParseResult parsed = line.parseArgs(arguments);
            if (parsed.isUsageHelpRequested()) {
                line.usage(out);
                return 0;
            }
            command.run(out, err, terminal);
            return 0;
        } catch (CommandLine.ParameterException | IllegalArgumentException wrong) {
            err.println(wrong.getMessage() + "; samples accuracy --help lists the options");
            return 2;
        }
    }

    private void run(PrintStream out, PrintStream err, boolean terminal) {
        List<AccuracyCase> cases = chosen();
        if (list) {
            for (AccuracyCase one : cases) {
                out.printf("%-6s %-28s %s%n", one.id(), one.title(), one.effort());
            }
            return;
        }
        List<AccuracyRow> rows = new ArrayList<>();
        try (ProgressBar bar = progress(cases, err, terminal)) {
            for (AccuracyCase one : cases) {
                if (bar != null) {
                    bar.setExtraMessage(" " + one.id());
                }
                rows.add(measure(one, bar));
            }
        }
        String text = AccuracyText.markdown(rows);
        out.print(text);
        double seconds = 0;
        for (AccuracyRow row : rows) {
            seconds += row.seconds();
        }
        out.printf("%n%d cases in %.0f s%n", rows.size(), seconds);
        if (write != null) {
            store(write, text, AccuracyText.csv(rows));
        }
    }

    /** Named cases are run whatever their length. */
    private List<AccuracyCase> chosen() {
        List<AccuracyCase> chosen = new ArrayList<>();
        for (String name : names) {
            boolean any = false;
            for (AccuracyCase one : AccuracyCases.all()) {
                if (one.id().equalsIgnoreCase(name)
                        || (name.length() == 1
                                && one.id().startsWith(name.toUpperCase(java.util.Locale.ROOT)))) {
                    chosen.add(one);
                    any = true;
                }
            }
            if (!any) {
                AccuracyCases.get(name);
            }
        }
        if (names.isEmpty()) {
            for (AccuracyCase one : AccuracyCases.all()) {
                if (all
                        || one.effort() == Effort.SHORT
                        || (!quick && one.effort() != Effort.LONG)) {
                    chosen.add(one);
                }
            }
        }
        return chosen;
    }

    private static boolean runs(AccuracyCase one, int substeps) {
        return substeps == DEFAULT_SUBSTEPS
                || (one.effort() != Effort.HEAVY && one.effort() != Effort.LONG);
    }

    private AccuracyRow measure(AccuracyCase one, @Nullable ProgressBar bar) {
        long start = System.nanoTime();
        Map<Integer, double[]> values = new TreeMap<>();
        double micros = Double.NaN;
        for (int n : SUBSTEPS) {
            if (runs(one, n)) {
                Trial trial = new Trial(n, precision, directFrom);
                values.put(n, one.experiment().run(trial));
                if (n == DEFAULT_SUBSTEPS) {
                    micros = trial.microsPerBodyStep();
                }
                if (bar != null) {
                    bar.step();
                }
            }
        }
        return new AccuracyRow(one, values, micros, (System.nanoTime() - start) / 1e9);
    }

    private static @Nullable ProgressBar progress(
            List<AccuracyCase> cases, PrintStream err, boolean terminal) {
        if (!terminal) {
            return null;
        }
        int total = 0;
        for (AccuracyCase one : cases) {
            for (int n : SUBSTEPS) {
                total += runs(one, n) ? 1 : 0;
            }
        }
        return new ProgressBarBuilder()
                .setTaskName("runs")
                .setInitialMax(total)
                .setStyle(ProgressBarStyle.ASCII)
                .setUpdateIntervalMillis(100)
                .setConsumer(new ConsoleProgressBarConsumer(err, BAR_WIDTH))
                .build();
    }

    private static void store(Path file, String text, String csv) {
        String mark = "<!-- accuracy -->\n";
        try {
            String old = Files.exists(file) ? Files.readString(file) : "# Accuracy\n\n" + mark;
            int at = old.indexOf(mark);
            String head = at < 0 ? old + "\n" + mark : old.substring(0, at + mark.length());
            Files.writeString(file, head + text);
            String name = String.valueOf(file.getFileName()).replaceFirst("\\.md$", "") + ".csv";
            Files.write(file.resolveSibling(name), csv.getBytes(StandardCharsets.UTF_8));
        } catch (IOException unwritable) {
            throw new UncheckedIOException(
                    "--write %s: the table could not be written: %s"
                            .formatted(file, unwritable.getMessage()),
                    unwritable);
        }
    }
}
