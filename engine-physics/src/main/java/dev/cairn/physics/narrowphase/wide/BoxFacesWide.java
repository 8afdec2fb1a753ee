package dev.cairn.physics.narrowphase.wide;

import static dev.cairn.physics.narrowphase.wide.BoxBatch.AXIS;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.CAPACITY;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.CENTRE;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.CORNER;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.FACE_A;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.FACE_B;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.FLIP;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.HALF;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.HALF_A;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.HALF_B;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.INCIDENT;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.INNER;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.KIND;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.LAST;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.MARGIN;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.NORMAL;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.OUTSIDE;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.POINT;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.RELATIVE;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.ROWS;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.SEPARATION;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.SEPARATION_A;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.SEPARATION_B;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.SEPARATION_FACES;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.SIGN;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.STRAIGHT;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.STRAIGHT_POINT;
import static dev.cairn.physics.narrowphase.wide.BoxBatch.WORLD;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * What has no branches in the face contacts of a batch of boxes, a pair to a lane: before clipping,
 * the corners of the incident faces; after it, the points in world axes. Its twin without the
 * Vector API is {@code narrowphase.BoxFaces}, with the same operations on each number.
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
            DoubleVector calm = DoubleVector.fromArray(S, t, INNER + i).mul(BoxBatch.CALM);
            VectorMask<Double> flip =
                    onB.compare(VectorOperators.GT, onA.add(calm.neg().blend(calm, beforeA)));
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
            for (int c = 0; c < 3; c++) {
                int column = RELATIVE + c * CAPACITY + i;
                int row = RELATIVE + 3 * c * CAPACITY + i;
                DoubleVector x =
                        DoubleVector.fromArray(S, t, column)
                                .blend(DoubleVector.fromArray(S, t, row), flip);
                DoubleVector y =
                        DoubleVector.fromArray(S, t, column + 3 * CAPACITY)
                                .blend(DoubleVector.fromArray(S, t, row + CAPACITY), flip);
                DoubleVector z =
                        DoubleVector.fromArray(S, t, column + 6 * CAPACITY)
                                .blend(DoubleVector.fromArray(S, t, row + 2 * CAPACITY), flip);
                y.blend(x, isX).blend(z, isZ).intoArray(t, ROWS + c * CAPACITY + i);
                x.blend(y, isX).intoArray(t, ROWS + (3 + c) * CAPACITY + i);
                z.blend(y, isZ).intoArray(t, ROWS + (6 + c) * CAPACITY + i);
            }
            DoubleVector x =
                    DoubleVector.fromArray(S, t, HALF_A + i)
                            .blend(DoubleVector.fromArray(S, t, HALF_B + i), flip);
            DoubleVector y =
                    DoubleVector.fromArray(S, t, HALF_A + CAPACITY + i)
                            .blend(DoubleVector.fromArray(S, t, HALF_B + CAPACITY + i), flip);
            DoubleVector z =
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

            for (int k = 1; k < 3; k++) {
                int row = ROWS + 3 * k * CAPACITY + i;
                int corner = CORNER + k * CAPACITY + i;
                after = (k == 1 ? dx.blend(dy, isX) : dz.blend(dy, isZ)).blend(0, flip);
                DoubleVector ry = DoubleVector.fromArray(S, t, row + CAPACITY);
                a = DoubleVector.fromArray(S, t, row).mul(x0);
                b = DoubleVector.fromArray(S, t, row).mul(x1);
                c = DoubleVector.fromArray(S, t, row + 2 * CAPACITY).mul(z0);
                d = DoubleVector.fromArray(S, t, row + 2 * CAPACITY).mul(z1);
                DoubleVector p0 = a.add(ry.mul(y0)).add(c).add(after);
                DoubleVector p1 = b.add(ry.mul(y1)).add(c).add(after);
                DoubleVector p2 = a.add(ry.mul(y2)).add(d).add(after);
                DoubleVector p3 = b.add(ry.mul(y3)).add(d).add(after);
                p0.intoArray(t, corner);
                p1.intoArray(t, corner + POINT);
                p2.intoArray(t, corner + 2 * POINT);
                p3.intoArray(t, corner + 3 * POINT);
                DoubleVector limit = DoubleVector.fromArray(S, t, HALF + k * CAPACITY + i);
                int sides = OUTSIDE + 2 * (k - 1) * CAPACITY + i;
                // Cheaper than max and min, which mind the signs of zeros.
                VectorMask<Double> up = p1.compare(VectorOperators.GT, p0);
                DoubleVector high = p0.blend(p1, up);
                DoubleVector below = p1.blend(p0, up);
                up = p3.compare(VectorOperators.GT, p2);
                DoubleVector high2 = p2.blend(p3, up);
                DoubleVector below2 = p3.blend(p2, up);
                high = high.blend(high2, high2.compare(VectorOperators.GT, high));
                below = below.blend(below2, below2.compare(VectorOperators.LT, below));
                high.sub(limit).intoArray(t, sides);
                below.neg().sub(limit).intoArray(t, sides + CAPACITY);
            }
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
            for (int k = 0; k < 3; k++) {
                int row = WORLD + 3 * k * CAPACITY + i;
                DoubleVector.fromArray(S, t, row)
                        .mul(x)
                        .add(DoubleVector.fromArray(S, t, row + CAPACITY).mul(y))
                        .add(DoubleVector.fromArray(S, t, row + 2 * CAPACITY).mul(z))
                        .intoArray(t, NORMAL + k * CAPACITY + i);
            }
        }
    }

    private static void points(double[] t, int end) {
        for (int i = 0; i < end; i += LANES) {
            VectorMask<Double> flip =
                    DoubleVector.fromArray(S, t, FLIP + i).compare(VectorOperators.GT, 0);
            DoubleVector axis = DoubleVector.fromArray(S, t, AXIS + i);
            VectorMask<Double> isX = axis.compare(VectorOperators.EQ, 0);
            VectorMask<Double> isZ = axis.compare(VectorOperators.EQ, 2);
            boolean straight =
                    DoubleVector.fromArray(S, t, STRAIGHT + i)
                            .compare(VectorOperators.GE, 0)
                            .allTrue();
            int from = straight ? STRAIGHT_POINT : CORNER;
            for (int p = i; p < 4 * POINT; p += POINT) {
                int at = CORNER + p;
                DoubleVector n = DoubleVector.fromArray(S, t, from + p);
                DoubleVector u = DoubleVector.fromArray(S, t, from + p + CAPACITY);
                DoubleVector v = DoubleVector.fromArray(S, t, from + p + 2 * CAPACITY);
                DoubleVector x = u.blend(n, isX);
                DoubleVector y = n.blend(u, isX).blend(v, isZ);
                DoubleVector z = v.blend(n, isZ);
                DoubleVector ax =
                        DoubleVector.fromArray(S, t, RELATIVE + i)
                                .mul(x)
                                .add(DoubleVector.fromArray(S, t, RELATIVE + CAPACITY + i).mul(y))
                                .add(
                                        DoubleVector.fromArray(S, t, RELATIVE + 2 * CAPACITY + i)
                                                .mul(z))
                                .add(DoubleVector.fromArray(S, t, CENTRE + i));
                DoubleVector ay =
                        DoubleVector.fromArray(S, t, RELATIVE + 3 * CAPACITY + i)
                                .mul(x)
                                .add(
                                        DoubleVector.fromArray(S, t, RELATIVE + 4 * CAPACITY + i)
                                                .mul(y))
                                .add(
                                        DoubleVector.fromArray(S, t, RELATIVE + 5 * CAPACITY + i)
                                                .mul(z))
                                .add(DoubleVector.fromArray(S, t, CENTRE + CAPACITY + i));
                DoubleVector az =
                        DoubleVector.fromArray(S, t, RELATIVE + 6 * CAPACITY + i)
                                .mul(x)
                                .add(
                                        DoubleVector.fromArray(S, t, RELATIVE + 7 * CAPACITY + i)
                                                .mul(y))
                                .add(
                                        DoubleVector.fromArray(S, t, RELATIVE + 8 * CAPACITY + i)
                                                .mul(z))
                                .add(DoubleVector.fromArray(S, t, CENTRE + 2 * CAPACITY + i));
                x = x.blend(ax, flip);
                y = y.blend(ay, flip);
                z = z.blend(az, flip);
                for (int k = 0; k < 3; k++) {
                    int row = WORLD + 3 * k * CAPACITY + i;
                    DoubleVector.fromArray(S, t, row)
                            .mul(x)
                            .add(DoubleVector.fromArray(S, t, row + CAPACITY).mul(y))
                            .add(DoubleVector.fromArray(S, t, row + 2 * CAPACITY).mul(z))
                            .intoArray(t, at + k * CAPACITY);
                }
            }
        }
    }
}
