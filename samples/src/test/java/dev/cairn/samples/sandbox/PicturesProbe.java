package dev.cairn.samples.sandbox;

import dev.cairn.render.app.View;
import dev.cairn.render.ui.Ui;
import dev.cairn.samples.SceneRegistry;
import dev.cairn.samples.window.WindowFixture;

import java.util.List;
import java.util.Map;

/** The sandbox as a user finds it, for {@link PicturesOfDocsTest}. */
final class PicturesProbe extends Sandbox {
    private static final List<String> PLACES =
            List.of("Keys", "rise", "Edit a copy", "box", "name");

    private PicturesProbe(String scene) {
        super(SceneRegistry.all(), Map.of(), 1, 4, false, System.err);
        beginWith(SceneRegistry.get(scene));
    }

    /**
     * Runs until the window is closed.
     *
     * @param arguments the scene to begin with
     */
    public static void main(String[] arguments) {
        new PicturesProbe(arguments[0]).size(1100, 700).start();
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
