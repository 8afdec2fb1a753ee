package dev.cairn.render.gl;

import static org.lwjgl.opengl.GL11.GL_FALSE;
import static org.lwjgl.opengl.GL20.GL_COMPILE_STATUS;
import static org.lwjgl.opengl.GL20.GL_FRAGMENT_SHADER;
import static org.lwjgl.opengl.GL20.GL_LINK_STATUS;
import static org.lwjgl.opengl.GL20.GL_VERTEX_SHADER;
import static org.lwjgl.opengl.GL20.glAttachShader;
import static org.lwjgl.opengl.GL20.glCompileShader;
import static org.lwjgl.opengl.GL20.glGetProgramInfoLog;
import static org.lwjgl.opengl.GL20.glGetProgrami;
import static org.lwjgl.opengl.GL20.glGetShaderInfoLog;
import static org.lwjgl.opengl.GL20.glGetShaderi;
import static org.lwjgl.opengl.GL20.glGetUniformLocation;
import static org.lwjgl.opengl.GL20.glLinkProgram;
import static org.lwjgl.opengl.GL20.glShaderSource;
import static org.lwjgl.opengl.GL20.glUniform1f;
import static org.lwjgl.opengl.GL20.glUniform1i;
import static org.lwjgl.opengl.GL20.glUniform2f;
import static org.lwjgl.opengl.GL20.glUniform3f;
import static org.lwjgl.opengl.GL20.glUniformMatrix4fv;
import static org.lwjgl.opengl.GL20.glUseProgram;

import org.joml.Matrix4d;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;

/** A vertex and a fragment shader, from the resources beside this class. */
public final class ShaderProgram implements AutoCloseable {
    /** On its way to a uniform. There is one context at a time, and so one drawing thread. */
    private static final float[] MATRIX = new float[16];

    private final int id;
    private final String name;

    /**
     * Compiles and links.
     *
     * @param name for messages
     * @param defines lines that go before the sources
     * @param vertex resource files that make up the vertex shader
     * @param fragment resource files that make up the fragment shader
     */
    public ShaderProgram(String name, String defines, String[] vertex, String[] fragment) {
        this.name = name;
        int program = 0;
        int first = 0;
        int second = 0;
        try {
            first = compile(GL_VERTEX_SHADER, defines, vertex);
            second = compile(GL_FRAGMENT_SHADER, defines, fragment);
            program = GlObjects.program();
            glAttachShader(program, first);
            glAttachShader(program, second);
            glLinkProgram(program);
            if (glGetProgrami(program, GL_LINK_STATUS) == GL_FALSE) {
                String log = glGetProgramInfoLog(program);
                GlObjects.deleteProgram(program);
                throw new IllegalStateException(
                        "shader program '" + name + "' does not link: " + log);
            }
        } finally {
            GlObjects.deleteShader(first);
            GlObjects.deleteShader(second);
        }
        id = program;
    }

    private int compile(int kind, String defines, String[] files) {
        StringBuilder source = new StringBuilder("#version 330 core\n").append(defines);
        for (String file : files) {
            source.append("#line 1\n").append(resource(file));
        }
        int shader = GlObjects.shader(kind);
        glShaderSource(shader, source);
        glCompileShader(shader);
        if (glGetShaderi(shader, GL_COMPILE_STATUS) == GL_FALSE) {
            String log = glGetShaderInfoLog(shader);
            GlObjects.deleteShader(shader);
            throw new IllegalStateException(
                    "shader of '"
                            + name
                            + "' ("
                            + String.join(", ", files)
                            + ") does not compile: "
                            + log);
        }
        return shader;
    }

    private static String resource(String file) {
        try (InputStream in = ShaderProgram.class.getResourceAsStream(file)) {
            if (in == null) {
                throw new IllegalStateException(
                        "the resource " + file + " is missing from the engine-render jar");
            }
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(
                    "the resource " + file + " of the engine-render jar cannot be read", e);
        }
    }

    /** Makes this the program that draws. */
    public void use() {
        glUseProgram(id);
    }

    /**
     * Where a uniform is; asked once, when the program is made.
     *
     * @param uniform its name in the shaders
     * @return its location
     */
    public int uniform(String uniform) {
        int location = glGetUniformLocation(id, uniform);
        if (location < 0) {
            throw new IllegalStateException(
                    "shader program '" + name + "' does not use a uniform '" + uniform + "'");
        }
        return location;
    }

    /**
     * Where a uniform is that not every variant of the program has.
     *
     * @param uniform its name in the shaders
     * @return its location, or -1, which may be set and does nothing
     */
    int uniformIfUsed(String uniform) {
        return glGetUniformLocation(id, uniform);
    }

    /**
     * Sets a uniform of the program in use.
     *
     * @param location from {@link #uniform}
     * @param value an int or a sampler's texture unit
     */
    public static void set(int location, int value) {
        glUniform1i(location, value);
    }

    /**
     * Sets a uniform of the program in use.
     *
     * @param location from {@link #uniform}
     * @param value a float
     */
    public static void set(int location, double value) {
        glUniform1f(location, (float) value);
    }

    /** Sets a vec2. */
    static void set(int location, double x, double y) {
        glUniform2f(location, (float) x, (float) y);
    }

    /**
     * Sets a uniform of the program in use.
     *
     * @param location from {@link #uniform}
     * @param x of a vec3
     * @param y same
     * @param z same
     */
    public static void set(int location, double x, double y, double z) {
        glUniform3f(location, (float) x, (float) y, (float) z);
    }

    /**
     * Sets a uniform of the program in use.
     *
     * @param location from {@link #uniform}
     * @param matrix a mat4
     */
    public static void set(int location, Matrix4d matrix) {
        glUniformMatrix4fv(location, false, matrix.get(MATRIX));
    }

    @Override
    public void close() {
        GlObjects.deleteProgram(id);
    }
}
