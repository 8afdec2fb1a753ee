package dev.cairn.physics.narrowphase.round;

import dev.cairn.physics.narrowphase.pair.ContactTolerances;
import dev.cairn.physics.narrowphase.pair.FeatureIds;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.narrowphase.pair.WarmStartKey;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;

/**
 * Balls and capsules against each other in closed form, in world axes: the nearest points of two
 * cores, which are points or segments. What has two points (capsules side by side), and cores that
 * touch or are beyond the range of squares, is left to {@code NarrowPhase}, which gives the same
 * within rounding.
 *
 * <p>Allocates nothing; one instance per worker.
 */
public final class RoundContacts {
    private static final long SINGLE = 3L << 62 | FeatureIds.hash(FeatureIds.CLOSEST);

    /** Squares of lengths in this range lose nothing to underflow or overflow. */
    private static final double LEAST = 0x1p-900, MOST = 0x1p900;

    /** Of the squared scale: cores that are nearer have no direction. */
    private static final double TOUCHING = 0x1p-80;

    /** Cosine squared of the angle below which capsules may lie side by side. */
    private static final double PARALLEL = 0.9;

    /** Sine of 0.1 rad: lines that are nearer to being at right angles to the normal are level. */
    private static final double LEVEL = 0.1;

    /** Of the squared sine: axes that cross by less are tried at all their ends. */
    private static final double CROSSING = 0x1p-10;

    /** Of the squared sine: axes that cross by less do not cross. */
    private static final double NEVER = 0x1p-60;

    /** The key of the last contact. */
    private long key;

    /** Direction of A's segment; of two capsules also that of B's. */
    double axisX, axisY, axisZ, otherX, otherY, otherZ;

    /** From the core of A to that of B, and where on A's core that begins. */
    double x, y, z, onA;

    /** Square of the least distance of two segments so far. */
    private double best;

    /** The last pair was two capsules that touch, nearly parallel and level. */
    private boolean lines;

    private final ParallelCapsules sideBySide = new ParallelCapsules();

    /** Whether a shape is a ball or a capsule, so that pairs of such may be tried. */
    public static boolean fits(Shape shape) {
        return shape instanceof Sphere || shape instanceof Capsule;
    }

    /** The key of the last contact, for {@code NarrowPhase.collide}; 0 when the pair was apart. */
    public long key() {
        return key;
    }

    /**
     * Finds the contact of a pair, as {@code NarrowPhase.collide} does.
     *
     * @param margin points up to this far apart are reported, m, not negative
     * @return false when the pair is none of this class; nothing is written then
     */
    public boolean collide(
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
            Manifold out) {
        double radiusA;
        double radiusB;
        onA = 0;
        axisX = 0;
        axisY = 0;
        axisZ = 0;
        lines = false;
        if (a instanceof Capsule first) {
            radiusA = first.radius();
            axis(qAx, qAy, qAz, qAw);
            if (b instanceof Capsule second) {
                radiusB = second.radius();
                double ux = axisX;
                double uy = axisY;
                double uz = axisZ;
                axis(qBx, qBy, qBz, qBw);
                segments(
                        first.halfLength(),
                        second.halfLength(),
                        ux,
                        uy,
                        uz,
                        axisX,
                        axisY,
                        axisZ,
                        dx,
                        dy,
                        dz);
                double along = ux * axisX + uy * axisY + uz * axisZ;
                otherX = axisX;
                otherY = axisY;
                otherZ = axisZ;
                axisX = ux;
                axisY = uy;
                axisZ = uz;
                lines = along * along >= PARALLEL;
            } else {
                radiusB = ((Sphere) b).radius();
                onA = toward(first.halfLength(), dx, dy, dz);
                x = dx - onA * axisX;
                y = dy - onA * axisY;
                z = dz - onA * axisZ;
            }
        } else {
            radiusA = ((Sphere) a).radius();
            if (b instanceof Capsule second) {
                radiusB = second.radius();
                axis(qBx, qBy, qBz, qBw);
                double t = toward(second.halfLength(), -dx, -dy, -dz);
                x = dx + t * axisX;
                y = dy + t * axisY;
                z = dz + t * axisZ;
            } else {
                radiusB = ((Sphere) b).radius();
                x = dx;
                y = dy;
                z = dz;
            }
        }
        return write(radiusA, radiusB, dx, dy, dz, margin, out);
    }

    private boolean write(
            double radiusA,
            double radiusB,
            double dx,
            double dy,
            double dz,
            double margin,
            Manifold out) {
        double square = x * x + y * y + z * z;
        double scale = radiusA + radiusB + Math.abs(dx) + Math.abs(dy) + Math.abs(dz);
        if (!(square >= LEAST && square <= MOST && square >= TOUCHING * scale * scale)) {
            lines = false;
            return false;
        }
        double length = Math.sqrt(square);
        double separation = length - radiusA - radiusB;
        out.bound = 0x1p-46 * scale;
        out.capped = false;
        out.patch = 0;
        if (separation > margin) {
            out.pointCount = 0;
            key = 0;
            return true;
        }
        if (lines && level(length)) {
            return false;
        }
        lines = false;
        single(length, separation, radiusA, out);
        return true;
    }

    /** Whether both segments are nearly at right angles to the normal. */
    private boolean level(double length) {
        double nx = x / length;
        double ny = y / length;
        double nz = z / length;
        double un = axisX * nx + axisY * ny + axisZ * nz;
        double vn = otherX * nx + otherY * ny + otherZ * nz;
        return Math.abs(un) <= LEVEL && Math.abs(vn) <= LEVEL;
    }

    /** The nearest points. */
    private void single(double length, double separation, double radiusA, Manifold out) {
        double nx = x / length;
        double ny = y / length;
        double nz = z / length;
        double reach = radiusA + 0.5 * separation;
        out.pointCount = 1;
        out.normalX = nx;
        out.normalY = ny;
        out.normalZ = nz;
        out.pointX[0] = onA * axisX + reach * nx;
        out.pointY[0] = onA * axisY + reach * ny;
        out.pointZ[0] = onA * axisZ + reach * nz;
        out.separation[0] = separation;
        out.feature[0] = FeatureIds.CLOSEST;
        key = SINGLE;
    }

    /**
     * Finds the contact after {@link #collide} left the pair, if it is two capsules that may lie
     * side by side. The arguments are the same; false when the pair is none of this class; nothing
     * is written then.
     */
    public boolean sideBySide(
            Shape a,
            Shape b,
            double dx,
            double dy,
            double dz,
            double margin,
            long cache,
            Manifold out) {
        if (!(lines && a instanceof Capsule first && b instanceof Capsule second)) {
            return false;
        }
        double radiusA = first.radius();
        double radiusB = second.radius();
        double length = Math.sqrt(x * x + y * y + z * z);
        double separation = length - radiusA - radiusB;
        double inner = Math.min(radiusA, radiusB);
        boolean before = cache >>> 62 == WarmStartKey.EDGES;
        double hysteresis = ContactTolerances.HYSTERESIS * inner;
        double enough = ContactTolerances.depthError(before, hysteresis, separation);
        double rounding = out.bound;
        sideBySide.run(
                this,
                radiusA,
                first.halfLength(),
                radiusB,
                second.halfLength(),
                dx,
                dy,
                dz,
                length,
                margin,
                hysteresis,
                out);
        double wrong = Math.abs(sideBySide.deepest - separation);
        if (out.pointCount > 0 && wrong <= enough) {
            out.bound = wrong + rounding;
            key = FeatureIds.of(out) & 0xFFFFFFFFL;
        } else {
            single(length, separation, radiusA, out);
        }
        return true;
    }

    /** The y axis of an orientation that is unit up to rounding. */
    private void axis(double qx, double qy, double qz, double qw) {
        double s = 2 / (qx * qx + qy * qy + qz * qz + qw * qw);
        axisX = s * (qx * qy - qz * qw);
        axisY = 1 - s * (qx * qx + qz * qz);
        axisZ = s * (qy * qz + qx * qw);
    }

    /** Where on a segment along the axis a point is nearest. */
    private double toward(double half, double px, double py, double pz) {
        double along = axisX * px + axisY * py + axisZ * pz;
        return within(half, along);
    }

    /** The place nearest to {@code on} between the ends. */
    private static double within(double half, double on) {
        double place = on > half ? half : on;
        return place < -half ? -half : place;
    }

    /**
     * Segments along u and v about 0 and d: their nearest points are inside both, or an end of one
     * and a point of the other.
     */
    private void segments(
            double h,
            double k,
            double ux,
            double uy,
            double uz,
            double vx,
            double vy,
            double vz,
            double dx,
            double dy,
            double dz) {
        double cx = uy * vz - uz * vy;
        double cy = uz * vx - ux * vz;
        double cz = ux * vy - uy * vx;
        double sine = cx * cx + cy * cy + cz * cz;
        double du = dx * ux + dy * uy + dz * uz;
        double dv = dx * vx + dy * vy + dz * vz;
        double uv = ux * vx + uy * vy + uz * vz;
        double inverse = 1 / sine;
        // Where the lines are nearest, on each.
        double t = (uv * du - dv) * inverse;
        double s = (du - uv * dv) * inverse;
        double f = (dx * cx + dy * cy + dz * cz) * inverse;
        boolean beyondA = Math.abs(s) > h;
        boolean beyondB = Math.abs(t) > k;
        boolean clear = sine > CROSSING;
        if (clear && !beyondA && !beyondB) {
            onA = s;
            x = f * cx;
            y = f * cy;
            z = f * cz;
            return;
        }
        best = Double.MAX_VALUE;
        x = dx;
        y = dy;
        z = dz;
        if (clear) {
            // The squared distance is convex in s and t, so it is least on a side of the
            // rectangle of all places that its minimum lies beyond.
            if (beyondB) {
                endOfB(t < 0 ? -k : k, h, du, uv, ux, uy, uz, vx, vy, vz, dx, dy, dz);
            }
            if (beyondA) {
                endOfA(s < 0 ? -h : h, k, dv, uv, ux, uy, uz, vx, vy, vz, dx, dy, dz);
            }
            return;
        }
        // Nearly parallel: s and t have lost their digits, so all ends are tried.
        endOfB(-k, h, du, uv, ux, uy, uz, vx, vy, vz, dx, dy, dz);
        endOfA(-h, k, dv, uv, ux, uy, uz, vx, vy, vz, dx, dy, dz);
        endOfB(k, h, du, uv, ux, uy, uz, vx, vy, vz, dx, dy, dz);
        endOfA(h, k, dv, uv, ux, uy, uz, vx, vy, vz, dx, dy, dz);
        if (sine > NEVER && Math.abs(t) <= k && Math.abs(s) <= h && f * f * sine < best) {
            onA = s;
            x = f * cx;
            y = f * cy;
            z = f * cz;
        }
    }

    /** Tries the end of B at e with the point of A nearest to it. */
    private void endOfB(
            double e,
            double h,
            double du,
            double uv,
            double ux,
            double uy,
            double uz,
            double vx,
            double vy,
            double vz,
            double dx,
            double dy,
            double dz) {
        double on = within(h, du + e * uv);
        double px = dx + e * vx - on * ux;
        double py = dy + e * vy - on * uy;
        double pz = dz + e * vz - on * uz;
        better(on, px, py, pz);
    }

    /** Tries the end of A at e with the point of B nearest to it. */
    private void endOfA(
            double e,
            double k,
            double dv,
            double uv,
            double ux,
            double uy,
            double uz,
            double vx,
            double vy,
            double vz,
            double dx,
            double dy,
            double dz) {
        double on = within(k, e * uv - dv);
        double px = dx + on * vx - e * ux;
        double py = dy + on * vy - e * uy;
        double pz = dz + on * vz - e * uz;
        better(e, px, py, pz);
    }

    private void better(double on, double px, double py, double pz) {
        double square = px * px + py * py + pz * pz;
        if (square < best) {
            best = square;
            onA = on;
            x = px;
            y = py;
            z = pz;
        }
    }
}
