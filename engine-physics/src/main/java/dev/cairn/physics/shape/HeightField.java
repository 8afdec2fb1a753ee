package dev.cairn.physics.shape;

import dev.cairn.core.state.StateInput;
import dev.cairn.core.state.StateOutput;
import dev.cairn.physics.shape.DegenerateShapeException.Reason;
import dev.cairn.physics.shape.mesh.FieldTriangles;
import dev.cairn.physics.shape.mesh.Meshed;
import dev.cairn.physics.shape.mesh.SampleGrid;
import dev.cairn.physics.shape.mesh.TriangleSet;

import java.util.Arrays;
import java.util.Objects;

/**
 * Ground by heights on a regular grid: sample (i, j) is the point (i stepX, h, j stepZ) of the
 * shape's frame, and each cell between four samples is two triangles, divided from (i, j) to (i +
 * 1, j + 1). For fixed and kinematic bodies; bodies meet it from above.
 *
 * <p>Immutable. What is dug or heaped up is another field, which shares the samples that are not
 * touched: {@code body.setShape(field.withHeights(...))}. Where nothing differs no body wakes, and
 * contacts keep their impulses.
 *
 * <p>It has an inside, unlike a {@link TriangleMesh}: whose centre is at most {@link #thickness}
 * below it is pushed out through the triangle above.
 *
 * <p>Memory: 8 bytes for each sample and 1/6 of a byte for bounds; 1 more where cells have holes or
 * materials. See {@code docs/levels.md}.
 */
public final class HeightField extends Meshed implements Shape {
    /** Heights may be so large, so that bounds of single precision hold them. */
    private static final double MOST = 1e30;

    private final SampleGrid grid;
    private final double stepX, stepZ, thickness;

    private HeightField(SampleGrid grid, double stepX, double stepZ, double thickness) {
        super(new FieldTriangles(grid, stepX, stepZ, thickness));
        this.grid = grid;
        this.stepX = stepX;
        this.stepZ = stepZ;
        this.thickness = thickness;
    }

    /**
     * A field without holes, as thick as its longer step.
     *
     * @param samplesX samples along x, at least 2
     * @param samplesZ samples along z, at least 2; all together at most 2^29
     * @param stepX between samples along x, m, 1e-30..1e30
     * @param stepZ between samples along z, m, 1e-30..1e30
     * @param heights by rows along x: that of sample (i, j) is {@code heights[j * samplesX + i]},
     *     m, -1e30..1e30; not kept
     * @return the shape
     * @throws DegenerateShapeException if a step or a height is out of range
     * @throws IllegalArgumentException if counts are out of range, or do not match the array
     */
    public static HeightField of(
            int samplesX, int samplesZ, double stepX, double stepZ, double[] heights) {
        if (samplesX < 2 || samplesZ < 2 || (long) samplesX * samplesZ > SampleGrid.MOST) {
            throw new IllegalArgumentException(
                    samplesX
                            + " x "
                            + samplesZ
                            + " samples; there must be two along x and z at least, and 2^29 in all"
                            + " at most");
        }
        step("stepX", stepX);
        step("stepZ", stepZ);
        if (heights == null || heights.length != samplesX * samplesZ) {
            throw new IllegalArgumentException(
                    "there are "
                            + (heights == null ? "no" : "" + heights.length)
                            + " heights; "
                            + samplesX
                            + " x "
                            + samplesZ
                            + " samples want "
                            + samplesX * samplesZ);
        }
        check(heights, 0, 0, samplesX);
        SampleGrid grid = SampleGrid.of(samplesX, samplesZ, heights);
        return new HeightField(grid, stepX, stepZ, Math.max(stepX, stepZ));
    }

    private static void step(String name, double step) {
        if (!(step >= 1 / MOST && step <= MOST)) {
            throw new DegenerateShapeException(
                    Double.isFinite(step) ? Reason.EXTENT : Reason.NOT_FINITE,
                    name + " is " + step + " m; it must lie in [1e-30, 1e30]");
        }
    }

    private static void check(double[] heights, int x, int z, int wide) {
        for (int i = 0; i < heights.length; i++) {
            if (!(Math.abs(heights[i]) <= MOST)) {
                throw new DegenerateShapeException(
                        Double.isFinite(heights[i]) ? Reason.EXTENT : Reason.NOT_FINITE,
                        "height of sample ("
                                + (x + i % wide)
                                + ", "
                                + (z + i / wide)
                                + ") is "
                                + heights[i]
                                + " m; it must lie in [-1e30, 1e30], and a hole is made by"
                                + " withHole");
            }
        }
    }

    private void inside(String what, int x, int z, int wide, int deep, int right, int far) {
        if (x < 0 || z < 0 || wide < 1 || deep < 1 || wide > right - x || deep > far - z) {
            throw new IllegalArgumentException(
                    wide
                            + " x "
                            + deep
                            + " "
                            + what
                            + " from ("
                            + x
                            + ", "
                            + z
                            + "); there are "
                            + right
                            + " x "
                            + far
                            + ", counted from 0");
        }
    }

    /**
     * The same with other heights of the samples in a rectangle. Takes the time and the memory of
     * the rectangle, and of 1/6 of a byte for each sample of the field.
     *
     * @param x the first sample along x
     * @param z the first sample along z
     * @param wide samples along x
     * @param heights by rows along x, as many rows as there are numbers, m
     * @return a new field
     * @throws DegenerateShapeException if a height is out of range
     * @throws IllegalArgumentException if the rectangle is not within the field
     */
    public HeightField withHeights(int x, int z, int wide, double[] heights) {
        int count = heights == null ? 0 : heights.length;
        if (wide < 1 || count % wide != 0) {
            throw new IllegalArgumentException(
                    count + " heights are no rows of " + wide + " samples");
        }
        inside("samples", x, z, wide, count / wide, grid.countX, grid.countZ);
        check(heights, x, z, wide);
        return new HeightField(grid.withHeights(x, z, wide, heights), stepX, stepZ, thickness);
    }

    /**
     * The same with the cells in a rectangle taken out, or put back.
     *
     * @param x the first cell along x
     * @param z the first cell along z
     * @param wide cells along x
     * @param deep cells along z
     * @param isHole whether there shall be a hole
     * @return a new field
     * @throws IllegalArgumentException if the rectangle is not within the field
     */
    public HeightField withHole(int x, int z, int wide, int deep, boolean isHole) {
        inside("cells", x, z, wide, deep, grid.countX - 1, grid.countZ - 1);
        int number = isHole ? SampleGrid.HOLE : 0;
        return new HeightField(grid.withCells(x, z, wide, deep, number), stepX, stepZ, thickness);
    }

    /**
     * The same with another material of the cells in a rectangle; holes there are closed.
     *
     * @param x the first cell along x
     * @param z the first cell along z
     * @param wide cells along x
     * @param deep cells along z
     * @param number which of the collider's materials, see {@code Collider.materials}, 0..254
     * @return a new field
     * @throws IllegalArgumentException if the rectangle is not within the field, or the number is
     *     out of range
     */
    public HeightField withMaterial(int x, int z, int wide, int deep, int number) {
        inside("cells", x, z, wide, deep, grid.countX - 1, grid.countZ - 1);
        Checks.material("material", number);
        return new HeightField(grid.withCells(x, z, wide, deep, number), stepX, stepZ, thickness);
    }

    @Override
    public int material(int triangle) {
        Objects.checkIndex(triangle, TriangleSet.of(this).count());
        return TriangleSet.of(this).material(triangle);
    }

    /**
     * The same with another thickness: whose centre is not deeper below the surface is pushed out.
     * More holds what is faster or covered by an edit; what shall stay below the ground wants less.
     *
     * @param metres 0..1e30; 0 for a surface without an inside
     * @return a new field that shares all samples
     * @throws IllegalArgumentException if it is out of range
     */
    public HeightField withThickness(double metres) {
        if (!(metres >= 0 && metres <= MOST)) {
            throw new IllegalArgumentException(
                    "thickness is " + metres + " m; it must lie in [0, 1e30]");
        }
        return new HeightField(grid, stepX, stepZ, metres);
    }

    void write(StateOutput out) {
        out.writeInt(grid.countX);
        out.writeInt(grid.countZ);
        out.writeDoubles(new double[] {stepX, stepZ, thickness});
        out.writeDoubles(heights());
        out.writeBoolean(grid.hasCells());
        if (grid.hasCells()) {
            int[] runs = runs();
            out.writeInts(runs);
        }
    }

    static HeightField read(StateInput in) {
        int x = in.readInt();
        int z = in.readInt();
        double[] numbers = in.readDoubles();
        HeightField field = of(x, z, numbers[0], numbers[1], in.readDoubles());
        SampleGrid grid = field.grid;
        if (in.readBoolean()) {
            int[] runs = in.readInts();
            for (int r = 0; r < runs.length; r += 4) {
                field.inside("cells", runs[r], runs[r + 1], runs[r + 2], 1, x - 1, z - 1);
                grid = grid.withCells(runs[r], runs[r + 1], runs[r + 2], 1, runs[r + 3] & 255);
            }
        }
        return new HeightField(grid, field.stepX, field.stepZ, numbers[2]);
    }

    /** Cells in a row that have one number: the first, along x and z, how many, and the number. */
    private int[] runs() {
        int[] runs = new int[16];
        int n = 0;
        for (int j = 0; j < grid.countZ - 1; j++) {
            for (int i = 0; i < grid.countX - 1; i++) {
                int number = grid.cell(i, j);
                if (number == 0) {
                    continue;
                }
                boolean goesOn = i > 0 && grid.cell(i - 1, j) == number;
                if (!goesOn) {
                    runs = n == runs.length ? Arrays.copyOf(runs, 2 * n) : runs;
                    runs[n] = i;
                    runs[n + 1] = j;
                    runs[n + 3] = number;
                    n += 4;
                }
                runs[n - 2]++;
            }
        }
        return Arrays.copyOf(runs, n);
    }

    /**
     * How many samples there are along x.
     *
     * @return at least 2
     */
    public int samplesX() {
        return grid.countX;
    }

    /**
     * How many samples there are along z.
     *
     * @return at least 2
     */
    public int samplesZ() {
        return grid.countZ;
    }

    /**
     * How far samples are from each other along x.
     *
     * @return m
     */
    public double stepX() {
        return stepX;
    }

    /**
     * How far samples are from each other along z.
     *
     * @return m
     */
    public double stepZ() {
        return stepZ;
    }

    /**
     * How far below the surface a centre may be and is still pushed out.
     *
     * @return m
     */
    public double thickness() {
        return thickness;
    }

    /**
     * The height of a sample.
     *
     * @param i along x, 0..{@code samplesX - 1}
     * @param j along z, 0..{@code samplesZ - 1}
     * @return m
     * @throws IllegalArgumentException if there is no such sample
     */
    public double sample(int i, int j) {
        inside("samples", i, j, 1, 1, grid.countX, grid.countZ);
        return grid.height(i, j);
    }

    /**
     * The height of the triangle at a place.
     *
     * @param x shape frame, m
     * @param z shape frame, m
     * @return m; NaN over a hole, or beside the field
     */
    public double height(double x, double z) {
        double u = x / stepX;
        double v = z / stepZ;
        if (!(u >= 0 && v >= 0 && u <= grid.countX - 1 && v <= grid.countZ - 1)) {
            return Double.NaN;
        }
        int i = Math.min(grid.countX - 2, (int) u);
        int j = Math.min(grid.countZ - 2, (int) v);
        return isHole(i, j) ? Double.NaN : grid.height(i, j, u - i, v - j);
    }

    /**
     * All heights.
     *
     * @return a new array by rows along x, m
     */
    public double[] heights() {
        double[] all = new double[grid.countX * grid.countZ];
        for (int i = 0; i < all.length; i++) {
            all[i] = grid.height(i % grid.countX, i / grid.countX);
        }
        return all;
    }

    /**
     * Whether a cell is not there.
     *
     * @param i along x, 0..{@code samplesX - 2}
     * @param j along z, 0..{@code samplesZ - 2}
     * @return whether bodies fall through it
     * @throws IllegalArgumentException if there is no such cell
     */
    public boolean isHole(int i, int j) {
        inside("cells", i, j, 1, 1, grid.countX - 1, grid.countZ - 1);
        return grid.cell(i, j) == SampleGrid.HOLE;
    }

    /**
     * Where another field differs from this one.
     *
     * @param other of as many samples and the same steps
     * @param dest receives minX, minY, minZ, maxX, maxY, maxZ of the cells that differ, old and new
     *     surface, shape frame, m
     * @return false if nowhere, or if the two are of different grids
     */
    public boolean differs(HeightField other, double[] dest) {
        int[] cells = new int[4];
        if (!isLike(other) || !grid.differs(other.grid, cells)) {
            return false;
        }
        dest[0] = cells[0] * stepX;
        dest[2] = cells[1] * stepZ;
        dest[3] = cells[2] * stepX;
        dest[5] = cells[3] * stepZ;
        dest[1] = Double.POSITIVE_INFINITY;
        dest[4] = Double.NEGATIVE_INFINITY;
        for (int j = cells[1]; j <= cells[3]; j++) {
            for (int i = cells[0]; i <= cells[2]; i++) {
                double a = grid.height(i, j);
                double b = other.grid.height(i, j);
                dest[1] = Math.min(dest[1], Math.min(a, b));
                dest[4] = Math.max(dest[4], Math.max(a, b));
            }
        }
        return true;
    }

    /**
     * Whether another field has as many samples at the same places, and the same thickness.
     *
     * @param other another one
     * @return whether it is this one after edits
     */
    public boolean isLike(HeightField other) {
        return grid.countX == other.grid.countX
                && grid.countZ == other.grid.countZ
                && stepX == other.stepX
                && stepZ == other.stepZ
                && thickness == other.thickness;
    }

    /**
     * The same surface as triangles, for tools; without the inside. Triangle t of the mesh is
     * triangle t of the field if there are no holes.
     *
     * @return a new mesh
     * @throws DegenerateShapeException if all cells are holes
     */
    public TriangleMesh toMesh() {
        TriangleSet set = TriangleSet.of(this);
        double[] xyz = new double[3 * grid.countX * grid.countZ];
        for (int v = 0; v < xyz.length / 3; v++) {
            int x = v % grid.countX;
            int z = v / grid.countX;
            xyz[3 * v] = x * stepX;
            xyz[3 * v + 1] = grid.height(x, z);
            xyz[3 * v + 2] = z * stepZ;
        }
        int[] index = new int[3 * set.count()];
        int n = 0;
        for (int t = 0; t < set.count(); t++) {
            int cell = t / 2;
            if (!isHole(cell % (grid.countX - 1), cell / (grid.countX - 1))) {
                for (int c = 0; c < 3; c++) {
                    index[n++] = set.vertex(t, c);
                }
            }
        }
        return TriangleMesh.of(xyz, Arrays.copyOf(index, n));
    }

    /**
     * Infinite mass and inertia; bodies are placed by sample (0, 0) at height 0.
     *
     * @param density kg/m³, positive and finite
     */
    @Override
    public MassProperties massProperties(double density) {
        return HalfSpace.of().massProperties(density);
    }

    @Override
    public double outerRadius() {
        double sum = 0;
        for (int axis = 0; axis < 3; axis++) {
            TriangleSet set = TriangleSet.of(this);
            double most = Math.max(Math.abs(set.end(axis, true)), Math.abs(set.end(axis, false)));
            sum += most * most;
        }
        return Math.sqrt(sum);
    }

    @Override
    public String toString() {
        return "HeightField["
                + grid.countX
                + " x "
                + grid.countZ
                + " samples, step="
                + stepX
                + " x "
                + stepZ
                + " m]";
    }
}
