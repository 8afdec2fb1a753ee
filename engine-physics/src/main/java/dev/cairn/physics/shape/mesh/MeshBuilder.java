package dev.cairn.physics.shape.mesh;

import dev.cairn.core.job.Blocks;
import dev.cairn.core.job.Jobs;

import org.jspecify.annotations.Nullable;

import java.util.Arrays;
import java.util.function.DoubleConsumer;

/**
 * Makes the tables of a mesh: vertices at one place become one, triangles without area are left
 * out, the rest is sorted by halves into a tree, and each edge is looked at together with its
 * neighbour. What it found is told by its counts. Set-up only; coordinates and indices are checked
 * by the caller.
 */
public final class MeshBuilder {
    /** Of the squared longest side: twice the area of a triangle that is none. */
    private static final double NO_AREA = 1e-12;

    /** Shares of the time that are over when vertices are welded, and when the tree is made. */
    private static final double WELDED = .1, TREE = .8;

    private static final int TRIANGLES_PER_BLOCK = 4096;

    private double[] vertex;
    private int[] index;
    private int[] source;
    private short[] flags = {};

    /** What was given, and is not in the tables: see {@link GivenMesh}. */
    private int[] weldedTo = {};

    private int[] degenerateCorners = {};

    /** Vertices that were at the place of another one. */
    public int welded;

    /** Triangles without area, by the number of the user; ascending. */
    public int[] degenerate = {};

    /** Edges of one triangle only; of more than two; of two that do not agree which side is out. */
    public int openEdges, crowdedEdges, flippedEdges;

    /** Half-edges by their lower vertex: where the list of each vertex begins. */
    private int[] begin = {};

    private int[] halfEdge = {};

    /**
     * Of vertices and triangles, neither of which is changed or kept.
     *
     * @param xyz three finite numbers for each vertex, m
     * @param indices three vertices for each triangle
     */
    public MeshBuilder(double[] xyz, int[] indices) {
        vertex = xyz.clone();
        index = indices;
        source = new int[0];
    }

    /** A surface without triangles. */
    public static TriangleSet nothing() {
        float[] box = {1, 1, 1, 0, 0, 0};
        return new MeshTables(
                false,
                new double[0],
                new int[0],
                new int[0],
                new short[0],
                new byte[0],
                box,
                new int[1],
                new double[6]);
    }

    /**
     * Builds; once. The same tables for any number of workers.
     *
     * @param progress is told the share that is done, 0 to 1, on this thread
     * @return {@code null} if no triangle has an area
     */
    public @Nullable TriangleSet build(boolean isTwoSided, Jobs jobs, DoubleConsumer progress) {
        leaveOut(weld());
        progress.accept(WELDED);
        int count = source.length;
        if (count == 0) {
            return null;
        }
        double[] ends = ends();
        MeshTree tree = new MeshTree(vertex, index, count);
        tree.build(jobs, share -> progress.accept(WELDED + share * (TREE - WELDED)));
        arrange(tree.order);
        flags = new short[count];
        edges(jobs);
        progress.accept(1);
        return new MeshTables(
                isTwoSided, vertex, index, source, flags, new byte[0], tree.box, tree.second, ends);
    }

    /** What was given, told from the tables; after {@link #build}. */
    public GivenMesh given() {
        return new GivenMesh(vertex, index, source, weldedTo, degenerate, degenerateCorners);
    }

    /**
     * The same triangles with both sides.
     *
     * @param built by {@link #build}
     */
    public static TriangleSet twoSided(TriangleSet built) {
        return ((MeshTables) built).twoSided();
    }

    /**
     * The same triangles with other materials.
     *
     * @param built by {@link #build}
     * @param materials by the user's number of a triangle; kept
     */
    public static TriangleSet with(TriangleSet built, byte[] materials) {
        return ((MeshTables) built).with(materials);
    }

    /** Of the vertices at one place the first stays; returns the number of each that is kept. */
    private int[] weld() {
        int n = vertex.length / 3;
        for (int i = 0; i < vertex.length; i++) {
            vertex[i] += 0.0; // no minus zero, so equal places have equal bits
        }
        int[] table = new int[Integer.highestOneBit(Math.max(4, n)) << 2];
        Arrays.fill(table, -1);
        int[] to = new int[n];
        int kept = 0;
        for (int v = 0; v < n; v++) {
            int at = hash(v) & table.length - 1;
            while (table[at] >= 0 && !isSame(table[at], v)) {
                at = at + 1 & table.length - 1;
            }
            if (table[at] < 0) {
                System.arraycopy(vertex, 3 * v, vertex, 3 * kept, 3);
                table[at] = kept;
                to[v] = kept++;
            } else {
                to[v] = table[at];
            }
        }
        welded = n - kept;
        vertex = Arrays.copyOf(vertex, 3 * kept);
        if (welded > 0) {
            weldedTo = to;
        }
        return to;
    }

    private int hash(int v) {
        long h = Double.doubleToRawLongBits(vertex[3 * v]);
        h = h * 0x9E3779B97F4A7C15L ^ Double.doubleToRawLongBits(vertex[3 * v + 1]);
        h = h * 0x9E3779B97F4A7C15L ^ Double.doubleToRawLongBits(vertex[3 * v + 2]);
        h *= 0x9E3779B97F4A7C15L;
        return (int) (h >>> 32);
    }

    private boolean isSame(int a, int b) {
        return vertex[3 * a] == vertex[3 * b]
                && vertex[3 * a + 1] == vertex[3 * b + 1]
                && vertex[3 * a + 2] == vertex[3 * b + 2];
    }

    /**
     * Names corners by the vertices that are kept, and leaves out triangles without area.
     *
     * @param to by given vertex, the one that is kept
     */
    private void leaveOut(int[] to) {
        int n = index.length / 3;
        int[] given = index;
        index = new int[given.length];
        Arrays.setAll(index, i -> to[given[i]]);
        int[] bad = new int[n];
        source = new int[n];
        int kept = 0;
        int left = 0;
        for (int t = 0; t < n; t++) {
            if (hasArea(t)) {
                System.arraycopy(index, 3 * t, index, 3 * kept, 3);
                source[kept++] = t;
            } else {
                bad[left++] = t;
            }
        }
        degenerate = Arrays.copyOf(bad, left);
        degenerateCorners = new int[3 * left];
        for (int i = 0; i < left; i++) {
            System.arraycopy(given, 3 * bad[i], degenerateCorners, 3 * i, 3);
        }
        source = Arrays.copyOf(source, kept);
        index = Arrays.copyOf(index, 3 * kept);
    }

    private boolean hasArea(int t) {
        int a = 3 * index[3 * t];
        int b = 3 * index[3 * t + 1];
        int c = 3 * index[3 * t + 2];
        double longest = Math.max(square(a, b), Math.max(square(b, c), square(c, a)));
        double ux = vertex[b] - vertex[a];
        double uy = vertex[b + 1] - vertex[a + 1];
        double uz = vertex[b + 2] - vertex[a + 2];
        double vx = vertex[c] - vertex[a];
        double vy = vertex[c + 1] - vertex[a + 1];
        double vz = vertex[c + 2] - vertex[a + 2];
        double nx = uy * vz - uz * vy;
        double ny = uz * vx - ux * vz;
        double nz = ux * vy - uy * vx;
        return Math.sqrt(nx * nx + ny * ny + nz * nz) > NO_AREA * longest;
    }

    private double square(int a, int b) {
        double x = vertex[b] - vertex[a];
        double y = vertex[b + 1] - vertex[a + 1];
        double z = vertex[b + 2] - vertex[a + 2];
        return x * x + y * y + z * z;
    }

    private double[] ends() {
        double[] ends = new double[6];
        for (int axis = 0; axis < 3; axis++) {
            ends[axis] = Double.POSITIVE_INFINITY;
            ends[axis + 3] = Double.NEGATIVE_INFINITY;
            for (int v : index) {
                ends[axis] = Math.min(ends[axis], vertex[3 * v + axis]);
                ends[axis + 3] = Math.max(ends[axis + 3], vertex[3 * v + axis]);
            }
        }
        return ends;
    }

    private void arrange(int[] order) {
        int[] corners = new int[index.length];
        int[] numbers = new int[source.length];
        for (int t = 0; t < order.length; t++) {
            System.arraycopy(index, 3 * order[t], corners, 3 * t, 3);
            numbers[t] = source[order[t]];
        }
        index = corners;
        source = numbers;
    }

    /** Half-edges, by their lower vertex, meet their neighbours. */
    private void edges(Jobs jobs) {
        begin = new int[vertex.length / 3 + 1];
        for (int h = 0; h < index.length; h++) {
            begin[Math.min(index[h], index[next(h)]) + 1]++;
        }
        for (int v = 0; v + 1 < begin.length; v++) {
            begin[v + 1] += begin[v];
        }
        int[] cursor = begin.clone();
        halfEdge = new int[index.length];
        for (int h = 0; h < index.length; h++) {
            halfEdge[cursor[Math.min(index[h], index[next(h)])]++] = h;
        }
        int blocks = Blocks.count(source.length, TRIANGLES_PER_BLOCK);
        int[] wrong = new int[3 * blocks];
        jobs.run((block, worker) -> kinds(block, wrong), blocks);
        for (int b = 0; b < blocks; b++) {
            openEdges += wrong[3 * b];
            crowdedEdges += wrong[3 * b + 1];
            flippedEdges += wrong[3 * b + 2];
        }
        byte[] ends = new byte[vertex.length / 3];
        for (int h = 0; h < index.length; h++) {
            int kind = flags[h / 3] >> (h % 3);
            int seen = (kind & (TriangleSet.CONVEX | TriangleSet.OPEN)) != 0 ? 1 : 0;
            seen |= (kind & (TriangleSet.HOLLOW | TriangleSet.OPEN)) != 0 ? 2 : 0;
            ends[index[h]] |= (byte) seen;
            ends[index[next(h)]] |= (byte) seen;
        }
        for (int h = 0; h < index.length; h++) {
            int seen = ends[index[h]];
            flags[h / 3] |= (short) (((seen & 1) * TriangleSet.CORNER) << (h % 3));
            flags[h / 3] |= (short) (((seen >> 1) * TriangleSet.CORNER_BACK) << (h % 3));
        }
    }

    /** The kinds of the edges of some triangles, and how many are open, crowded, flipped. */
    private void kinds(int block, int[] wrong) {
        int end = 3 * Blocks.end(block, TRIANGLES_PER_BLOCK, source.length);
        for (int h = 3 * Blocks.begin(block, TRIANGLES_PER_BLOCK); h < end; h++) {
            flags[h / 3] |= (short) (kind(h, 3 * block, wrong) << (h % 3));
        }
    }

    private static int next(int h) {
        return h % 3 == 2 ? h - 2 : h + 1;
    }

    /** One of the bits of {@link TriangleSet} for edge 0, or 0 for a flat edge. */
    private int kind(int h, int count, int[] wrong) {
        int a = index[h];
        int b = index[next(h)];
        int low = Math.min(a, b);
        int others = 0;
        int twin = -1;
        boolean isFirst = true;
        for (int i = begin[low]; i < begin[low + 1]; i++) {
            int g = halfEdge[i];
            int c = index[g];
            int d = index[next(g)];
            if (g != h && Math.min(c, d) == low && Math.max(c, d) == Math.max(a, b)) {
                others++;
                twin = g;
                isFirst &= h < g;
            }
        }
        if (others != 1) {
            wrong[count] += others == 0 ? 1 : 0;
            wrong[count + 1] += others > 1 && isFirst ? 1 : 0;
            return TriangleSet.OPEN;
        }
        if (index[twin] == a) {
            wrong[count + 2] += isFirst ? 1 : 0;
            return TriangleSet.OPEN;
        }
        int c = 3 * index[next(next(h))];
        int d = 3 * index[next(next(twin))];
        return Edge.kind(
                vertex[3 * a],
                vertex[3 * a + 1],
                vertex[3 * a + 2],
                vertex[3 * b],
                vertex[3 * b + 1],
                vertex[3 * b + 2],
                vertex[c],
                vertex[c + 1],
                vertex[c + 2],
                vertex[d],
                vertex[d + 1],
                vertex[d + 2]);
    }
}
