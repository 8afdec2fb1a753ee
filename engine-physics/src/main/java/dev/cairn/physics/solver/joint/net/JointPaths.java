package dev.cairn.physics.solver.joint.net;

import java.util.Arrays;

/**
 * The joints of an assembly in paths: each joint is followed by one that shares a body with it, the
 * one that leads on most straightly, and no path comes to a body twice. Of a net these are its warp
 * and its weft.
 *
 * <p>What joints of a path do to each other is so a block tridiagonal matrix, which is solved at
 * the cost of a sweep. Made when the graph of joints changes; allocates.
 */
public final class JointPaths {
    /** Joints, along the paths. */
    public final int[] joint;

    /** By place in that: the place of the joint before on its path, or -1 where that begins. */
    public final int[] prior;

    /** Where each group of paths that lie side by side begins; one more for the end. */
    public final int[] group;

    /** A path goes on where it turns by less than 60 degrees. */
    private static final double STRAIGHT = -0.5;

    private final int[] end;
    private final double[] arm;
    private final boolean[] isUsed;

    /** By body: the path that came to it last. */
    private final int[] visited;

    /** By body: its first end of a joint in {@link #of}; one more for the end. */
    private final int[] firstOf;

    private final int[] of;

    /**
     * Finds them.
     *
     * @param bodies how many
     * @param end bodies of each joint, -1 for one that does not move
     * @param arm by end of a joint: its place in the body's frame, three numbers
     * @param abreast paths that lie side by side, joint by joint: sweeps along one path wait for
     *     each number that they make, and a processor does several at once
     */
    public JointPaths(int bodies, int[] end, double[] arm, int abreast) {
        this.end = end;
        this.arm = arm;
        int joints = end.length / 2;
        joint = new int[joints];
        prior = new int[joints];
        isUsed = new boolean[joints];
        visited = new int[bodies];
        Arrays.fill(visited, -1);
        firstOf = new int[bodies + 1];
        of = new int[end.length];
        list();
        int[] back = new int[joints];
        int[] along = new int[joints];
        int[] first = new int[joints + 1];
        int paths = 0;
        int done = 0;
        for (int k = 0; k < joints; k++) {
            if (isUsed[k]) {
                continue;
            }
            isUsed[k] = true;
            visit(k, 2 * k);
            visit(k, 2 * k + 1);
            int n = 0;
            for (int e = onwards(k, 2 * k); e >= 0; e = onwards(k, e)) {
                back[n++] = e / 2;
            }
            while (n > 0) {
                along[done++] = back[--n];
            }
            along[done++] = k;
            for (int e = onwards(k, 2 * k + 1); e >= 0; e = onwards(k, e)) {
                along[done++] = e / 2;
            }
            first[++paths] = done;
        }
        group = new int[(paths + abreast - 1) / abreast + 1];
        lay(along, first, paths, abreast);
    }

    /** Lays paths side by side. */
    private void lay(int[] along, int[] first, int paths, int abreast) {
        int done = 0;
        int groups = 0;
        for (int from = 0; from < paths; from += abreast) {
            int to = Math.min(paths, from + abreast);
            int[] last = new int[to - from];
            Arrays.fill(last, -1);
            int end = done + first[to] - first[from];
            for (int at = 0; done < end; at++) {
                for (int k = from; k < to; k++) {
                    if (first[k] + at < first[k + 1]) {
                        joint[done] = along[first[k] + at];
                        prior[done] = last[k - from];
                        last[k - from] = done++;
                    }
                }
            }
            group[++groups] = done;
        }
    }

    /** Lists the ends of joints by body. */
    private void list() {
        int bodies = firstOf.length - 1;
        for (int e : end) {
            if (e >= 0) {
                firstOf[e + 1]++;
            }
        }
        for (int i = 0; i < bodies; i++) {
            firstOf[i + 1] += firstOf[i];
        }
        int[] next = Arrays.copyOf(firstOf, bodies);
        for (int e = 0; e < end.length; e++) {
            if (end[e] >= 0) {
                of[next[end[e]]++] = e;
            }
        }
    }

    private void visit(int path, int e) {
        if (end[e] >= 0) {
            visited[end[e]] = path;
        }
    }

    /** The far end of the joint with which a path goes on from an end of its last one, or -1. */
    private int onwards(int path, int from) {
        int body = end[from];
        if (body < 0) {
            return -1;
        }
        int best = -1;
        double straight = STRAIGHT;
        for (int i = firstOf[body]; i < firstOf[body + 1]; i++) {
            int e = of[i];
            int far = end[e ^ 1];
            if (isUsed[e / 2] || (far >= 0 && visited[far] == path)) {
                continue;
            }
            double c = cosine(from, e);
            if (c < straight) {
                straight = c;
                best = e;
            }
        }
        if (best < 0) {
            return -1;
        }
        isUsed[best / 2] = true;
        visit(path, best ^ 1);
        return best ^ 1;
    }

    /** Of the angle between the arms of two joints of a body; -1 where there is none. */
    private double cosine(int e, int f) {
        double dot = 0;
        double a = 0;
        double b = 0;
        for (int c = 0; c < 3; c++) {
            dot += arm[3 * e + c] * arm[3 * f + c];
            a += arm[3 * e + c] * arm[3 * e + c];
            b += arm[3 * f + c] * arm[3 * f + c];
        }
        double length = Math.sqrt(a * b);
        return length > 0 ? dot / length : -1;
    }
}
