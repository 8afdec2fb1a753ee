package dev.cairn.render.app;

import static org.lwjgl.glfw.GLFW.GLFW_DONT_CARE;
import static org.lwjgl.glfw.GLFW.GLFW_PLATFORM_WAYLAND;
import static org.lwjgl.glfw.GLFW.glfwGetPlatform;
import static org.lwjgl.glfw.GLFW.glfwGetPrimaryMonitor;
import static org.lwjgl.glfw.GLFW.glfwGetVideoMode;
import static org.lwjgl.glfw.GLFW.glfwGetWindowPos;
import static org.lwjgl.glfw.GLFW.glfwGetWindowSize;
import static org.lwjgl.glfw.GLFW.glfwSetWindowMonitor;

import org.lwjgl.glfw.GLFWVidMode;

/** Has a window fill the screen, and gives it back its place and size. Window thread. */
final class FullScreen {
    private static final int LEAST = 64;

    private final long window;
    private final int[] x = new int[1];
    private final int[] y = new int[1];
    private final int[] width = new int[1];
    private final int[] height = new int[1];
    private boolean filled;

    FullScreen(long window) {
        this.window = window;
    }

    /** Does what is wished if it is not so. */
    void set(boolean wished) {
        if (wished == filled) {
            return;
        }
        if (!wished) {
            glfwSetWindowMonitor(
                    window,
                    0,
                    x[0],
                    y[0],
                    Math.max(width[0], LEAST),
                    Math.max(height[0], LEAST),
                    GLFW_DONT_CARE);
            filled = false;
            return;
        }
        long monitor = glfwGetPrimaryMonitor();
        GLFWVidMode mode = monitor == 0 ? null : glfwGetVideoMode(monitor);
        if (mode == null) {
            return; // No screen is known; the wish stays until there is one.
        }
        if (glfwGetPlatform() != GLFW_PLATFORM_WAYLAND) {
            // Wayland tells no window where it is, and to ask is an error there.
            glfwGetWindowPos(window, x, y);
        }
        glfwGetWindowSize(window, width, height);
        glfwSetWindowMonitor(
                window, monitor, 0, 0, mode.width(), mode.height(), mode.refreshRate());
        filled = true;
    }
}
