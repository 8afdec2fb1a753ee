package dev.cairn.render.natives;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

class NativeLibrariesTest {
    @Test
    void allAreThereInTheTests() {
        assertNull(NativeLibraries.missing());
    }

    /** A picture asked for on a class path without natives: one line, which names all of them. */
    @Test
    void withoutThemOneSentenceNamesAll(@TempDir Path folder)
            throws IOException, InterruptedException {
        List<String> path = new ArrayList<>();
        for (String entry : System.getProperty("java.class.path").split(File.pathSeparator)) {
            if (!entry.contains("natives-")) {
                path.add(Path.of(entry).toAbsolutePath().toString());
            }
        }
        Process process =
                new ProcessBuilder(
                                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                                "--add-modules=jdk.incubator.vector",
                                "--enable-native-access=ALL-UNNAMED",
                                "-cp",
                                String.join(File.pathSeparator, path),
                                Asks.class.getName())
                        .directory(folder.toFile())
                        .redirectErrorStream(true)
                        .start();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(0, process.waitFor(), said);
        List<String> lines = said.lines().filter(line -> !line.startsWith("WARNING")).toList();
        assertEquals(3, lines.size(), said);
        for (String line : lines) {
            assertTrue(
                    line.contains("lwjgl, lwjgl-glfw, lwjgl-opengl, lwjgl-stb, lwjgl-nuklear")
                            && line.contains("dev.cairn:cairn-natives"),
                    said);
        }
    }

    /** What a program of the user asks for. */
    static final class Asks {
        private Asks() {}

        /** Two ways to a picture and one to a texture; each prints why not. */
        public static void main(String[] arguments) {
            System.out.println(dev.cairn.render.app.Offscreen.unavailableReason());
            try {
                dev.cairn.render.app.Offscreen.open(64, 64).close();
            } catch (IllegalStateException told) {
                System.out.println(told.getMessage());
            }
            try {
                NativeLibraries.require();
            } catch (IllegalStateException told) {
                assertNotNull(told.getMessage());
                System.out.println(told.getMessage());
            }
        }
    }
}
