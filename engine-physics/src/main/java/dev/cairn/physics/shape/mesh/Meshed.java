package dev.cairn.physics.shape.mesh;

/**
 * A shape that is a surface of triangles. The narrow phase reads them with {@link TriangleSet#of};
 * they are no part of what a user of the shape sees.
 */
public abstract class Meshed {
    /** In the shape's frame, whose origin is what bodies are placed by. */
    final TriangleSet triangles;

    /** Of these triangles. */
    protected Meshed(TriangleSet triangles) {
        this.triangles = triangles;
    }
}
