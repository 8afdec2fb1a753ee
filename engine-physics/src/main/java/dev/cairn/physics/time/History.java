package dev.cairn.physics.time;

import dev.cairn.core.state.StateDelta;
import dev.cairn.core.state.WorldState;
import dev.cairn.physics.PhysicsWorld;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The last ticks of a world, within bounds of number and memory: to go back to any of them, and
 * forth again.
 *
 * <p>Of most ticks only the {@link StateDelta} to the tick before is kept, so that memory goes by
 * what has changed, and what sleeps costs nothing. The first tick, and one now and then, is kept
 * whole: a keyframe. Going to a tick starts from the nearest of the keyframe before it, the latest
 * tick and the one that was looked at last, so the deltas on the way never exceed the size of a
 * state by much, and a neighbour is one delta away.
 *
 * <pre>
 *   key ─δ─ tick ─δ─ tick ─δ─ … ─δ─ key ─δ─ tick … ─δ─ latest
 * </pre>
 *
 * <p>Simulation thread, between steps. Remembering allocates the delta.
 */
public final class History {
    /** Ticks after which there is another keyframe, however little has changed. */
    private static final int MOST_DELTAS = 600;

    /** Deltas between two keyframes take at most so many times the memory of a state. */
    private static final int DELTAS_TO_KEY = 4;

    /** A gap that thinning leaves is at most this part of how long ago it is. */
    private static final int AGE_TO_GAP = 12;

    /** Fewer ticks are not thinned. */
    private static final int FEW = 16;

    private final PhysicsWorld world;
    private final long mostBytes;
    private final int mostTicks;
    private final boolean thins;

    /** Where thinning goes on, counted from the oldest. */
    private int sweep = 1;

    /** Room to join two deltas. */
    private final WorldState joined = new WorldState();

    /** By place, see {@link #place}: tick, what leads there from the one before, whole state. */
    private long[] ticks = new long[16];

    private @Nullable StateDelta[] deltas = new StateDelta[16];
    private @Nullable WorldState[] keys = new WorldState[16];

    /** Place of the oldest, which has a key, and how many there are. */
    private int first;

    private int count;
    private long bytes;

    /** Since the latest key: how many ticks, and bytes of deltas. */
    private int sinceKey;

    private long bytesSinceKey;

    /** State of the latest tick; room for the next one. */
    private WorldState latest = new WorldState();

    private WorldState next = new WorldState();

    /** State of the tick that was looked at last, -1 if there is none: counted from the oldest. */
    private final WorldState looked = new WorldState();

    private int lookedAt = -1;

    /** Keys that are free. */
    private final List<WorldState> spares = new ArrayList<>();

    /**
     * Without ticks.
     *
     * @param world whose past this is
     * @param mostTicks that are remembered, at least 1
     * @param mostBytes that deltas and keyframes may take together, at least 1; the latest state is
     *     kept even if it takes more alone. Beside it three states are held to work with
     */
    public History(PhysicsWorld world, int mostTicks, long mostBytes) {
        this(world, mostTicks, mostBytes, false);
    }

    /**
     * A history that reaches back as far as it is asked to: when memory is short it does not forget
     * the oldest tick, but every second one of the older three quarters, again and again, so that
     * the past is the coarser the longer ago it is. For a time bar over minutes; {@link #floorTick}
     * tells where it can go.
     *
     * @param world whose past this is
     * @param mostTicks how far back it reaches, in ticks, at least 1
     * @param mostBytes as {@link #History}; if that is too little for gaps of a twelfth of how long
     *     ago they are, the oldest are forgotten all the same
     * @return without ticks
     */
    public static History thinning(PhysicsWorld world, int mostTicks, long mostBytes) {
        return new History(world, mostTicks, mostBytes, true);
    }

    private History(PhysicsWorld world, int mostTicks, long mostBytes, boolean thins) {
        this.thins = thins;
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
        this.mostTicks = mostTicks;
        this.mostBytes = mostBytes;
    }

    /**
     * Remembers the present state as that of its tick. What was remembered of this tick and of
     * later ones, which another future has brought, is forgotten.
     */
    public void remember() {
        long tick = world.ecs().tickNumber();
        world.save(next); // refused during a step, and of a world that has failed
        forgetFrom(tick);
        while (count > 0 && (count >= mostTicks || tick - oldestTick() >= mostTicks)) {
            if (count == 1) {
                forgetFrom(oldestTick());
            } else {
                forgetOldest();
            }
        }
        ensureRoom();
        int at = place(count);
        StateDelta delta = count == 0 ? null : StateDelta.between(latest, next);
        long step = delta == null ? 0 : delta.byteCount();
        bytesSinceKey += step;
        sinceKey++;
        if (delta == null
                || bytesSinceKey > DELTAS_TO_KEY * next.byteCount()
                || sinceKey > MOST_DELTAS) {
            WorldState key = spares.isEmpty() ? new WorldState() : spares.removeLast();
            key.set(next);
            keys[at] = key;
            bytes += next.byteCount();
            sinceKey = 0;
            bytesSinceKey = 0;
        }
        deltas[at] = delta;
        ticks[at] = tick;
        bytes += step;
        count++;
        WorldState before = latest;
        latest = next;
        next = before;
        while (bytes > mostBytes && count > 1) {
            if (!thins || !thin()) {
                forgetOldest();
            }
        }
    }

    /**
     * Whether a tick is remembered.
     *
     * @param tick its number
     * @return whether {@link #rewind} can go there
     */
    public boolean has(long tick) {
        int i = floor(tick);
        return i >= 0 && ticks[place(i)] == tick;
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
     * The last tick that is remembered, of those up to a tick: where a time bar goes that was
     * dragged there.
     *
     * @param tick any
     * @return its number, -1 if all that are remembered are later
     */
    public long floorTick(long tick) {
        int i = floor(tick);
        return i < 0 ? -1 : ticks[place(i)];
    }

    /**
     * How many ticks are remembered.
     *
     * @return at most the bound
     */
    public int tickCount() {
        return count;
    }

    /**
     * How much memory deltas and keyframes take.
     *
     * @return bytes, at most the bound if there are several ticks
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
     * The state at a tick. A neighbour of the one that was asked for before costs what has changed
     * between them; others up to a copy of a state and as much again.
     *
     * @param tick its number
     * @return the state, until the next call of this history; read only
     * @throws IllegalArgumentException if the tick is not remembered
     */
    public WorldState state(long tick) {
        int i = floor(tick);
        if (i < 0 || ticks[place(i)] != tick) {
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
        look(i);
        return looked;
    }

    /** Leads {@link #looked} to a tick, on the shortest way. */
    private void look(int i) {
        int key = i;
        while (keys[place(key)] == null && (lookedAt < 0 || i - key < Math.abs(i - lookedAt))) {
            key--;
        }
        WorldState whole = keys[place(key)];
        int way = lookedAt < 0 ? Integer.MAX_VALUE : Math.abs(i - lookedAt);
        if (count - 1 - i < Math.min(way, whole == null ? Integer.MAX_VALUE : i - key)) {
            looked.set(latest);
            lookedAt = count - 1;
        } else if (whole != null && i - key < way) {
            looked.set(whole);
            lookedAt = key;
        }
        while (lookedAt < i) {
            delta(++lookedAt).apply(looked);
        }
        while (lookedAt > i) {
            delta(lookedAt--).revert(looked);
        }
    }

    private StateDelta delta(int i) {
        StateDelta delta = deltas[place(i)];
        if (delta == null) {
            throw new IllegalStateException("tick " + ticks[place(i)] + " has no delta");
        }
        return delta;
    }

    /** The last one at a tick or before it, counted from the oldest; -1 if there is none. */
    private int floor(long tick) {
        int low = 0;
        int high = count;
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (ticks[place(middle)] <= tick) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low - 1;
    }

    private int place(int i) {
        return (first + i) % ticks.length;
    }

    private void forgetFrom(long tick) {
        int keep = floor(tick - 1) + 1;
        if (keep == count) {
            return;
        }
        if (keep > 0) {
            look(keep - 1);
            latest.set(looked);
        }
        lookedAt = Math.min(lookedAt, keep - 1);
        while (count > keep) {
            forget(place(--count));
        }
        sinceKey = 0;
        bytesSinceKey = 0;
        for (int i = keep - 1; i >= 0 && keys[place(i)] == null; i--) {
            sinceKey++;
            bytesSinceKey += delta(i).byteCount();
        }
    }

    /** The key goes on to the tick behind it, which is the oldest now. */
    private void forgetOldest() {
        int second = place(1);
        WorldState key = keys[first];
        if (count > 1 && key != null && keys[second] == null) {
            bytes -= key.byteCount();
            delta(1).apply(key);
            bytes += key.byteCount();
            keys[first] = null;
            keys[second] = key;
        }
        if (count > 1) {
            bytes -= delta(1).byteCount();
            deltas[second] = null;
        }
        forget(first);
        first = second;
        count--;
        lookedAt = Math.max(-1, lookedAt - 1);
    }

    /** Forgets a tick among the older ones; false if there are too few. */
    private boolean thin() {
        int end = count - count / 4;
        int i = sweep < end ? sweep : 1;
        for (int tries = 0; count < FEW || !canGo(i); tries++) {
            if (count < FEW || tries == end) {
                return false;
            }
            i = i + 1 < end ? i + 1 : 1;
        }
        look(i - 1);
        joined.set(looked);
        look(i + 1);
        StateDelta over = StateDelta.between(joined, looked);
        bytes += over.byteCount() - delta(i + 1).byteCount();
        deltas[place(i + 1)] = over;
        forget(place(i));
        for (int k = i; k > 0; k--) {
            ticks[place(k)] = ticks[place(k - 1)];
            deltas[place(k)] = deltas[place(k - 1)];
            keys[place(k)] = keys[place(k - 1)];
        }
        deltas[first] = null;
        keys[first] = null;
        first = place(1);
        count--;
        lookedAt = i;
        sweep = i + 1;
        return true;
    }

    /**
     * Whether a tick may be forgotten: the gap that it leaves is small beside its age, and the
     * deltas from the key before to the key behind are few enough without its own.
     */
    private boolean canGo(int i) {
        long gap = ticks[place(i + 1)] - ticks[place(i - 1)];
        if (gap > 2 && gap > (latestTick() - ticks[place(i)]) / AGE_TO_GAP) {
            return false;
        }
        if (keys[place(i)] == null) {
            return true;
        }
        long sum = delta(i).byteCount();
        for (int k = i - 1; keys[place(k)] == null; k--) {
            sum += delta(k).byteCount();
        }
        for (int k = i + 1; k < count && keys[place(k)] == null; k++) {
            sum += delta(k).byteCount();
        }
        WorldState key = keys[place(i)];
        return key != null && sum <= DELTAS_TO_KEY * key.byteCount();
    }

    private void forget(int at) {
        StateDelta delta = deltas[at];
        WorldState key = keys[at];
        bytes -= delta == null ? 0 : delta.byteCount();
        deltas[at] = null;
        if (key != null) {
            bytes -= key.byteCount();
            keys[at] = null;
            if (spares.isEmpty()) {
                spares.add(key);
            }
        }
    }

    private void ensureRoom() {
        int length = ticks.length;
        if (count < length) {
            return;
        }
        int longer = 2 * length;
        ticks = turned(ticks, longer);
        @Nullable StateDelta[] newDeltas = new StateDelta[longer];
        @Nullable WorldState[] newKeys = new WorldState[longer];
        for (int i = 0; i < count; i++) {
            newDeltas[i] = deltas[(first + i) % length];
            newKeys[i] = keys[(first + i) % length];
        }
        deltas = newDeltas;
        keys = newKeys;
        first = 0;
    }

    private long[] turned(long[] from, int length) {
        long[] to = Arrays.copyOf(from, length);
        for (int i = 0; i < count; i++) {
            to[i] = from[(first + i) % from.length];
        }
        return to;
    }
}
