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
    static final double ON_PLANE = 1e-5;

    /**
     * The same for a corner that was a point of the last tick: it leaves the plane later than it
     * came, so that boxes that sway a little keep their names too.
     */
    static final double STILL_ON_PLANE = 1e-3;

    double[] x = new double[32],
            y = new double[32],
            z = new double[32],
            separation = new double[32];
    int[] feature = new int[32];
    int count;

    /** The least separation that was beyond the margin, m; infinite when none was. */
    double leftOut;

    /** How far beyond the side plane at hand each corner is. */
    private double[] beyond = new double[32];

    /**
     * What is cut and what is made of it, by turns: to exchange two references is less work for a
     * collector than to exchange one for each column.
     */
    private Polygon whole = new Polygon(32), rest = new Polygon(32);

    private int made;
    private boolean flip;
    private int last;
    private double first, later;
    private Polyhedron reference = dev.cairn.physics.shape.Box.cube(1).polyhedron();

    /**
     * Fills the corners with separation up to the margin, in the reference's frame.
     *
     * @param flip the reference is B
     * @param last the names of the points of the last tick, see {@link Names}
     */
    void clip(Pair p, boolean flip, int face, int incident, double margin, int last) {
        this.flip = flip;
        this.last = last;
        first = ON_PLANE * p.inner;
        later = STILL_ON_PLANE * p.inner;
        reference = flip ? p.b : p.a;
        Polyhedron other = flip ? p.a : p.b;
        int begin = reference.faceBegin(face);
        int end = reference.faceBegin(face + 1);
        load(p, other, incident, end - begin);
        for (int slot = begin; slot < end && count > 0; slot++) {
            cut(slot, face);
        }
        double nx = reference.normalX(face);
        double ny = reference.normalY(face);
        double nz = reference.normalZ(face);
        double offset = reference.offset(face);
        int kept = 0;
        leftOut = Double.POSITIVE_INFINITY;
        Polygon w = whole;
        for (int i = 0; i < count; i++) {
            double s = nx * w.x[i] + ny * w.y[i] + nz * w.z[i] - offset;
            if (s > margin) {
                leftOut = s < leftOut ? s : leftOut;
            } else {
                x[kept] = w.x[i];
                y[kept] = w.y[i];
                z[kept] = w.z[i];
                feature[kept] = w.feature[i];
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
        Polygon w = whole;
        for (int i = 0; i < count; i++) {
            int v = other.slotVertex(begin + i);
            if (flip) {
                double ux = other.vertexX(v) - p.dx;
                double uy = other.vertexY(v) - p.dy;
                double uz = other.vertexZ(v) - p.dz;
                w.x[i] = p.r00 * ux + p.r10 * uy + p.r20 * uz;
                w.y[i] = p.r01 * ux + p.r11 * uy + p.r21 * uz;
                w.z[i] = p.r02 * ux + p.r12 * uy + p.r22 * uz;
            } else {
                p.vertexB(v);
                w.x[i] = p.px;
                w.y[i] = p.py;
                w.z[i] = p.pz;
            }
            w.feature[i] = kind | v;
            w.slack[i] = slack(kind | v);
            w.side[i] = other.slotEdge(begin + i);
        }
    }

    /** Makes room for a number of corners that are put here from elsewhere. */
    void ensure(int need) {
        if (need > x.length) {
            grow(need + need / 2);
        }
    }

    private void grow(int need) {
        x = Arrays.copyOf(x, need);
        y = Arrays.copyOf(y, need);
        z = Arrays.copyOf(z, need);
        separation = Arrays.copyOf(separation, need);
        feature = Arrays.copyOf(feature, need);
        beyond = new double[need];
        whole = new Polygon(need);
        rest = new Polygon(need);
    }

    /**
     * Cuts by the side plane at a slot. Corners on the plane stay as they are; crossings are made
     * only between clear sides.
     */
    private void cut(int slot, int face) {
        double sx = reference.sideX(slot);
        double sy = reference.sideY(slot);
        double sz = reference.sideZ(slot);
        double so = reference.sideOffset(slot);
        Polygon p = whole;
        int corners = count;
        int outside = 0;
        for (int i = 0; i < corners; i++) {
            double s = sx * p.x[i] + sy * p.y[i] + sz * p.z[i] - so;
            beyond[i] = s;
            outside += s > p.slack[i] ? 1 : 0;
        }
        if (outside == 0) {
            return;
        }
        made = 0;
        if (outside < corners) {
            emitAll(slot, face);
            whole = rest;
            rest = p;
        }
        count = made;
    }

    private void emitAll(int slot, int face) {
        Polygon p = whole;
        int corners = count;
        for (int i = 0; i < corners; i++) {
            int j = i + 1 == corners ? 0 : i + 1;
            double here = beyond[i];
            double there = beyond[j];
            double slack = p.slack[i];
            int side = p.side[i];
            if (here <= slack) {
                boolean out = there > p.slack[j];
                boolean inside = here < -slack;
                int leaving = out && !inside ? ~slot : side;
                emit(p.x[i], p.y[i], p.z[i], p.feature[i], slack, leaving);
                if (out && inside) {
                    cross(i, j, here / (here - there), name(side, slot, face), ~slot);
                }
            } else if (there < -p.slack[j]) {
                cross(i, j, here / (here - there), name(side, slot, face), side);
            }
        }
    }

    private double slack(int name) {
        return last != 0 && Names.holds(last, name) ? later : first;
    }

    private void emit(double px, double py, double pz, int name, double own, int leaving) {
        Polygon p = rest;
        p.x[made] = px;
        p.y[made] = py;
        p.z[made] = pz;
        p.feature[made] = name;
        p.slack[made] = own;
        p.side[made++] = leaving;
    }

    private void cross(int i, int j, double t, int name, int leaving) {
        Polygon p = whole;
        emit(
                p.x[i] + t * (p.x[j] - p.x[i]),
                p.y[i] + t * (p.y[j] - p.y[i]),
                p.z[i] + t * (p.z[j] - p.z[i]),
                name,
                slack(name),
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

    /** Corners in the reference's frame. */
    private static final class Polygon {
        final double[] x, y, z;

        /** How far from a side plane each corner counts as on it. */
        final double[] slack;

        final int[] feature;

        /**
         * What the side after a corner came from: an edge of the incident shape, or the complement
         * of a reference slot.
         */
        final int[] side;

        Polygon(int room) {
            x = new double[room];
            y = new double[room];
            z = new double[room];
            slack = new double[room];
            feature = new int[room];
            side = new int[room];
        }
    }
}
