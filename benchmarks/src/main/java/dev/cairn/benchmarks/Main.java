package dev.cairn.benchmarks;

import dev.cairn.benchmarks.compare.Compare;
import dev.cairn.benchmarks.compare.Start;
import dev.cairn.benchmarks.cost.Cost;
import dev.cairn.benchmarks.cost.Scaling;
import dev.cairn.benchmarks.narrowphase.ErrorAgainstTime;
import dev.cairn.benchmarks.regress.Regress;
import dev.cairn.benchmarks.render.EffectFrame;
import dev.cairn.benchmarks.render.RenderFrame;
import dev.cairn.samples.Launched;

import java.io.IOException;
import java.util.Arrays;

/**
 * What {@code benchmarks.jar} runs: {@code compare} starts the work-precision report, {@code start}
 * times the first seconds of a JVM, {@code cost} the price list, {@code scaling} times by workers,
 * {@code regress} the headline figures, {@code render-frame} the CPU time of a drawn frame, {@code
 * effect-frame} what effects cost; all else is JMH's own command line.
 */
public final class Main {
    private Main() {}

    /**
     * Starts the report or JMH.
     *
     * @param args a command and its options, or JMH's arguments
     * @throws IOException if JMH cannot read its list of benchmarks
     */
    public static void main(String[] args) throws IOException {
        Launched.endWithLauncher();
        String command = args.length == 0 ? "" : args[0];
        switch (command) {
            case "compare" -> Compare.main(Arrays.copyOfRange(args, 1, args.length));
            case "start" -> Start.main(Arrays.copyOfRange(args, 1, args.length));
            case "cost" -> Cost.main(Arrays.copyOfRange(args, 1, args.length));
            case "scaling" -> Scaling.main(Arrays.copyOfRange(args, 1, args.length));
            case "narrow-phase" -> ErrorAgainstTime.main(Arrays.copyOfRange(args, 1, args.length));
            case "regress" -> Regress.main(Arrays.copyOfRange(args, 1, args.length));
            case "render-frame" -> RenderFrame.main(Arrays.copyOfRange(args, 1, args.length));
            case "effect-frame" -> EffectFrame.main(Arrays.copyOfRange(args, 1, args.length));
            default -> org.openjdk.jmh.Main.main(args);
        }
    }
}
