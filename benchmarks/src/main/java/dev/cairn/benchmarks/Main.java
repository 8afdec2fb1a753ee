package dev.cairn.benchmarks;

import dev.cairn.benchmarks.compare.Compare;
import dev.cairn.benchmarks.cost.Cost;
import dev.cairn.benchmarks.narrowphase.ErrorAgainstTime;
import dev.cairn.benchmarks.regress.Regress;
import dev.cairn.benchmarks.render.RenderFrame;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;

/**
 * Entry of {@code benchmarks.jar}: {@code compare} starts the work-precision report, {@code cost}
 * the price list, {@code regress} the headline figures, {@code render-frame} the CPU time of a
 * drawn frame; all else is JMH's own command line.
 */
public final class Main {
    private static final String VECTORS = "jdk.incubator.vector";

    /** Commands that step worlds in this JVM, which then needs the vectors. */
    private static final Set<String> MEASURE_HERE = Set.of("cost", "narrow-phase");

    private Main() {}

    /**
     * Starts the report or JMH.
     *
     * @param args a command and its options, or JMH's arguments
     * @throws IOException if JMH cannot read its list of benchmarks
     */
    public static void main(String[] args) throws IOException {
        String command = args.length == 0 ? "" : args[0];
        if (MEASURE_HERE.contains(command)
                && ModuleLayer.boot().findModule(VECTORS).isEmpty()
                && !Arrays.asList(args).contains("--help")) {
            System.exit(again(args));
        }
        switch (command) {
            case "compare" -> Compare.main(Arrays.copyOfRange(args, 1, args.length));
            case "cost" -> Cost.main(Arrays.copyOfRange(args, 1, args.length));
            case "narrow-phase" -> ErrorAgainstTime.main(Arrays.copyOfRange(args, 1, args.length));
            case "regress" -> Regress.main(Arrays.copyOfRange(args, 1, args.length));
            case "render-frame" -> RenderFrame.main(Arrays.copyOfRange(args, 1, args.length));
            default -> org.openjdk.jmh.Main.main(args);
        }
    }

    /** Does the same in a JVM that has the vector module; returns its status. */
    private static int again(String[] args) throws IOException {
        List<String> command = new ArrayList<>();
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        command.addAll(ManagementFactory.getRuntimeMXBean().getInputArguments());
        command.add("--add-modules=" + VECTORS);
        command.addAll(List.of("-cp", System.getProperty("java.class.path"), Main.class.getName()));
        command.addAll(Arrays.asList(args));
        try {
            return new ProcessBuilder(command).inheritIO().start().waitFor();
        } catch (InterruptedException stop) {
            Thread.currentThread().interrupt();
            return 1;
        }
    }
}
