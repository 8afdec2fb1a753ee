package dev.cairn.physics.contact;

import dev.cairn.physics.contact.impact.SurfacePlane;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.sweep.Flight;

/**
 * Puts the contact of a meeting into its row, told of the start of the tick: points are where they
 * are on the bodies, and as far apart as they approach until they meet. One worker's.
 */
final class MeetingContact {
    private final ContactStore contacts;
    private final PointStore points;
    private final SurfacePlane plane;
    private final PointStore.Scratch scratch = new PointStore.Scratch();
    private final double[] v = new double[3], u = new double[3];

    /**
     * A writer.
     *
     * @param plane stands in for a surface of triangles, if there is one
     */
    MeetingContact(ContactStore contacts, PointStore points, SurfacePlane plane) {
        this.contacts = contacts;
        this.points = points;
        this.plane = plane;
    }

    /**
     * Tells the row, unless there are no points, or some are beyond the triangles of a plane.
     *
     * @param m of the meeting; points from the first shape's centre, which a plane has on it
     * @param a the first shape, at the time of the meeting
     * @param dx from the first shape's centre to the second one's then, world, m
     * @param thin inner radius of the thinner one, m
     */
    void tell(
            int row, Manifold m, Flight a, Flight b, double dx, double dy, double dz, double thin) {
        if (m.pointCount == 0
                || (plane.isFirst() && !isOver(m, a, 0, 0, 0, -0.5, thin))
                || (plane.isSecond() && !isOver(m, b, dx, dy, dz, 0.5, thin))) {
            return;
        }
        ContactStore c = contacts;
        c.cache[row] = 0;
        c.keeps[row] = false;
        move(m, 1);
        points.store(row, m, scratch);
        move(m, -1);
        double nx = c.normalX(row);
        double ny = c.normalY(row);
        double nz = c.normalZ(row);
        for (int k = 0; k < m.pointCount; k++) {
            int q = ContactStore.POINTS * row + k;
            double x = m.pointX[k];
            double y = m.pointY[k];
            double z = m.pointZ[k];
            a.back(x, y, z, v);
            double moved = nx * a.movedX + ny * a.movedY + nz * a.movedZ;
            b.back(x - dx, y - dy, z - dz, u);
            moved = nx * b.movedX + ny * b.movedY + nz * b.movedZ - moved;
            c.setAnchors(q, v[0], v[1], v[2], u[0], u[1], u[2]);
            c.separation[q] = m.separation[k] - moved;
            // what pressed before is not what will press when they meet
            c.normalImpulse[q] = 0;
            c.preload[q] = 0;
        }
        c.forgetFriction(row);
    }

    /** Tells points from the surface's origin, where that is the first, or from its plane again. */
    private void move(Manifold m, double sign) {
        for (int k = 0; plane.isFirst() && k < m.pointCount; k++) {
            m.pointX[k] += sign * plane.fromOriginX();
            m.pointY[k] += sign * plane.fromOriginY();
            m.pointZ[k] += sign * plane.fromOriginZ();
        }
    }

    /**
     * Whether there are triangles under all points.
     *
     * @param f the plane
     * @param dx from the first shape's centre to the plane's, m
     * @param half of a separation, along the normal, from midway to the plane
     */
    private boolean isOver(
            Manifold m, Flight f, double dx, double dy, double dz, double half, double thin) {
        for (int k = 0; k < m.pointCount; k++) {
            double way = half * m.separation[k];
            f.back(
                    m.pointX[k] + way * m.normalX - dx,
                    m.pointY[k] + way * m.normalY - dy,
                    m.pointZ[k] + way * m.normalZ - dz,
                    v);
            if (!plane.isOver(v, thin)) {
                return false;
            }
        }
        return true;
    }
}
