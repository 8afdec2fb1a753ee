package dev.cairn.system;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.cairn.samples.SceneRegistry;
import dev.cairn.samples.SceneReport;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.List;
import java.util.Map;

/** A steady tick allocates nothing, on the simulation thread and on the helpers. */
final class AllocationTest {
    static List<String> scenes() {
        return SceneRegistry.ids();
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void steadyTicksAllocateNothing(String id) {
        SceneReport report = Scenes.run(id, 20, 2, Map.of());

        assertEquals(0, report.allocatedBytesPerTick(), () -> report.scene() + ", bytes per tick");
    }
}
