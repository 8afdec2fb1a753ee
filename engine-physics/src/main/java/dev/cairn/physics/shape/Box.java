package dev.cairn.physics.shape;

import dev.cairn.physics.shape.polyhedron.Polyhedral;
import dev.cairn.physics.shape.polyhedron.Polyhedron;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * A rectangular block around the origin of the shape frame. Its factories say in their names what
 * they take: {@link #ofHalfExtents half extents}, from the centre to a face, as the rest of the
 * engine uses them, or whole {@link #ofEdges edges}, from face to face, as a tape measures them.
 */
public final class Box extends Polyhedral implements Shape {
    /** Half extents, m. */
    private final double halfX, halfY, halfZ;

    private Box(double halfX, double halfY, double halfZ) {
        super(Polyhedron.box(halfX, halfY, halfZ));
        this.halfX = halfX;
        this.halfY = halfY;
        this.halfZ = halfZ;
    }

    /**
     * A block of {@code 2 halfX} by {@code 2 halfY} by {@code 2 halfZ}.
     *
     * @param halfX half the width, m, in [1e-50, 1e50]
     * @param halfY half the height, m
     * @param halfZ half the depth, m
     * @return the shape
     * @throws DegenerateShapeException if a half extent is NaN, infinite or out of range
     */
    public static Box ofHalfExtents(double halfX, double halfY, double halfZ) {
        Checks.length("Box halfX", halfX);
        Checks.length("Box halfY", halfY);
        Checks.length("Box halfZ", halfZ);
        return new Box(halfX, halfY, halfZ);
    }

    /**
     * A block of twice the half extents.
     *
     * @param half half the width, height and depth, m, each in [1e-50, 1e50]
     * @return the shape
     */
    public static Box ofHalfExtents(Vector3dc half) {
        return ofHalfExtents(half.x(), half.y(), half.z());
    }

    /**
     * A block of {@code edgeX} by {@code edgeY} by {@code edgeZ}.
     *
     * @param edgeX the whole width, m, in [2e-50, 2e50]
     * @param edgeY the whole height, m
     * @param edgeZ the whole depth, m
     * @return the shape, equal to the one of half of these as half extents
     * @throws DegenerateShapeException if an edge is NaN, infinite or out of range
     */
    public static Box ofEdges(double edgeX, double edgeY, double edgeZ) {
        return ofHalfExtents(edgeX / 2, edgeY / 2, edgeZ / 2);
    }

    /**
     * A block of the edges.
     *
     * @param edges the whole width, height and depth, m, each in [2e-50, 2e50]
     * @return the shape
     */
    public static Box ofEdges(Vector3dc edges) {
        return ofEdges(edges.x(), edges.y(), edges.z());
    }

    /**
     * A cube of edge {@code 2 half}.
     *
     * @param half half the edge, m, in [1e-50, 1e50]
     * @return the shape
     * @throws DegenerateShapeException if the half extent is NaN, infinite or out of range
     */
    public static Box cubeOfHalfExtent(double half) {
        return ofHalfExtents(half, half, half);
    }

    /**
     * A cube of the given edge.
     *
     * @param edge the whole edge, m, in [2e-50, 2e50]
     * @return the shape
     * @throws DegenerateShapeException if the edge is NaN, infinite or out of range
     */
    public static Box cubeOfEdge(double edge) {
        return ofEdges(edge, edge, edge);
    }

    /**
     * Half the width.
     *
     * @return m
     */
    public double halfX() {
        return halfX;
    }

    /**
     * Half the height.
     *
     * @return m
     */
    public double halfY() {
        return halfY;
    }

    /**
     * Half the depth.
     *
     * @return m
     */
    public double halfZ() {
        return halfZ;
    }

    @Override
    public double volume() {
        return 8 * (halfX * halfY * halfZ);
    }

    @Override
    public MassProperties massProperties(double density) {
        Checks.density(density);
        double mass = density * volume();
        double third = mass / 3;
        double xx = halfX * halfX;
        double yy = halfY * halfY;
        double zz = halfZ * halfZ;
        return new MassProperties(
                mass, 0, 0, 0, third * (yy + zz), third * (xx + zz), third * (xx + yy), 0, 0, 0);
    }

    @Override
    public double innerRadius() {
        return Math.min(halfX, Math.min(halfY, halfZ));
    }

    @Override
    public double outerRadius() {
        return Polyhedron.of(this).outerRadius();
    }

    @Override
    public Vector3d centreOfMass(Vector3d dest) {
        return dest.zero();
    }

    @Override
    public void bounds(double qx, double qy, double qz, double qw, double[] dest, int offset) {
        double rx =
                Math.abs(1 - 2 * (qy * qy + qz * qz)) * halfX
                        + Math.abs(2 * (qx * qy - qz * qw)) * halfY
                        + Math.abs(2 * (qx * qz + qy * qw)) * halfZ;
        double ry =
                Math.abs(2 * (qx * qy + qz * qw)) * halfX
                        + Math.abs(1 - 2 * (qx * qx + qz * qz)) * halfY
                        + Math.abs(2 * (qy * qz - qx * qw)) * halfZ;
        double rz =
                Math.abs(2 * (qx * qz - qy * qw)) * halfX
                        + Math.abs(2 * (qy * qz + qx * qw)) * halfY
                        + Math.abs(1 - 2 * (qx * qx + qy * qy)) * halfZ;
        dest[offset] = -rx;
        dest[offset + 1] = -ry;
        dest[offset + 2] = -rz;
        dest[offset + 3] = rx;
        dest[offset + 4] = ry;
        dest[offset + 5] = rz;
    }

    @Override
    public String toString() {
        return "Box[halfX=" + halfX + ", halfY=" + halfY + ", halfZ=" + halfZ + "]";
    }
}
