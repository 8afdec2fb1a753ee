package dev.cairn.physics.contact;

import dev.cairn.core.job.BlockJob;
import dev.cairn.core.job.Blocks;
import dev.cairn.core.job.Jobs;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.Rotations;

/**
 * Surfaces that move while their bodies do not: with what velocity the surface of a contact runs
 * along. Of the belt's velocity u what is along the contact counts, {@code u - (u . n) n}: a belt
 * drags, and pushes nothing away.
 *
 * <p>Between points and solve, in blocks of active rows, only while some collider has such a
 * surface. Allocates nothing but a few numbers for each worker.
 */
public final class BeltStage {
    private static final int ROWS_PER_BLOCK = 128;

    private final ColliderStore colliders;
    private final ContactStore contacts;
    private final BlockJob job = this::block;
    private double[][] scratch = {};

    /** Of some rows. */
    public BeltStage(ColliderStore colliders, ContactStore contacts) {
        this.colliders = colliders;
        this.contacts = contacts;
    }

    /** Notes the velocities of all active rows. */
    public void run(Jobs jobs) {
        if (!contacts.belts) {
            return;
        }
        if (scratch.length < jobs.workers()) {
            scratch = new double[jobs.workers()][3];
        }
        jobs.run(job, Blocks.count(contacts.activeCount, ROWS_PER_BLOCK));
    }

    private void block(int block, int worker) {
        ContactStore c = contacts;
        int end = Blocks.end(block, ROWS_PER_BLOCK, c.activeCount);
        for (int i = Blocks.begin(block, ROWS_PER_BLOCK); i < end; i++) {
            int row = c.active[i];
            c.belt[3 * row] = 0;
            c.belt[3 * row + 1] = 0;
            c.belt[3 * row + 2] = 0;
            if (c.isSolved(row)) {
                add(row, c.colliderA[row], c.bodyA[row], scratch[worker]);
                add(row, c.colliderB[row], c.bodyB[row], scratch[worker]);
            }
        }
    }

    private void add(int row, int collider, int body, double[] u) {
        double[] belt = colliders.belt;
        BodyStore b = colliders.bodies;
        int at = 3 * collider;
        if ((belt[at] == 0 && belt[at + 1] == 0 && belt[at + 2] == 0)
                || b.kind[body] == BodyStore.DYNAMIC
                || b.kind[body] == BodyStore.ASLEEP) {
            return;
        }
        Rotations.rotate(
                b.orientationX[body],
                b.orientationY[body],
                b.orientationZ[body],
                b.orientationW[body],
                belt[at],
                belt[at + 1],
                belt[at + 2],
                u);
        ContactStore c = contacts;
        double nx = c.normalX(row);
        double ny = c.normalY(row);
        double nz = c.normalZ(row);
        double away = u[0] * nx + u[1] * ny + u[2] * nz;
        c.belt[3 * row] = u[0] - away * nx;
        c.belt[3 * row + 1] = u[1] - away * ny;
        c.belt[3 * row + 2] = u[2] - away * nz;
    }
}
