package dev.cairn.samples.replay;

import dev.cairn.core.state.WorldState;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.samples.SceneRun;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Writes down a run while it goes on. */
public final class Recorder implements SceneRun.Observer {
    /** Sums of a world of so many bodies are taken in each tick; of larger ones now and then. */
    private static final int SMALL = 100;

    private static final int SELDOM = 60;

    private final List<String> arguments;
    private final List<Long> digests = new ArrayList<>();
    private final Map<Integer, RunFile.Keyframe> keyframes = new LinkedHashMap<>();
    private final WorldState room = new WorldState();

    /**
     * Of a run.
     *
     * @param arguments that lead to the same run
     */
    public Recorder(List<String> arguments) {
        this.arguments = List.copyOf(arguments);
    }

    @Override
    public void stepped(PhysicsWorld world, int tick) {
        digests.add(world.digest());
        if (world.bodyCount() <= SMALL || tick % SELDOM == 0) {
            keyframes.put(tick, RunFile.Keyframe.of(world, room));
        }
    }

    /**
     * What was written down.
     *
     * @return the run so far
     */
    public RunFile file() {
        return new RunFile(arguments, List.copyOf(digests), Map.copyOf(keyframes));
    }
}
