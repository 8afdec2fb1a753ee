package dev.cairn.samples.state;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.snapshot.Visual;
import dev.cairn.physics.BodyRef;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.time.Recorder;
import dev.cairn.render.mesh.Model;
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
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;

/** A moment of a scene that was written to a file goes on elsewhere as it went on here. */
@Tag("compiled")
class MomentFileTest {
    private static final int MANY = 150;

    @TempDir Path folder;

    static List<String> ids() {
        return SceneRegistry.ids();
    }

    /** Looks of each kind, joints, levels, systems, hooks, conveyors, things that come and go. */
    static List<String> few() {
        return List.of(
                "shapes",
                "one-way",
                "conveyor",
                "robot-arm",
                "terrain",
                "load-removal",
                "buoyancy");
    }

    private static PhysicsWorld world(SampleScene scene, int workers, int lanes) {
        return PhysicsWorld.builder()
                .settings(PhysicsSettings.DEFAULT.withLanes(lanes))
                .gravity(0, -SampleScene.GRAVITY, 0)
                .workers(workers)
                .sleeping(false)
                .systems(scene.systems(SceneOptions.defaults(scene)))
                .build();
    }

    private static void ticks(PhysicsWorld world, SceneBuilder built, int count) {
        for (int i = 0; i < count; i++) {
            built.beforeTick();
            world.step(built.stepSeconds());
            built.afterTick();
        }
    }

    private static RunFile written(
            Path file, String id, PhysicsWorld world, SceneBuilder built, Looks looks)
            throws IOException {
        Recorder<Act> moment = new Recorder<>(world, new Player(built), 1);
        List<String> arguments = List.of("--scene", id, "--sleeping", "off");
        RunFile.write(file, arguments, "", built.tick(), moment.recording(), looks);
        return RunFile.open(file);
    }

    @ParameterizedTest
    @MethodSource("few")
    void aSceneGoesOnFromTheFileInAnotherWorld(String id) throws IOException {
        goesOn(id);
    }

    @ParameterizedTest
    @Tag("soak")
    @MethodSource("ids")
    void everySceneGoesOnFromTheFileInAnotherWorld(String id) throws IOException {
        goesOn(id);
    }

    /** With the scene's own hooks, which count on from the tick in the file. */
    private void goesOn(String id) throws IOException {
        SampleScene scene = SceneRegistry.get(id);
        SceneOptions options = SceneOptions.defaults(scene);
        try (PhysicsWorld world = world(scene, 1, 1);
                PhysicsWorld other = world(scene, 2, 4)) {
            SceneBuilder built = scene.build(new SceneBuilder(world, options));
            Looks looks = new Looks(world);
            int before = world.bodyCount() > MANY ? 4 : 45;
            int after = world.bodyCount() > MANY ? 4 : 60;
            ticks(world, built, before);
            RunFile file = written(folder.resolve("moment.cairn"), id, world, built, looks);
            SceneBuilder again = scene.build(new SceneBuilder(other, options));
            file.putBack(other, again);
            assertEquals(before, again.tick());
            assertEquals(world.digest(), other.digest(), "as it is read");
            for (BodyRef body : world.bodies()) {
                sameLook(world, other, body);
            }
            ticks(world, built, after);
            ticks(other, again, after);
            assertEquals(world.digest(), other.digest(), after + " ticks later");
        }
    }

    /** Meshes and textures are those of the scene that was built, or the placeholder's. */
    private static void sameLook(PhysicsWorld world, PhysicsWorld other, BodyRef body) {
        long entity = body.entity();
        if (world.ecs().has(entity, Visual.COMPONENT)
                && world.ecs().get(entity, Visual.COMPONENT).model() instanceof Model model) {
            Model read = (Model) other.ecs().get(entity, Visual.COMPONENT).model();
            assertEquals(model.rgb(), read.rgb());
            assertEquals(model.scaleX(), read.scaleX());
        }
    }

    @Test
    void theCommandLineGoesOnFromAFile() throws IOException {
        SampleScene scene = SceneRegistry.get("stack-4");
        Path file = folder.resolve("moment.cairn");
        String digest;
        try (PhysicsWorld world = world(scene, 1, 1)) {
            SceneBuilder built = scene.build(new SceneBuilder(world, SceneOptions.defaults(scene)));
            Looks looks = new Looks(world);
            ticks(world, built, 50);
            // What the user threw comes along, with its looks.
            Player.throwBall(world, List.of(3.0, 1.0, 0.0, -9.0, 0.0, 0.0, 0.25, 1000.0, 1.0));
            written(file, "stack-4", world, built, looks);
            ticks(world, built, 100);
            digest = "%016x".formatted(world.digest());
        }
        String json = run(0, "--from", file.toString(), "--ticks", "100", "--json", "-");
        assertTrue(json.contains(digest), digest + " in " + json);
        String other = run(2, "--from", file.toString(), "--scene", "pyramid");
        assertTrue(other.contains("the file says which scene it is"), other);
    }

    @Test
    void damagedFilesAreRefusedWithAReason() throws IOException {
        SampleScene scene = SceneRegistry.get("stack-4");
        Path file = folder.resolve("moment.cairn");
        try (PhysicsWorld world = world(scene, 1, 1)) {
            SceneBuilder built = scene.build(new SceneBuilder(world, SceneOptions.defaults(scene)));
            written(file, "stack-4", world, built, new Looks(world));
        }
        byte[] whole = Files.readAllBytes(file);
        for (int at = 0; at < whole.length; at += 1 + whole.length / 25) {
            byte[] bad = whole.clone();
            bad[at] ^= 4;
            Files.write(file, bad);
            String told = run(2, "--from", file.toString(), "--ticks", "1");
            assertTrue(told.contains("moment.cairn: "), "byte " + at + ": " + told);
        }
        Files.write(file, Arrays.copyOf(whole, whole.length - 3));
        assertTrue(run(2, "--from", file.toString(), "--ticks", "1").contains("ends after"));
        Files.writeString(file, "text");
        assertTrue(run(2, "--from", file.toString()).contains("no bytes of a recorded run"));
        assertTrue(run(2, "--from", folder.resolve("none").toString()).contains("cannot be read"));
    }

    private static String run(int code, String... arguments) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        PrintStream both = new PrintStream(out, true, StandardCharsets.UTF_8);
        int seen = Main.run(arguments, both, both, false);
        String text = out.toString(StandardCharsets.UTF_8);
        assertEquals(code, seen, text);
        return text;
    }
}
