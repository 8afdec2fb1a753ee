package dev.cairn.physics.shape;

import dev.cairn.physics.shape.DegenerateShapeException.Reason;

import java.util.Arrays;

/**
 * The convex hull of points as triangles, by quickhull in double with exact sidedness.
 *
 * <p>Each triangle keeps the list of points above it. The farthest of them, the eye, becomes a
 * corner: all triangles that it sees are removed and the hole is closed by a cone. "Sees" is exact
 * and strict: a triangle whose plane contains the eye stays, so a cap grows by a few triangles per
 * point however many corners it has. No cone triangle is degenerate: if the eye lay on the line of
 * a horizon side, it would lie in the plane of the triangle that it sees across that side. And the
 * horizon is one simple loop: around each corner the triangles that are seen are consecutive.
 * Points less than a tolerance above all triangles are left out.
 *
 * <p>Source: C. B. Barber, D. P. Dobkin, H. Huhdanpaa, ACM TOMS 22 (1996). Set-up only; allocates;
 * one thread.
 */
final class QuickHull {
    /** Smallest thickness and width, as a fraction of the extent, that counts as a solid. */
    static final double THINNEST = 1e-9;

    /** What a coarse hull leaves out is a small share of the thickness. */
    private static final double THIN_SHARE = 1 / 32.0;

    final double[] p;

    /** Lengths below this are rounding, m. */
    final double tolerance;

    /** Points less than this above all triangles are left out, m. */
    private final double leftOut;

    /**
     * Corner k of triangle t is {@code corner[3 t + k]}; {@code twin[3 t + k]} is the triangle
     * across its side k.
     */
    int[] corner = new int[3 * 64];

    int[] twin = new int[3 * 64];
    private double[] plane = new double[3 * 64];
    private boolean[] dead = new boolean[64];
    private int[] firstAbove = new int[64];
    private int[] seen = new int[64];
    int triangles;
    private final int[] nextAbove;
    private final int[] coneAt;
    private int[] stack = new int[64];
    private int[] removed = new int[64];
    private int round;

    private QuickHull(double[] p, double tolerance, double leftOut) {
        this.p = p;
        this.tolerance = tolerance;
        this.leftOut = leftOut;
        this.nextAbove = new int[p.length / 3];
        this.coneAt = new int[p.length / 3];
    }

    /** Builds the hull; afterwards triangles are compact. */
    static QuickHull of(double[] xyz) {
        return of(xyz, 0);
    }

    /** The same without points that are nearer to the hull of others than a tolerance, m. */
    static QuickHull of(double[] xyz, double coarse) {
        int n = checked(xyz);
        double extent = extent(xyz);
        int[] simplex = new int[4];
        double thickness = simplex(xyz, n, extent, simplex);
        double fine = Math.min(5e-8 * extent, 5e-3 * thickness);
        double leftOut = Math.max(fine, Math.min(coarse, THIN_SHARE * thickness));
        QuickHull hull = new QuickHull(xyz, fine, leftOut);
        hull.seed(simplex);
        hull.grow();
        hull.compact();
        return hull;
    }

    private static int checked(double[] xyz) {
        if (xyz.length % 3 != 0) {
            throw new IllegalArgumentException(
                    "xyz has "
                            + xyz.length
                            + " numbers; give three per point: x, y, z, x, y, z, ...");
        }
        int n = xyz.length / 3;
        for (int i = 0; i < xyz.length; i++) {
            if (!Double.isFinite(xyz[i])) {
                throw new DegenerateShapeException(
                        Reason.NOT_FINITE,
                        "coordinate "
                                + "xyz".charAt(i % 3)
                                + " of point "
                                + i / 3
                                + " is "
                                + xyz[i]
                                + "; give finite metres");
            }
        }
        if (n < 4) {
            throw new DegenerateShapeException(
                    Reason.TOO_FEW_POINTS, "a hull needs at least 4 points, got " + n);
        }
        return n;
    }

    private static double extent(double[] xyz) {
        double extent = 0;
        double largest = 0;
        for (int axis = 0; axis < 3; axis++) {
            double low = Double.MAX_VALUE;
            double high = -Double.MAX_VALUE;
            for (int i = axis; i < xyz.length; i += 3) {
                low = Math.min(low, xyz[i]);
                high = Math.max(high, xyz[i]);
            }
            largest = Math.max(largest, Math.max(-low, high));
            extent = Math.max(extent, high - low);
        }
        if (extent == 0) {
            throw new DegenerateShapeException(
                    Reason.COINCIDENT,
                    "all "
                            + xyz.length / 3
                            + " points are ("
                            + xyz[0]
                            + ", "
                            + xyz[1]
                            + ", "
                            + xyz[2]
                            + "); a hull needs a volume");
        }
        if (!(extent >= Checks.MIN_LENGTH && largest <= Checks.MAX_LENGTH)) {
            throw new DegenerateShapeException(
                    Reason.EXTENT,
                    "the points span "
                            + extent
                            + " m and reach "
                            + largest
                            + " m; the span must be at least "
                            + Checks.MIN_LENGTH
                            + " and the reach at most "
                            + Checks.MAX_LENGTH);
        }
        return extent;
    }

    /**
     * Picks four points that span a volume; returns the distance of the last from the plane of the
     * others.
     */
    private static double simplex(double[] p, int n, double extent, int[] out) {
        int[] ends = new int[6];
        for (int i = 1; i < n; i++) {
            for (int axis = 0; axis < 3; axis++) {
                ends[2 * axis] =
                        p[3 * i + axis] < p[3 * ends[2 * axis] + axis] ? i : ends[2 * axis];
                ends[2 * axis + 1] =
                        p[3 * i + axis] > p[3 * ends[2 * axis + 1] + axis] ? i : ends[2 * axis + 1];
            }
        }
        double best = -1;
        for (int i = 0; i < 6; i++) {
            for (int j = 0; j < 6; j++) {
                double d = distance(p, ends[i], ends[j]);
                if (d > best) {
                    best = d;
                    out[0] = ends[i];
                    out[1] = ends[j];
                }
            }
        }
        double[] u = minus(p, out[1], out[0]);
        double width = -1;
        for (int i = 0; i < n; i++) {
            double[] c = cross(u, minus(p, i, out[0]));
            double d = length(c) / best;
            if (d > width) {
                width = d;
                out[2] = i;
            }
        }
        if (width <= THINNEST * extent) {
            throw new DegenerateShapeException(
                    Reason.COLLINEAR,
                    "all points lie within "
                            + width
                            + " m of one line, extent "
                            + extent
                            + " m; a hull must be wider than "
                            + THINNEST
                            + " of its extent");
        }
        double[] normal = cross(u, minus(p, out[2], out[0]));
        double area = length(normal);
        double thickness = -1;
        double signed = 0;
        for (int i = 0; i < n; i++) {
            double[] r = minus(p, i, out[0]);
            double d = (normal[0] * r[0] + normal[1] * r[1] + normal[2] * r[2]) / area;
            if (Math.abs(d) > thickness) {
                thickness = Math.abs(d);
                signed = d;
                out[3] = i;
            }
        }
        if (thickness <= THINNEST * extent) {
            throw new DegenerateShapeException(
                    Reason.COPLANAR,
                    "all points lie within "
                            + thickness
                            + " m of one plane, extent "
                            + extent
                            + " m; a hull must be thicker than "
                            + THINNEST
                            + " of its extent");
        }
        if (signed > 0) {
            int swap = out[1];
            out[1] = out[2];
            out[2] = swap;
        }
        return thickness;
    }

    private static double distance(double[] p, int i, int j) {
        return length(minus(p, i, j));
    }

    private static double[] minus(double[] p, int i, int j) {
        return new double[] {
            p[3 * i] - p[3 * j], p[3 * i + 1] - p[3 * j + 1], p[3 * i + 2] - p[3 * j + 2]
        };
    }

    private static double[] cross(double[] a, double[] b) {
        return new double[] {
            a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
        };
    }

    private static double length(double[] a) {
        return Math.sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
    }

    /** Point s[3] lies below triangle s[0], s[1], s[2]. */
    private void seed(int[] s) {
        add(s[0], s[1], s[2]);
        add(s[1], s[0], s[3]);
        add(s[2], s[1], s[3]);
        add(s[0], s[2], s[3]);
        int[] twins = {1, 2, 3, 0, 3, 2, 0, 1, 3, 0, 2, 1};
        System.arraycopy(twins, 0, twin, 0, 12);
        for (int i = 0; i < nextAbove.length; i++) {
            place(i, 0);
        }
    }

    private int add(int a, int b, int c) {
        int t = triangles++;
        if (t == dead.length) {
            int size = 2 * t;
            corner = Arrays.copyOf(corner, 3 * size);
            twin = Arrays.copyOf(twin, 3 * size);
            plane = Arrays.copyOf(plane, 3 * size);
            dead = Arrays.copyOf(dead, size);
            firstAbove = Arrays.copyOf(firstAbove, size);
            seen = Arrays.copyOf(seen, size);
            stack = Arrays.copyOf(stack, size);
            removed = Arrays.copyOf(removed, size);
        }
        corner[3 * t] = a;
        corner[3 * t + 1] = b;
        corner[3 * t + 2] = c;
        double[] n = cross(minus(p, b, a), minus(p, c, a));
        double length = length(n);
        double scale = length > 0 ? 1 / length : 0;
        plane[3 * t] = n[0] * scale;
        plane[3 * t + 1] = n[1] * scale;
        plane[3 * t + 2] = n[2] * scale;
        dead[t] = false;
        firstAbove[t] = -1;
        seen[t] = 0;
        return t;
    }

    private double above(int t, int point) {
        int a = corner[3 * t];
        return plane[3 * t] * (p[3 * point] - p[3 * a])
                + plane[3 * t + 1] * (p[3 * point + 1] - p[3 * a + 1])
                + plane[3 * t + 2] * (p[3 * point + 2] - p[3 * a + 2]);
    }

    /**
     * Hangs a point on the triangle, from {@code from} on, that it is highest above; drops it when
     * there is none.
     */
    private void place(int point, int from) {
        double best = leftOut;
        int home = -1;
        for (int t = from; t < triangles; t++) {
            double d = above(t, point);
            if (d > best) {
                best = d;
                home = t;
            }
        }
        if (home >= 0) {
            nextAbove[point] = firstAbove[home];
            firstAbove[home] = point;
        }
    }

    private void grow() {
        for (int t = 0; t < triangles; t++) {
            while (!dead[t] && firstAbove[t] >= 0) {
                int eye = takeFarthest(t);
                if (Orientation.sign(p, corner[3 * t], corner[3 * t + 1], corner[3 * t + 2], eye)
                        > 0) {
                    expand(t, eye);
                }
            }
        }
    }

    private int takeFarthest(int t) {
        int eye = -1;
        int before = -1;
        int previous = -1;
        double best = -Double.MAX_VALUE;
        for (int i = firstAbove[t]; i >= 0; i = nextAbove[i]) {
            double d = above(t, i);
            if (d > best || (d == best && i < eye)) {
                best = d;
                eye = i;
                before = previous;
            }
            previous = i;
        }
        if (before < 0) {
            firstAbove[t] = nextAbove[eye];
        } else {
            nextAbove[before] = nextAbove[eye];
        }
        return eye;
    }

    private void expand(int start, int eye) {
        round++;
        int top = 0;
        int gone = 0;
        stack[top++] = start;
        seen[start] = round;
        int first = triangles;
        while (top > 0) {
            int t = stack[--top];
            dead[t] = true;
            removed[gone++] = t;
            for (int k = 0; k < 3; k++) {
                int other = twin[3 * t + k];
                if (seen[other] != round && sees(other, eye)) {
                    seen[other] = round;
                    stack[top++] = other;
                }
            }
        }
        for (int i = 0; i < gone; i++) {
            int t = removed[i];
            for (int k = 0; k < 3; k++) {
                int other = twin[3 * t + k];
                if (seen[other] != round) {
                    int a = corner[3 * t + k];
                    int b = corner[3 * t + (k + 1) % 3];
                    int cone = add(a, b, eye);
                    twin[3 * cone] = other;
                    relink(other, b, a, cone);
                    coneAt[a] = cone;
                }
            }
        }
        for (int t = first; t < triangles; t++) {
            int after = coneAt[corner[3 * t + 1]];
            twin[3 * t + 1] = after;
            twin[3 * after + 2] = t;
        }
        for (int i = 0; i < gone; i++) {
            int point = firstAbove[removed[i]];
            firstAbove[removed[i]] = -1;
            while (point >= 0) {
                int next = nextAbove[point];
                place(point, first);
                point = next;
            }
        }
    }

    private boolean sees(int t, int eye) {
        return Orientation.sign(p, corner[3 * t], corner[3 * t + 1], corner[3 * t + 2], eye) > 0;
    }

    private void relink(int t, int a, int b, int to) {
        for (int k = 0; k < 3; k++) {
            if (corner[3 * t + k] == a && corner[3 * t + (k + 1) % 3] == b) {
                twin[3 * t + k] = to;
            }
        }
    }

    private void compact() {
        int[] renamed = new int[triangles];
        int alive = 0;
        for (int t = 0; t < triangles; t++) {
            renamed[t] = dead[t] ? -1 : alive++;
        }
        for (int t = 0; t < triangles; t++) {
            if (renamed[t] >= 0) {
                for (int k = 0; k < 3; k++) {
                    corner[3 * renamed[t] + k] = corner[3 * t + k];
                    twin[3 * renamed[t] + k] = renamed[twin[3 * t + k]];
                }
            }
        }
        triangles = alive;
    }
}
