package dev.cairn.render.gl;

import static org.lwjgl.opengl.GL11.GL_BLEND;
import static org.lwjgl.opengl.GL11.GL_CULL_FACE;
import static org.lwjgl.opengl.GL11.GL_DEPTH_TEST;
import static org.lwjgl.opengl.GL11.GL_FLOAT;
import static org.lwjgl.opengl.GL11.GL_GREATER;
import static org.lwjgl.opengl.GL11.GL_LEQUAL;
import static org.lwjgl.opengl.GL11.GL_ONE;
import static org.lwjgl.opengl.GL11.GL_ONE_MINUS_SRC_ALPHA;
import static org.lwjgl.opengl.GL11.GL_SRC_ALPHA;
import static org.lwjgl.opengl.GL11.GL_TRIANGLE_STRIP;
import static org.lwjgl.opengl.GL11.GL_UNSIGNED_BYTE;
import static org.lwjgl.opengl.GL11.glDepthFunc;
import static org.lwjgl.opengl.GL11.glDepthMask;
import static org.lwjgl.opengl.GL11.glDisable;
import static org.lwjgl.opengl.GL11.glEnable;
import static org.lwjgl.opengl.GL14.glBlendFuncSeparate;
import static org.lwjgl.opengl.GL15.GL_ARRAY_BUFFER;
import static org.lwjgl.opengl.GL15.GL_STREAM_DRAW;
import static org.lwjgl.opengl.GL15.glBindBuffer;
import static org.lwjgl.opengl.GL15.nglBufferData;
import static org.lwjgl.opengl.GL20.glEnableVertexAttribArray;
import static org.lwjgl.opengl.GL20.glVertexAttribPointer;
import static org.lwjgl.opengl.GL30.glBindVertexArray;
import static org.lwjgl.opengl.GL31.glDrawArraysInstanced;
import static org.lwjgl.opengl.GL33.glVertexAttribDivisor;

import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.lwjgl.system.MemoryUtil;

import java.nio.ByteBuffer;

/**
 * Lines and dots of a width in pixels over a drawn scene, each a rectangle that faces the camera (a
 * core profile draws no wide lines). What lies behind something is drawn faintly. Thread of the
 * context.
 */
public final class DebugLines implements SceneOverlay, AutoCloseable {
    /**
     * How well lines are seen through what lies in front of them, unless something else is said.
     */
    public static final double HIDDEN = 0.25;

    private static final int BYTES = 32;

    private final ShaderProgram program =
            new ShaderProgram(
                    "lines", "", new String[] {"lines.vert"}, new String[] {"lines.frag"});
    private final int matrixUniform = program.uniform("clipFromAnchored");
    private final int viewUniform = program.uniform("view");
    private final int frontUniform = program.uniform("front");
    private final int vertexArray = GlObjects.vertexArray();
    private final int buffer = GlObjects.buffer();
    private final Vector3d origin = new Vector3d();
    private final Matrix4d matrix = new Matrix4d();
    private ByteBuffer staging = MemoryUtil.memAlloc(1024 * BYTES);

    /** By address, since LWJGL wraps the buffer for each upload. */
    private long stagingAddress = MemoryUtil.memAddress(staging);

    private int count;
    private byte hiddenShare;
    private double widthScale = 1;

    /** Compiles the shader. */
    public DebugLines() {
        glBindVertexArray(vertexArray);
        glBindBuffer(GL_ARRAY_BUFFER, buffer);
        attribute(0, 3, GL_FLOAT, false, 0);
        attribute(1, 3, GL_FLOAT, false, 12);
        attribute(2, 4, GL_UNSIGNED_BYTE, true, 24);
        attribute(3, 1, GL_FLOAT, false, 28);
        glBindVertexArray(0);
    }

    private static void attribute(int index, int size, int type, boolean fraction, long offset) {
        glEnableVertexAttribArray(index);
        glVertexAttribPointer(index, size, type, fraction, BYTES, offset);
        glVertexAttribDivisor(index, 1);
    }

    /**
     * Forgets all lines.
     *
     * @param around a point near the camera, world frame, m: coordinates are kept relative to it
     * @param pixelScale factor on all widths, for screens of high density
     */
    public void begin(Vector3d around, double pixelScale) {
        origin.set(around);
        widthScale = pixelScale;
        count = 0;
        hidden(HIDDEN);
    }

    /**
     * Says how well the lines to come are seen through what lies in front of them.
     *
     * @param share 0..1; {@link #HIDDEN} after {@link #begin}
     */
    public void hidden(double share) {
        hiddenShare = (byte) Math.round(255 * share);
    }

    /**
     * Adds a line; a dot if both ends are one.
     *
     * @param ax world frame, m
     * @param ay same
     * @param az same
     * @param bx other end
     * @param by same
     * @param bz same
     * @param rgb 0xRRGGBB in sRGB
     * @param pixels width
     */
    public void line(
            double ax,
            double ay,
            double az,
            double bx,
            double by,
            double bz,
            int rgb,
            double pixels) {
        if ((count + 1) * BYTES > staging.capacity()) {
            staging = MemoryUtil.memRealloc(staging, 2 * staging.capacity());
            stagingAddress = MemoryUtil.memAddress(staging);
        }
        int at = count * BYTES;
        staging.putFloat(at, (float) (ax - origin.x));
        staging.putFloat(at + 4, (float) (ay - origin.y));
        staging.putFloat(at + 8, (float) (az - origin.z));
        staging.putFloat(at + 12, (float) (bx - origin.x));
        staging.putFloat(at + 16, (float) (by - origin.y));
        staging.putFloat(at + 20, (float) (bz - origin.z));
        staging.put(at + 24, (byte) (rgb >> 16));
        staging.put(at + 25, (byte) (rgb >> 8));
        staging.put(at + 26, (byte) rgb);
        staging.put(at + 27, hiddenShare);
        staging.putFloat(at + 28, (float) (pixels * widthScale));
        count++;
    }

    /**
     * Adds the twelve edges of a box.
     *
     * @param box minX, minY, minZ, maxX, maxY, maxZ, world frame, m
     * @param at index of minX
     * @param rgb 0xRRGGBB in sRGB
     * @param pixels width
     */
    public void box(double[] box, int at, int rgb, double pixels) {
        for (int edge = 0; edge < 12; edge++) {
            int axis = edge >> 2;
            int u = at + ((axis + 1) % 3) + ((edge & 1) == 0 ? 0 : 3);
            int v = at + ((axis + 2) % 3) + ((edge & 2) == 0 ? 0 : 3);
            double low = box[at + axis];
            double high = box[at + axis + 3];
            switch (axis) {
                case 0 -> line(low, box[u], box[v], high, box[u], box[v], rgb, pixels);
                case 1 -> line(box[v], low, box[u], box[v], high, box[u], rgb, pixels);
                default -> line(box[u], box[v], low, box[u], box[v], high, rgb, pixels);
            }
        }
    }

    @Override
    public void draw(Matrix4d clipFromAnchored, Vector3d anchor, int width, int height) {
        if (count == 0) {
            return;
        }
        program.use();
        ShaderProgram.set(
                matrixUniform,
                matrix.set(clipFromAnchored)
                        .translate(origin.x - anchor.x, origin.y - anchor.y, origin.z - anchor.z));
        ShaderProgram.set(viewUniform, width, height, 0);
        glBindBuffer(GL_ARRAY_BUFFER, buffer);
        nglBufferData(GL_ARRAY_BUFFER, (long) count * BYTES, stagingAddress, GL_STREAM_DRAW);
        glBindVertexArray(vertexArray);
        glEnable(GL_BLEND);
        glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
        glDisable(GL_CULL_FACE);
        glDepthMask(false);
        ShaderProgram.set(frontUniform, 0.0);
        glDepthFunc(GL_GREATER);
        glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
        ShaderProgram.set(frontUniform, 1.0);
        glDepthFunc(GL_LEQUAL);
        glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
        glDepthMask(true);
        glDisable(GL_BLEND);
        glEnable(GL_CULL_FACE);
        glEnable(GL_DEPTH_TEST);
        glBindVertexArray(0);
    }

    /**
     * How many lines there are.
     *
     * @return since {@link #begin}
     */
    public int count() {
        return count;
    }

    @Override
    public void close() {
        program.close();
        GlObjects.deleteVertexArray(vertexArray);
        GlObjects.deleteBuffer(buffer);
        MemoryUtil.memFree(staging);
    }
}
