package dev.cairn.physics.narrowphase.gjk;

import dev.cairn.physics.narrowphase.pair.Axes;
import dev.cairn.physics.narrowphase.pair.Pair;

/**
 * The distance of two polyhedra that are apart, from the features that {@link Gjk} ended on: the
 * plane of a face, the common perpendicular of two edges, or an edge and a vertex. A parallelogram
 * of two edges, or a face of four corners, is named by any three of its points, and these tell its
 * distance with different last bits; so wherever the search started from, the answer is the same.
 */
public final class NearestFeatures {
    /** Of the pair's scale: what rounding explains; else the points named something else. */
    private static final double SAME = 0x1p-42;

    /** Unit axis from A to B in A's frame, and the distance along it, m. */
    public double axisX, axisY, axisZ, distance;

    private Pair pair = Pair.NONE;

    /** After a run that ended apart. */
    public void measure(Pair p, Gjk g) {
        pair = p;
        take(g.vx, g.vy, g.vz, g.distance);
        double before = g.distance;
        if (g.count == 2) {
            segment(g);
        } else if (g.count == 3) {
            plane(g);
        }
        if (!(Math.abs(distance - before) <= SAME * p.scale)) {
            take(g.vx, g.vy, g.vz, before);
        }
    }

    private void take(double x, double y, double z, double length) {
        distance = length;
        axisX = x / length;
        axisY = y / length;
        axisZ = z / length;
    }

    /** The foot of the origin, as seen from either end, for neither comes first in a mirror. */
    private void segment(Gjk g) {
        double ex = g.wx[1] - g.wx[0];
        double ey = g.wy[1] - g.wy[0];
        double ez = g.wz[1] - g.wz[0];
        double square = ex * ex + ey * ey + ez * ez;
        double t = -(g.wx[0] * ex + g.wy[0] * ey + g.wz[0] * ez) / square;
        double u = (g.wx[1] * ex + g.wy[1] * ey + g.wz[1] * ez) / square;
        double x = 0.5 * ((g.wx[0] + t * ex) + (g.wx[1] - u * ex));
        double y = 0.5 * ((g.wy[0] + t * ey) + (g.wy[1] - u * ey));
        double z = 0.5 * ((g.wz[0] + t * ez) + (g.wz[1] - u * ez));
        double rest = (x * ex + y * ey + z * ez) / square;
        x -= rest * ex;
        y -= rest * ey;
        z -= rest * ez;
        take(x, y, z, Math.sqrt(x * x + y * y + z * z));
    }

    private void plane(Gjk g) {
        int ofA = distinct(g.ia);
        int ofB = distinct(g.ib);
        if (ofA == 3) {
            int face = Axes.faceToward(pair.a, g.ia[0], axisX, axisY, axisZ);
            axisX = pair.a.normalX(face);
            axisY = pair.a.normalY(face);
            axisZ = pair.a.normalZ(face);
            distance = pair.faceSeparationA(face, g.ib[0]);
        } else if (ofB == 3) {
            faceOfB(g);
        } else if (ofA == 2 && ofB == 2) {
            edges(g);
        }
    }

    private void faceOfB(Gjk g) {
        Pair p = pair;
        double x = -(p.r00 * axisX + p.r10 * axisY + p.r20 * axisZ);
        double y = -(p.r01 * axisX + p.r11 * axisY + p.r21 * axisZ);
        double z = -(p.r02 * axisX + p.r12 * axisY + p.r22 * axisZ);
        int face = Axes.faceToward(p.b, g.ib[0], x, y, z);
        x = p.b.normalX(face);
        y = p.b.normalY(face);
        z = p.b.normalZ(face);
        axisX = -(p.r00 * x + p.r01 * y + p.r02 * z);
        axisY = -(p.r10 * x + p.r11 * y + p.r12 * z);
        axisZ = -(p.r20 * x + p.r21 * y + p.r22 * z);
        distance = p.faceSeparationB(face, g.ia[0]);
    }

    /** The two edges, each from its middle: n = u x v, d = n . (b - a). */
    private void edges(Gjk g) {
        Pair p = pair;
        int a = Math.min(g.ia[0], Math.min(g.ia[1], g.ia[2]));
        int toA = Math.max(g.ia[0], Math.max(g.ia[1], g.ia[2]));
        int b = Math.min(g.ib[0], Math.min(g.ib[1], g.ib[2]));
        int toB = Math.max(g.ib[0], Math.max(g.ib[1], g.ib[2]));
        double ux = p.a.vertexX(toA) - p.a.vertexX(a);
        double uy = p.a.vertexY(toA) - p.a.vertexY(a);
        double uz = p.a.vertexZ(toA) - p.a.vertexZ(a);
        p.vertexB(toB);
        double vx = p.px;
        double vy = p.py;
        double vz = p.pz;
        p.vertexB(b);
        double wx = vx + p.px - (p.a.vertexX(toA) + p.a.vertexX(a));
        double wy = vy + p.py - (p.a.vertexY(toA) + p.a.vertexY(a));
        double wz = vz + p.pz - (p.a.vertexZ(toA) + p.a.vertexZ(a));
        vx -= p.px;
        vy -= p.py;
        vz -= p.pz;
        double nx = uy * vz - uz * vy;
        double ny = uz * vx - ux * vz;
        double nz = ux * vy - uy * vx;
        double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
        double scale = (nx * axisX + ny * axisY + nz * axisZ < 0 ? -1 : 1) / length;
        axisX = nx * scale;
        axisY = ny * scale;
        axisZ = nz * scale;
        // What rounding left of the product along the edge would count by the edge's length.
        double rest = (axisX * ux + axisY * uy + axisZ * uz) / (ux * ux + uy * uy + uz * uz);
        axisX -= rest * ux;
        axisY -= rest * uy;
        axisZ -= rest * uz;
        distance = 0.5 * (wx * axisX + wy * axisY + wz * axisZ);
    }

    /** How many of three vertices differ. */
    private static int distinct(int[] v) {
        if (v[0] == v[1]) {
            return v[1] == v[2] ? 1 : 2;
        }
        return v[0] == v[2] || v[1] == v[2] ? 2 : 3;
    }
}
