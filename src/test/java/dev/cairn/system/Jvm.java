package dev.cairn.system;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;

/** Starts a program in a JVM of their own, with this JVM's class path and Java. */
public final class Jvm {
    private static final long LIMIT_SECONDS = 900;

    private Jvm() {}

    /** A run that is over before the optimising compiler is done does without it. */
    private static final String BRIEF = "-XX:TieredStopAtLevel=1";

    /** Standard output of a run of the samples that must end with exit code 0. */
    static String samples(Path directory, List<String> flags, List<String> arguments)
            throws IOException, InterruptedException {
        return run(directory, flags, "dev.cairn.samples.Main", arguments);
    }

    /** Standard output of a run that must end with exit code 0; it starts where this JVM did. */
    static String run(Path directory, List<String> flags, String mainClass, List<String> arguments)
            throws IOException, InterruptedException {
        return run(Path.of("").toAbsolutePath(), directory, flags, mainClass, arguments);
    }

    /** The same of one that starts in the directory, and so finds and leaves files there. */
    public static String runInside(Path directory, String mainClass, List<String> arguments)
            throws IOException, InterruptedException {
        return run(directory, directory, List.of(BRIEF), mainClass, arguments);
    }

    private static String run(
            Path start,
            Path directory,
            List<String> flags,
            String mainClass,
            List<String> arguments)
            throws IOException, InterruptedException {
        List<String> command = new ArrayList<>();
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        if (flags.stream().noneMatch(flag -> flag.startsWith("--limit-modules"))) {
            command.add("--add-modules=jdk.incubator.vector");
        }
        command.addAll(
                List.of(
                        "--enable-native-access=ALL-UNNAMED",
                        "--sun-misc-unsafe-memory-access=allow",
                        "-cp",
                        System.getProperty("java.class.path")));
        command.addAll(flags);
        command.add(mainClass);
        command.addAll(arguments);
        Path out = Files.createTempFile(directory, "out", ".txt");
        Path err = Files.createTempFile(directory, "err", ".txt");
        Process process =
                new ProcessBuilder(command)
                        .directory(start.toFile())
                        .redirectOutput(out.toFile())
                        .redirectError(err.toFile())
                        .start();
        boolean ended = process.waitFor(LIMIT_SECONDS, TimeUnit.SECONDS);
        if (!ended) {
            process.destroyForcibly();
        }
        String errors = Files.readString(err, StandardCharsets.UTF_8);
        assertTrue(ended, () -> "still running after " + LIMIT_SECONDS + " s: " + errors);
        assertEquals(0, process.exitValue(), errors);
        return Files.readString(out, StandardCharsets.UTF_8);
    }
}
