package dev.cairn.samples.state;

import static org.junit.jupiter.api.Assertions.assertNull;

import dev.cairn.core.state.StateDelta;
import dev.cairn.core.state.WorldState;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneOptions;
import dev.cairn.samples.SceneRegistry;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.List;

/**
 * What deltas predict is not always so: of hulls, meshes, compounds, joints, belts and kinematic
 * bodies each bit comes back all the same, from tick to tick and over many.
 */
class DeltaOfEverySceneTest {
    static List<String> ids() {
        return SceneRegistry.ids();
    }

    @ParameterizedTest
    @MethodSource("ids")
    void deltasLeadForthAndBack(String id) {
        SampleScene scene = SceneRegistry.get(id);
        try (PhysicsWorld world =
                PhysicsWorld.builder()
                        .systems(scene.systems(SceneOptions.defaults(scene)))
                        .gravity(0, -SampleScene.GRAVITY, 0)
                        .workers(1)
                        .build()) {
            SceneBuilder built = scene.build(new SceneBuilder(world, SceneOptions.defaults(scene)));
            WorldState first = world.save();
            WorldState before = world.save();
            WorldState after = new WorldState();
            WorldState moved = new WorldState();
            int ticks = world.bodyCount() > 150 ? 3 : 16;
            for (int t = 0; t < ticks; t++) {
                built.beforeTick();
                world.step(SampleScene.STEP_SECONDS);
                built.afterTick();
                world.save(after);
                check(id + ", tick " + t, before, after, moved);
                check(id + ", ticks 0 to " + t, first, after, moved);
                WorldState last = before;
                before = after;
                after = last;
            }
        }
    }

    private static void check(String where, WorldState a, WorldState b, WorldState moved) {
        StateDelta delta = StateDelta.between(a, b);
        moved.set(a);
        delta.apply(moved);
        assertNull(moved.difference(b), where + ", forth");
        delta.revert(moved);
        assertNull(moved.difference(a), where + ", back");
    }
}
