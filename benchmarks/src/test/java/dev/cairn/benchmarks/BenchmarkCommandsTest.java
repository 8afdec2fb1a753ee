package dev.cairn.benchmarks;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import dev.cairn.render.app.Offscreen;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;

/**
 * The reports of {@code benchmarks.jar} that the docs name, in a small form and a JVM of their own,
 * to their end; JMH's are with {@link SmokeTest}. What they measure here is worth nothing.
 */
final class BenchmarkCommandsTest {
    private static final long LIMIT_SECONDS = 120;

    @TempDir Path folder;

    @Test
    void compareWritesItsReport() throws IOException, InterruptedException {
        run(
                "compare --quick --scenes stack-4 --engines cairn --substeps 1 --rounds 1"
                        + " --patience 0.1 --defaults-only --out report");
        assertTrue(Files.readString(folder.resolve("report/report.html")).contains("stack-4"));
        assertTrue(Files.size(folder.resolve("report/results.csv")) > 100);
    }

    @Test
    void startHasALineForEachEngine() throws IOException, InterruptedException {
        String said = run("start --scenes stack-4 --engines cairn --seconds 2");
        assertTrue(said.lines().anyMatch(line -> line.matches("stack-4 +cairn +[\\d.]+ .*")), said);
    }

    @Test
    @Tag("soak")
    void costWritesItsTables() throws IOException, InterruptedException {
        String said = run("cost --ladder-only --pairs 3 --builds 3");
        assertTrue(said.contains("| feature | the scene |"), said);
    }

    @Test
    void scalingHasALineForEachNumberOfWorkers() throws IOException, InterruptedException {
        List<String> rows =
                run("scaling --scenes washer --ticks 3 1 2")
                        .lines()
                        .filter(line -> line.startsWith("washer"))
                        .toList();
        assertEquals(2, rows.size());
        assertTrue(rows.stream().noneMatch(row -> row.contains("OTHER BITS")), rows.toString());
    }

    @Test
    @Tag("soak")
    void regressKeepsItsFigures() throws IOException, InterruptedException {
        run("regress --runs 1 --rounds 1 --folder figures");
        try (var files = Files.list(folder.resolve("figures"))) {
            assertEquals(1, files.filter(file -> file.toString().endsWith(".json")).count());
        }
    }

    @Test
    void framesOfTheRenderer() throws IOException, InterruptedException {
        assumeTrue(Offscreen.unavailableReason() == null, "nothing draws here");
        assertTrue(run("render-frame 10").lines().anyMatch(line -> line.startsWith("     10")));
        String said = run("effect-frame 2 1");
        assertTrue(said.contains("all but filmic"), said);
    }

    private String run(String line) throws IOException, InterruptedException {
        List<String> command =
                new ArrayList<>(
                        List.of(
                                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                                "--add-modules=jdk.incubator.vector",
                                "--enable-native-access=ALL-UNNAMED",
                                "--sun-misc-unsafe-memory-access=allow",
                                "-XX:TieredStopAtLevel=1",
                                "-cp",
                                System.getProperty("java.class.path"),
                                Main.class.getName()));
        command.addAll(Arrays.asList(line.split(" ", -1)));
        Path out = folder.resolve("out.txt");
        Path err = folder.resolve("err.txt");
        ProcessBuilder builder =
                new ProcessBuilder(command)
                        .directory(folder.toFile())
                        .redirectOutput(out.toFile())
                        .redirectError(err.toFile());
        // The driver checks what it is told and draws nothing: the rasteriser would take minutes.
        builder.environment().put("GALLIUM_NOOP", "1");
        builder.environment().put("LIBGL_ALWAYS_SOFTWARE", "1");
        Process process = builder.start();
        boolean ended = process.waitFor(LIMIT_SECONDS, TimeUnit.SECONDS);
        process.destroyForcibly();
        String errors = Files.readString(err, StandardCharsets.UTF_8);
        assertTrue(ended, () -> line + " has not ended: " + errors);
        assertEquals(0, process.waitFor(), line + ": " + errors);
        return Files.readString(out, StandardCharsets.UTF_8);
    }
}
