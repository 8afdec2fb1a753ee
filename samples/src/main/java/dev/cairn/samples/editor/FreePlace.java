package dev.cairn.samples.editor;

import dev.cairn.samples.scenefile.EntitySpec;
import dev.cairn.samples.scenefile.Turn;
import dev.cairn.samples.scenefile.Xyz;

import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;

/**
 * Finds room for a new entity: boxes along the axes of the world around all that is there must not
 * overlap the one around it. Touching is no overlap, so that a thing may stand on a floor. World
 * frame, metres. Stateless; allocates.
 */
final class FreePlace {
    /** Between things that were placed beside each other, m. */
    private static final double GAP = 0.1;

    /** Farther aside a thing is placed on top rather, m: it would be out of the picture. */
    private static final double ASIDE = 5;

    private FreePlace() {}

    /**
     * The nearest free place on either side; on top of what is there where both are far.
     *
     * @param entity what shall be placed, turned as it will be
     * @param wanted where
     * @param there what is there
     * @param alongX whether aside is along x; else along z
     * @param grid places aside are multiples of this; 0 = any
     * @return the place wanted if it is free
     */
    static Xyz near(
            EntitySpec entity, Xyz wanted, List<EntitySpec> there, boolean alongX, double grid) {
        int axis = alongX ? 0 : 2;
        List<Block> blocks = new ArrayList<>();
        for (EntitySpec other : there) {
            blocks.add(Block.around(other, other.position()));
        }
        Block start = Block.around(entity, wanted);
        double right = shift(start, blocks, axis, 1, grid);
        double left = shift(start, blocks, axis, -1, grid);
        double aside = right <= -left ? right : left;
        if (Math.abs(aside) <= ASIDE) {
            return alongX
                    ? new Xyz(wanted.x() + aside, wanted.y(), wanted.z())
                    : new Xyz(wanted.x(), wanted.y(), wanted.z() + aside);
        }
        return new Xyz(wanted.x(), wanted.y() + shift(start, blocks, 1, 1, 0), wanted.z());
    }

    /** How far a block has to go until it overlaps nothing; each step passes one of the others. */
    private static double shift(
            Block start, List<Block> blocks, int axis, int direction, double grid) {
        double gap = axis == 1 ? 0 : GAP;
        double shift = 0;
        Block now = start;
        Block hit = now.firstOverlap(blocks);
        while (hit != null) {
            double past =
                    direction > 0
                            ? hit.high.get(axis) + gap - start.low.get(axis)
                            : hit.low.get(axis) - gap - start.high.get(axis);
            shift = grid > 0 ? direction * Math.ceil(direction * past / grid) * grid : past;
            now = start.moved(axis, shift);
            hit = now.firstOverlap(blocks);
        }
        return shift;
    }

    private record Block(Vector3d low, Vector3d high) {
        /** Less than this is rounding, m. */
        private static final double TOUCHING = 1e-9;

        static Block around(EntitySpec entity, Xyz position) {
            Turn turn = entity.rotation();
            Vector3d low = new Vector3d(Double.POSITIVE_INFINITY);
            Vector3d high = new Vector3d(Double.NEGATIVE_INFINITY);
            for (Vector3d corner : Sizes.of(entity).corners(position, turn)) {
                low.min(corner);
                high.max(corner);
            }
            return new Block(low, high);
        }

        Block moved(int axis, double by) {
            Vector3d shift = new Vector3d().setComponent(axis, by);
            return new Block(new Vector3d(low).add(shift), new Vector3d(high).add(shift));
        }

        @Nullable Block firstOverlap(List<Block> blocks) {
            for (Block other : blocks) {
                boolean apart = false;
                for (int axis = 0; axis < 3; axis++) {
                    apart |=
                            low.get(axis) >= other.high.get(axis) - TOUCHING
                                    || high.get(axis) <= other.low.get(axis) + TOUCHING;
                }
                if (!apart) {
                    return other;
                }
            }
            return null;
        }
    }
}
