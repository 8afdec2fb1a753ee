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

    /** A mesh of the triangles that bear a number, and of the vertices that these use. */
    Mesh part(String name, int[] numberOfTriangle, int number) {
        MeshBuilder part = new MeshBuilder();
        int[] renamed = new int[vertexCount];
        Arrays.fill(renamed, -1);
        int[] corner = new int[3];
        for (int t = 0; t < triangleCount(); t++) {
            if (numberOfTriangle[t] != number) {
                continue;
            }
            for (int k = 0; k < 3; k++) {
                int v = indices[3 * t + k];
                if (renamed[v] < 0) {
                    renamed[v] = part.copy(vertices, v * Mesh.FLOATS_PER_VERTEX);
                }
                corner[k] = renamed[v];
            }
            part.triangle(corner[0], corner[1], corner[2]);
        }
        return part.build(name, null);
    }

    private int copy(float[] from, int at) {
        return vertex(
                from[at],
                from[at + 1],
                from[at + 2],
                from[at + 3],
                from[at + 4],
                from[at + 5],
                from[at + 6],
                from[at + 7]);
    }

    private static int grown(int length) {
        return Math.addExact(length, length);
    }
}
