package dev.cairn.physics.solver;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.cairn.core.job.Jobs;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.solver.graph.Batches;
import dev.cairn.physics.solver.graph.Domains;
import dev.cairn.physics.solver.row.EdgeList;
import dev.cairn.physics.tuning.Tunable;
import dev.cairn.physics.tuning.Tuning;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.Arrays;

/** Large islands in domains: a partition, the same bits for all, and momentum. */
@Tag("compiled")
class DomainsTest {
    /** 1156 contacts: more than a batch may have. */
    private static final int COURSES = 34;

    /** A wall of bricks in a triangle, on a plane that is body 0 if the scene is empty. */
    private static void wall(SolverScene s, int plane, double z) {
        int[] below = new int[COURSES];
        for (int course = 0; course < COURSES; course++) {
            for (int i = 0; i < COURSES - course; i++) {
                int brick = s.box(1, 0.48, 0.5, 0.5, i + 0.5 * course, 0.5 + 1.0005 * course, z);
                if (course == 0) {
                    s.boxOnPlane(plane, brick, 0, 1, 0, 0, 0.5, 0);
                } else {
                    s.boxOnBox(below[i], brick, 0.5, 0);
                    s.boxOnBox(below[i + 1], brick, 0.5, 0);
                }
                below[i] = brick;
            }
        }
    }

    @Test
    void domainsShareNoBodyAndTheRestIsFew() {
        SolverScene s = new SolverScene();
        int plane = s.fixed();
        wall(s, plane, 0);
        wall(s, plane, 10);
        EdgeList list = new EdgeList();
        Batches batches = BatchesTest.cut(s, list, 1, Integer.MAX_VALUE);
        int base = batches.lockstep(Batches.DOUBLES);
        int domains = batches.alone(Batches.DOUBLES) - base - 1;
        assertTrue(domains >= 4, "domains: " + domains);
        assertEquals(base + 1 + domains, batches.count);
        int[] home = new int[s.bodies.slotCount];
        Arrays.fill(home, -1);
        for (int b = 0; b < batches.count; b++) {
            for (int k = batches.firstBody[b]; k < batches.firstBody[b + 1]; k++) {
                assertEquals(-1, home[batches.order[k]], "a body twice");
                home[batches.order[k]] = b;
            }
        }
        int seen = 0;
        for (int b = 0; b < batches.count; b++) {
            int size = batches.firstRow[b + 1] - batches.firstRow[b];
            assertTrue(b == base || size < Domains.WANTED + 8, "rows of a domain: " + size);
            for (int k = batches.firstRow[b]; k < batches.firstRow[b + 1]; k++) {
                int m = batches.byBatch[k];
                int i = s.contacts.bodyA[m];
                int j = s.contacts.bodyB[m];
                seen++;
                if (b == base) {
                    assertNotEquals(home[i], home[j], "within a domain, yet in lockstep");
                    assertTrue(i != plane && j != plane, "the plane ties no domains");
                } else {
                    assertTrue(i == plane || home[i] == b, "body and row are apart");
                    assertTrue(j == plane || home[j] == b, "body and row are apart");
                }
            }
        }
        assertEquals(list.count, seen);
        int between = batches.firstRow[base + 1] - batches.firstRow[base];
        assertTrue(between > 0 && between < 0.15 * list.count, between + " of " + list.count);
    }

    /** What a wall does that is struck, turns a brick, and loses the load on its top. */
    private static double[] run(int lanes, int workers, boolean bouncing, boolean another) {
        Tuning settings = SolverScene.DOUBLES.with(Tunable.LANES, lanes);
        try (Jobs jobs = Jobs.of(workers)) {
            SolverScene s = new SolverScene(settings, jobs);
            int plane = s.fixed();
            wall(s, plane, 0);
            int bodies = s.bodies.slotCount;
            if (bouncing) {
                int ball = s.sphere(1, 0.5, -50, 0.6, 0);
                s.sphereOnPlane(plane, ball, 0, 1, 0, 0, 0.5, 0.5);
            }
            if (another) {
                wall(s, plane, 10);
            }
            s.spin(COURSES, 0, 1.5, 0);
            for (int tick = 0; tick < 16; tick++) {
                if (tick == 8) {
                    s.velocity(bodies - 1, 0, 40, 0);
                    s.velocity(bodies - 2, -3, 20, 0);
                }
                s.tick(SolverScene.TICK);
            }
            double[] all = new double[4 * bodies];
            System.arraycopy(s.bodies.positionX, 0, all, 0, bodies);
            System.arraycopy(s.bodies.positionY, 0, all, bodies, bodies);
            System.arraycopy(s.bodies.velocityY, 0, all, 2 * bodies, bodies);
            System.arraycopy(s.bodies.angularVelocityZ, 0, all, 3 * bodies, bodies);
            return all;
        }
    }

    @Test
    void theSameBitsForAllWorkersAndLanesAndWhateverElseThereIs() {
        double[] wanted = run(1, 1, false, false);
        for (int workers : new int[] {1, 2, 4}) {
            assertArrayEquals(wanted, run(4, workers, false, false), 0.0, workers + " workers");
        }
        assertArrayEquals(wanted, run(8, 2, false, false), 0.0, "8 lanes");
        assertArrayEquals(wanted, run(4, 2, true, false), 0.0, "a ball that bounces elsewhere");
        assertArrayEquals(wanted, run(4, 3, false, true), 0.0, "another wall");
    }

    /** What the ground gives in a tick is what gravity takes and the bodies gain. */
    @Test
    void allContactsAreSolvedAndReportedOnce() {
        Tuning own = SolverScene.DOUBLES;
        own = own.with(Tunable.LOAD_INERTIA, 0);
        SolverScene s = new SolverScene(own.with(Tunable.LANES, 4), Jobs.of(1));
        int plane = s.fixed();
        wall(s, plane, 0);
        BodyStore b = s.bodies;
        double weight = 9.81 * (b.slotCount - 1);
        double before = 0;
        for (int tick = 0; tick < 40; tick++) {
            s.tick(SolverScene.TICK);
            double momentum = 0;
            for (int i = 1; i < b.slotCount; i++) {
                momentum += b.velocityY[i];
            }
            double ground = 0;
            for (int m = 0; m < s.contacts.count; m++) {
                for (int p = 4 * m; p < 4 * m + s.contacts.pointCount[m]; p++) {
                    ground += s.contacts.bodyA[m] == plane ? s.contacts.totalNormalImpulse[p] : 0;
                }
            }
            double gained = ground - weight * SolverScene.TICK;
            assertEquals(momentum - before, gained, 1e-10, "tick " + tick + ", N s");
            before = momentum;
        }
    }
}
