package dev.cairn.samples.sandbox;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.cairn.render.app.View;
import dev.cairn.render.ui.Ui;
import dev.cairn.samples.SceneRegistry;
import dev.cairn.samples.window.WindowFixture;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.util.List;
import java.util.Map;

/**
 * What the window shows to who opens it. Makes the pictures of the docs: {@code mvn verify
 * -Dtest=PicturesOfDocsTest -Dgl.tests=required -Dwindow.pictures=FOLDER}.
 */
class PicturesOfDocsTest extends WindowFixture {
    @Override
    public Class<?> program() {
        return Probe.class;
    }

    @Override
    public List<String> arguments() {
        return List.of("junkyard");
    }

    @Override
    public Map<String, String> environment() {
        return System.getProperty("window.pictures") == null
                ? Map.of()
                : Map.of("JAVA_TOOL_OPTIONS", "-Dcairn.effects=all");
    }

    /** With all effects a rasteriser takes up to a second for a frame. */
    @Override
    public long deadlineSeconds() {
        return 3 * super.deadlineSeconds();
    }

    @Override
    public boolean ready(Seen seen) {
        return seen.number("tick") >= 200;
    }

    @Test
    void theSandboxTheMouseThePauseTheKeysAndTheEditor() throws IOException, InterruptedException {
        picture("sandbox");
        // What lies in the middle is held up.
        moveTo(550, 420);
        type("mousedown", "1");
        Seen held = await("a body in the hand", seen -> seen.flag("pulling"));
        moveTo(560, 250);
        await("it to be lifted", seen -> seen.number("tick") > held.number("tick") + 60);
        picture("mouse");
        type("mouseup", "1");
        await("it to be let go", seen -> !seen.flag("pulling"));
        // The heap hangs in the air.
        type("key", "r", "p");
        await("the pause", seen -> seen.flag("paused") && seen.number("tick") < 200);
        picture("pause");
        click("Keys");
        await("the keys", seen -> seen.values().containsKey("riseX"));
        settle();
        click("rise");
        settle();
        type("key", "g");
        settle();
        picture("keys");
        click("Edit a copy");
        await("the editor", seen -> seen.values().containsKey("boxX"));
        settle();
        moveTo(550, 400);
        type("click", "1");
        await("its fields", seen -> seen.values().containsKey("nameX"));
        picture("editor");
    }

    private void picture(String name) throws IOException, InterruptedException {
        settle();
        assertEquals(0, now().number("shortened"), name + ": " + last);
        assertEquals(0, now().number("overlapping"), name + ": " + last);
        look(name);
    }

    /** The sandbox as a user finds it. */
    static final class Probe extends Sandbox {
        private static final List<String> PLACES =
                List.of("Keys", "rise", "Edit a copy", "box", "name");

        private Probe(String scene) {
            super(SceneRegistry.all(), Map.of(), 1, 4, false, System.err);
            beginWith(SceneRegistry.get(scene));
        }

        /**
         * Runs until the window is closed.
         *
         * @param arguments the scene to begin with
         */
        public static void main(String[] arguments) {
            new Probe(arguments[0]).size(1100, 700).start();
        }

        @Override
        void shown(Ui ui, View view, SandboxState state) {
            StringBuilder line =
                    new StringBuilder(
                            "frame=%d tick=%d paused=%b pulling=%b uiScale=1 shortened=%d overlapping=%d"
                                    .formatted(
                                            view.frames(),
                                            state.tick,
                                            isPaused(),
                                            state.pulling,
                                            ui.shortened(),
                                            ui.overlapping()));
            for (String label : PLACES) {
                line.append(WindowFixture.middle(ui, label));
            }
            System.out.println(line);
            System.out.flush();
        }
    }
}
