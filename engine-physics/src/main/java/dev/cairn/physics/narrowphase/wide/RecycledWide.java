package dev.cairn.physics.narrowphase.wide;

import static dev.cairn.physics.narrowphase.wide.RecycledBatch.*;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * The kernels of {@link RecycledBatch}, a row to a lane. Their twin is {@code contact.Recycler},
 * with the same operations on each number.
 */
final class RecycledWide {
    private static final VectorSpecies<Double> S = DoubleVector.SPECIES_PREFERRED;
    private static final int LANES = S.length();

    private RecycledWide() {}

    static void run(double[] t, int count, double[] kept, int at, double reach, double fraction) {
        margins(t, count, reach, fraction);
        moves(t, count, kept, at);
        normals(t, count);
        matrices(t, count);
        points(t, count, kept, at);
    }

    /** Where the numbers of place {@code i} begin, a place where a vector begins. */
    private static int kept(int i) {
        return KEPT * (i & -ROWS) + (i & (ROWS - 1));
    }

    private static void margins(double[] t, int count, double reach, double fraction) {
        for (int i = 0; i < count; i += LANES) {
            DoubleVector x = DoubleVector.fromArray(S, t, AHEAD + i);
            DoubleVector y = DoubleVector.fromArray(S, t, AHEAD + CAPACITY + i);
            DoubleVector z = DoubleVector.fromArray(S, t, AHEAD + 2 * CAPACITY + i);
            x.mul(x)
                    .add(y.mul(y))
                    .add(z.mul(z))
                    .sqrt()
                    .mul(reach)
                    .add(DoubleVector.fromArray(S, t, ARC_A + i))
                    .add(DoubleVector.fromArray(S, t, ARC_B + i))
                    .add(DoubleVector.fromArray(S, t, INNER + i).mul(fraction))
                    .intoArray(t, MARGIN + i);
        }
    }

    /** Which pairs have hardly moved. */
    private static void moves(double[] t, int count, double[] kept, int at) {
        for (int i = 0; i < count; i += LANES) {
            int k = at + kept(i);
            DoubleVector rx = DoubleVector.fromArray(S, t, TURN_R + i);
            DoubleVector ry = DoubleVector.fromArray(S, t, TURN_R + CAPACITY + i);
            DoubleVector rz = DoubleVector.fromArray(S, t, TURN_R + 2 * CAPACITY + i);
            DoubleVector rw = DoubleVector.fromArray(S, t, TURN_R + 3 * CAPACITY + i);
            DoubleVector ix = DoubleVector.fromArray(S, t, TURN_I + i);
            DoubleVector iy = DoubleVector.fromArray(S, t, TURN_I + CAPACITY + i);
            DoubleVector iz = DoubleVector.fromArray(S, t, TURN_I + 2 * CAPACITY + i);
            DoubleVector iw = DoubleVector.fromArray(S, t, TURN_I + 3 * CAPACITY + i);
            DoubleVector qx =
                    rw.mul(ix)
                            .sub(rx.mul(iw))
                            .sub(ry.mul(iz))
                            .add(rz.mul(iy))
                            .sub(DoubleVector.fromArray(S, kept, k + ROWS * TURN));
            DoubleVector qy =
                    rw.mul(iy)
                            .sub(ry.mul(iw))
                            .sub(rz.mul(ix))
                            .add(rx.mul(iz))
                            .sub(DoubleVector.fromArray(S, kept, k + ROWS * (TURN + 1)));
            DoubleVector qz =
                    rw.mul(iz)
                            .sub(rz.mul(iw))
                            .sub(rx.mul(iy))
                            .add(ry.mul(ix))
                            .sub(DoubleVector.fromArray(S, kept, k + ROWS * (TURN + 2)));
            DoubleVector qw =
                    rw.mul(iw)
                            .add(rx.mul(ix))
                            .add(ry.mul(iy))
                            .add(rz.mul(iz))
                            .sub(DoubleVector.fromArray(S, kept, k + ROWS * (TURN + 3)));
            DoubleVector ex = DoubleVector.fromArray(S, t, OFFSET + i);
            DoubleVector ey = DoubleVector.fromArray(S, t, OFFSET + CAPACITY + i);
            DoubleVector ez = DoubleVector.fromArray(S, t, OFFSET + 2 * CAPACITY + i);
            DoubleVector tx = rz.mul(ey).sub(ry.mul(ez)).mul(2);
            DoubleVector ty = rx.mul(ez).sub(rz.mul(ex)).mul(2);
            DoubleVector tz = ry.mul(ex).sub(rx.mul(ey)).mul(2);
            DoubleVector cx =
                    ex.add(rw.mul(tx))
                            .add(rz.mul(ty).sub(ry.mul(tz)))
                            .sub(DoubleVector.fromArray(S, kept, k + ROWS * CENTRE));
            DoubleVector cy =
                    ey.add(rw.mul(ty))
                            .add(rx.mul(tz).sub(rz.mul(tx)))
                            .sub(DoubleVector.fromArray(S, kept, k + ROWS * (CENTRE + 1)));
            DoubleVector cz =
                    ez.add(rw.mul(tz))
                            .add(ry.mul(tx).sub(rx.mul(ty)))
                            .sub(DoubleVector.fromArray(S, kept, k + ROWS * (CENTRE + 2)));
            DoubleVector turned = qx.mul(qx).add(qy.mul(qy)).add(qz.mul(qz).add(qw.mul(qw)));
            DoubleVector moved =
                    cx.mul(cx)
                            .add(cy.mul(cy))
                            .add(cz.mul(cz))
                            .add(DoubleVector.fromArray(S, kept, k + ROWS * SPIN).mul(turned))
                            .mul(2);
            DoubleVector room =
                    DoubleVector.fromArray(S, kept, k + ROWS * GAP)
                            .sub(DoubleVector.fromArray(S, t, MARGIN + i));
            VectorMask<Double> stays =
                    room.compare(VectorOperators.GT, 0)
                            .and(
                                    moved.compare(
                                            VectorOperators.LE,
                                            DoubleVector.fromArray(S, kept, k + ROWS * LIMIT)))
                            .and(moved.compare(VectorOperators.LT, room.mul(room)));
            DoubleVector.zero(S).blend(1, stays).intoArray(t, STAYS + i);
        }
    }

    /** The normal of the reference's face: a column of its rotation matrix. */
    private static void normals(double[] t, int count) {
        for (int i = 0; i < count; i += LANES) {
            DoubleVector x = DoubleVector.fromArray(S, t, TURN_R + i);
            DoubleVector y = DoubleVector.fromArray(S, t, TURN_R + CAPACITY + i);
            DoubleVector z = DoubleVector.fromArray(S, t, TURN_R + 2 * CAPACITY + i);
            DoubleVector w = DoubleVector.fromArray(S, t, TURN_R + 3 * CAPACITY + i);
            DoubleVector axis = DoubleVector.fromArray(S, t, AXIS + i);
            VectorMask<Double> isX = axis.compare(VectorOperators.EQ, 0);
            VectorMask<Double> isZ = axis.compare(VectorOperators.EQ, 2);
            DoubleVector sign = DoubleVector.fromArray(S, t, SIGN + i);
            DoubleVector one = DoubleVector.broadcast(S, 1);
            DoubleVector xx = x.mul(x);
            DoubleVector yy = y.mul(y);
            DoubleVector zz = z.mul(z);
            DoubleVector nx = x.mul(y).sub(w.mul(z)).mul(2);
            DoubleVector ny = one.sub(xx.add(zz).mul(2));
            DoubleVector nz = y.mul(z).add(w.mul(x)).mul(2);
            nx.blend(one.sub(yy.add(zz).mul(2)), isX)
                    .blend(x.mul(z).add(w.mul(y)).mul(2), isZ)
                    .mul(sign)
                    .intoArray(t, NORMAL + i);
            ny.blend(x.mul(y).add(w.mul(z)).mul(2), isX)
                    .blend(y.mul(z).sub(w.mul(x)).mul(2), isZ)
                    .mul(sign)
                    .intoArray(t, NORMAL + CAPACITY + i);
            nz.blend(x.mul(z).sub(w.mul(y)).mul(2), isX)
                    .blend(one.sub(xx.add(yy).mul(2)), isZ)
                    .mul(sign)
                    .intoArray(t, NORMAL + 2 * CAPACITY + i);
        }
    }

    private static void matrices(double[] t, int count) {
        for (int i = 0; i < count; i += LANES) {
            DoubleVector x = DoubleVector.fromArray(S, t, TURN_I + i);
            DoubleVector y = DoubleVector.fromArray(S, t, TURN_I + CAPACITY + i);
            DoubleVector z = DoubleVector.fromArray(S, t, TURN_I + 2 * CAPACITY + i);
            DoubleVector w = DoubleVector.fromArray(S, t, TURN_I + 3 * CAPACITY + i);
            DoubleVector one = DoubleVector.broadcast(S, 1);
            DoubleVector xx = x.mul(x);
            DoubleVector yy = y.mul(y);
            DoubleVector zz = z.mul(z);
            DoubleVector xy = x.mul(y);
            DoubleVector xz = x.mul(z);
            DoubleVector yz = y.mul(z);
            DoubleVector wx = w.mul(x);
            DoubleVector wy = w.mul(y);
            DoubleVector wz = w.mul(z);
            one.sub(yy.add(zz).mul(2)).intoArray(t, WORLD + i);
            xy.sub(wz).mul(2).intoArray(t, WORLD + CAPACITY + i);
            xz.add(wy).mul(2).intoArray(t, WORLD + 2 * CAPACITY + i);
            xy.add(wz).mul(2).intoArray(t, WORLD + 3 * CAPACITY + i);
            one.sub(xx.add(zz).mul(2)).intoArray(t, WORLD + 4 * CAPACITY + i);
            yz.sub(wx).mul(2).intoArray(t, WORLD + 5 * CAPACITY + i);
            xz.sub(wy).mul(2).intoArray(t, WORLD + 6 * CAPACITY + i);
            yz.add(wx).mul(2).intoArray(t, WORLD + 7 * CAPACITY + i);
            one.sub(xx.add(yy).mul(2)).intoArray(t, WORLD + 8 * CAPACITY + i);
        }
    }

    private static void points(double[] t, int count, double[] kept, int at) {
        for (int i = 0; i < count; i += LANES) {
            DoubleVector nx = DoubleVector.fromArray(S, t, NORMAL + i);
            DoubleVector ny = DoubleVector.fromArray(S, t, NORMAL + CAPACITY + i);
            DoubleVector nz = DoubleVector.fromArray(S, t, NORMAL + 2 * CAPACITY + i);
            DoubleVector ex = DoubleVector.fromArray(S, t, OFFSET + i);
            DoubleVector ey = DoubleVector.fromArray(S, t, OFFSET + CAPACITY + i);
            DoubleVector ez = DoubleVector.fromArray(S, t, OFFSET + 2 * CAPACITY + i);
            int k = at + kept(i);
            DoubleVector before =
                    ex.mul(nx)
                            .add(ey.mul(ny))
                            .add(ez.mul(nz))
                            .sub(DoubleVector.fromArray(S, kept, k + ROWS * PLANE));
            for (int p = 0; p < 4; p++) {
                int from = k + ROWS * (POINT + 3 * p);
                DoubleVector px = DoubleVector.fromArray(S, kept, from);
                DoubleVector py = DoubleVector.fromArray(S, kept, from + ROWS);
                DoubleVector pz = DoubleVector.fromArray(S, kept, from + 2 * ROWS);
                DoubleVector x =
                        DoubleVector.fromArray(S, t, WORLD + i)
                                .mul(px)
                                .add(DoubleVector.fromArray(S, t, WORLD + CAPACITY + i).mul(py))
                                .add(
                                        DoubleVector.fromArray(S, t, WORLD + 2 * CAPACITY + i)
                                                .mul(pz));
                DoubleVector y =
                        DoubleVector.fromArray(S, t, WORLD + 3 * CAPACITY + i)
                                .mul(px)
                                .add(DoubleVector.fromArray(S, t, WORLD + 4 * CAPACITY + i).mul(py))
                                .add(
                                        DoubleVector.fromArray(S, t, WORLD + 5 * CAPACITY + i)
                                                .mul(pz));
                DoubleVector z =
                        DoubleVector.fromArray(S, t, WORLD + 6 * CAPACITY + i)
                                .mul(px)
                                .add(DoubleVector.fromArray(S, t, WORLD + 7 * CAPACITY + i).mul(py))
                                .add(
                                        DoubleVector.fromArray(S, t, WORLD + 8 * CAPACITY + i)
                                                .mul(pz));
                DoubleVector separation = x.mul(nx).add(y.mul(ny)).add(z.mul(nz)).add(before);
                separation.intoArray(t, SEPARATION + p * CAPACITY + i);
                // Anchors are midway between the surfaces.
                DoubleVector half = separation.mul(0.5);
                x = x.sub(half.mul(nx));
                y = y.sub(half.mul(ny));
                z = z.sub(half.mul(nz));
                int to = ANCHOR + 6 * p * CAPACITY + i;
                x.intoArray(t, to);
                y.intoArray(t, to + CAPACITY);
                z.intoArray(t, to + 2 * CAPACITY);
                x.add(ex).intoArray(t, to + 3 * CAPACITY);
                y.add(ey).intoArray(t, to + 4 * CAPACITY);
                z.add(ez).intoArray(t, to + 5 * CAPACITY);
            }
        }
    }
}
