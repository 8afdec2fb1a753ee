package dev.cairn.samples.editor;

import dev.cairn.render.camera.Camera;
import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenefile.PartSpec;
import dev.cairn.samples.scenefile.ShapeSpec;
import dev.cairn.samples.scenefile.ShapeSpec.BoxShape;
import dev.cairn.samples.scenefile.ShapeSpec.FieldShape;
import dev.cairn.samples.scenefile.ShapeSpec.GroundShape;
import dev.cairn.samples.scenefile.ShapeSpec.HullShape;
import dev.cairn.samples.scenefile.ShapeSpec.MeshShape;
import dev.cairn.samples.scenefile.ShapeSpec.MovedShape;
import dev.cairn.samples.scenefile.ShapeSpec.SphereShape;
import dev.cairn.samples.scenefile.ShapeSpec.SurfaceShape;
import dev.cairn.samples.scenefile.ShapeSpec.TurnedShape;
import dev.cairn.samples.scenefile.Turn;
import dev.cairn.samples.scenefile.Xyz;

import org.joml.Quaterniond;
import org.joml.Vector3d;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * The box around an entity's shape, in the frame of the shape, after its scale. A mesh counts as
 * the cube that stands in for it, since its file is not read here. Immutable.
 *
 * @param low least coordinates, m
 * @param high greatest coordinates, m
 */
record Sizes(Xyz low, Xyz high) {
    /** A half-space is shown as a square of this half width, m. */
    private static final double GROUND_HALF = 5;

    /**
     * What is beyond this counts as being there, m: sums and products of boxes stay numbers, and
     * nobody sees the difference.
     */
    private static final double FARTHEST = 1e30;

    /** The camera goes no nearer than to a ball of this radius, m. */
    private static final double LEAST_RADIUS = 0.1;

    static Sizes of(EntitySpec entity) {
        Xyz s = entity.scale();
        if (entity.physics().parts().isEmpty()) {
            return of(entity.shape(), s);
        }
        List<Vector3d> corners = new ArrayList<>();
        for (PartSpec part : entity.parts()) {
            Xyz at = part.position();
            Xyz place = bounded(at.x() * s.x(), at.y() * s.x(), at.z() * s.x());
            corners.addAll(List.of(of(part.shape(), s).corners(place, part.rotation())));
        }
        return around(corners);
    }

    /** Moves a camera, along the way that it looks, to where it sees all of the box. */
    void frame(Camera camera) {
        Vector3d diagonal =
                new Vector3d(high.x() - low.x(), high.y() - low.y(), high.z() - low.z());
        double radius = Math.max(0.5 * diagonal.length(), LEAST_RADIUS);
        double distance = 1.3 * radius / Math.sin(camera.fieldOfView() / 2);
        Vector3d from = camera.forward(new Vector3d()).mul(-distance);
        camera.moveTo(
                from.x + (low.x() + high.x()) / 2,
                from.y + (low.y() + high.y()) / 2,
                from.z + (low.z() + high.z()) / 2);
    }

    /** The box, along the axes of the world, around entities where they are. */
    static Sizes around(Iterable<EntitySpec> entities) {
        List<Vector3d> corners = new ArrayList<>();
        for (EntitySpec entity : entities) {
            corners.addAll(List.of(of(entity).corners(entity.position(), entity.rotation())));
        }
        return around(corners);
    }

    double width() {
        return high.x() - low.x();
    }

    private static Sizes of(ShapeSpec shape, Xyz s) {
        return switch (shape) {
            case BoxShape(Xyz half) -> around(half.x() * s.x(), half.y() * s.y(), half.z() * s.z());
            case SphereShape(double radius) ->
                    around(radius * s.x(), radius * s.y(), radius * s.z());
            case TurnedShape(String type, double radius, double half) ->
                    around(
                            radius * s.x(),
                            half * s.y() + (type.equals("capsule") ? radius * s.x() : 0),
                            radius * s.z());
            case GroundShape() -> around(GROUND_HALF, 0, GROUND_HALF);
            case MovedShape(ShapeSpec inner, Xyz at, Turn turn) -> {
                Xyz place = bounded(at.x() * s.x(), at.y() * s.x(), at.z() * s.x());
                yield around(List.of(of(inner, s).corners(place, turn)));
            }
            case MeshShape mesh -> around(0.5 * s.x(), 0.5 * s.y(), 0.5 * s.z());
            case HullShape(List<Xyz> points) -> around(scaled(points, s));
            case SurfaceShape surface -> around(scaled(surface.points(), s));
            case FieldShape field -> around(scaled(corners(field), s));
        };
    }

    /** The lowest and the highest point, in opposite corners. */
    private static List<Xyz> corners(FieldShape field) {
        List<Double> heights = field.heights();
        int rows = heights.size() / field.samplesX();
        return List.of(
                new Xyz(0, Collections.min(heights), 0),
                new Xyz(
                        (field.samplesX() - 1) * field.stepX(),
                        Collections.max(heights),
                        (rows - 1) * field.stepZ()));
    }

    private static List<Vector3d> scaled(List<Xyz> points, Xyz s) {
        return points.stream()
                .map(p -> new Vector3d(p.x() * s.x(), p.y() * s.y(), p.z() * s.z()))
                .toList();
    }

    private static Sizes around(double x, double y, double z) {
        return new Sizes(bounded(-x, -y, -z), bounded(x, y, z));
    }

    private static Sizes around(List<Vector3d> points) {
        Vector3d low = new Vector3d(Double.POSITIVE_INFINITY);
        Vector3d high = new Vector3d(Double.NEGATIVE_INFINITY);
        for (Vector3d point : points) {
            low.min(point);
            high.max(point);
        }
        return new Sizes(bounded(low.x, low.y, low.z), bounded(high.x, high.y, high.z));
    }

    /** Products of what a file may say have no end. */
    private static Xyz bounded(double x, double y, double z) {
        return new Xyz(bounded(x), bounded(y), bounded(z));
    }

    /** A coordinate that sums and products may be made of. */
    static double bounded(double metres) {
        return Math.clamp(metres, -FARTHEST, FARTHEST);
    }

    /** The eight corners in the world; bit 0, 1, 2 of the index: high in x, y, z. */
    Vector3d[] corners(Xyz position, Turn turn) {
        Quaterniond q = new Quaterniond(turn.x(), turn.y(), turn.z(), turn.w()).normalize();
        Vector3d[] corners = new Vector3d[8];
        for (int i = 0; i < 8; i++) {
            corners[i] =
                    q.transform(
                                    new Vector3d(
                                            (i & 1) == 0 ? low.x() : high.x(),
                                            (i & 2) == 0 ? low.y() : high.y(),
                                            (i & 4) == 0 ? low.z() : high.z()))
                            .add(
                                    bounded(position.x()),
                                    bounded(position.y()),
                                    bounded(position.z()));
        }
        return corners;
    }
}
