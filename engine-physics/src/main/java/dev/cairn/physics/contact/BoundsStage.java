package dev.cairn.physics.contact;

import dev.cairn.core.job.BlockJob;
import dev.cairn.core.job.Blocks;
import dev.cairn.core.job.Jobs;
import dev.cairn.physics.broadphase.BroadPhase;
import dev.cairn.physics.internal.BodyStore;

import java.util.Arrays;

/**
 * Where each body may be within this tick: needed boxes, fat boxes for those that left theirs, and
 * the reach that the narrow phase's margin is made of. Finds bodies whose motion can no longer be
 * computed with.
 *
 * <p>Simulation thread; allocates only when the number of bodies grows.
 */
public final class BoundsStage {
    /**
     * The largest coordinate (m), speed (m/s) and surface speed (m/s) that the step computes with:
     * the fourth power of it is still a number.
     */
    public static final double LIMIT = 1e60;

    private static final int BODIES_PER_BLOCK = 128;
    private static final byte STAYS = 0;
    private static final byte LEFT = 1;
    private static final byte INVALID = 2;

    /** Of the narrow phase's margin: ticks of relative motion, and share of the inner radius. */
    final double speculativeTime, speculativeFraction;

    private final double boundsMargin, boundsTime;
    private final BlockJob job = this::block;

    /** Numbers of a body in {@link #ahead}. */
    static final int AHEAD = 4;

    /**
     * Of each body, one after the other: velocity at the end of the tick if nothing is in the way,
     * m/s, world x, y and z; and how far turning may carry a surface out within the reach of time,
     * m. All 0 for fixed bodies.
     */
    double[] ahead = {};

    private byte[] state = {};
    private double[] box = {};
    private int[] blockChanges = {};
    private int[] invalid = new int[16];
    private int invalidCount;

    private BodyStore bodies = new BodyStore();
    private BroadPhase broadPhase = new BroadPhase();
    private int[] slots = {};
    private int slotCount;
    private double gravityX;
    private double gravityY;
    private double gravityZ;
    private double step;

    /**
     * A stage without bodies.
     *
     * @param speculativeTime ticks of motion that the needed box holds
     * @param speculativeFraction and share of the inner radius
     * @param boundsMargin share of the outer radius by which a box is fattened
     * @param boundsTime and ticks of motion
     */
    public BoundsStage(
            double speculativeTime,
            double speculativeFraction,
            double boundsMargin,
            double boundsTime) {
        this.speculativeTime = speculativeTime;
        this.speculativeFraction = speculativeFraction;
        this.boundsMargin = boundsMargin;
        this.boundsTime = boundsTime;
    }

    /**
     * Grows the columns; between phases only.
     *
     * @param capacity number of slots of bodies
     */
    public void ensureSlots(int capacity) {
        if (capacity <= state.length) {
            return;
        }
        int n = Math.max(capacity, Math.max(64, state.length + (state.length >> 1)));
        ahead = Arrays.copyOf(ahead, AHEAD * n);
        state = Arrays.copyOf(state, n);
        box = Arrays.copyOf(box, 6 * n);
        blockChanges = new int[Blocks.count(n, BODIES_PER_BLOCK)];
    }

    /**
     * Runs over the dynamic bodies and places those in the broad phase that left their fat box.
     *
     * @param store the bodies
     * @param target the trees
     * @param dynamicSlots slots of the dynamic bodies, ascending
     * @param dynamicCount how many there are
     * @param gx gravity, world, m/s²
     * @param gy gravity, world, m/s²
     * @param gz gravity, world, m/s²
     * @param stepSeconds length of the tick, s
     * @param jobs runs the blocks
     */
    public void run(
            BodyStore store,
            BroadPhase target,
            int[] dynamicSlots,
            int dynamicCount,
            double gx,
            double gy,
            double gz,
            double stepSeconds,
            Jobs jobs) {
        bodies = store;
        broadPhase = target;
        slots = dynamicSlots;
        slotCount = dynamicCount;
        gravityX = gx;
        gravityY = gy;
        gravityZ = gz;
        step = stepSeconds;
        invalidCount = 0;
        int blocks = Blocks.count(dynamicCount, BODIES_PER_BLOCK);
        jobs.run(job, blocks);
        for (int b = 0; b < blocks; b++) {
            if (blockChanges[b] != 0) {
                apply(b);
            }
        }
    }

    /**
     * Places a fixed body.
     *
     * @param store the bodies
     * @param target the trees
     * @param slot of the body
     */
    public void placeFixed(BodyStore store, BroadPhase target, int slot) {
        store.shape[slot].bounds(
                store.orientationX[slot],
                store.orientationY[slot],
                store.orientationZ[slot],
                store.orientationW[slot],
                box,
                6 * slot);
        int at = 6 * slot;
        box[at] += store.positionX[slot];
        box[at + 1] += store.positionY[slot];
        box[at + 2] += store.positionZ[slot];
        box[at + 3] += store.positionX[slot];
        box[at + 4] += store.positionY[slot];
        box[at + 5] += store.positionZ[slot];
        setAhead(slot, 0, 0, 0, 0);
        target.place(slot, true, box, at);
    }

    /**
     * Brings one body up to date that was woken after {@link #run}, by the same rule and with what
     * that call was given.
     *
     * @param store the bodies
     * @param target the trees
     * @param slot of a dynamic body at rest
     */
    public void refresh(BodyStore store, BroadPhase target, int slot) {
        bodies = store;
        broadPhase = target;
        if (look(slot) == LEFT) {
            target.place(slot, false, box, 6 * slot);
        }
    }

    /**
     * A body has fallen asleep. Its neighbours see it as one that is awake and at rest: were its
     * margin another one, points would appear, and wake it, because it fell asleep.
     *
     * @param slot of the body
     */
    public void rest(int slot) {
        setAhead(slot, step * gravityX, step * gravityY, step * gravityZ, 0);
    }

    private void setAhead(int slot, double x, double y, double z, double arc) {
        int at = AHEAD * slot;
        ahead[at] = x;
        ahead[at + 1] = y;
        ahead[at + 2] = z;
        ahead[at + 3] = arc;
    }

    /**
     * How many bodies {@link #run} found that cannot be computed with.
     *
     * @return at least 0
     */
    public int invalidCount() {
        return invalidCount;
    }

    /**
     * One of them.
     *
     * @param index 0 to invalidCount - 1
     * @return its slot; ascending
     */
    public int invalidSlot(int index) {
        return invalid[index];
    }

    /** In slot order, on the simulation thread: the order of changes is the order of the tree. */
    private void apply(int block) {
        int end = Blocks.end(block, BODIES_PER_BLOCK, slotCount);
        for (int i = Blocks.begin(block, BODIES_PER_BLOCK); i < end; i++) {
            int slot = slots[i];
            if (state[slot] == LEFT) {
                broadPhase.place(slot, false, box, 6 * slot);
            } else if (state[slot] == INVALID) {
                if (invalidCount == invalid.length) {
                    invalid = Arrays.copyOf(invalid, 2 * invalidCount);
                }
                invalid[invalidCount++] = slot;
            }
        }
    }

    private void block(int block, int worker) {
        int end = Blocks.end(block, BODIES_PER_BLOCK, slotCount);
        int changes = 0;
        for (int i = Blocks.begin(block, BODIES_PER_BLOCK); i < end; i++) {
            int slot = slots[i];
            byte result = look(slot);
            state[slot] = result;
            changes += result;
        }
        blockChanges[block] = changes;
    }

    private byte look(int s) {
        BodyStore b = bodies;
        double inverseMass = b.inverseMass[s];
        double vx = b.velocityX[s] + step * (gravityX + b.forceX[s] * inverseMass);
        double vy = b.velocityY[s] + step * (gravityY + b.forceY[s] * inverseMass);
        double vz = b.velocityZ[s] + step * (gravityZ + b.forceZ[s] * inverseMass);
        double outer = b.outerRadius[s];
        double spin = spinBound(s);
        boolean valid =
                Math.abs(vx) <= LIMIT
                        && Math.abs(vy) <= LIMIT
                        && Math.abs(vz) <= LIMIT
                        && spin <= LIMIT
                        && spin * outer <= LIMIT
                        && Math.abs(b.positionX[s]) <= LIMIT
                        && Math.abs(b.positionY[s]) <= LIMIT
                        && Math.abs(b.positionZ[s]) <= LIMIT;
        if (!valid) {
            return INVALID;
        }
        double reach = step * speculativeTime;
        double inner = b.innerRadius[s];
        double arc = Math.min(spin * outer * reach, outer - inner);
        setAhead(s, vx, vy, vz, arc);
        b.shape[s].bounds(
                b.orientationX[s],
                b.orientationY[s],
                b.orientationZ[s],
                b.orientationW[s],
                box,
                6 * s);
        double pad = arc + speculativeFraction * inner;
        double margin = boundsMargin * outer;
        boolean inside = broadPhase.contains(s);
        inside &= axis(s, 0, b.positionX[s], vx, reach, pad, margin);
        inside &= axis(s, 1, b.positionY[s], vy, reach, pad, margin);
        inside &= axis(s, 2, b.positionZ[s], vz, reach, pad, margin);
        return inside ? STAYS : LEFT;
    }

    /**
     * Fattens one axis of the box in place. Returns whether the present fat box holds the needed
     * one and is not far larger.
     */
    private boolean axis(
            int s, int axis, double centre, double v, double reach, double pad, double margin) {
        int low = 6 * s + axis;
        int high = low + 3;
        double swept = v * reach;
        double min = box[low] + centre - pad + Math.min(swept, 0);
        double max = box[high] + centre + pad + Math.max(swept, 0);
        double lead = v * (step * boundsTime);
        double fatMin = min - margin + Math.min(lead, 0);
        double fatMax = max + margin + Math.max(lead, 0);
        box[low] = fatMin;
        box[high] = fatMax;
        double[] now = broadPhase.fatBoxes();
        double extent = now[high] - now[low];
        return now[low] <= min
                && max <= now[high]
                && extent <= fatMax - fatMin + 4 * margin + 4 * Math.abs(lead);
    }

    /** An upper bound of the angular speed at the end of the tick, rad/s. */
    private double spinBound(int s) {
        BodyStore b = bodies;
        double wx = b.angularVelocityX[s];
        double wy = b.angularVelocityY[s];
        double wz = b.angularVelocityZ[s];
        double tx = Math.abs(b.torqueX[s]);
        double ty = Math.abs(b.torqueY[s]);
        double tz = Math.abs(b.torqueZ[s]);
        double spin = Math.sqrt(wx * wx + wy * wy + wz * wz);
        double torque = tx + ty + tz;
        if (torque == 0) {
            return spin;
        }
        // The largest eigenvalue of a positive symmetric matrix is at most its trace.
        double trace = b.inverseInertiaXX[s] + b.inverseInertiaYY[s] + b.inverseInertiaZZ[s];
        return spin + step * torque * trace;
    }
}
