package dev.cairn.benchmarks;

import dev.cairn.benchmarks.compare.Compare;

import java.io.IOException;
import java.util.Arrays;

/**
 * Entry of {@code benchmarks.jar}: {@code compare} starts the work-precision report, all else is
 * JMH's own command line.
 */
public final class Main {
    private Main() {}

    /**
     * Starts the report or JMH.
     *
     * @param args {@code compare} and its options, or JMH's arguments
     * @throws IOException if JMH cannot read its list of benchmarks
     */
    public static void main(String[] args) throws IOException {
        if (args.length > 0 && args[0].equals("compare")) {
            Compare.main(Arrays.copyOfRange(args, 1, args.length));
        } else {
            org.openjdk.jmh.Main.main(args);
        }
    }
}
