package dev.cairn.physics.narrowphase.wide;

import static dev.cairn.physics.narrowphase.wide.BoxBatch.AXIS;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.CAPACITY;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.CORNER;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.CUT;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.CUT_SEPARATION;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.DEEPEST;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.FIRST_ON_U;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.HALF;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.INCIDENT;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.MARGIN;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.NEAR;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.OUTSIDE;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.SECOND_WAYS;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.SIDES;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.SIGN;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.STAYS;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.STILL_NEAR;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.STRAIGHT;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.STRAIGHT_POINT;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * The usual cases of bricks, a pair to a lane: one side of the chosen face cuts two neighbouring
 * corners of the incident face off, and after it perhaps one of the sides beside it two of what is
 * left; all corners are clear of both, and all points are within the margin. Each of the two
 * corners moves along its edge to the side, so four points are left. The operations on each number
 * are those of {@code narrowphase.Clipper}. Other pairs keep their corners.
 */
final class BoxStraightWide {
    private static final VectorSpecies<Double> S = DoubleVector.SPECIES_PREFERRED;
    private static final int LANES = S.length();

    private BoxStraightWide() {}

    /**
     * Puts points in the place of corners: in the order of the loop the last corner that stays, the
     * first that stays again, and where the loop leaves and enters. Fills STRAIGHT, CUT_SEPARATION
     * and DEEPEST.
     */
    static void run(double[] t, int count) {
        sides(t, count);
        for (int i = 0; i < count; i += LANES) {
            if (DoubleVector.fromArray(S, t, STRAIGHT + i)
                    .compare(VectorOperators.GE, 0)
                    .anyTrue()) {
                for (int k = 0; k < 3; k++) {
                    loop(t, k * CAPACITY + i, i);
                }
                cut(t, i, SIDES);
                if (DoubleVector.fromArray(S, t, SIDES + 2 * CAPACITY + i)
                        .compare(VectorOperators.NE, 0)
                        .anyTrue()) {
                    cut(t, i, SIDES + 2 * CAPACITY);
                }
                finish(t, i);
            }
        }
    }

    private static void cut(double[] t, int i, int side) {
        choose(t, i, side);
        name(t, i, side);
        for (int k = 0; k < 3; k++) {
            move(t, k * CAPACITY + i, i, side);
        }
    }

    /** Which side cuts first, in the order of the face's loop, and which after it. */
    private static void sides(double[] t, int count) {
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
            VectorMask<Double> opposite = highU.and(lowU).or(highV.and(lowV));
            VectorMask<Double> fits = onU.or(onV).andNot(opposite);
            // The loop of sides is low v, high u, high v, low u on faces 1, 2 and 5, and low u,
            // high v, high u, low v on the others.
            VectorMask<Double> odd =
                    DoubleVector.fromArray(S, t, AXIS + i)
                            .compare(VectorOperators.EQ, 1)
                            .xor(
                                    DoubleVector.fromArray(S, t, SIGN + i)
                                            .compare(VectorOperators.GT, 0));
            VectorMask<Double> before = highU.and(highV).xor(odd.not());
            VectorMask<Double> firstU = onU.and(before.or(onV.not()));
            DoubleVector one = DoubleVector.broadcast(S, 1);
            DoubleVector signU = one.blend(-1, lowU);
            DoubleVector signV = one.blend(-1, lowV);
            DoubleVector halfU = DoubleVector.fromArray(S, t, HALF + CAPACITY + i);
            DoubleVector halfV = DoubleVector.fromArray(S, t, HALF + 2 * CAPACITY + i);
            DoubleVector.zero(S).blend(1, firstU).intoArray(t, FIRST_ON_U + i);
            signV.blend(signU, firstU).intoArray(t, SIDES + i);
            halfV.blend(halfU, firstU).intoArray(t, SIDES + CAPACITY + i);
            signU.blend(signV, firstU)
                    .blend(0, onU.and(onV).not())
                    .intoArray(t, SIDES + 2 * CAPACITY + i);
            halfU.blend(halfV, firstU).intoArray(t, SIDES + 3 * CAPACITY + i);
            DoubleVector.broadcast(S, -1).blend(0, fits).intoArray(t, STRAIGHT + i);
        }
    }

    /**
     * Puts the corners in the places where a cut leaves its points. Their loop is 0, 1, 3, 2 on
     * incident faces 1, 2 and 5, and 0, 2, 3, 1 on the others; that of the places 0, 2, 3, 1.
     */
    private static void loop(double[] t, int column, int i) {
        DoubleVector face = DoubleVector.fromArray(S, t, INCIDENT + i);
        VectorMask<Double> forward =
                face.compare(VectorOperators.EQ, 1)
                        .or(face.compare(VectorOperators.EQ, 2))
                        .or(face.compare(VectorOperators.EQ, 5));
        int from = CORNER + column;
        int to = STRAIGHT_POINT + column;
        DoubleVector one = DoubleVector.fromArray(S, t, from + 3 * CAPACITY);
        DoubleVector two = DoubleVector.fromArray(S, t, from + 6 * CAPACITY);
        DoubleVector.fromArray(S, t, from).intoArray(t, to);
        one.blend(two, forward).intoArray(t, to + 3 * CAPACITY);
        two.blend(one, forward).intoArray(t, to + 6 * CAPACITY);
        DoubleVector.fromArray(S, t, from + 9 * CAPACITY).intoArray(t, to + 9 * CAPACITY);
    }

    /** Which corners a side cuts off, -1 in STAYS for others than two, and where on their edges. */
    private static void choose(double[] t, int i, int side) {
        VectorMask<Double> onU =
                DoubleVector.fromArray(S, t, FIRST_ON_U + i)
                        .compare(VectorOperators.EQ, side == SIDES ? 1 : 0);
        DoubleVector sign = DoubleVector.fromArray(S, t, side + i);
        DoubleVector limit = DoubleVector.fromArray(S, t, side + CAPACITY + i);
        int u = STRAIGHT_POINT + CAPACITY + i;
        int v = u + CAPACITY;
        DoubleVector s0 =
                DoubleVector.fromArray(S, t, v)
                        .blend(DoubleVector.fromArray(S, t, u), onU)
                        .mul(sign)
                        .sub(limit);
        DoubleVector s3 =
                DoubleVector.fromArray(S, t, v + 3 * CAPACITY)
                        .blend(DoubleVector.fromArray(S, t, u + 3 * CAPACITY), onU)
                        .mul(sign)
                        .sub(limit);
        DoubleVector s1 =
                DoubleVector.fromArray(S, t, v + 6 * CAPACITY)
                        .blend(DoubleVector.fromArray(S, t, u + 6 * CAPACITY), onU)
                        .mul(sign)
                        .sub(limit);
        DoubleVector s2 =
                DoubleVector.fromArray(S, t, v + 9 * CAPACITY)
                        .blend(DoubleVector.fromArray(S, t, u + 9 * CAPACITY), onU)
                        .mul(sign)
                        .sub(limit);
        VectorMask<Double> clear =
                s0.abs()
                        .min(s1.abs())
                        .min(s2.abs().min(s3.abs()))
                        .compare(VectorOperators.GT, DoubleVector.fromArray(S, t, STILL_NEAR + i));
        VectorMask<Double> out0 = s0.compare(VectorOperators.GT, 0);
        VectorMask<Double> out1 = s1.compare(VectorOperators.GT, 0);
        // Two neighbours are outside when the opposite corners are not.
        VectorMask<Double> neighbours =
                clear.and(out0.xor(s2.compare(VectorOperators.GT, 0)))
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
        DoubleVector.broadcast(S, 1)
                .blend(0, is0)
                .blend(2, is2)
                .blend(3, is3)
                .blend(-1, neighbours.not())
                .intoArray(t, STAYS + i);
    }

    /** Adds the way of a side to the code of a pair, or takes the pair out. */
    private static void name(double[] t, int i, int side) {
        boolean first = side == SIDES;
        VectorMask<Double> onU =
                DoubleVector.fromArray(S, t, FIRST_ON_U + i).compare(VectorOperators.EQ, 1);
        DoubleVector sign = DoubleVector.fromArray(S, t, side + i);
        DoubleVector stays = DoubleVector.fromArray(S, t, STAYS + i);
        VectorMask<Double> none = sign.compare(VectorOperators.EQ, 0);
        DoubleVector way =
                stays.add(DoubleVector.zero(S).blend(4, sign.compare(VectorOperators.LT, 0)))
                        .add(first ? 8 : 1)
                        .sub(DoubleVector.zero(S).blend(first ? 8 : 0, onU))
                        .mul(first ? SECOND_WAYS : 1)
                        .blend(0, none);
        DoubleVector code = DoubleVector.fromArray(S, t, STRAIGHT + i);
        VectorMask<Double> fits =
                code.compare(VectorOperators.GE, 0)
                        .and(stays.compare(VectorOperators.GE, 0).or(none));
        DoubleVector.broadcast(S, -1).blend(code.add(way), fits).intoArray(t, STRAIGHT + i);
    }

    /** Moves a coordinate of the corners that a side cuts off; those of other pairs stay. */
    private static void move(double[] t, int column, int i, int side) {
        VectorMask<Double> none =
                DoubleVector.fromArray(S, t, side + i).compare(VectorOperators.EQ, 0);
        DoubleVector p = DoubleVector.fromArray(S, t, STAYS + i);
        VectorMask<Double> is0 = p.compare(VectorOperators.EQ, 0);
        VectorMask<Double> is2 = p.compare(VectorOperators.EQ, 2);
        VectorMask<Double> is3 = p.compare(VectorOperators.EQ, 3);
        int at = STRAIGHT_POINT + column;
        DoubleVector x0 = DoubleVector.fromArray(S, t, at);
        DoubleVector x3 = DoubleVector.fromArray(S, t, at + 3 * CAPACITY);
        DoubleVector x1 = DoubleVector.fromArray(S, t, at + 6 * CAPACITY);
        DoubleVector x2 = DoubleVector.fromArray(S, t, at + 9 * CAPACITY);
        DoubleVector stay = x1.blend(x0, is0).blend(x2, is2).blend(x3, is3);
        DoubleVector out = x2.blend(x1, is0).blend(x3, is2).blend(x0, is3);
        DoubleVector in = x3.blend(x2, is0).blend(x0, is2).blend(x1, is3);
        DoubleVector back = x0.blend(x3, is0).blend(x1, is2).blend(x2, is3);
        DoubleVector leave = stay.add(DoubleVector.fromArray(S, t, CUT + i).mul(out.sub(stay)));
        DoubleVector enter =
                in.add(DoubleVector.fromArray(S, t, CUT + CAPACITY + i).mul(back.sub(in)));
        stay.blend(x0, none).intoArray(t, at);
        back.blend(x3, none).intoArray(t, at + 3 * CAPACITY);
        leave.blend(x1, none).intoArray(t, at + 6 * CAPACITY);
        enter.blend(x2, none).intoArray(t, at + 9 * CAPACITY);
    }

    /** Separations, and points midway between the surfaces in the place of the corners. */
    private static void finish(double[] t, int i) {
        DoubleVector code = DoubleVector.fromArray(S, t, STRAIGHT + i);
        DoubleVector sign = DoubleVector.fromArray(S, t, SIGN + i);
        DoubleVector height = DoubleVector.fromArray(S, t, HALF + i);
        int from = STRAIGHT_POINT + i;
        DoubleVector highest = DoubleVector.broadcast(S, -Double.MAX_VALUE);
        DoubleVector deepest = DoubleVector.broadcast(S, Double.MAX_VALUE);
        for (int p = 0; p < 4; p++) {
            DoubleVector s =
                    DoubleVector.fromArray(S, t, from + 3 * p * CAPACITY).mul(sign).sub(height);
            s.intoArray(t, CUT_SEPARATION + p * CAPACITY + i);
            highest = highest.max(s);
            deepest = deepest.min(s);
        }
        deepest.intoArray(t, DEEPEST + i);
        VectorMask<Double> fits =
                code.compare(VectorOperators.GE, 0)
                        .and(
                                highest.compare(
                                        VectorOperators.LE,
                                        DoubleVector.fromArray(S, t, MARGIN + i)));
        code.blend(-1, fits.not()).intoArray(t, STRAIGHT + i);
        int to = CORNER + i;
        for (int p = 0; p < 12; p += 3) {
            int at = p * CAPACITY;
            DoubleVector half =
                    DoubleVector.fromArray(S, t, CUT_SEPARATION + p / 3 * CAPACITY + i).mul(0.5);
            DoubleVector n = DoubleVector.fromArray(S, t, from + at).sub(sign.mul(half));
            DoubleVector.fromArray(S, t, to + at).blend(n, fits).intoArray(t, to + at);
            for (int k = 1; k < 3; k++) {
                at += CAPACITY;
                DoubleVector.fromArray(S, t, to + at)
                        .blend(DoubleVector.fromArray(S, t, from + at), fits)
                        .intoArray(t, to + at);
            }
        }
    }
}
