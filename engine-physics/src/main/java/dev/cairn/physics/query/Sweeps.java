package dev.cairn.physics.query;

import dev.cairn.physics.internal.Rotations;
import dev.cairn.physics.internal.Surface;
import dev.cairn.physics.narrowphase.NarrowPhase;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.shape.mesh.TriangleSet;
import dev.cairn.physics.sweep.Flight;
import dev.cairn.physics.sweep.TimeOfImpact;

/**
 * The first meeting of two shapes that move and turn. Of a surface of triangles it is that of the
 * triangles near the other's way, which is cut into spans until few of them are near.
 *
 * <p>One thread. Allocates only when there are more triangles than ever.
 */
final class Sweeps {
    /** Distances to measure before a pair that is nearly touching is taken to touch. */
    private static final int MOST_STEPS = 4096;

    /** Of the sizes: nearly touching. */
    private static final double NEAR = 0x1p-20;

    /** Most that a shape may turn in one question, rad. */
    private static final double MOST_TURN = 1e5;

    /**
     * A span with more triangles is halved, while the shape goes farther in it than it is large.
     */
    private static final int FEW = 16;

    /** Cosine of the angle at which an edge still counts as met from the front. */
    private static final double SIDEWAYS = -1e-9;

    private final NarrowPhase narrowPhase;
    private final MeshQueries meshes;
    private final TimeOfImpact search;
    private final Manifold manifold = new Manifold();
    private final Flight a = new Flight(), b = new Flight(), surface = new Flight();
    private final TriangleSet.Found found = new TriangleSet.Found();
    private final double[] box = new double[6];
    private final double[] then = new double[3], now = new double[3], v = new double[3];

    Sweeps(NarrowPhase narrowPhase, MeshQueries meshes) {
        this.narrowPhase = narrowPhase;
        this.meshes = meshes;
        search = new TimeOfImpact(narrowPhase, MOST_STEPS, NEAR);
    }

    /** As {@link ShapeQueries#timeOfImpact}. */
    boolean meet(
            Placement first,
            Motion motionA,
            Placement second,
            Motion motionB,
            double seconds,
            Hit out) {
        check(motionA, motionB, seconds);
        TriangleSet ofA = MeshQueries.triangles(first.shape);
        TriangleSet ofB = MeshQueries.triangles(second.shape);
        if (ofA != null) {
            return ofB == null
                    && onSurface(first, motionA, ofA, second, motionB, seconds, -1, motionA, out);
        }
        if (ofB != null) {
            return onSurface(second, motionB, ofB, first, motionA, seconds, 1, motionA, out);
        }
        double far = far(first, motionA, second, motionB, seconds);
        set(a, motionA, first, first, far);
        set(b, motionB, second, second, far);
        if (!find(first, second, 0, seconds)) {
            return false;
        }
        tell(first, -1, motionA, out);
        return true;
    }

    private static void check(Motion motionA, Motion motionB, double seconds) {
        if (!(seconds >= 0 && seconds < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException(
                    "seconds is " + seconds + " s; it must be at least 0 and finite");
        }
        double turn = seconds * Math.max(motionA.spin(), motionB.spin());
        if (!(turn <= MOST_TURN)) {
            throw new IllegalArgumentException(
                    "a shape turns by "
                            + turn
                            + " rad in "
                            + seconds
                            + " s; the most in one question is "
                            + MOST_TURN
                            + " rad: ask for a part of the time, and go on from there");
        }
    }

    /** Farther from a pivot than that nothing of an endless shape is met. */
    private static double far(
            Placement first, Motion motionA, Placement second, Motion motionB, double seconds) {
        double x = second.x - first.x;
        double y = second.y - first.y;
        double z = second.z - first.z;
        double levers = motionA.lever(first) + motionB.lever(second);
        return Math.sqrt(x * x + y * y + z * z)
                + motionA.way(seconds)
                + motionB.way(seconds)
                + 2 * levers
                + size(first.shape)
                + size(second.shape);
    }

    private static double size(Shape shape) {
        double outer = shape.outerRadius();
        return outer < Double.POSITIVE_INFINITY ? outer : 0;
    }

    private static void set(Flight f, Motion m, Placement centre, Placement p, double far) {
        f.shape = p.shape;
        f.turned(p.qx, p.qy, p.qz, p.qw);
        move(f, m, centre, p.x, p.y, p.z);
        Shape inner = Surface.unmoved(p.shape);
        double outer = p.shape.outerRadius();
        f.begin(outer < Double.POSITIVE_INFINITY ? outer : far, inner instanceof Sphere);
    }

    /** Sets a motion, of what has its centre of mass there, for a part of it at a place. */
    private static void move(Flight f, Motion m, Placement centre, double x, double y, double z) {
        f.vx = m.vx;
        f.vy = m.vy;
        f.vz = m.vz;
        f.ax = m.ax;
        f.ay = m.ay;
        f.az = m.az;
        f.wx = m.wx;
        f.wy = m.wy;
        f.wz = m.wz;
        if (m.hasPivot) {
            f.lever(x - m.pivotX, y - m.pivotY, z - m.pivotZ);
        } else {
            f.lever(x - centre.x, y - centre.y, z - centre.z);
        }
    }

    private boolean find(Placement first, Placement second, double from, double until) {
        double x = second.x - first.x;
        double y = second.y - first.y;
        double z = second.z - first.z;
        double size = size(first.shape) + size(second.shape);
        double met = 0x1p-46 * size + 0x1p-50 * (Math.abs(x) + Math.abs(y) + Math.abs(z));
        return search.of(a, b, x, y, z, met).find(from, until, size);
    }

    /**
     * Writes the last meeting. The point is that of what was met, the side that the normal leaves.
     *
     * @param first where a's centre was at the start
     * @param sign of the normal, along the axis from a to b
     * @param mover whose way the distance is
     */
    private void tell(Placement first, double sign, Motion mover, Hit out) {
        double t = search.time;
        out.seconds = t;
        double x = t * (mover.vx + 0.5 * t * mover.ax);
        double y = t * (mover.vy + 0.5 * t * mover.ay);
        double z = t * (mover.vz + 0.5 * t * mover.az);
        out.distance = Math.sqrt(x * x + y * y + z * z);
        out.normalX = sign * search.axisX;
        out.normalY = sign * search.axisY;
        out.normalZ = sign * search.axisZ;
        out.inside = t == 0;
        out.capped = search.capped;
        out.triangle = -1;
        double gap =
                narrowPhase.closest(
                        a.shape,
                        b.shape,
                        a.qx,
                        a.qy,
                        a.qz,
                        a.qw,
                        b.qx,
                        b.qy,
                        b.qz,
                        b.qw,
                        search.apartX(),
                        search.apartY(),
                        search.apartZ(),
                        manifold);
        double half = -0.5 * sign * gap;
        out.pointX = first.x + a.x + (manifold.pointX[0] + half * manifold.normalX);
        out.pointY = first.y + a.y + (manifold.pointY[0] + half * manifold.normalY);
        out.pointZ = first.z + a.z + (manifold.pointZ[0] + half * manifold.normalZ);
    }

    // Surfaces of triangles ----------------------------------------------------------------------

    /**
     * A surface and a convex shape.
     *
     * @param sign of the normal, along the axis from the surface to the shape
     */
    private boolean onSurface(
            Placement mesh,
            Motion motionM,
            TriangleSet set,
            Placement shape,
            Motion motion,
            double seconds,
            double sign,
            Motion mover,
            Hit out) {
        meshes.use(mesh, set);
        double far = far(mesh, motionM, shape, motion, seconds);
        surface.turned(meshes.qx, meshes.qy, meshes.qz, meshes.qw);
        move(surface, motionM, mesh, mesh.x, mesh.y, mesh.z);
        surface.begin(0, false);
        set(b, motion, shape, shape, far);
        double from = 0;
        double span = seconds;
        while (true) {
            double to = Math.min(from + span, seconds);
            boolean isLong = around(mesh, motionM, set, shape, motion, from, to);
            set.find(box, found);
            if (found.count > FEW && isLong && from + 0.5 * (to - from) > from) {
                span = 0.5 * (to - from);
                continue;
            }
            if (firstOf(mesh, motionM, set, shape, from, to, far, sign, mover, out)) {
                return true;
            }
            if (to == seconds) {
                return false;
            }
            from = to;
            span *= 2;
        }
    }

    /**
     * The box of the way of a shape over a span, in the surface's frame: around both ends, with
     * room for K h²/8 by which a way that bends by K is off the straight one. Returns whether the
     * shape goes farther than it is large.
     */
    private boolean around(
            Placement mesh,
            Motion motionM,
            TriangleSet set,
            Placement shape,
            Motion motion,
            double from,
            double to) {
        place(mesh, shape, from, then);
        place(mesh, shape, to, now);
        double h = to - from;
        double lever = motion.lever(shape);
        double leverM = motionM.lever(mesh);
        double spin = motion.spin();
        double spinM = motionM.spin();
        double speed = motion.speed(to) + spin * lever + motionM.speed(to) + spinM * leverM;
        double apart = Math.max(length(then), length(now)) + speed * h;
        double bend =
                motion.acceleration()
                        + motionM.acceleration()
                        + spin * spin * lever
                        + spinM * spinM * (leverM + apart)
                        + 2 * spinM * speed;
        double off = 0.125 * bend * h * h;
        double outer = shape.shape.outerRadius();
        double room = outer + off + 0x1p-40 * (apart + off);
        double way = 0;
        for (int axis = 0; axis < 3; axis++) {
            way += (now[axis] - then[axis]) * (now[axis] - then[axis]);
            double low = Math.min(then[axis], now[axis]) - room;
            double high = Math.max(then[axis], now[axis]) + room;
            box[axis] = Math.max(low, set.end(axis, false) - 1);
            box[axis + 3] = Math.min(high, set.end(axis, true) + 1);
        }
        return Math.sqrt(way) + off > outer;
    }

    private static double length(double[] p) {
        return Math.sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    }

    /** Where the shape's centre is in the surface's frame, at a time. */
    private void place(Placement mesh, Placement shape, double t, double[] out) {
        surface.move(t);
        b.move(t);
        Rotations.rotate(
                -surface.qx,
                -surface.qy,
                -surface.qz,
                surface.qw,
                shape.x - mesh.x + (b.x - surface.x),
                shape.y - mesh.y + (b.y - surface.y),
                shape.z - mesh.z + (b.z - surface.z),
                out);
    }

    /**
     * The first of the triangles found; of equals the one that comes first. What is met from behind
     * is looked at again when it is known how long that matters.
     */
    private boolean firstOf(
            Placement mesh,
            Motion motionM,
            TriangleSet set,
            Placement shape,
            double from,
            double to,
            double far,
            double sign,
            Motion mover,
            Hit out) {
        double limit = to;
        int best = -1;
        int behind = 0;
        for (int round = 0; round < 2; round++) {
            int count = round == 0 ? found.count : behind;
            for (int i = 0; i < count; i++) {
                int t = found.triangle[i];
                meshes.place(t);
                Placement triangle = meshes.triangle;
                set(a, motionM, mesh, triangle, far);
                double met = meetTriangle(set, shape, from, limit, round > 0);
                if (met <= limit && (best < 0 || met < limit)) {
                    limit = met;
                    best = t;
                    tell(triangle, sign, mover, out);
                } else if (met == Double.POSITIVE_INFINITY && round == 0) {
                    found.triangle[behind++] = t;
                }
            }
        }
        if (best < 0) {
            return false;
        }
        out.triangle = set.source(best);
        set.corners(best, meshes.corner);
        surface.move(limit);
        Rotations.rotate(
                -surface.qx,
                -surface.qy,
                -surface.qz,
                surface.qw,
                out.pointX - meshes.ox - surface.x,
                out.pointY - meshes.oy - surface.y,
                out.pointZ - meshes.oz - surface.z,
                v);
        meshes.weigh(v[0], v[1], v[2]);
        out.weight1 = meshes.weight1;
        out.weight2 = meshes.weight2;
        return true;
    }

    /**
     * When the triangle at hand is met from a side that counts. NaN if never; infinite if it is met
     * from behind, and what follows is not asked for.
     */
    private double meetTriangle(
            TriangleSet set, Placement shape, double from, double until, boolean toTheEnd) {
        double start = from;
        while (start <= until && find(meshes.triangle, shape, start, until)) {
            if (set.isTwoSided || isInFront(shape, start)) {
                return search.time;
            }
            if (!toTheEnd) {
                return Double.POSITIVE_INFINITY;
            }
            start = search.leave();
        }
        return Double.NaN;
    }

    /**
     * Whether the last meeting is with the front of the triangle at hand: along the axis; of what
     * overlaps at the start by the shape's centre. What overlaps later has come through the back.
     */
    private boolean isInFront(Placement shape, double start) {
        boolean overlapped = search.time == start;
        if (overlapped && start > 0) {
            return false;
        }
        meshes.normal();
        Rotations.rotate(a.qx, a.qy, a.qz, a.qw, meshes.nx, meshes.ny, meshes.nz, v);
        double length = length(v);
        if (overlapped) {
            Placement t = meshes.triangle;
            return v[0] * (shape.x - t.x) + v[1] * (shape.y - t.y) + v[2] * (shape.z - t.z) >= 0;
        }
        return v[0] * search.axisX + v[1] * search.axisY + v[2] * search.axisZ >= SIDEWAYS * length;
    }
}
