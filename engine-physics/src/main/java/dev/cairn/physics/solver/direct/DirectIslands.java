package dev.cairn.physics.solver.direct;

import dev.cairn.core.state.StateVisitor;
import dev.cairn.core.state.Stateful;
import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.island.Islands;
import dev.cairn.physics.solver.graph.Batches;
import dev.cairn.physics.solver.graph.Domains;
import dev.cairn.physics.solver.load.LoadSweep;
import dev.cairn.physics.solver.row.EdgeList;
import dev.cairn.physics.tuning.Tunable;

import java.util.Arrays;

/**
 * Which islands are solved directly, see {@link DirectSolve}, and in which order their bodies are
 * eliminated.
 *
 * <p>Problem: a sweep hands an error on from contact to contact, so that a column of n boxes needs
 * some n^2 sweeps. A direct solve needs a time that grows with n if few bodies stand side by side,
 * and is out of the question for a heap. So an island is solved directly that is
 *
 * <ul>
 *   <li>long: from one end to the other, over bodies that touch, are as many bodies as the setting
 *       tells;
 *   <li>slender: the envelope of its matrix is at most {@value #WIDE} bodies wide (root of the mean
 *       square);
 *   <li>at rest, each of its bodies, as load-proportional inertia asks for it, see {@link
 *       LoadSweep}.
 * </ul>
 *
 * <p>Bodies are ordered breadth first from an end, neighbours with few contacts first, and then
 * backwards (E. Cuthill, J. McKee 1969; A. George 1971; the end is that of N. Gibbs, W. Poole, P.
 * Stockmeyer 1976, of one round). A function of the contacts alone. Simulation thread; allocates
 * only when a store has grown.
 */
public final class DirectIslands implements Stateful {
    /** Width of an envelope, in bodies. */
    private static final int WIDE = 4;

    /**
     * Inner radius over {@code g h²} at which islands are solved directly from {@link
     * Tunable#DIRECT_FROM} bodies on: 0.5 m at sub-steps of 1/240 s. A contact yields by some share
     * of {@code g h²} under its load, a stack of n leans on n of them, each under n bodies, and
     * falls when that makes up for its width: so what is smaller needs it from fewer on, as the
     * root of its radius.
     */
    private static final double STIFF = 3000;

    /** Contacts of an island, at most: what is larger is cut into {@link Domains}. */
    private static final int MOST_ROWS = Tunable.LARGE_ISLAND - 1;

    private int count;

    /** Whether contacts have changed, or an island was not at rest, since all was found. */
    private boolean isStale = true;

    /** By island: where its contacts and bodies start in what follows. */
    int[] firstRow = new int[1];

    public int[] firstBody = new int[1];

    /** Contacts of the list: first those of two bodies that move. */
    int[] row = {};

    /** Slots in the order of elimination; of each, the first body that its row of blocks has. */
    public int[] body = {};

    int[] firstBlock = {};

    /** By slot: place in that order within its island. */
    int[] local = {};

    /** By island: factors after the bias pass and after the relax pass. */
    private DirectFactors[] factors = {};

    /** Islands at rest, by batch. */
    private int[] open = {};

    private int[] firstOpen = new int[1];
    private int openCount;

    /** By slot: island, or -1; bodies of the island whose smallest slot it is. */
    private int[] of = {};

    private int[] tally = {};

    /** By slot: least inner radius of the island whose smallest slot it is, m. */
    private double[] least = {};

    /** Bodies from end to end of large bodies, and {@code g h²}, m. */
    private int most;

    private double yield;

    /** The same two when all was found. */
    private int foundMost;

    private double foundYield;

    /** Whether another state was restored, or room was made, since all was found. */
    private boolean renewed;

    /** Which bodies touch. */
    private int[] firstNeighbour = new int[1];

    private int[] neighbour = {};
    private int[] queue = {};

    /** By slot: how far it is from the start, in the search with this stamp. */
    private int[] level = {};

    private int[] seen = {};
    private int stamp;

    /** Makes room, from the first tick on; whether all that was found is lost by that. */
    private boolean ensureCapacity(BodyStore b, EdgeList list) {
        boolean grows = local.length < b.slotCount || row.length < list.source.length;
        if (local.length < b.slotCount) {
            int n = b.kind.length;
            firstRow = new int[n + 1];
            firstBody = new int[n + 1];
            body = new int[n];
            firstBlock = new int[n];
            local = new int[n];
            open = new int[n];
            of = new int[n];
            tally = new int[n];
            least = new double[n];
            firstNeighbour = new int[n + 1];
            queue = new int[n];
            level = new int[n];
            seen = new int[n];
        }
        if (row.length < list.source.length) {
            row = new int[list.source.length];
            neighbour = new int[2 * row.length];
        }
        return grows;
    }

    /**
     * Finds the islands that are long, slender and at rest, and in which batch they are.
     *
     * @param batches knows islands and bodies with contacts
     * @param from bodies from end to end, of bodies that are not small
     * @param fall {@code g h²} of the sub-step that softness goes by, m
     * @param same whether contacts and bodies are those of the last tick
     */
    public void update(
            BodyStore b, EdgeList list, Batches batches, int from, double fall, boolean same) {
        isStale |= !same;
        renewed |= from < Integer.MAX_VALUE && ensureCapacity(b, list);
        count = renewed ? 0 : count;
        openCount = 0;
        most = from;
        yield = fall;
        if (from == Integer.MAX_VALUE || !rests(b, batches)) {
            return;
        }
        if (isStale) {
            foundMost = most;
            foundYield = yield;
        }
        if (isStale || renewed) {
            find(b, list, batches);
            renewed = false;
        }
        if (count > 0) {
            gate(b, batches);
        }
    }

    /** By what it was found; what was found is found anew. */
    @Override
    public void state(StateVisitor s) {
        s.section("direct", this);
        isStale = s.value("isStale", isStale);
        foundMost = s.value("foundMost", foundMost);
        foundYield = s.value("foundYield", foundYield);
        renewed |= s.isRestoring();
    }

    /** Whether as many bodies are at rest as an island needs at least. */
    private boolean rests(BodyStore b, Batches batches) {
        int resting = 0;
        double radius = Double.POSITIVE_INFINITY;
        for (int k = 0; k < batches.boundCount && resting < most; k++) {
            int i = batches.bound[k];
            if (b.restTicks[i] >= LoadSweep.HOLD) {
                resting++;
                radius = Math.min(radius, b.innerRadius[i]);
            }
        }
        return resting >= from(radius, most, yield);
    }

    /** Bodies from end to end of an island whose smallest body has a radius: 2 or more. */
    private static int from(double radius, int most, double yield) {
        double few = Math.ceil(most * Math.sqrt(radius / (STIFF * yield)));
        return few < most ? Math.max(2, (int) few) : most;
    }

    private int from(double radius) {
        return from(radius, foundMost, foundYield);
    }

    private void find(BodyStore b, EdgeList list, Batches batches) {
        count = 0;
        Islands islands = batches.islands(list);
        int[] bound = batches.bound;
        for (int k = 0; k < batches.boundCount; k++) {
            tally[bound[k]] = 0;
            least[bound[k]] = Double.POSITIVE_INFINITY;
            of[bound[k]] = -1;
        }
        for (int k = 0; k < batches.boundCount; k++) {
            int root = islands.root(bound[k]);
            tally[root]++;
            least[root] = Math.min(least[root], b.innerRadius[bound[k]]);
            // for now: a body of the island that is not at rest
            of[root] = b.restTicks[bound[k]] >= LoadSweep.HOLD ? of[root] : root;
        }
        for (int m = list.contacts; m < list.count; m++) {
            // the matrix is made of contacts alone
            tally[islands.root(list.mover(m))] = MOST_ROWS + 1;
        }
        for (int m = 0; b.driven > 0 && m < list.contacts; m++) {
            if (list.carrier[m] >= 0 || isDragged(b, list, m)) {
                tally[islands.root(list.mover(m))] = MOST_ROWS + 1;
            }
        }
        boolean any = false;
        isStale = false;
        for (int k = batches.boundCount - 1; k >= 0; k--) {
            int i = bound[k];
            int root = islands.root(i);
            boolean candidate =
                    tally[root] >= from(least[root])
                            && tally[root] <= MOST_ROWS
                            && !batches.isSingle[i];
            // one that comes to rest is looked at again
            isStale |= candidate && of[root] >= 0;
            candidate &= of[root] < 0;
            any |= candidate;
            // the smallest slot, which all others ask, comes last
            of[i] = candidate ? root : -1;
        }
        if (!any) {
            return;
        }
        connect(b, list);
        for (int k = 0; k < batches.boundCount; k++) {
            int i = bound[k];
            int root = islands.root(i);
            // of the island: -1, or its number, once its smallest slot has been seen
            of[i] = root != i ? of[root] : of[i] >= 0 && order(i, from(least[i])) ? count++ : -1;
        }
        sortRows(list);
        int made = factors.length;
        if (made < 2 * count) {
            factors = Arrays.copyOf(factors, 4 * count);
            for (int k = made; k < factors.length; k++) {
                factors[k] = new DirectFactors();
            }
        }
    }

    /** The factors of an island after a pass of one kind. */
    DirectFactors factors(int island, boolean soft) {
        return factors[2 * island + (soft ? 0 : 1)];
    }

    /** Contacts of the island that has most. */
    int mostRows() {
        return largest(firstRow);
    }

    /** Bodies of the island that has most. */
    int mostBodies() {
        return largest(firstBody);
    }

    private int largest(int[] first) {
        int most = 0;
        for (int k = 0; k < count; k++) {
            most = Math.max(most, first[k + 1] - first[k]);
        }
        return most;
    }

    /** Lists the neighbours of the bodies of candidates. */
    private void connect(BodyStore b, EdgeList list) {
        Arrays.fill(firstNeighbour, 0, b.slotCount + 1, 0);
        for (int pass = 0; pass < 2; pass++) {
            for (int m = 0; m < list.contacts; m++) {
                int i = list.slotA[m];
                int j = list.slotB[m];
                if (!list.isBetweenMovers(m) || of[i] < 0) {
                    continue;
                }
                if (pass == 0) {
                    firstNeighbour[i + 1]++;
                    firstNeighbour[j + 1]++;
                } else {
                    neighbour[queue[i]++] = j;
                    neighbour[queue[j]++] = i;
                }
            }
            for (int i = 0; i < b.slotCount && pass == 0; i++) {
                firstNeighbour[i + 1] += firstNeighbour[i];
                queue[i] = firstNeighbour[i];
            }
        }
    }

    /** Orders the bodies of an island; false if it is short or wide. */
    private boolean order(int start, int from) {
        int first = count == 0 ? 0 : firstBody[count];
        int n = tally[start];
        spread(start);
        // no two bodies are further apart than over this one
        if (2 * level[queue[n - 1]] + 1 < from) {
            return false;
        }
        spread(queue[n - 1]);
        if (level[queue[n - 1]] + 1 < from) {
            return false;
        }
        for (int k = 0; k < n; k++) {
            body[first + k] = queue[n - 1 - k];
            local[queue[n - 1 - k]] = k;
        }
        long work = 0;
        for (int k = 0; k < n; k++) {
            int i = body[first + k];
            int least = k;
            for (int e = firstNeighbour[i]; e < firstNeighbour[i + 1]; e++) {
                least = Math.min(least, local[neighbour[e]]);
            }
            firstBlock[first + k] = least;
            work += (long) (k - least) * (k - least);
        }
        firstBody[count] = first;
        firstBody[count + 1] = first + n;
        return work <= (long) WIDE * WIDE * n;
    }

    /** Breadth first, into {@link #queue}. */
    private void spread(int start) {
        stamp++;
        seen[start] = stamp;
        level[start] = 0;
        queue[0] = start;
        int tail = 1;
        for (int head = 0; head < tail; head++) {
            int i = queue[head];
            int from = tail;
            for (int e = firstNeighbour[i]; e < firstNeighbour[i + 1]; e++) {
                int j = neighbour[e];
                if (seen[j] == stamp) {
                    continue;
                }
                seen[j] = stamp;
                level[j] = level[i] + 1;
                int k = tail++;
                for (; k > from && degree(queue[k - 1]) > degree(j); k--) {
                    queue[k] = queue[k - 1];
                }
                queue[k] = j;
            }
        }
    }

    private int degree(int i) {
        return firstNeighbour[i + 1] - firstNeighbour[i];
    }

    /** Lists the contacts by island; those with static bodies have the last word. */
    private void sortRows(EdgeList list) {
        Arrays.fill(firstRow, 0, count + 1, 0);
        for (int m = 0; m < list.contacts; m++) {
            int island = of[list.mover(m)];
            if (island >= 0) {
                firstRow[island + 1]++;
            }
        }
        for (int k = 0; k < count; k++) {
            firstRow[k + 1] += firstRow[k];
        }
        for (int pass = 0; pass < 2; pass++) {
            for (int m = 0; m < list.contacts; m++) {
                int island = list.isBetweenMovers(m) == (pass == 0) ? of[list.mover(m)] : -1;
                if (island >= 0) {
                    row[firstRow[island]++] = m;
                }
            }
        }
        System.arraycopy(firstRow, 0, firstRow, 1, count);
        firstRow[0] = 0;
    }

    /** Finds those that are still at rest in this tick, by batch. */
    private void gate(BodyStore b, Batches batches) {
        if (firstOpen.length < batches.count + 1) {
            firstOpen = new int[batches.firstRow.length]; // grows with the store
        }
        Arrays.fill(firstOpen, 0, batches.count + 1, 0);
        for (int k = 0; k < count; k++) {
            if (isOpen(b, k)) {
                firstOpen[batches.batchOfRow(row[firstRow[k]]) + 1]++;
                openCount++;
                factors(k, true).forget();
                factors(k, false).forget();
            }
        }
        for (int k = 0; k < batches.count; k++) {
            firstOpen[k + 1] += firstOpen[k];
        }
        for (int k = 0; k < count; k++) {
            if (isOpen(b, k)) {
                open[firstOpen[batches.batchOfRow(row[firstRow[k]])]++] = k;
            }
        }
        System.arraycopy(firstOpen, 0, firstOpen, 1, batches.count);
        firstOpen[0] = 0;
    }

    private boolean isOpen(BodyStore b, int island) {
        if (firstRow[island + 1] - firstRow[island] > MOST_ROWS) {
            return false;
        }
        for (int k = firstBody[island]; k < firstBody[island + 1]; k++) {
            if (b.restTicks[body[k]] < LoadSweep.HOLD) {
                return false;
            }
        }
        return true;
    }

    /** How many islands of a batch are solved directly in this tick. */
    public int openIn(int batch) {
        return openCount == 0 ? 0 : firstOpen[batch + 1] - firstOpen[batch];
    }

    /** One of these islands. */
    public int open(int batch, int index) {
        return open[firstOpen[batch] + index];
    }

    /** Whether a surface of two bodies that move runs along: friction then does not hold them. */
    private static boolean isDragged(BodyStore b, EdgeList list, int m) {
        return b.belts > 0
                && list.isBetweenMovers(m)
                && (b.hasBelt[list.slotA[m]] || b.hasBelt[list.slotB[m]]);
    }
}
