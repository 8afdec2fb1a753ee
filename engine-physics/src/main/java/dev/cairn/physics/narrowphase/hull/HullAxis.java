package dev.cairn.physics.narrowphase.hull;

import dev.cairn.physics.narrowphase.axis.AxisAscent;
import dev.cairn.physics.narrowphase.axis.AxisRefinement;
import dev.cairn.physics.narrowphase.clip.ContactPoints;
import dev.cairn.physics.narrowphase.gjk.Epa;
import dev.cairn.physics.narrowphase.gjk.Gjk;
import dev.cairn.physics.narrowphase.gjk.NearestFeatures;
import dev.cairn.physics.narrowphase.gjk.Polytope;
import dev.cairn.physics.narrowphase.pair.Axes;
import dev.cairn.physics.narrowphase.pair.Pair;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Shape;

/**
 * The axis and the signed distance of two polyhedra: by the fifteen axes of boxes, or by {@link
 * Gjk} and {@link Epa}, snapped to true features.
 */
public final class HullAxis {
    /** Cosine of the angle, 1e-6 rad, between axes that are one up to rounding. */
    private static final double SAME_AXIS = 1 - 0x1p-41;

    /** Of the pair's scale: nearer than this GJK's direction loses digits that can be regained. */
    private static final double NEAR = 0x1p-10;

    /** Of the pair's scale: a gap between the bounds that the axis may be to blame for. */
    private static final double DOUBT = 0x1p-47;

    /** Of the pair's scale: separations this close are one. */
    private static final double ROUNDING = 0x1p-51;

    /** The last axes were found by iteration. */
    public boolean general;

    /** By how much the signed distance may be larger, m. */
    double gap;

    /** The vertices that are nearest, for the next distance of the pair; 0 when it is not apart. */
    long key;

    /** Where the polytope of the pair is kept between ticks, see {@link #remember}. */
    private long[] memory = {};

    private int at;

    /** 1 when the kept polytope holds the origin, -1 when it does not, 0 when that is not known. */
    private int recalled;

    private final Pair pair;
    private final Gjk gjk;
    private final Epa epa;
    private final Axes axes;
    private final ContactPoints points;
    private final boolean fifteen;
    private final AxisRefinement refinement = new AxisRefinement();
    private final AxisAscent ascent = new AxisAscent(refinement);
    private final NearestFeatures nearest = new NearestFeatures();
    private final double[] tried = new double[3 * 16];

    public HullAxis(Pair pair, Gjk gjk, Epa epa, Axes axes, ContactPoints points, boolean fifteen) {
        this.pair = pair;
        this.gjk = gjk;
        this.epa = epa;
        this.axes = axes;
        this.points = points;
        this.fifteen = fifteen;
    }

    /**
     * Fills the axes, by iteration or by the fifteen axes.
     *
     * @param sx where the iteration starts: any vector from A towards B, better near the axis
     */
    void find(Shape a, Shape b, double sx, double sy, double sz, double margin) {
        general = !fifteen || !(a instanceof Box && b instanceof Box);
        if (!general) {
            axes.boxes(pair, margin);
            return;
        }
        if (!resume()) {
            gjk.run(pair, sx, sy, sz, margin);
            settle();
        }
        if (memory.length > 0) {
            boolean deep = gjk.overlap && !gjk.beyond && !epa.capped;
            if (deep) {
                epa.save(memory, at);
            } else {
                Polytope.forget(memory, at);
            }
        }
    }

    /** Chooses where the polytope of a pair is kept between ticks; none in an empty array. */
    void remember(long[] keptPolytope, int begin) {
        memory = keptPolytope;
        at = begin;
        recalled = 0;
    }

    /**
     * An upper bound of the signed distance of shapes that overlap, from the polytope of the last
     * search at the present poses; infinite when there is none.
     */
    double upper() {
        if (recalled == 0) {
            recalled = memory.length > 0 && epa.recall(pair, memory, at) ? 1 : -1;
        }
        return recalled > 0 ? -epa.lower : Double.POSITIVE_INFINITY;
    }

    /** Goes on from the polytope of the last search. */
    private boolean resume() {
        if (upper() == Double.POSITIVE_INFINITY || !epa.resume(pair)) {
            epa.capped = false;
            return false;
        }
        gjk.overlap = true;
        gjk.beyond = false;
        gjk.capped = false;
        gjk.iterations = 0;
        deepest();
        return true;
    }

    private void deepest() {
        snapDeepest();
        gap = Math.max(0, -epa.lower - axes.best());
    }

    /** Fills the axes after a run of GJK. */
    private void settle() {
        if (gjk.beyond) {
            axes.clear(gjk.lower);
        } else if (gjk.overlap) {
            epa.run(pair, gjk);
            deepest();
        } else {
            double s = 1 / gjk.distance;
            axes.snap(pair, gjk.vx * s, gjk.vy * s, gjk.vz * s);
            gap = Math.max(0, gjk.distance - axes.best());
        }
    }

    /**
     * The signed distance of the pair; leaves its axis in the points.
     *
     * @param cache the {@link #key} of another pose, or 0
     */
    double distance(Shape a, Shape b, long cache) {
        key = 0;
        general = !fifteen || !(a instanceof Box && b instanceof Box);
        if (general || cache != 0) {
            if (!gjk.runFrom(cache, pair, Double.MAX_VALUE)) {
                gjk.run(pair, pair.dx, pair.dy, pair.dz, Double.MAX_VALUE);
            }
        }
        return distanceAfterRun(general || cache != 0);
    }

    /**
     * A lower bound of the signed distance of the pair, of those that are apart, along the axis
     * that GJK ends with; leaves it in the points. NaN if that tells nothing.
     */
    double apartBy() {
        key = 0;
        gjk.run(pair, pair.dx, pair.dy, pair.dz, Double.MAX_VALUE);
        if (gjk.overlap || !(gjk.distance > 0)) {
            return Double.NaN;
        }
        double s = 1 / gjk.distance;
        points.setAxis(s * gjk.vx, s * gjk.vy, s * gjk.vz);
        return pair.separation(points.axisX, points.axisY, points.axisZ);
    }

    /** The same after GJK has run from anywhere, or has not. */
    public double distanceAfterRun(boolean ran) {
        if (ran) {
            if (!gjk.overlap && !gjk.capped && gjk.distance > NEAR * pair.scale) {
                return apart();
            }
        }
        if (general) {
            settle();
        } else {
            axes.boxes(pair, Double.MAX_VALUE);
        }
        double best = axes.best();
        points.bestAxis();
        if (best <= 0) {
            return best;
        }
        if (!general) {
            gjk.run(pair, pair.dx, pair.dy, pair.dz, Double.MAX_VALUE);
        }
        if (gjk.overlap || gjk.distance <= NEAR * pair.scale) {
            return nearlyTouching(best);
        }
        return apart();
    }

    private double apart() {
        key = gjk.key();
        nearest.measure(pair, gjk);
        points.setAxis(nearest.axisX, nearest.axisY, nearest.axisZ);
        return gjk.distance - gjk.lower > DOUBT * pair.scale ? among() : nearest.distance;
    }

    /**
     * Features that are nearly parallel are equally near up to rounding, and GJK may end on a
     * simplex of others than those that are nearest: all of them compete then.
     */
    private double among() {
        double s = pair.separation(nearest.axisX, nearest.axisY, nearest.axisZ);
        refinement.run(pair, nearest.axisX, nearest.axisY, nearest.axisZ, true);
        if (refinement.separation > s) {
            s = refinement.separation;
            points.setAxis(refinement.axisX, refinement.axisY, refinement.axisZ);
        }
        return s;
    }

    /**
     * Shapes that are apart by so little that the difference of their nearest points has lost
     * digits: all features near the axes known so far compete, as for round shapes, and where what
     * touches along the best of them does not meet, those towards where it would.
     */
    private double nearlyTouching(double best) {
        double most = best;
        refinement.run(pair, points.axisX, points.axisY, points.axisZ);
        for (int i = 0; i < 2; i++) {
            ascent.climb(pair);
            if (refinement.separation > most) {
                most = refinement.separation;
                points.setAxis(refinement.axisX, refinement.axisY, refinement.axisZ);
            }
            if (i == 1 || !(gjk.distance > 0)) {
                break;
            }
            double s = 1 / gjk.distance;
            refinement.run(pair, gjk.vx * s, gjk.vy * s, gjk.vz * s);
        }
        return gjk.overlap ? most : towardsNearest(most);
    }

    /**
     * Axes that turn about the best one lose but the square of the angle, so rounding can't tell
     * which of them leads to where the shapes meet; of those, the nearest features do.
     */
    private double towardsNearest(double best) {
        nearest.measure(pair, gjk);
        double s = pair.separation(nearest.axisX, nearest.axisY, nearest.axisZ);
        if (!(s >= best - ROUNDING * pair.scale)) {
            return best;
        }
        points.setAxis(nearest.axisX, nearest.axisY, nearest.axisZ);
        return s;
    }

    /**
     * Snaps the axis of the polytope, and what rounding cannot tell from it, and keeps the best.
     */
    private void snapDeepest() {
        tried[0] = epa.axisX;
        tried[1] = epa.axisY;
        tried[2] = epa.axisZ;
        axes.snap(pair, epa.axisX, epa.axisY, epa.axisZ, epa.vertexA, epa.vertexB);
        int best = 0;
        int count = 1;
        double most = axes.best();
        while (3 * count < tried.length && epa.another(tried, count, SAME_AXIS)) {
            axes.snap(pair, tried[3 * count], tried[3 * count + 1], tried[3 * count + 2]);
            if (axes.best() > most) {
                most = axes.best();
                best = count;
            }
            count++;
        }
        if (best < count - 1) {
            axes.snap(pair, tried[3 * best], tried[3 * best + 1], tried[3 * best + 2]);
        }
    }
}
