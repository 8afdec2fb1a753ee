package dev.cairn.system;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.cairn.samples.SceneRegistry;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/**
 * A steady tick allocates nothing, on the simulation thread and on the helpers: exactly 0 bytes in
 * all of the second half of 20 seconds, in every scene.
 *
 * <p>The JVM that is measured stops at C1. When a thread asks for a C2 compilation, HotSpot first
 * resolves the string constants of the method's class on that thread, which are our error messages;
 * their bytes, some hundred in the first minute and then none, would count as ours.
 */
final class AllocationTest {
    @Test
    void steadyTicksAllocateNothing(@TempDir Path directory)
            throws IOException, InterruptedException {
        String lines =
                Jvm.run(
                        directory,
                        List.of("-XX:TieredStopAtLevel=1"),
                        AllocationProbe.class.getName(),
                        List.of(String.valueOf(Scenes.ticks(20)), "2"));

        String nothing =
                SceneRegistry.ids().stream().map(id -> id + " 0\n").collect(Collectors.joining());
        assertEquals(nothing, lines.replace("\r", ""));
    }

    /** With C2, and so with lanes: boxes, all shapes, joints, impacts. */
    @Test
    void someScenesAreSteadyOnceTheyAreCompiled(@TempDir Path directory)
            throws IOException, InterruptedException {
        steadyOnceCompiled(directory, List.of("pyramid", "pile-mixed", "ragdolls", "gas"));
    }

    @Test
    @Tag("soak")
    void everySceneIsSteadyOnceItIsCompiled(@TempDir Path directory)
            throws IOException, InterruptedException {
        steadyOnceCompiled(directory, SceneRegistry.ids());
    }

    /**
     * In a JVM of its own: tests that try several numbers of lanes in one JVM leave type profiles
     * behind that keep the Vector API's calls from being inlined, and then vectors are objects on
     * the heap.
     */
    private static void steadyOnceCompiled(Path directory, List<String> scenes)
            throws IOException, InterruptedException {
        List<String> arguments = new ArrayList<>(scenes);
        arguments.addFirst("2");
        String lines = Jvm.run(directory, List.of(), SteadyProbe.class.getName(), arguments);

        String nothing = scenes.stream().map(id -> id + " 0.0\n").collect(Collectors.joining());
        assertEquals(nothing, lines.replace("\r", ""));
    }
}
