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

    void set(long newEntity, double newX, double newY, double newZ, boolean newLooks) {
        entity = newEntity;
        x = newX;
        y = newY;
        z = newZ;
        looks = newLooks;
    }

    void set(Following other) {
        set(other.entity, other.x, other.y, other.z, other.looks);
    }

    void shift(double dx, double dy, double dz) {
        x += dx;
        y += dy;
        z += dz;
    }
}
