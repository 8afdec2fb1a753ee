package dev.cairn.physics.narrowphase.box;

import static dev.cairn.physics.narrowphase.wide.BoxBatch.*;

import dev.cairn.physics.narrowphase.clip.Clipper;
import dev.cairn.physics.narrowphase.clip.Reduction;
import dev.cairn.physics.narrowphase.pair.BoxTopology;
import dev.cairn.physics.narrowphase.pair.ContactTolerances;
import dev.cairn.physics.narrowphase.pair.FeatureIds;
import dev.cairn.physics.narrowphase.pair.Manifold;

/**
 * The face contact of two boxes: what {@code ContactPoints.face} and {@link Clipper} do, for
 * rectangles whose sides are parallel to the axes. The operations on each number are the same, so
 * the points are the same bits and the names the same names.
 */
final class BoxFaceContact {
    /** Corners a polygon can have while it is cut: four and two more for each of four sides. */
    private static final int MOST = 16;

    /** Corners in the frame of the reference box, x, y and z; and the next ones while cutting. */
    private double[] x = new double[MOST], y = new double[MOST], z = new double[MOST];

    private double[] nextX = new double[MOST], nextY = new double[MOST], nextZ = new double[MOST];
    private int[] feature = new int[MOST], nextFeature = new int[MOST];

    /** What the side after a corner came from, as in {@link Clipper}. */
    private int[] side = new int[MOST], nextSide = new int[MOST];

    /** How far from a side plane a corner counts as on it. */
    private double[] slack = new double[MOST], nextSlack = new double[MOST];

    /** The corners of the incident face before it is cut, three numbers each. */
    private final double[] origin = new double[12];

    private final double[] beyond = new double[MOST];
    private final double[] separation = new double[MOST];
    private int count, made;

    /** Turns the incident box's axes into the reference's, row by row. */
    private final double[] turn = new double[9];

    private final double[] half = new double[3];
    private double[] columns = {};
    private int pair, incidentFace;
    private boolean flip;
    private int last;
    private double first, later;

    /** The least separation that was beyond the margin, of the last pair. */
    double leftOut;

    private final Clipper many = new Clipper();
    private final Reduction reduction = new Reduction();

    /**
     * Writes the points of a face of A, or of B when flipped, and the normal; returns the least
     * separation, or {@code Double.MAX_VALUE} without points.
     */
    double face(
            double[] t,
            int i,
            boolean flip,
            int face,
            double inner,
            double margin,
            int last,
            Manifold out) {
        this.flip = flip;
        this.last = last;
        first = ContactTolerances.ON_PLANE * inner;
        later = ContactTolerances.STILL_ON_PLANE * inner;
        int axis = face >> 1;
        load(t, i, axis, (face & 1) != 0);
        cutAll(face, axis);
        keepNear(axis, (face & 1) != 0, margin);
        if (count > 4) {
            reduce(axis, (face & 1) != 0, ContactTolerances.HYSTERESIS * inner);
        }
        return write(t, i, axis, (face & 1) != 0, out);
    }

    /** The face of the incident box that looks most against an axis of the reference. */
    private void load(double[] t, int i, int axis, boolean positive) {
        int reference = (flip ? HALF_B : HALF_A) + i;
        half[0] = t[reference];
        half[1] = t[reference + CAPACITY];
        half[2] = t[reference + 2 * CAPACITY];
        int at = RELATIVE + i;
        for (int r = 0; r < 3; r++) {
            for (int c = 0; c < 3; c++) {
                turn[flip ? 3 * c + r : 3 * r + c] = t[at];
                at += CAPACITY;
            }
        }
        double tx = turn[3 * axis];
        double ty = turn[3 * axis + 1];
        double tz = turn[3 * axis + 2];
        double sx = Math.abs(tx);
        double sy = Math.abs(ty);
        double sz = Math.abs(tz);
        int along = sx >= sy && sx >= sz ? 0 : sy >= sz ? 1 : 2;
        double toward = along == 0 ? tx : along == 1 ? ty : tz;
        incidentFace = 2 * along + (positive == toward < 0 ? 1 : 0);
        columns = t;
        pair = i;
        corners(t, i, 4 * incidentFace);
    }

    private void corners(double[] t, int i, int begin) {
        int incident = (flip ? HALF_A : HALF_B) + i;
        double hx = t[incident];
        double hy = t[incident + CAPACITY];
        double hz = t[incident + 2 * CAPACITY];
        double dx = t[CENTRE + i];
        double dy = t[CENTRE + CAPACITY + i];
        double dz = t[CENTRE + 2 * CAPACITY + i];
        double[] m = turn;
        int kind = flip ? FeatureIds.VERTEX_A : FeatureIds.VERTEX_B;
        count = 4;
        for (int k = 0; k < 4; k++) {
            int v = BoxTopology.slotVertex(begin + k);
            double px = (v & 1) == 0 ? -hx : hx;
            double py = (v & 2) == 0 ? -hy : hy;
            double pz = (v & 4) == 0 ? -hz : hz;
            if (flip) {
                px -= dx;
                py -= dy;
                pz -= dz;
                x[k] = m[0] * px + m[1] * py + m[2] * pz;
                y[k] = m[3] * px + m[4] * py + m[5] * pz;
                z[k] = m[6] * px + m[7] * py + m[8] * pz;
            } else {
                x[k] = m[0] * px + m[1] * py + m[2] * pz + dx;
                y[k] = m[3] * px + m[4] * py + m[5] * pz + dy;
                z[k] = m[6] * px + m[7] * py + m[8] * pz + dz;
            }
            origin[3 * k] = x[k];
            origin[3 * k + 1] = y[k];
            origin[3 * k + 2] = z[k];
            feature[k] = kind | v;
            side[k] = k;
        }
    }

    /** Cuts by the four sides, unless no corner is outside of any. */
    private void cutAll(int face, int axis) {
        double[] u = axis == 0 ? y : x;
        double[] v = axis == 2 ? y : z;
        double limitU = half[axis == 0 ? 1 : 0];
        double limitV = half[axis == 2 ? 1 : 2];
        double outU =
                Math.max(
                        Math.max(Math.abs(u[0]), Math.abs(u[1])),
                        Math.max(Math.abs(u[2]), Math.abs(u[3])));
        double outV =
                Math.max(
                        Math.max(Math.abs(v[0]), Math.abs(v[1])),
                        Math.max(Math.abs(v[2]), Math.abs(v[3])));
        if (outU - limitU <= first && outV - limitV <= first) {
            return;
        }
        for (int k = 0; k < 4; k++) {
            slack[k] = slack(feature[k]);
        }
        for (int k = 4 * face; k < 4 * face + 4 && count > 0; k++) {
            cut(BoxClipper.CUT_ORDER[k], 4 * face);
        }
    }

    private double slack(int name) {
        return last != 0 && FeatureIds.contains(last, name) ? later : first;
    }

    /** As {@link Clipper}'s. */
    private void cut(int slot, int begin) {
        int axis = BoxTopology.sideAxis(slot);
        double[] c = axis == 0 ? x : axis == 1 ? y : z;
        double limit = half[axis];
        boolean positive = BoxTopology.isSidePositive(slot);
        boolean outside = false;
        int n = count;
        for (int i = 0; i < n; i++) {
            double s = (positive ? c[i] : -c[i]) - limit;
            beyond[i] = s;
            outside |= s > slack[i];
        }
        if (!outside) {
            return;
        }
        made = 0;
        for (int i = 0; i < n; i++) {
            int j = i + 1 == n ? 0 : i + 1;
            double here = beyond[i];
            double there = beyond[j];
            if (here <= slack[i]) {
                boolean leaves = there > slack[j];
                boolean inside = here < -slack[i];
                emit(x[i], y[i], z[i], feature[i], slack[i], leaves && !inside ? ~slot : side[i]);
                if (leaves && inside) {
                    cross(side[i], slot, begin, ~slot);
                }
            } else if (there < -slack[j]) {
                cross(side[i], slot, begin, side[i]);
            }
        }
        swap();
    }

    private void emit(double px, double py, double pz, int name, double own, int leaving) {
        nextX[made] = px;
        nextY[made] = py;
        nextZ[made] = pz;
        nextFeature[made] = name;
        nextSlack[made] = own;
        nextSide[made++] = leaving;
    }

    /** As {@link Clipper}'s. */
    private void cross(int cutSide, int slot, int begin, int leaving) {
        int name = name(cutSide, slot, begin);
        if (cutSide < 0) {
            int after = slot == begin + 3 ? begin : slot + 1;
            corner(BoxTopology.slotVertex(after == ~cutSide ? after : slot), begin, name, leaving);
            return;
        }
        double[] o = origin;
        int axis = BoxTopology.sideAxis(slot);
        int i = 3 * cutSide;
        int j = cutSide == 3 ? 0 : i + 3;
        double sign = BoxTopology.isSidePositive(slot) ? 1 : -1;
        double here = sign * o[i + axis] - half[axis];
        double there = sign * o[j + axis] - half[axis];
        boolean enters = there < here;
        int in = enters ? j : i;
        int out = enters ? i : j;
        double s = enters ? there / (there - here) : here / (here - there);
        emit(
                o[in] + s * (o[out] - o[in]),
                o[in + 1] + s * (o[out + 1] - o[in + 1]),
                o[in + 2] + s * (o[out + 2] - o[in + 2]),
                name,
                slack(name),
                leaving);
    }

    /** The point of the incident plane above a corner of the face. */
    private void corner(int vertex, int begin, int name, int leaving) {
        int axis = begin >> 3;
        double normal = (begin & 4) != 0 ? 1 : -1;
        double px = (vertex & 1) == 0 ? -half[0] : half[0];
        double py = (vertex & 2) == 0 ? -half[1] : half[1];
        double pz = (vertex & 4) == 0 ? -half[2] : half[2];
        double above =
                BoxIncidentPlane.above(columns, pair, flip, incidentFace, axis, normal, px, py, pz);
        emit(
                axis == 0 ? px + above * normal : px,
                axis == 1 ? py + above * normal : py,
                axis == 2 ? pz + above * normal : pz,
                name,
                slack(name),
                leaving);
    }

    private int name(int cutSide, int slot, int begin) {
        if (cutSide >= 0) {
            return BoxClipper.crossing(
                    flip,
                    BoxTopology.slotEdge(4 * incidentFace + cutSide),
                    BoxTopology.slotEdge(slot));
        }
        int kind = flip ? FeatureIds.VERTEX_B : FeatureIds.VERTEX_A;
        int after = slot == begin + 3 ? begin : slot + 1;
        return kind | BoxTopology.slotVertex(after == ~cutSide ? after : slot);
    }

    private void swap() {
        double[] d = x;
        x = nextX;
        nextX = d;
        d = y;
        y = nextY;
        nextY = d;
        d = z;
        z = nextZ;
        nextZ = d;
        d = slack;
        slack = nextSlack;
        nextSlack = d;
        int[] n = feature;
        feature = nextFeature;
        nextFeature = n;
        n = side;
        side = nextSide;
        nextSide = n;
        count = made;
    }

    /** Drops the corners beyond the margin. */
    private void keepNear(int axis, boolean positive, double margin) {
        double[] c = axis == 0 ? x : axis == 1 ? y : z;
        double limit = half[axis];
        int kept = 0;
        leftOut = Double.POSITIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            double s = (positive ? c[i] : -c[i]) - limit;
            if (s <= margin) {
                x[kept] = x[i];
                y[kept] = y[i];
                z[kept] = z[i];
                feature[kept] = feature[i];
                separation[kept++] = s;
            } else {
                leftOut = Math.min(leftOut, s);
            }
        }
        count = kept;
    }

    private void reduce(int axis, boolean positive, double hysteresis) {
        System.arraycopy(x, 0, many.x, 0, count);
        System.arraycopy(y, 0, many.y, 0, count);
        System.arraycopy(z, 0, many.z, 0, count);
        System.arraycopy(separation, 0, many.separation, 0, count);
        System.arraycopy(feature, 0, many.feature, 0, count);
        many.count = count;
        double n = positive ? 1 : -1;
        reduction.reduce(
                many,
                axis == 0 ? n : 0,
                axis == 1 ? n : 0,
                axis == 2 ? n : 0,
                0.01 * hysteresis,
                hysteresis,
                last);
        count = many.count;
        System.arraycopy(many.x, 0, x, 0, count);
        System.arraycopy(many.y, 0, y, 0, count);
        System.arraycopy(many.z, 0, z, 0, count);
        System.arraycopy(many.separation, 0, separation, 0, count);
        System.arraycopy(many.feature, 0, feature, 0, count);
    }

    /** Turns the corners, moved midway between the surfaces, into world axes, in order of names. */
    private double write(double[] t, int i, int axis, boolean positive, Manifold out) {
        double[] c = axis == 0 ? x : axis == 1 ? y : z;
        double w00 = t[WORLD + i];
        double w01 = t[WORLD + CAPACITY + i];
        double w02 = t[WORLD + 2 * CAPACITY + i];
        double w10 = t[WORLD + 3 * CAPACITY + i];
        double w11 = t[WORLD + 4 * CAPACITY + i];
        double w12 = t[WORLD + 5 * CAPACITY + i];
        double w20 = t[WORLD + 6 * CAPACITY + i];
        double w21 = t[WORLD + 7 * CAPACITY + i];
        double w22 = t[WORLD + 8 * CAPACITY + i];
        double least = Double.MAX_VALUE;
        for (int k = 0; k < count; k++) {
            double s = separation[k];
            least = Math.min(least, s);
            c[k] = positive ? c[k] - s / 2 : c[k] + s / 2;
            double px = x[k];
            double py = y[k];
            double pz = z[k];
            if (flip) {
                // The transpose of turn takes the reference's axes into A's.
                double ux = turn[0] * px + turn[3] * py + turn[6] * pz + t[CENTRE + i];
                double uy = turn[1] * px + turn[4] * py + turn[7] * pz + t[CENTRE + CAPACITY + i];
                pz = turn[2] * px + turn[5] * py + turn[8] * pz + t[CENTRE + 2 * CAPACITY + i];
                px = ux;
                py = uy;
            }
            out.insert(
                    feature[k],
                    s,
                    w00 * px + w01 * py + w02 * pz,
                    w10 * px + w11 * py + w12 * pz,
                    w20 * px + w21 * py + w22 * pz);
        }
        double sign = positive == flip ? -1 : 1;
        double nx = flip ? sign * turn[3 * axis] : axis == 0 ? sign : 0;
        double ny = flip ? sign * turn[3 * axis + 1] : axis == 1 ? sign : 0;
        double nz = flip ? sign * turn[3 * axis + 2] : axis == 2 ? sign : 0;
        out.normalX = w00 * nx + w01 * ny + w02 * nz;
        out.normalY = w10 * nx + w11 * ny + w12 * nz;
        out.normalZ = w20 * nx + w21 * ny + w22 * nz;
        return least;
    }
}
