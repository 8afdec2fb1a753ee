package dev.cairn.physics.shape.mesh;

/**
 * Triangles with shared vertices and a flat tree of boxes over them. A node that holds more than
 * {@link #LEAF} triangles is followed by its first half, and knows where its second half begins;
 * the halves are of equal count, so no links to triangles are needed.
 *
 * <p>Bytes for each triangle of a closed surface: 12 of indices, 12 of vertices, 4 of its number, 2
 * of flags, 7 to 14 of the tree.
 */
final class MeshTables extends TriangleSet {
    /** Triangles of a leaf at most. */
    static final int LEAF = 8;

    /** Numbers of a node in {@link #box}. */
    static final int BOX = 6;

    /** Coordinates of the vertices, m. */
    final double[] vertex;

    /** Three vertices to a triangle. */
    final int[] index;

    final int[] source;
    final short[] flags;

    /** By the user's number of a triangle; empty if all are 0. */
    final byte[] material;

    /** Lower and upper corner of each node. */
    final float[] box;

    /** Where the second half's node is. */
    final int[] second;

    private final double[] ends;

    MeshTables(
            boolean isTwoSided,
            double[] vertex,
            int[] index,
            int[] source,
            short[] flags,
            byte[] material,
            float[] box,
            int[] second,
            double[] ends) {
        super(isTwoSided);
        this.vertex = vertex;
        this.index = index;
        this.source = source;
        this.flags = flags;
        this.material = material;
        this.box = box;
        this.second = second;
        this.ends = ends;
    }

    /** How many of so many triangles are in the first half. */
    static int half(int count) {
        return (count + 1) / 2;
    }

    @Override
    public int count() {
        return source.length;
    }

    @Override
    public void find(double[] b, Found out) {
        out.count = 0;
        find(0, 0, count(), b, out);
    }

    /** As deep as the tree is high. */
    private void find(int node, int from, int to, double[] b, Found out) {
        int at = BOX * node;
        if (box[at] > b[3]
                || box[at + 1] > b[4]
                || box[at + 2] > b[5]
                || box[at + 3] < b[0]
                || box[at + 4] < b[1]
                || box[at + 5] < b[2]) {
            return;
        }
        if (to - from <= LEAF) {
            for (int t = from; t < to; t++) {
                if (isNear(t, 0, b) && isNear(t, 1, b) && isNear(t, 2, b)) {
                    out.add(t);
                }
            }
            return;
        }
        int middle = from + half(to - from);
        find(node + 1, from, middle, b, out);
        find(second[node], middle, to, b, out);
    }

    private boolean isNear(int t, int axis, double[] b) {
        double p = vertex[3 * index[3 * t] + axis];
        double q = vertex[3 * index[3 * t + 1] + axis];
        double r = vertex[3 * index[3 * t + 2] + axis];
        return Math.min(p, Math.min(q, r)) <= b[axis + 3] && Math.max(p, Math.max(q, r)) >= b[axis];
    }

    @Override
    public void along(double[] ray, double limit, double[] pad, Found out) {
        out.count = 0;
        along(0, 0, count(), ray, limit, pad, out);
    }

    private void along(
            int node, int from, int to, double[] ray, double limit, double[] pad, Found out) {
        int at = BOX * node;
        if (!Boxes.meets(
                box[at],
                box[at + 1],
                box[at + 2],
                box[at + 3],
                box[at + 4],
                box[at + 5],
                ray,
                limit,
                pad)) {
            return;
        }
        if (to - from <= LEAF) {
            for (int t = from; t < to; t++) {
                out.add(t);
            }
            return;
        }
        int middle = from + half(to - from);
        along(node + 1, from, middle, ray, limit, pad, out);
        along(second[node], middle, to, ray, limit, pad, out);
    }

    @Override
    public void corners(int t, double[] out) {
        for (int c = 0; c < 3; c++) {
            System.arraycopy(vertex, 3 * index[3 * t + c], out, 3 * c, 3);
        }
    }

    @Override
    public int vertex(int t, int corner) {
        return index[3 * t + corner];
    }

    @Override
    public int flags(int t) {
        return flags[t];
    }

    @Override
    public int source(int t) {
        return source[t];
    }

    @Override
    public int material(int t) {
        return material.length == 0 ? 0 : material[source[t]] & 255;
    }

    /** The same triangles with other materials. */
    MeshTables with(byte[] materials) {
        return new MeshTables(
                isTwoSided, vertex, index, source, flags, materials, box, second, ends);
    }

    /** The same triangles with both sides. */
    MeshTables twoSided() {
        return new MeshTables(true, vertex, index, source, flags, material, box, second, ends);
    }

    @Override
    public double end(int axis, boolean upper) {
        return ends[upper ? axis + 3 : axis];
    }
}
