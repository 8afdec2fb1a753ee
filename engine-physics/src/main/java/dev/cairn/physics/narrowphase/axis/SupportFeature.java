package dev.cairn.physics.narrowphase.axis;

import dev.cairn.physics.narrowphase.pair.Pair;
import dev.cairn.physics.narrowphase.pair.SolidOfRevolution;
import dev.cairn.physics.shape.polyhedron.Polyhedron;

/**
 * The support feature of one shape of a pair along an axis: a point, a segment, a face or a disc;
 * and how far a point of the other shape is beside it. In A's frame.
 */
final class SupportFeature {
    private static final double ROUNDING = 0x1p-48;

    /** A touching point, from A's centre, see {@link #supportPoint}. */
    double tx, ty, tz;

    /** A touching segment: its middle, unit direction and half length, see {@link #segment}. */
    double midX, midY, midZ, alongX, alongY, alongZ, reach;

    /** From the flat or line to the other's touching point, see {@link #miss}. */
    double missX, missY, missZ;

    private final CandidateFeatures side;
    private final boolean flip;
    private Pair pair = Pair.NONE;

    SupportFeature(CandidateFeatures side, boolean ofB) {
        this.side = side;
        flip = ofB;
    }

    void of(Pair p) {
        pair = p;
    }

    private SolidOfRevolution solid() {
        return flip ? pair.solidB : pair.solidA;
    }

    /** Finds a point that the shape reaches with along a unit direction, outwards. */
    void supportPoint(double x, double y, double z) {
        if (!(flip ? pair.roundB : pair.roundA)) {
            Polyhedron h = flip ? pair.b : pair.a;
            int v = flip ? pair.endB(x, y, z) : pair.endA(x, y, z);
            if (flip) {
                pair.vertexB(v);
            }
            tx = flip ? pair.px : h.vertexX(v);
            ty = flip ? pair.py : h.vertexY(v);
            tz = flip ? pair.pz : h.vertexZ(v);
            return;
        }
        SolidOfRevolution c = solid();
        double along = x * side.ax + y * side.ay + z * side.az;
        double rho = across(x, y, z);
        boolean top = c.high * along + c.highRadius * rho >= c.low * along + c.lowRadius * rho;
        rimPoint(x, y, z, along, rho, top ? c.high : c.low, top ? c.highRadius : c.lowRadius);
    }

    private double across(double x, double y, double z) {
        double along = x * side.ax + y * side.ay + z * side.az;
        double ux = x - along * side.ax;
        double uy = y - along * side.ay;
        double uz = z - along * side.az;
        return Math.sqrt(ux * ux + uy * uy + uz * uz);
    }

    private void rimPoint(
            double x,
            double y,
            double z,
            double along,
            double rho,
            double height,
            double rimRadius) {
        double f = rho > 0 ? rimRadius / rho : 0;
        tx = height * side.ax + f * (x - along * side.ax) + (flip ? pair.dx : 0);
        ty = height * side.ay + f * (y - along * side.ay) + (flip ? pair.dy : 0);
        tz = height * side.az + f * (z - along * side.az) + (flip ? pair.dz : 0);
    }

    /** Finds the segment that touches along a direction at right angles to a line, outwards. */
    void segment(int line, double x, double y, double z) {
        if (!(flip ? pair.roundB : pair.roundA)) {
            midX = side.px[line];
            midY = side.py[line];
            midZ = side.pz[line];
            alongX = side.lineX[line];
            alongY = side.lineY[line];
            alongZ = side.lineZ[line];
            reach = side.half[line];
            return;
        }
        SolidOfRevolution c = solid();
        double along = x * side.ax + y * side.ay + z * side.az;
        double rho = across(x, y, z);
        rimPoint(x, y, z, along, rho, c.low, c.lowRadius);
        double fromX = tx;
        double fromY = ty;
        double fromZ = tz;
        rimPoint(x, y, z, along, rho, c.high, c.highRadius);
        double ex = tx - fromX;
        double ey = ty - fromY;
        double ez = tz - fromZ;
        double length = Math.sqrt(ex * ex + ey * ey + ez * ez);
        midX = 0.5 * (tx + fromX);
        midY = 0.5 * (ty + fromY);
        midZ = 0.5 * (tz + fromZ);
        alongX = ex / length;
        alongY = ey / length;
        alongZ = ez / length;
        reach = 0.5 * length;
    }

    /** What rounding of a direction moves the point where a rim touches by. */
    double unsteady(double x, double y, double z) {
        if (!(flip ? pair.roundB : pair.roundA)) {
            return 0;
        }
        return ROUNDING * Math.max(solid().lowRadius, solid().highRadius) / across(x, y, z);
    }

    /**
     * How far a place along the segment found, counted from its middle, is beyond its ends or
     * nearer to one than an inset.
     */
    void beyond(double t, double inset) {
        double by = Math.max(0, Math.abs(t) - reach + inset) * Math.signum(t);
        missX = by * alongX;
        missY = by * alongY;
        missZ = by * alongZ;
    }

    /**
     * How far the other shape's touching point is beside a flat, or beyond a line's ends, that are
     * drawn in by an inset.
     */
    void miss(boolean flat, int place, SupportFeature other, double inset) {
        double x = other.tx;
        double y = other.ty;
        double z = other.tz;
        if (!flat) {
            double wx = x - midX;
            double wy = y - midY;
            double wz = z - midZ;
            double t = wx * alongX + wy * alongY + wz * alongZ;
            beyond(t, inset);
            missX += wx - t * alongX;
            missY += wy - t * alongY;
            missZ += wz - t * alongZ;
            return;
        }
        double ox = x - (flip ? pair.dx : 0);
        double oy = y - (flip ? pair.dy : 0);
        double oz = z - (flip ? pair.dz : 0);
        missX = 0;
        missY = 0;
        missZ = 0;
        if (flip ? pair.roundB : pair.roundA) {
            missDisc(place, ox, oy, oz, inset);
            return;
        }
        Pair p = pair;
        double lx = flip ? p.r00 * ox + p.r10 * oy + p.r20 * oz : ox;
        double ly = flip ? p.r01 * ox + p.r11 * oy + p.r21 * oz : oy;
        double lz = flip ? p.r02 * ox + p.r12 * oy + p.r22 * oz : oz;
        if (side.flatFace[place] >= 0) {
            missPolygon(flip ? p.b : p.a, side.flatFace[place], lx, ly, lz, inset);
        }
    }

    private void missDisc(int flat, double x, double y, double z, double inset) {
        SolidOfRevolution c = solid();
        double dot =
                side.flatX[flat] * side.ax
                        + side.flatY[flat] * side.ay
                        + side.flatZ[flat] * side.az;
        boolean top = flip ? dot < 0 : dot > 0;
        double along = x * side.ax + y * side.ay + z * side.az;
        double off = across(x, y, z);
        double by = off - (top ? c.highRadius : c.lowRadius) + inset;
        if (by > 0 && off > 0) {
            double f = by / off;
            missX = f * (x - along * side.ax);
            missY = f * (y - along * side.ay);
            missZ = f * (z - along * side.az);
        }
    }

    /** The way from that side of a face that a point is farthest beyond. */
    private void missPolygon(Polyhedron h, int face, double x, double y, double z, double inset) {
        int best = -1;
        double most = 0;
        for (int s = h.faceBegin(face); s < h.faceBegin(face + 1); s++) {
            double by = h.sideX(s) * x + h.sideY(s) * y + h.sideZ(s) * z - h.sideOffset(s) + inset;
            if (by > most) {
                most = by;
                best = s;
            }
        }
        if (best >= 0) {
            double sx = most * h.sideX(best);
            double sy = most * h.sideY(best);
            double sz = most * h.sideZ(best);
            missX = flip ? side.turnX(sx, sy, sz) : sx;
            missY = flip ? side.turnY(sx, sy, sz) : sy;
            missZ = flip ? side.turnZ(sx, sy, sz) : sz;
        }
    }
}
