package dev.cairn.physics.solver.graph;

import dev.cairn.physics.island.Islands;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.joint.Assemblies;
import dev.cairn.physics.solver.row.EdgeList;
import dev.cairn.physics.tuning.Tunable;

import java.util.Arrays;
import java.util.function.IntUnaryOperator;

/**
 * Cuts the edges of a tick into batches that share no body that moves, so that a worker takes a
 * batch through the whole tick on its own.
 *
 * <p>Problem: in lockstep all contacts of a scene stream through the caches in each of the passes,
 * and the workers wait for each other after each colour of each pass. Islands do not see each
 * other; the rows of one that fits the cache stay there for all sub-steps, and no worker waits. So
 * islands are gathered into batches, in the order of their smallest slot, up to {@link #WANTED}
 * rows; what one worker should not have alone goes to batch 0, which all workers solve in lockstep.
 * Islands of more than {@link #LARGEST} rows are cut into {@link Domains}, a batch each, with the
 * edges between these in batch 0. A batch has islands whose rows are of one precision, and there is
 * a batch in lockstep with domains for each precision.
 *
 * <p>The order in which the edges of an island are solved is the same in both, and so are the bits:
 * the cut may depend on the number of workers. Simulation thread; allocates only when a store has
 * grown.
 */
public final class Batches {
    /**
     * Rows up to which small islands are put together: some 700 bytes each in a cache of 512 KiB.
     */
    static final int WANTED = 320;

    /** A larger island is cut into domains. */
    private static final int LARGEST = Tunable.LARGE_ISLAND - 1;

    /** Kinds of rows, in the order of their batches. */
    public static final int FLOATS = 0;

    public static final int DOUBLES = 1;

    /** In {@link #tally}: the island is cut into domains. */
    private static final int CUT = -1;

    private final Islands islands = new Islands();

    /** Whether islands are those of the edges that were cut last. */
    private boolean knowsIslands;

    private final Domains domains = new Domains();

    /** Batches, those in lockstep and the domains included. */
    public int count;

    /** By kind of rows: the batch in lockstep, its domains after it; the first alone. */
    private final int[] lockstep = new int[2];

    private final int[] alone = new int[2];

    /** An empty batch, after those whose rows are floats, before those of doubles. */
    public int divider;

    /** By slot of a body with edges: whether its rows are floats. */
    public boolean[] isSingle = {};

    /**
     * By slot of the smallest body of an island: whether it is an assembly that touches nothing.
     */
    private boolean[] swings = {};

    private int floatsFrom;

    /** The first of the batches whose islands are assemblies that touch nothing. */
    private int firstSwinging;

    private final IntUnaryOperator batchFinder = this::batchOfBody;

    /** By domain: its batch. */
    private int[] batchOfDomain = {};

    /** Bodies with edges, by batch and then by slot; where those of each batch start. */
    public int[] order = {};

    public int[] firstBody = new int[2];

    /** Bodies with edges, by slot. */
    public int[] bound = {};

    public int boundCount;

    /** By slot: rows of the island whose smallest slot it is, then its batch. */
    private int[] tally = {};

    /** By row: its batch; by batch: where its rows start in {@link #byBatch}. */
    private int[] batchOf = {};

    public int[] firstRow = new int[2];

    /** Rows by batch, in their order. */
    public int[] byBatch = {};

    private void ensureCapacity(int slots, int rows) {
        if (order.length < slots) {
            int n = Math.max(slots, order.length + (order.length >> 1));
            order = new int[n];
            bound = new int[n];
            tally = new int[n];
            isSingle = new boolean[n];
            swings = new boolean[n];
        }
        islands.ensureSlots(order.length);
        if (byBatch.length < rows) {
            int n = Math.max(rows, Math.max(64, byBatch.length + (byBatch.length >> 1)));
            byBatch = new int[n];
            batchOf = new int[n];
        }
        int most = Math.max(order.length, byBatch.length) + 4;
        if (firstBody.length < most) {
            firstBody = new int[most];
            firstRow = new int[most];
            batchOfDomain = new int[most];
        }
    }

    /**
     * Cuts the rows.
     *
     * @param slots of bodies
     * @param guide tells which bodies have edges
     * @param workers that take part
     * @param floatsFrom rows of an island that are floats if there are as many
     * @param assemblies those of the tick; they are told which batch each is in
     */
    public void cut(
            EdgeList list,
            int slots,
            int[] guide,
            int workers,
            int floatsFrom,
            Assemblies assemblies) {
        this.floatsFrom = floatsFrom;
        ensureCapacity(slots, list.source.length);
        boundCount = 0;
        for (int i = 0; i < slots; i++) {
            if (guide[i] != SolverBodies.FREE) {
                bound[boundCount++] = i;
            }
        }
        boolean isOne = floatsFrom == 0 || list.count < floatsFrom;
        knowsIslands = false;
        if (isOne && list.count <= WANTED && assemblies.count() == 0) {
            whole(list, isSingle(list.count) ? FLOATS : DOUBLES);
        } else {
            islands(list);
            gather(list, workers, assemblies);
            assemblies.sort(batchFinder, count);
        }
    }

    private void gather(EdgeList list, int workers, Assemblies assemblies) {
        tally(list);
        findSwinging(list, assemblies);
        for (int k = 0; k < boundCount; k++) {
            int root = islands.root(bound[k]);
            isSingle[bound[k]] = !swings[root] && isSingle(tally[root]);
        }
        cutLarge(list);
        // an island that would keep one worker busy while the others wait is for all
        int share = workers == 1 ? LARGEST : list.count / (2 * workers);
        int largest = Math.max(WANTED, Math.min(LARGEST, share));
        count = 0;
        number(FLOATS, largest);
        divider = count++;
        number(DOUBLES, largest);
        firstSwinging = count;
        assign(DOUBLES, Integer.MAX_VALUE, true);
        for (int m = 0; m < list.count; m++) {
            list.isSingle[m] = isSingle[batchOf[m]];
            int batch = tally[batchOf[m]];
            batchOf[m] = batch == CUT ? domain(list, m) : batch;
        }
        sortRows(list);
        sortBodies();
    }

    /** All in one batch. */
    private void whole(EdgeList list, int kind) {
        count = 0;
        int target = 0;
        for (int k = FLOATS; k <= DOUBLES; k++) {
            lockstep[k] = count++;
            alone[k] = count;
            if (k == kind) {
                target = count++;
            }
            if (k == FLOATS) {
                divider = count++;
            }
        }
        firstSwinging = count;
        System.arraycopy(bound, 0, order, 0, boundCount);
        for (int k = 0; k < boundCount; k++) {
            isSingle[bound[k]] = kind == FLOATS;
        }
        for (int m = 0; m < list.count; m++) {
            byBatch[m] = m;
            batchOf[m] = target;
            list.isSingle[m] = kind == FLOATS;
        }
        for (int b = 0; b <= count; b++) {
            firstRow[b] = b <= target ? 0 : list.count;
            firstBody[b] = b <= target ? 0 : boundCount;
        }
    }

    /** Counts the rows of each island. */
    private void tally(EdgeList list) {
        for (int k = 0; k < boundCount; k++) {
            tally[bound[k]] = 0;
        }
        for (int m = 0; m < list.count; m++) {
            int root = islands.root(list.mover(m));
            batchOf[m] = root;
            tally[root]++;
        }
    }

    /** Finds the islands that touch nothing and are solved directly. */
    private void findSwinging(EdgeList list, Assemblies assemblies) {
        for (int k = 0; k < boundCount; k++) {
            int root = islands.root(bound[k]);
            swings[bound[k]] = root == bound[k] && assemblies.binds(root);
        }
        for (int m = 0; m < list.contacts; m++) {
            swings[batchOf[m]] = false;
        }
    }

    /** Whether a batch is one of assemblies that touch nothing. */
    public boolean isSwinging(int batch) {
        return batch >= firstSwinging;
    }

    /** Whether the rows of an island are floats. */
    private boolean isSingle(int islandRows) {
        return islandRows >= floatsFrom;
    }

    /** Cuts what is too large. */
    private void cutLarge(EdgeList list) {
        boolean cuts = false;
        for (int k = 0; k < boundCount; k++) {
            if (tally[bound[k]] > LARGEST && !swings[bound[k]]) {
                tally[bound[k]] = CUT;
                cuts = true;
            }
        }
        domains.count = 0;
        if (cuts) {
            domains.cut(list, islands, batchOf, tally, CUT, bound, boundCount);
        }
    }

    /** Numbers the batches of one kind: the one in lockstep, its domains, those of islands. */
    private void number(int kind, int largest) {
        lockstep[kind] = count++;
        for (int d = 0; d < domains.count; d++) {
            if (kindOf(domains.seed[d]) == kind) {
                batchOfDomain[d] = count++;
            }
        }
        alone[kind] = count;
        assign(kind, largest, false);
    }

    /** Kind of rows of a body with edges. */
    public int kindOf(int slot) {
        return isSingle[slot] ? FLOATS : DOUBLES;
    }

    /** The batch in lockstep of one kind; its domains follow. */
    public int lockstep(int kind) {
        return lockstep[kind];
    }

    /** The first of the batches of a kind that one worker has alone. */
    public int alone(int kind) {
        return alone[kind];
    }

    /** Whether any island has rows of a kind. */
    public boolean hasBodies(int kind) {
        return firstBody[end(kind)] > firstBody[lockstep[kind]];
    }

    /** Rows of a kind. */
    public int rows(int kind) {
        return firstRow[end(kind)] - firstRow[lockstep[kind]];
    }

    /**
     * Whether each island of a batch that one worker has alone is so small that one worker has it
     * alone however many there are.
     */
    public boolean isSmall(int batch) {
        return firstRow[batch + 1] - firstRow[batch] <= WANTED;
    }

    /** End of the batches of a kind that one worker has alone. */
    public int end(int kind) {
        return kind == FLOATS ? divider : count;
    }

    private void assign(int kind, int largest, boolean swinging) {
        int open = 0;
        int openRows = WANTED;
        for (int k = 0; k < boundCount; k++) {
            int i = bound[k];
            if (islands.root(i) != i
                    || tally[i] == CUT
                    || kindOf(i) != kind
                    || swings[i] != swinging) {
                continue;
            }
            int n = tally[i];
            if (n > largest) {
                tally[i] = lockstep[kind];
                continue;
            }
            if (openRows + n > WANTED) {
                open = count++;
                openRows = 0;
            }
            openRows += n;
            tally[i] = open;
        }
    }

    /** The batch of an edge within a domain; that in lockstep for one between two of them. */
    private int domain(EdgeList list, int m) {
        int of = domains.of[list.mover(m)];
        boolean isWithin = !list.isBetweenMovers(m) || of == domains.of[list.slotB[m]];
        return isWithin ? batchOfDomain[of] : lockstep[kindOf(list.slotA[m])];
    }

    private void sortRows(EdgeList list) {
        Arrays.fill(firstRow, 0, count + 1, 0);
        for (int m = 0; m < list.count; m++) {
            firstRow[batchOf[m] + 1]++;
        }
        for (int b = 0; b < count; b++) {
            firstRow[b + 1] += firstRow[b];
        }
        for (int m = 0; m < list.count; m++) {
            byBatch[firstRow[batchOf[m]]++] = m;
        }
        shift(firstRow);
    }

    private void sortBodies() {
        Arrays.fill(firstBody, 0, count + 1, 0);
        for (int k = 0; k < boundCount; k++) {
            firstBody[batchOfBody(bound[k]) + 1]++;
        }
        for (int b = 0; b < count; b++) {
            firstBody[b + 1] += firstBody[b];
        }
        for (int k = 0; k < boundCount; k++) {
            order[firstBody[batchOfBody(bound[k])]++] = bound[k];
        }
        shift(firstBody);
    }

    private int batchOfBody(int slot) {
        int batch = tally[islands.root(slot)];
        return batch == CUT ? batchOfDomain[domains.of[slot]] : batch;
    }

    /** The islands of the edges that were cut last, which are still those of the list. */
    public Islands islands(EdgeList list) {
        if (!knowsIslands) {
            islands.begin(bound, boundCount);
            for (int m = 0; m < list.count; m++) {
                if (list.isBetweenMovers(m)) {
                    islands.join(list.slotA[m], list.slotB[m]);
                }
            }
            knowsIslands = true;
        }
        return islands;
    }

    /** The batch of a row. */
    public int batchOfRow(int m) {
        return batchOf[m];
    }

    /** The batch that a row is solved with: of a domain, that in lockstep. */
    int groupOfRow(int m) {
        int batch = batchOf[m];
        int kind = batch < divider ? FLOATS : DOUBLES;
        return batch < alone[kind] ? lockstep[kind] : batch;
    }

    /** Whether a row is in a batch in lockstep. */
    boolean isLockstep(int m) {
        int batch = batchOf[m];
        return batch == lockstep[batch < divider ? FLOATS : DOUBLES];
    }

    /** Ends become starts again. */
    private void shift(int[] first) {
        System.arraycopy(first, 0, first, 1, count);
        first[0] = 0;
    }
}
