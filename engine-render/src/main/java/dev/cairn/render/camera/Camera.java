package dev.cairn.render.camera;

import org.joml.Vector3d;

import java.util.concurrent.locks.ReentrantLock;

/**
 * Where the picture is taken from: a position in double (so that scenes far from the origin are
 * seen as sharply as at it), a heading and a lens. It stays upright: yaw turns about the world's y
 * axis, pitch lifts the view.
 *
 * <p>Yaw 0 looks along -z, yaw grows to the right (towards +x); pitch grows upwards and is kept
 * within +-89.9 degrees.
 *
 * <p>All methods may be called from any thread: the window's keys move the camera on the GL thread
 * while {@code update} places it on the simulation thread; each call is atomic, the later one wins.
 * No method allocates.
 */
public final class Camera {
    private static final double MAX_PITCH = Math.toRadians(89.9);

    /** {@link #followed()} when the camera follows nothing. */
    public static final long NOTHING = -1;

    private final ReentrantLock lock = new ReentrantLock();
    private double x;
    private double y;
    private double z;
    private double yaw;
    private double pitch;
    private double fieldOfView = Math.toRadians(50);
    private double near = 0.1;
    private double far = 2000;
    private double speed = 5;
    private final Following following = new Following();

    /** A camera at (0, 3, 10) that looks at the origin. */
    public Camera() {
        lookAt(0, 3, 10, 0, 0, 0);
    }

    /**
     * Places the camera and turns it to a point.
     *
     * @param eyeX position, world frame, metres
     * @param eyeY same
     * @param eyeZ same
     * @param targetX point to look at, world frame, metres; if it is the position itself, the
     *     heading stays
     * @param targetY same
     * @param targetZ same
     * @return this
     */
    public Camera lookAt(
            double eyeX, double eyeY, double eyeZ, double targetX, double targetY, double targetZ) {
        Following.checkFinite("eye", eyeX, eyeY, eyeZ);
        Following.checkFinite("target", targetX, targetY, targetZ);
        lock.lock();
        try {
            x = eyeX;
            y = eyeY;
            z = eyeZ;
            turnTo(targetX - eyeX, targetY - eyeY, targetZ - eyeZ);
        } finally {
            lock.unlock();
        }
        return this;
    }

    /**
     * Turns the camera to a point.
     *
     * @param targetX world frame, metres
     * @param targetY same
     * @param targetZ same
     * @return this
     */
    public Camera lookAt(double targetX, double targetY, double targetZ) {
        Following.checkFinite("target", targetX, targetY, targetZ);
        lock.lock();
        try {
            turnTo(targetX - x, targetY - y, targetZ - z);
        } finally {
            lock.unlock();
        }
        return this;
    }

    /**
     * Places the camera; the heading stays.
     *
     * @param newX world frame, metres
     * @param newY same
     * @param newZ same
     * @return this
     */
    public Camera moveTo(double newX, double newY, double newZ) {
        Following.checkFinite("position", newX, newY, newZ);
        lock.lock();
        try {
            x = newX;
            y = newY;
            z = newZ;
        } finally {
            lock.unlock();
        }
        return this;
    }

    /**
     * Moves the camera along its own axes, as the movement keys do.
     *
     * @param forward metres along the view direction
     * @param right metres to the right, level
     * @param up metres along the world's y axis
     */
    public void fly(double forward, double right, double up) {
        Following.checkFinite("movement", forward, right, up);
        lock.lock();
        try {
            double sinYaw = Math.sin(yaw);
            double cosYaw = Math.cos(yaw);
            double level = Math.cos(pitch);
            double dx = forward * level * sinYaw + right * cosYaw;
            double dy = forward * Math.sin(pitch) + up;
            double dz = -forward * level * cosYaw + right * sinYaw;
            x += dx;
            y += dy;
            z += dz;
            following.shift(dx, dy, dz);
        } finally {
            lock.unlock();
        }
    }

    /**
     * Turns the camera.
     *
     * @param yawRadians to the right
     * @param pitchRadians upwards
     */
    public void turn(double yawRadians, double pitchRadians) {
        Following.checkFinite("turn", yawRadians, pitchRadians, 0);
        lock.lock();
        try {
            yaw = Math.IEEEremainder(yaw + yawRadians, 2 * Math.PI);
            pitch = Math.clamp(pitch + pitchRadians, -MAX_PITCH, MAX_PITCH);
        } finally {
            lock.unlock();
        }
    }

    /**
     * Makes the camera ride beside an entity that has a pose and a visual, until {@link #release()}
     * or until the entity is gone. The movement keys shift the offset.
     *
     * @param entity which one
     * @param offsetX where the camera is, seen from the entity's position, world axes, metres
     * @param offsetY same
     * @param offsetZ same
     * @param lookAtIt whether the camera also keeps turned to the entity
     * @return this
     */
    public Camera follow(
            long entity, double offsetX, double offsetY, double offsetZ, boolean lookAtIt) {
        Following.checkFinite("offset", offsetX, offsetY, offsetZ);
        lock.lock();
        try {
            following.set(entity, offsetX, offsetY, offsetZ, lookAtIt);
        } finally {
            lock.unlock();
        }
        return this;
    }

    /**
     * Whether a camera that follows also turns with the entity's heading, as a passenger does.
     *
     * @param value true from now until the next {@link #follow}
     * @return this
     */
    public Camera turning(boolean value) {
        lock.lock();
        try {
            following.turns(value);
        } finally {
            lock.unlock();
        }
        return this;
    }

    /**
     * Ends {@link #follow}; the camera stays where it is.
     *
     * @return this
     */
    public Camera release() {
        return follow(NOTHING, 0, 0, 0, false);
    }

    /**
     * The entity that the camera rides on.
     *
     * @return the entity, or {@link #NOTHING}
     */
    public long followed() {
        lock.lock();
        try {
            return following.entity;
        } finally {
            lock.unlock();
        }
    }

    /**
     * Called by the renderer before each frame with the interpolated pose of the followed entity.
     *
     * @param entityX world frame, metres
     * @param entityY same
     * @param entityZ same
     * @param heading of the entity about the world's y axis, radians
     */
    public void rideOn(double entityX, double entityY, double entityZ, double heading) {
        lock.lock();
        try {
            if (following.entity != NOTHING) {
                yaw = Math.IEEEremainder(yaw - following.turned(heading), 2 * Math.PI);
                x = entityX + following.x;
                y = entityY + following.y;
                z = entityZ + following.z;
                if (following.looks) {
                    turnTo(-following.x, -following.y, -following.z);
                }
            }
        } finally {
            lock.unlock();
        }
    }

    /**
     * Chooses the lens.
     *
     * @param verticalRadians angle between the upper and the lower edge of the picture, 0.02..3.0
     * @return this
     */
    public Camera fieldOfView(double verticalRadians) {
        if (!(verticalRadians >= 0.02 && verticalRadians <= 3.0)) {
            throw new IllegalArgumentException(
                    "field of view is " + verticalRadians + " rad, expected 0.02..3.0");
        }
        lock.lock();
        try {
            fieldOfView = verticalRadians;
        } finally {
            lock.unlock();
        }
        return this;
    }

    /**
     * Chooses what is drawn by its distance along the view direction. The depth buffer's precision
     * falls with {@code far / near}.
     *
     * @param nearMetres &gt; 0
     * @param farMetres &gt; {@code nearMetres}
     * @return this
     */
    public Camera range(double nearMetres, double farMetres) {
        if (!(nearMetres > 0 && farMetres > nearMetres) || Double.isInfinite(farMetres)) {
            throw new IllegalArgumentException(
                    "range is %s..%s m, expected 0 < near < far, finite"
                            .formatted(nearMetres, farMetres));
        }
        lock.lock();
        try {
            near = nearMetres;
            far = farMetres;
        } finally {
            lock.unlock();
        }
        return this;
    }

    /**
     * How fast the movement keys fly; with the fast key held, five times this.
     *
     * @param metresPerSecond &ge; 0
     * @return this
     */
    public Camera speed(double metresPerSecond) {
        if (!(metresPerSecond >= 0) || Double.isInfinite(metresPerSecond)) {
            throw new IllegalArgumentException(
                    "speed is " + metresPerSecond + " m/s, expected >= 0 and finite");
        }
        lock.lock();
        try {
            speed = metresPerSecond;
        } finally {
            lock.unlock();
        }
        return this;
    }

    /**
     * Where the camera is.
     *
     * @param dest receives the world position, metres
     * @return {@code dest}
     */
    public Vector3d position(Vector3d dest) {
        lock.lock();
        try {
            return dest.set(x, y, z);
        } finally {
            lock.unlock();
        }
    }

    /**
     * Where the camera looks.
     *
     * @param dest receives the unit direction, world frame
     * @return {@code dest}
     */
    public Vector3d forward(Vector3d dest) {
        lock.lock();
        try {
            double level = Math.cos(pitch);
            return dest.set(level * Math.sin(yaw), Math.sin(pitch), -level * Math.cos(yaw));
        } finally {
            lock.unlock();
        }
    }

    /**
     * The direction from the camera through a place in the picture, for picking and throwing.
     *
     * @param across -1 at the left edge, 0 in the middle, 1 at the right edge
     * @param upwards -1 at the lower edge, 0 in the middle, 1 at the upper edge
     * @param aspect width of the picture by its height, &gt; 0
     * @param dest receives the unit direction, world frame
     * @return {@code dest}
     */
    public Vector3d ray(double across, double upwards, double aspect, Vector3d dest) {
        lock.lock();
        try {
            double tan = Math.tan(fieldOfView / 2);
            dest.set(across * tan * aspect, upwards * tan, -1).normalize();
            return dest.rotateX(pitch).rotateY(-yaw);
        } finally {
            lock.unlock();
        }
    }

    /**
     * Takes over everything of another camera.
     *
     * @param other which one
     * @return this
     */
    public Camera set(Camera other) {
        if (other == this) {
            return this;
        }
        // Never holds two locks, so that two cameras may be set from each other.
        double[] state;
        Following theirs = new Following();
        other.lock.lock();
        try {
            state =
                    new double[] {
                        other.x,
                        other.y,
                        other.z,
                        other.yaw,
                        other.pitch,
                        other.fieldOfView,
                        other.near,
                        other.far,
                        other.speed
                    };
            theirs.set(other.following);
        } finally {
            other.lock.unlock();
        }
        lock.lock();
        try {
            x = state[0];
            y = state[1];
            z = state[2];
            yaw = state[3];
            pitch = state[4];
            fieldOfView = state[5];
            near = state[6];
            far = state[7];
            speed = state[8];
            following.set(theirs);
        } finally {
            lock.unlock();
        }
        return this;
    }

    /**
     * Heading, to the right of -z.
     *
     * @return radians, -pi..pi
     */
    public double yaw() {
        lock.lock();
        try {
            return yaw;
        } finally {
            lock.unlock();
        }
    }

    /**
     * Lift of the view.
     *
     * @return radians, positive upwards
     */
    public double pitch() {
        lock.lock();
        try {
            return pitch;
        } finally {
            lock.unlock();
        }
    }

    /**
     * Angle between the upper and the lower edge of the picture.
     *
     * @return radians
     */
    public double fieldOfView() {
        lock.lock();
        try {
            return fieldOfView;
        } finally {
            lock.unlock();
        }
    }

    /**
     * Nearest distance that is drawn.
     *
     * @return metres
     */
    public double near() {
        lock.lock();
        try {
            return near;
        } finally {
            lock.unlock();
        }
    }

    /**
     * Farthest distance that is drawn.
     *
     * @return metres
     */
    public double far() {
        lock.lock();
        try {
            return far;
        } finally {
            lock.unlock();
        }
    }

    /**
     * Speed of the movement keys.
     *
     * @return metres per second
     */
    public double speed() {
        lock.lock();
        try {
            return speed;
        } finally {
            lock.unlock();
        }
    }

    private void turnTo(double dx, double dy, double dz) {
        double level = Math.sqrt(dx * dx + dz * dz);
        if (level == 0 && dy == 0) {
            return;
        }
        if (level > 0) {
            yaw = Math.atan2(dx, -dz);
        }
        pitch = Math.clamp(Math.atan2(dy, level), -MAX_PITCH, MAX_PITCH);
    }
}
