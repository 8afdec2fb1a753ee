package dev.cairn.render.app;

import dev.cairn.core.snapshot.PoseSnapshot;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.input.Pointer;

import java.nio.file.Path;
import java.util.List;

/** Views for tests of panels without a window. */
public final class Views {
    private Views() {}

    /** A view of nothing yet. */
    public static View of(Camera camera, Pointer pointer, PoseSnapshot first) {
        return new View(camera, pointer, first);
    }

    /** The next frame, with files that were dropped before it. */
    public static void next(
            View view, PoseSnapshot snapshot, double aspect, long frame, List<Path> dropped) {
        view.next(snapshot, 1, aspect, frame);
        view.dropped(dropped);
    }
}
