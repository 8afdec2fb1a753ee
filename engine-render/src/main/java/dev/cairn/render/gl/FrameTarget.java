package dev.cairn.render.gl;

import static org.lwjgl.opengl.GL11.GL_COLOR_BUFFER_BIT;
import static org.lwjgl.opengl.GL11.GL_NEAREST;
import static org.lwjgl.opengl.GL11.GL_PACK_ALIGNMENT;
import static org.lwjgl.opengl.GL11.GL_RGBA8;
import static org.lwjgl.opengl.GL11.glGetInteger;
import static org.lwjgl.opengl.GL11.glPixelStorei;
import static org.lwjgl.opengl.GL11.glReadPixels;
import static org.lwjgl.opengl.GL12.GL_BGRA;
import static org.lwjgl.opengl.GL12.GL_UNSIGNED_INT_8_8_8_8_REV;
import static org.lwjgl.opengl.GL14.GL_DEPTH_COMPONENT24;
import static org.lwjgl.opengl.GL30.GL_COLOR_ATTACHMENT0;
import static org.lwjgl.opengl.GL30.GL_DEPTH_ATTACHMENT;
import static org.lwjgl.opengl.GL30.GL_DRAW_FRAMEBUFFER;
import static org.lwjgl.opengl.GL30.GL_FRAMEBUFFER;
import static org.lwjgl.opengl.GL30.GL_FRAMEBUFFER_COMPLETE;
import static org.lwjgl.opengl.GL30.GL_MAX_SAMPLES;
import static org.lwjgl.opengl.GL30.GL_READ_FRAMEBUFFER;
import static org.lwjgl.opengl.GL30.GL_RENDERBUFFER;
import static org.lwjgl.opengl.GL30.glBindFramebuffer;
import static org.lwjgl.opengl.GL30.glBindRenderbuffer;
import static org.lwjgl.opengl.GL30.glBlitFramebuffer;
import static org.lwjgl.opengl.GL30.glCheckFramebufferStatus;
import static org.lwjgl.opengl.GL30.glFramebufferRenderbuffer;
import static org.lwjgl.opengl.GL30.glRenderbufferStorageMultisample;

import org.lwjgl.system.MemoryUtil;

import java.nio.IntBuffer;

/** What is drawn into: colour and depth of some samples per pixel, and the same resolved to one. */
public final class FrameTarget implements AutoCloseable {
    private static final int SAMPLES = 4;

    private final int width;
    private final int height;
    private final boolean smooth;
    private final int framebuffer;
    private final int colour;
    private final int depth;
    private final int resolved;
    private final int resolvedColour;

    /**
     * Makes a target.
     *
     * @param width pixels
     * @param height pixels
     * @param smooth whether edges are smooth: {@value #SAMPLES} samples per pixel in place of one,
     *     or as many as the graphics processor can
     */
    public FrameTarget(int width, int height, boolean smooth) {
        this.width = width;
        this.height = height;
        this.smooth = smooth;
        int count = smooth ? Math.min(SAMPLES, glGetInteger(GL_MAX_SAMPLES)) : 0;
        framebuffer = GlObjects.framebuffer();
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        colour = buffer(GL_RGBA8, count, GL_COLOR_ATTACHMENT0);
        depth = buffer(GL_DEPTH_COMPONENT24, count, GL_DEPTH_ATTACHMENT);
        check();
        resolved = GlObjects.framebuffer();
        glBindFramebuffer(GL_FRAMEBUFFER, resolved);
        resolvedColour = buffer(GL_RGBA8, 0, GL_COLOR_ATTACHMENT0);
        check();
    }

    private int buffer(int format, int samples, int attachment) {
        int id = GlObjects.renderbuffer();
        glBindRenderbuffer(GL_RENDERBUFFER, id);
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, id);
        return id;
    }

    private void check() {
        int status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
        if (status != GL_FRAMEBUFFER_COMPLETE) {
            throw new IllegalStateException(
                    "a picture of "
                            + width
                            + " x "
                            + height
                            + " pixels cannot be drawn here: framebuffer status 0x"
                            + Integer.toHexString(status)
                            + "; choose a smaller size");
        }
    }

    /**
     * Width.
     *
     * @return pixels
     */
    public int width() {
        return width;
    }

    /**
     * Height.
     *
     * @return pixels
     */
    public int height() {
        return height;
    }

    /**
     * Whether this is what is wanted, or another has to be made.
     *
     * @param wantedWidth pixels
     * @param wantedHeight pixels
     * @param wantedSmooth whether with smooth edges
     * @return true if it is
     */
    public boolean is(int wantedWidth, int wantedHeight, boolean wantedSmooth) {
        return width == wantedWidth && height == wantedHeight && smooth == wantedSmooth;
    }

    /** Makes this what is drawn into. */
    void bind() {
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    }

    /** Averages the samples of each pixel. */
    void resolve() {
        glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved);
        glBlitFramebuffer(
                0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    }

    /** Makes the resolved picture what is drawn into, for what needs no depth. */
    public void bindResolved() {
        glBindFramebuffer(GL_FRAMEBUFFER, resolved);
    }

    /** Copies the resolved picture to the window. */
    public void show() {
        glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved);
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
        glBlitFramebuffer(
                0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    }

    /**
     * Reads the resolved picture back.
     *
     * @return pixels, top row first, 0xAARRGGBB
     */
    public int[] read() {
        int[] argb = new int[width * height];
        IntBuffer pixels = MemoryUtil.memAllocInt(width * height);
        try {
            glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved);
            glPixelStorei(GL_PACK_ALIGNMENT, 4);
            glReadPixels(0, 0, width, height, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, pixels);
            for (int y = 0; y < height; y++) {
                pixels.get(y * width, argb, (height - 1 - y) * width, width);
            }
        } finally {
            MemoryUtil.memFree(pixels);
        }
        return argb;
    }

    @Override
    public void close() {
        GlObjects.deleteFramebuffer(framebuffer);
        GlObjects.deleteFramebuffer(resolved);
        GlObjects.deleteRenderbuffer(colour);
        GlObjects.deleteRenderbuffer(depth);
        GlObjects.deleteRenderbuffer(resolvedColour);
    }
}
