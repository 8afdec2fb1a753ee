package dev.cairn.physics.solver.wide;

import static dev.cairn.physics.solver.row.ConstraintRows.ARM_B;
import static dev.cairn.physics.solver.row.ConstraintRows.COLD;
import static dev.cairn.physics.solver.row.ConstraintRows.IMPULSE;
import static dev.cairn.physics.solver.row.ConstraintRows.POINT;
import static dev.cairn.physics.solver.row.ConstraintRows.POINT_FIELDS;
import static dev.cairn.physics.solver.row.Scratch.LANDS;
import static dev.cairn.physics.solver.row.Scratch.LINE;
import static dev.cairn.physics.solver.row.Scratch.VA;
import static dev.cairn.physics.solver.row.Scratch.VB;

import dev.cairn.physics.solver.kernel.CommonStep;
import dev.cairn.physics.solver.kernel.ScalarNormals;
import dev.cairn.physics.solver.row.Scratch;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

import java.lang.invoke.MethodHandles;

/**
 * Sweeps over one or two points in lanes: the arithmetic of {@link ScalarNormals}, operation by
 * operation.
 */
final class LaneFew implements LaneKernels.Points {
    private static final VectorSpecies<Double> S = LaneSpecies.doubles(MethodHandles.lookup());
    private static final int L = S.length();

    // the pack of a group, see Scratch
    private static final int GAIN = Scratch.GAIN_PACKED * L;
    private static final int GOAL = Scratch.GOAL_PACKED * L;
    private static final int SPEED = Scratch.SPEED_PACKED * L;
    private static final int CHANGE = Scratch.CHANGE_PACKED * L;
    private static final int COUPLING = Scratch.COUPLING_PACKED * L;
    private static final int OWN = Scratch.OWN_PACKED * L;
    private static final int FIRST = Scratch.FIRST_PACKED * L;

    @Override
    public boolean sweep(
            double[] d, int o, double[] st, int k, int g, int points, int sweeps, int step) {
        speeds(d, o, st, k, g, points);
        boolean lands;
        if (points == 2) {
            couplings(d, o, st, k, g, points);
            if (!evenTwo(d, o, st, k, step) && step == CommonStep.SOFT) {
                DoubleVector.zero(S).intoArray(st, LANDS + g);
                return false;
            }
            lands = two(d, o, st, k, g, sweeps);
        } else {
            lands = one(d, o, st, k, g, sweeps);
        }
        push(d, o, st, k, g, points);
        turn(d, o, st, k, g, points);
        return lands;
    }

    /** Speeds of separation, less what the own impulses make of them. */
    private static void speeds(double[] d, int o, double[] st, int k, int g, int points) {
        var sum =
                DoubleVector.fromArray(S, st, VA + 7 * LINE + g)
                        .add(DoubleVector.fromArray(S, st, VB + 7 * LINE + g));
        var vn =
                DoubleVector.fromArray(S, d, o)
                        .mul(
                                DoubleVector.fromArray(S, st, VB + g)
                                        .sub(DoubleVector.fromArray(S, st, VA + g)));
        for (int i = 1; i < 3; i++) {
            var along =
                    DoubleVector.fromArray(S, st, VB + i * LINE + g)
                            .sub(DoubleVector.fromArray(S, st, VA + i * LINE + g));
            vn = vn.add(DoubleVector.fromArray(S, d, o + i * L).mul(along));
        }
        var ax = DoubleVector.fromArray(S, st, VA + 3 * LINE + g);
        var ay = DoubleVector.fromArray(S, st, VA + 4 * LINE + g);
        var az = DoubleVector.fromArray(S, st, VA + 5 * LINE + g);
        var bx = DoubleVector.fromArray(S, st, VB + 3 * LINE + g);
        var by = DoubleVector.fromArray(S, st, VB + 4 * LINE + g);
        var bz = DoubleVector.fromArray(S, st, VB + 5 * LINE + g);
        for (int p = 0; p < points; p++) {
            int q = o + (POINT + p * POINT_FIELDS) * L;
            var ux = DoubleVector.fromArray(S, d, q);
            var uy = DoubleVector.fromArray(S, d, q + L);
            var uz = DoubleVector.fromArray(S, d, q + 2 * L);
            var wx = DoubleVector.fromArray(S, d, q + ARM_B * L);
            var wy = DoubleVector.fromArray(S, d, q + (ARM_B + 1) * L);
            var wz = DoubleVector.fromArray(S, d, q + (ARM_B + 2) * L);
            var squareA = ux.mul(ux).add(uy.mul(uy)).add(uz.mul(uz));
            var squareB = wx.mul(wx).add(wy.mul(wy)).add(wz.mul(wz));
            var own = sum.add(squareA.add(squareB));
            own.intoArray(st, k + OWN + p * L);
            vn.add(wx.mul(bx).add(wy.mul(by)).add(wz.mul(bz)))
                    .sub(ux.mul(ax).add(uy.mul(ay)).add(uz.mul(az)))
                    .sub(own.mul(DoubleVector.fromArray(S, d, q + IMPULSE * L)))
                    .intoArray(st, k + SPEED + p * L);
        }
    }

    /** What an impulse at one point makes of the speed at another. */
    private static void couplings(double[] d, int o, double[] st, int k, int g, int points) {
        var sum =
                DoubleVector.fromArray(S, st, VA + 7 * LINE + g)
                        .add(DoubleVector.fromArray(S, st, VB + 7 * LINE + g));
        int out = k + COUPLING;
        for (int p = 1; p < points; p++) {
            int q = o + (POINT + p * POINT_FIELDS) * L;
            var ux = DoubleVector.fromArray(S, d, q);
            var uy = DoubleVector.fromArray(S, d, q + L);
            var uz = DoubleVector.fromArray(S, d, q + 2 * L);
            var wx = DoubleVector.fromArray(S, d, q + ARM_B * L);
            var wy = DoubleVector.fromArray(S, d, q + (ARM_B + 1) * L);
            var wz = DoubleVector.fromArray(S, d, q + (ARM_B + 2) * L);
            for (int r = 0; r < p; r++) {
                int i = o + (POINT + r * POINT_FIELDS) * L;
                var dotA =
                        ux.mul(DoubleVector.fromArray(S, d, i))
                                .add(uy.mul(DoubleVector.fromArray(S, d, i + L)))
                                .add(uz.mul(DoubleVector.fromArray(S, d, i + 2 * L)));
                i += ARM_B * L;
                var dotB =
                        wx.mul(DoubleVector.fromArray(S, d, i))
                                .add(wy.mul(DoubleVector.fromArray(S, d, i + L)))
                                .add(wz.mul(DoubleVector.fromArray(S, d, i + 2 * L)));
                sum.add(dotA.add(dotB)).intoArray(st, out);
                out += L;
            }
        }
    }

    /** The same for two. */
    private static boolean evenTwo(double[] d, int o, double[] st, int k, int step) {
        int q = o + (POINT + IMPULSE) * L;
        int next = POINT_FIELDS * L;
        var zero = DoubleVector.zero(S);
        var f0 = DoubleVector.fromArray(S, d, q);
        var f1 = DoubleVector.fromArray(S, d, q + next);
        if (step == CommonStep.NONE) {
            f0.intoArray(st, k + FIRST);
            f1.intoArray(st, k + FIRST + L);
            return true;
        }
        var begins =
                (step == CommonStep.SOFT ? DoubleVector.fromArray(S, d, o + COLD * L) : zero)
                        .compare(VectorOperators.GT, 0.0);
        var least = DoubleVector.broadcast(S, Double.MAX_VALUE);
        var own0 = DoubleVector.fromArray(S, st, k + OWN);
        var gain0 = DoubleVector.fromArray(S, st, k + GAIN);
        var t0 =
                DoubleVector.fromArray(S, st, k + GOAL)
                        .sub(gain0.mul(DoubleVector.fromArray(S, st, k + SPEED)));
        var on0 =
                f0.compare(VectorOperators.GT, 0.0)
                        .or(begins.and(t0.compare(VectorOperators.GT, 0.0)));
        var a0 = zero.blend(1.0, on0);
        var k0 = gain0.mul(own0);
        var miss0 = zero.blend(f0.sub(t0).mul(own0), on0);
        least = least.blend(f0, on0.and(f0.compare(VectorOperators.LT, least)));
        var own1 = DoubleVector.fromArray(S, st, k + OWN + L);
        var gain1 = DoubleVector.fromArray(S, st, k + GAIN + L);
        var t1 =
                DoubleVector.fromArray(S, st, k + GOAL + L)
                        .sub(gain1.mul(DoubleVector.fromArray(S, st, k + SPEED + L)));
        var on1 =
                f1.compare(VectorOperators.GT, 0.0)
                        .or(begins.and(t1.compare(VectorOperators.GT, 0.0)));
        var a1 = zero.blend(1.0, on1);
        var k1 = gain1.mul(own1);
        var miss1 = zero.blend(f1.sub(t1).mul(own1), on1);
        least = least.blend(f1, on1.and(f1.compare(VectorOperators.LT, least)));
        var n = a0.add(a1);
        var miss = miss0.add(miss1);
        var scale = a0.mul(k0).add(a1.mul(k1));
        var give0 = DoubleVector.broadcast(S, 1.0).sub(k0).mul(own0);
        var give1 = DoubleVector.broadcast(S, 1.0).sub(k1).mul(own1);
        var give = a0.mul(give0).add(a1.mul(give1));
        var response = a0.mul(own0);
        response =
                response.add(
                        a1.mul(
                                own1.add(
                                        a0.mul(DoubleVector.fromArray(S, st, k + COUPLING))
                                                .mul(2.0))));
        var delta = miss.neg().div(response.mul(scale.div(n)).add(give));
        var floor = least.neg().blend(0.0, begins);
        delta = delta.blend(floor, delta.compare(VectorOperators.LT, floor));
        delta = zero.blend(delta, n.compare(VectorOperators.GT, 1.0));
        f0.add(delta.mul(a0)).intoArray(st, k + FIRST);
        f1.add(delta.mul(a1)).intoArray(st, k + FIRST + L);
        return n.compare(VectorOperators.GT, 0.0).anyTrue();
    }

    /** The same for two. */
    private static boolean two(double[] d, int o, double[] st, int k, int g, int sweeps) {
        int q = o + (POINT + IMPULSE) * L;
        int next = POINT_FIELDS * L;
        var f0 = DoubleVector.fromArray(S, d, q);
        var f1 = DoubleVector.fromArray(S, d, q + next);
        var k01 = DoubleVector.fromArray(S, st, k + COUPLING);
        var gain0 = DoubleVector.fromArray(S, st, k + GAIN);
        var gain1 = DoubleVector.fromArray(S, st, k + GAIN + L);
        var goal0 =
                DoubleVector.fromArray(S, st, k + GOAL)
                        .sub(gain0.mul(DoubleVector.fromArray(S, st, k + SPEED).sub(k01.mul(f1))));
        var goal1 =
                DoubleVector.fromArray(S, st, k + GOAL + L)
                        .sub(
                                gain1.mul(
                                        DoubleVector.fromArray(S, st, k + SPEED + L)
                                                .sub(k01.mul(f0))));
        var g01 = gain0.mul(k01);
        var g10 = gain1.mul(k01);
        f0 = DoubleVector.fromArray(S, st, k + FIRST);
        f1 = DoubleVector.fromArray(S, st, k + FIRST + L);
        var zero = DoubleVector.zero(S);
        var moved = zero;
        for (int sweep = 0; sweep < sweeps; sweep++) {
            var e0 = goal0.sub(g01.mul(f1));
            e0 = zero.blend(e0, e0.compare(VectorOperators.GT, 0.0));
            var c0 = e0.sub(f0);
            f0 = e0;
            var e1 = goal1.sub(g10.mul(f0));
            e1 = zero.blend(e1, e1.compare(VectorOperators.GT, 0.0));
            var c1 = e1.sub(f1);
            f1 = e1;
            moved = c0.abs().add(c1.abs());
            if (!moved.compare(VectorOperators.GT, 0.0).anyTrue()) {
                break;
            }
        }
        f0.sub(DoubleVector.fromArray(S, d, q)).intoArray(st, k + CHANGE);
        f0.intoArray(d, q);
        f1.sub(DoubleVector.fromArray(S, d, q + next)).intoArray(st, k + CHANGE + L);
        f1.intoArray(d, q + next);
        moved.intoArray(st, LANDS + g);
        return lands(d, o, st, g);
    }

    /** One point is right after its first sweep; a second one finds nothing to do. */
    private static boolean one(double[] d, int o, double[] st, int k, int g, int sweeps) {
        int q = o + (POINT + IMPULSE) * L;
        var old = DoubleVector.fromArray(S, d, q);
        var f =
                DoubleVector.fromArray(S, st, k + GOAL)
                        .sub(
                                DoubleVector.fromArray(S, st, k + GAIN)
                                        .mul(DoubleVector.fromArray(S, st, k + SPEED)));
        f = DoubleVector.zero(S).blend(f, f.compare(VectorOperators.GT, 0.0));
        f.intoArray(d, q);
        f.sub(old).intoArray(st, k + CHANGE);
        if (sweeps > 1) {
            DoubleVector.zero(S).intoArray(st, LANDS + g);
            return false;
        }
        f.sub(old).abs().intoArray(st, LANDS + g);
        return lands(d, o, st, g);
    }

    /** Velocities that the changes of the impulses make. */
    private static void push(double[] d, int o, double[] st, int k, int g, int points) {
        var change = DoubleVector.zero(S);
        for (int p = 0; p < points; p++) {
            change = change.add(DoubleVector.fromArray(S, st, k + CHANGE + p * L));
        }
        var ka = change.mul(DoubleVector.fromArray(S, st, VA + 7 * LINE + g));
        var kb = change.mul(DoubleVector.fromArray(S, st, VB + 7 * LINE + g));
        for (int i = 0; i < 3; i++) {
            var n = DoubleVector.fromArray(S, d, o + i * L);
            int a = VA + i * LINE + g;
            int b = VB + i * LINE + g;
            DoubleVector.fromArray(S, st, a).sub(ka.mul(n)).add(0.0).intoArray(st, a);
            DoubleVector.fromArray(S, st, b).add(kb.mul(n)).add(0.0).intoArray(st, b);
        }
    }

    /** Weighted angular velocities that they make. */
    private static void turn(double[] d, int o, double[] st, int k, int g, int points) {
        int a = VA + 3 * LINE + g;
        int b = VB + 3 * LINE + g;
        var ax = DoubleVector.fromArray(S, st, a);
        var ay = DoubleVector.fromArray(S, st, a + LINE);
        var az = DoubleVector.fromArray(S, st, a + 2 * LINE);
        var bx = DoubleVector.fromArray(S, st, b);
        var by = DoubleVector.fromArray(S, st, b + LINE);
        var bz = DoubleVector.fromArray(S, st, b + 2 * LINE);
        for (int p = 0; p < points; p++) {
            int q = o + (POINT + p * POINT_FIELDS) * L;
            int w = q + ARM_B * L;
            var change = DoubleVector.fromArray(S, st, k + CHANGE + p * L);
            ax = ax.sub(change.mul(DoubleVector.fromArray(S, d, q)));
            ay = ay.sub(change.mul(DoubleVector.fromArray(S, d, q + L)));
            az = az.sub(change.mul(DoubleVector.fromArray(S, d, q + 2 * L)));
            bx = bx.add(change.mul(DoubleVector.fromArray(S, d, w)));
            by = by.add(change.mul(DoubleVector.fromArray(S, d, w + L)));
            bz = bz.add(change.mul(DoubleVector.fromArray(S, d, w + 2 * L)));
        }
        ax.add(0.0).intoArray(st, a);
        ay.add(0.0).intoArray(st, a + LINE);
        az.add(0.0).intoArray(st, a + 2 * LINE);
        bx.add(0.0).intoArray(st, b);
        by.add(0.0).intoArray(st, b + LINE);
        bz.add(0.0).intoArray(st, b + 2 * LINE);
    }

    /** Marks the lanes that have had no warm start and have moved. */
    private static boolean lands(double[] d, int o, double[] st, int g) {
        var lands =
                DoubleVector.fromArray(S, d, o + COLD * L)
                        .compare(VectorOperators.GT, 0.0)
                        .and(
                                DoubleVector.fromArray(S, st, LANDS + g)
                                        .compare(VectorOperators.GT, 0.0));
        DoubleVector.zero(S).blend(1.0, lands).intoArray(st, LANDS + g);
        return lands.anyTrue();
    }
}
