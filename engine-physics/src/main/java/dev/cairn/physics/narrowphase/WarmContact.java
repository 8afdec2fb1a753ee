package dev.cairn.physics.narrowphase;

import static dev.cairn.physics.narrowphase.NarrowPhase.CALM;
import static dev.cairn.physics.narrowphase.NarrowPhase.EDGES;
import static dev.cairn.physics.narrowphase.NarrowPhase.FACE_A;
import static dev.cairn.physics.narrowphase.NarrowPhase.FACE_B;

import dev.cairn.physics.shape.Polyhedron;

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
 * both bounds are so near each other that each decision of {@link Polyhedra} would be the same with
 * either, its answer is the same without any search. Else the search runs.
 */
final class WarmContact {
    /** Of {@link NarrowPhase#CALM}: what two edges may leave open. */
    private static final double EDGE_GAP = 0.5;

    /** Of the depth. */
    private static final double EDGE_SHARE = 0.05;

    private final Pair pair;
    private final Axes axes;
    private final ContactPoints points;
    private final PolyhedronAxis search;

    /** See {@link Safeguard}. */
    boolean secondBound = true;

    /** The contact of the last {@link #collide} is complete. */
    boolean done;

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

    /** Two edges in A's frame: where they begin, and where they lead. */
    private double ax, ay, az, bx, by, bz, ux, uy, uz, vx, vy, vz;

    /** Another face than that of the last tick is tried. */
    private boolean second;

    /** The face that the point of {@link #within} is nearest to. */
    private int nearest;

    /** The deepest corner that was clipped. */
    private int deepest;

    WarmContact(Pair pair, Axes axes, ContactPoints points, PolyhedronAxis search) {
        this.pair = pair;
        this.axes = axes;
        this.points = points;
        this.search = search;
    }

    /** Nothing is known. */
    void forget() {
        done = false;
        certain = false;
        clipped = false;
        second = false;
        axisX = pair.dx;
        axisY = pair.dy;
        axisZ = pair.dz;
    }

    /**
     * Tries the features of a word that is not 0; returns the next word when {@link #done}.
     *
     * @param crossing two edges that separated best though a face held the contact, as {@link
     *     #crossing} tells them; 0 for none
     */
    long collide(double margin, long cache, long crossing, Manifold out) {
        forget();
        long kind = cache >>> 62;
        if (crossing != 0 && kind != EDGES) {
            int ea = (int) (crossing >>> 15) & 0x7FFF;
            int eb = (int) crossing & 0x7FFF;
            if (ea < pair.a.edgeCount() && eb < pair.b.edgeCount()) {
                edges(ea, eb);
            }
            if (certain) {
                return 0;
            }
            forget();
        }
        int face = Word.faceOf(cache);
        int hint = Word.hint(cache);
        if (kind == FACE_A && face < pair.a.faceCount() && hint < pair.b.vertexCount()) {
            return onA(face, hint, margin, cache, out);
        }
        if (kind == FACE_B && face < pair.b.faceCount() && hint < pair.a.vertexCount()) {
            return onB(face, hint, margin, cache, out);
        }
        if (kind == EDGES && face < pair.a.edgeCount() && hint < pair.b.edgeCount()) {
            edges(face, hint);
        }
        return 0;
    }

    /** The edges of the axes, when they separate best by more than any decision could overlook. */
    long crossing() {
        double faces = Math.max(axes.separationA, axes.separationB);
        boolean best = axes.separationEdge > faces + CALM * pair.inner;
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
        long kind = flip ? FACE_B : FACE_A;
        separation = s;
        if (s > margin) {
            done = true;
            return Word.withHint(Word.of(kind, at, (int) cache), v);
        }
        double calm = CALM * pair.inner;
        face = at;
        points.face(flip, v, margin, calm, (int) cache, out);
        axisX = points.axisX;
        axisY = points.axisY;
        axisZ = points.axisZ;
        if (out.pointCount == 0) {
            return 0;
        }
        double least = Polyhedra.deepest(out);
        double upper = secondBound ? upper(flip, at) : s;
        if (secondBound && least - s <= calm && !settled(s, least, upper, calm)) {
            Clipper c = points.clipper;
            Polyhedron reference = flip ? pair.b : pair.a;
            upper = Math.min(upper, -within(reference, c.x[deepest], c.y[deepest], c.z[deepest]));
        }
        if (secondBound && least - s <= calm && !settled(s, least, upper, calm)) {
            upper = Math.min(upper, search.upper());
        }
        if (secondBound && !settled(s, least, upper, calm)) {
            return other(flip, least - s <= calm, margin, cache, out);
        }
        done = true;
        out.bound = wrong(s, least, upper) + 0x1p-48 * pair.scale;
        return Word.withHint(Word.of(kind, at, Names.of(out)), v);
    }

    /** What the depth at the points may be wrong by. */
    private static double wrong(double s, double least, double upper) {
        return Math.max(Math.abs(least - s), Math.abs(upper - least));
    }

    /** Whether any signed distance between the bounds would leave the face contact as it is. */
    private static boolean settled(double s, double least, double upper, double calm) {
        double smallest = s > 0 ? s : Math.max(0, -upper);
        return upper - s <= calm && wrong(s, least, upper) <= 1.5 * calm + 0.15 * smallest;
    }

    /** How deep a point of the one shape is inside the other; minus infinity when it is not. */
    private double within(Polyhedron h, double x, double y, double z) {
        double least = Double.MAX_VALUE;
        int faces = h.faceCount();
        for (int f = 0; f < faces; f++) {
            double s = h.offset(f) - (h.normalX(f) * x + h.normalY(f) * y + h.normalZ(f) * z);
            if (s < least) {
                least = s;
                nearest = f;
            }
        }
        return least >= 0 ? least : Double.NEGATIVE_INFINITY;
    }

    /**
     * The face does not separate best. If its deepest corner is where two edges cross, these may;
     * if it is a vertex of the face's own shape, the face on which it lies.
     */
    private long other(boolean flip, boolean deep, double margin, long cache, Manifold out) {
        int name = points.clipper.feature[deepest];
        int id = name & 0x3FFF_FFFF;
        if (name >>> 30 == Clipper.CROSSING >>> 30) {
            edges(id >>> 15, id & 0x7FFF);
            clipped = certain;
            onB = flip;
        } else if (!second && (name >>> 30 == Clipper.VERTEX_B >>> 30) == flip) {
            second = true;
            out.pointCount = 0;
            return flip
                    ? onA(points.incidentFace, id, margin, cache, out)
                    : onB(points.incidentFace, id, margin, cache, out);
        } else if (!second && deep && nearest != face) {
            second = true;
            out.pointCount = 0;
            int v = points.incidentVertex;
            return flip ? onB(nearest, v, margin, cache, out) : onA(nearest, v, margin, cache, out);
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
        double edge = inside(reference, face, c.x[deepest], c.y[deepest], c.z[deepest]);
        double slope =
                c.count == 1 ? 0 : inside(reference, face, x * part, y * part, z * part) - edge;
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
        return -Math.max(0, depth(d, Math.max(0, edge + at * slope), high, beside));
    }

    /** The lower bound of the depth from a disc and the ball; see the class. */
    private double depth(double d, double r, double high, double beside) {
        double radii = pair.a.innerRadius() + pair.b.innerRadius();
        double k = (radii - r - beside) / (high + d);
        double least = Math.min(d, (r + k * d) / Math.sqrt(1 + k * k));
        return least <= high ? least : 0;
    }

    /** How far inside all sides of a face the foot of a point is. */
    private static double inside(Polyhedron h, int face, double x, double y, double z) {
        double least = Double.MAX_VALUE;
        int end = h.faceBegin(face + 1);
        for (int i = h.faceBegin(face); i < end; i++) {
            double s = h.sideOffset(i) - (h.sideX(i) * x + h.sideY(i) * y + h.sideZ(i) * z);
            least = s < least ? s : least;
        }
        return least;
    }

    /** Fills the axes when two edges are still those that separate best. */
    private void edges(int ea, int eb) {
        Pair p = pair;
        axes.rawX = p.dx;
        axes.rawY = p.dy;
        axes.rawZ = p.dz;
        if (axes.cross(p, ea, eb) == 0) {
            return;
        }
        axisX = axes.cx;
        axisY = axes.cy;
        axisZ = axes.cz;
        int from = p.a.edgeFrom(ea);
        int to = p.a.edgeTo(ea);
        ax = p.a.vertexX(from);
        ay = p.a.vertexY(from);
        az = p.a.vertexZ(from);
        ux = p.a.vertexX(to) - ax;
        uy = p.a.vertexY(to) - ay;
        uz = p.a.vertexZ(to) - az;
        p.vertexB(p.b.edgeTo(eb));
        vx = p.px;
        vy = p.py;
        vz = p.pz;
        p.vertexB(p.b.edgeFrom(eb));
        bx = p.px;
        by = p.py;
        bz = p.pz;
        vx -= bx;
        vy -= by;
        vz -= bz;
        double s = (bx - ax) * axisX + (by - ay) * axisY + (bz - az) * axisZ;
        if (!supports(from, p.b.edgeFrom(eb), axisX, axisY, axisZ, s)) {
            return;
        }
        double enough = EDGE_GAP * CALM * p.inner - EDGE_SHARE * Math.min(s, 0);
        double upper = secondBound ? upperOfEdges(s, enough) : s;
        if (upper - s > enough) {
            upper = Math.min(upper, search.upper());
        }
        if (upper - s <= enough) {
            certain = true;
            gap = upper - s;
            axes.snapTo(p, ea, eb, axisX, axisY, axisZ, s);
        }
    }

    /**
     * An upper bound of the signed distance of two edges u from a and v from b; tries until enough.
     */
    private double upperOfEdges(double s, double enough) {
        Pair p = pair;
        double rx = bx - ax;
        double ry = by - ay;
        double rz = bz - az;
        double uu = ux * ux + uy * uy + uz * uz;
        double vv = vx * vx + vy * vy + vz * vz;
        double uv = ux * vx + uy * vy + uz * vz;
        double ur = ux * rx + uy * ry + uz * rz;
        double vr = vx * rx + vy * ry + vz * rz;
        double det = uu * vv - uv * uv;
        double f = (ur * vv - vr * uv) / det;
        double g = (ur * uv - vr * uu) / det;
        double alongU = Math.min(f, 1 - f);
        double alongV = Math.min(g, 1 - g);
        if (!(alongU >= 0 && alongV >= 0)) {
            return Double.POSITIVE_INFINITY;
        }
        if (s >= 0) {
            return s;
        }
        double high = axisX * p.dx + axisY * p.dy + axisZ * p.dz;
        double square = p.dx * p.dx + p.dy * p.dy + p.dz * p.dz;
        double beside = Math.sqrt(Math.max(0, square - high * high));
        // Distances from the sides of the parallelogram: |u x v| / |v| and / |u|.
        double r = Math.sqrt(det) * Math.min(alongU / Math.sqrt(vv), alongV / Math.sqrt(uu));
        double upper = -Math.max(0, depth(-s, r, high, beside));
        if (upper - s > enough) {
            double inA = within(p.a, bx + g * vx, by + g * vy, bz + g * vz);
            upper = Math.min(upper, -inA);
        }
        if (upper - s > enough) {
            // The point of A, in B's frame.
            double x = ax + f * ux - p.dx;
            double y = ay + f * uy - p.dy;
            double z = az + f * uz - p.dz;
            double inB =
                    within(
                            p.b,
                            p.r00 * x + p.r10 * y + p.r20 * z,
                            p.r01 * x + p.r11 * y + p.r21 * z,
                            p.r02 * x + p.r12 * y + p.r22 * z);
            upper = Math.min(upper, -inB);
        }
        return upper;
    }

    /** Whether no vertex reaches farther along the axis than the edges do. */
    private boolean supports(int va, int vb, double nx, double ny, double nz, double s) {
        Pair p = pair;
        int a = p.a.climb(nx, ny, nz, va);
        int b =
                p.b.climb(
                        -(p.r00 * nx + p.r10 * ny + p.r20 * nz),
                        -(p.r01 * nx + p.r11 * ny + p.r21 * nz),
                        -(p.r02 * nx + p.r12 * ny + p.r22 * nz),
                        vb);
        p.vertexB(b);
        double t =
                (p.px - p.a.vertexX(a)) * nx
                        + (p.py - p.a.vertexY(a)) * ny
                        + (p.pz - p.a.vertexZ(a)) * nz;
        return t >= s - 0x1p-46 * p.scale;
    }
}
