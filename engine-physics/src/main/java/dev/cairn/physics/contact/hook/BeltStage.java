package dev.cairn.physics.contact.hook;

import dev.cairn.core.job.BlockJob;
import dev.cairn.core.job.Blocks;
import dev.cairn.core.job.Jobs;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.Palettes;
import dev.cairn.physics.internal.PerWorker;
import dev.cairn.physics.internal.Rotations;

/**
 * Surfaces that move along while their bodies do not: by how much, at each contact, B's surface
 * runs faster than A's, {@code u = u_B - u_A}; where only one of the two bodies moves by itself, by
 * how much the other's does. Of u what is along the contact counts, {@code u - (u . n) n}: a belt
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
    private final PerWorker<double[]> scratch = new PerWorker<>(() -> new double[3]);

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
        scratch.ensure(jobs.workers());
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
                boolean isFloorA = colliders.bodies.kind[c.bodyA[row]] != BodyStore.DYNAMIC;
                add(row, c.colliderA[row], c.bodyA[row], isFloorA ? 1 : -1, scratch.of(worker));
                add(row, c.colliderB[row], c.bodyB[row], isFloorA ? -1 : 1, scratch.of(worker));
                flatten(row);
            }
        }
    }

    private void add(int row, int collider, int body, double sign, double[] u) {
        double[] belt = colliders.belt;
        BodyStore b = colliders.bodies;
        int at = 3 * collider;
        int triangle = contacts.grouped ? contacts.triangle[row] : 0;
        int material = triangle > 0 ? colliders.material(collider, triangle - 1) : -1;
        if (material >= 0) {
            belt = colliders.palettes.of(collider);
            at = material + Palettes.BELT;
        }
        if ((belt[at] == 0 && belt[at + 1] == 0 && belt[at + 2] == 0)
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
        contacts.belt[3 * row] += sign * u[0];
        contacts.belt[3 * row + 1] += sign * u[1];
        contacts.belt[3 * row + 2] += sign * u[2];
    }

    /** What is along the contact. */
    private void flatten(int row) {
        ContactStore c = contacts;
        double nx = c.normalX(row);
        double ny = c.normalY(row);
        double nz = c.normalZ(row);
        double x = c.belt[3 * row];
        double y = c.belt[3 * row + 1];
        double z = c.belt[3 * row + 2];
        double away = x * nx + y * ny + z * nz;
        c.belt[3 * row] = x - away * nx;
        c.belt[3 * row + 1] = y - away * ny;
        c.belt[3 * row + 2] = z - away * nz;
    }
}
