package dev.cairn.physics.narrowphase.box;

import static dev.cairn.physics.narrowphase.wide.BoxBatch.*;

import dev.cairn.physics.narrowphase.NarrowPhase;
import dev.cairn.physics.narrowphase.pair.ContactTolerances;
import dev.cairn.physics.narrowphase.pair.FeatureIds;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.narrowphase.pair.WarmStartKey;
import dev.cairn.physics.narrowphase.wide.BoxAxes;
import dev.cairn.physics.narrowphase.wide.BoxBatch;
import dev.cairn.physics.shape.Box;

/**
 * Contacts of pairs of boxes in batches, by the same rules as {@link NarrowPhase} and with the same
 * results, for face contacts and pairs that are apart. The rest (an edge, a corner) goes to {@link
 * NarrowPhase}. With lanes, face contacts that were such in the last tick and are clipped to a
 * quadrilateral are found from beginning to end by {@link BoxAxes}; the others, and all without
 * lanes, pair by pair.
 *
 * <p>One instance per worker; not thread-safe; allocates nothing.
 */
public final class BoxContacts {
    /**
     * Thinner boxes (inner by outer radius) take the other way: rounding would hide their thickness
     * from a support point.
     */
    private static final double THINNEST = 1e-9;

    private final BoxBatch batch = new BoxBatch();
    private final double[] t = batch.data;
    private final NarrowPhase single;

    private final BoxClipper cuts = new BoxClipper();
    private boolean wide = BoxAxes.wide();

    /** Pairs whose contact was found by lanes alone, a bit each. */
    private int settled;

    /** Of the others: whether they are apart, and else their faces; then what was found. */
    private final BoxReferenceFace choice = new BoxReferenceFace(t);

    private final double[] deepest = new double[CAPACITY];
    private final int[] pointCount = new int[CAPACITY];

    /** An empty batch. */
    public BoxContacts(NarrowPhase single) {
        this.single = single;
    }

    /** Whether a box may be put into a batch; false for extremely thin ones. */
    public static boolean fits(Box box) {
        return box.innerRadius() >= THINNEST * box.outerRadius();
    }

    /**
     * Chooses whether lanes are used where there are any; they are at first. The results are the
     * same bits. Until a kernel is compiled its vectors are objects on the heap, so lanes pay only
     * where a kernel runs often.
     *
     * @param often whether many batches are to come in each tick
     */
    public void useLanes(boolean often) {
        wide = often && BoxAxes.wide();
    }

    /**
     * Puts a pair into the batch. The arguments are those of {@link NarrowPhase#collide}.
     *
     * @param i its place, 0 to {@link BoxBatch#CAPACITY} - 1
     * @param innerRadius the smaller of the inner radii, m
     * @param distance the margin: points up to this far apart are reported, m, not negative
     * @param cache the key that the last call for this pair returned; 0 if there is none
     */
    public void put(
            int i,
            Box a,
            Box b,
            double qAx,
            double qAy,
            double qAz,
            double qAw,
            double qBx,
            double qBy,
            double qBz,
            double qBw,
            double dx,
            double dy,
            double dz,
            double innerRadius,
            double distance,
            long cache) {
        double[] t = this.t;
        t[TURN_A + i] = qAx;
        t[TURN_A + CAPACITY + i] = qAy;
        t[TURN_A + 2 * CAPACITY + i] = qAz;
        t[TURN_A + 3 * CAPACITY + i] = qAw;
        t[TURN_B + i] = qBx;
        t[TURN_B + CAPACITY + i] = qBy;
        t[TURN_B + 2 * CAPACITY + i] = qBz;
        t[TURN_B + 3 * CAPACITY + i] = qBw;
        t[OFFSET + i] = dx;
        t[OFFSET + CAPACITY + i] = dy;
        t[OFFSET + 2 * CAPACITY + i] = dz;
        t[HALF_A + i] = a.halfX();
        t[HALF_A + CAPACITY + i] = a.halfY();
        t[HALF_A + 2 * CAPACITY + i] = a.halfZ();
        t[HALF_B + i] = b.halfX();
        t[HALF_B + CAPACITY + i] = b.halfY();
        t[HALF_B + 2 * CAPACITY + i] = b.halfZ();
        t[MARGIN + i] = distance;
        t[INNER + i] = innerRadius;
        t[LAST + i] = cache >>> 47;
        choice.key[i] = cache;
    }

    /** Collides all pairs that were put. */
    public void run(int count) {
        settled = 0;
        if (!wide) {
            BoxAxes.scalar(batch, count);
            for (int i = 0; i < count; i++) {
                one(i);
            }
            return;
        }
        // In one long method: shorter ones are compiled into their callers, which then have no
        // room left for what is small.
        int all = (int) ((1L << count) - 1);
        BoxAxes.faces(batch, count);
        int others = BoxAxes.choose(batch, count) & all;
        int near = 0;
        for (int bits = others; bits != 0; bits &= bits - 1) {
            int i = Integer.numberOfTrailingZeros(bits);
            if (!choice.apartByFaces(i)) {
                near |= 1 << i;
            }
        }
        BoxAxes.edges(batch, near);
        for (int bits = near; bits != 0; bits &= bits - 1) {
            int i = Integer.numberOfTrailingZeros(bits);
            choice.choose(i);
        }
        BoxAxes.corners(batch, count);
        long cut = BoxAxes.clipAligned(batch, count);
        settled = (int) cut & all & ~others;
        for (int bits = (int) (cut >>> 32) & all; bits != 0; bits &= bits - 1) {
            int i = Integer.numberOfTrailingZeros(bits);
            if (!AlignedFeatureIds.rests((int) t[ALIGNED + i], (int) choice.key[i])) {
                t[ALIGNED + i] = -1;
                settled &= ~(1 << i);
            }
        }
        // What has chosen its face in lanes, but needs its edges.
        int unproven = all & ~others & ~settled;
        BoxAxes.edges(batch, unproven);
        for (int bits = unproven; bits != 0; bits &= bits - 1) {
            int i = Integer.numberOfTrailingZeros(bits);
            choice.choose(i);
        }
        int edges = 0;
        for (int bits = all & ~settled; bits != 0; bits &= bits - 1) {
            int i = Integer.numberOfTrailingZeros(bits);
            edges |= choice.onFace[i] && choice.crosses[i] ? 1 << i : 0;
        }
        BoxAxes.crossings(batch, edges);
        for (int bits = all & ~settled; bits != 0; bits &= bits - 1) {
            int i = Integer.numberOfTrailingZeros(bits);
            if ((edges >>> i & 1) != 0) {
                choice.crosses(i, true);
            }
            if (choice.onFace[i] && !choice.crosses[i]) {
                clip(i);
            }
        }
        BoxAxes.world(batch, count);
    }

    /** A pair without lanes, after its axes. */
    private void one(int i) {
        if (choice.apartByFaces(i)) {
            return;
        }
        choice.choose(i);
        if (choice.onFace[i] && choice.crosses[i]) {
            choice.crosses(i, false);
        }
        if (choice.onFace[i] && !choice.crosses[i]) {
            BoxAxes.corners(t, i);
            clip(i);
            BoxAxes.world(t, i, pointCount[i]);
        }
    }

    private void clip(int i) {
        pointCount[i] = cuts.clip(t, i, t[INNER + i], t[MARGIN + i], (int) choice.key[i]);
        deepest[i] = cuts.deepest;
        choice.leftOut[i] = cuts.leftOut;
    }

    /**
     * The contact of one pair, after {@link #run}; once per pair. The result is that of {@link
     * NarrowPhase#collide}; {@link Manifold#bound} may be larger. Returns the key to pass next
     * time.
     */
    public long take(int i, Box a, Box b, Manifold out) {
        out.patch = 0;
        out.capped = false;
        if (isSettled(i)) {
            out.bound = t[BOUND + i];
            copyNormal(i, out);
            return AlignedPoints.copy(t, i, out);
        }
        return takeOther(i, a, b, out);
    }

    private boolean isSettled(int i) {
        return (settled >>> i & 1) != 0;
    }

    private long takeOther(int i, Box a, Box b, Manifold out) {
        out.pointCount = 0;
        out.bound = 0;
        if (!choice.onFace[i]) {
            return choice.key[i];
        }
        if (choice.crosses[i]) {
            return point(i, a, b, out);
        }
        int face = 2 * (int) t[AXIS + i] + (t[SIGN + i] > 0 ? 1 : 0);
        boolean flip = t[FLIP + i] != 0;
        if (pointCount[i] == 0 || choice.strays(i, deepest[i])) {
            return point(i, a, b, out);
        }
        out.bound = Math.abs(choice.best[i] - deepest[i]) + 0x1p-48 * scale(i);
        copyNormal(i, out);
        if (t[ALIGNED + i] >= 0) {
            return AlignedPoints.copy(t, i, out);
        }
        copy(i, pointCount[i], out);
        long kind = flip ? WarmStartKey.FACE_B : WarmStartKey.FACE_A;
        return WarmStartKey.of(kind, face, cuts.names[i]);
    }

    /**
     * How much nearer a pair must come for another point; after {@link #take}. Returns the least
     * separation of the points that were left out for the margin, m; infinite when there are none;
     * of a pair that is apart a lower bound of its distance; NaN when it is neither apart nor on a
     * face.
     */
    public double leftOut(int i) {
        return isSettled(i) ? Double.POSITIVE_INFINITY : choice.leftOut[i];
    }

    private void copyNormal(int i, Manifold out) {
        out.normalX = t[NORMAL + i];
        out.normalY = t[NORMAL + CAPACITY + i];
        out.normalZ = t[NORMAL + 2 * CAPACITY + i];
    }

    private void copy(int i, int points, Manifold out) {
        out.pointCount = points;
        for (int p = 0; p < points; p++) {
            int at = CORNER + POINT * p + i;
            out.pointX[p] = t[at];
            out.pointY[p] = t[at + CAPACITY];
            out.pointZ[p] = t[at + 2 * CAPACITY];
            out.separation[p] = cuts.separation[4 * i + p];
            out.feature[p] = cuts.name[4 * i + p];
        }
    }

    /**
     * Whether a pair has four points that were clipped to a quadrilateral in lanes, with the same
     * names as in the last tick; after {@link #run}, instead of {@link #take}.
     *
     * @param names of the last tick, four from {@code first} on
     * @param first where they begin
     * @param order which of the four, in order of names, is at each place, two bits each
     * @return false when {@link #take} must tell
     */
    public boolean sameAligned(int i, int[] names, int first, int order) {
        if (!isSettled(i)
                && (!wide
                        || !choice.onFace[i]
                        || choice.crosses[i]
                        || t[ALIGNED + i] < 0
                        || choice.strays(i, deepest[i]))) {
            return false;
        }
        return AlignedPoints.named(t, i, names, first, order);
    }

    /**
     * Writes the contact of a pair of {@link #sameAligned}.
     *
     * @param order of the places, see {@link #sameAligned}
     * @param normal receives the unit normal from A to B, world
     * @param anchors receives of each point its place from A's centre, then from B's, world, m
     * @param separation receives the separations, m
     * @return the key to pass next time
     */
    public long write(
            int i,
            int order,
            double[] normal,
            int n,
            double[] anchors,
            int at,
            double[] separation,
            int first) {
        return AlignedPoints.write(t, i, order, normal, n, anchors, at, separation, first);
    }

    /** Two edges that cross; where they do not, {@link NarrowPhase} finds what touches. */
    private long point(int i, Box a, Box b, Manifold out) {
        choice.leftOut[i] = Double.NaN;
        double best = choice.best[i];
        double separation = t[SEPARATION_EDGE + i];
        BoxEdgeContact crossing = choice.crossing;
        boolean found = separation >= best - ContactTolerances.HYSTERESIS * t[INNER + i];
        if (found && wide && choice.crosses[i]) {
            found = crossing.copy(i, out);
        } else if (found) {
            found = crossing.place(i) && crossing.point(i, out);
        }
        if (found) {
            out.bound = Math.abs(best - separation) + 0x1p-48 * scale(i);
            return WarmStartKey.of(WarmStartKey.EDGES, 0, FeatureIds.of(out));
        }
        return single(i, a, b, out);
    }

    private long single(int i, Box a, Box b, Manifold out) {
        return single.collide(
                a,
                b,
                t[TURN_A + i],
                t[TURN_A + CAPACITY + i],
                t[TURN_A + 2 * CAPACITY + i],
                t[TURN_A + 3 * CAPACITY + i],
                t[TURN_B + i],
                t[TURN_B + CAPACITY + i],
                t[TURN_B + 2 * CAPACITY + i],
                t[TURN_B + 3 * CAPACITY + i],
                t[OFFSET + i],
                t[OFFSET + CAPACITY + i],
                t[OFFSET + 2 * CAPACITY + i],
                t[MARGIN + i],
                choice.key[i],
                out);
    }

    /** At least what rounding errors are proportional to. */
    private double scale(int i) {
        double sum = 0;
        for (int k = 0; k < 3; k++) {
            sum +=
                    t[HALF_A + k * CAPACITY + i]
                            + t[HALF_B + k * CAPACITY + i]
                            + Math.abs(t[CENTRE + k * CAPACITY + i]);
        }
        return sum;
    }
}
