package dev.cairn.render.gl;

import static org.lwjgl.opengl.GL15.GL_ARRAY_BUFFER;
import static org.lwjgl.opengl.GL15.GL_ELEMENT_ARRAY_BUFFER;
import static org.lwjgl.opengl.GL15.GL_STATIC_DRAW;
import static org.lwjgl.opengl.GL15.glBindBuffer;
import static org.lwjgl.opengl.GL15.glBufferData;
import static org.lwjgl.opengl.GL30.glBindVertexArray;

import dev.cairn.render.mesh.Mesh;

/** A mesh in graphics memory. */
final class GpuMesh implements AutoCloseable {
    private final int vertexBuffer;
    private final int indexBuffer;
    private final int indexCount;

    GpuMesh(Mesh mesh) {
        // The index buffer's binding belongs to the bound vertex array, which must not be a batch's
        // here.
        glBindVertexArray(0);
        vertexBuffer = GlObjects.buffer();
        glBindBuffer(GL_ARRAY_BUFFER, vertexBuffer);
        glBufferData(GL_ARRAY_BUFFER, mesh.vertices(), GL_STATIC_DRAW);
        indexBuffer = GlObjects.buffer();
        int[] indices = mesh.indices();
        indexCount = indices.length;
        // Through the array target: without a vertex array a core profile refuses the element
        // target.
        glBindBuffer(GL_ARRAY_BUFFER, indexBuffer);
        glBufferData(GL_ARRAY_BUFFER, indices, GL_STATIC_DRAW);
        glBindBuffer(GL_ARRAY_BUFFER, 0);
    }

    int vertexBuffer() {
        return vertexBuffer;
    }

    int indexCount() {
        return indexCount;
    }

    /** Binds the indices to the vertex array that is bound. */
    void bindIndices() {
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indexBuffer);
    }

    @Override
    public void close() {
        GlObjects.deleteBuffer(vertexBuffer);
        GlObjects.deleteBuffer(indexBuffer);
    }
}
