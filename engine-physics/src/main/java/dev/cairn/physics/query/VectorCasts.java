package dev.cairn.physics.query;

import org.joml.Vector3dc;
import org.jspecify.annotations.Nullable;

import java.util.List;

/**
 * Casts through a world, with points and directions as JOML's vectors beside three doubles. The
 * thread is that of who implements it. Each throws an IllegalArgumentException if a number is not
 * finite, the direction is zero, the distance negative or what moves endless, and an
 * IllegalStateException if the world is closed or a step runs.
 *
 * @param <B> a body
 * @param <M> a collider that was met, and where
 */
public interface VectorCasts<B, M> {
    /**
     * Follows a ray to the first body.
     *
     * @param fromX where the ray starts, world, m, finite
     * @param fromY see {@code fromX}
     * @param fromZ see {@code fromX}
     * @param directionX where it goes, world, any length above 0
     * @param directionY see {@code directionX}
     * @param directionZ see {@code directionX}
     * @param maxDistance how far it goes, m, at least 0, may be infinite
     * @param out receives the hit; unchanged when there is none
     * @return the body, or {@code null} if there is none
     */
    @Nullable B rayCast(
            double fromX,
            double fromY,
            double fromZ,
            double directionX,
            double directionY,
            double directionZ,
            double maxDistance,
            Hit out);

    /**
     * Follows a ray to the first body.
     *
     * @param from where the ray starts, world, m, finite
     * @param direction where it goes, world, any length above 0
     * @param maxDistance how far it goes, m, at least 0, may be infinite
     * @param out receives the hit; unchanged when there is none
     * @return the body, or {@code null} if there is none
     */
    default @Nullable B rayCast(Vector3dc from, Vector3dc direction, double maxDistance, Hit out) {
        return rayCast(
                from.x(),
                from.y(),
                from.z(),
                direction.x(),
                direction.y(),
                direction.z(),
                maxDistance,
                out);
    }

    /**
     * Follows a ray through all that it meets. Each collider is met once, where the ray first
     * touches it. Allocates a hit for each.
     *
     * @param fromX where the ray starts, world, m, finite
     * @param fromY see {@code fromX}
     * @param fromZ see {@code fromX}
     * @param directionX where it goes, world, any length above 0
     * @param directionY see {@code directionX}
     * @param directionZ see {@code directionX}
     * @param maxDistance how far it goes, m, at least 0, may be infinite
     * @param out receives the hits, the nearest first, of equals in slot order, after what it holds
     * @return how many there are
     */
    int rayCastAll(
            double fromX,
            double fromY,
            double fromZ,
            double directionX,
            double directionY,
            double directionZ,
            double maxDistance,
            List<? super M> out);

    /**
     * Follows a ray through all that it meets. Each collider is met once, where the ray first
     * touches it. Allocates a hit for each.
     *
     * @param from where the ray starts, world, m, finite
     * @param direction where it goes, world, any length above 0
     * @param maxDistance how far it goes, m, at least 0, may be infinite
     * @param out receives the hits, the nearest first, of equals in slot order, after what it holds
     * @return how many there are
     */
    default int rayCastAll(
            Vector3dc from, Vector3dc direction, double maxDistance, List<? super M> out) {
        return rayCastAll(
                from.x(),
                from.y(),
                from.z(),
                direction.x(),
                direction.y(),
                direction.z(),
                maxDistance,
                out);
    }

    /**
     * Moves a shape, without turning it, to the first body that it touches.
     *
     * @param moving the shape where it starts; not a half-space
     * @param directionX where it goes, world, any length above 0
     * @param directionY see {@code directionX}
     * @param directionZ see {@code directionX}
     * @param maxDistance how far it goes, m, at least 0, may be infinite
     * @param out receives the hit; unchanged when there is none
     * @return the body, or {@code null} if there is none
     */
    @Nullable B shapeCast(
            Placement moving,
            double directionX,
            double directionY,
            double directionZ,
            double maxDistance,
            Hit out);

    /**
     * Moves a shape, without turning it, to the first body that it touches.
     *
     * @param moving the shape where it starts; not a half-space
     * @param direction where it goes, world, any length above 0
     * @param maxDistance how far it goes, m, at least 0, may be infinite
     * @param out receives the hit; unchanged when there is none
     * @return the body, or {@code null} if there is none
     */
    default @Nullable B shapeCast(
            Placement moving, Vector3dc direction, double maxDistance, Hit out) {
        return shapeCast(moving, direction.x(), direction.y(), direction.z(), maxDistance, out);
    }

    /**
     * Moves a shape, without turning it, through all that it meets. Each collider is met once,
     * where it is first touched. Allocates a hit for each.
     *
     * @param moving the shape where it starts; not a half-space
     * @param directionX where it goes, world, any length above 0
     * @param directionY see {@code directionX}
     * @param directionZ see {@code directionX}
     * @param maxDistance how far it goes, m, at least 0, may be infinite
     * @param out receives the hits, the nearest first, of equals in slot order, after what it holds
     * @return how many there are
     */
    int shapeCastAll(
            Placement moving,
            double directionX,
            double directionY,
            double directionZ,
            double maxDistance,
            List<? super M> out);

    /**
     * Moves a shape, without turning it, through all that it meets. Each collider is met once,
     * where it is first touched. Allocates a hit for each.
     *
     * @param moving the shape where it starts; not a half-space
     * @param direction where it goes, world, any length above 0
     * @param maxDistance how far it goes, m, at least 0, may be infinite
     * @param out receives the hits, the nearest first, of equals in slot order, after what it holds
     * @return how many there are
     */
    default int shapeCastAll(
            Placement moving, Vector3dc direction, double maxDistance, List<? super M> out) {
        return shapeCastAll(moving, direction.x(), direction.y(), direction.z(), maxDistance, out);
    }
}
