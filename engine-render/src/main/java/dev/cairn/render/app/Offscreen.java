package dev.cairn.render.app;

import dev.cairn.core.snapshot.PoseSnapshot;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.camera.Light;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;

/** Draws snapshots into pictures without a display. First form. */
public final class Offscreen implements AutoCloseable {
    private Offscreen() {}

    /**
     * Whether pictures can be drawn on this machine.
     *
     * @return null if they can, otherwise one sentence that says why not and what to install
     */
    public static @Nullable String unavailableReason() {
        throw new UnsupportedOperationException();
    }

    /**
     * Opens a place to draw to. One at a time; main thread.
     *
     * @param width pixels
     * @param height pixels
     * @return the place
     * @throws IllegalStateException with the unavailable reason
     */
    public static Offscreen open(int width, int height) {
        throw new UnsupportedOperationException();
    }

    /**
     * Draws.
     *
     * @param snapshot what
     * @param alpha 0 = previous poses, 1 = current poses
     * @param camera from where
     * @param light in which light
     */
    public void draw(PoseSnapshot snapshot, double alpha, Camera camera, Light light) {
        throw new UnsupportedOperationException();
    }

    /**
     * What was drawn last.
     *
     * @return a new picture
     */
    public Picture picture() {
        throw new UnsupportedOperationException();
    }

    /**
     * Writes what was drawn last.
     *
     * @param file where; parent folders are made
     */
    public void savePng(Path file) {
        throw new UnsupportedOperationException();
    }

    @Override
    public void close() {}
}
