package dev.cairn.render.gl;

import static org.lwjgl.opengl.GL11.GL_FLOAT;
import static org.lwjgl.opengl.GL11.GL_TRIANGLES;
import static org.lwjgl.opengl.GL11.GL_UNSIGNED_INT;
import static org.lwjgl.opengl.GL15.GL_ARRAY_BUFFER;
import static org.lwjgl.opengl.GL15.GL_STREAM_DRAW;
import static org.lwjgl.opengl.GL15.glBindBuffer;
import static org.lwjgl.opengl.GL15.nglBufferData;
import static org.lwjgl.opengl.GL20.glEnableVertexAttribArray;
import static org.lwjgl.opengl.GL20.glVertexAttribPointer;
import static org.lwjgl.opengl.GL30.glBindVertexArray;
import static org.lwjgl.opengl.GL30.glVertexAttribIPointer;
import static org.lwjgl.opengl.GL31.glDrawElementsInstanced;
import static org.lwjgl.opengl.GL33.glVertexAttribDivisor;

import dev.cairn.render.mesh.Mesh;

import org.joml.Matrix4d;
import org.lwjgl.system.MemoryUtil;

import java.nio.IntBuffer;

/**
 * What one pass over the scene draws: per batch, the slots whose bounding spheres touch the pass's
 * frustum, in ascending order. The list is made anew when the frustum or the poses have changed; it
 * is all that is uploaded for a new view of the same tick, four bytes for each visible instance.
 */
final class Pass implements AutoCloseable {
    private static final int SLOT_ATTRIBUTE = 3;

    private final Instances instances;
    private final boolean openNear;
    private final int slotBuffer = GlObjects.buffer();
    private final Frustum frustum = new Frustum();
    private final Matrix4d culledFor = new Matrix4d().zero();
    private int culledUpload = -1;
    private int arrangement = -1;
    private int[] vertexArrays = new int[0];
    private int[] visible = new int[0];
    private int drawn;
    private IntBuffer staging = MemoryUtil.memAllocInt(64);

    /** By address, since LWJGL wraps the buffer for each upload. */
    private long stagingAddress = MemoryUtil.memAddress(staging);

    /**
     * A pass that draws nothing yet.
     *
     * @param instances what there is
     * @param openNear see {@link Frustum#set}
     */
    Pass(Instances instances, boolean openNear) {
        this.instances = instances;
        this.openNear = openNear;
    }

    /**
     * Chooses what is drawn.
     *
     * @param clipFromAnchored the pass's projection
     */
    void cull(Matrix4d clipFromAnchored) {
        if (arrangement != instances.arrangements()) {
            arrange();
        } else if (culledUpload == instances.uploads() && culledFor.equals(clipFromAnchored)) {
            return;
        }
        frustum.set(clipFromAnchored, openNear);
        drawn = 0;
        for (int b = 0; b < visible.length; b++) {
            Instances.Batch batch = instances.batch(b);
            visible[b] = instances.visible(frustum, batch.first, batch.count, staging);
            drawn += visible[b];
        }
        glBindBuffer(GL_ARRAY_BUFFER, slotBuffer);
        nglBufferData(GL_ARRAY_BUFFER, 4L * instances.slots(), stagingAddress, GL_STREAM_DRAW);
        culledUpload = instances.uploads();
        culledFor.set(clipFromAnchored);
    }

    private void arrange() {
        deleteVertexArrays();
        int batches = instances.batchCount();
        visible = new int[batches];
        vertexArrays = new int[batches];
        if (staging.capacity() < instances.slots()) {
            MemoryUtil.memFree(staging);
            staging = MemoryUtil.memAllocInt(Math.max(instances.slots(), 2 * staging.capacity()));
            stagingAddress = MemoryUtil.memAddress(staging);
        }
        for (int b = 0; b < batches; b++) {
            Instances.Batch batch = instances.batch(b);
            GpuMesh mesh = batch.gpuMesh;
            if (mesh == null) {
                throw new IllegalStateException("a batch without its mesh");
            }
            vertexArrays[b] = GlObjects.vertexArray();
            glBindVertexArray(vertexArrays[b]);
            glBindBuffer(GL_ARRAY_BUFFER, mesh.vertexBuffer());
            attribute(0, 3, 0);
            attribute(1, 3, 3);
            attribute(2, 2, 6);
            glBindBuffer(GL_ARRAY_BUFFER, slotBuffer);
            glEnableVertexAttribArray(SLOT_ATTRIBUTE);
            glVertexAttribIPointer(
                    SLOT_ATTRIBUTE, 1, GL_UNSIGNED_INT, 0, batch.first * (long) Integer.BYTES);
            glVertexAttribDivisor(SLOT_ATTRIBUTE, 1);
            mesh.bindIndices();
        }
        glBindVertexArray(0);
        arrangement = instances.arrangements();
    }

    private static void attribute(int index, int size, int offsetFloats) {
        glEnableVertexAttribArray(index);
        glVertexAttribPointer(
                index,
                size,
                GL_FLOAT,
                false,
                Mesh.FLOATS_PER_VERTEX * Float.BYTES,
                offsetFloats * (long) Float.BYTES);
    }

    /**
     * Draws the visible instances of a batch.
     *
     * @param b the batch's number
     */
    void draw(int b) {
        GpuMesh mesh = instances.batch(b).gpuMesh;
        if (mesh != null && visible[b] > 0) {
            glBindVertexArray(vertexArrays[b]);
            glDrawElementsInstanced(
                    GL_TRIANGLES, mesh.indexCount(), GL_UNSIGNED_INT, 0, visible[b]);
        }
    }

    /** How many batches there are. */
    int batches() {
        return visible.length;
    }

    /** Whether anything of a batch is drawn. */
    boolean isVisible(int b) {
        return visible[b] > 0;
    }

    /** Whether nothing is seen through a batch. */
    boolean isSolid(int b) {
        return instances.batch(b).texture.opacity() == 1;
    }

    /** How many instances the pass draws. */
    int drawn() {
        return drawn;
    }

    private void deleteVertexArrays() {
        for (int id : vertexArrays) {
            GlObjects.deleteVertexArray(id);
        }
    }

    @Override
    public void close() {
        deleteVertexArrays();
        GlObjects.deleteBuffer(slotBuffer);
        MemoryUtil.memFree(staging);
    }
}
