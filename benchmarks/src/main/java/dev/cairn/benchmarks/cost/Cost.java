package dev.cairn.benchmarks.cost;

import dev.cairn.benchmarks.Marked;
import dev.cairn.benchmarks.WarmUp;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;

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
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.concurrent.Callable;

/** The command that measures the price list and the ablation ladder. */
@Command(
        name = "cost",
        mixinStandardHelpOptions = true,
        description =
                "Marginal costs by regression over generated scenes, and the ablation ladder.")
public final class Cost implements Callable<Integer> {
    private static final Marked TABLES = new Marked("cost");
    private static final PhysicsSettings AWAKE = PhysicsSettings.DEFAULT.withSleeping(false);
    private static final Mix BIG = new Mix(50, 50, 20, 100, 200, 100, 50, 0, 0, 0.6);
    private static final long SEED = 1;
    private static final int REPEATS = 3;

    /** Two-sided 95 % of Student's t for the some dozens of degrees of freedom here. */
    private static final double T95 = 2.0;

    @Option(
            names = "--scenes",
            paramLabel = "N",
            defaultValue = "60",
            description = "generated scenes, default: ${DEFAULT-VALUE}")
    private int scenes = 60;

    @Option(
            names = "--pairs",
            paramLabel = "N",
            defaultValue = "40",
            description = "pairs of turns per build, default: ${DEFAULT-VALUE}")
    private int pairs = 40;

    @Option(
            names = "--builds",
            paramLabel = "N",
            defaultValue = "30",
            description = "pairs of worlds per rung of the ladder, default: ${DEFAULT-VALUE}")
    private int builds = 30;

    @Option(names = "--ladder-only", description = "leaves the price list out; prints")
    private boolean ladderOnly;

    @Option(
            names = "--out",
            paramLabel = "FILE",
            description = "replaces the tables in this file, docs/cost.md; else they are printed")
    private @Nullable Path out;

    private final PrintStream err = System.err;
    private final ThreadTime time = new ThreadTime();

    private Cost() {}

    /**
     * Runs the command and ends the JVM with its status.
     *
     * @param args its options; {@code --help} lists them
     */
    public static void main(String[] args) {
        System.exit(new CommandLine(new Cost()).execute(args));
    }

    @Override
    public Integer call() throws IOException {
        if (scenes < 3 * Mix.NAMES.size() || pairs < 3 || builds < 3) {
            err.printf(
                    "--scenes %d, --pairs %d, --builds %d: want at least %d scenes, 3 pairs, 3"
                            + " builds%n",
                    scenes, pairs, builds, 3 * Mix.NAMES.size());
            return CommandLine.ExitCode.USAGE;
        }
        if (ladderOnly) {
            System.out.println(ladder());
            return CommandLine.ExitCode.OK;
        }
        if (out == null) {
            System.out.println(priceLists() + "\n" + ladder());
            return CommandLine.ExitCode.OK;
        }
        String page = TABLES.page(out);
        try {
            // now, and not after minutes of measuring
            TABLES.replaced(page, "");
        } catch (IllegalArgumentException unmarked) {
            err.printf("--out %s: %s%n", out, unmarked.getMessage());
            return CommandLine.ExitCode.USAGE;
        }
        String tables = priceLists() + "\n" + ladder();
        Files.writeString(out, TABLES.replaced(page, tables), StandardCharsets.UTF_8);
        return CommandLine.ExitCode.OK;
    }

    private String priceLists() {
        return priceList(false) + "\n" + priceList(true);
    }

    /** Measures all scenes over and over, and keeps each scene's median time. */
    private String priceList(boolean wide) {
        if (wide) {
            try (PhysicsWorld world = BIG.build(AWAKE)) {
                WarmUp.untilQuiet(() -> {
                    for (int tick = 0; tick < 120; tick++) {
                        world.step(1.0 / 60);
                    }
                });
            }
        }
        SplittableRandom random = new SplittableRandom(SEED);
        List<Mix> mixes = new ArrayList<>();
        for (int i = 0; i < scenes; i++) {
            mixes.add(Mix.random(random, wide));
        }
        double[][] micros = new double[scenes][REPEATS];
        double[][] counts = new double[scenes][];
        // The first pass warms up.
        for (int pass = -1; pass < REPEATS; pass++) {
            err.printf(
                    "price list, %s contacts, pass %d of %d%n",
                    wide ? "many" : "few", pass + 2, REPEATS + 1);
            for (int i = 0; i < scenes; i++) {
                Mix.Sample sample = mixes.get(i).measure(AWAKE, time);
                counts[i] = sample.counts();
                if (pass >= 0) {
                    micros[i][pass] = sample.micros();
                }
            }
        }
        double[] y = new double[scenes];
        double[] weights = new double[scenes];
        for (int i = 0; i < scenes; i++) {
            y[i] = Ladder.median(micros[i]);
            // Errors are shares of the time.
            weights[i] = 1 / (y[i] * y[i]);
        }
        LeastSquares fit = LeastSquares.fit(counts, y, weights);
        StringBuilder text = new StringBuilder();
        text.append(
                String.format(
                        Locale.ROOT,
                        "Price list, scenes of %s: %d scenes, seed %d, median of %d passes,"
                                + " one worker, 4 sub-steps, R² = %.4f. Nanoseconds of CPU time per"
                                + " tick.%n%n",
                        wide
                                ? "more than 300 contacts, solved several at once"
                                : "fewer than 230 contacts, solved one by one",
                        scenes,
                        SEED,
                        REPEATS,
                        fit.rSquared()));
        text.append("| one more | ns per tick | 95 % |\n|---|---|---|\n");
        for (int k = 0; k < Mix.NAMES.size(); k++) {
            text.append(
                    String.format(
                            Locale.ROOT,
                            "| %s | %.0f | ± %.0f |%n",
                            Mix.NAMES.get(k),
                            1e3 * fit.coefficients()[k],
                            1e3 * T95 * fit.errors()[k]));
        }
        return text.toString();
    }

    private String ladder() {
        StringBuilder text = new StringBuilder();
        text.append(
                String.format(
                        Locale.ROOT,
                        "Ablation ladder: CPU time with the feature over without it; median of %d"
                                + " pairs of worlds, each the median of %d pairs of turns; 95 %% by"
                                + " bootstrap over the worlds.%n%n",
                        builds,
                        pairs));
        text.append("| feature | the scene | with / without | 95 % | same bits |\n");
        text.append("|---|---|---|---|---|\n");
        for (Ladder.Rung rung : Ladder.RUNGS) {
            err.printf("ladder, %s%n", rung.feature());
            Ladder.Found found = Ladder.climb(rung, builds, pairs, time);
            text.append(
                    String.format(
                            Locale.ROOT,
                            "| %s | %s%s | %.3f | %.3f to %.3f | %s |%n",
                            rung.feature(),
                            rung.isNull()
                                    ? ""
                                    : rung.needed() ? "needs it: " : "does not need it: ",
                            rung.with().flyingBoxes() > 0 ? "400 bodies in flight" : "300 at rest",
                            found.ratio(),
                            found.low(),
                            found.high(),
                            found.sameBits() ? "yes" : "no"));
        }
        return text.toString();
    }
}
