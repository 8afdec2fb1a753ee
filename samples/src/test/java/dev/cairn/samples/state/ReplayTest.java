package dev.cairn.samples.state;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.time.Recorder;
import dev.cairn.physics.time.Recording;
import dev.cairn.samples.Main;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneOptions;
import dev.cairn.samples.SceneRegistry;
import dev.cairn.samples.replay.Act;
import dev.cairn.samples.replay.Act.What;
import dev.cairn.samples.replay.Looks;
import dev.cairn.samples.replay.Player;
import dev.cairn.samples.replay.RunFile;
import dev.cairn.samples.time.AimedShot;
import dev.cairn.samples.time.TwoPeers;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** Runs that are written down come again; games over a network and aimed shots are the truth. */
class ReplayTest {
    private final ByteArrayOutputStream out = new ByteArrayOutputStream();
    private final ByteArrayOutputStream err = new ByteArrayOutputStream();

    private int run(String... arguments) {
        out.reset();
        err.reset();
        return Main.run(
                arguments,
                new PrintStream(out, true, StandardCharsets.UTF_8),
                new PrintStream(err, true, StandardCharsets.UTF_8),
                false);
    }

    private static PhysicsWorld world() {
        return PhysicsWorld.builder().gravity(0, -SampleScene.GRAVITY, 0).sleeping(false).build();
    }

    @Test
    void aRunComesAgainWithOtherWorkersAndLanes(@TempDir Path folder) {
        String file = folder.resolve("run.cairn").toString();
        assertEquals(
                0,
                run(
                        "--scene",
                        "pyramid",
                        "--set",
                        "base=4",
                        "--ticks",
                        "40",
                        "--record",
                        file,
                        "--workers",
                        "2"),
                err::toString);
        assertEquals(0, run("--replay", file, "--workers", "1", "--lanes", "1"), err::toString);
        assertTrue(out.toString().contains("40 ticks from tick 0 on, all with"), out.toString());
    }

    @Test
    void theFirstTickThatDiffersIsToldAndInWhat(@TempDir Path folder) throws IOException {
        Path file = folder.resolve("run.cairn");
        SampleScene scene = SceneRegistry.get("stack-4");
        try (PhysicsWorld world = world()) {
            SceneBuilder built = scene.build(new SceneBuilder(world, SceneOptions.defaults(scene)));
            Looks looks = new Looks(world);
            Recorder<Act> recorder = new Recorder<>(world, new Player(built), 1);
            for (int tick = 0; tick < 20; tick++) {
                recorder.input(Act.BEFORE);
                if (tick == 7) {
                    // Nobody writes this down.
                    built.bodies().get(2).applyImpulse(0, 1e-9, 0);
                }
                recorder.step(built.stepSeconds());
            }
            List<String> arguments = List.of("--scene", "stack-4", "--sleeping", "off");
            RunFile.write(file, arguments, "", 0, recorder.recording(), looks);
        }
        assertEquals(1, run("--replay", file.toString()));
        String told = err.toString();
        assertTrue(told.contains("tick 8 is the first that differs; at tick 8 "), told);
        assertTrue(told.contains("the first column is bodies."), told);
    }

    /** From a moment in the middle, with a hand, a ball and other sub-steps. */
    @Test
    void whatAUserDidComesAgain(@TempDir Path folder) throws IOException {
        Path file = folder.resolve("report.cairn");
        SampleScene scene = SceneRegistry.get("stack-4");
        try (PhysicsWorld world = world()) {
            SceneBuilder built = scene.build(new SceneBuilder(world, SceneOptions.defaults(scene)));
            Looks looks = new Looks(world);
            for (int tick = 0; tick < 50; tick++) {
                built.beforeTick();
                world.step(built.stepSeconds());
                built.afterTick();
            }
            Recorder<Act> recorder = new Recorder<>(world, new Player(built), 60);
            Vector3d top = built.bodies().get(4).position(new Vector3d());
            List<Double> point = List.of(top.x + 0.1, top.y, top.z);
            recorder.input(new Act(What.GRAB, built.bodies().get(4).entity(), point));
            for (int tick = 0; tick < 120; tick++) {
                if (tick == 20) {
                    List<Double> ball = List.of(5.0, 1.0, 0.0, -9.0, 0.0, 0.0, 0.25, 1000.0, 1.0);
                    recorder.input(new Act(What.THROW, 0, ball));
                    recorder.input(new Act(What.SUBSTEPS, 0, List.of(6.0)));
                } else if (tick == 80) {
                    recorder.input(new Act(What.RELEASE, 0, List.of()));
                }
                recorder.input(Act.BEFORE);
                List<Double> to = List.of(top.x + 0.02 * tick, top.y + 0.5, top.z);
                recorder.input(new Act(What.PULL, 0, to));
                recorder.step(built.stepSeconds());
            }
            List<String> arguments = List.of("--scene", "stack-4", "--sleeping", "off");
            RunFile.write(file, arguments, "", 50, recorder.recording(), looks);
            for (String workers : new String[] {"1", "2"}) {
                String[] again = {"--replay", file.toString(), "--workers", workers};
                assertEquals(0, run(again), err::toString);
                String told = out.toString();
                assertTrue(told.contains("120 ticks from tick 50 on, all with"), told);
                assertTrue(told.contains("%016x".formatted(world.digest())), told);
            }
        }
    }

    @Test
    void whatIsNoRecordingIsRefused(@TempDir Path folder) throws IOException {
        Path file = folder.resolve("run.cairn");
        assertEquals(2, run("--replay", file.toString()));
        Files.writeString(file, "text");
        assertEquals(2, run("--replay", file.toString()));
        assertTrue(err.toString().contains("no bytes of a recorded run"), err.toString());
        run("--scene", "stack-4", "--ticks", "5", "--record", file.toString());
        byte[] whole = Files.readAllBytes(file);
        for (int at = 12; at < whole.length; at += 1 + whole.length / 25) {
            byte[] bad = whole.clone();
            bad[at] ^= 4;
            Files.write(file, bad);
            assertEquals(2, run("--replay", file.toString()), "byte " + at);
            assertTrue(err.toString().contains("run.cairn: "), err.toString());
        }
        try (PhysicsWorld world = PhysicsWorld.builder().build()) {
            Recording<Act> none = new Recorder<Act>(world, (any, act) -> {}, 1).recording();
            RunFile.write(file, List.of("--picture", "x.png"), "", 0, none, new Looks(world));
        }
        assertEquals(2, run("--replay", file.toString()));
        assertTrue(err.toString().contains("--picture"), err.toString());
        assertEquals(2, run("--replay", file.toString(), "--scene", "pyramid"));
        assertEquals(2, run("--record", file.toString()), "all scenes are not one");
    }

    @Test
    void twoPeersEndInTheWorldOfARunWithoutANetwork() {
        TwoPeers.Result result = TwoPeers.play(200, 4);
        assertEquals(List.of(result.truth(), result.truth()), result.digests());
        assertTrue(result.lost() > 10 && result.ticksAgain().get(0) > 50, result.toString());
    }

    @Test
    void anAimedShotComesOutAsInItsFork() {
        AimedShot.Shot[] best = new AimedShot.Shot[2];
        for (int workers = 1; workers <= 2; workers++) {
            try (var table = AimedShot.table(workers)) {
                best[workers - 1] = AimedShot.aim(table, 24);
                assertEquals(
                        best[workers - 1], AimedShot.play(table, best[workers - 1].number(), 24));
            }
        }
        assertEquals(best[0], best[1]);
    }
}
