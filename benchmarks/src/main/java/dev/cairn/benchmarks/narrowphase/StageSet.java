package dev.cairn.benchmarks.narrowphase;

import dev.cairn.core.job.Jobs;
import dev.cairn.physics.contact.BoundsStage;
import dev.cairn.physics.contact.ManifoldStage;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactMaterials;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.tuning.Tuning;

import org.joml.Quaterniond;
import org.joml.Vector3d;

/**
 * The narrow phase as a step runs it: pairs of one kind as rows of a contact store, through {@link
 * ManifoldStage}, gather and store included. One worker.
 */
public final class StageSet implements AutoCloseable {
    /** Sets of {@link PairSet#SIZE} pairs. */
    private static final int SETS = 8;

    /** Rows. */
    public static final int ROWS = SETS * PairSet.SIZE;

    private static final double STEP_SECONDS = 1.0 / 60.0;

    private final PairSet[] sets = new PairSet[SETS];
    private final BodyStore bodies = new BodyStore();
    private final ColliderStore colliders = new ColliderStore(bodies);
    private final ContactStore rows = new ContactStore();
    private final BoundsStage bounds = new BoundsStage(colliders, Tuning.DEFAULT);
    private final ManifoldStage stage = new ManifoldStage(colliders, bounds);
    private final Jobs jobs = Jobs.of(1);

    /**
     * A stage with pairs of one kind.
     *
     * @param kind of all pairs
     */
    public StageSet(PairSet.Kind kind) {
        bodies.ensureCapacity(2 * ROWS);
        bodies.slotCount = 2 * ROWS;
        bounds.ensureSlots(2 * ROWS);
        rows.ensureCapacity(ROWS);
        rows.count = ROWS;
        rows.activateAll();
        for (int s = 0; s < SETS; s++) {
            sets[s] = new PairSet(kind, s + 1);
            for (int i = 0; i < PairSet.SIZE; i++) {
                int row = s * PairSet.SIZE + i;
                colliders.attach(2 * row, sets[s].a[i]);
                colliders.attach(2 * row + 1, sets[s].b[i]);
                ContactMaterials.join(rows, row, colliders, 2 * row, 2 * row + 1);
                turn(2 * row, sets[s].turnA[i]);
                // Moving bodies do not expect to be at the same place in the next tick.
                bodies.velocityX[2 * row + 1] = 0.5;
            }
        }
        move(0);
    }

    private void turn(int slot, Quaterniond q) {
        bodies.orientationX[slot] = q.x;
        bodies.orientationY[slot] = q.y;
        bodies.orientationZ[slot] = q.z;
        bodies.orientationW[slot] = q.w;
    }

    /**
     * Moves every B to its place in a tick.
     *
     * @param tick any
     */
    public void move(int tick) {
        for (int s = 0; s < SETS; s++) {
            sets[s].move(tick);
            for (int i = 0; i < PairSet.SIZE; i++) {
                int slot = 2 * (s * PairSet.SIZE + i) + 1;
                Vector3d d = sets[s].offset[i];
                bodies.positionX[slot] = d.x;
                bodies.positionY[slot] = d.y;
                bodies.positionZ[slot] = d.z;
                turn(slot, sets[s].turnB[i]);
            }
        }
    }

    /** Collides all rows. */
    public void run() {
        stage.run(rows, STEP_SECONDS, jobs);
    }

    /**
     * What was found.
     *
     * @return number of points of all rows
     */
    public int points() {
        int points = 0;
        for (int row = 0; row < ROWS; row++) {
            points += rows.pointCount[row];
        }
        return points;
    }

    @Override
    public void close() {
        jobs.close();
    }
}
