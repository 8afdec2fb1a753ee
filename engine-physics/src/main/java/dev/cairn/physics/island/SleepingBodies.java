package dev.cairn.physics.island;

import dev.cairn.core.job.Jobs;
import dev.cairn.core.state.StateVisitor;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.EdgeSource;

import java.util.Arrays;

/**
 * Which bodies sleep: puts islands to sleep, wakes them, and tells what changed in a tick.
 *
 * <p>Simulation thread; allocates only when slots are added.
 */
public final class SleepingBodies {
    /**
     * Islands are looked for in every so many ticks: sleep may wait, and union-find is not free.
     */
    private static final int LOOK = 4;

    /** Words that {@link #bits} gives of a body. */
    public static final int WORDS = 19 + AwakeNeighbours.KEPT;

    private static final int NONE = -1;

    private final BodyStore bodies;
    private final EdgeSource[] edges;
    private final boolean enabled;
    private final RestDetector detector;
    private final RestingIslands resting;
    private final AwakeNeighbours neighbours;
    private final SleepChanges told;

    /** Name of the island that a body sleeps in, and the next body of it in a ring. */
    private int[] island = {};

    private int[] next = {};

    /** What the solver remembers of a body's load; it forgets about bodies that it does not see. */
    private double[] pressed = {};

    private int[] pressing = {};

    /** Whether a body's state was published since it fell asleep. */
    private boolean[] settled = {};

    private int[] tail = {};

    private int[] fresh = new int[64];
    private int freshCount;
    private int asleepCount;
    private boolean rowsStale;
    private boolean slotsStale;
    private long changes;
    private int ticksToLook;

    /**
     * No body sleeps yet.
     *
     * @param enabled whether bodies sleep
     * @param sleepSeconds time of quiet before, s
     * @param softness as for {@link RestDetector}
     * @param learning see {@code softness}
     * @param bodies whose kinds change
     * @param edges the links: contacts, and other kinds of constraints
     */
    public SleepingBodies(
            boolean enabled,
            double sleepSeconds,
            double softness,
            double learning,
            BodyStore bodies,
            EdgeSource... edges) {
        this.bodies = bodies;
        this.edges = edges;
        this.enabled = enabled;
        detector = new RestDetector(sleepSeconds, softness, learning);
        resting = new RestingIslands(detector, bodies, edges);
        neighbours = new AwakeNeighbours(bodies);
        told = new SleepChanges(bodies);
    }

    /**
     * Grows the columns; between phases only.
     *
     * @param slots number of slots of bodies
     */
    public void ensureSlots(int slots) {
        if (!enabled || slots <= island.length) {
            return;
        }
        int n = Math.max(slots, Math.max(64, island.length + (island.length >> 1)));
        int old = island.length;
        detector.ensureSlots(n);
        resting.ensureSlots(n);
        neighbours.ensureSlots(n);
        island = Arrays.copyOf(island, n);
        Arrays.fill(island, old, n, NONE);
        next = Arrays.copyOf(next, n);
        pressed = Arrays.copyOf(pressed, n);
        pressing = Arrays.copyOf(pressing, n);
        settled = Arrays.copyOf(settled, n);
        told.ensureSlots(n);
        tail = new int[n];
    }

    /**
     * Which bodies sleep, and since when; slots have room already. Changes are counted on, so that
     * no reader takes another state for the one that it has seen.
     *
     * @param slots in use
     */
    public void state(StateVisitor s, int slots) {
        s.section("sleepers", this);
        changes += s.isRestoring() ? 1 : 0;
        asleepCount = s.value("asleepCount", asleepCount);
        rowsStale = s.value("rowsStale", rowsStale);
        slotsStale = s.value("slotsStale", slotsStale);
        ticksToLook = s.value("ticksToLook", ticksToLook);
        freshCount = s.value("freshCount", freshCount);
        fresh = s.array("fresh", fresh, freshCount);
        if (enabled) {
            detector.state(s, slots);
            neighbours.state(s, slots);
            s.section("islands", this);
            island = s.array("island", island, slots);
            if (s.isRestoring()) {
                Arrays.fill(island, slots, island.length, NONE);
            }
            next = s.array("next", next, slots);
            pressed = s.array("pressed", pressed, slots);
            pressing = s.array("pressing", pressing, slots);
            settled = s.array("settled", settled, slots);
            told.state(s, slots);
        }
    }

    /**
     * A body is born in a slot, awake.
     *
     * @param slot of the body
     * @param maySleep whether it may fall asleep
     */
    public void born(int slot, boolean maySleep) {
        if (enabled) {
            detector.reset(slot);
            detector.maySleep[slot] = maySleep;
            neighbours.forget(slot);
        }
    }

    /**
     * Whether a body may fall asleep from now on.
     *
     * @param slot of the body
     * @param maySleep false to keep it awake
     */
    public void allow(int slot, boolean maySleep) {
        if (enabled) {
            detector.maySleep[slot] = maySleep;
        }
    }

    /** A body, awake, begins to be quiet anew. */
    public void renew(int slot) {
        if (enabled) {
            detector.reset(slot);
        }
    }

    /**
     * Whether the world lets bodies sleep.
     *
     * @return as in the settings
     */
    public boolean enabled() {
        return enabled;
    }

    /**
     * How many bodies sleep.
     *
     * @return at least 0
     */
    public int asleepCount() {
        return asleepCount;
    }

    /**
     * The bodies that fell asleep or woke, for events.
     *
     * @return the changes since they were told
     */
    public SleepChanges told() {
        return told;
    }

    /** Those that move beside sleepers. */
    AwakeNeighbours awakeNeighbours() {
        return neighbours;
    }

    /**
     * Whether a body sleeps.
     *
     * @param slot of the body
     * @return true if so
     */
    public boolean asleep(int slot) {
        return bodies.kind[slot] == BodyStore.ASLEEP;
    }

    /**
     * The island that a body sleeps in.
     *
     * @param slot of a body
     * @return the smallest slot of the island, or -1 if the body is awake
     */
    public int islandOf(int slot) {
        return enabled ? island[slot] : NONE;
    }

    // Falling asleep ---------------------------------------------------------------------------

    /**
     * Puts the islands to sleep that have come to rest; after the solve.
     *
     * @param awake slots of the awake bodies, ascending
     * @param count how many there are
     * @param gravity its size, m/s²
     * @param stepSeconds length of the tick, s
     * @param jobs runs the loop over bodies
     */
    public void look(int[] awake, int count, double gravity, double stepSeconds, Jobs jobs) {
        if (!enabled || count == 0) {
            return;
        }
        int still = detector.run(bodies, awake, count, gravity, stepSeconds, jobs);
        if (ticksToLook > 0) {
            ticksToLook--;
            return;
        }
        ticksToLook = LOOK - 1;
        if (still == 0) {
            return;
        }
        resting.find(awake, count, asleepCount > 0);
        for (int i = 0; i < count; i++) {
            int s = awake[i];
            if (resting.sleeps(s)) {
                lieDown(s, resting.head(s));
            }
        }
    }

    /**
     * Puts the island of a body to sleep at once, whatever it does.
     *
     * @param slot of an awake body
     * @param awake slots of the awake bodies, ascending
     * @param count how many there are
     */
    public void sleep(int slot, int[] awake, int count) {
        int root = resting.link(slot, awake, count);
        for (int i = 0; i < count; i++) {
            if (resting.root(awake[i]) == root) {
                lieDown(awake[i], root);
            }
        }
    }

    /** Slots come ascending: the first of a ring, then the others at its tail. */
    private void lieDown(int s, int first) {
        island[s] = first;
        if (s != first) {
            next[tail[first]] = s;
        }
        next[s] = first;
        tail[first] = s;
        BodyStore b = bodies;
        b.kind[s] = BodyStore.ASLEEP;
        detector.reset(s);
        b.velocityX[s] = 0;
        b.velocityY[s] = 0;
        b.velocityZ[s] = 0;
        b.angularVelocityX[s] = 0;
        b.angularVelocityY[s] = 0;
        b.angularVelocityZ[s] = 0;
        pressed[s] = b.pressed[s];
        pressing[s] = b.pressing[s];
        b.pressed[s] = 0;
        b.pressing[s] = 0;
        settled[s] = false;
        asleepCount++;
        note(s);
    }

    // Waking -----------------------------------------------------------------------------------

    /**
     * Wakes the island of a body, at once; nothing if it is awake.
     *
     * @param slot of the body
     */
    public void wake(int slot) {
        if (bodies.kind[slot] != BodyStore.ASLEEP) {
            return;
        }
        int s = slot;
        do {
            int after = next[s];
            getUp(s);
            s = after;
        } while (s != slot);
    }

    /**
     * Wakes bodies that are bound by another edge than a contact to one that is awake, or to one
     * that moves of itself.
     */
    public void wakeLinked() {
        int before;
        do {
            before = asleepCount;
            for (int k = 1; k < edges.length; k++) {
                wakeLinked(edges[k]);
            }
        } while (asleepCount < before);
    }

    private void wakeLinked(EdgeSource source) {
        byte[] kind = bodies.kind;
        for (int i = 0; i < source.edges(); i++) {
            int a = source.edgeA(i);
            if (a < 0) {
                continue;
            }
            int b = source.edgeB(i);
            if (kind[a] == BodyStore.DYNAMIC || bodies.isMoved(a)) {
                wake(b);
            } else if (kind[b] == BodyStore.DYNAMIC || bodies.isMoved(b)) {
                wake(a);
            }
        }
    }

    private void getUp(int s) {
        bodies.kind[s] = BodyStore.DYNAMIC;
        bodies.pressed[s] = pressed[s];
        bodies.pressing[s] = pressing[s];
        island[s] = NONE;
        settled[s] = false;
        detector.reset(s);
        asleepCount--;
        if (freshCount == fresh.length) {
            fresh = Arrays.copyOf(fresh, 2 * freshCount);
        }
        fresh[freshCount++] = s;
        note(s);
    }

    /**
     * Wakes all.
     *
     * @param slotCount number of slots of bodies
     */
    public void wakeAll(int slotCount) {
        for (int s = 0; asleepCount > 0 && s < slotCount; s++) {
            wake(s);
        }
    }

    private void note(int s) {
        changes++;
        rowsStale = true;
        slotsStale = true;
        told.note(s);
    }

    // What others ask --------------------------------------------------------------------------

    /**
     * How many bodies woke since {@link #forgetFresh}.
     *
     * @return at least 0
     */
    public int freshCount() {
        return freshCount;
    }

    /**
     * One of them.
     *
     * @param index 0 to freshCount - 1
     * @return its slot
     */
    public int fresh(int index) {
        return fresh[index];
    }

    /** Their boxes are up to date. */
    public void forgetFresh() {
        freshCount = 0;
    }

    /** The list of active rows must be made anew at the next tick. */
    public void rowsWillBeStale() {
        rowsStale = true;
    }

    /**
     * Whether the list of active rows must be made anew; asks once.
     *
     * @return true after any change
     */
    public boolean takeRowsStale() {
        boolean was = rowsStale;
        rowsStale = false;
        return was;
    }

    /**
     * Whether lists of awake bodies must be made anew; asks once.
     *
     * @return true after any change
     */
    public boolean takeListsStale() {
        boolean was = slotsStale;
        slotsStale = false;
        return was;
    }

    /**
     * Grows whenever a body falls asleep or wakes.
     *
     * @return a count
     */
    public long changes() {
        return changes;
    }

    /**
     * Whether a body sleeps and its state is published, so that there is nothing to write.
     *
     * @param slot of a body
     * @return true if so
     */
    public boolean settled(int slot) {
        return settled[slot];
    }

    /**
     * A body's state has been published.
     *
     * @param slot of a body that may sleep
     * @return whether it sleeps and was not settled before
     */
    public boolean settle(int slot) {
        boolean now = bodies.kind[slot] == BodyStore.ASLEEP && !settled[slot];
        settled[slot] |= now;
        return now;
    }

    /**
     * Adds what is remembered of a body to a hash.
     *
     * @param slot of a body
     * @param at 0 to WORDS - 1
     * @return bits
     */
    public long bits(int slot, int at) {
        if (bodies.kind[slot] == BodyStore.DYNAMIC) {
            if (at > 18) {
                return neighbours.bits(slot, at - 19);
            }
            return at == 0 ? NONE : detector.bits(slot, at - 1);
        }
        return switch (at) {
            case 0 -> island[slot];
            case 1 -> Double.doubleToRawLongBits(pressed[slot]);
            case 2 -> pressing[slot];
            default -> 0;
        };
    }
}
