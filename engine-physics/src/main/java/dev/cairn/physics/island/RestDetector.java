package dev.cairn.physics.island;

import dev.cairn.core.job.BlockJob;
import dev.cairn.core.job.Blocks;
import dev.cairn.core.job.Jobs;
import dev.cairn.core.state.StateVisitor;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.Sag;

import java.util.Arrays;

/**
 * Which bodies are at rest, by the rule in the package's essay.
 *
 * <p>Simulation thread; in blocks; allocates only when slots are added.
 */
public final class RestDetector {
    /**
     * Largest speed of a quiet body's surface over {@code sqrt(g r)}: 3.3 mm/s for a cube of 1 m.
     */
    private static final double SLOW = 0.0015;

    /** How far a still body may be from its place, over the inner radius, and no further than */
    private static final double STAYS = Sag.SHOWS;

    /** this speed over {@code sqrt(g r)} takes it in the time: 2.2 mm/s for a cube of 1 m. */
    private static final double DRIFT = 0.001;

    /** A body that is faster than this over {@code sqrt(g r)} is not still, wherever it is. */
    private static final double FAST = 0.1;

    /** A motion that fades by less than this in a window counts as steady. */
    private static final double FADES = 0.95;

    /** What may be left to travel, over the inner radius. */
    private static final double LEFT = 0.002;

    /** A motion over a window that counts as none, over the inner radius. */
    private static final double NONE = 5e-6;

    /** Times of quiet after which a body counts as still whatever is left of its motion. */
    private static final double STILL = 4;

    private static final int BODIES_PER_BLOCK = 256;
    private static final int POSE = 7;

    private final double softness;
    private final double learning;
    private final double window;
    private final double stillSeconds;
    private final BlockJob job = this::block;

    /** How long the body has been quiet in the present window, s; negative: no window has begun. */
    double[] seconds = {};

    /** What its surface moved in the window before, m; negative if there was none. */
    double[] before = {};

    /** Whether it was at rest when the last window ended, and has been quiet since. */
    boolean[] rests = {};

    /** How long it has stayed about its place, s; negative: it has none. */
    private double[] stayed = {};

    /** Its place: position and orientation. */
    private double[] place = {};

    /** Whether it may sleep at all. */
    boolean[] maySleep = {};

    /** Pose at the start of the window: position and orientation. */
    private double[] start = {};

    private int[] restsInBlock = {};

    private BodyStore bodies = new BodyStore();
    private int[] slots = {};
    private int count;
    private double gravity;
    private double step;

    /**
     * A rule.
     *
     * @param sleepSeconds time of quiet before sleep, s: two windows
     * @param softness how far what rests sinks into a contact, over {@code g} times the square of
     *     the tick
     * @param learning share of it that a contact learns in a tick
     */
    public RestDetector(double sleepSeconds, double softness, double learning) {
        this.softness = softness;
        this.learning = learning;
        window = 0.5 * sleepSeconds;
        stillSeconds = STILL * sleepSeconds;
    }

    /**
     * Grows the columns; between phases only.
     *
     * @param n number of slots of bodies
     */
    public void ensureSlots(int n) {
        if (n <= rests.length) {
            return;
        }
        seconds = Arrays.copyOf(seconds, n);
        before = Arrays.copyOf(before, n);
        rests = Arrays.copyOf(rests, n);
        stayed = Arrays.copyOf(stayed, n);
        place = Arrays.copyOf(place, POSE * n);
        maySleep = Arrays.copyOf(maySleep, n);
        start = Arrays.copyOf(start, POSE * n);
        restsInBlock = new int[Blocks.count(n, BODIES_PER_BLOCK)];
    }

    /**
     * A body begins, falls asleep or is woken: nothing is remembered of it.
     *
     * @param slot of the body
     */
    public void reset(int slot) {
        seconds[slot] = -1;
        before[slot] = -1;
        rests[slot] = false;
        stayed[slot] = -1;
        Arrays.fill(start, POSE * slot, POSE * slot + POSE, 0);
        Arrays.fill(place, POSE * slot, POSE * slot + POSE, 0);
    }

    /**
     * Whether a body has stayed about its place for so long that, among others, it is still.
     *
     * @param slot of the body
     * @return true if so
     */
    boolean isStill(int slot) {
        return stayed[slot] >= stillSeconds;
    }

    /**
     * Whether a body has stayed about its place for the time of quiet, which is enough where nearly
     * all others are still.
     */
    boolean isStaying(int slot) {
        return stayed[slot] >= stillSeconds / STILL;
    }

    /** What is remembered of each slot; slots have room already. */
    void state(StateVisitor s, int slots) {
        s.section("rest", this);
        seconds = s.array("seconds", seconds, slots);
        before = s.array("before", before, slots);
        rests = s.array("rests", rests, slots);
        maySleep = s.array("maySleep", maySleep, slots);
        start = s.array("start", start, POSE * slots);
        stayed = s.array("stayed", stayed, slots);
        place = s.array("place", place, POSE * slots);
    }

    /**
     * Looks at the awake bodies, after the solve and before forces are cleared.
     *
     * @param store the bodies
     * @param awake their slots
     * @param awakeCount how many there are
     * @param g size of gravity, m/s²
     * @param stepSeconds length of the tick, s
     * @param jobs runs the blocks
     * @return how many are at rest or still
     */
    public int run(
            BodyStore store, int[] awake, int awakeCount, double g, double stepSeconds, Jobs jobs) {
        bodies = store;
        slots = awake;
        count = awakeCount;
        gravity = g;
        step = stepSeconds;
        int blocks = Blocks.count(awakeCount, BODIES_PER_BLOCK);
        jobs.run(job, blocks);
        int sum = 0;
        for (int b = 0; b < blocks; b++) {
            sum += restsInBlock[b];
        }
        return sum;
    }

    private void block(int block, int worker) {
        int end = Blocks.end(block, BODIES_PER_BLOCK, count);
        int sum = 0;
        for (int i = Blocks.begin(block, BODIES_PER_BLOCK); i < end; i++) {
            int s = slots[i];
            if (!maySleep[s]) {
                continue;
            }
            double limit = gravity * bodies.innerRadius[s];
            double bound = bodies.surfaceSpeed(s);
            double speed = isPushed(s) ? Double.POSITIVE_INFINITY : bound * bound;
            stay(s, speed <= FAST * FAST * limit, limit);
            if (speed <= SLOW * SLOW * limit) {
                watch(s);
            } else if (seconds[s] >= 0) {
                seconds[s] = -1;
                before[s] = -1;
                rests[s] = false;
            }
            sum += rests[s] || isStill(s) ? 1 : 0;
        }
        restsInBlock[block] = sum;
    }

    private boolean isPushed(int s) {
        BodyStore b = bodies;
        return b.forceX[s] != 0
                || b.forceY[s] != 0
                || b.forceZ[s] != 0
                || b.torqueX[s] != 0
                || b.torqueY[s] != 0
                || b.torqueZ[s] != 0;
    }

    /** One more tick about its place, or at a new one. */
    private void stay(int s, boolean isSlow, double limit) {
        if (!isSlow) {
            stayed[s] = -1;
            return;
        }
        if (stayed[s] >= 0) {
            double drift = DRIFT * stillSeconds * Math.sqrt(limit);
            if (moved(s, place) <= Math.min(STAYS * bodies.innerRadius[s], drift)) {
                stayed[s] += step;
                return;
            }
        }
        stayed[s] = 0;
        remember(s, place);
    }

    /** One more tick of quiet. */
    private void watch(int s) {
        if (seconds[s] < 0) {
            seconds[s] = 0;
            remember(s, start);
            return;
        }
        seconds[s] += step;
        // A window ends with the tick that comes closest to it.
        if (seconds[s] + 0.5 * step < window) {
            return;
        }
        double moved = moved(s, start);
        double last = before[s];
        double r = bodies.innerRadius[s];
        // what is thin rises from its sag by more than a share of its size
        double sag = softness * gravity * (step * step);
        double left = Math.max(LEFT * r, Math.min(STAYS * r, sag));
        // by its own fading, and by that of a sag, which a faster motion may have hidden
        double stays = power(1 - learning * Sag.times(sag, r), (int) (seconds[s] / step + 0.5));
        double rise = learning > 0 ? Math.min(sag, moved * stays / (1 - stays)) : 0;
        boolean fades =
                moved <= FADES * last && moved * moved <= left * (last - moved) && rise <= left;
        rests[s] = last >= 0 && (moved <= NONE * r || fades);
        before[s] = moved;
        seconds[s] = 0;
        remember(s, start);
    }

    private void remember(int s, double[] poses) {
        BodyStore b = bodies;
        int o = POSE * s;
        poses[o] = b.positionX[s];
        poses[o + 1] = b.positionY[s];
        poses[o + 2] = b.positionZ[s];
        poses[o + 3] = b.orientationX[s];
        poses[o + 4] = b.orientationY[s];
        poses[o + 5] = b.orientationZ[s];
        poses[o + 6] = b.orientationW[s];
    }

    /** How far any point of the body has moved since a pose, at most; m. */
    private double moved(int s, double[] poses) {
        BodyStore b = bodies;
        int o = POSE * s;
        double x = b.positionX[s] - poses[o];
        double y = b.positionY[s] - poses[o + 1];
        double z = b.positionZ[s] - poses[o + 2];
        double qx = poses[o + 3];
        double qy = poses[o + 4];
        double qz = poses[o + 5];
        double qw = poses[o + 6];
        double ox = b.orientationX[s];
        double oy = b.orientationY[s];
        double oz = b.orientationZ[s];
        double ow = b.orientationW[s];
        // Vector part of q now times the conjugate of q then: half the angle that it turned.
        double tx = -ow * qx + ox * qw - oy * qz + oz * qy;
        double ty = -ow * qy + ox * qz + oy * qw - oz * qx;
        double tz = -ow * qz - ox * qy + oy * qx + oz * qw;
        return Math.sqrt(x * x + y * y + z * z)
                + 2 * b.outerRadius[s] * Math.sqrt(tx * tx + ty * ty + tz * tz);
    }

    /**
     * Adds what this class remembers of a body to a hash.
     *
     * @param slot of an awake body
     * @param at 0 to 17: time in the window, motion before, rest, time about its place, pose at the
     *     start, its place
     * @return bits
     */
    public long bits(int slot, int at) {
        if (at == 2) {
            return rests[slot] ? 1 : 0;
        }
        double value =
                switch (at) {
                    case 0 -> seconds[slot];
                    case 1 -> before[slot];
                    case 3 -> stayed[slot];
                    case 4, 5, 6, 7, 8, 9, 10 -> start[POSE * slot + at - 4];
                    default -> place[POSE * slot + at - 11];
                };
        return Double.doubleToRawLongBits(value);
    }

    /** By squares: {@code StrictMath.pow} is loaded at its first call, which would be in a tick. */
    private static double power(double base, int times) {
        double all = 1;
        double square = base;
        for (int n = times; n > 0; n >>= 1) {
            all *= (n & 1) != 0 ? square : 1;
            square *= square;
        }
        return all;
    }
}
