package dev.cairn.physics.shape.polyhedron;

/**
 * A shape with faces, edges and vertices. The narrow phase reads them with {@link Polyhedron#of};
 * they are no part of what a user of the shape sees.
 */
public abstract class Polyhedral {
    /** Relative to the centre of mass. */
    final Polyhedron polyhedron;

    protected Polyhedral(Polyhedron polyhedron) {
        this.polyhedron = polyhedron;
    }
}
