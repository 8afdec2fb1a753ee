package dev.cairn.physics.contact.seam;

import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.Poses;
import dev.cairn.physics.narrowphase.pair.ContactTolerances;
import dev.cairn.physics.narrowphase.pair.Reach;

/**
 * The contacts of one collider M with its neighbours, the members of a group of {@link SeamStage}:
 * along which normal each holds M off, where the neighbour is from M, and which neighbours are
 * behind the plane of another one. Lengths are told from M's centre, in world axes.
 *
 * <p>One instance per worker.
 */
final class SeamMembers {
    /** Of M's inner radius: surfaces that are nearer to one plane are flush. */
    private static final double FLUSH = 0x1p-15;

    /** Rounding of a reach, of the lengths that it is the sum of. */
    private static final double ROUNDING = 0x1p-46;

    /** Square of the distance of unit vectors that are the same normal. */
    private static final double SAME = 1e-18;

    private final ColliderStore colliders;
    private final ContactStore contacts;
    private final Reach own = new Reach();

    /** The shape of the neighbour {@code taken}. */
    private final Reach shape = new Reach();

    private int taken;

    /** M. */
    int m;

    int size;
    private int[] member = {};
    private int from;

    /** By member: normal towards M; from M's centre to the neighbour's; least separation. */
    double[] normal = {}, apart = {}, separation = {};

    /** By member: how far its neighbour reaches along its normal, from M's centre. */
    double[] plane = {};

    SeamMembers(ColliderStore colliders, ContactStore contacts) {
        this.colliders = colliders;
        this.contacts = contacts;
    }

    /** Makes room for groups of some size; between phases only. */
    void ensure(int most) {
        if (separation.length < most) {
            int n = Math.max(32, 2 * most);
            normal = new double[3 * n];
            apart = new double[3 * n];
            separation = new double[n];
            plane = new double[n];
        }
    }

    /** Chooses a collider and its contacts. */
    void begin(int collider, int[] members, int first, int number) {
        m = collider;
        member = members;
        from = first;
        size = number;
        take(m, own);
        taken = ColliderStore.NONE;
        ContactStore c = contacts;
        Poses s = colliders.poses;
        for (int i = 0; i < size; i++) {
            int row = row(i);
            double sign = isSecond(i) ? 1 : -1;
            normal[3 * i] = sign * c.normalX(row);
            normal[3 * i + 1] = sign * c.normalY(row);
            normal[3 * i + 2] = sign * c.normalZ(row);
            int k = neighbour(i);
            apart[3 * i] = s.apartX(m, k);
            apart[3 * i + 1] = s.apartY(m, k);
            apart[3 * i + 2] = s.apartZ(m, k);
            double least = Double.POSITIVE_INFINITY;
            for (int p = 0; p < c.pointCount[row]; p++) {
                least = Math.min(least, c.separation[ContactStore.POINTS * row + p]);
            }
            separation[i] = least;
            snap(i);
        }
    }

    /**
     * Takes the normal of the neighbour's face, where that separates as well as the contact's: the
     * narrow phase may have chosen a face of M, which is tilted against the surface.
     */
    private void snap(int i) {
        take(neighbour(i));
        int n = 3 * i;
        double cosine = shape.findFace(normal[n], normal[n + 1], normal[n + 2]);
        if (cosine >= ContactTolerances.NEARLY_PARALLEL) {
            double x = shape.faceX;
            double y = shape.faceY;
            double z = shape.faceZ;
            if (x == normal[n] && y == normal[n + 1] && z == normal[n + 2]) {
                plane[i] = height(x, y, z, i);
                return;
            }
            double face = height(x, y, z, i);
            double lowest = -own.along(-x, -y, -z);
            double held = 2 * ContactTolerances.HYSTERESIS * colliders.innerRadius[m];
            if (lowest - face >= separation[i] - held) {
                normal[n] = x;
                normal[n + 1] = y;
                normal[n + 2] = z;
                plane[i] = face;
                return;
            }
        }
        plane[i] = height(normal[n], normal[n + 1], normal[n + 2], i);
    }

    /** How far a neighbour reaches along a direction, from M's centre. */
    private double height(double x, double y, double z, int k) {
        take(neighbour(k));
        return shape.along(x, y, z)
                + (x * apart[3 * k] + y * apart[3 * k + 1] + z * apart[3 * k + 2]);
    }

    private void take(int collider) {
        if (collider != taken) {
            take(collider, shape);
            taken = collider;
        }
    }

    private void take(int collider, Reach to) {
        Poses s = colliders.poses;
        to.set(
                colliders.shape[collider],
                s.orientationX[collider],
                s.orientationY[collider],
                s.orientationZ[collider],
                s.orientationW[collider]);
    }

    int row(int i) {
        return member[from + i] >> 1;
    }

    boolean isSecond(int i) {
        return (member[from + i] & 1) != 0;
    }

    int neighbour(int i) {
        return isSecond(i) ? contacts.colliderA[row(i)] : contacts.colliderB[row(i)];
    }

    /** Its entry in the stage's list: twice the row, plus 1 where M is B. */
    int entry(int i) {
        return member[from + i];
    }

    /** Two members change places. */
    void swap(int i, int j) {
        if (i == j) {
            return;
        }
        int entry = member[from + i];
        member[from + i] = member[from + j];
        member[from + j] = entry;
        for (int axis = 0; axis < 3; axis++) {
            double number = normal[3 * i + axis];
            normal[3 * i + axis] = normal[3 * j + axis];
            normal[3 * j + axis] = number;
            number = apart[3 * i + axis];
            apart[3 * i + axis] = apart[3 * j + axis];
            apart[3 * j + axis] = number;
        }
        double least = separation[i];
        separation[i] = separation[j];
        separation[j] = least;
        double most = plane[i];
        plane[i] = plane[j];
        plane[j] = most;
    }

    /** Whether a neighbour is behind the plane that another one touches along its normal. */
    boolean covers(int j, int k) {
        if (!movesTogether(neighbour(j), neighbour(k))) {
            return false;
        }
        double most = height(normal[3 * j], normal[3 * j + 1], normal[3 * j + 2], k);
        double slack = slack(j);
        // a half-space reaches for ever along all but one: no rounding of that is a distance
        return most <= plane[j] + slack + Math.min(slack, ROUNDING * Math.abs(most));
    }

    double slack(int j) {
        double size =
                Math.abs(apart[3 * j]) + Math.abs(apart[3 * j + 1]) + Math.abs(apart[3 * j + 2]);
        return FLUSH * colliders.innerRadius[m] + ROUNDING * size;
    }

    boolean movesTogether(int j, int k) {
        return colliders.bodies.movesWith(colliders.body[j], colliders.body[k]);
    }

    /** Whether two members have the same normal. */
    boolean isSame(int i, int j) {
        double x = normal[3 * i] - normal[3 * j];
        double y = normal[3 * i + 1] - normal[3 * j + 1];
        double z = normal[3 * i + 2] - normal[3 * j + 2];
        return x * x + y * y + z * z <= SAME;
    }

    /** Whether a point, from M's centre, is in a neighbour or within a slack of it. */
    boolean holds(int k, double x, double y, double z) {
        take(neighbour(k));
        return shape.holds(
                x - apart[3 * k], y - apart[3 * k + 1], z - apart[3 * k + 2], 2 * slack(k));
    }
}
