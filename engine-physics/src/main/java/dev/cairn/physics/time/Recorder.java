package dev.cairn.physics.time;

import dev.cairn.core.state.StateDelta;
import dev.cairn.core.state.WorldState;
import dev.cairn.physics.PhysicsWorld;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BiConsumer;

/**
 * Writes a run down while it goes on: the state that it begins with, what was done to the world
 * before each tick, and the digest after it. All that is done to the world must come by {@link
 * #input}, and all steps by {@link #step}.
 *
 * <p>Simulation thread, between steps.
 *
 * @param <I> what is done to the world: immutable, with a codec if the recording is to be written
 */
public final class Recorder<I> {
    private final PhysicsWorld world;
    private final BiConsumer<PhysicsWorld, I> acts;
    private final int keyframeTicks;
    private final WorldState start;
    private final long startDigest;
    private final List<Recording.Tick<I>> ticks = new ArrayList<>();
    private final List<I> now = new ArrayList<>();

    /** State of the last keyframe; room for the next one. */
    private final WorldState key = new WorldState();

    private final WorldState next = new WorldState();

    /**
     * Begins with the present state.
     *
     * @param world what is recorded
     * @param acts applies an input to a world; what it keeps outside of the world must follow from
     *     the inputs since the start
     * @param keyframeTicks ticks from one keyframe to the next, at least 1: a replay that comes out
     *     otherwise tells at the next keyframe in what. With 1 each tick is kept, as the difference
     *     from the one before
     */
    public Recorder(PhysicsWorld world, BiConsumer<PhysicsWorld, I> acts, int keyframeTicks) {
        if (world == null || acts == null || keyframeTicks < 1) {
            throw new IllegalArgumentException(
                    "a recorder needs a world, a function and keyframes every 1 or more ticks, and"
                            + " got "
                            + keyframeTicks);
        }
        this.world = world;
        this.acts = acts;
        this.keyframeTicks = keyframeTicks;
        start = world.save();
        startDigest = world.digest();
        key.set(start);
    }

    /**
     * Does something to the world, and writes it down for the coming tick.
     *
     * @param input what is done; not null
     */
    public void input(I input) {
        if (input == null) {
            throw new IllegalArgumentException("input is null; nothing is done by no input");
        }
        acts.accept(world, input); // if it is refused, it was not done
        now.add(input);
    }

    /**
     * Steps the world.
     *
     * @param stepSeconds length of the tick, s
     */
    public void step(double stepSeconds) {
        world.step(stepSeconds);
        write(stepSeconds, world.digest());
    }

    /**
     * Steps the world, and writes down the digest that another run of the same had after this tick:
     * so a replay tells at which tick the two part.
     *
     * @param stepSeconds length of the tick, s
     * @param digest {@link PhysicsWorld#digest} as it was seen
     * @return whether this world has the same
     */
    public boolean step(double stepSeconds, long digest) {
        world.step(stepSeconds);
        write(stepSeconds, digest);
        return world.digest() == digest;
    }

    private void write(double stepSeconds, long digest) {
        StateDelta delta = null;
        if ((ticks.size() + 1) % keyframeTicks == 0) {
            world.save(next);
            delta = StateDelta.between(key, next);
            key.set(next);
        }
        ticks.add(new Recording.Tick<>(stepSeconds, List.copyOf(now), digest, delta));
        now.clear();
    }

    /**
     * What was written down.
     *
     * @return the run so far, without inputs of the tick to come
     */
    public Recording<I> recording() {
        return new Recording<>(start, startDigest, List.copyOf(ticks));
    }
}
