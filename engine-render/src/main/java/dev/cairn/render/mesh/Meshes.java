package dev.cairn.render.mesh;

import dev.cairn.physics.shape.Shape;

/** Meshes made by arithmetic: the primitives, and one for each shape of the physics. */
public final class Meshes {
    private Meshes() {}

    /**
     * The surface of a collision shape, in the shape's frame.
     *
     * @param shape which one
     * @return its mesh
     */
    public static Mesh of(Shape shape) {
        throw new UnsupportedOperationException();
    }
}
