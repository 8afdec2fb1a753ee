package dev.cairn.physics.solver.wide;

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
 * Sweeps over three or four points in lanes: the arithmetic of {@link ScalarNormals}, operation by
 * operation. All is written out, so that a sweep goes over numbers in registers: short loops over
 * the points took twice the time.
 */
final class LaneFour implements LaneKernels.Points {
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
        enterFour(d, o, st, k, g);
        if (!evenFour(d, o, st, k, step) && step == CommonStep.SOFT) {
            DoubleVector.zero(S).intoArray(st, LANDS + g);
            return false;
        }
        boolean lands = sweepFour(d, o, st, k, g, sweeps);
        leaveFour(d, o, st, k, g);
        return lands;
    }

    /**
     * Speeds of separation without the own impulses, and what an impulse at one point makes of the
     * speed at another; for four points, written out.
     */
    private static void enterFour(double[] d, int o, double[] st, int k, int g) {
        var sum =
                DoubleVector.fromArray(S, st, VA + 7 * LINE + g)
                        .add(DoubleVector.fromArray(S, st, VB + 7 * LINE + g));
        var vx = DoubleVector.fromArray(S, st, VB + g).sub(DoubleVector.fromArray(S, st, VA + g));
        var vy =
                DoubleVector.fromArray(S, st, VB + LINE + g)
                        .sub(DoubleVector.fromArray(S, st, VA + LINE + g));
        var vz =
                DoubleVector.fromArray(S, st, VB + 2 * LINE + g)
                        .sub(DoubleVector.fromArray(S, st, VA + 2 * LINE + g));
        var ax = DoubleVector.fromArray(S, st, VA + 3 * LINE + g);
        var ay = DoubleVector.fromArray(S, st, VA + 4 * LINE + g);
        var az = DoubleVector.fromArray(S, st, VA + 5 * LINE + g);
        var bx = DoubleVector.fromArray(S, st, VB + 3 * LINE + g);
        var by = DoubleVector.fromArray(S, st, VB + 4 * LINE + g);
        var bz = DoubleVector.fromArray(S, st, VB + 5 * LINE + g);
        var vn =
                DoubleVector.fromArray(S, d, o)
                        .mul(vx)
                        .add(DoubleVector.fromArray(S, d, o + L).mul(vy))
                        .add(DoubleVector.fromArray(S, d, o + 2 * L).mul(vz));
        int q = o + POINT * L;
        int next = POINT_FIELDS * L;
        var ux0 = DoubleVector.fromArray(S, d, q);
        var uy0 = DoubleVector.fromArray(S, d, q + L);
        var uz0 = DoubleVector.fromArray(S, d, q + 2 * L);
        var wx0 = DoubleVector.fromArray(S, d, q + 3 * L);
        var wy0 = DoubleVector.fromArray(S, d, q + 4 * L);
        var wz0 = DoubleVector.fromArray(S, d, q + 5 * L);
        var own0 =
                sum.add(
                        ux0.mul(ux0)
                                .add(uy0.mul(uy0))
                                .add(uz0.mul(uz0))
                                .add(wx0.mul(wx0).add(wy0.mul(wy0)).add(wz0.mul(wz0))));
        own0.intoArray(st, k + OWN);
        vn.add(wx0.mul(bx).add(wy0.mul(by)).add(wz0.mul(bz)))
                .sub(ux0.mul(ax).add(uy0.mul(ay)).add(uz0.mul(az)))
                .sub(own0.mul(DoubleVector.fromArray(S, d, q + IMPULSE * L)))
                .intoArray(st, k + SPEED);
        var ux1 = DoubleVector.fromArray(S, d, q + next);
        var uy1 = DoubleVector.fromArray(S, d, q + next + L);
        var uz1 = DoubleVector.fromArray(S, d, q + next + 2 * L);
        var wx1 = DoubleVector.fromArray(S, d, q + next + 3 * L);
        var wy1 = DoubleVector.fromArray(S, d, q + next + 4 * L);
        var wz1 = DoubleVector.fromArray(S, d, q + next + 5 * L);
        var own1 =
                sum.add(
                        ux1.mul(ux1)
                                .add(uy1.mul(uy1))
                                .add(uz1.mul(uz1))
                                .add(wx1.mul(wx1).add(wy1.mul(wy1)).add(wz1.mul(wz1))));
        own1.intoArray(st, k + OWN + L);
        vn.add(wx1.mul(bx).add(wy1.mul(by)).add(wz1.mul(bz)))
                .sub(ux1.mul(ax).add(uy1.mul(ay)).add(uz1.mul(az)))
                .sub(own1.mul(DoubleVector.fromArray(S, d, q + next + IMPULSE * L)))
                .intoArray(st, k + SPEED + L);
        sum.add(
                        ux1.mul(ux0)
                                .add(uy1.mul(uy0))
                                .add(uz1.mul(uz0))
                                .add(wx1.mul(wx0).add(wy1.mul(wy0)).add(wz1.mul(wz0))))
                .intoArray(st, k + COUPLING);
        var ux2 = DoubleVector.fromArray(S, d, q + 2 * next);
        var uy2 = DoubleVector.fromArray(S, d, q + 2 * next + L);
        var uz2 = DoubleVector.fromArray(S, d, q + 2 * next + 2 * L);
        var wx2 = DoubleVector.fromArray(S, d, q + 2 * next + 3 * L);
        var wy2 = DoubleVector.fromArray(S, d, q + 2 * next + 4 * L);
        var wz2 = DoubleVector.fromArray(S, d, q + 2 * next + 5 * L);
        var own2 =
                sum.add(
                        ux2.mul(ux2)
                                .add(uy2.mul(uy2))
                                .add(uz2.mul(uz2))
                                .add(wx2.mul(wx2).add(wy2.mul(wy2)).add(wz2.mul(wz2))));
        own2.intoArray(st, k + OWN + 2 * L);
        vn.add(wx2.mul(bx).add(wy2.mul(by)).add(wz2.mul(bz)))
                .sub(ux2.mul(ax).add(uy2.mul(ay)).add(uz2.mul(az)))
                .sub(own2.mul(DoubleVector.fromArray(S, d, q + 2 * next + IMPULSE * L)))
                .intoArray(st, k + SPEED + 2 * L);
        sum.add(
                        ux2.mul(ux0)
                                .add(uy2.mul(uy0))
                                .add(uz2.mul(uz0))
                                .add(wx2.mul(wx0).add(wy2.mul(wy0)).add(wz2.mul(wz0))))
                .intoArray(st, k + COUPLING + L);
        sum.add(
                        ux2.mul(ux1)
                                .add(uy2.mul(uy1))
                                .add(uz2.mul(uz1))
                                .add(wx2.mul(wx1).add(wy2.mul(wy1)).add(wz2.mul(wz1))))
                .intoArray(st, k + COUPLING + 2 * L);
        var ux3 = DoubleVector.fromArray(S, d, q + 3 * next);
        var uy3 = DoubleVector.fromArray(S, d, q + 3 * next + L);
        var uz3 = DoubleVector.fromArray(S, d, q + 3 * next + 2 * L);
        var wx3 = DoubleVector.fromArray(S, d, q + 3 * next + 3 * L);
        var wy3 = DoubleVector.fromArray(S, d, q + 3 * next + 4 * L);
        var wz3 = DoubleVector.fromArray(S, d, q + 3 * next + 5 * L);
        var own3 =
                sum.add(
                        ux3.mul(ux3)
                                .add(uy3.mul(uy3))
                                .add(uz3.mul(uz3))
                                .add(wx3.mul(wx3).add(wy3.mul(wy3)).add(wz3.mul(wz3))));
        own3.intoArray(st, k + OWN + 3 * L);
        vn.add(wx3.mul(bx).add(wy3.mul(by)).add(wz3.mul(bz)))
                .sub(ux3.mul(ax).add(uy3.mul(ay)).add(uz3.mul(az)))
                .sub(own3.mul(DoubleVector.fromArray(S, d, q + 3 * next + IMPULSE * L)))
                .intoArray(st, k + SPEED + 3 * L);
        sum.add(
                        ux3.mul(ux0)
                                .add(uy3.mul(uy0))
                                .add(uz3.mul(uz0))
                                .add(wx3.mul(wx0).add(wy3.mul(wy0)).add(wz3.mul(wz0))))
                .intoArray(st, k + COUPLING + 3 * L);
        sum.add(
                        ux3.mul(ux1)
                                .add(uy3.mul(uy1))
                                .add(uz3.mul(uz1))
                                .add(wx3.mul(wx1).add(wy3.mul(wy1)).add(wz3.mul(wz1))))
                .intoArray(st, k + COUPLING + 4 * L);
        sum.add(
                        ux3.mul(ux2)
                                .add(uy3.mul(uy2))
                                .add(uz3.mul(uz2))
                                .add(wx3.mul(wx2).add(wy3.mul(wy2)).add(wz3.mul(wz2))))
                .intoArray(st, k + COUPLING + 5 * L);
    }

    /**
     * The impulses that the sweeps start with: the same change at all points that press, or begin
     * to, see {@link ScalarNormals}.
     *
     * @return whether a point of the group presses or closes
     */
    private static boolean evenFour(double[] d, int o, double[] st, int k, int step) {
        int q = o + (POINT + IMPULSE) * L;
        int next = POINT_FIELDS * L;
        var zero = DoubleVector.zero(S);
        var f0 = DoubleVector.fromArray(S, d, q);
        var f1 = DoubleVector.fromArray(S, d, q + next);
        var f2 = DoubleVector.fromArray(S, d, q + 2 * next);
        var f3 = DoubleVector.fromArray(S, d, q + 3 * next);
        if (step == CommonStep.NONE) {
            f0.intoArray(st, k + FIRST);
            f1.intoArray(st, k + FIRST + L);
            f2.intoArray(st, k + FIRST + 2 * L);
            f3.intoArray(st, k + FIRST + 3 * L);
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
        var own2 = DoubleVector.fromArray(S, st, k + OWN + 2 * L);
        var gain2 = DoubleVector.fromArray(S, st, k + GAIN + 2 * L);
        var t2 =
                DoubleVector.fromArray(S, st, k + GOAL + 2 * L)
                        .sub(gain2.mul(DoubleVector.fromArray(S, st, k + SPEED + 2 * L)));
        var on2 =
                f2.compare(VectorOperators.GT, 0.0)
                        .or(begins.and(t2.compare(VectorOperators.GT, 0.0)));
        var a2 = zero.blend(1.0, on2);
        var k2 = gain2.mul(own2);
        var miss2 = zero.blend(f2.sub(t2).mul(own2), on2);
        least = least.blend(f2, on2.and(f2.compare(VectorOperators.LT, least)));
        var own3 = DoubleVector.fromArray(S, st, k + OWN + 3 * L);
        var gain3 = DoubleVector.fromArray(S, st, k + GAIN + 3 * L);
        var t3 =
                DoubleVector.fromArray(S, st, k + GOAL + 3 * L)
                        .sub(gain3.mul(DoubleVector.fromArray(S, st, k + SPEED + 3 * L)));
        var on3 =
                f3.compare(VectorOperators.GT, 0.0)
                        .or(begins.and(t3.compare(VectorOperators.GT, 0.0)));
        var a3 = zero.blend(1.0, on3);
        var k3 = gain3.mul(own3);
        var miss3 = zero.blend(f3.sub(t3).mul(own3), on3);
        least = least.blend(f3, on3.and(f3.compare(VectorOperators.LT, least)));
        var n = a0.add(a1).add(a2).add(a3);
        var miss = miss0.add(miss1).add(miss2).add(miss3);
        var scale = a0.mul(k0).add(a1.mul(k1)).add(a2.mul(k2)).add(a3.mul(k3));
        var give0 = DoubleVector.broadcast(S, 1.0).sub(k0).mul(own0);
        var give1 = DoubleVector.broadcast(S, 1.0).sub(k1).mul(own1);
        var give2 = DoubleVector.broadcast(S, 1.0).sub(k2).mul(own2);
        var give3 = DoubleVector.broadcast(S, 1.0).sub(k3).mul(own3);
        var give = a0.mul(give0).add(a1.mul(give1)).add(a2.mul(give2)).add(a3.mul(give3));
        var response = a0.mul(own0);
        response =
                response.add(
                        a1.mul(
                                own1.add(
                                        a0.mul(DoubleVector.fromArray(S, st, k + COUPLING))
                                                .mul(2.0))));
        response =
                response.add(
                        a2.mul(
                                own2.add(
                                        a0.mul(DoubleVector.fromArray(S, st, k + COUPLING + L))
                                                .add(
                                                        a1.mul(
                                                                DoubleVector.fromArray(
                                                                        S,
                                                                        st,
                                                                        k + COUPLING + 2 * L)))
                                                .mul(2.0))));
        response =
                response.add(
                        a3.mul(
                                own3.add(
                                        a0.mul(DoubleVector.fromArray(S, st, k + COUPLING + 3 * L))
                                                .add(
                                                        a1.mul(
                                                                DoubleVector.fromArray(
                                                                        S,
                                                                        st,
                                                                        k + COUPLING + 4 * L)))
                                                .add(
                                                        a2.mul(
                                                                DoubleVector.fromArray(
                                                                        S,
                                                                        st,
                                                                        k + COUPLING + 5 * L)))
                                                .mul(2.0))));
        var delta = miss.neg().div(response.mul(scale.div(n)).add(give));
        var floor = least.neg().blend(0.0, begins);
        delta = delta.blend(floor, delta.compare(VectorOperators.LT, floor));
        delta = zero.blend(delta, n.compare(VectorOperators.GT, 1.0));
        f0.add(delta.mul(a0)).intoArray(st, k + FIRST);
        f1.add(delta.mul(a1)).intoArray(st, k + FIRST + L);
        f2.add(delta.mul(a2)).intoArray(st, k + FIRST + 2 * L);
        f3.add(delta.mul(a3)).intoArray(st, k + FIRST + 3 * L);
        return n.compare(VectorOperators.GT, 0.0).anyTrue();
    }

    /** Sweeps over up to four points; a point that is not there has no gain. */
    private static boolean sweepFour(double[] d, int o, double[] st, int k, int g, int sweeps) {
        int q = o + (POINT + IMPULSE) * L;
        int next = POINT_FIELDS * L;
        var f0 = DoubleVector.fromArray(S, d, q);
        var f1 = DoubleVector.fromArray(S, d, q + next);
        var f2 = DoubleVector.fromArray(S, d, q + 2 * next);
        var f3 = DoubleVector.fromArray(S, d, q + 3 * next);
        var k01 = DoubleVector.fromArray(S, st, k + COUPLING);
        var k02 = DoubleVector.fromArray(S, st, k + COUPLING + L);
        var k12 = DoubleVector.fromArray(S, st, k + COUPLING + 2 * L);
        var k03 = DoubleVector.fromArray(S, st, k + COUPLING + 3 * L);
        var k13 = DoubleVector.fromArray(S, st, k + COUPLING + 4 * L);
        var k23 = DoubleVector.fromArray(S, st, k + COUPLING + 5 * L);
        var gain0 = DoubleVector.fromArray(S, st, k + GAIN);
        var gain1 = DoubleVector.fromArray(S, st, k + GAIN + L);
        var gain2 = DoubleVector.fromArray(S, st, k + GAIN + 2 * L);
        var gain3 = DoubleVector.fromArray(S, st, k + GAIN + 3 * L);
        var goal0 =
                DoubleVector.fromArray(S, st, k + GOAL)
                        .sub(
                                gain0.mul(
                                        DoubleVector.fromArray(S, st, k + SPEED)
                                                .sub(k01.mul(f1))
                                                .sub(k02.mul(f2))
                                                .sub(k03.mul(f3))));
        var goal1 =
                DoubleVector.fromArray(S, st, k + GOAL + L)
                        .sub(
                                gain1.mul(
                                        DoubleVector.fromArray(S, st, k + SPEED + L)
                                                .sub(k01.mul(f0))
                                                .sub(k12.mul(f2))
                                                .sub(k13.mul(f3))));
        var goal2 =
                DoubleVector.fromArray(S, st, k + GOAL + 2 * L)
                        .sub(
                                gain2.mul(
                                        DoubleVector.fromArray(S, st, k + SPEED + 2 * L)
                                                .sub(k02.mul(f0))
                                                .sub(k12.mul(f1))
                                                .sub(k23.mul(f3))));
        var goal3 =
                DoubleVector.fromArray(S, st, k + GOAL + 3 * L)
                        .sub(
                                gain3.mul(
                                        DoubleVector.fromArray(S, st, k + SPEED + 3 * L)
                                                .sub(k03.mul(f0))
                                                .sub(k13.mul(f1))
                                                .sub(k23.mul(f2))));
        var g01 = gain0.mul(k01);
        var g02 = gain0.mul(k02);
        var g03 = gain0.mul(k03);
        var g10 = gain1.mul(k01);
        var g12 = gain1.mul(k12);
        var g13 = gain1.mul(k13);
        var g20 = gain2.mul(k02);
        var g21 = gain2.mul(k12);
        var g23 = gain2.mul(k23);
        var g30 = gain3.mul(k03);
        var g31 = gain3.mul(k13);
        var g32 = gain3.mul(k23);
        f0 = DoubleVector.fromArray(S, st, k + FIRST);
        f1 = DoubleVector.fromArray(S, st, k + FIRST + L);
        f2 = DoubleVector.fromArray(S, st, k + FIRST + 2 * L);
        f3 = DoubleVector.fromArray(S, st, k + FIRST + 3 * L);
        var zero = DoubleVector.zero(S);
        var moved = zero;
        for (int sweep = 0; sweep < sweeps; sweep++) {
            var e0 = goal0.sub(g01.mul(f1)).sub(g02.mul(f2)).sub(g03.mul(f3));
            e0 = zero.blend(e0, e0.compare(VectorOperators.GT, 0.0));
            var c0 = e0.sub(f0);
            f0 = e0;
            var e1 = goal1.sub(g12.mul(f2)).sub(g13.mul(f3)).sub(g10.mul(f0));
            e1 = zero.blend(e1, e1.compare(VectorOperators.GT, 0.0));
            var c1 = e1.sub(f1);
            f1 = e1;
            var e2 = goal2.sub(g23.mul(f3)).sub(g20.mul(f0)).sub(g21.mul(f1));
            e2 = zero.blend(e2, e2.compare(VectorOperators.GT, 0.0));
            var c2 = e2.sub(f2);
            f2 = e2;
            var e3 = goal3.sub(g30.mul(f0)).sub(g31.mul(f1)).sub(g32.mul(f2));
            e3 = zero.blend(e3, e3.compare(VectorOperators.GT, 0.0));
            var c3 = e3.sub(f3);
            f3 = e3;
            moved = c0.abs().add(c1.abs()).add(c2.abs().add(c3.abs()));
            if (!moved.compare(VectorOperators.GT, 0.0).anyTrue()) {
                break;
            }
        }
        f0.sub(DoubleVector.fromArray(S, d, q)).intoArray(st, k + CHANGE);
        f0.intoArray(d, q);
        f1.sub(DoubleVector.fromArray(S, d, q + next)).intoArray(st, k + CHANGE + L);
        f1.intoArray(d, q + next);
        f2.sub(DoubleVector.fromArray(S, d, q + 2 * next)).intoArray(st, k + CHANGE + 2 * L);
        f2.intoArray(d, q + 2 * next);
        f3.sub(DoubleVector.fromArray(S, d, q + 3 * next)).intoArray(st, k + CHANGE + 3 * L);
        f3.intoArray(d, q + 3 * next);
        moved.intoArray(st, LANDS + g);
        return lands(d, o, st, g);
    }

    /** Velocities that the changes of the impulses make. */
    private static void leaveFour(double[] d, int o, double[] st, int k, int g) {
        int q = o + POINT * L;
        int next = POINT_FIELDS * L;
        int a = VA + 3 * LINE + g;
        int b = VB + 3 * LINE + g;
        var c0 = DoubleVector.fromArray(S, st, k + CHANGE);
        var c1 = DoubleVector.fromArray(S, st, k + CHANGE + L);
        var c2 = DoubleVector.fromArray(S, st, k + CHANGE + 2 * L);
        var c3 = DoubleVector.fromArray(S, st, k + CHANGE + 3 * L);
        var change = c0.add(c1).add(c2).add(c3);
        var ka = change.mul(DoubleVector.fromArray(S, st, VA + 7 * LINE + g));
        var kb = change.mul(DoubleVector.fromArray(S, st, VB + 7 * LINE + g));
        for (int i = 0; i < 3; i++) {
            var n = DoubleVector.fromArray(S, d, o + i * L);
            int v = VA + i * LINE + g;
            DoubleVector.fromArray(S, st, v).sub(ka.mul(n)).add(0.0).intoArray(st, v);
            v = VB + i * LINE + g;
            DoubleVector.fromArray(S, st, v).add(kb.mul(n)).add(0.0).intoArray(st, v);
        }
        DoubleVector.fromArray(S, st, a)
                .sub(c0.mul(DoubleVector.fromArray(S, d, q)))
                .sub(c1.mul(DoubleVector.fromArray(S, d, q + next)))
                .sub(c2.mul(DoubleVector.fromArray(S, d, q + 2 * next)))
                .sub(c3.mul(DoubleVector.fromArray(S, d, q + 3 * next)))
                .add(0.0)
                .intoArray(st, a);
        DoubleVector.fromArray(S, st, b)
                .add(c0.mul(DoubleVector.fromArray(S, d, q + 3 * L)))
                .add(c1.mul(DoubleVector.fromArray(S, d, q + next + 3 * L)))
                .add(c2.mul(DoubleVector.fromArray(S, d, q + 2 * next + 3 * L)))
                .add(c3.mul(DoubleVector.fromArray(S, d, q + 3 * next + 3 * L)))
                .add(0.0)
                .intoArray(st, b);
        DoubleVector.fromArray(S, st, a + LINE)
                .sub(c0.mul(DoubleVector.fromArray(S, d, q + L)))
                .sub(c1.mul(DoubleVector.fromArray(S, d, q + next + L)))
                .sub(c2.mul(DoubleVector.fromArray(S, d, q + 2 * next + L)))
                .sub(c3.mul(DoubleVector.fromArray(S, d, q + 3 * next + L)))
                .add(0.0)
                .intoArray(st, a + LINE);
        DoubleVector.fromArray(S, st, b + LINE)
                .add(c0.mul(DoubleVector.fromArray(S, d, q + 4 * L)))
                .add(c1.mul(DoubleVector.fromArray(S, d, q + next + 4 * L)))
                .add(c2.mul(DoubleVector.fromArray(S, d, q + 2 * next + 4 * L)))
                .add(c3.mul(DoubleVector.fromArray(S, d, q + 3 * next + 4 * L)))
                .add(0.0)
                .intoArray(st, b + LINE);
        DoubleVector.fromArray(S, st, a + 2 * LINE)
                .sub(c0.mul(DoubleVector.fromArray(S, d, q + 2 * L)))
                .sub(c1.mul(DoubleVector.fromArray(S, d, q + next + 2 * L)))
                .sub(c2.mul(DoubleVector.fromArray(S, d, q + 2 * next + 2 * L)))
                .sub(c3.mul(DoubleVector.fromArray(S, d, q + 3 * next + 2 * L)))
                .add(0.0)
                .intoArray(st, a + 2 * LINE);
        DoubleVector.fromArray(S, st, b + 2 * LINE)
                .add(c0.mul(DoubleVector.fromArray(S, d, q + 5 * L)))
                .add(c1.mul(DoubleVector.fromArray(S, d, q + next + 5 * L)))
                .add(c2.mul(DoubleVector.fromArray(S, d, q + 2 * next + 5 * L)))
                .add(c3.mul(DoubleVector.fromArray(S, d, q + 3 * next + 5 * L)))
                .add(0.0)
                .intoArray(st, b + 2 * LINE);
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
