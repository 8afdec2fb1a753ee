package dev.cairn.render.gl;

import static org.lwjgl.opengl.GL11.GL_FLOAT;
import static org.lwjgl.opengl.GL11.GL_LINEAR;
import static org.lwjgl.opengl.GL11.GL_RGB;
import static org.lwjgl.opengl.GL11.GL_TEXTURE_2D;
import static org.lwjgl.opengl.GL11.GL_TEXTURE_MAG_FILTER;
import static org.lwjgl.opengl.GL11.GL_TEXTURE_MIN_FILTER;
import static org.lwjgl.opengl.GL11.GL_TEXTURE_WRAP_S;
import static org.lwjgl.opengl.GL11.GL_TEXTURE_WRAP_T;
import static org.lwjgl.opengl.GL11.glBindTexture;
import static org.lwjgl.opengl.GL11.glTexImage2D;
import static org.lwjgl.opengl.GL11.glTexParameteri;
import static org.lwjgl.opengl.GL12.GL_CLAMP_TO_EDGE;
import static org.lwjgl.opengl.GL13.GL_TEXTURE0;
import static org.lwjgl.opengl.GL13.glActiveTexture;
import static org.lwjgl.opengl.GL30.GL_RGB16F;

import dev.cairn.render.camera.Light;

import org.jspecify.annotations.Nullable;
import org.lwjgl.system.MemoryUtil;

import java.nio.FloatBuffer;

/**
 * The sky as light. It looks the same all around, so two numbers are enough to look it up: the
 * height of a direction, and how rough the mirror is. A row for each roughness holds the mean of
 * the sky over the lobe of GGX around a mirrored direction, seen along it (the first part of the
 * split sum of Karis, "Real shading in Unreal Engine 4", 2013, weighted by what the facets let
 * through instead of by the cosine, so that it is exact from above); the last row the light on a
 * surface by its normal, the mean over its half of the sky by the cosine. Made anew when the light
 * changes, by sums over fixed directions, so that pictures are the same bytes each time. GL thread.
 */
final class SkyTable implements AutoCloseable {
    /** Known to material.glsl. */
    private static final int WIDTH = 64;

    private static final int HEIGHT = 8;
    private static final int SAMPLES = 256;

    private int texture;
    private @Nullable Light made;

    /** Binds the table of a light to its unit. */
    void bind(Light light) {
        glActiveTexture(GL_TEXTURE0 + SceneUniforms.SKY_TABLE);
        if (texture == 0) {
            texture = GlObjects.texture();
        }
        glBindTexture(GL_TEXTURE_2D, texture);
        if (!light.equals(made)) {
            upload(light);
            made = light;
        }
    }

    private static void upload(Light light) {
        FloatBuffer texels = MemoryUtil.memAllocFloat(WIDTH * HEIGHT * 3);
        try {
            texels.put(table(light)).flip();
            glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB16F, WIDTH, HEIGHT, 0, GL_RGB, GL_FLOAT, texels);
        } finally {
            MemoryUtil.memFree(texels);
        }
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    }

    /** All texels, linear red, green, blue. */
    static float[] table(Light light) {
        float[] all = new float[WIDTH * HEIGHT * 3];
        double[] sum = new double[3];
        double[] gain = gains(light);
        for (int column = 0; column < WIDTH; column++) {
            double height = 2.0 * column / (WIDTH - 1) - 1;
            for (int row = 0; row < HEIGHT; row++) {
                boolean isSurface = row == HEIGHT - 1;
                if (isSurface) {
                    onSurface(light, height, gain, sum);
                } else {
                    mirrored(light, height, row / (HEIGHT - 2.0), sum);
                }
                for (int c = 0; c < 3; c++) {
                    all[3 * (row * WIDTH + column) + c] = (float) sum[c];
                }
            }
        }
        return all;
    }

    /** The sky as the backdrop draws it, below it the light from the ground. */
    private static double sky(Light light, double height, int channel) {
        int shift = 16 - 8 * channel;
        if (height < 0) {
            return channel == 0
                    ? light.groundRed()
                    : channel == 1 ? light.groundGreen() : light.groundBlue();
        }
        double zenith = Srgb.linear(light.zenithRgb() >> shift);
        double horizon = Srgb.linear(light.horizonRgb() >> shift);
        return horizon + (zenith - horizon) * (1 - Math.exp(-3 * height));
    }

    /** What makes a surface that faces up get the light that {@link Light} says, per channel. */
    private static double[] gains(Light light) {
        double[] whole = new double[3];
        onSurface(light, 1, new double[] {1, 1, 1}, whole);
        double[] wanted = {light.skyRed(), light.skyGreen(), light.skyBlue()};
        double[] gains = new double[3];
        for (int c = 0; c < 3; c++) {
            gains[c] = whole[c] > 0 ? wanted[c] / whole[c] : 0;
        }
        return gains;
    }

    /** Mean over the half of all directions that a surface faces, by the cosine. */
    private static void onSurface(Light light, double normalY, double[] gain, double[] sum) {
        double side = Math.sqrt(Math.max(0, 1 - normalY * normalY));
        clear(sum);
        for (int i = 0; i < SAMPLES; i++) {
            // Evenly over the disc below the half sphere: that is the cosine.
            double r = Math.sqrt((i + 0.5) / SAMPLES);
            double angle = 2.399963229728653 * i;
            double up = Math.sqrt(1 - r * r);
            double height = up * normalY + r * Math.cos(angle) * side;
            for (int c = 0; c < 3; c++) {
                sum[c] += sky(light, height, c) * (height < 0 ? 1 : gain[c]) / SAMPLES;
            }
        }
    }

    /** Mean over the lobe of GGX around a mirrored direction, the eye on it. */
    private static void mirrored(Light light, double height, double roughness, double[] sum) {
        double side = Math.sqrt(Math.max(0, 1 - height * height));
        double a = roughness * roughness;
        double weight = 0;
        clear(sum);
        for (int i = 0; i < SAMPLES; i++) {
            double share = (i + 0.5) / SAMPLES;
            double angle = 2.399963229728653 * i;
            // The half vector by its distribution, the eye mirrored in it.
            double cos = Math.sqrt((1 - share) / (1 + (a * a - 1) * share));
            double towards = 2 * cos * cos - 1;
            double aside = 2 * cos * Math.sqrt(Math.max(0, 1 - cos * cos));
            if (towards > 0) {
                double up = towards * height + aside * Math.cos(angle) * side;
                // Smith's visibility of the light among the facets; the eye hides none.
                double seen =
                        2
                                * towards
                                / (towards + Math.sqrt(a * a + (1 - a * a) * towards * towards));
                for (int c = 0; c < 3; c++) {
                    sum[c] += seen * sky(light, up, c);
                }
                weight += seen;
            }
        }
        for (int c = 0; c < 3; c++) {
            sum[c] /= weight;
        }
    }

    private static void clear(double[] sum) {
        sum[0] = 0;
        sum[1] = 0;
        sum[2] = 0;
    }

    @Override
    public void close() {
        if (texture != 0) {
            GlObjects.deleteTexture(texture);
        }
    }
}
