package dev.cairn.physics.island;

import dev.cairn.core.job.BlockJob;
import dev.cairn.core.job.Blocks;
import dev.cairn.core.job.Jobs;
import dev.cairn.core.state.StateVisitor;
import dev.cairn.physics.internal.BodyStore;

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

    /** A motion that fades by less than this in a window counts as steady. */
    private static final double FADES = 0.95;

    /** What may be left to travel, over the inner radius. */
    private static final double LEFT = 0.002;

    /** A motion over a window that counts as none, over the inner radius. */
    private static final double NONE = 5e-6;

    private static final int BODIES_PER_BLOCK = 256;
    private static final int POSE = 7;

    private final double window;
    private final BlockJob job = this::block;

    /** How long the body has been quiet in the present window, s; negative: no window has begun. */
    double[] seconds = {};

    /** What its surface moved in the window before, m; negative if there was none. */
    double[] before = {};

    /** Whether it was at rest when the last window ended, and has been quiet since. */
    boolean[] rests = {};

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
     */
    public RestDetector(double sleepSeconds) {
        window = 0.5 * sleepSeconds;
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
        maySleep = Arrays.copyOf(maySleep, n);
        start = Arrays.copyOf(start, POSE * n);
        restsInBlock = new int[Blocks.count(n, BODIES_PER_BLOCK)];
    }

    /**
     * A body begins, or is woken.
     *
     * @param slot of the body
     */
    public void reset(int slot) {
        seconds[slot] = -1;
        before[slot] = -1;
        rests[slot] = false;
    }

    /** What is remembered of each slot; slots have room already. */
    void state(StateVisitor s, int slots) {
        s.section("rest", this);
        seconds = s.array("seconds", seconds, slots);
        before = s.array("before", before, slots);
        rests = s.array("rests", rests, slots);
        maySleep = s.array("maySleep", maySleep, slots);
        start = s.array("start", start, POSE * slots);
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
     * @return how many are at rest
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
            if (isQuiet(s)) {
                watch(s);
            } else if (seconds[s] >= 0) {
                reset(s);
            }
            sum += rests[s] ? 1 : 0;
        }
        restsInBlock[block] = sum;
    }

    private boolean isQuiet(int s) {
        BodyStore b = bodies;
        double vx = b.velocityX[s];
        double vy = b.velocityY[s];
        double vz = b.velocityZ[s];
        double wx = b.angularVelocityX[s];
        double wy = b.angularVelocityY[s];
        double wz = b.angularVelocityZ[s];
        // |v| + R |w| <= limit, without roots for those that move
        double limit = SLOW * SLOW * gravity * b.innerRadius[s];
        double outer = b.outerRadius[s];
        double v = vx * vx + vy * vy + vz * vz;
        double w = (wx * wx + wy * wy + wz * wz) * outer * outer;
        if (!(v <= limit && w <= limit && v + w + 2 * Math.sqrt(v * w) <= limit)) {
            return false;
        }
        return b.forceX[s] == 0
                && b.forceY[s] == 0
                && b.forceZ[s] == 0
                && b.torqueX[s] == 0
                && b.torqueY[s] == 0
                && b.torqueZ[s] == 0;
    }

    /** One more tick of quiet. */
    private void watch(int s) {
        if (seconds[s] < 0) {
            seconds[s] = 0;
            remember(s);
            return;
        }
        seconds[s] += step;
        // A window ends with the tick that comes closest to it.
        if (seconds[s] + 0.5 * step < window) {
            return;
        }
        double moved = moved(s);
        double last = before[s];
        double r = bodies.innerRadius[s];
        boolean fades = moved <= FADES * last && moved * moved <= LEFT * r * (last - moved);
        rests[s] = last >= 0 && (moved <= NONE * r || fades);
        before[s] = moved;
        seconds[s] = 0;
        remember(s);
    }

    private void remember(int s) {
        BodyStore b = bodies;
        int o = POSE * s;
        start[o] = b.positionX[s];
        start[o + 1] = b.positionY[s];
        start[o + 2] = b.positionZ[s];
        start[o + 3] = b.orientationX[s];
        start[o + 4] = b.orientationY[s];
        start[o + 5] = b.orientationZ[s];
        start[o + 6] = b.orientationW[s];
    }

    /** How far any point of the body has moved since the window began, at most; m. */
    private double moved(int s) {
        BodyStore b = bodies;
        int o = POSE * s;
        double x = b.positionX[s] - start[o];
        double y = b.positionY[s] - start[o + 1];
        double z = b.positionZ[s] - start[o + 2];
        double qx = start[o + 3];
        double qy = start[o + 4];
        double qz = start[o + 5];
        double qw = start[o + 6];
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
     * @param at 0 to 9: time in the window, motion before, rest, pose at the start
     * @return bits
     */
    public long bits(int slot, int at) {
        if (at == 2) {
            return rests[slot] ? 1 : 0;
        }
        double value =
                at == 0 ? seconds[slot] : at == 1 ? before[slot] : start[POSE * slot + at - 3];
        return Double.doubleToRawLongBits(value);
    }
}
