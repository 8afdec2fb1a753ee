package dev.cairn.physics.narrowphase.curved;

import dev.cairn.physics.narrowphase.axis.AxisRefinement;
import dev.cairn.physics.narrowphase.clip.ContactPoints;
import dev.cairn.physics.narrowphase.clip.Overlay;
import dev.cairn.physics.narrowphase.clip.Patch;
import dev.cairn.physics.narrowphase.clip.Reduction;
import dev.cairn.physics.narrowphase.pair.Axes;
import dev.cairn.physics.narrowphase.pair.ContactTolerances;
import dev.cairn.physics.narrowphase.pair.FeatureIds;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.narrowphase.pair.Pair;
import dev.cairn.physics.narrowphase.pair.WarmStartKey;

/**
 * The manifold of a pair with a capsule, cylinder or cone, once {@link CurvedAxis} has its axis:
 * flats and lines that face each other give up to four points by {@link Overlay}, two lines side by
 * side give two, all else one point.
 *
 * <p>As for polyhedra, the flat of the last tick stays the reference while it is nearly as good as
 * the best, and a contact of flats or lines is replaced by one point along the best axis when its
 * deepest point does not tell the true depth.
 */
final class CurvedContact {
    /** Sine of 0.1 rad. */
    private static final double ACROSS = 0.1;

    private final Pair pair;
    private final ContactPoints points;
    private final CurvedAxis axis;
    private final Patch patchA = new Patch(), patchB = new Patch();
    private final Overlay overlay = new Overlay();
    private final Reduction reduction = new Reduction();
    private double nx, ny, nz, separation;

    CurvedContact(Pair pair, ContactPoints points, CurvedAxis axis) {
        this.pair = pair;
        this.points = points;
        this.axis = axis;
    }

    /** Fills the manifold of a pair whose axis is known; returns the key of the next tick. */
    long run(double margin, double hysteresis, long cache, Manifold out) {
        nx = axis.axisX;
        ny = axis.axisY;
        nz = axis.axisZ;
        separation = axis.separation - pair.radiusA - pair.radiusB;
        if (separation > margin) {
            return 0;
        }
        long before = cache >>> 62;
        int last = (int) cache;
        patchA.fill(pair, false, nx, ny, nz);
        patchB.fill(pair, true, -nx, -ny, -nz);
        long reference = reference(before, hysteresis);
        if (reference == WarmStartKey.FACE_A) {
            flats(patchA, patchB, margin, hysteresis, last, out);
        } else if (reference == WarmStartKey.FACE_B) {
            flats(patchB, patchA, margin, hysteresis, last, out);
        } else {
            lines(margin, hysteresis, out);
        }
        double enough =
                ContactTolerances.depthError(before == WarmStartKey.EDGES, hysteresis, separation);
        if (out.pointCount == 0 || Math.abs(out.deepest() - separation) > enough) {
            single(out);
            reference = WarmStartKey.EDGES;
        }
        out.bound = Math.abs(out.deepest() - separation) + axis.gap + 0x1p-46 * pair.scale;
        // Lines are the reference of neither shape: key 0 with names.
        return reference << 62 | (FeatureIds.of(out) & 0xFFFFFFFFL);
    }

    /** The shape whose flat the separations are measured from; 0 for neither. */
    private long reference(long before, double hysteresis) {
        double a = Axes.NEVER;
        double b = Axes.NEVER;
        boolean incidentA = patchA.line || patchA.flat != Patch.NONE;
        boolean incidentB = patchB.line || patchB.flat != Patch.NONE;
        if (patchA.flat != Patch.NONE
                && patchA.cosine >= ContactTolerances.NEARLY_PARALLEL
                && incidentB) {
            a = along(patchA.nx, patchA.ny, patchA.nz);
        }
        if (patchB.flat != Patch.NONE
                && patchB.cosine >= ContactTolerances.NEARLY_PARALLEL
                && incidentA) {
            b = along(-patchB.nx, -patchB.ny, -patchB.nz);
        }
        if (a == Axes.NEVER && b == Axes.NEVER) {
            return 0;
        }
        // A face is preferred to a disc, then what was the reference before.
        double bias =
                before == WarmStartKey.FACE_B
                        ? -hysteresis
                        : before == WarmStartKey.FACE_A ? hysteresis : 0x1p-40 * pair.scale;
        if (patchA.flat != patchB.flat && a != Axes.NEVER && b != Axes.NEVER) {
            bias = patchA.flat == Patch.FACE ? hysteresis : -hysteresis;
        }
        return b > a + bias ? WarmStartKey.FACE_B : WarmStartKey.FACE_A;
    }

    private double along(double x, double y, double z) {
        return x * pair.dx
                + y * pair.dy
                + z * pair.dz
                - pair.reachA(x, y, z)
                - pair.reachB(-x, -y, -z)
                - pair.radiusA
                - pair.radiusB;
    }

    private void flats(
            Patch ref, Patch inc, double margin, double hysteresis, int last, Manifold out) {
        inc.fill(pair, inc.second, -ref.nx, -ref.ny, -ref.nz);
        overlay.begin(pair, ref, inc, last);
        overlay.run();
        overlay.finish(margin);
        reduction.reduce(overlay.out, ref.nx, ref.ny, ref.nz, 0.01 * hysteresis, hysteresis, last);
        double sign = ref.second ? -1 : 1;
        points.setAxis(sign * ref.nx, sign * ref.ny, sign * ref.nz);
        points.take(overlay.out, ref.nx, ref.ny, ref.nz, out);
        boolean disc = ref.flat == Patch.DISC || (inc.flat == Patch.DISC && inc.flatter);
        out.patch = disc && out.pointCount == Manifold.POINTS ? Patch.DISC_SHARE : 0;
    }

    /** Two lines side by side: both ends of the part that they share. */
    private void lines(double margin, double hysteresis, Manifold out) {
        Patch a = patchA;
        Patch b = patchB;
        if (!a.line || !b.line) {
            return;
        }
        double ux = a.qx - a.px;
        double uy = a.qy - a.py;
        double uz = a.qz - a.pz;
        double vx = b.qx - b.px;
        double vy = b.qy - b.py;
        double vz = b.qz - b.pz;
        double uu = ux * ux + uy * uy + uz * uz;
        double uv = ux * vx + uy * vy + uz * vz;
        double vv = vx * vx + vy * vy + vz * vz;
        double un = ux * nx + uy * ny + uz * nz;
        double vn = vx * nx + vy * ny + vz * nz;
        boolean level = un * un <= ACROSS * ACROSS * uu && vn * vn <= ACROSS * ACROSS * vv;
        if (!level || uv * uv < 0.9 * uu * vv) {
            return;
        }
        double atP = ((b.px - a.px) * ux + (b.py - a.py) * uy + (b.pz - a.pz) * uz) / uu;
        double atQ = ((b.qx - a.px) * ux + (b.qy - a.py) * uy + (b.qz - a.pz) * uz) / uu;
        double slope = atQ - atP;
        double from = Math.max(0, Math.min(atP, atQ));
        double to = Math.min(1, Math.max(atP, atQ));
        if (!(to - from > 0x1p-10)) {
            return;
        }
        boolean ok = true;
        points.setAxis(nx, ny, nz);
        out.pointCount = 0;
        for (int k = 0; k < 2; k++) {
            double s = k == 0 ? from : to;
            double t = (s - atP) / slope;
            double ax = a.px + s * ux;
            double ay = a.py + s * uy;
            double az = a.pz + s * uz;
            double gx = b.px + t * vx - ax;
            double gy = b.py + t * vy - ay;
            double gz = b.pz + t * vz - az;
            double gap = gx * nx + gy * ny + gz * nz;
            double side = Math.max(0, gx * gx + gy * gy + gz * gz - gap * gap);
            // What round sides lose where they pass each other: side² / (2 (R + r)).
            ok &= side <= 2 * hysteresis * (a.bend + b.bend);
            int name = s == 0 ? a.nameP : s == 1 ? a.nameQ : t <= 0.5 ? b.nameP : b.nameQ;
            if (gap <= margin) {
                points.add(ax + gx / 2, ay + gy / 2, az + gz / 2, gap, name, out);
            }
        }
        if (!ok) {
            out.pointCount = 0;
        }
    }

    /** One point, midway between the surfaces along the axis; a tip has its name. */
    private void single(Manifold out) {
        double half = 0.5 * separation;
        double x;
        double y;
        double z;
        int name = FeatureIds.CLOSEST;
        boolean ofA =
                axis.kindA > axis.kindB
                        || (axis.kindA == axis.kindB && pair.roundA && pair.solidA.isPoint());
        if (axis.kindA == AxisRefinement.LINE && axis.kindB == AxisRefinement.LINE) {
            crossing();
            x = crossX;
            y = crossY;
            z = crossZ;
        } else if (ofA) {
            int v = pair.supportA(nx, ny, nz, 0);
            name = pair.roundA && pair.solidA.isTip(v) ? FeatureIds.VERTEX_A | Patch.TIP : name;
            double reach = pair.radiusA + half;
            x = pair.vertexAX(v) + reach * nx;
            y = pair.vertexAY(v) + reach * ny;
            z = pair.vertexAZ(v) + reach * nz;
        } else {
            int v = pair.supportB(-nx, -ny, -nz, 0);
            pair.vertexB(v);
            name = pair.roundB && pair.solidB.isTip(v) ? FeatureIds.VERTEX_B | Patch.TIP : name;
            double reach = pair.radiusB + half;
            x = pair.px - reach * nx;
            y = pair.py - reach * ny;
            z = pair.pz - reach * nz;
        }
        points.setAxis(nx, ny, nz);
        points.single(x, y, z, separation, name, out);
    }

    private double crossX, crossY, crossZ;

    /** Midway between the nearest points of the two lines. */
    private void crossing() {
        Patch a = patchA;
        Patch b = patchB;
        a.fill(pair, false, nx, ny, nz);
        b.fill(pair, true, -nx, -ny, -nz);
        double ux = a.qx - a.px;
        double uy = a.qy - a.py;
        double uz = a.qz - a.pz;
        double vx = b.qx - b.px;
        double vy = b.qy - b.py;
        double vz = b.qz - b.pz;
        double rx = b.px - a.px;
        double ry = b.py - a.py;
        double rz = b.pz - a.pz;
        double uu = ux * ux + uy * uy + uz * uz;
        double vv = vx * vx + vy * vy + vz * vz;
        double uv = ux * vx + uy * vy + uz * vz;
        double ur = ux * rx + uy * ry + uz * rz;
        double vr = vx * rx + vy * ry + vz * rz;
        double det = uu * vv - uv * uv;
        if (!(det > 0x1p-40 * uu * vv)) {
            // Side by side: the middle of what they share.
            double atP = ur / uu;
            double atQ = (ur + uv) / uu;
            double from = Math.max(0, Math.min(atP, atQ));
            double to = Math.min(1, Math.max(atP, atQ));
            double mid = Math.max(0, Math.min(1, 0.5 * (from + to)));
            double half = 0.5 * separation;
            crossX = a.px + mid * ux + half * nx;
            crossY = a.py + mid * uy + half * ny;
            crossZ = a.pz + mid * uz + half * nz;
            return;
        }
        double s = Math.max(0, Math.min(1, (ur * vv - vr * uv) / det));
        double t = Math.max(0, Math.min(1, (ur * uv - vr * uu) / det));
        crossX = (a.px + s * ux + b.px + t * vx) / 2;
        crossY = (a.py + s * uy + b.py + t * vy) / 2;
        crossZ = (a.pz + s * uz + b.pz + t * vz) / 2;
    }
}
