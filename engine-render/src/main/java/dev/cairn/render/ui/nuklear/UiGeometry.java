package dev.cairn.render.ui.nuklear;

import static org.lwjgl.nuklear.Nuklear.*;
import static org.lwjgl.opengl.GL11.GL_FLOAT;
import static org.lwjgl.opengl.GL11.GL_UNSIGNED_BYTE;
import static org.lwjgl.opengl.GL11.glGetInteger;
import static org.lwjgl.opengl.GL15.GL_ARRAY_BUFFER;
import static org.lwjgl.opengl.GL15.GL_ARRAY_BUFFER_BINDING;
import static org.lwjgl.opengl.GL15.GL_ELEMENT_ARRAY_BUFFER;
import static org.lwjgl.opengl.GL15.GL_STREAM_DRAW;
import static org.lwjgl.opengl.GL15.glBindBuffer;
import static org.lwjgl.opengl.GL15.nglBufferData;
import static org.lwjgl.opengl.GL20.glEnableVertexAttribArray;
import static org.lwjgl.opengl.GL20.glVertexAttribPointer;
import static org.lwjgl.opengl.GL30.GL_VERTEX_ARRAY_BINDING;
import static org.lwjgl.opengl.GL30.glBindVertexArray;

import dev.cairn.render.gl.GlObjects;

import org.lwjgl.nuklear.NkBuffer;
import org.lwjgl.nuklear.NkContext;
import org.lwjgl.nuklear.NkConvertConfig;
import org.lwjgl.nuklear.NkDrawCommand;
import org.lwjgl.nuklear.NkDrawNullTexture;
import org.lwjgl.nuklear.NkDrawVertexLayoutElement;
import org.lwjgl.nuklear.NkHandle;
import org.lwjgl.nuklear.NkRect;
import org.lwjgl.system.MemoryUtil;

import java.nio.ByteBuffer;

/**
 * Triangles of the panels in graphics memory, and the batches that they are drawn in. What Nuklear
 * has collected is held against what it had collected the frame before; where that is the same, the
 * triangles are too, and nothing is made or sent. Buffers have fixed sizes (indices are 16 bits
 * wide); what does not fit is an error that says so.
 */
final class UiGeometry implements AutoCloseable {
    private static final int VERTEX_BYTES = 20;
    private static final int MOST_VERTICES = 65_536;
    private static final int MOST_INDEX_BYTES = 1 << 19;
    private static final int BATCH_BYTES = 1 << 17;

    /** Sizes in graphics memory are multiples of this, and never become smaller. */
    private static final int PAGE_BYTES = 1 << 14;

    private final int vertexArray = GlObjects.vertexArray();
    private final int vertexBuffer = GlObjects.buffer();
    private final int indexBuffer = GlObjects.buffer();
    private long vertexRoom;
    private long indexRoom;
    private final long vertexAddress = room((long) MOST_VERTICES * VERTEX_BYTES);
    private final long indexAddress = room(MOST_INDEX_BYTES);
    private final long batchAddress = MemoryUtil.nmemAlignedAllocChecked(64, BATCH_BYTES);
    private final NkBuffer vertices = NkBuffer.calloc();
    private final NkBuffer indices = NkBuffer.calloc();
    private final NkBuffer batches = NkBuffer.calloc();
    private final NkDrawVertexLayoutElement.Buffer layout = NkDrawVertexLayoutElement.calloc(4);
    private final NkConvertConfig config = NkConvertConfig.calloc();

    /** Commands of this frame, in Nuklear's own memory, and of the frame that was made last. */
    private final ByteBuffer commands;

    private final ByteBuffer made;

    /** Address of the first batch, as Nuklear keeps them; they lie one after another. */
    private final long[] batch = new long[BATCH_BYTES / NkDrawCommand.SIZEOF];

    private int batchCount;
    private long changes;

    /**
     * Makes buffers; with a current context.
     *
     * @param commands where Nuklear collects, read only
     * @param whiteTexel of the letters' texture
     */
    UiGeometry(ByteBuffer commands, NkDrawNullTexture whiteTexel) {
        this.commands = commands.duplicate();
        this.made = MemoryUtil.memAlloc(commands.capacity()).limit(0);
        layout.get(0).set(NK_VERTEX_POSITION, NK_FORMAT_FLOAT, 0);
        layout.get(1).set(NK_VERTEX_TEXCOORD, NK_FORMAT_FLOAT, 8);
        layout.get(2).set(NK_VERTEX_COLOR, NK_FORMAT_R8G8B8A8, 16);
        layout.get(3).set(NK_VERTEX_ATTRIBUTE_COUNT, NK_FORMAT_COUNT, 0);
        config.vertex_layout(layout)
                .vertex_size(VERTEX_BYTES)
                .vertex_alignment(4)
                .tex_null(whiteTexel)
                .circle_segment_count(22)
                .curve_segment_count(22)
                .arc_segment_count(22)
                .global_alpha(1)
                .shape_AA(NK_ANTI_ALIASING_ON)
                .line_AA(NK_ANTI_ALIASING_ON);
        int arrayBefore = glGetInteger(GL_VERTEX_ARRAY_BINDING);
        int bufferBefore = glGetInteger(GL_ARRAY_BUFFER_BINDING);
        glBindVertexArray(vertexArray);
        glBindBuffer(GL_ARRAY_BUFFER, vertexBuffer);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indexBuffer);
        glEnableVertexAttribArray(0);
        glVertexAttribPointer(0, 2, GL_FLOAT, false, VERTEX_BYTES, 0);
        glEnableVertexAttribArray(1);
        glVertexAttribPointer(1, 2, GL_FLOAT, false, VERTEX_BYTES, 8);
        glEnableVertexAttribArray(2);
        glVertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, true, VERTEX_BYTES, 16);
        glBindVertexArray(arrayBefore);
        glBindBuffer(GL_ARRAY_BUFFER, bufferBefore);
    }

    /** Up to the end of the last page, so that whole pages can be sent. */
    private static long room(long bytes) {
        return MemoryUtil.nmemCallocChecked(1, bytes + PAGE_BYTES);
    }

    /** How many frames so far were made into triangles, since they differed from the one before. */
    long changes() {
        return changes;
    }

    /** Binds the triangles for drawing. */
    void bind() {
        glBindVertexArray(vertexArray);
    }

    /**
     * Takes what was collected in this frame, after {@link #bind}; another buffer than before is
     * bound afterwards.
     */
    void update(NkContext context) {
        // Writes in which order the panels lie over each other into the commands.
        nnk__begin(context.address());
        int bytes =
                (int)
                        MemoryUtil.memGetAddress(
                                context.address() + NkContext.MEMORY + NkBuffer.ALLOCATED);
        commands.limit(bytes);
        if (commands.equals(made)) {
            return;
        }
        made.limit(bytes).put(0, commands, 0, bytes); // LWJGL's own copy makes garbage
        changes++;
        convert(context);
        glBindBuffer(GL_ARRAY_BUFFER, vertexBuffer);
        vertexRoom = send(GL_ARRAY_BUFFER, vertexRoom, vertices.allocated(), vertexAddress);
        indexRoom = send(GL_ELEMENT_ARRAY_BUFFER, indexRoom, indices.allocated(), indexAddress);
    }

    /**
     * Replaces what is in a buffer, all of it and by the same size where that is enough: drivers
     * have another piece of memory of that size at hand, and wait for no frame.
     */
    private static long send(int target, long room, long bytes, long address) {
        long size = Math.max(room, (bytes + PAGE_BYTES - 1) / PAGE_BYTES * PAGE_BYTES);
        nglBufferData(target, size, address, GL_STREAM_DRAW);
        return size;
    }

    private void convert(NkContext context) {
        // All by address: LWJGL's buffers and arrays are wrapped for each call.
        nnk_buffer_init_fixed(
                vertices.address(), vertexAddress, (long) MOST_VERTICES * VERTEX_BYTES);
        nnk_buffer_init_fixed(indices.address(), indexAddress, MOST_INDEX_BYTES);
        nnk_buffer_init_fixed(batches.address(), batchAddress, BATCH_BYTES);
        int result = nk_convert(context, batches, vertices, indices, config);
        if (result != NK_CONVERT_SUCCESS) {
            made.limit(0);
            throw new IllegalStateException(
                    "the panels need more than "
                            + MOST_VERTICES
                            + " vertices (Nuklear's code "
                            + result
                            + "); draw fewer widgets or shorter plots");
        }
        batchCount = 0;
        for (long command = nnk__draw_begin(context.address(), batches.address());
                command != MemoryUtil.NULL;
                command = nnk__draw_next(command, batches.address(), context.address())) {
            if (NkDrawCommand.nelem_count(command) > 0) {
                batch[batchCount++] = command;
            }
        }
    }

    int batches() {
        return batchCount;
    }

    /** How many indices a batch has, two bytes each, after those of the batches before. */
    int count(int index) {
        return NkDrawCommand.nelem_count(batch[index]);
    }

    int texture(int index) {
        return MemoryUtil.memGetInt(batch[index] + NkDrawCommand.TEXTURE + NkHandle.ID);
    }

    float clipLeft(int index) {
        return MemoryUtil.memGetFloat(batch[index] + NkDrawCommand.CLIP_RECT + NkRect.X);
    }

    float clipTop(int index) {
        return MemoryUtil.memGetFloat(batch[index] + NkDrawCommand.CLIP_RECT + NkRect.Y);
    }

    float clipWidth(int index) {
        return MemoryUtil.memGetFloat(batch[index] + NkDrawCommand.CLIP_RECT + NkRect.W);
    }

    float clipHeight(int index) {
        return MemoryUtil.memGetFloat(batch[index] + NkDrawCommand.CLIP_RECT + NkRect.H);
    }

    @Override
    public void close() {
        GlObjects.deleteVertexArray(vertexArray);
        GlObjects.deleteBuffer(vertexBuffer);
        GlObjects.deleteBuffer(indexBuffer);
        MemoryUtil.memFree(made);
        MemoryUtil.nmemFree(vertexAddress);
        MemoryUtil.nmemFree(indexAddress);
        MemoryUtil.nmemAlignedFree(batchAddress);
        vertices.free();
        indices.free();
        batches.free();
        layout.free();
        config.free();
    }
}
