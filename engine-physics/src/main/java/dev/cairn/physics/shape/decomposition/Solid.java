package dev.cairn.physics.shape.decomposition;

import dev.cairn.physics.shape.TriangleMesh;
import dev.cairn.physics.shape.mesh.TriangleSet;

/**
 * The triangles of a mesh as a solid: how far a place is from the surface, and whether it is
 * inside. Immutable; each thread asks with a {@link Probe} of its own.
 *
 * <p>The triangles come in the order of the mesh's tree, so ranges of them are near together, and
 * boxes about halves of ranges are a tree.
 */
final class Solid {
    private static final int LEAF = 4;

    /** Corners: nine numbers for each triangle, m. */
    final double[] corner;

    /** Unit normals. */
    final double[] normal;

    /** Bit e: edge e, from corner e to the next, is hollow from the front. */
    final byte[] hollow;

    final int count;

    /** Ends of the box about all, m: three lower ones, three upper ones. */
    final double[] box = new double[6];

    /** The longest side of the box, m. */
    final double size;

    /** What differs by less is one place, m: rounding of coordinates, and 1e-11 of the size. */
    final double snap;

    private final boolean isClosed;
    private final double[] nodeBox;

    Solid(TriangleMesh mesh) {
        TriangleSet set = TriangleSet.of(mesh);
        count = set.count();
        corner = new double[9 * count];
        normal = new double[3 * count];
        hollow = new byte[count];
        boolean isTurned = isInsideOut(set);
        double[] nine = new double[9];
        for (int t = 0; t < count; t++) {
            set.corners(t, nine);
            int edges = (set.flags(t) / TriangleSet.HOLLOW) & TriangleSet.ALL;
            if (isTurned) {
                for (int axis = 3; axis < 6; axis++) {
                    double swap = nine[axis];
                    nine[axis] = nine[axis + 3];
                    nine[axis + 3] = swap;
                }
                int ridges = (set.flags(t) / TriangleSet.CONVEX) & TriangleSet.ALL;
                edges = ((ridges & 1) << 2) | (ridges & 2) | (ridges >> 2);
            }
            System.arraycopy(nine, 0, corner, 9 * t, 9);
            hollow[t] = (byte) edges;
            Planes.normal(nine, normal, 3 * t);
        }
        isClosed = mesh.report().isClosed();
        int nodes = 1;
        while (nodes * LEAF < count) {
            nodes *= 2;
        }
        nodeBox = new double[6 * 2 * nodes];
        measure(0, 0, count);
        System.arraycopy(nodeBox, 0, box, 0, 6);
        double longest = 0;
        double reach = 0;
        for (int axis = 0; axis < 3; axis++) {
            longest = Math.max(longest, box[axis + 3] - box[axis]);
            reach = Math.max(reach, Math.max(-box[axis], box[axis + 3]));
        }
        size = longest;
        snap = 1e-11 * size + 0x1p-50 * reach;
    }

    /** Whether the volume that the triangles enclose is negative, seen from the first corner. */
    private static boolean isInsideOut(TriangleSet set) {
        double[] c = new double[9];
        set.corners(0, c);
        double x = c[0];
        double y = c[1];
        double z = c[2];
        double sum = 0;
        for (int t = 0; t < set.count(); t++) {
            set.corners(t, c);
            for (int i = 0; i < 9; i += 3) {
                c[i] -= x;
                c[i + 1] -= y;
                c[i + 2] -= z;
            }
            sum +=
                    c[0] * (c[4] * c[8] - c[5] * c[7])
                            + c[1] * (c[5] * c[6] - c[3] * c[8])
                            + c[2] * (c[3] * c[7] - c[4] * c[6]);
        }
        return sum < 0;
    }

    private void measure(int node, int from, int to) {
        int b = 6 * node;
        if (to - from > LEAF) {
            int half = (from + to) >>> 1;
            int left = 2 * node + 1;
            measure(left, from, half);
            measure(left + 1, half, to);
            for (int axis = 0; axis < 3; axis++) {
                nodeBox[b + axis] =
                        Math.min(nodeBox[6 * left + axis], nodeBox[6 * left + 6 + axis]);
                nodeBox[b + axis + 3] =
                        Math.max(nodeBox[6 * left + axis + 3], nodeBox[6 * left + axis + 9]);
            }
            return;
        }
        for (int axis = 0; axis < 3; axis++) {
            double low = Double.POSITIVE_INFINITY;
            double high = Double.NEGATIVE_INFINITY;
            for (int i = 9 * from + axis; i < 9 * to; i += 3) {
                low = Math.min(low, corner[i]);
                high = Math.max(high, corner[i]);
            }
            nodeBox[b + axis] = low;
            nodeBox[b + axis + 3] = high;
        }
    }

    /** Asks a solid; one thread's. */
    final class Probe {
        private static final int DEPTH = 128;

        /** Directions of rays along which crossings are counted: askew to what people build. */
        private static final double[] RAYS = {
            0.8123, 0.2671, 0.5183, -0.3217, 0.8541, 0.4087, 0.1931, -0.4373, 0.8783, -0.7019,
            -0.5347, 0.4703, 0.5881, -0.7127, -0.3821,
        };

        private final int[] stack = new int[3 * DEPTH];
        private final double[] away = new double[DEPTH];
        private boolean grazes;

        /**
         * The distance of a place from the surface, m.
         *
         * @param near what is nearer than this need not be told exactly, m
         * @param far it is known to be no farther, m; may be infinite
         */
        double distance(double x, double y, double z, double near, double far) {
            double enough = near > 0 ? near * near : 0;
            double best = far * far;
            int top = 0;
            push(top++, 0, 0, count, apart(0, x, y, z));
            while (top > 0 && best > enough) {
                top--;
                if (away[top] >= best) {
                    continue;
                }
                int node = stack[3 * top];
                int from = stack[3 * top + 1];
                int to = stack[3 * top + 2];
                if (to - from <= LEAF) {
                    for (int t = from; t < to; t++) {
                        best = Math.min(best, Planes.squareToTriangle(corner, 9 * t, x, y, z));
                    }
                    continue;
                }
                int half = (from + to) >>> 1;
                int left = 2 * node + 1;
                double first = apart(left, x, y, z);
                double second = apart(left + 1, x, y, z);
                if (first <= second) {
                    push(top++, left + 1, half, to, second);
                    push(top++, left, from, half, first);
                } else {
                    push(top++, left, from, half, first);
                    push(top++, left + 1, half, to, second);
                }
            }
            return Math.sqrt(best);
        }

        private void push(int at, int node, int from, int to, double square) {
            stack[3 * at] = node;
            stack[3 * at + 1] = from;
            stack[3 * at + 2] = to;
            away[at] = square;
        }

        private double apart(int node, double x, double y, double z) {
            int b = 6 * node;
            double dx = Math.max(0, Math.max(nodeBox[b] - x, x - nodeBox[b + 3]));
            double dy = Math.max(0, Math.max(nodeBox[b + 1] - y, y - nodeBox[b + 4]));
            double dz = Math.max(0, Math.max(nodeBox[b + 2] - z, z - nodeBox[b + 5]));
            return dx * dx + dy * dy + dz * dz;
        }

        /**
         * Whether the surface winds about a place: a ray crosses it more often one way than the
         * other. On a closed surface every ray says the same; on another one two of three decide.
         */
        boolean isInside(double x, double y, double z) {
            if (x < box[0] || y < box[1] || z < box[2] || x > box[3] || y > box[4] || z > box[5]) {
                return false;
            }
            int yes = 0;
            int no = 0;
            int wanted = isClosed ? 1 : 2;
            for (int ray = 0; ray < RAYS.length; ray += 3) {
                int winds = crossings(x, y, z, RAYS[ray], RAYS[ray + 1], RAYS[ray + 2]);
                if (grazes) {
                    continue;
                }
                if (winds != 0 && ++yes == wanted) {
                    return true;
                }
                if (winds == 0 && ++no == wanted) {
                    return false;
                }
            }
            return yes > no;
        }

        /** Fronts left minus backs left on a ray; sets whether it touches an edge exactly. */
        private int crossings(double x, double y, double z, double dx, double dy, double dz) {
            int sum = 0;
            int top = 0;
            grazes = false;
            push(top++, 0, 0, count, 0);
            while (top > 0) {
                top--;
                int node = stack[3 * top];
                int from = stack[3 * top + 1];
                int to = stack[3 * top + 2];
                if (!meets(node, x, y, z, dx, dy, dz)) {
                    continue;
                }
                if (to - from <= LEAF) {
                    for (int t = from; t < to; t++) {
                        sum += crossing(9 * t, x, y, z, dx, dy, dz);
                    }
                    continue;
                }
                int half = (from + to) >>> 1;
                push(top++, 2 * node + 1, from, half, 0);
                push(top++, 2 * node + 2, half, to, 0);
            }
            return sum;
        }

        private boolean meets(
                int node, double x, double y, double z, double dx, double dy, double dz) {
            int b = 6 * node;
            double ax = (nodeBox[b] - snap - x) / dx;
            double bx = (nodeBox[b + 3] + snap - x) / dx;
            double ay = (nodeBox[b + 1] - snap - y) / dy;
            double by = (nodeBox[b + 4] + snap - y) / dy;
            double az = (nodeBox[b + 2] - snap - z) / dz;
            double bz = (nodeBox[b + 5] + snap - z) / dz;
            double in = Math.max(Math.max(Math.min(ax, bx), Math.min(ay, by)), Math.min(az, bz));
            double out = Math.min(Math.min(Math.max(ax, bx), Math.max(ay, by)), Math.max(az, bz));
            return out >= 0 && in <= out;
        }

        /**
         * Sides are told by volumes (a x b) . d, whose signs two neighbours compute alike, so that
         * no ray slips through between them.
         */
        private int crossing(int c, double x, double y, double z, double dx, double dy, double dz) {
            double ax = corner[c] - x;
            double ay = corner[c + 1] - y;
            double az = corner[c + 2] - z;
            double bx = corner[c + 3] - x;
            double by = corner[c + 4] - y;
            double bz = corner[c + 5] - z;
            double cx = corner[c + 6] - x;
            double cy = corner[c + 7] - y;
            double cz = corner[c + 8] - z;
            double ab = side(ax, ay, az, bx, by, bz, dx, dy, dz);
            double bc = side(bx, by, bz, cx, cy, cz, dx, dy, dz);
            double ca = side(cx, cy, cz, ax, ay, az, dx, dy, dz);
            boolean front = ab >= 0 && bc >= 0 && ca >= 0;
            boolean back = ab <= 0 && bc <= 0 && ca <= 0;
            if (!front && !back) {
                return 0;
            }
            int n = c / 3;
            double across = normal[n] * dx + normal[n + 1] * dy + normal[n + 2] * dz;
            double height = normal[n] * ax + normal[n + 1] * ay + normal[n + 2] * az;
            if (across == 0 || height / across < 0) {
                return 0;
            }
            grazes |= ab == 0 || bc == 0 || ca == 0;
            return front ? 1 : -1;
        }

        private static double side(
                double ax,
                double ay,
                double az,
                double bx,
                double by,
                double bz,
                double dx,
                double dy,
                double dz) {
            double x = ay * bz - az * by;
            double y = az * bx - ax * bz;
            double z = ax * by - ay * bx;
            return x * dx + y * dy + z * dz;
        }
    }
}
