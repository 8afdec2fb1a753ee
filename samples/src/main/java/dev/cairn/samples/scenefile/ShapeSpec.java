package dev.cairn.samples.scenefile;

import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Cone;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Cylinder;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.HeightField;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.shape.TriangleMesh;
import dev.cairn.physics.shape.decomposition.Decomposer;

import org.joml.Quaterniond;

import java.util.List;

/** What an entity is shaped like, before its scale. Immutable. */
public sealed interface ShapeSpec {
    /**
     * The word in the file.
     *
     * @return the value of {@code type}
     */
    String type();

    /**
     * A block around the origin of its frame.
     *
     * @param halfExtents half its width, height and depth, m
     */
    record BoxShape(Xyz halfExtents) implements ShapeSpec {
        @Override
        public String type() {
            return "box";
        }
    }

    /**
     * A ball around the origin of its frame.
     *
     * @param radius m
     */
    record SphereShape(double radius) implements ShapeSpec {
        @Override
        public String type() {
            return "sphere";
        }
    }

    /**
     * The convex hull of points.
     *
     * @param points at least four that are not in a plane, m
     */
    record HullShape(List<Xyz> points) implements ShapeSpec {
        /** Copies the list. */
        public HullShape {
            points = List.copyOf(points);
        }

        @Override
        public String type() {
            return "hull";
        }
    }

    /**
     * A capsule, cylinder or cone along the y axis of its frame.
     *
     * @param type {@code capsule}, {@code cylinder} or {@code cone}
     * @param radius m
     * @param halfHeight half the height, m; for a capsule without its round ends
     */
    record TurnedShape(String type, double radius, double halfHeight) implements ShapeSpec {}

    /** Everything below the plane y = 0 of its frame. */
    record GroundShape() implements ShapeSpec {
        @Override
        public String type() {
            return "half-space";
        }
    }

    /**
     * A shape at another place of the body.
     *
     * @param shape which one
     * @param position where its frame's origin is, m
     * @param rotation how it is turned
     */
    record MovedShape(ShapeSpec shape, Xyz position, Turn rotation) implements ShapeSpec {
        @Override
        public String type() {
            return "moved";
        }
    }

    /** What a file of triangles collides as. */
    enum As {
        /** The convex hull of its points. */
        HULL,
        /** Its triangles; such a body is not dynamic. */
        LEVEL,
        /** Convex parts that are nearly its solid, with the mass of the solid. */
        PARTS
    }

    /**
     * A file of triangles: drawn as it is.
     *
     * @param file path of an {@code .obj} file
     * @param as what it collides as
     * @param parts most parts, if it does so as parts
     * @param error how far a part may go beyond the solid, a share of its longest side
     */
    record MeshShape(String file, As as, int parts, double error) implements ShapeSpec {
        /** Parts, and the error that is allowed, if a file says nothing. */
        public static final int PARTS = 32;

        /** See {@link #PARTS}. */
        public static final double ERROR = 0.02;

        /** Checks the ranges. */
        public MeshShape {
            if (parts < 1 || parts > Decomposer.MOST_PARTS) {
                throw new IllegalArgumentException(
                        "parts is %d, expected 1..%d".formatted(parts, Decomposer.MOST_PARTS));
            }
            if (!(error >= Decomposer.LEAST_ERROR && error <= 1)) {
                throw new IllegalArgumentException(
                        "error is %s, expected %s..1".formatted(error, Decomposer.LEAST_ERROR));
            }
        }

        /**
         * Collides as the convex hull.
         *
         * @param file path of an {@code .obj} file
         */
        public MeshShape(String file) {
            this(file, As.HULL, PARTS, ERROR);
        }

        /**
         * The same from another file.
         *
         * @param value path of an {@code .obj} file
         * @return a copy
         */
        public MeshShape withFile(String value) {
            return new MeshShape(value, as, parts, error);
        }

        @Override
        public String type() {
            return "mesh";
        }
    }

    /**
     * A surface of triangles, for bodies that are not dynamic.
     *
     * @param points the vertices, m
     * @param triangles three vertices for each triangle, counted from 0, counter-clockwise seen
     *     from the front
     * @param twoSided whether bodies meet the backs too
     */
    record SurfaceShape(List<Xyz> points, List<Integer> triangles, boolean twoSided)
            implements ShapeSpec {
        /** Copies the lists. */
        public SurfaceShape {
            points = List.copyOf(points);
            triangles = List.copyOf(triangles);
        }

        @Override
        public String type() {
            return "triangles";
        }
    }

    /**
     * Ground by heights on a regular grid, for bodies that are not dynamic.
     *
     * @param samplesX samples along x
     * @param stepX between samples along x, m
     * @param stepZ between samples along z, m
     * @param thickness how far below its surface bodies are pushed out, m
     * @param heights by rows along x, m
     * @param holes cells that are not there
     */
    record FieldShape(
            int samplesX,
            double stepX,
            double stepZ,
            double thickness,
            List<Double> heights,
            List<Cells> holes)
            implements ShapeSpec {
        /**
         * A rectangle of cells.
         *
         * @param x the first along x
         * @param z the first along z
         * @param wide how many along x
         * @param deep how many along z
         */
        public record Cells(int x, int z, int wide, int deep) {}

        /** Copies the lists. */
        public FieldShape {
            heights = List.copyOf(heights);
            holes = List.copyOf(holes);
        }

        @Override
        public String type() {
            return "heights";
        }

        private HeightField at(Xyz scale) {
            double[] scaled = new double[heights.size()];
            for (int i = 0; i < scaled.length; i++) {
                scaled[i] = heights.get(i) * scale.y();
            }
            HeightField field =
                    HeightField.of(
                                    samplesX,
                                    scaled.length / samplesX,
                                    stepX * scale.x(),
                                    stepZ * scale.z(),
                                    scaled)
                            .withThickness(thickness * scale.y());
            for (Cells hole : holes) {
                field = field.withHole(hole.x, hole.z, hole.wide, hole.deep, true);
            }
            return field;
        }
    }

    /**
     * Whether only bodies that are not dynamic can have it.
     *
     * @return true for levels: surfaces of triangles and heights
     */
    default boolean isSurface() {
        return switch (this) {
            case MovedShape moved -> moved.shape().isSurface();
            case MeshShape mesh -> mesh.as() == As.LEVEL;
            case SurfaceShape surface -> true;
            case FieldShape field -> true;
            default -> false;
        };
    }

    /**
     * The collision shape. A mesh has none before its file is read.
     *
     * @param scale factors along the shape's axes, &gt; 0; a round shape wants three equal ones
     * @return the shape at its size
     * @throws IllegalArgumentException if a size is out of range, the hull is flat, or a round
     *     shape would be squashed
     * @throws IllegalStateException for a mesh
     */
    default Shape collider(Xyz scale) {
        return switch (this) {
            case BoxShape(Xyz half) ->
                    Box.ofHalfExtents(
                            half.x() * scale.x(), half.y() * scale.y(), half.z() * scale.z());
            case SphereShape(double radius) -> Sphere.of(radius * uniform(scale));
            case HullShape(List<Xyz> points) -> ConvexHull.of(flat(points, scale));
            case SurfaceShape(List<Xyz> points, List<Integer> triangles, boolean twoSided) -> {
                TriangleMesh mesh =
                        TriangleMesh.of(
                                flat(points, scale),
                                triangles.stream().mapToInt(Integer::intValue).toArray());
                yield twoSided ? mesh.twoSided() : mesh;
            }
            case FieldShape field -> field.at(scale);
            case TurnedShape(String type, double radius, double half) -> {
                double r = radius * scale.x();
                double h = half * scale.y();
                if (scale.x() != scale.z() || (scale.x() != scale.y() && type.equals("capsule"))) {
                    uniform(scale);
                }
                yield switch (type) {
                    case "capsule" -> Capsule.of(r, h);
                    case "cylinder" -> Cylinder.of(r, h);
                    default -> Cone.of(r, h);
                };
            }
            case GroundShape() -> HalfSpace.of();
            case MovedShape(ShapeSpec inner, Xyz at, Turn turn) ->
                    inner.collider(Xyz.ONE.equals(scale) ? scale : allEqual(scale))
                            .moved(
                                    at.x() * scale.x(),
                                    at.y() * scale.x(),
                                    at.z() * scale.x(),
                                    new Quaterniond(turn.x(), turn.y(), turn.z(), turn.w()));
            case MeshShape mesh ->
                    throw new IllegalStateException(
                            "mesh " + mesh.file() + " has no collision shape before it is read");
        };
    }

    private static double[] flat(List<Xyz> points, Xyz scale) {
        double[] xyz = new double[3 * points.size()];
        for (int i = 0; i < points.size(); i++) {
            xyz[3 * i] = points.get(i).x() * scale.x();
            xyz[3 * i + 1] = points.get(i).y() * scale.y();
            xyz[3 * i + 2] = points.get(i).z() * scale.z();
        }
        return xyz;
    }

    private static Xyz allEqual(Xyz scale) {
        uniform(scale);
        return scale;
    }

    private static double uniform(Xyz scale) {
        if (scale.x() != scale.y() || scale.x() != scale.z()) {
            throw new IllegalArgumentException(
                    "scale of a round shape is (%s, %s, %s), expected three equal factors"
                            .formatted(scale.x(), scale.y(), scale.z()));
        }
        return scale.x();
    }
}
