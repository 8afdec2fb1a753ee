package dev.cairn.physics.shape;

import dev.cairn.core.job.Jobs;
import dev.cairn.core.state.StateInput;
import dev.cairn.core.state.StateOutput;
import dev.cairn.physics.shape.DegenerateShapeException.Reason;
import dev.cairn.physics.shape.mesh.GivenMesh;
import dev.cairn.physics.shape.mesh.MeshBuilder;
import dev.cairn.physics.shape.mesh.Meshed;
import dev.cairn.physics.shape.mesh.TriangleSet;

import org.joml.Vector3dc;

import java.util.Arrays;
import java.util.Objects;
import java.util.function.DoubleConsumer;
import java.util.stream.Collectors;

/**
 * A surface of triangles: the ground and the walls of a level. For fixed and kinematic bodies; any
 * number of them may share one mesh. Bodies meet the front of a triangle, from which its corners
 * are seen counter-clockwise, and pass through its back, unless the mesh is {@link #twoSided}.
 *
 * <p>It is a surface and not a solid: what is wholly inside is not pushed out. Inner edges are not
 * felt: what slides or rolls over flat or hollow edges meets the faces alone, see {@code
 * docs/levels.md}.
 */
public final class TriangleMesh extends Meshed implements Shape {
    /** Coordinates may be so large, so that boxes of single precision hold them. */
    private static final double MAX_COORDINATE = 1e30;

    private final GivenMesh given;
    private final MeshReport report;
    private final double outerRadius;

    /** By given triangle; empty if all are 0. */
    private final byte[] materials;

    private TriangleMesh(
            TriangleSet triangles, GivenMesh given, MeshReport report, byte[] materials) {
        super(triangles);
        this.given = given;
        this.report = report;
        this.materials = materials;
        outerRadius = given.outerRadius();
    }

    /**
     * The surface of triangles, with their fronts only.
     *
     * @param vertices x, y, z of each vertex, shape frame, m; not kept
     * @param indices three vertices for each triangle, counter-clockwise seen from the front; not
     *     kept
     * @return the shape; what was left out or looks wrong is told by {@link #report}
     * @throws DegenerateShapeException if a coordinate is not finite or beyond 1e30, or no triangle
     *     has an area
     * @throws IllegalArgumentException if an array is null, or of a length that is no multiple of
     *     three, or an index is out of range
     */
    public static TriangleMesh of(double[] vertices, int[] indices) {
        try (Jobs alone = Jobs.of(1)) {
            return of(vertices, indices, alone, share -> {});
        }
    }

    /**
     * The same with work on several workers: for levels of a million triangles. The mesh does not
     * depend on how many there are.
     *
     * @param vertices as of {@link #of(double[], int[])}
     * @param indices as there
     * @param jobs the workers; not those of a step that is under way
     * @param progress is told the share that is done, ascending to 1, on this thread
     * @return the shape
     */
    public static TriangleMesh of(
            double[] vertices, int[] indices, Jobs jobs, DoubleConsumer progress) {
        check("vertices", vertices == null ? -1 : vertices.length, "numbers per vertex");
        check("indices", indices == null ? -1 : indices.length, "vertices per triangle");
        for (int i = 0; i < vertices.length; i++) {
            if (!(Math.abs(vertices[i]) <= MAX_COORDINATE)) {
                throw new DegenerateShapeException(
                        Double.isFinite(vertices[i]) ? Reason.EXTENT : Reason.NOT_FINITE,
                        "xyz".charAt(i % 3)
                                + " of vertex "
                                + i / 3
                                + " is "
                                + vertices[i]
                                + " m; it must lie in [-1e30, 1e30]");
            }
        }
        for (int i = 0; i < indices.length; i++) {
            if (indices[i] < 0 || 3L * indices[i] >= vertices.length) {
                throw new IllegalArgumentException(
                        "corner "
                                + i % 3
                                + " of triangle "
                                + i / 3
                                + " is vertex "
                                + indices[i]
                                + "; there are "
                                + vertices.length / 3
                                + ", counted from 0");
            }
        }
        return build(vertices, indices, false, jobs, progress);
    }

    void write(StateOutput out) {
        out.writeDoubles(given.vertices());
        out.writeInts(given.indices());
        out.writeBoolean(isTwoSided());
        out.writeInts(materials());
    }

    static TriangleMesh read(StateInput in) {
        TriangleMesh mesh = of(in.readDoubles(), in.readInts());
        mesh = in.readBoolean() ? mesh.twoSided() : mesh;
        int[] materials = in.readInts();
        return materials.length == 0 ? mesh : mesh.withMaterials(materials);
    }

    private TriangleMesh like(TriangleMesh other) {
        return other.materials.length == 0 ? this : with(other.materials);
    }

    private TriangleMesh with(byte[] numbers) {
        TriangleSet set = MeshBuilder.with(TriangleSet.of(this), numbers);
        return new TriangleMesh(set, given, report, numbers);
    }

    /**
     * The same surface with a number for each triangle: which of its collider's materials it has,
     * see {@code Collider.materials}. Shares all else with this one.
     *
     * @param numbers of each triangle as they were given, 0..254; not kept
     * @return a new mesh
     * @throws IllegalArgumentException if there are not as many as triangles, or one is out of
     *     range
     */
    public TriangleMesh withMaterials(int[] numbers) {
        int count = given.triangles();
        if (numbers == null || numbers.length != count) {
            throw new IllegalArgumentException(
                    "there are "
                            + (numbers == null ? "no" : "" + numbers.length)
                            + " numbers of materials; give one to each of the "
                            + count
                            + " triangles");
        }
        byte[] narrow = new byte[count];
        for (int t = 0; t < count; t++) {
            narrow[t] = (byte) Checks.material("material of triangle " + t, numbers[t]);
        }
        return with(narrow);
    }

    @Override
    public int material(int triangle) {
        Objects.checkIndex(triangle, given.triangles());
        return materials.length == 0 ? 0 : materials[triangle] & 255;
    }

    /**
     * The numbers of all materials.
     *
     * @return a new array, of each triangle as they were given; empty if none was said
     */
    public int[] materials() {
        int[] all = new int[materials.length];
        Arrays.setAll(all, t -> materials[t] & 255);
        return all;
    }

    private static void check(String name, int length, String what) {
        if (length < 0) {
            throw new IllegalArgumentException(name + " is null; give three " + what);
        }
        if (length % 3 != 0) {
            throw new IllegalArgumentException(
                    name + " has " + length + " entries; it must have three " + what);
        }
    }

    private static TriangleMesh build(
            double[] vertices,
            int[] indices,
            boolean isTwoSided,
            Jobs jobs,
            DoubleConsumer progress) {
        MeshBuilder builder = new MeshBuilder(vertices, indices);
        TriangleSet triangles = builder.build(isTwoSided, jobs, progress);
        if (triangles == null) {
            throw new DegenerateShapeException(
                    Reason.COLLINEAR,
                    "none of the "
                            + indices.length / 3
                            + " triangles has an area; give one whose corners are not on a line");
        }
        MeshReport report =
                new MeshReport(
                        triangles.count(),
                        Arrays.stream(builder.degenerate)
                                .boxed()
                                .collect(Collectors.toUnmodifiableList()),
                        builder.welded,
                        builder.openEdges,
                        builder.crowdedEdges,
                        builder.flippedEdges);
        return new TriangleMesh(triangles, builder.given(), report, new byte[0]);
    }

    /**
     * The same surface with both sides of each triangle.
     *
     * @return this mesh if it is so already, else a new one
     */
    public TriangleMesh twoSided() {
        if (isTwoSided()) {
            return this;
        }
        TriangleSet both = MeshBuilder.twoSided(TriangleSet.of(this));
        return new TriangleMesh(both, given, report, materials);
    }

    /**
     * The same surface at another size, or mirrored: what was in front stays in front.
     *
     * @param x factor along x, finite and not 0; negative to mirror
     * @param y see {@code x}
     * @param z see {@code x}
     * @return a new mesh
     * @throws IllegalArgumentException if a factor is 0 or not finite, or makes a coordinate too
     *     large
     */
    public TriangleMesh scaled(double x, double y, double z) {
        double[] factor = {x, y, z};
        for (double f : factor) {
            if (!(Math.abs(f) > 0 && Math.abs(f) <= Double.MAX_VALUE)) {
                throw new IllegalArgumentException(
                        "scale is ("
                                + x
                                + ", "
                                + y
                                + ", "
                                + z
                                + "); no factor may be 0 or infinite");
            }
        }
        double[] moved = given.vertices();
        for (int i = 0; i < moved.length; i++) {
            moved[i] *= factor[i % 3];
        }
        int[] turned = given.indices();
        if (Math.signum(x) * Math.signum(y) * Math.signum(z) < 0) {
            for (int t = 0; t < turned.length; t += 3) {
                int second = turned[t + 1];
                turned[t + 1] = turned[t + 2];
                turned[t + 2] = second;
            }
        }
        TriangleMesh mesh = of(moved, turned).like(this);
        return isTwoSided() ? mesh.twoSided() : mesh;
    }

    /**
     * The same surface at another size, or mirrored.
     *
     * @param factors along x, y and z, each finite and not 0
     * @return a new mesh
     */
    public TriangleMesh scaled(Vector3dc factors) {
        return scaled(factors.x(), factors.y(), factors.z());
    }

    /**
     * Whether bodies meet both sides.
     *
     * @return false if they pass through the backs of triangles
     */
    public boolean isTwoSided() {
        return TriangleSet.of(this).isTwoSided;
    }

    /**
     * What was found when the mesh was made.
     *
     * @return the report
     */
    public MeshReport report() {
        return report;
    }

    /**
     * The vertices as they were given.
     *
     * @return a new array x, y, z, ..., shape frame, m; in linear time
     */
    public double[] vertices() {
        return given.vertices();
    }

    /**
     * The triangles as they were given, degenerate ones too. A corner where several vertices are at
     * one place is the first of them, whichever was given.
     *
     * @return a new array of three vertices for each triangle; in linear time
     */
    public int[] indices() {
        return given.indices();
    }

    /**
     * Mass, centre of mass and inertia of what the surface encloses, exactly: for a body whose
     * colliders only come near to it, see {@code Body.massProperties}. Places where the surface
     * overlaps itself count once for each time.
     *
     * @param density kg/m³, positive and finite
     * @return about the centre of mass, in the axes of the mesh's frame
     * @throws IllegalArgumentException if the surface is not closed ({@link MeshReport#isClosed}),
     *     encloses nothing or is turned inside out, or the density is out of range
     */
    public MassProperties solidProperties(double density) {
        Checks.density(density);
        if (!report.isClosed()) {
            throw new IllegalArgumentException(
                    "the mesh is not closed, so it encloses no volume: it has "
                            + report.openEdges()
                            + " open, "
                            + report.crowdedEdges()
                            + " crowded and "
                            + report.flippedEdges()
                            + " flipped edges; close it, or state the mass");
        }
        int[] indices = given.indices();
        int[][] faces = new int[indices.length / 3][];
        for (int t = 0; t < faces.length; t++) {
            faces[t] = Arrays.copyOfRange(indices, 3 * t, 3 * t + 3);
        }
        MassProperties unit = Solids.integrate(given.vertices(), faces);
        if (!(unit.mass() > 0)) {
            throw new IllegalArgumentException(
                    "the mesh encloses "
                            + unit.mass()
                            + " m³; it must be above 0: corners are counter-clockwise seen from"
                            + " outside, else turn the triangles");
        }
        return unit.times(density);
    }

    /**
     * Infinite mass and inertia; bodies are placed by the origin of the mesh's frame.
     *
     * @param density kg/m³, positive and finite
     */
    @Override
    public MassProperties massProperties(double density) {
        return HalfSpace.of().massProperties(density);
    }

    @Override
    public double outerRadius() {
        return outerRadius;
    }

    @Override
    public String toString() {
        return "TriangleMesh[triangles=" + report.triangles() + ", twoSided=" + isTwoSided() + "]";
    }
}
