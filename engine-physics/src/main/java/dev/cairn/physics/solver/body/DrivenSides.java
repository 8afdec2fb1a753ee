package dev.cairn.physics.solver.body;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactColumns;

import java.util.Arrays;

/**
 * Kinematic bodies that move, as the solver sees them: to each edge with one a body of its own, of
 * inverse mass 0, that moves as the body says. So no two edges share it: batches may be in
 * different sub-steps, and lanes may write what they have read.
 *
 * <p>A body of the solver turns as {@code w = L y}, and an impulse changes {@code y} by {@code L^T
 * (r x n)}. For an inertia without end L would be 0, and the body could not turn. Here the first
 * column of L is {@code e w}, and y is {@code (1/e, 0, 0)}, with a power of two e so small that
 * what an impulse adds to y is lost to rounding: then the speed of each point, {@code w.(r x n)},
 * is right to the last digit, and nothing stops the body.
 *
 * <p>The velocity of a body that speeds up goes from sub-step to sub-step, by {@link
 * BodyStore#ramp} over the tick, about that of the tick. So a rider is pulled along evenly, not at
 * the start of each tick alone, where friction, bounded by the load of one sub-step, gives way.
 *
 * <p>They lie behind the bodies of all slots. Simulation thread, but for {@link #move}, which any
 * worker calls for the batch that it has. Allocates only while their number grows.
 */
public final class DrivenSides {
    /** Speeds times impulses up to 1e19 J are lost beside the square of its inverse. */
    private static final double LEVER = 0x1p-60;

    /** Numbers to a body of {@link BodyStore#ramp}. */
    private static final int RAMP = BodyStore.RAMP;

    private int firstSlot;
    private int count;

    /** By side: slot of the kinematic body. */
    private int[] body = {};

    /** By side: its edge. */
    private int[] edge = {};

    /** By side: velocity of the surface against its body, world, m/s, three numbers. */
    private double[] belt = {};

    /** By side: velocity and y of the first column over the whole tick, four numbers. */
    private double[] mean = {};

    /** Whether the velocity of one changes within the tick. */
    private boolean ramps;

    /** By batch: its first side; one more for the end of the last. */
    private int[] first = new int[2];

    private int batches;

    /** Sides of another list of edges follow, batch by batch. */
    public void begin(int slots, int batchCount) {
        firstSlot = slots;
        count = 0;
        batches = batchCount;
        if (first.length <= batchCount) {
            first = new int[batchCount + (batchCount >> 1) + 2];
        }
    }

    /** What is added next belongs to a batch; they come in order. */
    public void beginBatch(int batch) {
        first[batch] = count;
        first[batch + 1] = count;
    }

    /**
     * Adds a side to the batch that was begun.
     *
     * @param slot of a kinematic body
     * @param m its edge
     * @return where the side lies in {@link SolverBodies#state}
     */
    public int add(int slot, int m, int batch) {
        if (count == body.length) {
            body = Arrays.copyOf(body, Math.max(16, 2 * count));
            edge = Arrays.copyOf(edge, body.length);
            belt = Arrays.copyOf(belt, 3 * body.length);
            mean = new double[RAMP * body.length];
        }
        edge[count] = m;
        body[count] = slot;
        first[batch + 1] = count + 1;
        return SolverBodies.offset(firstSlot + count++);
    }

    /** The first side of a batch; that of the next one ends them. */
    public int from(int batch) {
        return count == 0 ? 0 : first[batch];
    }

    /** The edge of a side. */
    public int edge(int side) {
        return edge[side];
    }

    /** Slot of the kinematic body of a side. */
    public int slot(int side) {
        return body[side];
    }

    /** Twice the largest speed of a point of a side, m/s. */
    public double twiceFastest(SolverBodies s, int side) {
        return s.fastest[firstSlot + side];
    }

    /** How many there are. */
    public int count() {
        return count;
    }

    /**
     * Puts all where their bodies are at the start of the tick.
     *
     * @param c has the surfaces that move along
     * @param source by edge: its row
     * @param contactCount edges that are contacts, which come first
     */
    public void load(
            BodyStore b, SolverBodies s, ContactColumns c, int[] source, int contactCount) {
        s.drivenFrom = count == 0 ? Integer.MAX_VALUE : SolverBodies.offset(firstSlot);
        ramps = false;
        for (int k = 0; k < count; k++) {
            boolean has = c.belts && edge[k] < contactCount;
            for (int n = 0; n < 3; n++) {
                belt[3 * k + n] = has ? c.belt[3 * source[edge[k]] + n] : 0;
            }
            load(b, s, k, body[k]);
        }
    }

    private void load(BodyStore b, SolverBodies s, int k, int slot) {
        int i = firstSlot + k;
        int o = SolverBodies.offset(i);
        int r = (i + 1) * SolverBodies.ROOT;
        int w = (i + 1) * SolverBodies.HALF;
        double[] v = s.state;
        Arrays.fill(v, o, o + SolverBodies.STRIDE, 0.0);
        Arrays.fill(s.root, r, r + SolverBodies.ROOT, 0.0);
        Arrays.fill(s.warm, w, w + SolverBodies.HALF, 0.0);
        // a velocity of -0 would be 0 once something was added to it
        v[o] = b.velocityX[slot] + belt[3 * k] + 0.0;
        v[o + 1] = b.velocityY[slot] + belt[3 * k + 1] + 0.0;
        v[o + 2] = b.velocityZ[slot] + belt[3 * k + 2] + 0.0;
        double x = b.angularVelocityX[slot];
        double y = b.angularVelocityY[slot];
        double z = b.angularVelocityZ[slot];
        if (x != 0 || y != 0 || z != 0) {
            v[o + SolverBodies.V + 3] = 1 / LEVER;
            s.root[r] = LEVER * x;
            s.root[r + 3] = LEVER * y;
            s.root[r + 6] = LEVER * z;
        }
        double spin = SolverBodies.norm(x, y, z);
        double most = SolverBodies.norm(v[o], v[o + 1], v[o + 2]) + spin * b.outerRadius[slot];
        for (int n = 0; n < RAMP; n++) {
            mean[RAMP * k + n] = v[o + n];
            double ramp = ramp(b, slot, n);
            ramps |= ramp != 0;
            most += n < 3 ? Math.abs(ramp) : Math.abs(ramp) * spin * b.outerRadius[slot];
        }
        s.fastest[i] = 2 * most;
        s.impactTime[i] = 0;
        s.shifted[i] = false;
        s.round(i);
        s.roundRoot(i);
    }

    private static double ramp(BodyStore b, int slot, int n) {
        return b.kind[slot] == BodyStore.KINEMATIC ? b.ramp[RAMP * slot + n] : 0;
    }

    /**
     * Gives the sides of a batch the velocity of a sub-step: {@code v + ((k + 1/2)/n - 1/2) dv},
     * {@code dv} the change over the tick. The mean is v, so the tick ends where it shall.
     *
     * @param k index of the sub-step
     * @param substeps n
     * @param single whether the batch's rows are floats
     */
    public void pace(BodyStore b, SolverBodies s, int batch, int k, int substeps, boolean single) {
        if (!ramps || batch >= batches) {
            return;
        }
        double at = (k + 0.5) / substeps - 0.5;
        for (int side = first[batch]; side < first[batch + 1]; side++) {
            int i = firstSlot + side;
            int o = SolverBodies.offset(i);
            for (int n = 0; n < RAMP; n++) {
                double u = mean[RAMP * side + n];
                double by = at * ramp(b, body[side], n);
                s.state[o + n] = u + (n < 3 ? by : by * u) + 0.0;
            }
            if (single) {
                s.roundVelocity(i);
            }
        }
    }

    /**
     * Moves the sides of a batch.
     *
     * @param h length of the sub-step, s
     * @param single whether the batch's rows are floats
     */
    public void move(SolverBodies s, int batch, double h, boolean single) {
        if (count == 0 || batch >= batches) {
            return;
        }
        double[] v = s.state;
        for (int k = first[batch]; k < first[batch + 1]; k++) {
            int i = firstSlot + k;
            int o = SolverBodies.offset(i);
            for (int n = 0; n < 6; n++) {
                // a surface that moves along takes its body nowhere
                double speed = v[o + SolverBodies.V + n] - (n < 3 ? belt[3 * k + n] : 0);
                v[o + SolverBodies.P + n] += h * speed;
            }
            if (single) {
                s.round(i);
            }
        }
    }

    /** Whether a point of one may meet another body faster than this, m/s. */
    public boolean isFast(SolverBodies s, double speed) {
        for (int k = 0; k < count; k++) {
            if (!(s.fastest[firstSlot + k] < speed)) {
                return true;
            }
        }
        return false;
    }

    /** Twice the largest speed of a point of the side at an offset of the state, m/s. */
    public static double fastest(SolverBodies s, int offset) {
        return offset == 0 ? 0 : s.fastest[SolverBodies.slot(offset)];
    }
}
