package dev.cairn.samples.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.samples.editor.files.FileChooser;
import dev.cairn.samples.sandbox.EditorProbe;
import dev.cairn.samples.scenefile.SceneReader;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeSet;
import java.util.stream.Stream;

/**
 * Names that are typed for a scene or a thing in the real window, and are not of the usual kind.
 */
class SaveNameWindowTest extends WindowFixture {
    /** Right to left, on a keyboard that has these letters. */
    private static final String FOREIGN = "\u05e9\u05dc\u05d5\u05dd \u05d0";

    /** What is no name leaves the list open. */
    private boolean listed;

    @Override
    public Class<?> program() {
        return EditorProbe.class;
    }

    /** The window's own list, and a locale in which each name has a file. */
    @Override
    public Map<String, String> environment() {
        return Map.of("LC_ALL", "C.UTF-8", "JAVA_TOOL_OPTIONS", "-Dcairn.dialog=window");
    }

    @Override
    public boolean ready(Seen seen) {
        return seen.number("tick") >= 1;
    }

    @Override
    public void prepare() throws IOException {
        Files.createDirectory(folder.resolve("below"));
        Files.createDirectory(folder.resolve("empty.json"));
        Files.createDirectories(folder.resolve("full.json/within"));
    }

    private void enter(String label, String text) throws IOException, InterruptedException {
        click(label);
        settle();
        type("key", "ctrl+a", "Delete");
        settle();
        if (!text.isEmpty()) {
            keyboard(text.equals(FOREIGN) ? "il" : "us");
            type("type", "--delay", "20", text);
            settle();
            keyboard("us");
        }
        settle();
    }

    /** The list is left open where the name cannot be one. */
    private void saveAs(String name) throws IOException, InterruptedException {
        if (!listed) {
            click("Save as...");
        }
        listed = false;
        settle();
        enter(FileChooser.NAME, name);
        look("save-as-" + (name.length() > 20 ? "long" : name.replace('/', '_')));
        click(FileChooser.SAVE);
        settle();
    }

    private void isTold(String name, String part) throws IOException, InterruptedException {
        saveAs(name);
        await(part, seen -> seen.flag("wrong") && seen.values().get("message").contains(part));
        assertTrue(now().flag("changed"), last);
        assertEquals(0, now().number("shortened"), last);
    }

    private void isNone(String name) throws IOException, InterruptedException {
        saveAs(name);
        look("save-as-none");
        listed = true;
        assertTrue(now().flag("changed"), last);
    }

    @Test
    void whatIsNoNameIsToldAndNothingIsWritten() throws IOException, InterruptedException {
        type("key", "F2");
        await("the editor", seen -> seen.is("mode", "REST"));
        click("box");
        await("an unsaved edit", seen -> seen.flag("changed"));
        TreeSet<String> before = files();
        isNone("");
        isNone("..");
        isNone("/");
        isNone("below/");
        isTold("x".repeat(300), "too_long");
        isTold("none/of", "no_such_folder");
        isTold("empty", "it_is_a_folder");
        isTold("full", "it_is_a_folder");
        if (Files.isDirectory(Path.of("/sys"))) {
            isTold("/sys/scene", "it_may_not_be_written_there"); // by nobody
        }
        assertEquals(before, files(), last);

        saveAs(FOREIGN);
        await("it to be saved", seen -> !seen.flag("changed"));
        before.add(FOREIGN + ".json");
        assertEquals(before, files(), last);

        enter("name", FOREIGN);
        await("the name", seen -> seen.number("nameLength") == FOREIGN.length());
        type("key", "BackSpace");
        await("one letter less", seen -> seen.number("nameLength") == FOREIGN.length() - 1);
        look("name-foreign");
        type("key", "Return");
        click("Save");
        await("it to be saved", seen -> !seen.flag("changed"));
        Path file = folder.resolve(FOREIGN + ".json");
        assertEquals(
                FOREIGN.substring(0, 5), SceneReader.read(file).entities().getLast().name(), last);
        assertEquals(0, now().number("shortened"), last);
    }

    private TreeSet<String> files() throws IOException {
        TreeSet<String> names = new TreeSet<>();
        try (Stream<Path> all = Files.walk(folder, 2)) {
            all.map(path -> folder.relativize(path).toString())
                    .filter(name -> name.contains("json"))
                    .forEach(names::add);
        }
        return names;
    }
}
