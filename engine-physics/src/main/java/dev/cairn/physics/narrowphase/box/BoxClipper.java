package dev.cairn.physics.narrowphase.box;

import static dev.cairn.physics.narrowphase.wide.BoxBatch.*;

import dev.cairn.physics.narrowphase.clip.Clipper;
import dev.cairn.physics.narrowphase.clip.Reduction;
import dev.cairn.physics.narrowphase.pair.BoxTopology;
import dev.cairn.physics.narrowphase.pair.ContactTolerances;
import dev.cairn.physics.narrowphase.pair.FeatureIds;
import dev.cairn.physics.narrowphase.wide.BoxBatch;

/**
 * Clips the incident face of a pair in a batch, whose corners are in the columns, and puts the
 * points there in their place. The operations on each number are those of {@link Clipper}, the
 * names are its names.
 */
final class BoxClipper {
    /** Corners a polygon can have while it is cut: four and two more for each of four sides. */
    private static final int MOST = 16;

    /** The polygon is not convex up to rounding: the single path shall decide. */
    static final int UNSURE = 0;

    /** The side of a slot is on the first axis beside the face's, or the second. */
    private static final boolean[] SIDE_FIRST = new boolean[24];

    /**
     * The slots of a face in the order in which its sides cut: those across the first axis beside
     * the face's come first. Soft corners make it matter, and a mirror shares this order.
     */
    private static final int[] CUT_ORDER = new int[24];

    /** The column of a side, and the slot of a column. */
    static final int[] SIDE_OUTSIDE = new int[24], SIDE_SLOT = new int[24];

    /** The batch's corner at a slot; and the vertices of the batch's corners, four to a face. */
    static final int[] SLOT_CORNER = new int[24], CORNER_VERTEX = new int[24];

    static {
        for (int s = 0; s < 24; s++) {
            int axis = s >> 3;
            int low = axis == 0 ? 1 : 0;
            int high = axis == 2 ? 1 : 2;
            int v = BoxTopology.slotVertex(s);
            SLOT_CORNER[s] = (v >> low & 1) | (v >> high & 1) << 1;
            CORNER_VERTEX[(s & ~3) + SLOT_CORNER[s]] = v;
            SIDE_FIRST[s] = BoxTopology.sideAxis(s) == low;
            int side = (SIDE_FIRST[s] ? 0 : 2) + (BoxTopology.isSidePositive(s) ? 0 : 1);
            SIDE_OUTSIDE[s] = OUTSIDE + side * CAPACITY;
            SIDE_SLOT[(s & ~3) + side] = s;
        }
        for (int s = 0; s < 24; s++) {
            int odd = SIDE_FIRST[s & ~3] ? 0 : 1;
            CUT_ORDER[s] = (s & ~3) + (((s & 1) << 1 | (s >> 1 & 1)) ^ odd);
        }
    }

    /** Corners made so far: along the face's axis and the two beside it. */
    private final double[] n = new double[MOST], u = new double[MOST], v = new double[MOST];

    private final int[] feature = new int[MOST];

    /** What the side after a corner came from, as in {@link Clipper}. */
    private final int[] side = new int[MOST];

    /** Of the pair at hand: the first slot of the incident face. */
    private int incident;

    /** How far from a side plane a corner counts as on it. */
    private final double[] slack = new double[MOST];

    /** How far beyond the side plane at hand each corner is; in the end the separations. */
    private final double[] beyond = new double[MOST];

    /** The polygon: indices of corners, four bits each, the first one lowest. */
    private long order;

    private int count, made;
    private boolean flip;
    private int last;
    private double first, later;

    private final Clipper many = new Clipper();
    private final Reduction reduction = new Reduction();

    /** Of pairs that are not clipped in lanes, up to four points: names, and separations. */
    final int[] name = new int[4 * BoxBatch.CAPACITY];

    /** The same of each pair as a key, see {@link FeatureIds}. */
    final int[] names = new int[BoxBatch.CAPACITY];

    final double[] separation = new double[4 * BoxBatch.CAPACITY];

    /** The least separation of the last pair. */
    double deepest;

    /** The least separation that was beyond the margin, of the last pair. */
    double leftOut;

    /**
     * Clips a pair, unless it was clipped to a quadrilateral in lanes; returns the number of
     * points, or {@link #UNSURE}.
     */
    int clip(double[] t, int i, double inner, double margin, int last) {
        this.last = last;
        flip = t[FLIP + i] != 0;
        leftOut = Double.POSITIVE_INFINITY;
        boolean positive = t[SIGN + i] > 0;
        int incident = 4 * (int) t[INCIDENT + i];
        int begin = 8 * (int) t[AXIS + i] + (positive ? 4 : 0);
        if (t[ALIGNED + i] >= 0) {
            deepest = t[DEEPEST + i];
            return 4;
        }
        first = ContactTolerances.ON_PLANE * inner;
        boolean cuts = false;
        for (int slot = begin; slot < begin + 4; slot++) {
            cuts |= t[SIDE_OUTSIDE[slot] + i] > first;
        }
        if (!cuts) {
            return whole(t, i, positive, incident, margin);
        }
        later = ContactTolerances.STILL_ON_PLANE * inner;
        return any(t, i, positive, incident, begin, margin, inner);
    }

    private int any(
            double[] t,
            int i,
            boolean positive,
            int incident,
            int begin,
            double margin,
            double inner) {
        this.incident = incident;
        load(t, i, incident);
        double limitU = t[HALF + CAPACITY + i];
        double limitV = t[HALF + 2 * CAPACITY + i];
        for (int k = begin; k < begin + 4 && count > 0; k++) {
            int slot = CUT_ORDER[k];
            if (t[SIDE_OUTSIDE[slot] + i] <= first) {
                continue;
            }
            boolean onU = SIDE_FIRST[slot];
            if (!cut(t, i, slot, begin, onU ? u : v, onU ? limitU : limitV)) {
                return UNSURE;
            }
        }
        keepNear(positive, t[HALF + i], margin);
        if (count > 4) {
            reduce(begin >> 3, positive, ContactTolerances.HYSTERESIS * inner);
        }
        return put(t, i, positive);
    }

    /** All four corners stay, in order of their names. */
    private int whole(double[] t, int i, boolean positive, int incident, double margin) {
        int hash = 0;
        int kind = flip ? FeatureIds.VERTEX_A : FeatureIds.VERTEX_B;
        double limit = t[HALF + i];
        double least = Double.MAX_VALUE;
        int kept = 0;
        int to = CORNER + i;
        int from = to;
        for (int k = 0; k < 4; k++, from += POINT) {
            double height = t[from];
            double s = (positive ? height : -height) - limit;
            if (s > margin) {
                leftOut = s < leftOut ? s : leftOut;
                continue;
            }
            least = s < least ? s : least;
            name[4 * i + kept] = kind | CORNER_VERTEX[incident + k];
            hash |= FeatureIds.hash(name[4 * i + kept]) << (8 * kept);
            separation[4 * i + kept++] = s;
            t[to] = positive ? height - s / 2 : height + s / 2;
            if (to != from) {
                t[to + CAPACITY] = t[from + CAPACITY];
                t[to + 2 * CAPACITY] = t[from + 2 * CAPACITY];
            }
            to += POINT;
        }
        deepest = least;
        names[i] = hash;
        return kept;
    }

    private static int crossing(boolean flip, int incidentEdge, int edge) {
        return flip
                ? FeatureIds.CROSSING | incidentEdge << 15 | edge
                : FeatureIds.CROSSING | edge << 15 | incidentEdge;
    }

    private void load(double[] t, int i, int incident) {
        int kind = flip ? FeatureIds.VERTEX_A : FeatureIds.VERTEX_B;
        count = 4;
        made = 4;
        order = 0x3210;
        for (int k = 0; k < 4; k++) {
            int at = CORNER + POINT * SLOT_CORNER[incident + k] + i;
            n[k] = t[at];
            u[k] = t[at + CAPACITY];
            v[k] = t[at + 2 * CAPACITY];
            feature[k] = kind | BoxTopology.slotVertex(incident + k);
            slack[k] = slack(feature[k]);
            side[k] = k;
        }
    }

    private double slack(int vertex) {
        return FeatureIds.contains(last, vertex) ? later : first;
    }

    /**
     * Cuts by the side plane at a slot, with {@link Clipper}'s rules. The corners outside are one
     * run of a convex polygon, so no branch depends on which they are; false when they are more
     * than one run, which rounding can make of flush sides.
     */
    private boolean cut(double[] t, int pair, int slot, int begin, double[] c, double limit) {
        double sign = BoxTopology.isSidePositive(slot) ? 1 : -1;
        int corners = count;
        int outside = 0;
        for (int i = 0; i < corners; i++) {
            int k = (int) (order >>> (4 * i)) & 15;
            double s = sign * c[k] - limit;
            beyond[k] = s;
            outside |= s > slack[k] ? 1 << i : 0;
        }
        if (outside == 0) {
            return true;
        }
        int inside = ((1 << corners) - 1) & ~outside;
        if (inside == 0) {
            count = 0;
            return true;
        }
        boolean wraps = (outside & 1) != 0;
        int run = wraps ? inside : outside;
        if ((run & (run + (run & -run))) != 0) {
            return false;
        }
        int begun = Integer.numberOfTrailingZeros(run);
        int ended = 32 - Integer.numberOfLeadingZeros(run);
        // The last corner that stays, and the first that stays again.
        int stays = wraps ? ended - 1 : begun - 1;
        int again = wraps ? begun : ended == corners ? 0 : ended;
        int from = at(stays);
        int back = at(again);
        long leave = 0;
        int left = 0;
        if (beyond[from] < -slack[from]) {
            cross(t, pair, side[from], slot, begin, c, limit, ~slot);
            leave = made - 1L;
            left = 1;
        } else {
            side[from] = ~slot;
        }
        long enter = 0;
        int entered = 0;
        if (beyond[back] < -slack[back]) {
            int cutSide = side[at(again == 0 ? corners - 1 : again - 1)];
            cross(t, pair, cutSide, slot, begin, c, limit, cutSide);
            enter = made - 1L;
            entered = 1;
        }
        if (wraps) {
            int kept = stays - again + 1;
            long middle = (order >>> (4 * again)) & ((1L << (4 * kept)) - 1);
            order = enter | middle << (4 * entered) | leave << (4 * (entered + kept));
            count = entered + kept + left;
        } else {
            int head = stays + 1;
            int tail = corners - ended;
            long rest = tail == 0 ? 0 : order >>> (4 * ended);
            long low = order & ((1L << (4 * head)) - 1);
            order =
                    low
                            | leave << (4 * head)
                            | enter << (4 * (head + left))
                            | rest << (4 * (head + left + entered));
            count = head + left + entered + tail;
        }
        return true;
    }

    private int at(int place) {
        return (int) (order >>> (4 * place)) & 15;
    }

    private void cross(
            double[] t,
            int pair,
            int cutSide,
            int slot,
            int begin,
            double[] c,
            double limit,
            int leaving) {
        int k = made++;
        int crossing =
                name(cutSide < 0 ? cutSide : BoxTopology.slotEdge(incident + cutSide), slot, begin);
        if (cutSide >= 0) {
            // The corners of the incident face keep their places.
            double sign = BoxTopology.isSidePositive(slot) ? 1 : -1;
            int next = cutSide + 1 & 3;
            double here = sign * c[cutSide] - limit;
            double there = sign * c[next] - limit;
            boolean enters = there < here;
            int i = enters ? next : cutSide;
            int j = enters ? cutSide : next;
            double s = enters ? there / (there - here) : here / (here - there);
            n[k] = n[i] + s * (n[j] - n[i]);
            u[k] = u[i] + s * (u[j] - u[i]);
            v[k] = v[i] + s * (v[j] - v[i]);
        } else {
            int after = slot == begin + 3 ? begin : slot + 1;
            corner(t, pair, k, BoxTopology.slotVertex(after == ~cutSide ? after : slot), begin);
        }
        feature[k] = crossing;
        slack[k] = slack(crossing);
        side[k] = leaving;
    }

    /** The point of the incident plane above a corner of the face, as {@code IncidentPlane}'s. */
    private void corner(double[] t, int i, int k, int vertex, int begin) {
        int axis = begin >> 3;
        double normal = (begin & 4) != 0 ? 1 : -1;
        int half = (flip ? HALF_B : HALF_A) + i;
        double x = (vertex & 1) == 0 ? -t[half] : t[half];
        double y = (vertex & 2) == 0 ? -t[half + CAPACITY] : t[half + CAPACITY];
        double z = (vertex & 4) == 0 ? -t[half + 2 * CAPACITY] : t[half + 2 * CAPACITY];
        double above = BoxIncidentPlane.above(t, i, flip, incident >> 2, axis, normal, x, y, z);
        double height = axis == 0 ? x : axis == 1 ? y : z;
        n[k] = height + above * normal;
        u[k] = axis == 0 ? y : x;
        v[k] = axis == 2 ? y : z;
    }

    private int name(int cutSide, int slot, int begin) {
        return name(flip, cutSide, slot, begin);
    }

    /** What a side plane makes of a side that came from an edge, or from another side plane. */
    static int name(boolean flip, int cutSide, int slot, int begin) {
        if (cutSide >= 0) {
            return crossing(flip, cutSide, BoxTopology.slotEdge(slot));
        }
        int kind = flip ? FeatureIds.VERTEX_B : FeatureIds.VERTEX_A;
        int after = slot == begin + 3 ? begin : slot + 1;
        return kind | BoxTopology.slotVertex(after == ~cutSide ? after : slot);
    }

    /** Drops the corners beyond the margin; what is left has its separation in {@link #beyond}. */
    private void keepNear(boolean positive, double limit, double margin) {
        int kept = 0;
        long near = 0;
        for (int i = 0; i < count; i++) {
            int k = at(i);
            double s = (positive ? n[k] : -n[k]) - limit;
            beyond[k] = s;
            boolean stays = s <= margin;
            leftOut = !stays && s < leftOut ? s : leftOut;
            near |= stays ? (long) k << (4 * kept) : 0;
            kept += stays ? 1 : 0;
        }
        order = near;
        count = kept;
    }

    private void reduce(int axis, boolean positive, double hysteresis) {
        double normal = positive ? 1 : -1;
        double[] x = axis == 0 ? n : u;
        double[] y = axis == 0 ? u : axis == 1 ? n : v;
        double[] z = axis == 2 ? n : v;
        for (int i = 0; i < count; i++) {
            int k = at(i);
            many.x[i] = x[k];
            many.y[i] = y[k];
            many.z[i] = z[k];
            many.separation[i] = beyond[k];
            many.feature[i] = feature[k];
        }
        many.count = count;
        reduction.reduce(
                many,
                axis == 0 ? normal : 0,
                axis == 1 ? normal : 0,
                axis == 2 ? normal : 0,
                0.01 * hysteresis,
                hysteresis,
                last);
        // The four are in the order of the polygon still: look them up by name and depth.
        long four = 0;
        int found = 0;
        for (int i = 0; i < count && found < 4; i++) {
            int k = at(i);
            if (feature[k] == many.feature[found]
                    && x[k] == many.x[found]
                    && y[k] == many.y[found]) {
                four |= (long) k << (4 * found++);
            }
        }
        order = four;
        count = found;
    }

    /** Writes the points, midway between the surfaces, into the columns in order of names. */
    private int put(double[] t, int i, boolean positive) {
        long a = key(0);
        long b = key(1);
        long c = key(2);
        long d = key(3);
        long low = Math.min(a, b);
        long high = Math.max(a, b);
        long low2 = Math.min(c, d);
        long high2 = Math.max(c, d);
        long mid = Math.max(low, low2);
        long mid2 = Math.min(high, high2);
        double least = Double.MAX_VALUE;
        int hash = 0;
        for (int p = 0; p < count; p++) {
            long chosen =
                    p == 0
                            ? Math.min(low, low2)
                            : p == 1
                                    ? Math.min(mid, mid2)
                                    : p == 2 ? Math.max(mid, mid2) : Math.max(high, high2);
            int k = (int) chosen & 15;
            double s = beyond[k];
            least = s < least ? s : least;
            int to = CORNER + POINT * p + i;
            t[to] = positive ? n[k] - s / 2 : n[k] + s / 2;
            t[to + CAPACITY] = u[k];
            t[to + 2 * CAPACITY] = v[k];
            name[4 * i + p] = feature[k];
            hash |= FeatureIds.hash(feature[k]) << (8 * p);
            separation[4 * i + p] = s;
        }
        names[i] = hash;
        deepest = least;
        return count;
    }

    /** Sorts by name, then by place in the polygon; places beyond its end come last. */
    private long key(int place) {
        int k = at(place);
        long key = (feature[k] & 0xFFFFFFFFL) << 8 | (long) place << 4 | k;
        return place < count ? key : Long.MAX_VALUE;
    }
}
