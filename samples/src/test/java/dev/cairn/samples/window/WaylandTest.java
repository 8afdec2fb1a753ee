package dev.cairn.samples.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.shape.Box;
import dev.cairn.render.app.Application;
import dev.cairn.render.app.Scene;
import dev.cairn.render.app.View;
import dev.cairn.render.ui.Ui;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.lwjgl.glfw.GLFW;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;

/**
 * Full screen and back on Wayland, where no window knows its place. Needs {@code weston}, which
 * shows nothing here; skipped where it is missing.
 */
class WaylandTest {
    private static final int FRAMES_EACH = 30;

    /** Fills the screen and leaves it, twice; tells the size at the end of each. */
    static final class Probe extends Application {
        private static final int STAGES = 5;

        private Probe() {}

        /** Runs through all stages and quits. */
        public static void main(String[] arguments) {
            new Probe().size(640, 480).start();
        }

        @Override
        protected void initScene(Scene scene) {
            scene.add(Body.fixed().shape(Box.cubeOfHalfExtent(0.5)));
        }

        @Override
        protected void panels(Ui ui, View view) {
            // What is asked of Wayland in vain leaves no trace but GLFW's last error.
            int error = GLFW.glfwGetError(null);
            if (error != GLFW.GLFW_NO_ERROR) {
                System.out.printf("error=%#x in frame %d%n", error, view.frames());
            }
            long stage = view.frames() / FRAMES_EACH;
            if (view.frames() % FRAMES_EACH == FRAMES_EACH - 1) {
                System.out.printf("size=%.0fx%.0f%n", ui.width(), ui.height());
            }
            if (stage == STAGES) {
                quit();
            } else {
                fullscreen(stage % 2 == 1);
            }
        }
    }

    @Test
    void fullScreenIsLeft(@TempDir Path folder) throws IOException, InterruptedException {
        assumeTrue(!System.getProperty("gl.tests", "auto").equals("off"), "GL tests are off");
        boolean there =
                Arrays.stream(System.getenv("PATH").split(File.pathSeparator))
                        .anyMatch(entry -> Files.isExecutable(Path.of(entry, "weston")));
        if (!there) {
            System.err.println("NOTICE: full screen on Wayland is not tested: weston is missing");
        }
        assumeTrue(there, "weston is missing");
        ProcessBuilder weston =
                new ProcessBuilder(
                        "weston",
                        "--backend=headless-backend.so",
                        "--socket=cairn",
                        "--width=1100",
                        "--height=700",
                        "--idle-time=0");
        Process compositor = start(weston, folder, "weston.txt");
        try {
            while (!Files.exists(folder.resolve("cairn")) && compositor.isAlive()) {
                Thread.onSpinWait();
            }
            ProcessBuilder probe =
                    new ProcessBuilder(
                            Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                            "--enable-native-access=ALL-UNNAMED",
                            "-cp",
                            WindowFixture.wholeClassPath(),
                            Probe.class.getName());
            probe.environment().remove("DISPLAY");
            probe.environment().put("WAYLAND_DISPLAY", "cairn");
            probe.environment().put("LIBGL_ALWAYS_SOFTWARE", "1");
            Process window = start(probe, folder, "window.txt");
            boolean ended = window.waitFor(120, TimeUnit.SECONDS);
            window.destroy();
            String told = Files.readString(folder.resolve("window.txt"));
            assertTrue(ended, told);
            List<String> sizes = told.lines().filter(line -> line.startsWith("size=")).toList();
            String own = "size=640x480";
            String whole = "size=1100x700";
            assertEquals(List.of(own, whole, own, whole, own), sizes, told);
            assertFalse(told.contains("error="), told);
        } finally {
            compositor.destroy();
            compositor.waitFor();
        }
    }

    private static Process start(ProcessBuilder builder, Path folder, String output)
            throws IOException {
        builder.environment().put("XDG_RUNTIME_DIR", folder.toString());
        return builder.redirectErrorStream(true)
                .redirectOutput(folder.resolve(output).toFile())
                .start();
    }
}
