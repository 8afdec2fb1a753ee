package dev.cairn.samples.scenefile;

import dev.cairn.physics.Material;
import dev.cairn.render.camera.CameraMount;
import dev.cairn.render.input.Control;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;

/**
 * One thing of a scene. World frame, metres, seconds, y up. Immutable.
 *
 * @param name for people; may be empty, need not be unique
 * @param body its part in the physics
 * @param shape its shape
 * @param position where the origin of the shape's frame is, m
 * @param rotation how that frame is turned
 * @param scale factors along the shape's axes, &gt; 0
 * @param material friction, restitution, density
 * @param mass kg, or null for density times volume
 * @param velocity of the centre of mass, m/s
 * @param angularVelocity rad/s
 * @param look how it looks
 * @param driven what the user does to it
 * @param physics what else its body has; its first part, if any, is of the entity's shape
 */
public record EntitySpec(
        String name,
        BodyKind body,
        ShapeSpec shape,
        Xyz position,
        Turn rotation,
        Xyz scale,
        Material material,
        @Nullable Double mass,
        Xyz velocity,
        Xyz angularVelocity,
        LookSpec look,
        Driven driven,
        BodySpec physics) {
    /**
     * What drives an entity, and whether it carries the camera.
     *
     * @param controls what keys and buttons do to it
     * @param camera where the camera rides on it, or null if it does not
     */
    public record Driven(List<Control> controls, @Nullable CameraMount camera) {
        /** By nothing but physics. */
        public static final Driven NONE = new Driven(List.of(), null);

        /** Copies the list. */
        public Driven {
            controls = List.copyOf(controls);
        }
    }

    /** Checks scale and mass. */
    public EntitySpec {
        if (!(scale.x() > 0 && scale.y() > 0 && scale.z() > 0)) {
            throw new IllegalArgumentException("scale is " + scale + ", expected factors above 0");
        }
        if (mass != null && !(mass > 0 && mass < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException("mass is " + mass + " kg, expected above 0");
        }
        if (!physics.parts().isEmpty()) {
            if (!physics.parts().get(0).shape().equals(shape)) {
                throw new IllegalArgumentException(
                        "shape is %s, expected that of the first part, %s"
                                .formatted(shape, physics.parts().get(0).shape()));
            }
            if (scale.x() != scale.y() || scale.x() != scale.z()) {
                throw new IllegalArgumentException(
                        "scale of an entity of colliders is %s, expected three equal factors"
                                .formatted(scale));
            }
        }
    }

    /**
     * A thing at the origin, with defaults for all else.
     *
     * @param name for people
     * @param body its part in the physics
     * @param shape its shape
     * @return the entity
     */
    public static EntitySpec of(String name, BodyKind body, ShapeSpec shape) {
        return new EntitySpec(
                name,
                body,
                shape,
                Xyz.ZERO,
                Turn.NONE,
                Xyz.ONE,
                Material.DEFAULT,
                null,
                Xyz.ZERO,
                Xyz.ZERO,
                LookSpec.DEFAULT,
                Driven.NONE,
                BodySpec.DEFAULT);
    }

    /**
     * What it is made of.
     *
     * @return its parts, or its shape as the only one
     */
    public List<PartSpec> parts() {
        return physics.parts().isEmpty() ? List.of(PartSpec.of(shape)) : physics.parts();
    }

    /**
     * The same under another name.
     *
     * @param value the name
     * @return a copy
     */
    public EntitySpec withName(String value) {
        return new EntitySpec(
                value,
                body,
                shape,
                position,
                rotation,
                scale,
                material,
                mass,
                velocity,
                angularVelocity,
                look,
                driven,
                physics);
    }

    /**
     * The same with another part in the physics.
     *
     * @param value the part
     * @return a copy
     */
    public EntitySpec withBody(BodyKind value) {
        return new EntitySpec(
                name,
                value,
                shape,
                position,
                rotation,
                scale,
                material,
                mass,
                velocity,
                angularVelocity,
                look,
                driven,
                physics);
    }

    /**
     * The same in another shape.
     *
     * @param value the shape
     * @return a copy
     */
    public EntitySpec withShape(ShapeSpec value) {
        BodySpec changed = physics;
        if (!physics.parts().isEmpty()) {
            List<PartSpec> parts = new ArrayList<>(physics.parts());
            parts.set(0, parts.get(0).withShape(value));
            changed = physics.withParts(parts);
        }
        return new EntitySpec(
                name,
                body,
                value,
                position,
                rotation,
                scale,
                material,
                mass,
                velocity,
                angularVelocity,
                look,
                driven,
                changed);
    }

    /**
     * The same elsewhere.
     *
     * @param newPosition m
     * @param newRotation how it is turned
     * @return a copy
     */
    public EntitySpec at(Xyz newPosition, Turn newRotation) {
        return new EntitySpec(
                name,
                body,
                shape,
                newPosition,
                newRotation,
                scale,
                material,
                mass,
                velocity,
                angularVelocity,
                look,
                driven,
                physics);
    }

    /**
     * The same at another scale.
     *
     * @param value factors, &gt; 0
     * @return a copy
     */
    public EntitySpec withScale(Xyz value) {
        return new EntitySpec(
                name,
                body,
                shape,
                position,
                rotation,
                value,
                material,
                mass,
                velocity,
                angularVelocity,
                look,
                driven,
                physics);
    }

    /**
     * The same of another substance.
     *
     * @param newMaterial friction, restitution, density
     * @param newMass kg, or null for density times volume
     * @return a copy
     */
    public EntitySpec withMaterial(Material newMaterial, @Nullable Double newMass) {
        return new EntitySpec(
                name,
                body,
                shape,
                position,
                rotation,
                scale,
                newMaterial,
                newMass,
                velocity,
                angularVelocity,
                look,
                driven,
                physics);
    }

    /**
     * The same in another motion.
     *
     * @param linear of the centre of mass, m/s
     * @param angular rad/s
     * @return a copy
     */
    public EntitySpec moving(Xyz linear, Xyz angular) {
        return new EntitySpec(
                name, body, shape, position, rotation, scale, material, mass, linear, angular, look,
                driven, physics);
    }

    /**
     * The same with another look.
     *
     * @param value the look
     * @return a copy
     */
    public EntitySpec withLook(LookSpec value) {
        return new EntitySpec(
                name,
                body,
                shape,
                position,
                rotation,
                scale,
                material,
                mass,
                velocity,
                angularVelocity,
                value,
                driven,
                physics);
    }

    /**
     * The same, driven otherwise.
     *
     * @param value what the user does to it
     * @return a copy
     */
    public EntitySpec withDriven(Driven value) {
        return new EntitySpec(
                name,
                body,
                shape,
                position,
                rotation,
                scale,
                material,
                mass,
                velocity,
                angularVelocity,
                look,
                value,
                physics);
    }

    /**
     * The same with other features of its body.
     *
     * @param value what it has; if there are parts, the first one's shape becomes the entity's
     * @return a copy
     */
    public EntitySpec withPhysics(BodySpec value) {
        return new EntitySpec(
                name,
                body,
                value.parts().isEmpty() ? shape : value.parts().get(0).shape(),
                position,
                rotation,
                scale,
                material,
                mass,
                velocity,
                angularVelocity,
                look,
                driven,
                value);
    }
}
