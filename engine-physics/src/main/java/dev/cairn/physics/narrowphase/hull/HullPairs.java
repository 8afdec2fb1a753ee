package dev.cairn.physics.narrowphase.hull;

import dev.cairn.physics.narrowphase.clip.ContactPoints;
import dev.cairn.physics.narrowphase.gjk.Epa;
import dev.cairn.physics.narrowphase.gjk.Gjk;
import dev.cairn.physics.narrowphase.pair.Axes;
import dev.cairn.physics.narrowphase.pair.ContactTolerances;
import dev.cairn.physics.narrowphase.pair.FeatureIds;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.narrowphase.pair.Pair;
import dev.cairn.physics.narrowphase.pair.WarmStartKey;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.Shape;

/**
 * The contact of two polyhedra: what separates or carries them, by the fifteen axes, by {@link Gjk}
 * and {@link Epa}, or, where the features of the last tick will do, by {@link WarmContact}; then a
 * face contact or a point.
 */
public final class HullPairs {
    public static final long[] NOTHING = {};

    private static final double NONE = Double.POSITIVE_INFINITY;

    private final boolean specialised;
    private final Pair pair;
    private final Gjk gjk;
    private final Axes axes;
    private final ContactPoints points;
    private final WarmContact warm;
    private final HullAxis search;

    /** GJK has run for this pair. */
    private boolean iterated;

    /** By how much the signed distance may be larger than the best axis tells, m. */
    private double gap;

    /** Along the best face that was weighed, m; {@link #NONE} when that alone did not decide. */
    private double rival;

    /** That face is on B. */
    private boolean rivalOnB;

    /** See {@code NarrowPhase.leftOut}. */
    public double leftOut;

    public HullPairs(
            boolean specialised, Pair pair, Gjk gjk, Epa epa, Axes axes, ContactPoints points) {
        this.specialised = specialised;
        this.pair = pair;
        this.gjk = gjk;
        this.axes = axes;
        this.points = points;
        this.search = new HullAxis(pair, gjk, epa, axes, points, specialised);
        this.warm = new WarmContact(pair, axes, points, search);
    }

    /** See {@code NarrowPhase.distance}; leaves the axis in {@link ContactPoints}. */
    public double distance(Shape a, Shape b, long cache) {
        search.gap = 0;
        return search.distance(a, b, cache);
    }

    /** See {@code NarrowPhase.apartBy}; leaves the axis in {@link ContactPoints}. */
    public double apartBy() {
        return search.apartBy();
    }

    /** What to pass to the next {@link #distance}. */
    public long distanceKey() {
        return search.key;
    }

    /**
     * Whether the last pair took what was proven at another pose, see {@link DistanceCertificate}.
     */
    public boolean proven() {
        return warm.proven;
    }

    private double rounding() {
        return 0x1p-48 * pair.scale;
    }

    /** See {@code NarrowPhase.collide}. */
    public long collide(
            Shape a, Shape b, double margin, long cache, long[] memory, int at, Manifold out) {
        gap = 0;
        iterated = false;
        leftOut = Double.NaN;
        // Else a pair that stays apart would remember the vertex of whatever was collided before
        // it.
        points.incidentVertex = 0;
        boolean hulls = specialised && !(a instanceof Box && b instanceof Box);
        boolean remembers = hulls && memory.length > 0;
        search.remember(remembers ? memory : NOTHING, at);
        if (hulls && cache != 0) {
            long crossing = remembers ? memory[at + PairMemory.CROSSING] : 0;
            if (remembers) {
                warm.certificate.recall(
                        pair,
                        memory,
                        at + PairMemory.CERTIFICATE,
                        ContactTolerances.HYSTERESIS * pair.inner);
            } else {
                warm.certificate.none();
            }
            long key = warm.collide(margin, cache, crossing, out);
            if (warm.done) {
                boolean apart = out.pointCount == 0;
                if (remembers && !warm.proven) {
                    memory[at + PairMemory.CROSSING] = 0;
                    if (!apart) {
                        keep(memory, at, warm.separation, warm.upper, NONE);
                    }
                }
                leftOut = apart ? warm.separation : leftOut(key);
                return key;
            }
        } else {
            warm.forget();
            if (stillApart(cache, margin)) {
                return cache;
            }
        }
        if (warm.certain) {
            gap = warm.gap;
        } else {
            search.gap = 0;
            search.find(a, b, warm.axisX, warm.axisY, warm.axisZ, margin);
            iterated = search.general;
            gap = search.gap;
        }
        if (remembers) {
            memory[at + PairMemory.CROSSING] = warm.crossing();
        }
        long key = manifold(margin, cache, out);
        if (remembers && out.pointCount > 0) {
            keep(memory, at, axes.best(), axes.best() + gap, rival);
        }
        if (!hulls || key == 0) {
            return key;
        }
        if (key >>> 62 != WarmStartKey.EDGES) {
            return WarmStartKey.withHint(key, points.incidentVertex);
        }
        boolean crossing = out.feature[0] >>> 30 == FeatureIds.CROSSING >>> 30;
        return crossing
                ? WarmStartKey.withHint(key | (long) axes.edgeA << 47, axes.edgeB)
                : key | WarmStartKey.NO_EDGE << 47;
    }

    /** Keeps what is known of the present pose, see {@link DistanceCertificate}. */
    private void keep(long[] memory, int at, double low, double high, double faces) {
        boolean onB = faces != NONE && rivalOnB;
        int face = faces == NONE ? 0 : onB ? axes.faceB : axes.faceA;
        DistanceCertificate.keep(
                pair, memory, at + PairMemory.CERTIFICATE, low, high, faces, face, onB);
    }

    private double leftOut(long key) {
        return key >>> 62 == WarmStartKey.EDGES ? Double.NaN : points.clipper.leftOut;
    }

    private long manifold(double margin, long cache, Manifold out) {
        double best = axes.best();
        double faces = Math.max(axes.separationA, axes.separationB);
        rival = NONE;
        if (best > margin) {
            leftOut = best;
        }
        if (best > margin && iterated && gjk.beyond) {
            return 0;
        }
        if (best > margin) {
            return key(
                    axes.separationB > axes.separationA ? WarmStartKey.FACE_B : WarmStartKey.FACE_A,
                    0);
        }
        long before = cache >>> 62;
        boolean flip = chooseFace(cache, ContactTolerances.HYSTERESIS * pair.inner);
        rivalOnB = flip;
        if (crosses(flip, best, before == WarmStartKey.EDGES)) {
            out.pointCount = 0;
            out.patch = 0;
            pointContact(margin, best, out);
            if (out.pointCount > 0) {
                rival = faces;
                out.bound = Math.abs(best - out.deepest()) + gap + rounding();
                return key(WarmStartKey.EDGES, FeatureIds.of(out));
            }
            warm.clipped = false;
        }
        boolean clipped =
                warm.clipped && flip == warm.onB && warm.face == (flip ? axes.faceB : axes.faceA);
        if (!clipped) {
            out.pointCount = 0;
            double hysteresis = ContactTolerances.HYSTERESIS * pair.inner;
            if (warm.certain) {
                int v = flip ? axes.vertexOfA : axes.vertexOfB;
                points.face(flip, v, margin, hysteresis, (int) cache, out);
            } else {
                points.face(flip, margin, hysteresis, (int) cache, out);
            }
        }
        long kind = flip ? WarmStartKey.FACE_B : WarmStartKey.FACE_A;
        if (out.pointCount == 0 || strays(out, flip, best, before == WarmStartKey.EDGES)) {
            kind = WarmStartKey.EDGES;
            out.pointCount = 0;
            out.patch = 0;
            pointContact(margin, best, out);
        }
        if (out.pointCount == 0) {
            return key(flip ? WarmStartKey.FACE_B : WarmStartKey.FACE_A, 0);
        }
        rival = kind == WarmStartKey.EDGES ? NONE : faces;
        leftOut = leftOut(kind << 62);
        out.bound = Math.abs(best - out.deepest()) + gap + rounding();
        return key(kind, FeatureIds.of(out));
    }

    /**
     * The reference face: the face of the last tick while it is nearly as good as the best; true
     * when it is B's.
     */
    private boolean chooseFace(long cache, double hysteresis) {
        long before = cache >>> 62;
        int last = (int) (cache >>> 47) & 0x7FFF;
        double enough = Math.max(axes.separationA, axes.separationB) - hysteresis;
        if (before == WarmStartKey.FACE_A && last != axes.faceA && last < pair.a.faceCount()) {
            double s = separationA(last, cache);
            if (s >= enough) {
                axes.faceA = last;
                axes.separationA = s;
                axes.vertexOfB = pair.end;
            }
        }
        if (before == WarmStartKey.FACE_B && last != axes.faceB && last < pair.b.faceCount()) {
            double s = separationB(last, cache);
            if (s >= enough) {
                axes.faceB = last;
                axes.separationB = s;
                axes.vertexOfA = pair.end;
            }
        }
        double bias =
                before == WarmStartKey.FACE_A
                        ? hysteresis
                        : before == WarmStartKey.FACE_B ? -hysteresis : 0x1p-40 * pair.scale;
        return axes.separationB > axes.separationA + bias;
    }

    private double separationA(int face, long cache) {
        int near = WarmStartKey.hint(cache);
        boolean known = warm.certain && near < pair.b.vertexCount();
        return known ? pair.faceSeparationA(face, near) : pair.faceSeparationA(face);
    }

    private double separationB(int face, long cache) {
        int near = WarmStartKey.hint(cache);
        boolean known = warm.certain && near < pair.a.vertexCount();
        return known ? pair.faceSeparationB(face, near) : pair.faceSeparationB(face);
    }

    private long key(long kind, int names) {
        long i =
                kind == WarmStartKey.FACE_A
                        ? axes.faceA
                        : kind == WarmStartKey.FACE_B ? axes.faceB : 0;
        return WarmStartKey.of(kind, i, names);
    }

    /** The face that separated or carried the pair last time separates it now. */
    private boolean stillApart(long cache, double margin) {
        long kind = cache >>> 62;
        int face = (int) (cache >>> 47) & 0x7FFF;
        if (kind == WarmStartKey.FACE_A && face < pair.a.faceCount()) {
            leftOut = pair.faceSeparationA(face);
        } else if (kind == WarmStartKey.FACE_B && face < pair.b.faceCount()) {
            leftOut = pair.faceSeparationB(face);
        }
        boolean apart = leftOut > margin;
        leftOut = apart ? leftOut : Double.NaN;
        return apart;
    }

    /**
     * Whether a point contact along the best axis tells the truth better than the face contact: its
     * points tell another depth, or its axis, which is another direction, separates by much less.
     * Near touching all axes are equally deep, so the depth at the points alone would let a wrong
     * normal pass.
     */
    private boolean strays(Manifold out, boolean flip, double best, boolean before) {
        return Math.abs(out.deepest() - best) > better(best, before) || crosses(flip, best, before);
    }

    /** How much truer a point contact must be. */
    private double better(double best, boolean before) {
        return ContactTolerances.depthError(
                before, ContactTolerances.HYSTERESIS * pair.inner, best);
    }

    /** Whether the best axis is another direction than the face's and separates by much less. */
    private boolean crosses(boolean flip, double best, boolean before) {
        double face = flip ? axes.separationB : axes.separationA;
        if (best - face <= better(best, before)) {
            return false;
        }
        points.faceAxis(flip);
        boolean edge = axes.separationEdge >= axes.separationRaw - rounding();
        double cosine =
                edge
                        ? points.axisX * axes.edgeX
                                + points.axisY * axes.edgeY
                                + points.axisZ * axes.edgeZ
                        : points.axisX * axes.rawX
                                + points.axisY * axes.rawY
                                + points.axisZ * axes.rawZ;
        return cosine <= ContactTolerances.NEARLY_PARALLEL;
    }

    /**
     * One point: two edges that cross, else the nearest points, else the deepest vertex along the
     * best axis.
     */
    private void pointContact(double margin, double best, Manifold out) {
        if (axes.separationEdge >= best - ContactTolerances.HYSTERESIS * pair.inner
                && points.crossing(margin, out)) {
            return;
        }
        if (!iterated) {
            gjk.run(pair, pair.dx, pair.dy, pair.dz, margin);
        }
        if (!gjk.overlap) {
            if (!gjk.beyond && gjk.distance <= margin) {
                points.nearest(out);
            }
            return;
        }
        points.bestAxis();
        int v = pair.supportB(-points.axisX, -points.axisY, -points.axisZ, 0);
        pair.vertexB(v);
        double half = best / 2;
        points.single(
                pair.px - half * points.axisX,
                pair.py - half * points.axisY,
                pair.pz - half * points.axisZ,
                best,
                FeatureIds.VERTEX_B | v,
                out);
    }
}
