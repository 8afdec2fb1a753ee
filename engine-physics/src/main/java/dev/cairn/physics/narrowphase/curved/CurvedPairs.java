package dev.cairn.physics.narrowphase.curved;

import dev.cairn.physics.narrowphase.clip.ContactPoints;
import dev.cairn.physics.narrowphase.gjk.Epa;
import dev.cairn.physics.narrowphase.gjk.Gjk;
import dev.cairn.physics.narrowphase.pair.ContactTolerances;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.narrowphase.pair.Pair;
import dev.cairn.physics.shape.HalfSpace;
import dev.cairn.physics.shape.Shape;

/**
 * The pairs that are not of boxes, hulls and balls alone: sends half-spaces to {@link PlaneContact}
 * and the rest to {@link CurvedAxis} and {@link CurvedContact}.
 */
public final class CurvedPairs {
    public boolean capped;

    private final Pair pair;
    private final Gjk gjk;
    private final Epa epa;
    private final ContactPoints points;
    private final boolean closedForm;
    private final CurvedAxis axis = new CurvedAxis();
    private final SegmentBox segmentBox = new SegmentBox();
    private final SegmentHull segmentHull = new SegmentHull();
    private final CurvedContact contact;
    private final CapsuleOnBox capsuleOnBox;
    private final PlaneContact plane;

    /** Of the last distance: 1 when the first shape was a half-space, -1 when the second. */
    private int planeLast;

    private double lastX, lastY, lastZ;

    public CurvedPairs(Pair pair, Gjk gjk, Epa epa, ContactPoints points, boolean closedForm) {
        this.pair = pair;
        this.gjk = gjk;
        this.epa = epa;
        this.points = points;
        this.closedForm = closedForm;
        this.contact = new CurvedContact(pair, points, axis);
        this.capsuleOnBox = new CapsuleOnBox(pair, points, segmentBox);
        this.plane = new PlaneContact(pair, points);
    }

    private boolean byHull(Shape a, Shape b, double limit) {
        return closedForm && SegmentHull.fits(a, b) && segmentHull.find(pair, a, b, limit, axis);
    }

    /** See {@code NarrowPhase.collide}; one of the shapes at least is none of the plain ones. */
    public long collide(
            Shape a,
            Shape b,
            double qAx,
            double qAy,
            double qAz,
            double qAw,
            double qBx,
            double qBy,
            double qBz,
            double qBw,
            double dx,
            double dy,
            double dz,
            double margin,
            long cache,
            Manifold out) {
        capped = false;
        out.pointCount = 0;
        out.patch = 0;
        out.bound = 0;
        out.capped = false;
        if (a instanceof HalfSpace && b instanceof HalfSpace) {
            return 0;
        }
        if (b instanceof HalfSpace) {
            pair.set(a, a, qAx, qAy, qAz, qAw, qAx, qAy, qAz, qAw, 0, 0, 0);
            double s = plane.distance(qBx, qBy, qBz, qBw, -dx, -dy, -dz);
            return plane.run(
                    s, false, margin, ContactTolerances.HYSTERESIS * pair.inner, cache, out);
        }
        if (a instanceof HalfSpace) {
            pair.set(b, b, qBx, qBy, qBz, qBw, qBx, qBy, qBz, qBw, 0, 0, 0);
            double s = plane.distance(qAx, qAy, qAz, qAw, dx, dy, dz);
            long key =
                    plane.run(
                            s, true, margin, ContactTolerances.HYSTERESIS * pair.inner, cache, out);
            swap(dx, dy, dz, out);
            return key;
        }
        pair.set(a, b, qAx, qAy, qAz, qAw, qBx, qBy, qBz, qBw, dx, dy, dz);
        double limit = margin + pair.radiusA + pair.radiusB;
        boolean closed = closedForm && SegmentBox.fits(a, b);
        if (closed) {
            segmentBox.find(pair, a, b, limit, axis);
        } else if (!byHull(a, b, limit)) {
            axis.find(pair, closedForm, gjk, epa, limit);
        }
        capped = axis.capped;
        if (axis.beyond) {
            return 0;
        }
        long key =
                closed && !capsuleOnBox.sideBySide()
                        ? capsuleOnBox.run(
                                margin, ContactTolerances.HYSTERESIS * pair.inner, cache, out)
                        : contact.run(
                                margin, ContactTolerances.HYSTERESIS * pair.inner, cache, out);
        out.capped = capped;
        return key;
    }

    /** See {@code NarrowPhase.distance}. */
    public double distance(
            Shape a,
            Shape b,
            double qAx,
            double qAy,
            double qAz,
            double qAw,
            double qBx,
            double qBy,
            double qBz,
            double qBw,
            double dx,
            double dy,
            double dz) {
        capped = false;
        if (a instanceof HalfSpace && b instanceof HalfSpace) {
            points.setAxis(0, 1, 0);
            return Double.NEGATIVE_INFINITY;
        }
        if (b instanceof HalfSpace) {
            pair.set(a, a, qAx, qAy, qAz, qAw, qAx, qAy, qAz, qAw, 0, 0, 0);
            double s = plane.distance(qBx, qBy, qBz, qBw, -dx, -dy, -dz);
            planeLast = -1;
            axisFromWorld(-plane.normalX, -plane.normalY, -plane.normalZ);
            return s;
        }
        if (a instanceof HalfSpace) {
            pair.set(b, b, qBx, qBy, qBz, qBw, qBx, qBy, qBz, qBw, 0, 0, 0);
            double s = plane.distance(qAx, qAy, qAz, qAw, dx, dy, dz);
            planeLast = 1;
            lastX = dx;
            lastY = dy;
            lastZ = dz;
            axisFromWorld(plane.normalX, plane.normalY, plane.normalZ);
            return s;
        }
        planeLast = 0;
        pair.set(a, b, qAx, qAy, qAz, qAw, qBx, qBy, qBz, qBw, dx, dy, dz);
        if (closedForm && SegmentBox.fits(a, b)) {
            segmentBox.find(pair, a, b, Double.MAX_VALUE, axis);
        } else if (!byHull(a, b, Double.MAX_VALUE)) {
            axis.find(pair, closedForm, gjk, epa, Double.MAX_VALUE);
        }
        capped = axis.capped;
        points.setAxis(axis.axisX, axis.axisY, axis.axisZ);
        return axis.separation - pair.radiusA - pair.radiusB;
    }

    /** One point for the pair of the last {@link #distance}; false when none is a half-space. */
    public boolean witnessOfPlane(double d, Manifold out) {
        if (planeLast == 0) {
            return false;
        }
        plane.witness(d, out);
        if (planeLast > 0) {
            swap(lastX, lastY, lastZ, out);
        }
        return true;
    }

    private void axisFromWorld(double x, double y, double z) {
        points.setAxis(
                pair.w00 * x + pair.w10 * y + pair.w20 * z,
                pair.w01 * x + pair.w11 * y + pair.w21 * z,
                pair.w02 * x + pair.w12 * y + pair.w22 * z);
    }

    /** From the solid first to the half-space first. */
    private static void swap(double dx, double dy, double dz, Manifold out) {
        out.normalX = -out.normalX;
        out.normalY = -out.normalY;
        out.normalZ = -out.normalZ;
        for (int i = 0; i < out.pointCount; i++) {
            out.pointX[i] += dx;
            out.pointY[i] += dy;
            out.pointZ[i] += dz;
        }
    }
}
