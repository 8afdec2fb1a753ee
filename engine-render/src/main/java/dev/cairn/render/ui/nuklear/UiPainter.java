package dev.cairn.render.ui.nuklear;

import static org.lwjgl.nuklear.Nuklear.*;
import static org.lwjgl.opengl.GL11.*;
import static org.lwjgl.opengl.GL13.GL_ACTIVE_TEXTURE;
import static org.lwjgl.opengl.GL13.GL_TEXTURE0;
import static org.lwjgl.opengl.GL13.glActiveTexture;
import static org.lwjgl.opengl.GL14.GL_BLEND_DST_ALPHA;
import static org.lwjgl.opengl.GL14.GL_BLEND_DST_RGB;
import static org.lwjgl.opengl.GL14.GL_BLEND_SRC_ALPHA;
import static org.lwjgl.opengl.GL14.GL_BLEND_SRC_RGB;
import static org.lwjgl.opengl.GL14.glBlendFuncSeparate;
import static org.lwjgl.opengl.GL15.GL_ARRAY_BUFFER;
import static org.lwjgl.opengl.GL15.GL_ARRAY_BUFFER_BINDING;
import static org.lwjgl.opengl.GL15.GL_ELEMENT_ARRAY_BUFFER;
import static org.lwjgl.opengl.GL15.GL_STREAM_DRAW;
import static org.lwjgl.opengl.GL15.glBindBuffer;
import static org.lwjgl.opengl.GL15.glBufferData;
import static org.lwjgl.opengl.GL15.nglBufferSubData;
import static org.lwjgl.opengl.GL20.GL_CURRENT_PROGRAM;
import static org.lwjgl.opengl.GL20.glEnableVertexAttribArray;
import static org.lwjgl.opengl.GL20.glUseProgram;
import static org.lwjgl.opengl.GL20.glVertexAttribPointer;
import static org.lwjgl.opengl.GL30.GL_VERTEX_ARRAY_BINDING;
import static org.lwjgl.opengl.GL30.glBindVertexArray;

import dev.cairn.render.gl.GlObjects;
import dev.cairn.render.gl.ShaderProgram;

import org.lwjgl.nuklear.NkBuffer;
import org.lwjgl.nuklear.NkContext;
import org.lwjgl.nuklear.NkConvertConfig;
import org.lwjgl.nuklear.NkDrawCommand;
import org.lwjgl.nuklear.NkDrawVertexLayoutElement;
import org.lwjgl.nuklear.NkHandle;
import org.lwjgl.nuklear.NkRect;
import org.lwjgl.system.MemoryUtil;

/**
 * Draws what Nuklear has collected, by one shader and as many scissored calls as it has batches.
 * Buffers have fixed sizes (indices are 16 bits wide); what does not fit is an error that says so.
 * All state that it changes is put back, so that whoever draws next need not know.
 */
final class UiPainter implements AutoCloseable {
    private static final int VERTEX_BYTES = 20;
    private static final int MOST_VERTICES = 65_536;
    private static final int MOST_INDEX_BYTES = 1 << 19;
    private static final int COMMAND_BYTES = 1 << 17;

    private final ShaderProgram program =
            new ShaderProgram("ui", "", new String[] {"ui.vert"}, new String[] {"ui.frag"});
    private final int scaleUniform = program.uniform("clipPerPixel");
    private final int textureUniform = program.uniform("letters");
    private final int vertexArray = GlObjects.vertexArray();
    private final int vertexBuffer = GlObjects.buffer();
    private final int indexBuffer = GlObjects.buffer();
    private final long vertexAddress =
            MemoryUtil.nmemAllocChecked((long) MOST_VERTICES * VERTEX_BYTES);
    private final long indexAddress = MemoryUtil.nmemAllocChecked(MOST_INDEX_BYTES);
    private final long commandAddress = MemoryUtil.nmemAlignedAllocChecked(64, COMMAND_BYTES);
    private final NkBuffer vertices = NkBuffer.calloc();
    private final NkBuffer indices = NkBuffer.calloc();
    private final NkBuffer commands = NkBuffer.calloc();
    private final NkDrawVertexLayoutElement.Buffer layout = NkDrawVertexLayoutElement.calloc(4);
    private final NkConvertConfig config = NkConvertConfig.calloc();
    private final long fourInts = MemoryUtil.nmemAllocChecked(16);

    UiPainter(UiFont font) {
        layout.get(0).set(NK_VERTEX_POSITION, NK_FORMAT_FLOAT, 0);
        layout.get(1).set(NK_VERTEX_TEXCOORD, NK_FORMAT_FLOAT, 8);
        layout.get(2).set(NK_VERTEX_COLOR, NK_FORMAT_R8G8B8A8, 16);
        layout.get(3).set(NK_VERTEX_ATTRIBUTE_COUNT, NK_FORMAT_COUNT, 0);
        config.vertex_layout(layout)
                .vertex_size(VERTEX_BYTES)
                .vertex_alignment(4)
                .tex_null(font.whiteTexel())
                .circle_segment_count(22)
                .curve_segment_count(22)
                .arc_segment_count(22)
                .global_alpha(1)
                .shape_AA(NK_ANTI_ALIASING_ON)
                .line_AA(NK_ANTI_ALIASING_ON);
        int before = glGetInteger(GL_VERTEX_ARRAY_BINDING);
        glBindVertexArray(vertexArray);
        glBindBuffer(GL_ARRAY_BUFFER, vertexBuffer);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indexBuffer);
        glEnableVertexAttribArray(0);
        glVertexAttribPointer(0, 2, GL_FLOAT, false, VERTEX_BYTES, 0);
        glEnableVertexAttribArray(1);
        glVertexAttribPointer(1, 2, GL_FLOAT, false, VERTEX_BYTES, 8);
        glEnableVertexAttribArray(2);
        glVertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, true, VERTEX_BYTES, 16);
        glBindVertexArray(before);
    }

    /** Draws into the bound framebuffer of the given size, pixels. */
    void draw(NkContext context, int width, int height) {
        // All by address: LWJGL's buffers and arrays are wrapped for each call.
        nnk_buffer_init_fixed(
                vertices.address(), vertexAddress, (long) MOST_VERTICES * VERTEX_BYTES);
        nnk_buffer_init_fixed(indices.address(), indexAddress, MOST_INDEX_BYTES);
        nnk_buffer_init_fixed(commands.address(), commandAddress, COMMAND_BYTES);
        int result = nk_convert(context, commands, vertices, indices, config);
        if (result != NK_CONVERT_SUCCESS) {
            throw new IllegalStateException(
                    "the panels need more than "
                            + MOST_VERTICES
                            + " vertices (Nuklear's code "
                            + result
                            + "); draw fewer widgets or shorter plots");
        }
        boolean depth = glIsEnabled(GL_DEPTH_TEST);
        boolean cull = glIsEnabled(GL_CULL_FACE);
        boolean blend = glIsEnabled(GL_BLEND);
        boolean scissor = glIsEnabled(GL_SCISSOR_TEST);
        int sourceRgb = integer(GL_BLEND_SRC_RGB);
        int targetRgb = integer(GL_BLEND_DST_RGB);
        int sourceAlpha = integer(GL_BLEND_SRC_ALPHA);
        int targetAlpha = integer(GL_BLEND_DST_ALPHA);
        int activeTexture = integer(GL_ACTIVE_TEXTURE);
        int usedProgram = integer(GL_CURRENT_PROGRAM);
        int usedArray = integer(GL_VERTEX_ARRAY_BINDING);
        int usedBuffer = integer(GL_ARRAY_BUFFER_BINDING);
        glActiveTexture(GL_TEXTURE0);
        int usedTexture = integer(GL_TEXTURE_BINDING_2D);
        nglGetIntegerv(GL_SCISSOR_BOX, fourInts);
        int clipX = MemoryUtil.memGetInt(fourInts);
        int clipY = MemoryUtil.memGetInt(fourInts + 4);
        int clipWidth = MemoryUtil.memGetInt(fourInts + 8);
        int clipHeight = MemoryUtil.memGetInt(fourInts + 12);
        nglGetIntegerv(GL_VIEWPORT, fourInts);

        glEnable(GL_BLEND);
        glEnable(GL_SCISSOR_TEST);
        glDisable(GL_DEPTH_TEST);
        glDisable(GL_CULL_FACE);
        glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
        glViewport(0, 0, width, height);
        program.use();
        ShaderProgram.set(scaleUniform, 2.0 / width, -2.0 / height, 0);
        ShaderProgram.set(textureUniform, 0);
        glBindVertexArray(vertexArray);
        upload();
        drawCommands(context, width, height);

        enable(GL_DEPTH_TEST, depth);
        enable(GL_CULL_FACE, cull);
        enable(GL_BLEND, blend);
        enable(GL_SCISSOR_TEST, scissor);
        glBlendFuncSeparate(sourceRgb, targetRgb, sourceAlpha, targetAlpha);
        glBindTexture(GL_TEXTURE_2D, usedTexture);
        glActiveTexture(activeTexture);
        glUseProgram(usedProgram);
        glBindVertexArray(usedArray);
        glBindBuffer(GL_ARRAY_BUFFER, usedBuffer);
        glScissor(clipX, clipY, clipWidth, clipHeight);
        glViewport(
                MemoryUtil.memGetInt(fourInts),
                MemoryUtil.memGetInt(fourInts + 4),
                MemoryUtil.memGetInt(fourInts + 8),
                MemoryUtil.memGetInt(fourInts + 12));
    }

    /** A whole new store each time, so that the driver need not wait for the last frame. */
    private void upload() {
        long vertexBytes = vertices.allocated();
        long indexBytes = indices.allocated();
        glBindBuffer(GL_ARRAY_BUFFER, vertexBuffer);
        glBufferData(GL_ARRAY_BUFFER, Math.max(vertexBytes, 1), GL_STREAM_DRAW);
        nglBufferSubData(GL_ARRAY_BUFFER, 0, vertexBytes, vertexAddress);
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, Math.max(indexBytes, 1), GL_STREAM_DRAW);
        nglBufferSubData(GL_ELEMENT_ARRAY_BUFFER, 0, indexBytes, indexAddress);
    }

    private void drawCommands(NkContext context, int width, int height) {
        long offset = 0;
        for (long command = nnk__draw_begin(context.address(), commands.address());
                command != MemoryUtil.NULL;
                command = nnk__draw_next(command, commands.address(), context.address())) {
            int count = NkDrawCommand.nelem_count(command);
            if (count == 0) {
                continue;
            }
            glBindTexture(
                    GL_TEXTURE_2D,
                    MemoryUtil.memGetInt(command + NkDrawCommand.TEXTURE + NkHandle.ID));
            long clip = command + NkDrawCommand.CLIP_RECT;
            float clipX = MemoryUtil.memGetFloat(clip + NkRect.X);
            float clipY = MemoryUtil.memGetFloat(clip + NkRect.Y);
            float clipWidth = MemoryUtil.memGetFloat(clip + NkRect.W);
            float clipHeight = MemoryUtil.memGetFloat(clip + NkRect.H);
            int left = (int) Math.clamp(clipX, 0, width);
            int top = (int) Math.clamp(clipY, 0, height);
            int right = (int) Math.clamp(Math.ceil(clipX + clipWidth), 0, width);
            int bottom = (int) Math.clamp(Math.ceil(clipY + clipHeight), 0, height);
            glScissor(left, height - bottom, Math.max(0, right - left), Math.max(0, bottom - top));
            glDrawElements(GL_TRIANGLES, count, GL_UNSIGNED_SHORT, offset);
            offset += 2L * count;
        }
    }

    private int integer(int name) {
        nglGetIntegerv(name, fourInts);
        return MemoryUtil.memGetInt(fourInts);
    }

    private static void enable(int what, boolean value) {
        if (value) {
            glEnable(what);
        } else {
            glDisable(what);
        }
    }

    @Override
    public void close() {
        program.close();
        GlObjects.deleteVertexArray(vertexArray);
        GlObjects.deleteBuffer(vertexBuffer);
        GlObjects.deleteBuffer(indexBuffer);
        MemoryUtil.nmemFree(vertexAddress);
        MemoryUtil.nmemFree(indexAddress);
        MemoryUtil.nmemAlignedFree(commandAddress);
        vertices.free();
        indices.free();
        commands.free();
        layout.free();
        config.free();
        MemoryUtil.nmemFree(fourInts);
    }
}
