package dev.cairn.physics.state;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.cairn.core.state.WorldState;
import dev.cairn.physics.Body;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.joint.Joint;
import dev.cairn.physics.mesh.Grounds;
import dev.cairn.physics.shape.Box;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** A state that was written goes on in another virtual machine with the same bits. */
class OtherJvmTest {
    private static final double STEP = 1.0 / 60;
    private static final int TICKS = 100;

    /** What the other machine does: reads a state, steps, prints every digest. */
    public static final class Main {
        private Main() {}

        /**
         * Runs.
         *
         * @param arguments file, workers, lanes
         * @throws IOException if the file cannot be read
         */
        public static void main(String[] arguments) throws IOException {
            PhysicsSettings settings =
                    PhysicsSettings.DEFAULT.withLanes(Integer.parseInt(arguments[2]));
            try (PhysicsWorld world =
                    PhysicsWorld.builder()
                            .settings(settings)
                            .workers(Integer.parseInt(arguments[1]))
                            .build()) {
                world.restore(WorldState.read(Path.of(arguments[0]), PhysicsWorld.codecs()));
                digests(world).forEach(System.out::println);
            }
        }
    }

    private static List<String> digests(PhysicsWorld world) {
        List<String> digests = new ArrayList<>();
        for (int t = 0; t < TICKS; t++) {
            world.step(STEP);
            digests.add(Long.toHexString(world.digest()));
        }
        return digests;
    }

    @Test
    void anotherMachineGoesOnWithTheSameBits(@TempDir Path folder) throws Exception {
        try (PhysicsWorld world = PhysicsWorld.builder().workers(1).build()) {
            Grounds.drop(world, 20, 3);
            BodyRef a = world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.3)).at(0, 8, 0));
            BodyRef b = world.add(Body.dynamic().shape(Box.cubeOfHalfExtent(0.3)).at(1, 8, 0));
            world.add(Joint.hinge(a, b).at(0.5, 8, 0).axis(0, 0, 1));
            for (int t = 0; t < 60; t++) {
                world.step(STEP);
            }
            Path file = folder.resolve("state.cairn");
            world.save().writeTo(file, PhysicsWorld.codecs());
            List<String> here = digests(world);
            for (int[] each : new int[][] {{1, 8}, {2, 1}}) {
                assertEquals(here, elsewhere(folder, file, each[0], each[1]));
            }
        }
    }

    private static List<String> elsewhere(Path folder, Path file, int workers, int lanes)
            throws IOException, InterruptedException {
        Path out = folder.resolve("out.txt");
        Path err = folder.resolve("err.txt");
        Process process =
                new ProcessBuilder(
                                ProcessHandle.current().info().command().orElseThrow(),
                                "--add-modules=jdk.incubator.vector",
                                "-cp",
                                System.getProperty("java.class.path"),
                                Main.class.getName(),
                                file.toString(),
                                Integer.toString(workers),
                                Integer.toString(lanes))
                        .redirectOutput(out.toFile())
                        .redirectError(err.toFile())
                        .start();
        assertEquals(0, process.waitFor(), () -> text(err));
        return Files.readAllLines(out);
    }

    private static String text(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException lost) {
            return lost.toString();
        }
    }
}
