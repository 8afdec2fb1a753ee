package dev.cairn.samples;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** The command line as a user meets it, in this process. */
class CommandLineTest {
    private record Answer(int code, String out, String err) {}

    private static Answer samples(String... arguments) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        int code =
                Main.run(
                        arguments,
                        new PrintStream(out, true, StandardCharsets.UTF_8),
                        new PrintStream(err, true, StandardCharsets.UTF_8),
                        false);
        return new Answer(
                code, out.toString(StandardCharsets.UTF_8), err.toString(StandardCharsets.UTF_8));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "--scene pyramide               | did you mean pyramid?",
                "--scene xyzzy                  | --list shows all",
                "--sceen pyramid                | --scene",
                "--scene                        | --scene",
                "--ticks ten                    | whole number from 0 to",
                "--ticks -5                     | --ticks -5",
                "--ticks 99999999999            | whole number from 0 to",
                "--workers 0                    | from 1 to 256",
                "--workers 1000                 | from 1 to 256",
                "--substeps 0                   | from 1 to 64",
                "--lanes 32                     | auto, 1, 4, 8 or 16",
                "--precision half               | auto, double or single",
                "--seed x                       | --seed x",
                "--scene pyramid --set bse=5    | did you mean base?",
                "--scene pyramid --set base=x   | whole number from 1 to 400",
                "--scene pyramid --set base=2.5 | whole number from 1 to 400",
                "--scene pyramid --set base=NaN | whole number from 1 to 400",
                "--scene pyramid --set base     | name=value",
                "--set nosuch=1                 | --list shows all",
                "--set base=5                   | of which scene?",
                "--scene pyramid --set base=3 --set base=4 | set it once",
                "--obj no/such/file.obj         | there is no such file",
                "--at 5                         | --picture",
                "--picture a.png                | add --scene",
                "--scene pyramid --picture a.jpg | .png",
                "--scene pyramid --picture a.png --ticks 5 --at 9 | the run ends after 5 ticks",
                "--scene pyramid --json no/such/folder/a.json | in a folder that exists",
                "--window --headless            | contradict",
                "--window --ticks 5             | go with --headless",
                "--window                       | there is no display",
                "--contact-sheet a.jpg          | .png",
                "--contact-sheet a.png --picture b.png | without --picture",
                "--scene ,                      | a name is empty",
                "--scene pyramid,,room          | a name is empty",
                "--scene pyramid --set base=20d | whole number from 1 to 400",
                "--scene pyramid --set base=0x1p3 | whole number from 1 to 400",
                "--scene pyramid --set friction= | number from 0 to 10",
                "--obj src                      | this is a folder",
                "pyramid                        | did you mean --scene pyramid?",
                "help                           | --help lists them",
                "--ticks 1 --ticks 2            | only once",
                "--scene pyramid --json src     | cannot write there",
                "--scene-file no/such.json      | nothing there",
                "--scene-file src               | a folder",
                "--scene-file pom.xml           | pom.xml:1: $: expected JSON",
                "--scene-file a.json --scene room | leave --scene and --obj out",
                "--export-scene a.json          | add --scene",
                "--scene room --export-scene a.txt | .json",
                "--scene room --export-scene a.json --json - | only writes the file",
                "--scene room --export-scene no/such/a.json | in a folder that exists",
                "--list --headless              | leave the other options out",
            })
    void aMistakeIsOneLineThatTeachesAndExitCode2(String arguments, String hint) {
        Answer answer = samples(arguments.trim().split(" +"));
        assertEquals(2, answer.code, answer.err);
        assertEquals(1, answer.err.lines().count(), "one line, but: " + answer.err);
        assertTrue(answer.err.contains(hint), "wanted \"" + hint + "\" in: " + answer.err);
        assertEquals("", answer.out);
    }

    @Test
    void aMeshNeedsItsScene(@TempDir Path folder) throws IOException {
        Path file = Files.writeString(folder.resolve("a.obj"), "v 0 0 0\n");
        Answer answer = samples("--scene", "pyramid", "--obj", file.toString());
        assertEquals(2, answer.code);
        assertTrue(answer.err.contains("--scene obj-drop"), answer.err);
    }

    @ParameterizedTest
    @CsvSource({"nonsense", "v 1 2", "v 0 0 0;v 1 0 0;v 0 1 0;f 1 2 3", "v 0 0 0;f 1 2 9"})
    void aBrokenMeshIsRefused(String lines, @TempDir Path folder) throws IOException {
        Path file =
                Files.writeString(folder.resolve("broken.obj"), lines.replace(';', '\n') + "\n");
        Answer answer = samples("--headless", "--obj", file.toString(), "--ticks", "1");
        assertEquals(2, answer.code, answer.err);
        assertEquals(1, answer.err.lines().count(), answer.err);
        assertTrue(answer.err.contains("broken.obj"), answer.err);
    }

    @Test
    void helpVersionAndListAnswer() {
        Answer help = samples("--help");
        assertEquals(0, help.code);
        assertTrue(help.out.contains("--workers"), help.out);
        Answer version = samples("--version");
        assertEquals(0, version.code);
        assertTrue(version.out.contains("Cairn"), version.out);
        Answer list = samples("--list");
        assertEquals(0, list.code);
        for (String id : SceneRegistry.ids()) {
            assertTrue(list.out.contains(id), list.out);
        }
    }

    @Test
    void jsonOnStandardOutputIsAllThereIs() {
        Answer answer =
                samples(
                        "--scene",
                        "slope-box",
                        "--ticks",
                        "20",
                        "--json",
                        "-",
                        "--workers",
                        "2",
                        "--lanes",
                        "1");
        assertEquals(0, answer.code, answer.err);
        JsonObject report = JsonParser.parseString(answer.out).getAsJsonObject();
        List<String> names = new ArrayList<>(report.keySet());
        assertEquals(
                List.of(
                        "scene",
                        "parameters",
                        "bodies",
                        "ticks",
                        "workers",
                        "lanes",
                        "tickMillisMedian",
                        "tickMillisP99",
                        "contacts",
                        "kineticEnergy",
                        "maxPenetrationMetres",
                        "errors",
                        "digest",
                        "allocatedBytesPerTick",
                        "stageMicros",
                        "systemMicros"),
                names);
        assertEquals("slope-box", report.get("scene").getAsString());
        assertEquals(20, report.get("ticks").getAsInt());
        assertEquals(2, report.get("workers").getAsInt());
        assertEquals(1, report.get("lanes").getAsInt());
        assertEquals(2, report.get("bodies").getAsInt());
        assertTrue(report.get("digest").getAsString().matches("[0-9a-f]{16}"), answer.out);
        assertEquals(0.5, report.getAsJsonObject("parameters").get("friction").getAsDouble());
    }

    @Test
    void severalScenesAreAnArray(@TempDir Path folder) throws IOException {
        Path file = folder.resolve("two.json");
        Answer answer =
                samples(
                        "--scene",
                        "pairs-3,free-fall",
                        "--ticks",
                        "2",
                        "--json",
                        file.toString(),
                        "--workers",
                        "1");
        assertEquals(0, answer.code, answer.err);
        JsonArray reports = JsonParser.parseString(Files.readString(file)).getAsJsonArray();
        assertEquals(2, reports.size());
        assertTrue(answer.out.contains("collision 2"), answer.out);
        assertFalse(answer.out.contains("collision 3"), answer.out);
    }

    @Test
    void anExportedSceneRunsFromItsFile(@TempDir Path folder) {
        String file = folder.resolve("Five Rows.json").toString();
        Answer written = samples("--scene", "pyramid", "--set", "base=3", "--export-scene", file);
        assertEquals(0, written.code, written.err);
        Answer run = samples("--scene-file", file, "--ticks", "3", "--json", "-");
        assertEquals(0, run.code, run.err);
        JsonObject report = JsonParser.parseString(run.out).getAsJsonObject();
        assertEquals("five-rows", report.get("scene").getAsString());
        assertEquals(1 + 6, report.get("bodies").getAsInt());
    }

    @Test
    void zeroTicksAreAllowed() {
        Answer answer = samples("--scene", "stack-4", "--ticks", "0");
        assertEquals(0, answer.code, answer.err);
        assertTrue(answer.out.contains("stack-4"), answer.out);
    }

    /** Who names no scene waits for a few; a group is no scene twice. */
    @ParameterizedTest
    @ValueSource(strings = {"", "--scene report ", "--scene room,report,room "})
    void theScenesOfTheReportRunIfNoneIsNamed(String named) {
        Answer answer = samples((named + "--ticks 0 --json -").split(" "));
        assertEquals(0, answer.code, answer.err);
        JsonArray runs = JsonParser.parseString(answer.out).getAsJsonArray();
        assertEquals(SceneRegistry.report().size(), runs.size());
    }
}
