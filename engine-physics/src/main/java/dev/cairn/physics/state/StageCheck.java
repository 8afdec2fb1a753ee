package dev.cairn.physics.state;

import dev.cairn.physics.broadphase.BroadPhase;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactStore;

/**
 * What each stage of the step promises to the next one, for {@code assert}: every method returns
 * true or throws an {@link AssertionError} that tells the place. Allocates nothing while all holds.
 */
public final class StageCheck {
    private StageCheck() {}

    /** The list of awake bodies: ascending, and none that is fixed, asleep or gone. */
    public static boolean awake(BodyStore bodies, int[] slots, int count) {
        for (int i = 0; i < count; i++) {
            int slot = slots[i];
            if ((i > 0 && slot <= slots[i - 1]) || bodies.kind[slot] != BodyStore.DYNAMIC) {
                throw new AssertionError("slot " + slot + " at place " + i + " of the awake list");
            }
        }
        return true;
    }

    /** Every collider of an awake body has a box, which is none of infinities or the wrong way. */
    public static boolean boxes(
            BodyStore bodies, ColliderStore colliders, BroadPhase broadPhase, int[] slots, int n) {
        double[] box = broadPhase.fatBoxes();
        for (int i = 0; i < n; i++) {
            int first = bodies.kind[slots[i]] == BodyStore.DYNAMIC ? bodies.collider[slots[i]] : -1;
            for (int c = first; c != ColliderStore.NONE; c = colliders.next[c]) {
                boolean ordered = broadPhase.contains(c);
                for (int k = 6 * c; k < 6 * c + 3; k++) {
                    ordered &= box[k] <= box[k + 3] && Double.isFinite(box[k + 3] - box[k]);
                }
                if (!ordered) {
                    throw new AssertionError("box of collider " + c + " of body " + slots[i]);
                }
            }
        }
        return true;
    }

    /** Each new pair is one of two colliders, the lower one first, and was made a pair. */
    public static boolean newPairs(BroadPhase broadPhase) {
        for (int i = 0; i < broadPhase.newPairCount(); i++) {
            long key = broadPhase.newPairs()[i];
            int a = (int) (key >>> 32);
            int b = (int) key;
            if (a < 0 || a >= b || !broadPhase.isPair(a, b)) {
                throw new AssertionError("new pair " + i + " of colliders " + a + " and " + b);
            }
        }
        return true;
    }

    /** As many rows as pairs, each of one, between two bodies that are there; a list in order. */
    public static boolean rows(
            ContactStore c,
            int sensorRows,
            ColliderStore colliders,
            BodyStore bodies,
            BroadPhase broadPhase) {
        int pairs = sensorRows;
        for (int row = 0; row < c.count; row++) {
            pairs += c.isFurther(row) ? 0 : 1;
        }
        if (pairs != broadPhase.pairCount()) {
            throw new AssertionError(pairs + " rows of " + broadPhase.pairCount() + " pairs");
        }
        for (int row = 0; row < c.count; row++) {
            int a = c.bodyA[row];
            int b = c.bodyB[row];
            if (!broadPhase.isPair(c.colliderA[row], c.colliderB[row])
                    || colliders.body[c.colliderA[row]] != a
                    || colliders.body[c.colliderB[row]] != b
                    || bodies.kind[a] == BodyStore.FREE
                    || bodies.kind[b] == BodyStore.FREE) {
                throw new AssertionError("row " + row + " of bodies " + a + " and " + b);
            }
        }
        for (int i = 0; i < c.activeCount; i++) {
            if (c.active[i] >= c.count || (i > 0 && c.active[i] <= c.active[i - 1])) {
                throw new AssertionError("row " + c.active[i] + " at active place " + i);
            }
            int row = c.active[i];
            if (bodies.kind[c.bodyA[row]] != BodyStore.DYNAMIC
                    && bodies.kind[c.bodyB[row]] != BodyStore.DYNAMIC
                    && !broadPhase.moved(c.colliderA[row])
                    && !broadPhase.moved(c.colliderB[row])) {
                throw new AssertionError(
                        "row " + row + " is active, and neither of its bodies is awake");
            }
        }
        return true;
    }

    /** After those were stopped that ceased to be finite. */
    public static boolean poses(BodyStore b, int[] slots, int count) {
        for (int i = 0; i < count; i++) {
            int s = slots[i];
            double sum =
                    Math.abs(b.positionX[s])
                            + Math.abs(b.positionY[s])
                            + Math.abs(b.positionZ[s])
                            + Math.abs(b.orientationX[s])
                            + Math.abs(b.orientationY[s])
                            + Math.abs(b.orientationZ[s])
                            + Math.abs(b.orientationW[s]);
            if (!(sum < Double.POSITIVE_INFINITY)) {
                throw new AssertionError("pose of body " + s + " is not finite");
            }
        }
        return true;
    }
}
