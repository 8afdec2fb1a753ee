package dev.cairn.physics.narrowphase.wide;

import static dev.cairn.physics.narrowphase.wide.BoxBatch.*;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * The kernels of {@link BoxAxes}: a pair to a lane. Vectors stay in local variables of one method,
 * for only the JDK's own methods are sure to be inlined; what crosses to the next kernel goes
 * through the batch's columns.
 */
final class BoxAxesWide {
    private static final VectorSpecies<Double> S = DoubleVector.SPECIES_PREFERRED;
    private static final int LANES = S.length();

    private BoxAxesWide() {}

    /** Two lanes are slower than none: the comparisons have no such masks there. */
    static boolean paysOff() {
        return LANES >= 4;
    }

    static void faces(double[] t, int count) {
        int end = (count + LANES - 1) / LANES * LANES;
        world(t, end);
        relative(t, end);
        facesOfA(t, end);
        facesOfB(t, end);
    }

    /** The groups of lanes in which a bit is set. */
    static void edges(double[] t, int pairs) {
        int group = (int) ((1L << LANES) - 1);
        for (int i = 0; i < CAPACITY; i += LANES) {
            if ((pairs >>> i & group) == 0) {
                continue;
            }
            DoubleVector.broadcast(S, -Double.MAX_VALUE).intoArray(t, SEPARATION_EDGE + i);
            DoubleVector.broadcast(S, -Double.MAX_VALUE).intoArray(t, SIGNED_SQUARE + i);
            DoubleVector.broadcast(S, 1).intoArray(t, SQUARE + i);
            DoubleVector.broadcast(S, -1).intoArray(t, EDGE + i);
            edges(t, i, 0, CAPACITY, 2 * CAPACITY, 0);
            edges(t, i, CAPACITY, 0, 2 * CAPACITY, 1);
            edges(t, i, 2 * CAPACITY, 0, CAPACITY, 2);
            DoubleVector.fromArray(S, t, SEPARATION_EDGE + i)
                    .div(DoubleVector.fromArray(S, t, SQUARE + i).sqrt())
                    .intoArray(t, SEPARATION_EDGE + i);
        }
    }

    /** Rotation matrix of A and the offset in its frame. */
    private static void world(double[] t, int end) {
        for (int i = 0; i < end; i += LANES) {
            DoubleVector x = DoubleVector.fromArray(S, t, TURN_A + i);
            DoubleVector y = DoubleVector.fromArray(S, t, TURN_A + CAPACITY + i);
            DoubleVector z = DoubleVector.fromArray(S, t, TURN_A + 2 * CAPACITY + i);
            DoubleVector w = DoubleVector.fromArray(S, t, TURN_A + 3 * CAPACITY + i);
            DoubleVector xx = x.mul(x);
            DoubleVector yy = y.mul(y);
            DoubleVector zz = z.mul(z);
            DoubleVector xy = x.mul(y);
            DoubleVector xz = x.mul(z);
            DoubleVector yz = y.mul(z);
            DoubleVector xw = x.mul(w);
            DoubleVector yw = y.mul(w);
            DoubleVector zw = z.mul(w);
            DoubleVector one = DoubleVector.broadcast(S, 1);
            DoubleVector s = DoubleVector.broadcast(S, 2).div(xx.add(yy).add(zz).add(w.mul(w)));
            DoubleVector w00 = one.sub(s.mul(yy.add(zz)));
            DoubleVector w01 = s.mul(xy.sub(zw));
            DoubleVector w02 = s.mul(xz.add(yw));
            DoubleVector w10 = s.mul(xy.add(zw));
            DoubleVector w11 = one.sub(s.mul(xx.add(zz)));
            DoubleVector w12 = s.mul(yz.sub(xw));
            DoubleVector w20 = s.mul(xz.sub(yw));
            DoubleVector w21 = s.mul(yz.add(xw));
            DoubleVector w22 = one.sub(s.mul(xx.add(yy)));
            w00.intoArray(t, WORLD + i);
            w01.intoArray(t, WORLD + CAPACITY + i);
            w02.intoArray(t, WORLD + 2 * CAPACITY + i);
            w10.intoArray(t, WORLD + 3 * CAPACITY + i);
            w11.intoArray(t, WORLD + 4 * CAPACITY + i);
            w12.intoArray(t, WORLD + 5 * CAPACITY + i);
            w20.intoArray(t, WORLD + 6 * CAPACITY + i);
            w21.intoArray(t, WORLD + 7 * CAPACITY + i);
            w22.intoArray(t, WORLD + 8 * CAPACITY + i);
            DoubleVector dx = DoubleVector.fromArray(S, t, OFFSET + i);
            DoubleVector dy = DoubleVector.fromArray(S, t, OFFSET + CAPACITY + i);
            DoubleVector dz = DoubleVector.fromArray(S, t, OFFSET + 2 * CAPACITY + i);
            w00.mul(dx).add(w10.mul(dy)).add(w20.mul(dz)).intoArray(t, CENTRE + i);
            w01.mul(dx).add(w11.mul(dy)).add(w21.mul(dz)).intoArray(t, CENTRE + CAPACITY + i);
            w02.mul(dx).add(w12.mul(dy)).add(w22.mul(dz)).intoArray(t, CENTRE + 2 * CAPACITY + i);
        }
    }

    /** Rotation matrix from B's axes to A's. */
    private static void relative(double[] t, int end) {
        for (int i = 0; i < end; i += LANES) {
            DoubleVector ax = DoubleVector.fromArray(S, t, TURN_A + i);
            DoubleVector ay = DoubleVector.fromArray(S, t, TURN_A + CAPACITY + i);
            DoubleVector az = DoubleVector.fromArray(S, t, TURN_A + 2 * CAPACITY + i);
            DoubleVector aw = DoubleVector.fromArray(S, t, TURN_A + 3 * CAPACITY + i);
            DoubleVector bx = DoubleVector.fromArray(S, t, TURN_B + i);
            DoubleVector by = DoubleVector.fromArray(S, t, TURN_B + CAPACITY + i);
            DoubleVector bz = DoubleVector.fromArray(S, t, TURN_B + 2 * CAPACITY + i);
            DoubleVector bw = DoubleVector.fromArray(S, t, TURN_B + 3 * CAPACITY + i);
            DoubleVector x = aw.mul(bx).sub(ax.mul(bw)).sub(ay.mul(bz)).add(az.mul(by));
            DoubleVector y = aw.mul(by).add(ax.mul(bz)).sub(ay.mul(bw)).sub(az.mul(bx));
            DoubleVector z = aw.mul(bz).sub(ax.mul(by)).add(ay.mul(bx)).sub(az.mul(bw));
            DoubleVector w = aw.mul(bw).add(ax.mul(bx)).add(ay.mul(by)).add(az.mul(bz));
            DoubleVector xx = x.mul(x);
            DoubleVector yy = y.mul(y);
            DoubleVector zz = z.mul(z);
            DoubleVector xy = x.mul(y);
            DoubleVector xz = x.mul(z);
            DoubleVector yz = y.mul(z);
            DoubleVector xw = x.mul(w);
            DoubleVector yw = y.mul(w);
            DoubleVector zw = z.mul(w);
            DoubleVector one = DoubleVector.broadcast(S, 1);
            DoubleVector s = DoubleVector.broadcast(S, 2).div(xx.add(yy).add(zz).add(w.mul(w)));
            one.sub(s.mul(yy.add(zz))).intoArray(t, RELATIVE + i);
            s.mul(xy.sub(zw)).intoArray(t, RELATIVE + CAPACITY + i);
            s.mul(xz.add(yw)).intoArray(t, RELATIVE + 2 * CAPACITY + i);
            s.mul(xy.add(zw)).intoArray(t, RELATIVE + 3 * CAPACITY + i);
            one.sub(s.mul(xx.add(zz))).intoArray(t, RELATIVE + 4 * CAPACITY + i);
            s.mul(yz.sub(xw)).intoArray(t, RELATIVE + 5 * CAPACITY + i);
            s.mul(xz.sub(yw)).intoArray(t, RELATIVE + 6 * CAPACITY + i);
            s.mul(yz.add(xw)).intoArray(t, RELATIVE + 7 * CAPACITY + i);
            one.sub(s.mul(xx.add(yy))).intoArray(t, RELATIVE + 8 * CAPACITY + i);
        }
    }

    private static void facesOfA(double[] t, int end) {
        for (int i = 0; i < end; i += LANES) {
            DoubleVector hx = DoubleVector.fromArray(S, t, HALF_B + i);
            DoubleVector hy = DoubleVector.fromArray(S, t, HALF_B + CAPACITY + i);
            DoubleVector hz = DoubleVector.fromArray(S, t, HALF_B + 2 * CAPACITY + i);
            // No loop: where one begins and ends, masks would be kept as arrays.
            DoubleVector x = DoubleVector.fromArray(S, t, RELATIVE + 0 * CAPACITY + i);
            DoubleVector y = DoubleVector.fromArray(S, t, RELATIVE + 1 * CAPACITY + i);
            DoubleVector z = DoubleVector.fromArray(S, t, RELATIVE + 2 * CAPACITY + i);
            DoubleVector along = DoubleVector.fromArray(S, t, CENTRE + i);
            DoubleVector extent = x.abs().mul(hx).add(y.abs().mul(hy)).add(z.abs().mul(hz));
            DoubleVector half = DoubleVector.fromArray(S, t, HALF_A + i);
            DoubleVector s = along.abs().sub(half.add(extent));
            DoubleVector most = s;
            DoubleVector face = DoubleVector.zero(S).blend(1, along.compare(VectorOperators.GE, 0));

            x = DoubleVector.fromArray(S, t, RELATIVE + 3 * CAPACITY + i);
            y = DoubleVector.fromArray(S, t, RELATIVE + 4 * CAPACITY + i);
            z = DoubleVector.fromArray(S, t, RELATIVE + 5 * CAPACITY + i);
            along = DoubleVector.fromArray(S, t, CENTRE + CAPACITY + i);
            extent = x.abs().mul(hx).add(y.abs().mul(hy)).add(z.abs().mul(hz));
            half = DoubleVector.fromArray(S, t, HALF_A + CAPACITY + i);
            s = along.abs().sub(half.add(extent));
            VectorMask<Double> better = s.compare(VectorOperators.GT, most);
            most = most.blend(s, better);
            DoubleVector here =
                    DoubleVector.broadcast(S, 2).blend(3, along.compare(VectorOperators.GE, 0));
            face = face.blend(here, better);

            x = DoubleVector.fromArray(S, t, RELATIVE + 6 * CAPACITY + i);
            y = DoubleVector.fromArray(S, t, RELATIVE + 7 * CAPACITY + i);
            z = DoubleVector.fromArray(S, t, RELATIVE + 8 * CAPACITY + i);
            along = DoubleVector.fromArray(S, t, CENTRE + 2 * CAPACITY + i);
            extent = x.abs().mul(hx).add(y.abs().mul(hy)).add(z.abs().mul(hz));
            half = DoubleVector.fromArray(S, t, HALF_A + 2 * CAPACITY + i);
            s = along.abs().sub(half.add(extent));
            better = s.compare(VectorOperators.GT, most);
            most = most.blend(s, better);
            here = DoubleVector.broadcast(S, 4).blend(5, along.compare(VectorOperators.GE, 0));
            face = face.blend(here, better);
            most.intoArray(t, SEPARATION_A + i);
            face.intoArray(t, FACE_A + i);
        }
    }

    private static void facesOfB(double[] t, int end) {
        for (int i = 0; i < end; i += LANES) {
            DoubleVector hx = DoubleVector.fromArray(S, t, HALF_A + i);
            DoubleVector hy = DoubleVector.fromArray(S, t, HALF_A + CAPACITY + i);
            DoubleVector hz = DoubleVector.fromArray(S, t, HALF_A + 2 * CAPACITY + i);
            DoubleVector dx = DoubleVector.fromArray(S, t, CENTRE + i);
            DoubleVector dy = DoubleVector.fromArray(S, t, CENTRE + CAPACITY + i);
            DoubleVector dz = DoubleVector.fromArray(S, t, CENTRE + 2 * CAPACITY + i);
            DoubleVector x = DoubleVector.fromArray(S, t, RELATIVE + 0 * CAPACITY + i);
            DoubleVector y = DoubleVector.fromArray(S, t, RELATIVE + 3 * CAPACITY + i);
            DoubleVector z = DoubleVector.fromArray(S, t, RELATIVE + 6 * CAPACITY + i);
            DoubleVector along = dx.mul(x).add(dy.mul(y)).add(dz.mul(z));
            DoubleVector extent = x.abs().mul(hx).add(y.abs().mul(hy)).add(z.abs().mul(hz));
            DoubleVector half = DoubleVector.fromArray(S, t, HALF_B + i);
            DoubleVector s = along.abs().sub(half.add(extent));
            DoubleVector most = s;
            DoubleVector face =
                    DoubleVector.broadcast(S, 1).blend(0, along.compare(VectorOperators.GE, 0));

            x = DoubleVector.fromArray(S, t, RELATIVE + 1 * CAPACITY + i);
            y = DoubleVector.fromArray(S, t, RELATIVE + 4 * CAPACITY + i);
            z = DoubleVector.fromArray(S, t, RELATIVE + 7 * CAPACITY + i);
            along = dx.mul(x).add(dy.mul(y)).add(dz.mul(z));
            extent = x.abs().mul(hx).add(y.abs().mul(hy)).add(z.abs().mul(hz));
            half = DoubleVector.fromArray(S, t, HALF_B + CAPACITY + i);
            s = along.abs().sub(half.add(extent));
            VectorMask<Double> better = s.compare(VectorOperators.GT, most);
            most = most.blend(s, better);
            DoubleVector here =
                    DoubleVector.broadcast(S, 3).blend(2, along.compare(VectorOperators.GE, 0));
            face = face.blend(here, better);

            x = DoubleVector.fromArray(S, t, RELATIVE + 2 * CAPACITY + i);
            y = DoubleVector.fromArray(S, t, RELATIVE + 5 * CAPACITY + i);
            z = DoubleVector.fromArray(S, t, RELATIVE + 8 * CAPACITY + i);
            along = dx.mul(x).add(dy.mul(y)).add(dz.mul(z));
            extent = x.abs().mul(hx).add(y.abs().mul(hy)).add(z.abs().mul(hz));
            half = DoubleVector.fromArray(S, t, HALF_B + 2 * CAPACITY + i);
            s = along.abs().sub(half.add(extent));
            better = s.compare(VectorOperators.GT, most);
            most = most.blend(s, better);
            here = DoubleVector.broadcast(S, 5).blend(4, along.compare(VectorOperators.GE, 0));
            face = face.blend(here, better);
            most.intoArray(t, SEPARATION_B + i);
            face.intoArray(t, FACE_B + i);
        }
    }

    /**
     * One edge direction of B with the three of A. Separations {@code s / sqrt(square)} are
     * compared by {@code s |s| square'} against {@code s' |s'| square}: nine roots and divisions
     * would cost more than all the rest.
     *
     * @param i the first pair of the lanes
     * @param j column of B's axis
     * @param k column of B's next axis
     * @param l column of B's last axis
     * @param pair number of the axis
     */
    private static void edges(double[] t, int i, int j, int k, int l, int pair) {
        DoubleVector x = DoubleVector.fromArray(S, t, RELATIVE + j + i);
        DoubleVector y = DoubleVector.fromArray(S, t, RELATIVE + 3 * CAPACITY + j + i);
        DoubleVector z = DoubleVector.fromArray(S, t, RELATIVE + 6 * CAPACITY + j + i);
        DoubleVector ux = DoubleVector.fromArray(S, t, RELATIVE + k + i);
        DoubleVector uy = DoubleVector.fromArray(S, t, RELATIVE + 3 * CAPACITY + k + i);
        DoubleVector uz = DoubleVector.fromArray(S, t, RELATIVE + 6 * CAPACITY + k + i);
        DoubleVector vx = DoubleVector.fromArray(S, t, RELATIVE + l + i);
        DoubleVector vy = DoubleVector.fromArray(S, t, RELATIVE + 3 * CAPACITY + l + i);
        DoubleVector vz = DoubleVector.fromArray(S, t, RELATIVE + 6 * CAPACITY + l + i);
        DoubleVector dx = DoubleVector.fromArray(S, t, CENTRE + i);
        DoubleVector dy = DoubleVector.fromArray(S, t, CENTRE + CAPACITY + i);
        DoubleVector dz = DoubleVector.fromArray(S, t, CENTRE + 2 * CAPACITY + i);
        DoubleVector ax = DoubleVector.fromArray(S, t, HALF_A + i);
        DoubleVector ay = DoubleVector.fromArray(S, t, HALF_A + CAPACITY + i);
        DoubleVector az = DoubleVector.fromArray(S, t, HALF_A + 2 * CAPACITY + i);
        DoubleVector h1 = DoubleVector.fromArray(S, t, HALF_B + k + i);
        DoubleVector h2 = DoubleVector.fromArray(S, t, HALF_B + l + i);
        DoubleVector xx = x.mul(x);
        DoubleVector yy = y.mul(y);
        DoubleVector zz = z.mul(z);
        DoubleVector bx = x.abs();
        DoubleVector by = y.abs();
        DoubleVector bz = z.abs();
        DoubleVector most = DoubleVector.fromArray(S, t, SEPARATION_EDGE + i);
        DoubleVector mostSquare = DoubleVector.fromArray(S, t, SIGNED_SQUARE + i);
        DoubleVector below = DoubleVector.fromArray(S, t, SQUARE + i);
        DoubleVector name = DoubleVector.fromArray(S, t, EDGE + i);

        DoubleVector square = yy.add(zz);
        DoubleVector along =
                dz.mul(y)
                        .sub(dy.mul(z))
                        .abs()
                        .sub(ay.mul(bz))
                        .sub(az.mul(by))
                        .sub(h1.mul(uz.mul(y).sub(uy.mul(z)).abs()))
                        .sub(h2.mul(vz.mul(y).sub(vy.mul(z)).abs()));
        DoubleVector s = along.mul(along.abs());
        VectorMask<Double> better =
                square.compare(VectorOperators.GT, BoxAxes.PARALLEL)
                        .and(s.mul(below).compare(VectorOperators.GT, mostSquare.mul(square)));
        most = most.blend(along, better);
        mostSquare = mostSquare.blend(s, better);
        below = below.blend(square, better);
        name = name.blend(pair, better);

        square = xx.add(zz);
        along =
                dx.mul(z)
                        .sub(dz.mul(x))
                        .abs()
                        .sub(ax.mul(bz))
                        .sub(az.mul(bx))
                        .sub(h1.mul(ux.mul(z).sub(uz.mul(x)).abs()))
                        .sub(h2.mul(vx.mul(z).sub(vz.mul(x)).abs()));
        s = along.mul(along.abs());
        better =
                square.compare(VectorOperators.GT, BoxAxes.PARALLEL)
                        .and(s.mul(below).compare(VectorOperators.GT, mostSquare.mul(square)));
        most = most.blend(along, better);
        mostSquare = mostSquare.blend(s, better);
        below = below.blend(square, better);
        name = name.blend(3 + pair, better);

        square = xx.add(yy);
        along =
                dy.mul(x)
                        .sub(dx.mul(y))
                        .abs()
                        .sub(ax.mul(by))
                        .sub(ay.mul(bx))
                        .sub(h1.mul(uy.mul(x).sub(ux.mul(y)).abs()))
                        .sub(h2.mul(vy.mul(x).sub(vx.mul(y)).abs()));
        s = along.mul(along.abs());
        better =
                square.compare(VectorOperators.GT, BoxAxes.PARALLEL)
                        .and(s.mul(below).compare(VectorOperators.GT, mostSquare.mul(square)));
        most.blend(along, better).intoArray(t, SEPARATION_EDGE + i);
        mostSquare.blend(s, better).intoArray(t, SIGNED_SQUARE + i);
        below.blend(square, better).intoArray(t, SQUARE + i);
        name.blend(6 + pair, better).intoArray(t, EDGE + i);
    }
}
