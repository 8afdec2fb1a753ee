package dev.cairn.physics.shape.decomposition;

/** Planes, triangles and convex polygons as plain numbers. */
final class Planes {
    private Planes() {}

    /** The unit normal of a triangle of nine numbers; zero if it has no area. */
    static void normal(double[] c, double[] out, int at) {
        double ux = c[3] - c[0];
        double uy = c[4] - c[1];
        double uz = c[5] - c[2];
        double vx = c[6] - c[0];
        double vy = c[7] - c[1];
        double vz = c[8] - c[2];
        out[at] = uy * vz - uz * vy;
        out[at + 1] = uz * vx - ux * vz;
        out[at + 2] = ux * vy - uy * vx;
        double length = length(out[at], out[at + 1], out[at + 2]);
        double scale = length > 0 ? 1 / length : 0;
        out[at] *= scale;
        out[at + 1] *= scale;
        out[at + 2] *= scale;
    }

    static double length(double x, double y, double z) {
        return Math.sqrt(x * x + y * y + z * z);
    }

    /** The height of a point above a plane n . x = o, given as n and o. */
    static double height(double[] plane, double x, double y, double z) {
        return plane[0] * x + plane[1] * y + plane[2] * z - plane[3];
    }

    /**
     * The square of the distance of a point from a triangle. With p the point in the triangle's
     * plane, u and v the sides from a corner: p = s u + t v; if s, t and 1 - s - t are not negative
     * the plane is nearest, else one of the sides.
     */
    static double squareToTriangle(double[] c, int at, double x, double y, double z) {
        double ux = c[at + 3] - c[at];
        double uy = c[at + 4] - c[at + 1];
        double uz = c[at + 5] - c[at + 2];
        double vx = c[at + 6] - c[at];
        double vy = c[at + 7] - c[at + 1];
        double vz = c[at + 8] - c[at + 2];
        double px = x - c[at];
        double py = y - c[at + 1];
        double pz = z - c[at + 2];
        double nx = uy * vz - uz * vy;
        double ny = uz * vx - ux * vz;
        double nz = ux * vy - uy * vx;
        double nn = nx * nx + ny * ny + nz * nz;
        // s = (p x v) . n / n², t = (u x p) . n / n²
        double s = (py * vz - pz * vy) * nx + (pz * vx - px * vz) * ny + (px * vy - py * vx) * nz;
        double t = (uy * pz - uz * py) * nx + (uz * px - ux * pz) * ny + (ux * py - uy * px) * nz;
        if (s >= 0 && t >= 0 && s + t <= nn && nn > 0) {
            double h = px * nx + py * ny + pz * nz;
            return h * h / nn;
        }
        double first = squareToSide(px, py, pz, ux, uy, uz);
        double second = squareToSide(px, py, pz, vx, vy, vz);
        double third = squareToSide(px - ux, py - uy, pz - uz, vx - ux, vy - uy, vz - uz);
        return Math.min(first, Math.min(second, third));
    }

    private static double squareToSide(
            double px, double py, double pz, double ux, double uy, double uz) {
        double uu = ux * ux + uy * uy + uz * uz;
        double along = px * ux + py * uy + pz * uz;
        double k = uu > 0 ? Math.min(1, Math.max(0, along / uu)) : 0;
        double dx = px - k * ux;
        double dy = py - k * uy;
        double dz = pz - k * uz;
        return dx * dx + dy * dy + dz * dz;
    }

    /**
     * What of a convex polygon is above or below a plane. Corners within {@code snap} of it belong
     * to both; a side is cut from its upper end, so that two polygons cut a common side alike.
     *
     * @param keep 1 for what is above, -1 for what is below
     * @return the corners, three numbers each; none if nothing but points on the plane is left
     */
    static double[] clip(double[] polygon, double[] plane, int keep, double snap) {
        int n = polygon.length / 3;
        double[] out = new double[3 * (n + 2)];
        int count = 0;
        boolean any = false;
        for (int i = 0; i < n; i++) {
            int j = (i + 1) % n;
            double a = keep * height(plane, polygon[3 * i], polygon[3 * i + 1], polygon[3 * i + 2]);
            double b = keep * height(plane, polygon[3 * j], polygon[3 * j + 1], polygon[3 * j + 2]);
            if (a >= -snap) {
                any |= a > snap;
                System.arraycopy(polygon, 3 * i, out, count, 3);
                count += 3;
            }
            if ((a > snap && b < -snap) || (a < -snap && b > snap)) {
                cut(polygon, keep * a > 0 ? i : j, keep * a > 0 ? j : i, plane, out, count);
                count += 3;
            }
        }
        return any ? java.util.Arrays.copyOf(out, count) : new double[0];
    }

    /** Where the side from corner i, above, to corner j, below, meets a plane. */
    static void cut(double[] p, int i, int j, double[] plane, double[] out, int at) {
        double up = height(plane, p[3 * i], p[3 * i + 1], p[3 * i + 2]);
        double down = height(plane, p[3 * j], p[3 * j + 1], p[3 * j + 2]);
        double k = up / (up - down);
        for (int axis = 0; axis < 3; axis++) {
            out[at + axis] = p[3 * i + axis] + k * (p[3 * j + axis] - p[3 * i + axis]);
        }
    }

    /** A square on a plane about the foot of a point, with sides of twice a length. */
    static double[] square(double[] plane, double[] middle, double half) {
        double h = height(plane, middle[0], middle[1], middle[2]);
        double ax = Math.abs(plane[0]);
        double ay = Math.abs(plane[1]);
        double az = Math.abs(plane[2]);
        // the axis that is least along the normal
        double ex = ax <= ay && ax <= az ? 1 : 0;
        double ey = ex == 0 && ay <= az ? 1 : 0;
        double ez = ex == 0 && ey == 0 ? 1 : 0;
        double ux = ey * plane[2] - ez * plane[1];
        double uy = ez * plane[0] - ex * plane[2];
        double uz = ex * plane[1] - ey * plane[0];
        double scale = half / length(ux, uy, uz);
        ux *= scale;
        uy *= scale;
        uz *= scale;
        double vx = plane[1] * uz - plane[2] * uy;
        double vy = plane[2] * ux - plane[0] * uz;
        double vz = plane[0] * uy - plane[1] * ux;
        double x = middle[0] - h * plane[0];
        double y = middle[1] - h * plane[1];
        double z = middle[2] - h * plane[2];
        return new double[] {
            x - ux - vx,
            y - uy - vy,
            z - uz - vz,
            x + ux - vx,
            y + uy - vy,
            z + uz - vz,
            x + ux + vx,
            y + uy + vy,
            z + uz + vz,
            x - ux + vx,
            y - uy + vy,
            z - uz + vz,
        };
    }
}
