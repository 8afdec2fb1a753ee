package dev.cairn.physics.solver.wide;

import static dev.cairn.physics.solver.body.SolverBodies.LOADED;
import static dev.cairn.physics.solver.row.ConstraintRows.*;
import static dev.cairn.physics.solver.row.Scratch.*;

import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.Scratch;
import dev.cairn.physics.solver.row.SubStep;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

import java.lang.invoke.MethodHandles;

/**
 * What the sweeps over normal impulses start from, in lanes: the arithmetic of {@link
 * ScalarNormals}, operation by operation.
 */
final class LaneNormals implements LaneKernels.Normals {
    private static final VectorSpecies<Double> S = LaneSpecies.doubles(MethodHandles.lookup());
    private static final int L = S.length();

    // the pack of a group, see Scratch
    private static final int GAIN = Scratch.GAIN_PACKED * L;
    private static final int GOAL = Scratch.GOAL_PACKED * L;

    @Override
    public void begin(ConstraintRows rows, int from, int to, double[] st, int g) {
        double[] d = rows.doubles;
        for (int j = from; j < to; j += L, g += L) {
            int points = rows.points[j / L];
            int o = START + j * FIELDS;
            var sum = DoubleVector.zero(S);
            for (int p = 0; p < points; p++) {
                int q = o + (POINT + p * POINT_FIELDS + IMPULSE) * L;
                sum = sum.add(DoubleVector.fromArray(S, d, q));
            }
            DoubleVector.zero(S)
                    .blend(1.0, sum.compare(VectorOperators.EQ, 0.0))
                    .intoArray(d, o + COLD * L);

            st[IDLE + g] = 0;
        }
    }

    @Override
    public void soften(
            ConstraintRows rows, int from, int to, double[] st, int g, SubStep sub, int marks) {
        double inverse = sub.inverse;
        double push = -sub.pushSpeed;
        double touch = /*(float)*/ sub.touch;
        double freeRate = sub.rate;
        double fixedRate = sub.fixedRate;
        double freeScale = sub.massScale;
        double fixedScale = sub.fixedMassScale;
        double[] d = rows.doubles;
        for (int j = from; j < to; j += L, g += L) {
            int points = rows.points[j / L];
            int o = START + j * FIELDS;
            int k = PACKED + g * PACK;
            var ma = DoubleVector.fromArray(S, st, VA + 7 * LINE + g);
            var mb = DoubleVector.fromArray(S, st, VB + 7 * LINE + g);
            var fixed = ma.compare(VectorOperators.EQ, 0.0).or(mb.compare(VectorOperators.EQ, 0.0));
            var rate = DoubleVector.broadcast(S, freeRate).blend(fixedRate, fixed);
            var scale = DoubleVector.broadcast(S, freeScale).blend(fixedScale, fixed);
            var rests = DoubleVector.fromArray(S, st, marks + g).compare(VectorOperators.EQ, 0.0);
            for (int p = 0; p < points; p++) {
                int q = o + (POINT + p * POINT_FIELDS) * L;
                var s = DoubleVector.fromArray(S, d, q + SEPARATION * L);
                var mass = DoubleVector.fromArray(S, d, q + MASS * L);
                var open = s.compare(VectorOperators.GT, touch);
                var b = s.mul(rate);
                b = b.blend(push, b.compare(VectorOperators.LT, push)).blend(s.mul(inverse), open);
                mass.mul(scale.blend(1.0, open)).blend(0.0, rests).intoArray(st, k + GAIN + p * L);
                mass.mul(b)
                        .neg()
                        .blend(DoubleVector.fromArray(S, d, q + IMPULSE * L), rests)
                        .intoArray(st, k + GOAL + p * L);
            }
        }
    }

    @Override
    public void harden(
            ConstraintRows rows, int from, int to, double[] st, int g, SubStep sub, int marks) {
        double inverse = sub.inverse;
        double touch = /*(float)*/ sub.touch;
        double closing = /*(float)*/ sub.closing;
        double[] d = rows.doubles;
        for (int j = from; j < to; j += L, g += L) {
            int points = rows.points[j / L];
            int o = START + j * FIELDS;
            int k = PACKED + g * PACK;
            var rests = DoubleVector.fromArray(S, st, marks + g).compare(VectorOperators.EQ, 0.0);
            for (int p = 0; p < points; p++) {
                int q = o + (POINT + p * POINT_FIELDS) * L;
                var s = DoubleVector.fromArray(S, d, q + SEPARATION * L);
                var mass = DoubleVector.fromArray(S, d, q + MASS * L);
                var impulse = DoubleVector.fromArray(S, d, q + IMPULSE * L);
                var open = s.compare(VectorOperators.GT, touch);
                var stays = rests.or(open.and(impulse.compare(VectorOperators.EQ, 0.0)));
                var b = DoubleVector.broadcast(S, closing).blend(s.mul(inverse), open);
                mass.blend(0.0, stays).intoArray(st, k + GAIN + p * L);
                mass.mul(b).neg().blend(impulse, stays).intoArray(st, k + GOAL + p * L);
            }
        }
    }

    @Override
    public boolean separate(
            ConstraintRows rows, int from, int to, double[] st, int g, SubStep sub) {
        double touch = /*(float)*/ sub.touch;
        boolean any = false;
        double[] d = rows.doubles;
        for (int j = from; j < to; j += L, g += L) {
            int points = rows.points[j / L];
            int o = START + j * FIELDS;
            var moved =
                    DoubleVector.fromArray(S, d, o)
                            .mul(
                                    DoubleVector.fromArray(S, st, PB + g)
                                            .sub(DoubleVector.fromArray(S, st, PA + g)));
            for (int i = 1; i < 3; i++) {
                var along =
                        DoubleVector.fromArray(S, st, PB + i * LINE + g)
                                .sub(DoubleVector.fromArray(S, st, PA + i * LINE + g));
                moved = moved.add(DoubleVector.fromArray(S, d, o + i * L).mul(along));
            }
            // a mask that is carried round a loop would be an object; a number above 0 says the
            // same
            var busy = DoubleVector.zero(S);
            var ax = DoubleVector.fromArray(S, st, PA + 3 * LINE + g);
            var ay = DoubleVector.fromArray(S, st, PA + 4 * LINE + g);
            var az = DoubleVector.fromArray(S, st, PA + 5 * LINE + g);
            var bx = DoubleVector.fromArray(S, st, PB + 3 * LINE + g);
            var by = DoubleVector.fromArray(S, st, PB + 4 * LINE + g);
            var bz = DoubleVector.fromArray(S, st, PB + 5 * LINE + g);
            for (int p = 0; p < points; p++) {
                int q = o + (POINT + p * POINT_FIELDS) * L;
                int w = q + ARM_B * L;
                var turnA =
                        DoubleVector.fromArray(S, d, q)
                                .mul(ax)
                                .add(DoubleVector.fromArray(S, d, q + L).mul(ay))
                                .add(DoubleVector.fromArray(S, d, q + 2 * L).mul(az));
                var turnB =
                        DoubleVector.fromArray(S, d, w)
                                .mul(bx)
                                .add(DoubleVector.fromArray(S, d, w + L).mul(by))
                                .add(DoubleVector.fromArray(S, d, w + 2 * L).mul(bz));
                var s =
                        moved.add(DoubleVector.fromArray(S, d, o + (GAP + p) * L))
                                .add(turnB)
                                .sub(turnA);
                s.intoArray(d, q + SEPARATION * L);
                // a point that is not there has no mass
                var open =
                        s.compare(VectorOperators.GT, touch)
                                .and(
                                        DoubleVector.fromArray(S, d, q + IMPULSE * L)
                                                .compare(VectorOperators.EQ, 0.0));
                busy = busy.add(DoubleVector.fromArray(S, d, q + MASS * L).blend(0.0, open));
            }
            // friction of a lane whose points have all opened goes to zero first
            int l = o + LAMBDA * L;
            var last =
                    DoubleVector.fromArray(S, d, l)
                            .abs()
                            .add(DoubleVector.fromArray(S, d, l + L).abs())
                            .add(DoubleVector.fromArray(S, d, l + 2 * L).abs());
            boolean idle = busy.add(last).compare(VectorOperators.EQ, 0.0).allTrue();
            st[IDLE + g] = idle ? 1 : 0;
            any |= !idle;
        }
        return any;
    }

    @Override
    public void load(ConstraintRows rows, int from, int to, double[] st, int g) {
        double[] d = rows.doubles;
        for (int j = from; j < to; j += L, g += L) {
            int points = rows.points[j / L];
            int o = START + j * FIELDS;
            var sum = DoubleVector.zero(S);
            for (int p = 0; p < points; p++) {
                int q = o + (POINT + p * POINT_FIELDS + IMPULSE) * L;
                sum = sum.add(DoubleVector.fromArray(S, d, q));
            }
            var presses = sum.compare(VectorOperators.GT, 0.0);
            int a = VA + LOADED * LINE + g;
            int b = VB + LOADED * LINE + g;
            DoubleVector.fromArray(S, st, a).blend(1.0, presses).intoArray(st, a);
            DoubleVector.fromArray(S, st, b).blend(1.0, presses).intoArray(st, b);
        }
    }
}
