package dev.cairn.samples.sandbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.physics.PhysicsWorld;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.SceneBuilder;
import dev.cairn.samples.SceneOptions;
import dev.cairn.samples.SceneRegistry;

import org.junit.jupiter.api.Test;

import java.util.Set;

/** What the panel shows of a tick, without a window. */
class PlotHistoryTest {
    @Test
    void eachSystemOfTheWorldHasItsTime() {
        SampleScene scene = SceneRegistry.get("buoyancy");
        SceneOptions options = SceneOptions.defaults(scene);
        try (PhysicsWorld world =
                PhysicsWorld.builder().workers(1).systems(scene.systems(options)).build()) {
            world.profile().enable();
            scene.build(new SceneBuilder(world, options));
            PlotHistory history = new PlotHistory();
            for (int tick = 0; tick < 3; tick++) {
                world.step(1 / 60.0);
                history.add(world, null, 1);
            }
            PlotHistory shown = new PlotHistory();
            shown.copy(history);
            assertEquals(
                    Set.of("buoyancy, µs", "physics, µs", "wind, µs"), Set.of(shown.systemNames));
            for (int i = 0; i < 3; i++) {
                assertTrue(shown.systemMicros(i) > 0, shown.systemNames[i]);
                assertEquals(history.systemMicros(i), shown.systemMicros(i));
            }
            history.clear();
            assertEquals(0, history.systemNames.length);
        }
    }
}
