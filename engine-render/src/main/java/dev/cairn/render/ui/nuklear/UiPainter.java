package dev.cairn.render.ui.nuklear;

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
import static org.lwjgl.opengl.GL15.glBindBuffer;
import static org.lwjgl.opengl.GL20.GL_CURRENT_PROGRAM;
import static org.lwjgl.opengl.GL20.glUseProgram;
import static org.lwjgl.opengl.GL30.GL_VERTEX_ARRAY_BINDING;
import static org.lwjgl.opengl.GL30.glBindVertexArray;

import dev.cairn.render.gl.ShaderProgram;

import org.lwjgl.nuklear.NkContext;
import org.lwjgl.system.MemoryUtil;

/**
 * Draws what Nuklear has collected, by one shader and as many scissored calls as it has batches.
 * All state that it changes is put back, so that whoever draws next need not know.
 */
final class UiPainter implements AutoCloseable {
    private final ShaderProgram program =
            new ShaderProgram("ui", "", new String[] {"ui.vert"}, new String[] {"ui.frag"});
    private final int scaleUniform = program.uniform("clipPerPixel");
    private final int textureUniform = program.uniform("letters");
    private final UiGeometry geometry;
    private final long fourInts = MemoryUtil.nmemAllocChecked(16);

    UiPainter(UiGeometry geometry) {
        this.geometry = geometry;
    }

    /** Draws into the bound framebuffer of the given size, pixels. */
    void draw(NkContext context, int width, int height) {
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
        geometry.update(context);
        drawBatches(width, height);

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

    private void drawBatches(int width, int height) {
        long offset = 0;
        for (int i = 0; i < geometry.batches(); i++) {
            glBindTexture(GL_TEXTURE_2D, geometry.texture(i));
            float clipX = geometry.clipLeft(i);
            float clipY = geometry.clipTop(i);
            int left = (int) Math.clamp(clipX, 0, width);
            int top = (int) Math.clamp(clipY, 0, height);
            int right = (int) Math.clamp(Math.ceil(clipX + geometry.clipWidth(i)), 0, width);
            int bottom = (int) Math.clamp(Math.ceil(clipY + geometry.clipHeight(i)), 0, height);
            glScissor(left, height - bottom, Math.max(0, right - left), Math.max(0, bottom - top));
            glDrawElements(GL_TRIANGLES, geometry.count(i), GL_UNSIGNED_SHORT, offset);
            offset += 2L * geometry.count(i);
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
        MemoryUtil.nmemFree(fourInts);
    }
}
