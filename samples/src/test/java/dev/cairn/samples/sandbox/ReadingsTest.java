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

/**
 * What the panels show of a tick, without a window: numbers that run can be read, and one that has
 * come to rest is the true one.
 */
class ReadingsTest {
    private static final long FRAME_NANOS = 16_666_667;

    private final Readings readings = new Readings();
    private final SandboxState state = new SandboxState();
    private long nanos;

    private void frame(boolean stands) {
        nanos += FRAME_NANOS;
        readings.read(state, 60, stands, nanos);
    }

    @Test
    void tenTimesASecondWhileItRuns() {
        frame(false);
        int changes = 0;
        for (int i = 0; i < 600; i++) {
            long before = readings.tick;
            state.tick++;
            frame(false);
            changes += readings.tick == before ? 0 : 1;
            assertTrue(state.tick - readings.tick <= 6, "never older than a tenth of a second");
        }
        assertEquals(100, changes, "in ten seconds");
    }

    @Test
    void atOnceWhereItStandsGoesBackOrIsAnother() {
        state.tick = 7;
        frame(false);
        state.tick = 8;
        frame(true);
        assertEquals(8, readings.tick, "it stands");
        state.tick = 3;
        frame(false);
        assertEquals(3, readings.tick, "it went back");
        state.scene = 2;
        state.tick = 4;
        frame(false);
        assertEquals(4, readings.tick, "another scene");
        state.held = "a ball";
        state.heldSpeed = 5;
        frame(false);
        assertEquals(5, readings.heldSpeed, "another body is held");
    }

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
