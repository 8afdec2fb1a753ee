package dev.cairn.samples.state;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.time.Recorder;
import dev.cairn.samples.Main;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneOptions;
import dev.cairn.samples.replay.Act;
import dev.cairn.samples.replay.Looks;
import dev.cairn.samples.replay.Player;
import dev.cairn.samples.replay.RunFile;
import dev.cairn.samples.scenefile.SceneFile;
import dev.cairn.samples.scenefile.SceneLoader;
import dev.cairn.samples.scenefile.SceneReader;
import dev.cairn.samples.scenefile.SceneWriter;
import dev.cairn.samples.scenefile.Xyz;
import dev.cairn.samples.scenefile.edit.SceneEdit;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** A scene file that begins with a saved moment goes on from there, and tells what does not fit. */
class SceneStateTest {
    private static final int BEFORE = 40;
    private static final int AFTER = 50;
    private static final String TEXT =
            """
            {"format": "cairn-scene", "version": 1, "name": "three", "entities": [
              {"name": "floor", "body": "fixed", "shape": {"type": "box", "halfExtents": [9, 0.5, 9]},
               "position": [0, -0.5, 0]},
              {"name": "low", "shape": {"type": "box", "halfExtents": [0.5, 0.5, 0.5]},
               "position": [0, 0.6, 0]},
              {"name": "high", "shape": {"type": "box", "halfExtents": [0.4, 0.4, 0.4]},
               "position": [0.2, 2, 0.1]},
              {"name": "ball", "shape": {"type": "sphere", "radius": 0.3},
               "position": [-4, 1, 0], "velocity": [6, 0, 0]}
            ]}
            """;

    @TempDir Path folder;
    private SceneFile scene;

    @BeforeEach
    void saveAMoment() throws IOException {
        scene = SceneReader.parse("three.json", TEXT);
        moment("moment.cairn", SceneWriter.text(scene), List.of("--sleeping", "off"));
    }

    /** What key M writes after {@link #BEFORE} ticks, with a ball that was thrown meanwhile. */
    private void moment(String name, String text, List<String> arguments) throws IOException {
        SampleScene sample = SceneLoader.sample(folder.resolve("three.json"), scene);
        try (PhysicsWorld world = PhysicsWorld.builder().sleeping(false).build()) {
            SceneBuilder built =
                    sample.build(new SceneBuilder(world, SceneOptions.defaults(sample)));
            Looks looks = new Looks(world);
            for (int tick = 0; tick < BEFORE; tick++) {
                if (tick == 10) {
                    Player.throwBall(world, List.of(0.1, 6.0, 0.0, 0.0, -9.0, 0.0, 0.2, 2e3, 1.0));
                }
                world.step(built.stepSeconds());
                built.afterTick();
            }
            Recorder<Act> moment = new Recorder<>(world, (any, act) -> {}, 1);
            RunFile.write(folder.resolve(name), arguments, text, BEFORE, moment.recording(), looks);
        }
    }

    private Path written(SceneFile value) {
        Path file = folder.resolve("begun.json");
        SceneWriter.write(value, file);
        return file;
    }

    private static String run(int code, String... arguments) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        PrintStream both = new PrintStream(out, true, StandardCharsets.UTF_8);
        int seen = Main.run(arguments, both, both, false);
        String text = out.toString(StandardCharsets.UTF_8);
        assertEquals(code, seen, text);
        return text;
    }

    private static String digest(String... arguments) {
        List<String> all = new ArrayList<>(List.of(arguments));
        all.addAll(List.of("--ticks", Integer.toString(AFTER), "--json", "-"));
        String told = run(0, all.toArray(new String[0]));
        Matcher digest = Pattern.compile("\"digest\": *\"([0-9a-f]+)\"").matcher(told);
        assertTrue(digest.find(), told);
        return digest.group(1);
    }

    /** As the moment itself goes on, which holds its scene; with any workers and lanes. */
    @Test
    void itGoesOnFromTheMoment() {
        String file = written(scene.withState("moment.cairn")).toString();
        String other = digest("--from", folder.resolve("moment.cairn").toString());
        assertEquals(other, digest("--scene-file", file, "--workers", "1", "--lanes", "1"));
        assertEquals(other, digest("--scene-file", file, "--workers", "2", "--lanes", "4"));
        assertTrue(!other.equals(digest("--scene-file", written(scene).toString())), other);
    }

    /** A run of a scene file holds the scene: the file may be gone, or be another one by then. */
    @Test
    void aRunOfASceneFileIsWrittenDownAndComesAgain() throws IOException {
        for (String state : new String[] {null, "moment.cairn"}) {
            Path file = written(scene.withState(state));
            String run = folder.resolve("run.cairn").toString();
            String[] record = {"--scene-file", file.toString(), "--ticks", "90", "--record", run};
            String told = run(0, record);
            Matcher digest = Pattern.compile("digest ([0-9a-f]{16})").matcher(told);
            assertTrue(digest.find(), told);
            Files.delete(file);
            String again = run(0, "--replay", run, "--workers", "2", "--lanes", "4");
            assertTrue(again.contains("the last " + digest.group(1)), told + again);
            assertTrue(again.contains(state == null ? "from tick 0" : "from tick 40"), again);
        }
    }

    @Test
    void theStateStaysWhereTheSceneIsWrittenEditedAndMoved() {
        SceneFile begun = scene.withState("states/moment.cairn");
        assertEquals(begun, SceneReader.parse("again", SceneWriter.text(begun)));
        SceneFile edited =
                SceneEdit.change(
                        begun, 1, entity -> entity.at(new Xyz(1, 2, 3), entity.rotation()));
        edited = SceneEdit.delete(edited, 2).withCamera(SceneFile.CameraSpec.DEFAULT);
        assertEquals("states/moment.cairn", edited.withLayers(List.of("one")).state());
        SceneFile moved = SceneEdit.rebase(begun, folder, folder.resolve("deep"));
        assertEquals("../states/moment.cairn", moved.state());
    }

    /** It begins as it was saved, and says so. */
    @Test
    void aSceneThatWasEditedSinceIsTold() {
        SceneFile more = SceneEdit.duplicate(scene, 3, new Xyz(0, 3, 0));
        Path file = written(more.withState("moment.cairn"));
        String told = run(0, "--scene-file", file.toString(), "--ticks", "1");
        assertTrue(told.contains("was edited since moment.cairn was saved"), told);
    }

    @Test
    void whatIsNoMomentOfASceneFileIsRefusedWithAReason() throws IOException {
        moment("list.cairn", "", List.of("--scene", "pyramid"));
        refused("list.cairn", "is a moment of --scene pyramid");
        refused("none.cairn", "$.state: \"none.cairn\" cannot be read (NoSuchFileException)");
        refused("../moment.cairn", "outside of both");
        Files.writeString(folder.resolve("text.cairn"), "text");
        refused("text.cairn", "no bytes of a recorded run");
        byte[] whole = Files.readAllBytes(folder.resolve("moment.cairn"));
        for (int at = 0; at < whole.length; at += 1 + whole.length / 20) {
            byte[] bad = whole.clone();
            bad[at] ^= 4;
            Files.write(folder.resolve("bad.cairn"), bad);
            refused("bad.cairn", "$.state: ");
        }
        refused("moment.txt", "ends in .cairn");
    }

    private void refused(String state, String reason) {
        String told =
                run(2, "--scene-file", written(scene.withState(state)).toString(), "--ticks", "1");
        assertTrue(told.contains(reason), state + ": " + told);
    }
}
