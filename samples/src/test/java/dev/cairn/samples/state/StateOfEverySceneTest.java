package dev.cairn.samples.state;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.cairn.core.state.WorldState;
import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneOptions;
import dev.cairn.samples.SceneRegistry;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.List;

/**
 * Every scene goes on from a saved state with the same bits: in the same world, and in another one
 * of other workers and lanes, which has seen nothing of it.
 */
@Tag("compiled")
class StateOfEverySceneTest {
    private static final double STEP = SampleScene.STEP_SECONDS;

    static List<String> ids() {
        return SceneRegistry.ids();
    }

    private static PhysicsWorld world(SampleScene scene, int workers, int lanes) {
        return PhysicsWorld.builder()
                .systems(scene.systems(SceneOptions.defaults(scene)))
                .settings(PhysicsSettings.DEFAULT.withLanes(lanes))
                .gravity(0, -SampleScene.GRAVITY, 0)
                .workers(workers)
                .build();
    }

    @ParameterizedTest
    @MethodSource("ids")
    void aRestoredWorldGoesOnWithTheSameBits(String id) {
        goesOn(id, false);
    }

    /** As long as the promise is: a hundred ticks from ticks 0, 1, 50 and 200. */
    @ParameterizedTest
    @Tag("soak")
    @MethodSource("ids")
    void aRestoredWorldGoesOnForAHundredTicks(String id) {
        goesOn(id, true);
    }

    private static void goesOn(String id, boolean whole) {
        SampleScene scene = SceneRegistry.get(id);
        try (PhysicsWorld world = world(scene, 1, 1)) {
            SceneBuilder built = scene.build(new SceneBuilder(world, SceneOptions.defaults(scene)));
            boolean large = !whole && world.bodyCount() > 150;
            int[] marks = large ? new int[] {0, 1, 12} : new int[] {0, 1, 50, 200};
            int ticks = whole ? 100 : large ? 4 : 40;
            WorldState state = new WorldState();
            for (int mark : marks) {
                while (world.ecs().tickNumber() < mark) {
                    built.beforeTick();
                    world.step(STEP);
                    built.afterTick();
                }
                check(id, world, world.save(state), ticks);
            }
        }
    }

    /** The world is where it was afterwards. */
    private static void check(String id, PhysicsWorld world, WorldState state, int ticks) {
        String where = id + " saved at tick " + world.ecs().tickNumber() + ", tick +";
        long[] digests = new long[ticks + 1];
        long[] entities = new long[ticks + 1];
        for (int t = 0; t <= ticks; t++) {
            digests[t] = world.digest();
            entities[t] = world.ecs().digest();
            world.step(STEP);
        }
        world.restore(state);
        for (int t = 0; t <= ticks; t++) {
            assertEquals(digests[t], world.digest(), where + t + ", same world");
            assertEquals(entities[t], world.ecs().digest(), where + t + ", same world's entities");
            world.step(STEP);
        }
        // a contact hook is a function, which a state does not hold: a fork has it from its world
        boolean hasHook = id.equals("one-way");
        try (PhysicsWorld other = hasHook ? world.fork() : world(SceneRegistry.get(id), 2, 4)) {
            other.restore(state);
            for (int t = 0; t <= ticks; t++) {
                assertEquals(digests[t], other.digest(), where + t + ", new world");
                assertEquals(entities[t], other.ecs().digest(), where + t + ", new entities");
                other.step(STEP);
            }
        }
        world.restore(state);
    }
}
