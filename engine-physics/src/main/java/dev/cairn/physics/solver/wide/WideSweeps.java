package dev.cairn.physics.solver.wide;

import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.KernelWarmUp;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.kernel.RowSweeps;
import dev.cairn.physics.solver.kernel.Sweeps;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.EdgeList;
import dev.cairn.physics.solver.row.Scratch;
import dev.cairn.physics.solver.row.SubStep;
import dev.cairn.physics.tuning.Tuning;

import org.jspecify.annotations.Nullable;

import java.util.Arrays;
import java.util.SplittableRandom;

/**
 * The wide sweeps, once the compiler is done with them; the scalar ones before that. They are
 * warmed up on made-up rows: in the background when the number of lanes was left to the machine, at
 * once when it was asked for.
 */
public final class WideSweeps implements Sweeps {
    private final Sweeps wide;
    private final Sweeps scalar;
    private final boolean isSingle;
    private final WarmUp warmUp;
    private volatile boolean isWanted;

    public WideSweeps(Sweeps wide, boolean isSingle) {
        this.wide = wide;
        this.isSingle = isSingle;
        scalar = RowSweeps.scalar(isSingle);
        warmUp = new WarmUp();
    }

    @Override
    public int lanes() {
        return wide.lanes();
    }

    @Override
    public void fill(
            ConstraintRows rows,
            SolverBodies bodies,
            ContactStore contacts,
            SubStep sub,
            int from,
            int to,
            Scratch scratch) {
        (warmUp.isReady() || isWanted ? wide : scalar)
                .fill(rows, bodies, contacts, sub, from, to, scratch);
    }

    @Override
    public void bias(
            ConstraintRows rows,
            SolverBodies bodies,
            SubStep sub,
            int from,
            int to,
            Scratch scratch) {
        (warmUp.isReady() || isWanted ? wide : scalar).bias(rows, bodies, sub, from, to, scratch);
    }

    @Override
    public void relax(
            ConstraintRows rows,
            SolverBodies bodies,
            SubStep sub,
            int from,
            int to,
            Scratch scratch) {
        (warmUp.isReady() || isWanted ? wide : scalar).relax(rows, bodies, sub, from, to, scratch);
    }

    @Override
    public void store(
            ConstraintRows rows,
            SolverBodies bodies,
            ContactStore contacts,
            SubStep sub,
            int from,
            int to,
            Scratch scratch) {
        (warmUp.isReady() || isWanted ? wide : scalar)
                .store(rows, bodies, contacts, sub, from, to, scratch);
    }

    /** Whether the wide sweeps are in use. */
    public boolean isWarm() {
        return warmUp.isReady() || isWanted;
    }

    /** Starts to warm up in the background, once. */
    public void begin() {
        warmUp.begin();
    }

    /** Warms up now, unless that has been done; uses them if they pay off. */
    void await() {
        warmUp.finish();
    }

    /** Warms up now, unless that has been done, and uses them even if they do not pay off. */
    public void finish() {
        warmUp.finish();
        isWanted = true;
    }

    /** Rounds of both sweeps over the same rows. */
    private final class WarmUp extends KernelWarmUp {
        /** There from the first round to the last. */
        private @Nullable MadeUpRows rows;

        private long bestWide = Long.MAX_VALUE;
        private long bestScalar = Long.MAX_VALUE;

        WarmUp() {
            super("cairn-warm-up" + (isSingle ? "-floats" : "-doubles"), 3_000, 20_000);
        }

        @Override
        protected boolean run(int round) {
            if (rows == null) {
                rows = new MadeUpRows();
            }
            long scalarNanos = time(rows, scalar, round);
            long wideNanos = time(rows, wide, round);
            if (round % 2 == 0) {
                bestScalar = Math.min(bestScalar, scalarNanos);
                bestWide = Math.min(bestWide, wideNanos);
            }
            return wideNanos < 2 * scalarNanos;
        }

        private static long time(MadeUpRows rows, Sweeps sweeps, int round) {
            rows.fill(round);
            long start = System.nanoTime();
            rows.pass(sweeps);
            return System.nanoTime() - start;
        }

        @Override
        protected void end() {
            rows = null;
        }

        @Override
        protected boolean paysOff() {
            return bestWide < bestScalar;
        }

        @Override
        protected void giveUp() {
            Lanes.warn(
                    "The contact solver gains nothing from sweeps of "
                            + lanes()
                            + " lanes and stays scalar, unless lanes were asked for: they took "
                            + bestWide
                            + " ns on this JVM, scalar ones "
                            + bestScalar
                            + " ns. The results are the same.");
        }
    }

    /** What the kernels are warmed up on. */
    private final class MadeUpRows {
        private final EdgeList list = new EdgeList(lanes(), lanes(), lanes(), lanes());
        private final ConstraintRows rows = isSingle ? list.floats : list.doubles;
        private final ContactStore contacts = new ContactStore();
        private final SolverBodies bodies = new SolverBodies();
        private final Scratch scratch = new Scratch();
        private final SubStep sub = new SubStep();
        private final SplittableRandom random = new SplittableRandom(1);

        MadeUpRows() {
            contacts.ensureCapacity(ConstraintRows.CHUNK);
            bodies.ensureCapacity(2 * ConstraintRows.CHUNK);
            sub.set(1 / 60.0, 1 / 240.0, Tuning.DEFAULT);
            sub.fillScale = 1;
            sub.still = 0.01;
        }

        void fill(int round) {
            WideSweeps.fill(rows, bodies, contacts, random, round);
        }

        void pass(Sweeps sweeps) {
            int to = rows.places;
            sweeps.fill(rows, bodies, contacts, sub, 0, to, scratch);
            sweeps.bias(rows, bodies, sub, 0, to, scratch);
            sweeps.relax(rows, bodies, sub, 0, to, scratch);
            sweeps.store(rows, bodies, contacts, sub, 0, to, scratch);
        }
    }

    /**
     * Contacts between pairs of bodies, as unlike as those of a scene: what a compiled kernel has
     * not seen it does not know, and then it is interpreted once more, with its vectors on the
     * heap.
     */
    private static void fill(
            ConstraintRows rows,
            SolverBodies bodies,
            ContactStore c,
            SplittableRandom random,
            int round) {
        int n = ConstraintRows.CHUNK;
        rows.ensurePlaces(n);
        rows.places = n;
        random(random, bodies.state, 0.01);
        random(random, bodies.root, 1);
        random(random, bodies.warm, 0.01);
        Arrays.fill(bodies.state, 0, SolverBodies.STRIDE, 0.0);
        for (double[] column :
                new double[][] {c.head, c.anchors, c.separation, c.normalImpulse, c.preload}) {
            random(random, column, 1);
        }
        for (int j = 0; j < n; j++) {
            contact(rows, bodies, c, round, j);
        }
    }

    /**
     * One contact. Its points are set by factors, not by questions: of a loop with questions in it
     * the compiler makes a copy for each mix of answers, and had more to do with these rows than
     * with any kernel.
     */
    private static void contact(
            ConstraintRows rows, SolverBodies bodies, ContactStore c, int round, int j) {
        int l = j * ConstraintRows.LINK;
        boolean pads = (j + round) % 8 == 5 && round % 3 == 0;
        rows.link[l] = pads || j % 7 == 0 ? 0 : (2 * j + 1) * SolverBodies.STRIDE;
        rows.link[l + 1] = pads ? 0 : (2 * j + 2) * SolverBodies.STRIDE;
        rows.link[l + ConstraintRows.SOURCE] = j;
        c.pointCount[j] = 1 + (round + j / 8) % 4;
        rows.link[l + ConstraintRows.COUNT] = pads ? 0 : c.pointCount[j];
        c.setFriction(j, (round + j / 8) % 16 == 0 ? 0 : 0.5);
        boolean cold = round % 4 == 3 && j % 5 == 0;
        // whole groups that are far apart, and such that touch and part
        boolean apart = (round + j / 16) % 8 == 6;
        boolean parts = (round + j / 16) % 8 == 3;
        double loaded = cold || apart || parts ? 0 : 1;
        double own = apart || parts ? 0 : 1;
        double gap = apart ? 1000 : parts ? -1e-9 : 0;
        for (int p = ContactStore.POINTS * j; p < ContactStore.POINTS * (j + 1); p++) {
            c.normalImpulse[p] = loaded * Math.abs(c.normalImpulse[p]);
            c.separation[p] = gap + own * c.separation[p];
            c.preload[p] *= own;
        }
        if (parts) {
            c.setFrictionImpulse(j, 0, 0, 0, 0);
            part(bodies, c, j);
        }
        rows.settleMark[j] = (byte) ((j + round) % 11 == 0 ? 1 : 0);
        bodies.state[(2 * j + 1) * SolverBodies.STRIDE + SolverBodies.MASS] = 0.5;
        bodies.state[(2 * j + 2) * SolverBodies.STRIDE + SolverBodies.MASS] = 0.5;
        for (int slot = 2 * j; slot < 2 * j + 2; slot++) {
            bodies.round(slot);
            bodies.roundRoot(slot);
        }
    }

    /** Moves the bodies of contact {@code j} away from each other, without turning. */
    private static void part(SolverBodies bodies, ContactStore c, int j) {
        int a = (2 * j + 1) * SolverBodies.STRIDE;
        int b = (2 * j + 2) * SolverBodies.STRIDE;
        Arrays.fill(bodies.state, a, a + 6, 0.0);
        Arrays.fill(bodies.state, b, b + 6, 0.0);
        bodies.state[b] = c.normalX(j);
        bodies.state[b + 1] = c.normalY(j);
        bodies.state[b + 2] = c.normalZ(j);
    }

    private static void random(SplittableRandom random, double[] column, double size) {
        for (int i = 0; i < column.length; i++) {
            column[i] = size * (random.nextDouble() - 0.3);
        }
    }
}
