package dev.cairn.physics.internal;

import dev.cairn.core.state.StateCodec;

import java.util.Arrays;

/**
 * A smooth curve through points: the cubic spline with continuous second derivatives, open with
 * straight ends ("natural") or closed. Its parameter w is the length of the chords from the first
 * point on. An open one goes on straight beyond its ends, a closed one round and round: w grows
 * with each lap. Two points are a straight line, exactly.
 *
 * <p>On chord i of length h, with second derivatives m at its ends and t from 0 to h,
 *
 * <pre>
 * r = p + t ((p' - p)/h - h (2 m + m')/6) + t² m/2 + t³ (m' - m)/(6 h)
 * </pre>
 *
 * <p>and the slopes meet at each point where {@code h m + 2 (h + h') m' + h' m" = 6 ((p" - p')/h' -
 * (p' - p)/h)}, a tridiagonal system. Lengths are sums by the rule of Gauss and Legendre with eight
 * points to a chord.
 *
 * <p>Source: C. de Boor, "A Practical Guide to Splines" (1978), IV. Immutable; the methods that a
 * step calls are made of arithmetic and square roots and do not allocate.
 */
public final class Curve {
    /** Numbers that {@link #at} writes: place, first and second derivative by w. */
    public static final int AT = 9;

    /** Numbers to a chord: of each power of t three. */
    private static final int CHORD = 12;

    private static final int ROUNDS = 24;
    private static final double NEAR = 1e-9;

    /** Places to a chord at which the search for the nearest point begins. */
    private static final int STARTS = 8;

    /** Abscissas and weights of the rule on (-1, 1). */
    private static final double[] NODE = {
        0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363
    };

    private static final double[] WEIGHT = {
        0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763
    };

    /** How such a curve becomes bytes. */
    public static final StateCodec<Curve> CODEC =
            StateCodec.of(
                    Curve.class,
                    "jointCurve",
                    (curve, out) -> {
                        out.writeInt(curve.isClosed ? 1 : 0);
                        out.writeDoubles(curve.points);
                    },
                    in -> new Curve(in.readInt() == 1, in.readDoubles()));

    private final double[] points;
    private final boolean isClosed;
    private final int chords;
    private final double[] coefficient;

    /** By point: w, and the length of the curve up to it; one more for the end. */
    private final double[] knot;

    private final double[] sum;

    /**
     * A curve.
     *
     * @param isClosed whether it comes back to its first point
     * @param points x, y, z of each, m, finite; at least two of them, three if closed; neighbours
     *     apart
     */
    public Curve(boolean isClosed, double[] points) {
        int n = points.length / 3;
        if (points.length % 3 != 0 || n < (isClosed ? 3 : 2)) {
            throw new IllegalArgumentException(
                    "a "
                            + (isClosed ? "closed" : "open")
                            + " path has "
                            + points.length
                            + " numbers; give x, y, z of at least "
                            + (isClosed ? "three" : "two")
                            + " points");
        }
        for (int i = 0; i < points.length; i++) {
            Checks.finite("number " + i + " of the path's points", points[i]);
        }
        this.isClosed = isClosed;
        this.points = points.clone();
        chords = isClosed ? n : n - 1;
        knot = new double[chords + 1];
        coefficient = new double[CHORD * chords];
        sum = new double[chords + 1];
        for (int i = 0; i < chords; i++) {
            double h = chord(i);
            if (!(h > 1e-9)) {
                throw new IllegalArgumentException(
                        "points "
                                + i
                                + " and "
                                + (i + 1) % n
                                + " of a path are one place; leave one of them out");
            }
            knot[i + 1] = knot[i] + h;
        }
        for (int axis = 0; axis < 3; axis++) {
            fill(axis, isClosed ? closed(axis) : open(axis));
        }
        for (int i = 0; i < chords; i++) {
            sum[i + 1] = sum[i] + part(i, knot[i + 1] - knot[i]);
        }
    }

    // Making --------------------------------------------------------------------------------------

    private double point(int i, int axis) {
        return points[3 * (i % (points.length / 3)) + axis];
    }

    private double chord(int i) {
        double x = point(i + 1, 0) - point(i, 0);
        double y = point(i + 1, 1) - point(i, 1);
        double z = point(i + 1, 2) - point(i, 2);
        return Math.sqrt(x * x + y * y + z * z);
    }

    private double width(int i) {
        int k = (i + chords) % chords;
        return knot[k + 1] - knot[k];
    }

    /** Right-hand side at a point between two chords. */
    private double bend(int i, int axis) {
        int before = (i - 1 + chords) % chords;
        return 6
                * ((point(i + 1, axis) - point(i, axis)) / width(i)
                        - (point(before + 1, axis) - point(before, axis)) / width(before));
    }

    /** Second derivatives by one coordinate: 0 at both ends. */
    private double[] open(int axis) {
        double[] m = new double[chords + 1];
        double[] upper = new double[chords];
        for (int i = 1; i < chords; i++) {
            double pivot = 2 * (width(i - 1) + width(i)) - width(i - 1) * upper[i - 1];
            upper[i] = width(i) / pivot;
            m[i] = (bend(i, axis) - width(i - 1) * m[i - 1]) / pivot;
        }
        for (int i = chords - 1; i > 0; i--) {
            m[i] -= upper[i] * m[i + 1];
        }
        return m;
    }

    /**
     * The same of a closed curve: the matrix is {@code T + u v^T} with the two corners in u and v,
     * so {@code m = y - z (v y)/(1 + v z)} with {@code T y = b} and {@code T z = u} (Sherman and
     * Morrison).
     */
    private double[] closed(int axis) {
        int n = chords;
        double corner = width(n - 1);
        double[] first = new double[n];
        double[] y = new double[n];
        double[] z = new double[n];
        double[] upper = new double[n];
        double gamma = -2 * (width(n - 1) + width(0));
        for (int i = 0; i < n; i++) {
            double diagonal = 2 * (width(i - 1) + width(i));
            diagonal -= i == 0 ? gamma : 0;
            diagonal -= i == n - 1 ? corner * corner / gamma : 0;
            double below = i == 0 ? 0 : width(i - 1);
            first[i] = i == 0 ? gamma : i == n - 1 ? corner : 0;
            double pivot = diagonal - (i == 0 ? 0 : below * upper[i - 1]);
            upper[i] = width(i) / pivot;
            y[i] = (bend(i, axis) - (i == 0 ? 0 : below * y[i - 1])) / pivot;
            z[i] = (first[i] - (i == 0 ? 0 : below * z[i - 1])) / pivot;
        }
        for (int i = n - 2; i >= 0; i--) {
            y[i] -= upper[i] * y[i + 1];
            z[i] -= upper[i] * z[i + 1];
        }
        double share = (y[0] + corner / gamma * y[n - 1]) / (1 + z[0] + corner / gamma * z[n - 1]);
        double[] m = new double[n + 1];
        for (int i = 0; i < n; i++) {
            m[i] = y[i] - share * z[i];
        }
        m[n] = m[0];
        return m;
    }

    private void fill(int axis, double[] m) {
        for (int i = 0; i < chords; i++) {
            double h = width(i);
            double p = point(i, axis);
            int at = CHORD * i + axis;
            coefficient[at] = p;
            coefficient[at + 3] = (point(i + 1, axis) - p) / h - h * (2 * m[i] + m[i + 1]) / 6;
            coefficient[at + 6] = 0.5 * m[i];
            coefficient[at + 9] = (m[i + 1] - m[i]) / (6 * h);
        }
    }

    // Asking --------------------------------------------------------------------------------------

    /** Whether it comes back to its first point. */
    public boolean isClosed() {
        return isClosed;
    }

    /** A copy of the points, three numbers each. */
    public double[] points() {
        return points.clone();
    }

    /** Its length, of a closed one that of a lap, m. */
    public double length() {
        return sum[chords];
    }

    /**
     * The parameter of a point of the curve.
     *
     * @param share 0 for the first point, 1 for the last one, of a closed curve the first again
     */
    public double parameter(double share) {
        return share * whole();
    }

    /** The parameter of the end, of a closed curve that of a lap. */
    private double whole() {
        return knot[chords];
    }

    private double laps(double w) {
        return isClosed ? Math.floor(w / whole()) : 0;
    }

    /** The chord of a parameter that is within one lap. */
    private int chordOf(double w) {
        int low = 0;
        int high = chords;
        while (high - low > 1) {
            int middle = (low + high) >>> 1;
            if (knot[middle] <= w) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return low;
    }

    /**
     * Place and derivatives.
     *
     * @param w any
     * @param into receives {@link #AT} numbers
     */
    public void at(double w, double[] into) {
        double v = w - laps(w) * whole();
        double beyond = isClosed ? 0 : v < 0 ? v : v > whole() ? v - whole() : 0;
        v -= beyond;
        int i = chordOf(v);
        double t = v - knot[i];
        for (int axis = 0; axis < 3; axis++) {
            int c = CHORD * i + axis;
            double b = coefficient[c + 3];
            double q = coefficient[c + 6];
            double d = coefficient[c + 9];
            into[axis] = coefficient[c] + t * (b + t * (q + t * d));
            into[3 + axis] = b + t * (2 * q + 3 * t * d);
            into[6 + axis] = 2 * q + 6 * t * d;
            if (beyond != 0) {
                into[axis] += beyond * into[3 + axis];
                into[6 + axis] = 0;
            }
        }
    }

    /** Length of the curve from its first point to a parameter, laps included; negative before. */
    public double along(double w) {
        double laps = laps(w);
        double v = w - laps * whole();
        double inside = isClosed ? v : Math.max(0, Math.min(whole(), v));
        int i = chordOf(inside);
        double straight = v - inside;
        double slope = straight == 0 ? 0 : speed(straight < 0 ? 0 : chords - 1, inside - knot[i]);
        return laps * length() + sum[i] + part(i, inside - knot[i]) + straight * slope;
    }

    /** {@code |r'|} on a chord. */
    private double speed(int i, double t) {
        double square = 0;
        for (int axis = 0; axis < 3; axis++) {
            int c = CHORD * i + axis;
            double v =
                    coefficient[c + 3] + t * (2 * coefficient[c + 6] + 3 * t * coefficient[c + 9]);
            square += v * v;
        }
        return Math.sqrt(square);
    }

    /** Length of the first part of a chord. */
    private double part(int i, double t) {
        double half = 0.5 * t;
        double total = 0;
        for (int k = 0; k < NODE.length; k++) {
            double off = half * NODE[k];
            total += WEIGHT[k] * (speed(i, half - off) + speed(i, half + off));
        }
        return half * total;
    }

    /**
     * The point of the curve that is nearest to another one, as far as it is near to where it was:
     * where {@code (r - p) r' = 0}, by Newton's method.
     *
     * @param w where it was
     * @param room for {@link #AT} numbers; holds place and derivatives of the answer
     * @return its parameter
     */
    public double follow(double x, double y, double z, double w, double[] room) {
        double now = w;
        double most = 0.25 * whole();
        for (int round = 0; ; round++) {
            at(now, room);
            double gx = room[0] - x;
            double gy = room[1] - y;
            double gz = room[2] - z;
            double f = gx * room[3] + gy * room[4] + gz * room[5];
            double square = room[3] * room[3] + room[4] * room[4] + room[5] * room[5];
            double slope = square + gx * room[6] + gy * room[7] + gz * room[8];
            // far from the curve the slope may vanish; then a shorter step
            double step = f / (slope > 0.25 * square ? slope : square);
            now -= Math.max(-most, Math.min(most, step));
            if (!(Math.abs(step) > NEAR * whole()) || round == ROUNDS) {
                at(now, room); // the step squares what was missing
                return now;
            }
        }
    }

    /** The parameter of the nearest point, wherever it is; of a closed curve in its first lap. */
    public double nearest(double x, double y, double z) {
        double[] room = new double[AT];
        double best = 0;
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k <= STARTS * chords; k++) {
            int i = Math.min(k / STARTS, chords - 1);
            double w = knot[i] + (k - STARTS * i) * width(i) / STARTS;
            at(w, room);
            double gx = room[0] - x;
            double gy = room[1] - y;
            double gz = room[2] - z;
            double distance = gx * gx + gy * gy + gz * gz;
            if (distance < least) {
                least = distance;
                best = w;
            }
        }
        double w = follow(x, y, z, best, room);
        return isClosed ? w - laps(w) * whole() : Math.max(0, Math.min(whole(), w));
    }

    @Override
    public String toString() {
        return (isClosed ? "closed" : "open") + " path of " + Arrays.toString(points);
    }
}
