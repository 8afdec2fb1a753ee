package dev.cairn.physics.shape.mesh;

import org.jspecify.annotations.Nullable;

import java.util.Arrays;

/**
 * Heights on a regular grid, and a number of each cell, in square tiles, with a pyramid of bounds.
 * Immutable; a grid that differs in a rectangle shares all tiles outside it.
 *
 * <p>Bytes for each sample: 8, and 1/6 of the pyramid; 1 more in tiles where a cell has a number.
 */
public final class SampleGrid {
    /** Number of a cell that is not there. */
    public static final int HOLE = 255;

    /** Most samples: numbers of triangles, and names of vertices in feature ids, have 30 bits. */
    public static final int MOST = 1 << 29;

    /** Samples along a side of a tile: 2 to this. */
    private static final int TILE = 5;

    private static final int IN_TILE = (1 << TILE) - 1;

    /** Cells along a side of a block of the lowest level of the pyramid: 2 to this. */
    static final int BLOCK = 3;

    /** Samples along x and z. */
    public final int countX, countZ;

    private final int tilesX;
    private final double[][] height;
    private final byte @Nullable [][] cell;

    /** Of each level, the finest first: lower and upper end of each block. */
    private final float[][] bounds;

    private SampleGrid(
            int countX,
            int countZ,
            double[][] height,
            byte @Nullable [][] cell,
            float @Nullable [][] bounds) {
        this.countX = countX;
        this.countZ = countZ;
        this.height = height;
        this.cell = cell;
        tilesX = tiles(countX);
        this.bounds = bounds == null ? pyramid() : bounds;
    }

    /**
     * Without holes.
     *
     * @param countX samples along x, at least 2
     * @param countZ samples along z, at least 2
     * @param heights by rows along x, m; not kept
     */
    public static SampleGrid of(int countX, int countZ, double[] heights) {
        int tilesX = tiles(countX);
        double[][] tiles = new double[tilesX * tiles(countZ)][];
        for (int t = 0; t < tiles.length; t++) {
            int i = (t % tilesX) << TILE;
            int j = (t / tilesX) << TILE;
            int wide = Math.min(1 << TILE, countX - i);
            tiles[t] = new double[wide * Math.min(1 << TILE, countZ - j)];
            for (int k = 0; k < tiles[t].length; k++) {
                tiles[t][k] = heights[(j + k / wide) * countX + i + k % wide];
            }
        }
        return new SampleGrid(countX, countZ, tiles, null, null);
    }

    private static int tiles(int count) {
        return (count + IN_TILE) >> TILE;
    }

    private int tile(int i, int j) {
        return (j >> TILE) * tilesX + (i >> TILE);
    }

    private int in(int i, int j) {
        int first = i & ~IN_TILE;
        return (j & IN_TILE) * Math.min(1 << TILE, countX - first) + (i - first);
    }

    /** The height of a sample, m. */
    public double height(int i, int j) {
        return height[tile(i, j)][in(i, j)];
    }

    /**
     * The height of the triangle at a place of a cell, m.
     *
     * @param u 0..1 along x
     * @param v 0..1 along z
     */
    public double height(int i, int j, double u, double v) {
        double a = height(i, j);
        double c = height(i + 1, j + 1);
        if (u > v) {
            double d = height(i + 1, j);
            return a + u * (d - a) + v * (c - d);
        }
        double b = height(i, j + 1);
        return a + v * (b - a) + u * (c - b);
    }

    /** The number of a cell, 0..254, or {@link #HOLE}. */
    public int cell(int i, int j) {
        byte[] tile = cell == null ? null : cell[tile(i, j)];
        return tile == null ? 0 : tile[in(i, j)] & 255;
    }

    /** Whether a cell is within the grid, and no hole. */
    boolean has(int i, int j) {
        return i >= 0 && j >= 0 && i < countX - 1 && j < countZ - 1 && cell(i, j) != HOLE;
    }

    /** Whether any cell has, or had, a number. */
    public boolean hasCells() {
        return cell != null;
    }

    /**
     * The same with other heights in a rectangle.
     *
     * @param x its first sample
     * @param z its first sample
     * @param wide samples along x
     * @param heights by rows along x, m
     */
    public SampleGrid withHeights(int x, int z, int wide, double[] heights) {
        double[][] tiles = height.clone();
        boolean[] own = new boolean[tiles.length];
        int deep = heights.length / wide;
        for (int j = z; j < z + deep; j++) {
            for (int i = x; i < x + wide; i++) {
                int t = tile(i, j);
                if (!own[t]) {
                    tiles[t] = height[t].clone();
                    own[t] = true;
                }
                tiles[t][in(i, j)] = heights[(j - z) * wide + i - x];
            }
        }
        float[][] levels = new float[bounds.length][];
        for (int level = 0; level < levels.length; level++) {
            levels[level] = bounds[level].clone();
        }
        SampleGrid grid = new SampleGrid(countX, countZ, tiles, cell, levels);
        grid.measure(x - 1, z - 1, x + wide - 1, z + deep - 1);
        return grid;
    }

    /** The same with another number of the cells in a rectangle. */
    public SampleGrid withCells(int x, int z, int wide, int deep, int number) {
        byte[][] tiles = cell == null ? new byte[height.length][] : cell.clone();
        boolean[] own = new boolean[tiles.length];
        for (int j = z; j < z + deep; j++) {
            for (int i = x; i < x + wide; i++) {
                int t = tile(i, j);
                if (!own[t]) {
                    tiles[t] = Arrays.copyOf(none(tiles[t]), height[t].length);
                    own[t] = true;
                }
                tiles[t][in(i, j)] = (byte) number;
            }
        }
        return new SampleGrid(countX, countZ, height, tiles, bounds);
    }

    private static byte[] none(byte @Nullable [] tile) {
        return tile == null ? new byte[0] : tile;
    }

    /**
     * Where another grid of the same size differs from this one.
     *
     * @param dest receives the first cell along x and z, and one past the last
     * @return false if nowhere
     */
    public boolean differs(SampleGrid other, int[] dest) {
        dest[0] = dest[1] = Integer.MAX_VALUE;
        dest[2] = dest[3] = 0;
        for (int j = 0; j < countZ; j++) {
            for (int i = 0; i < countX; i++) {
                int t = tile(i, j);
                if (shares(other, t)) {
                    i |= IN_TILE;
                } else if (height(i, j) != other.height(i, j)) {
                    include(i - 1, j - 1, i + 1, j + 1, dest);
                } else if (cell(i, j) != other.cell(i, j)) {
                    include(i, j, i + 1, j + 1, dest);
                }
            }
        }
        dest[0] = Math.max(0, dest[0]);
        dest[1] = Math.max(0, dest[1]);
        dest[2] = Math.min(countX - 1, dest[2]);
        dest[3] = Math.min(countZ - 1, dest[3]);
        return dest[0] < dest[2];
    }

    @SuppressWarnings("ReferenceEquality") // the very tile
    private boolean shares(SampleGrid other, int tile) {
        return height[tile] == other.height[tile] && cells(tile) == other.cells(tile);
    }

    private byte @Nullable [] cells(int tile) {
        return cell == null ? null : cell[tile];
    }

    private static void include(int x0, int z0, int x1, int z1, int[] dest) {
        dest[0] = Math.min(dest[0], x0);
        dest[1] = Math.min(dest[1], z0);
        dest[2] = Math.max(dest[2], x1);
        dest[3] = Math.max(dest[3], z1);
    }

    // The pyramid --------------------------------------------------------------------------------

    /** How many blocks of a level there are along so many samples. */
    private static int blocks(int count, int level) {
        return ((count - 2) >> (BLOCK + level)) + 1;
    }

    int blocksX(int level) {
        return blocks(countX, level);
    }

    int blocksZ(int level) {
        return blocks(countZ, level);
    }

    int levels() {
        return bounds.length;
    }

    /** The lower end of a block's samples, rounded outwards, m. */
    double low(int level, int i, int j) {
        return bounds[level][2 * (j * blocksX(level) + i)];
    }

    /** The upper end. */
    double high(int level, int i, int j) {
        return bounds[level][2 * (j * blocksX(level) + i) + 1];
    }

    private float[][] pyramid() {
        int levels = 1;
        while (blocks(Math.max(countX, countZ), levels - 1) > 1) {
            levels++;
        }
        float[][] made = new float[levels][];
        for (int level = 0; level < levels; level++) {
            made[level] = new float[2 * blocksX(level) * blocksZ(level)];
        }
        measure(made, 0, 0, countX - 2, countZ - 2);
        return made;
    }

    private void measure(int x0, int z0, int x1, int z1) {
        measure(bounds, x0, z0, x1, z1);
    }

    /** Measures the blocks of some cells, ends included, from the finest level up. */
    private void measure(float[][] to, int x0, int z0, int x1, int z1) {
        for (int level = 0; level < to.length; level++) {
            int shift = BLOCK + level;
            int right = Math.min(x1, countX - 2) >> shift;
            int far = Math.min(z1, countZ - 2) >> shift;
            for (int j = Math.max(0, z0) >> shift; j <= far; j++) {
                for (int i = Math.max(0, x0) >> shift; i <= right; i++) {
                    if (level == 0) {
                        measureBlock(to[0], i, j);
                    } else {
                        join(to, level, i, j);
                    }
                }
            }
        }
    }

    private void measureBlock(float[] to, int i, int j) {
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        for (int z = j << BLOCK; z <= Math.min((j + 1) << BLOCK, countZ - 1); z++) {
            for (int x = i << BLOCK; x <= Math.min((i + 1) << BLOCK, countX - 1); x++) {
                low = Math.min(low, height(x, z));
                high = Math.max(high, height(x, z));
            }
        }
        int at = 2 * (j * blocksX(0) + i);
        to[at] = Math.nextDown((float) low);
        to[at + 1] = Math.nextUp((float) high);
    }

    private void join(float[][] to, int level, int i, int j) {
        float low = Float.POSITIVE_INFINITY;
        float high = Float.NEGATIVE_INFINITY;
        for (int z = 2 * j; z <= Math.min(2 * j + 1, blocksZ(level - 1) - 1); z++) {
            for (int x = 2 * i; x <= Math.min(2 * i + 1, blocksX(level - 1) - 1); x++) {
                int from = 2 * (z * blocksX(level - 1) + x);
                low = Math.min(low, to[level - 1][from]);
                high = Math.max(high, to[level - 1][from + 1]);
            }
        }
        int at = 2 * (j * blocksX(level) + i);
        to[level][at] = low;
        to[level][at + 1] = high;
    }
}
