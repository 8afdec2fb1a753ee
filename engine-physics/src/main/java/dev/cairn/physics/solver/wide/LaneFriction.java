package dev.cairn.physics.solver.wide;

import static dev.cairn.physics.solver.row.ConstraintRows.*;
import static dev.cairn.physics.solver.row.Scratch.*;

import dev.cairn.physics.solver.kernel.PatchFriction;
import dev.cairn.physics.solver.kernel.ScalarFriction;
import dev.cairn.physics.solver.row.ConstraintRows;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

import java.lang.invoke.MethodHandles;

/** Friction in lanes: the arithmetic of {@link ScalarFriction}, operation by operation. */
final class LaneFriction implements LaneKernels.Friction {
    private static final VectorSpecies<Double> S = LaneSpecies.doubles(MethodHandles.lookup());
    private static final int L = S.length();

    /**
     * Of a group that slips: the square of the impulse that stops its slide, the impulse that stops
     * its spin, their limits, and the shares of them that it can give.
     */
    private static final int SLIDE = PACKED;

    private static final int SPIN = SLIDE + L;
    private static final int LIMIT = SLIDE + 2 * L;
    private static final int BOUND = SLIDE + 3 * L;
    private static final int SLIDE_SHARE = SLIDE + 4 * L;
    private static final int SPIN_SHARE = SLIDE + 5 * L;

    /** Of the group in work: sum of the normal impulses, marks, and impulses that would stop it. */
    private static final int NORMAL = SLIDE + 6 * L;

    private static final int ACTIVE = SLIDE + 7 * L;
    private static final int TWISTED = SLIDE + 8 * L;
    private static final int HELD = SLIDE + 9 * L;
    private static final int WANTED = SLIDE + 10 * L;

    /** Of a group that slips, see {@link PatchFriction#give}, and the slip that is left. */
    private static final int ACROSS = SLIDE + 12 * L;

    private static final int WHOLE = SLIDE + 13 * L;
    private static final int GIVE = SLIDE + 14 * L;
    private static final int MEAN = SLIDE + 15 * L;
    private static final int HALF = SLIDE + 16 * L;

    @Override
    public boolean solve(ConstraintRows rows, int from, int to, double[] st, int g, int marks) {
        boolean again = false;
        double[] d = rows.doubles;
        for (int j = from; j < to; j += L, g += L) {
            int points = rows.points[j / L];
            int o = START + j * FIELDS;
            if (st[IDLE + g] != 0 || !rows.hasFriction[j / L]) {
                DoubleVector.zero(S).intoArray(st, SLIDES + g);
                continue;
            }
            again |= solve(d, o, st, g, points, marks);
        }
        return again;
    }

    /** In steps that are small enough for the compiler; they hand numbers on in scratch. */
    private static boolean solve(double[] d, int o, double[] st, int g, int points, int marks) {
        if (!press(d, o, st, points)) {
            DoubleVector.zero(S).intoArray(st, SLIDES + g);
            return false;
        }
        boolean again = mark(d, o, st, g, marks);
        spin(d, o, st, g);
        if (slide(d, o, st, g)) {
            slip(d, o, st);
            for (int i = 0; i < PatchFriction.STEPS; i++) {
                newton(d, o, st);
            }
            brake(d, o, st);
        }
        give(d, o, st, g);
        push(d, o, st, g);
        return again;
    }

    /** What the normal impulses allow; false without any impulse, old or new. */
    private static boolean press(double[] d, int o, double[] st, int points) {
        var bound = DoubleVector.zero(S);
        var normal = DoubleVector.zero(S);
        for (int p = 0; p < points; p++) {
            var impulse =
                    DoubleVector.fromArray(S, d, o + (POINT + p * POINT_FIELDS + IMPULSE) * L);
            normal = normal.add(impulse);
            bound = bound.add(impulse.mul(DoubleVector.fromArray(S, d, o + (REACH + p) * L)));
        }
        int l = o + LAMBDA * L;
        var any =
                normal.add(DoubleVector.fromArray(S, d, l).abs())
                        .add(DoubleVector.fromArray(S, d, l + L).abs())
                        .add(DoubleVector.fromArray(S, d, l + 2 * L).abs());
        var mu = DoubleVector.fromArray(S, d, o + FRICTION * L);
        normal.intoArray(st, NORMAL);
        mu.mul(normal).intoArray(st, LIMIT);
        bound.mul(mu).intoArray(st, BOUND);
        return any.compare(VectorOperators.GT, 0.0).anyTrue();
    }

    /** Marks the lanes that press without a good warm start: they need another round. */
    private static boolean mark(double[] d, int o, double[] st, int g, int marks) {
        int l = o + LAMBDA * L;
        var f1 = DoubleVector.fromArray(S, d, l);
        var f2 = DoubleVector.fromArray(S, d, l + L);
        var limit = DoubleVector.fromArray(S, st, LIMIT);
        var stale =
                f1.mul(f1)
                        .add(f2.mul(f2))
                        .compare(VectorOperators.GT, limit.mul(limit).mul(PatchFriction.STALE));
        var cold = DoubleVector.fromArray(S, d, o + COLD * L);
        cold = cold.blend(DoubleVector.fromArray(S, st, marks + g), stale);
        cold.intoArray(d, o + COLD * L);
        var slides =
                cold.compare(VectorOperators.GT, 0.0)
                        .and(
                                DoubleVector.fromArray(S, st, marks + g)
                                        .compare(VectorOperators.GT, 0.0))
                        .and(DoubleVector.fromArray(S, st, NORMAL).compare(VectorOperators.GT, 0.0))
                        .and(
                                DoubleVector.fromArray(S, d, o + FRICTION * L)
                                        .compare(VectorOperators.GT, 0.0));
        var active = DoubleVector.fromArray(S, st, marks + g);
        active.intoArray(st, ACTIVE);
        DoubleVector.zero(S).blend(1.0, slides).intoArray(st, SLIDES + g);
        return slides.anyTrue();
    }

    /** The twist that would stop the spin. */
    private static void spin(double[] d, int o, double[] st, int g) {
        int t = o + TWIST * L;
        var ax = DoubleVector.fromArray(S, st, VA + 3 * LINE + g);
        var ay = DoubleVector.fromArray(S, st, VA + 4 * LINE + g);
        var az = DoubleVector.fromArray(S, st, VA + 5 * LINE + g);
        var bx = DoubleVector.fromArray(S, st, VB + 3 * LINE + g);
        var by = DoubleVector.fromArray(S, st, VB + 4 * LINE + g);
        var bz = DoubleVector.fromArray(S, st, VB + 5 * LINE + g);
        var tax = DoubleVector.fromArray(S, d, t);
        var tay = DoubleVector.fromArray(S, d, t + L);
        var taz = DoubleVector.fromArray(S, d, t + 2 * L);
        var tbx = DoubleVector.fromArray(S, d, t + 3 * L);
        var tby = DoubleVector.fromArray(S, d, t + 4 * L);
        var tbz = DoubleVector.fromArray(S, d, t + 5 * L);
        var old = DoubleVector.fromArray(S, d, o + (LAMBDA + 2) * L);
        var speed =
                tbx.mul(bx)
                        .add(tby.mul(by))
                        .add(tbz.mul(bz))
                        .sub(tax.mul(ax).add(tay.mul(ay)).add(taz.mul(az)));
        var active = DoubleVector.fromArray(S, st, ACTIVE).compare(VectorOperators.GT, 0.0);
        var bound = DoubleVector.fromArray(S, st, BOUND);
        var none = bound.compare(VectorOperators.LE, 0.0);
        var twist =
                old.blend(
                        old.sub(DoubleVector.fromArray(S, d, o + TWIST_MASS * L).mul(speed))
                                .blend(0.0, none),
                        active);
        twist.intoArray(st, TWISTED);
        var held = old.blend(twist.min(bound).max(bound.neg()), active);
        held.intoArray(st, HELD);
        var turn = held.sub(old);
        ax.sub(turn.mul(tax)).intoArray(st, VA + 3 * LINE + g);
        ay.sub(turn.mul(tay)).intoArray(st, VA + 4 * LINE + g);
        az.sub(turn.mul(taz)).intoArray(st, VA + 5 * LINE + g);
        bx.add(turn.mul(tbx)).intoArray(st, VB + 3 * LINE + g);
        by.add(turn.mul(tby)).intoArray(st, VB + 4 * LINE + g);
        bz.add(turn.mul(tbz)).intoArray(st, VB + 5 * LINE + g);
    }

    /** The tangent impulses that would stop the slide; whether a lane may slip. */
    private static boolean slide(double[] d, int o, double[] st, int g) {
        int u = o + TANGENT1 * L;
        int v = o + LEVER * L;
        var v1 = DoubleVector.zero(S);
        var v2 = v1;
        for (int i = 0; i < 3; i++) {
            var along =
                    DoubleVector.fromArray(S, st, VB + i * LINE + g)
                            .sub(DoubleVector.fromArray(S, st, VA + i * LINE + g));
            v1 = v1.add(along.mul(DoubleVector.fromArray(S, d, u + i * L)));
            v2 = v2.add(along.mul(DoubleVector.fromArray(S, d, u + (3 + i) * L)));
        }
        var ax = DoubleVector.fromArray(S, st, VA + 3 * LINE + g);
        var ay = DoubleVector.fromArray(S, st, VA + 4 * LINE + g);
        var az = DoubleVector.fromArray(S, st, VA + 5 * LINE + g);
        var bx = DoubleVector.fromArray(S, st, VB + 3 * LINE + g);
        var by = DoubleVector.fromArray(S, st, VB + 4 * LINE + g);
        var bz = DoubleVector.fromArray(S, st, VB + 5 * LINE + g);
        v1 =
                v1.add(
                                DoubleVector.fromArray(S, d, v + 6 * L)
                                        .mul(bx)
                                        .add(DoubleVector.fromArray(S, d, v + 7 * L).mul(by))
                                        .add(DoubleVector.fromArray(S, d, v + 8 * L).mul(bz)))
                        .sub(
                                DoubleVector.fromArray(S, d, v)
                                        .mul(ax)
                                        .add(DoubleVector.fromArray(S, d, v + L).mul(ay))
                                        .add(DoubleVector.fromArray(S, d, v + 2 * L).mul(az)));
        v2 =
                v2.add(
                                DoubleVector.fromArray(S, d, v + 9 * L)
                                        .mul(bx)
                                        .add(DoubleVector.fromArray(S, d, v + 10 * L).mul(by))
                                        .add(DoubleVector.fromArray(S, d, v + 11 * L).mul(bz)))
                        .sub(
                                DoubleVector.fromArray(S, d, v + 3 * L)
                                        .mul(ax)
                                        .add(DoubleVector.fromArray(S, d, v + 4 * L).mul(ay))
                                        .add(DoubleVector.fromArray(S, d, v + 5 * L).mul(az)));
        int k = o + BLOCK * L;
        var k12 = DoubleVector.fromArray(S, d, k + L);
        int l = o + LAMBDA * L;
        var f1 =
                DoubleVector.fromArray(S, d, l)
                        .sub(DoubleVector.fromArray(S, d, k).mul(v1).add(k12.mul(v2)));
        var f2 =
                DoubleVector.fromArray(S, d, l + L)
                        .sub(k12.mul(v1).add(DoubleVector.fromArray(S, d, k + 2 * L).mul(v2)));
        f1.intoArray(st, WANTED);
        f2.intoArray(st, WANTED + L);
        var twist = DoubleVector.fromArray(S, st, TWISTED);
        var size = f1.mul(f1).add(f2.mul(f2));
        var spin = twist.abs();
        var limit = DoubleVector.fromArray(S, st, LIMIT);
        var bound = DoubleVector.fromArray(S, st, BOUND);
        size.intoArray(st, SLIDE);
        spin.intoArray(st, SPIN);
        DoubleVector.zero(S)
                .blend(1.0, limit.compare(VectorOperators.GT, 0.0))
                .intoArray(st, SLIDE_SHARE);
        DoubleVector.zero(S)
                .blend(1.0, bound.compare(VectorOperators.GT, 0.0))
                .intoArray(st, SPIN_SHARE);
        return size.compare(VectorOperators.GT, limit.mul(limit).mul(PatchFriction.SURE_SLIDE))
                .or(spin.compare(VectorOperators.GT, bound.mul(PatchFriction.SURE_SPIN)))
                // a lane that nothing presses gives nothing, however it slides
                .and(limit.compare(VectorOperators.GT, 0.0))
                .anyTrue();
    }

    /** The impulses that the patch can give, and the turn that they make. */
    private static void give(double[] d, int o, double[] st, int g) {
        int l = o + LAMBDA * L;
        int t = o + TWIST * L;
        int v = o + LEVER * L;
        var active = DoubleVector.fromArray(S, st, ACTIVE).compare(VectorOperators.GT, 0.0);
        var scale = DoubleVector.fromArray(S, st, SLIDE_SHARE);
        var twist = DoubleVector.fromArray(S, st, TWISTED);
        var next =
                DoubleVector.fromArray(S, d, l + 2 * L)
                        .blend(
                                twist.mul(DoubleVector.fromArray(S, st, SPIN_SHARE)).add(0.0),
                                active);
        next.intoArray(d, l + 2 * L);
        var turn = next.sub(DoubleVector.fromArray(S, st, HELD));
        var old1 = DoubleVector.fromArray(S, d, l);
        var old2 = DoubleVector.fromArray(S, d, l + L);
        var f1 = old1.blend(DoubleVector.fromArray(S, st, WANTED).mul(scale).add(0.0), active);
        var f2 = old2.blend(DoubleVector.fromArray(S, st, WANTED + L).mul(scale).add(0.0), active);
        f1.intoArray(d, l);
        f2.intoArray(d, l + L);
        var d1 = f1.sub(old1);
        var d2 = f2.sub(old2);
        d1.intoArray(st, WANTED);
        d2.intoArray(st, WANTED + L);
        for (int i = 0; i < 3; i++) {
            int a = VA + (3 + i) * LINE + g;
            int b = VB + (3 + i) * LINE + g;
            DoubleVector.fromArray(S, st, a)
                    .sub(turn.mul(DoubleVector.fromArray(S, d, t + i * L)))
                    .sub(
                            d1.mul(DoubleVector.fromArray(S, d, v + i * L))
                                    .add(d2.mul(DoubleVector.fromArray(S, d, v + (3 + i) * L))))
                    .add(0.0)
                    .intoArray(st, a);
            DoubleVector.fromArray(S, st, b)
                    .add(turn.mul(DoubleVector.fromArray(S, d, t + (3 + i) * L)))
                    .add(
                            d1.mul(DoubleVector.fromArray(S, d, v + (6 + i) * L))
                                    .add(d2.mul(DoubleVector.fromArray(S, d, v + (9 + i) * L))))
                    .add(0.0)
                    .intoArray(st, b);
        }
    }

    /** The velocities that the tangent impulses make. */
    private static void push(double[] d, int o, double[] st, int g) {
        int u = o + TANGENT1 * L;
        var d1 = DoubleVector.fromArray(S, st, WANTED);
        var d2 = DoubleVector.fromArray(S, st, WANTED + L);
        var ma = DoubleVector.fromArray(S, st, VA + 7 * LINE + g);
        var mb = DoubleVector.fromArray(S, st, VB + 7 * LINE + g);
        for (int i = 0; i < 3; i++) {
            var p =
                    d1.mul(DoubleVector.fromArray(S, d, u + i * L))
                            .add(d2.mul(DoubleVector.fromArray(S, d, u + (3 + i) * L)));
            int a = VA + i * LINE + g;
            int b = VB + i * LINE + g;
            DoubleVector.fromArray(S, st, a).sub(ma.mul(p)).add(0.0).intoArray(st, a);
            DoubleVector.fromArray(S, st, b).add(mb.mul(p)).add(0.0).intoArray(st, b);
        }
    }

    /** What the spin of a group that slips does, and the least slip that is left of it. */
    private static void slip(double[] d, int o, double[] st) {
        var slide = DoubleVector.fromArray(S, st, SLIDE).sqrt();
        var spin = DoubleVector.fromArray(S, st, SPIN);
        var limit = DoubleVector.fromArray(S, st, LIMIT);
        int k = o + BLOCK * L;
        var k11 = DoubleVector.fromArray(S, d, k);
        var skew = DoubleVector.fromArray(S, d, k + L);
        var k22 = DoubleVector.fromArray(S, d, k + 2 * L);
        var mean = k11.add(k22).mul(0.5);
        var half = k11.sub(k22).mul(0.5);
        var inertia = DoubleVector.fromArray(S, d, o + TWIST_MASS * L);
        var reach = DoubleVector.fromArray(S, st, BOUND).div(limit);
        var radius = reach.mul(PatchFriction.RADIUS);
        var x =
                slide.mul(inertia.div(mean.mul(reach.add(PatchFriction.SHORT))))
                        .div(spin.mul(PatchFriction.RADIUS).add(PatchFriction.LEAST));
        var e = x.mul(x);
        var inner =
                e.mul(e.mul(e.mul(e).mul(PatchFriction.EIGHTH).add(PatchFriction.FOURTH)).add(1.0))
                        .add(1.0);
        var share =
                DoubleVector.broadcast(S, 1.0)
                        .div(
                                e.mul(PatchFriction.FAST)
                                        .sub(PatchFriction.LESS)
                                        .blend(
                                                inner,
                                                e.compare(
                                                        VectorOperators.LT,
                                                        PatchFriction.TURNING)));
        var whole =
                share.mul(PatchFriction.NEAR)
                        .add(PatchFriction.FAR)
                        .mul(radius.mul(radius))
                        .mul(limit);
        var across =
                share.mul(PatchFriction.CLOSE).add(PatchFriction.FAR).sqrt().mul(spin).mul(radius);
        mean.intoArray(st, MEAN);
        half.intoArray(st, HALF);
        whole.intoArray(st, WHOLE);
        across.intoArray(st, ACROSS);
        var stiff = mean.add(half.mul(half).add(skew.mul(skew)).sqrt());
        slide.sub(limit)
                .div(stiff)
                .max(across.sub(whole).div(inertia.add(PatchFriction.SHORT)))
                .max(0.0)
                .intoArray(st, GIVE);
    }

    /** A step of Newton's method for the slip that is left. */
    private static void newton(double[] d, int o, double[] st) {
        var f1 = DoubleVector.fromArray(S, st, WANTED);
        var f2 = DoubleVector.fromArray(S, st, WANTED + L);
        var give = DoubleVector.fromArray(S, st, GIVE);
        var skew = DoubleVector.fromArray(S, d, o + (BLOCK + 1) * L);
        var mean = DoubleVector.fromArray(S, st, MEAN);
        var half = DoubleVector.fromArray(S, st, HALF);
        var inertia = DoubleVector.fromArray(S, d, o + TWIST_MASS * L);
        var unit = DoubleVector.broadcast(S, 1.0);
        var u = unit.div(mean.mul(give).add(DoubleVector.fromArray(S, st, LIMIT)));
        var w =
                unit.div(
                        inertia.mul(give.add(PatchFriction.SHORT))
                                .add(DoubleVector.fromArray(S, st, WHOLE))
                                .add(PatchFriction.LEAST));
        var b1 = give.mul(u).mul(half);
        var b2 = give.mul(u).mul(skew);
        var one = u.div(unit.sub(b1.mul(b1).add(b2.mul(b2))));
        var less = unit.sub(b1);
        var more = unit.add(b1);
        var p1 = one.mul(less.mul(f1).sub(b2.mul(f2)));
        var p2 = one.mul(more.mul(f2).sub(b2.mul(f1)));
        var q = DoubleVector.fromArray(S, st, ACROSS).mul(w);
        var most = p1.abs().max(p2.abs()).max(q);
        var scale = unit.div(most);
        p1 = p1.mul(scale);
        p2 = p2.mul(scale);
        q = q.mul(scale);
        var h = p1.mul(p1).add(p2.mul(p2)).add(q.mul(q));
        var y1 = less.mul(p1).sub(b2.mul(p2));
        var y2 = more.mul(p2).sub(b2.mul(p1));
        var z1 = mean.add(half).mul(p1).add(skew.mul(p2));
        var z2 = mean.sub(half).mul(p2).add(skew.mul(p1));
        var fall = one.mul(y1.mul(z1).add(y2.mul(z2))).add(q.mul(q).mul(inertia.mul(w)));
        give.add(h.mul(h.sqrt().mul(most).sub(1.0)).div(fall)).max(0.0).intoArray(st, GIVE);
    }

    /** The impulses that slipping lanes of a group can give, see {@link PatchFriction}. */
    private static void brake(double[] d, int o, double[] st) {
        var f1 = DoubleVector.fromArray(S, st, WANTED);
        var f2 = DoubleVector.fromArray(S, st, WANTED + L);
        var give = DoubleVector.fromArray(S, st, GIVE);
        var limit = DoubleVector.fromArray(S, st, LIMIT);
        var whole = DoubleVector.fromArray(S, st, WHOLE);
        var skew = DoubleVector.fromArray(S, d, o + (BLOCK + 1) * L);
        var mean = DoubleVector.fromArray(S, st, MEAN);
        var half = DoubleVector.fromArray(S, st, HALF);
        var unit = DoubleVector.broadcast(S, 1.0);
        var u = unit.div(mean.mul(give).add(limit));
        var w =
                unit.div(
                        DoubleVector.fromArray(S, d, o + TWIST_MASS * L)
                                .mul(give)
                                .add(whole)
                                .add(PatchFriction.LEAST));
        var b1 = give.mul(u).mul(half);
        var b2 = give.mul(u).mul(skew);
        var one = u.div(unit.sub(b1.mul(b1).add(b2.mul(b2))));
        var p1 = one.mul(unit.sub(b1).mul(f1).sub(b2.mul(f2)));
        var p2 = one.mul(unit.add(b1).mul(f2).sub(b2.mul(f1)));
        var q = DoubleVector.fromArray(S, st, ACROSS).mul(w);
        var rest = unit.div(p1.mul(p1).add(p2.mul(p2)).add(q.mul(q)).sqrt());
        var holds = holds(st);
        p1.mul(limit.mul(rest)).blend(f1, holds).intoArray(st, WANTED);
        p2.mul(limit.mul(rest)).blend(f2, holds).intoArray(st, WANTED + L);
        var bound = DoubleVector.fromArray(S, st, BOUND);
        whole.mul(w)
                .mul(rest)
                .blend(1.0, holds)
                .blend(0.0, bound.compare(VectorOperators.LE, 0.0))
                .intoArray(st, SPIN_SHARE);
    }

    /** See {@link PatchFriction#holds}; also where nothing presses. */
    private static VectorMask<Double> holds(double[] st) {
        var slide = DoubleVector.fromArray(S, st, SLIDE);
        var spin = DoubleVector.fromArray(S, st, SPIN);
        var limit = DoubleVector.fromArray(S, st, LIMIT);
        var bound = DoubleVector.fromArray(S, st, BOUND);
        var l2 = limit.mul(limit);
        var rim = spin.div(bound.div(limit).add(PatchFriction.SHORT));
        return slide.compare(VectorOperators.LE, l2)
                .and(spin.compare(VectorOperators.LE, bound))
                .and(
                        slide.mul(9.0)
                                .add(rim.mul(rim).mul(16.0))
                                .compare(VectorOperators.LE, l2.mul(9.0)))
                .or(limit.compare(VectorOperators.LE, 0.0));
    }

    @Override
    public void total(ConstraintRows rows, int from, int to, double[] st, int g) {
        double[] d = rows.doubles;
        for (int j = from; j < to; j += L, g += L) {
            int points = rows.points[j / L];
            int o = START + j * FIELDS;
            if (st[IDLE + g] != 0) {
                continue;
            }
            int t = o + TOTAL * L;
            int l = o + LAMBDA * L;
            for (int f = 0; f < 3; f++) {
                DoubleVector.fromArray(S, d, t + f * L)
                        .add(DoubleVector.fromArray(S, d, l + f * L))
                        .intoArray(d, t + f * L);
            }
            for (int p = 0; p < points; p++) {
                int q = o + (POINT + p * POINT_FIELDS + IMPULSE) * L;
                int s = o + (SUM + p) * L;
                DoubleVector.fromArray(S, d, s)
                        .add(DoubleVector.fromArray(S, d, q))
                        .intoArray(d, s);
            }
        }
    }
}
