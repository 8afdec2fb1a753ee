package dev.cairn.physics.state;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.island.Sleepers;
import dev.cairn.physics.shape.HeightField;
import dev.cairn.physics.shape.Moved;
import dev.cairn.physics.shape.Shape;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

/**
 * Ground that becomes another one in a rectangle: bodies that sleep there wake, no others are
 * disturbed. Between steps. Stateless.
 */
public final class GroundEdit {
    /** Of a ball's radius: how far from what has changed it still wakes. */
    private static final double NEAR = 1.25;

    private GroundEdit() {}

    /**
     * The field of a shape that is one before and after, and differs in nothing but heights and
     * cells.
     *
     * @return null if it is another shape
     */
    public static @Nullable HeightField edited(Shape before, Shape after) {
        if (before instanceof Moved m && after instanceof Moved n && m.isPlacedAs(n)) {
            return edited(m.inner(), n.inner());
        }
        return before instanceof HeightField f && after instanceof HeightField g && f.isLike(g)
                ? g
                : null;
    }

    /**
     * Wakes the bodies that sleep where the ground differs.
     *
     * @param ground the collider, still with its old shape
     * @param after its new one, see {@link #edited}
     */
    public static void wake(
            ColliderStore colliders, Sleepers sleepers, int ground, HeightField after) {
        Shape shape = colliders.shape[ground];
        Quaterniond turn =
                new Quaterniond(
                        colliders.poses.orientationX[ground],
                        colliders.poses.orientationY[ground],
                        colliders.poses.orientationZ[ground],
                        colliders.poses.orientationW[ground]);
        if (shape instanceof Moved m) {
            turn.mul(m.rotation(new Quaterniond()));
            shape = m.inner();
        }
        double[] box = new double[6];
        if (!(shape instanceof HeightField before) || !before.differs(after, box)) {
            return;
        }
        box[1] -= before.thickness();
        BodyStore bodies = colliders.bodies;
        Vector3d at = new Vector3d();
        for (int s = 0; sleepers.asleepCount() > 0 && s < bodies.slotCount; s++) {
            for (int c = bodies.collider[s];
                    bodies.kind[s] == BodyStore.ASLEEP && c != ColliderStore.NONE;
                    c = colliders.next[c]) {
                at.set(
                        colliders.poses.apartX(ground, c),
                        colliders.poses.apartY(ground, c),
                        colliders.poses.apartZ(ground, c));
                turn.transformInverse(at);
                if (isNear(at, NEAR * colliders.outerRadius[c], box)) {
                    sleepers.wake(s);
                }
            }
        }
    }

    private static boolean isNear(Vector3d at, double radius, double[] box) {
        boolean near = true;
        for (int axis = 0; axis < 3; axis++) {
            double x = at.get(axis);
            near &= x >= box[axis] - radius && x <= box[axis + 3] + radius;
        }
        return near;
    }
}
