package dev.cairn.physics.time;

import dev.cairn.core.state.WorldState;
import dev.cairn.physics.PhysicsWorld;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;

/**
 * One peer of a game over a network, by rollback: it steps on without waiting, with the inputs that
 * it knows and for the others with the last one of their player; when one arrives that was
 * predicted otherwise, it goes back to that tick and steps again up to now. Peers that have got the
 * same inputs have the same world, bit for bit, whenever and in whatever order these came.
 *
 * <p>The input of tick n is applied to the world at tick n, before the step that leads to n + 1.
 * Simulation thread, between steps.
 *
 * @param <I> input of one player for one tick: immutable, with {@code equals}
 */
public final class Rollback<I> {
    /**
     * What inputs do to the world; a function of its arguments, since it is called again for a tick
     * that is stepped again.
     *
     * @param <I> the input
     */
    @FunctionalInterface
    public interface Inputs<I> {
        /**
         * Applies the inputs of a tick.
         *
         * @param world at this tick, between steps
         * @param tick its number
         * @param inputs one to a player, in the order of their numbers; read only
         */
        void apply(PhysicsWorld world, long tick, List<I> inputs);
    }

    private final PhysicsWorld world;
    private final double stepSeconds;
    private final int players;
    private final int window;
    private final Inputs<I> inputs;

    /** Of the last ticks, by tick modulo their number: used again, without garbage. */
    private final WorldState[] past;

    /**
     * By player and tick modulo {@link #length}: what was told, and what the step was made with.
     */
    private final List<@Nullable I> told;

    private final List<I> used;

    /** Inputs of this many ticks are held: those that may be rewound, and as many to come. */
    private final int length;

    /** By player: the first tick whose input is not known. */
    private final long[] unknown;

    /** The first tick whose inputs are held. */
    private long base;

    private final List<I> now;
    private long dirty = Long.MAX_VALUE;
    private long rewinds;
    private long again;

    /**
     * A peer.
     *
     * @param world alike for all peers
     * @param stepSeconds length of a tick, s
     * @param players how many there are, at least 1
     * @param window most ticks that the world may be ahead of the slowest player's inputs, at least
     *     1: beyond that {@link #advance} waits
     * @param none input of a player of whom nothing is known yet
     * @param inputs what inputs do
     */
    public Rollback(
            PhysicsWorld world,
            double stepSeconds,
            int players,
            int window,
            I none,
            Inputs<I> inputs) {
        if (players < 1 || window < 1) {
            throw new IllegalArgumentException(
                    "a rollback of "
                            + players
                            + " players over "
                            + window
                            + " ticks is none; both must be at least 1");
        }
        this.world = world;
        this.stepSeconds = stepSeconds;
        this.players = players;
        this.window = window;
        this.inputs = inputs;
        length = 2 * window + 2;
        past = new WorldState[window + 1];
        Arrays.setAll(past, i -> new WorldState());
        told = new ArrayList<@Nullable I>();
        for (int i = 0; i < players * length; i++) {
            told.add(null);
        }
        used = new ArrayList<>(Collections.nCopies(players * length, none));
        now = new ArrayList<>(Collections.nCopies(players, none));
        unknown = new long[players];
        base = tick();
        Arrays.fill(unknown, base);
    }

    /**
     * The tick that the world is at.
     *
     * @return its number
     */
    public long tick() {
        return world.ecs().tickNumber();
    }

    /**
     * The tick up to which all inputs are known: what has come before it is final.
     *
     * @return its number
     */
    public long settledTick() {
        long least = unknown[0];
        for (long tick : unknown) {
            least = Math.min(least, tick);
        }
        return Math.min(least, tick());
    }

    /**
     * Tells an input, of this peer or another, for this tick, an earlier or a later one. Told twice
     * it counts once.
     *
     * @param player 0 to players - 1
     * @param tick of the input
     * @param input what the player does
     * @throws IllegalArgumentException if the tick is later than can be held, or another input was
     *     told for it: then the peers have no common game any more
     */
    public void input(int player, long tick, I input) {
        if (player < 0 || player >= players) {
            throw new IllegalArgumentException(
                    "player is " + player + "; it must be 0 to " + (players - 1));
        }
        if (tick < unknown[player]) {
            return; // told before, and maybe final since
        }
        if (tick >= base + length) {
            throw new IllegalArgumentException(
                    "the input of player "
                            + player
                            + " for tick "
                            + tick
                            + " is "
                            + (tick - base)
                            + " ticks ahead of what is settled; at most "
                            + (length - 1)
                            + " can be held: tell inputs as they come, and wait where advance"
                            + " does");
        }
        int at = at(player, tick);
        I known = told.get(at);
        if (known != null && !known.equals(input)) {
            throw new IllegalArgumentException(
                    "player " + player + " told " + known + " and " + input + " for tick " + tick);
        }
        told.set(at, input);
        if (tick < tick() && !input.equals(used.get(at))) {
            dirty = Math.min(dirty, tick);
        }
        while (unknown[player] < base + length && told.get(at(player, unknown[player])) != null) {
            unknown[player]++;
        }
    }

    /**
     * Makes good what was predicted wrongly, and goes on by one tick.
     *
     * @return false if the world is so far ahead of a player that it must wait for inputs
     */
    public boolean advance() {
        settle();
        if (tick() - settledTick() >= window) {
            return false;
        }
        step();
        return true;
    }

    /** Makes good what was predicted wrongly, and stays at this tick. */
    public void settle() {
        long end = tick();
        if (dirty < end) {
            world.restore(past(dirty));
            rewinds++;
            while (tick() < end) {
                step();
                again++;
            }
        }
        dirty = Long.MAX_VALUE;
        for (long settled = settledTick(); base < settled; base++) {
            for (int p = 0; p < players; p++) {
                told.set(at(p, base), null);
            }
        }
    }

    /**
     * How often the world went back.
     *
     * @return times
     */
    public long rewinds() {
        return rewinds;
    }

    /**
     * How many ticks were stepped again.
     *
     * @return ticks
     */
    public long ticksAgain() {
        return again;
    }

    private void step() {
        long tick = tick();
        world.save(past(tick));
        for (int p = 0; p < players; p++) {
            int at = at(p, tick);
            I known = told.get(at);
            I next = known != null ? known : used.get(at(p, tick - 1));
            used.set(at, next);
            now.set(p, next);
        }
        inputs.apply(world, tick, Collections.unmodifiableList(now));
        world.step(stepSeconds);
    }

    private WorldState past(long tick) {
        return past[(int) Math.floorMod(tick, (long) past.length)];
    }

    private int at(int player, long tick) {
        return player * length + (int) Math.floorMod(tick, (long) length);
    }
}
