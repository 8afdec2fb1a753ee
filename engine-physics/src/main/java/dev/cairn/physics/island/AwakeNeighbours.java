package dev.cairn.physics.island;

import dev.cairn.core.state.StateVisitor;
import dev.cairn.physics.internal.BodyStore;

import java.util.Arrays;

/**
 * Bodies that move while others sleep beside them: where each was when the first of those fell
 * asleep.
 *
 * <p>Simulation thread; allocates only when slots are added.
 */
public final class AwakeNeighbours {
    private final BodyStore bodies;

    /** Position, m; not a number where no mover leans. */
    private double[] leanAt = {};

    AwakeNeighbours(BodyStore bodies) {
        this.bodies = bodies;
    }

    void ensureSlots(int n) {
        int old = leanAt.length;
        leanAt = Arrays.copyOf(leanAt, 3 * n);
        Arrays.fill(leanAt, old, 3 * n, Double.NaN);
    }

    void state(StateVisitor s, int slots) {
        s.section("awakeNeighbours", this);
        leanAt = s.array("leanAt", leanAt, 3 * slots);
        if (s.isRestoring()) {
            Arrays.fill(leanAt, 3 * slots, leanAt.length, Double.NaN);
        }
    }

    /**
     * A body fell asleep beside one that moves.
     *
     * @param mover slot of that body
     */
    public void leanOn(int mover) {
        if (Double.isNaN(leanAt[3 * mover])) {
            leanAt[3 * mover] = bodies.positionX[mover];
            leanAt[3 * mover + 1] = bodies.positionY[mover];
            leanAt[3 * mover + 2] = bodies.positionZ[mover];
        }
    }

    /**
     * How far a body has moved since another one fell asleep beside it.
     *
     * @param mover slot of an awake body
     * @return m; not a number if none did
     */
    public double moved(int mover) {
        double x = bodies.positionX[mover] - leanAt[3 * mover];
        double y = bodies.positionY[mover] - leanAt[3 * mover + 1];
        double z = bodies.positionZ[mover] - leanAt[3 * mover + 2];
        return Math.sqrt(x * x + y * y + z * z);
    }

    /** A body that wakes beside one that moves is put to the test anew. */
    public void forget(int mover) {
        leanAt[3 * mover] = Double.NaN;
    }

    /** What is remembered of a body, for a hash; {@code at} is 0 to 2. */
    long bits(int slot, int at) {
        return Double.doubleToRawLongBits(leanAt[3 * slot + at]);
    }
}
