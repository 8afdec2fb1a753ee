package dev.cairn.render.gl;

import static org.lwjgl.opengl.GL11.GL_LINEAR;
import static org.lwjgl.opengl.GL11.GL_NEAREST;
import static org.lwjgl.opengl.GL11.GL_NONE;
import static org.lwjgl.opengl.GL11.GL_POLYGON_OFFSET_FILL;
import static org.lwjgl.opengl.GL11.GL_TEXTURE_2D;
import static org.lwjgl.opengl.GL11.GL_TEXTURE_BORDER_COLOR;
import static org.lwjgl.opengl.GL11.GL_TEXTURE_MAG_FILTER;
import static org.lwjgl.opengl.GL11.GL_TEXTURE_MIN_FILTER;
import static org.lwjgl.opengl.GL11.glDisable;
import static org.lwjgl.opengl.GL11.glEnable;
import static org.lwjgl.opengl.GL11.glPolygonOffset;
import static org.lwjgl.opengl.GL11.glTexParameterfv;
import static org.lwjgl.opengl.GL11.glTexParameteri;
import static org.lwjgl.opengl.GL13.GL_CLAMP_TO_BORDER;
import static org.lwjgl.opengl.GL13.GL_TEXTURE0;
import static org.lwjgl.opengl.GL13.glActiveTexture;
import static org.lwjgl.opengl.GL14.GL_TEXTURE_COMPARE_MODE;
import static org.lwjgl.opengl.GL30.GL_COMPARE_REF_TO_TEXTURE;
import static org.lwjgl.opengl.GL32.GL_DEPTH_CLAMP;
import static org.lwjgl.opengl.GL33.glBindSampler;
import static org.lwjgl.opengl.GL33.glSamplerParameteri;

import org.joml.Matrix4d;
import org.joml.Vector3d;

/**
 * Depth as the sun sees it, over a square region. The region's size goes in steps and its place in
 * whole texels of the world, so that shadows of resting things stand still.
 */
final class ShadowMap implements AutoCloseable {
    private final int size;
    private final DepthPass depth;

    /** The map as numbers, without comparison. */
    private final int numbers = GlObjects.sampler();

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
        depth = new DepthPass("shadow", size, size, GL_LINEAR, GL_CLAMP_TO_BORDER);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
        // Outside of the region everything is lit.
        glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, new float[] {1, 1, 1, 1});
        glSamplerParameteri(numbers, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glSamplerParameteri(numbers, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glSamplerParameteri(numbers, GL_TEXTURE_COMPARE_MODE, GL_NONE);
    }

    /**
     * Draws the map.
     *
     * @param alpha interpolation
     * @param sun unit direction to the sun
     * @param middle of the region, anchored
     * @param reach half its width, m; it is made somewhat larger
     */
    void draw(double alpha, Vector3d sun, Vector3d middle, double reach) {
        centre.set(middle);
        // Steps of a quarter of an octave.
        radius = Math.pow(2, Math.ceil(4 * Math.log(Math.max(reach, 1)) / Math.log(2)) / 4);
        place(sun);
        pass.cull(matrix);
        glEnable(GL_DEPTH_CLAMP);
        glEnable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(2, 4);
        depth.draw(pass, alpha, matrix);
        glDisable(GL_POLYGON_OFFSET_FILL);
        glDisable(GL_DEPTH_CLAMP);
    }

    private void place(Vector3d sun) {
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
        double half = depthMetres() / 2;
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
        matrix.setOrtho(-radius, radius, -radius, radius, -half, half).mul(lightFromAnchored);
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
        depth.bindTexture();
    }

    /** Also at a second unit, where it is read as numbers. */
    void bindNumbers(int unit) {
        glActiveTexture(GL_TEXTURE0 + unit);
        depth.bindTexture();
        glBindSampler(unit, numbers);
    }

    @Override
    public void close() {
        pass.close();
        depth.close();
        GlObjects.deleteSampler(numbers);
    }
}
