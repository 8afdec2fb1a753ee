package dev.cairn.samples.sandbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.samples.window.WindowFixture;
import dev.cairn.samples.window.WindowManager;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** A run of a scene in the editor, as {@code samples --window --record} writes it. */
class RecordEditorTest extends WindowFixture {
    @Override
    public boolean pixels() {
        return false;
    }

    @Override
    public Class<?> program() {
        return DrivenProbe.class;
    }

    @Override
    public void prepare() throws IOException {
        Files.createFile(folder.resolve(SandboxProbe.RUN));
    }

    @Override
    public boolean ready(Seen seen) {
        return seen.is("mode", "REST") && seen.number("frame") > 3;
    }

    @Test
    void theRunOfAnEditedSceneIsWrittenWhenTheWindowCloses()
            throws IOException, InterruptedException {
        type("key", "p");
        await("the scene to run", seen -> seen.is("mode", "PLAYING") && seen.number("ticked") > 20);
        type("keydown", "Up");
        Seen start = now();
        await("pushes", seen -> seen.number("ticked") > start.number("ticked") + 20);
        type("keyup", "Up");
        type("key", "p");
        await("the pause", seen -> seen.flag("paused"));
        settle();
        Seen end = now();
        try (WindowManager manager = manager()) {
            manager.askToClose();
        }
        assertEquals(0, ended());
        Path run = folder.resolve(SandboxProbe.RUN);
        assertTrue(Files.size(run) > 1000, "nothing is in " + run);
        String told = plays(run, end);
        assertTrue(told.contains("%.0f ticks from tick 0".formatted(end.number("ticked"))), told);
    }
}
