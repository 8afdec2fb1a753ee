package dev.cairn.samples.scenefile;

import dev.cairn.physics.Collider;
import dev.cairn.physics.Material;
import dev.cairn.physics.collider.Filter;
import dev.cairn.physics.shape.Shape;

import org.joml.Quaterniond;
import org.jspecify.annotations.Nullable;

/**
 * One of the shapes that an entity is made of. Immutable.
 *
 * @param shape its shape
 * @param position of the shape's frame in the entity's, m
 * @param rotation of the shape's frame in the entity's
 * @param material of it alone, or null for the entity's
 * @param filter whom it meets, or null for the entity's
 * @param sensor whether it only tells who is in it
 * @param surfaceVelocity at which the surface runs along, entity's axes, m/s; null for that of the
 *     material
 * @param userData a word or a number ({@code Double}) for the program; null for none
 */
public record PartSpec(
        ShapeSpec shape,
        Xyz position,
        Turn rotation,
        @Nullable Material material,
        @Nullable Filter filter,
        boolean sensor,
        @Nullable Xyz surfaceVelocity,
        @Nullable Object userData) {
    /**
     * A shape at the entity's origin.
     *
     * @param shape which one
     * @return a part with defaults for all else
     */
    public static PartSpec of(ShapeSpec shape) {
        return new PartSpec(shape, Xyz.ZERO, Turn.NONE, null, null, false, null, null);
    }

    /**
     * The same in another shape.
     *
     * @param value the shape
     * @return a copy
     */
    public PartSpec withShape(ShapeSpec value) {
        return new PartSpec(
                value, position, rotation, material, filter, sensor, surfaceVelocity, userData);
    }

    /**
     * The same elsewhere in the entity.
     *
     * @param newPosition m
     * @return a copy
     */
    public PartSpec at(Xyz newPosition) {
        return new PartSpec(
                shape, newPosition, rotation, material, filter, sensor, surfaceVelocity, userData);
    }

    /**
     * The same, as a sensor or not.
     *
     * @param value true for a sensor
     * @return a copy
     */
    public PartSpec withSensor(boolean value) {
        return new PartSpec(
                shape, position, rotation, material, filter, value, surfaceVelocity, userData);
    }

    /**
     * The same with another run of its surface.
     *
     * @param value m/s, or null for that of the material
     * @return a copy
     */
    public PartSpec withSurfaceVelocity(@Nullable Xyz value) {
        return new PartSpec(shape, position, rotation, material, filter, sensor, value, userData);
    }

    /**
     * The same of another substance.
     *
     * @param value the material, or null for the entity's
     * @return a copy
     */
    public PartSpec withMaterial(@Nullable Material value) {
        return new PartSpec(
                shape, position, rotation, value, filter, sensor, surfaceVelocity, userData);
    }

    /**
     * The same, turned otherwise in the entity.
     *
     * @param value of the shape's frame
     * @return a copy
     */
    public PartSpec turned(Turn value) {
        return new PartSpec(
                shape, position, value, material, filter, sensor, surfaceVelocity, userData);
    }

    /**
     * The same, meeting others.
     *
     * @param value the filter, or null for the entity's
     * @return a copy
     */
    public PartSpec withFilter(@Nullable Filter value) {
        return new PartSpec(
                shape, position, rotation, material, value, sensor, surfaceVelocity, userData);
    }

    /**
     * As a collider of a body.
     *
     * @param made its shape at its size
     * @param scale of the entity, &gt; 0
     * @return the collider
     * @throws IllegalArgumentException if it cannot be: a half-space as a sensor
     */
    public Collider collider(Shape made, double scale) {
        Collider collider =
                Collider.of(made)
                        .at(scale * position.x(), scale * position.y(), scale * position.z())
                        .rotation(
                                new Quaterniond(
                                        rotation.x(), rotation.y(), rotation.z(), rotation.w()))
                        .sensor(sensor);
        if (surfaceVelocity != null) {
            collider =
                    collider.surfaceVelocity(
                            surfaceVelocity.x(), surfaceVelocity.y(), surfaceVelocity.z());
        }
        if (material != null) {
            collider = collider.material(material);
        }
        if (filter != null) {
            collider = collider.filter(filter);
        }
        return userData == null ? collider : collider.userData(userData);
    }
}
