package dev.cairn.samples.replay;

import dev.cairn.core.state.WorldState;
import dev.cairn.physics.PhysicsWorld;
import dev.cairn.samples.SceneRun;

import org.jspecify.annotations.Nullable;

import java.util.Map;

/** Compares a run with one that was recorded: tells the first tick that differs, and in what. */
public final class Replay implements SceneRun.Observer {
    private final RunFile recorded;
    private final WorldState room = new WorldState();
    private int compared;
    private int firstTick = -1;
    private @Nullable String where;

    /**
     * Of a run.
     *
     * @param recorded what it should be like
     */
    public Replay(RunFile recorded) {
        this.recorded = recorded;
    }

    @Override
    public void stepped(PhysicsWorld world, int tick) {
        if (tick >= recorded.digests().size() || where != null) {
            return;
        }
        compared++;
        if (firstTick < 0 && recorded.digests().get(tick) != world.digest()) {
            firstTick = tick;
        }
        RunFile.Keyframe then = recorded.keyframes().get(tick);
        if (firstTick >= 0 && then != null) {
            where = "at tick " + tick + " " + difference(then, RunFile.Keyframe.of(world, room));
        }
    }

    private static String difference(RunFile.Keyframe then, RunFile.Keyframe now) {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < Math.min(then.bodies().size(), now.bodies().size()); i++) {
            if (!then.bodies().get(i).equals(now.bodies().get(i))) {
                text.append("body ").append(i).append(" is the first that moves otherwise, ");
                break;
            }
        }
        if (then.bodies().size() != now.bodies().size()) {
            text.append("there were ").append(then.bodies().size()).append(" bodies and are ");
            text.append(now.bodies().size()).append(", ");
        }
        for (Map.Entry<String, Integer> column : then.columns().entrySet()) {
            if (!column.getValue().equals(now.columns().get(column.getKey()))) {
                return text + "and " + column.getKey() + " is the first column that differs";
            }
        }
        return text + "and no column differs";
    }

    /**
     * Whether all ticks that were recorded came again as they were.
     *
     * @return true if so
     */
    public boolean isSame() {
        return firstTick < 0 && compared == recorded.digests().size();
    }

    /**
     * The first tick that came out otherwise.
     *
     * @return its number, -1 if there is none
     */
    public int firstTick() {
        return firstTick;
    }

    /**
     * What to tell the user.
     *
     * @return a sentence
     */
    public String verdict() {
        if (firstTick >= 0) {
            return "tick "
                    + firstTick
                    + " is the first that differs"
                    + (where == null ? "; no keyframe follows that tells in what" : "; " + where);
        }
        return isSame()
                ? compared + " ticks, all with the same digests"
                : compared + " ticks were compared of " + recorded.digests().size();
    }
}
