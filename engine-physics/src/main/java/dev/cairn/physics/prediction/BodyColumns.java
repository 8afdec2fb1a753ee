package dev.cairn.physics.prediction;

import dev.cairn.core.state.StateColumns;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.shape.Shape;

import org.jspecify.annotations.Nullable;

/** Where the numbers of bodies are in a state. */
final class BodyColumns {
    static final int POSE = 7;
    static final int VELOCITY = 6;
    static final int BOX = 6;

    private static final String[] POSE_NAMES = {
        "positionX",
        "positionY",
        "positionZ",
        "orientationX",
        "orientationY",
        "orientationZ",
        "orientationW"
    };
    private static final String[] VELOCITY_NAMES = {
        "velocityX",
        "velocityY",
        "velocityZ",
        "angularVelocityX",
        "angularVelocityY",
        "angularVelocityZ"
    };

    final StateColumns state;
    final int[] pose = new int[POSE];
    final int[] velocity = new int[VELOCITY];

    /** Pose at the start of the tick, velocity then, box around it if it lies, place of rest. */
    final int began, last, tight, place;

    private final int start, seconds, stayed, kind, collider, shape;

    /** Slots that all columns have. */
    final int slots;

    /** Whether bodies may sleep, so that places of rest are known. */
    final boolean mayRest;

    private final double[] box = new double[BOX];

    BodyColumns(StateColumns state) {
        this.state = state;
        int bodies = state.section("bodies", -1);
        kind = state.bytes(bodies, "kind");
        collider = state.ints(bodies, "collider");
        last = state.wide(bodies, "lastVelocity");
        int least = Math.min(state.count(kind), state.count(collider));
        least = Math.min(least, state.count(last) / VELOCITY);
        for (int c = 0; c < POSE; c++) {
            pose[c] = state.wide(bodies, POSE_NAMES[c]);
            least = Math.min(least, state.count(pose[c]));
        }
        for (int c = 0; c < VELOCITY; c++) {
            velocity[c] = state.wide(bodies, VELOCITY_NAMES[c]);
            least = Math.min(least, state.count(velocity[c]));
        }
        int bounds = state.section("bounds", bodies);
        began = state.wide(bounds, "began");
        tight = state.wide(bounds, "tight");
        least = Math.min(least, state.count(began) / POSE);
        least = Math.min(least, state.count(tight) / BOX);
        int rest = state.section("rest", bodies);
        place = state.wide(rest, "place");
        start = state.wide(rest, "start");
        seconds = state.wide(rest, "seconds");
        stayed = state.wide(rest, "stayed");
        shape = state.objects(state.section("colliders", bodies), "shape");
        slots = Math.min(least, state.count(shape));
        int rests = Math.min(state.count(place), state.count(start)) / POSE;
        mayRest = slots <= Math.min(rests, Math.min(state.count(seconds), state.count(stayed)));
    }

    boolean isWhole() {
        return slots > 0;
    }

    /** By slot: whether a row says that it is packed. */
    boolean[] marks(int[] rows) {
        boolean[] marks = new boolean[slots];
        for (int row : rows) {
            if (row >> 1 < slots) {
                marks[row >> 1] = true;
            }
        }
        return marks;
    }

    /** The shape of a body whose only collider it is, about its centre; or null. */
    @Nullable Shape shape(int slot) {
        return slot >= 0
                        && slot < slots
                        && state.integer(collider, slot) == slot
                        && state.object(shape, slot) instanceof Shape known
                ? known
                : null;
    }

    /** A number of the pose at the start of the tick. */
    double began(int slot, int i) {
        return state.number(began, POSE * slot + i);
    }

    /** What was and what is, each in the place of the other. */
    void exchange(int slot) {
        for (int c = 0; c < POSE; c++) {
            exchange(began, POSE * slot + c, pose[c], slot);
        }
        for (int c = 0; c < VELOCITY; c++) {
            exchange(last, VELOCITY * slot + c, velocity[c], slot);
        }
    }

    private void exchange(int a, int i, int b, int k) {
        long bits = state.bits(a, i);
        state.set(a, i, state.bits(b, k));
        state.set(b, k, bits);
    }

    /**
     * Against the pose: where the body has begun to rest, if that is new, and the box around one
     * that lies.
     */
    void rest(int slot, boolean isSettled) {
        if (mayRest && isSettled && state.number(stayed, slot) >= 0) {
            mix(place, slot);
        }
        if (mayRest && isSettled && state.number(seconds, slot) >= 0) {
            mix(start, slot);
        }
        Shape known = shape(slot);
        if (known == null || state.octet(kind, slot) == BodyStore.DYNAMIC) {
            return;
        }
        known.bounds(
                state.number(pose[3], slot),
                state.number(pose[4], slot),
                state.number(pose[5], slot),
                state.number(pose[6], slot),
                box,
                0);
        for (int k = 0; k < BOX; k++) {
            double predicted = box[k] + state.number(pose[k % 3], slot);
            int i = BOX * slot + k;
            state.set(tight, i, state.bits(tight, i) ^ Double.doubleToRawLongBits(predicted));
        }
    }

    private void mix(int column, int slot) {
        for (int c = 0; c < POSE; c++) {
            int i = POSE * slot + c;
            state.set(column, i, state.bits(column, i) ^ state.bits(pose[c], slot));
        }
    }

    /**
     * How far the last number of both unit quaternions is from what the others say, in place of it;
     * and back.
     */
    void turns(int slot, boolean packs) {
        int i = POSE * slot;
        turn(began, i + 3, began, i + 4, began, i + 5, began, i + 6, packs);
        turn(pose[3], slot, pose[4], slot, pose[5], slot, pose[6], slot, packs);
    }

    private void turn(int x, int i, int y, int j, int z, int k, int w, int l, boolean packs) {
        double a = state.number(x, i);
        double b = state.number(y, j);
        double c = state.number(z, k);
        PredictedValues.next(
                state, w, l, Math.sqrt(Math.max(0, 1 - (a * a + b * b + c * c))), packs);
    }
}
