package dev.cairn.physics.contact.hook;

import dev.cairn.core.job.BlockJob;
import dev.cairn.core.job.Blocks;
import dev.cairn.core.job.Jobs;
import dev.cairn.physics.collider.ContactHook;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactMaterials;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.PerWorker;

import org.jspecify.annotations.Nullable;

import java.util.Arrays;

/**
 * Between points and solve: the user's hook sees each contact, and may change it for this step. A
 * world without a hook does not come here.
 *
 * <p>In blocks of active rows, one worker to a row, each row once a tick. What a hook sets does not
 * stay: friction and restitution are mixed anew before it is asked. Allocates only when the number
 * of workers grows.
 */
public final class HookStage {
    private static final int ROWS_PER_BLOCK = 64;

    private final ColliderStore colliders;
    private final ContactStore contacts;
    private final BlockJob job = this::block;
    private @Nullable ContactHook hook;
    private final PerWorker<Cursor> cursors = new PerWorker<>(Cursor::new);

    /** Without a hook. */
    public HookStage(ColliderStore colliders, ContactStore contacts) {
        this.colliders = colliders;
        this.contacts = contacts;
    }

    /** Chooses the hook; {@code null} for none. Between steps. */
    public void set(@Nullable ContactHook value) {
        if (hook != null && value == null) {
            for (int row = 0; row < contacts.count; row++) {
                ContactMaterials.mix(contacts, row, colliders);
            }
        }
        hook = value;
        if (value != null) {
            contacts.beginHooks();
        }
    }

    /** The hook that was chosen. */
    public @Nullable ContactHook get() {
        return hook;
    }

    /** Another state was restored: the hook stays, and what it remembered may never have been. */
    public void renew() {
        if (hook != null && !contacts.hooked) {
            contacts.beginHooks();
            Arrays.fill(contacts.hookMemory, 0);
        }
    }

    /** Asks the hook about all active rows. */
    public void run(Jobs jobs) {
        if (hook == null) {
            return;
        }
        cursors.ensure(jobs.workers());
        jobs.run(job, Blocks.count(contacts.activeCount, ROWS_PER_BLOCK));
    }

    private void block(int block, int worker) {
        ContactHook asked = hook;
        if (asked == null) {
            return;
        }
        Cursor cursor = cursors.of(worker);
        int end = Blocks.end(block, ROWS_PER_BLOCK, contacts.activeCount);
        for (int i = Blocks.begin(block, ROWS_PER_BLOCK); i < end; i++) {
            int row = contacts.active[i];
            if (contacts.isSolved(row)) {
                ContactMaterials.mix(contacts, row, colliders);
                cursor.row = row;
                asked.change(cursor);
            }
        }
    }

    /** One contact after another, of one worker. */
    private final class Cursor implements ContactHook.Change {
        private int row;

        @Override
        public @Nullable Object userDataA() {
            return colliders.userData[contacts.colliderA[row]];
        }

        @Override
        public @Nullable Object userDataB() {
            return colliders.userData[contacts.colliderB[row]];
        }

        @Override
        public int triangle() {
            return contacts.triangle(row);
        }

        @Override
        public double normalX() {
            return contacts.normalX(row);
        }

        @Override
        public double normalY() {
            return contacts.normalY(row);
        }

        @Override
        public double normalZ() {
            return contacts.normalZ(row);
        }

        @Override
        public double separation() {
            double least = Double.POSITIVE_INFINITY;
            int first = ContactStore.POINTS * row;
            for (int p = first; p < first + contacts.pointCount[row]; p++) {
                least = Math.min(least, contacts.separation[p]);
            }
            return least;
        }

        @Override
        public double approachSpeed() {
            BodyStore b = colliders.bodies;
            int i = contacts.bodyA[row];
            int j = contacts.bodyB[row];
            return normalX() * (b.velocityX[i] - b.velocityX[j])
                    + normalY() * (b.velocityY[i] - b.velocityY[j])
                    + normalZ() * (b.velocityZ[i] - b.velocityZ[j]);
        }

        @Override
        public double friction() {
            return contacts.friction(row);
        }

        @Override
        public void surface(double friction, double restitution) {
            if (!(friction >= 0 && friction < Double.POSITIVE_INFINITY)
                    || !(restitution >= 0 && restitution <= 1)) {
                throw new IllegalArgumentException(
                        "the contact hook set friction "
                                + friction
                                + " and restitution "
                                + restitution
                                + "; friction must be finite and at least 0, restitution 0 to 1");
            }
            contacts.setFriction(row, friction);
            contacts.restitution[row] = restitution;
        }

        @Override
        public void disable() {
            contacts.disable(row);
        }

        @Override
        public int memory() {
            return contacts.hookMemory[row];
        }

        @Override
        public void remember(int value) {
            contacts.hookMemory[row] = value;
        }
    }
}
