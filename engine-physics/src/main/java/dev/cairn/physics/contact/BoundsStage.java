package dev.cairn.physics.contact;

import dev.cairn.core.job.BlockJob;
import dev.cairn.core.job.Blocks;
import dev.cairn.core.job.Jobs;
import dev.cairn.core.state.StateVisitor;
import dev.cairn.physics.broadphase.BroadPhase;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.Poses;
import dev.cairn.physics.tuning.Tunable;
import dev.cairn.physics.tuning.Tuning;

import java.util.Arrays;

/**
 * Where each collider may be within this tick: needed boxes, fat boxes for those that left theirs,
 * and the reach that the narrow phase's margin is made of. Finds bodies whose motion can no longer
 * be computed with.
 *
 * <p>Simulation thread; allocates only when the number of bodies grows.
 */
public final class BoundsStage {
    private static final int BODIES_PER_BLOCK = 128;
    private static final byte STAYS = 0;
    private static final byte LEFT = 1;
    private static final byte INVALID = 2;

    /** Of the narrow phase's margin: ticks of relative motion, and share of the inner radius. */
    public final double speculativeTime;

    final double speculativeFraction;

    private final double boundsMargin, boundsTime;
    private final BlockJob job = this::block;

    /** Numbers of a collider in {@link #ahead}. */
    static final int AHEAD = 4;

    /** Numbers of a box. */
    private static final int BOX = 6;

    /** Numbers of a pose. */
    static final int POSE = 7;

    /**
     * Of each collider, one after the other: velocity at the end of the tick if nothing is in the
     * way, m/s, world x, y and z; and how far turning may carry a surface out within the reach of
     * time, m. All 0 for those of fixed bodies.
     */
    double[] ahead = {};

    /** Of each collider: where its centre was when the tick began, world, m, x, y and z. */
    double[] start = {};

    /** Of each collider: the box around it when the tick began, world, m, least x to largest z. */
    private double[] tight = {};

    /**
     * Of each body with one collider: position and orientation when it was looked at last, seven
     * numbers. Its contacts have been computed from these; a state holds them so that deltas can
     * foresee points.
     */
    double[] began = {};

    private byte[] state = {};
    private double[] box = {};
    private int[] blockChanges = {};
    private int[] invalid = new int[16];
    private int invalidCount;
    private final BodyStore bodies;
    private final ColliderStore colliders;
    private BroadPhase broadPhase = new BroadPhase();
    private int[] slots = {};
    private int slotCount;

    /** Of the tick, world, m/s². */
    double gravityX, gravityY, gravityZ;

    private double step;

    /**
     * A stage without bodies.
     *
     * @param colliders whose boxes these are
     * @param settings the margin rules
     */
    public BoundsStage(ColliderStore colliders, Tuning settings) {
        this.colliders = colliders;
        bodies = colliders.bodies;
        speculativeTime = settings.get(Tunable.SPECULATIVE_TICKS);
        speculativeFraction = settings.get(Tunable.SPECULATIVE_FRACTION);
        boundsMargin = settings.get(Tunable.BOUNDS_MARGIN);
        boundsTime = settings.get(Tunable.BOUNDS_TICKS);
    }

    /**
     * The speculative margin of two colliders; see the package's essay.
     *
     * @param reach the tick's share in which relative motion counts, s
     * @param smaller inner radius of which a share is added, m
     */
    public double margin(int a, int b, double reach, double smaller) {
        int i = AHEAD * a;
        int j = AHEAD * b;
        double vx = ahead[j] - ahead[i];
        double vy = ahead[j + 1] - ahead[i + 1];
        double vz = ahead[j + 2] - ahead[i + 2];
        return reach * Math.sqrt(vx * vx + vy * vy + vz * vz)
                + ahead[i + 3]
                + ahead[j + 3]
                + speculativeFraction * smaller;
    }

    /**
     * Whether two colliders are further apart than their margin because the boxes around them are:
     * then no narrow phase is needed. False says nothing.
     *
     * @param reach as for {@link #margin}
     */
    boolean isFar(int a, int b, double reach) {
        int i = BOX * a;
        int j = BOX * b;
        double x = Math.max(tight[j] - tight[i + 3], tight[i] - tight[j + 3]);
        double y = Math.max(tight[j + 1] - tight[i + 4], tight[i + 1] - tight[j + 4]);
        double z = Math.max(tight[j + 2] - tight[i + 5], tight[i + 2] - tight[j + 5]);
        double gap = Math.max(x, Math.max(y, z));
        return gap > 0
                && gap
                        > margin(
                                a,
                                b,
                                reach,
                                Math.min(colliders.innerRadius[a], colliders.innerRadius[b]));
    }

    /** Grows the columns; between phases only. */
    public void ensureSlots(int capacity) {
        if (capacity <= state.length) {
            return;
        }
        int n = Math.max(capacity, Math.max(64, state.length + (state.length >> 1)));
        ahead = Arrays.copyOf(ahead, AHEAD * n);
        start = Arrays.copyOf(start, 3 * n);
        tight = Arrays.copyOf(tight, BOX * n);
        began = Arrays.copyOf(began, POSE * n);
        state = Arrays.copyOf(state, n);
        box = Arrays.copyOf(box, BOX * n);
        blockChanges = new int[Blocks.count(n, BODIES_PER_BLOCK)];
    }

    /**
     * Runs over the dynamic bodies and places those in the broad phase that left their fat box.
     *
     * @param dynamicSlots slots of the dynamic bodies, ascending
     * @param dynamicCount how many there are
     * @param gx gravity, world, m/s²
     * @param gy gravity, world, m/s²
     * @param gz gravity, world, m/s²
     * @param stepSeconds length of the tick, s
     */
    public void run(
            BroadPhase target,
            int[] dynamicSlots,
            int dynamicCount,
            double gx,
            double gy,
            double gz,
            double stepSeconds,
            Jobs jobs) {
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
        target.finishPlaces();
    }

    /**
     * How far those reach that are not looked at in each tick; slots have room already. Of others
     * there is nothing: the next tick finds it anew.
     */
    public void state(StateVisitor s, int slots) {
        s.section("bounds", this);
        gravityX = s.value("gravityX", gravityX);
        gravityY = s.value("gravityY", gravityY);
        gravityZ = s.value("gravityZ", gravityZ);
        step = s.value("step", step);
        ahead = lying(s, "ahead", ahead, AHEAD, slots);
        tight = lying(s, "tight", tight, BOX, slots);
        began = s.array("began", began, 0, POSE * slots, began.length, false);
    }

    private void begin(int slot) {
        if (bodies.collider[slot] != slot) {
            return;
        }
        int at = POSE * slot;
        began[at] = bodies.positionX[slot];
        began[at + 1] = bodies.positionY[slot];
        began[at + 2] = bodies.positionZ[slot];
        began[at + 3] = bodies.orientationX[slot];
        began[at + 4] = bodies.orientationY[slot];
        began[at + 5] = bodies.orientationZ[slot];
        began[at + 6] = bodies.orientationW[slot];
    }

    private double[] lying(StateVisitor s, String name, double[] column, int numbers, int slots) {
        if (s.isRestoring()) {
            return s.array(name, column, 0, numbers * slots, column.length, false);
        }
        for (int c = 0; c < slots; c++) {
            int body = colliders.body[c];
            if (body >= 0 && body < slots && bodies.kind[body] == BodyStore.DYNAMIC) {
                Arrays.fill(box, numbers * c, numbers * c + numbers, 0);
            } else {
                System.arraycopy(column, numbers * c, box, numbers * c, numbers);
            }
        }
        s.array(name, box, 0, numbers * slots, box.length, false);
        return column;
    }

    /** Places a fixed body; see {@link BroadPhase#finishPlaces} for what is placed with others. */
    public void placeFixed(BroadPhase target, int slot, boolean withOthers) {
        begin(slot);
        for (int c = bodies.collider[slot]; c != ColliderStore.NONE; c = colliders.next[c]) {
            tightBox(c);
            setAhead(c, 0, 0, 0, 0);
            // a sensor of a fixed body also meets what is fixed
            target.place(c, !colliders.sensor[c], tight, BOX * c, withOthers);
        }
        target.settle(slot);
    }

    /**
     * Places a kinematic body that moves: where it is, where it will be, and what its turn may
     * carry out in between.
     *
     * @param stepSeconds length of the tick, s
     */
    public void placeDriven(BroadPhase target, int slot, double stepSeconds) {
        begin(slot);
        broadPhase = target;
        BodyStore b = bodies;
        step = stepSeconds;
        double spin =
                Math.sqrt(
                        b.angularVelocityX[slot] * b.angularVelocityX[slot]
                                + b.angularVelocityY[slot] * b.angularVelocityY[slot]
                                + b.angularVelocityZ[slot] * b.angularVelocityZ[slot]);
        for (int c = b.collider[slot]; c != ColliderStore.NONE; c = colliders.next[c]) {
            look(slot, c, b.velocityX[slot], b.velocityY[slot], b.velocityZ[slot], spin);
            target.place(c, !colliders.sensor[c], box, 6 * c);
        }
        target.settle(slot);
    }

    /** Into {@link #box} about the collider's centre, and into {@link #tight}. */
    private void tightBox(int c) {
        Poses p = colliders.poses;
        int at = BOX * c;
        colliders.shape[c].bounds(
                p.orientationX[c],
                p.orientationY[c],
                p.orientationZ[c],
                p.orientationW[c],
                box,
                at);
        tight[at] = box[at] + p.positionX[c];
        tight[at + 1] = box[at + 1] + p.positionY[c];
        tight[at + 2] = box[at + 2] + p.positionZ[c];
        tight[at + 3] = box[at + 3] + p.positionX[c];
        tight[at + 4] = box[at + 4] + p.positionY[c];
        tight[at + 5] = box[at + 5] + p.positionZ[c];
    }

    /**
     * Brings one body up to date that was woken after {@link #run}, by the same rule and with what
     * that call was given.
     */
    public void refresh(BroadPhase target, int slot) {
        broadPhase = target;
        look(slot);
        place(slot, false);
    }

    /**
     * A body was put to sleep where it is: that may be out of its box, or it never had one. It gets
     * one, so that it is met.
     */
    public void settle(BroadPhase target, int slot) {
        for (int c = bodies.collider[slot]; c != ColliderStore.NONE; c = colliders.next[c]) {
            if (!isIn(target, c)) {
                refresh(target, slot);
                return;
            }
        }
    }

    private boolean isIn(BroadPhase target, int c) {
        Poses p = colliders.poses;
        tightBox(c);
        return target.contains(c)
                && isBetween(target, 6 * c, p.positionX[c])
                && isBetween(target, 6 * c + 1, p.positionY[c])
                && isBetween(target, 6 * c + 2, p.positionZ[c]);
    }

    private boolean isBetween(BroadPhase target, int low, double centre) {
        double[] fat = target.fatBoxes();
        return fat[low] <= box[low] + centre && box[low + 3] + centre <= fat[low + 3];
    }

    /**
     * A body has fallen asleep. Its neighbours see it as one that is awake and at rest: were its
     * margin another one, points would appear, and wake it, because it fell asleep.
     */
    public void rest(int slot) {
        double fall = step * bodies.gravityScale[slot];
        for (int c = bodies.collider[slot]; c != ColliderStore.NONE; c = colliders.next[c]) {
            tightBox(c);
            setAhead(c, fall * gravityX, fall * gravityY, fall * gravityZ, 0);
        }
    }

    private void setAhead(int collider, double x, double y, double z, double arc) {
        start[3 * collider] = colliders.poses.positionX[collider];
        start[3 * collider + 1] = colliders.poses.positionY[collider];
        start[3 * collider + 2] = colliders.poses.positionZ[collider];
        int at = AHEAD * collider;
        ahead[at] = x;
        ahead[at + 1] = y;
        ahead[at + 2] = z;
        ahead[at + 3] = arc;
    }

    /** How many bodies {@link #run} found that cannot be computed with. */
    public int invalidCount() {
        return invalidCount;
    }

    /** Slot of one of them, {@code index} 0 to invalidCount - 1; ascending. */
    public int invalidSlot(int index) {
        return invalid[index];
    }

    /** In slot order, on the simulation thread: the order of changes is the order of the tree. */
    private void apply(int block) {
        int end = Blocks.end(block, BODIES_PER_BLOCK, slotCount);
        for (int i = Blocks.begin(block, BODIES_PER_BLOCK); i < end; i++) {
            int slot = slots[i];
            place(slot, true);
            if (state[bodies.collider[slot]] == INVALID) {
                if (invalidCount == invalid.length) {
                    invalid = Arrays.copyOf(invalid, 2 * invalidCount);
                }
                invalid[invalidCount++] = slot;
            }
        }
    }

    private void place(int slot, boolean withOthers) {
        boolean any = false;
        for (int c = bodies.collider[slot]; c != ColliderStore.NONE; c = colliders.next[c]) {
            if (state[c] == LEFT) {
                broadPhase.place(c, false, box, BOX * c, withOthers);
                any = true;
            }
        }
        if (any) {
            broadPhase.settle(slot);
        }
    }

    private void block(int block, int worker) {
        int end = Blocks.end(block, BODIES_PER_BLOCK, slotCount);
        int changes = 0;
        for (int i = Blocks.begin(block, BODIES_PER_BLOCK); i < end; i++) {
            changes += look(slots[i]);
        }
        blockChanges[block] = changes;
    }

    /** Returns 0 if the body's colliders stay in their fat boxes. */
    private int look(int s) {
        begin(s);
        BodyStore b = bodies;
        double inverseMass = b.inverseMass[s];
        double scale = b.gravityScale[s];
        double vx = b.velocityX[s] + step * (scale * gravityX + b.forceX[s] * inverseMass);
        double vy = b.velocityY[s] + step * (scale * gravityY + b.forceY[s] * inverseMass);
        double vz = b.velocityZ[s] + step * (scale * gravityZ + b.forceZ[s] * inverseMass);
        double spin = StepLimits.spin(b, s, step);
        boolean valid = StepLimits.allow(b, s, vx, vy, vz, spin);
        int c = b.collider[s];
        if (c == ColliderStore.NONE) {
            return 0;
        }
        state[c] = valid ? look(s, c, vx, vy, vz, spin) : INVALID;
        return state[c] + lookAtOthers(s, colliders.next[c], vx, vy, vz, spin, valid);
    }

    /** Apart, as nearly all bodies have one collider: a loop costs the compiler 0.25 s. */
    private int lookAtOthers(
            int s, int first, double vx, double vy, double vz, double spin, boolean valid) {
        int changes = 0;
        for (int c = first; c != ColliderStore.NONE; c = colliders.next[c]) {
            state[c] = valid ? look(s, c, vx, vy, vz, spin) : INVALID;
            changes += state[c];
        }
        return changes;
    }

    private byte look(int s, int c, double vx, double vy, double vz, double spin) {
        return c == s ? look(c, vx, vy, vz, spin, 0) : lookAtChild(s, c, vx, vy, vz, spin);
    }

    /**
     * The centre of a child goes with v + w x o, o from the body's centre. In the time t it leaves
     * that line by at most |o| (a t + w² t²/2), a what torques may add to the spin w; and never by
     * more than 2 |o|.
     */
    private byte lookAtChild(int s, int c, double vx, double vy, double vz, double spin) {
        BodyStore b = bodies;
        Poses p = colliders.poses;
        double ox = p.apartX(s, c);
        double oy = p.apartY(s, c);
        double oz = p.apartZ(s, c);
        double wx = b.angularVelocityX[s];
        double wy = b.angularVelocityY[s];
        double wz = b.angularVelocityZ[s];
        double reach = step * speculativeTime;
        double arm = Math.sqrt(ox * ox + oy * oy + oz * oz);
        double pushed = spin - Math.sqrt(wx * wx + wy * wy + wz * wz);
        double turn = spin * reach;
        double bend = arm * Math.min(2, pushed * reach + 0.5 * turn * turn);
        return look(
                c,
                vx + wy * oz - wz * oy,
                vy + wz * ox - wx * oz,
                vz + wx * oy - wy * ox,
                spin,
                bend);
    }

    /** With the bend, m, of the centre's way within the reach. What has no end does not turn. */
    private byte look(int c, double vx, double vy, double vz, double spin, double bend) {
        Poses p = colliders.poses;
        double reach = step * speculativeTime;
        // of a surface of triangles it is infinite: nothing is known to be inside
        double inner = Double.isInfinite(colliders.innerRadius[c]) ? 0 : colliders.innerRadius[c];
        double outer = colliders.outerRadius[c];
        double arc = (spin > 0 ? Math.min(spin * outer * reach, outer - inner) : 0) + bend;
        setAhead(c, vx, vy, vz, arc);
        tightBox(c);
        double pad = arc + speculativeFraction * inner;
        double margin = boundsMargin * outer;
        boolean inside = broadPhase.contains(c);
        inside &= axis(c, 0, p.positionX[c], vx, reach, pad, margin);
        inside &= axis(c, 1, p.positionY[c], vy, reach, pad, margin);
        inside &= axis(c, 2, p.positionZ[c], vz, reach, pad, margin);
        return inside ? STAYS : LEFT;
    }

    /**
     * Fattens one axis of the box in place. Returns whether the present fat box holds the needed
     * one and is not far larger.
     */
    private boolean axis(
            int c, int axis, double centre, double v, double reach, double pad, double margin) {
        int low = 6 * c + axis;
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
}
