package dev.cairn.render.camera;

import dev.cairn.core.ecs.Query;
import dev.cairn.core.ecs.World;
import dev.cairn.core.ecs.component.Component;

/**
 * Component of an entity that carries the camera: from the start of the scene the camera rides on
 * it, as by {@link Camera#follow}. The first in the order of the world carries it. Immutable.
 *
 * @param x where the camera is, seen from the entity's position, world axes, m
 * @param y same
 * @param z same
 * @param looks whether the camera also keeps turned to the entity
 */
public record CameraMount(double x, double y, double z, boolean looks) {
    /** Key of this component. */
    public static final Component<CameraMount> COMPONENT = Component.of(CameraMount.class);

    /**
     * Checks the place.
     *
     * @throws IllegalArgumentException if it is not finite, or the camera would look at itself
     */
    public CameraMount {
        double square = x * x + y * y + z * z;
        if (!Double.isFinite(square)) {
            throw new IllegalArgumentException(
                    "camera mount at (%s, %s, %s), expected finite numbers".formatted(x, y, z));
        }
        if (looks && square == 0) {
            throw new IllegalArgumentException(
                    "camera mount at (0, 0, 0) that looks at its entity, expected a distance");
        }
    }

    /**
     * Puts a camera on the entity that carries it, or takes it off if there is none. Between ticks.
     *
     * @param ecs a world
     * @param camera which camera
     * @return true if an entity carries it
     */
    public static boolean attach(World ecs, Camera camera) {
        Query mounts = ecs.query(COMPONENT);
        for (int c = 0; c < mounts.chunkCount(); c++) {
            if (mounts.chunk(c).size() > 0) {
                long entity = mounts.chunk(c).entity(0);
                CameraMount mount = ecs.get(entity, COMPONENT);
                camera.follow(entity, mount.x, mount.y, mount.z, mount.looks);
                return true;
            }
        }
        camera.release();
        return false;
    }
}
