package dev.cairn.physics.solver;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.job.Jobs;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.kernel.RowSweeps;
import dev.cairn.physics.solver.kernel.Sweeps;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.Scratch;
import dev.cairn.physics.solver.row.SubStep;
import dev.cairn.physics.solver.wide.Lanes;
import dev.cairn.physics.solver.wide.WideSweeps;
import dev.cairn.physics.tuning.Tunable;
import dev.cairn.physics.tuning.Tuning;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.logging.Handler;
import java.util.logging.Level;
import java.util.logging.LogRecord;
import java.util.logging.Logger;

/** Wide kernels that are no faster than scalar code are left alone: a warning, the same bits. */
@Tag("compiled")
class WideSweepsTest {
    private static final String NAME = "dev.cairn.physics";

    /** Wide sweeps of a machine that is bad at them: they do everything twice. */
    private static final class Slow implements Sweeps {
        private final Sweeps scalar;

        Slow(boolean isSingle) {
            scalar = RowSweeps.scalar(isSingle);
        }

        @Override
        public int lanes() {
            return 4;
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
            scalar.fill(rows, bodies, contacts, sub, from, to, scratch);
            scalar.fill(rows, bodies, contacts, sub, from, to, scratch);
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
            scalar.store(rows, bodies, contacts, sub, from, to, scratch);
            scalar.store(rows, bodies, contacts, sub, from, to, scratch);
        }

        @Override
        public void bias(
                ConstraintRows rows,
                SolverBodies bodies,
                SubStep sub,
                int from,
                int to,
                Scratch scratch) {
            scalar.bias(rows, bodies, sub, from, to, scratch);
            scalar.bias(rows, bodies, sub, from, to, scratch);
        }

        @Override
        public void relax(
                ConstraintRows rows,
                SolverBodies bodies,
                SubStep sub,
                int from,
                int to,
                Scratch scratch) {
            scalar.relax(rows, bodies, sub, from, to, scratch);
            scalar.relax(rows, bodies, sub, from, to, scratch);
        }
    }

    private static double[] columns(Sweeps sweeps, int lanes, boolean isSingle) {
        Tuning settings =
                SolverScene.DOUBLES
                        .with(Tunable.LANES, lanes)
                        .with(Tunable.FLOATS_FROM, isSingle ? 0 : Integer.MAX_VALUE);
        try (Jobs jobs = Jobs.of(1)) {
            SolverScene s = new SolverScene(new ContactSolver(settings, sweeps, sweeps), jobs);
            int plane = s.fixed();
            for (int column = 0; column < 5; column++) {
                int below = s.box(1, 0.5, 0.5, 0.5, 2 * column, 0.5, 0);
                s.boxOnPlane(plane, below, 0, 1, 0, 0, 0.5, 0);
                int above = s.box(1, 0.5, 0.5, 0.5, 2 * column + 0.2, 1.55, 0);
                s.velocity(above, 0.5, 0, 0.1 * column);
                s.boxOnBox(below, above, 0.5, 0);
            }
            s.run(1);
            int n = s.bodies.slotCount;
            double[] all = new double[4 * n];
            System.arraycopy(s.bodies.positionX, 0, all, 0, n);
            System.arraycopy(s.bodies.positionY, 0, all, n, n);
            System.arraycopy(s.bodies.velocityX, 0, all, 2 * n, n);
            System.arraycopy(s.bodies.angularVelocityZ, 0, all, 3 * n, n);
            return all;
        }
    }

    @ParameterizedTest(name = "in single precision: {0}")
    @ValueSource(booleans = {false, true})
    void slowKernelsAreLeftAlone(boolean isSingle) throws InterruptedException {
        List<LogRecord> records = new CopyOnWriteArrayList<>();
        Handler handler =
                new Handler() {
                    @Override
                    public void publish(LogRecord record) {
                        records.add(record);
                    }

                    @Override
                    public void flush() {}

                    @Override
                    public void close() {}
                };
        Logger logger = Logger.getLogger(NAME);
        logger.addHandler(handler);
        WideSweeps wide = new WideSweeps(new Slow(isSingle), isSingle);
        try {
            wide.begin();
            for (Thread thread : Thread.getAllStackTraces().keySet()) {
                if (thread.getName().startsWith("cairn-warm-up")) {
                    thread.join();
                }
            }
        } finally {
            logger.removeHandler(handler);
        }
        assertFalse(wide.isWarm());
        assertEquals(1, records.size(), "one warning and nothing else");
        assertEquals(Level.WARNING, records.getFirst().getLevel());
        assertTrue(records.getFirst().getMessage().contains("stays scalar"));
        double[] scalar = columns(RowSweeps.scalar(isSingle), 1, isSingle);
        assertArrayEquals(scalar, columns(wide, 4, isSingle), 0.0, "asked for, but not warm");
        assertArrayEquals(scalar, columns(wide, 0, isSingle), 0.0, "left to the machine");
        for (int lanes = 4; lanes <= (isSingle ? 8 : 4); lanes += 4) {
            Sweeps real = Lanes.sweeps(lanes, isSingle, true);
            assertArrayEquals(scalar, columns(real, lanes, isSingle), 0.0, lanes + " real ones");
        }
    }
}
