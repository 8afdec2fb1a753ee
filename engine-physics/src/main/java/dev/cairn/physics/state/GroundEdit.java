package dev.cairn.physics.state;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.island.SleepingBodies;
import dev.cairn.physics.shape.HeightField;
import dev.cairn.physics.shape.Moved;
import dev.cairn.physics.shape.Shape;

import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

/**
 * Ground that becomes another one in a rectangle: bodies that sleep there wake, and contacts there
 * forget what they remember of the old one; no others are disturbed. Between steps.
 */
public final class GroundEdit {
    /** Of a ball's radius: how far from what has changed it still wakes. */
    private static final double NEAR = 1.25;

    private final ColliderStore colliders;
    private final int ground;

    /** World from field. */
    private final Quaterniond turn;

    /** What has changed, in the axes of the field, from its place: least and most x, y, z. */
    private final double[] box;

    private final Vector3d at = new Vector3d();

    private GroundEdit(ColliderStore colliders, int ground, Quaterniond turn, double[] box) {
        this.colliders = colliders;
        this.ground = ground;
        this.turn = turn;
        this.box = box;
    }

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
     * What an edit changes.
     *
     * @param ground the collider, still with its old shape
     * @param after its new one, see {@link #edited}
     * @return null if that is nothing
     */
    public static @Nullable GroundEdit of(ColliderStore colliders, int ground, HeightField after) {
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
            return null;
        }
        box[1] -= before.thickness();
        return new GroundEdit(colliders, ground, turn, box);
    }

    /** Wakes the bodies that sleep where the ground differs. */
    public void wake(SleepingBodies sleepers) {
        BodyStore bodies = colliders.bodies;
        for (int s = 0; sleepers.asleepCount() > 0 && s < bodies.slotCount; s++) {
            for (int c = bodies.collider[s];
                    bodies.kind[s] == BodyStore.ASLEEP && c != ColliderStore.NONE;
                    c = colliders.next[c]) {
                if (isNear(c, 0)) {
                    sleepers.wake(s);
                }
            }
        }
    }

    /**
     * Forgets what rows remember of the ground where it differs, as far as they looked around; what
     * is collided anew anyhow does not tell how far that was.
     */
    public void renew(ContactStore contacts) {
        boolean[] isNear = new boolean[colliders.slotCount];
        for (int row = 0; row < contacts.count; row++) {
            int other = other(contacts, row);
            if (other >= 0 && !isNear[other]) {
                double gap = contacts.kept[ContactStore.keptAt(row) + ContactStore.KEPT_GAP];
                isNear[other] = !contacts.keeps[row] || isNear(other, gap);
            }
        }
        for (int row = 0; row < contacts.count; row++) {
            int other = other(contacts, row);
            if (other >= 0 && isNear[other]) {
                contacts.renewRow(row, colliders);
            }
        }
    }

    /** The collider that a row tells touches the ground, or -1. */
    private int other(ContactStore contacts, int row) {
        int a = contacts.colliderA[row];
        int b = contacts.colliderB[row];
        return a == ground ? b : b == ground ? a : -1;
    }

    private boolean isNear(int c, double gap) {
        at.set(
                colliders.poses.apartX(ground, c),
                colliders.poses.apartY(ground, c),
                colliders.poses.apartZ(ground, c));
        turn.transformInverse(at);
        double radius = NEAR * colliders.outerRadius[c] + gap;
        boolean near = true;
        for (int axis = 0; axis < 3; axis++) {
            double x = at.get(axis);
            near &= x >= box[axis] - radius && x <= box[axis + 3] + radius;
        }
        return near;
    }
}
