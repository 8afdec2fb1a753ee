package dev.cairn.samples.sandbox;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.cairn.physics.PhysicsSettings;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.physics.tuning.Precision;
import dev.cairn.samples.SampleScene;
import dev.cairn.samples.scenes.stack.StackOfBoxes;

import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Map;

/** A window's world has the settings that were asked for; no window is opened for it. */
final class SandboxSettingsTest {
    @Test
    void theWorldHasThem() {
        SampleScene scene = StackOfBoxes.scene();
        Sandbox window = new Sandbox(List.of(scene), Map.of(), 1, 7, false, System.err);
        window.settings(PhysicsSettings.DEFAULT.withLanes(1).withPrecision(Precision.SINGLE));
        try (PhysicsWorld world = window.createPhysics()) {
            assertEquals(1, world.settings().lanes());
            assertEquals(Precision.SINGLE, world.settings().precision());
            assertEquals(7, world.settings().substeps());
        }
    }
}
