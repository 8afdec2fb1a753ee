package dev.cairn.samples.decompose;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.samples.Main;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneOptions;
import dev.cairn.samples.scenefile.SceneFile;
import dev.cairn.samples.scenefile.SceneFileException;
import dev.cairn.samples.scenefile.SceneLoader;
import dev.cairn.samples.scenefile.SceneReader;
import dev.cairn.samples.scenefile.SceneWriter;

import org.joml.Vector3d;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/** An .obj file becomes a body of convex parts: by the tool, and in a scene file. */
class DecomposeTest {
    /** A U of 7 cubes: outline, extruded along z from 0 to 1. */
    private static final double[][] OUTLINE = {
        {0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}
    };

    @TempDir Path folder;

    private final ByteArrayOutputStream out = new ByteArrayOutputStream();
    private final ByteArrayOutputStream err = new ByteArrayOutputStream();

    @BeforeEach
    void write() throws IOException {
        StringBuilder obj = new StringBuilder();
        for (int z = 0; z < 2; z++) {
            for (double[] p : OUTLINE) {
                obj.append("v %s %s %d%n".formatted(p[0], p[1], z));
            }
        }
        for (int[] f : new int[][] {{1, 2, 5, 6}, {2, 3, 4, 5}, {1, 6, 7, 8}}) {
            obj.append("f %d %d %d %d%n".formatted(f[3], f[2], f[1], f[0]));
            obj.append("f %d %d %d %d%n".formatted(f[0] + 8, f[1] + 8, f[2] + 8, f[3] + 8));
        }
        for (int i = 1; i <= 8; i++) {
            int next = i % 8 + 1;
            obj.append("f %d %d %d %d%n".formatted(i, next, next + 8, i + 8));
        }
        Files.writeString(folder.resolve("u.obj"), obj);
    }

    private int run(String... arguments) {
        return Main.run(
                arguments,
                new PrintStream(out, true, StandardCharsets.UTF_8),
                new PrintStream(err, true, StandardCharsets.UTF_8),
                false);
    }

    private static BodyRef body(PhysicsWorld world, SceneFile scene, Path folder, int index) {
        SampleScene sample = SceneLoader.sample("parts", "parts", folder, scene);
        sample.build(new SceneBuilder(world, SceneOptions.defaults(sample)));
        return world.bodies().get(index);
    }

    private static void assertIsU(BodyRef body, double scale) {
        double volume = 7 * scale * scale * scale;
        assertEquals(3, body.colliders().size());
        assertEquals(1000 * volume, body.mass(), 1e-9 * volume);
        Vector3d centre = body.centreOfMass(new Vector3d()).sub(body.position());
        assertEquals(1.5 * scale, centre.x, 1e-9);
        assertEquals((3 * .5 + 2 * 1.5 + 2 * 2.5) / 7 * scale, centre.y, 1e-9);
        assertEquals(.5 * scale, centre.z, 1e-9);
    }

    @Test
    void theToolWritesABodyOfParts() {
        String file = folder.resolve("u.json").toString();
        String obj = folder.resolve("u.obj").toString();
        assertEquals(0, run("--decompose", obj, "--size", "6", "--out", file), err::toString);
        String told = out.toString(StandardCharsets.UTF_8);
        assertTrue(told.contains("3 parts") && told.contains("56.0000 m3 of 56.0000"), told);
        SceneFile scene = SceneReader.read(Path.of(file));
        assertEquals(5, scene.entities().size(), "ground, body, three parts to look at");
        assertEquals(scene, SceneReader.parse("again", SceneWriter.text(scene)));
        try (PhysicsWorld world = PhysicsWorld.builder().gravity(0, -9.81, 0).build()) {
            BodyRef body = body(world, scene, folder, 1);
            assertIsU(body, 2);
            for (int i = 0; i < 240; i++) {
                world.step(1 / 60.0);
            }
            assertEquals(0, body.position().y, 1e-3, "stands on its base");
        }
        assertEquals(1, run("--decompose", obj, "--parts", "2"), "an error that is too large");
        assertTrue(out.toString(StandardCharsets.UTF_8).contains("more parts"));
    }

    private SceneFile scene(String shape) {
        return SceneReader.parse(
                "inline",
                "{\"format\": \"cairn-scene\", \"version\": 1, \"entities\": [{\"scale\": [2, 2,"
                        + " 2], \"shape\": "
                        + shape
                        + "}]}");
    }

    @Test
    void aSceneFileHasAMeshAsParts() {
        SceneFile scene =
                scene("{\"type\": \"mesh\", \"file\": \"u.obj\", \"as\": \"parts\", \"parts\": 8}");
        assertEquals(scene, SceneReader.parse("again", SceneWriter.text(scene)));
        try (PhysicsWorld world = PhysicsWorld.builder().build()) {
            assertIsU(body(world, scene, folder, 0), 2);
        }
        SceneFileException many =
                assertThrows(
                        SceneFileException.class,
                        () ->
                                scene(
                                        "{\"type\": \"mesh\", \"file\": \"u.obj\", \"as\":"
                                                + " \"parts\", \"error\": 3}"));
        assertTrue(String.valueOf(many.getMessage()).contains("error is 3"), many.getMessage());
    }

    @Test
    void aFlatFileIsAPlaceholderAndTheToolRefusesIt() throws IOException {
        Path flat = folder.resolve("flat.obj");
        Files.writeString(flat, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        try (PhysicsWorld world = PhysicsWorld.builder().build()) {
            SceneFile scene =
                    scene("{\"type\": \"mesh\", \"file\": \"flat.obj\", \"as\": \"parts\"}");
            assertEquals(1, body(world, scene, folder, 0).colliders().size());
        }
        String[] wrong = {flat.toString(), folder.resolve("none.obj").toString()};
        for (String file : wrong) {
            assertEquals(2, run("--decompose", file));
        }
        assertEquals(2, run("--decompose", folder.resolve("u.obj").toString(), "--parts", "0"));
        String told = err.toString(StandardCharsets.UTF_8);
        assertTrue(told.contains("no solid") && told.contains("parts is 0"), told);
    }
}
