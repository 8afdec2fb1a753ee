package dev.cairn.physics.query;

import org.joml.Vector3dc;

/**
 * How a shape moves: a point of it, the pivot, at a constant velocity or acceleration, and the
 * shape about the pivot at a constant angular velocity. The pivot is the centre of mass, as of a
 * body in flight, unless {@link #about} says otherwise, as of a door.
 *
 * <p>Reuse one object: nothing here allocates. One thread at a time.
 */
public final class Motion {
    double vx, vy, vz, ax, ay, az, wx, wy, wz;
    double pivotX, pivotY, pivotZ;
    boolean hasPivot;

    /** Rest. */
    public Motion() {}

    /**
     * Back to rest about the centre of mass.
     *
     * @return this
     */
    public Motion clear() {
        hasPivot = false;
        return velocity(0, 0, 0).acceleration(0, 0, 0).angularVelocity(0, 0, 0);
    }

    /**
     * Velocity of the pivot at the start.
     *
     * @param x world, m/s, finite
     * @param y see {@code x}
     * @param z see {@code x}
     * @return this
     * @throws IllegalArgumentException if a number is not finite
     */
    public Motion velocity(double x, double y, double z) {
        Placement.finite("velocity x", x);
        Placement.finite("velocity y", y);
        Placement.finite("velocity z", z);
        vx = x;
        vy = y;
        vz = z;
        return this;
    }

    /**
     * As {@link #velocity(double, double, double)}.
     *
     * @param v world, m/s, finite
     * @return this
     */
    public Motion velocity(Vector3dc v) {
        return velocity(v.x(), v.y(), v.z());
    }

    /**
     * Acceleration of the pivot, such as gravity; 0 unless it is set.
     *
     * @param x world, m/s², finite
     * @param y see {@code x}
     * @param z see {@code x}
     * @return this
     * @throws IllegalArgumentException if a number is not finite
     */
    public Motion acceleration(double x, double y, double z) {
        Placement.finite("acceleration x", x);
        Placement.finite("acceleration y", y);
        Placement.finite("acceleration z", z);
        ax = x;
        ay = y;
        az = z;
        return this;
    }

    /**
     * Acceleration of the pivot.
     *
     * @param a world, m/s², finite
     * @return this
     */
    public Motion acceleration(Vector3dc a) {
        return acceleration(a.x(), a.y(), a.z());
    }

    /**
     * Angular velocity about the pivot.
     *
     * @param x world, rad/s, finite
     * @param y see {@code x}
     * @param z see {@code x}
     * @return this
     * @throws IllegalArgumentException if a number is not finite
     */
    public Motion angularVelocity(double x, double y, double z) {
        Placement.finite("angularVelocity x", x);
        Placement.finite("angularVelocity y", y);
        Placement.finite("angularVelocity z", z);
        wx = x;
        wy = y;
        wz = z;
        return this;
    }

    /**
     * As {@link #angularVelocity(double, double, double)}.
     *
     * @param w world, rad/s, finite
     * @return this
     */
    public Motion angularVelocity(Vector3dc w) {
        return angularVelocity(w.x(), w.y(), w.z());
    }

    /**
     * Chooses the pivot: the point, fixed to the shape, that velocity and acceleration are of and
     * that the shape turns about.
     *
     * @param x where it is at the start, world, m, finite
     * @param y see {@code x}
     * @param z see {@code x}
     * @return this
     * @throws IllegalArgumentException if a number is not finite
     */
    public Motion about(double x, double y, double z) {
        Placement.finite("pivot x", x);
        Placement.finite("pivot y", y);
        Placement.finite("pivot z", z);
        pivotX = x;
        pivotY = y;
        pivotZ = z;
        hasPivot = true;
        return this;
    }

    /**
     * Chooses the pivot.
     *
     * @param a where it is at the start, world, m, finite
     * @return this
     */
    public Motion about(Vector3dc a) {
        return about(a.x(), a.y(), a.z());
    }

    /**
     * A box around all places that a shape comes to; not the tightest.
     *
     * @param shape the shape where it starts
     * @param seconds for how long, s
     * @param dest receives minX, minY, minZ, maxX, maxY, maxZ, world, m
     */
    public void bounds(Placement shape, double seconds, double[] dest) {
        double outer = shape.shape.outerRadius() + lever(shape);
        double x = hasPivot ? pivotX : shape.x;
        double y = hasPivot ? pivotY : shape.y;
        double z = hasPivot ? pivotZ : shape.z;
        bounds(0, x, vx, ax, seconds, outer, dest);
        bounds(1, y, vy, ay, seconds, outer, dest);
        bounds(2, z, vz, az, seconds, outer, dest);
    }

    /** Between 0, the end, and where the parabola turns. */
    private static void bounds(
            int axis, double at, double v, double a, double t, double outer, double[] dest) {
        double end = t * (v + 0.5 * t * a);
        double turn = -v / a;
        double top = turn > 0 && turn < t ? 0.5 * turn * v : 0;
        double low = Math.min(0, Math.min(end, top));
        double high = Math.max(0, Math.max(end, top));
        double room = outer + 0x1p-44 * (Math.abs(at) + outer + high - low);
        dest[axis] = at + low - room;
        dest[axis + 3] = at + high + room;
    }

    /** Angular speed, rad/s. */
    double spin() {
        return Math.sqrt(wx * wx + wy * wy + wz * wz);
    }

    /** m/s². */
    double acceleration() {
        return Math.sqrt(ax * ax + ay * ay + az * az);
    }

    /** Speed of the pivot at most until a time, m/s. */
    double speed(double seconds) {
        return Math.sqrt(vx * vx + vy * vy + vz * vz) + seconds * acceleration();
    }

    /** How far the pivot goes at most in a time, m. */
    double way(double seconds) {
        return seconds * speed(seconds);
    }

    /** How far a place is from the pivot; m. */
    double lever(Placement p) {
        double x = hasPivot ? p.x - pivotX : 0;
        double y = hasPivot ? p.y - pivotY : 0;
        double z = hasPivot ? p.z - pivotZ : 0;
        return Math.sqrt(x * x + y * y + z * z);
    }
}
