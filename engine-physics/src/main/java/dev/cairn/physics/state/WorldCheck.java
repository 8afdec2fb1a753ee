package dev.cairn.physics.state;

import dev.cairn.physics.broadphase.AabbTree;
import dev.cairn.physics.broadphase.BroadPhase;
import dev.cairn.physics.broadphase.PairSet;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.island.SleepingBodies;

import java.util.Arrays;
import java.util.function.IntFunction;
import java.util.function.IntPredicate;

/**
 * Checks all state that the next tick depends on, between steps. Every fault names the place, the
 * value and its bound, for a report. Allocates; its cost is linear but for a sort of the bodies.
 */
public final class WorldCheck {
    /** Least and greatest length of an orientation: each tick makes it 1 but for rounding. */
    private static final double SHORT = 1 - 1e-9, LONG = 1 + 1e-9;

    private static final String INPUT =
            "look at the velocities, impulses and places that were given to the body since the last"
                    + " valid state; if they were right, report this line and the scene";

    private static final String REPORT =
            "this is a fault of the engine: report this line, the scene, the settings and after how"
                    + " many steps it was seen";

    private final BodyStore bodies;
    private final ColliderStore colliders;
    private final ContactStore contacts;
    private final BroadPhase broadPhase;
    private final SleepingBodies sleepers;
    private final IntFunction<String> name;
    private final IntPredicate waits;

    /**
     * A check of one world.
     *
     * @param waits whether a fixed body has its box still to come, at the start of the next tick
     */
    public WorldCheck(
            BodyStore bodies,
            ColliderStore colliders,
            ContactStore contacts,
            BroadPhase broadPhase,
            SleepingBodies sleepers,
            IntFunction<String> name,
            IntPredicate waits) {
        this.bodies = bodies;
        this.colliders = colliders;
        this.contacts = contacts;
        this.broadPhase = broadPhase;
        this.sleepers = sleepers;
        this.name = name;
        this.waits = waits;
    }

    /**
     * Checks everything.
     *
     * @throws IllegalStateException of the first fault
     */
    public void run() {
        for (int slot = 0; slot < bodies.slotCount; slot++) {
            if (bodies.kind[slot] != BodyStore.FREE) {
                motion(slot);
                box(slot);
            }
        }
        entities();
        tree("fixed", broadPhase.staticTree());
        tree("moving", broadPhase.dynamicTree());
        islands();
        PairSet pairs = new PairSet();
        for (int row = 0; row < contacts.count; row++) {
            row(row);
            int a = contacts.colliderA[row];
            int b = contacts.colliderB[row];
            boolean isNew = contacts.isFurther(row) || pairs.add(PairSet.key(a, b));
            if (!broadPhase.isPair(a, b) || !isNew) {
                String what = "row of colliders " + a + " and " + b;
                throw fault("contact row " + row, what, row, "the only one of a pair", REPORT);
            }
        }
    }

    private void motion(int s) {
        BodyStore b = bodies;
        finite(s, "position x", b.positionX[s]);
        finite(s, "position y", b.positionY[s]);
        finite(s, "position z", b.positionZ[s]);
        finite(s, "velocity x", b.velocityX[s]);
        finite(s, "velocity y", b.velocityY[s]);
        finite(s, "velocity z", b.velocityZ[s]);
        finite(s, "angular velocity x", b.angularVelocityX[s]);
        finite(s, "angular velocity y", b.angularVelocityY[s]);
        finite(s, "angular velocity z", b.angularVelocityZ[s]);
        double x = b.orientationX[s];
        double y = b.orientationY[s];
        double z = b.orientationZ[s];
        double w = b.orientationW[s];
        double length = Math.sqrt(x * x + y * y + z * z + w * w);
        if (!(length >= SHORT && length <= LONG)) {
            throw fault(body(s), "length of the orientation", length, "1 within 1e-9", REPORT);
        }
    }

    private void finite(int slot, String what, double value) {
        if (!Double.isFinite(value)) {
            throw fault(body(slot), what, value, "finite", INPUT);
        }
    }

    /** An awake body may have left its box within the last tick: the next one looks first. */
    private void box(int slot) {
        byte kind = bodies.kind[slot];
        boolean fixed = kind == BodyStore.STATIC || kind == BodyStore.KINEMATIC;
        if (bodies.kind[slot] == BodyStore.DYNAMIC || (fixed && waits.test(slot))) {
            return;
        }
        double[] tight = new double[6];
        for (int c = bodies.collider[slot]; c != ColliderStore.NONE; c = colliders.next[c]) {
            if (!broadPhase.contains(c)) {
                throw fault(body(slot), "number of tree boxes", 0, "1", REPORT);
            }
            double[] at = {
                colliders.poses.positionX[c],
                colliders.poses.positionY[c],
                colliders.poses.positionZ[c]
            };
            colliders.shape[c].bounds(
                    colliders.poses.orientationX[c],
                    colliders.poses.orientationY[c],
                    colliders.poses.orientationZ[c],
                    colliders.poses.orientationW[c],
                    tight,
                    0);
            for (int i = 0; i < 3; i++) {
                double low = broadPhase.fatBoxes()[6 * c + i];
                double high = broadPhase.fatBoxes()[6 * c + 3 + i];
                if (tight[i] + at[i] < low) {
                    String bound = "at least " + low + ", where its box in the tree begins";
                    throw fault(body(slot), "lower end along " + axis(i), tight[i] + at[i], bound);
                }
                if (tight[3 + i] + at[i] > high) {
                    String bound = "at most " + high + ", where its box in the tree ends";
                    throw fault(
                            body(slot), "upper end along " + axis(i), tight[3 + i] + at[i], bound);
                }
            }
        }
    }

    private static char axis(int i) {
        return (char) ('x' + i);
    }

    private void entities() {
        long[] ids = new long[bodies.slotCount];
        int count = 0;
        for (int slot = 0; slot < bodies.slotCount; slot++) {
            if (bodies.kind[slot] != BodyStore.FREE) {
                ids[count++] = bodies.entity[slot];
            }
        }
        Arrays.sort(ids, 0, count);
        for (int i = 1; i < count; i++) {
            if (ids[i] == ids[i - 1]) {
                throw fault("entity " + ids[i], "number of bodies", 2, "1", REPORT);
            }
        }
    }

    private static void tree(String which, AabbTree tree) {
        try {
            tree.validate();
        } catch (IllegalStateException broken) {
            throw new IllegalStateException(
                    "the tree of " + which + " bodies: " + broken.getMessage() + "; " + REPORT,
                    broken);
        }
    }

    private void islands() {
        int asleep = 0;
        for (int slot = 0; slot < bodies.slotCount; slot++) {
            if (bodies.kind[slot] == BodyStore.FREE || !sleepers.enabled()) {
                continue;
            }
            int island = sleepers.islandOf(slot);
            boolean sleeps = sleepers.asleep(slot);
            asleep += sleeps ? 1 : 0;
            if (!sleeps && island != -1) {
                throw fault(body(slot), "island of an awake body", island, "-1", REPORT);
            }
            if (sleeps && (island < 0 || island > slot || sleepers.islandOf(island) != island)) {
                String bound = "the lowest slot of bodies that sleep together";
                throw fault(body(slot), "island of a sleeping body", island, bound, REPORT);
            }
        }
        if (asleep != sleepers.asleepCount()) {
            String bound = sleepers.asleepCount() + " as counted when they fell asleep";
            throw fault("the world", "number of sleeping bodies", asleep, bound, REPORT);
        }
    }

    private void row(int row) {
        ContactStore c = contacts;
        String where = "contact row " + row;
        side(where, c.colliderA[row], c.bodyA[row]);
        side(where, c.colliderB[row], c.bodyB[row]);
        where += " of " + body(c.bodyA[row]) + " and " + body(c.bodyB[row]);
        boolean isWhole =
                colliders.isWhole(c.colliderA[row]) || colliders.isWhole(c.colliderB[row]);
        int points = isWhole ? -c.pointCount[row] : c.pointCount[row];
        if (points < 0 || points > ContactStore.POINTS) {
            throw fault(where, "number of points", points, "0 to " + ContactStore.POINTS, REPORT);
        }
        for (int i = 0; i < points; i++) {
            int p = ContactStore.POINTS * row + i;
            impulse(where, "normal impulse of point " + i, c.normalImpulse[p]);
            // A sum of changes, which may round to less than 0.
            finite(where, "normal impulse over the tick of point " + i, c.totalNormalImpulse[p]);
            finite(where, "separation of point " + i, c.separation[p]);
        }
    }

    private void side(String where, int collider, int slot) {
        boolean known = slot >= 0 && slot < bodies.slotCount;
        if (!known || bodies.kind[slot] == BodyStore.FREE) {
            throw fault(where, "slot of a body", slot, "that of a body in the world", REPORT);
        }
        if (colliders.body[collider] != slot) {
            String bound = colliders.body[collider] + ", whose collider touches";
            throw fault(where, "slot of a body", slot, bound, REPORT);
        }
    }

    private static void finite(String where, String what, double value) {
        if (!Double.isFinite(value)) {
            throw fault(where, what, value, "finite", REPORT);
        }
    }

    private static void impulse(String where, String what, double value) {
        if (!(value >= 0 && value < Double.POSITIVE_INFINITY)) {
            throw fault(where, what, value, "finite and at least 0", REPORT);
        }
    }

    private String body(int slot) {
        return name.apply(slot);
    }

    private static IllegalStateException fault(
            String where, String what, double value, String bound) {
        return fault(where, what, value, bound, REPORT);
    }

    private static IllegalStateException fault(
            String where, String what, double value, String bound, String advice) {
        String number = value == (int) value ? "" + (int) value : "" + value;
        return new IllegalStateException(
                where + ": " + what + " is " + number + "; it must be " + bound + "; " + advice);
    }
}
