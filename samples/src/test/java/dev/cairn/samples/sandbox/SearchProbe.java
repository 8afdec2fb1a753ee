package dev.cairn.samples.sandbox;

import dev.cairn.render.app.View;
import dev.cairn.render.ui.Ui;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.scenes.BouncingBall;
import dev.cairn.samples.scenes.Cradle;
import dev.cairn.samples.scenes.SlopeBox;
import dev.cairn.samples.scenes.stack.StackOfBoxes;
import dev.cairn.samples.window.WindowFixture;

import java.util.List;
import java.util.Locale;
import java.util.Map;

/** The sandbox with four scenes, telling which of them are listed, for {@link SearchWindowTest}. */
final class SearchProbe extends Sandbox {
    private static final List<SampleScene> SCENES =
            List.of(StackOfBoxes.scene(), SlopeBox.scene(), BouncingBall.scene(), Cradle.scene());

    private SearchProbe() {
        super(SCENES, Map.of(), 1, 4, false, System.err);
    }

    /** Runs until the window is closed. */
    public static void main(String[] arguments) {
        new SearchProbe().size(1024, 640).start();
    }

    @Override
    void shown(Ui ui, View view, SandboxState state) {
        int listed = scenePanels().listed();
        StringBuilder line =
                new StringBuilder(
                        "frame=%d tick=%d scene=%d paused=%b listed=%d sought=%s"
                                .formatted(
                                        view.frames(),
                                        state.tick,
                                        state.scene,
                                        isPaused(),
                                        listed,
                                        scenePanels().sought().replace(' ', '_')));
        line.append(WindowFixture.middle(ui, SandboxPanels.SEARCH));
        double[] at = ui.boundsOf(SCENES.get(1).title());
        if (at != null) {
            line.append(
                    String.format(
                            Locale.ROOT, " hitX=%.1f hitY=%.1f", at[0] + 20, at[1] + at[3] / 2));
        }
        System.out.println(line);
        System.out.flush();
    }
}
