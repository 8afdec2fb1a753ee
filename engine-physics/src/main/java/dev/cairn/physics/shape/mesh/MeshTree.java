package dev.cairn.physics.shape.mesh;

import dev.cairn.core.job.Jobs;

import java.util.Arrays;
import java.util.function.DoubleConsumer;

/**
 * Orders triangles by halves along the longest side of their middles, and boxes them. Level by
 * level: the ranges of a level have nothing in common, so workers share them, and how large a range
 * is says where its node is, so the tree is the same for any number of them.
 */
final class MeshTree {
    /** Blocks of a level with many ranges. */
    private static final int BLOCKS = 64;

    final int[] order;
    final float[] box;
    final int[] second;
    private final double[] vertex;
    private final int[] index;

    /** The ranges of the level at hand and of the next one: begin, end, node. */
    private int[] range, below;

    MeshTree(double[] vertex, int[] index, int count) {
        this.vertex = vertex;
        this.index = index;
        order = new int[count];
        for (int t = 0; t < count; t++) {
            order[t] = t;
        }
        int size = nodes(count);
        box = new float[MeshTables.BOX * size];
        second = new int[size];
        range = new int[] {0, count, 0};
        below = new int[0];
    }

    private static int nodes(int count) {
        return count <= MeshTables.LEAF
                ? 1
                : 1 + nodes(MeshTables.half(count)) + nodes(count - MeshTables.half(count));
    }

    /**
     * Builds; once.
     *
     * @param progress is told the share of levels that are done, on this thread
     */
    void build(Jobs jobs, DoubleConsumer progress) {
        int levels = 1;
        for (int n = order.length; n > MeshTables.LEAF; n = MeshTables.half(n)) {
            levels++;
        }
        for (int level = 1; range.length > 0; level++) {
            int ranges = range.length / 3;
            below = new int[6 * ranges];
            jobs.run(this::split, Math.min(ranges, BLOCKS));
            range = filled(below);
            progress.accept(Math.min(1, level / (double) levels));
        }
    }

    /** The ranges that there are, in their order. */
    private static int[] filled(int[] all) {
        int n = 0;
        for (int i = 0; i < all.length; i += 3) {
            if (all[i + 1] > 0) {
                System.arraycopy(all, i, all, n, 3);
                n += 3;
            }
        }
        return Arrays.copyOf(all, n);
    }

    private void split(int block, int worker) {
        int ranges = range.length / 3;
        int blocks = Math.min(ranges, BLOCKS);
        int end = (int) ((block + 1L) * ranges / blocks);
        for (int r = (int) ((long) block * ranges / blocks); r < end; r++) {
            int from = range[3 * r];
            int to = range[3 * r + 1];
            int node = range[3 * r + 2];
            measure(node, from, to);
            if (to - from <= MeshTables.LEAF) {
                continue;
            }
            int half = MeshTables.half(to - from);
            select(from, to, from + half, longest(from, to));
            second[node] = node + 1 + nodes(half);
            put(6 * r, from, from + half, node + 1);
            put(6 * r + 3, from + half, to, second[node]);
        }
    }

    private void put(int at, int from, int to, int node) {
        below[at] = from;
        below[at + 1] = to;
        below[at + 2] = node;
    }

    private void measure(int node, int from, int to) {
        for (int axis = 0; axis < 3; axis++) {
            double low = Double.POSITIVE_INFINITY;
            double high = Double.NEGATIVE_INFINITY;
            for (int i = 3 * from; i < 3 * to; i++) {
                double x = vertex[3 * index[3 * order[i / 3] + i % 3] + axis];
                low = Math.min(low, x);
                high = Math.max(high, x);
            }
            box[MeshTables.BOX * node + axis] = Math.nextDown((float) low);
            box[MeshTables.BOX * node + axis + 3] = Math.nextUp((float) high);
        }
    }

    /** Three times the middle of a triangle. */
    private double middle(int t, int axis) {
        return vertex[3 * index[3 * t] + axis]
                + vertex[3 * index[3 * t + 1] + axis]
                + vertex[3 * index[3 * t + 2] + axis];
    }

    private int longest(int from, int to) {
        int best = 0;
        double most = -1;
        for (int axis = 0; axis < 3; axis++) {
            double low = Double.POSITIVE_INFINITY;
            double high = Double.NEGATIVE_INFINITY;
            for (int i = from; i < to; i++) {
                low = Math.min(low, middle(order[i], axis));
                high = Math.max(high, middle(order[i], axis));
            }
            if (high - low > most) {
                most = high - low;
                best = axis;
            }
        }
        return best;
    }

    private boolean isBefore(int s, int t, int axis) {
        double a = middle(s, axis);
        double b = middle(t, axis);
        return a < b || (a == b && s < t);
    }

    /** Hoare's selection: what is before the middle place belongs there; no two are equal. */
    private void select(int from, int to, int place, int axis) {
        int low = from;
        int high = to - 1;
        while (low < high) {
            int pivot = median(order[low], order[(low + high) >>> 1], order[high], axis);
            int i = low;
            int j = high;
            while (i <= j) {
                while (isBefore(order[i], pivot, axis)) {
                    i++;
                }
                while (isBefore(pivot, order[j], axis)) {
                    j--;
                }
                if (i <= j) {
                    int swap = order[i];
                    order[i++] = order[j];
                    order[j--] = swap;
                }
            }
            if (place <= j) {
                high = j;
            } else if (place >= i) {
                low = i;
            } else {
                return;
            }
        }
    }

    private int median(int a, int b, int c, int axis) {
        boolean ab = isBefore(a, b, axis);
        boolean bc = isBefore(b, c, axis);
        if (ab == bc) {
            return b;
        }
        return ab == isBefore(a, c, axis) ? c : a;
    }
}
