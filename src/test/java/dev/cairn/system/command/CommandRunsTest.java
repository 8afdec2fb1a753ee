package dev.cairn.system.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.render.app.Offscreen;
import dev.cairn.samples.Main;
import dev.cairn.system.DocsTest;
import dev.cairn.system.Jvm;

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
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Every command of README, CONTRIBUTING and docs ({@link CommandsTest.PageCommands}) is in one of
 * two tables: what runs here, as it stands or in a small form by the same main class, and what runs
 * in another test, with why. A command in neither fails the build, and so does a row for no
 * command.
 */
final class CommandRunsTest {
    private static final String SAMPLES = "(?:java -jar samples/target/samples\\.jar|samples) ?";
    private static final String BENCHMARKS =
            "(?:GALLIUM_NOOP=1 )?java (?:-Dcairn\\.natives\\.box3d=LIBRARY )?"
                    + "-jar benchmarks/target/benchmarks\\.jar ?";

    /**
     * A command line of the samples by a pattern, and what runs for it; AS_IT_STANDS for itself.
     */
    private record Here(String arguments, String run, boolean draws) {}

    private static final String AS_IT_STANDS = "";

    private static final List<Here> HERE =
            List.of(
                    // what the pages take as given: scenes of the reader's own, a recorded run
                    new Here("", "--scene stack --export-scene my.json", false),
                    new Here("", "--scene stack --export-scene my-scene.json", false),
                    new Here("--scene \\w+ --export-scene \\S+", AS_IT_STANDS, false),
                    new Here("--scene-file \\S+( --json - --workers 2)?", AS_IT_STANDS, false),
                    new Here(
                            "--scene-file my\\.json --picture my\\.png --at 90",
                            "--scene-file my.json --picture my.png --at 9 --ticks 10",
                            true),
                    new Here(
                            "--scene-file my-scene\\.json --record run\\.cairn",
                            "--scene-file my-scene.json --record run.cairn --ticks 20",
                            false),
                    new Here(
                            "--scene pyramid --ticks 600 --record run\\.cairn",
                            "--scene pyramid --set base=4 --ticks 60 --record run.cairn",
                            false),
                    new Here("--replay run\\.cairn --workers 1 --lanes 4", AS_IT_STANDS, false),
                    new Here(
                            "--headless --scene pyramid --picture p\\.png --ticks 60",
                            "--headless --scene pyramid --set base=4 --picture p.png --ticks 9",
                            true),
                    new Here(
                            "--headless --scene \\w+ --ticks \\d+ --animation \\w+\\.png",
                            "--headless --scene cradle --ticks 6 --animation a.png",
                            true),
                    new Here(
                            "--contact-sheet \\S+ --scene \\S+",
                            "--contact-sheet sheet.png --scene cradle --ticks 3",
                            true),
                    new Here(
                            "--decompose mug\\.obj --parts 32 --error 0\\.01 --out mug\\.json"
                                    + " --picture mug\\.png",
                            AS_IT_STANDS,
                            true),
                    new Here("accuracy( --quick| [A-Z]\\d?( [A-Z]\\d?)?)?", "accuracy A1", false),
                    new Here(
                            "accuracy --long --write docs/accuracy\\.md",
                            "accuracy A1 --write accuracy.md",
                            false),
                    new Here("fuzz --seed 7 --world 1234", AS_IT_STANDS, false),
                    new Here("fuzz --seed 7 --worlds 10000", "fuzz --seed 7 --worlds 3", false),
                    new Here(
                            "fuzz(?: --worlds 300 --family HOUSE --keep 0 --seed 1)?",
                            "fuzz --worlds 2 --family HOUSE --keep 0 --seed 1",
                            false));

    /** A command by a pattern, the test that runs it, and why it does not run here. */
    private record There(String command, String by, String why) {}

    /** Small forms, where the classes of the benchmarks are. */
    private static final String SMALL = "BenchmarkCommandsTest";

    /** Real ones, in a clone of these sources; each command has its row there. */
    private static final String SHELL = "MavenCommandsTest";

    private static final List<There> THERE =
            List.of(
                    new There(SAMPLES, "SpectacleTest", "opens the window"),
                    new There(SAMPLES + "--scene ragdolls", "WholeProgramTest", "opens the window"),
                    new There(SAMPLES + "--window .*--record .*", "RecordWindowTest", "a window"),
                    new There(SAMPLES + "--from moment.*", "MomentFileTest", "a key writes it"),
                    new There(SAMPLES + "gallery", "GalleryTest", "minutes; one of its takes"),
                    new There(SAMPLES + "pictures", "ThumbnailsTest", "minutes; a scene of it"),
                    new There(SAMPLES + "pictures --of-list", "ThumbnailsTest", "minutes"),
                    new There(BENCHMARKS + "(EcsIterate|-prof gc \\w+)?", "SmokeTest", "JMH"),
                    new There(BENCHMARKS + "compare.*", SMALL, "hours; two seconds of it"),
                    new There(BENCHMARKS + "start .*", SMALL, "minutes; two seconds of it"),
                    new There(BENCHMARKS + "cost.*", SMALL, "minutes; 13 s of it, soak"),
                    new There(BENCHMARKS + "regress.*", SMALL, "minutes; 44 s of it, soak"),
                    new There(BENCHMARKS + "scaling", SMALL, "minutes; a scene, 3 ticks"),
                    new There(BENCHMARKS + "render-frame", SMALL, "minutes; ten bodies"),
                    new There(BENCHMARKS + "effect-frame.*", SMALL, "minutes; two bodies"),
                    new There(BENCHMARKS + "-l", SHELL, "the jar itself"),
                    new There("(JAVA_HOME=\\S+ )?mvn .*", SHELL, "a build in a build; soak"),
                    new There("java -jar stress/.*", SHELL, "is built there; soak"),
                    new There("bash .*", SHELL, "builds; soak"),
                    new There("(apt-get|git|cd) .*", SHELL, "in a shell; soak"),
                    new There("gradle run", SHELL, "where there is a Gradle; soak"));

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

    private static boolean isThere(String command) {
        return THERE.stream().anyMatch(row -> isThere(row, command));
    }

    private static boolean isThere(There row, String command) {
        return Pattern.matches(row.command, command);
    }

    private static boolean isFor(Here row, String command) {
        return !isThere(command) && Pattern.matches(SAMPLES + row.arguments, command);
    }

    @Test
    void everyCommandIsRunByATest() throws IOException {
        Set<String> commands = CommandsTest.PageCommands.all();
        Set<String> unknown = new TreeSet<>();
        for (String command : commands) {
            if (!isThere(command) && HERE.stream().noneMatch(row -> isFor(row, command))) {
                unknown.add(command);
            }
        }
        assertEquals(Set.of(), unknown, "in neither table of this test");
        assertTrue(commands.size() > 50, commands.toString());
        for (Here row : HERE) {
            assertTrue(
                    row.arguments.isEmpty() || commands.stream().anyMatch(c -> isFor(row, c)),
                    "no page has " + row);
        }
        try (Stream<Path> files = Files.walk(DocsTest.ROOT)) {
            List<String> sources =
                    files.map(file -> DocsTest.ROOT.relativize(file).toString()).toList();
            for (There row : THERE) {
                assertTrue(
                        commands.stream().anyMatch(c -> Pattern.matches(row.command, c)),
                        "no page has " + row);
                assertTrue(
                        sources.stream().anyMatch(f -> f.endsWith("/" + row.by + ".java")),
                        "there is no " + row.by);
            }
        }
        for (String command : commands) {
            assertTrue(
                    THERE.stream().noneMatch(r -> r.by.equals(SHELL) && isThere(r, command))
                            || MavenCommandsTest.runs(command),
                    command + " is run by no line of " + SHELL);
        }
        for (String pattern : MavenCommandsTest.patterns()) {
            assertTrue(
                    commands.stream().anyMatch(c -> Pattern.matches(pattern, c)),
                    "no page has " + pattern);
        }
    }

    @Test
    void theyRun(@TempDir Path folder) throws IOException, InterruptedException {
        boolean draws = Offscreen.unavailableReason() == null;
        Set<String> commands = CommandsTest.PageCommands.all();
        List<String> lines = new ArrayList<>();
        for (Here row : HERE) {
            if (row.draws && !draws) {
                continue;
            }
            if (!row.run.equals(AS_IT_STANDS)) {
                lines.add(row.run);
                continue;
            }
            for (String command : commands) {
                if (isFor(row, command)) {
                    lines.add(command.replaceFirst(SAMPLES, ""));
                }
            }
        }
        Files.writeString(folder.resolve("mug.obj"), MUG);
        Files.writeString(folder.resolve("accuracy.md"), "<!-- accuracy -->\n");
        String said = Jvm.runInside(folder, Probe.class.getName(), lines);
        for (String line : lines) {
            assertTrue(said.contains("0 " + line + System.lineSeparator()), line + ": " + said);
        }
        for (String file : List.of("room.json", "run.cairn", "accuracy.md")) {
            assertTrue(Files.size(folder.resolve(file)) > 100, file);
        }
        for (String file :
                List.of("p.png", "my.png", "mug.png", "mug.json", "a.png", "sheet.png")) {
            assertTrue(!draws || Files.size(folder.resolve(file)) > 100, file);
        }
    }
}
