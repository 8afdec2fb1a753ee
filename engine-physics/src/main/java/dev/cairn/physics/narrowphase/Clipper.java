package dev.cairn.physics.narrowphase;

import dev.cairn.physics.shape.Polyhedron;

import java.util.Arrays;

/**
 * Clips the face of one polyhedron that looks at another's reference face against the sides of that
 * face (Sutherland and Hodgman), in the frame of the reference polyhedron. Each side of the polygon
 * keeps the name of what it came from, so each corner has an exact name: a vertex of either shape,
 * or an edge of A crossing an edge of B. The names are the same whichever shape is the reference.
 */
final class Clipper {
    static final int VERTEX_A = 0;
    static final int VERTEX_B = 1 << 30;
    static final int CROSSING = 2 << 30;

    /**
     * Of the smaller shape's inner radius: corners this near to a side plane count as on it, so
     * that flush boxes keep their names.
     */
    private static final double ON_PLANE = 1e-5;

    /**
     * Marks a corner that {@link #reduce} keeps; no edge and no complement of a slot has this
     * value.
     */
    private static final int CHOSEN = 0x40000000;

    double[] x = new double[32],
            y = new double[32],
            z = new double[32],
            separation = new double[32];
    int[] feature = new int[32];
    int count;

    /**
     * What the side after a corner came from: an edge of the incident shape, or the complement of a
     * reference slot.
     */
    private int[] side = new int[32];

    private double[] nextX = new double[32], nextY = new double[32], nextZ = new double[32];
    private int[] nextFeature = new int[32], nextSide = new int[32];
    private int made;
    private boolean flip;
    private Polyhedron reference = dev.cairn.physics.shape.Box.cube(1).polyhedron();

    /**
     * Fills the corners with separation up to the margin, in the reference's frame.
     *
     * @param flip the reference is B
     */
    void clip(Pair p, boolean flip, int face, int incident, double margin) {
        this.flip = flip;
        reference = flip ? p.b : p.a;
        Polyhedron other = flip ? p.a : p.b;
        int begin = reference.faceBegin(face);
        int end = reference.faceBegin(face + 1);
        load(p, other, incident, end - begin);
        double tolerance = ON_PLANE * p.inner;
        for (int slot = begin; slot < end && count > 0; slot++) {
            cut(slot, face, tolerance);
        }
        double nx = reference.normalX(face);
        double ny = reference.normalY(face);
        double nz = reference.normalZ(face);
        double offset = reference.offset(face);
        int kept = 0;
        for (int i = 0; i < count; i++) {
            double s = nx * x[i] + ny * y[i] + nz * z[i] - offset;
            if (s <= margin) {
                x[kept] = x[i];
                y[kept] = y[i];
                z[kept] = z[i];
                feature[kept] = feature[i];
                separation[kept++] = s;
            }
        }
        count = kept;
    }

    private void load(Pair p, Polyhedron other, int incident, int sides) {
        int begin = other.faceBegin(incident);
        count = other.faceBegin(incident + 1) - begin;
        int need = count + 2 * sides + 2;
        if (need > x.length) {
            grow(need);
        }
        int kind = flip ? VERTEX_A : VERTEX_B;
        for (int i = 0; i < count; i++) {
            int v = other.slotVertex(begin + i);
            if (flip) {
                double ux = other.vertexX(v) - p.dx;
                double uy = other.vertexY(v) - p.dy;
                double uz = other.vertexZ(v) - p.dz;
                x[i] = p.r00 * ux + p.r10 * uy + p.r20 * uz;
                y[i] = p.r01 * ux + p.r11 * uy + p.r21 * uz;
                z[i] = p.r02 * ux + p.r12 * uy + p.r22 * uz;
            } else {
                p.vertexB(v);
                x[i] = p.px;
                y[i] = p.py;
                z[i] = p.pz;
            }
            feature[i] = kind | v;
            side[i] = other.slotEdge(begin + i);
        }
    }

    private void grow(int need) {
        x = Arrays.copyOf(x, need);
        y = Arrays.copyOf(y, need);
        z = Arrays.copyOf(z, need);
        separation = Arrays.copyOf(separation, need);
        feature = Arrays.copyOf(feature, need);
        side = Arrays.copyOf(side, need);
        nextX = new double[need];
        nextY = new double[need];
        nextZ = new double[need];
        nextFeature = new int[need];
        nextSide = new int[need];
    }

    /**
     * Cuts by the side plane at a slot. Corners on the plane stay as they are; crossings are made
     * only between clear sides.
     */
    private void cut(int slot, int face, double tolerance) {
        double sx = reference.sideX(slot);
        double sy = reference.sideY(slot);
        double sz = reference.sideZ(slot);
        double so = reference.sideOffset(slot);
        made = 0;
        int outside = 0;
        double before = sx * x[0] + sy * y[0] + sz * z[0] - so;
        double first = before;
        for (int i = 0; i < count; i++) {
            int j = i + 1 == count ? 0 : i + 1;
            double here = before;
            double there = j == 0 ? first : sx * x[j] + sy * y[j] + sz * z[j] - so;
            before = there;
            if (here <= tolerance) {
                boolean leaves = here >= -tolerance && there > tolerance;
                emit(x[i], y[i], z[i], feature[i], leaves ? ~slot : side[i]);
                if (here < -tolerance && there > tolerance) {
                    cross(i, j, here, there, slot, face, ~slot);
                }
            } else {
                outside++;
                if (there < -tolerance) {
                    cross(i, j, here, there, slot, face, side[i]);
                }
            }
        }
        if (outside > 0) {
            swap();
        }
    }

    private void emit(double px, double py, double pz, int name, int leaving) {
        nextX[made] = px;
        nextY[made] = py;
        nextZ[made] = pz;
        nextFeature[made] = name;
        nextSide[made++] = leaving;
    }

    private void cross(int i, int j, double here, double there, int slot, int face, int leaving) {
        double t = here / (here - there);
        emit(
                x[i] + t * (x[j] - x[i]),
                y[i] + t * (y[j] - y[i]),
                z[i] + t * (z[j] - z[i]),
                name(side[i], slot, face),
                leaving);
    }

    /** Names the crossing of a polygon side with a reference side. */
    private int name(int cutSide, int slot, int face) {
        if (cutSide >= 0) {
            int edge = reference.slotEdge(slot);
            return flip ? CROSSING | cutSide << 15 | edge : CROSSING | edge << 15 | cutSide;
        }
        int kind = flip ? VERTEX_B : VERTEX_A;
        int begin = reference.faceBegin(face);
        int end = reference.faceBegin(face + 1);
        int after = slot + 1 == end ? begin : slot + 1;
        return kind | reference.slotVertex(after == ~cutSide ? after : slot);
    }

    private void swap() {
        double[] t = x;
        x = nextX;
        nextX = t;
        t = y;
        y = nextY;
        nextY = t;
        t = z;
        z = nextZ;
        nextZ = t;
        int[] u = feature;
        feature = nextFeature;
        nextFeature = u;
        u = side;
        side = nextSide;
        nextSide = u;
        count = made;
    }

    /**
     * Reduces to four: the deepest, the one farthest from it, and on each side of their line the
     * one that spans most area. Among equals within {@code tie} the first choice is an extreme
     * along a fixed direction of the face, and a point of the last tick ({@code kept} holds bits of
     * their names) wins over one that is less than a tenth better, so the choice is calm.
     */
    void reduce(double nx, double ny, double nz, double tie, int kept) {
        if (count <= 4) {
            return;
        }
        int deepest = deepest(tie, kept);
        int far = farthest(deepest, kept);
        double ex = x[far] - x[deepest];
        double ey = y[far] - y[deepest];
        double ez = z[far] - z[deepest];
        int left = -1;
        int right = -1;
        double most = 0;
        double least = 0;
        for (int i = 0; i < count; i++) {
            double fx = x[i] - x[deepest];
            double fy = y[i] - y[deepest];
            double fz = z[i] - z[deepest];
            double area =
                    (nx * (ey * fz - ez * fy) + ny * (ez * fx - ex * fz) + nz * (ex * fy - ey * fx))
                            * bonus(i, kept);
            if (i != deepest && i != far && area > most) {
                most = area;
                left = i;
            }
            if (i != deepest && i != far && area < least) {
                least = area;
                right = i;
            }
        }
        pick(deepest);
        pick(far);
        pick(left);
        pick(right);
        int at = 0;
        for (int i = 0; i < count; i++) {
            if (side[i] == CHOSEN) {
                x[at] = x[i];
                y[at] = y[i];
                z[at] = z[i];
                separation[at] = separation[i];
                feature[at++] = feature[i];
            }
        }
        count = at;
    }

    private void pick(int i) {
        if (i >= 0) {
            side[i] = CHOSEN;
        }
    }

    private double bonus(int i, int kept) {
        return (kept >>> bit(feature[i]) & 1) != 0 ? 1.1 : 1;
    }

    /**
     * One of 32 bits for a feature name: enough to recognise most, and nothing breaks when two
     * share one.
     */
    static int bit(int feature) {
        return (feature * 0x9E3779B9) >>> 27;
    }

    private int deepest(double tie, int kept) {
        double least = Double.MAX_VALUE;
        for (int i = 0; i < count; i++) {
            side[i] = 0;
            least = Math.min(least, separation[i]);
        }
        int best = -1;
        double most = -Double.MAX_VALUE;
        for (int i = 0; i < count; i++) {
            if (separation[i] <= least + tie) {
                double value = (bonus(i, kept) > 1 ? 1 : 0) - (double) (feature[i] >>> 1) * 0x1p-32;
                if (value > most) {
                    most = value;
                    best = i;
                }
            }
        }
        return best;
    }

    private int farthest(int from, int kept) {
        int best = from;
        double most = -1;
        for (int i = 0; i < count; i++) {
            double fx = x[i] - x[from];
            double fy = y[i] - y[from];
            double fz = z[i] - z[from];
            double square = (fx * fx + fy * fy + fz * fz) * bonus(i, kept);
            if (i != from && square > most) {
                most = square;
                best = i;
            }
        }
        return best;
    }
}
