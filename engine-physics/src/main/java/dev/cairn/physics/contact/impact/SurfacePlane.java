package dev.cairn.physics.contact.impact;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ColliderStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.MovedTurn;
import dev.cairn.physics.internal.Poses;
import dev.cairn.physics.internal.Rotations;
import dev.cairn.physics.internal.Surface;
import dev.cairn.physics.narrowphase.pair.Reach;
import dev.cairn.physics.shape.Moved;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.mesh.Meshed;
import dev.cairn.physics.shape.mesh.TriangleSet;
import dev.cairn.physics.sweep.Flight;
import dev.cairn.physics.sweep.TimeOfImpact;

/**
 * The plane of a row of a surface of triangles, fixed or kinematic: it stands in for the surface
 * where a motion is swept, and goes along with it.
 *
 * <p>What the row holds apart lies behind the plane, so a shape that does not meet the plane does
 * not meet that part of the surface either. What does meet the plane meets the surface where its
 * triangles are, see {@link #isOver}.
 *
 * <p>One worker's. Allocates only when more triangles are found than ever.
 */
public final class SurfacePlane {
    /** Sides of a row: none is of triangles, the first is, the second is. */
    private static final int NONE = 0, FIRST = 1, SECOND = 2;

    /** Cosine of the angle between normals of one plane, 1e-6 rad. */
    private static final double ONE_PLANE = 1 - 5e-13;

    /** Of the smaller inner radius: how far beside its triangle, and above, a point may be. */
    private static final double SLACK = 0x1p-20;

    private final ColliderStore colliders;
    private final ContactStore contacts;
    private final TriangleSet.Found found = new TriangleSet.Found();
    private final double[] box = new double[6], corner = new double[9], out = new double[3];
    private final double[] point = new double[3];
    private final TrianglePass pass = new TrianglePass();
    private int side;
    private int collider;

    /** A point of the plane, from the centre of the surface's body, world, m. */
    public double x, y, z;

    /** Outward normal, world. */
    private double nx, ny, nz;

    /** From the body's centre to the surface's origin. */
    private double leverX, leverY, leverZ;

    /** World from a half-space, whose plane it is. */
    public double qx, qy, qz, qw;

    /** World from the triangles. */
    private double ax, ay, az, aw;

    /** Of the rows of a world. */
    public SurfacePlane(ColliderStore colliders, ContactStore contacts) {
        this.colliders = colliders;
        this.contacts = contacts;
    }

    /** Whether a row can be swept: of two solids, or of a solid and a surface. */
    public static boolean fits(ColliderStore colliders, int a, int b) {
        if (Reach.fits(colliders.shape[a])) {
            return Reach.fits(colliders.shape[b]) || isSurface(colliders, b);
        }
        return Reach.fits(colliders.shape[b]) && isSurface(colliders, a);
    }

    private static boolean isSurface(ColliderStore colliders, int slot) {
        return Surface.isMeshed(colliders.shape[slot])
                && colliders.bodies.kind[colliders.body[slot]] != BodyStore.DYNAMIC;
    }

    /** From the surface's origin to the point of the plane. */
    public double fromOriginX() {
        return x - leverX;
    }

    /** See {@link #fromOriginX}. */
    public double fromOriginY() {
        return y - leverY;
    }

    /** See {@link #fromOriginX}. */
    public double fromOriginZ() {
        return z - leverZ;
    }

    /** Whether the first collider of the row is the surface. */
    public boolean isFirst() {
        return side == FIRST;
    }

    /** Whether the second one is. */
    public boolean isSecond() {
        return side == SECOND;
    }

    /** There is none. */
    public void clear() {
        side = NONE;
    }

    /** Finds that of a row, if a side of it is of triangles. */
    public void find(int row) {
        ContactStore c = contacts;
        int a = c.colliderA[row];
        int b = c.colliderB[row];
        side = isSurface(colliders, a) ? FIRST : isSurface(colliders, b) ? SECOND : NONE;
        if (side == NONE) {
            return;
        }
        collider = side == FIRST ? a : b;
        double sign = side == FIRST ? 1 : -1;
        nx = sign * c.normalX(row);
        ny = sign * c.normalY(row);
        nz = sign * c.normalZ(row);
        int p = ContactStore.POINTS * row;
        int at = ContactStore.anchor(p) + (side == FIRST ? 0 : 3);
        // anchors are midway between the surfaces, from the body's centre
        double half = 0.5 * c.separation[p];
        Poses s = colliders.poses;
        boolean isChild = colliders.isChild(collider);
        int body = colliders.body[collider];
        leverX = isChild ? s.apartX(body, collider) : 0;
        leverY = isChild ? s.apartY(body, collider) : 0;
        leverZ = isChild ? s.apartZ(body, collider) : 0;
        x = c.anchors[at] - half * nx;
        y = c.anchors[at + 1] - half * ny;
        z = c.anchors[at + 2] - half * nz;
        turn();
    }

    /**
     * Whether the solid of the row passes the surface, though it meets the plane: the row is of an
     * edge or a corner, or left behind before, and no triangle is met. False says nothing.
     *
     * @param row the one that was found
     * @param solid on its way
     * @param outer its radius, m
     * @param met nearer than that counts as met, m
     */
    public boolean isPassed(
            int row, Flight solid, double outer, double step, double met, TimeOfImpact search) {
        int body = colliders.body[collider];
        if (colliders.bodies.isMoved(body)
                || !(Surface.unmoved(colliders.shape[collider]) instanceof Meshed mesh)
                || (isFace(row, outer, 0, 0, 0) && staysOver(row, solid, outer, step))) {
            return false;
        }
        Poses s = colliders.poses;
        int other = side == FIRST ? contacts.colliderB[row] : contacts.colliderA[row];
        turnSurface();
        return pass.turned(ax, ay, az, aw)
                .passes(
                        TriangleSet.of(mesh),
                        solid,
                        s.apartX(collider, other),
                        s.apartY(collider, other),
                        s.apartZ(collider, other),
                        outer,
                        step,
                        met,
                        search);
    }

    /** Whether its points are over triangles of the plane at the tick's end, too. */
    private boolean staysOver(int row, Flight solid, double outer, double step) {
        solid.move(step);
        double down = nx * solid.x + ny * solid.y + nz * solid.z;
        return isFace(row, outer, solid.x - down * nx, solid.y - down * ny, solid.z - down * nz);
    }

    /** Whether the points of a row, moved, lie over triangles of its plane, not at their edges. */
    private boolean isFace(int row, double outer, double dx, double dy, double dz) {
        ContactStore c = contacts;
        for (int k = 0; k < c.pointCount[row]; k++) {
            int p = ContactStore.POINTS * row + k;
            int at = ContactStore.anchor(p) + (side == FIRST ? 0 : 3);
            double half = 0.5 * c.separation[p];
            point[0] = c.anchors[at] - half * nx + dx;
            point[1] = c.anchors[at + 1] - half * ny + dy;
            point[2] = c.anchors[at + 2] - half * nz + dz;
            if (!isOver(point, -SLACK * outer, SLACK * outer)) {
                return false;
            }
        }
        return true;
    }

    /** The shortest turn from the y axis to the normal. */
    private void turn() {
        double w = 1 + ny;
        double length = Math.sqrt(nz * nz + nx * nx + w * w);
        boolean isDown = !(length > 1e-8);
        qx = isDown ? 1 : nz / length;
        qy = 0;
        qz = isDown ? 0 : -nx / length;
        qw = isDown ? 0 : w / length;
    }

    /**
     * Whether a point of the plane is over triangles of it.
     *
     * @param point at the tick's start, from the centre of the surface's body, world, m
     * @param thin inner radius of the solid, m
     */
    public boolean isOver(double[] point, double thin) {
        return isOver(point, SLACK * thin, SLACK * thin);
    }

    /**
     * The same.
     *
     * @param beside how far beside its triangle it may be, m; negative where it must be inside
     * @param above how far above, m
     */
    private boolean isOver(double[] point, double beside, double above) {
        if (!(Surface.unmoved(colliders.shape[collider]) instanceof Meshed mesh)) {
            return false;
        }
        TriangleSet set = TriangleSet.of(mesh);
        turnSurface();
        double px = point[0] - leverX;
        double py = point[1] - leverY;
        double pz = point[2] - leverZ;
        Rotations.rotate(-ax, -ay, -az, aw, px, py, pz, out);
        return isOver(set, out[0], out[1], out[2], beside, above);
    }

    private void turnSurface() {
        Poses p = colliders.poses;
        ax = p.orientationX[collider];
        ay = p.orientationY[collider];
        az = p.orientationZ[collider];
        aw = p.orientationW[collider];
        Shape shape = colliders.shape[collider];
        if (shape instanceof Moved m) {
            double rx = MovedTurn.x(m, ax, ay, az, aw);
            double ry = MovedTurn.y(m, ax, ay, az, aw);
            double rz = MovedTurn.z(m, ax, ay, az, aw);
            aw = MovedTurn.w(m, ax, ay, az, aw);
            ax = rx;
            ay = ry;
            az = rz;
        }
    }

    /** Whether a point of the plane, in the axes of the triangles, is on one of the plane. */
    private boolean isOver(
            TriangleSet set, double px, double py, double pz, double beside, double above) {
        for (int axis = 0; axis < 3; axis++) {
            double at = axis == 0 ? px : axis == 1 ? py : pz;
            box[axis] = at - above;
            box[axis + 3] = at + above;
        }
        set.find(box, found);
        Rotations.rotate(-ax, -ay, -az, aw, nx, ny, nz, out);
        double ux = out[0];
        double uy = out[1];
        double uz = out[2];
        for (int i = 0; i < found.count; i++) {
            set.corners(found.triangle[i], corner);
            for (int c = 0; c < 9; c += 3) {
                corner[c] -= px;
                corner[c + 1] -= py;
                corner[c + 2] -= pz;
            }
            if (isOver(ux, uy, uz, beside, above, set.isTwoSided)) {
                return true;
            }
        }
        return false;
    }

    /** Whether the origin is on the triangle whose corners are there, and u its normal. */
    private boolean isOver(
            double ux, double uy, double uz, double beside, double above, boolean twoSided) {
        double gx = corner[3] - corner[0];
        double gy = corner[4] - corner[1];
        double gz = corner[5] - corner[2];
        double hx = corner[6] - corner[0];
        double hy = corner[7] - corner[1];
        double hz = corner[8] - corner[2];
        double cx = gy * hz - gz * hy;
        double cy = gz * hx - gx * hz;
        double cz = gx * hy - gy * hx;
        double along = cx * ux + cy * uy + cz * uz;
        double area = Math.sqrt(cx * cx + cy * cy + cz * cz);
        if (!((twoSided ? Math.abs(along) : along) >= ONE_PLANE * area)) {
            return false;
        }
        if (Math.abs(corner[0] * ux + corner[1] * uy + corner[2] * uz) > above) {
            return false;
        }
        double way = along > 0 ? 1 : -1;
        for (int c = 0; c < 9; c += 3) {
            int d = (c + 3) % 9;
            double ex = corner[d] - corner[c];
            double ey = corner[d + 1] - corner[c + 1];
            double ez = corner[d + 2] - corner[c + 2];
            // (e x -c) . u is the edge's length times how far inside of it the origin is
            double inside =
                    (ez * corner[c + 1] - ey * corner[c + 2]) * ux
                            + (ex * corner[c + 2] - ez * corner[c]) * uy
                            + (ey * corner[c] - ex * corner[c + 1]) * uz;
            if (way * inside < -beside * Math.sqrt(ex * ex + ey * ey + ez * ez)) {
                return false;
            }
        }
        return true;
    }
}
