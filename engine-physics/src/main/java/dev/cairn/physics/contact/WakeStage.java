package dev.cairn.physics.contact;

import dev.cairn.core.job.Jobs;
import dev.cairn.core.state.StateVisitor;
import dev.cairn.physics.broadphase.BroadPhase;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.island.Leaning;
import dev.cairn.physics.island.SleepingBodies;

import java.util.Arrays;

/**
 * Between narrow phase and solve: a sleeping body that an awake one has come to touch is woken,
 * with its island, and collides within the same tick; again until no more bodies wake.
 *
 * <p>Simulation thread; the narrow phase in blocks; allocates only when rows are added.
 */
public final class WakeStage {
    private final SleepingBodies sleepers;
    private final BodyStore bodies;
    private final ContactStore contacts;
    private final Leaning leaning;
    private double seconds = 1;
    private double secondsBefore = 1;
    private int[] late = {};
    private int lateCount;
    private int[] merged = {};

    /** A stage. */
    public WakeStage(SleepingBodies sleepers, BodyStore bodies, ContactStore contacts) {
        this.sleepers = sleepers;
        this.bodies = bodies;
        this.contacts = contacts;
        leaning = new Leaning(sleepers, bodies, contacts);
    }

    /**
     * Wakes.
     *
     * @param bounds brings the boxes of the woken up to date
     * @param manifolds collides their rows
     * @param gx gravity, world, m/s²
     * @param gy gravity, world, m/s²
     * @param gz gravity, world, m/s²
     * @param stepSeconds length of the tick, s
     * @param substeps sub-steps of a tick
     */
    public void run(
            BoundsStage bounds,
            BroadPhase broadPhase,
            ManifoldStage manifolds,
            double gx,
            double gy,
            double gz,
            double stepSeconds,
            int substeps,
            Jobs jobs) {
        secondsBefore = seconds;
        seconds = stepSeconds;
        if (sleepers.asleepCount() == 0) {
            return;
        }
        leaning.look(gx, gy, gz, stepSeconds, 1 / secondsBefore, substeps);
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

    /** The lengths of ticks that forces are reckoned with. */
    public void state(StateVisitor s) {
        s.section("wakes", this);
        seconds = s.value("seconds", seconds);
    }

    /**
     * Remembers the forces that moving bodies put on bodies that fell asleep beside them; after
     * {@link SleepingBodies#look}, if any fell asleep.
     *
     * @param substeps sub-steps of a tick
     */
    public void lean(int substeps) {
        leaning.begin(1 / seconds, substeps);
    }

    /** A point joins a body asleep to one that is awake, or to a fixed one that is new there. */
    private void wakeTouched(int[] rows, int count) {
        byte[] kind = bodies.kind;
        for (int i = 0; i < count; i++) {
            int row = rows[i];
            int a = contacts.bodyA[row];
            int b = contacts.bodyB[row];
            if ((kind[a] == BodyStore.ASLEEP || kind[b] == BodyStore.ASLEEP)
                    && (contacts.isSolved(row) || leaning.leans(row))
                    && !leaning.staysAsleep(row, 1 / secondsBefore)) {
                wake(row);
            }
        }
    }

    private void wake(int row) {
        leaning.forget(row);
        sleepers.wake(contacts.bodyA[row]);
        sleepers.wake(contacts.bodyB[row]);
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
