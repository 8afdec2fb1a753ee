package dev.cairn.render.gl;

import org.joml.Matrix4d;
import org.joml.Vector3d;

/** Draws over a scene before its samples are averaged, with the scene's depth still there. */
@FunctionalInterface
public interface SceneOverlay {
    /**
     * Draws. Leaves depth test and face culling as it found them.
     *
     * @param clipFromAnchored from positions relative to the anchor to clip space
     * @param anchor world frame, m
     * @param width of the picture, pixels
     * @param height of the picture, pixels
     */
    void draw(Matrix4d clipFromAnchored, Vector3d anchor, int width, int height);
}
