package dev.cairn.physics.shape.decomposition;

import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.MassProperties;
import dev.cairn.physics.shape.TriangleMesh;

import java.util.List;

/**
 * Convex parts that are, together, nearly a mesh: the colliders of one body. Immutable.
 *
 * <p>The parts are in the mesh's frame, so each is a collider at the body's origin.
 */
public final class Decomposition {
    private final TriangleMesh mesh;
    private final List<ConvexHull> parts;
    private final double beyond;
    private final double beyondAtMost;
    private final double missing;
    private final double allowed;

    /** A part, how far it goes beyond the solid, no farther than what, and how far it is short. */
    record Measured(ConvexHull hull, double beyond, double beyondAtMost, double missing) {}

    Decomposition(TriangleMesh mesh, List<Measured> parts, double allowed) {
        this.mesh = mesh;
        this.parts = parts.stream().map(Measured::hull).toList();
        this.beyond = parts.stream().mapToDouble(Measured::beyond).max().orElse(0);
        this.beyondAtMost = parts.stream().mapToDouble(Measured::beyondAtMost).max().orElse(0);
        this.missing = parts.stream().mapToDouble(Measured::missing).max().orElse(0);
        this.allowed = allowed;
    }

    /**
     * The parts, in the mesh's frame.
     *
     * @return an immutable list
     */
    public List<ConvexHull> parts() {
        return parts;
    }

    /**
     * How far parts go beyond the mesh: the largest distance from the mesh's solid that a point of
     * a part was found to have.
     *
     * @return m; the true maximum is between this and {@link #beyondAtMost}
     */
    public double beyond() {
        return beyond;
    }

    /**
     * An upper bound of the same: no point of a part is farther from the mesh's solid.
     *
     * @return m, at least {@link #beyond}
     */
    public double beyondAtMost() {
        return beyondAtMost;
    }

    /**
     * How far the mesh goes beyond the parts: the largest distance of a point of the mesh from the
     * part that it belongs to.
     *
     * @return m
     */
    public double missing() {
        return missing;
    }

    /**
     * The error that was allowed.
     *
     * @return m
     */
    public double allowed() {
        return allowed;
    }

    /**
     * Whether no point of a part is farther from the mesh than was allowed.
     *
     * @return false if there would have to be more parts
     */
    public boolean isWithinAllowed() {
        return beyondAtMost <= allowed;
    }

    /**
     * The sum of the parts' volumes; where parts overlap it counts for each.
     *
     * @return m³
     */
    public double volume() {
        return parts.stream().mapToDouble(ConvexHull::volume).sum();
    }

    /**
     * Mass, centre and inertia of the mesh's solid, exactly, whatever the parts add to it: for
     * {@code Body.massProperties}.
     *
     * @param density kg/m³, positive and finite
     * @return in the mesh's frame
     * @throws IllegalArgumentException if the mesh is not closed, see {@link
     *     TriangleMesh#solidProperties}
     */
    public MassProperties massProperties(double density) {
        return mesh.solidProperties(density);
    }

    @Override
    public String toString() {
        return "Decomposition[parts="
                + parts.size()
                + ", beyond="
                + beyond
                + " m, missing="
                + missing
                + " m]";
    }
}
