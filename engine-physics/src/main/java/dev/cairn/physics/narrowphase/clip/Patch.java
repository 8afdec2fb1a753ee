package dev.cairn.physics.narrowphase.clip;

import dev.cairn.physics.internal.Surface;
import dev.cairn.physics.narrowphase.pair.Axes;
import dev.cairn.physics.narrowphase.pair.FeatureIds;
import dev.cairn.physics.narrowphase.pair.Pair;
import dev.cairn.physics.narrowphase.pair.SolidOfRevolution;
import dev.cairn.physics.shape.Box;
import dev.cairn.physics.shape.polyhedron.Polyhedron;

import java.util.Arrays;

/**
 * What a shape touches with in a direction: the flat that looks most along it (a face or a disc)
 * and the line of its surface there (an edge, or a line of the side of a capsule, cylinder or
 * cone). In A's frame, whichever shape it is; the radius of a capsule is in it.
 */
public final class Patch {
    public static final int NONE = 0;
    public static final int FACE = 1;
    public static final int DISC = 2;

    /** Mean distance of a disc's area from its middle, over that of its rim. */
    public static final double DISC_SHARE = 2.0 / 3;

    /** Names of the ends of a line, of a cap's rim from 0, and of sides where they cross others. */
    public static final int END = Surface.UPPER_END - 1;

    /** Name of a cone's tip, the upper end of its side. */
    public static final int TIP = Surface.UPPER_END;

    /** {@link #NONE}, {@link #FACE} or {@link #DISC}, its outward normal and a point of it. */
    public int flat;

    public double nx, ny, nz, ox, oy, oz;

    /** Of the angle of the flat's normal with the direction. */
    public double cosine;

    /** Of a disc, in m. */
    double radius;

    /** The first name of the disc's rim. */
    int rim;

    /** Whose face the flat is, and which. */
    Polyhedron hull = Polyhedron.of(Box.cubeOfHalfExtent(1));

    int face;

    /** Corners of a face in A's frame, counter-clockwise seen from outside. */
    int count;

    double[] x = new double[16], y = new double[16], z = new double[16];
    int[] vertex = new int[16], edge = new int[16];

    /** Ends of the line; the radius of curvature across it, m. */
    public boolean line;

    public double px, py, pz, qx, qy, qz, bend;

    /** Names of the ends and of the line. */
    public int nameP, nameQ, nameLine;

    /** The flat lies nearer to the direction than the line. */
    public boolean flatter;

    /** The shape is the second one. */
    public boolean second;

    /** {@link FeatureIds#VERTEX_A} or {@link FeatureIds#VERTEX_B}. */
    public int kind;

    private Pair pair = Pair.NONE;

    /** Looks along a unit direction of A's frame. */
    public void fill(Pair p, boolean ofB, double dx, double dy, double dz) {
        pair = p;
        second = ofB;
        kind = ofB ? FeatureIds.VERTEX_B : FeatureIds.VERTEX_A;
        flat = NONE;
        line = false;
        flatter = false;
        cosine = -1;
        count = 0;
        double x0 = dx;
        double y0 = dy;
        double z0 = dz;
        if (ofB) {
            x0 = p.r00 * dx + p.r10 * dy + p.r20 * dz;
            y0 = p.r01 * dx + p.r11 * dy + p.r21 * dz;
            z0 = p.r02 * dx + p.r12 * dy + p.r22 * dz;
        }
        if (ofB ? p.roundB : p.roundA) {
            solid(ofB ? p.solidB : p.solidA, x0, y0, z0);
        } else {
            polyhedron(ofB ? p.b : p.a, x0, y0, z0);
        }
    }

    private void solid(SolidOfRevolution s, double dx, double dy, double dz) {
        double across = Math.sqrt(dx * dx + dz * dz);
        double ux = across > 0 ? dx / across : 1;
        double uz = across > 0 ? dz / across : 0;
        boolean top = dy >= s.sideAlong;
        double cap = top ? s.highRadius : s.lowRadius;
        if (cap > 0) {
            flat = DISC;
            cosine = top ? dy : -dy;
            radius = cap;
            rim = top ? 8 : 0;
            setNormal(0, top ? 1 : -1, 0);
            placeOrigin(0, top ? s.high : s.low, 0);
        }
        if (!s.isPoint()) {
            // Cosine of the angle with the nearest normal of the side.
            double side = dy * s.sideAlong + across * s.sideAcross;
            line = true;
            flatter = flat == DISC && cosine > side;
            double ex = s.round * dx;
            double ey = s.round * dy;
            double ez = s.round * dz;
            placeP(s.lowRadius * ux + ex, s.low + ey, s.lowRadius * uz + ez);
            placeQ(s.highRadius * ux + ex, s.high + ey, s.highRadius * uz + ez);
            nameP = kind | END;
            nameQ = kind | (END + 1);
            nameLine = END;
            bend = s.round + 0.5 * (s.lowRadius + s.highRadius);
        }
    }

    private void polyhedron(Polyhedron h, double dx, double dy, double dz) {
        int v = h.support(dx, dy, dz);
        hull = h;
        face = Axes.faceToward(h, v, dx, dy, dz);
        flat = FACE;
        flatter = true;
        double fx = h.normalX(face);
        double fy = h.normalY(face);
        double fz = h.normalZ(face);
        cosine = fx * dx + fy * dy + fz * dz;
        setNormal(fx, fy, fz);
        int begin = h.faceBegin(face);
        count = h.faceBegin(face + 1) - begin;
        if (count > x.length) {
            grow(count);
        }
        for (int i = 0; i < count; i++) {
            int corner = h.slotVertex(begin + i);
            placeOrigin(h.vertexX(corner), h.vertexY(corner), h.vertexZ(corner));
            x[i] = ox;
            y[i] = oy;
            z[i] = oz;
            vertex[i] = corner;
            edge[i] = h.slotEdge(begin + i);
        }
        placeOrigin(fx * h.offset(face), fy * h.offset(face), fz * h.offset(face));
        edge(h, v, dx, dy, dz);
    }

    /** The edge at the support vertex that is nearest to being at right angles. */
    private void edge(Polyhedron h, int v, double dx, double dy, double dz) {
        double least = 2;
        int best = -1;
        for (int s = h.spokeBegin(v); s < h.spokeBegin(v + 1); s++) {
            int to = h.spokeVertex(s);
            double ex = h.vertexX(to) - h.vertexX(v);
            double ey = h.vertexY(to) - h.vertexY(v);
            double ez = h.vertexZ(to) - h.vertexZ(v);
            double c =
                    Math.abs(ex * dx + ey * dy + ez * dz) / Math.sqrt(ex * ex + ey * ey + ez * ez);
            if (c < least) {
                least = c;
                best = h.spokeEdge(s);
            }
        }
        line = true;
        bend = 0;
        int from = h.edgeFrom(best);
        int to = h.edgeTo(best);
        placeP(h.vertexX(from), h.vertexY(from), h.vertexZ(from));
        placeQ(h.vertexX(to), h.vertexY(to), h.vertexZ(to));
        nameP = kind | from;
        nameQ = kind | to;
        nameLine = best;
    }

    private void grow(int need) {
        x = Arrays.copyOf(x, need);
        y = Arrays.copyOf(y, need);
        z = Arrays.copyOf(z, need);
        vertex = Arrays.copyOf(vertex, need);
        edge = Arrays.copyOf(edge, need);
    }

    private double turnX(double a, double b, double c) {
        return second ? pair.r00 * a + pair.r01 * b + pair.r02 * c : a;
    }

    private double turnY(double a, double b, double c) {
        return second ? pair.r10 * a + pair.r11 * b + pair.r12 * c : b;
    }

    private double turnZ(double a, double b, double c) {
        return second ? pair.r20 * a + pair.r21 * b + pair.r22 * c : c;
    }

    private void setNormal(double a, double b, double c) {
        nx = turnX(a, b, c);
        ny = turnY(a, b, c);
        nz = turnZ(a, b, c);
    }

    private void placeOrigin(double a, double b, double c) {
        ox = turnX(a, b, c) + (second ? pair.dx : 0);
        oy = turnY(a, b, c) + (second ? pair.dy : 0);
        oz = turnZ(a, b, c) + (second ? pair.dz : 0);
    }

    private void placeP(double a, double b, double c) {
        px = turnX(a, b, c) + (second ? pair.dx : 0);
        py = turnY(a, b, c) + (second ? pair.dy : 0);
        pz = turnZ(a, b, c) + (second ? pair.dz : 0);
    }

    private void placeQ(double a, double b, double c) {
        qx = turnX(a, b, c) + (second ? pair.dx : 0);
        qy = turnY(a, b, c) + (second ? pair.dy : 0);
        qz = turnZ(a, b, c) + (second ? pair.dz : 0);
    }

    /**
     * How far along a direction the plane of the flat is from a point: t with (point + t direction)
     * in the plane.
     */
    double height(double ax, double ay, double az, double dx, double dy, double dz) {
        return ((ox - ax) * nx + (oy - ay) * ny + (oz - az) * nz) / (nx * dx + ny * dy + nz * dz);
    }
}
