package dev.cairn.physics.narrowphase.curved;

import dev.cairn.physics.narrowphase.clip.ContactPoints;
import dev.cairn.physics.narrowphase.clip.Patch;
import dev.cairn.physics.narrowphase.pair.BoxTopology;
import dev.cairn.physics.narrowphase.pair.ContactTolerances;
import dev.cairn.physics.narrowphase.pair.FeatureIds;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.narrowphase.pair.Pair;
import dev.cairn.physics.narrowphase.pair.WarmStartKey;

/**
 * The contact of a capsule and a box once {@link SegmentBox} has their axis, by the rules of {@link
 * CurvedContact} and {@code Overlay}: where the axis is nearly the normal of a face, the part of
 * the capsule's line that is over the face; else one point.
 */
final class CapsuleOnBox {
    /** Sine of 0.1 rad. */
    private static final double ACROSS = 0.1;

    /** Square of the cosine between lines that count as side by side. */
    private static final double ALIGNED = 0.9;

    private final Pair pair;
    private final ContactPoints points;
    private final SegmentBox axis;

    /** The part of the line from its lower to its upper end, 0 to 1, and the names of its ends. */
    private double from, to;

    private int fromName, toName;

    /** How far from a side plane an end counts as on it: at first, and while it was a point. */
    private double slack, slackBefore;

    private int last;

    /** The least separation of the points that were made. */
    private double deepest;

    CapsuleOnBox(Pair pair, ContactPoints points, SegmentBox axis) {
        this.pair = pair;
        this.points = points;
        this.axis = axis;
    }

    /** Whether the capsule may lie along an edge of the box, which {@link CurvedContact} tells. */
    boolean sideBySide() {
        SegmentBox s = axis;
        return face() < 0
                && (along(s.x, s.ux) || along(s.y, s.uy) || along(s.z, s.uz))
                && Math.abs(s.x * s.ux + s.y * s.uy + s.z * s.uz) <= ACROSS;
    }

    private static boolean along(double n, double u) {
        return Math.abs(n) <= ACROSS && u * u >= ALIGNED;
    }

    /** The face whose normal is nearly the axis, or -1. */
    private int face() {
        if (Math.abs(axis.x) >= ContactTolerances.NEARLY_PARALLEL) {
            return axis.x > 0 ? 1 : 0;
        }
        if (Math.abs(axis.y) >= ContactTolerances.NEARLY_PARALLEL) {
            return axis.y > 0 ? 3 : 2;
        }
        return Math.abs(axis.z) >= ContactTolerances.NEARLY_PARALLEL ? axis.z > 0 ? 5 : 4 : -1;
    }

    /** Fills the manifold; returns the key of the next tick. See {@link CurvedContact#run}. */
    long run(double margin, double hysteresis, long cache, Manifold out) {
        double radius = pair.radiusA + pair.radiusB;
        double separation = axis.best - radius;
        if (separation > margin) {
            return 0;
        }
        boolean single = cache >>> 62 == WarmStartKey.EDGES;
        double enough = ContactTolerances.depthError(single, hysteresis, separation);
        int face = face();
        deepest = Double.MAX_VALUE;
        if (face >= 0) {
            last = (int) cache;
            onFace(face, radius, margin, out);
        }
        long reference = axis.second ? WarmStartKey.FACE_B : WarmStartKey.FACE_A;
        if (!(Math.abs(deepest - separation) <= enough)) {
            reference = WarmStartKey.EDGES;
            deepest = separation;
            out.pointCount = 0;
            // Midway between the surfaces, which are r from the segment and best from it.
            double back = 0.5 * (axis.best + radius);
            add(
                    axis.cx + axis.at * axis.ux - back * axis.x,
                    axis.cy + axis.at * axis.uy - back * axis.y,
                    axis.cz + axis.at * axis.uz - back * axis.z,
                    separation,
                    FeatureIds.CLOSEST,
                    out);
            normal(axis.x, axis.y, axis.z, out);
        }
        out.bound = Math.abs(deepest - separation) + 0x1p-46 * pair.scale;
        return WarmStartKey.of(reference, 0, FeatureIds.of(out));
    }

    /** The capsule's line nearest to a face, cut by the sides of the face. */
    private void onFace(int face, double radius, double margin, Manifold out) {
        SegmentBox s = axis;
        int end = axis.second ? FeatureIds.VERTEX_A : FeatureIds.VERTEX_B;
        from = 0;
        to = 1;
        fromName = end | Patch.END;
        toName = end | (Patch.END + 1);
        slack = ContactTolerances.ON_PLANE * pair.inner;
        slackBefore = ContactTolerances.STILL_ON_PLANE * pair.inner;
        int normal = face >> 1;
        double sign = (face & 1) == 0 ? -1 : 1;
        for (int slot = 4 * face; slot < 4 * face + 4; slot++) {
            int side = BoxTopology.sideAxis(slot);
            double c = side == 0 ? s.cx : side == 1 ? s.cy : s.cz;
            double u = side == 0 ? s.ux : side == 1 ? s.uy : s.uz;
            double b = side == 0 ? s.bx : side == 1 ? s.by : s.bz;
            double outward = BoxTopology.isSidePositive(slot) ? 1 : -1;
            cut(outward * (c - s.h * u) - b, outward * (2 * s.h * u), BoxTopology.slotEdge(slot));
        }
        if (to < from) {
            return;
        }
        put(from, fromName, normal, sign, radius, margin, out);
        if (to - from > 0x1p-20) {
            put(to, toName, normal, sign, radius, margin, out);
        }
        normal(normal == 0 ? sign : 0, normal == 1 ? sign : 0, normal == 2 ? sign : 0, out);
    }

    /** Keeps the part of the line where p + t slope is not positive. */
    private void cut(double p, double slope, int edge) {
        double atFrom = p + from * slope;
        double atTo = p + to * slope;
        double t = slope == 0 ? 0 : -p / slope;
        if (atTo > slack(toName)) {
            toName = crossing(edge, Patch.END + 2);
            to = atFrom > slack(fromName) ? -1 : Math.max(from, t);
        } else if (atFrom > slack(fromName)) {
            fromName = crossing(edge, Patch.END + 3);
            from = Math.min(to, t);
        }
    }

    private double slack(int name) {
        return last != 0 && FeatureIds.contains(last, name) ? slackBefore : slack;
    }

    private int crossing(int edge, int line) {
        return axis.second
                ? FeatureIds.CROSSING | line << 15 | edge
                : FeatureIds.CROSSING | edge << 15 | line;
    }

    /** A point of the line midway between the surfaces along a face's normal. */
    private void put(
            double t,
            int name,
            int normal,
            double sign,
            double radius,
            double margin,
            Manifold out) {
        SegmentBox s = axis;
        double along = (2 * t - 1) * s.h;
        double x = s.cx + along * s.ux;
        double y = s.cy + along * s.uy;
        double z = s.cz + along * s.uz;
        double height = normal == 0 ? sign * x : normal == 1 ? sign * y : sign * z;
        double above = height - (normal == 0 ? s.bx : normal == 1 ? s.by : s.bz);
        double separation = above - radius;
        if (separation > margin) {
            return;
        }
        deepest = Math.min(deepest, separation);
        double back = sign * (0.5 * (above + radius));
        x -= normal == 0 ? back : 0;
        y -= normal == 1 ? back : 0;
        z -= normal == 2 ? back : 0;
        add(x, y, z, separation, name, out);
    }

    /** A point, given in the box's frame. */
    private void add(double x, double y, double z, double separation, int name, Manifold out) {
        Pair p = pair;
        if (axis.second) {
            points.add(
                    p.r00 * x + p.r01 * y + p.r02 * z + p.dx,
                    p.r10 * x + p.r11 * y + p.r12 * z + p.dy,
                    p.r20 * x + p.r21 * y + p.r22 * z + p.dz,
                    separation,
                    name,
                    out);
        } else {
            points.add(x, y, z, separation, name, out);
        }
    }

    /** Sets the normal, given from the box to the capsule in the box's frame. */
    private void normal(double x, double y, double z, Manifold out) {
        Pair p = pair;
        if (axis.second) {
            points.setAxis(
                    -(p.r00 * x + p.r01 * y + p.r02 * z),
                    -(p.r10 * x + p.r11 * y + p.r12 * z),
                    -(p.r20 * x + p.r21 * y + p.r22 * z));
        } else {
            points.setAxis(x, y, z);
        }
        points.writeNormal(out);
    }
}
