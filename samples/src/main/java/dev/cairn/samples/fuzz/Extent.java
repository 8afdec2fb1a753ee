package dev.cairn.samples.fuzz;

import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenefile.PartSpec;
import dev.cairn.samples.scenefile.ShapeSpec;
import dev.cairn.samples.scenefile.Xyz;

import java.util.List;

/** How large and how thin the shapes of the generator are. */
final class Extent {
    private Extent() {}

    /** Radius of the ball about an entity's origin that holds all of its parts, m. */
    static double outer(EntitySpec entity) {
        double most = 0;
        for (PartSpec part : entity.parts()) {
            most = Math.max(most, length(part.position()) + outer(part.shape()));
        }
        return most;
    }

    /** Half the least thickness of an entity's parts, m. */
    static double inner(EntitySpec entity) {
        double least = Double.POSITIVE_INFINITY;
        for (PartSpec part : entity.parts()) {
            least = Math.min(least, inner(part.shape()));
        }
        return least;
    }

    /** Radius of the ball about the origin of a shape's frame that holds it, m. */
    static double outer(ShapeSpec shape) {
        return switch (shape) {
            case ShapeSpec.SphereShape(double radius) -> radius;
            case ShapeSpec.BoxShape(Xyz half) -> length(half);
            case ShapeSpec.TurnedShape(String type, double radius, double half) ->
                    type.equals("capsule")
                            ? radius + half
                            : Math.sqrt(radius * radius + half * half);
            case ShapeSpec.HullShape(List<Xyz> points) -> {
                double most = 0;
                for (Xyz point : points) {
                    most = Math.max(most, length(point));
                }
                yield most;
            }
            default -> Double.POSITIVE_INFINITY;
        };
    }

    /** Half the least thickness of a shape along an axis of its frame, m. */
    static double inner(ShapeSpec shape) {
        return switch (shape) {
            case ShapeSpec.SphereShape(double radius) -> radius;
            case ShapeSpec.BoxShape(Xyz half) -> least(half);
            case ShapeSpec.TurnedShape(String type, double radius, double half) ->
                    type.equals("capsule") ? radius : Math.min(radius, half);
            case ShapeSpec.HullShape(List<Xyz> points) -> {
                double x = 0;
                double y = 0;
                double z = 0;
                for (Xyz point : points) {
                    x = Math.max(x, Math.abs(point.x()));
                    y = Math.max(y, Math.abs(point.y()));
                    z = Math.max(z, Math.abs(point.z()));
                }
                yield least(new Xyz(x, y, z));
            }
            default -> Double.POSITIVE_INFINITY;
        };
    }

    static double length(Xyz v) {
        return Math.sqrt(v.x() * v.x() + v.y() * v.y() + v.z() * v.z());
    }

    private static double least(Xyz v) {
        return Math.min(v.x(), Math.min(v.y(), v.z()));
    }
}
