package dev.cairn.physics.contact;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.Poses;
import dev.cairn.physics.internal.Rotations;
import dev.cairn.physics.internal.Surface;
import dev.cairn.physics.narrowphase.pair.Manifold;

/**
 * Renews the contacts of a convex shape on a surface of triangles that has hardly moved since they
 * were found, as {@link PolyhedronRecycler} does for two solids: the pair is kept as a whole, with
 * the pose of the shape seen from the surface in its first row.
 *
 * <p>Of each row the normal m is kept, in the surface's axes, and of each point its place p on the
 * shape and its height b along m. With the shape's centre e now, seen from the surface,
 *
 * <pre>
 *   separation = m . (e + p) - b
 * </pre>
 *
 * <p>which is exact on a face, and on an edge or a corner up to the square of the move, for there m
 * is a stationary point of the separation. A corner's p turns with the shape. Of a round side p
 * goes with the axis u: with the height h along it, the radius r, and the radius c around the core,
 *
 * <pre>
 *   p = h u + r d - c m,    d the unit vector across u that is most against m
 * </pre>
 *
 * <p>so a ball that rolls stays above its contact. The bound of the move and of the error are those
 * of {@link PolyhedronRecycler}. One worker's.
 */
final class SurfaceRecycler {
    /** Numbers of a row in {@link ContactStore#ground}: normal, heights, then which are round. */
    private static final int HEIGHT = 3, ROUND = 7;

    /** Sine of the least angle between normal and axis at which a rim has a deepest point. */
    private static final double TILTED = 0.05;

    /** Cosine of an angle that is 0 up to rounding. */
    private static final double ALIGNED = 1 - 1e-12;

    private final ColliderStore colliders;
    private final BodyStore bodies;
    private final Poses s;
    private final PairGroups groups;
    private ContactStore c = new ContactStore();
    private double stepSquared;

    /** What the last turn gave. */
    private final double[] t = new double[3];

    SurfaceRecycler(ColliderStore colliders, PairGroups groups) {
        this.colliders = colliders;
        this.groups = groups;
        bodies = colliders.bodies;
        s = colliders.poses;
    }

    /** Chooses the columns. */
    void use(ContactStore rows, double stepSeconds) {
        c = rows;
        stepSquared = stepSeconds * stepSeconds;
    }

    /**
     * Renews all rows of a pair.
     *
     * @param head its first row
     * @param surface the collider of triangles
     * @param shape the other one
     * @param margin up to which points are reported now, m
     * @param face the same of faces
     * @param slack how much less of it may have been looked through, m
     * @return false when the pair must be collided
     */
    boolean renew(int head, int surface, int shape, double margin, double face, double slack) {
        if (!c.keeps[head]) {
            return false;
        }
        int at = ContactStore.keptAt(head);
        if (!(margin <= c.kept[at + PolyhedronRecycler.GAP] + slack)
                || !(KeptPose.moved(c.kept, at, s, surface, shape)
                        <= c.kept[at + PolyhedronRecycler.LIMIT])) {
            return false;
        }
        for (int row = head; row >= 0; row = groups.next(row)) {
            if (c.pointCount[row] > 0 && !(c.keeps[row] && points(row, surface, shape) <= face)) {
                return false;
            }
        }
        return true;
    }

    /** Writes a row from the present poses; returns the largest separation. */
    private double points(int row, int surface, int shape) {
        double[] g = c.ground;
        int at = ContactStore.GROUND * row;
        turn(surface, g[at], g[at + 1], g[at + 2]);
        double nx = t[0];
        double ny = t[1];
        double nz = t[2];
        boolean flip = c.colliderA[row] == shape;
        c.setNormal(row, flip ? -nx : nx, flip ? -ny : ny, flip ? -nz : nz);
        double ex = s.apartX(surface, shape);
        double ey = s.apartY(surface, shape);
        double ez = s.apartZ(surface, shape);
        double[] anchors = c.anchors;
        double farthest = -Double.MAX_VALUE;
        for (int p = 0; p < c.pointCount[row]; p++) {
            int point = ContactStore.POINTS * row + p;
            int kept = ContactStore.keptAt(row) + PolyhedronRecycler.POINT + 3 * p;
            if (((int) g[at + ROUND] >> p & 1) != 0) {
                round(shape, c.kept[kept], c.kept[kept + 1], nx, ny, nz);
            } else {
                turn(shape, c.kept[kept], c.kept[kept + 1], c.kept[kept + 2]);
            }
            double separation =
                    nx * (ex + t[0]) + ny * (ey + t[1]) + nz * (ez + t[2]) - g[at + HEIGHT + p];
            farthest = Math.max(farthest, separation);
            // anchors are midway between the surfaces
            double half = 0.5 * separation;
            double x = t[0] - half * nx;
            double y = t[1] - half * ny;
            double z = t[2] - half * nz;
            int own = ContactStore.anchor(point) + (flip ? 0 : 3);
            anchors[own] = x;
            anchors[own + 1] = y;
            anchors[own + 2] = z;
            int other = ContactStore.anchor(point) + (flip ? 3 : 0);
            anchors[other] = x + ex;
            anchors[other + 1] = y + ey;
            anchors[other + 2] = z + ez;
            c.separation[point] = separation;
        }
        return farthest;
    }

    /** Into t: a direction of a collider's axes, in those of the world. */
    private void turn(int collider, double vx, double vy, double vz) {
        Rotations.rotate(
                s.orientationX[collider],
                s.orientationY[collider],
                s.orientationZ[collider],
                s.orientationW[collider],
                vx,
                vy,
                vz,
                t);
    }

    /** Into t: the point of a round side that is deepest against a normal. */
    private void round(int shape, double along, double across, double nx, double ny, double nz) {
        int at = BodyStore.REVOLUTION * shape;
        double[] axis = bodies.revolution;
        turn(shape, axis[at], axis[at + 1], axis[at + 2]);
        double cosine = t[0] * nx + t[1] * ny + t[2] * nz;
        double dx = cosine * t[0] - nx;
        double dy = cosine * t[1] - ny;
        double dz = cosine * t[2] - nz;
        double r = across == 0 ? 0 : across / Math.sqrt(dx * dx + dy * dy + dz * dz);
        double core = core(shape);
        t[0] = along * t[0] + r * dx - core * nx;
        t[1] = along * t[1] + r * dy - core * ny;
        t[2] = along * t[2] + r * dz - core * nz;
    }

    /** The radius around the core of a solid of revolution, of a ball its own, m. */
    private double core(int shape) {
        double laid = bodies.revolution[BodyStore.REVOLUTION * shape + 3];
        return laid > 0 ? laid : isBall(shape) ? colliders.outerRadius[shape] : 0;
    }

    private boolean isBall(int shape) {
        int at = BodyStore.REVOLUTION * shape;
        double[] axis = bodies.revolution;
        return axis[at] == 0 && axis[at + 1] == 0 && axis[at + 2] == 0;
    }

    /**
     * Whether a pair is worth keeping: one whose bodies will be elsewhere in the next tick need not
     * be remembered.
     */
    private boolean stays(int head, double allowed) {
        int a = c.bodyA[head];
        int b = c.bodyB[head];
        double vx = bodies.velocityX[b] - bodies.velocityX[a];
        double vy = bodies.velocityY[b] - bodies.velocityY[a];
        double vz = bodies.velocityZ[b] - bodies.velocityZ[a];
        return stepSquared * (vx * vx + vy * vy + vz * vz) < allowed * allowed;
    }

    /**
     * Keeps the pose of a pair that was collided, if it is worth it; its rows are to be kept then.
     *
     * @param margin up to which points were looked for, m
     * @return whether it is
     */
    boolean keep(int head, int surface, int shape, double margin) {
        double allowed = PolyhedronRecycler.SHARE * colliders.innerRadius[shape];
        c.keeps[head] = stays(head, allowed);
        if (c.keeps[head]) {
            int at = ContactStore.keptAt(head);
            double radius = colliders.outerRadius[shape];
            KeptPose.keep(c.kept, at + PolyhedronRecycler.POSE, s, surface, shape, radius);
            c.kept[at + PolyhedronRecycler.LIMIT] = allowed * allowed;
            c.kept[at + PolyhedronRecycler.GAP] = margin;
        }
        return c.keeps[head];
    }

    /**
     * Keeps the points of a row.
     *
     * @param m what was stored
     */
    void keepRow(int row, int surface, int shape, Manifold m) {
        boolean flip = c.colliderA[row] == shape;
        double sign = flip ? -1 : 1;
        int kept = ContactStore.keptAt(row) + PolyhedronRecycler.POINT;
        PolyhedronRecycler.keepPoints(c.kept, kept, s, surface, shape, m, flip);
        int at = ContactStore.GROUND * row;
        double[] g = c.ground;
        double nx = sign * m.normalX;
        double ny = sign * m.normalY;
        double nz = sign * m.normalZ;
        turnBack(surface, nx, ny, nz);
        g[at] = t[0];
        g[at + 1] = t[1];
        g[at + 2] = t[2];
        turnBack(shape, nx, ny, nz);
        double ox = t[0];
        double oy = t[1];
        double oz = t[2];
        double e =
                nx * s.apartX(surface, shape)
                        + ny * s.apartY(surface, shape)
                        + nz * s.apartZ(surface, shape);
        int rounds = 0;
        for (int p = 0; p < m.pointCount; p++) {
            int k = kept + 3 * p;
            double height = ox * c.kept[k] + oy * c.kept[k + 1] + oz * c.kept[k + 2];
            g[at + HEIGHT + p] = e + height - m.separation[p];
            rounds |= keepRound(shape, k, ox, oy, oz) ? 1 << p : 0;
        }
        g[at + ROUND] = rounds;
        c.keeps[row] = true;
    }

    /** Keeps a point of a round side as height and radius, if it is the deepest there. */
    private boolean keepRound(int shape, int k, double nx, double ny, double nz) {
        if (colliders.surface[shape] == Surface.CORNERED) {
            return false;
        }
        int at = BodyStore.REVOLUTION * shape;
        double[] axis = bodies.revolution;
        double core = core(shape);
        double x = c.kept[k] + core * nx;
        double y = c.kept[k + 1] + core * ny;
        double z = c.kept[k + 2] + core * nz;
        double along = axis[at] * x + axis[at + 1] * y + axis[at + 2] * z;
        x -= along * axis[at];
        y -= along * axis[at + 1];
        z -= along * axis[at + 2];
        double across = Math.sqrt(x * x + y * y + z * z);
        if (across <= 1e-9 * colliders.innerRadius[shape]) {
            across = 0;
        } else {
            double cosine = axis[at] * nx + axis[at + 1] * ny + axis[at + 2] * nz;
            double dx = cosine * axis[at] - nx;
            double dy = cosine * axis[at + 1] - ny;
            double dz = cosine * axis[at + 2] - nz;
            double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
            if (isBall(shape)
                    || length < TILTED
                    || !(x * dx + y * dy + z * dz >= ALIGNED * across * length)) {
                return false;
            }
        }
        c.kept[k] = along;
        c.kept[k + 1] = across;
        c.kept[k + 2] = 0;
        return true;
    }

    /** Into t: a direction of the world, in a collider's axes. */
    private void turnBack(int collider, double vx, double vy, double vz) {
        Rotations.rotate(
                -s.orientationX[collider],
                -s.orientationY[collider],
                -s.orientationZ[collider],
                s.orientationW[collider],
                vx,
                vy,
                vz,
                t);
    }
}
