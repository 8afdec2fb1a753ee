package dev.cairn.samples.editor.gizmo;

import dev.cairn.render.camera.Camera;

import org.joml.Vector3d;

/**
 * Takes the camera around a point: the point keeps its place in the picture and its distance.
 * Window thread.
 */
public final class Orbit {
    /** A way as long as the picture is high turns by this, rad. */
    private static final double TURN = Math.PI;

    private final Vector3d pivot = new Vector3d();
    private final Vector3d seen = new Vector3d();
    private final Vector3d forward = new Vector3d();
    private final Vector3d right = new Vector3d();
    private final Vector3d up = new Vector3d();
    private double lastX;
    private double lastY;

    /** Around nothing yet. */
    public Orbit() {}

    /**
     * Begins.
     *
     * @param around world, m
     * @param x of the cursor, as a share of the picture's width
     * @param y of the cursor, as a share of its height, downwards
     */
    public void begin(Vector3d around, double x, double y) {
        pivot.set(around);
        lastX = x;
        lastY = y;
    }

    /**
     * Goes on: what is grabbed goes with the cursor, so the camera goes the other way.
     *
     * @param camera what is moved
     * @param x of the cursor now
     * @param y of the cursor now
     * @param aspect width by height of the picture
     */
    public void go(Camera camera, double x, double y, double aspect) {
        double yaw = -(x - lastX) * aspect * TURN;
        double pitch = (y - lastY) * TURN;
        lastX = x;
        lastY = y;
        if (yaw == 0 && pitch == 0) {
            return;
        }
        // v = R^T (c - e): where the point is in the camera's frame.
        axes(camera);
        camera.position(seen);
        seen.set(pivot.x - seen.x, pivot.y - seen.y, pivot.z - seen.z);
        double ahead = seen.dot(forward);
        double aside = seen.dot(right);
        double above = seen.dot(up);
        // The camera bounds its pitch, so it is asked for its axes again. It looks down by as much
        // as it rises.
        camera.turn(yaw, -pitch);
        axes(camera);
        // e' = c - R' v
        seen.set(pivot).fma(-ahead, forward).fma(-aside, right).fma(-above, up);
        camera.moveTo(seen.x, seen.y, seen.z);
    }

    private void axes(Camera camera) {
        camera.forward(forward);
        forward.cross(0, 1, 0, right).normalize();
        right.cross(forward, up);
    }
}
