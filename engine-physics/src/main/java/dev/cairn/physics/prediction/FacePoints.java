package dev.cairn.physics.prediction;

import dev.cairn.physics.narrowphase.pair.FeatureIds;
import dev.cairn.physics.narrowphase.pair.WarmStartKey;
import dev.cairn.physics.shape.Shape;
import dev.cairn.physics.shape.polyhedron.Polyhedral;
import dev.cairn.physics.shape.polyhedron.Polyhedron;

/**
 * The points of a contact of two polyhedra from their poses and the names of the points, where two
 * edges cross or on a face of one of the two, the reference. With everything seen from the
 * reference's centre, in world axes: n the face's normal and h its distance, m and g those of the
 * other's face that looks most against it. A point q on the other one is
 *
 * <pre>
 *   a corner of the other        q
 *   a corner c of the reference  q = c + t n,  m . q = g
 *   where edges e, f cross       q on f, in the plane through e along n
 * </pre>
 *
 * its separation s = n . q - h, and the point of the contact midway, q - s n / 2. Of a pair that
 * hardly moves q stays where it was on the other one, which the narrow phase keeps.
 */
final class FacePoints {
    private static final int NUMBER = 0x7FFF;

    /** From A to B. */
    final double[] normal = new double[3];

    /** From A's centre. */
    final double[] point = new double[3];

    double separation;

    private final double[] turnR = new double[9];
    private final double[] turnI = new double[9];

    /** From the reference to the other. */
    private final double[] away = new double[3];

    private final double[] n = new double[3];
    private final double[] m = new double[3];
    private final double[] q = new double[3];
    private final double[] end = new double[3];
    private final double[] from = new double[3];
    private final double[] to = new double[3];
    private double h;
    private double g;
    private boolean flip;

    /** Not of a face. */
    private boolean isOfEdges;

    private Polyhedron reference = Polyhedron.triangle();
    private Polyhedron other = reference;
    private double[] apart = {};

    /** Whether normal and points are known; then the normal is found. */
    boolean begin(
            BodyColumns bodies,
            int a,
            Shape shapeA,
            int b,
            Shape shapeB,
            double[] ab,
            long key,
            int name) {
        if (key >>> 62 == 0
                || !(shapeA instanceof Polyhedral first)
                || !(shapeB instanceof Polyhedral second)) {
            return false;
        }
        isOfEdges = key >>> 62 == WarmStartKey.EDGES;
        flip = WarmStartKey.onFaceOfB(key);
        apart = ab;
        reference = Polyhedron.of(flip ? second : first);
        other = Polyhedron.of(flip ? first : second);
        int face = WarmStartKey.faceOf(key);
        if (!isOfEdges && face >= reference.faceCount()) {
            return false;
        }
        turn(bodies, flip ? b : a, turnR);
        turn(bodies, flip ? a : b, turnI);
        if (isOfEdges) {
            for (int k = 0; k < 3; k++) {
                away[k] = ab[k];
            }
            return edges(name);
        }
        rotate(turnR, reference.normalX(face), reference.normalY(face), reference.normalZ(face), n);
        h = reference.offset(face);
        double least = Double.MAX_VALUE;
        int against = 0;
        for (int k = 0; k < 3; k++) {
            away[k] = flip ? -ab[k] : ab[k];
            normal[k] = flip ? -n[k] : n[k];
        }
        for (int f = 0; f < other.faceCount(); f++) {
            rotate(turnI, other.normalX(f), other.normalY(f), other.normalZ(f), m);
            double look = dot(n, m);
            against = look < least ? f : against;
            least = Math.min(look, least);
        }
        rotate(turnI, other.normalX(against), other.normalY(against), other.normalZ(against), m);
        g = other.offset(against) + dot(m, away);
        return true;
    }

    /**
     * Two edges that cross: with d and e their directions, n along d x e, and the feet of the
     * shortest way between them.
     */
    private boolean edges(int name) {
        int d = name >> 15 & NUMBER;
        int e = name & NUMBER;
        if ((name & FeatureIds.CLOSEST) != FeatureIds.CROSSING
                || d >= reference.edgeCount()
                || e >= other.edgeCount()) {
            return false;
        }
        ends(d, e);
        double x = 0;
        double y = 0;
        double dd = 0;
        double de = 0;
        double ee = 0;
        for (int k = 0; k < 3; k++) {
            double u = end[k] - q[k];
            double v = to[k] - from[k];
            double w = from[k] - q[k];
            dd += u * u;
            de += u * v;
            ee += v * v;
            x += u * w;
            y += v * w;
            m[k] = u;
            n[k] = v;
        }
        double cross = dd * ee - de * de;
        double s = (x * ee - y * de) / cross;
        double t = (x * de - y * dd) / cross;
        normal[0] = m[1] * n[2] - m[2] * n[1];
        normal[1] = m[2] * n[0] - m[0] * n[2];
        normal[2] = m[0] * n[1] - m[1] * n[0];
        double size = Math.sqrt(dot(normal, normal));
        size = dot(normal, away) < 0 ? -size : size;
        separation = 0;
        for (int k = 0; k < 3; k++) {
            normal[k] /= size;
            double onA = q[k] + s * m[k];
            double onB = from[k] + t * n[k];
            separation += normal[k] * (onB - onA);
            point[k] = 0.5 * (onA + onB);
        }
        return true;
    }

    /** Makes point and separation; false for a name that says nothing here. */
    boolean find(int name) {
        if (isOfEdges) {
            return true;
        }
        int kind = name & FeatureIds.CLOSEST;
        int number = name & ~FeatureIds.CLOSEST;
        boolean isOfA = kind == FeatureIds.VERTEX_A;
        if (kind == FeatureIds.CLOSEST) {
            return false;
        }
        if (kind == FeatureIds.CROSSING) {
            int e = flip ? name & NUMBER : name >> 15 & NUMBER;
            int f = flip ? name >> 15 & NUMBER : name & NUMBER;
            if (e >= reference.edgeCount() || f >= other.edgeCount()) {
                return false;
            }
            cross(e, f);
            separation = dot(n, q) - h;
        } else if (isOfA == flip) {
            if (number >= other.vertexCount()) {
                return false;
            }
            corner(other, turnI, number, q);
            add(q, away);
            separation = dot(n, q) - h;
        } else {
            if (number >= reference.vertexCount()) {
                return false;
            }
            corner(reference, turnR, number, q);
            separation = (g - dot(m, q)) / dot(m, n);
            for (int k = 0; k < 3; k++) {
                q[k] += separation * n[k];
            }
        }
        halfway();
        return true;
    }

    /** The same for a point that is kept in the axes of the other one. */
    void keep(double x, double y, double z) {
        rotate(turnI, x, y, z, q);
        add(q, away);
        separation = dot(n, q) - h;
        halfway();
    }

    private void halfway() {
        for (int k = 0; k < 3; k++) {
            double x = q[k] - 0.5 * separation * n[k];
            point[k] = flip ? x + apart[k] : x;
        }
    }

    /** Of the plane through e along n the point on f. */
    private void cross(int e, int f) {
        ends(e, f);
        double ex = end[0] - q[0];
        double ey = end[1] - q[1];
        double ez = end[2] - q[2];
        double sx = ey * n[2] - ez * n[1];
        double sy = ez * n[0] - ex * n[2];
        double sz = ex * n[1] - ey * n[0];
        double limit = sx * q[0] + sy * q[1] + sz * q[2];
        double here = sx * from[0] + sy * from[1] + sz * from[2] - limit;
        double there = sx * to[0] + sy * to[1] + sz * to[2] - limit;
        double share = here / (here - there);
        for (int k = 0; k < 3; k++) {
            q[k] = from[k] + share * (to[k] - from[k]);
        }
    }

    /** Of an edge of the reference and of one of the other. */
    private void ends(int e, int f) {
        corner(reference, turnR, reference.edgeFrom(e), q);
        corner(reference, turnR, reference.edgeTo(e), end);
        corner(other, turnI, other.edgeFrom(f), from);
        corner(other, turnI, other.edgeTo(f), to);
        add(from, away);
        add(to, away);
    }

    private static void corner(Polyhedron p, double[] turn, int vertex, double[] out) {
        rotate(turn, p.vertexX(vertex), p.vertexY(vertex), p.vertexZ(vertex), out);
    }

    private static void turn(BodyColumns bodies, int slot, double[] r) {
        double x = bodies.began(slot, 3);
        double y = bodies.began(slot, 4);
        double z = bodies.began(slot, 5);
        double w = bodies.began(slot, 6);
        r[0] = 1 - 2 * (y * y + z * z);
        r[1] = 2 * (x * y - w * z);
        r[2] = 2 * (x * z + w * y);
        r[3] = 2 * (x * y + w * z);
        r[4] = 1 - 2 * (x * x + z * z);
        r[5] = 2 * (y * z - w * x);
        r[6] = 2 * (x * z - w * y);
        r[7] = 2 * (y * z + w * x);
        r[8] = 1 - 2 * (x * x + y * y);
    }

    private static void rotate(double[] r, double x, double y, double z, double[] out) {
        out[0] = r[0] * x + r[1] * y + r[2] * z;
        out[1] = r[3] * x + r[4] * y + r[5] * z;
        out[2] = r[6] * x + r[7] * y + r[8] * z;
    }

    private static void add(double[] to, double[] what) {
        for (int k = 0; k < 3; k++) {
            to[k] += what[k];
        }
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }
}
