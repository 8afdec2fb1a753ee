package dev.cairn.render.mesh;

import org.jspecify.annotations.Nullable;

import java.util.Objects;

/**
 * Triangles to draw: vertices with position, normal and texture coordinate, and an index list, in
 * the frame of the model that uses them (metres, right-handed, counter-clockwise seen from
 * outside). Immutable and free of OpenGL, so it can be made on any thread and read without a
 * display; the renderer uploads it when it first draws it.
 */
public final class Mesh {
    /** Floats per vertex of {@link #vertices()}: position x y z, normal x y z, texture u v. */
    public static final int FLOATS_PER_VERTEX = 8;

    private final String name;
    private final float[] vertices;
    private final int[] indices;
    private final double[] points;
    private final double radius;

    private Mesh(String name, float[] vertices, int[] indices, double[] points) {
        this.name = name;
        this.vertices = vertices;
        this.indices = indices;
        this.points = points;
        double square = 0;
        for (int i = 0; i < vertices.length; i += FLOATS_PER_VERTEX) {
            double x = vertices[i];
            double y = vertices[i + 1];
            double z = vertices[i + 2];
            square = Math.max(square, x * x + y * y + z * z);
        }
        this.radius = Math.sqrt(square);
    }

    /**
     * A mesh from interleaved vertices.
     *
     * @param name what it is called in messages
     * @param vertices {@value #FLOATS_PER_VERTEX} floats per vertex: position, unit normal, texture
     *     coordinate (v upwards); copied
     * @param indices three per triangle, counter-clockwise seen from outside; copied
     * @return the mesh; its {@link #points()} are the positions of all vertices
     * @throws IllegalArgumentException if a length does not divide, a number is not finite, or an
     *     index is out of range
     */
    public static Mesh of(String name, float[] vertices, int[] indices) {
        return of(name, vertices, indices, null);
    }

    static Mesh of(String name, float[] vertices, int[] indices, double @Nullable [] points) {
        Objects.requireNonNull(name, "name");
        if (vertices.length % FLOATS_PER_VERTEX != 0) {
            throw new IllegalArgumentException(
                    "mesh '"
                            + name
                            + "': vertices.length is "
                            + vertices.length
                            + ", expected a multiple of "
                            + FLOATS_PER_VERTEX);
        }
        if (indices.length % 3 != 0) {
            throw new IllegalArgumentException(
                    "mesh '"
                            + name
                            + "': indices.length is "
                            + indices.length
                            + ", expected three per triangle");
        }
        for (int i = 0; i < vertices.length; i++) {
            if (!Float.isFinite(vertices[i])) {
                throw new IllegalArgumentException(
                        "mesh '"
                                + name
                                + "': vertices["
                                + i
                                + "] is "
                                + vertices[i]
                                + ", expected a finite number");
            }
        }
        int count = vertices.length / FLOATS_PER_VERTEX;
        for (int i = 0; i < indices.length; i++) {
            if (indices[i] < 0 || indices[i] >= count) {
                throw new IllegalArgumentException(
                        "mesh '"
                                + name
                                + "': indices["
                                + i
                                + "] is "
                                + indices[i]
                                + ", expected 0.."
                                + (count - 1));
            }
        }
        double[] kept = points != null ? points.clone() : positions(vertices);
        return new Mesh(name, vertices.clone(), indices.clone(), kept);
    }

    private static double[] positions(float[] vertices) {
        double[] result = new double[vertices.length / FLOATS_PER_VERTEX * 3];
        for (int v = 0, i = 0; i < result.length; v += FLOATS_PER_VERTEX, i += 3) {
            result[i] = vertices[v];
            result[i + 1] = vertices[v + 1];
            result[i + 2] = vertices[v + 2];
        }
        return result;
    }

    /**
     * What the mesh is called in messages.
     *
     * @return the name, for a file its path
     */
    public String name() {
        return name;
    }

    /**
     * How many vertices there are; corners with different normals or texture coordinates count
     * apart.
     *
     * @return the count
     */
    public int vertexCount() {
        return vertices.length / FLOATS_PER_VERTEX;
    }

    /**
     * How many triangles there are.
     *
     * @return the count
     */
    public int triangleCount() {
        return indices.length / 3;
    }

    /**
     * The interleaved vertices, {@value #FLOATS_PER_VERTEX} floats each.
     *
     * @return a copy
     */
    public float[] vertices() {
        return vertices.clone();
    }

    /**
     * The vertex numbers of the triangles, three each, counter-clockwise seen from outside.
     *
     * @return a copy
     */
    public int[] indices() {
        return indices.clone();
    }

    /**
     * The points that the mesh was made from, three coordinates each, in double: for a file its
     * {@code v} lines in order. This is what a convex hull is built from.
     *
     * @return a copy
     */
    public double[] points() {
        return points.clone();
    }

    /**
     * The greatest distance of a vertex from the origin of the mesh's frame.
     *
     * @return metres, 0 for an empty mesh
     */
    public double radius() {
        return radius;
    }

    /**
     * The same mesh with all texture coordinates multiplied, to repeat a texture.
     *
     * @param u factor along u, finite
     * @param v factor along v, finite
     * @return a new mesh
     */
    public Mesh repeatTexture(double u, double v) {
        float[] copy = vertices.clone();
        for (int i = 0; i < copy.length; i += FLOATS_PER_VERTEX) {
            copy[i + 6] = (float) (copy[i + 6] * u);
            copy[i + 7] = (float) (copy[i + 7] * v);
        }
        return of(name, copy, indices, points);
    }

    @Override
    public String toString() {
        return "Mesh["
                + name
                + ", "
                + vertexCount()
                + " vertices, "
                + triangleCount()
                + " triangles]";
    }
}
