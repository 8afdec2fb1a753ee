package dev.cairn.physics.narrowphase.hull;

import dev.cairn.physics.narrowphase.clip.Clipper;
import dev.cairn.physics.narrowphase.clip.ContactPoints;
import dev.cairn.physics.narrowphase.pair.Axes;
import dev.cairn.physics.narrowphase.pair.ContactTolerances;
import dev.cairn.physics.narrowphase.pair.Containment;
import dev.cairn.physics.narrowphase.pair.FeatureIds;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.narrowphase.pair.Pair;
import dev.cairn.physics.narrowphase.pair.WarmStartKey;
import dev.cairn.physics.shape.polyhedron.Polyhedron;

/**
 * The contact of two polyhedra on the features of the last tick, certified. A face of one shape, or
 * two edges, gives a separation s, which is a lower bound of the signed distance. An upper bound
 * comes from points that the Minkowski difference D = B - A is known to hold:
 *
 * <ul>
 *   <li>A point of B at height h above the face of A, whose foot is inside that face, gives the
 *       point h n. So the distance is at most h when h is positive, and the shapes overlap when it
 *       is not.
 *   <li>For h = -d and a foot that is at least r inside the face, D holds a disc of radius r about
 *       that point, in the plane of the face. It also holds the ball about B's centre minus A's
 *       whose radius is the sum R of the inner radii. Let that centre be H high and l beside the
 *       normal. The hull of both holds at height z the disc about the axis of radius r + k (z + d)
 *       with k = (R - r - l) / (H + d), hence the ball about the origin of radius
 * </ul>
 *
 * <pre>L = min(d, (r + k d) / sqrt(1 + k^2))   if L &lt;= H</pre>
 *
 * and the depth is at least L. It is also at least as deep as a point of B is inside A, away from
 * all faces, for D holds b - A. Two edges that cross are such a face of D: a parallelogram. When
 * both bounds are so near each other that each decision of {@link HullPairs} would be the same with
 * either, its answer is the same without any search. Else the search runs.
 */
final class WarmContact {
    /** Of {@link ContactTolerances#HYSTERESIS}: what two edges may leave open. */
    private static final double EDGE_GAP = 0.5;

    /** Of the depth. */
    private static final double EDGE_SHARE = 0.05;

    private final Pair pair;
    private final Axes axes;
    private final ContactPoints points;
    private final HullAxis search;
    private final Containment inside = new Containment();
    private final CrossingEdges cross;

    /** What is known from an earlier pose. */
    final DistanceCertificate certificate = new DistanceCertificate();

    /** The contact of the last {@link #collide} is complete. */
    boolean done;

    /**
     * By the {@link #certificate} alone; else {@link #upper} is what bounds the signed distance, m.
     */
    boolean proven;

    double upper;

    /** Nothing but the certificate is tried; two edges of a known axis are best by it. */
    private boolean certificateOnly, edgesBest;

    /** The axes of the last {@link #collide} are known to be the best, up to {@link #gap}. */
    boolean certain;

    double gap;

    /** Along the face of the last tick, m. */
    double separation;

    /**
     * The manifold holds the face contact of {@link #face}, of B when {@link #onB}, though it may
     * not be the answer.
     */
    boolean clipped, onB;

    int face;

    /** A direction that is near to the best one, from A to B in A's frame. */
    double axisX, axisY, axisZ;

    /** Another face than that of the last tick is tried. */
    private boolean second;

    /** The deepest corner that was clipped. */
    private int deepest;

    WarmContact(Pair pair, Axes axes, ContactPoints points, HullAxis search) {
        this.pair = pair;
        this.axes = axes;
        this.points = points;
        this.search = search;
        this.cross = new CrossingEdges(pair, axes, inside);
    }

    /** Nothing is known. */
    void forget() {
        done = false;
        proven = false;
        certificateOnly = false;
        edgesBest = false;
        certain = false;
        clipped = false;
        second = false;
        axisX = pair.dx;
        axisY = pair.dy;
        axisZ = pair.dz;
    }

    /**
     * Tries the features of a key that is not 0; returns the next key when {@link #done}.
     *
     * @param crossing two edges that separated best though a face held the contact, as {@link
     *     #crossing} tells them; 0 for none
     */
    long collide(double margin, long cache, long crossing, Manifold out) {
        forget();
        boolean byEdges = cache >>> 62 == WarmStartKey.EDGES;
        if (certificate.isTight(ContactTolerances.HYSTERESIS * pair.inner)
                && (byEdges || crossing != 0)) {
            certificateOnly = true;
            edgesBest = !byEdges && !certificate.same && certifiedBest(crossing);
            long key = last(margin, cache, out);
            if (done) {
                return key;
            }
            out.pointCount = 0;
            out.patch = 0;
            forget();
        }
        if (crossing != 0 && !byEdges) {
            if (exist(crossing)) {
                edges((int) (crossing >>> 15) & 0x7FFF, (int) crossing & 0x7FFF);
            }
            if (certain) {
                return 0;
            }
            forget();
        }
        return last(margin, cache, out);
    }

    private boolean exist(long crossing) {
        return ((crossing >>> 15) & 0x7FFF) < pair.a.edgeCount()
                && (crossing & 0x7FFF) < pair.b.edgeCount();
    }

    /** Whether the certificate tells that no direction is much better than that of two edges. */
    private boolean certifiedBest(long crossing) {
        return exist(crossing)
                && cross.place((int) (crossing >>> 15) & 0x7FFF, (int) crossing & 0x7FFF)
                && certificate.high - cross.along <= enough(cross.along);
    }

    /** Tries the features of the last tick. */
    private long last(double margin, long cache, Manifold out) {
        long kind = cache >>> 62;
        int face = WarmStartKey.faceOf(cache);
        int hint = WarmStartKey.hint(cache);
        if (kind == WarmStartKey.FACE_A
                && face < pair.a.faceCount()
                && hint < pair.b.vertexCount()) {
            return onA(face, hint, margin, cache, out);
        }
        if (kind == WarmStartKey.FACE_B
                && face < pair.b.faceCount()
                && hint < pair.a.vertexCount()) {
            return onB(face, hint, margin, cache, out);
        }
        if (kind == WarmStartKey.EDGES && face < pair.a.edgeCount() && hint < pair.b.edgeCount()) {
            if (certificateOnly) {
                return provenEdges(face, hint, margin, out);
            }
            edges(face, hint);
        }
        return 0;
    }

    /** The edges of the axes, when they separate best by more than any decision could overlook. */
    long crossing() {
        double faces = Math.max(axes.separationA, axes.separationB);
        boolean best = axes.separationEdge > faces + ContactTolerances.HYSTERESIS * pair.inner;
        return best ? 1L << 62 | (long) axes.edgeA << 15 | axes.edgeB : 0;
    }

    private long onA(int face, int hint, double margin, long cache, Manifold out) {
        Pair p = pair;
        double x = -p.a.normalX(face);
        double y = -p.a.normalY(face);
        double z = -p.a.normalZ(face);
        int v =
                p.b.climb(
                        p.r00 * x + p.r10 * y + p.r20 * z,
                        p.r01 * x + p.r11 * y + p.r21 * z,
                        p.r02 * x + p.r12 * y + p.r22 * z,
                        hint);
        p.vertexB(v);
        double s = -(p.px * x + p.py * y + p.pz * z) - p.a.offset(face);
        axes.faceA = face;
        return face(false, face, v, s, margin, cache, out);
    }

    private long onB(int face, int hint, double margin, long cache, Manifold out) {
        Pair p = pair;
        double x = p.b.normalX(face);
        double y = p.b.normalY(face);
        double z = p.b.normalZ(face);
        double nx = p.r00 * x + p.r01 * y + p.r02 * z;
        double ny = p.r10 * x + p.r11 * y + p.r12 * z;
        double nz = p.r20 * x + p.r21 * y + p.r22 * z;
        int v = p.a.climb(-nx, -ny, -nz, hint);
        double s =
                (p.a.vertexX(v) - p.dx) * nx
                        + (p.a.vertexY(v) - p.dy) * ny
                        + (p.a.vertexZ(v) - p.dz) * nz
                        - p.b.offset(face);
        axes.faceB = face;
        return face(true, face, v, s, margin, cache, out);
    }

    private long face(
            boolean flip, int at, int v, double s, double margin, long cache, Manifold out) {
        long kind = flip ? WarmStartKey.FACE_B : WarmStartKey.FACE_A;
        separation = s;
        if (s > margin) {
            done = true;
            return WarmStartKey.withHint(WarmStartKey.of(kind, at, (int) cache), v);
        }
        double hysteresis = ContactTolerances.HYSTERESIS * pair.inner;
        face = at;
        boolean known = certificate.keepsReference(s, hysteresis);
        known =
                known
                        && (certificate.keepsDirection(s, hysteresis)
                                || (edgesBest && besideEdges(flip)));
        if (certificateOnly && !known) {
            return 0;
        }
        points.face(flip, v, margin, hysteresis, (int) cache, out);
        axisX = points.axisX;
        axisY = points.axisY;
        axisZ = points.axisZ;
        if (out.pointCount == 0) {
            return 0;
        }
        double least = out.deepest();
        double low = Math.max(s, certificate.low);
        proven = known && certificate.confirmsDepth(low, least, hysteresis);
        if (certificateOnly && !proven) {
            return 0;
        }
        upper = certificate.high;
        if (!proven) {
            upper = upper(flip, at, s, least, hysteresis);
        }
        if (!proven && !DistanceCertificate.confirmsFace(s, s, least, upper, upper, hysteresis)) {
            return other(flip, least - s <= hysteresis, margin, cache, out);
        }
        done = true;
        out.bound = DistanceCertificate.depthError(low, least, upper) + 0x1p-48 * pair.scale;
        return WarmStartKey.withHint(WarmStartKey.of(kind, at, FeatureIds.of(out)), v);
    }

    /** An upper bound of the signed distance from all that may give one; tries until it settles. */
    private double upper(boolean flip, int at, double s, double least, double hysteresis) {
        double best = Math.min(certificate.high, upper(flip, at));
        if (least - s <= hysteresis
                && !DistanceCertificate.confirmsFace(s, s, least, best, best, hysteresis)) {
            Clipper c = points.clipper;
            Polyhedron reference = flip ? pair.b : pair.a;
            best =
                    Math.min(
                            best,
                            -inside.within(reference, c.x[deepest], c.y[deepest], c.z[deepest]));
        }
        if (least - s <= hysteresis
                && !DistanceCertificate.confirmsFace(s, s, least, best, best, hysteresis)) {
            best = Math.min(best, search.upper());
        }
        return best;
    }

    /**
     * The face does not separate best. If its deepest corner is where two edges cross, these may;
     * if it is a vertex of the face's own shape, the face on which it lies.
     */
    private long other(boolean flip, boolean deep, double margin, long cache, Manifold out) {
        int name = points.clipper.feature[deepest];
        int id = name & 0x3FFF_FFFF;
        if (name >>> 30 == FeatureIds.CROSSING >>> 30) {
            edges(id >>> 15, id & 0x7FFF);
            clipped = certain;
            onB = flip;
        } else if (!second && (name >>> 30 == FeatureIds.VERTEX_B >>> 30) == flip) {
            second = true;
            out.pointCount = 0;
            return flip
                    ? onA(points.incidentFace, id, margin, cache, out)
                    : onB(points.incidentFace, id, margin, cache, out);
        } else if (!second && deep && inside.nearest != face) {
            second = true;
            out.pointCount = 0;
            int v = points.incidentVertex;
            return flip
                    ? onB(inside.nearest, v, margin, cache, out)
                    : onA(inside.nearest, v, margin, cache, out);
        }
        if (!certain) {
            out.pointCount = 0;
        }
        return 0;
    }

    /** An upper bound of the signed distance, from the corners that the clipper was left with. */
    private double upper(boolean flip, int face) {
        Pair p = pair;
        Polyhedron reference = flip ? p.b : p.a;
        Clipper c = points.clipper;
        deepest = 0;
        double x = c.x[0];
        double y = c.y[0];
        double z = c.z[0];
        double s = c.separation[0];
        for (int i = 1; i < c.count; i++) {
            x += c.x[i];
            y += c.y[i];
            z += c.z[i];
            s += c.separation[i];
            deepest = c.separation[i] < c.separation[deepest] ? i : deepest;
        }
        double part = 1.0 / c.count;
        double low = c.separation[deepest];
        double rise = s * part - low;
        double edge = Containment.face(reference, face, c.x[deepest], c.y[deepest], c.z[deepest]);
        double slope =
                c.count == 1
                        ? 0
                        : Containment.face(reference, face, x * part, y * part, z * part) - edge;
        // A point between the deepest corner and the middle: how far inside it is at least grows
        // evenly.
        double from = edge >= 0 ? 0 : -edge / slope;
        if (!(edge >= 0 || (slope > 0 && from <= 1))) {
            return Double.POSITIVE_INFINITY;
        }
        if (low + from * rise >= 0) {
            return low + from * rise;
        }
        double ox = flip ? -(p.r00 * p.dx + p.r10 * p.dy + p.r20 * p.dz) : p.dx;
        double oy = flip ? -(p.r01 * p.dx + p.r11 * p.dy + p.r21 * p.dz) : p.dy;
        double oz = flip ? -(p.r02 * p.dx + p.r12 * p.dy + p.r22 * p.dz) : p.dz;
        double high =
                reference.normalX(face) * ox
                        + reference.normalY(face) * oy
                        + reference.normalZ(face) * oz;
        double square = ox * ox + oy * oy + oz * oz;
        double beside = Math.sqrt(Math.max(0, square - high * high));
        double steep = (p.a.innerRadius() + p.b.innerRadius() - beside) / (high - low);
        double need = -low * (Math.sqrt(1 + steep * steep) - steep) * 1.0625;
        double at = slope > 0 ? Math.max(from, Math.min(1, (need - edge) / slope)) : from;
        double d = -(low + at * rise);
        return -Math.max(0, Containment.depth(p, d, Math.max(0, edge + at * slope), high, beside));
    }

    /** The point of two edges where the certificate tells that it is the answer still. */
    private long provenEdges(int ea, int eb, double margin, Manifold out) {
        if (!cross.place(ea, eb)) {
            return 0;
        }
        double s = cross.along;
        double enough = enough(s);
        if (!(certificate.high - s <= enough && s - certificate.low <= enough)) {
            return 0;
        }
        axes.edgeA = ea;
        axes.edgeB = eb;
        axes.edgeX = cross.axisX;
        axes.edgeY = cross.axisY;
        axes.edgeZ = cross.axisZ;
        axes.separationEdge = s;
        if (!(certificate.same || noFace()) || !points.crossing(margin, out)) {
            return 0;
        }
        done = true;
        proven = true;
        out.bound =
                DistanceCertificate.depthError(certificate.low, s, certificate.high)
                        + 0x1p-48 * pair.scale;
        return WarmStartKey.withHint(
                WarmStartKey.of(WarmStartKey.EDGES, 0, FeatureIds.of(out)) | (long) ea << 47, eb);
    }

    /** The best face is another direction and separates by much less. */
    private boolean noFace() {
        double most = Math.max(Math.abs(certificate.low), Math.abs(certificate.high));
        if (!(certificate.low - certificate.rival
                > ContactTolerances.depthError(
                        true, ContactTolerances.HYSTERESIS * pair.inner, most))) {
            return false;
        }
        axes.faceA = certificate.face;
        axes.faceB = certificate.face;
        return !besideEdges(certificate.onB);
    }

    /** Whether the face of the axes is nearly the same direction as the edges. */
    private boolean besideEdges(boolean flip) {
        points.faceAxis(flip);
        double cosine =
                points.axisX * cross.axisX
                        + points.axisY * cross.axisY
                        + points.axisZ * cross.axisZ;
        return cosine > ContactTolerances.NEARLY_PARALLEL;
    }

    /** What two edges may leave open. */
    private double enough(double s) {
        return EDGE_GAP * ContactTolerances.HYSTERESIS * pair.inner - EDGE_SHARE * Math.min(s, 0);
    }

    /** Fills the axes when two edges are still those that separate best. */
    private void edges(int ea, int eb) {
        if (!cross.place(ea, eb)) {
            return;
        }
        axisX = cross.axisX;
        axisY = cross.axisY;
        axisZ = cross.axisZ;
        if (!cross.support()) {
            return;
        }
        double s = cross.along;
        double enough = enough(s);
        double high = cross.upper(enough);
        if (high - s > enough) {
            high = Math.min(high, search.upper());
        }
        if (high - s <= enough) {
            certain = true;
            gap = high - s;
            axes.snapTo(pair, ea, eb, axisX, axisY, axisZ, s);
        }
    }
}
