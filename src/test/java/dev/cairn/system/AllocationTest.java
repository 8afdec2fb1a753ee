package dev.cairn.system;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonParser;

import dev.cairn.samples.SceneRegistry;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * A steady tick allocates nothing, on the simulation thread and on the helpers: exactly 0 bytes in
 * 20 seconds of every scene (which ticks count: {@code SteadyBytes}).
 *
 * <p>The JVM that is measured stops at C1. When a thread asks for a C2 compilation, HotSpot first
 * resolves the string constants of the method's class on that thread, which are our error messages;
 * their bytes, some hundred in the first minute and then none, would count as ours.
 */
final class AllocationTest {
    @Test
    void steadyTicksAllocateNothing(@TempDir Path directory)
            throws IOException, InterruptedException {
        String json =
                Jvm.samples(
                        directory,
                        List.of("-XX:TieredStopAtLevel=1"),
                        List.of(
                                "--headless",
                                "--scene",
                                String.join(",", SceneRegistry.ids()),
                                "--ticks",
                                String.valueOf(Scenes.ticks(20)),
                                "--workers",
                                "2",
                                "--json",
                                "-"));

        JsonArray scenes = JsonParser.parseString(json).getAsJsonArray();
        assertEquals(SceneRegistry.ids().size(), scenes.size());
        List<Executable> checks = new ArrayList<>();
        for (JsonElement scene : scenes) {
            String id = scene.getAsJsonObject().get("scene").getAsString();
            double bytes = scene.getAsJsonObject().get("allocatedBytesPerTick").getAsDouble();
            checks.add(() -> assertEquals(0, bytes, () -> id + ", bytes per tick"));
        }
        assertAll(checks);
    }
}
