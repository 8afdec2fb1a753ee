package dev.cairn.samples.scenefile;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.PhysicsWorld;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneOptions;
import dev.cairn.samples.UsageException;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;

/**
 * Good files run the same after they were written again. Of damaged ones each is read, or told
 * about in one line; what is read is built, or told about; what is built runs.
 */
class BrokenFilesTest {
    private static final SceneOptions NO_OPTIONS = new SceneOptions(Map.of(), 1, null);
    private static final Pattern NUMBER = Pattern.compile("-?\\d[\\d.eE+-]*");
    private static final Pattern WORD = Pattern.compile("\"[^\"\\\\\\n]*\"");
    private static final List<String> NUMBERS =
            List.of(
                    "0",
                    "-0",
                    "1",
                    "-1",
                    "2",
                    "0.5",
                    "1e-6",
                    "1e-9",
                    "1e-300",
                    "4.9e-324",
                    "1e6",
                    "1e9",
                    "-1e9",
                    "2147483647",
                    "-2147483648",
                    "4294967296",
                    "1e16",
                    "1e100",
                    "1e154",
                    "1e300",
                    "-1.7976931348623157e308",
                    "1e999",
                    "NaN",
                    "63",
                    "64",
                    "1e7");
    private static final List<String> WORDS =
            List.of(
                    "null",
                    "true",
                    "{}",
                    "[]",
                    "[[]]",
                    "\"\"",
                    "\"builtin:glass\"",
                    "\"mesh\"",
                    "\"moved\"",
                    "\"fixed\"",
                    "\"dynamic\"",
                    "\"none\"",
                    "\"parts\"",
                    "\"\\u0000\"",
                    "\"\\ud83d\"",
                    "\"/dev/zero\"",
                    "\"../..\"",
                    "\"hinge\"",
                    "\"path\"",
                    "\"gear\"");

    @TempDir private Path folder;

    private void files() throws IOException {
        Files.writeString(
                folder.resolve("tetra.obj"),
                "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    }

    // Damage -----------------------------------------------------------------------------------

    static String damaged(String text, SplittableRandom random) {
        String now = text;
        if (random.nextBoolean()) { // still JSON, so that more of it is read
            for (int i = random.nextInt(3); i >= 0; i--) {
                now = replaced(now, NUMBER, NUMBERS, random);
            }
            return now;
        }
        for (int i = random.nextInt(4); i >= 0; i--) {
            now = once(now, random);
        }
        return now;
    }

    private static String once(String text, SplittableRandom random) {
        if (text.length() < 2) {
            return text + "[";
        }
        int at = random.nextInt(text.length());
        int to = Math.min(text.length(), at + 1 + random.nextInt(30));
        return switch (random.nextInt(12)) {
            case 0 -> {
                byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
                bytes[random.nextInt(bytes.length)] ^= (byte) (1 << random.nextInt(8));
                yield new String(bytes, StandardCharsets.UTF_8);
            }
            case 1 -> text.substring(0, at) + text.substring(to);
            case 2 -> text.substring(0, to) + text.substring(at);
            case 3 -> text.substring(0, at);
            case 4, 5 -> lines(text, random);
            case 6, 7, 8 -> replaced(text, NUMBER, NUMBERS, random);
            case 9, 10 -> replaced(text, WORD, WORDS, random);
            default -> {
                String deep = (random.nextBoolean() ? "[" : "{\"a\":").repeat(random.nextInt(2000));
                yield text.substring(0, at) + deep + text.substring(at);
            }
        };
    }

    private static String lines(String text, SplittableRandom random) {
        List<String> lines = new ArrayList<>(text.lines().toList());
        int i = random.nextInt(lines.size());
        switch (random.nextInt(3)) {
            case 0 -> lines.remove(i);
            case 1 -> lines.add(i, lines.get(i));
            default -> Collections.swap(lines, i, random.nextInt(lines.size()));
        }
        return String.join("\n", lines) + "\n";
    }

    private static String replaced(
            String text, Pattern what, List<String> by, SplittableRandom random) {
        List<MatchResult> all = what.matcher(text).results().toList();
        if (all.isEmpty()) {
            return text + "]";
        }
        MatchResult one = all.get(random.nextInt(all.size()));
        String with = by.get(random.nextInt(by.size()));
        return text.substring(0, one.start()) + with + text.substring(one.end());
    }

    // What must hold ---------------------------------------------------------------------------

    /** What became of a file: read and run, told by the reader, told by the builder. */
    String live(String text) {
        SceneFile scene;
        try {
            scene = SceneReader.parse("file.json", text);
        } catch (SceneFileException told) {
            oneLine(told);
            return "no scene";
        }
        String written = SceneWriter.text(scene);
        SceneFile again = SceneReader.parse("again.json", written);
        assertTrue(scene.equals(again), "read, written and read");
        assertEquals(written, SceneWriter.text(again));
        String first = world(scene);
        assertEquals(first, world(again), "the worlds of both");
        return first.startsWith("digest") ? "runs" : "no world";
    }

    private String world(SceneFile scene) {
        try (PhysicsWorld world =
                PhysicsWorld.builder().workers(1).substeps(scene.tick().substeps()).build()) {
            SceneBuilder into = new SceneBuilder(world, NO_OPTIONS);
            try {
                SceneLoader.sample("file", "file.json", folder, scene).build(into);
            } catch (UsageException told) {
                oneLine(told);
                return String.valueOf(told.getMessage());
            }
            into.remarks().forEach(said -> assertEquals(1, said.lines().count(), said));
            for (int i = 0; i < 30; i++) {
                into.beforeTick();
                world.step(scene.tick().seconds());
                into.afterTick();
            }
            return "digest " + world.digest();
        }
    }

    private static void oneLine(Exception told) {
        String message = String.valueOf(told.getMessage());
        assertEquals(1, message.lines().count(), message);
        assertTrue(message.length() < 2000, () -> message.length() + " letters");
        assertTrue(message.chars().noneMatch(Character::isISOControl), message);
        assertTrue(!message.contains("Exception"), message);
    }

    private void damage(long first, long count) throws IOException {
        files();
        for (long seed = first; seed < first + count; seed++) {
            String good = SceneWriter.text(RandomScene.of(seed / 20));
            String text = seed % 20 == 0 ? good : damaged(good, new SplittableRandom(seed));
            try {
                live(text);
            } catch (RuntimeException | Error failed) {
                throw new AssertionError("seed " + seed + ": " + failed + "\n" + text, failed);
            }
        }
    }

    /** Half of a pair of surrogates has no bytes of its own. */
    @Test
    void halvesOfLettersAreSavedAndRead() {
        SceneFile scene =
                SceneFile.empty("\ud83d, \ude00\ud83d\ude00")
                        .withLayers(List.of("\ud83d", "whole \ud83d\ude00"));
        Path file = folder.resolve("half.json");
        SceneWriter.write(scene, file);
        assertEquals(scene, SceneReader.read(file));
    }

    @Test
    void damagedFilesAreToldInOneLineOrRun() throws IOException {
        damage(0, Long.getLong("files.count", 300));
    }

    @Test
    @Tag("soak")
    void manyDamagedFiles() throws IOException {
        damage(Long.getLong("soak.seed", 1000), Long.getLong("soak.files", 100_000));
    }
}
