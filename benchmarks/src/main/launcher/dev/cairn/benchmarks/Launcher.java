package dev.cairn.benchmarks;

/**
 * Starts the benchmarks on a Java that can run them, with the flags that they need: what the
 * samples' launcher does, with another {@code Main}. Compiled for Java 8.
 */
public final class Launcher {
    private Launcher() {}

    /**
     * Runs the benchmarks and ends this process with their exit code.
     *
     * @param arguments a command and its options, or JMH's arguments
     */
    public static void main(String[] arguments) {
        dev.cairn.samples.Launcher.launch(
                "dev.cairn.benchmarks.Main", "Cairn's benchmarks", arguments);
    }
}
