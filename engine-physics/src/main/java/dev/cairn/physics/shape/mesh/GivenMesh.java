package dev.cairn.physics.shape.mesh;

/**
 * A mesh as it was given, told from its tables: stored is only what those do not have, which of a
 * mesh without double vertices and without degenerate triangles is nothing. (Copies of what was
 * given took 24 bytes a triangle beside the 40 of the tables.)
 *
 * <p>Immutable; any thread.
 */
public final class GivenMesh {
    private final double[] vertex;
    private final int[] index, source;

    /** By given vertex, its number in the tables; empty if each has its own place. */
    private final int[] welded;

    /** Triangles without area by their given numbers, and three given vertices of each. */
    private final int[] degenerate, corners;

    GivenMesh(
            double[] vertex,
            int[] index,
            int[] source,
            int[] welded,
            int[] degenerate,
            int[] corners) {
        this.vertex = vertex;
        this.index = index;
        this.source = source;
        this.welded = welded;
        this.degenerate = degenerate;
        this.corners = corners;
    }

    /** How many triangles were given. */
    public int triangles() {
        return source.length + degenerate.length;
    }

    /** The vertices that were given: a new array x, y, z, ..., shape frame, m. */
    public double[] vertices() {
        if (welded.length == 0) {
            return vertex.clone();
        }
        double[] all = new double[3 * welded.length];
        for (int v = 0; v < welded.length; v++) {
            System.arraycopy(vertex, 3 * welded[v], all, 3 * v, 3);
        }
        return all;
    }

    /**
     * The triangles that were given, in their order: a new array of three vertices each, of those
     * at one place the first.
     */
    public int[] indices() {
        int[] all = new int[3 * triangles()];
        int[] first = first();
        for (int t = 0; t < source.length; t++) {
            for (int c = 0; c < 3; c++) {
                int v = index[3 * t + c];
                all[3 * source[t] + c] = welded.length == 0 ? v : first[v];
            }
        }
        for (int i = 0; i < degenerate.length; i++) {
            System.arraycopy(corners, 3 * i, all, 3 * degenerate[i], 3);
        }
        return all;
    }

    /** By vertex of the tables, the first given vertex at its place. */
    private int[] first() {
        int[] first = new int[welded.length == 0 ? 0 : vertex.length / 3];
        for (int v = welded.length - 1; v >= 0; v--) {
            first[welded[v]] = v;
        }
        return first;
    }

    /** The largest distance of a triangle's corner from the origin of the shape frame, m. */
    public double outerRadius() {
        double most = 0;
        for (int v : index) {
            double x = vertex[3 * v];
            double y = vertex[3 * v + 1];
            double z = vertex[3 * v + 2];
            most = Math.max(most, x * x + y * y + z * z);
        }
        return Math.sqrt(most);
    }
}
