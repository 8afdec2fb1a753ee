package dev.cairn.physics.island;

import dev.cairn.core.state.StateVisitor;
import dev.cairn.physics.internal.BodyStore;

import java.util.Arrays;

/**
 * Which bodies fell asleep and which woke, in pairs: a body that did both between two tellings did
 * neither.
 *
 * <p>Simulation thread; allocates only when a list grows.
 */
public final class SleepChanges {
    private final BodyStore bodies;
    private boolean[] toldAsleep = {};
    private int[] changed = new int[64];
    private int changedCount;
    private int[] fell = new int[64];
    private int fellCount;
    private int[] woke = new int[64];
    private int wokeCount;

    SleepChanges(BodyStore bodies) {
        this.bodies = bodies;
    }

    void ensureSlots(int n) {
        toldAsleep = Arrays.copyOf(toldAsleep, n);
    }

    void state(StateVisitor s, int slots) {
        s.section("sleep changes", this);
        changedCount = s.value("changedCount", changedCount);
        changed = s.array("changed", changed, changedCount);
        fellCount = s.value("fellCount", fellCount);
        fell = s.array("fell", fell, fellCount);
        wokeCount = s.value("wokeCount", wokeCount);
        woke = s.array("woke", woke, wokeCount);
        toldAsleep = s.array("toldAsleep", toldAsleep, slots);
    }

    /** A body fell asleep or woke. */
    void note(int s) {
        if (changedCount == changed.length) {
            changed = Arrays.copyOf(changed, 2 * changedCount);
        }
        changed[changedCount++] = s;
    }

    /**
     * Sums up the changes since the last call: bodies that sleep and did not, bodies that do not
     * and did.
     */
    public void tell() {
        fellCount = 0;
        wokeCount = 0;
        for (int i = 0; i < changedCount; i++) {
            int s = changed[i];
            boolean now = bodies.kind[s] == BodyStore.ASLEEP;
            if (now == toldAsleep[s]) {
                continue;
            }
            toldAsleep[s] = now;
            if (now) {
                if (fellCount == fell.length) {
                    fell = Arrays.copyOf(fell, 2 * fellCount);
                }
                fell[fellCount++] = s;
            } else {
                if (wokeCount == woke.length) {
                    woke = Arrays.copyOf(woke, 2 * wokeCount);
                }
                woke[wokeCount++] = s;
            }
        }
        changedCount = 0;
    }

    /**
     * How many bodies fell asleep in the last tick.
     *
     * @return at least 0
     */
    public int fellCount() {
        return fellCount;
    }

    /**
     * One of them.
     *
     * @param event 0 to fellCount - 1
     * @return its slot
     */
    public int fell(int event) {
        return fell[event];
    }

    /**
     * How many bodies woke in the last tick, or before it by a call.
     *
     * @return at least 0
     */
    public int wokeCount() {
        return wokeCount;
    }

    /**
     * One of them.
     *
     * @param event 0 to wokeCount - 1
     * @return its slot
     */
    public int woke(int event) {
        return woke[event];
    }
}
