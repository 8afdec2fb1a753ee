package dev.cairn.render.camera;

/** What a camera rides on and from where it sees it. Guarded by the camera's lock. */
final class Following {
    /** The entity, or {@link Camera#NOTHING}. */
    long entity = Camera.NOTHING;

    /** Where the camera is, seen from the entity, world axes, m. */
    double x;

    double y;
    double z;

    /** Whether the camera keeps turned to the entity. */
    boolean looks;

    /** Whether the camera's place and view turn with the entity's heading. */
    private boolean turns;

    /** The heading at the last frame; NaN before the first. */
    private double heading = Double.NaN;

    void turns(boolean value) {
        turns = value;
        heading = Double.NaN;
    }

    /** Turns the place with the entity; how far it turned to the left, radians. */
    double turned(double newHeading) {
        double angle =
                turns && !Double.isNaN(heading)
                        ? Math.IEEEremainder(newHeading - heading, 2 * Math.PI)
                        : 0;
        heading = newHeading;
        double cos = Math.cos(angle);
        double sin = Math.sin(angle);
        double turnedX = cos * x + sin * z;
        z = cos * z - sin * x;
        x = turnedX;
        return angle;
    }

    static void checkFinite(String name, double x, double y, double z) {
        if (!(Double.isFinite(x) && Double.isFinite(y) && Double.isFinite(z))) {
            throw new IllegalArgumentException(
                    name + " is (" + x + ", " + y + ", " + z + "), expected finite numbers");
        }
    }

    void set(long newEntity, double newX, double newY, double newZ, boolean newLooks) {
        entity = newEntity;
        x = newX;
        y = newY;
        z = newZ;
        looks = newLooks;
        turns(false);
    }

    void set(Following other) {
        set(other.entity, other.x, other.y, other.z, other.looks);
        turns(other.turns);
    }

    void shift(double dx, double dy, double dz) {
        x += dx;
        y += dy;
        z += dz;
    }
}
