package dev.cairn.physics.narrowphase.curved;

import dev.cairn.physics.narrowphase.axis.AxisRefinement;
import dev.cairn.physics.narrowphase.pair.Axes;
import dev.cairn.physics.narrowphase.pair.Pair;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Shape;

/**
 * The exact axis of a capsule's segment and a box, without iteration.
 *
 * <p>In the box's frame the segment is c + t h u, |t| <= 1, and b are the half extents. The signed
 * distance is the largest separation over all unit axes n,
 *
 * <pre>
 *   s(n) = n . c - h |n . u| - b . |n|.
 * </pre>
 *
 * <p>The box swept along the segment is a zonotope of four generators, whose faces are at right
 * angles to two of them each: three normals of the box's faces and three common perpendiculars of u
 * and an edge. When the cores overlap one of these six is the least way out. When they are apart it
 * may also be the way to an edge or a vertex of the zonotope: from the point of the segment that is
 * nearest to the box. The square of a point's distance is a sum of squares of what each coordinate
 * is beyond, so along the segment its slope is rising and made of straight pieces; the piece that
 * holds the zero is found among the six places where a coordinate comes to lie beyond.
 *
 * <p>Each axis is judged by its true separation, a lower bound of the signed distance.
 */
final class SegmentBox {
    /** Of the squared sine: segments nearer to being parallel to an edge have no perpendicular. */
    private static final double PARALLEL = 0x1p-100;

    /** Of the scale: axes this close are equal, and then the flatter features tell more. */
    private static final double TIE = 0x1p-52;

    /**
     * Of the scale: cores that are farther apart have nearest features that rounding does not hide.
     */
    private static final double CLEAR = 0x1p-40;

    /** Half extents; middle, direction and half length of the segment, in the box's frame. */
    double bx, by, bz, cx, cy, cz, ux, uy, uz, h;

    /** The best axis, from the box to the segment, its separation, and what it belongs to. */
    double x, y, z, best;

    int ofBox, ofSegment;

    /** Where on the segment its nearest or deepest point is, m from the middle. */
    double at;

    /** The box is the second shape. */
    boolean second;

    /** Whether a pair is one of a capsule and a box, in either order. */
    static boolean fits(Shape a, Shape b) {
        return a instanceof Box ? b instanceof Capsule : a instanceof Capsule && b instanceof Box;
    }

    /** Finds the axis of a pair that {@link #fits}. */
    void find(Pair p, Shape a, Shape b, double limit, CurvedAxis out) {
        second = b instanceof Box;
        h = ((Capsule) (second ? a : b)).halfLength();
        Box box = (Box) (second ? b : a);
        bx = box.halfX();
        by = box.halfY();
        bz = box.halfZ();
        if (second) {
            cx = -(p.r00 * p.dx + p.r10 * p.dy + p.r20 * p.dz);
            cy = -(p.r01 * p.dx + p.r11 * p.dy + p.r21 * p.dz);
            cz = -(p.r02 * p.dx + p.r12 * p.dy + p.r22 * p.dz);
            ux = p.r10;
            uy = p.r11;
            uz = p.r12;
            solve(p.scale, limit);
            out.take(
                    -(p.r00 * x + p.r01 * y + p.r02 * z),
                    -(p.r10 * x + p.r11 * y + p.r12 * z),
                    -(p.r20 * x + p.r21 * y + p.r22 * z),
                    best,
                    ofSegment,
                    ofBox,
                    best > limit);
        } else {
            cx = p.dx;
            cy = p.dy;
            cz = p.dz;
            ux = p.r01;
            uy = p.r11;
            uz = p.r21;
            solve(p.scale, limit);
            out.take(x, y, z, best, ofBox, ofSegment, best > limit);
        }
    }

    private void solve(double scale, double limit) {
        faces();
        if (best > limit) {
            return;
        }
        double tie = TIE * scale;
        if (best > CLEAR * scale) {
            nearest(Axes.NEVER);
            return;
        }
        crosses(best + tie);
        if (best > CLEAR * scale) {
            // Far apart all axes are equal up to rounding, so the features decide.
            nearest(best - 16 * tie);
        } else if (best > 0) {
            nearest(best + tie);
        }
    }

    private void faces() {
        double sx = Math.abs(cx) - h * Math.abs(ux) - bx;
        double sy = Math.abs(cy) - h * Math.abs(uy) - by;
        double sz = Math.abs(cz) - h * Math.abs(uz) - bz;
        boolean alongX = sx >= sy && sx >= sz;
        boolean alongY = !alongX && sy >= sz;
        best = alongX ? sx : alongY ? sy : sz;
        x = alongX ? (cx < 0 ? -1 : 1) : 0;
        y = alongY ? (cy < 0 ? -1 : 1) : 0;
        z = (alongX || alongY) ? 0 : (cz < 0 ? -1 : 1);
        ofBox = AxisRefinement.FLAT;
        ofSegment = AxisRefinement.POINT;
        at = x * ux + y * uy + z * uz > 0 ? -h : h;
    }

    /** The common perpendiculars of the segment and the edges; what is not above a bound is not. */
    private void crosses(double above) {
        double xx = ux * ux;
        double yy = uy * uy;
        double zz = uz * uz;
        double sx = cross(yy + zz, cz * uy - cy * uz, by, uz, bz, uy);
        double sy = cross(zz + xx, cx * uz - cz * ux, bz, ux, bx, uz);
        double sz = cross(xx + yy, cy * ux - cx * uy, bx, uy, by, ux);
        double most = Math.max(sx, Math.max(sy, sz));
        if (!(most > above)) {
            return;
        }
        best = most;
        ofBox = AxisRefinement.LINE;
        ofSegment = AxisRefinement.LINE;
        x = 0;
        y = 0;
        z = 0;
        if (sx == most) {
            double f = (cz * uy < cy * uz ? -1 : 1) / Math.sqrt(yy + zz);
            y = -uz * f;
            z = uy * f;
            at = (offset(y, by, cy) * uy + offset(z, bz, cz) * uz) / (yy + zz);
        } else if (sy == most) {
            double f = (cx * uz < cz * ux ? -1 : 1) / Math.sqrt(zz + xx);
            z = -ux * f;
            x = uz * f;
            at = (offset(z, bz, cz) * uz + offset(x, bx, cx) * ux) / (zz + xx);
        } else {
            double f = (cy * ux < cx * uy ? -1 : 1) / Math.sqrt(xx + yy);
            x = -uy * f;
            y = ux * f;
            at = (offset(x, bx, cx) * ux + offset(y, by, cy) * uy) / (xx + yy);
        }
        at = Math.max(-h, Math.min(h, at));
    }

    /** From the middle of the segment to the side of the box that looks along an axis. */
    private static double offset(double n, double b, double c) {
        return (n < 0 ? -b : b) - c;
    }

    /** Separation along an axis that is no unit vector yet; h does not count across u. */
    private static double cross(
            double square, double along, double b, double u, double d, double v) {
        double s = Math.abs(along) - (b * Math.abs(u) + d * Math.abs(v));
        return square > PARALLEL ? s / Math.sqrt(square) : Axes.NEVER;
    }

    private static double beyond(double p, double b) {
        return p - Math.max(-b, Math.min(b, p));
    }

    /** Half the slope of the squared distance along the segment, over h. */
    private double slope(double t) {
        double s = t * h;
        return beyond(cx + s * ux, bx) * ux
                + beyond(cy + s * uy, by) * uy
                + beyond(cz + s * uz, bz) * uz;
    }

    /** No coordinate. */
    private static final int NONE = -1;

    /** The range that holds the nearest point, and which coordinate bends the slope at its ends. */
    private double from, to;

    private int bendFrom, bendTo;

    /** The way from the box to a point of the segment. */
    private double wx, wy, wz;

    /** The way from the box to the nearest point of the segment. */
    private void nearest(double above) {
        double t;
        if (slope(-1) >= 0) {
            t = -1;
        } else if (slope(1) <= 0) {
            t = 1;
        } else {
            from = -1;
            to = 1;
            bendFrom = NONE;
            bendTo = NONE;
            narrow(cx, ux, bx, 0);
            narrow(cy, uy, by, 1);
            narrow(cz, uz, bz, 2);
            inside(above);
            return;
        }
        double s = t * h;
        wx = beyond(cx + s * ux, bx);
        wy = beyond(cy + s * uy, by);
        wz = beyond(cz + s * uz, bz);
        take(s, AxisRefinement.POINT, above);
    }

    /** The places where a coordinate comes to lie within or beyond cut the range. */
    private void narrow(double c, double u, double b, int axis) {
        double across = h * Math.abs(u);
        double middle = u < 0 ? -c : c;
        cut((-b - middle) / across, axis);
        cut((b - middle) / across, axis);
    }

    private void cut(double t, int axis) {
        if (t > from && t < to) {
            if (slope(t) > 0) {
                to = t;
                bendTo = axis;
            } else {
                from = t;
                bendFrom = axis;
            }
        }
    }

    /**
     * The zero of the straight piece between two places: there the way is at right angles to the
     * segment, as far as its parts are beyond the box. When the piece has no zero after all,
     * rounding hid that of the coordinate that bends the slope at its end, which then takes part.
     */
    private void inside(double above) {
        double s = 0.5 * (from + to) * h;
        wx = beyond(cx + s * ux, bx);
        wy = beyond(cy + s * uy, by);
        wz = beyond(cz + s * uz, bz);
        double vx = wx != 0 ? ux : 0;
        double vy = wy != 0 ? uy : 0;
        double vz = wz != 0 ? uz : 0;
        double square = vx * vx + vy * vy + vz * vz;
        double dot = wx * vx + wy * vy + wz * vz;
        double back = square > 0 ? dot / square : 0;
        double room = 0.5 * (to - from) * h;
        int bend = back > room ? bendFrom : back < -room ? bendTo : NONE;
        boolean end = Math.abs(back) > room && bend == NONE;
        move(Math.max(-room, Math.min(room, back)), vx, vy, vz);
        vx = bend == 0 ? ux : vx;
        vy = bend == 1 ? uy : vy;
        vz = bend == 2 ? uz : vz;
        square = vx * vx + vy * vy + vz * vz;
        if (!end && square > 0) {
            // Again, for h times what rounding leaves along the segment is lost.
            move((wx * vx + wy * vy + wz * vz) / square, vx, vy, vz);
        }
        take(s - Math.max(-room, Math.min(room, back)), AxisRefinement.LINE, above);
    }

    private void move(double back, double vx, double vy, double vz) {
        wx -= back * vx;
        wy -= back * vy;
        wz -= back * vz;
    }

    /** Tries a way from the box to the segment as an axis. */
    private void take(double along, int segmentKind, double above) {
        double most = Math.max(Math.abs(wx), Math.max(Math.abs(wy), Math.abs(wz)));
        double nx = wx / most;
        double ny = wy / most;
        double nz = wz / most;
        double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
        nx /= length;
        ny /= length;
        nz /= length;
        double s =
                nx * cx
                        + ny * cy
                        + nz * cz
                        - h * Math.abs(nx * ux + ny * uy + nz * uz)
                        - (bx * Math.abs(nx) + by * Math.abs(ny) + bz * Math.abs(nz));
        if (!(s > above)) {
            return;
        }
        best = s;
        at = along;
        x = nx;
        y = ny;
        z = nz;
        int beside = (wx != 0 ? 1 : 0) + (wy != 0 ? 1 : 0) + (wz != 0 ? 1 : 0);
        ofBox =
                beside == 1
                        ? AxisRefinement.FLAT
                        : beside == 2 ? AxisRefinement.LINE : AxisRefinement.POINT;
        ofSegment = beside == 1 ? AxisRefinement.POINT : segmentKind;
    }
}
