package dev.cairn.physics.shape;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Turns the triangles of a hull into its true faces: neighbouring triangles whose corners lie
 * within a tolerance of one plane become one face, corners that only two faces share vanish into an
 * edge. Regions grow from the largest triangle down, because its plane is the best conditioned.
 * Set-up only; allocates; one thread.
 */
final class FaceMerger {
    private final QuickHull hull;
    private final int[] region;

    private FaceMerger(QuickHull hull) {
        this.hull = hull;
        this.region = new int[hull.triangles];
    }

    /**
     * The loops of the faces, in point indices of the input; falls back to finer tolerances, at
     * last to triangles.
     */
    static int[][] loops(QuickHull hull) {
        FaceMerger merger = new FaceMerger(hull);
        for (double tolerance = 4 * hull.tolerance;
                tolerance > 1e-4 * hull.tolerance;
                tolerance /= 16) {
            merger.grow(tolerance);
            int[][] loops = merger.faces();
            if (loops != null) {
                return ordered(loops);
            }
        }
        int[][] triangles = new int[hull.triangles][];
        for (int t = 0; t < triangles.length; t++) {
            triangles[t] = Arrays.copyOfRange(hull.corner, 3 * t, 3 * t + 3);
        }
        return ordered(triangles);
    }

    /**
     * Loops from their lowest corner on, and in an order that does not depend on how they were
     * found nor on which way round they go: a mirror image then has them in the same order.
     */
    private static int[][] ordered(int[][] loops) {
        for (int[] loop : loops) {
            int[] from = loop.clone();
            int low = 0;
            for (int i = 1; i < from.length; i++) {
                low = from[i] < from[low] ? i : low;
            }
            for (int i = 0; i < from.length; i++) {
                loop[i] = from[(low + i) % from.length];
            }
        }
        Arrays.sort(loops, FaceMerger::compare);
        return loops;
    }

    /** By the lowest corner and its two neighbours, which no two faces share. */
    private static int compare(int[] a, int[] b) {
        int byLowest = Integer.compare(a[0], b[0]);
        if (byLowest != 0) {
            return byLowest;
        }
        int endA = a[a.length - 1];
        int endB = b[b.length - 1];
        int byNear = Integer.compare(Math.min(a[1], endA), Math.min(b[1], endB));
        return byNear != 0 ? byNear : Integer.compare(Math.max(a[1], endA), Math.max(b[1], endB));
    }

    /** The lowest corner of a triangle comes first; then the others, as they go round. */
    private int corner(int t, int k) {
        int[] c = hull.corner;
        int low = c[3 * t] < c[3 * t + 1] ? 0 : 1;
        low = c[3 * t + 2] < c[3 * t + low] ? 2 : low;
        return c[3 * t + (low + k) % 3];
    }

    private double[] normal(int t) {
        double[] p = hull.p;
        int a = 3 * corner(t, 0);
        int b = 3 * corner(t, 1);
        int c = 3 * corner(t, 2);
        double ux = p[b] - p[a];
        double uy = p[b + 1] - p[a + 1];
        double uz = p[b + 2] - p[a + 2];
        double vx = p[c] - p[a];
        double vy = p[c + 1] - p[a + 1];
        double vz = p[c + 2] - p[a + 2];
        double nx = uy * vz - uz * vy;
        double ny = uz * vx - ux * vz;
        double nz = ux * vy - uy * vx;
        return new double[] {nx, ny, nz, Math.sqrt(nx * nx + ny * ny + nz * nz)};
    }

    private int compare(int s, int t) {
        return compare(
                new int[] {corner(s, 0), corner(s, 1), corner(s, 2)},
                new int[] {corner(t, 0), corner(t, 1), corner(t, 2)});
    }

    private void grow(double tolerance) {
        int n = hull.triangles;
        double[][] normals = new double[n][];
        for (int t = 0; t < n; t++) {
            normals[t] = normal(t);
        }
        int[] order =
                IntStream.range(0, n)
                        .boxed()
                        .sorted((s, t) -> {
                            int byArea = Double.compare(normals[t][3], normals[s][3]);
                            return byArea != 0 ? byArea : compare(s, t);
                        })
                        .mapToInt(Integer::intValue)
                        .toArray();
        Arrays.fill(region, -1);
        ArrayDeque<Integer> front = new ArrayDeque<>();
        for (int seed : order) {
            if (region[seed] >= 0) {
                continue;
            }
            region[seed] = seed;
            front.add(seed);
            while (!front.isEmpty()) {
                int t = front.remove();
                for (int k = 0; k < 3; k++) {
                    int other = hull.twin[3 * t + k];
                    if (region[other] < 0 && fits(normals[seed], seed, other, tolerance)) {
                        region[other] = seed;
                        front.add(other);
                    }
                }
            }
        }
    }

    private boolean fits(double[] normal, int seed, int t, double tolerance) {
        double[] p = hull.p;
        int a = 3 * corner(seed, 0);
        for (int k = 0; k < 3; k++) {
            int v = 3 * hull.corner[3 * t + k];
            double d =
                    normal[0] * (p[v] - p[a])
                            + normal[1] * (p[v + 1] - p[a + 1])
                            + normal[2] * (p[v + 2] - p[a + 2]);
            if (!(Math.abs(d) <= tolerance * normal[3])) {
                return false;
            }
        }
        return true;
    }

    /** Walks the regions' borders; null when a region is not a simple polygon. */
    private int @org.jspecify.annotations.Nullable [][] faces() {
        for (int attempt = 0; attempt < 100; attempt++) {
            int[] degree = degrees();
            List<int[]> loops = new ArrayList<>();
            boolean absorbed = false;
            int[] next = new int[degree.length];
            for (List<Integer> members : members()) {
                int[] border = border(members, next);
                if (border.length == 0) {
                    return null;
                }
                int[] loop = Arrays.stream(border).filter(v -> degree[v] >= 3).toArray();
                if (loop.length < 3) {
                    absorb(members);
                    absorbed = true;
                    break;
                }
                loops.add(loop);
            }
            if (!absorbed) {
                int[][] result = loops.toArray(new int[0][]);
                return closed(result) ? result : null;
            }
        }
        return null;
    }

    private List<List<Integer>> members() {
        List<List<Integer>> all = new ArrayList<>();
        int[] index = new int[region.length];
        Arrays.fill(index, -1);
        for (int t = 0; t < region.length; t++) {
            if (index[region[t]] < 0) {
                index[region[t]] = all.size();
                all.add(new ArrayList<>());
            }
            all.get(index[region[t]]).add(t);
        }
        return all;
    }

    /** In how many regions each point is a corner. */
    private int[] degrees() {
        long[] pairs = new long[3 * region.length];
        for (int i = 0; i < pairs.length; i++) {
            pairs[i] = ((long) hull.corner[i] << 32) | region[i / 3];
        }
        Arrays.sort(pairs);
        int[] degree = new int[hull.p.length / 3];
        for (int i = 0; i < pairs.length; i++) {
            if (i == 0 || pairs[i] != pairs[i - 1]) {
                degree[(int) (pairs[i] >> 32)]++;
            }
        }
        return degree;
    }

    /** The border of a region as one loop; empty when it is not one simple loop. */
    private int[] border(List<Integer> members, int[] next) {
        int sides = 0;
        int start = -1;
        for (int t : members) {
            for (int k = 0; k < 3; k++) {
                next[hull.corner[3 * t + k]] = -1;
            }
        }
        for (int t : members) {
            for (int k = 0; k < 3; k++) {
                if (region[hull.twin[3 * t + k]] != region[t]) {
                    int a = hull.corner[3 * t + k];
                    if (next[a] >= 0) {
                        return new int[0];
                    }
                    next[a] = hull.corner[3 * t + (k + 1) % 3];
                    sides++;
                    start = a;
                }
            }
        }
        int[] loop = new int[sides];
        int v = start;
        for (int i = 0; i < sides; i++) {
            loop[i] = v;
            v = next[v];
            if (v < 0 || (v == start && i + 1 < sides)) {
                return new int[0];
            }
        }
        return v == start ? loop : new int[0];
    }

    /**
     * Gives a region that has fewer than three corners to the neighbour with which it shares the
     * longest border.
     */
    private void absorb(List<Integer> members) {
        double best = -1;
        int target = -1;
        for (int t : members) {
            for (int k = 0; k < 3; k++) {
                int other = region[hull.twin[3 * t + k]];
                int a = 3 * hull.corner[3 * t + k];
                int b = 3 * hull.corner[3 * t + (k + 1) % 3];
                double dx = hull.p[a] - hull.p[b];
                double dy = hull.p[a + 1] - hull.p[b + 1];
                double dz = hull.p[a + 2] - hull.p[b + 2];
                double length = dx * dx + dy * dy + dz * dz;
                if (other != region[t] && length > best) {
                    best = length;
                    target = other;
                }
            }
        }
        for (int t : members) {
            region[t] = target;
        }
    }

    /** Every side has exactly one partner in the other direction, and Euler's formula holds. */
    private static boolean closed(int[][] loops) {
        int sides = Arrays.stream(loops).mapToInt(l -> l.length).sum();
        long[] forward = new long[sides];
        long[] backward = new long[sides];
        int at = 0;
        for (int[] loop : loops) {
            for (int i = 0; i < loop.length; i++) {
                long a = loop[i];
                long b = loop[(i + 1) % loop.length];
                forward[at] = a << 32 | b;
                backward[at++] = b << 32 | a;
            }
        }
        Arrays.sort(forward);
        Arrays.sort(backward);
        long vertices = Arrays.stream(loops).flatMapToInt(Arrays::stream).distinct().count();
        return Arrays.equals(forward, backward)
                && Arrays.stream(forward).distinct().count() == sides
                && vertices - sides / 2 + loops.length == 2;
    }
}
