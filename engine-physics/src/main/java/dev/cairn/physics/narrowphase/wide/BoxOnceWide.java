package dev.cairn.physics.narrowphase.wide;

import static dev.cairn.physics.narrowphase.wide.BoxBatch.CAPACITY;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.CORNER;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.CUT;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.DEEPEST;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.HALF;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.INCIDENT;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.MARGIN;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.NEAR;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.ONCE;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.OUTSIDE;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.SIGN;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.STAYS;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.STILL_NEAR;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * The usual case of bricks, a pair to a lane: one side of the chosen face cuts two neighbouring
 * corners of the incident face off, all four are clear of it, and all points are within the margin.
 * Each of the two corners moves along its edge to the side. The operations on each number are those
 * of {@code narrowphase.Clipper}. Other pairs keep their corners.
 */
final class BoxOnceWide {
    private static final VectorSpecies<Double> S = DoubleVector.SPECIES_PREFERRED;
    private static final int LANES = S.length();

    private BoxOnceWide() {}

    /**
     * Puts points in the place of corners: in the order of the loop the last corner that stays, the
     * first that stays again, and where the loop leaves and enters. Fills ONCE, CUT and DEEPEST.
     */
    static void run(double[] t, int count) {
        for (int i = 0; i < count; i += LANES) {
            DoubleVector near = DoubleVector.fromArray(S, t, NEAR + i);
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
            VectorMask<Double> twice = highU.and(lowU).or(highV.and(lowV)).or(onU.and(onV));
            VectorMask<Double> fits = onU.or(onV).andNot(twice);
            VectorMask<Double> low = lowU.or(lowV);
            if (!fits.anyTrue()) {
                DoubleVector.broadcast(S, -1).intoArray(t, ONCE + i);
                continue;
            }
            DoubleVector sign = DoubleVector.broadcast(S, 1).blend(-1, low);
            DoubleVector limit =
                    DoubleVector.fromArray(S, t, HALF + 2 * CAPACITY + i)
                            .blend(DoubleVector.fromArray(S, t, HALF + CAPACITY + i), onU);
            // The loop of corners is 0, 1, 3, 2 on faces 1, 2 and 5, and 0, 2, 3, 1 on the others.
            DoubleVector face = DoubleVector.fromArray(S, t, INCIDENT + i);
            VectorMask<Double> forward =
                    face.compare(VectorOperators.EQ, 1)
                            .or(face.compare(VectorOperators.EQ, 2))
                            .or(face.compare(VectorOperators.EQ, 5));
            int u = CORNER + CAPACITY + i;
            int v = CORNER + 2 * CAPACITY + i;
            DoubleVector s0 =
                    DoubleVector.fromArray(S, t, v)
                            .blend(DoubleVector.fromArray(S, t, u), onU)
                            .mul(sign)
                            .sub(limit);
            DoubleVector one =
                    DoubleVector.fromArray(S, t, v + 3 * CAPACITY)
                            .blend(DoubleVector.fromArray(S, t, u + 3 * CAPACITY), onU)
                            .mul(sign)
                            .sub(limit);
            DoubleVector two =
                    DoubleVector.fromArray(S, t, v + 6 * CAPACITY)
                            .blend(DoubleVector.fromArray(S, t, u + 6 * CAPACITY), onU)
                            .mul(sign)
                            .sub(limit);
            DoubleVector s2 =
                    DoubleVector.fromArray(S, t, v + 9 * CAPACITY)
                            .blend(DoubleVector.fromArray(S, t, u + 9 * CAPACITY), onU)
                            .mul(sign)
                            .sub(limit);
            DoubleVector s1 = two.blend(one, forward);
            DoubleVector s3 = one.blend(two, forward);
            DoubleVector still = DoubleVector.fromArray(S, t, STILL_NEAR + i);
            VectorMask<Double> clear =
                    s0.abs()
                            .min(s1.abs())
                            .min(s2.abs().min(s3.abs()))
                            .compare(VectorOperators.GT, still);
            VectorMask<Double> out0 = s0.compare(VectorOperators.GT, 0);
            VectorMask<Double> out1 = s1.compare(VectorOperators.GT, 0);
            // Two neighbours are outside when the opposite corners are not.
            fits =
                    fits.and(clear)
                            .and(out0.xor(s2.compare(VectorOperators.GT, 0)))
                            .and(out1.xor(s3.compare(VectorOperators.GT, 0)));
            // The last corner that stays: 3 for 0 and 1 outside, 0 for 1 and 2, 1 for 2 and 3.
            VectorMask<Double> is3 = out0.and(out1);
            VectorMask<Double> is2 = out0.andNot(out1);
            VectorMask<Double> is0 = out1.andNot(out0);
            DoubleVector sP = s1.blend(s0, is0).blend(s2, is2).blend(s3, is3);
            DoubleVector sOut = s2.blend(s1, is0).blend(s3, is2).blend(s0, is3);
            DoubleVector sIn = s3.blend(s2, is0).blend(s0, is2).blend(s1, is3);
            DoubleVector sQ = s0.blend(s3, is0).blend(s1, is2).blend(s2, is3);
            sP.div(sP.sub(sOut)).intoArray(t, CUT + i);
            sIn.div(sIn.sub(sQ)).intoArray(t, CUT + CAPACITY + i);
            DoubleVector stays =
                    DoubleVector.broadcast(S, 1).blend(0, is0).blend(2, is2).blend(3, is3);
            stays.intoArray(t, STAYS + i);
            stays.add(DoubleVector.zero(S).blend(8, onV).add(DoubleVector.zero(S).blend(4, low)))
                    .blend(-1, fits.not())
                    .intoArray(t, ONCE + i);
        }
        heights(t, count);
        for (int k = 1; k < 3; k++) {
            places(t, count, k * CAPACITY);
        }
    }

    /** Along the face's normal: separations, and points midway between the surfaces. */
    private static void heights(double[] t, int count) {
        for (int i = 0; i < count; i += LANES) {
            DoubleVector code = DoubleVector.fromArray(S, t, ONCE + i);
            VectorMask<Double> fits = code.compare(VectorOperators.GE, 0);
            DoubleVector p = DoubleVector.fromArray(S, t, STAYS + i);
            VectorMask<Double> is0 = p.compare(VectorOperators.EQ, 0);
            VectorMask<Double> is2 = p.compare(VectorOperators.EQ, 2);
            VectorMask<Double> is3 = p.compare(VectorOperators.EQ, 3);
            DoubleVector face = DoubleVector.fromArray(S, t, INCIDENT + i);
            VectorMask<Double> forward =
                    face.compare(VectorOperators.EQ, 1)
                            .or(face.compare(VectorOperators.EQ, 2))
                            .or(face.compare(VectorOperators.EQ, 5));
            int at = CORNER + i;
            DoubleVector x0 = DoubleVector.fromArray(S, t, at);
            DoubleVector one = DoubleVector.fromArray(S, t, at + 3 * CAPACITY);
            DoubleVector two = DoubleVector.fromArray(S, t, at + 6 * CAPACITY);
            DoubleVector x2 = DoubleVector.fromArray(S, t, at + 9 * CAPACITY);
            DoubleVector x1 = two.blend(one, forward);
            DoubleVector x3 = one.blend(two, forward);
            DoubleVector stay = x1.blend(x0, is0).blend(x2, is2).blend(x3, is3);
            DoubleVector out = x2.blend(x1, is0).blend(x3, is2).blend(x0, is3);
            DoubleVector in = x3.blend(x2, is0).blend(x0, is2).blend(x1, is3);
            DoubleVector back = x0.blend(x3, is0).blend(x1, is2).blend(x2, is3);
            DoubleVector leave = stay.add(DoubleVector.fromArray(S, t, CUT + i).mul(out.sub(stay)));
            DoubleVector enter =
                    in.add(DoubleVector.fromArray(S, t, CUT + CAPACITY + i).mul(back.sub(in)));
            DoubleVector sign = DoubleVector.fromArray(S, t, SIGN + i);
            DoubleVector height = DoubleVector.fromArray(S, t, HALF + i);
            DoubleVector sStay = sign.mul(stay).sub(height);
            DoubleVector sBack = sign.mul(back).sub(height);
            DoubleVector sLeave = sign.mul(leave).sub(height);
            DoubleVector sEnter = sign.mul(enter).sub(height);
            DoubleVector highest = sStay.max(sBack).max(sLeave.max(sEnter));
            fits =
                    fits.and(
                            highest.compare(
                                    VectorOperators.LE, DoubleVector.fromArray(S, t, MARGIN + i)));
            code.blend(-1, fits.not()).intoArray(t, ONCE + i);
            sLeave.min(sEnter).min(sStay.min(sBack)).intoArray(t, DEEPEST + i);
            sStay.intoArray(t, CUT + 2 * CAPACITY + i);
            sBack.intoArray(t, CUT + 3 * CAPACITY + i);
            sLeave.intoArray(t, CUT + 4 * CAPACITY + i);
            sEnter.intoArray(t, CUT + 5 * CAPACITY + i);
            x0.blend(stay.sub(sign.mul(sStay.mul(0.5))), fits).intoArray(t, at);
            one.blend(back.sub(sign.mul(sBack.mul(0.5))), fits).intoArray(t, at + 3 * CAPACITY);
            two.blend(leave.sub(sign.mul(sLeave.mul(0.5))), fits).intoArray(t, at + 6 * CAPACITY);
            x2.blend(enter.sub(sign.mul(sEnter.mul(0.5))), fits).intoArray(t, at + 9 * CAPACITY);
        }
    }

    /** Along one of the axes beside the normal. */
    private static void places(double[] t, int count, int column) {
        for (int i = 0; i < count; i += LANES) {
            DoubleVector code = DoubleVector.fromArray(S, t, ONCE + i);
            VectorMask<Double> fits = code.compare(VectorOperators.GE, 0);
            DoubleVector p = DoubleVector.fromArray(S, t, STAYS + i);
            VectorMask<Double> is0 = p.compare(VectorOperators.EQ, 0);
            VectorMask<Double> is2 = p.compare(VectorOperators.EQ, 2);
            VectorMask<Double> is3 = p.compare(VectorOperators.EQ, 3);
            DoubleVector face = DoubleVector.fromArray(S, t, INCIDENT + i);
            VectorMask<Double> forward =
                    face.compare(VectorOperators.EQ, 1)
                            .or(face.compare(VectorOperators.EQ, 2))
                            .or(face.compare(VectorOperators.EQ, 5));
            int at = CORNER + column + i;
            DoubleVector x0 = DoubleVector.fromArray(S, t, at);
            DoubleVector one = DoubleVector.fromArray(S, t, at + 3 * CAPACITY);
            DoubleVector two = DoubleVector.fromArray(S, t, at + 6 * CAPACITY);
            DoubleVector x2 = DoubleVector.fromArray(S, t, at + 9 * CAPACITY);
            DoubleVector x1 = two.blend(one, forward);
            DoubleVector x3 = one.blend(two, forward);
            DoubleVector stay = x1.blend(x0, is0).blend(x2, is2).blend(x3, is3);
            DoubleVector out = x2.blend(x1, is0).blend(x3, is2).blend(x0, is3);
            DoubleVector in = x3.blend(x2, is0).blend(x0, is2).blend(x1, is3);
            DoubleVector back = x0.blend(x3, is0).blend(x1, is2).blend(x2, is3);
            DoubleVector leave = stay.add(DoubleVector.fromArray(S, t, CUT + i).mul(out.sub(stay)));
            DoubleVector enter =
                    in.add(DoubleVector.fromArray(S, t, CUT + CAPACITY + i).mul(back.sub(in)));
            x0.blend(stay, fits).intoArray(t, at);
            one.blend(back, fits).intoArray(t, at + 3 * CAPACITY);
            two.blend(leave, fits).intoArray(t, at + 6 * CAPACITY);
            x2.blend(enter, fits).intoArray(t, at + 9 * CAPACITY);
        }
    }
}
