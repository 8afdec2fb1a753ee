package dev.cairn.physics.contact;

import dev.cairn.core.job.Jobs;
import dev.cairn.physics.broadphase.BroadPhase;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.island.Sleepers;

import java.util.Arrays;

/**
 * Between narrow phase and solve: whom an awake body has come to touch is woken, with all that
 * hangs on him, and collides within the same tick; again until nobody more wakes.
 *
 * <p>Simulation thread; the narrow phase in blocks; allocates only when rows are added.
 */
public final class WakeStage {
    private final Sleepers sleepers;
    private final BodyStore bodies;
    private final ContactStore contacts;
    private int[] late = {};
    private int lateCount;
    private int[] merged = {};

    /** A stage. */
    public WakeStage(Sleepers sleepers, BodyStore bodies, ContactStore contacts) {
        this.sleepers = sleepers;
        this.bodies = bodies;
        this.contacts = contacts;
    }

    /**
     * Wakes.
     *
     * @param bounds brings the boxes of the woken up to date
     * @param manifolds collides their rows
     * @param stepSeconds length of the tick, s
     */
    public void run(
            BoundsStage bounds,
            BroadPhase broadPhase,
            ManifoldStage manifolds,
            double stepSeconds,
            Jobs jobs) {
        if (sleepers.asleepCount() == 0) {
            return;
        }
        wakeTouched(contacts.active, contacts.activeCount);
        sleepers.wakeLinked();
        while (sleepers.freshCount() > 0) {
            refresh(bounds, broadPhase);
            join();
            if (lateCount == 0) {
                return;
            }
            int[] all = contacts.active;
            int count = contacts.activeCount;
            contacts.active = late;
            contacts.activeCount = lateCount;
            int before = contacts.count;
            manifolds.run(contacts, stepSeconds, jobs);
            late = contacts.active;
            lateCount = contacts.activeCount;
            int added = contacts.count - before;
            contacts.active = added == 0 ? all : Arrays.copyOf(all, contacts.bodyA.length);
            contacts.activeCount = count;
            for (int i = 0; i < added; i++) {
                contacts.active[contacts.activeCount++] = before + i;
            }
            wakeTouched(late, lateCount);
            sleepers.wakeLinked();
        }
    }

    /** Brings boxes and margins of bodies that were woken within the tick up to date. */
    public void refresh(BoundsStage bounds, BroadPhase broadPhase) {
        for (int i = 0; i < sleepers.freshCount(); i++) {
            bounds.refresh(broadPhase, sleepers.fresh(i));
        }
        sleepers.forgetFresh();
    }

    /** A point joins a body asleep to one that is awake, or to a fixed one that is new there. */
    private void wakeTouched(int[] rows, int count) {
        byte[] kind = bodies.kind;
        for (int i = 0; i < count; i++) {
            int row = rows[i];
            int a = contacts.bodyA[row];
            int b = contacts.bodyB[row];
            if ((kind[a] == BodyStore.ASLEEP || kind[b] == BodyStore.ASLEEP)
                    && contacts.isSolved(row)) {
                sleepers.wake(a);
                sleepers.wake(b);
            }
        }
    }

    /** Rows that have become active: into the list, and by themselves into another. */
    private void join() {
        int length = contacts.bodyA.length;
        if (late.length < length) {
            late = new int[length];
            merged = new int[length];
        }
        byte[] kind = bodies.kind;
        int[] active = contacts.active;
        int size = 0;
        int at = 0;
        lateCount = 0;
        for (int row = 0; row < contacts.count; row++) {
            if (at < contacts.activeCount && active[at] == row) {
                at++;
                merged[size++] = row;
            } else if (kind[contacts.bodyA[row]] == BodyStore.DYNAMIC
                    || kind[contacts.bodyB[row]] == BodyStore.DYNAMIC) {
                late[lateCount++] = row;
                merged[size++] = row;
            }
        }
        contacts.active = merged;
        contacts.activeCount = size;
        merged = active;
    }
}
