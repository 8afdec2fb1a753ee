package dev.cairn.system;

import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.render.app.Offscreen;
import dev.cairn.samples.Main;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;

/**
 * Command lines of the pages for users, run as they stand there, one after the other in an empty
 * folder. Left out are those that open a window (tests of the window do that) and what takes
 * minutes: of the animations, the accuracy cases, the laws and the pictures of the docs other tests
 * run a shorter form ({@code GalleryTest}, {@code TruthsTest}, {@code LawsTest}, {@code
 * ThumbnailsTest}); a moment is written by a key of the window ({@code MomentFileTest}).
 */
final class CommandRunsTest {
    private static final List<String> PAGES =
            List.of("first-ten-minutes", "levels", "scene-files", "state");

    private static final List<String> LEFT_OUT = List.of("--window", "--from moment.cairn");

    /** What the pages take as given: scenes and a mesh of the reader's own. */
    private static final List<String> BEFORE =
            List.of(
                    "--scene stack --export-scene my.json",
                    "--scene stack --export-scene my-scene.json");

    private static final String MUG =
            """
            v 0 0 0
            v 1 0 0
            v 0 1 0
            v 0 0 1
            f 1 3 2
            f 1 2 4
            f 1 4 3
            f 2 3 4
            """;

    /** Runs the lines that it is given, all in its own folder; tells which one failed. */
    static final class Probe {
        private Probe() {}

        /** Each argument is a command line of the samples. */
        public static void main(String[] lines) {
            for (String line : lines) {
                ByteArrayOutputStream said = new ByteArrayOutputStream();
                PrintStream both = new PrintStream(said, true, StandardCharsets.UTF_8);
                int exit = Main.run(line.split(" +", -1), both, both, false);
                System.out.printf("%d %s%n", exit, line);
                if (exit != 0) {
                    System.out.println(said.toString(StandardCharsets.UTF_8));
                }
            }
        }
    }

    @Test
    void theyRunAsTheyStand(@TempDir Path folder) throws IOException, InterruptedException {
        boolean draws = Offscreen.unavailableReason() == null;
        List<String> lines = new ArrayList<>(BEFORE);
        for (String page : PAGES) {
            String text = Files.readString(DocsTest.ROOT.resolve("docs/" + page + ".md"));
            for (Matcher m = DocsTest.COMMAND.matcher(text); m.find(); ) {
                String line = m.group(1).replace("\\\n", " ").strip();
                if (LEFT_OUT.stream().noneMatch(line::contains)
                        && (draws || !line.contains("--picture"))) {
                    lines.add(line);
                }
            }
        }
        assertTrue(lines.size() >= (draws ? 10 : 8), lines.toString());
        Files.writeString(folder.resolve("mug.obj"), MUG);
        String said = Jvm.runInside(folder, Probe.class.getName(), lines);
        for (String line : lines) {
            assertTrue(said.contains("0 " + line + System.lineSeparator()), line + ": " + said);
        }
        for (String file : List.of("mug.json", "room.json", "run.cairn")) {
            assertTrue(Files.size(folder.resolve(file)) > 100, file);
        }
        assertTrue(!draws || Files.size(folder.resolve("p.png")) > 10_000, "p.png");
    }
}
