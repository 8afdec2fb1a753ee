package dev.cairn.render.mesh;

/** Normals and triangles of flat polygons. */
final class Polygons {
    private Polygons() {}

    /**
     * Newell's normal of a loop of corners, unit length, counter-clockwise seen from its tip.
     *
     * @param xyz coordinates of all points
     * @param loop point numbers of the corners
     * @param count how many of them are used
     * @param dest receives the normal; (0, 1, 0) if the polygon has no area
     */
    static void normal(double[] xyz, int[] loop, int count, double[] dest) {
        double nx = 0;
        double ny = 0;
        double nz = 0;
        // Differences to the first corner, so that a polygon far from the origin loses no digits.
        int origin = 3 * loop[0];
        for (int i = 0; i < count; i++) {
            int a = 3 * loop[i];
            int b = 3 * loop[i + 1 == count ? 0 : i + 1];
            double ax = xyz[a] - xyz[origin];
            double ay = xyz[a + 1] - xyz[origin + 1];
            double az = xyz[a + 2] - xyz[origin + 2];
            double bx = xyz[b] - xyz[origin];
            double by = xyz[b + 1] - xyz[origin + 1];
            double bz = xyz[b + 2] - xyz[origin + 2];
            nx += ay * bz - az * by;
            ny += az * bx - ax * bz;
            nz += ax * by - ay * bx;
        }
        double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
        if (length > 0) {
            dest[0] = nx / length;
            dest[1] = ny / length;
            dest[2] = nz / length;
        } else {
            dest[0] = 0;
            dest[1] = 1;
            dest[2] = 0;
        }
    }

    /**
     * Cuts a polygon into {@code count - 2} triangles by ear clipping, so that concave ones come
     * out right too. Of a convex one each corner is an ear, so it becomes a fan about its last.
     *
     * @param xyz coordinates of all points
     * @param loop point numbers of the corners
     * @param count how many of them are used, at least 3
     * @param normal the polygon's normal
     * @param dest receives corner positions within the loop, three per triangle; length at least
     *     {@code 3 * (count - 2)}
     */
    static void triangulate(double[] xyz, int[] loop, int count, double[] normal, int[] dest) {
        if (isConvex(xyz, loop, count, normal)) {
            for (int i = 0; i < count - 3; i++) {
                dest[3 * i] = count - 1;
                dest[3 * i + 1] = i;
                dest[3 * i + 2] = i + 1;
            }
            for (int i = 0; i < 3; i++) {
                dest[3 * (count - 3) + i] = count - 3 + i;
            }
            return;
        }
        int[] left = new int[count];
        for (int i = 0; i < count; i++) {
            left[i] = i;
        }
        int remaining = count;
        int written = 0;
        int tried = 0;
        int at = 0;
        while (remaining > 3) {
            int before = left[(at + remaining - 1) % remaining];
            int corner = left[at % remaining];
            int after = left[(at + 1) % remaining];
            // A polygon that crosses itself may have no ear left; then any corner is cut, so that
            // the loop ends.
            if (tried >= remaining
                    || isEar(xyz, loop, left, remaining, before, corner, after, normal)) {
                dest[written++] = before;
                dest[written++] = corner;
                dest[written++] = after;
                int gap = at % remaining;
                System.arraycopy(left, gap + 1, left, gap, remaining - gap - 1);
                remaining--;
                tried = 0;
                at = gap % remaining;
            } else {
                at = (at + 1) % remaining;
                tried++;
            }
        }
        dest[written] = left[0];
        dest[written + 1] = left[1];
        dest[written + 2] = left[2];
    }

    /**
     * Whether a polygon turns left at each corner and lies left of its last corner's view: then it
     * goes around once. Takes time in proportion to the corners.
     */
    static boolean isConvex(double[] xyz, int[] loop, int count, double[] normal) {
        int last = 3 * loop[count - 1];
        for (int i = 0; i < count; i++) {
            int a = 3 * loop[i];
            int b = 3 * loop[(i + 1) % count];
            int c = 3 * loop[(i + 2) % count];
            if (!(turn(xyz, a, b, c, normal) > 0)
                    || (i + 2 < count && !(turn(xyz, last, a, b, normal) > 0))) {
                return false;
            }
        }
        return true;
    }

    private static boolean isEar(
            double[] xyz,
            int[] loop,
            int[] left,
            int remaining,
            int before,
            int corner,
            int after,
            double[] normal) {
        int a = 3 * loop[before];
        int b = 3 * loop[corner];
        int c = 3 * loop[after];
        if (!(turn(xyz, a, b, c, normal) > 0)) {
            return false;
        }
        for (int i = 0; i < remaining; i++) {
            int other = left[i];
            if (other == before || other == corner || other == after) {
                continue;
            }
            int p = 3 * loop[other];
            if (turn(xyz, a, b, p, normal) >= 0
                    && turn(xyz, b, c, p, normal) >= 0
                    && turn(xyz, c, a, p, normal) >= 0) {
                return false;
            }
        }
        return true;
    }

    /**
     * Twice the area of the triangle a b c, positive if it turns left seen from the normal's tip.
     */
    private static double turn(double[] xyz, int a, int b, int c, double[] normal) {
        double ux = xyz[b] - xyz[a];
        double uy = xyz[b + 1] - xyz[a + 1];
        double uz = xyz[b + 2] - xyz[a + 2];
        double vx = xyz[c] - xyz[a];
        double vy = xyz[c + 1] - xyz[a + 1];
        double vz = xyz[c + 2] - xyz[a + 2];
        return (uy * vz - uz * vy) * normal[0]
                + (uz * vx - ux * vz) * normal[1]
                + (ux * vy - uy * vx) * normal[2];
    }
}
