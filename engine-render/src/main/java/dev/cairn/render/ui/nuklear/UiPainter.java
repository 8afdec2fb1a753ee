package dev.cairn.render.ui.nuklear;

import static org.lwjgl.opengl.GL11.*;
import static org.lwjgl.opengl.GL13.GL_TEXTURE0;
import static org.lwjgl.opengl.GL13.glActiveTexture;
import static org.lwjgl.opengl.GL14.glBlendFuncSeparate;
import static org.lwjgl.opengl.GL30.glBindVertexArray;

import dev.cairn.render.gl.ShaderProgram;

import org.jspecify.annotations.Nullable;
import org.lwjgl.nuklear.NkContext;

/**
 * Draws what Nuklear has collected, by one shader and as many scissored calls as it has batches.
 * What others count on is as they do afterwards: depth and culling on, blending and scissors off.
 * Drivers are not asked what was before, since some answer only after all that they were told.
 */
final class UiPainter implements AutoCloseable {
    private static final int NO_TEXTURE = -1;

    private final ShaderProgram program =
            new ShaderProgram("ui", "", new String[] {"ui.vert"}, new String[] {"ui.frag"});
    private final int scaleUniform = program.uniform("clipPerPixel");
    private final int textureUniform = program.uniform("letters");
    private final UiGeometry geometry;

    /** Edges at which the batch drawn last was cut, pixels. */
    private int clipLeft;

    private int clipTop;
    private int clipRight;
    private int clipBottom;

    UiPainter(UiGeometry geometry) {
        this.geometry = geometry;
    }

    /**
     * Draws into the bound framebuffer of the given size, pixels: what the context has collected,
     * or without one what was drawn before.
     */
    void draw(@Nullable NkContext context, int width, int height) {
        if (context == null && geometry.batches() == 0) {
            return;
        }
        glEnable(GL_BLEND);
        glEnable(GL_SCISSOR_TEST);
        glDisable(GL_DEPTH_TEST);
        glDisable(GL_CULL_FACE);
        glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
        glViewport(0, 0, width, height);
        program.use();
        ShaderProgram.set(scaleUniform, 2.0 / width, -2.0 / height, 0);
        ShaderProgram.set(textureUniform, 0);
        glActiveTexture(GL_TEXTURE0);
        geometry.bind();
        if (context != null) {
            geometry.update(context);
        }
        drawBatches(width, height);
        glBindVertexArray(0);
        glEnable(GL_CULL_FACE);
        glEnable(GL_DEPTH_TEST);
        glDisable(GL_SCISSOR_TEST);
        glDisable(GL_BLEND);
    }

    private void drawBatches(int width, int height) {
        long offset = 0;
        int bound = NO_TEXTURE;
        clipLeft = -1; // who drew before may have left another
        for (int i = 0; i < geometry.batches(); i++) {
            int texture = geometry.texture(i);
            if (texture != bound) {
                glBindTexture(GL_TEXTURE_2D, texture);
                bound = texture;
            }
            float clipX = geometry.clipLeft(i);
            float clipY = geometry.clipTop(i);
            int left = (int) Math.clamp(clipX, 0, width);
            int top = (int) Math.clamp(clipY, 0, height);
            int right = (int) Math.clamp(Math.ceil(clipX + geometry.clipWidth(i)), 0, width);
            int bottom = (int) Math.clamp(Math.ceil(clipY + geometry.clipHeight(i)), 0, height);
            if (!isClip(left, top, right, bottom)) {
                glScissor(
                        left,
                        height - bottom,
                        Math.max(0, right - left),
                        Math.max(0, bottom - top));
            }
            glDrawElements(GL_TRIANGLES, geometry.count(i), GL_UNSIGNED_SHORT, offset);
            offset += 2L * geometry.count(i);
        }
    }

    /** Whether the last batch was cut at these edges too; they are the last from now on. */
    private boolean isClip(int left, int top, int right, int bottom) {
        boolean same =
                left == clipLeft && top == clipTop && right == clipRight && bottom == clipBottom;
        clipLeft = left;
        clipTop = top;
        clipRight = right;
        clipBottom = bottom;
        return same;
    }

    @Override
    public void close() {
        program.close();
    }
}
