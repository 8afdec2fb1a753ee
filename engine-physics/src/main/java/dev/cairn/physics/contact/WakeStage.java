package dev.cairn.physics.contact;

import dev.cairn.core.job.Jobs;
import dev.cairn.core.state.StateVisitor;
import dev.cairn.physics.broadphase.BroadPhase;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.island.SleepingBodies;

import java.util.Arrays;

/**
 * Between narrow phase and solve: a sleeping body that an awake one has come to touch is woken,
 * with its island, and collides within the same tick; again until no more bodies wake.
 *
 * <p>Simulation thread; the narrow phase in blocks; allocates only when rows are added.
 */
public final class WakeStage {
    /**
     * Change of a force, or of its moment over the radius, that wakes; over the sleeper's weight or
     * the load that it carried, whichever is more.
     */
    private static final double LEAN_CHANGE = 0.5;

    private final SleepingBodies sleepers;
    private final BodyStore bodies;
    private final ContactStore contacts;
    private double gravity;
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
    }

    /**
     * Wakes.
     *
     * @param bounds brings the boxes of the woken up to date
     * @param manifolds collides their rows
     * @param gravity its size, m/s²
     * @param stepSeconds length of the tick, s
     */
    public void run(
            BoundsStage bounds,
            BroadPhase broadPhase,
            ManifoldStage manifolds,
            double gravity,
            double stepSeconds,
            Jobs jobs) {
        this.gravity = gravity;
        secondsBefore = seconds;
        seconds = stepSeconds;
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

    /** The lengths of ticks that forces are reckoned with. */
    public void state(StateVisitor s) {
        s.section("wakes", this);
        seconds = s.value("seconds", seconds);
    }

    /**
     * Remembers the forces that moving bodies put on bodies that fell asleep beside them; after
     * {@link SleepingBodies#look}, if any fell asleep.
     */
    public void lean() {
        byte[] kind = bodies.kind;
        for (int i = 0; i < contacts.activeCount; i++) {
            int row = contacts.active[i];
            int a = contacts.bodyA[row];
            int b = contacts.bodyB[row];
            int mover = kind[a] == BodyStore.DYNAMIC ? a : b;
            int sleeper = a + b - mover;
            if (kind[mover] == BodyStore.DYNAMIC
                    && kind[sleeper] == BodyStore.ASLEEP
                    && !sleepers.settled(sleeper)
                    && contacts.isSolved(row)) {
                contacts.beginLeaning();
                contacts.lean[row] =
                        Math.max(Double.MIN_NORMAL, contacts.normalImpulse(row) / seconds);
                sleepers.awakeNeighbours().leanOn(mover);
            }
        }
    }

    /** A point joins a body asleep to one that is awake, or to a fixed one that is new there. */
    private void wakeTouched(int[] rows, int count) {
        byte[] kind = bodies.kind;
        for (int i = 0; i < count; i++) {
            int row = rows[i];
            int a = contacts.bodyA[row];
            int b = contacts.bodyB[row];
            if ((kind[a] == BodyStore.ASLEEP || kind[b] == BodyStore.ASLEEP)
                    && (contacts.isSolved(row) || leans(row))
                    && !staysAsleep(row)) {
                wake(row);
            }
        }
    }

    private boolean leans(int row) {
        return contacts.leans && contacts.lean[row] > 0;
    }

    /**
     * Whether the sleeper of a contact carries about as much of the body that moves beside it as
     * when it fell asleep, at about the same place.
     */
    private boolean staysAsleep(int row) {
        int a = contacts.bodyA[row];
        int mover = bodies.kind[a] == BodyStore.DYNAMIC ? a : contacts.bodyB[row];
        int sleeper = a + contacts.bodyB[row] - mover;
        if (bodies.kind[mover] != BodyStore.DYNAMIC) {
            return false;
        }
        double weight = gravity / bodies.inverseMass[sleeper];
        if (!leans(row)) {
            return mayBeginToLean(row, mover, weight);
        }
        // Apart: F0. Else F - F0, if that is more, and the moment max(F, F0) d / r; loads that only
        // go from one contact to another beside a body that stays in its place change nothing.
        double before = contacts.lean[row];
        double change = before;
        if (contacts.isSolved(row)) {
            double force = contacts.normalImpulse(row) / secondsBefore;
            double moved = sleepers.awakeNeighbours().moved(mover) / bodies.innerRadius[sleeper];
            change = Math.max(0, force - before) + Math.max(force, before) * moved;
        }
        return change <= LEAN_CHANGE * Math.max(weight, before);
    }

    /**
     * A body beside those asleep touches one more of them: that wakes the sleeper unless the
     * momentum is small beside what the sleeper's weight gives it in a tick. What it presses with
     * shows in the next.
     */
    private boolean mayBeginToLean(int row, int mover, double weight) {
        // m |v| <= share m g h; not so for a body on which no other leans yet: d is not a number
        boolean small =
                bodies.surfaceSpeed(mover)
                                <= LEAN_CHANGE * weight * seconds * bodies.inverseMass[mover]
                        && sleepers.awakeNeighbours().moved(mover) >= 0;
        if (small) {
            contacts.beginLeaning();
            contacts.lean[row] = Double.MIN_NORMAL;
        }
        return small;
    }

    private void wake(int row) {
        int a = contacts.bodyA[row];
        int b = contacts.bodyB[row];
        if (leans(row)) {
            contacts.lean[row] = 0;
            sleepers.awakeNeighbours().forget(bodies.kind[a] == BodyStore.DYNAMIC ? a : b);
        }
        sleepers.wake(a);
        sleepers.wake(b);
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
