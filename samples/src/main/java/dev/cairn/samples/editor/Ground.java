package dev.cairn.samples.editor;

import dev.cairn.samples.scenefile.BodyKind;
import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenefile.SceneFile;
import dev.cairn.samples.scenefile.ShapeSpec;
import dev.cairn.samples.scenefile.ShapeSpec.GroundShape;
import dev.cairn.samples.scenefile.ShapeSpec.MovedShape;
import dev.cairn.samples.scenefile.Turn;
import dev.cairn.samples.scenefile.Xyz;
import dev.cairn.samples.scenefile.edit.SceneEdit;

import org.joml.Quaterniond;
import org.joml.Vector3d;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;

/**
 * What other things stand on: fixed half-spaces, and fixed slabs at least {@link #SLAB} times as
 * wide and deep as high. A click into the picture means what stands on the ground, never the ground
 * itself, which is chosen in the list. World frame, metres. Stateless.
 */
final class Ground {
    private static final double SLAB = 5;

    /** Nearer or farther than this the middle of the picture says little about where to place. */
    private static final double NEAREST = 2;

    private static final double FARTHEST = 40;

    /** Where no ground is ahead. */
    private static final double AHEAD = 8;

    /** Less than this is rounding, m. */
    private static final double TOUCHING = 1e-6;

    private Ground() {}

    static boolean is(EntitySpec entity) {
        if (entity.body() != BodyKind.FIXED) {
            return false;
        }
        if (isHalfSpace(entity.shape())) {
            return true;
        }
        Sizes sizes = Sizes.of(entity);
        double high = sizes.high().y() - sizes.low().y();
        return sizes.high().x() - sizes.low().x() >= SLAB * high
                && sizes.high().z() - sizes.low().z() >= SLAB * high;
    }

    private static boolean isHalfSpace(ShapeSpec shape) {
        return switch (shape) {
            case GroundShape() -> true;
            case MovedShape(ShapeSpec inner, Xyz at, Turn turn) -> isHalfSpace(inner);
            default -> false;
        };
    }

    /** A place on the ground in the middle of the picture, or some metres ahead. */
    static Xyz ahead(Vector3d eye, Vector3d along, List<EntitySpec> entities) {
        double nearest = Double.POSITIVE_INFINITY;
        for (EntitySpec entity : entities) {
            if (is(entity)) {
                Upper upper = new Upper(entity);
                double t = upper.distance(eye, along);
                if (t > NEAREST && t < FARTHEST && t < nearest) {
                    Vector3d hit = new Vector3d(eye).fma(t, along);
                    nearest = upper.covers(hit.x, hit.z) ? t : nearest;
                }
            }
        }
        Vector3d hit = new Vector3d(eye).fma(nearest > FARTHEST ? AHEAD : nearest, along);
        return new Xyz(hit.x, hit.y, hit.z);
    }

    /**
     * Puts a thing onto the ground.
     *
     * @param made the thing, turned as it will be
     * @param at its place; the height does not count
     * @param entities what is there
     * @return the place at which its lowest point is on the highest ground under the box around it;
     *     without ground there, on y = 0
     */
    static Xyz under(EntitySpec made, Xyz at, List<EntitySpec> entities) {
        Vector3d[] corners = Sizes.of(made).corners(new Xyz(at.x(), 0, at.z()), made.rotation());
        double lowest = Double.POSITIVE_INFINITY;
        for (Vector3d corner : corners) {
            lowest = Math.min(lowest, corner.y);
        }
        double highest = Double.NEGATIVE_INFINITY;
        for (EntitySpec entity : entities) {
            if (is(entity)) {
                Upper upper = new Upper(entity);
                for (Vector3d corner : corners) {
                    if (upper.covers(corner.x, corner.z)) {
                        highest = Math.max(highest, upper.height(corner.x, corner.z));
                    }
                }
            }
        }
        double ground = highest == Double.NEGATIVE_INFINITY ? 0 : highest;
        return new Xyz(at.x(), Math.rint((ground - lowest) * 1e6) / 1e6, at.z());
    }

    /**
     * Puts things down onto what is below them: the ground, or the box around another thing.
     *
     * @param scene the scene
     * @param which places in its list; the lowest goes first, so that a stack stays one
     * @return the scene with them standing
     */
    static SceneFile dropped(SceneFile scene, int[] which) {
        List<Integer> order = new ArrayList<>(Arrays.stream(which).boxed().toList());
        order.sort(Comparator.comparingDouble(i -> box(scene.entities().get(i)).low().y()));
        SceneFile now = scene;
        for (int index : order) {
            EntitySpec entity = now.entities().get(index);
            Sizes own = box(entity);
            double ground = under(entity, entity.position(), now.entities()).y();
            double top = Double.NEGATIVE_INFINITY;
            for (int i = 0; i < now.entities().size(); i++) {
                EntitySpec other = now.entities().get(i);
                Sizes below = box(other);
                if (i != index
                        && !is(other)
                        && below.low().x() < own.high().x()
                        && below.high().x() > own.low().x()
                        && below.low().z() < own.high().z()
                        && below.high().z() > own.low().z()
                        && below.high().y() <= own.low().y() + TOUCHING) {
                    top = Math.max(top, below.high().y());
                }
            }
            double onOther = entity.position().y() + top - own.low().y();
            double height = Math.rint(Math.max(ground, onOther) * 1e6) / 1e6;
            now =
                    SceneEdit.move(
                            now,
                            index,
                            new Xyz(entity.position().x(), height, entity.position().z()));
        }
        return now;
    }

    private static Sizes box(EntitySpec entity) {
        return Sizes.around(List.of(entity));
    }

    /** The plane of a ground's upper side: n · p = n · point. */
    private static final class Upper {
        private final boolean endless;
        private final Vector3d normal = new Vector3d(0, 1, 0);
        private final Vector3d point;
        private double lowX = Double.POSITIVE_INFINITY;
        private double highX = Double.NEGATIVE_INFINITY;
        private double lowZ = Double.POSITIVE_INFINITY;
        private double highZ = Double.NEGATIVE_INFINITY;

        Upper(EntitySpec ground) {
            endless = isHalfSpace(ground.shape());
            Turn turn = ground.rotation();
            Quaterniond q = new Quaterniond(turn.x(), turn.y(), turn.z(), turn.w()).normalize();
            q.transform(normal);
            Xyz at = ground.position();
            Sizes sizes = Sizes.of(ground);
            point =
                    q.transform(new Vector3d(0, sizes.high().y(), 0))
                            .add(
                                    Sizes.bounded(at.x()),
                                    Sizes.bounded(at.y()),
                                    Sizes.bounded(at.z()));
            for (Vector3d corner : sizes.corners(at, turn)) {
                lowX = Math.min(lowX, corner.x);
                highX = Math.max(highX, corner.x);
                lowZ = Math.min(lowZ, corner.z);
                highZ = Math.max(highZ, corner.z);
            }
        }

        boolean covers(double x, double z) {
            return normal.y > 0
                    && (endless || (x >= lowX && x <= highX && z >= lowZ && z <= highZ));
        }

        double height(double x, double z) {
            return point.y - (normal.x * (x - point.x) + normal.z * (z - point.z)) / normal.y;
        }

        /** Where a ray from above meets the plane; negative or NaN where it does not. */
        double distance(Vector3d eye, Vector3d along) {
            double down = -normal.dot(along);
            return down <= 0 ? -1 : new Vector3d(eye).sub(point).dot(normal) / down;
        }
    }
}
