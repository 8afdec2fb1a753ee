package dev.cairn.physics.narrowphase;

import dev.cairn.physics.internal.MovedTurn;
import dev.cairn.physics.narrowphase.clip.ContactPoints;
import dev.cairn.physics.narrowphase.curved.CurvedPairs;
import dev.cairn.physics.narrowphase.gjk.Epa;
import dev.cairn.physics.narrowphase.gjk.Gjk;
import dev.cairn.physics.narrowphase.gjk.Witness;
import dev.cairn.physics.narrowphase.hull.HullPairs;
import dev.cairn.physics.narrowphase.pair.Axes;
import dev.cairn.physics.narrowphase.pair.FeatureIds;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.narrowphase.pair.Pair;
import dev.cairn.physics.narrowphase.round.BallAxis;
import dev.cairn.physics.narrowphase.round.BallBox;
import dev.cairn.physics.narrowphase.round.RoundContacts;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Moved;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.Sphere;
import dev.cairn.physics.shape.polyhedron.Polyhedral;

/**
 * Collides pairs of convex shapes: axis by {@link Gjk} and {@link Epa} (or {@link Axes#boxes}),
 * snapped to true features, then a manifold by {@code Clipper}. One instance per worker: it owns
 * all scratch memory and is not thread-safe. Allocates nothing, except when a face has more sides
 * than any before.
 */
public final class NarrowPhase {
    /** How the axis of a pair is found. */
    public enum Method {
        /** GJK and EPA for every pair, whatever the shapes. */
        GENERAL,
        /** The fifteen axes for two boxes, closed forms for balls, the general way for the rest. */
        SPECIALISED
    }

    private final Method method;
    private final Pair pair = new Pair();
    private final Gjk gjk = new Gjk();
    private final Epa epa = new Epa();
    private final Axes axes = new Axes();
    private final ContactPoints points = new ContactPoints(pair, axes, gjk);
    private final HullPairs polyhedra;
    private final BallAxis round = new BallAxis();
    private final RoundContacts rounds = new RoundContacts();
    private final BallBox ballBox = new BallBox();
    private final CurvedPairs curved;
    private final Witness witness = new Witness();

    /** An orientation that a moved shape's own turn was multiplied into. */
    private double tx, ty, tz, tw;

    private boolean curvedLast;
    private long[] memory = HullPairs.NOTHING;
    private int memoryAt;

    /** Creates the scratch of one worker that uses the fast paths. */
    public NarrowPhase() {
        this(Method.SPECIALISED);
    }

    /**
     * Creates the scratch of one worker.
     *
     * @param method how axes are found; the results agree within {@link Manifold#bound}
     */
    public NarrowPhase(Method method) {
        this.method = method;
        this.polyhedra = new HullPairs(method == Method.SPECIALISED, pair, gjk, epa, axes, points);
        this.curved = new CurvedPairs(pair, gjk, epa, points, method == Method.SPECIALISED);
    }

    /**
     * Creates the scratch of one worker whose iterations end early, to weigh time against error.
     * The axis that they end with is still snapped to true features.
     *
     * @param tolerance relative gap at which an iteration ends, at least 0; finer than the default
     *     counts as the default
     * @param iterations cap of each iteration, at least 1; more than the default counts as the
     *     default
     */
    public NarrowPhase(Method method, double tolerance, int iterations) {
        this(method);
        gjk.tolerance = Math.max(Gjk.TOLERANCE, tolerance);
        epa.relativeTolerance = Math.max(Epa.TOLERANCE, tolerance);
        gjk.cap = Math.min(Gjk.CAP, iterations);
        epa.cap = Math.min(epa.cap, iterations);
    }

    /** Whether the last call met an iteration cap, so that a better axis may exist. */
    public boolean capped() {
        return curvedLast ? curved.capped : round.capped || gjk.capped || epa.capped;
    }

    /**
     * Steps of GJK, and then of the expanding polytope, in the last call for a pair that needed
     * them; what ran before counts when the last call did without.
     */
    public int iterations() {
        return gjk.iterations + epa.iterations;
    }

    /** Forgets the steps of earlier calls, see {@link #iterations}. */
    public void forgetIterations() {
        gjk.iterations = 0;
        epa.iterations = 0;
    }

    /**
     * The axis of the last {@link #distance} call: a unit vector from A to B along which the signed
     * distance was measured; its x component, world axes.
     */
    public double axisX() {
        return points.worldX();
    }

    /** See {@link #axisX}; the y component, world axes. */
    public double axisY() {
        return points.worldY();
    }

    /** See {@link #axisX}; the z component, world axes. */
    public double axisZ() {
        return points.worldZ();
    }

    /**
     * Hands the next {@link #collide} what an earlier one for the pair left beside the key.
     *
     * @param pairs a {@code PairMemory}, zeros at first; rewritten
     */
    public void remember(long[] pairs, int at) {
        memory = pairs;
        memoryAt = at;
    }

    /**
     * Finds the contact of a pair.
     *
     * @param qAx orientation of A, world from body, unit quaternion
     * @param qBx orientation of B, world from body, unit quaternion
     * @param dx centre of mass of B minus that of A, world axes, m
     * @param margin points up to this far apart are reported, m, not negative
     * @param cache the key that the last call for this pair in this order returned; 0 if there is
     *     none
     * @return the key to pass next time
     */
    public long collide(
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
            long cache,
            Manifold out) {
        long[] kept = memory;
        memory = HullPairs.NOTHING;
        if (method == Method.SPECIALISED && RoundContacts.fits(a) && RoundContacts.fits(b)) {
            boolean done =
                    rounds.collide(
                            a, b, qAx, qAy, qAz, qAw, qBx, qBy, qBz, qBw, dx, dy, dz, margin, out);
            if (done || rounds.sideBySide(a, b, dx, dy, dz, margin, cache, out)) {
                exact();
                return rounds.key();
            }
        }
        if (method == Method.SPECIALISED
                && (a instanceof Sphere || b instanceof Sphere)
                && ballBox.collide(
                        a, b, qAx, qAy, qAz, qAw, qBx, qBy, qBz, qBw, dx, dy, dz, margin, out)) {
            exact();
            return 0;
        }
        if (a instanceof Moved m) {
            turn(qAx, qAy, qAz, qAw, m);
            return collide(
                    m.inner(), b, tx, ty, tz, tw, qBx, qBy, qBz, qBw, dx, dy, dz, margin, cache,
                    out);
        }
        if (b instanceof Moved m) {
            turn(qBx, qBy, qBz, qBw, m);
            return collide(
                    a, m.inner(), qAx, qAy, qAz, qAw, tx, ty, tz, tw, dx, dy, dz, margin, cache,
                    out);
        }
        if (!(plain(a) && plain(b))) {
            curvedLast = true;
            return curved.collide(
                    a, b, qAx, qAy, qAz, qAw, qBx, qBy, qBz, qBw, dx, dy, dz, margin, cache, out);
        }
        begin(a, b, qAx, qAy, qAz, qAw, qBx, qBy, qBz, qBw, dx, dy, dz);
        out.pointCount = 0;
        out.patch = 0;
        out.bound = 0;
        boolean ball = pair.roundA || pair.roundB;
        long key =
                ball
                        ? ball(a, b, margin, out)
                        : polyhedra.collide(a, b, margin, cache, kept, memoryAt, out);
        out.capped = capped();
        return key;
    }

    /**
     * Whether the last pair of hulls took what was proven at another pose, see {@code
     * DistanceCertificate}.
     */
    boolean proven() {
        return polyhedra.proven();
    }

    /**
     * How much nearer a pair of boxes or hulls must come for another point; after {@link #collide}.
     * Returns the least separation of the points that were left out for the margin, m; infinite
     * when there are none; of a pair that is apart a lower bound of its distance; NaN when it is
     * neither apart nor on a face.
     */
    public double leftOut() {
        return polyhedra.leftOut;
    }

    /**
     * The signed distance of two shapes, which are given as to {@link #collide}: how far apart they
     * are, or minus the length of the shortest move that separates them; m.
     */
    public double distance(
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
            double dz) {
        return distance(a, b, qAx, qAy, qAz, qAw, qBx, qBy, qBz, qBw, dx, dy, dz, 0);
    }

    /**
     * As {@link #distance}, from what the last call for this pair in this order left: of shapes
     * that are apart and have moved little, a fraction of the time.
     *
     * @param cache {@link #distanceKey} after the last call; 0 if there is none. A stale or random
     *     key costs time, never correctness
     */
    public double distance(
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
            long cache) {
        if (a instanceof Moved m) {
            turn(qAx, qAy, qAz, qAw, m);
            return distance(m.inner(), b, tx, ty, tz, tw, qBx, qBy, qBz, qBw, dx, dy, dz);
        }
        if (b instanceof Moved m) {
            turn(qBx, qBy, qBz, qBw, m);
            return distance(a, m.inner(), qAx, qAy, qAz, qAw, tx, ty, tz, tw, dx, dy, dz);
        }
        if (!(plain(a) && plain(b))) {
            curvedLast = true;
            return curved.distance(a, b, qAx, qAy, qAz, qAw, qBx, qBy, qBz, qBw, dx, dy, dz);
        }
        begin(a, b, qAx, qAy, qAz, qAw, qBx, qBy, qBz, qBw, dx, dy, dz);
        if (pair.roundA || pair.roundB) {
            round.run(pair, a, b, method == Method.SPECIALISED, gjk, Double.MAX_VALUE);
            points.setAxis(round.axisX, round.axisY, round.axisZ);
            return round.distance - pair.radiusA - pair.radiusB;
        }
        return polyhedra.distance(a, b, cache);
    }

    /**
     * A lower bound of the distance of two shapes that are apart, by an axis that is told as of
     * {@link #distance}: of boxes and hulls that nearly touch, at a fraction of the cost.
     *
     * @return m; where it is not above 0 they may be apart or not
     */
    public double apartBy(
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
            double dz) {
        if (a instanceof Polyhedral && b instanceof Polyhedral) {
            begin(a, b, qAx, qAy, qAz, qAw, qBx, qBy, qBz, qBw, dx, dy, dz);
            return polyhedra.apartBy();
        }
        return distance(a, b, qAx, qAy, qAz, qAw, qBx, qBy, qBz, qBw, dx, dy, dz);
    }

    /**
     * The nearest features of the last {@link #distance} of two boxes or hulls, to pass to the next
     * call for the pair; 0 when there is nothing to pass.
     */
    public long distanceKey() {
        return polyhedra.distanceKey();
    }

    /**
     * The nearest points of two shapes.
     *
     * @param out receives one point, midway between the nearest points, its separation, and the
     *     normal along which that is measured
     * @return the signed distance, m, as {@link #distance} tells it
     */
    public double closest(
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
            Manifold out) {
        double d = distance(a, b, qAx, qAy, qAz, qAw, qBx, qBy, qBz, qBw, dx, dy, dz);
        out.capped = capped();
        if (curvedLast && curved.witnessOfPlane(d, out)) {
            return d;
        }
        witness.find(pair, points.axisX, points.axisY, points.axisZ, d);
        points.single(witness.x, witness.y, witness.z, d, FeatureIds.CLOSEST, out);
        return d;
    }

    /** Final classes, so this is up to three comparisons, most often one. */
    private static boolean plain(Shape shape) {
        return shape instanceof Box || shape instanceof ConvexHull || shape instanceof Sphere;
    }

    private void turn(double qx, double qy, double qz, double qw, Moved m) {
        tx = MovedTurn.x(m, qx, qy, qz, qw);
        ty = MovedTurn.y(m, qx, qy, qz, qw);
        tz = MovedTurn.z(m, qx, qy, qz, qw);
        tw = MovedTurn.w(m, qx, qy, qz, qw);
    }

    private void begin(
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
            double dz) {
        pair.set(a, b, qAx, qAy, qAz, qAw, qBx, qBy, qBz, qBw, dx, dy, dz);
        exact();
    }

    /** No cap was met yet. */
    private void exact() {
        round.capped = false;
        curvedLast = false;
        gjk.capped = false;
        epa.capped = false;
    }

    /**
     * A ball touches at one point, whose name never changes, so that rolling over an edge keeps the
     * impulse.
     */
    private long ball(Shape a, Shape b, double margin, Manifold out) {
        double radii = pair.radiusA + pair.radiusB;
        round.run(pair, a, b, method == Method.SPECIALISED, gjk, margin + radii);
        double separation = round.distance - radii;
        if (separation <= margin) {
            points.setAxis(round.axisX, round.axisY, round.axisZ);
            double half = separation / 2;
            double along = pair.roundA ? pair.radiusA + half : -(pair.radiusB + half);
            double bx = pair.roundA ? 0 : pair.dx;
            double by = pair.roundA ? 0 : pair.dy;
            double bz = pair.roundA ? 0 : pair.dz;
            points.single(
                    bx + along * points.axisX,
                    by + along * points.axisY,
                    bz + along * points.axisZ,
                    separation,
                    FeatureIds.CLOSEST,
                    out);
            out.bound = 0x1p-48 * pair.scale;
        }
        return 0;
    }
}
