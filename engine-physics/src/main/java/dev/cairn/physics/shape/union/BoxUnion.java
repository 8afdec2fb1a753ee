package dev.cairn.physics.shape.union;

import dev.cairn.physics.internal.Rotations;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.union.ConvexUnion.Piece;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Boxes of one set of axes that make larger boxes: all of them at once if they fill the box around
 * them, or else by twos that continue each other along an axis, until no two do. Ends that are
 * equal to rounding get one number, so comparisons are exact.
 */
final class BoxUnion {
    private static final double HALF = Math.sqrt(0.5);

    /** Entries of a rotation matrix this near to 0 are 0: axes that are shared. */
    private static final double ALIGNED = 0x1p-30;

    /** Unit quaternion of the axes in the body. */
    private final double[] axes;

    private final List<Piece> pieces;

    /** By piece: the two ends along each axis, m, and their numbers. */
    private final double[][] low, high;

    private final int[][] lowAt, highAt;

    private BoxUnion(double[] axes, List<Piece> pieces) {
        this.axes = axes;
        this.pieces = pieces;
        int n = pieces.size();
        low = new double[n][3];
        high = new double[n][3];
        lowAt = new int[n][3];
        highAt = new int[n][3];
    }

    /** Replaces boxes by what they make. */
    static void join(List<Piece> all, double tolerance) {
        List<Piece> left = new ArrayList<>(all);
        List<Piece> done = new ArrayList<>();
        while (!left.isEmpty()) {
            Piece first = left.get(0);
            List<Piece> same = new ArrayList<>();
            for (Piece p : left) {
                if (p == first || (isBox(first) && isBox(p) && isAligned(first.pose, p.pose))) {
                    same.add(p);
                }
            }
            left.removeAll(same);
            if (same.size() == 1) {
                done.add(first);
            } else {
                done.addAll(new BoxUnion(axes(same), same).join(tolerance));
            }
        }
        all.clear();
        all.addAll(done);
    }

    private static boolean isBox(Piece p) {
        return p.shape instanceof Box;
    }

    /** Whether each axis of one is an axis of the other. */
    private static boolean isAligned(double[] a, double[] b) {
        double[] m = matrix(between(a, b));
        for (double entry : m) {
            double size = Math.abs(entry);
            if (size > ALIGNED && size < 1 - ALIGNED) {
                return false;
            }
        }
        return true;
    }

    /** Rotation a inverse b. */
    private static double[] between(double[] a, double[] b) {
        double[] back = {-a[3], -a[4], -a[5], a[6]};
        return times(back, new double[] {b[3], b[4], b[5], b[6]});
    }

    static double[] times(double[] a, double[] b) {
        return new double[] {
            a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1],
            a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
            a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3],
            a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]
        };
    }

    /** Row by row. */
    private static double[] matrix(double[] q) {
        double[] m = new double[9];
        double[] v = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            Rotations.rotate(
                    q[0],
                    q[1],
                    q[2],
                    q[3],
                    axis == 0 ? 1 : 0,
                    axis == 1 ? 1 : 0,
                    axis == 2 ? 1 : 0,
                    v);
            for (int row = 0; row < 3; row++) {
                m[3 * row + axis] = v[row];
            }
        }
        return m;
    }

    /** The axes that are nearest to the body's: those of the piece that needs the least turn. */
    private static double[] axes(List<Piece> pieces) {
        double[] best = {0, 0, 0, 0};
        for (Piece p : pieces) {
            double[] q = nearest(new double[] {p.pose[3], p.pose[4], p.pose[5], p.pose[6]});
            best = q[3] > best[3] ? q : best;
        }
        return best;
    }

    /** Of the 24 ways to name the axes of a box, the one that is turned least. */
    static double[] nearest(double[] q) {
        double[] best = {0, 0, 0, 0};
        for (int i = 0; i < 4; i++) {
            double[] one = new double[4];
            one[i] = 1;
            best = better(best, times(q, one));
            for (int j = 0; j < i; j++) {
                for (int sign = -1; sign <= 1; sign += 2) {
                    double[] two = new double[4];
                    two[i] = HALF;
                    two[j] = sign * HALF;
                    best = better(best, times(q, two));
                }
            }
        }
        for (int signs = 0; signs < 8; signs++) {
            double[] four = {
                (signs & 1) == 0 ? 0.5 : -0.5,
                (signs & 2) == 0 ? 0.5 : -0.5,
                (signs & 4) == 0 ? 0.5 : -0.5,
                0.5
            };
            best = better(best, times(q, four));
        }
        return best;
    }

    private static double[] better(double[] best, double[] q) {
        if (Math.abs(q[3]) <= best[3]) {
            return best;
        }
        double sign = q[3] < 0 ? -1 : 1;
        return new double[] {sign * q[0], sign * q[1], sign * q[2], sign * q[3]};
    }

    private List<Piece> join(double tolerance) {
        for (int i = 0; i < pieces.size(); i++) {
            measure(i);
        }
        for (int axis = 0; axis < 3; axis++) {
            number(axis, tolerance);
        }
        List<int[]> groups = new ArrayList<>();
        if (fillsItsBox()) {
            int[] all = new int[pieces.size()];
            Arrays.setAll(all, i -> i);
            groups.add(all);
        } else {
            for (int i = 0; i < pieces.size(); i++) {
                groups.add(new int[] {i});
            }
            for (int before = 0; before != groups.size(); ) {
                before = groups.size();
                for (int axis = 0; axis < 3; axis++) {
                    groups = joinAlong(axis, groups);
                }
            }
        }
        List<Piece> made = new ArrayList<>();
        for (int[] group : groups) {
            made.add(group.length == 1 ? pieces.get(group[0]) : make(group));
        }
        return made;
    }

    /** The ends of a piece along the axes. */
    private void measure(int i) {
        Piece p = pieces.get(i);
        Box box = (Box) p.shape;
        double[] m =
                matrix(between(new double[] {0, 0, 0, axes[0], axes[1], axes[2], axes[3]}, p.pose));
        double[] c = new double[3];
        Rotations.rotate(-axes[0], -axes[1], -axes[2], axes[3], p.pose[0], p.pose[1], p.pose[2], c);
        for (int axis = 0; axis < 3; axis++) {
            double half =
                    Math.abs(m[3 * axis]) > 0.5
                            ? box.halfX()
                            : Math.abs(m[3 * axis + 1]) > 0.5 ? box.halfY() : box.halfZ();
            low[i][axis] = c[axis] - half;
            high[i][axis] = c[axis] + half;
        }
    }

    /** Numbers the ends along an axis, equal ones alike. */
    private void number(int axis, double tolerance) {
        int n = pieces.size();
        double[] ends = new double[2 * n];
        for (int i = 0; i < n; i++) {
            ends[2 * i] = low[i][axis];
            ends[2 * i + 1] = high[i][axis];
        }
        Arrays.sort(ends);
        int[] numbers = new int[2 * n];
        for (int i = 1; i < 2 * n; i++) {
            numbers[i] = numbers[i - 1] + (ends[i] - ends[i - 1] > tolerance ? 1 : 0);
        }
        for (int i = 0; i < n; i++) {
            lowAt[i][axis] = numbers[Arrays.binarySearch(ends, low[i][axis])];
            highAt[i][axis] = numbers[Arrays.binarySearch(ends, high[i][axis])];
        }
    }

    /** Whether no two pieces overlap and all of them have the volume of the box around them. */
    private boolean fillsItsBox() {
        double sum = 0;
        double[] least = low[0].clone();
        double[] most = high[0].clone();
        for (int i = 0; i < pieces.size(); i++) {
            sum += pieces.get(i).volume();
            for (int axis = 0; axis < 3; axis++) {
                least[axis] = Math.min(least[axis], low[i][axis]);
                most[axis] = Math.max(most[axis], high[i][axis]);
            }
        }
        double around = (most[0] - least[0]) * (most[1] - least[1]) * (most[2] - least[2]);
        if (Math.abs(around - sum) > 3 * ConvexUnion.FLUSH * around) {
            return false;
        }
        for (int i = 0; i < pieces.size(); i++) {
            for (int j = 0; j < i; j++) {
                if (overlap(i, j)) {
                    return false;
                }
            }
        }
        return true;
    }

    private boolean overlap(int i, int j) {
        for (int axis = 0; axis < 3; axis++) {
            if (highAt[i][axis] <= lowAt[j][axis] || highAt[j][axis] <= lowAt[i][axis]) {
                return false;
            }
        }
        return true;
    }

    private int end(int[] group, int axis, boolean isHigh) {
        int end = isHigh ? Integer.MIN_VALUE : Integer.MAX_VALUE;
        for (int i : group) {
            end = isHigh ? Math.max(end, highAt[i][axis]) : Math.min(end, lowAt[i][axis]);
        }
        return end;
    }

    /** Joins boxes that are alike along two axes and continue each other along the third. */
    private List<int[]> joinAlong(int axis, List<int[]> groups) {
        int u = (axis + 1) % 3;
        int v = (axis + 2) % 3;
        List<int[]> sorted = new ArrayList<>(groups);
        sorted.sort((a, b) -> Arrays.compare(key(a, u, v, axis), key(b, u, v, axis)));
        List<int[]> made = new ArrayList<>();
        int[] open = {};
        int[] openKey = {};
        for (int[] group : sorted) {
            int[] key = key(group, u, v, axis);
            if (open.length > 0
                    && Arrays.equals(key, 0, 4, openKey, 0, 4)
                    && key[4] <= end(open, axis, true)) {
                int[] both = Arrays.copyOf(open, open.length + group.length);
                System.arraycopy(group, 0, both, open.length, group.length);
                open = both;
                made.set(made.size() - 1, both);
            } else {
                made.add(group);
                open = group;
                openKey = key;
            }
        }
        return made;
    }

    private int[] key(int[] group, int u, int v, int along) {
        return new int[] {
            end(group, u, false),
            end(group, u, true),
            end(group, v, false),
            end(group, v, true),
            end(group, along, false)
        };
    }

    private Piece make(int[] group) {
        double[] centre = new double[3];
        double[] half = new double[3];
        List<Piece> of = new ArrayList<>();
        for (int axis = 0; axis < 3; axis++) {
            double least = Double.POSITIVE_INFINITY;
            double most = Double.NEGATIVE_INFINITY;
            for (int i : group) {
                least = Math.min(least, low[i][axis]);
                most = Math.max(most, high[i][axis]);
            }
            centre[axis] = (least + most) / 2;
            half[axis] = (most - least) / 2;
        }
        for (int i : group) {
            of.add(pieces.get(i));
        }
        double[] at = new double[3];
        Rotations.rotate(axes[0], axes[1], axes[2], axes[3], centre[0], centre[1], centre[2], at);
        double[] pose = {at[0], at[1], at[2], axes[0], axes[1], axes[2], axes[3]};
        return new Piece(Piece.members(of), Box.ofHalfExtents(half[0], half[1], half[2]), pose);
    }
}
