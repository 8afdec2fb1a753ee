package dev.cairn.samples.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.samples.sandbox.EditorProbe;
import dev.cairn.samples.scenefile.BodyKind;
import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenefile.SceneFile;
import dev.cairn.samples.scenefile.SceneWriter;
import dev.cairn.samples.scenefile.ShapeSpec.SphereShape;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;

/** What is no scene, mesh or picture is let go over the window: told each time, nothing lost. */
class HostileDropTest extends WindowFixture {
    private static final long SEED = 20261126;

    /** Of these nothing comes. */
    private final List<String> refused = new ArrayList<>();

    @Override
    public Class<?> program() {
        return EditorProbe.class;
    }

    /** The C locale, in which Java cannot name every file, and less memory than a file of it. */
    @Override
    public Map<String, String> environment() {
        return Map.of("LC_ALL", "C", "JAVA_TOOL_OPTIONS", "-Xmx512m");
    }

    @Override
    public boolean ready(Seen seen) {
        return seen.number("tick") >= 1;
    }

    @Override
    public void prepare() throws IOException {
        byte[] noise = new byte[10_000];
        new SplittableRandom(SEED).nextBytes(noise);
        for (String ending : List.of(".json", ".obj", ".png")) {
            refuse(Files.createDirectory(folder.resolve("folder" + ending)));
            refuse(folder.resolve("gone" + ending));
            refuse(
                    Files.createSymbolicLink(
                            folder.resolve("device" + ending), Path.of("/dev/zero")));
            Path pipe = folder.resolve("pipe" + ending);
            new ProcessBuilder("mkfifo", pipe.toString()).start().onExit().join();
            refuse(pipe);
            Files.write(folder.resolve("noise" + ending), noise);
            String sparse = folder.resolve("sparse" + ending).toString();
            try (RandomAccessFile file = new RandomAccessFile(sparse, "rw")) {
                file.setLength(1L << 30);
            }
        }
        refuse(folder.resolve("noise.json"));
        refuse(folder.resolve("sparse.json"));
        refuse(Files.createFile(folder.resolve("empty.json")));
        refuse(Files.createFile(folder.resolve("no ending")));
        EntitySpec ball = EntitySpec.of("ball", BodyKind.DYNAMIC, new SphereShape(0.5));
        Path nan = folder.resolve("nan.json");
        SceneWriter.write(SceneFile.empty("nan").withEntities(List.of(ball)), nan);
        Files.writeString(nan, Files.readString(nan).replace("0.5", "NaN"));
        refuse(nan);
        refuse(Files.createFile(folder.resolve("new\nline \u0001\u001b[31m.json")));
    }

    private void refuse(Path file) {
        refused.add(file.toUri().toString());
    }

    private void drop(List<String> dropped, int x, int y) throws IOException {
        try (WindowManager manager = manager()) {
            manager.drop(dropped, x, y);
        }
    }

    private Seen awaitMessage(String part) throws IOException, InterruptedException {
        return await(part, seen -> seen.values().get("message").contains(part));
    }

    @Test
    void whatIsNoneIsToldAndNothingIsLost() throws IOException, InterruptedException {
        System.out.println("seed " + SEED);
        type("key", "F2");
        await("the editor", seen -> seen.is("mode", "REST"));
        click("box");
        Seen edited = await("an unsaved edit", seen -> seen.flag("changed"));
        // Beside everything, where a picture has nothing to be put on.
        drop(refused, 1000, 620);
        awaitMessage("%d_of_%1$d_files_were_not_taken".formatted(refused.size()));
        drop(Collections.nCopies(1000, refused.getFirst()), 1000, 620);
        awaitMessage("1000_files:_at_most_100");
        // Java has no name for the first in this locale, which is no reason to lose the second.
        Path named = folder.resolve("named.txt");
        drop(List.of(folder.toUri() + "sch%C3%B6n.json", named.toUri().toString()), 1000, 620);
        awaitMessage("named.txt:_expected_a_scene");
        settle();
        Seen after = now();
        assertTrue(after.flag("changed"), last);
        assertEquals(edited.number("entities"), after.number("entities"), last);
        assertEquals(edited.number("steps"), after.number("steps"), last);

        // What is a file of its kind by its name is a placeholder, told by the world.
        String noise = folder.resolve("noise.obj").toUri().toString();
        String sparse = folder.resolve("sparse.obj").toUri().toString();
        drop(List.of(noise, sparse), 1000, 420);
        await("both", seen -> seen.number("entities") == edited.number("entities") + 2);
        await("the first", seen -> seen.values().get("notes").contains("noise.obj:1:"));
        await("the other", seen -> seen.values().get("notes").contains("a_line_of_more_than"));
        drop(List.of(noise.replace(".obj", ".png"), sparse.replace(".obj", ".png")), 512, 330);
        await("the picture", seen -> seen.values().get("notes").contains("sparse.png"));
        look("editor-hostile");
    }
}
