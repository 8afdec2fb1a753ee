package dev.cairn.samples.sandbox.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.time.Recorder;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneOptions;
import dev.cairn.samples.replay.Act;
import dev.cairn.samples.replay.Looks;
import dev.cairn.samples.replay.Player;
import dev.cairn.samples.replay.RunFile;
import dev.cairn.samples.sandbox.SandboxProbe;
import dev.cairn.samples.scenes.stack.StackOfBoxes;
import dev.cairn.samples.window.WindowFixture;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/** A window that begins with a saved moment, as {@code samples --from} opens it. */
class FromWindowTest extends WindowFixture {
    private static final int SAVED = 60;
    private static final int LATER = 4000;

    /** By tick since the moment: what the window must show. */
    private final List<String> digests = new ArrayList<>();

    @Override
    public boolean pixels() {
        return false;
    }

    @Override
    public Class<?> program() {
        return SandboxProbe.class;
    }

    @Override
    public boolean ready(Seen seen) {
        return seen.number("tick") >= SAVED;
    }

    /** A stack on which a ball was thrown, in the middle of its fall. */
    @Override
    public void prepare() throws IOException {
        SampleScene scene = StackOfBoxes.scene();
        try (PhysicsWorld world =
                PhysicsWorld.builder()
                        .gravity(0, -SampleScene.GRAVITY, 0)
                        .workers(2)
                        .sleeping(false)
                        .build()) {
            SceneBuilder built = scene.build(new SceneBuilder(world, SceneOptions.defaults(scene)));
            Looks looks = new Looks(world);
            for (int tick = 0; tick < SAVED; tick++) {
                if (tick == 40) {
                    Player.throwBall(world, List.of(9.0, 3.0, 0.0, -6.0, 2.0, 0.0, 0.25, 1e3, 1.0));
                }
                step(world, built);
            }
            Recorder<Act> moment = new Recorder<>(world, new Player(built), 1);
            RunFile.write(
                    folder.resolve(SandboxProbe.MOMENT),
                    List.of("--scene", scene.id(), "--sleeping", "off"),
                    "",
                    built.tick(),
                    moment.recording(),
                    looks);
            for (int tick = 0; tick < LATER; tick++) {
                digests.add("%016x".formatted(world.digest()));
                step(world, built);
            }
        }
    }

    private static void step(PhysicsWorld world, SceneBuilder built) {
        built.beforeTick();
        world.step(built.stepSeconds());
        built.afterTick();
    }

    private void isTheRun(Seen seen) {
        int tick = (int) seen.number("digestTick");
        if (tick > SAVED && tick < SAVED + LATER) {
            assertEquals(digests.get(tick - SAVED), seen.values().get("digest"), "tick " + tick);
        }
    }

    /**
     * It goes on tick by tick as the run did, with the ball; a restart is the scene's beginning.
     */
    @Test
    void theWindowGoesOnFromTheMoment() throws IOException, InterruptedException {
        Seen first = now();
        assertEquals(6, first.number("bodies"), "five of the scene and the ball: " + last);
        assertTrue(first.number("oldest") >= SAVED, "the past begins there: " + last);
        await(
                "100 ticks",
                seen -> {
                    isTheRun(seen);
                    return seen.number("digestTick") > SAVED + 100;
                });
        // back into what was seen since, and on again
        type("key", "comma");
        await("the pause", seen -> seen.flag("paused"));
        settle();
        Seen paused = now();
        type("key", "comma");
        await("a tick back", seen -> seen.number("tick") < paused.number("tick"));
        type("key", "space");
        await(
                "more ticks",
                seen -> {
                    isTheRun(seen);
                    return seen.number("digestTick") > paused.number("newest") + 20;
                });
        assertEquals(0, now().number("otherAgain"), last);
        type("key", "r");
        await("the scene's own beginning", seen -> seen.number("tick") < SAVED);
        assertEquals(5, now().number("bodies"), last);
    }
}
