package dev.cairn.physics.narrowphase.wide;

import static dev.cairn.physics.narrowphase.wide.RoundBatch.*;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * Pairs of balls and capsules, a pair to a lane. Its twin without the Vector API is {@code
 * narrowphase.RoundContacts}, with the same operations on each number.
 */
final class RoundWide {
    private static final VectorSpecies<Double> S = DoubleVector.SPECIES_PREFERRED;
    private static final int LANES = S.length();

    private RoundWide() {}

    /** See {@link RoundBatch#run}. */
    static void run(
            double[] t,
            int count,
            boolean capsulesA,
            boolean capsulesB,
            double reach,
            double fraction) {
        if (capsulesA && capsulesB) {
            axes(t, count, TURN_A, HALF_A, AXIS_A);
            axes(t, count, TURN_B, HALF_B, AXIS_B);
            if (!crossing(t, count)) {
                nearlyParallel(t, count);
            }
        } else if (capsulesA) {
            axes(t, count, TURN_A, HALF_A, AXIS_A);
            onSegmentA(t, count);
        } else if (capsulesB) {
            axes(t, count, TURN_B, HALF_B, AXIS_B);
            onSegmentB(t, count);
        } else {
            points(t, count);
        }
        margins(t, count, reach, fraction);
        contacts(t, count);
        if (capsulesA && capsulesB) {
            lines(t, count);
        }
    }

    /** See {@code BoundsStage}: how far apart points are contacts. */
    private static void margins(double[] t, int count, double reach, double fraction) {
        for (int i = 0; i < count; i += LANES) {
            DoubleVector x = DoubleVector.fromArray(S, t, AHEAD + i);
            DoubleVector y = DoubleVector.fromArray(S, t, AHEAD + CAPACITY + i);
            DoubleVector z = DoubleVector.fromArray(S, t, AHEAD + 2 * CAPACITY + i);
            DoubleVector radiusA = DoubleVector.fromArray(S, t, RADIUS_A + i);
            DoubleVector radiusB = DoubleVector.fromArray(S, t, RADIUS_B + i);
            DoubleVector smaller =
                    radiusA.blend(radiusB, radiusB.compare(VectorOperators.LT, radiusA));
            x.mul(x)
                    .add(y.mul(y))
                    .add(z.mul(z))
                    .sqrt()
                    .mul(reach)
                    .add(DoubleVector.fromArray(S, t, ARC_A + i))
                    .add(DoubleVector.fromArray(S, t, ARC_B + i))
                    .add(smaller.mul(fraction))
                    .intoArray(t, MARGIN + i);
        }
    }

    /** The y axis of each orientation, zero for balls. */
    private static void axes(double[] t, int count, int turn, int half, int axis) {
        for (int i = 0; i < count; i += LANES) {
            DoubleVector x = DoubleVector.fromArray(S, t, turn + i);
            DoubleVector y = DoubleVector.fromArray(S, t, turn + CAPACITY + i);
            DoubleVector z = DoubleVector.fromArray(S, t, turn + 2 * CAPACITY + i);
            DoubleVector w = DoubleVector.fromArray(S, t, turn + 3 * CAPACITY + i);
            DoubleVector xx = x.mul(x);
            DoubleVector zz = z.mul(z);
            DoubleVector s =
                    DoubleVector.broadcast(S, 2).div(xx.add(y.mul(y)).add(zz).add(w.mul(w)));
            VectorMask<Double> ball =
                    DoubleVector.fromArray(S, t, half + i).compare(VectorOperators.EQ, 0);
            s.mul(x.mul(y).sub(z.mul(w))).blend(0, ball).intoArray(t, axis + i);
            DoubleVector.broadcast(S, 1)
                    .sub(s.mul(xx.add(zz)))
                    .blend(0, ball)
                    .intoArray(t, axis + CAPACITY + i);
            s.mul(y.mul(z).add(x.mul(w))).blend(0, ball).intoArray(t, axis + 2 * CAPACITY + i);
        }
    }

    /** Balls alone: from centre to centre. */
    private static void points(double[] t, int count) {
        for (int i = 0; i < count; i += LANES) {
            DoubleVector zero = DoubleVector.zero(S);
            DoubleVector.fromArray(S, t, OFFSET + i).intoArray(t, ACROSS + i);
            DoubleVector.fromArray(S, t, OFFSET + CAPACITY + i).intoArray(t, ACROSS + CAPACITY + i);
            DoubleVector.fromArray(S, t, OFFSET + 2 * CAPACITY + i)
                    .intoArray(t, ACROSS + 2 * CAPACITY + i);
            zero.intoArray(t, AXIS_A + i);
            zero.intoArray(t, AXIS_A + CAPACITY + i);
            zero.intoArray(t, AXIS_A + 2 * CAPACITY + i);
            zero.intoArray(t, ON_A + i);
        }
    }

    /** Of B only centres: where A's segment is nearest to them. */
    private static void onSegmentA(double[] t, int count) {
        for (int i = 0; i < count; i += LANES) {
            DoubleVector ux = DoubleVector.fromArray(S, t, AXIS_A + i);
            DoubleVector uy = DoubleVector.fromArray(S, t, AXIS_A + CAPACITY + i);
            DoubleVector uz = DoubleVector.fromArray(S, t, AXIS_A + 2 * CAPACITY + i);
            DoubleVector dx = DoubleVector.fromArray(S, t, OFFSET + i);
            DoubleVector dy = DoubleVector.fromArray(S, t, OFFSET + CAPACITY + i);
            DoubleVector dz = DoubleVector.fromArray(S, t, OFFSET + 2 * CAPACITY + i);
            DoubleVector h = DoubleVector.fromArray(S, t, HALF_A + i);
            DoubleVector low = h.neg();
            DoubleVector on = ux.mul(dx).add(uy.mul(dy)).add(uz.mul(dz));
            on = on.blend(h, on.compare(VectorOperators.GT, h));
            on = on.blend(low, on.compare(VectorOperators.LT, low));
            on.intoArray(t, ON_A + i);
            dx.sub(on.mul(ux)).intoArray(t, ACROSS + i);
            dy.sub(on.mul(uy)).intoArray(t, ACROSS + CAPACITY + i);
            dz.sub(on.mul(uz)).intoArray(t, ACROSS + 2 * CAPACITY + i);
        }
    }

    /** Of A only centres: where B's segment is nearest to them. */
    private static void onSegmentB(double[] t, int count) {
        for (int i = 0; i < count; i += LANES) {
            DoubleVector zero = DoubleVector.zero(S);
            DoubleVector vx = DoubleVector.fromArray(S, t, AXIS_B + i);
            DoubleVector vy = DoubleVector.fromArray(S, t, AXIS_B + CAPACITY + i);
            DoubleVector vz = DoubleVector.fromArray(S, t, AXIS_B + 2 * CAPACITY + i);
            DoubleVector dx = DoubleVector.fromArray(S, t, OFFSET + i);
            DoubleVector dy = DoubleVector.fromArray(S, t, OFFSET + CAPACITY + i);
            DoubleVector dz = DoubleVector.fromArray(S, t, OFFSET + 2 * CAPACITY + i);
            DoubleVector k = DoubleVector.fromArray(S, t, HALF_B + i);
            DoubleVector low = k.neg();
            DoubleVector on = vx.mul(dx.neg()).add(vy.mul(dy.neg())).add(vz.mul(dz.neg()));
            on = on.blend(k, on.compare(VectorOperators.GT, k));
            on = on.blend(low, on.compare(VectorOperators.LT, low));
            dx.add(on.mul(vx)).intoArray(t, ACROSS + i);
            dy.add(on.mul(vy)).intoArray(t, ACROSS + CAPACITY + i);
            dz.add(on.mul(vz)).intoArray(t, ACROSS + 2 * CAPACITY + i);
            zero.intoArray(t, AXIS_A + i);
            zero.intoArray(t, AXIS_A + CAPACITY + i);
            zero.intoArray(t, AXIS_A + 2 * CAPACITY + i);
            zero.intoArray(t, ON_A + i);
        }
    }

    /**
     * The nearest points of two segments that cross clearly, see {@code RoundContacts.segments}.
     * Returns whether all do.
     */
    private static boolean crossing(double[] t, int count) {
        boolean all = true;
        for (int i = 0; i < count; i += LANES) {
            DoubleVector ux = DoubleVector.fromArray(S, t, AXIS_A + i);
            DoubleVector uy = DoubleVector.fromArray(S, t, AXIS_A + CAPACITY + i);
            DoubleVector uz = DoubleVector.fromArray(S, t, AXIS_A + 2 * CAPACITY + i);
            DoubleVector vx = DoubleVector.fromArray(S, t, AXIS_B + i);
            DoubleVector vy = DoubleVector.fromArray(S, t, AXIS_B + CAPACITY + i);
            DoubleVector vz = DoubleVector.fromArray(S, t, AXIS_B + 2 * CAPACITY + i);
            DoubleVector dx = DoubleVector.fromArray(S, t, OFFSET + i);
            DoubleVector dy = DoubleVector.fromArray(S, t, OFFSET + CAPACITY + i);
            DoubleVector dz = DoubleVector.fromArray(S, t, OFFSET + 2 * CAPACITY + i);
            DoubleVector h = DoubleVector.fromArray(S, t, HALF_A + i);
            DoubleVector k = DoubleVector.fromArray(S, t, HALF_B + i);
            DoubleVector cx = uy.mul(vz).sub(uz.mul(vy));
            DoubleVector cy = uz.mul(vx).sub(ux.mul(vz));
            DoubleVector cz = ux.mul(vy).sub(uy.mul(vx));
            DoubleVector sine = cx.mul(cx).add(cy.mul(cy)).add(cz.mul(cz));
            DoubleVector du = dx.mul(ux).add(dy.mul(uy)).add(dz.mul(uz));
            DoubleVector dv = dx.mul(vx).add(dy.mul(vy)).add(dz.mul(vz));
            DoubleVector uv = ux.mul(vx).add(uy.mul(vy)).add(uz.mul(vz));
            uv.mul(uv).intoArray(t, ALIGNED + i);
            all &= sine.compare(VectorOperators.GT, CROSSING).allTrue();
            DoubleVector inverse = DoubleVector.broadcast(S, 1).div(sine);
            DoubleVector onV = uv.mul(du).sub(dv).mul(inverse);
            DoubleVector onU = du.sub(uv.mul(dv)).mul(inverse);
            DoubleVector f = dx.mul(cx).add(dy.mul(cy)).add(dz.mul(cz)).mul(inverse);
            VectorMask<Double> beyondA = onU.abs().compare(VectorOperators.GT, h);
            VectorMask<Double> beyondB = onV.abs().compare(VectorOperators.GT, k);

            DoubleVector low = h.neg();
            DoubleVector e = k.neg();
            DoubleVector end = k.blend(e, onV.compare(VectorOperators.LT, 0));
            // Cheaper than min and max, which mind the signs of zeros.
            DoubleVector on = du.add(end.mul(uv));
            on = on.blend(h, on.compare(VectorOperators.GT, h));
            on = on.blend(low, on.compare(VectorOperators.LT, low));
            DoubleVector x = dx.add(end.mul(vx)).sub(on.mul(ux));
            DoubleVector y = dy.add(end.mul(vy)).sub(on.mul(uy));
            DoubleVector z = dz.add(end.mul(vz)).sub(on.mul(uz));
            DoubleVector best = x.mul(x).add(y.mul(y)).add(z.mul(z));
            x = f.mul(cx).blend(x, beyondB);
            y = f.mul(cy).blend(y, beyondB);
            z = f.mul(cz).blend(z, beyondB);
            onU.blend(on, beyondB).intoArray(t, ON_A + i);

            end = h.blend(low, onU.compare(VectorOperators.LT, 0));
            on = end.mul(uv).sub(dv);
            on = on.blend(k, on.compare(VectorOperators.GT, k));
            on = on.blend(e, on.compare(VectorOperators.LT, e));
            DoubleVector px = dx.add(on.mul(vx)).sub(end.mul(ux));
            DoubleVector py = dy.add(on.mul(vy)).sub(end.mul(uy));
            DoubleVector pz = dz.add(on.mul(vz)).sub(end.mul(uz));
            DoubleVector square = px.mul(px).add(py.mul(py)).add(pz.mul(pz));
            VectorMask<Double> better =
                    beyondA.andNot(beyondB.andNot(square.compare(VectorOperators.LT, best)));
            DoubleVector.fromArray(S, t, ON_A + i).blend(end, better).intoArray(t, ON_A + i);
            x.blend(px, better).intoArray(t, ACROSS + i);
            y.blend(py, better).intoArray(t, ACROSS + CAPACITY + i);
            z.blend(pz, better).intoArray(t, ACROSS + 2 * CAPACITY + i);
        }
        return all;
    }

    /** Replaces those that do not cross clearly: all ends are tried. */
    private static void nearlyParallel(double[] t, int count) {
        for (int i = 0; i < count; i += LANES) {
            DoubleVector ux = DoubleVector.fromArray(S, t, AXIS_A + i);
            DoubleVector uy = DoubleVector.fromArray(S, t, AXIS_A + CAPACITY + i);
            DoubleVector uz = DoubleVector.fromArray(S, t, AXIS_A + 2 * CAPACITY + i);
            DoubleVector vx = DoubleVector.fromArray(S, t, AXIS_B + i);
            DoubleVector vy = DoubleVector.fromArray(S, t, AXIS_B + CAPACITY + i);
            DoubleVector vz = DoubleVector.fromArray(S, t, AXIS_B + 2 * CAPACITY + i);
            DoubleVector dx = DoubleVector.fromArray(S, t, OFFSET + i);
            DoubleVector dy = DoubleVector.fromArray(S, t, OFFSET + CAPACITY + i);
            DoubleVector dz = DoubleVector.fromArray(S, t, OFFSET + 2 * CAPACITY + i);
            DoubleVector h = DoubleVector.fromArray(S, t, HALF_A + i);
            DoubleVector k = DoubleVector.fromArray(S, t, HALF_B + i);
            DoubleVector cx = uy.mul(vz).sub(uz.mul(vy));
            DoubleVector cy = uz.mul(vx).sub(ux.mul(vz));
            DoubleVector cz = ux.mul(vy).sub(uy.mul(vx));
            DoubleVector sine = cx.mul(cx).add(cy.mul(cy)).add(cz.mul(cz));
            DoubleVector du = dx.mul(ux).add(dy.mul(uy)).add(dz.mul(uz));
            DoubleVector dv = dx.mul(vx).add(dy.mul(vy)).add(dz.mul(vz));
            DoubleVector uv = ux.mul(vx).add(uy.mul(vy)).add(uz.mul(vz));
            DoubleVector inverse = DoubleVector.broadcast(S, 1).div(sine);
            DoubleVector onV = uv.mul(du).sub(dv).mul(inverse);
            DoubleVector onU = du.sub(uv.mul(dv)).mul(inverse);
            DoubleVector f = dx.mul(cx).add(dy.mul(cy)).add(dz.mul(cz)).mul(inverse);
            VectorMask<Double> within =
                    onV.abs()
                            .compare(VectorOperators.LE, k)
                            .and(onU.abs().compare(VectorOperators.LE, h));
            // Of a ball only the end that it is competes.
            VectorMask<Double> ballA = h.compare(VectorOperators.EQ, 0);
            VectorMask<Double> ballB = k.compare(VectorOperators.EQ, 0);
            VectorMask<Double> noEndA = ballB;
            VectorMask<Double> noEndB = ballA.andNot(ballB);

            DoubleVector low = h.neg();
            DoubleVector e = k.neg();
            // Cheaper than min and max, which mind the signs of zeros.
            DoubleVector on = du.add(e.mul(uv));
            on = on.blend(h, on.compare(VectorOperators.GT, h));
            on = on.blend(low, on.compare(VectorOperators.LT, low));
            DoubleVector x = dx.add(e.mul(vx)).sub(on.mul(ux));
            DoubleVector y = dy.add(e.mul(vy)).sub(on.mul(uy));
            DoubleVector z = dz.add(e.mul(vz)).sub(on.mul(uz));
            DoubleVector best =
                    x.mul(x).add(y.mul(y)).add(z.mul(z)).blend(Double.MAX_VALUE, noEndB);
            DoubleVector onA = on;

            on = low.mul(uv).sub(dv);
            on = on.blend(k, on.compare(VectorOperators.GT, k));
            on = on.blend(e, on.compare(VectorOperators.LT, e));
            DoubleVector px = dx.add(on.mul(vx)).sub(low.mul(ux));
            DoubleVector py = dy.add(on.mul(vy)).sub(low.mul(uy));
            DoubleVector pz = dz.add(on.mul(vz)).sub(low.mul(uz));
            DoubleVector square = px.mul(px).add(py.mul(py)).add(pz.mul(pz));
            VectorMask<Double> better = square.compare(VectorOperators.LT, best).andNot(noEndA);
            best = best.blend(square, better);
            onA = onA.blend(low, better);
            x = x.blend(px, better);
            y = y.blend(py, better);
            z = z.blend(pz, better);

            on = du.add(k.mul(uv));
            on = on.blend(h, on.compare(VectorOperators.GT, h));
            on = on.blend(low, on.compare(VectorOperators.LT, low));
            px = dx.add(k.mul(vx)).sub(on.mul(ux));
            py = dy.add(k.mul(vy)).sub(on.mul(uy));
            pz = dz.add(k.mul(vz)).sub(on.mul(uz));
            square = px.mul(px).add(py.mul(py)).add(pz.mul(pz));
            better = square.compare(VectorOperators.LT, best).andNot(noEndB);
            best = best.blend(square, better);
            onA = onA.blend(on, better);
            x = x.blend(px, better);
            y = y.blend(py, better);
            z = z.blend(pz, better);

            on = h.mul(uv).sub(dv);
            on = on.blend(k, on.compare(VectorOperators.GT, k));
            on = on.blend(e, on.compare(VectorOperators.LT, e));
            px = dx.add(on.mul(vx)).sub(h.mul(ux));
            py = dy.add(on.mul(vy)).sub(h.mul(uy));
            pz = dz.add(on.mul(vz)).sub(h.mul(uz));
            square = px.mul(px).add(py.mul(py)).add(pz.mul(pz));
            better = square.compare(VectorOperators.LT, best).andNot(noEndA);
            best = best.blend(square, better);
            onA = onA.blend(h, better);
            x = x.blend(px, better);
            y = y.blend(py, better);
            z = z.blend(pz, better);

            better =
                    sine.compare(VectorOperators.GT, NEVER)
                            .and(f.mul(f).mul(sine).compare(VectorOperators.LT, best))
                            .and(within);
            VectorMask<Double> clear = sine.compare(VectorOperators.GT, CROSSING);
            onA.blend(onU, better)
                    .blend(DoubleVector.fromArray(S, t, ON_A + i), clear)
                    .intoArray(t, ON_A + i);
            x.blend(f.mul(cx), better)
                    .blend(DoubleVector.fromArray(S, t, ACROSS + i), clear)
                    .intoArray(t, ACROSS + i);
            y.blend(f.mul(cy), better)
                    .blend(DoubleVector.fromArray(S, t, ACROSS + CAPACITY + i), clear)
                    .intoArray(t, ACROSS + CAPACITY + i);
            z.blend(f.mul(cz), better)
                    .blend(DoubleVector.fromArray(S, t, ACROSS + 2 * CAPACITY + i), clear)
                    .intoArray(t, ACROSS + 2 * CAPACITY + i);
        }
    }

    private static void contacts(double[] t, int count) {
        for (int i = 0; i < count; i += LANES) {
            DoubleVector x = DoubleVector.fromArray(S, t, ACROSS + i);
            DoubleVector y = DoubleVector.fromArray(S, t, ACROSS + CAPACITY + i);
            DoubleVector z = DoubleVector.fromArray(S, t, ACROSS + 2 * CAPACITY + i);
            DoubleVector radiusA = DoubleVector.fromArray(S, t, RADIUS_A + i);
            DoubleVector radiusB = DoubleVector.fromArray(S, t, RADIUS_B + i);
            DoubleVector scale =
                    radiusA.add(radiusB)
                            .add(DoubleVector.fromArray(S, t, OFFSET + i).abs())
                            .add(DoubleVector.fromArray(S, t, OFFSET + CAPACITY + i).abs())
                            .add(DoubleVector.fromArray(S, t, OFFSET + 2 * CAPACITY + i).abs());
            scale.intoArray(t, SCALE + i);
            DoubleVector square = x.mul(x).add(y.mul(y)).add(z.mul(z));
            VectorMask<Double> good =
                    square.compare(VectorOperators.GE, LEAST)
                            .and(square.compare(VectorOperators.LE, MOST))
                            .and(
                                    square.compare(
                                            VectorOperators.GE, scale.mul(TOUCHING).mul(scale)));
            DoubleVector length = square.sqrt();
            DoubleVector separation = length.sub(radiusA).sub(radiusB);
            separation.intoArray(t, SEPARATION + i);
            VectorMask<Double> apart =
                    separation.compare(
                            VectorOperators.GT, DoubleVector.fromArray(S, t, MARGIN + i));
            DoubleVector reach = radiusA.add(separation.mul(0.5));
            DoubleVector onA = DoubleVector.fromArray(S, t, ON_A + i);
            DoubleVector nx = x.div(length);
            DoubleVector ny = y.div(length);
            DoubleVector nz = z.div(length);
            nx.intoArray(t, NORMAL + i);
            ny.intoArray(t, NORMAL + CAPACITY + i);
            nz.intoArray(t, NORMAL + 2 * CAPACITY + i);
            DoubleVector ux = DoubleVector.fromArray(S, t, AXIS_A + i);
            DoubleVector uy = DoubleVector.fromArray(S, t, AXIS_A + CAPACITY + i);
            DoubleVector uz = DoubleVector.fromArray(S, t, AXIS_A + 2 * CAPACITY + i);
            onA.mul(ux).add(reach.mul(nx)).intoArray(t, POINT + i);
            onA.mul(uy).add(reach.mul(ny)).intoArray(t, POINT + CAPACITY + i);
            onA.mul(uz).add(reach.mul(nz)).intoArray(t, POINT + 2 * CAPACITY + i);
            DoubleVector.broadcast(S, RoundBatch.ONE_POINT)
                    .blend(RoundBatch.APART, apart)
                    .blend(RoundBatch.OTHER, good.not())
                    .intoArray(t, KIND + i);
        }
    }

    /** Of two capsules that have one point: may they have two? */
    private static void lines(double[] t, int count) {
        for (int i = 0; i < count; i += LANES) {
            DoubleVector nx = DoubleVector.fromArray(S, t, NORMAL + i);
            DoubleVector ny = DoubleVector.fromArray(S, t, NORMAL + CAPACITY + i);
            DoubleVector nz = DoubleVector.fromArray(S, t, NORMAL + 2 * CAPACITY + i);
            DoubleVector un =
                    DoubleVector.fromArray(S, t, AXIS_A + i)
                            .mul(nx)
                            .add(DoubleVector.fromArray(S, t, AXIS_A + CAPACITY + i).mul(ny))
                            .add(DoubleVector.fromArray(S, t, AXIS_A + 2 * CAPACITY + i).mul(nz));
            DoubleVector vn =
                    DoubleVector.fromArray(S, t, AXIS_B + i)
                            .mul(nx)
                            .add(DoubleVector.fromArray(S, t, AXIS_B + CAPACITY + i).mul(ny))
                            .add(DoubleVector.fromArray(S, t, AXIS_B + 2 * CAPACITY + i).mul(nz));
            DoubleVector kind = DoubleVector.fromArray(S, t, KIND + i);
            VectorMask<Double> lines =
                    DoubleVector.fromArray(S, t, ALIGNED + i)
                            .compare(VectorOperators.GE, PARALLEL)
                            .and(kind.compare(VectorOperators.EQ, RoundBatch.ONE_POINT))
                            .and(un.abs().compare(VectorOperators.LE, LEVEL))
                            .and(vn.abs().compare(VectorOperators.LE, LEVEL));
            kind.blend(RoundBatch.LINES, lines).intoArray(t, KIND + i);
        }
    }
}
