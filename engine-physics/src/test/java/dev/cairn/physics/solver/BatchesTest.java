package dev.cairn.physics.solver;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.job.Jobs;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.graph.Batches;
import dev.cairn.physics.solver.joint.Assemblies;
import dev.cairn.physics.solver.row.EdgeList;
import dev.cairn.physics.tuning.Tunable;
import dev.cairn.physics.tuning.Tuning;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.Arrays;

/** Islands in batches: a partition that shares no body, and the bits of lockstep. */
@Tag("compiled")
class BatchesTest {
    private static final int COLUMNS = 100;
    private static final int ON_PLATE = 360;

    /** Columns of four, and one large island: a plate with boxes on it. */
    private static SolverScene scene(Jobs jobs, Tuning settings) {
        SolverScene s = new SolverScene(settings, jobs);
        int plane = s.fixed();
        int[] column = new int[4];
        for (int i = 0; i < COLUMNS; i++) {
            for (int k = 0; k < 4; k++) {
                column[k] = s.box(1, 0.5, 0.5, 0.5, 3 * i + 0.02 * k, 0.5 + 1.001 * k, 0);
            }
            s.boxOnPlane(plane, column[0], 0, 1, 0, 0, 0.5, 0);
            for (int k = 1; k < 4; k++) {
                s.boxOnBox(column[k - 1], column[k], 0.5, 0);
            }
            s.velocity(column[3], 0.01 * i, 0, 0);
        }
        int plate = s.box(100, 40, 0.5, 40, 0, 0.5, 90);
        s.boxOnPlane(plane, plate, 0, 1, 0, 0, 0.5, 0);
        for (int i = 0; i < ON_PLATE; i++) {
            int box = s.box(1, 0.5, 0.5, 0.5, 2 * (i % 20) - 20, 1.52, 90 - 20 + 2 * (i / 20.0));
            s.boxOnBox(plate, box, 0.5, 0);
        }
        return s;
    }

    private static double[] state(SolverScene s, int bodies) {
        double[] all = new double[4 * bodies];
        System.arraycopy(s.bodies.positionX, 0, all, 0, bodies);
        System.arraycopy(s.bodies.positionY, 0, all, bodies, bodies);
        System.arraycopy(s.bodies.velocityY, 0, all, 2 * bodies, bodies);
        System.arraycopy(s.bodies.angularVelocityZ, 0, all, 3 * bodies, bodies);
        return all;
    }

    private static double[] run(int workers, boolean bouncing) {
        return run(workers, bouncing, Integer.MAX_VALUE, 0);
    }

    private static double[] run(int workers, boolean bouncing, int floatsFrom, int lanes) {
        Tuning settings =
                SolverScene.DOUBLES
                        .with(Tunable.FLOATS_FROM, floatsFrom)
                        .with(Tunable.LANES, lanes);
        try (Jobs jobs = Jobs.of(workers)) {
            SolverScene s = scene(jobs, settings);
            int bodies = s.bodies.slotCount;
            if (bouncing) {
                int ball = s.sphere(1, 0.5, -50, 0.6, 0);
                s.sphereOnPlane(0, ball, 0, 1, 0, 0, 0.5, 0.5);
            }
            for (int tick = 0; tick < 20; tick++) {
                s.tick(SolverScene.TICK);
            }
            return state(s, bodies);
        }
    }

    /** What bounces puts the whole scene in lockstep; it must not be felt elsewhere. */
    @Test
    void theSameBitsAsInLockstep() {
        double[] batched = run(1, false);
        assertArrayEquals(batched, run(1, true), 0.0, "one worker, lockstep");
        for (int workers = 2; workers <= 4; workers++) {
            assertArrayEquals(batched, run(workers, false), 0.0, workers + " workers");
            assertArrayEquals(batched, run(workers, true), 0.0, workers + " workers, lockstep");
        }
    }

    /** Where large islands are floats, each body does what it does if all are what it is. */
    @Test
    void eachIslandHasItsPrecision() {
        double[] doubles = run(1, false);
        double[] floats = run(1, false, 0, 1);
        int bodies = doubles.length / 4;
        double[] expected = doubles.clone();
        int plate = 4 * COLUMNS + 1;
        for (int part = 0; part < 4; part++) {
            int from = part * bodies + plate;
            System.arraycopy(floats, from, expected, from, bodies - plate);
        }
        assertFalse(Arrays.equals(doubles, expected), "floats change nothing");
        for (int workers = 1; workers <= 4; workers++) {
            int lanes = workers % 2 == 0 ? 4 : 1;
            String who = workers + " workers, lanes " + lanes;
            assertArrayEquals(expected, run(workers, false, ON_PLATE, lanes), 0.0, who);
            assertArrayEquals(
                    expected, run(workers, true, ON_PLATE, lanes), 0.0, who + ", lockstep");
        }
    }

    private static boolean isLockstep(Batches batches, int b) {
        return b == batches.lockstep(Batches.FLOATS) || b == batches.lockstep(Batches.DOUBLES);
    }

    /** All bodies but the first have contacts. */
    static Batches cut(SolverScene s, EdgeList list, int workers, int floatsFrom) {
        s.collide();
        list.ensureCapacity(s.contacts.count);
        list.count = s.contacts.count;
        list.contacts = list.count;
        int[] guide = new int[s.bodies.slotCount];
        Arrays.fill(guide, SolverBodies.BOUND);
        guide[0] = SolverBodies.FREE;
        for (int m = 0; m < list.count; m++) {
            list.source[m] = m;
            list.slotA[m] = mover(s, s.contacts.bodyA[m]);
            list.slotB[m] = mover(s, s.contacts.bodyB[m]);
        }
        Batches batches = new Batches();
        batches.cut(list, s.bodies.slotCount, guide, workers, floatsFrom, new Assemblies(list));
        return batches;
    }

    private static int mover(SolverScene s, int slot) {
        return s.bodies.kind[slot] == BodyStore.DYNAMIC ? slot : -1;
    }

    /** From 100 contacts on, those of an island are floats: the plate's. */
    @ParameterizedTest(name = "floats from {0} contacts")
    @ValueSource(ints = {0, 100, Integer.MAX_VALUE})
    void noBodyIsInTwoBatchesAndNothingIsLost(int floatsFrom) {
        for (int workers : new int[] {1, 2}) {
            SolverScene s = scene(Jobs.of(1), SolverScene.DOUBLES);
            EdgeList list = new EdgeList();
            Batches batches = cut(s, list, workers, floatsFrom);
            assertTrue(batches.count > 2, "batches: " + batches.count);
            int[] home = new int[s.bodies.slotCount];
            Arrays.fill(home, -1);
            for (int b = 0; b < batches.count; b++) {
                for (int k = batches.firstBody[b]; k < batches.firstBody[b + 1]; k++) {
                    assertEquals(-1, home[batches.order[k]], "a body twice");
                    home[batches.order[k]] = b;
                }
            }
            boolean[] seen = new boolean[list.count];
            for (int b = 0; b < batches.count; b++) {
                int size = batches.firstRow[b + 1] - batches.firstRow[b];
                assertTrue(isLockstep(batches, b) || size <= 1024, "rows of a batch: " + size);
                for (int k = batches.firstRow[b]; k < batches.firstRow[b + 1]; k++) {
                    int m = batches.byBatch[k];
                    assertTrue(!seen[m], "a row twice");
                    seen[m] = true;
                    assertEquals(b < batches.divider, list.isSingle[m], "precision of a row");
                    for (int i : new int[] {s.contacts.bodyA[m], s.contacts.bodyB[m]}) {
                        if (s.bodies.kind[i] == BodyStore.DYNAMIC) {
                            assertEquals(b, home[i], "body and row are apart");
                        }
                    }
                }
            }
            for (boolean row : seen) {
                assertTrue(row, "a row is lost");
            }
            // the plate is too large a share for one of two workers
            int plate = 4 * COLUMNS + 1;
            assertEquals(workers > 1, isLockstep(batches, home[plate]));
            assertEquals(floatsFrom <= ON_PLATE, batches.isSingle[plate]);
            assertEquals(floatsFrom == 0, batches.isSingle[1]);
        }
    }
}
