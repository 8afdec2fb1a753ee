package dev.cairn.system;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.gson.JsonParser;

import dev.cairn.core.job.Jobs;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.tuning.Precision;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneOptions;
import dev.cairn.samples.SceneRegistry;
import dev.cairn.samples.SceneReport;
import dev.cairn.samples.SceneRun;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/**
 * The first promise: the same bits for any number of workers, any schedule, any JVM run, compiled
 * or not.
 */
final class DeterminismTest {
    private static final int MAX_WORKERS = 4;
    private static final double SECONDS = 2;
    private static final int PERTURBED_SEEDS = 5;

    static List<String> scenes() {
        return SceneRegistry.ids();
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void anyNumberOfWorkersGivesTheSameBits(String id) {
        String alone = digest(id, 1);

        // which number is the scene's: together they are all of 2 to 4
        int workers = 2 + Math.floorMod(id.hashCode(), MAX_WORKERS - 1);
        assertEquals(alone, digest(id, workers), () -> workers + " workers");
    }

    private static String digest(String id, int workers) {
        SampleScene scene = SceneRegistry.get(id);
        SceneOptions options = SceneOptions.defaults(scene);
        int ticks = Scenes.ticks(SECONDS);
        return Scenes.digest(
                scene, options, new SceneRun(scene, options, ticks, workers, 4), ticks);
    }

    @Test
    void aPerturbedScheduleGivesTheSameBitsInEveryTick() {
        List<Long> alone = digests(Jobs.of(1));
        for (int seed = 1; seed <= PERTURBED_SEEDS; seed++) {
            assertEquals(alone, digests(Jobs.perturbed(3, seed)), "perturber's seed " + seed);
        }
    }

    private static List<Long> digests(Jobs jobs) {
        SampleScene scene = SceneRegistry.get("pyramid");
        SceneOptions options =
                SceneOptions.of(scene, Map.of("base", "8"), SceneOptions.DEFAULT_SEED, null);
        List<Long> digests = new ArrayList<>();
        try (jobs;
                PhysicsWorld world = PhysicsWorld.builder().sleeping(false).jobs(jobs).build()) {
            SceneBuilder built = scene.build(new SceneBuilder(world, options));
            for (int tick = 0; tick < 60; tick++) {
                built.beforeTick();
                world.step(SampleScene.STEP_SECONDS);
                built.afterTick();
                digests.add(world.digest());
            }
        }
        return digests;
    }

    @Test
    void anotherRunOfTheJvmAndTheInterpreterGiveTheSameBits(@TempDir Path directory)
            throws IOException, InterruptedException {
        List<String> run =
                List.of(
                        "--headless",
                        "--scene",
                        "room",
                        "--ticks",
                        "120",
                        "--workers",
                        "2",
                        "--json",
                        "-");

        String compiled = digestOf(Jvm.samples(directory, List.of(), run));
        String again = digestOf(Jvm.samples(directory, List.of(), run));
        String interpreted = digestOf(Jvm.samples(directory, List.of("-Xint"), run));

        assertEquals(compiled, again);
        assertEquals(compiled, interpreted);
        assertEquals(Scenes.run("room", 2, 1, Map.of()).digest(), compiled);
    }

    /** The lanes are this JVM's: each JVM compiles their kernels for half a minute. */
    @Tag("compiled")
    @Test
    void withoutTheVectorModuleTheBitsAreTheSame(@TempDir Path directory)
            throws IOException, InterruptedException {
        SampleScene scene = SceneRegistry.get("pyramid");
        SceneOptions options =
                SceneOptions.of(scene, Map.of("base", "16"), SceneOptions.DEFAULT_SEED, null);
        SceneReport wide = new SceneRun(scene, options, 60, 1, 4).lanes(8).run(() -> {});
        // a module graph without the vectors' module
        String plain =
                Jvm.samples(
                        directory,
                        List.of(
                                "-XX:TieredStopAtLevel=1",
                                "--limit-modules=java.se,jdk.unsupported,jdk.management,jdk.jfr"),
                        List.of(
                                "--headless",
                                "--scene",
                                "pyramid",
                                "--set",
                                "base=16",
                                "--ticks",
                                "60",
                                "--lanes",
                                "8",
                                "--json",
                                "-"));

        assertEquals(8, wide.lanes());
        assertEquals(1, lanesOf(plain));
        assertEquals(wide.digest(), digestOf(plain));
    }

    private static int lanesOf(String json) {
        return JsonParser.parseString(json).getAsJsonObject().get("lanes").getAsInt();
    }

    @Tag("compiled")
    @ParameterizedTest
    @ValueSource(strings = {"pyramid", "room", "pile", "arch"})
    void anyNumberOfLanesGivesTheSameBits(String id) {
        SampleScene scene = SceneRegistry.get(id);
        SceneOptions options = SceneOptions.defaults(scene);
        String alone = null;
        for (int lanes : new int[] {1, 4, 8, 16}) {
            int most = lanes == 16 ? 1 : MAX_WORKERS;
            for (int workers = 1; workers <= most; workers += MAX_WORKERS - 1) {
                SceneRun run = new SceneRun(scene, options, 40, workers, 4).lanes(lanes);
                String digest = Scenes.digest(scene, options, run, 40);
                alone = alone == null ? digest : alone;
                assertEquals(alone, digest, lanes + " lanes, " + workers + " workers");
            }
        }
    }

    /** A few ticks of every scene, then more of those that shake the most. */
    @Tag("compiled")
    @ParameterizedTest
    @MethodSource("scenes")
    void inSinglePrecisionToo(String id) {
        boolean shakes = List.of("pyramid", "room", "arch", "bounce").contains(id);
        SampleScene scene = SceneRegistry.get(id);
        SceneOptions options = SceneOptions.defaults(scene);
        int ticks = shakes ? 60 : 10;
        String alone = null;
        for (int[] each : new int[][] {{1, 1}, {4, 2}, {8, 3}}) {
            int lanes = each[0];
            int workers = each[1];
            SceneRun run =
                    new SceneRun(scene, options, ticks, workers, 4)
                            .lanes(lanes)
                            .precision(Precision.SINGLE);
            String digest = Scenes.digest(scene, options, run, ticks);
            alone = alone == null ? digest : alone;
            assertEquals(alone, digest, lanes + " lanes, " + workers + " workers");
        }
    }

    private static String digestOf(String json) {
        String digest = JsonParser.parseString(json).getAsJsonObject().get("digest").getAsString();
        assertTrue(digest.matches("[0-9a-f]{16}"), digest);
        return digest;
    }
}
