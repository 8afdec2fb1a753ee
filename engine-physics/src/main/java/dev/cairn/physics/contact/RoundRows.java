package dev.cairn.physics.contact;

import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.Poses;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.narrowphase.round.RoundPairs;
import dev.cairn.physics.narrowphase.wide.RoundBatch;

/**
 * Rows of balls and capsules in lanes, a batch at a time: gathers what the kernels read, runs them,
 * and writes the rows. Loops are short and each reads few columns, so that the compiler keeps
 * addresses and lengths of these in registers.
 */
final class RoundRows {
    private final PairKinds kinds;
    private final PointStore points;
    private final Poses s;
    private ContactStore c = new ContactStore();
    private double[] ahead = {};
    private double reach, fraction;

    /** Of a stage. */
    RoundRows(ColliderStore colliders, PairKinds kinds, PointStore points) {
        s = colliders.poses;
        this.kinds = kinds;
        this.points = points;
    }

    /**
     * Chooses the columns and the margin.
     *
     * @param fraction share of the smaller radius in it
     */
    void use(ContactStore rows, BoundsStage bounds, double reachSeconds, double fraction) {
        c = rows;
        ahead = bounds.ahead;
        reach = reachSeconds;
        this.fraction = fraction;
    }

    /**
     * Collides up to a batch of the ordered rows.
     *
     * @param begin the first one's place
     * @return how many rows are left to the general way: the first ones of {@link Scratch#left}
     */
    int run(int begin, int count, Scratch own) {
        // B is a capsule in the last two kinds, A in the second and in the last one.
        int last = begin + count - 1;
        boolean capsulesB = last >= kinds.begin(PairKinds.ROUND + 2);
        boolean capsulesA =
                last >= kinds.begin(PairKinds.ROUND + 3)
                        || (last >= kinds.begin(PairKinds.ROUND + 1)
                                && begin < kinds.begin(PairKinds.ROUND + 2));
        gather(begin, count, own);
        margins(count, own);
        if (capsulesA) {
            turn(count, own.colliderA, false, own.pairs);
        }
        if (capsulesB) {
            turn(count, own.colliderB, true, own.pairs);
        }
        own.pairs.run(count, capsulesA, capsulesB, reach, fraction);
        return others(store(begin, count, own), own);
    }

    private void gather(int begin, int count, Scratch own) {
        int[] order = kinds.order();
        int[] rowsA = c.colliderA;
        int[] rowsB = c.colliderB;
        double[] sizes = kinds.sizes();
        RoundPairs pairs = own.pairs;
        for (int i = 0; i < count; i++) {
            int row = order[begin + i];
            int a = rowsA[row];
            int b = rowsB[row];
            own.colliderA[i] = a;
            own.colliderB[i] = b;
            int sizeA = PairKinds.SIZES * a;
            int sizeB = PairKinds.SIZES * b;
            pairs.put(
                    i,
                    s.apartX(a, b),
                    s.apartY(a, b),
                    s.apartZ(a, b),
                    sizes[sizeA],
                    sizes[sizeA + 1],
                    sizes[sizeB],
                    sizes[sizeB + 1]);
        }
    }

    private void margins(int count, Scratch own) {
        double[] v = ahead;
        int[] colliderA = own.colliderA;
        int[] colliderB = own.colliderB;
        RoundPairs pairs = own.pairs;
        for (int i = 0; i < count; i++) {
            int a = BoundsStage.AHEAD * colliderA[i];
            int b = BoundsStage.AHEAD * colliderB[i];
            pairs.ahead(
                    i, v[b] - v[a], v[b + 1] - v[a + 1], v[b + 2] - v[a + 2], v[a + 3], v[b + 3]);
        }
    }

    private void turn(int count, int[] slots, boolean second, RoundPairs pairs) {
        double[] x = s.orientationX;
        double[] y = s.orientationY;
        double[] z = s.orientationZ;
        double[] w = s.orientationW;
        for (int i = 0; i < count; i++) {
            int slot = slots[i];
            pairs.turn(i, second, x[slot], y[slot], z[slot], w[slot]);
        }
    }

    /** Writes the rows that have the one point that they had; returns how many have not. */
    private int store(int begin, int count, Scratch own) {
        int[] order = kinds.order();
        RoundPairs pairs = own.pairs;
        int others = 0;
        for (int i = 0; i < count; i++) {
            int row = order[begin + i];
            int first = ContactStore.POINTS * row;
            // This word says that the row has one point, named as such a one is: it is the same as
            // in the last tick and keeps its name and its impulses.
            if (pairs.touches(i) && c.cache[row] == RoundPairs.SINGLE) {
                c.separation[first] =
                        pairs.write(
                                i,
                                c.head,
                                ContactStore.head(row),
                                c.anchors,
                                ContactStore.anchor(first));
            } else {
                own.place[others] = i;
                own.left[others++] = row;
            }
        }
        return others;
    }

    private int others(int count, Scratch own) {
        RoundPairs pairs = own.pairs;
        Manifold m = own.manifold;
        int left = 0;
        for (int k = 0; k < count; k++) {
            int i = own.place[k];
            int row = own.left[k];
            if (pairs.take(i, m)) {
                c.cache[row] = RoundPairs.key(m);
                points.store(row, m, own.points);
            } else if (pairs.sideBySide(i, c.cache[row], m)) {
                c.cache[row] = pairs.key();
                points.store(row, m, own.points);
            } else {
                own.left[left++] = row;
            }
        }
        return left;
    }

    /** What one worker needs. */
    static final class Scratch {
        final RoundPairs pairs = new RoundPairs();
        final int[] colliderA = new int[RoundBatch.CAPACITY];
        final int[] colliderB = new int[RoundBatch.CAPACITY];
        final int[] place = new int[RoundBatch.CAPACITY];
        final int[] left = new int[RoundBatch.CAPACITY];
        final Manifold manifold = new Manifold();
        final PointStore.Scratch points = new PointStore.Scratch();
    }
}
