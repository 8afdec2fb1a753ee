package dev.cairn.physics.narrowphase.curved;

import dev.cairn.physics.narrowphase.axis.AxisAscent;
import dev.cairn.physics.narrowphase.axis.AxisRefinement;
import dev.cairn.physics.narrowphase.gjk.Epa;
import dev.cairn.physics.narrowphase.gjk.Gjk;
import dev.cairn.physics.narrowphase.pair.Axes;
import dev.cairn.physics.narrowphase.pair.Pair;
import dev.cairn.physics.narrowphase.pair.SolidOfRevolution;

/**
 * Axis and signed distance of the cores of a pair of which one at least is a capsule, cylinder or
 * cone: closed forms for points and segments, and for a point against a cylinder or cone; else
 * {@link Gjk} and {@link Epa} for a rough axis and {@link AxisRefinement} for the exact one.
 *
 * <p>The iterations stop early, for they converge slowly on round surfaces. Their upper bound of
 * the signed distance less the separation along the axis found is {@link #gap}: what the answer may
 * be wrong by.
 */
final class CurvedAxis {
    /** Of the squared distance. */
    private static final double NEAR = 0x1p-40;

    /** Of the smaller shape: two overlaps this close may be taken one for the other. */
    private static final double DEEP = 0x1p-24;

    /** Of the depth: as above, for shallow overlaps. */
    private static final double SHARE = 0x1p-16;

    /** Of the smaller shape: overlaps that are not much more than that. */
    private static final double SHALLOW = 0x1p-18;

    /** Cosine of 0.02 rad: a disc's axis this near to the best one may bend the separation. */
    private static final double NEARLY = 0.9998;

    /** Axes that are tried when the polytope met its cap. */
    private static final int STARTS = 12;

    /** Unit axis from A to B in A's frame, and the signed distance of the cores along it. */
    double axisX, axisY, axisZ, separation;

    /** The cores are farther apart than the limit; {@link #separation} is then a lower bound. */
    boolean beyond;

    /** By how much the signed distance may be larger, m. */
    double gap;

    boolean capped;

    /** What the axis belongs to, see {@link AxisRefinement}. */
    int kindA, kindB;

    private final AxisRefinement refinement = new AxisRefinement();
    private final AxisAscent ascent = new AxisAscent(refinement);

    /** Cosine of the angle, 0.3 rad, between axes that count as different ones. */
    private static final double APART = 0.955;

    private final double[] tried = new double[3 * STARTS];
    private double px, pz, across;

    void find(Pair p, boolean closedForm, Gjk gjk, Epa epa, double limit) {
        beyond = false;
        capped = false;
        gap = 0;
        kindA = AxisRefinement.POINT;
        kindB = AxisRefinement.POINT;
        boolean thin = p.roundA && p.roundB && p.solidA.isThin() && p.solidB.isThin();
        if (closedForm && thin) {
            segments(p);
            return;
        }
        boolean pointA = p.roundA && p.solidA.isPoint() && p.roundB;
        boolean pointB = p.roundB && p.solidB.isPoint() && p.roundA;
        if (closedForm && (pointA || pointB)) {
            pointAgainst(p, pointB);
            return;
        }
        iterate(p, thin, pointA, pointB, gjk, epa, limit);
    }

    private void iterate(
            Pair p, boolean thin, boolean pointA, boolean pointB, Gjk gjk, Epa epa, double limit) {
        double finest = gjk.tolerance;
        gjk.tolerance = Math.max(NEAR, finest);
        gjk.run(p, p.dx, p.dy, p.dz, limit);
        gjk.tolerance = finest;
        if (gjk.beyond) {
            beyond = true;
            separation = gjk.lower;
            double s = 1 / gjk.distance;
            set(gjk.vx * s, gjk.vy * s, gjk.vz * s);
            return;
        }
        if (gjk.overlap && thin) {
            separation = 0;
            acrossBoth(p);
        } else if (gjk.overlap && (pointA || pointB)) {
            // Inside, all points of the side may be equally near, too many for a polytope.
            pointAgainst(p, pointB);
        } else if (gjk.overlap) {
            overlapping(p, gjk, epa);
        } else {
            double s = 1 / gjk.distance;
            refinement.run(p, gjk.vx * s, gjk.vy * s, gjk.vz * s);
            take();
            settle(p);
            gap = Math.max(0, gjk.distance - separation);
            capped = gjk.capped && gap > 4 * DEEP * p.scale;
        }
    }

    private void overlapping(Pair p, Gjk gjk, Epa epa) {
        if (p.roundA && p.roundB && onOneLine(p)) {
            return;
        }
        double finest = epa.relativeTolerance;
        double tolerance = DEEP * p.small;
        epa.relativeTolerance = Math.max(tolerance / p.scale, finest);
        epa.share = finest <= DEEP ? SHARE : Double.MAX_VALUE;
        epa.run(p, gjk);
        epa.share = Double.MAX_VALUE;
        epa.relativeTolerance = finest;
        refinement.run(p, epa.axisX, epa.axisY, epa.axisZ);
        take();
        settle(p);
        if (gjk.distance > 0 && separation > -SHALLOW * p.small) {
            // Nearly touching, any axis is hardly deep; the way to the nearest points tells more.
            double s = 1 / gjk.distance;
            double before = separation;
            better(p, gjk.vx * s, gjk.vy * s, gjk.vz * s, false);
            if (separation > before) {
                settle(p);
            }
        }
        if (epa.capped) {
            tried[0] = epa.axisX;
            tried[1] = epa.axisY;
            tried[2] = epa.axisZ;
            for (int i = 1; i < STARTS && epa.another(tried, i, APART); i++) {
                better(p, tried[3 * i], tried[3 * i + 1], tried[3 * i + 2], true);
            }
        }
        gap = Math.max(0, -epa.lower - separation);
        capped = epa.capped && gap > 4 * DEEP * p.scale;
    }

    /**
     * Where what touches along the axis just refined does not meet, a better axis is near: at
     * another corner of a polyhedron, or between two flats, or, of shapes that are apart, towards
     * the points that are nearest. Without discs the rough axis tells which corners touch.
     */
    private void settle(Pair p) {
        boolean discs = (p.roundA && !p.solidA.isThin()) || (p.roundB && !p.solidB.isThin());
        if (!discs) {
            return;
        }
        boolean settled = ascent.climb(p);
        take();
        if (!settled) {
            betweenFlats(p);
        }
    }

    /**
     * Where a disc is nearly parallel to what it lies on, the best axis may lie between the disc's
     * and the normal of the other's flat, and the rough axis on the far side of that normal, where
     * the other touches with another corner. So what is in between is refined as well.
     */
    private void betweenFlats(Pair p) {
        if (p.roundA && !p.solidA.isThin()) {
            betterTowards(p, 0, 1, 0);
        }
        if (p.roundB && !p.solidB.isThin()) {
            betterTowards(p, p.r01, p.r11, p.r21);
        }
    }

    private void betterTowards(Pair p, double x, double y, double z) {
        double dot = axisX * x + axisY * y + axisZ * z;
        if (Math.abs(dot) < NEARLY) {
            return;
        }
        double sign = dot < 0 ? -0.5 : 0.5;
        double mx = 0.5 * axisX + sign * x;
        double my = 0.5 * axisY + sign * y;
        double mz = 0.5 * axisZ + sign * z;
        double length = Math.sqrt(mx * mx + my * my + mz * mz);
        better(p, mx / length, my / length, mz / length, true);
    }

    /** Takes over what {@link SegmentBox} found. */
    void take(double x, double y, double z, double along, int ofA, int ofB, boolean isBeyond) {
        set(x, y, z);
        separation = along;
        kindA = ofA;
        kindB = ofB;
        beyond = isBeyond;
        gap = 0;
        capped = false;
    }

    private void take() {
        set(refinement.axisX, refinement.axisY, refinement.axisZ);
        separation = refinement.separation;
        kindA = refinement.kindA;
        kindB = refinement.kindB;
    }

    private void better(Pair p, double x, double y, double z, boolean wide) {
        refinement.run(p, x, y, z, wide);
        if (refinement.separation > separation) {
            take();
        }
    }

    /**
     * Two round shapes about one line: a whole circle of directions is equally good, too many for a
     * polytope. Were the line exactly one, the cross-section of the Minkowski difference would be a
     * polygon, whose sides are at right angles to the line or are those of the two shapes. The
     * separation along any axis differs from that by no more than B is aside and its ends are
     * turned away, so the best of these is the best up to twice as much.
     */
    private boolean onOneLine(Pair p) {
        double aside = Math.sqrt(p.dx * p.dx + p.dz * p.dz);
        double sine = Math.sqrt(p.r01 * p.r01 + p.r21 * p.r21);
        double slack = 4 * (aside + sine * p.reach());
        if (!(slack <= DEEP * p.small)) {
            return false;
        }
        double most = Math.max(Math.abs(p.dx), Math.abs(p.dz));
        double ux = most > 0 ? p.dx / most : 1;
        double uz = most > 0 ? p.dz / most : 0;
        double length = Math.sqrt(ux * ux + uz * uz);
        ux /= length;
        uz /= length;
        separation = Axes.NEVER;
        better(p, 0, p.dy < 0 ? -1 : 1, 0, false);
        better(p, 0, p.dy < 0 ? 1 : -1, 0, false);
        SolidOfRevolution a = p.solidA;
        better(p, a.sideAcross * ux, a.sideAlong, a.sideAcross * uz, false);
        SolidOfRevolution b = p.solidB;
        double along = p.r11 < 0 ? b.sideAlong : -b.sideAlong;
        better(p, b.sideAcross * ux, along, b.sideAcross * uz, false);
        gap = slack;
        return true;
    }

    private void set(double x, double y, double z) {
        axisX = x;
        axisY = y;
        axisZ = z;
    }

    /** At right angles to both segments, which touch; to one, or any, when there is no other. */
    private void acrossBoth(Pair p) {
        boolean lineA = !p.solidA.isPoint();
        boolean lineB = !p.solidB.isPoint();
        double ux = lineB ? p.r01 : 0;
        double uy = lineB ? p.r11 : 1;
        double uz = lineB ? p.r21 : 0;
        // The y axis of A, crossed with the axis of B.
        double x = uz;
        double z = -ux;
        double square = x * x + z * z;
        if (lineA && lineB && square > 0x1p-60) {
            double length = Math.sqrt(square);
            set(x / length, 0, z / length);
            return;
        }
        // The coordinate axis that is least along the segment, made to be at right angles to it.
        boolean small = Math.abs(ux) <= Math.abs(uz);
        double e = small ? ux : uz;
        double ax = (small ? 1 : 0) - e * ux;
        double ay = -e * uy;
        double az = (small ? 0 : 1) - e * uz;
        double length = Math.sqrt(ax * ax + ay * ay + az * az);
        set(ax / length, ay / length, az / length);
    }

    // Closed forms ------------------------------------------------------------------------------

    private double best, bestX, bestY, bestZ;

    /**
     * Two segments (or points): their nearest points are an end of one and a point of the other, or
     * inside both. All of these are tried, so that nearly parallel ones keep their digits.
     */
    private void segments(Pair p) {
        double h = p.solidA.high;
        double k = p.solidB.high;
        double vx = p.r01 * k;
        double vy = p.r11 * k;
        double vz = p.r21 * k;
        best = Double.MAX_VALUE;
        for (int sign = -1; sign <= 1; sign += 2) {
            double bx = p.dx + sign * vx;
            double by = p.dy + sign * vy;
            double bz = p.dz + sign * vz;
            candidate(
                    bx,
                    by - Math.max(-h, Math.min(h, by)),
                    bz,
                    inside(by, h),
                    AxisRefinement.POINT);
            double wx = p.dx;
            double wy = p.dy - sign * h;
            double wz = p.dz;
            double along = wx * p.r01 + wy * p.r11 + wz * p.r21;
            double t = Math.max(-k, Math.min(k, -along));
            double x = wx + t * p.r01;
            double y = wy + t * p.r11;
            double z = wz + t * p.r21;
            int kind = inside(along, k);
            if (kind == AxisRefinement.LINE) {
                // What rounding left along the segment would count by its length near touching.
                double rest = x * p.r01 + y * p.r11 + z * p.r21;
                x -= rest * p.r01;
                y -= rest * p.r11;
                z -= rest * p.r21;
            }
            candidate(x, y, z, AxisRefinement.POINT, kind);
        }
        // Inside both: the difference is along the common perpendicular, u x v with u = y.
        double cx = p.r21;
        double cz = -p.r01;
        double square = cx * cx + cz * cz;
        if (h > 0 && k > 0 && square > 0x1p-60) {
            double t = -(p.dx * p.r01 + p.dz * p.r21) / square;
            double s = p.dy + t * p.r11;
            if (Math.abs(t) <= k && Math.abs(s) <= h) {
                double f = (p.dx * cx + p.dz * cz) / square;
                candidate(f * cx, 0, f * cz, AxisRefinement.LINE, AxisRefinement.LINE);
            }
        }
        double most = Math.max(Math.abs(bestX), Math.max(Math.abs(bestY), Math.abs(bestZ)));
        if (most <= 0x1p-60 * p.scale) {
            separation = 0;
            acrossBoth(p);
            return;
        }
        double x = bestX / most;
        double y = bestY / most;
        double z = bestZ / most;
        double length = Math.sqrt(x * x + y * y + z * z);
        separation = length * most;
        set(x / length, y / length, z / length);
    }

    private static int inside(double along, double half) {
        return Math.abs(along) < half ? AxisRefinement.LINE : AxisRefinement.POINT;
    }

    private void candidate(double x, double y, double z, int ofA, int ofB) {
        double square = x * x + y * y + z * z;
        if (square < best) {
            kindA = ofA;
            kindB = ofB;
            best = square;
            bestX = x;
            bestY = y;
            bestZ = z;
        }
    }

    /** A ball's centre against two discs and all between: a point and a trapezium in a plane. */
    private void pointAgainst(Pair p, boolean ofB) {
        SolidOfRevolution s = ofB ? p.solidA : p.solidB;
        double y = ofB ? p.dy : -(p.r01 * p.dx + p.r11 * p.dy + p.r21 * p.dz);
        px = ofB ? p.dx : -(p.r00 * p.dx + p.r10 * p.dy + p.r20 * p.dz);
        pz = ofB ? p.dz : -(p.r02 * p.dx + p.r12 * p.dy + p.r22 * p.dz);
        double most = Math.max(Math.abs(px), Math.abs(pz));
        double ux = most > 0 ? px / most : 1;
        double uz = most > 0 ? pz / most : 0;
        double length = Math.sqrt(ux * ux + uz * uz);
        across = length * (most > 0 ? most : 0);
        ux /= length;
        uz /= length;
        // Heights over the upper flat, the lower flat and the side; the latter's ends.
        double top = y - s.high;
        double bottom = s.low - y;
        double side = (across - s.lowRadius) * s.sideAcross + (y - s.low) * s.sideAlong;
        double along = (y - s.low) * s.sideAcross - (across - s.lowRadius) * s.sideAlong;
        double rise = s.high - s.low;
        double taper = s.lowRadius - s.highRadius;
        double slant = Math.sqrt(rise * rise + taper * taper);
        double outX;
        double outY;
        if (top <= 0 && bottom <= 0 && side <= 0) {
            boolean flatTop = s.highRadius > 0 && top >= bottom;
            double cap = flatTop ? top : bottom;
            boolean bySide = side >= cap;
            separation = Math.max(cap, side);
            outX = bySide ? s.sideAcross : 0;
            outY = bySide ? s.sideAlong : flatTop ? 1 : -1;
        } else if (side > 0 && along >= 0 && along <= slant) {
            separation = side;
            outX = s.sideAcross;
            outY = s.sideAlong;
        } else {
            // The nearer end of the side; beyond the larger flat only that one's.
            boolean nearsHigh = along > 0.5 * slant;
            boolean upper = taper < 0 ? top > 0 || nearsHigh : bottom <= 0 && nearsHigh;
            double radius = upper ? s.highRadius : s.lowRadius;
            double ex = Math.max(0, across - radius);
            double ey = y - (upper ? s.high : s.low);
            double big = Math.max(ex, Math.abs(ey));
            double a = ex / big;
            double b = ey / big;
            double l = Math.sqrt(a * a + b * b);
            separation = l * big;
            outX = a / l;
            outY = b / l;
        }
        double nx = outX * ux;
        double nz = outX * uz;
        if (ofB) {
            set(nx, outY, nz);
        } else {
            set(
                    -(p.r00 * nx + p.r01 * outY + p.r02 * nz),
                    -(p.r10 * nx + p.r11 * outY + p.r12 * nz),
                    -(p.r20 * nx + p.r21 * outY + p.r22 * nz));
        }
    }
}
