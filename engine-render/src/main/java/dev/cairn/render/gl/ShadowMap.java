package dev.cairn.render.gl;

import static org.lwjgl.opengl.GL11.GL_DEPTH_BUFFER_BIT;
import static org.lwjgl.opengl.GL11.GL_DEPTH_COMPONENT;
import static org.lwjgl.opengl.GL11.GL_LINEAR;
import static org.lwjgl.opengl.GL11.GL_NEAREST;
import static org.lwjgl.opengl.GL11.GL_NONE;
import static org.lwjgl.opengl.GL11.GL_POLYGON_OFFSET_FILL;
import static org.lwjgl.opengl.GL11.GL_TEXTURE_2D;
import static org.lwjgl.opengl.GL11.GL_TEXTURE_BORDER_COLOR;
import static org.lwjgl.opengl.GL11.GL_TEXTURE_MAG_FILTER;
import static org.lwjgl.opengl.GL11.GL_TEXTURE_MIN_FILTER;
import static org.lwjgl.opengl.GL11.GL_TEXTURE_WRAP_S;
import static org.lwjgl.opengl.GL11.GL_TEXTURE_WRAP_T;
import static org.lwjgl.opengl.GL11.GL_UNSIGNED_INT;
import static org.lwjgl.opengl.GL11.glBindTexture;
import static org.lwjgl.opengl.GL11.glClear;
import static org.lwjgl.opengl.GL11.glDisable;
import static org.lwjgl.opengl.GL11.glDrawBuffer;
import static org.lwjgl.opengl.GL11.glEnable;
import static org.lwjgl.opengl.GL11.glPolygonOffset;
import static org.lwjgl.opengl.GL11.glReadBuffer;
import static org.lwjgl.opengl.GL11.glTexImage2D;
import static org.lwjgl.opengl.GL11.glTexParameterfv;
import static org.lwjgl.opengl.GL11.glTexParameteri;
import static org.lwjgl.opengl.GL11.glViewport;
import static org.lwjgl.opengl.GL13.GL_CLAMP_TO_BORDER;
import static org.lwjgl.opengl.GL13.GL_TEXTURE0;
import static org.lwjgl.opengl.GL13.glActiveTexture;
import static org.lwjgl.opengl.GL14.GL_DEPTH_COMPONENT24;
import static org.lwjgl.opengl.GL14.GL_TEXTURE_COMPARE_MODE;
import static org.lwjgl.opengl.GL30.GL_COMPARE_REF_TO_TEXTURE;
import static org.lwjgl.opengl.GL30.GL_DEPTH_ATTACHMENT;
import static org.lwjgl.opengl.GL30.GL_FRAMEBUFFER;
import static org.lwjgl.opengl.GL30.glBindFramebuffer;
import static org.lwjgl.opengl.GL30.glFramebufferTexture2D;
import static org.lwjgl.opengl.GL32.GL_DEPTH_CLAMP;
import static org.lwjgl.opengl.GL33.glBindSampler;
import static org.lwjgl.opengl.GL33.glSamplerParameteri;

import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.lwjgl.system.MemoryUtil;

/**
 * Depth as the sun sees it, over a square region that holds all small models, or the part of them
 * near the view where they are spread wide. The region's size goes in steps and its place in whole
 * texels of the world, so that shadows of resting things stand still.
 */
final class ShadowMap implements AutoCloseable {
    /**
     * Models with a greater radius do not make the region larger (floors, walls); they cast and
     * receive all the same.
     */
    static final double CASTER_LIMIT = 20;

    private static final double MAX_RADIUS = 60;
    private static final double FOCUS_METRES = 30;

    private final int size;
    private final int framebuffer;
    private final int texture;

    /** The map as numbers, without comparison. */
    private final int numbers = GlObjects.sampler();

    private final ShaderProgram program;
    private final int matrixUniform;
    private final int alphaUniform;
    private final Pass pass;
    private final Instances instances;
    private final Matrix4d lightFromAnchored = new Matrix4d();
    private final Matrix4d matrix = new Matrix4d();
    private final Vector3d centre = new Vector3d();
    private final Vector3d right = new Vector3d();
    private final Vector3d up = new Vector3d();
    private double radius;

    /**
     * An empty map.
     *
     * @param size texels a side
     * @param instances what casts
     */
    ShadowMap(int size, Instances instances) {
        this.size = size;
        this.instances = instances;
        // What lies between the sun and the region casts into it, however far away it is.
        this.pass = new Pass(instances, true);
        texture = GlObjects.texture();
        glBindTexture(GL_TEXTURE_2D, texture);
        glTexImage2D(
                GL_TEXTURE_2D,
                0,
                GL_DEPTH_COMPONENT24,
                size,
                size,
                0,
                GL_DEPTH_COMPONENT,
                GL_UNSIGNED_INT,
                MemoryUtil.NULL);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
        // Outside of the region everything is lit.
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
        glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, new float[] {1, 1, 1, 1});
        glSamplerParameteri(numbers, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glSamplerParameteri(numbers, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glSamplerParameteri(numbers, GL_TEXTURE_COMPARE_MODE, GL_NONE);
        framebuffer = GlObjects.framebuffer();
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, texture, 0);
        glDrawBuffer(GL_NONE);
        glReadBuffer(GL_NONE);
        program =
                new ShaderProgram(
                        "shadow",
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
     * Draws the map.
     *
     * @param alpha interpolation
     * @param sun unit direction to the sun
     * @param eye camera, anchored
     * @param forward unit view direction
     */
    void draw(double alpha, Vector3d sun, Vector3d eye, Vector3d forward) {
        place(sun, eye, forward);
        pass.cull(matrix);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        glViewport(0, 0, size, size);
        glClear(GL_DEPTH_BUFFER_BIT);
        glEnable(GL_DEPTH_CLAMP);
        glEnable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(2, 4);
        program.use();
        ShaderProgram.set(matrixUniform, matrix);
        ShaderProgram.set(alphaUniform, alpha);
        for (int b = 0; b < pass.batches(); b++) {
            pass.draw(b);
        }
        glDisable(GL_POLYGON_OFFSET_FILL);
        glDisable(GL_DEPTH_CLAMP);
    }

    private void place(Vector3d sun, Vector3d eye, Vector3d forward) {
        Vector3d min = instances.castersMin();
        Vector3d max = instances.castersMax();
        centre.set(forward).mul(FOCUS_METRES).add(eye);
        if (min.x <= max.x) {
            double diagonal = 0.5 * min.distance(max);
            if (diagonal <= MAX_RADIUS) {
                centre.set(min).add(max).mul(0.5);
            } else {
                centre.max(min).min(max);
            }
            radius = Math.min(diagonal, MAX_RADIUS);
        } else {
            radius = MAX_RADIUS / 2;
        }
        // Steps of a quarter of an octave.
        radius = Math.pow(2, Math.ceil(4 * Math.log(Math.max(radius, 1)) / Math.log(2)) / 4);
        if (Math.abs(sun.y) < 0.99) {
            right.set(0, 1, 0).cross(sun).normalize();
        } else {
            right.set(1, 0, 0);
            right.fma(-right.dot(sun), sun).normalize();
        }
        up.set(sun).cross(right);
        // Whole texels of the world: the anchor is added for the rounding, so that it may jump
        // unseen.
        double texel = texelMetres();
        Vector3d anchor = instances.anchor();
        double across = right.dot(centre) + right.dot(anchor);
        double along = up.dot(centre) + up.dot(anchor);
        centre.fma(texel * Math.rint(across / texel) - across, right);
        centre.fma(texel * Math.rint(along / texel) - along, up);
        double depth = depthMetres() / 2;
        lightFromAnchored.set(
                right.x,
                up.x,
                sun.x,
                0,
                right.y,
                up.y,
                sun.y,
                0,
                right.z,
                up.z,
                sun.z,
                0,
                -right.dot(centre),
                -up.dot(centre),
                -sun.dot(centre),
                1);
        matrix.setOrtho(-radius, radius, -radius, radius, -depth, depth).mul(lightFromAnchored);
    }

    Matrix4d matrix() {
        return matrix;
    }

    int size() {
        return size;
    }

    double texelMetres() {
        return 2 * radius / size;
    }

    double bias() {
        return 0.5 * texelMetres() / depthMetres();
    }

    private double depthMetres() {
        return 4 * radius;
    }

    void bindTexture() {
        glBindTexture(GL_TEXTURE_2D, texture);
    }

    /** Also at a second unit, where it is read as numbers. */
    void bindNumbers(int unit) {
        glActiveTexture(GL_TEXTURE0 + unit);
        glBindTexture(GL_TEXTURE_2D, texture);
        glBindSampler(unit, numbers);
    }

    @Override
    public void close() {
        pass.close();
        program.close();
        GlObjects.deleteFramebuffer(framebuffer);
        GlObjects.deleteTexture(texture);
        GlObjects.deleteSampler(numbers);
    }
}
