package dev.cairn.render.gl;

import static org.lwjgl.glfw.GLFW.GLFW_ANY_PLATFORM;
import static org.lwjgl.glfw.GLFW.GLFW_CLIENT_API;
import static org.lwjgl.glfw.GLFW.GLFW_CONTEXT_CREATION_API;
import static org.lwjgl.glfw.GLFW.GLFW_CONTEXT_VERSION_MAJOR;
import static org.lwjgl.glfw.GLFW.GLFW_CONTEXT_VERSION_MINOR;
import static org.lwjgl.glfw.GLFW.GLFW_EGL_CONTEXT_API;
import static org.lwjgl.glfw.GLFW.GLFW_FALSE;
import static org.lwjgl.glfw.GLFW.GLFW_NATIVE_CONTEXT_API;
import static org.lwjgl.glfw.GLFW.GLFW_NO_ERROR;
import static org.lwjgl.glfw.GLFW.GLFW_OPENGL_API;
import static org.lwjgl.glfw.GLFW.GLFW_OPENGL_CORE_PROFILE;
import static org.lwjgl.glfw.GLFW.GLFW_OPENGL_FORWARD_COMPAT;
import static org.lwjgl.glfw.GLFW.GLFW_OPENGL_PROFILE;
import static org.lwjgl.glfw.GLFW.GLFW_PLATFORM;
import static org.lwjgl.glfw.GLFW.GLFW_PLATFORM_NULL;
import static org.lwjgl.glfw.GLFW.GLFW_PLATFORM_X11;
import static org.lwjgl.glfw.GLFW.GLFW_SCALE_TO_MONITOR;
import static org.lwjgl.glfw.GLFW.GLFW_TRUE;
import static org.lwjgl.glfw.GLFW.GLFW_VISIBLE;
import static org.lwjgl.glfw.GLFW.glfwCreateWindow;
import static org.lwjgl.glfw.GLFW.glfwDefaultWindowHints;
import static org.lwjgl.glfw.GLFW.glfwDestroyWindow;
import static org.lwjgl.glfw.GLFW.glfwGetError;
import static org.lwjgl.glfw.GLFW.glfwInit;
import static org.lwjgl.glfw.GLFW.glfwInitHint;
import static org.lwjgl.glfw.GLFW.glfwMakeContextCurrent;
import static org.lwjgl.glfw.GLFW.glfwPlatformSupported;
import static org.lwjgl.glfw.GLFW.glfwTerminate;
import static org.lwjgl.glfw.GLFW.glfwWindowHint;
import static org.lwjgl.opengl.GL11.GL_NO_ERROR;
import static org.lwjgl.opengl.GL11.GL_RENDERER;
import static org.lwjgl.opengl.GL11.GL_VERSION;
import static org.lwjgl.opengl.GL11.glGetError;
import static org.lwjgl.opengl.GL11.glGetString;

import dev.cairn.render.natives.NativeLibraries;

import org.lwjgl.PointerBuffer;
import org.lwjgl.glfw.Callbacks;
import org.lwjgl.glfw.GLFW;
import org.lwjgl.glfw.GLFWErrorCallback;
import org.lwjgl.opengl.GL;
import org.lwjgl.system.Configuration;
import org.lwjgl.system.MemoryStack;
import org.lwjgl.system.MemoryUtil;

import java.util.Locale;
import java.util.Map;
import java.util.concurrent.atomic.AtomicBoolean;

/**
 * GLFW's window with an OpenGL 3.3 core context: a real one, or one of the null platform whose
 * context comes from EGL and needs no display. One at a time. Open, use and close it on one thread;
 * for a real window that is the main thread. A failed opening leaves GLFW terminated, as if nothing
 * had been tried.
 */
public final class GlContext implements AutoCloseable {
    private static final AtomicBoolean OPEN = new AtomicBoolean();

    private static final String INSTALL =
            "; on Debian or Ubuntu: apt-get install libegl1 libgl1-mesa-dri";

    private final long window;
    private final Thread owner = Thread.currentThread();
    private final String renderer;
    private boolean closed;

    private GlContext(long window, String renderer) {
        this.window = window;
        this.renderer = renderer;
    }

    /**
     * Opens a context without a display.
     *
     * @return the context, current on this thread
     * @throws GlUnavailableException if there is none on this machine
     * @throws IllegalStateException if another one is open
     */
    public static GlContext offscreen() {
        return open(false, 16, 16, "offscreen");
    }

    /**
     * Opens a window, not yet visible.
     *
     * @param width in screen coordinates
     * @param height in screen coordinates
     * @param title its title
     * @return the context, current on this thread
     * @throws GlUnavailableException if there is no display, or it has no OpenGL 3.3
     * @throws IllegalStateException if another one is open
     */
    public static GlContext window(int width, int height, String title) {
        return open(true, width, height, title);
    }

    private static GlContext open(boolean visible, int width, int height, String title) {
        String missing = NativeLibraries.missing();
        if (missing != null) {
            throw new GlUnavailableException(missing);
        }
        if (!OPEN.compareAndSet(false, true)) {
            throw new IllegalStateException(
                    "a window or an offscreen view is open already; close it before another one is"
                            + " opened");
        }
        boolean done = false;
        try {
            GlContext context = create(visible, width, height, title);
            done = true;
            return context;
        } catch (LinkageError e) {
            throw new GlUnavailableException(
                    "LWJGL's native libraries cannot be loaded ("
                            + e.getMessage()
                            + "); add the artifact dev.cairn:cairn-natives to the class path");
        } finally {
            if (!done) {
                OPEN.set(false);
            }
        }
    }

    /** Under an X server alone, trying Wayland would only have its library print that it fails. */
    static int platform(Map<String, String> environment) {
        boolean onlyX11 =
                environment.containsKey("DISPLAY") && !environment.containsKey("WAYLAND_DISPLAY");
        return onlyX11 && glfwPlatformSupported(GLFW_PLATFORM_X11)
                ? GLFW_PLATFORM_X11
                : GLFW_ANY_PLATFORM;
    }

    private static GlContext create(boolean visible, int width, int height, String title) {
        // GLFW's own printing would come between the application's lines; its words come back by
        // glfwGetError.
        GLFWErrorCallback previous = GLFW.glfwSetErrorCallback(null);
        if (previous != null) {
            previous.free();
        }
        // Init hints outlive glfwTerminate, so the platform is always named.
        glfwInitHint(GLFW_PLATFORM, visible ? platform(System.getenv()) : GLFW_PLATFORM_NULL);
        if (!glfwInit()) {
            String reason = lastError();
            glfwTerminate();
            throw new GlUnavailableException("no display (" + reason + ")");
        }
        boolean done = false;
        try {
            glfwDefaultWindowHints();
            glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
            glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
            glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_API);
            glfwWindowHint(
                    GLFW_CONTEXT_CREATION_API,
                    visible ? GLFW_NATIVE_CONTEXT_API : GLFW_EGL_CONTEXT_API);
            glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
            glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
            glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
            glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
            long window = glfwCreateWindow(width, height, title, MemoryUtil.NULL, MemoryUtil.NULL);
            if (window == MemoryUtil.NULL) {
                String what =
                        visible ? "no window with OpenGL 3.3 (" : "no OpenGL 3.3 through EGL (";
                throw new GlUnavailableException(
                        what + lastError() + ")" + (visible ? "" : INSTALL));
            }
            glfwMakeContextCurrent(window);
            Configuration.OPENGL_CONTEXT_API.set(visible ? "native" : "EGL");
            try {
                GL.createCapabilities();
            } catch (IllegalStateException e) {
                throw new GlUnavailableException(
                        "OpenGL cannot be used (" + e.getMessage() + ")" + INSTALL);
            }
            String renderer = glGetString(GL_RENDERER) + ", OpenGL " + glGetString(GL_VERSION);
            done = true;
            return new GlContext(window, renderer);
        } finally {
            if (!done) {
                glfwTerminate();
            }
        }
    }

    private static String lastError() {
        try (MemoryStack stack = MemoryStack.stackPush()) {
            PointerBuffer text = stack.mallocPointer(1);
            int code = glfwGetError(text);
            return code == GLFW_NO_ERROR ? "no reason given" : MemoryUtil.memUTF8(text.get(0));
        }
    }

    /**
     * GLFW's handle.
     *
     * @return the window
     */
    public long handle() {
        return window;
    }

    /**
     * Who draws.
     *
     * @return names of the renderer and of the OpenGL version
     */
    public String renderer() {
        return renderer;
    }

    /**
     * Whether the CPU draws, so that effort is worth saving.
     *
     * @return true for Mesa's llvmpipe and softpipe, and SwiftShader
     */
    public boolean isSoftware() {
        return isSoftware(renderer);
    }

    /** The same, by what {@code GL_RENDERER} says. */
    static boolean isSoftware(String renderer) {
        String name = renderer.toLowerCase(Locale.ROOT);
        return name.contains("llvmpipe")
                || name.contains("softpipe")
                || name.contains("swiftshader");
    }

    /**
     * Checks that the calling thread may draw.
     *
     * @throws IllegalStateException if the context is closed or belongs to another thread
     */
    public void check() {
        if (closed) {
            throw new IllegalStateException("this view is closed");
        }
        if (!owner.equals(Thread.currentThread())) {
            throw new IllegalStateException(
                    "this view belongs to the thread '"
                            + owner.getName()
                            + "', but '"
                            + Thread.currentThread().getName()
                            + "' called; draw on the thread that opened it");
        }
    }

    /**
     * Throws if OpenGL has noted an error since the last call.
     *
     * @param where what was done, for the message
     */
    public static void checkErrors(String where) {
        int error = glGetError();
        if (error != GL_NO_ERROR) {
            throw new IllegalStateException(
                    "OpenGL error 0x" + Integer.toHexString(error) + " in " + where);
        }
    }

    /** Destroys the window and terminates GLFW; a second call does nothing. */
    @Override
    public void close() {
        if (closed) {
            return;
        }
        check();
        closed = true;
        try {
            glfwMakeContextCurrent(MemoryUtil.NULL);
            GL.setCapabilities(null);
            Callbacks.glfwFreeCallbacks(window);
            glfwDestroyWindow(window);
        } finally {
            glfwTerminate();
            OPEN.set(false);
        }
    }
}
