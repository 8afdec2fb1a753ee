package dev.cairn.physics.narrowphase.wide;

import static dev.cairn.physics.narrowphase.wide.BoxBatch.*;

import dev.cairn.physics.narrowphase.pair.ContactTolerances;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * Two edges that cross, a pair to a lane, after the axes of edges: the operations on each number
 * are those of {@code narrowphase.BoxEdgeContact}.
 */
final class BoxCrossingWide {
    private static final VectorSpecies<Double> S = DoubleVector.SPECIES_PREFERRED;
    private static final int LANES = S.length();

    private BoxCrossingWide() {}

    /** Fills the columns from CROSSING_AXIS on, of the groups of lanes in which a bit is set. */
    static void run(double[] t, int pairs) {
        int group = (int) ((1L << LANES) - 1);
        for (int i = 0; i < CAPACITY; i += LANES) {
            if ((pairs >>> i & group) != 0) {
                axis(t, i);
                cosine(t, i);
                middleOfA(t, i);
                middleOfB(t, i);
                point(t, i);
                world(t, i);
            }
        }
    }

    /** The unit axis from A to B in A's frame: the cross product of an axis of A and one of B. */
    private static void axis(double[] t, int i) {
        DoubleVector pair = DoubleVector.fromArray(S, t, EDGE + i);
        VectorMask<Double> kx = pair.compare(VectorOperators.LT, 3);
        VectorMask<Double> kz = pair.compare(VectorOperators.GE, 6);
        VectorMask<Double> ky = kx.or(kz).not();
        DoubleVector l = pair.sub(DoubleVector.broadcast(S, 3).blend(0, kx).blend(6, kz));
        VectorMask<Double> lx = l.compare(VectorOperators.LE, 0);
        VectorMask<Double> lz = l.compare(VectorOperators.GE, 2);
        DoubleVector x =
                DoubleVector.fromArray(S, t, RELATIVE + CAPACITY + i)
                        .blend(DoubleVector.fromArray(S, t, RELATIVE + i), lx)
                        .blend(DoubleVector.fromArray(S, t, RELATIVE + 2 * CAPACITY + i), lz);
        DoubleVector y =
                DoubleVector.fromArray(S, t, RELATIVE + 4 * CAPACITY + i)
                        .blend(DoubleVector.fromArray(S, t, RELATIVE + 3 * CAPACITY + i), lx)
                        .blend(DoubleVector.fromArray(S, t, RELATIVE + 5 * CAPACITY + i), lz);
        DoubleVector z =
                DoubleVector.fromArray(S, t, RELATIVE + 7 * CAPACITY + i)
                        .blend(DoubleVector.fromArray(S, t, RELATIVE + 6 * CAPACITY + i), lx)
                        .blend(DoubleVector.fromArray(S, t, RELATIVE + 8 * CAPACITY + i), lz);
        DoubleVector h =
                DoubleVector.fromArray(S, t, HALF_B + CAPACITY + i)
                        .blend(DoubleVector.fromArray(S, t, HALF_B + i), lx)
                        .blend(DoubleVector.fromArray(S, t, HALF_B + 2 * CAPACITY + i), lz);
        x.mul(h).intoArray(t, CROSSING_LINES + i);
        y.mul(h).intoArray(t, CROSSING_LINES + CAPACITY + i);
        z.mul(h).intoArray(t, CROSSING_LINES + 2 * CAPACITY + i);
        DoubleVector length = DoubleVector.fromArray(S, t, SQUARE + i).sqrt();
        DoubleVector nx = z.blend(y.neg(), kz).blend(0, kx).div(length);
        DoubleVector ny = x.blend(z.neg(), kx).blend(0, ky).div(length);
        DoubleVector nz = y.blend(x.neg(), ky).blend(0, kz).div(length);
        VectorMask<Double> back =
                nx.mul(DoubleVector.fromArray(S, t, CENTRE + i))
                        .add(ny.mul(DoubleVector.fromArray(S, t, CENTRE + CAPACITY + i)))
                        .add(nz.mul(DoubleVector.fromArray(S, t, CENTRE + 2 * CAPACITY + i)))
                        .compare(VectorOperators.LT, 0);
        nx.blend(nx.neg(), back).intoArray(t, CROSSING_AXIS + i);
        ny.blend(ny.neg(), back).intoArray(t, CROSSING_AXIS + CAPACITY + i);
        nz.blend(nz.neg(), back).intoArray(t, CROSSING_AXIS + 2 * CAPACITY + i);
    }

    /** Of that axis and the normal of the chosen face, which is reversed when it is B's. */
    private static void cosine(double[] t, int i) {
        VectorMask<Double> flip =
                DoubleVector.fromArray(S, t, FLIP + i).compare(VectorOperators.GT, 0);
        DoubleVector axis = DoubleVector.fromArray(S, t, AXIS + i);
        VectorMask<Double> isX = axis.compare(VectorOperators.EQ, 0);
        VectorMask<Double> isZ = axis.compare(VectorOperators.EQ, 2);
        DoubleVector nx = DoubleVector.fromArray(S, t, CROSSING_AXIS + i);
        DoubleVector ny = DoubleVector.fromArray(S, t, CROSSING_AXIS + CAPACITY + i);
        DoubleVector nz = DoubleVector.fromArray(S, t, CROSSING_AXIS + 2 * CAPACITY + i);
        DoubleVector x =
                DoubleVector.fromArray(S, t, RELATIVE + CAPACITY + i)
                        .blend(DoubleVector.fromArray(S, t, RELATIVE + i), isX)
                        .blend(DoubleVector.fromArray(S, t, RELATIVE + 2 * CAPACITY + i), isZ);
        DoubleVector y =
                DoubleVector.fromArray(S, t, RELATIVE + 4 * CAPACITY + i)
                        .blend(DoubleVector.fromArray(S, t, RELATIVE + 3 * CAPACITY + i), isX)
                        .blend(DoubleVector.fromArray(S, t, RELATIVE + 5 * CAPACITY + i), isZ);
        DoubleVector z =
                DoubleVector.fromArray(S, t, RELATIVE + 7 * CAPACITY + i)
                        .blend(DoubleVector.fromArray(S, t, RELATIVE + 6 * CAPACITY + i), isX)
                        .blend(DoubleVector.fromArray(S, t, RELATIVE + 8 * CAPACITY + i), isZ);
        DoubleVector onB = x.mul(nx).add(y.mul(ny)).add(z.mul(nz)).neg();
        ny.blend(nx, isX)
                .blend(nz, isZ)
                .blend(onB, flip)
                .mul(DoubleVector.fromArray(S, t, SIGN + i))
                .intoArray(t, CROSSING_COSINE + i);
    }

    /** The middle of the edge of A, and the vertex that it ends at. */
    private static void middleOfA(double[] t, int i) {
        DoubleVector nx = DoubleVector.fromArray(S, t, CROSSING_AXIS + i);
        DoubleVector ny = DoubleVector.fromArray(S, t, CROSSING_AXIS + CAPACITY + i);
        DoubleVector nz = DoubleVector.fromArray(S, t, CROSSING_AXIS + 2 * CAPACITY + i);
        DoubleVector pair = DoubleVector.fromArray(S, t, EDGE + i);
        VectorMask<Double> kx = pair.compare(VectorOperators.LT, 3);
        VectorMask<Double> kz = pair.compare(VectorOperators.GE, 6);
        VectorMask<Double> ky = kx.or(kz).not();
        DoubleVector zero = DoubleVector.zero(S);
        VectorMask<Double> up = nx.compare(VectorOperators.GE, 0);
        DoubleVector ends = zero.blend(8, up);
        DoubleVector h = DoubleVector.fromArray(S, t, HALF_A + i);
        h.neg().blend(h, up).blend(0, kx).intoArray(t, CROSSING_POINT + i);
        up = ny.compare(VectorOperators.GE, 0);
        ends = ends.add(zero.blend(16, up));
        h = DoubleVector.fromArray(S, t, HALF_A + CAPACITY + i);
        h.neg().blend(h, up).blend(0, ky).intoArray(t, CROSSING_POINT + CAPACITY + i);
        up = nz.compare(VectorOperators.GE, 0);
        ends = ends.add(zero.blend(32, up));
        h = DoubleVector.fromArray(S, t, HALF_A + 2 * CAPACITY + i);
        h.neg().blend(h, up).blend(0, kz).intoArray(t, CROSSING_POINT + 2 * CAPACITY + i);
        ends.intoArray(t, CROSSING_ENDS + i);
    }

    /** The middle of the edge of B, in A's frame, and the vertex that it ends at. */
    private static void middleOfB(double[] t, int i) {
        DoubleVector nx = DoubleVector.fromArray(S, t, CROSSING_AXIS + i);
        DoubleVector ny = DoubleVector.fromArray(S, t, CROSSING_AXIS + CAPACITY + i);
        DoubleVector nz = DoubleVector.fromArray(S, t, CROSSING_AXIS + 2 * CAPACITY + i);
        DoubleVector pair = DoubleVector.fromArray(S, t, EDGE + i);
        DoubleVector l =
                pair.sub(
                        DoubleVector.broadcast(S, 3)
                                .blend(0, pair.compare(VectorOperators.LT, 3))
                                .blend(6, pair.compare(VectorOperators.GE, 6)));
        DoubleVector zero = DoubleVector.zero(S);
        DoubleVector ends = DoubleVector.fromArray(S, t, CROSSING_ENDS + i);
        DoubleVector r0 = DoubleVector.fromArray(S, t, RELATIVE + i);
        DoubleVector r1 = DoubleVector.fromArray(S, t, RELATIVE + 3 * CAPACITY + i);
        DoubleVector r2 = DoubleVector.fromArray(S, t, RELATIVE + 6 * CAPACITY + i);
        VectorMask<Double> up =
                r0.mul(nx).add(r1.mul(ny)).add(r2.mul(nz)).compare(VectorOperators.LE, 0);
        ends = ends.add(zero.blend(1, up));
        DoubleVector h = DoubleVector.fromArray(S, t, HALF_B + i);
        DoubleVector b = h.neg().blend(h, up).blend(0, l.compare(VectorOperators.LE, 0));
        DoubleVector px = r0.mul(b);
        DoubleVector py = r1.mul(b);
        DoubleVector pz = r2.mul(b);
        r0 = DoubleVector.fromArray(S, t, RELATIVE + CAPACITY + i);
        r1 = DoubleVector.fromArray(S, t, RELATIVE + 4 * CAPACITY + i);
        r2 = DoubleVector.fromArray(S, t, RELATIVE + 7 * CAPACITY + i);
        up = r0.mul(nx).add(r1.mul(ny)).add(r2.mul(nz)).compare(VectorOperators.LE, 0);
        ends = ends.add(zero.blend(2, up));
        h = DoubleVector.fromArray(S, t, HALF_B + CAPACITY + i);
        b = h.neg().blend(h, up).blend(0, l.compare(VectorOperators.EQ, 1));
        px = px.add(r0.mul(b));
        py = py.add(r1.mul(b));
        pz = pz.add(r2.mul(b));
        r0 = DoubleVector.fromArray(S, t, RELATIVE + 2 * CAPACITY + i);
        r1 = DoubleVector.fromArray(S, t, RELATIVE + 5 * CAPACITY + i);
        r2 = DoubleVector.fromArray(S, t, RELATIVE + 8 * CAPACITY + i);
        up = r0.mul(nx).add(r1.mul(ny)).add(r2.mul(nz)).compare(VectorOperators.LE, 0);
        ends.add(zero.blend(4, up)).intoArray(t, CROSSING_ENDS + i);
        h = DoubleVector.fromArray(S, t, HALF_B + 2 * CAPACITY + i);
        b = h.neg().blend(h, up).blend(0, l.compare(VectorOperators.GE, 2));
        px.add(r0.mul(b))
                .add(DoubleVector.fromArray(S, t, CENTRE + i))
                .intoArray(t, CROSSING_NORMAL + i);
        py.add(r1.mul(b))
                .add(DoubleVector.fromArray(S, t, CENTRE + CAPACITY + i))
                .intoArray(t, CROSSING_NORMAL + CAPACITY + i);
        pz.add(r2.mul(b))
                .add(DoubleVector.fromArray(S, t, CENTRE + 2 * CAPACITY + i))
                .intoArray(t, CROSSING_NORMAL + 2 * CAPACITY + i);
    }

    /** Midway between the nearest points of both lines; CROSSING_ENDS is -1 where these are not. */
    private static void point(double[] t, int i) {
        DoubleVector pair = DoubleVector.fromArray(S, t, EDGE + i);
        VectorMask<Double> kx = pair.compare(VectorOperators.LT, 3);
        VectorMask<Double> kz = pair.compare(VectorOperators.GE, 6);
        VectorMask<Double> ky = kx.or(kz).not();
        DoubleVector ax = DoubleVector.fromArray(S, t, CROSSING_POINT + i);
        DoubleVector ay = DoubleVector.fromArray(S, t, CROSSING_POINT + CAPACITY + i);
        DoubleVector az = DoubleVector.fromArray(S, t, CROSSING_POINT + 2 * CAPACITY + i);
        DoubleVector px = DoubleVector.fromArray(S, t, CROSSING_NORMAL + i);
        DoubleVector py = DoubleVector.fromArray(S, t, CROSSING_NORMAL + CAPACITY + i);
        DoubleVector pz = DoubleVector.fromArray(S, t, CROSSING_NORMAL + 2 * CAPACITY + i);
        DoubleVector vx = DoubleVector.fromArray(S, t, CROSSING_LINES + i);
        DoubleVector vy = DoubleVector.fromArray(S, t, CROSSING_LINES + CAPACITY + i);
        DoubleVector vz = DoubleVector.fromArray(S, t, CROSSING_LINES + 2 * CAPACITY + i);
        DoubleVector u =
                DoubleVector.fromArray(S, t, HALF_A + CAPACITY + i)
                        .blend(DoubleVector.fromArray(S, t, HALF_A + i), kx)
                        .blend(DoubleVector.fromArray(S, t, HALF_A + 2 * CAPACITY + i), kz);
        DoubleVector rx = px.sub(ax);
        DoubleVector ry = py.sub(ay);
        DoubleVector rz = pz.sub(az);
        DoubleVector uu = u.mul(u);
        DoubleVector vv = vx.mul(vx).add(vy.mul(vy)).add(vz.mul(vz));
        DoubleVector uv = u.mul(vy.blend(vx, kx).blend(vz, kz));
        DoubleVector ur = u.mul(ry.blend(rx, kx).blend(rz, kz));
        DoubleVector vr = vx.mul(rx).add(vy.mul(ry)).add(vz.mul(rz));
        DoubleVector det = uu.mul(vv).sub(uv.mul(uv));
        DoubleVector f = ur.mul(vv).sub(vr.mul(uv)).div(det);
        DoubleVector g = ur.mul(uv).sub(vr.mul(uu)).div(det);
        VectorMask<Double> meet =
                f.abs()
                        .compare(VectorOperators.LE, ContactTolerances.CROSSING_END)
                        .and(g.abs().compare(VectorOperators.LE, ContactTolerances.CROSSING_END))
                        .and(pair.compare(VectorOperators.GE, 0))
                        .and(
                                DoubleVector.fromArray(S, t, SEPARATION_EDGE + i)
                                        .compare(
                                                VectorOperators.LE,
                                                DoubleVector.fromArray(S, t, MARGIN + i)));
        DoubleVector.broadcast(S, -1)
                .blend(DoubleVector.fromArray(S, t, CROSSING_ENDS + i), meet)
                .intoArray(t, CROSSING_ENDS + i);
        DoubleVector fu = f.mul(u);
        DoubleVector zero = DoubleVector.zero(S);
        ax.add(zero.blend(fu, kx)).add(px.add(g.mul(vx))).mul(0.5).intoArray(t, CROSSING_POINT + i);
        ay.add(zero.blend(fu, ky))
                .add(py.add(g.mul(vy)))
                .mul(0.5)
                .intoArray(t, CROSSING_POINT + CAPACITY + i);
        az.add(zero.blend(fu, kz))
                .add(pz.add(g.mul(vz)))
                .mul(0.5)
                .intoArray(t, CROSSING_POINT + 2 * CAPACITY + i);
    }

    /** Turns point and axis into world axes. */
    private static void world(double[] t, int i) {
        DoubleVector x = DoubleVector.fromArray(S, t, CROSSING_POINT + i);
        DoubleVector y = DoubleVector.fromArray(S, t, CROSSING_POINT + CAPACITY + i);
        DoubleVector z = DoubleVector.fromArray(S, t, CROSSING_POINT + 2 * CAPACITY + i);
        DoubleVector nx = DoubleVector.fromArray(S, t, CROSSING_AXIS + i);
        DoubleVector ny = DoubleVector.fromArray(S, t, CROSSING_AXIS + CAPACITY + i);
        DoubleVector nz = DoubleVector.fromArray(S, t, CROSSING_AXIS + 2 * CAPACITY + i);
        for (int k = i; k < 3 * CAPACITY; k += CAPACITY) {
            int row = WORLD + 3 * (k - i) + i;
            DoubleVector w0 = DoubleVector.fromArray(S, t, row);
            DoubleVector w1 = DoubleVector.fromArray(S, t, row + CAPACITY);
            DoubleVector w2 = DoubleVector.fromArray(S, t, row + 2 * CAPACITY);
            w0.mul(x).add(w1.mul(y)).add(w2.mul(z)).intoArray(t, CROSSING_POINT + k);
            w0.mul(nx).add(w1.mul(ny)).add(w2.mul(nz)).intoArray(t, CROSSING_NORMAL + k);
        }
    }
}
