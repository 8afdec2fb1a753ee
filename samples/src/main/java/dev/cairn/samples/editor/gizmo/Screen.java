package dev.cairn.samples.editor.gizmo;

import dev.cairn.render.app.View;
import dev.cairn.render.camera.Camera;

import org.joml.Vector3d;

/**
 * Where points of the world are in the picture, and the ray under the cursor. Lengths in the
 * picture are shares of its height, from the upper left corner. Makes no garbage. Window thread.
 */
final class Screen {
    final Vector3d eye = new Vector3d();

    /** Direction of the ray under the cursor, unit. */
    final Vector3d ray = new Vector3d();

    private final Vector3d forward = new Vector3d();
    private final Vector3d right = new Vector3d();
    private final Vector3d up = new Vector3d();
    private final Vector3d arm = new Vector3d();
    private double aspect;
    private double tan;

    /** Where the cursor is. */
    double cursorX;

    double cursorY;

    /** The point that was projected last. */
    double x;

    double y;

    void look(View view) {
        Camera camera = view.camera();
        camera.position(eye);
        camera.forward(forward);
        right.set(1, 0, 0).rotateY(-camera.yaw());
        up.set(right).cross(forward);
        aspect = view.aspect();
        tan = Math.tan(camera.fieldOfView() / 2);
        cursorX = view.pointer().x() * aspect;
        cursorY = view.pointer().y();
        camera.ray(view.pointer().across(), view.pointer().upwards(), aspect, ray);
    }

    /** Width of the picture by its height. */
    double aspect() {
        return aspect;
    }

    /** How many metres half the picture's height is, at the distance of a point. */
    double halfHeight(Vector3d at) {
        return arm.set(at).sub(eye).dot(forward) * tan;
    }

    /** Sets {@link #x} and {@link #y}; false for what is behind the camera. */
    boolean project(double px, double py, double pz) {
        arm.set(px, py, pz).sub(eye);
        double depth = arm.dot(forward);
        if (depth <= 0) {
            return false;
        }
        x = 0.5 * aspect + 0.5 * arm.dot(right) / (depth * tan);
        y = 0.5 - 0.5 * arm.dot(up) / (depth * tan);
        return true;
    }

    /** The distance of the cursor from a segment in the picture. */
    double fromCursor(double ax, double ay, double bx, double by) {
        double dx = bx - ax;
        double dy = by - ay;
        double square = dx * dx + dy * dy;
        double t = square == 0 ? 0 : ((cursorX - ax) * dx + (cursorY - ay) * dy) / square;
        t = Math.clamp(t, 0.0, 1.0);
        return Math.hypot(ax + t * dx - cursorX, ay + t * dy - cursorY);
    }
}
