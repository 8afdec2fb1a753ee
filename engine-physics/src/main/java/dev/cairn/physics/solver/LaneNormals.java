package dev.cairn.physics.solver;

import static dev.cairn.physics.solver.ConstraintRows.ARM_B;
import static dev.cairn.physics.solver.ConstraintRows.COLD;
import static dev.cairn.physics.solver.ConstraintRows.FIELDS;
import static dev.cairn.physics.solver.ConstraintRows.GAP;
import static dev.cairn.physics.solver.ConstraintRows.IMPULSE;
import static dev.cairn.physics.solver.ConstraintRows.LAMBDA;
import static dev.cairn.physics.solver.ConstraintRows.MASS;
import static dev.cairn.physics.solver.ConstraintRows.POINT;
import static dev.cairn.physics.solver.ConstraintRows.POINT_FIELDS;
import static dev.cairn.physics.solver.ConstraintRows.SEPARATION;
import static dev.cairn.physics.solver.ConstraintRows.START;
import static dev.cairn.physics.solver.Scratch.IDLE;
import static dev.cairn.physics.solver.Scratch.LANDS;
import static dev.cairn.physics.solver.Scratch.LINE;
import static dev.cairn.physics.solver.Scratch.PA;
import static dev.cairn.physics.solver.Scratch.PACK;
import static dev.cairn.physics.solver.Scratch.PACKED;
import static dev.cairn.physics.solver.Scratch.PB;
import static dev.cairn.physics.solver.Scratch.VA;
import static dev.cairn.physics.solver.Scratch.VB;
import static dev.cairn.physics.solver.SolverBodies.LOADED;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

import java.lang.invoke.MethodHandles;

/**
 * Normal impulses in lanes: the arithmetic of {@link ScalarNormals}, operation by operation. A
 * sweep goes over numbers that are all in registers.
 */
final class LaneNormals implements LaneKernels.Normals {
    private static final VectorSpecies<Double> S = species();
    private static final int L = S.length();

    /** In the pack of a group, by point: gain, goal, speed without the own impulse, change. */
    private static final int GAIN = 0;

    private static final int GOAL = 4 * L;
    private static final int SPEED = 8 * L;
    private static final int CHANGE = 12 * L;

    /** Couplings of the points 01, 02, 12, 03, 13, 23. */
    private static final int COUPLING = 16 * L;

    /** By point: inverse of the effective mass, and the impulse that the sweeps start with. */
    private static final int OWN = 22 * L;

    private static final int FIRST = 26 * L;

    private static VectorSpecies<Double> species() {
        try {
            int lanes = MethodHandles.classData(MethodHandles.lookup(), "_", Integer.class);
            return lanes == 4 ? DoubleVector.SPECIES_256 : DoubleVector.SPECIES_512;
        } catch (IllegalAccessException refused) {
            throw new ExceptionInInitializerError(refused);
        }
    }

    @Override
    public void begin(ConstraintRows rows, int from, int to, double[] st, int g) {
        double[] d = rows.row;
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
        double[] d = rows.row;
        for (int j = from; j < to; j += L, g += L) {
            int points = rows.points[j / L];
            int o = START + j * FIELDS;
            int k = PACKED + g * PACK;
            var ma = DoubleVector.fromArray(S, st, VA + 7 * LINE + g);
            var mb = DoubleVector.fromArray(S, st, VB + 7 * LINE + g);
            var fixed = ma.compare(VectorOperators.EQ, 0.0).or(mb.compare(VectorOperators.EQ, 0.0));
            var rate = DoubleVector.broadcast(S, sub.rate).blend(sub.fixedRate, fixed);
            var scale = DoubleVector.broadcast(S, sub.massScale).blend(sub.fixedMassScale, fixed);
            var rests = DoubleVector.fromArray(S, st, marks + g).compare(VectorOperators.EQ, 0.0);
            for (int p = 0; p < points; p++) {
                int q = o + (POINT + p * POINT_FIELDS) * L;
                var s = DoubleVector.fromArray(S, d, q + SEPARATION * L);
                var mass = DoubleVector.fromArray(S, d, q + MASS * L);
                var open = s.compare(VectorOperators.GT, 0.0);
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
            ConstraintRows rows, int from, int to, double[] st, int g, double inverse, int marks) {
        double[] d = rows.row;
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
                var open = s.compare(VectorOperators.GT, 0.0);
                var stays = rests.or(open.and(impulse.compare(VectorOperators.EQ, 0.0)));
                var b = DoubleVector.zero(S).blend(s.mul(inverse), open);
                mass.blend(0.0, stays).intoArray(st, k + GAIN + p * L);
                mass.mul(b).neg().blend(impulse, stays).intoArray(st, k + GOAL + p * L);
            }
        }
    }

    @Override
    public boolean separate(ConstraintRows rows, int from, int to, double[] st, int g) {
        boolean any = false;
        double[] d = rows.row;
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
                        s.compare(VectorOperators.GT, 0.0)
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
    public boolean sweep(
            ConstraintRows rows, int from, int to, double[] st, int g, int sweeps, int step) {
        boolean lands = false;
        for (int j = from, l = g; j < to; j += L, l += L) {
            int o = START + j * FIELDS;
            int k = PACKED + l * PACK;
            if (st[IDLE + l] == 0) {
                int n = rows.points[j / L];
                lands |=
                        n > 2
                                ? four(rows.row, o, st, k, l, sweeps, step)
                                : few(rows.row, o, st, k, l, n, sweeps, step);
            }
        }
        return lands;
    }

    private static boolean four(
            double[] d, int o, double[] st, int k, int g, int sweeps, int step) {
        enterFour(d, o, st, k, g);
        if (!evenFour(d, o, st, k, g, step) && step == SOFT) {
            DoubleVector.zero(S).intoArray(st, LANDS + g);
            return false;
        }
        boolean lands = sweepFour(d, o, st, k, g, sweeps);
        leaveFour(d, o, st, k, g);
        return lands;
    }

    private static boolean few(
            double[] d, int o, double[] st, int k, int g, int points, int sweeps, int step) {
        speeds(d, o, st, k, g, points);
        boolean lands;
        if (points == 2) {
            couplings(d, o, st, k, g, points);
            if (!evenTwo(d, o, st, k, g, step) && step == SOFT) {
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

    /**
     * The impulses that the sweeps start with: the same change at all points that press, or begin
     * to, see {@link ScalarNormals}.
     *
     * @return whether a point of the group presses or closes
     */
    private static boolean evenFour(double[] d, int o, double[] st, int k, int g, int step) {
        int q = o + (POINT + IMPULSE) * L;
        int next = POINT_FIELDS * L;
        var zero = DoubleVector.zero(S);
        var f0 = DoubleVector.fromArray(S, d, q);
        var f1 = DoubleVector.fromArray(S, d, q + next);
        var f2 = DoubleVector.fromArray(S, d, q + 2 * next);
        var f3 = DoubleVector.fromArray(S, d, q + 3 * next);
        if (step == NONE) {
            f0.intoArray(st, k + FIRST);
            f1.intoArray(st, k + FIRST + L);
            f2.intoArray(st, k + FIRST + 2 * L);
            f3.intoArray(st, k + FIRST + 3 * L);
            return true;
        }
        var begins =
                (step == SOFT ? DoubleVector.fromArray(S, d, o + COLD * L) : zero)
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

    /** The same for two. */
    private static boolean evenTwo(double[] d, int o, double[] st, int k, int g, int step) {
        int q = o + (POINT + IMPULSE) * L;
        int next = POINT_FIELDS * L;
        var zero = DoubleVector.zero(S);
        var f0 = DoubleVector.fromArray(S, d, q);
        var f1 = DoubleVector.fromArray(S, d, q + next);
        if (step == NONE) {
            f0.intoArray(st, k + FIRST);
            f1.intoArray(st, k + FIRST + L);
            return true;
        }
        var begins =
                (step == SOFT ? DoubleVector.fromArray(S, d, o + COLD * L) : zero)
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
        var nx = DoubleVector.fromArray(S, d, o);
        DoubleVector.fromArray(S, st, VA + g).sub(ka.mul(nx)).add(0.0).intoArray(st, VA + g);
        DoubleVector.fromArray(S, st, VB + g).add(kb.mul(nx)).add(0.0).intoArray(st, VB + g);
        var ny = DoubleVector.fromArray(S, d, o + L);
        DoubleVector.fromArray(S, st, VA + LINE + g)
                .sub(ka.mul(ny))
                .add(0.0)
                .intoArray(st, VA + LINE + g);
        DoubleVector.fromArray(S, st, VB + LINE + g)
                .add(kb.mul(ny))
                .add(0.0)
                .intoArray(st, VB + LINE + g);
        var nz = DoubleVector.fromArray(S, d, o + 2 * L);
        DoubleVector.fromArray(S, st, VA + 2 * LINE + g)
                .sub(ka.mul(nz))
                .add(0.0)
                .intoArray(st, VA + 2 * LINE + g);
        DoubleVector.fromArray(S, st, VB + 2 * LINE + g)
                .add(kb.mul(nz))
                .add(0.0)
                .intoArray(st, VB + 2 * LINE + g);
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

    @Override
    public void load(ConstraintRows rows, int from, int to, double[] st, int g) {
        double[] d = rows.row;
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
