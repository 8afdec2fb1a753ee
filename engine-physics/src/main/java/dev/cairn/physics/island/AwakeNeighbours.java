package dev.cairn.physics.island;

import dev.cairn.core.state.StateVisitor;
import dev.cairn.physics.internal.BodyStore;

import java.util.Arrays;

/**
 * Bodies that move while others sleep beside them: where each was, and what bore it, when it began
 * to lean on one of those.
 *
 * <p>Simulation thread; allocates only when slots are added.
 */
final class AwakeNeighbours {
    /** Numbers kept of a body: its position, m; the force of what bears it, N. */
    static final int KEPT = 6;

    private static final int FORCE = 3;

    private final BodyStore bodies;

    /** All not a number: it leans on nobody. */
    private double[] kept = {};

    /** Force of what bears it in the present tick, N; scratch. */
    private double[] bears = {};

    AwakeNeighbours(BodyStore bodies) {
        this.bodies = bodies;
    }

    void ensureSlots(int n) {
        int old = kept.length;
        kept = Arrays.copyOf(kept, KEPT * n);
        Arrays.fill(kept, old, KEPT * n, Double.NaN);
        bears = Arrays.copyOf(bears, 3 * n);
    }

    void state(StateVisitor s, int slots) {
        s.section("awakeNeighbours", this);
        kept = s.array("kept", kept, KEPT * slots);
        if (s.isRestoring()) {
            Arrays.fill(kept, KEPT * slots, kept.length, Double.NaN);
        }
    }

    /** Nothing bears a body, so far. */
    void clear(int slot) {
        Arrays.fill(bears, 3 * slot, 3 * slot + 3, 0);
    }

    /** One more contact bears a body, with a force, N. */
    void bear(int slot, double x, double y, double z) {
        bears[3 * slot] += x;
        bears[3 * slot + 1] += y;
        bears[3 * slot + 2] += z;
    }

    /** A body begins to lean on a sleeper, unless it leaned on one before. */
    void leanOn(int mover) {
        int o = KEPT * mover;
        if (Double.isNaN(kept[o])) {
            kept[o] = bodies.positionX[mover];
            kept[o + 1] = bodies.positionY[mover];
            kept[o + 2] = bodies.positionZ[mover];
        }
    }

    /** Remembers what bears a body now. */
    void remember(int mover) {
        System.arraycopy(bears, 3 * mover, kept, KEPT * mover + FORCE, 3);
    }

    /** Whether a body leans on a sleeper. */
    boolean leans(int mover) {
        return !Double.isNaN(kept[KEPT * mover]);
    }

    /** How far a body has moved since it began to lean, m. */
    double moved(int mover) {
        int o = KEPT * mover;
        double x = bodies.positionX[mover] - kept[o];
        double y = bodies.positionY[mover] - kept[o + 1];
        double z = bodies.positionZ[mover] - kept[o + 2];
        return Math.sqrt(x * x + y * y + z * z);
    }

    /** By how much what bears a body has changed since that was remembered, N. */
    double change(int mover) {
        int o = KEPT * mover + FORCE;
        double x = bears[3 * mover] - kept[o];
        double y = bears[3 * mover + 1] - kept[o + 1];
        double z = bears[3 * mover + 2] - kept[o + 2];
        return Math.sqrt(x * x + y * y + z * z);
    }

    /** A body that wakes beside one that moves is put to the test anew. */
    void forget(int mover) {
        Arrays.fill(kept, KEPT * mover, KEPT * mover + KEPT, Double.NaN);
    }

    /** What is remembered of a body, for a hash; {@code at} is 0 to 5. */
    long bits(int slot, int at) {
        return Double.doubleToRawLongBits(kept[KEPT * slot + at]);
    }
}
