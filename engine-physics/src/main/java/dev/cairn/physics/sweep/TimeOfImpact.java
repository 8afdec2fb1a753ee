package dev.cairn.physics.sweep;

import dev.cairn.physics.narrowphase.NarrowPhase;
import dev.cairn.physics.narrowphase.pair.Reach;

/**
 * The first time at which two convex shapes touch, each on its {@link Flight}.
 *
 * <p>Two proofs that a span is free. Let d be their distance and n the unit axis along which it is
 * measured, from a to b. Conservative advancement (B. Mirtich, 1996): no point closes along n
 * faster than
 *
 * <pre>
 *   c = n . (vA - vB) + |n x wA| RA + |n x wB| RB        R = how far a point is from its pivot
 * </pre>
 *
 * so nothing meets before d/c, and nothing at all if c is not positive. It creeps where the true
 * speed is far below c. So a longer span [0, h] is tried, at whose ends the distances are d0, d1
 * and the axes n0, n1. Let the axis go straight from n0 to n1. For each pair of points, the gap f =
 * n . (pB - pA) along it is at least d0 and d1 at the ends, and
 *
 * <pre>
 *   |f''| &lt;= K = |aB - aA| + |wA|² RA + |wB|² RB + 2/h (|m . (vB - vA)| + |m x wA| RA + |m x wB| RB),
 *   m = n1 - n0          hence        f(t) &gt;= d0 + (d1 - d0) t/h - K/2 t (h - t)
 * </pre>
 *
 * for all pairs, so if the right side stays above 0 nothing has met. It holds for spans of sqrt(8
 * d/K) where both graze, and next to a meeting for any step that ends before it, so the search
 * converges as Newton's method does.
 *
 * <p>Of a body that tumbles, |w| is the largest that it may have, and |n x w| no more than that at
 * the start and what w may have changed by; |dw/dt| R is added to K.
 *
 * <p>One thread. Allocates nothing.
 */
public final class TimeOfImpact {
    /** Of what they have moved: rounding of their places. */
    private static final double ROUNDING = 0x1p-51;

    /** Of the sizes: a step of what parts. */
    private static final double SHORT = 0x1p-8;

    /** By how much less than K the gap may bend in a trial, after trials that went well. */
    private static final double MOST_BOLD = 0x1p12;

    /** Of the tick, in a proof. */
    private static final int MOST_HALVINGS = 4;

    private final NarrowPhase narrowPhase;
    private final SupportGaps supports = new SupportGaps();
    private final int mostSteps, mostInAll;
    private final double near;

    private final double[] next = new double[3];
    private Flight a = new Flight(), b = new Flight();
    private double apartX, apartY, apartZ;
    private double until;

    private double met, scale;

    /** What {@link #haveMet} saw, m. */
    private double gapAtEnd;

    /** At the end of a trial span. */
    private double nextX, nextY, nextZ;

    /** When they meet, s. */
    public double time;

    /** Unit axis from a to b at that time, world. */
    public double axisX, axisY, axisZ;

    /** Whether the search gave up while they were near, and takes them to have met. */
    public boolean capped;

    /** Whether the search gave up while they were not near: free until {@link #time}. */
    public boolean isUndecided;

    /**
     * A search that ends only when it knows.
     *
     * @param narrowPhase measures distances
     * @param mostSteps distances to measure before it gives up
     * @param near it gives up only when they are no farther apart than this part of their sizes
     */
    public TimeOfImpact(NarrowPhase narrowPhase, int mostSteps, double near) {
        this(narrowPhase, mostSteps, near, Integer.MAX_VALUE);
    }

    /**
     * A search that ends: a body that turns a hundred times in a tick, close to another one, is not
     * followed to the end.
     *
     * @param narrowPhase measures distances
     * @param mostSteps see above
     * @param near see above
     * @param mostInAll distances to measure before it gives up however far apart they are
     */
    public TimeOfImpact(NarrowPhase narrowPhase, int mostSteps, double near, int mostInAll) {
        this.narrowPhase = narrowPhase;
        this.mostSteps = mostSteps;
        this.near = near;
        this.mostInAll = mostInAll;
    }

    /**
     * Says which shapes the next questions are about.
     *
     * @param first the shape a
     * @param second the shape b
     * @param x from a's centre to b's at the start, world, m
     * @param y see {@code x}
     * @param z see {@code x}
     * @param nearer nearer than that counts as met, m, at least 0
     * @return this
     */
    public TimeOfImpact of(
            Flight first, Flight second, double x, double y, double z, double nearer) {
        a = first;
        b = second;
        apartX = x;
        apartY = y;
        apartZ = z;
        met = nearer;
        capped = false;
        isUndecided = false;
        return this;
    }

    /**
     * Looks for the first meeting of two; see {@link #of}.
     *
     * @param from when it begins, s
     * @param end when it ends, s; at it they may meet
     * @param size what {@code near} is a part of, m
     * @return whether they meet; tells {@link #time} and the axis, and leaves both shapes there.
     *     Where {@link #isUndecided}, it is not known
     */
    public boolean find(double from, double end, double size) {
        until = end;
        scale = size;
        time = from;
        if (search(near * scale)) {
            a.move(time);
            b.move(time);
            return true;
        }
        return false;
    }

    /**
     * Whether two that are apart overlap at a later time: then they meet before it, and a caller
     * that need not know when needs no search; see {@link #of}.
     *
     * @param later s
     * @param nx unit axis from a to b, world: corners that are farthest along it are tried first
     * @param ny see {@code nx}
     * @param nz see {@code nx}
     */
    public boolean haveMet(double later, double nx, double ny, double nz) {
        until = later;
        a.move(later);
        b.move(later);
        double x = apartX();
        double y = apartY();
        double z = apartZ();
        if (supports.isCornerIn(a, b, x, y, z, nx, ny, nz)
                || supports.isCornerIn(b, a, -x, -y, -z, -nx, -ny, -nz)) {
            gapAtEnd = 0;
            return true;
        }
        gapAtEnd = apartBy();
        gapAtEnd = gapAtEnd > 0 ? gapAtEnd : look(later);
        return gapAtEnd <= 0;
    }

    /**
     * After {@link #haveMet} said no: whether two that {@link Reach} fits are held apart by an axis
     * that turns to that of their distance then. The second proof above, by support functions; it
     * decides most pairs that go around each other.
     *
     * @param nx unit axis from a to b at the start, world; that of their distance is looked for
     *     where this one tells nothing
     * @param ny see {@code nx}
     * @param nz see {@code nx}
     * @return false says nothing
     */
    public boolean areHeldApart(double nx, double ny, double nz) {
        if (!(gapAtEnd > 0)) {
            return false;
        }
        double x = nextX;
        double y = nextY;
        double z = nextZ;
        a.move(0);
        b.move(0);
        axisX = nx;
        axisY = ny;
        axisZ = nz;
        double now = along(nx, ny, nz);
        if (!(now > 0)) {
            // no axis of theirs; that of the end, or else their own
            axisX = x;
            axisY = y;
            axisZ = z;
            now = along(x, y, z);
        }
        if (!(now > 0)) {
            now = apartBy();
            take();
        }
        return now > 0 && isHeld(0, now, until, x, y, z, gapAtEnd, MOST_HALVINGS);
    }

    /**
     * Whether they are held apart over a span, or over both of its halves, from the present axis to
     * another one; in the middle by an axis half-way.
     */
    private boolean isHeld(
            double from,
            double d,
            double to,
            double x,
            double y,
            double z,
            double last,
            int halvings) {
        time = from;
        nextX = x;
        nextY = y;
        nextZ = z;
        if (isFree(to - from, d, last)) {
            take();
            return true;
        }
        if (halvings == 0) {
            return false;
        }
        double t = from + 0.5 * (to - from);
        double mx = axisX + x;
        double my = axisY + y;
        double mz = axisZ + z;
        double unit = 1 / Math.sqrt(mx * mx + my * my + mz * mz);
        mx *= unit;
        my *= unit;
        mz *= unit;
        a.move(t);
        b.move(t);
        double mid = along(mx, my, mz);
        return mid > 0
                && isHeld(from, d, t, mx, my, mz, mid, halvings - 1)
                && isHeld(t, mid, to, x, y, z, last, halvings - 1);
    }

    /**
     * Whether two that {@link Reach} fits are held apart by an axis that does not turn, or by one
     * that turns as the first or the second of them does, as the normal of a face: by the second
     * proof above, with support functions in place of distances. Costs a fraction of a search, and
     * decides most pairs that pass each other; see {@link #of}.
     *
     * @param later when it ends, s; it begins at 0
     * @param nx unit axis from a to b, world
     * @param ny see {@code nx}
     * @param nz see {@code nx}
     * @return false says nothing
     */
    public boolean arePassing(double later, double nx, double ny, double nz) {
        time = 0;
        axisX = nx;
        axisY = ny;
        axisZ = nz;
        a.move(0);
        b.move(0);
        double now = along(nx, ny, nz);
        if (!(now > 0)) {
            return false;
        }
        a.move(later);
        b.move(later);
        if (isFreeTo(later, now, nx, ny, nz)) {
            return true;
        }
        for (int side = 0; side < 2; side++) {
            Flight f = side == 0 ? a : b;
            if (f.spin > 0) {
                f.turned(nx, ny, nz, next);
                if (isFreeTo(later, now, next[0], next[1], next[2])) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Whether nothing meets until they lie as now, while the axis turns to another one. */
    private boolean isFreeTo(double later, double d, double nx, double ny, double nz) {
        nextX = nx;
        nextY = ny;
        nextZ = nz;
        double last = along(nx, ny, nz);
        return last > 0 && isFree(later, d, last);
    }

    /** How much farther apart than met they are along an axis, as they lie, at least. */
    private double along(double nx, double ny, double nz) {
        return supports.along(a, b, apartX(), apartY(), apartZ(), nx, ny, nz) - met;
    }

    private boolean search(double nearby) {
        double d = look(time);
        take();
        double slope = closing();
        double boldness = 1;
        double most = Double.POSITIVE_INFINITY;
        double failed = Double.NaN;
        for (int step = 1; d > 0; step++) {
            double closing = closing();
            double safe = d / closing;
            if (!(closing > 0) || time + safe > until) {
                return false;
            }
            if (step > mostSteps && d <= nearby) {
                capped = true;
                return true;
            }
            if (step > mostInAll) {
                isUndecided = true;
                return false;
            }
            double span = Math.min(trial(d, slope, bend() / boldness), most);
            double next = Math.min(time + span, until);
            if (next == failed) {
                // it would most likely fail again
                next = time + 0.5 * (failed - time);
            }
            boolean isSafe = !(next > time + safe);
            next = isSafe ? time + safe : next;
            span = next - time;
            if (time + safe == time) {
                // as near as rounding can tell
                return true;
            }
            double there = look(next);
            double fall = (d - there) / span;
            if (isSafe || (there > 0 && isFree(span, d, there))) {
                slope = fall;
                boldness = Math.min(4 * boldness, MOST_BOLD);
                most = most > span ? most - span : Double.POSITIVE_INFINITY;
                time = next;
                d = there;
                take();
            } else {
                slope = Math.max(slope, fall);
                boldness = Math.max(boldness / 16, 1);
                failed = next;
                most = there > 0 ? 0.5 * span : 0.9375 * d / fall;
            }
        }
        return true;
    }

    /**
     * After a meeting: the first time from there on at which they are apart again. While they
     * overlap by a depth d they cannot part before d/c; near the end of it, it goes on by a small
     * part of their size.
     *
     * @return s; beyond the end when they are not
     */
    public double leave() {
        double most = fastest();
        double least = SHORT * scale / most;
        for (double t = time + least; t <= until; ) {
            double d = look(t);
            if (d > 0) {
                return t;
            }
            t = Math.max(t + Math.max(-d / most, least), Math.nextUp(t));
        }
        return Double.POSITIVE_INFINITY;
    }

    /**
     * How fast any two points of them pass each other at most, m/s.
     *
     * @return a bound for the whole of the span
     */
    public double fastest() {
        double x = a.vx - b.vx;
        double y = a.vy - b.vy;
        double z = a.vz - b.vz;
        return Math.sqrt(x * x + y * y + z * z) + bend() * until + a.rim() + b.rim();
    }

    /**
     * How much farther apart than met the two of the last search are at a time; negative while they
     * overlap.
     *
     * @param t s
     * @return m
     */
    public double gap(double t) {
        return look(t);
    }

    /** From a's centre to b's, where they were left; world, m. */
    public double apartX() {
        return apartX + b.x - a.x;
    }

    /** See {@link #apartX}. */
    public double apartY() {
        return apartY + b.y - a.y;
    }

    /** See {@link #apartX}. */
    public double apartZ() {
        return apartZ + b.z - a.z;
    }

    /** How much farther apart than met they are at a time. */
    private double look(double t) {
        a.move(t);
        b.move(t);
        return seen(
                narrowPhase.distance(
                        a.shape, b.shape, a.qx, a.qy, a.qz, a.qw, b.qx, b.qy, b.qz, b.qw, apartX(),
                        apartY(), apartZ()));
    }

    /** The same, at least, as they lie. */
    private double apartBy() {
        return seen(
                narrowPhase.apartBy(
                        a.shape, b.shape, a.qx, a.qy, a.qz, a.qw, b.qx, b.qy, b.qz, b.qw, apartX(),
                        apartY(), apartZ()));
    }

    private double seen(double d) {
        nextX = narrowPhase.axisX();
        nextY = narrowPhase.axisY();
        nextZ = narrowPhase.axisZ();
        double moved =
                Math.abs(a.x) + Math.abs(a.y) + Math.abs(a.z) + Math.abs(b.x) + Math.abs(b.y);
        return d - met - ROUNDING * (moved + Math.abs(b.z));
    }

    private void take() {
        axisX = nextX;
        axisY = nextY;
        axisZ = nextZ;
    }

    /** The speed c at which they close along the axis at most, until the end. */
    private double closing() {
        double now = centres(axisX, axisY, axisZ, time);
        double last = centres(axisX, axisY, axisZ, until);
        return Math.max(now, last) + turning(axisX, axisY, axisZ);
    }

    /** n . (vA - vB) at a time. */
    private double centres(double nx, double ny, double nz, double t) {
        return nx * (a.vx + t * a.ax - b.vx - t * b.ax)
                + ny * (a.vy + t * a.ay - b.vy - t * b.ay)
                + nz * (a.vz + t * a.az - b.vz - t * b.az);
    }

    private double turning(double nx, double ny, double nz) {
        return a.turning(nx, ny, nz) + b.turning(nx, ny, nz);
    }

    /** |aB - aA| + (|wA|² + |dwA/dt|) RA + (|wB|² + |dwB/dt|) RB. */
    private double bend() {
        double x = b.ax - a.ax;
        double y = b.ay - a.ay;
        double z = b.az - a.az;
        return Math.sqrt(x * x + y * y + z * z)
                + (a.spin * a.spin + a.swingRate) * a.radius
                + (b.spin * b.spin + b.swingRate) * b.radius;
    }

    /** The span after which d - s t - K/2 t² is 0. */
    private static double trial(double d, double s, double k) {
        return 2 * d / (s + Math.sqrt(s * s + 2 * k * d));
    }

    /** Whether the lower bound of all gaps stays above 0 over a span. */
    private boolean isFree(double h, double d0, double d1) {
        double mx = nextX - axisX;
        double my = nextY - axisY;
        double mz = nextZ - axisZ;
        double across =
                Math.max(
                        Math.abs(centres(mx, my, mz, time)),
                        Math.abs(centres(mx, my, mz, time + h)));
        double k = bend() + 2 / h * (across + turning(mx, my, mz));
        // least at
        double t = 0.5 * h - (d1 - d0) / (h * k);
        return !(t > 0 && t < h) || 0.5 * k * t * t < d0;
    }
}
