package dev.cairn.render.gl;

import static org.lwjgl.opengl.GL11.GL_CULL_FACE;
import static org.lwjgl.opengl.GL11.GL_DEPTH_TEST;
import static org.lwjgl.opengl.GL11.GL_NEAREST;
import static org.lwjgl.opengl.GL11.GL_RED;
import static org.lwjgl.opengl.GL11.GL_TEXTURE_2D;
import static org.lwjgl.opengl.GL11.GL_TEXTURE_MAG_FILTER;
import static org.lwjgl.opengl.GL11.GL_TEXTURE_MIN_FILTER;
import static org.lwjgl.opengl.GL11.GL_TRIANGLES;
import static org.lwjgl.opengl.GL11.GL_UNSIGNED_BYTE;
import static org.lwjgl.opengl.GL11.glBindTexture;
import static org.lwjgl.opengl.GL11.glDisable;
import static org.lwjgl.opengl.GL11.glDrawArrays;
import static org.lwjgl.opengl.GL11.glEnable;
import static org.lwjgl.opengl.GL11.glTexImage2D;
import static org.lwjgl.opengl.GL11.glTexParameteri;
import static org.lwjgl.opengl.GL11.glViewport;
import static org.lwjgl.opengl.GL12.GL_CLAMP_TO_EDGE;
import static org.lwjgl.opengl.GL13.GL_TEXTURE0;
import static org.lwjgl.opengl.GL13.glActiveTexture;
import static org.lwjgl.opengl.GL30.GL_COLOR_ATTACHMENT0;
import static org.lwjgl.opengl.GL30.GL_FRAMEBUFFER;
import static org.lwjgl.opengl.GL30.GL_R8;
import static org.lwjgl.opengl.GL30.glBindFramebuffer;
import static org.lwjgl.opengl.GL30.glBindVertexArray;
import static org.lwjgl.opengl.GL30.glFramebufferTexture2D;

import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.lwjgl.system.MemoryUtil;

/**
 * The part of the sky that each pixel's neighbourhood leaves open: the scene's depth as the camera
 * sees it, then a picture of the shares, which the scene's shader averages. GL thread.
 */
final class Occlusion implements AutoCloseable {
    /** Radius of the neighbourhood, by its distance from the eye. */
    private static final double SHARE = 0.07;

    final int width;
    final int height;
    private final DepthPass depth;
    private final int framebuffer;
    private final int texture;
    private final int vertexArray;
    private final ShaderProgram program;
    private final int anchoredFromClip;
    private final int eye;
    private final int reach;
    private final Matrix4d inverse = new Matrix4d();

    /**
     * Empty textures.
     *
     * @param width of the picture, pixels
     * @param height same
     * @param vertexArray an empty one
     */
    Occlusion(int width, int height, int vertexArray) {
        this.width = width;
        this.height = height;
        this.vertexArray = vertexArray;
        glActiveTexture(GL_TEXTURE0 + SceneUniforms.SCENE_DEPTH);
        depth = new DepthPass("depth", width, height, GL_NEAREST, GL_CLAMP_TO_EDGE);
        glActiveTexture(GL_TEXTURE0 + SceneUniforms.OPEN_SHARE);
        texture = GlObjects.texture();
        glBindTexture(GL_TEXTURE_2D, texture);
        glTexImage2D(
                GL_TEXTURE_2D,
                0,
                GL_R8,
                width,
                height,
                0,
                GL_RED,
                GL_UNSIGNED_BYTE,
                MemoryUtil.NULL);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        framebuffer = GlObjects.framebuffer();
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
        program =
                new ShaderProgram(
                        "occlusion",
                        "#define OCCLUSION_SHARE %s%n".formatted(SHARE),
                        new String[] {"cover.vert"},
                        new String[] {"sampling.glsl", "occlusion.frag"});
        anchoredFromClip = program.uniform("anchoredFromClip");
        eye = program.uniform("eye");
        reach = program.uniform("occlusionReach");
        program.use();
        ShaderProgram.set(program.uniform("sceneDepth"), SceneUniforms.SCENE_DEPTH);
    }

    /**
     * Draws both.
     *
     * @param pass what is seen
     * @param alpha interpolation
     * @param clipFromAnchored of the picture
     * @param anchoredEye where it is seen from
     * @param tan of half the field of view, upwards
     */
    void draw(
            Pass pass, double alpha, Matrix4d clipFromAnchored, Vector3d anchoredEye, double tan) {
        depth.draw(pass, alpha, clipFromAnchored);
        glActiveTexture(GL_TEXTURE0 + SceneUniforms.SCENE_DEPTH);
        depth.bindTexture();
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        glViewport(0, 0, width, height);
        program.use();
        ShaderProgram.set(anchoredFromClip, clipFromAnchored.invert(inverse));
        ShaderProgram.set(eye, anchoredEye.x, anchoredEye.y, anchoredEye.z);
        double share = 0.5 * SHARE / tan;
        ShaderProgram.set(reach, share * height / width, share);
        glDisable(GL_DEPTH_TEST);
        glDisable(GL_CULL_FACE);
        glBindVertexArray(vertexArray);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glEnable(GL_CULL_FACE);
        glEnable(GL_DEPTH_TEST);
    }

    /** Binds both textures to their units; another unit is active then. */
    void bind() {
        glActiveTexture(GL_TEXTURE0 + SceneUniforms.SCENE_DEPTH);
        depth.bindTexture();
        glActiveTexture(GL_TEXTURE0 + SceneUniforms.OPEN_SHARE);
        glBindTexture(GL_TEXTURE_2D, texture);
    }

    @Override
    public void close() {
        depth.close();
        program.close();
        GlObjects.deleteFramebuffer(framebuffer);
        GlObjects.deleteTexture(texture);
    }
}
