package dev.cairn.samples.editor.files;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.render.ui.Ui;
import dev.cairn.samples.editor.files.FileDialog.Taken;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.lang.reflect.Proxy;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;

/** The desktop's dialog, and the window's own list where there is none. */
@Timeout(60)
class FileDialogTest {
    /** What a frame's panels said, and the widget that the user clicks on in it. */
    private final List<String> said = new ArrayList<>();

    private String clicked = "";
    private final Ui ui =
            (Ui)
                    Proxy.newProxyInstance(
                            Ui.class.getClassLoader(),
                            new Class<?>[] {Ui.class},
                            (proxy, method, arguments) ->
                                    switch (method.getName()) {
                                        case "width", "height" -> 600.0;
                                        case "panel" -> true;
                                        case "textField" -> arguments[1];
                                        case "button", "item" -> clicked.equals(arguments[0]);
                                        case "text" -> said.add(arguments[0].toString());
                                        default -> null;
                                    });

    /** Frames until something is taken or the dialog shows nothing of its own any more. */
    private Taken answer(FileDialog dialog) {
        Taken taken = null;
        do {
            said.clear();
            taken = dialog.draw(ui);
        } while (taken == null && said.contains("The desktop's dialog is open."));
        return taken;
    }

    private record Desktop(Answer answer, boolean needsWindowThread) implements DesktopDialog {
        interface Answer {
            Path to(FileQuestion question) throws IOException;
        }

        @Override
        public Path ask(FileQuestion question) throws IOException {
            return answer.to(question);
        }
    }

    @Test
    void whatTheDesktopAnswersIsTakenOnceOnEitherThread(@TempDir Path folder) {
        for (boolean here : new boolean[] {false, true}) {
            Thread window = Thread.currentThread();
            FileDialog dialog =
                    new FileDialog(
                            new Desktop(
                                    question -> {
                                        assertEquals(here, window.equals(Thread.currentThread()));
                                        return question.folder().resolve("a" + question.name());
                                    },
                                    here));
            dialog.open("Open", folder, ".json");
            assertEquals(new Taken(folder.resolve("a"), false), answer(dialog));
            assertNull(answer(dialog));
            assertFalse(dialog.isListShown());
            // The desktop need not add the ending; a file without it could never be opened again.
            dialog.save("Save", folder, ".json", "b");
            assertEquals(new Taken(folder.resolve("ab.json"), true), answer(dialog));
            dialog.save("Save", folder, ".json", "b.json");
            assertEquals(new Taken(folder.resolve("ab.json"), true), answer(dialog));
        }
    }

    @Test
    void whoWantsNoFileIsNotAskedAgain(@TempDir Path folder) {
        FileDialog dialog = new FileDialog(new Desktop(question -> null, false));
        dialog.open("Open", folder, ".json");
        assertNull(answer(dialog));
        assertFalse(dialog.isListShown());
    }

    @Test
    void aDesktopThatFailsIsFollowedByTheListWithTheReason(@TempDir Path folder)
            throws IOException {
        Files.createFile(folder.resolve("mine.json"));
        FileDialog dialog =
                new FileDialog(
                        new Desktop(
                                question -> {
                                    throw new IOException("no portal");
                                },
                                false));
        dialog.open("Open", folder, ".json");
        assertNull(answer(dialog));
        assertTrue(dialog.isListShown());
        assertNull(answer(dialog));
        assertTrue(said.toString().contains("no portal"), said.toString());
        clicked = "mine.json";
        assertEquals(new Taken(folder.resolve("mine.json"), false), answer(dialog));
        clicked = "";
        dialog.save("Save", folder, ".json", "new");
        assertTrue(dialog.isListShown(), "and is not asked a second time");
        clicked = FileChooser.SAVE;
        assertEquals(new Taken(folder.resolve("new.json"), true), answer(dialog));
    }

    @Test
    void aDialogThatNeverComesIsGivenUp(@TempDir Path folder) throws InterruptedException {
        CountDownLatch open = new CountDownLatch(1);
        CountDownLatch closed = new CountDownLatch(1);
        FileDialog dialog =
                new FileDialog(
                        new Desktop(
                                question -> {
                                    try {
                                        open.await();
                                    } catch (InterruptedException e) {
                                        throw new IOException(e);
                                    }
                                    closed.countDown();
                                    return folder.resolve("late.json");
                                },
                                false));
        dialog.open("Open", folder, ".json");
        assertNull(dialog.draw(ui));
        dialog.open("Another", folder, ".json");
        clicked = FileDialog.HERE;
        assertNull(dialog.draw(ui));
        assertTrue(dialog.isListShown());
        clicked = "";
        open.countDown();
        closed.await();
        assertNull(answer(dialog), "what comes too late is nobody's answer");
        assertTrue(dialog.dismiss());
    }

    /** With an ending behind it each of these would be a file somewhere else. */
    @Test
    void aNameThatIsAFolderIsToldAndTheListStays(@TempDir Path folder) {
        clicked = FileChooser.SAVE;
        for (String name : List.of("", " ", ".", "..", "../..", "/", "below/", "below/..")) {
            FileDialog dialog = new FileDialog(null);
            dialog.save("save", folder, ".json", name);
            assertNull(dialog.draw(ui), name);
            assertTrue(dialog.isListShown(), name);
            said.clear();
            dialog.draw(ui);
            assertTrue(said.toString().contains("is a folder"), name + ": " + said);
        }
        FileDialog dialog = new FileDialog(null);
        dialog.save("save", folder, ".json", "below/../a b");
        assertEquals(new Taken(folder.resolve("a b.json"), true), dialog.draw(ui));
        assertFalse(dialog.isListShown());
    }

    @Test
    void nothingIsAskedOfADesktopWhereThePropertySaysSo() {
        String before = System.getProperty(NativeDialog.PROPERTY);
        try {
            System.setProperty(NativeDialog.PROPERTY, "window");
            assertNull(NativeDialog.find());
        } finally {
            if (before == null) {
                System.clearProperty(NativeDialog.PROPERTY);
            } else {
                System.setProperty(NativeDialog.PROPERTY, before);
            }
        }
    }
}
