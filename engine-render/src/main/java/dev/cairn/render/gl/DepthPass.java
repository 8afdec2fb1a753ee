package dev.cairn.render.gl;

import static org.lwjgl.opengl.GL11.GL_DEPTH_BUFFER_BIT;
import static org.lwjgl.opengl.GL11.GL_DEPTH_COMPONENT;
import static org.lwjgl.opengl.GL11.GL_NONE;
import static org.lwjgl.opengl.GL11.GL_TEXTURE_2D;
import static org.lwjgl.opengl.GL11.GL_TEXTURE_MAG_FILTER;
import static org.lwjgl.opengl.GL11.GL_TEXTURE_MIN_FILTER;
import static org.lwjgl.opengl.GL11.GL_TEXTURE_WRAP_S;
import static org.lwjgl.opengl.GL11.GL_TEXTURE_WRAP_T;
import static org.lwjgl.opengl.GL11.GL_UNSIGNED_INT;
import static org.lwjgl.opengl.GL11.glBindTexture;
import static org.lwjgl.opengl.GL11.glClear;
import static org.lwjgl.opengl.GL11.glDrawBuffer;
import static org.lwjgl.opengl.GL11.glReadBuffer;
import static org.lwjgl.opengl.GL11.glTexImage2D;
import static org.lwjgl.opengl.GL11.glTexParameteri;
import static org.lwjgl.opengl.GL11.glViewport;
import static org.lwjgl.opengl.GL14.GL_DEPTH_COMPONENT24;
import static org.lwjgl.opengl.GL30.GL_DEPTH_ATTACHMENT;
import static org.lwjgl.opengl.GL30.GL_FRAMEBUFFER;
import static org.lwjgl.opengl.GL30.glBindFramebuffer;
import static org.lwjgl.opengl.GL30.glFramebufferTexture2D;

import org.joml.Matrix4d;
import org.lwjgl.system.MemoryUtil;

/** Draws the depth of models into a texture, without colours. GL thread. */
final class DepthPass implements AutoCloseable {
    final int width;
    final int height;
    private final int framebuffer;
    private final int texture;
    private final ShaderProgram program;
    private final int matrixUniform;
    private final int alphaUniform;

    /**
     * An empty texture; the texture unit that is active is bound to it.
     *
     * @param name of the program in messages
     * @param width texels
     * @param height texels
     * @param filter between texels, {@code GL_NEAREST} or {@code GL_LINEAR}
     * @param wrap beyond the edge
     */
    DepthPass(String name, int width, int height, int filter, int wrap) {
        this.width = width;
        this.height = height;
        texture = GlObjects.texture();
        glBindTexture(GL_TEXTURE_2D, texture);
        glTexImage2D(
                GL_TEXTURE_2D,
                0,
                GL_DEPTH_COMPONENT24,
                width,
                height,
                0,
                GL_DEPTH_COMPONENT,
                GL_UNSIGNED_INT,
                MemoryUtil.NULL);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
        framebuffer = GlObjects.framebuffer();
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, texture, 0);
        glDrawBuffer(GL_NONE);
        glReadBuffer(GL_NONE);
        program =
                new ShaderProgram(
                        name,
                        "",
                        new String[] {"instance.glsl", "shadow.vert"},
                        new String[] {"shadow.frag"});
        matrixUniform = program.uniform("shadowFromAnchored");
        alphaUniform = program.uniform("alpha");
        program.use();
        ShaderProgram.set(program.uniform("motion"), 2);
        ShaderProgram.set(program.uniform("look"), 3);
    }

    /**
     * Draws what a pass sees.
     *
     * @param alpha interpolation
     * @param clipFromAnchored where it is seen from
     */
    void draw(Pass pass, double alpha, Matrix4d clipFromAnchored) {
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        glViewport(0, 0, width, height);
        glClear(GL_DEPTH_BUFFER_BIT);
        program.use();
        ShaderProgram.set(matrixUniform, clipFromAnchored);
        ShaderProgram.set(alphaUniform, alpha);
        for (int b = 0; b < pass.batches(); b++) {
            if (pass.isSolid(b)) {
                pass.draw(b);
            }
        }
    }

    void bindTexture() {
        glBindTexture(GL_TEXTURE_2D, texture);
    }

    @Override
    public void close() {
        program.close();
        GlObjects.deleteFramebuffer(framebuffer);
        GlObjects.deleteTexture(texture);
    }
}
