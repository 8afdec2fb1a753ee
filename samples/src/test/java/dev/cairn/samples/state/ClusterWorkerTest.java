package dev.cairn.samples.state;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;

import dev.cairn.samples.Main;

import org.junit.jupiter.api.Test;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * The worker's side of a cluster, as {@code docs/state.md} tells it: an engine such as Spark or Ray
 * maps seeds to results by calling the headless runner, in whatever order and place, and gathers
 * one JSON document of each.
 */
class ClusterWorkerTest {
    /** What a worker does with a seed: {@code seeds.map(worker)}. */
    private static JsonObject worker(long seed) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        int code =
                Main.run(
                        arguments(seed),
                        new PrintStream(out, true, StandardCharsets.UTF_8),
                        new PrintStream(err, true, StandardCharsets.UTF_8),
                        false);
        assertEquals(0, code, err::toString);
        return JsonParser.parseString(out.toString(StandardCharsets.UTF_8)).getAsJsonObject();
    }

    private static String[] arguments(long seed) {
        String line = "--headless --scene pile --set boxes=12 --ticks 30 --workers 1 --json -";
        return (line + " --seed " + seed).split(" ");
    }

    private static Map<Long, String> digests(List<Long> seeds) {
        Map<Long, String> digests = new TreeMap<>();
        for (long seed : seeds) {
            JsonObject report = worker(seed);
            assertEquals("pile", report.get("scene").getAsString());
            assertEquals(30, report.get("ticks").getAsInt());
            assertTrue(report.get("kineticEnergy").getAsDouble() >= 0);
            digests.put(seed, report.get("digest").getAsString());
        }
        return digests;
    }

    @Test
    void seedsAreRunInAnyOrderWithTheSameResults() {
        List<Long> seeds = new ArrayList<>(List.of(1L, 2L, 3L, 17L, 18L));
        Map<Long, String> one = digests(seeds);
        assertEquals(one, digests(seeds.reversed()));
        assertEquals(seeds.size(), new HashSet<>(one.values()).size(), "each seed is another run");
    }

    /** As the page's function does it: a process for each seed, whose output is the document. */
    @Test
    void aProcessWritesOneDocumentAndNothingElse() throws IOException, InterruptedException {
        List<String> command = new ArrayList<>();
        command.add(ProcessHandle.current().info().command().orElseThrow());
        command.addAll(List.of("--add-modules=jdk.incubator.vector", "-cp"));
        command.addAll(List.of(System.getProperty("java.class.path"), Main.class.getName()));
        command.addAll(List.of(arguments(17)));
        Process process =
                new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.DISCARD).start();
        String out = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(0, process.waitFor(), out);
        JsonObject report = JsonParser.parseString(out).getAsJsonObject();
        assertEquals(worker(17).get("digest"), report.get("digest"));
    }
}
