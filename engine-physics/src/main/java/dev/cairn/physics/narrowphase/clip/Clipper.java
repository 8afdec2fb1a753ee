package dev.cairn.physics.narrowphase.clip;

import dev.cairn.physics.narrowphase.pair.ContactTolerances;
import dev.cairn.physics.narrowphase.pair.FeatureIds;
import dev.cairn.physics.narrowphase.pair.Pair;
import dev.cairn.physics.shape.polyhedron.Polyhedron;

import java.util.Arrays;

/**
 * Clips the face of one polyhedron that looks at another's reference face against the sides of that
 * face (Sutherland and Hodgman), in the frame of the reference polyhedron. Each side of the polygon
 * keeps the name of what it came from, so each corner has an exact name: a vertex of either shape,
 * or an edge of A crossing an edge of B. The names are the same whichever shape is the reference.
 */
public final class Clipper {
    public double[] x = new double[32],
            y = new double[32],
            z = new double[32],
            separation = new double[32];
    public int[] feature = new int[32];
    public int count;

    /** The least separation that was beyond the margin, m; infinite when none was. */
    public double leftOut;

    /** How far beyond the side plane at hand each corner is. */
    private double[] beyond = new double[32];

    /**
     * Corners of what is cut and of what is made of it, by turns, in the reference's frame: four
     * numbers each, the last of which is how far from a side plane the corner counts as on it.
     */
    private double[] whole = new double[4 * 32], rest = new double[4 * 32];

    /**
     * Of each corner its name and, in the lower half, what the side after it came from: the place
     * of an edge in the loop of the incident face, or the complement of a reference slot.
     */
    private long[] names = new long[32], restNames = new long[32];

    /** The corners of the incident face before it is cut, three numbers each. */
    private double[] origin = new double[3 * 32];

    private boolean flip;
    private int last;

    private double onPlane, stillOnPlane;
    private double vx, vy, vz;
    private Polyhedron reference = Polyhedron.of(dev.cairn.physics.shape.Box.cubeOfHalfExtent(1));

    /** Of the incident shape: its face, the first slot of it, and how many corners it has. */
    private int incidentFace, incidentBegin, incidentCorners;

    private Polyhedron other = reference;
    private final IncidentPlane plane = new IncidentPlane();
    private final SideOrder order = new SideOrder();
    private Pair pair = Pair.NONE;

    /**
     * Fills the corners with separation up to the margin, in the reference's frame.
     *
     * @param last the names of the points of the last tick, see {@link FeatureIds}
     */
    public void clip(Pair p, boolean flip, int face, int incident, double margin, int last) {
        this.flip = flip;
        this.last = last;
        onPlane = ContactTolerances.ON_PLANE * p.inner;
        stillOnPlane = ContactTolerances.STILL_ON_PLANE * p.inner;
        reference = flip ? p.b : p.a;
        other = flip ? p.a : p.b;
        pair = p;
        leftOut = Double.POSITIVE_INFINITY;
        clip(face, incident, margin, 0);
    }

    /**
     * Clips a face against a reference face of the same shapes, up to a height; what is left of it
     * comes after the other corners.
     */
    void clipMore(int face, int incident, double height, double margin) {
        double beyond = leftOut;
        clip(face, incident, Math.min(margin, height + 0x1p-40 * pair.scale), count);
        leftOut = height > margin ? Math.min(beyond, height) : beyond;
    }

    /** Clips one face; what is left of it comes after so many corners that are here already. */
    private void clip(int face, int incident, double margin, int before) {
        incidentFace = incident;
        plane.forget();
        int begin = reference.faceBegin(face);
        int end = reference.faceBegin(face + 1);
        int first = other.faceBegin(incident);
        int corners = other.faceBegin(incident + 1) - first;
        int need = before + corners + 2 * (end - begin) + 2;
        if (need > x.length) {
            grow(need);
        }
        int k = 0;
        incidentBegin = first;
        incidentCorners = corners;
        order.set(reference, begin, end - begin);
        if (corners == 3) {
            k = triangle(pair, first, face, end - begin);
        } else {
            load(pair, first, corners);
        }
        for (; k < end - begin && count > 0; k++) {
            cut(order.slot(k), face);
        }
        within(face, margin, before);
    }

    /** Keeps what is up to the margin from the face. */
    private void within(int face, double margin, int before) {
        double nx = reference.normalX(face);
        double ny = reference.normalY(face);
        double nz = reference.normalZ(face);
        double offset = reference.offset(face);
        int kept = before;
        double[] w = whole;
        for (int i = 0; i < count; i++) {
            double px = w[4 * i];
            double py = w[4 * i + 1];
            double pz = w[4 * i + 2];
            double s = nx * px + ny * py + nz * pz - offset;
            int name = (int) (names[i] >>> 32);
            if (s > margin) {
                leftOut = s < leftOut ? s : leftOut;
            } else if (before == 0 || !has(name, before)) {
                x[kept] = px;
                y[kept] = py;
                z[kept] = pz;
                feature[kept] = name;
                separation[kept++] = s;
            }
        }
        count = kept;
    }

    /** Whether one of so many corners has a name. */
    private boolean has(int name, int before) {
        int i = 0;
        while (i < before && feature[i] != name) {
            i++;
        }
        return i < before;
    }

    private void load(Pair p, int begin, int corners) {
        int kind = flip ? FeatureIds.VERTEX_A : FeatureIds.VERTEX_B;
        for (int i = 0; i < corners; i++) {
            int v = other.slotVertex(begin + i);
            corner(p, v);
            remember(i, vx, vy, vz);
            put(whole, names, i, vx, vy, vz, kind | v, slack(kind | v), i);
        }
        count = corners;
    }

    /** Puts a vertex of the incident shape, in the reference's frame, into v. */
    private void corner(Pair p, int v) {
        if (flip) {
            double ux = other.vertexX(v) - p.dx;
            double uy = other.vertexY(v) - p.dy;
            double uz = other.vertexZ(v) - p.dz;
            vx = p.r00 * ux + p.r10 * uy + p.r20 * uz;
            vy = p.r01 * ux + p.r11 * uy + p.r21 * uz;
            vz = p.r02 * ux + p.r12 * uy + p.r22 * uz;
        } else {
            double ux = other.vertexX(v);
            double uy = other.vertexY(v);
            double uz = other.vertexZ(v);
            vx = p.r00 * ux + p.r01 * uy + p.r02 * uz + p.dx;
            vy = p.r10 * ux + p.r11 * uy + p.r12 * uz + p.dy;
            vz = p.r20 * ux + p.r21 * uy + p.r22 * uz + p.dz;
        }
    }

    /**
     * Cuts a triangle by the first side that has a corner of it beyond; returns how many sides are
     * done. Most faces of hulls are triangles; until then its corners need no memory.
     */
    private int triangle(Pair p, int at, int face, int sides) {
        Polyhedron h = reference;
        int kind = flip ? FeatureIds.VERTEX_A : FeatureIds.VERTEX_B;
        int v0 = other.slotVertex(at);
        int v1 = other.slotVertex(at + 1);
        int v2 = other.slotVertex(at + 2);
        corner(p, v0);
        double x0 = vx;
        double y0 = vy;
        double z0 = vz;
        corner(p, v1);
        double x1 = vx;
        double y1 = vy;
        double z1 = vz;
        corner(p, v2);
        double x2 = vx;
        double y2 = vy;
        double z2 = vz;
        int n0 = kind | v0;
        int n1 = kind | v1;
        int n2 = kind | v2;
        double s0 = slack(n0);
        double s1 = slack(n1);
        double s2 = slack(n2);
        double[] w = whole;
        long[] n = names;
        for (int k = 0; k < sides; k++) {
            int slot = order.slot(k);
            double sx = h.sideX(slot);
            double sy = h.sideY(slot);
            double sz = h.sideZ(slot);
            double so = h.sideOffset(slot);
            double b0 = sx * x0 + sy * y0 + sz * z0 - so;
            double b1 = sx * x1 + sy * y1 + sz * z1 - so;
            double b2 = sx * x2 + sy * y2 + sz * z2 - so;
            if (b0 > s0 || b1 > s1 || b2 > s2) {
                remember(0, x0, y0, z0);
                remember(1, x1, y1, z1);
                remember(2, x2, y2, z2);
                int m = side(w, n, 0, x0, y0, z0, x1, y1, z1, b0, b1, s0, s1, n0, 0, slot, face);
                m = side(w, n, m, x1, y1, z1, x2, y2, z2, b1, b2, s1, s2, n1, 1, slot, face);
                count = side(w, n, m, x2, y2, z2, x0, y0, z0, b2, b0, s2, s0, n2, 2, slot, face);
                return k + 1;
            }
        }
        put(w, n, 0, x0, y0, z0, n0, s0, 0);
        put(w, n, 1, x1, y1, z1, n1, s1, 1);
        put(w, n, 2, x2, y2, z2, n2, s2, 2);
        count = 3;
        return sides;
    }

    /**
     * Writes what is left of a side of the polygon, from corner p to corner q: p and where the side
     * crosses the plane, or one of them, or nothing. Corners on the plane stay as they are;
     * crossings are made only between clear sides.
     *
     * @param here how far p is beyond the plane
     * @param slack of p, {@code next} that of q
     * @param corner name of p
     * @param edge what the side came from
     * @return corners written
     */
    private int side(
            double[] w,
            long[] named,
            int from,
            double px,
            double py,
            double pz,
            double qx,
            double qy,
            double qz,
            double here,
            double there,
            double slack,
            double next,
            int corner,
            int edge,
            int slot,
            int face) {
        int at = from;
        boolean kept = here <= slack;
        boolean crosses = !kept && there < -next;
        int leaving = edge;
        if (kept) {
            boolean out = there > next;
            boolean inside = here < -slack;
            crosses = out && inside;
            put(w, named, at++, px, py, pz, corner, slack, out && !inside ? ~slot : edge);
            leaving = ~slot;
        }
        if (crosses) {
            int name = name(edge, slot, face);
            if (edge >= 0) {
                crossEdge(edge, slot);
            } else if (!crossSides(~edge, slot, face)) {
                boolean enters = there < here;
                double t = enters ? there / (there - here) : here / (here - there);
                vx = enters ? qx + t * (px - qx) : px + t * (qx - px);
                vy = enters ? qy + t * (py - qy) : py + t * (qy - py);
                vz = enters ? qz + t * (pz - qz) : pz + t * (qz - pz);
            }
            put(w, named, at++, vx, vy, vz, name, slack(name), leaving);
        }
        return at;
    }

    /**
     * Puts into v where an edge of the incident face crosses a side plane: from the end that is
     * farther inside to the other, whatever was cut off before. So it depends on the edge and the
     * side alone, neither on the order of the sides nor on the way round, and a mirror image has
     * the mirrored bits.
     */
    private void crossEdge(int edge, int slot) {
        double sx = reference.sideX(slot);
        double sy = reference.sideY(slot);
        double sz = reference.sideZ(slot);
        double so = reference.sideOffset(slot);
        double[] o = origin;
        int i = 3 * edge;
        int j = edge + 1 == incidentCorners ? 0 : i + 3;
        double here = sx * o[i] + sy * o[i + 1] + sz * o[i + 2] - so;
        double there = sx * o[j] + sy * o[j + 1] + sz * o[j + 2] - so;
        boolean enters = there < here;
        int in = enters ? j : i;
        int out = enters ? i : j;
        double t = enters ? there / (there - here) : here / (here - there);
        vx = o[in] + t * (o[out] - o[in]);
        vy = o[in + 1] + t * (o[out + 1] - o[in + 1]);
        vz = o[in + 2] + t * (o[out + 2] - o[in + 2]);
    }

    /**
     * Puts into v the point of the incident plane above the corner of the reference face between
     * two sides; false when they are not neighbours (then a side between them cuts it off later),
     * or the plane is too steep.
     */
    private boolean crossSides(int cut, int slot, int face) {
        int begin = reference.faceBegin(face);
        int end = reference.faceBegin(face + 1);
        int afterSlot = slot + 1 == end ? begin : slot + 1;
        int afterCut = cut + 1 == end ? begin : cut + 1;
        if (afterSlot != cut && afterCut != slot) {
            return false;
        }
        int corner = reference.slotVertex(afterSlot == cut ? cut : slot);
        double x = reference.vertexX(corner);
        double y = reference.vertexY(corner);
        double z = reference.vertexZ(corner);
        double nx = reference.normalX(face);
        double ny = reference.normalY(face);
        double nz = reference.normalZ(face);
        plane.set(pair, flip, other, incidentFace);
        double above = plane.above(x, y, z, nx, ny, nz);
        if (Double.isNaN(above)) {
            return false;
        }
        vx = x + above * nx;
        vy = y + above * ny;
        vz = z + above * nz;
        return true;
    }

    private void remember(int i, double px, double py, double pz) {
        origin[3 * i] = px;
        origin[3 * i + 1] = py;
        origin[3 * i + 2] = pz;
    }

    /** Writes a corner. */
    private static void put(
            double[] w,
            long[] named,
            int at,
            double px,
            double py,
            double pz,
            int name,
            double own,
            int leaving) {
        w[4 * at] = px;
        w[4 * at + 1] = py;
        w[4 * at + 2] = pz;
        w[4 * at + 3] = own;
        named[at] = (long) name << 32 | (leaving & 0xFFFFFFFFL);
    }

    /** Puts one more corner behind what was found. */
    public void add(double px, double py, double pz, double apart, int name) {
        ensure(count + 1);
        int at = count++;
        x[at] = px;
        y[at] = py;
        z[at] = pz;
        separation[at] = apart;
        feature[at] = name;
    }

    /**
     * Adds all corners that are less than a margin above a plane, given by its normal and height.
     */
    public void addCorners(
            Polyhedron p, double height, double ux, double uy, double uz, double margin) {
        for (int v = 0; v < p.vertexCount(); v++) {
            double px = p.vertexX(v);
            double py = p.vertexY(v);
            double pz = p.vertexZ(v);
            double apart = height + ux * px + uy * py + uz * pz;
            if (apart <= margin) {
                add(px, py, pz, apart, FeatureIds.VERTEX_B | v);
            }
        }
    }

    /** Makes room for a number of corners that are put here from elsewhere. */
    public void ensure(int need) {
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
        whole = new double[4 * need];
        rest = new double[4 * need];
        origin = new double[3 * need];
        names = new long[need];
        restNames = new long[need];
    }

    /** Cuts by the side plane at a slot. */
    private void cut(int slot, int face) {
        double sx = reference.sideX(slot);
        double sy = reference.sideY(slot);
        double sz = reference.sideZ(slot);
        double so = reference.sideOffset(slot);
        double[] w = whole;
        int corners = count;
        int outside = 0;
        for (int i = 0; i < corners; i++) {
            double s = sx * w[4 * i] + sy * w[4 * i + 1] + sz * w[4 * i + 2] - so;
            beyond[i] = s;
            outside += s > w[4 * i + 3] ? 1 : 0;
        }
        if (outside == 0) {
            return;
        }
        int made = 0;
        if (outside < corners) {
            double[] q = rest;
            long[] n = names;
            long[] m = restNames;
            for (int i = 0; i < corners; i++) {
                int j = i + 1 == corners ? 0 : i + 1;
                made =
                        side(
                                q,
                                m,
                                made,
                                w[4 * i],
                                w[4 * i + 1],
                                w[4 * i + 2],
                                w[4 * j],
                                w[4 * j + 1],
                                w[4 * j + 2],
                                beyond[i],
                                beyond[j],
                                w[4 * i + 3],
                                w[4 * j + 3],
                                (int) (n[i] >>> 32),
                                (int) n[i],
                                slot,
                                face);
            }
            whole = q;
            rest = w;
            names = m;
            restNames = n;
        }
        count = made;
    }

    private double slack(int name) {
        return last != 0 && FeatureIds.contains(last, name) ? stillOnPlane : onPlane;
    }

    /** Names the crossing of a polygon side with a reference side. */
    private int name(int cutSide, int slot, int face) {
        if (cutSide >= 0) {
            int cutEdge = other.slotEdge(incidentBegin + cutSide);
            int edge = reference.slotEdge(slot);
            return flip
                    ? FeatureIds.CROSSING | cutEdge << 15 | edge
                    : FeatureIds.CROSSING | edge << 15 | cutEdge;
        }
        int kind = flip ? FeatureIds.VERTEX_B : FeatureIds.VERTEX_A;
        int begin = reference.faceBegin(face);
        int end = reference.faceBegin(face + 1);
        int after = slot + 1 == end ? begin : slot + 1;
        return kind | reference.slotVertex(after == ~cutSide ? after : slot);
    }
}
