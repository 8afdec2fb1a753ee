package dev.cairn.render.gl;

import static org.lwjgl.opengl.GL11.glBindTexture;
import static org.lwjgl.opengl.GL11.glGetInteger;
import static org.lwjgl.opengl.GL13.glActiveTexture;
import static org.lwjgl.opengl.GL15.glBindBuffer;
import static org.lwjgl.opengl.GL15.nglBufferData;
import static org.lwjgl.opengl.GL30.GL_RGBA32F;
import static org.lwjgl.opengl.GL31.GL_MAX_TEXTURE_BUFFER_SIZE;
import static org.lwjgl.opengl.GL31.GL_TEXTURE_BUFFER;
import static org.lwjgl.opengl.GL31.glTexBuffer;

/** A list of four-float texels that shaders read by number. */
final class BufferTexture implements AutoCloseable {
    static final int FLOATS_PER_TEXEL = 4;

    private final String what;
    private final int unit;
    private final int limit = glGetInteger(GL_MAX_TEXTURE_BUFFER_SIZE);
    private final int buffer = GlObjects.buffer();
    private final int texture = GlObjects.texture();

    /**
     * An empty list.
     *
     * @param what is in it, for the message when it does not fit
     * @param unit the texture unit that it is read from, GL_TEXTURE0 or above
     */
    BufferTexture(String what, int unit) {
        this.what = what;
        this.unit = unit;
        glActiveTexture(unit);
        glBindTexture(GL_TEXTURE_BUFFER, texture);
        glBindBuffer(GL_TEXTURE_BUFFER, buffer);
        glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, buffer);
    }

    /**
     * Replaces the list. It gets a new store each time, so the driver need not wait for frames that
     * still read the old one.
     *
     * @param address of the first float
     * @param floats how many
     * @param usage GL_STREAM_DRAW, GL_STATIC_DRAW
     */
    void write(long address, int floats, int usage) {
        int texels = floats / FLOATS_PER_TEXEL;
        if (texels > limit) {
            throw new IllegalStateException(
                    what
                            + " take "
                            + texels
                            + " texels, but this graphics processor holds at most "
                            + limit
                            + " in a buffer texture; show fewer entities");
        }
        glBindBuffer(GL_TEXTURE_BUFFER, buffer);
        nglBufferData(GL_TEXTURE_BUFFER, 4L * floats, address, usage);
    }

    /** Makes it readable at its unit. */
    void bind() {
        glActiveTexture(unit);
        glBindTexture(GL_TEXTURE_BUFFER, texture);
    }

    @Override
    public void close() {
        GlObjects.deleteTexture(texture);
        GlObjects.deleteBuffer(buffer);
    }
}
