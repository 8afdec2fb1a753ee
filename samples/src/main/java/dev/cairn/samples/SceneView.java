package dev.cairn.samples;

import dev.cairn.render.camera.Camera;

/**
 * Where a scene wants to be seen from. World frame, metres.
 *
 * @param eyeX camera, x
 * @param eyeY camera, y
 * @param eyeZ camera, z
 * @param targetX what it looks at, x
 * @param targetY what it looks at, y
 * @param targetZ what it looks at, z
 * @param fieldOfView angle between the upper and the lower edge of the picture, rad
 */
public record SceneView(
        double eyeX,
        double eyeY,
        double eyeZ,
        double targetX,
        double targetY,
        double targetZ,
        double fieldOfView) {
    /** Angle between the upper and the lower edge of the picture where none is named. */
    private static final double FIELD_OF_VIEW = Math.toRadians(50);

    /**
     * A view through the usual lens.
     *
     * @param eyeX camera, x
     * @param eyeY camera, y
     * @param eyeZ camera, z
     * @param targetX what it looks at, x
     * @param targetY what it looks at, y
     * @param targetZ what it looks at, z
     */
    public SceneView(
            double eyeX, double eyeY, double eyeZ, double targetX, double targetY, double targetZ) {
        this(eyeX, eyeY, eyeZ, targetX, targetY, targetZ, FIELD_OF_VIEW);
    }

    /**
     * Places a camera.
     *
     * @param camera which one
     * @return the same camera
     */
    public Camera place(Camera camera) {
        return camera.lookAt(eyeX, eyeY, eyeZ, targetX, targetY, targetZ).fieldOfView(fieldOfView);
    }
}
