package dev.cairn.physics.narrowphase.wide;

import static dev.cairn.physics.narrowphase.wide.BoxAlignedWide.P;
import static dev.cairn.physics.narrowphase.wide.BoxAlignedWide.Q;
import static dev.cairn.physics.narrowphase.wide.BoxAlignedWide.R;
import static dev.cairn.physics.narrowphase.wide.BoxAlignedWide.W;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.*;

import dev.cairn.physics.narrowphase.pair.ContactTolerances;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * The second of two sides that leave a quadrilateral of a box's face, see {@link BoxAlignedWide}: a
 * pair to a lane.
 */
final class BoxSecondSideWide {
    private static final VectorSpecies<Double> S = DoubleVector.SPECIES_PREFERRED;

    private BoxSecondSideWide() {}

    static void run(double[] t, int i) {
        plane(t, i);
        corner(t, i);
        second(t, i);
        moveSecond(t, i, 0, 2 * CAPACITY);
        moveSecond(t, i, CAPACITY, 0);
        moveSecond(t, i, 2 * CAPACITY, CAPACITY);
    }

    /** The side that cuts after the first, on the second axis, of the pairs that have one. */
    private static void second(double[] t, int i) {
        DoubleVector sign = DoubleVector.fromArray(S, t, SECOND + i);
        VectorMask<Double> cuts = sign.compare(VectorOperators.NE, 0);
        DoubleVector limit = DoubleVector.fromArray(S, t, SECOND + CAPACITY + i);
        int v = 2 * CAPACITY + i;
        DoubleVector sp = DoubleVector.fromArray(S, t, P + v).mul(sign).sub(limit);
        DoubleVector sq = DoubleVector.fromArray(S, t, Q + v).mul(sign).sub(limit);
        DoubleVector sr = DoubleVector.fromArray(S, t, R + v).mul(sign).sub(limit);
        DoubleVector sw = DoubleVector.fromArray(S, t, W + v).mul(sign).sub(limit);
        DoubleVector inner = DoubleVector.fromArray(S, t, INNER + i);
        DoubleVector near = inner.mul(ContactTolerances.ON_PLANE);
        DoubleVector still = inner.mul(ContactTolerances.STILL_ON_PLANE);
        DoubleVector within = still.neg();
        VectorMask<Double> low = sp.compare(VectorOperators.GT, near);
        VectorMask<Double> outQ = sq.compare(VectorOperators.GT, near);
        VectorMask<Double> outR = sr.compare(VectorOperators.GT, near);
        VectorMask<Double> outW = sw.compare(VectorOperators.GT, near);
        VectorMask<Double> fits =
                low.or(sp.compare(VectorOperators.LT, within))
                        .and(outQ.or(sq.compare(VectorOperators.LT, within)))
                        .and(outR.or(sr.compare(VectorOperators.LT, within)))
                        .and(outW.or(sw.compare(VectorOperators.LT, within)))
                        .and(low.xor(outR))
                        .and(low.xor(outW))
                        .and(low.xor(outQ).not());
        VectorMask<Double> soft =
                low.and(sp.compare(VectorOperators.LE, still))
                        .or(outQ.and(sq.compare(VectorOperators.LE, still)))
                        .or(outR.and(sr.compare(VectorOperators.LE, still)))
                        .or(outW.and(sw.compare(VectorOperators.LE, still)));
        DoubleVector.fromArray(S, t, SOFT + i).blend(1, soft.and(cuts)).intoArray(t, SOFT + i);
        DoubleVector begin = sp.blend(sr, low);
        begin.div(begin.sub(sr.blend(sp, low))).intoArray(t, CUT + i);
        begin = sq.blend(sw, low);
        begin.div(begin.sub(sw.blend(sq, low))).intoArray(t, CUT + CAPACITY + i);
        DoubleVector way = DoubleVector.fromArray(S, t, ALIGNED + i);
        VectorMask<Double> missed = fits.not().and(cuts).or(way.compare(VectorOperators.LT, 0));
        DoubleVector zero = DoubleVector.zero(S);
        way.add(zero.blend(1, cuts))
                .add(zero.blend(2, sign.compare(VectorOperators.LT, 0)))
                .add(zero.blend(1, low.and(cuts)))
                .blend(-1, missed)
                .intoArray(t, ALIGNED + i);
        zero.blend(-1, cuts.andNot(low)).blend(1, low.and(cuts)).intoArray(t, SECOND_ON_U + i);
    }

    /**
     * Along one axis, moves the corners that the second side cuts off: one along its edge, that
     * which lies on the first side to the corner between both.
     */
    private static void moveSecond(double[] t, int i, int axis, int between) {
        int at = P + axis + i;
        VectorMask<Double> firstLow =
                DoubleVector.fromArray(S, t, FIRST_LOW + i).compare(VectorOperators.GT, 0);
        DoubleVector lowHigh = DoubleVector.fromArray(S, t, SECOND_ON_U + i);
        VectorMask<Double> low = lowHigh.compare(VectorOperators.GT, 0);
        VectorMask<Double> high = lowHigh.compare(VectorOperators.LT, 0);
        DoubleVector p = DoubleVector.fromArray(S, t, at);
        DoubleVector q = DoubleVector.fromArray(S, t, at + POINT);
        DoubleVector r = DoubleVector.fromArray(S, t, at + 2 * POINT);
        DoubleVector w = DoubleVector.fromArray(S, t, at + 3 * POINT);
        DoubleVector cut = DoubleVector.fromArray(S, t, CUT + i);
        DoubleVector begin = p.blend(r, low);
        DoubleVector pr = begin.add(cut.mul(r.blend(p, low).sub(begin)));
        cut = DoubleVector.fromArray(S, t, CUT + CAPACITY + i);
        begin = q.blend(w, low);
        DoubleVector qw = begin.add(cut.mul(w.blend(q, low).sub(begin)));
        DoubleVector corner = DoubleVector.fromArray(S, t, BETWEEN + between + i);
        pr = pr.blend(corner, firstLow);
        qw = corner.blend(qw, firstLow);
        p.blend(pr, low).intoArray(t, at);
        q.blend(qw, low).intoArray(t, at + POINT);
        r.blend(pr, high).intoArray(t, at + 2 * POINT);
        w.blend(qw, high).intoArray(t, at + 3 * POINT);
    }

    /**
     * The plane of the incident face in the face's frame, as {@code
     * narrowphase.BoxIncidentPlane}'s.
     */
    private static void plane(double[] t, int i) {
        DoubleVector axis = DoubleVector.fromArray(S, t, AXIS + i);
        VectorMask<Double> isX = axis.compare(VectorOperators.EQ, 0);
        VectorMask<Double> isZ = axis.compare(VectorOperators.EQ, 2);
        DoubleVector incident = DoubleVector.fromArray(S, t, INCIDENT + i);
        VectorMask<Double> kx = incident.compare(VectorOperators.LT, 2);
        VectorMask<Double> kz = incident.compare(VectorOperators.GE, 4);
        DoubleVector positive =
                incident.sub(DoubleVector.broadcast(S, 2).blend(0, kx).blend(4, kz));
        DoubleVector m =
                DoubleVector.broadcast(S, -1).blend(1, positive.compare(VectorOperators.GT, 0));
        DoubleVector n =
                DoubleVector.fromArray(S, t, ROWS + CAPACITY + i)
                        .blend(DoubleVector.fromArray(S, t, ROWS + i), kx)
                        .blend(DoubleVector.fromArray(S, t, ROWS + 2 * CAPACITY + i), kz)
                        .mul(m);
        DoubleVector u =
                DoubleVector.fromArray(S, t, ROWS + 4 * CAPACITY + i)
                        .blend(DoubleVector.fromArray(S, t, ROWS + 3 * CAPACITY + i), kx)
                        .blend(DoubleVector.fromArray(S, t, ROWS + 5 * CAPACITY + i), kz)
                        .mul(m);
        DoubleVector v =
                DoubleVector.fromArray(S, t, ROWS + 7 * CAPACITY + i)
                        .blend(DoubleVector.fromArray(S, t, ROWS + 6 * CAPACITY + i), kx)
                        .blend(DoubleVector.fromArray(S, t, ROWS + 8 * CAPACITY + i), kz)
                        .mul(m);
        DoubleVector x = u.blend(n, isX);
        DoubleVector y = n.blend(u, isX).blend(v, isZ);
        DoubleVector z = v.blend(n, isZ);
        DoubleVector dx = DoubleVector.fromArray(S, t, CENTRE + i);
        DoubleVector dy = DoubleVector.fromArray(S, t, CENTRE + CAPACITY + i);
        DoubleVector dz = DoubleVector.fromArray(S, t, CENTRE + 2 * CAPACITY + i);
        VectorMask<Double> flip =
                DoubleVector.fromArray(S, t, FLIP + i).compare(VectorOperators.GT, 0);
        DoubleVector hx =
                DoubleVector.fromArray(S, t, HALF_B + i)
                        .blend(DoubleVector.fromArray(S, t, HALF_A + i), flip);
        DoubleVector hy =
                DoubleVector.fromArray(S, t, HALF_B + CAPACITY + i)
                        .blend(DoubleVector.fromArray(S, t, HALF_A + CAPACITY + i), flip);
        DoubleVector hz =
                DoubleVector.fromArray(S, t, HALF_B + 2 * CAPACITY + i)
                        .blend(DoubleVector.fromArray(S, t, HALF_A + 2 * CAPACITY + i), flip);
        DoubleVector along = x.mul(dx).add(y.mul(dy)).add(z.mul(dz));
        along = along.blend(m.mul(dy.blend(dx, kx).blend(dz, kz)).neg(), flip);
        x.intoArray(t, PLANE + i);
        y.intoArray(t, PLANE + CAPACITY + i);
        z.intoArray(t, PLANE + 2 * CAPACITY + i);
        hy.blend(hx, kx).blend(hz, kz).add(along).intoArray(t, PLANE + 3 * CAPACITY + i);
    }

    /**
     * The point of that plane above the corner between the two sides that cut: along the face's
     * normal; along the other axes it is known.
     */
    private static void corner(double[] t, int i) {
        DoubleVector axis = DoubleVector.fromArray(S, t, AXIS + i);
        VectorMask<Double> isX = axis.compare(VectorOperators.EQ, 0);
        VectorMask<Double> isZ = axis.compare(VectorOperators.EQ, 2);
        DoubleVector x = DoubleVector.fromArray(S, t, PLANE + i);
        DoubleVector y = DoubleVector.fromArray(S, t, PLANE + CAPACITY + i);
        DoubleVector z = DoubleVector.fromArray(S, t, PLANE + 2 * CAPACITY + i);
        DoubleVector sign = DoubleVector.fromArray(S, t, SIGN + i);
        DoubleVector height = DoubleVector.fromArray(S, t, HALF + i).mul(sign);
        DoubleVector sideU = DoubleVector.fromArray(S, t, BETWEEN + i);
        DoubleVector sideV = DoubleVector.fromArray(S, t, BETWEEN + CAPACITY + i);
        DoubleVector px = sideU.blend(height, isX);
        DoubleVector py = height.blend(sideU, isX).blend(sideV, isZ);
        DoubleVector pz = sideV.blend(height, isZ);
        DoubleVector above =
                DoubleVector.fromArray(S, t, PLANE + 3 * CAPACITY + i)
                        .sub(x.mul(px).add(y.mul(py)).add(z.mul(pz)))
                        .div(y.blend(x, isX).blend(z, isZ).mul(sign));
        height.add(above.mul(sign)).intoArray(t, BETWEEN + 2 * CAPACITY + i);
    }
}
