package dev.cairn.samples.sandbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.samples.Main;
import dev.cairn.samples.scenefile.SceneReader;
import dev.cairn.samples.scenefile.SceneWriter;
import dev.cairn.samples.window.WindowFixture;

import org.junit.jupiter.api.Test;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/** Moments and reports of a scene in the editor in which keys drive a ball, in the real window. */
class ReportWindowTest extends WindowFixture {
    @Override
    public Class<?> program() {
        return DrivenProbe.class;
    }

    @Override
    public boolean ready(Seen seen) {
        return seen.is("mode", "REST") && seen.number("frame") > 3;
    }

    /** A report of what keys did has the digests that were seen; a moment begins a scene file. */
    @Test
    void keysThatDriveAreInAReportOfAnEditedScene() throws IOException, InterruptedException {
        type("key", "p");
        await("the scene to run", seen -> seen.is("mode", "PLAYING") && seen.number("ticked") > 20);
        type("keydown", "Up");
        Seen start = now();
        await("pushes", seen -> seen.number("ticked") > start.number("ticked") + 20);
        type("keyup", "Up");
        await(
                "a jump",
                seen -> {
                    if (seen.number("height") < 0.7 && (int) seen.number("frame") % 8 == 0) {
                        jump();
                    }
                    return seen.number("height") > 0.8;
                });
        Seen high = now();
        await("ticks", seen -> seen.number("ticked") > high.number("ticked") + 20);
        type("key", "p");
        await("the pause", seen -> seen.flag("paused"));
        settle();
        Seen end = now();
        String tick = "%.0f".formatted(end.number("ticked"));
        assertEquals(end.number("ticked"), end.number("tick"), last);
        type("key", "m");
        Path moment = folder.resolve("moment-driven-" + tick + ".cairn");
        await("the moment", seen -> Files.exists(moment));
        type("key", "F9");
        Path report = folder.resolve("report-driven-" + tick + ".cairn");
        await("the report", seen -> Files.exists(report));
        settle();
        String told = run("--replay", report.toString(), "--workers", "2", "--lanes", "4");
        assertTrue(told.contains(end.values().get("digest")), end + " against " + told);

        String on = run("--from", moment.toString(), "--ticks", "30", "--json", "-");
        Path begun = folder.resolve("begun.json");
        SceneWriter.write(
                SceneReader.parse("driven", DrivenProbe.SCENE)
                        .withState(String.valueOf(moment.getFileName())),
                begun);
        String file = run("--scene-file", begun.toString(), "--ticks", "30", "--json", "-");
        assertEquals(digest(on), digest(file));
    }

    private void jump() {
        try {
            type("key", "u");
        } catch (IOException | InterruptedException failure) {
            throw new IllegalStateException(failure);
        }
    }

    private static String digest(String json) {
        int at = json.indexOf("\"digest\"");
        return json.substring(at, json.indexOf('\n', at));
    }

    private static String run(String... arguments) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        PrintStream both = new PrintStream(out, true, StandardCharsets.UTF_8);
        assertEquals(0, Main.run(arguments, both, both, false), out::toString);
        return out.toString(StandardCharsets.UTF_8);
    }
}
