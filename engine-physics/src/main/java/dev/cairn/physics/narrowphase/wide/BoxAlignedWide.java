package dev.cairn.physics.narrowphase.wide;

import static dev.cairn.physics.narrowphase.wide.BoxBatch.*;

import dev.cairn.physics.narrowphase.pair.ContactTolerances;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * Boxes whose faces are aligned so well that clipping leaves a quadrilateral, a pair to a lane: no
 * side of the reference face cuts the incident face; or one side cuts two neighbouring corners off;
 * all corners are clear of it, and all points are within the margin. Each of the two corners moves
 * along its edge to the side, so four points are left. The operations on each number are those of
 * {@code narrowphase.Clipper}. Other pairs keep their corners.
 *
 * <p>A corner that is only a little beyond a side is cut off unless it was a point of the last
 * tick. Lanes know no feature ids: they cut it off, and {@code BoxContacts} looks whether that was
 * right.
 *
 * <p>The four corners, and later points, are called p, q, r and w: p and w are corners 0 and 3, q
 * and r corners 1 and 2, or 2 and 1, so that the side cuts the edges pq and rw.
 */
final class BoxAlignedWide {
    private static final VectorSpecies<Double> S = DoubleVector.SPECIES_PREFERRED;
    private static final int LANES = S.length();

    static final int P = ALIGNED_POINT;
    static final int Q = P + POINT;
    static final int R = Q + POINT;
    static final int W = R + POINT;

    /** In place of separations, how far the corners are beyond the side that cuts. */
    private static final int BEYOND = P + 3 * CAPACITY;

    /**
     * Of the scale: more than the rounding of a separation along the cross product of two edges,
     * whose length may be 2^-20.
     */
    private static final double ROUNDING = 0x1p-26;

    /**
     * A little less than what {@code BoxContacts.strays} allows of {@link
     * ContactTolerances#HYSTERESIS}.
     */
    private static final double STRAYS = 1.498 * ContactTolerances.HYSTERESIS;

    private BoxAlignedWide() {}

    /**
     * Fills STRAIGHT, separations, DEEPEST, BOUND; returns a bit for each proven pair, and 32 bits
     * higher one for each that has a corner near a side.
     */
    static long run(double[] t, int count) {
        long bits = 0;
        for (int i = 0; i < count; i += LANES) {
            sides(t, i);
            beyond(t, i);
            cut(t, i);
            move(t, i, 0);
            move(t, i, CAPACITY);
            move(t, i, 2 * CAPACITY);
            separations(t, i);
            bits |= certify(t, i);
        }
        return bits;
    }

    /** The side that cuts. */
    private static void sides(double[] t, int i) {
        DoubleVector near = DoubleVector.fromArray(S, t, INNER + i).mul(ContactTolerances.ON_PLANE);
        VectorMask<Double> highU =
                DoubleVector.fromArray(S, t, OUTSIDE + i).compare(VectorOperators.GT, near);
        VectorMask<Double> lowU =
                DoubleVector.fromArray(S, t, OUTSIDE + CAPACITY + i)
                        .compare(VectorOperators.GT, near);
        VectorMask<Double> highV =
                DoubleVector.fromArray(S, t, OUTSIDE + 2 * CAPACITY + i)
                        .compare(VectorOperators.GT, near);
        VectorMask<Double> lowV =
                DoubleVector.fromArray(S, t, OUTSIDE + 3 * CAPACITY + i)
                        .compare(VectorOperators.GT, near);
        VectorMask<Double> onU = highU.or(lowU);
        VectorMask<Double> onV = highV.or(lowV);
        DoubleVector one = DoubleVector.broadcast(S, 1);
        DoubleVector zero = DoubleVector.zero(S);
        DoubleVector signU = one.blend(-1, lowU);
        DoubleVector signV = one.blend(-1, lowV);
        DoubleVector halfU = DoubleVector.fromArray(S, t, HALF + CAPACITY + i);
        DoubleVector halfV = DoubleVector.fromArray(S, t, HALF + 2 * CAPACITY + i);
        signV.blend(signU, onU).intoArray(t, SIDE + i);
        halfV.blend(halfU, onU).intoArray(t, SIDE + CAPACITY + i);
        zero.blend(1, onU.or(onV)).intoArray(t, CUTS + i);
        zero.blend(1, onU).intoArray(t, ON_U + i);
        // Opposite sides leave no quadrilateral, sides beside each other rarely do.
        zero.blend(-1, highU.and(lowU).or(highV.and(lowV)).or(onU.and(onV)))
                .intoArray(t, ALIGNED + i);
    }

    /** How far the corners are beyond the side. */
    private static void beyond(double[] t, int i) {
        VectorMask<Double> onU =
                DoubleVector.fromArray(S, t, ON_U + i).compare(VectorOperators.NE, 0);
        DoubleVector sign = DoubleVector.fromArray(S, t, SIDE + i);
        DoubleVector limit = DoubleVector.fromArray(S, t, SIDE + CAPACITY + i);
        int u = CORNER + CAPACITY + i;
        int v = u + CAPACITY;
        DoubleVector.fromArray(S, t, v)
                .blend(DoubleVector.fromArray(S, t, u), onU)
                .mul(sign)
                .sub(limit)
                .intoArray(t, BEYOND + i);
        DoubleVector.fromArray(S, t, v + POINT)
                .blend(DoubleVector.fromArray(S, t, u + POINT), onU)
                .mul(sign)
                .sub(limit)
                .intoArray(t, BEYOND + POINT + i);
        DoubleVector.fromArray(S, t, v + 2 * POINT)
                .blend(DoubleVector.fromArray(S, t, u + 2 * POINT), onU)
                .mul(sign)
                .sub(limit)
                .intoArray(t, BEYOND + 2 * POINT + i);
        DoubleVector.fromArray(S, t, v + 3 * POINT)
                .blend(DoubleVector.fromArray(S, t, u + 3 * POINT), onU)
                .mul(sign)
                .sub(limit)
                .intoArray(t, BEYOND + 3 * POINT + i);
    }

    /** Which corners the side cuts off, and where it cuts the two edges. */
    private static void cut(double[] t, int i) {
        DoubleVector one = DoubleVector.broadcast(S, 1);
        DoubleVector zero = DoubleVector.zero(S);
        VectorMask<Double> cuts =
                DoubleVector.fromArray(S, t, CUTS + i).compare(VectorOperators.NE, 0);
        VectorMask<Double> onU =
                DoubleVector.fromArray(S, t, ON_U + i).compare(VectorOperators.NE, 0);
        DoubleVector sign = DoubleVector.fromArray(S, t, SIDE + i);
        DoubleVector s0 = DoubleVector.fromArray(S, t, BEYOND + i);
        DoubleVector s1 = DoubleVector.fromArray(S, t, BEYOND + POINT + i);
        DoubleVector s2 = DoubleVector.fromArray(S, t, BEYOND + 2 * POINT + i);
        DoubleVector s3 = DoubleVector.fromArray(S, t, BEYOND + 3 * POINT + i);
        DoubleVector inner = DoubleVector.fromArray(S, t, INNER + i);
        DoubleVector near = inner.mul(ContactTolerances.ON_PLANE);
        VectorMask<Double> out0 = s0.compare(VectorOperators.GT, near);
        VectorMask<Double> out1 = s1.compare(VectorOperators.GT, near);
        VectorMask<Double> along = out0.xor(out1).not().and(cuts);
        VectorMask<Double> low = out0.and(cuts);
        VectorMask<Double> high = cuts.andNot(out0);
        DoubleVector still = inner.mul(ContactTolerances.STILL_ON_PLANE);
        DoubleVector within = still.neg();
        VectorMask<Double> out2 = s2.compare(VectorOperators.GT, near);
        VectorMask<Double> out3 = s3.compare(VectorOperators.GT, near);
        // Two neighbours are outside when the opposite corners are not.
        VectorMask<Double> two =
                out0.or(s0.compare(VectorOperators.LT, within))
                        .and(out1.or(s1.compare(VectorOperators.LT, within)))
                        .and(out2.or(s2.compare(VectorOperators.LT, within)))
                        .and(out3.or(s3.compare(VectorOperators.LT, within)))
                        .and(out0.xor(out3))
                        .and(out1.xor(out2));
        VectorMask<Double> soft =
                out0.and(s0.compare(VectorOperators.LE, still))
                        .or(out1.and(s1.compare(VectorOperators.LE, still)))
                        .or(out2.and(s2.compare(VectorOperators.LE, still)))
                        .or(out3.and(s3.compare(VectorOperators.LE, still)));
        zero.blend(1, soft.and(cuts)).intoArray(t, SOFT + i);
        zero.blend(1, along).intoArray(t, ALONG + i);
        zero.blend(-1, high).blend(1, low).intoArray(t, LOW + i);
        // An edge is cut from its end inside.
        DoubleVector sq = s1.blend(s2, along);
        DoubleVector sr = s2.blend(s1, along);
        DoubleVector begin = s0.blend(sq, low);
        begin.div(begin.sub(sq.blend(s0, low))).intoArray(t, CUT + i);
        begin = s3.blend(sr, high);
        begin.div(begin.sub(sr.blend(s3, high))).intoArray(t, CUT + CAPACITY + i);
        DoubleVector way =
                zero.blend(8, onU.not())
                        .add(zero.blend(4, sign.compare(VectorOperators.LT, 0)))
                        .add(zero.blend(2, along))
                        .add(one.blend(2, low))
                        .blend(0, cuts.not());
        VectorMask<Double> missed =
                two.or(cuts.not())
                        .not()
                        .or(
                                DoubleVector.fromArray(S, t, ALIGNED + i)
                                        .compare(VectorOperators.LT, 0));
        way.blend(-1, missed).intoArray(t, ALIGNED + i);
    }

    /** Along one axis, moves the corners that the side cuts off along their edges. */
    private static void move(double[] t, int i, int axis) {
        int from = CORNER + axis + i;
        int to = P + axis + i;
        VectorMask<Double> along =
                DoubleVector.fromArray(S, t, ALONG + i).compare(VectorOperators.NE, 0);
        DoubleVector lowHigh = DoubleVector.fromArray(S, t, LOW + i);
        VectorMask<Double> low = lowHigh.compare(VectorOperators.GT, 0);
        VectorMask<Double> high = lowHigh.compare(VectorOperators.LT, 0);
        DoubleVector p = DoubleVector.fromArray(S, t, from);
        DoubleVector x1 = DoubleVector.fromArray(S, t, from + POINT);
        DoubleVector x2 = DoubleVector.fromArray(S, t, from + 2 * POINT);
        DoubleVector w = DoubleVector.fromArray(S, t, from + 3 * POINT);
        DoubleVector q = x1.blend(x2, along);
        DoubleVector r = x2.blend(x1, along);
        DoubleVector cut = DoubleVector.fromArray(S, t, CUT + i);
        DoubleVector begin = p.blend(q, low);
        DoubleVector pq = begin.add(cut.mul(q.blend(p, low).sub(begin)));
        cut = DoubleVector.fromArray(S, t, CUT + CAPACITY + i);
        begin = w.blend(r, high);
        DoubleVector rw = begin.add(cut.mul(r.blend(w, high).sub(begin)));
        p.blend(pq, low).intoArray(t, to);
        q.blend(pq, high).intoArray(t, to + POINT);
        r.blend(rw, low).intoArray(t, to + 2 * POINT);
        w.blend(rw, high).intoArray(t, to + 3 * POINT);
    }

    /** Puts the points of the pairs of some lanes in the place of their corners. */
    static void place(double[] t, int i) {
        VectorMask<Double> fits =
                DoubleVector.fromArray(S, t, ALIGNED + i).compare(VectorOperators.GE, 0);
        for (int p = i; p < 4 * POINT; p += POINT) {
            for (int k = p; k < p + 3 * CAPACITY; k += CAPACITY) {
                DoubleVector.fromArray(S, t, CORNER + k)
                        .blend(DoubleVector.fromArray(S, t, P + k), fits)
                        .intoArray(t, CORNER + k);
            }
        }
    }

    /** Separations, and points midway between the surfaces. */
    private static void separations(double[] t, int i) {
        DoubleVector way = DoubleVector.fromArray(S, t, ALIGNED + i);
        DoubleVector sign = DoubleVector.fromArray(S, t, SIGN + i);
        DoubleVector height = DoubleVector.fromArray(S, t, HALF + i);
        DoubleVector margin = DoubleVector.fromArray(S, t, MARGIN + i);
        DoubleVector n0 = DoubleVector.fromArray(S, t, P + i);
        DoubleVector n1 = DoubleVector.fromArray(S, t, Q + i);
        DoubleVector n2 = DoubleVector.fromArray(S, t, R + i);
        DoubleVector n3 = DoubleVector.fromArray(S, t, W + i);
        DoubleVector s0 = n0.mul(sign).sub(height);
        DoubleVector s1 = n1.mul(sign).sub(height);
        DoubleVector s2 = n2.mul(sign).sub(height);
        DoubleVector s3 = n3.mul(sign).sub(height);
        s0.intoArray(t, CORNER + 3 * CAPACITY + i);
        s1.intoArray(t, CORNER + POINT + 3 * CAPACITY + i);
        s2.intoArray(t, CORNER + 2 * POINT + 3 * CAPACITY + i);
        s3.intoArray(t, CORNER + 3 * POINT + 3 * CAPACITY + i);
        n0.sub(sign.mul(s0.mul(0.5))).intoArray(t, P + i);
        n1.sub(sign.mul(s1.mul(0.5))).intoArray(t, Q + i);
        n2.sub(sign.mul(s2.mul(0.5))).intoArray(t, R + i);
        n3.sub(sign.mul(s3.mul(0.5))).intoArray(t, W + i);
        VectorMask<Double> up = s1.compare(VectorOperators.GT, s0);
        DoubleVector highest = s0.blend(s1, up);
        DoubleVector deepest = s1.blend(s0, up);
        up = s3.compare(VectorOperators.GT, s2);
        DoubleVector highest2 = s2.blend(s3, up);
        DoubleVector deepest2 = s3.blend(s2, up);
        highest = highest.blend(highest2, highest2.compare(VectorOperators.GT, highest));
        deepest = deepest.blend(deepest2, deepest2.compare(VectorOperators.LT, deepest));
        deepest.intoArray(t, DEEPEST + i);
        highest.intoArray(t, HIGHEST + i);
        VectorMask<Double> fits =
                way.compare(VectorOperators.GE, 0).and(highest.compare(VectorOperators.LE, margin));
        DoubleVector.fromArray(S, t, FLIP + i)
                .mul(6)
                .add(DoubleVector.fromArray(S, t, AXIS + i).mul(2))
                .add(sign.mul(.5).add(.5))
                .mul(6)
                .add(DoubleVector.fromArray(S, t, INCIDENT + i))
                .mul(WAYS)
                .add(way)
                .blend(-1, fits.not())
                .intoArray(t, ALIGNED + i);
    }

    /**
     * Whether the axes of edges can be left out: each point of the patch lies on the incident face
     * and, h above it, in the reference face up to e. Along a unit vector at an angle of a to the
     * normal the boxes are separated by at most
     *
     * <pre>  h cos a - (w - e) sin a,</pre>
     *
     * with h the largest separation of a point and w the least width of the patch: take the
     * outermost points on either side. Between 0 and 90 degrees that is at most h when w - e is at
     * least -h. Beyond 90 degrees take points of the reference box's other face, H farther down:
     * then it is at most h when h plus the least separation is at least -H. A convex patch of area
     * F and perimeter L is at least 2 F / L wide, and L is at most that of the reference face. So
     * the signed distance is between the largest separation along a face normal and h; where all
     * decisions are the same for each of these values, edges cannot change them.
     */
    private static long certify(double[] t, int i) {
        VectorMask<Double> fits =
                DoubleVector.fromArray(S, t, ALIGNED + i).compare(VectorOperators.GE, 0);
        DoubleVector margin = DoubleVector.fromArray(S, t, MARGIN + i);
        DoubleVector highest = DoubleVector.fromArray(S, t, HIGHEST + i);
        DoubleVector deepest = DoubleVector.fromArray(S, t, DEEPEST + i);
        DoubleVector inner = DoubleVector.fromArray(S, t, INNER + i);
        int u = CAPACITY + i;
        int v = u + CAPACITY;
        DoubleVector pwU =
                DoubleVector.fromArray(S, t, W + u).sub(DoubleVector.fromArray(S, t, P + u));
        DoubleVector pwV =
                DoubleVector.fromArray(S, t, W + v).sub(DoubleVector.fromArray(S, t, P + v));
        DoubleVector qrU =
                DoubleVector.fromArray(S, t, R + u).sub(DoubleVector.fromArray(S, t, Q + u));
        DoubleVector qrV =
                DoubleVector.fromArray(S, t, R + v).sub(DoubleVector.fromArray(S, t, Q + v));
        DoubleVector twice = pwU.mul(qrV).sub(pwV.mul(qrU)).abs();
        DoubleVector beside = inner.mul(4 * ContactTolerances.ON_PLANE);
        DoubleVector around =
                DoubleVector.fromArray(S, t, HALF + u)
                        .add(DoubleVector.fromArray(S, t, HALF + v))
                        .add(beside)
                        .mul(4.0001);
        VectorMask<Double> wide =
                twice.compare(VectorOperators.GT, beside.sub(highest).mul(around))
                        .and(twice.compare(VectorOperators.GT, beside.mul(around)));
        VectorMask<Double> shallow =
                highest.add(deepest)
                        .add(DoubleVector.fromArray(S, t, HALF + i))
                        .compare(VectorOperators.GT, 0);
        DoubleVector scale =
                DoubleVector.fromArray(S, t, HALF_A + i)
                        .add(DoubleVector.fromArray(S, t, HALF_A + u))
                        .add(DoubleVector.fromArray(S, t, HALF_A + v))
                        .add(DoubleVector.fromArray(S, t, HALF_B + i))
                        .add(DoubleVector.fromArray(S, t, HALF_B + u))
                        .add(DoubleVector.fromArray(S, t, HALF_B + v))
                        .add(DoubleVector.fromArray(S, t, CENTRE + i).abs())
                        .add(DoubleVector.fromArray(S, t, CENTRE + u).abs())
                        .add(DoubleVector.fromArray(S, t, CENTRE + v).abs());
        DoubleVector faces = DoubleVector.fromArray(S, t, SEPARATION_FACES + i);
        DoubleVector most = highest.add(scale.mul(ROUNDING));
        most = most.blend(faces, faces.compare(VectorOperators.GT, most));
        DoubleVector separation = DoubleVector.fromArray(S, t, SEPARATION + i);
        DoubleVector above = most.sub(deepest);
        DoubleVector below = deepest.sub(faces);
        DoubleVector wrong = above.blend(below, below.compare(VectorOperators.GT, above));
        wrong.add(scale.mul(0x1p-48)).intoArray(t, BOUND + i);
        DoubleVector allowed = inner.mul(STRAYS);
        VectorMask<Double> proven =
                fits.and(wide)
                        .and(shallow)
                        .and(most.compare(VectorOperators.LE, margin))
                        .and(wrong.compare(VectorOperators.LT, allowed))
                        .and(most.sub(separation).compare(VectorOperators.LT, allowed));
        VectorMask<Double> soft =
                fits.and(DoubleVector.fromArray(S, t, SOFT + i).compare(VectorOperators.NE, 0));
        return (proven.toLong() | soft.toLong() << 32) << i;
    }
}
