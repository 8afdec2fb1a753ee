package dev.cairn.render.app;

import dev.cairn.core.snapshot.PoseSnapshot;
import dev.cairn.render.camera.Camera;
import dev.cairn.render.gl.DebugLines;
import dev.cairn.render.input.Pointer;

import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

import java.nio.file.Path;
import java.util.List;

/**
 * What the window shows in the present frame, for {@link Application#panels}. Window thread, inside
 * that call only.
 */
public final class View {
    private final Camera camera;
    private final Pointer pointer;
    private PoseSnapshot snapshot;
    private double alpha;
    private double aspect = 1;
    private double framesPerSecond;
    private double panelMillis;
    private long frames;
    private final Picker picker = new Picker();
    private final Vector3d eye = new Vector3d();
    private final Vector3d direction = new Vector3d();
    private @Nullable DebugLines lines;
    private List<Path> dropped = List.of();

    View(Camera camera, Pointer pointer, PoseSnapshot first) {
        this.camera = camera;
        this.pointer = pointer;
        this.snapshot = first;
    }

    void next(PoseSnapshot newSnapshot, double newAlpha, double newAspect, long frame) {
        snapshot = newSnapshot;
        alpha = newAlpha;
        aspect = newAspect;
        frames = frame;
    }

    void dropped(List<Path> value) {
        dropped = value;
    }

    void lines(DebugLines value) {
        lines = value;
    }

    void rate(double newFramesPerSecond, double newPanelMillis) {
        framesPerSecond = newFramesPerSecond;
        panelMillis = newPanelMillis;
    }

    /**
     * Draws a line over the scene in this frame; a dot if both ends are one. What lies behind
     * something is faint.
     *
     * @param ax world frame, m
     * @param ay same
     * @param az same
     * @param bx other end
     * @param by same
     * @param bz same
     * @param rgb 0xRRGGBB in sRGB
     * @param width logical pixels
     */
    public void line(
            double ax,
            double ay,
            double az,
            double bx,
            double by,
            double bz,
            int rgb,
            double width) {
        if (lines != null) {
            lines.line(ax, ay, az, bx, by, bz, rgb, width);
        }
    }

    /**
     * Draws a line as {@link #line} does, but as well where something is in front of it.
     *
     * @param ax world frame, m
     * @param ay same
     * @param az same
     * @param bx other end
     * @param by same
     * @param bz same
     * @param rgb 0xRRGGBB in sRGB
     * @param width logical pixels
     */
    public void lineOver(
            double ax,
            double ay,
            double az,
            double bx,
            double by,
            double bz,
            int rgb,
            double width) {
        if (lines != null) {
            lines.hidden(1);
            lines.line(ax, ay, az, bx, by, bz, rgb, width);
            lines.hidden(DebugLines.HIDDEN);
        }
    }

    /**
     * What is drawn at a place in the picture.
     *
     * @param across -1 at the left edge, 1 at the right edge
     * @param upwards -1 at the lower edge, 1 at the upper edge
     * @return the nearest, or null if only the sky is there
     */
    public @Nullable Pick pick(double across, double upwards) {
        camera.position(eye);
        camera.ray(across, upwards, aspect, direction);
        return picker.pick(snapshot, alpha, eye, direction);
    }

    /**
     * The tick that is drawn, with what was added to it.
     *
     * @return the snapshot; not to be kept
     */
    public PoseSnapshot snapshot() {
        return snapshot;
    }

    /**
     * How far the picture is from the previous pose to the current one.
     *
     * @return 0..1
     */
    public double alpha() {
        return alpha;
    }

    /**
     * The camera.
     *
     * @return the camera of the application
     */
    public Camera camera() {
        return camera;
    }

    /**
     * The mouse, as far as the panels leave it to the scene.
     *
     * @return the pointer, as of the last frame's panels
     */
    public Pointer pointer() {
        return pointer;
    }

    /**
     * The files that the user dropped into the window, where the {@link #pointer} is.
     *
     * @return as a rule empty; each file once
     */
    public List<Path> dropped() {
        return dropped;
    }

    /**
     * Width of the picture by its height.
     *
     * @return above 0
     */
    public double aspect() {
        return aspect;
    }

    /**
     * Frames per second over the last half second.
     *
     * @return at least 0
     */
    public double framesPerSecond() {
        return framesPerSecond;
    }

    /**
     * Wall time that the panels took of this thread for each frame: their calls, and handing them
     * to OpenGL.
     *
     * @return ms, mean over the last half second
     */
    public double panelMillis() {
        return panelMillis;
    }

    /**
     * Frames since the window was opened.
     *
     * @return the count
     */
    public long frames() {
        return frames;
    }
}
