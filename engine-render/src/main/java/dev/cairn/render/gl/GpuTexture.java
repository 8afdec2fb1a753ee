package dev.cairn.render.gl;

import static org.lwjgl.opengl.GL11.GL_LINEAR;
import static org.lwjgl.opengl.GL11.GL_LINEAR_MIPMAP_LINEAR;
import static org.lwjgl.opengl.GL11.GL_MAX_TEXTURE_SIZE;
import static org.lwjgl.opengl.GL11.GL_RENDERER;
import static org.lwjgl.opengl.GL11.GL_REPEAT;
import static org.lwjgl.opengl.GL11.GL_TEXTURE_2D;
import static org.lwjgl.opengl.GL11.GL_TEXTURE_MAG_FILTER;
import static org.lwjgl.opengl.GL11.GL_TEXTURE_MIN_FILTER;
import static org.lwjgl.opengl.GL11.GL_TEXTURE_WRAP_S;
import static org.lwjgl.opengl.GL11.GL_TEXTURE_WRAP_T;
import static org.lwjgl.opengl.GL11.glBindTexture;
import static org.lwjgl.opengl.GL11.glGetInteger;
import static org.lwjgl.opengl.GL11.glGetString;
import static org.lwjgl.opengl.GL11.glTexImage2D;
import static org.lwjgl.opengl.GL11.glTexParameterf;
import static org.lwjgl.opengl.GL11.glTexParameteri;
import static org.lwjgl.opengl.GL12.GL_BGRA;
import static org.lwjgl.opengl.GL12.GL_UNSIGNED_INT_8_8_8_8_REV;
import static org.lwjgl.opengl.GL21.GL_SRGB8_ALPHA8;
import static org.lwjgl.opengl.GL30.glGenerateMipmap;

import dev.cairn.render.mesh.Texture;

import org.lwjgl.opengl.EXTTextureFilterAnisotropic;
import org.lwjgl.opengl.GL;
import org.lwjgl.system.MemoryUtil;

import java.nio.IntBuffer;
import java.util.Objects;

/** A texture in graphics memory, with mipmaps; sampled in linear light. */
final class GpuTexture implements AutoCloseable {
    private static final float ANISOTROPY = 8;

    private final int id;

    GpuTexture(Texture texture) {
        int limit = glGetInteger(GL_MAX_TEXTURE_SIZE);
        int width = texture.width();
        int height = texture.height();
        if (width > limit || height > limit) {
            throw new IllegalArgumentException(
                    texture
                            + " is too large for this graphics processor, whose limit is "
                            + limit
                            + " pixels a side");
        }
        id = GlObjects.texture();
        glBindTexture(GL_TEXTURE_2D, id);
        IntBuffer pixels = MemoryUtil.memAllocInt(width * height);
        try {
            int[] argb = texture.argb();
            // OpenGL's first row is the lowest.
            for (int y = height - 1; y >= 0; y--) {
                pixels.put(argb, y * width, width);
            }
            glTexImage2D(
                    GL_TEXTURE_2D,
                    0,
                    GL_SRGB8_ALPHA8,
                    width,
                    height,
                    0,
                    GL_BGRA,
                    GL_UNSIGNED_INT_8_8_8_8_REV,
                    pixels.flip());
        } finally {
            MemoryUtil.memFree(pixels);
        }
        glGenerateMipmap(GL_TEXTURE_2D);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
        if (isAnisotropic()) {
            glTexParameterf(
                    GL_TEXTURE_2D,
                    EXTTextureFilterAnisotropic.GL_TEXTURE_MAX_ANISOTROPY_EXT,
                    ANISOTROPY);
        }
    }

    /**
     * Whether the graphics processor takes the mean over a long footprint itself; else the shader
     * does. llvmpipe could, but walks over every texel below the pixel's ellipse: seconds for a
     * face seen on edge.
     */
    static boolean isAnisotropic() {
        return GL.getCapabilities().GL_EXT_texture_filter_anisotropic
                && !GlContext.isSoftware(Objects.requireNonNullElse(glGetString(GL_RENDERER), ""));
    }

    void bind() {
        glBindTexture(GL_TEXTURE_2D, id);
    }

    @Override
    public void close() {
        GlObjects.deleteTexture(id);
    }
}
