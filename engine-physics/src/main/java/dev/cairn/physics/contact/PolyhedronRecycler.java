package dev.cairn.physics.contact;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.Poses;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.narrowphase.pair.WarmStartKey;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.polyhedron.Polyhedron;

/**
 * Renews the points of pairs of boxes and hulls that have hardly moved since they were collided,
 * without colliding them again. Let the reference be the solid whose face carries the contact (or
 * separates the pair), the incident solid the other one. Seen from the reference, the incident
 * solid has moved by at most what {@link KeptPose} tells. Up to {@link #SHARE} of the smaller inner
 * radius the same points of the incident solid are the contact still: their separations from the
 * face, and the normal, are those of the present poses. A pair that is apart stays so while it has
 * moved by less than its distance exceeds the margin.
 *
 * <p>With d the true signed distance when the pair was collided, d' the one now, s and s' the least
 * separations of the points: |d' - d| and |s' - s| are each at most the move, so the reported depth
 * is as true as it was up to twice the {@link #SHARE}. The moves do not add up: they are counted
 * from the poses at which the pair was collided. The idea is Catto's and Jolt's, see {@code
 * solver-study} section 5.1; the bound is this engine's.
 */
final class PolyhedronRecycler {
    /** Of the smaller inner radius: how far a pair may move before it is collided again. */
    static final double SHARE = 0x1p-12;

    // What is kept of a row, from ContactStore.keptAt on ------------------------------------------

    /** The incident box seen from the reference. */
    static final int POSE = 0;

    /** Distance of the face's plane from the centre of the reference, m. */
    private static final int PLANE = KeptPose.SIZE;

    /** The square of the allowed move, m2. */
    static final int LIMIT = 9;

    /** The separation up to which nothing is left out, m. */
    static final int GAP = ContactStore.KEPT_GAP;

    /** The points on the incident box in its axes, m, three numbers each. */
    static final int POINT = ContactStore.KEPT_POINT;

    private final ColliderStore colliders;
    private final BodyStore bodies;
    private final Poses s;
    private ContactStore c = new ContactStore();
    private double stepSquared;

    /** Of some colliders. */
    PolyhedronRecycler(ColliderStore colliders) {
        this.colliders = colliders;
        bodies = colliders.bodies;
        s = colliders.poses;
    }

    /** Chooses the columns. */
    void use(ContactStore rows, double stepSeconds) {
        c = rows;
        stepSquared = stepSeconds * stepSeconds;
    }

    /** Whether pairs of such shapes may be kept. */
    static boolean fits(Shape shape) {
        return shape instanceof Box || shape instanceof ConvexHull;
    }

    /**
     * Renews a row.
     *
     * @return false when the pair must be collided
     */
    boolean renew(int row, double margin) {
        if (!c.keeps[row]) {
            return false;
        }
        double[] k = c.kept;
        int at = ContactStore.keptAt(row);
        double room = k[at + GAP] - margin;
        if (!(room > 0)) {
            return false;
        }
        boolean flip = flip(row);
        int r = flip ? c.colliderB[row] : c.colliderA[row];
        int i = flip ? c.colliderA[row] : c.colliderB[row];
        double moved = KeptPose.moved(k, at + POSE, s, r, i);
        if (!(moved <= k[at + LIMIT] && moved < room * room)) {
            return false;
        }
        if (c.pointCount[row] == 0) {
            return true;
        }
        int face = WarmStartKey.faceOf(c.cache[row]);
        double rx = s.orientationX[r];
        double ry = s.orientationY[r];
        double rz = s.orientationZ[r];
        double rw = s.orientationW[r];
        double sign = (face & 1) == 0 ? -1 : 1;
        // The face's outward normal: of a box a column of its rotation matrix.
        double nx;
        double ny;
        double nz;
        if (colliders.shape[r] instanceof ConvexHull hull) {
            Polyhedron h = Polyhedron.of(hull);
            double x = h.normalX(face);
            double y = h.normalY(face);
            double z = h.normalZ(face);
            double ux = 2 * (ry * z - rz * y);
            double uy = 2 * (rz * x - rx * z);
            double uz = 2 * (rx * y - ry * x);
            nx = x + rw * ux + (ry * uz - rz * uy);
            ny = y + rw * uy + (rz * ux - rx * uz);
            nz = z + rw * uz + (rx * uy - ry * ux);
        } else if (face >> 1 == 1) {
            nx = sign * (2 * (rx * ry - rw * rz));
            ny = sign * (1 - 2 * (rx * rx + rz * rz));
            nz = sign * (2 * (ry * rz + rw * rx));
        } else if (face >> 1 == 0) {
            nx = sign * (1 - 2 * (ry * ry + rz * rz));
            ny = sign * (2 * (rx * ry + rw * rz));
            nz = sign * (2 * (rx * rz - rw * ry));
        } else {
            nx = sign * (2 * (rx * rz + rw * ry));
            ny = sign * (2 * (ry * rz - rw * rx));
            nz = sign * (1 - 2 * (rx * rx + ry * ry));
        }
        c.setNormal(row, flip ? -nx : nx, flip ? -ny : ny, flip ? -nz : nz);
        // A point that leaves the margin is a matter for the narrow phase, which writes all anew.
        return points(row, flip, r, i, nx, ny, nz) <= margin;
    }

    /** Writes the points from the present poses; returns the largest separation. */
    private double points(int row, boolean flip, int r, int i, double nx, double ny, double nz) {
        double ex = s.apartX(r, i);
        double ey = s.apartY(r, i);
        double ez = s.apartZ(r, i);
        double ix = s.orientationX[i];
        double iy = s.orientationY[i];
        double iz = s.orientationZ[i];
        double iw = s.orientationW[i];
        double m00 = 1 - 2 * (iy * iy + iz * iz);
        double m01 = 2 * (ix * iy - iw * iz);
        double m02 = 2 * (ix * iz + iw * iy);
        double m10 = 2 * (ix * iy + iw * iz);
        double m11 = 1 - 2 * (ix * ix + iz * iz);
        double m12 = 2 * (iy * iz - iw * ix);
        double m20 = 2 * (ix * iz - iw * iy);
        double m21 = 2 * (iy * iz + iw * ix);
        double m22 = 1 - 2 * (ix * ix + iy * iy);
        double[] k = c.kept;
        int at = ContactStore.keptAt(row);
        double before = ex * nx + ey * ny + ez * nz - k[at + PLANE];
        int to = ContactStore.POINTS * row;
        int end = to + c.pointCount[row];
        double[] anchors = c.anchors;
        int incident = ContactStore.anchor(to) + (flip ? 0 : 3);
        int reference = ContactStore.anchor(to) + (flip ? 3 : 0);
        double farthest = -Double.MAX_VALUE;
        for (int p = at + POINT;
                to < end;
                to++, p += 3, incident += ContactStore.ANCHORS, reference += ContactStore.ANCHORS) {
            double x = m00 * k[p] + m01 * k[p + 1] + m02 * k[p + 2];
            double y = m10 * k[p] + m11 * k[p + 1] + m12 * k[p + 2];
            double z = m20 * k[p] + m21 * k[p + 1] + m22 * k[p + 2];
            double separation = x * nx + y * ny + z * nz + before;
            farthest = separation > farthest ? separation : farthest;
            // Anchors are midway between the surfaces.
            double half = 0.5 * separation;
            x -= half * nx;
            y -= half * ny;
            z -= half * nz;
            anchors[incident] = x;
            anchors[incident + 1] = y;
            anchors[incident + 2] = z;
            anchors[reference] = x + ex;
            anchors[reference + 1] = y + ey;
            anchors[reference + 2] = z + ez;
            c.separation[to] = separation;
        }
        return farthest;
    }

    /** The reference is B. */
    private boolean flip(int row) {
        return WarmStartKey.onFaceOfB(c.cache[row]);
    }

    /**
     * Keeps what {@link #renew} needs, after a row was collided and stored.
     *
     * @param m what was stored
     * @param gap the least separation of a point that was left out for the margin; of a pair that
     *     is apart a lower bound of its distance; NaN when the contact is not one of a face
     */
    void keep(int row, Manifold m, double gap, double margin) {
        boolean apart = m.pointCount == 0;
        c.keeps[row] = false;
        if (!stays(row, apart, gap, margin)) {
            return;
        }
        int a = c.colliderA[row];
        int b = c.colliderB[row];
        double allowed = allowed(a, b, apart, gap, margin);
        c.keeps[row] = true;
        boolean flip = flip(row);
        int r = flip ? b : a;
        int i = flip ? a : b;
        double[] k = c.kept;
        int at = ContactStore.keptAt(row);
        KeptPose.keep(k, at + POSE, s, r, i, colliders.outerRadius[i]);
        k[at + PLANE] = offset(colliders.shape[r], WarmStartKey.faceOf(c.cache[row]));
        k[at + LIMIT] = apart ? Double.MAX_VALUE : allowed * allowed;
        k[at + GAP] = gap;
        keepPoints(k, at + POINT, s, r, i, m, flip);
    }

    /**
     * Whether a pair is worth keeping: one whose bodies will be elsewhere in the next tick need not
     * be remembered. The arguments are those of {@link #keep}.
     */
    boolean stays(int row, boolean apart, double gap, double margin) {
        if (Double.isNaN(gap)) {
            return false;
        }
        double allowed = allowed(c.colliderA[row], c.colliderB[row], apart, gap, margin);
        int a = c.bodyA[row];
        int b = c.bodyB[row];
        double vx = bodies.velocityX[b] - bodies.velocityX[a];
        double vy = bodies.velocityY[b] - bodies.velocityY[a];
        double vz = bodies.velocityZ[b] - bodies.velocityZ[a];
        return stepSquared * (vx * vx + vy * vy + vz * vz) < allowed * allowed;
    }

    private double allowed(int a, int b, boolean apart, double gap, double margin) {
        return apart
                ? gap - margin
                : SHARE * Math.min(colliders.innerRadius[a], colliders.innerRadius[b]);
    }

    /** How far the plane of a face is from the centre of its shape, m. */
    private static double offset(Shape shape, int face) {
        if (shape instanceof ConvexHull hull) {
            return Polyhedron.of(hull).offset(face);
        }
        Box box = (Box) shape;
        int axis = face >> 1;
        return axis == 0 ? box.halfX() : axis == 1 ? box.halfY() : box.halfZ();
    }

    /** Keeps the points on the surface of the incident shape, in its axes. */
    static void keepPoints(double[] k, int at, Poses s, int r, int i, Manifold m, boolean flip) {
        double ix = s.orientationX[i];
        double iy = s.orientationY[i];
        double iz = s.orientationZ[i];
        double iw = s.orientationW[i];
        double ex = s.apartX(r, i);
        double ey = s.apartY(r, i);
        double ez = s.apartZ(r, i);
        double m00 = 1 - 2 * (iy * iy + iz * iz);
        double m01 = 2 * (ix * iy - iw * iz);
        double m02 = 2 * (ix * iz + iw * iy);
        double m10 = 2 * (ix * iy + iw * iz);
        double m11 = 1 - 2 * (ix * ix + iz * iz);
        double m12 = 2 * (iy * iz - iw * ix);
        double m20 = 2 * (ix * iz - iw * iy);
        double m21 = 2 * (iy * iz + iw * ix);
        double m22 = 1 - 2 * (ix * ix + iy * iy);
        for (int p = 0; p < m.pointCount; p++) {
            // The normal points from A to B: the surface of B is half the separation ahead.
            double half = flip ? -0.5 * m.separation[p] : 0.5 * m.separation[p];
            double x = m.pointX[p] + half * m.normalX;
            double y = m.pointY[p] + half * m.normalY;
            double z = m.pointZ[p] + half * m.normalZ;
            if (!flip) {
                x -= ex;
                y -= ey;
                z -= ez;
            }
            int to = at + 3 * p;
            k[to] = m00 * x + m10 * y + m20 * z;
            k[to + 1] = m01 * x + m11 * y + m21 * z;
            k[to + 2] = m02 * x + m12 * y + m22 * z;
        }
    }
}
