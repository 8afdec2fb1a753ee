package dev.cairn.physics.contact;

import dev.cairn.core.job.BlockJob;
import dev.cairn.core.job.Blocks;
import dev.cairn.core.job.Jobs;
import dev.cairn.core.state.StateVisitor;
import dev.cairn.physics.broadphase.BroadPhase;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactMaterials;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.island.SleepingBodies;

/**
 * Which pairs have a row. Rows whose fat boxes parted leave, and the last rows take their places,
 * so that a tick moves no more rows than left; new pairs follow at the end.
 *
 * <p>Simulation thread; allocates only when the number of rows grows.
 */
public final class ContactRows {
    private static final int ROWS_PER_BLOCK = 256;

    private final BlockJob markJob = this::markBlock;
    private boolean[] parted = {};
    private int[] partedInBlock = {};

    /** Places of rows that leave; rows that take them, and whether these are active. */
    private int[] hole = {}, source = {};

    private boolean[] sourceIsActive = {};

    private BroadPhase broadPhase = new BroadPhase();
    private ContactStore contacts = new ContactStore();

    private final BodyStore bodies;
    private final ColliderStore colliders;
    private final SleepingBodies sleepers;
    final PairGroups groups = new PairGroups();
    private int candidates;
    private boolean every;

    /**
     * Without rows.
     *
     * @param colliders frictions and restitutions of new rows
     * @param sleepers wakes bodies that lose a contact
     */
    public ContactRows(ColliderStore colliders, SleepingBodies sleepers) {
        this.colliders = colliders;
        bodies = colliders.bodies;
        this.sleepers = sleepers;
    }

    /** What lasts of pairs beside their rows. */
    public void state(StateVisitor s) {
        groups.state(s);
    }

    /**
     * Brings the rows in step with the broad phase's pairs, and lists those that are active: with
     * an awake body, or new, or with a fixed body that was moved.
     *
     * @param pairs after its pairs phase
     * @param events receives the touches that end with a row
     */
    public void update(
            ContactStore store,
            BroadPhase pairs,
            TouchEvents events,
            SensorStage sensors,
            Jobs jobs) {
        if (sensors.count() > 0 && pairs.movedCount() > 0) {
            sensors.drop();
        }
        broadPhase = pairs;
        contacts = store;
        boolean others = sleepers.asleepCount() > 0 && othersMoved();
        boolean stale = sleepers.takeRowsStale();
        boolean all = stale || others;
        if (others) {
            // Rows that are active for this reason are so for this tick.
            sleepers.rowsWillBeStale();
        }
        if (pairs.movedCount() > 0 && store.count > 0) {
            drop(events, all, jobs);
        }
        if (all) {
            wakeMoved();
            activate(bodies, store, pairs);
        }
        append(store, pairs, sensors);
        reserve();
    }

    /**
     * Room for all rows to leave: when the store grows, and not when the first of them leaves,
     * which may be much later. A state that was restored may have more of them than before.
     */
    private void reserve() {
        if (parted.length < contacts.bodyA.length) {
            parted = new boolean[contacts.bodyA.length];
            partedInBlock = new int[Blocks.count(parted.length, ROWS_PER_BLOCK)];
            hole = new int[parted.length];
            source = new int[parted.length];
            sourceIsActive = new boolean[parted.length];
        }
    }

    /** Whether a box changed that is not of an awake body: rows that are not active matter, too. */
    private boolean othersMoved() {
        for (int i = 0; i < broadPhase.movedCount(); i++) {
            if (bodies.kind[colliders.body[broadPhase.movedSlot(i)]] != BodyStore.DYNAMIC) {
                return true;
            }
        }
        return false;
    }

    private void drop(TouchEvents events, boolean all, Jobs jobs) {
        reserve();
        candidates = all ? contacts.count : contacts.activeCount;
        every = all;
        int blocks = Blocks.count(candidates, ROWS_PER_BLOCK);
        jobs.run(markJob, blocks);
        if (broadPhase.isRefiltered()) {
            markRefused();
        }
        int holes = 0;
        for (int block = 0; block < blocks; block++) {
            holes += partedInBlock[block];
        }
        if (holes > 0) {
            end(events);
            fill(holes);
        }
    }

    /**
     * Tells which touches end, in the order of the candidates, and lists their places, ascending.
     */
    private void end(TouchEvents events) {
        ContactStore c = contacts;
        int n = 0;
        for (int i = 0; i < candidates; i++) {
            int row = every ? i : c.active[i];
            if (!parted[row]) {
                continue;
            }
            hole[n++] = row;
            boolean touches = c.touching[row] != 0;
            if (c.grouped && c.group[row] != 0) {
                // its pair ends with the first row, and is told once
                touches = c.group[row] > 0 && groups.close(c.group[row]);
            }
            if (!c.isFurther(row)) {
                broadPhase.forget(c.colliderA[row], c.colliderB[row]);
            }
            if (touches) {
                events.ended.add(c.colliderA[row], c.colliderB[row]);
            }
            if (c.isSolved(row)) {
                sleepers.wake(c.bodyA[row]);
                sleepers.wake(c.bodyB[row]);
            }
        }
    }

    /** Moves the last rows into the holes before them; the list of active rows stays ascending. */
    private void fill(int holes) {
        ContactStore c = contacts;
        int kept = c.count - holes;
        int listed = c.activeCount;
        while (!every && listed > 0 && c.active[listed - 1] >= kept) {
            listed--;
        }
        int moved = 0;
        int read = listed;
        for (int row = kept; row < c.count; row++) {
            boolean active = !every && read < c.activeCount && c.active[read] == row;
            read += active ? 1 : 0;
            if (!parted[row]) {
                source[moved] = row;
                sourceIsActive[moved++] = active;
            }
        }
        c.move(source, hole, moved);
        // The list is wrong after all rows were looked at; update() makes it anew.
        int at = 0;
        int next = 0;
        for (int i = 0; i < (every ? 0 : listed); i++) {
            int row = c.active[i];
            if (!parted[row] || sourceIsActive[next++]) {
                c.active[at++] = row;
            }
        }
        c.activeCount = at;
        c.count = kept;
        for (int i = 0; i < holes; i++) {
            parted[hole[i]] = false;
        }
    }

    /** Marks rows whose boxes parted; leaves no mark elsewhere. */
    private void markBlock(int block, int worker) {
        ContactStore c = contacts;
        int end = Blocks.end(block, ROWS_PER_BLOCK, candidates);
        int count = 0;
        for (int i = Blocks.begin(block, ROWS_PER_BLOCK); i < end; i++) {
            int row = every ? i : c.active[i];
            int a = c.colliderA[row];
            int b = c.colliderB[row];
            boolean hasMoved = broadPhase.moved(a) || broadPhase.moved(b);
            boolean apart = (hasMoved && !broadPhase.overlap(a, b)) || isSpare(c, row);
            parted[row] = apart;
            count += apart ? 1 : 0;
        }
        partedInBlock[block] = count;
    }

    /** Whether a row is none of the first of its pair, and empty. */
    private static boolean isSpare(ContactStore c, int row) {
        return c.isFurther(row) && c.pointCount[row] == 0 && c.touching[row] == 0;
    }

    /** Marks rows that the filters refuse since they were changed; in row order. */
    private void markRefused() {
        ContactStore c = contacts;
        for (int i = 0; i < candidates; i++) {
            int row = every ? i : c.active[i];
            int a = c.colliderA[row];
            int b = c.colliderB[row];
            if (!parted[row]
                    && (broadPhase.moved(a) || broadPhase.moved(b))
                    && !broadPhase.admits(a, b)) {
                parted[row] = true;
                partedInBlock[i / ROWS_PER_BLOCK]++;
            }
        }
    }

    /** Bodies that touch a fixed body that was moved wake. */
    private void wakeMoved() {
        ContactStore c = contacts;
        for (int row = 0; sleepers.asleepCount() > 0 && row < c.count; row++) {
            if (c.isSolved(row)
                    && (broadPhase.moved(c.colliderA[row]) || broadPhase.moved(c.colliderB[row]))) {
                sleepers.wake(c.bodyA[row]);
                sleepers.wake(c.bodyB[row]);
            }
        }
    }

    /**
     * Lists the active rows anew.
     *
     * @param pairs knows which fixed bodies were moved
     */
    public static void activate(BodyStore bodies, ContactStore c, BroadPhase pairs) {
        byte[] kind = bodies.kind;
        int count = 0;
        for (int row = 0; row < c.count; row++) {
            if (kind[c.bodyA[row]] == BodyStore.DYNAMIC
                    || kind[c.bodyB[row]] == BodyStore.DYNAMIC
                    || pairs.moved(c.colliderA[row])
                    || pairs.moved(c.colliderB[row])) {
                c.active[count++] = row;
            }
        }
        c.activeCount = count;
    }

    private boolean isSurface(int a, int b) {
        return SurfaceStage.triangles(colliders.shape[a]) != null
                || SurfaceStage.triangles(colliders.shape[b]) != null;
    }

    private void append(ContactStore c, BroadPhase pairs, SensorStage sensors) {
        int added = pairs.newPairCount();
        if (added == 0) {
            return;
        }
        long[] keys = pairs.newPairs();
        int sensed = 0;
        for (int i = 0; colliders.sensors && i < added; i++) {
            sensed += sensors.takes((int) (keys[i] >>> 32), (int) keys[i]) ? 1 : 0;
        }
        if (c.count + (long) added > Integer.MAX_VALUE / (2L * ContactStore.POINTS)) {
            throw new IllegalStateException(
                    (c.count + (long) added)
                            + " pairs of shapes are near each other; at most "
                            + Integer.MAX_VALUE / (2 * ContactStore.POINTS)
                            + " rows are possible");
        }
        int row = c.count;
        if (added > sensed) {
            c.append(added - sensed);
        }
        for (int i = 0; i < added; i++) {
            int a = (int) (keys[i] >>> 32);
            int b = (int) keys[i];
            if (sensed > 0 && sensors.takes(a, b)) {
                sensors.add(a, b);
            } else {
                if (colliders.surfaces && isSurface(a, b)) {
                    c.beginGroups();
                    c.group[row] = groups.open();
                }
                ContactMaterials.join(c, row++, colliders, a, b);
            }
        }
    }
}
