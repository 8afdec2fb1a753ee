package dev.cairn.physics.narrowphase.curved;

import dev.cairn.physics.narrowphase.axis.AxisRefinement;
import dev.cairn.physics.narrowphase.pair.Axes;
import dev.cairn.physics.narrowphase.pair.Containment;
import dev.cairn.physics.narrowphase.pair.Pair;
import dev.cairn.physics.shape.Capsule;
import dev.cairn.physics.shape.ConvexHull;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.polyhedron.Polyhedron;

/**
 * The exact axis of a capsule's segment and a hull, when they are apart and near features settle
 * it; else nothing, and {@link CurvedAxis} iterates.
 *
 * <p>In the hull's frame the segment is c + t u, |t| &lt;= h. The separation along any unit axis is
 * a lower bound of the distance, the distance of any two points an upper one. The face that
 * separates best is the answer when the foot of the nearer end is inside it. Else its edges are
 * tried, and as long as the hull reaches beyond the plane at right angles to the way found, the
 * edges of the vertex that does. Where both bounds meet that way is the answer.
 */
final class SegmentHull {
    /** Hulls with more faces are left to the iteration, which does not look at all of them. */
    private static final int MOST_FACES = 1024;

    private static final int STEPS = 4;

    /** Of the scale: what the bounds may leave open; axes that are equal. */
    private static final double OPEN = 0x1p-48, TIE = 0x1p-52;

    /** Of the scale: nearer points tell no direction. */
    private static final double CLEAR = 0x1p-24;

    /** Of the squared distance: ways this near to equal are no answer unless they are the same. */
    private static final double EQUAL = 0x1p-40;

    /** Of the squared sine: segment and edge nearer to parallel are left to the iteration. */
    private static final double PARALLEL = 0x1p-40;

    /** In place of a vertex: no other way can be shorter; the shortest tells no direction. */
    private static final int DONE = -1, NONE = -2;

    /** Middle, direction and half length of the segment, in the hull's frame. */
    private double cx, cy, cz, ux, uy, uz, h;

    private Polyhedron hull = Polyhedron.of(dev.cairn.physics.shape.Box.cubeOfHalfExtent(1));

    /** The best axis, from the hull to the segment, its separation, and what it belongs to. */
    private double x, y, z, best;

    private int ofHull, ofSegment;

    /** The shortest of the ways tried, its square, and what it joins. */
    private double wx, wy, wz, least;

    private int wayOfHull, wayOfSegment;

    /** Its direction, see {@link #direct}. */
    private double dirX, dirY, dirZ;

    /** Half the edge that it leads from; zero from a vertex. */
    private double ex, ey, ez;

    /** Another way is as short. */
    private boolean tie;

    /** Whether a pair is one of a capsule and a hull, in either order. */
    static boolean fits(Shape a, Shape b) {
        return a instanceof ConvexHull
                ? b instanceof Capsule
                : a instanceof Capsule && b instanceof ConvexHull;
    }

    /** Finds the axis of a pair that {@link #fits}; false when near features do not tell. */
    boolean find(Pair p, Shape a, Shape b, double limit, CurvedAxis out) {
        boolean second = b instanceof ConvexHull;
        hull = second ? p.b : p.a;
        if (hull.faceCount() > MOST_FACES) {
            return false;
        }
        h = ((Capsule) (second ? a : b)).halfLength();
        cx = second ? -(p.r00 * p.dx + p.r10 * p.dy + p.r20 * p.dz) : p.dx;
        cy = second ? -(p.r01 * p.dx + p.r11 * p.dy + p.r21 * p.dz) : p.dy;
        cz = second ? -(p.r02 * p.dx + p.r12 * p.dy + p.r22 * p.dz) : p.dz;
        ux = second ? p.r10 : p.r01;
        uy = p.r11;
        uz = second ? p.r12 : p.r21;
        if (!solve(p.scale, limit)) {
            return false;
        }
        if (second) {
            out.take(
                    -(p.r00 * x + p.r01 * y + p.r02 * z),
                    -(p.r10 * x + p.r11 * y + p.r12 * z),
                    -(p.r20 * x + p.r21 * y + p.r22 * z),
                    best,
                    ofSegment,
                    ofHull,
                    best > limit);
        } else {
            out.take(x, y, z, best, ofHull, ofSegment, best > limit);
        }
        return true;
    }

    private boolean solve(double scale, double limit) {
        int face = face(limit);
        if (best > limit) {
            return true;
        }
        if (best > CLEAR * scale && !hull.isUneven(face)) {
            double at = x * ux + y * uy + z * uz > 0 ? -h : h;
            if (Containment.face(hull, face, cx + at * ux, cy + at * uy, cz + at * uz) >= 0) {
                return true;
            }
        }
        least = Double.POSITIVE_INFINITY;
        for (int s = hull.faceBegin(face); s < hull.faceBegin(face + 1); s++) {
            way(hull.slotEdge(s));
        }
        for (int step = 0; step < STEPS; step++) {
            int v = axis(scale);
            if (v < 0) {
                return v == DONE && !tie;
            }
            double before = least;
            for (int s = hull.spokeBegin(v); s < hull.spokeBegin(v + 1); s++) {
                way(hull.spokeEdge(s));
            }
            if (!(least < before)) {
                return false;
            }
        }
        return false;
    }

    /** The face that separates best, or the first one that separates by more than the limit. */
    private int face(double limit) {
        best = Axes.NEVER;
        int face = 0;
        for (int f = 0; f < hull.faceCount() && best <= limit; f++) {
            double nx = hull.normalX(f);
            double ny = hull.normalY(f);
            double nz = hull.normalZ(f);
            double s =
                    nx * cx
                            + ny * cy
                            + nz * cz
                            - h * Math.abs(nx * ux + ny * uy + nz * uz)
                            - hull.offset(f);
            if (s > best) {
                best = s;
                face = f;
            }
        }
        x = hull.normalX(face);
        y = hull.normalY(face);
        z = hull.normalZ(face);
        ofHull = AxisRefinement.FLAT;
        ofSegment = AxisRefinement.POINT;
        return face;
    }

    private double clampToSegment(double t) {
        return Math.max(-h, Math.min(h, t));
    }

    /**
     * Tries the way from an edge to the segment. With m the middle of the edge, e half of it, and r
     * = c - m, the points m + s e and c + t u are nearest where s (e . e) = r . e + t (u . e) and t
     * = s (u . e) - r . u, as far as the ends let them.
     */
    private void way(int edge) {
        int from = hull.edgeFrom(edge);
        int to = hull.edgeTo(edge);
        double hx = 0.5 * (hull.vertexX(to) - hull.vertexX(from));
        double hy = 0.5 * (hull.vertexY(to) - hull.vertexY(from));
        double hz = 0.5 * (hull.vertexZ(to) - hull.vertexZ(from));
        double rx = cx - 0.5 * (hull.vertexX(to) + hull.vertexX(from));
        double ry = cy - 0.5 * (hull.vertexY(to) + hull.vertexY(from));
        double rz = cz - 0.5 * (hull.vertexZ(to) + hull.vertexZ(from));
        double ee = hx * hx + hy * hy + hz * hz;
        double ue = ux * hx + uy * hy + uz * hz;
        double re = rx * hx + ry * hy + rz * hz;
        double ru = rx * ux + ry * uy + rz * uz;
        double det = ee - ue * ue;
        double t = det > PARALLEL * ee ? clampToSegment((ue * re - ee * ru) / det) : 0;
        double s = Math.max(-1, Math.min(1, (re + t * ue) / ee));
        t = clampToSegment(s * ue - ru);
        s = Math.max(-1, Math.min(1, (re + t * ue) / ee));
        if (Math.abs(s) == 1) {
            // From the vertex itself, so that all its edges tell the same.
            int v = s < 0 ? from : to;
            rx = cx - hull.vertexX(v);
            ry = cy - hull.vertexY(v);
            rz = cz - hull.vertexZ(v);
            t = clampToSegment(-(rx * ux + ry * uy + rz * uz));
            hx = 0;
            hy = 0;
            hz = 0;
            s = 0;
        }
        take(rx + t * ux - s * hx, ry + t * uy - s * hy, rz + t * uz - s * hz, hx, hy, hz, t);
    }

    private void take(double px, double py, double pz, double hx, double hy, double hz, double t) {
        double square = px * px + py * py + pz * pz;
        if (square > least * (1 + EQUAL)) {
            return;
        }
        if (square >= least * (1 - EQUAL)) {
            tie |= px != wx || py != wy || pz != wz;
            return;
        }
        tie = false;
        least = square;
        wx = px;
        wy = py;
        wz = pz;
        ex = hx;
        ey = hy;
        ez = hz;
        wayOfHull = hx == 0 && hy == 0 && hz == 0 ? AxisRefinement.POINT : AxisRefinement.LINE;
        wayOfSegment = Math.abs(t) < h ? AxisRefinement.LINE : AxisRefinement.POINT;
    }

    /**
     * Judges the shortest way by the separation along it. {@link #DONE} when no other can be
     * shorter, {@link #NONE} when it tells no direction, else the vertex that reaches beyond.
     */
    private int axis(double scale) {
        double length = Math.sqrt(least);
        if (!(length > CLEAR * scale) || !direct()) {
            return NONE;
        }
        double nx = dirX;
        double ny = dirY;
        double nz = dirZ;
        int v = hull.support(nx, ny, nz);
        double s =
                nx * cx
                        + ny * cy
                        + nz * cz
                        - h * Math.abs(nx * ux + ny * uy + nz * uz)
                        - (nx * hull.vertexX(v) + ny * hull.vertexY(v) + nz * hull.vertexZ(v));
        if (!(length - s <= OPEN * scale)) {
            return v;
        }
        if (s > best + TIE * scale) {
            x = nx;
            y = ny;
            z = nz;
            best = s;
            ofHull = wayOfHull;
            ofSegment = wayOfSegment;
        }
        return DONE;
    }

    /** The direction of the shortest way; false when the lines are parallel. */
    private boolean direct() {
        boolean edge = wayOfHull == AxisRefinement.LINE;
        boolean line = wayOfSegment == AxisRefinement.LINE;
        // What rounding left along an edge or the segment would count by its length.
        double nx = wx;
        double ny = wy;
        double nz = wz;
        if (edge && line) {
            nx = ey * uz - ez * uy;
            ny = ez * ux - ex * uz;
            nz = ex * uy - ey * ux;
            double ee = ex * ex + ey * ey + ez * ez;
            if (!(nx * nx + ny * ny + nz * nz > PARALLEL * ee)) {
                return false;
            }
        } else if (edge) {
            double rest = (wx * ex + wy * ey + wz * ez) / (ex * ex + ey * ey + ez * ez);
            nx -= rest * ex;
            ny -= rest * ey;
            nz -= rest * ez;
        } else if (line) {
            double rest = wx * ux + wy * uy + wz * uz;
            nx -= rest * ux;
            ny -= rest * uy;
            nz -= rest * uz;
        }
        double f =
                (nx * wx + ny * wy + nz * wz < 0 ? -1 : 1) / Math.sqrt(nx * nx + ny * ny + nz * nz);
        dirX = f * nx;
        dirY = f * ny;
        dirZ = f * nz;
        return true;
    }
}
