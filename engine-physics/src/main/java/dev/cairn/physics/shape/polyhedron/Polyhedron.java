package dev.cairn.physics.shape.polyhedron;

import java.util.Arrays;

/**
 * The features of a convex polyhedron, relative to its centre of mass, in shape axes: vertices,
 * faces as counter-clockwise loops with their outward planes, edges with their two faces.
 * Immutable, but for {@link #setTriangle}; all arrays are private, every accessor is a plain read
 * without allocation.
 *
 * <p>A <em>slot</em> is a position in the concatenation of all face loops: slot {@code faceBegin(f)
 * + k} is the {@code k}-th corner of face {@code f} and at the same time the side that leaves that
 * corner. A <em>spoke</em> is a position in the concatenation of all vertex neighbour lists.
 */
public final class Polyhedron {
    /**
     * Most vertices a polyhedron may have: its at most 3 V - 6 edges then fit the 15 bits of a
     * contact's feature id.
     */
    public static final int MAX_VERTICES = 10_922;

    /** Up to so many vertices are scanned for a support point, more are climbed. */
    private static final int SCANNED = 40;

    /** Three numbers of a vertex lie side by side; so do a plane's normal and offset. */
    final double[] vertex, plane, sidePlane;

    private final int[] faceBegin;
    private final int[] slotVertex, slotEdge;
    private final int[] edgeFrom, edgeTo, edgeLeft, edgeRight;
    private final int[] spokeBegin, spokeVertex, spokeEdge, spokeFace;
    private double innerRadius;
    double outerRadius;
    private final int largestFace;
    private final int[] extremes;

    /** Made by {@link #box}: the signs of a direction name the vertex. */
    private final boolean block;

    /** Faces whose corners are not in one plane, but for what coplanar faces are merged within. */
    private final boolean[] uneven;

    private final boolean anyUneven;

    /** The faces that lie nearly in the plane of another. */
    public final LevelFaces level;

    /**
     * Assembles the topology from vertices and loops.
     *
     * @param loops counter-clockwise loops, every edge in exactly two of them, once in each
     *     direction
     */
    public Polyhedron(double[] x, double[] y, double[] z, int[][] loops) {
        this(x, y, z, loops, false);
    }

    private Polyhedron(double[] x, double[] y, double[] z, int[][] loops, boolean block) {
        this.block = block;
        vertex = pack(x, y, z, new double[x.length]);
        Topology topology = new Topology(x.length, loops);
        faceBegin = topology.faceBegin;
        slotVertex = topology.slotVertex;
        slotEdge = topology.slotEdge;
        edgeFrom = topology.edgeFrom;
        edgeTo = topology.edgeTo;
        edgeLeft = topology.edgeLeft;
        edgeRight = topology.edgeRight;
        spokeBegin = topology.spokeBegin;
        spokeVertex = topology.spokeVertex;
        spokeEdge = topology.spokeEdge;
        spokeFace = topology.spokeFace;
        largestFace = topology.largestFace;
        FacePlanes planes = new FacePlanes(x, y, z, topology);
        plane = pack(planes.normalX, planes.normalY, planes.normalZ, planes.offset);
        sidePlane = pack(planes.sideX, planes.sideY, planes.sideZ, planes.sideOffset);
        uneven = planes.uneven;
        anyUneven = planes.anyUneven;
        double inner = Double.MAX_VALUE;
        for (int f = 0; f < faceCount(); f++) {
            double nx = normalX(f);
            double ny = normalY(f);
            double nz = normalZ(f);
            int top = support(nx, ny, nz, slotVertex[faceBegin[f]]);
            plane[4 * f + 3] = Math.max(offset(f), along(top, nx, ny, nz));
            inner = Math.min(inner, offset(f));
        }
        innerRadius = inner;
        double outer = 0;
        for (int v = 0; v < x.length; v++) {
            outer = Math.max(outer, x[v] * x[v] + y[v] * y[v] + z[v] * z[v]);
        }
        outerRadius = Math.sqrt(outer);
        extremes = Topology.extremes(x, y, z);
        level = new LevelFaces(this);
    }

    private static double[] pack(double[] x, double[] y, double[] z, double[] w) {
        double[] packed = new double[4 * x.length];
        for (int i = 0; i < x.length; i++) {
            packed[4 * i] = x[i];
            packed[4 * i + 1] = y[i];
            packed[4 * i + 2] = z[i];
            packed[4 * i + 3] = w[i];
        }
        return packed;
    }

    /**
     * A block; bit k of a vertex index is the sign of axis k, face 2 k + s looks along axis k with
     * sign s.
     */
    public static Polyhedron box(double hx, double hy, double hz) {
        double[] x = new double[8];
        double[] y = new double[8];
        double[] z = new double[8];
        for (int v = 0; v < 8; v++) {
            x[v] = (v & 1) == 0 ? -hx : hx;
            y[v] = (v & 2) == 0 ? -hy : hy;
            z[v] = (v & 4) == 0 ? -hz : hz;
        }
        int[][] loops = {
            {0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6},
        };
        return new Polyhedron(x, y, z, loops, true);
    }

    /**
     * A triangle without thickness: three vertices, three edges and two faces, the first of which
     * sees its corners counter-clockwise. To be placed by {@link #setTriangle}.
     */
    public static Polyhedron triangle() {
        double[] x = {0, 1, -1};
        double[] y = {1, -1, 0};
        Polyhedron flat = new Polyhedron(x, y, new double[3], new int[][] {{0, 1, 2}, {0, 2, 1}});
        flat.innerRadius = 0;
        return flat;
    }

    /**
     * Places the corners of a {@link #triangle}. Whoever made it does this between collisions; no
     * other thread may know it.
     *
     * @param corners three times x, y, z, m; not on one line
     * @param ox the point that the vertices are relative to, m
     */
    public void setTriangle(double[] corners, double ox, double oy, double oz) {
        TrianglePlanes.set(this, corners, ox, oy, oz);
    }

    /** The faces, edges and vertices of a shape that has such. */
    public static Polyhedron of(Polyhedral shape) {
        return shape.polyhedron;
    }

    /** How many vertices: at least 4, of a triangle 3, at most {@link #MAX_VERTICES}. */
    public int vertexCount() {
        return vertex.length >> 2;
    }

    /** How many faces: at least 4. */
    public int faceCount() {
        return plane.length >> 2;
    }

    /** How many edges: at least 6. There are twice as many slots and spokes. */
    public int edgeCount() {
        return edgeFrom.length;
    }

    /** Corners of the face that has most. */
    public int largestFace() {
        return largestFace;
    }

    /** A coordinate of a vertex relative to the centre of mass, m. */
    public double vertexX(int vertex) {
        return this.vertex[4 * vertex];
    }

    /** See {@link #vertexX}. */
    public double vertexY(int vertex) {
        return this.vertex[4 * vertex + 1];
    }

    /** See {@link #vertexX}. */
    public double vertexZ(int vertex) {
        return this.vertex[4 * vertex + 2];
    }

    /** The first slot of a face; its loop ends before {@code faceBegin(face + 1)}. */
    public int faceBegin(int face) {
        return faceBegin[face];
    }

    /** The vertex that is the corner at a slot. */
    public int slotVertex(int slot) {
        return slotVertex[slot];
    }

    /** The edge from the corner at a slot to the next corner of the loop. */
    public int slotEdge(int slot) {
        return slotEdge[slot];
    }

    /**
     * Whether the corners of a face are not in one plane: it was merged from nearly coplanar ones,
     * and the edges between those are not listed. Never of a triangle.
     */
    public boolean isUneven(int face) {
        return uneven[face];
    }

    /** A component of the outward unit normal of a face. */
    public double normalX(int face) {
        return plane[4 * face];
    }

    /** See {@link #normalX}. */
    public double normalY(int face) {
        return plane[4 * face + 1];
    }

    /** See {@link #normalX}. */
    public double normalZ(int face) {
        return plane[4 * face + 2];
    }

    /**
     * Distance of a face's plane from the centre of mass, m: inside means {@code normal . p <=
     * offset}.
     */
    public double offset(int face) {
        return plane[4 * face + 3];
    }

    /**
     * Unit vector in the plane of the face, at right angles to the side at a slot, pointing out of
     * the face.
     */
    public double sideX(int slot) {
        return sidePlane[4 * slot];
    }

    /** See {@link #sideX}. */
    public double sideY(int slot) {
        return sidePlane[4 * slot + 1];
    }

    /** See {@link #sideX}. */
    public double sideZ(int slot) {
        return sidePlane[4 * slot + 2];
    }

    /** Offset of the side plane at a slot, m: inside means {@code side . p <= sideOffset}. */
    public double sideOffset(int slot) {
        return sidePlane[4 * slot + 3];
    }

    /** The vertex at one end of an edge. */
    public int edgeFrom(int edge) {
        return edgeFrom[edge];
    }

    /** The vertex at the other end of an edge. */
    public int edgeTo(int edge) {
        return edgeTo[edge];
    }

    /** The face to the left of an edge's direction, seen from outside, or the other one. */
    public int edgeFace(int edge, boolean left) {
        return left ? edgeLeft[edge] : edgeRight[edge];
    }

    /** The first spoke of a vertex; its list ends before {@code spokeBegin(vertex + 1)}. */
    public int spokeBegin(int vertex) {
        return spokeBegin[vertex];
    }

    /** The neighbour at the other end of a spoke. */
    public int spokeVertex(int spoke) {
        return spokeVertex[spoke];
    }

    /** The edge of a spoke. */
    public int spokeEdge(int spoke) {
        return spokeEdge[spoke];
    }

    /** The face left of a spoke; over the spokes of a vertex, each of its faces once. */
    public int spokeFace(int spoke) {
        return spokeFace[spoke];
    }

    /** The radius of the largest ball around the centre of mass inside, m. */
    public double innerRadius() {
        return innerRadius;
    }

    /** The radius of the smallest ball around the centre of mass outside, m. */
    public double outerRadius() {
        return outerRadius;
    }

    /**
     * The vertex farthest in a direction. Few vertices are scanned, ties go to the lowest index;
     * many are climbed from the extreme vertex of the direction's main axis along the edges, which
     * ends at the same value because a local maximum of a linear function on a convex body is a
     * global one.
     *
     * @param dx direction in shape axes, any length
     * @param dy direction
     * @param dz direction
     * @return the vertex
     */
    public int support(double dx, double dy, double dz) {
        if (block) {
            return (dx > 0 ? 1 : 0) | (dy > 0 ? 2 : 0) | (dz > 0 ? 4 : 0);
        }
        int n = vertexCount();
        return n > SCANNED
                ? climb(dx, dy, dz, start(dx, dy, dz))
                : n == 3 ? TrianglePlanes.support(this, dx, dy, dz) : scan(dx, dy, dz);
    }

    /**
     * The first vertex with the greatest product. That is not negative, for the centre is inside,
     * so its bits are the greatest as well, and their maximum takes no branch that a processor
     * would have to guess.
     */
    private int scan(double dx, double dy, double dz) {
        double[] p = vertex;
        long most = Long.MIN_VALUE;
        for (int i = 0; i < p.length - 3; i += 4) {
            double dot = p[i] * dx + p[i + 1] * dy + p[i + 2] * dz;
            most = Math.max(most, Double.doubleToRawLongBits(dot));
        }
        double greatest = Double.longBitsToDouble(most);
        for (int i = 0; i < p.length - 3; i += 4) {
            if (p[i] * dx + p[i + 1] * dy + p[i + 2] * dz == greatest) {
                return i >> 2;
            }
        }
        // Not a number.
        return 0;
    }

    /**
     * As {@link #support(double, double, double)}, but a climb starts at the given vertex, and a
     * block keeps that vertex' side where the direction does not tell: the mirror image of a search
     * then meets the mirror images of its vertices.
     *
     * @param dx direction in shape axes, any length
     * @param dy direction
     * @param dz direction
     * @param hint vertex to start from
     * @return the vertex
     */
    public int support(double dx, double dy, double dz, int hint) {
        if (block && (dx == 0 || dy == 0 || dz == 0)) {
            int known = (dx != 0 ? 1 : 0) | (dy != 0 ? 2 : 0) | (dz != 0 ? 4 : 0);
            return (support(dx, dy, dz) & known) | (hint & 7 & ~known);
        }
        return vertexCount() > SCANNED ? climb(dx, dy, dz, hint) : support(dx, dy, dz);
    }

    /**
     * As {@link #support(double, double, double)}, but of a block a second direction tells the side
     * where the first is zero: in a mirror image as well.
     *
     * @param dx direction in shape axes, any length
     * @param dy direction
     * @param dz direction
     * @param ex second direction
     * @param ey second direction
     * @param ez second direction
     * @return the vertex
     */
    public int support(double dx, double dy, double dz, double ex, double ey, double ez) {
        return block
                ? support(dx != 0 ? dx : ex, dy != 0 ? dy : ey, dz != 0 ? dz : ez)
                : support(dx, dy, dz);
    }

    /** How far a vertex is along a direction. */
    double along(int v, double dx, double dy, double dz) {
        return vertex[4 * v] * dx + vertex[4 * v + 1] * dy + vertex[4 * v + 2] * dz;
    }

    private int start(double dx, double dy, double dz) {
        double ax = Math.abs(dx);
        double ay = Math.abs(dy);
        double az = Math.abs(dz);
        if (ax >= ay && ax >= az) {
            return extremes[dx > 0 ? 1 : 0];
        }
        return ay >= az ? extremes[dy > 0 ? 3 : 2] : extremes[dz > 0 ? 5 : 4];
    }

    /**
     * As {@link #support(double, double, double)}, by climbing along the edges from a vertex,
     * whatever the number of vertices: for those who know one that is near.
     *
     * @param dx direction in shape axes, any length
     * @param dy direction
     * @param dz direction
     * @param from vertex to start from
     * @return the vertex
     */
    public int climb(double dx, double dy, double dz, int from) {
        int best = from;
        double bestDot = along(from, dx, dy, dz);
        int at = -1;
        while (at != best) {
            at = best;
            for (int s = spokeBegin[at]; s < spokeBegin[at + 1]; s++) {
                int v = spokeVertex[s];
                double dot = along(v, dx, dy, dz);
                if (dot > bestDot || (dot == bestDot && best != at && v < best)) {
                    bestDot = dot;
                    best = v;
                }
            }
            if (at == best && anyUneven) {
                best = across(dx, dy, dz, at, bestDot);
                bestDot = along(best, dx, dy, dz);
            }
        }
        return best;
    }

    /**
     * Faces that were merged from nearly coplanar ones have lost the edges between those, and a
     * climb may stall on them: the highest vertex of all such faces at a vertex.
     */
    private int across(double dx, double dy, double dz, int at, double height) {
        int best = at;
        double most = height;
        for (int s = spokeBegin[at]; s < spokeBegin[at + 1]; s++) {
            int f = spokeFace[s];
            if (!uneven[f]) {
                continue;
            }
            for (int k = faceBegin[f]; k < faceBegin[f + 1]; k++) {
                int v = slotVertex[k];
                double dot = along(v, dx, dy, dz);
                if (dot > most) {
                    most = dot;
                    best = v;
                }
            }
        }
        return best;
    }

    /**
     * Copies the loops.
     *
     * @return a new array of new arrays: per face its vertices, counter-clockwise seen from outside
     */
    public int[][] faceLoops() {
        int[][] loops = new int[faceCount()][];
        for (int f = 0; f < loops.length; f++) {
            loops[f] = Arrays.copyOfRange(slotVertex, faceBegin[f], faceBegin[f + 1]);
        }
        return loops;
    }

    /**
     * Writes the box around it, turned by a unit quaternion: the lower corner, then the upper one.
     */
    public void bounds(double qx, double qy, double qz, double qw, double[] dest, int at) {
        row(
                dest,
                at,
                1 - 2 * (qy * qy + qz * qz),
                2 * (qx * qy - qz * qw),
                2 * (qx * qz + qy * qw));
        row(
                dest,
                at + 1,
                2 * (qx * qy + qz * qw),
                1 - 2 * (qx * qx + qz * qz),
                2 * (qy * qz - qx * qw));
        row(
                dest,
                at + 2,
                2 * (qx * qz - qy * qw),
                2 * (qy * qz + qx * qw),
                1 - 2 * (qx * qx + qy * qy));
    }

    private void row(double[] dest, int at, double dx, double dy, double dz) {
        int high = support(dx, dy, dz);
        int low = support(-dx, -dy, -dz);
        dest[at] = along(low, dx, dy, dz);
        dest[at + 3] = along(high, dx, dy, dz);
    }
}
