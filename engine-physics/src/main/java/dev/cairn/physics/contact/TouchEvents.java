package dev.cairn.physics.contact;

import dev.cairn.core.job.BlockJob;
import dev.cairn.core.job.Blocks;
import dev.cairn.core.job.Jobs;
import dev.cairn.core.state.StateVisitor;
import dev.cairn.core.state.Stateful;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;

import java.util.Arrays;

/**
 * Which pairs began and ceased to touch in a tick: first the touches that ended with their row,
 * then the others, in row order, and last those of pairs with several rows.
 *
 * <p>A pair begins to touch when one of its points overlaps or pushes; it ceases when no point is
 * within the speculative margin any more. Between the two the state stays, so that a resting pair
 * does not flicker.
 *
 * <p>Simulation thread; allocates only when a list grows.
 */
public final class TouchEvents implements Stateful {
    private static final int ROWS_PER_BLOCK = 512;

    private final BlockJob job = this::block;
    private ContactStore contacts = new ContactStore();
    private int[] changesInBlock = {};
    private byte[] change = {};

    /** Colliders A and B of pairs that began to touch, and of pairs that ceased. */
    public final PairList began = new PairList(), ended = new PairList();

    private final BlockJob approachJob = this::approachBlock;
    private BodyStore bodies = new BodyStore();
    private double hitSpeed = Double.POSITIVE_INFINITY;
    private int[] hits = new int[16];
    private int hitCount;

    /** Without events. */
    public TouchEvents() {}

    /** Empties both lists; at the start of a tick. */
    public void clear() {
        began.clear();
        ended.clear();
        hitCount = 0;
    }

    /**
     * From which approach speed on a touch that begins is a hit; between steps.
     *
     * @param rows whose speeds are noted
     * @param speed m/s, at least 0; infinite for no hits, which costs nothing
     */
    public void setHitSpeed(ContactStore rows, double speed) {
        hitSpeed = speed;
        if (speed < Double.POSITIVE_INFINITY) {
            rows.beginHits();
        }
    }

    /**
     * Notes how fast pairs approach that do not touch yet; before the solve, if hits are wanted.
     *
     * @param store velocities at the start of the tick
     */
    public void approach(ContactStore rows, BodyStore store, Jobs jobs) {
        if (hitSpeed == Double.POSITIVE_INFINITY) {
            return;
        }
        contacts = rows;
        bodies = store;
        jobs.run(approachJob, Blocks.count(rows.activeCount, ROWS_PER_BLOCK));
    }

    private void approachBlock(int block, int worker) {
        ContactStore c = contacts;
        int end = Blocks.end(block, ROWS_PER_BLOCK, c.activeCount);
        for (int i = Blocks.begin(block, ROWS_PER_BLOCK); i < end; i++) {
            int row = c.active[i];
            if (c.touching[row] == 0) {
                c.approach[row] = speed(c, row);
            }
        }
    }

    /** The largest (vA + wA x rA - vB - wB x rB) . n of the points, 0 if there are none. */
    private double speed(ContactStore c, int row) {
        BodyStore b = bodies;
        int i = c.bodyA[row];
        int j = c.bodyB[row];
        double nx = c.normalX(row);
        double ny = c.normalY(row);
        double nz = c.normalZ(row);
        double most = 0;
        int first = ContactStore.POINTS * row;
        for (int p = first; p < first + c.pointCount[row]; p++) {
            double x = b.pointVelocityX(i, c.anchorAY(p), c.anchorAZ(p));
            double y = b.pointVelocityY(i, c.anchorAX(p), c.anchorAZ(p));
            double z = b.pointVelocityZ(i, c.anchorAX(p), c.anchorAY(p));
            x -= b.pointVelocityX(j, c.anchorBY(p), c.anchorBZ(p));
            y -= b.pointVelocityY(j, c.anchorBX(p), c.anchorBZ(p));
            z -= b.pointVelocityZ(j, c.anchorBX(p), c.anchorBY(p));
            most = Math.max(most, x * nx + y * ny + z * nz);
        }
        return most;
    }

    /** How many pairs met at speed. */
    public int hitCount() {
        return hitCount;
    }

    /**
     * The row of a pair that met at speed; until the next tick.
     *
     * @param hit 0 to hitCount - 1
     */
    public int hit(int hit) {
        return hits[hit];
    }

    /**
     * Compares the active rows with their state before; after the solve. A pair that sleeps stays
     * as it is.
     *
     * @param pairs knows the pairs with several rows
     */
    public void update(ContactStore rows, ContactRows pairs, Jobs jobs) {
        PairGroups groups = pairs.groups;
        contacts = rows;
        int count = rows.activeCount;
        if (change.length < rows.bodyA.length) {
            change = new byte[rows.bodyA.length];
            changesInBlock = new int[Blocks.count(change.length, ROWS_PER_BLOCK)];
        }
        int blocks = Blocks.count(count, ROWS_PER_BLOCK);
        jobs.run(job, blocks);
        collect(rows, groups, blocks);
    }

    /** Pairs with several rows are told once, after the others. */
    private void collect(ContactStore rows, PairGroups groups, int blocks) {
        int count = rows.activeCount;
        for (int b = 0; b < blocks; b++) {
            if (changesInBlock[b] == 0) {
                continue;
            }
            int end = Blocks.end(b, ROWS_PER_BLOCK, count);
            for (int i = Blocks.begin(b, ROWS_PER_BLOCK); i < end; i++) {
                int row = rows.active[i];
                if (rows.grouped && rows.group[row] != 0) {
                    if (change[i] != 0) {
                        groups.change(Math.abs(rows.group[row]), change[i] > 0, row);
                    }
                } else if (change[i] > 0) {
                    begin(rows, row);
                } else if (change[i] < 0) {
                    ended.add(rows.colliderA[row], rows.colliderB[row]);
                }
            }
        }
        for (int i = 0; i < groups.changes; i++) {
            int row = groups.row(i);
            int outcome = groups.outcome(i);
            if (outcome > 0) {
                begin(rows, row);
            } else if (outcome < 0) {
                ended.add(rows.colliderA[row], rows.colliderB[row]);
            }
        }
        groups.endChanges();
    }

    private void block(int block, int worker) {
        ContactStore c = contacts;
        int end = Blocks.end(block, ROWS_PER_BLOCK, c.activeCount);
        int changes = 0;
        for (int i = Blocks.begin(block, ROWS_PER_BLOCK); i < end; i++) {
            int row = c.active[i];
            change[i] = 0;
            if (c.touching[row] == 0) {
                if (pushes(c, row)) {
                    c.touching[row] = 1;
                    change[i] = 1;
                    changes++;
                }
            } else if (!c.isSolved(row)) {
                c.touching[row] = 0;
                change[i] = -1;
                changes++;
            }
        }
        changesInBlock[block] = changes;
    }

    private static boolean pushes(ContactStore c, int row) {
        int first = ContactStore.POINTS * row;
        int end = first + c.pointCount[row];
        for (int p = first; p < end; p++) {
            if (c.totalNormalImpulse[p] > 0 || c.separation[p] <= 0) {
                return true;
            }
        }
        return false;
    }

    private void begin(ContactStore rows, int row) {
        if (hitSpeed < Double.POSITIVE_INFINITY && rows.approach[row] >= hitSpeed) {
            if (hitCount == hits.length) {
                hits = Arrays.copyOf(hits, 2 * hitCount);
            }
            hits[hitCount++] = row;
        }
        began.add(rows.colliderA[row], rows.colliderB[row]);
    }

    @Override
    public void state(StateVisitor s) {
        s.section("touches", this);
        hitSpeed = s.value("hitSpeed", hitSpeed);
        hitCount = s.count("hitCount", hitCount);
        hits = s.array("hits", hits, hitCount);
        began.state(s);
        ended.state(s);
    }
}
