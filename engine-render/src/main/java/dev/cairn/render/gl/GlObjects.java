package dev.cairn.render.gl;

import static org.lwjgl.opengl.GL11.glDeleteTextures;
import static org.lwjgl.opengl.GL11.glGenTextures;
import static org.lwjgl.opengl.GL15.glDeleteBuffers;
import static org.lwjgl.opengl.GL15.glGenBuffers;
import static org.lwjgl.opengl.GL20.glCreateProgram;
import static org.lwjgl.opengl.GL20.glCreateShader;
import static org.lwjgl.opengl.GL20.glDeleteProgram;
import static org.lwjgl.opengl.GL20.glDeleteShader;
import static org.lwjgl.opengl.GL30.glDeleteFramebuffers;
import static org.lwjgl.opengl.GL30.glDeleteRenderbuffers;
import static org.lwjgl.opengl.GL30.glDeleteVertexArrays;
import static org.lwjgl.opengl.GL30.glGenFramebuffers;
import static org.lwjgl.opengl.GL30.glGenRenderbuffers;
import static org.lwjgl.opengl.GL30.glGenVertexArrays;
import static org.lwjgl.opengl.GL33.glDeleteSamplers;
import static org.lwjgl.opengl.GL33.glGenSamplers;

import java.util.EnumMap;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.atomic.AtomicLong;

/**
 * The one place where OpenGL objects are made and deleted, so that they can be counted: what is not
 * deleted leaks, since no collector frees it. Making and deleting is for the thread of the context;
 * the counts may be read on any thread.
 */
public final class GlObjects {
    /** A kind of object. */
    public enum Kind {
        /** Vertices, indices, instances. */
        BUFFER,
        /** How buffers feed a shader. */
        VERTEX_ARRAY,
        /** Pictures, depth maps, and views of buffers. */
        TEXTURE,
        /** What is drawn into. */
        FRAMEBUFFER,
        /** Its storage. */
        RENDERBUFFER,
        /** A linked pair of shaders. */
        PROGRAM,
        /** A compiled shader. */
        SHADER,
        /** How a texture is read. */
        SAMPLER
    }

    private static final Map<Kind, AtomicLong> MADE = counters();
    private static final Map<Kind, AtomicLong> LIVE = counters();

    private GlObjects() {}

    private static Map<Kind, AtomicLong> counters() {
        Map<Kind, AtomicLong> counters = new EnumMap<>(Kind.class);
        for (Kind kind : Kind.values()) {
            counters.put(kind, new AtomicLong());
        }
        return counters;
    }

    private static AtomicLong of(Map<Kind, AtomicLong> counters, Kind kind) {
        return Objects.requireNonNull(counters.get(kind));
    }

    /**
     * How many objects of a kind are made and not deleted.
     *
     * @param kind which kind
     * @return the count
     */
    public static long live(Kind kind) {
        return of(LIVE, kind).get();
    }

    /**
     * How many objects of a kind were ever made.
     *
     * @param kind which kind
     * @return the count
     */
    public static long made(Kind kind) {
        return of(MADE, kind).get();
    }

    /**
     * How many objects of all kinds are made and not deleted.
     *
     * @return the count
     */
    public static long live() {
        long sum = 0;
        for (Kind kind : Kind.values()) {
            sum += live(kind);
        }
        return sum;
    }

    private static int made(Kind kind, int id) {
        of(MADE, kind).incrementAndGet();
        of(LIVE, kind).incrementAndGet();
        return id;
    }

    private static void deleted(Kind kind, int id) {
        if (id != 0) {
            of(LIVE, kind).decrementAndGet();
        }
    }

    /**
     * Makes a buffer.
     *
     * @return its name
     */
    public static int buffer() {
        return made(Kind.BUFFER, glGenBuffers());
    }

    /**
     * Deletes a buffer.
     *
     * @param id its name; 0 does nothing
     */
    public static void deleteBuffer(int id) {
        glDeleteBuffers(id);
        deleted(Kind.BUFFER, id);
    }

    /**
     * Makes a vertex array.
     *
     * @return its name
     */
    public static int vertexArray() {
        return made(Kind.VERTEX_ARRAY, glGenVertexArrays());
    }

    /**
     * Deletes a vertex array.
     *
     * @param id its name; 0 does nothing
     */
    public static void deleteVertexArray(int id) {
        glDeleteVertexArrays(id);
        deleted(Kind.VERTEX_ARRAY, id);
    }

    /**
     * Makes a texture.
     *
     * @return its name
     */
    public static int texture() {
        return made(Kind.TEXTURE, glGenTextures());
    }

    /**
     * Deletes a texture.
     *
     * @param id its name; 0 does nothing
     */
    public static void deleteTexture(int id) {
        glDeleteTextures(id);
        deleted(Kind.TEXTURE, id);
    }

    static int framebuffer() {
        return made(Kind.FRAMEBUFFER, glGenFramebuffers());
    }

    static void deleteFramebuffer(int id) {
        glDeleteFramebuffers(id);
        deleted(Kind.FRAMEBUFFER, id);
    }

    static int renderbuffer() {
        return made(Kind.RENDERBUFFER, glGenRenderbuffers());
    }

    static void deleteRenderbuffer(int id) {
        glDeleteRenderbuffers(id);
        deleted(Kind.RENDERBUFFER, id);
    }

    static int program() {
        return made(Kind.PROGRAM, glCreateProgram());
    }

    static void deleteProgram(int id) {
        glDeleteProgram(id);
        deleted(Kind.PROGRAM, id);
    }

    static int sampler() {
        return made(Kind.SAMPLER, glGenSamplers());
    }

    static void deleteSampler(int id) {
        glDeleteSamplers(id);
        deleted(Kind.SAMPLER, id);
    }

    static int shader(int stage) {
        return made(Kind.SHADER, glCreateShader(stage));
    }

    static void deleteShader(int id) {
        glDeleteShader(id);
        deleted(Kind.SHADER, id);
    }
}
