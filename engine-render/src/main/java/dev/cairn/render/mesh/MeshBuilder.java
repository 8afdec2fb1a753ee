package dev.cairn.render.mesh;

import org.jspecify.annotations.Nullable;

import java.util.Arrays;

/** Collects vertices and triangles. One thread. */
final class MeshBuilder {
    private float[] vertices = new float[64 * Mesh.FLOATS_PER_VERTEX];
    private int[] indices = new int[128];
    private int vertexCount;
    private int indexCount;

    /** Adds a vertex and returns its number. */
    int vertex(double x, double y, double z, double nx, double ny, double nz, double u, double v) {
        int at = vertexCount * Mesh.FLOATS_PER_VERTEX;
        if (at == vertices.length) {
            vertices = Arrays.copyOf(vertices, grown(at));
        }
        vertices[at] = (float) x;
        vertices[at + 1] = (float) y;
        vertices[at + 2] = (float) z;
        vertices[at + 3] = (float) nx;
        vertices[at + 4] = (float) ny;
        vertices[at + 5] = (float) nz;
        vertices[at + 6] = (float) u;
        vertices[at + 7] = (float) v;
        return vertexCount++;
    }

    void triangle(int a, int b, int c) {
        if (indexCount + 3 > indices.length) {
            indices = Arrays.copyOf(indices, grown(indices.length));
        }
        indices[indexCount] = a;
        indices[indexCount + 1] = b;
        indices[indexCount + 2] = c;
        indexCount += 3;
    }

    int vertexCount() {
        return vertexCount;
    }

    int triangleCount() {
        return indexCount / 3;
    }

    Mesh build(String name, double @Nullable [] points) {
        return Mesh.of(
                name,
                Arrays.copyOf(vertices, vertexCount * Mesh.FLOATS_PER_VERTEX),
                Arrays.copyOf(indices, indexCount),
                points);
    }

    private static int grown(int length) {
        return Math.addExact(length, length);
    }
}
