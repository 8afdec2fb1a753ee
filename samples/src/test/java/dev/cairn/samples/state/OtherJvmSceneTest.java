package dev.cairn.samples.state;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.time.Recorder;
import dev.cairn.samples.Main;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneOptions;
import dev.cairn.samples.SceneRegistry;
import dev.cairn.samples.replay.Act;
import dev.cairn.samples.replay.Looks;
import dev.cairn.samples.replay.Player;
import dev.cairn.samples.replay.RunFile;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * Scenes that were saved in the middle of a run go on in another process, with other workers and
 * lanes: each tick has the digest that it had here. Large ones for fewer ticks.
 */
class OtherJvmSceneTest {
    private static final int MANY = 150;

    @Test
    void aFewScenesGoOnInAnotherJvm(@TempDir Path folder) throws IOException, InterruptedException {
        goOn(List.of("stack-4", "robot-arm", "buoyancy", "conveyor"), folder);
    }

    @Test
    @Tag("soak")
    void everySceneGoesOnInAnotherJvm(@TempDir Path folder)
            throws IOException, InterruptedException {
        goOn(SceneRegistry.ids(), folder);
    }

    private static void goOn(List<String> ids, Path folder)
            throws IOException, InterruptedException {
        List<String> command = new ArrayList<>();
        command.add(ProcessHandle.current().info().command().orElseThrow());
        command.addAll(List.of("--add-modules=jdk.incubator.vector", "-cp"));
        command.addAll(List.of(System.getProperty("java.class.path"), Elsewhere.class.getName()));
        for (String id : ids) {
            Path file = folder.resolve(id + ".cairn");
            record(id, file);
            command.add(file.toString());
        }
        Path told = folder.resolve("told.txt");
        Process process =
                new ProcessBuilder(command)
                        .redirectErrorStream(true)
                        .redirectOutput(told.toFile())
                        .start();
        int failed = process.waitFor();
        assertEquals(0, failed, failed == 0 ? "" : Files.readString(told));
    }

    /** From tick 50 on, a hundred ticks; the first of a scene of many bodies. */
    private static void record(String id, Path file) throws IOException {
        SampleScene scene = SceneRegistry.get(id);
        SceneOptions options = SceneOptions.defaults(scene);
        try (PhysicsWorld world =
                PhysicsWorld.builder()
                        .gravity(0, -SampleScene.GRAVITY, 0)
                        .workers(1)
                        .sleeping(true)
                        .systems(scene.systems(options))
                        .build()) {
            SceneBuilder built = scene.build(new SceneBuilder(world, options));
            Looks looks = new Looks(world);
            boolean large = world.bodyCount() > MANY;
            for (int tick = 0; tick < (large ? 10 : 50); tick++) {
                built.beforeTick();
                world.step(built.stepSeconds());
                built.afterTick();
            }
            long begin = built.tick();
            Recorder<Act> recorder = new Recorder<>(world, new Player(built), 50);
            for (int tick = 0; tick < (large ? 10 : 100); tick++) {
                if (tick > 0) {
                    recorder.input(Act.AFTER);
                }
                recorder.input(Act.BEFORE);
                recorder.step(built.stepSeconds());
            }
            List<String> arguments = List.of("--scene", id, "--sleeping", "on");
            RunFile.write(file, arguments, "", begin, recorder.recording(), looks);
        }
    }

    /** The other process. */
    static final class Elsewhere {
        private Elsewhere() {}

        /** Replays files; ends with how many came out otherwise. */
        public static void main(String[] files) {
            int failed = 0;
            for (String file : files) {
                String[] arguments = {"--replay", file, "--workers", "2", "--lanes", "4"};
                failed += Main.run(arguments, System.out, System.out, false) == 0 ? 0 : 1;
            }
            System.exit(failed);
        }
    }
}
