package dev.cairn.samples.sandbox;

import dev.cairn.render.app.View;
import dev.cairn.render.ui.Ui;
import dev.cairn.samples.scenefile.SceneReader;
import dev.cairn.samples.scenes.stack.StackOfBoxes;
import dev.cairn.samples.window.WindowFixture;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * The sandbox with a scene file in the editor in which arrow keys drive a ball, as a program of its
 * own that tells, one line a frame, what is seen, for {@link ReportWindowTest} and {@link
 * RecordEditorTest}.
 */
final class DrivenProbe extends Sandbox {
    static final String SCENE =
            """
            {"format": "cairn-scene", "version": 1, "name": "driven", "entities": [
              {"name": "floor", "body": "fixed", "shape": {"type": "box", "halfExtents": [30, 0.5, 30]},
               "position": [0, -0.5, 0]},
              {"name": "ball", "shape": {"type": "sphere", "radius": 0.5}, "position": [0, 0.6, 0],
               "controls": [
                 {"key": "UP", "does": "push", "along": [0, 0, -12]},
                 {"key": "U", "does": "kick", "along": [0, 4, 0]}]},
              {"name": "box", "shape": {"type": "box", "halfExtents": [0.5, 0.5, 0.5]},
               "position": [0, 0.5, -3]}
            ]}
            """;

    private volatile String seen = "ticked=-1 digest=0 height=0";

    private DrivenProbe() {
        super(List.of(StackOfBoxes.scene()), Map.of(), 1, 4, false, System.err);
    }

    /** Runs until the window is closed. */
    public static void main(String[] arguments) throws IOException {
        Path file = Path.of("driven.json");
        Files.writeString(file, SCENE);
        DrivenProbe probe = new DrivenProbe();
        if (Files.exists(Path.of(SandboxProbe.RUN))) {
            probe.record(Path.of(SandboxProbe.RUN));
        }
        probe.edit(file, SceneReader.read(file));
        probe.size(1024, 640).start();
    }

    @Override
    protected void updated(double seconds) {
        super.updated(seconds);
        double height = 0;
        for (var body : physics().bodies()) {
            height = body.name().equals("ball") ? body.position(new org.joml.Vector3d()).y : height;
        }
        seen =
                String.format(
                        Locale.ROOT,
                        "ticked=%d digest=%016x height=%.3f",
                        builtTick(),
                        physics().digest(),
                        height);
    }

    @Override
    void shown(Ui ui, View view, SandboxState state) {
        System.out.printf(
                Locale.ROOT,
                "frame=%d mode=%s tick=%d paused=%b %s%s%n",
                view.frames(),
                editor().mode(),
                state.tick,
                isPaused(),
                seen,
                WindowFixture.middle(ui, "Notice"));
        System.out.flush();
    }
}
