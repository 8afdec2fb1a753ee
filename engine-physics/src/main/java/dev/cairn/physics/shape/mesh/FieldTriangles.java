package dev.cairn.physics.shape.mesh;

/**
 * The triangles of a grid of heights: two to a cell, with fronts up. Nothing is stored of them:
 * what is asked for is computed from the samples about a cell.
 *
 * <pre>
 *   (i, j) ──────── (i+1, j) ─▶ x       triangle 0: (i, j), (i, j+1), (i+1, j+1)
 *      │ ╲      1      │                triangle 1: (i, j), (i+1, j+1), (i+1, j)
 *      │   ╲           │
 *      │ 0   ╲         │                triangle k of cell (i, j) has the number
 *      ▼       ╲       │                2 (j cellsX + i) + k, holes counted
 *   (i, j+1) ─── (i+1, j+1)
 *      z
 * </pre>
 */
public final class FieldTriangles extends TriangleSet {
    /** Where the corners of the two triangles are, in cells. */
    private static final int[] CORNER_X = {0, 0, 1, 0, 1, 1}, CORNER_Z = {0, 1, 1, 0, 1, 0};

    /** Across each edge: cell, triangle, and the corner that the edge does not have. */
    private static final int[] ACROSS_X = {-1, 0, 0, 0, 1, 0}, ACROSS_Z = {0, 1, 0, 0, 0, -1};

    private static final int[] APEX_X = {-1, 1, 1, 0, 2, 0}, APEX_Z = {0, 2, 0, 1, 1, -1};

    /** The edges that end at a sample: three of the cell after it, three of the one before. */
    private static final int[] SPOKE_TRIANGLE = {0, 0, 1, 0, 0, 1}, SPOKE_EDGE = {0, 2, 2, 1, 2, 1};

    private final SampleGrid grid;
    private final int cellsX, cellsZ;
    private final double stepX, stepZ, thickness;

    /**
     * Of a grid whose first sample is at x = z = 0.
     *
     * @param stepX between samples along x, m
     * @param stepZ between samples along z, m
     * @param thickness how far below the surface a centre is pushed out, m
     */
    public FieldTriangles(SampleGrid grid, double stepX, double stepZ, double thickness) {
        super(false);
        this.grid = grid;
        this.stepX = stepX;
        this.stepZ = stepZ;
        this.thickness = thickness;
        cellsX = grid.countX - 1;
        cellsZ = grid.countZ - 1;
    }

    @Override
    public int count() {
        return 2 * cellsX * cellsZ;
    }

    /** The first cell that reaches so far, not clamped. */
    private static int first(double at, double step) {
        int i = (int) Math.max(-2, Math.min(at / step, SampleGrid.MOST));
        return i * step >= at ? i - 1 : i;
    }

    private static int last(double at, double step) {
        int i = (int) Math.max(-2, Math.min(Math.floor(at / step), SampleGrid.MOST));
        return (i + 1) * step <= at ? i + 1 : i;
    }

    @Override
    public void find(double[] b, Found out) {
        out.count = 0;
        int left = Math.max(0, first(b[0], stepX));
        int right = Math.min(cellsX - 1, last(b[3], stepX));
        int near = Math.max(0, first(b[2], stepZ));
        int far = Math.min(cellsZ - 1, last(b[5], stepZ));
        for (int j = near; j <= far; j++) {
            for (int i = left; i <= right; i++) {
                int block = i >> SampleGrid.BLOCK;
                boolean isEntered = i == left || i == block << SampleGrid.BLOCK;
                if (isEntered && !isNear(block, j >> SampleGrid.BLOCK, b[1], b[4])) {
                    i |= (1 << SampleGrid.BLOCK) - 1;
                } else if (grid.has(i, j)) {
                    add(i, j, b[1], b[4], out);
                }
            }
        }
    }

    private boolean isNear(int i, int j, double low, double high) {
        return grid.low(0, i, j) <= high && grid.high(0, i, j) >= low;
    }

    /** The triangles of a cell that are between two heights. */
    private void add(int i, int j, double low, double high, Found out) {
        double a = grid.height(i, j);
        double b = grid.height(i, j + 1);
        double c = grid.height(i + 1, j + 1);
        double d = grid.height(i + 1, j);
        double least = Math.min(a, c);
        double most = Math.max(a, c);
        int t = 2 * (j * cellsX + i);
        if (Math.min(least, b) <= high && Math.max(most, b) >= low) {
            out.add(t);
        }
        if (Math.min(least, d) <= high && Math.max(most, d) >= low) {
            out.add(t + 1);
        }
    }

    @Override
    public void along(double[] ray, double limit, double[] pad, Found out) {
        out.count = 0;
        along(grid.levels() - 1, 0, 0, ray, limit, pad, out);
    }

    /** As deep as the pyramid is high. */
    private void along(
            int level, int i, int j, double[] ray, double limit, double[] pad, Found out) {
        int shift = SampleGrid.BLOCK + level;
        if (!Boxes.meets(
                (i << shift) * stepX,
                grid.low(level, i, j),
                (j << shift) * stepZ,
                Math.min(cellsX, (i + 1) << shift) * stepX,
                grid.high(level, i, j),
                Math.min(cellsZ, (j + 1) << shift) * stepZ,
                ray,
                limit,
                pad)) {
            return;
        }
        if (level == 0) {
            block(i, j, ray, limit, pad, out);
            return;
        }
        for (int z = 2 * j; z <= Math.min(2 * j + 1, grid.blocksZ(level - 1) - 1); z++) {
            for (int x = 2 * i; x <= Math.min(2 * i + 1, grid.blocksX(level - 1) - 1); x++) {
                along(level - 1, x, z, ray, limit, pad, out);
            }
        }
    }

    /** The cells of a block that the ray passes, row by row. */
    private void block(int bi, int bj, double[] ray, double limit, double[] pad, Found out) {
        int right = Math.min(cellsX, (bi + 1) << SampleGrid.BLOCK);
        int far = Math.min(cellsZ, (bj + 1) << SampleGrid.BLOCK);
        for (int j = bj << SampleGrid.BLOCK; j < far; j++) {
            if (!Boxes.meets(
                    (bi << SampleGrid.BLOCK) * stepX,
                    grid.low(0, bi, bj),
                    j * stepZ,
                    right * stepX,
                    grid.high(0, bi, bj),
                    (j + 1) * stepZ,
                    ray,
                    limit,
                    pad)) {
                continue;
            }
            for (int i = bi << SampleGrid.BLOCK; i < right; i++) {
                if (grid.has(i, j) && passes(i, j, ray, limit, pad)) {
                    int t = 2 * (j * cellsX + i);
                    out.add(t);
                    out.add(t + 1);
                }
            }
        }
    }

    private boolean passes(int i, int j, double[] ray, double limit, double[] pad) {
        double a = grid.height(i, j);
        double b = grid.height(i, j + 1);
        double c = grid.height(i + 1, j + 1);
        double d = grid.height(i + 1, j);
        return Boxes.meets(
                i * stepX,
                Math.min(Math.min(a, b), Math.min(c, d)),
                j * stepZ,
                (i + 1) * stepX,
                Math.max(Math.max(a, b), Math.max(c, d)),
                (j + 1) * stepZ,
                ray,
                limit,
                pad);
    }

    // One triangle -------------------------------------------------------------------------------

    private int cellX(int t) {
        return (t >> 1) % cellsX;
    }

    private int cellZ(int t) {
        return (t >> 1) / cellsX;
    }

    @Override
    public void corners(int t, double[] out) {
        int i = cellX(t);
        int j = cellZ(t);
        for (int c = 0; c < 3; c++) {
            int x = i + CORNER_X[3 * (t & 1) + c];
            int z = j + CORNER_Z[3 * (t & 1) + c];
            out[3 * c] = x * stepX;
            out[3 * c + 1] = grid.height(x, z);
            out[3 * c + 2] = z * stepZ;
        }
    }

    @Override
    public int vertex(int t, int corner) {
        int x = cellX(t) + CORNER_X[3 * (t & 1) + corner];
        int z = cellZ(t) + CORNER_Z[3 * (t & 1) + corner];
        return z * grid.countX + x;
    }

    @Override
    public int flags(int t) {
        int i = cellX(t);
        int j = cellZ(t);
        int k = t & 1;
        int flags = 0;
        for (int c = 0; c < 3; c++) {
            flags |= kind(i, j, k, c) << c;
            flags |= ends(i + CORNER_X[3 * k + c], j + CORNER_Z[3 * k + c]) << c;
        }
        return flags;
    }

    @Override
    public int edges(int t) {
        int i = cellX(t);
        int j = cellZ(t);
        int k = t & 1;
        return kind(i, j, k, 0) | kind(i, j, k, 1) << 1 | kind(i, j, k, 2) << 2;
    }

    /** What an edge of a cell that is there is, as of edge 0. */
    private int kind(int i, int j, int k, int e) {
        int at = 3 * k + e;
        if (!grid.has(i + ACROSS_X[at], j + ACROSS_Z[at])) {
            return OPEN;
        }
        int next = 3 * k + (e + 1) % 3;
        int apex = 3 * k + (e + 2) % 3;
        int ax = i + CORNER_X[at];
        int az = j + CORNER_Z[at];
        int bx = i + CORNER_X[next];
        int bz = j + CORNER_Z[next];
        int cx = i + CORNER_X[apex];
        int cz = j + CORNER_Z[apex];
        int dx = i + APEX_X[at];
        int dz = j + APEX_Z[at];
        return Edge.kind(
                ax * stepX,
                grid.height(ax, az),
                az * stepZ,
                bx * stepX,
                grid.height(bx, bz),
                bz * stepZ,
                cx * stepX,
                grid.height(cx, cz),
                cz * stepZ,
                dx * stepX,
                grid.height(dx, dz),
                dz * stepZ);
    }

    /** What ends at a sample: bits {@link #CORNER} and {@link #CORNER_BACK}. */
    private int ends(int x, int z) {
        int seen = 0;
        for (int s = 0; s < 6; s++) {
            int i = s < 3 ? x : x - 1;
            int j = s < 3 ? z : z - 1;
            int at = 3 * SPOKE_TRIANGLE[s] + SPOKE_EDGE[s];
            int kind = 0;
            if (grid.has(i, j)) {
                kind = kind(i, j, SPOKE_TRIANGLE[s], SPOKE_EDGE[s]);
            } else if (grid.has(i + ACROSS_X[at], j + ACROSS_Z[at])) {
                kind = OPEN;
            }
            seen |= (kind & (CONVEX | OPEN)) != 0 ? CORNER : 0;
            seen |= (kind & (HOLLOW | OPEN)) != 0 ? CORNER_BACK : 0;
            if (seen == (CORNER | CORNER_BACK)) {
                return seen;
            }
        }
        return seen;
    }

    @Override
    public int material(int t) {
        return grid.cell(cellX(t), cellZ(t));
    }

    @Override
    public int source(int t) {
        return t;
    }

    @Override
    public double end(int axis, boolean upper) {
        if (axis == 1) {
            int top = grid.levels() - 1;
            return upper ? grid.high(top, 0, 0) : grid.low(top, 0, 0) - thickness;
        }
        return upper ? (axis == 0 ? cellsX * stepX : cellsZ * stepZ) : 0;
    }

    @Override
    public int above(double x, double y, double z) {
        if (!(x >= 0 && z >= 0 && x < cellsX * stepX && z < cellsZ * stepZ)) {
            return -1;
        }
        int i = Math.min(cellsX - 1, (int) (x / stepX));
        int j = Math.min(cellsZ - 1, (int) (z / stepZ));
        double u = x / stepX - i;
        double v = z / stepZ - j;
        double height = grid.height(i, j, u, v);
        boolean isUnder =
                y < height && y >= height - thickness && grid.cell(i, j) != SampleGrid.HOLE;
        return isUnder ? 2 * (j * cellsX + i) + (u > v ? 1 : 0) : -1;
    }
}
