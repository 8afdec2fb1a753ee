package dev.cairn.physics.narrowphase.pair;

import dev.cairn.physics.shape.polyhedron.Polyhedron;

/**
 * The best axis of each kind for two polyhedra: a face normal of A, one of B, the common
 * perpendicular of two edges, and the axis that an iteration came with. Each separation is computed
 * from true supports along that axis, so each is a lower bound of the signed distance and the
 * largest is the answer.
 */
public final class Axes {
    /** Candidates per shape when edges are matched with a given axis. */
    private static final int NEAREST_EDGES = 3;

    public static final double NEVER = -Double.MAX_VALUE;

    /** Cosine of 8 degrees: edges whose perpendicular is farther from the axis are not its own. */
    private static final double ALIGNED = 0.99;

    public int faceA, faceB;
    public double separationA, separationB;

    /** The vertices that these faces met, where they were not found by the fifteen axes. */
    public int vertexOfB, vertexOfA;

    /**
     * Edges and their common unit perpendicular from A to B; {@code separationEdge} is {@link
     * #NEVER} without.
     */
    public int edgeA, edgeB;

    public double separationEdge, edgeX, edgeY, edgeZ;

    /** Of the best edge axis so far: separation times its size, and squared length. */
    private double signedSquare, square;

    /**
     * The axis as it came from an iteration; {@code separationRaw} is {@link #NEVER} when none ran.
     */
    public double separationRaw, rawX, rawY, rawZ;

    private final int[] nearA = new int[NEAREST_EDGES], nearB = new int[NEAREST_EDGES];
    private final double[] cosine = new double[NEAREST_EDGES];
    public double cx, cy, cz;
    private double crossDot, crossSquare;

    public double best() {
        return Math.max(
                Math.max(separationA, separationB), Math.max(separationEdge, separationRaw));
    }

    /** Only a bound is known. */
    public void clear(double bound) {
        separationA = NEVER;
        separationB = NEVER;
        separationEdge = NEVER;
        separationRaw = bound;
    }

    /**
     * The fifteen axes of two boxes (Gottschalk, Lin, Manocha 1996). Stops at the first that
     * separates by more than the margin.
     */
    public void boxes(Pair p, double margin) {
        separationRaw = NEVER;
        separationEdge = NEVER;
        separationA = NEVER;
        separationB = NEVER;
        double ax = p.a.vertexX(7);
        double ay = p.a.vertexY(7);
        double az = p.a.vertexZ(7);
        double bx = p.b.vertexX(7);
        double by = p.b.vertexY(7);
        double bz = p.b.vertexZ(7);
        boxFaceA(0, p.dx, ax + extent(p.r00, p.r01, p.r02, bx, by, bz));
        boxFaceA(2, p.dy, ay + extent(p.r10, p.r11, p.r12, bx, by, bz));
        boxFaceA(4, p.dz, az + extent(p.r20, p.r21, p.r22, bx, by, bz));
        if (separationA > margin) {
            return;
        }
        boxFaceB(
                0,
                p.dx * p.r00 + p.dy * p.r10 + p.dz * p.r20,
                bx + extent(p.r00, p.r10, p.r20, ax, ay, az));
        boxFaceB(
                2,
                p.dx * p.r01 + p.dy * p.r11 + p.dz * p.r21,
                by + extent(p.r01, p.r11, p.r21, ax, ay, az));
        boxFaceB(
                4,
                p.dx * p.r02 + p.dy * p.r12 + p.dz * p.r22,
                bz + extent(p.r02, p.r12, p.r22, ax, ay, az));
        if (separationB > margin) {
            return;
        }
        signedSquare = NEVER;
        square = 1;
        int pair = -1;
        pair =
                boxEdges(
                        p, 0, p.r00, p.r10, p.r20, ax, ay, az, by, bz, p.r01, p.r11, p.r21, p.r02,
                        p.r12, p.r22, pair);
        pair =
                boxEdges(
                        p, 1, p.r01, p.r11, p.r21, ax, ay, az, bx, bz, p.r00, p.r10, p.r20, p.r02,
                        p.r12, p.r22, pair);
        pair =
                boxEdges(
                        p, 2, p.r02, p.r12, p.r22, ax, ay, az, bx, by, p.r00, p.r10, p.r20, p.r01,
                        p.r11, p.r21, pair);
        if (pair >= 0) {
            double length = Math.sqrt(square);
            separationEdge /= length;
            edgeX /= length;
            edgeY /= length;
            edgeZ /= length;
            nameBoxEdges(p, pair / 3, pair % 3);
        }
    }

    private static double extent(double x, double y, double z, double hx, double hy, double hz) {
        return Math.abs(x) * hx + Math.abs(y) * hy + Math.abs(z) * hz;
    }

    private void boxFaceA(int face, double along, double reach) {
        double s = Math.abs(along) - reach;
        if (s > separationA) {
            separationA = s;
            faceA = along >= 0 ? face + 1 : face;
        }
    }

    private void boxFaceB(int face, double along, double reach) {
        double s = Math.abs(along) - reach;
        if (s > separationB) {
            separationB = s;
            faceB = along >= 0 ? face : face + 1;
        }
    }

    /**
     * Edge direction j of B, given as (x, y, z), with the three of A; (h1, u) and (h2, v) are B's
     * other half axes.
     */
    private int boxEdges(
            Pair p,
            int j,
            double x,
            double y,
            double z,
            double ax,
            double ay,
            double az,
            double h1,
            double h2,
            double ux,
            double uy,
            double uz,
            double vx,
            double vy,
            double vz,
            int pair) {
        int best = pair;
        double across = y * y + z * z;
        if (across > 0x1p-40) {
            double s =
                    Math.abs(p.dz * y - p.dy * z)
                            - ay * Math.abs(z)
                            - az * Math.abs(y)
                            - h1 * Math.abs(uz * y - uy * z)
                            - h2 * Math.abs(vz * y - vy * z);
            best = boxEdge(s, across, 0, -z, y, j, best);
        }
        across = x * x + z * z;
        if (across > 0x1p-40) {
            double s =
                    Math.abs(p.dx * z - p.dz * x)
                            - ax * Math.abs(z)
                            - az * Math.abs(x)
                            - h1 * Math.abs(ux * z - uz * x)
                            - h2 * Math.abs(vx * z - vz * x);
            best = boxEdge(s, across, z, 0, -x, 3 + j, best);
        }
        across = x * x + y * y;
        if (across > 0x1p-40) {
            double s =
                    Math.abs(p.dy * x - p.dx * y)
                            - ax * Math.abs(y)
                            - ay * Math.abs(x)
                            - h1 * Math.abs(uy * x - ux * y)
                            - h2 * Math.abs(vy * x - vx * y);
            best = boxEdge(s, across, -y, x, 0, 6 + j, best);
        }
        return best;
    }

    /**
     * Takes an axis (x, y, z), not of unit length, if it separates by more. Separations {@code s /
     * sqrt(square)} are compared as {@link dev.cairn.physics.narrowphase.wide.BoxAxes} compares
     * them, by {@code s |s| square'} against {@code s' |s'| square}.
     */
    private int boxEdge(
            double s, double across, double x, double y, double z, int pair, int before) {
        double signed = s * Math.abs(s);
        if (!(signed * square > signedSquare * across)) {
            return before;
        }
        signedSquare = signed;
        square = across;
        separationEdge = s;
        edgeX = x;
        edgeY = y;
        edgeZ = z;
        return pair;
    }

    /** Orients the edge axis from A to B and finds which edges of direction i and j it touches. */
    private void nameBoxEdges(Pair p, int i, int j) {
        if (edgeX * p.dx + edgeY * p.dy + edgeZ * p.dz < 0) {
            edgeX = -edgeX;
            edgeY = -edgeY;
            edgeZ = -edgeZ;
        }
        int va = (edgeX >= 0 ? 1 : 0) | (edgeY >= 0 ? 2 : 0) | (edgeZ >= 0 ? 4 : 0);
        edgeA = edge(p.a, va, va ^ (1 << i));
        double bx = p.r00 * edgeX + p.r10 * edgeY + p.r20 * edgeZ;
        double by = p.r01 * edgeX + p.r11 * edgeY + p.r21 * edgeZ;
        double bz = p.r02 * edgeX + p.r12 * edgeY + p.r22 * edgeZ;
        int vb = (bx <= 0 ? 1 : 0) | (by <= 0 ? 2 : 0) | (bz <= 0 ? 4 : 0);
        edgeB = edge(p.b, vb, vb ^ (1 << j));
    }

    private static int edge(Polyhedron h, int from, int to) {
        for (int s = h.spokeBegin(from); s < h.spokeBegin(from + 1); s++) {
            if (h.spokeVertex(s) == to) {
                return h.spokeEdge(s);
            }
        }
        throw new IllegalStateException("no edge from vertex " + from + " to " + to);
    }

    /**
     * Finds the features that a unit axis from A to B belongs to, and the exact separation along
     * each.
     */
    public void snap(Pair p, double x, double y, double z) {
        snap(p, x, y, z, p.endA(x, y, z), p.endB(-x, -y, -z));
    }

    /** The same where the support vertices along the axis are known. */
    public void snap(Pair p, double x, double y, double z, int va, int vb) {
        rawX = x;
        rawY = y;
        rawZ = z;
        double bx = p.r00 * x + p.r10 * y + p.r20 * z;
        double by = p.r01 * x + p.r11 * y + p.r21 * z;
        double bz = p.r02 * x + p.r12 * y + p.r22 * z;
        p.vertexB(vb);
        separationRaw =
                (p.px - p.a.vertexX(va)) * x
                        + (p.py - p.a.vertexY(va)) * y
                        + (p.pz - p.a.vertexZ(va)) * z;
        snapEdges(p, va, vb, bx, by, bz);
        boolean edges = separationEdge > NEVER;
        faceA = edges ? faceAtEdge(p.a, edgeA, x, y, z) : faceToward(p.a, va, x, y, z);
        separationA = p.faceSeparationA(faceA);
        vertexOfB = p.end;
        faceB = edges ? faceAtEdge(p.b, edgeB, -bx, -by, -bz) : faceToward(p.b, vb, -bx, -by, -bz);
        separationB = p.faceSeparationB(faceB);
        vertexOfA = p.end;
        // What a feature tells does not depend on how the search came to it; the axis as it came
        // from there does, in the last bits.
        double most = Math.max(separationEdge, Math.max(separationA, separationB));
        if (separationRaw <= most + 0x1p-50 * p.scale) {
            separationRaw = most;
        }
    }

    /** The same where the edges that the axis belongs to are known. */
    public void snapTo(Pair p, int ea, int eb, double x, double y, double z, double separation) {
        rawX = x;
        rawY = y;
        rawZ = z;
        separationRaw = separation;
        edgeA = ea;
        edgeB = eb;
        edgeX = x;
        edgeY = y;
        edgeZ = z;
        separationEdge = separation;
        double bx = p.r00 * x + p.r10 * y + p.r20 * z;
        double by = p.r01 * x + p.r11 * y + p.r21 * z;
        double bz = p.r02 * x + p.r12 * y + p.r22 * z;
        faceA = faceBeside(p.a, ea, x, y, z);
        separationA = p.faceSeparationA(faceA, p.b.edgeFrom(eb));
        vertexOfB = p.end;
        faceB = faceBeside(p.b, eb, -bx, -by, -bz);
        separationB = p.faceSeparationB(faceB, p.a.edgeFrom(ea));
        vertexOfA = p.end;
    }

    /** Of the two faces of an edge, the one whose normal is nearer to a direction. */
    private static int faceBeside(Polyhedron h, int edge, double x, double y, double z) {
        int f = h.edgeFace(edge, true);
        int g = h.edgeFace(edge, false);
        double df = h.normalX(f) * x + h.normalY(f) * y + h.normalZ(f) * z;
        double dg = h.normalX(g) * x + h.normalY(g) * y + h.normalZ(g) * z;
        return df > dg || (df == dg && f < g) ? f : g;
    }

    /** Both ends of an edge are support points up to rounding, so the faces of both compete. */
    private static int faceAtEdge(Polyhedron h, int edge, double x, double y, double z) {
        int f = faceToward(h, h.edgeFrom(edge), x, y, z);
        int g = faceToward(h, h.edgeTo(edge), x, y, z);
        double df = h.normalX(f) * x + h.normalY(f) * y + h.normalZ(f) * z;
        double dg = h.normalX(g) * x + h.normalY(g) * y + h.normalZ(g) * z;
        return df > dg || (df == dg && f < g) ? f : g;
    }

    /**
     * Of the faces at a vertex, the one whose normal is nearest to a direction; ties go to the
     * lowest.
     */
    public static int faceToward(Polyhedron h, int vertex, double x, double y, double z) {
        int best = -1;
        double most = NEVER;
        for (int s = h.spokeBegin(vertex); s < h.spokeBegin(vertex + 1); s++) {
            int f = h.spokeFace(s);
            double dot = h.normalX(f) * x + h.normalY(f) * y + h.normalZ(f) * z;
            if (dot > most || (dot == most && f < best)) {
                most = dot;
                best = f;
            }
        }
        return best;
    }

    private void snapEdges(Pair p, int va, int vb, double bx, double by, double bz) {
        separationEdge = NEVER;
        int countA = nearestEdges(p.a, va, rawX, rawY, rawZ, nearA);
        int countB = nearestEdges(p.b, vb, bx, by, bz, nearB);
        double align = ALIGNED * ALIGNED;
        boolean found = false;
        for (int i = 0; i < countA; i++) {
            for (int j = 0; j < countB; j++) {
                double square = alignment(p, nearA[i], nearB[j]);
                if (square > align) {
                    align = square;
                    edgeA = nearA[i];
                    edgeB = nearB[j];
                    found = true;
                }
            }
        }
        if (found) {
            cross(p, edgeA, edgeB);
            edgeX = cx;
            edgeY = cy;
            edgeZ = cz;
            separationEdge = p.separation(edgeX, edgeY, edgeZ);
        }
    }

    /** The edges at a vertex that are nearest to being perpendicular to an axis. */
    private int nearestEdges(Polyhedron h, int vertex, double x, double y, double z, int[] near) {
        int count = 0;
        for (int s = h.spokeBegin(vertex); s < h.spokeBegin(vertex + 1); s++) {
            int to = h.spokeVertex(s);
            double ex = h.vertexX(to) - h.vertexX(vertex);
            double ey = h.vertexY(to) - h.vertexY(vertex);
            double ez = h.vertexZ(to) - h.vertexZ(vertex);
            double dot = ex * x + ey * y + ez * z;
            double c = dot * dot / (ex * ex + ey * ey + ez * ez);
            int at = count;
            while (at > 0 && cosine[at - 1] > c) {
                at--;
            }
            if (at < NEAREST_EDGES) {
                count = Math.min(count + 1, NEAREST_EDGES);
                for (int k = count - 1; k > at; k--) {
                    near[k] = near[k - 1];
                    cosine[k] = cosine[k - 1];
                }
                near[at] = h.spokeEdge(s);
                cosine[at] = c;
            }
        }
        return count;
    }

    /**
     * Unit cross product of two edges, oriented along the raw axis, in cx, cy, cz; returns its
     * cosine with that axis.
     */
    public double cross(Pair p, int ea, int eb) {
        if (alignment(p, ea, eb) == 0) {
            return 0;
        }
        double scale = (crossDot < 0 ? -1 : 1) / Math.sqrt(crossSquare);
        cx *= scale;
        cy *= scale;
        cz *= scale;
        return Math.abs(crossDot * scale);
    }

    /**
     * The square of that cosine, and the product not of unit length; 0 for edges that are parallel.
     */
    private double alignment(Pair p, int ea, int eb) {
        Polyhedron a = p.a;
        Polyhedron b = p.b;
        double ux = a.vertexX(a.edgeTo(ea)) - a.vertexX(a.edgeFrom(ea));
        double uy = a.vertexY(a.edgeTo(ea)) - a.vertexY(a.edgeFrom(ea));
        double uz = a.vertexZ(a.edgeTo(ea)) - a.vertexZ(a.edgeFrom(ea));
        double lx = b.vertexX(b.edgeTo(eb)) - b.vertexX(b.edgeFrom(eb));
        double ly = b.vertexY(b.edgeTo(eb)) - b.vertexY(b.edgeFrom(eb));
        double lz = b.vertexZ(b.edgeTo(eb)) - b.vertexZ(b.edgeFrom(eb));
        double vx = p.r00 * lx + p.r01 * ly + p.r02 * lz;
        double vy = p.r10 * lx + p.r11 * ly + p.r12 * lz;
        double vz = p.r20 * lx + p.r21 * ly + p.r22 * lz;
        double nx = uy * vz - uz * vy;
        double ny = uz * vx - ux * vz;
        double nz = ux * vy - uy * vx;
        double square = nx * nx + ny * ny + nz * nz;
        double lengths = (ux * ux + uy * uy + uz * uz) * (lx * lx + ly * ly + lz * lz);
        if (square <= 0x1p-60 * lengths) {
            return 0;
        }
        double dot = nx * rawX + ny * rawY + nz * rawZ;
        cx = nx;
        cy = ny;
        cz = nz;
        crossDot = dot;
        crossSquare = square;
        return dot * dot / square;
    }
}
