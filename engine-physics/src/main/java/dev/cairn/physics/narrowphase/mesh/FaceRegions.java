package dev.cairn.physics.narrowphase.mesh;

import java.util.Arrays;

/**
 * The triangles whose faces look at a convex shape, in groups that lie in one plane, and which
 * places are over them. Axes of the mesh, from the shape's centre, m.
 */
final class FaceRegions {
    /** Cosine of the angle between normals of one plane, 1e-6 rad. */
    static final double ONE_PLANE = 1 - 5e-13;

    /** Groups that a triangle is compared with, the latest ones: neighbours come close together. */
    private static final int COMPARED = 32;

    /** Numbers of a triangle: normal, then corners. */
    private static final int NUMBERS = 12;

    /** Triangles. */
    int count;

    /** Groups. */
    int groups;

    private int[] triangle = new int[64], material = new int[64];
    private int[] edges = new int[64], hollow = new int[64];
    private int[] group = new int[64];

    /** The next triangle of the same group, or -1; and the first and last one of each group. */
    private int[] next = new int[64], first = new int[64], latest = new int[64];

    private double[] number = new double[64 * NUMBERS];
    private double[] area = new double[64];

    /** 1 if the corners go round the normal counter-clockwise, else -1. */
    private double[] side = new double[64];

    /** Of each group: the triangle with the largest area, whose plane it has. */
    private int[] leader = new int[64];

    void clear() {
        count = 0;
        groups = 0;
    }

    /**
     * Adds a triangle to the group of its plane and material.
     *
     * @param ofMaterial its number
     * @param corner three times x, y, z
     * @param nx unit normal towards the shape
     * @param ofEdges their bits, see {@link dev.cairn.physics.shape.mesh.TriangleSet}
     * @param hollowEdges bit e for an edge beyond which the surface rises
     * @param twiceArea m²
     * @param front 1 if the corners go round the normal counter-clockwise, else -1
     * @param tolerance of the distance from a plane, m
     * @return the group
     */
    int add(
            int number,
            int ofMaterial,
            int ofEdges,
            int hollowEdges,
            double[] corner,
            double nx,
            double ny,
            double nz,
            double twiceArea,
            double front,
            double tolerance) {
        if (count == triangle.length) {
            grow();
        }
        int at = count++;
        next[at] = -1;
        triangle[at] = number;
        material[at] = ofMaterial;
        edges[at] = ofEdges;
        hollow[at] = hollowEdges;
        area[at] = twiceArea;
        side[at] = front;
        double[] n = this.number;
        n[NUMBERS * at] = nx;
        n[NUMBERS * at + 1] = ny;
        n[NUMBERS * at + 2] = nz;
        System.arraycopy(corner, 0, n, NUMBERS * at + 3, 9);
        for (int g = groups - 1; g >= 0 && g >= groups - COMPARED; g--) {
            int l = NUMBERS * leader[g];
            if (material[leader[g]] == ofMaterial
                    && nx * n[l] + ny * n[l + 1] + nz * n[l + 2] >= ONE_PLANE
                    && Math.abs(above(leader[g], corner[0], corner[1], corner[2])) <= tolerance) {
                group[at] = g;
                next[latest[g]] = at;
                latest[g] = at;
                if (twiceArea > area[leader[g]]) {
                    leader[g] = at;
                }
                return g;
            }
        }
        leader[groups] = at;
        first[groups] = at;
        latest[groups] = at;
        group[at] = groups;
        return groups++;
    }

    private void grow() {
        int n = 2 * count;
        triangle = Arrays.copyOf(triangle, n);
        material = Arrays.copyOf(material, n);
        edges = Arrays.copyOf(edges, n);
        hollow = Arrays.copyOf(hollow, n);
        group = Arrays.copyOf(group, n);
        number = Arrays.copyOf(number, NUMBERS * n);
        area = Arrays.copyOf(area, n);
        leader = Arrays.copyOf(leader, n);
        next = Arrays.copyOf(next, n);
        first = Arrays.copyOf(first, n);
        latest = Arrays.copyOf(latest, n);
        side = Arrays.copyOf(side, n);
    }

    /** The triangle that was added i-th, and its corners. */
    int read(int i, double[] corner) {
        System.arraycopy(number, NUMBERS * i + 3, corner, 0, 9);
        return triangle[i];
    }

    /** A component of the normal of the triangle that was added i-th. */
    double normalOf(int i, int axis) {
        return number[NUMBERS * i + axis];
    }

    /** 1 if the corners of that triangle go round its normal counter-clockwise, else -1. */
    double orientation(int i) {
        return side[i];
    }

    /** The bits of its edges. */
    int edges(int i) {
        return edges[i];
    }

    /** The group of that triangle. */
    int groupOf(int i) {
        return group[i];
    }

    /** A component of a group's normal, towards the shape. */
    double normal(int g, int axis) {
        return number[NUMBERS * leader[g] + axis];
    }

    /** How far a place is above a group's plane, m. */
    double height(int g, double x, double y, double z) {
        return above(leader[g], x, y, z);
    }

    private double above(int t, double x, double y, double z) {
        int n = NUMBERS * t;
        return number[n] * (x - number[n + 3])
                + number[n + 1] * (y - number[n + 4])
                + number[n + 2] * (z - number[n + 5]);
    }

    /**
     * Whether a place is over a triangle of a group, seen along its normal.
     *
     * @param slack how far beyond a side it may be, m
     * @param slackHollow the same where the surface rises beyond: what is there, is in it
     */
    boolean isOver(int g, double x, double y, double z, double slack, double slackHollow) {
        return under(g, x, y, z, slack, slackHollow) >= 0;
    }

    /** The first triangle of a group that a place is over, or -1; see {@link #isOver}. */
    int under(int g, double x, double y, double z, double slack, double slackHollow) {
        for (int t = first[g]; t >= 0; t = next[t]) {
            if (isOverOne(t, x, y, z, slack, slackHollow)) {
                return triangle[t];
            }
        }
        return -1;
    }

    /**
     * Whether the triangles of a plane go on in all directions from a point: where a corner is on
     * the side of another triangle, no edge is shared, and still none can be felt.
     *
     * @param nx the plane's unit normal
     */
    boolean goesOn(
            int g,
            double x,
            double y,
            double z,
            double nx,
            double ny,
            double nz,
            double tolerance) {
        double step = 8 * tolerance;
        boolean small = Math.abs(nx) < 0.6;
        double ax = small ? 0 : -nz;
        double ay = small ? nz : 0;
        double az = small ? -ny : nx;
        double f = step / Math.sqrt(ax * ax + ay * ay + az * az);
        ax *= f;
        ay *= f;
        az *= f;
        double bx = ny * az - nz * ay;
        double by = nz * ax - nx * az;
        double bz = nx * ay - ny * ax;
        return isOver(g, x + ax, y + ay, z + az, tolerance, tolerance)
                && isOver(g, x - ax, y - ay, z - az, tolerance, tolerance)
                && isOver(g, x + bx, y + by, z + bz, tolerance, tolerance)
                && isOver(g, x - bx, y - by, z - bz, tolerance, tolerance);
    }

    /** The largest triangle of a group. */
    int largest(int g) {
        return triangle[leader[g]];
    }

    private boolean isOverOne(
            int t, double x, double y, double z, double slack, double slackHollow) {
        int n = NUMBERS * t;
        double nx = number[n];
        double ny = number[n + 1];
        double nz = number[n + 2];
        // seen from a shape in front the corners go round counter-clockwise, from the back not
        double sign = side[t];
        for (int e = 0; e < 3; e++) {
            int a = n + 3 + 3 * e;
            int b = n + 3 + (e == 2 ? 0 : 3 * e + 3);
            double ex = sign * (number[b] - number[a]);
            double ey = sign * (number[b + 1] - number[a + 1]);
            double ez = sign * (number[b + 2] - number[a + 2]);
            double sx = ey * nz - ez * ny;
            double sy = ez * nx - ex * nz;
            double sz = ex * ny - ey * nx;
            double over =
                    sx * (x - number[a]) + sy * (y - number[a + 1]) + sz * (z - number[a + 2]);
            double room = (hollow[t] >> e & 1) != 0 ? slackHollow : slack;
            // the root only for points beyond the side
            if (over > 0 && over > room * Math.sqrt(sx * sx + sy * sy + sz * sz)) {
                return false;
            }
        }
        return true;
    }
}
