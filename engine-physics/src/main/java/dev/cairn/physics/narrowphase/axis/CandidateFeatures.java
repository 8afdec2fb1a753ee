package dev.cairn.physics.narrowphase.axis;

import dev.cairn.physics.narrowphase.pair.Axes;
import dev.cairn.physics.narrowphase.pair.Pair;
import dev.cairn.physics.narrowphase.pair.SolidOfRevolution;
import dev.cairn.physics.shape.polyhedron.Polyhedron;

/**
 * The features of one shape of a pair whose normals are near a direction: flats (one normal), lines
 * (a circle of normals), and vertices or rims (a region of normals). Everything in A's frame and
 * turned towards B.
 */
final class CandidateFeatures {
    static final int MOST = 16;
    private static final int EDGES = 3;

    /** Sine of the angle, 1e-3 rad, within which a wide look takes in what touches as well. */
    private static final double WIDE = 0x1p-10;

    int flats, lines, points;
    final double[] flatX = new double[MOST], flatY = new double[MOST], flatZ = new double[MOST];

    /** Circles: n . c = level. */
    final double[] lineX = new double[MOST],
            lineY = new double[MOST],
            lineZ = new double[MOST],
            level = new double[MOST];

    /** A point of each line or a disc, from A's centre; with the radius of the disc. */
    final double[] px = new double[2 * MOST],
            py = new double[2 * MOST],
            pz = new double[2 * MOST],
            radius = new double[2 * MOST];

    /** The same points from the shape's own centre. */
    final double[] ownX = new double[2 * MOST],
            ownY = new double[2 * MOST],
            ownZ = new double[2 * MOST];

    /** Half the length of each line of a polyhedron. */
    final double[] half = new double[MOST];

    /** The faces, edges and vertices of a polyhedron that these are; -1 for hidden ones. */
    final int[] flatFace = new int[MOST];

    private final int[] lineEdge = new int[MOST], pointVertex = new int[MOST];
    private final int[] corner = new int[MOST];

    /** The axis of the discs. */
    double ax, ay, az;

    final double[] cosine = new double[EDGES];
    final int[] edge = new int[EDGES];

    private final boolean flip;
    private Pair pair = Pair.NONE;
    private boolean wide;

    CandidateFeatures(boolean ofB) {
        flip = ofB;
    }

    /**
     * Looks along a unit direction of A's frame, from the shape outwards; of a polyhedron at one
     * corner, or wide, at all that touch up to an angle.
     */
    void gather(Pair p, double dx, double dy, double dz, boolean widely) {
        pair = p;
        wide = widely;
        flats = 0;
        lines = 0;
        points = 0;
        double x = dx;
        double y = dy;
        double z = dz;
        if (flip) {
            x = p.r00 * dx + p.r10 * dy + p.r20 * dz;
            y = p.r01 * dx + p.r11 * dy + p.r21 * dz;
            z = p.r02 * dx + p.r12 * dy + p.r22 * dz;
        }
        if (flip ? p.roundB : p.roundA) {
            solid(flip ? p.solidB : p.solidA, y);
        } else {
            polyhedron(flip ? p.b : p.a, x, y, z);
            if (wide) {
                spread(flip ? p.b : p.a, x, y, z);
            }
        }
    }

    private void solid(SolidOfRevolution c, double along) {
        ax = flip ? pair.r01 : 0;
        ay = flip ? pair.r11 : 1;
        az = flip ? pair.r21 : 0;
        double sign = flip ? -1 : 1;
        if (along > 0.5 && c.highRadius > 0) {
            flat(sign * ax, sign * ay, sign * az);
        }
        if (along < -0.5 && c.lowRadius > 0) {
            flat(-sign * ax, -sign * ay, -sign * az);
        }
        if (c.isPoint()) {
            point(c.high, 0);
            return;
        }
        if (Math.abs(along - c.sideAlong) < 0.5) {
            line(ax, ay, az, sign * c.sideAlong);
            disc(lines - 1, c.high, c.highRadius);
        }
        boolean nearSide = Math.abs(along - c.sideAlong) < 0.1;
        if (nearSide || along >= c.sideAlong) {
            point(c.high, c.highRadius);
        }
        if (nearSide || along < c.sideAlong) {
            point(c.low, c.lowRadius);
        }
    }

    private void flat(double x, double y, double z) {
        flatX[flats] = x;
        flatY[flats] = y;
        flatZ[flats++] = z;
    }

    private void line(double x, double y, double z, double cosineWithAxis) {
        lineX[lines] = x;
        lineY[lines] = y;
        lineZ[lines] = z;
        level[lines++] = cosineWithAxis;
    }

    private void point(double height, double rimRadius) {
        disc(MOST + points++, height, rimRadius);
    }

    private void disc(int at, double height, double rimRadius) {
        radius[at] = rimRadius;
        place(at, ax * height, ay * height, az * height);
    }

    private void polyhedron(Polyhedron h, double x, double y, double z) {
        ax = 0;
        ay = 1;
        az = 0;
        int v = support(h, x, y, z);
        face(h, Axes.faceToward(h, v, x, y, z));
        vertex(h, v);
        int edges = nearestEdges(h, v, x, y, z);
        for (int i = 0; i < edges; i++) {
            edge(h, edge[i]);
        }
    }

    /** Adds what is connected to the corner by edges that lie across the direction. */
    private void spread(Polyhedron h, double x, double y, double z) {
        for (int i = 0; i < points; i++) {
            int v = pointVertex[i];
            for (int s = h.spokeBegin(v); s < h.spokeBegin(v + 1); s++) {
                int to = h.spokeVertex(s);
                double ex = h.vertexX(to) - h.vertexX(v);
                double ey = h.vertexY(to) - h.vertexY(v);
                double ez = h.vertexZ(to) - h.vertexZ(v);
                double dot = ex * x + ey * y + ez * z;
                if (dot * dot <= WIDE * WIDE * (ex * ex + ey * ey + ez * ez)) {
                    edge(h, h.spokeEdge(s));
                    vertex(h, to);
                }
                int f = h.spokeFace(s);
                if (h.normalX(f) * x + h.normalY(f) * y + h.normalZ(f) * z >= 1 - WIDE * WIDE) {
                    face(h, f);
                }
            }
        }
    }

    /**
     * Faces that were merged from nearly coplanar ones have lost edges and planes: all of two and
     * three corners are taken, in the order of their numbers, which is the same in a mirror.
     */
    private void hidden(Polyhedron h, int face) {
        int corners = sorted(h, face);
        for (int i = 0; i < corners; i++) {
            vertex(h, corner[i]);
            for (int j = i + 1; j < corners; j++) {
                if (lines < MOST) {
                    lineEdge[lines] = -1;
                    segment(h, corner[i], corner[j]);
                }
                for (int k = j + 1; k < corners; k++) {
                    plane(h, face, corner[i], corner[j], corner[k]);
                }
            }
        }
    }

    /** The corners of a face, by number, as many as there is room for. */
    private int sorted(Polyhedron h, int face) {
        int count = 0;
        for (int s = h.faceBegin(face); s < h.faceBegin(face + 1); s++) {
            int v = h.slotVertex(s);
            int at = Math.min(count, MOST - 1);
            if (count == MOST && corner[at] < v) {
                continue;
            }
            while (at > 0 && corner[at - 1] > v) {
                corner[at] = corner[at - 1];
                at--;
            }
            corner[at] = v;
            count = Math.min(count + 1, MOST);
        }
        return count;
    }

    private void plane(Polyhedron h, int face, int u, int v, int w) {
        double ex = h.vertexX(v) - h.vertexX(u);
        double ey = h.vertexY(v) - h.vertexY(u);
        double ez = h.vertexZ(v) - h.vertexZ(u);
        double fx = h.vertexX(w) - h.vertexX(u);
        double fy = h.vertexY(w) - h.vertexY(u);
        double fz = h.vertexZ(w) - h.vertexZ(u);
        double x = ey * fz - ez * fy;
        double y = ez * fx - ex * fz;
        double z = ex * fy - ey * fx;
        double length = Math.sqrt(x * x + y * y + z * z);
        if (flats < MOST && length > 0) {
            double out = x * h.normalX(face) + y * h.normalY(face) + z * h.normalZ(face);
            double scale = (out < 0 ? -1 : 1) / length;
            flatFace[flats] = -1;
            facing(x * scale, y * scale, z * scale);
        }
    }

    private static boolean isNew(int[] known, int count, int item) {
        for (int i = 0; i < count; i++) {
            if (known[i] == item) {
                return false;
            }
        }
        return count < MOST;
    }

    private void face(Polyhedron h, int face) {
        if (!isNew(flatFace, flats, face)) {
            return;
        }
        flatFace[flats] = face;
        facing(h.normalX(face), h.normalY(face), h.normalZ(face));
        if (wide && h.isUneven(face)) {
            hidden(h, face);
        }
    }

    private void facing(double x, double y, double z) {
        if (flip) {
            flat(-turnX(x, y, z), -turnY(x, y, z), -turnZ(x, y, z));
        } else {
            flat(x, y, z);
        }
    }

    private void edge(Polyhedron h, int e) {
        if (!isNew(lineEdge, lines, e)) {
            return;
        }
        lineEdge[lines] = e;
        segment(h, h.edgeFrom(e), h.edgeTo(e));
    }

    private void segment(Polyhedron h, int from, int to) {
        double ex = h.vertexX(to) - h.vertexX(from);
        double ey = h.vertexY(to) - h.vertexY(from);
        double ez = h.vertexZ(to) - h.vertexZ(from);
        double length = Math.sqrt(ex * ex + ey * ey + ez * ez);
        half[lines] = 0.5 * length;
        ex /= length;
        ey /= length;
        ez /= length;
        if (flip) {
            line(turnX(ex, ey, ez), turnY(ex, ey, ez), turnZ(ex, ey, ez), 0);
        } else {
            line(ex, ey, ez, 0);
        }
        // The middle, for of an edge that lies right across both ends are as good.
        turned(
                lines - 1,
                0.5 * (h.vertexX(from) + h.vertexX(to)),
                0.5 * (h.vertexY(from) + h.vertexY(to)),
                0.5 * (h.vertexZ(from) + h.vertexZ(to)));
    }

    private void vertex(Polyhedron h, int v) {
        if (isNew(pointVertex, points, v)) {
            pointVertex[points] = v;
            turned(MOST + points++, h.vertexX(v), h.vertexY(v), h.vertexZ(v));
        }
    }

    /** The support vertex; towards the other shape where the direction does not tell. */
    private int support(Polyhedron h, double x, double y, double z) {
        if (x != 0 && y != 0 && z != 0) {
            return h.support(x, y, z);
        }
        Pair p = pair;
        double ox = flip ? -(p.r00 * p.dx + p.r10 * p.dy + p.r20 * p.dz) : p.dx;
        double oy = flip ? -(p.r01 * p.dx + p.r11 * p.dy + p.r21 * p.dz) : p.dy;
        double oz = flip ? -(p.r02 * p.dx + p.r12 * p.dy + p.r22 * p.dz) : p.dz;
        return h.support(x, y, z, ox, oy, oz);
    }

    private void turned(int at, double x, double y, double z) {
        radius[at] = 0;
        if (flip) {
            place(at, turnX(x, y, z), turnY(x, y, z), turnZ(x, y, z));
        } else {
            place(at, x, y, z);
        }
    }

    private void place(int at, double x, double y, double z) {
        ownX[at] = x;
        ownY[at] = y;
        ownZ[at] = z;
        px[at] = x + (flip ? pair.dx : 0);
        py[at] = y + (flip ? pair.dy : 0);
        pz[at] = z + (flip ? pair.dz : 0);
    }

    double turnX(double x, double y, double z) {
        return pair.r00 * x + pair.r01 * y + pair.r02 * z;
    }

    double turnY(double x, double y, double z) {
        return pair.r10 * x + pair.r11 * y + pair.r12 * z;
    }

    double turnZ(double x, double y, double z) {
        return pair.r20 * x + pair.r21 * y + pair.r22 * z;
    }

    private int nearestEdges(Polyhedron h, int v, double x, double y, double z) {
        int count = 0;
        for (int k = h.spokeBegin(v); k < h.spokeBegin(v + 1); k++) {
            int to = h.spokeVertex(k);
            double ex = h.vertexX(to) - h.vertexX(v);
            double ey = h.vertexY(to) - h.vertexY(v);
            double ez = h.vertexZ(to) - h.vertexZ(v);
            double c = Math.abs(ex * x + ey * y + ez * z) / Math.sqrt(ex * ex + ey * ey + ez * ez);
            int at = count;
            while (at > 0 && cosine[at - 1] > c) {
                at--;
            }
            if (at < EDGES) {
                count = Math.min(count + 1, EDGES);
                for (int m = count - 1; m > at; m--) {
                    cosine[m] = cosine[m - 1];
                    edge[m] = edge[m - 1];
                }
                cosine[at] = c;
                edge[at] = h.spokeEdge(k);
            }
        }
        return count;
    }

    /**
     * Whether the shape reaches along a direction with the vertex or rim at a place. Far apart the
     * separations of all axes are equal up to rounding, and would not tell.
     */
    boolean reachesWith(int at, double x, double y, double z) {
        double along = x * ax + y * ay + z * az;
        double ux = x - along * ax;
        double uy = y - along * ay;
        double uz = z - along * az;
        double rim = radius[at] * Math.sqrt(ux * ux + uy * uy + uz * uz);
        double own = x * ownX[at] + y * ownY[at] + z * ownZ[at] + rim;
        double most = flip ? pair.reachB(x, y, z) : pair.reachA(x, y, z);
        return own >= most - 0x1p-40 * pair.small;
    }
}
