package dev.cairn.physics.contact;

import dev.cairn.core.job.BlockJob;
import dev.cairn.core.job.Blocks;
import dev.cairn.core.job.Jobs;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.PerWorker;

/**
 * Colliders of bodies with several follow their bodies, once a tick, after these have moved; what
 * sleeps or is fixed stays where it was put. Bodies with one collider have nothing to follow.
 *
 * <p>Simulation thread, in blocks of bodies; allocates nothing but a few numbers for each worker.
 */
public final class ComposeStage {
    private static final int BODIES_PER_BLOCK = 32;

    private final ColliderStore colliders;
    private final BlockJob job = this::block;
    private final PerWorker<double[]> scratch = new PerWorker<>(() -> new double[3]);

    /** Of some colliders. */
    public ComposeStage(ColliderStore colliders) {
        this.colliders = colliders;
    }

    /** Puts them where their bodies are. */
    public void run(Jobs jobs) {
        if (colliders.compoundCount == 0) {
            return;
        }
        scratch.ensure(jobs.workers());
        jobs.run(job, Blocks.count(colliders.compoundCount, BODIES_PER_BLOCK));
    }

    private void block(int block, int worker) {
        byte[] kind = colliders.bodies.kind;
        int end = Blocks.end(block, BODIES_PER_BLOCK, colliders.compoundCount);
        for (int i = Blocks.begin(block, BODIES_PER_BLOCK); i < end; i++) {
            int slot = colliders.compound[i];
            if (kind[slot] != BodyStore.FREE && kind[slot] != BodyStore.ASLEEP) {
                colliders.compose(slot, scratch.of(worker));
            }
        }
    }
}
