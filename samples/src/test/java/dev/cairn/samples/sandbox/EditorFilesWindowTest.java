package dev.cairn.samples.sandbox;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.cairn.samples.scenefile.BodyKind;
import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenefile.SceneFile;
import dev.cairn.samples.scenefile.SceneReader;
import dev.cairn.samples.scenefile.SceneWriter;
import dev.cairn.samples.scenefile.ShapeSpec.GroundShape;
import dev.cairn.samples.scenefile.ShapeSpec.SphereShape;
import dev.cairn.samples.window.WindowFixture;
import dev.cairn.samples.window.WindowManager;

import org.junit.jupiter.api.Test;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

import javax.imageio.ImageIO;

/** Files that are dropped into the window, and those that are chosen from a list. */
class EditorFilesWindowTest extends WindowFixture {
    private static final String TETRAHEDRON =
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

    @Override
    public boolean pixels() {
        return false;
    }

    @Override
    public Class<?> program() {
        return EditorProbe.class;
    }

    @Override
    public boolean ready(Seen seen) {
        return seen.number("tick") >= 1;
    }

    /** A desktop whose bus has gone: its dialog fails, and the window's own list takes over. */
    @Override
    public Map<String, String> environment() {
        return Map.of("DBUS_SESSION_BUS_ADDRESS", "unix:path=" + folder.resolve("gone"));
    }

    @Override
    public void prepare() throws IOException {
        Files.writeString(folder.resolve("thing.obj"), TETRAHEDRON);
        Files.createDirectory(folder.resolve("below"));
        BufferedImage red = new BufferedImage(8, 8, BufferedImage.TYPE_INT_RGB);
        red.setRGB(0, 0, 0xFF0000);
        ImageIO.write(red, "png", folder.resolve("red.png").toFile());
        EntitySpec ground = EntitySpec.of("ground", BodyKind.FIXED, new GroundShape());
        EntitySpec ball = EntitySpec.of("ball", BodyKind.DYNAMIC, new SphereShape(0.5));
        SceneFile other =
                SceneFile.empty("other").withEntities(List.of(ground, ball, ball, ball, ball));
        SceneWriter.write(other, folder.resolve("other.json"));
        SceneWriter.write(other.withEntities(List.of(ground)), folder.resolve("below/other.json"));
    }

    private void drop(Path file, int x, int y) throws IOException {
        try (WindowManager manager = manager()) {
            manager.drop(List.of(file.toUri().toString()), x, y);
        }
    }

    @Test
    void filesAreDroppedAndChosen() throws IOException, InterruptedException {
        drop(folder.resolve("thing.obj"), 560, 420); // opens the editor
        Seen placed =
                await("the mesh", seen -> seen.is("mode", "REST") && seen.number("entities") == 2);
        assertEquals(0, placed.number("selectedY"), 1e-9, "it stands on the floor: " + last);
        await("it to be seen", seen -> seen.number("bodyY") == 0);
        settle();
        look("editor-dropped");
        type("key", "f");
        settle();
        drop(folder.resolve("red.png"), 512, 330);
        await("the picture on it", seen -> seen.is("texture", "red.png"));
        settle();
        look("editor-picture");

        drop(folder.resolve("other.json"), 560, 300);
        await("the warning of unsaved changes", seen -> seen.flag("wrong"));
        assertEquals(2, now().number("entities"), last);
        drop(folder.resolve("other.json"), 560, 300);
        await("the other scene", seen -> seen.number("entities") == 5);

        click("Open...");
        await("the list", seen -> seen.values().containsKey("below/X"));
        settle();
        look("editor-open");
        click("below/");
        await("its only file", seen -> seen.number("other.jsonY") <= seen.number("below/Y"));
        settle();
        click("other.json");
        await("the scene from below", seen -> seen.number("entities") == 1);
        settle();
        look("editor-chosen");
        assertEquals(0, now().number("shortened"), last);

        click("box");
        await("an unsaved edit", seen -> seen.flag("changed"));
        click("Save as...");
        await("the list", seen -> seen.values().containsKey("Save_hereX"));
        settle();
        look("editor-save-as");
        click("Save here"); // by the name that is proposed, the scene's own
        await("the edit to be saved", seen -> !seen.flag("changed"));
        assertEquals(2, SceneReader.read(folder.resolve("below/other.json")).entities().size());
    }
}
