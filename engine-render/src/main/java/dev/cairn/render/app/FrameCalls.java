package dev.cairn.render.app;

import org.lwjgl.glfw.GLFW;

import java.lang.foreign.FunctionDescriptor;
import java.lang.foreign.Linker;
import java.lang.foreign.MemorySegment;
import java.lang.foreign.ValueLayout;
import java.lang.invoke.MethodHandle;

/**
 * The functions of GLFW that frames call once. LWJGL wraps addresses in objects, which the JIT does
 * away with only in what runs some thousand times: after minutes of frames. These take plain
 * numbers, so that a frame makes no garbage from the first second on. Window thread.
 */
final class FrameCalls {
    private static final MethodHandle POLL_EVENTS =
            function(GLFW.Functions.PollEvents, FunctionDescriptor.ofVoid());
    private static final MethodHandle SWAP_BUFFERS =
            function(GLFW.Functions.SwapBuffers, FunctionDescriptor.ofVoid(ValueLayout.JAVA_LONG));

    private static final MethodHandle SET_WINDOW_TITLE =
            function(
                    GLFW.Functions.SetWindowTitle,
                    FunctionDescriptor.ofVoid(ValueLayout.JAVA_LONG, ValueLayout.JAVA_LONG));

    private FrameCalls() {}

    // The address is LWJGL's, which has bound the same function by the same signature.
    @SuppressWarnings("restricted")
    private static MethodHandle function(long address, FunctionDescriptor signature) {
        return Linker.nativeLinker().downcallHandle(MemorySegment.ofAddress(address), signature);
    }

    static void pollEvents() {
        try {
            POLL_EVENTS.invokeExact();
        } catch (Throwable thrown) {
            throw new IllegalStateException("glfwPollEvents failed", thrown);
        }
    }

    /** Sets the title to the text in UTF-8, ended by 0, at an address. */
    static void title(long window, long text) {
        try {
            SET_WINDOW_TITLE.invokeExact(window, text);
        } catch (Throwable thrown) {
            throw new IllegalStateException("glfwSetWindowTitle failed", thrown);
        }
    }

    static void swapBuffers(long window) {
        try {
            SWAP_BUFFERS.invokeExact(window);
        } catch (Throwable thrown) {
            throw new IllegalStateException("glfwSwapBuffers failed", thrown);
        }
    }
}
