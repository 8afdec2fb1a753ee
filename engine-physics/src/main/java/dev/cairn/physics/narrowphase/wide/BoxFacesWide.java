package dev.cairn.physics.narrowphase.wide;

import static dev.cairn.physics.narrowphase.wide.BoxBatch.*;

import dev.cairn.physics.narrowphase.pair.ContactTolerances;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * What has no branches in the face contacts of a batch of boxes, a pair to a lane: before clipping,
 * the corners of the incident faces; after it, the points in world axes. Its twin without the
 * Vector API is {@link BoxFacesScalar}, with the same operations on each number.
 */
final class BoxFacesWide {
    private static final VectorSpecies<Double> S = DoubleVector.SPECIES_PREFERRED;
    private static final int LANES = S.length();

    private BoxFacesWide() {}

    /**
     * Chooses by the rules of {@code BoxContacts.chooseFace} where the face of the last tick is
     * still the best one of its box; returns the other pairs, a bit each.
     */
    static int choose(double[] t, int count) {
        int others = 0;
        for (int i = 0; i < count; i += LANES) {
            DoubleVector onA = DoubleVector.fromArray(S, t, SEPARATION_A + i);
            DoubleVector onB = DoubleVector.fromArray(S, t, SEPARATION_B + i);
            DoubleVector faceA = DoubleVector.fromArray(S, t, FACE_A + i);
            DoubleVector faceB = DoubleVector.fromArray(S, t, FACE_B + i);
            DoubleVector last = DoubleVector.fromArray(S, t, LAST + i);
            DoubleVector margin = DoubleVector.fromArray(S, t, MARGIN + i);
            VectorMask<Double> beforeA = last.compare(VectorOperators.EQ, faceA.add(KIND));
            VectorMask<Double> beforeB = last.compare(VectorOperators.EQ, faceB.add(2.0 * KIND));
            DoubleVector hysteresis =
                    DoubleVector.fromArray(S, t, INNER + i).mul(ContactTolerances.HYSTERESIS);
            VectorMask<Double> flip =
                    onB.compare(
                            VectorOperators.GT,
                            onA.add(hysteresis.neg().blend(hysteresis, beforeA)));
            DoubleVector face = faceA.blend(faceB, flip);
            DoubleVector axis =
                    DoubleVector.zero(S)
                            .blend(1, face.compare(VectorOperators.GE, 2))
                            .blend(2, face.compare(VectorOperators.GE, 4));
            DoubleVector.zero(S).blend(1, flip).intoArray(t, FLIP + i);
            axis.intoArray(t, AXIS + i);
            face.sub(axis.mul(2)).mul(2).sub(1).intoArray(t, SIGN + i);
            onA.blend(onB, flip).intoArray(t, SEPARATION + i);
            DoubleVector most = onA.blend(onB, onB.compare(VectorOperators.GT, onA));
            most.intoArray(t, SEPARATION_FACES + i);
            VectorMask<Double> usual =
                    beforeA.or(beforeB).and(most.compare(VectorOperators.LE, margin));
            others |= (int) usual.not().toLong() << i;
        }
        return others;
    }

    /** Fills the columns from INCIDENT to CORNER; reads FLIP, AXIS and SIGN. */
    static void corners(double[] t, int count) {
        int end = (count + LANES - 1) / LANES * LANES;
        rows(t, end);
        incident(t, end);
        outside(t, end, CORNER + CAPACITY, HALF + CAPACITY, OUTSIDE);
        outside(t, end, CORNER + 2 * CAPACITY, HALF + 2 * CAPACITY, OUTSIDE + 2 * CAPACITY);
    }

    /** Turns the points in CORNER into world axes and writes NORMAL. */
    static void world(double[] t, int count) {
        int end = (count + LANES - 1) / LANES * LANES;
        normals(t, end);
        points(t, end);
    }

    /** The rotation from the other box to the face's box, normal first. */
    private static void rows(double[] t, int end) {
        for (int i = 0; i < end; i += LANES) {
            VectorMask<Double> flip =
                    DoubleVector.fromArray(S, t, FLIP + i).compare(VectorOperators.GT, 0);
            DoubleVector axis = DoubleVector.fromArray(S, t, AXIS + i);
            VectorMask<Double> isX = axis.compare(VectorOperators.EQ, 0);
            VectorMask<Double> isZ = axis.compare(VectorOperators.EQ, 2);
            // No loop: where one begins and ends, masks would be kept as arrays.
            DoubleVector x =
                    DoubleVector.fromArray(S, t, RELATIVE + i)
                            .blend(DoubleVector.fromArray(S, t, RELATIVE + i), flip);
            DoubleVector y =
                    DoubleVector.fromArray(S, t, RELATIVE + 3 * CAPACITY + i)
                            .blend(DoubleVector.fromArray(S, t, RELATIVE + CAPACITY + i), flip);
            DoubleVector z =
                    DoubleVector.fromArray(S, t, RELATIVE + 6 * CAPACITY + i)
                            .blend(DoubleVector.fromArray(S, t, RELATIVE + 2 * CAPACITY + i), flip);
            y.blend(x, isX).blend(z, isZ).intoArray(t, ROWS + i);
            x.blend(y, isX).intoArray(t, ROWS + 3 * CAPACITY + i);
            z.blend(y, isZ).intoArray(t, ROWS + 6 * CAPACITY + i);
            x =
                    DoubleVector.fromArray(S, t, RELATIVE + CAPACITY + i)
                            .blend(DoubleVector.fromArray(S, t, RELATIVE + 3 * CAPACITY + i), flip);
            y =
                    DoubleVector.fromArray(S, t, RELATIVE + 4 * CAPACITY + i)
                            .blend(DoubleVector.fromArray(S, t, RELATIVE + 4 * CAPACITY + i), flip);
            z =
                    DoubleVector.fromArray(S, t, RELATIVE + 7 * CAPACITY + i)
                            .blend(DoubleVector.fromArray(S, t, RELATIVE + 5 * CAPACITY + i), flip);
            y.blend(x, isX).blend(z, isZ).intoArray(t, ROWS + CAPACITY + i);
            x.blend(y, isX).intoArray(t, ROWS + 4 * CAPACITY + i);
            z.blend(y, isZ).intoArray(t, ROWS + 7 * CAPACITY + i);
            x =
                    DoubleVector.fromArray(S, t, RELATIVE + 2 * CAPACITY + i)
                            .blend(DoubleVector.fromArray(S, t, RELATIVE + 6 * CAPACITY + i), flip);
            y =
                    DoubleVector.fromArray(S, t, RELATIVE + 5 * CAPACITY + i)
                            .blend(DoubleVector.fromArray(S, t, RELATIVE + 7 * CAPACITY + i), flip);
            z =
                    DoubleVector.fromArray(S, t, RELATIVE + 8 * CAPACITY + i)
                            .blend(DoubleVector.fromArray(S, t, RELATIVE + 8 * CAPACITY + i), flip);
            y.blend(x, isX).blend(z, isZ).intoArray(t, ROWS + 2 * CAPACITY + i);
            x.blend(y, isX).intoArray(t, ROWS + 5 * CAPACITY + i);
            z.blend(y, isZ).intoArray(t, ROWS + 8 * CAPACITY + i);
            x =
                    DoubleVector.fromArray(S, t, HALF_A + i)
                            .blend(DoubleVector.fromArray(S, t, HALF_B + i), flip);
            y =
                    DoubleVector.fromArray(S, t, HALF_A + CAPACITY + i)
                            .blend(DoubleVector.fromArray(S, t, HALF_B + CAPACITY + i), flip);
            z =
                    DoubleVector.fromArray(S, t, HALF_A + 2 * CAPACITY + i)
                            .blend(DoubleVector.fromArray(S, t, HALF_B + 2 * CAPACITY + i), flip);
            y.blend(x, isX).blend(z, isZ).intoArray(t, HALF + i);
            x.blend(y, isX).intoArray(t, HALF + CAPACITY + i);
            z.blend(y, isZ).intoArray(t, HALF + 2 * CAPACITY + i);
        }
    }

    /** The incident face and its corners. */
    private static void incident(double[] t, int end) {
        for (int i = 0; i < end; i += LANES) {
            VectorMask<Double> flip =
                    DoubleVector.fromArray(S, t, FLIP + i).compare(VectorOperators.GT, 0);
            DoubleVector axis = DoubleVector.fromArray(S, t, AXIS + i);
            VectorMask<Double> isX = axis.compare(VectorOperators.EQ, 0);
            VectorMask<Double> isZ = axis.compare(VectorOperators.EQ, 2);
            DoubleVector nx = DoubleVector.fromArray(S, t, ROWS + i);
            DoubleVector ny = DoubleVector.fromArray(S, t, ROWS + CAPACITY + i);
            DoubleVector nz = DoubleVector.fromArray(S, t, ROWS + 2 * CAPACITY + i);
            DoubleVector ax = nx.abs();
            DoubleVector ay = ny.abs();
            DoubleVector az = nz.abs();
            VectorMask<Double> kx =
                    ax.compare(VectorOperators.GE, ay).and(ax.compare(VectorOperators.GE, az));
            VectorMask<Double> ky = ay.compare(VectorOperators.GE, az).andNot(kx);
            VectorMask<Double> kz = kx.or(ky).not();
            VectorMask<Double> odd =
                    nz.blend(ny, ky)
                            .blend(nx, kx)
                            .mul(DoubleVector.fromArray(S, t, SIGN + i))
                            .compare(VectorOperators.LT, 0);
            DoubleVector.broadcast(S, 4)
                    .blend(2, ky)
                    .blend(0, kx)
                    .add(DoubleVector.zero(S).blend(1, odd))
                    .intoArray(t, INCIDENT + i);

            DoubleVector zero = DoubleVector.zero(S);
            DoubleVector dx = DoubleVector.fromArray(S, t, CENTRE + i);
            DoubleVector dy = DoubleVector.fromArray(S, t, CENTRE + CAPACITY + i);
            DoubleVector dz = DoubleVector.fromArray(S, t, CENTRE + 2 * CAPACITY + i);
            DoubleVector hx =
                    DoubleVector.fromArray(S, t, HALF_B + i)
                            .blend(DoubleVector.fromArray(S, t, HALF_A + i), flip);
            DoubleVector hy =
                    DoubleVector.fromArray(S, t, HALF_B + CAPACITY + i)
                            .blend(DoubleVector.fromArray(S, t, HALF_A + CAPACITY + i), flip);
            DoubleVector hz =
                    DoubleVector.fromArray(S, t, HALF_B + 2 * CAPACITY + i)
                            .blend(DoubleVector.fromArray(S, t, HALF_A + 2 * CAPACITY + i), flip);
            VectorMask<Double> even = odd.not();
            DoubleVector before = zero.blend(dx, flip);
            DoubleVector x0 = hx.blend(hx.neg(), kx.and(odd).not()).sub(before);
            DoubleVector x1 = hx.blend(hx.neg(), kx.and(even)).sub(before);
            before = zero.blend(dz, flip);
            DoubleVector z0 = hz.blend(hz.neg(), kz.and(odd).not()).sub(before);
            DoubleVector z1 = hz.blend(hz.neg(), kz.and(even)).sub(before);
            before = zero.blend(dy, flip);
            DoubleVector low = hy.neg();
            DoubleVector side = low.blend(hy, odd);
            DoubleVector y0 = low.blend(side, ky).sub(before);
            DoubleVector y1 = low.blend(hy, kx).blend(side, ky).sub(before);
            DoubleVector y2 = hy.blend(low, kx).blend(side, ky).sub(before);
            DoubleVector y3 = hy.blend(side, ky).sub(before);

            DoubleVector after = dy.blend(dx, isX).blend(dz, isZ).blend(0, flip);
            DoubleVector a = nx.mul(x0);
            DoubleVector b = nx.mul(x1);
            DoubleVector c = nz.mul(z0);
            DoubleVector d = nz.mul(z1);
            a.add(ny.mul(y0)).add(c).add(after).intoArray(t, CORNER + i);
            b.add(ny.mul(y1)).add(c).add(after).intoArray(t, CORNER + POINT + i);
            a.add(ny.mul(y2)).add(d).add(after).intoArray(t, CORNER + 2 * POINT + i);
            b.add(ny.mul(y3)).add(d).add(after).intoArray(t, CORNER + 3 * POINT + i);

            after = dx.blend(dy, isX).blend(0, flip);
            DoubleVector rx = DoubleVector.fromArray(S, t, ROWS + 3 * CAPACITY + i);
            DoubleVector ry = DoubleVector.fromArray(S, t, ROWS + 4 * CAPACITY + i);
            DoubleVector rz = DoubleVector.fromArray(S, t, ROWS + 5 * CAPACITY + i);
            a = rx.mul(x0);
            b = rx.mul(x1);
            c = rz.mul(z0);
            d = rz.mul(z1);
            DoubleVector p0 = a.add(ry.mul(y0)).add(c).add(after);
            DoubleVector p1 = b.add(ry.mul(y1)).add(c).add(after);
            DoubleVector p2 = a.add(ry.mul(y2)).add(d).add(after);
            DoubleVector p3 = b.add(ry.mul(y3)).add(d).add(after);
            p0.intoArray(t, CORNER + CAPACITY + i);
            p1.intoArray(t, CORNER + POINT + CAPACITY + i);
            p2.intoArray(t, CORNER + 2 * POINT + CAPACITY + i);
            p3.intoArray(t, CORNER + 3 * POINT + CAPACITY + i);
            after = dz.blend(dy, isZ).blend(0, flip);
            rx = DoubleVector.fromArray(S, t, ROWS + 6 * CAPACITY + i);
            ry = DoubleVector.fromArray(S, t, ROWS + 7 * CAPACITY + i);
            rz = DoubleVector.fromArray(S, t, ROWS + 8 * CAPACITY + i);
            a = rx.mul(x0);
            b = rx.mul(x1);
            c = rz.mul(z0);
            d = rz.mul(z1);
            p0 = a.add(ry.mul(y0)).add(c).add(after);
            p1 = b.add(ry.mul(y1)).add(c).add(after);
            p2 = a.add(ry.mul(y2)).add(d).add(after);
            p3 = b.add(ry.mul(y3)).add(d).add(after);
            p0.intoArray(t, CORNER + 2 * CAPACITY + i);
            p1.intoArray(t, CORNER + POINT + 2 * CAPACITY + i);
            p2.intoArray(t, CORNER + 2 * POINT + 2 * CAPACITY + i);
            p3.intoArray(t, CORNER + 3 * POINT + 2 * CAPACITY + i);
        }
    }

    /** How far the outermost corners are beyond the sides on either of the two axes. */
    private static void outside(double[] t, int end, int corner, int half, int sides) {
        for (int i = 0; i < end; i += LANES) {
            DoubleVector p0 = DoubleVector.fromArray(S, t, corner + i);
            DoubleVector p1 = DoubleVector.fromArray(S, t, corner + POINT + i);
            DoubleVector p2 = DoubleVector.fromArray(S, t, corner + 2 * POINT + i);
            DoubleVector p3 = DoubleVector.fromArray(S, t, corner + 3 * POINT + i);
            DoubleVector limit = DoubleVector.fromArray(S, t, half + i);
            // Cheaper than max and min, which mind the signs of zeros.
            VectorMask<Double> up = p1.compare(VectorOperators.GT, p0);
            DoubleVector high = p0.blend(p1, up);
            DoubleVector below = p1.blend(p0, up);
            up = p3.compare(VectorOperators.GT, p2);
            DoubleVector high2 = p2.blend(p3, up);
            DoubleVector below2 = p3.blend(p2, up);
            high = high.blend(high2, high2.compare(VectorOperators.GT, high));
            below = below.blend(below2, below2.compare(VectorOperators.LT, below));
            high.sub(limit).intoArray(t, sides + i);
            below.neg().sub(limit).intoArray(t, sides + CAPACITY + i);
        }
    }

    private static void normals(double[] t, int end) {
        for (int i = 0; i < end; i += LANES) {
            VectorMask<Double> flip =
                    DoubleVector.fromArray(S, t, FLIP + i).compare(VectorOperators.GT, 0);
            DoubleVector axis = DoubleVector.fromArray(S, t, AXIS + i);
            DoubleVector sign = DoubleVector.fromArray(S, t, SIGN + i);
            DoubleVector zero = DoubleVector.zero(S);
            DoubleVector x = zero.blend(sign, axis.compare(VectorOperators.EQ, 0));
            DoubleVector y = zero.blend(sign, axis.compare(VectorOperators.EQ, 1));
            DoubleVector z = zero.blend(sign, axis.compare(VectorOperators.EQ, 2));
            sign = sign.neg();
            x = x.blend(sign.mul(DoubleVector.fromArray(S, t, ROWS + i)), flip);
            y = y.blend(sign.mul(DoubleVector.fromArray(S, t, ROWS + CAPACITY + i)), flip);
            z = z.blend(sign.mul(DoubleVector.fromArray(S, t, ROWS + 2 * CAPACITY + i)), flip);
            DoubleVector.fromArray(S, t, WORLD + i)
                    .mul(x)
                    .add(DoubleVector.fromArray(S, t, WORLD + CAPACITY + i).mul(y))
                    .add(DoubleVector.fromArray(S, t, WORLD + 2 * CAPACITY + i).mul(z))
                    .intoArray(t, NORMAL + i);
            DoubleVector.fromArray(S, t, WORLD + 3 * CAPACITY + i)
                    .mul(x)
                    .add(DoubleVector.fromArray(S, t, WORLD + 4 * CAPACITY + i).mul(y))
                    .add(DoubleVector.fromArray(S, t, WORLD + 5 * CAPACITY + i).mul(z))
                    .intoArray(t, NORMAL + CAPACITY + i);
            DoubleVector.fromArray(S, t, WORLD + 6 * CAPACITY + i)
                    .mul(x)
                    .add(DoubleVector.fromArray(S, t, WORLD + 7 * CAPACITY + i).mul(y))
                    .add(DoubleVector.fromArray(S, t, WORLD + 8 * CAPACITY + i).mul(z))
                    .intoArray(t, NORMAL + 2 * CAPACITY + i);
        }
    }

    private static void points(double[] t, int end) {
        for (int i = 0; i < end; i += LANES) {
            boolean aligned =
                    DoubleVector.fromArray(S, t, ALIGNED + i)
                            .compare(VectorOperators.GE, 0)
                            .allTrue();
            if (!aligned) {
                BoxAlignedWide.place(t, i);
            }
            int from = i + (aligned ? ALIGNED_POINT : CORNER);
            point(t, i, from, CORNER + i);
            point(t, i, from + POINT, CORNER + POINT + i);
            point(t, i, from + 2 * POINT, CORNER + 2 * POINT + i);
            point(t, i, from + 3 * POINT, CORNER + 3 * POINT + i);
        }
    }

    private static void point(double[] t, int i, int from, int to) {
        VectorMask<Double> flip =
                DoubleVector.fromArray(S, t, FLIP + i).compare(VectorOperators.GT, 0);
        DoubleVector axis = DoubleVector.fromArray(S, t, AXIS + i);
        VectorMask<Double> isX = axis.compare(VectorOperators.EQ, 0);
        VectorMask<Double> isZ = axis.compare(VectorOperators.EQ, 2);
        DoubleVector n = DoubleVector.fromArray(S, t, from);
        DoubleVector u = DoubleVector.fromArray(S, t, from + CAPACITY);
        DoubleVector v = DoubleVector.fromArray(S, t, from + 2 * CAPACITY);
        DoubleVector x = u.blend(n, isX);
        DoubleVector y = n.blend(u, isX).blend(v, isZ);
        DoubleVector z = v.blend(n, isZ);
        DoubleVector ax =
                DoubleVector.fromArray(S, t, RELATIVE + i)
                        .mul(x)
                        .add(DoubleVector.fromArray(S, t, RELATIVE + CAPACITY + i).mul(y))
                        .add(DoubleVector.fromArray(S, t, RELATIVE + 2 * CAPACITY + i).mul(z))
                        .add(DoubleVector.fromArray(S, t, CENTRE + i));
        DoubleVector ay =
                DoubleVector.fromArray(S, t, RELATIVE + 3 * CAPACITY + i)
                        .mul(x)
                        .add(DoubleVector.fromArray(S, t, RELATIVE + 4 * CAPACITY + i).mul(y))
                        .add(DoubleVector.fromArray(S, t, RELATIVE + 5 * CAPACITY + i).mul(z))
                        .add(DoubleVector.fromArray(S, t, CENTRE + CAPACITY + i));
        DoubleVector az =
                DoubleVector.fromArray(S, t, RELATIVE + 6 * CAPACITY + i)
                        .mul(x)
                        .add(DoubleVector.fromArray(S, t, RELATIVE + 7 * CAPACITY + i).mul(y))
                        .add(DoubleVector.fromArray(S, t, RELATIVE + 8 * CAPACITY + i).mul(z))
                        .add(DoubleVector.fromArray(S, t, CENTRE + 2 * CAPACITY + i));
        x = x.blend(ax, flip);
        y = y.blend(ay, flip);
        z = z.blend(az, flip);
        DoubleVector.fromArray(S, t, WORLD + i)
                .mul(x)
                .add(DoubleVector.fromArray(S, t, WORLD + CAPACITY + i).mul(y))
                .add(DoubleVector.fromArray(S, t, WORLD + 2 * CAPACITY + i).mul(z))
                .intoArray(t, to);
        DoubleVector.fromArray(S, t, WORLD + 3 * CAPACITY + i)
                .mul(x)
                .add(DoubleVector.fromArray(S, t, WORLD + 4 * CAPACITY + i).mul(y))
                .add(DoubleVector.fromArray(S, t, WORLD + 5 * CAPACITY + i).mul(z))
                .intoArray(t, to + CAPACITY);
        DoubleVector.fromArray(S, t, WORLD + 6 * CAPACITY + i)
                .mul(x)
                .add(DoubleVector.fromArray(S, t, WORLD + 7 * CAPACITY + i).mul(y))
                .add(DoubleVector.fromArray(S, t, WORLD + 8 * CAPACITY + i).mul(z))
                .intoArray(t, to + 2 * CAPACITY);
    }
}
