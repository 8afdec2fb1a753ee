package dev.cairn.physics.time;

import dev.cairn.core.state.WorldState;
import dev.cairn.physics.PhysicsWorld;

/**
 * The states of the last ticks of a world, within bounds of number and memory: to go back to any of
 * them. States are used again, so that remembering allocates nothing once all are large enough.
 *
 * <p>Simulation thread, between steps.
 */
public final class History {
    private final PhysicsWorld world;
    private final long mostBytes;
    private final WorldState[] states;
    private final long[] ticks;

    /** Place of the oldest, and how many there are. */
    private int first;

    private int count;
    private long bytes;

    /**
     * Without ticks.
     *
     * @param world whose past this is
     * @param mostTicks that are remembered, at least 1
     * @param mostBytes that their numbers may take together, at least 1; the latest state is kept
     *     even if it takes more alone
     */
    public History(PhysicsWorld world, int mostTicks, long mostBytes) {
        if (world == null) {
            throw new IllegalArgumentException("world is null; pass the world to remember");
        }
        if (mostTicks < 1 || mostBytes < 1) {
            throw new IllegalArgumentException(
                    "a history of "
                            + mostTicks
                            + " ticks and "
                            + mostBytes
                            + " bytes holds nothing; both must be at least 1");
        }
        this.world = world;
        this.mostBytes = mostBytes;
        states = new WorldState[mostTicks];
        ticks = new long[mostTicks];
        for (int i = 0; i < mostTicks; i++) {
            states[i] = new WorldState();
        }
    }

    /**
     * Remembers the present state as that of its tick. What was remembered of this tick and of
     * later ones, which another future has brought, is forgotten.
     */
    public void remember() {
        forgetFrom(world.ecs().tickNumber());
        if (count == states.length) {
            forgetOldest();
        }
        int at = place(count++);
        world.save(states[at]);
        ticks[at] = world.ecs().tickNumber();
        bytes += states[at].byteCount();
        while (bytes > mostBytes && count > 1) {
            forgetOldest();
        }
    }

    /**
     * Whether a tick is remembered.
     *
     * @param tick its number
     * @return whether {@link #rewind} can go there
     */
    public boolean has(long tick) {
        return find(tick) >= 0;
    }

    /**
     * The first tick that is remembered.
     *
     * @return its number, -1 if there is none
     */
    public long oldestTick() {
        return count == 0 ? -1 : ticks[first];
    }

    /**
     * The last tick that is remembered.
     *
     * @return its number, -1 if there is none
     */
    public long latestTick() {
        return count == 0 ? -1 : ticks[place(count - 1)];
    }

    /**
     * How much memory the numbers of all states take.
     *
     * @return bytes, at most the bound if there are several
     */
    public long byteCount() {
        return bytes;
    }

    /**
     * Puts the world back to a tick. Later ticks are still remembered, until {@link #remember}
     * tells of another future.
     *
     * @param tick its number
     * @throws IllegalArgumentException if the tick is not remembered
     */
    public void rewind(long tick) {
        world.restore(state(tick));
    }

    /**
     * The state at a tick.
     *
     * @param tick its number
     * @return the state, until the tick is forgotten; read only
     * @throws IllegalArgumentException if the tick is not remembered
     */
    public WorldState state(long tick) {
        int at = find(tick);
        if (at < 0) {
            throw new IllegalArgumentException(
                    "tick "
                            + tick
                            + " is not remembered; "
                            + (count == 0
                                    ? "nothing is: call remember() after each step"
                                    : "the first one is "
                                            + oldestTick()
                                            + " and the last one "
                                            + latestTick()));
        }
        return states[at];
    }

    private int find(long tick) {
        for (int i = 0; i < count; i++) {
            if (ticks[place(i)] == tick) {
                return place(i);
            }
        }
        return -1;
    }

    private int place(int i) {
        return (first + i) % states.length;
    }

    private void forgetFrom(long tick) {
        while (count > 0 && latestTick() >= tick) {
            bytes -= states[place(--count)].byteCount();
        }
    }

    private void forgetOldest() {
        bytes -= states[first].byteCount();
        first = (first + 1) % states.length;
        count--;
    }
}
