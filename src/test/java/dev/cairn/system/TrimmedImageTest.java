package dev.cairn.system;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.shape.Box;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.File;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.spi.ToolProvider;

/** A run-time image with no more than the base modules: no flight recorder, no Vector API. */
class TrimmedImageTest {
    @Test
    void aWorldStepsWithoutTheFlightRecorder(@TempDir Path folder) throws Exception {
        Optional<ToolProvider> jlink = ToolProvider.findFirst("jlink");
        assumeTrue(jlink.isPresent(), "this JDK has no jlink");
        Path image = folder.resolve("image");
        StringWriter text = new StringWriter();
        int linked =
                jlink.get()
                        .run(
                                new PrintWriter(text),
                                new PrintWriter(text),
                                "--add-modules",
                                "java.base,jdk.unsupported",
                                "--strip-debug",
                                "--output",
                                image.toString());
        assumeTrue(linked == 0, () -> "this JDK cannot link an image: " + text);
        Path out = folder.resolve("out.txt");
        Process run =
                new ProcessBuilder(
                                image.resolve("bin").resolve("java").toString(),
                                "-cp",
                                System.getProperty("java.class.path"),
                                Fall.class.getName())
                        .redirectErrorStream(true)
                        .redirectOutput(out.toFile())
                        .start();
        int code = run.waitFor();
        String told = Files.readString(out);
        assertEquals(0, code, told);
        assertEquals("fell " + -0.5 * 9.81, told.strip().lines().reduce((a, b) -> b).orElse(""));
        assertEquals(false, new File(image.toFile(), "lib/libjfr.so").exists());
    }

    /** One tick of a second, timed. */
    static final class Fall {
        private Fall() {}

        public static void main(String[] args) {
            try (PhysicsWorld world = PhysicsWorld.builder().workers(2).build()) {
                world.profile().enable();
                BodyRef box = world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.5)));
                world.step(1);
                System.out.println("fell " + box.position().y);
            }
        }
    }
}
