package dev.cairn.physics.narrowphase;

import static dev.cairn.physics.narrowphase.wide.RoundBatch.CROSSING;
import static dev.cairn.physics.narrowphase.wide.RoundBatch.LEAST;
import static dev.cairn.physics.narrowphase.wide.RoundBatch.MOST;
import static dev.cairn.physics.narrowphase.wide.RoundBatch.NEVER;
import static dev.cairn.physics.narrowphase.wide.RoundBatch.PARALLEL;
import static dev.cairn.physics.narrowphase.wide.RoundBatch.TOUCHING;

import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;

/**
 * Balls and capsules against each other in closed form, in world axes: the nearest points of two
 * cores, which are points or segments. What has two points (capsules side by side), and cores that
 * touch or are beyond the range of squares, is left to {@link NarrowPhase}, which gives the same
 * within rounding.
 *
 * <p>Allocates nothing; one instance per worker.
 */
public final class RoundContacts {
    static final long SINGLE = 3L << 62 | Names.hash(ContactPoints.CLOSEST);

    /** The word of the last contact. */
    private long word;

    /** Direction of A's segment; of two capsules also that of B's. */
    double axisX, axisY, axisZ, otherX, otherY, otherZ;

    /** From the core of A to that of B, and where on A's core that begins. */
    double x, y, z, onA;

    /** The last pair was two capsules that may lie side by side, and touch. */
    private boolean lines;

    private final CapsuleLines sideBySide = new CapsuleLines();

    /** Creates the scratch of one worker. */
    public RoundContacts() {}

    /**
     * Whether a shape is a ball or a capsule.
     *
     * @param shape any
     * @return true when pairs of such may be tried
     */
    public static boolean fits(Shape shape) {
        return shape instanceof Sphere || shape instanceof Capsule;
    }

    /**
     * The word of the last contact, for {@link NarrowPhase#collide}.
     *
     * @return 0 when the pair was apart
     */
    public long word() {
        return word;
    }

    /**
     * Finds the contact of a pair, as {@link NarrowPhase#collide} does.
     *
     * @param a first shape; {@link #fits}
     * @param b second shape; {@link #fits}
     * @param qAx orientation of A, world from body, unit quaternion
     * @param qAy orientation of A
     * @param qAz orientation of A
     * @param qAw orientation of A
     * @param qBx orientation of B, world from body, unit quaternion
     * @param qBy orientation of B
     * @param qBz orientation of B
     * @param qBw orientation of B
     * @param dx centre of B minus centre of A, world axes, m
     * @param dy see {@code dx}
     * @param dz see {@code dx}
     * @param margin points up to this far apart are reported, m, not negative
     * @param out receives the contact
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
            word = 0;
            return true;
        }
        if (lines) {
            return false;
        }
        single(length, separation, radiusA, out);
        return true;
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
        out.feature[0] = ContactPoints.CLOSEST;
        word = SINGLE;
    }

    /**
     * Finds the contact after {@link #collide} left the pair, if it is two capsules that may lie
     * side by side. The arguments are the same.
     *
     * @return false when the pair is none of this class; nothing is written then
     */
    boolean sideBySide(
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
        double length = Math.sqrt(x * x + y * y + z * z);
        double separation = length - first.radius() - second.radius();
        double inner = Math.min(first.radius(), second.radius());
        boolean before = cache >>> 62 == NarrowPhase.EDGES;
        double calm = NarrowPhase.CALM * inner;
        double enough = (before ? 0.5 : 1.5) * calm + (before ? 0.05 : 0.15) * Math.abs(separation);
        double rounding = out.bound;
        sideBySide.run(this, first, second, dx, dy, dz, length, margin, calm, out);
        double wrong = Math.abs(sideBySide.deepest - separation);
        if (out.pointCount > 0 && wrong <= enough) {
            out.bound = wrong + rounding;
            word = Names.of(out) & 0xFFFFFFFFL;
        } else {
            single(length, separation, first.radius(), out);
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

    /**
     * The place nearest to {@code on} between the ends; as in lanes, without regard to signs of 0.
     */
    private static double within(double half, double on) {
        double place = on > half ? half : on;
        return place < -half ? -half : place;
    }

    /**
     * Segments along u and v about 0 and d: their nearest points are inside both, or an end of one
     * and a point of the other. Unless they cross clearly all of these are tried, so that nearly
     * parallel ones keep their digits.
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
        double t = (uv * du - dv) * inverse;
        double s = (du - uv * dv) * inverse;
        if (sine > CROSSING && Math.abs(t) <= k && Math.abs(s) <= h) {
            double f = (dx * cx + dy * cy + dz * cz) * inverse;
            onA = s;
            x = f * cx;
            y = f * cy;
            z = f * cz;
            return;
        }
        double best = Double.MAX_VALUE;
        for (int sign = -1; sign <= 1; sign += 2) {
            // An end of B.
            double e = sign * k;
            double on = within(h, du + e * uv);
            double px = dx + e * vx - on * ux;
            double py = dy + e * vy - on * uy;
            double pz = dz + e * vz - on * uz;
            double square = px * px + py * py + pz * pz;
            if (square < best) {
                best = square;
                onA = on;
                x = px;
                y = py;
                z = pz;
            }
            // An end of A.
            e = sign * h;
            double other = within(k, e * uv - dv);
            px = dx + other * vx - e * ux;
            py = dy + other * vy - e * uy;
            pz = dz + other * vz - e * uz;
            square = px * px + py * py + pz * pz;
            if (square < best) {
                best = square;
                onA = e;
                x = px;
                y = py;
                z = pz;
            }
        }
        if (sine > NEVER && sine <= CROSSING && Math.abs(t) <= k && Math.abs(s) <= h) {
            double f = (dx * cx + dy * cy + dz * cz) * inverse;
            if (f * f * sine < best) {
                onA = s;
                x = f * cx;
                y = f * cy;
                z = f * cz;
            }
        }
    }
}
