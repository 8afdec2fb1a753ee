package dev.cairn.physics.solver.wide;

import static dev.cairn.physics.solver.row.ConstraintRows.*;
import static dev.cairn.physics.solver.row.Scratch.LINE;
import static dev.cairn.physics.solver.row.Scratch.PACKED;
import static dev.cairn.physics.solver.row.Scratch.VA;
import static dev.cairn.physics.solver.row.Scratch.VB;

import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.kernel.Offsets;
import dev.cairn.physics.solver.kernel.RowStore;
import dev.cairn.physics.solver.kernel.StoreRow;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.Scratch;
import dev.cairn.physics.solver.row.SubStep;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

import java.lang.invoke.MethodHandles;

/**
 * Empties constraint rows with one row to a lane: the arithmetic of {@link StoreRow} and {@link
 * Offsets}, operation by operation. Made once for each number of lanes, like {@link LanePrepare}.
 */
final class LaneStore implements RowStore {
    private final LaneKernels.Bodies gathers;

    private static final VectorSpecies<Double> S = LaneSpecies.doubles(MethodHandles.lookup());
    private static final int L = S.length();

    /** In scratch, of the group in work: separations of the points, then their preloads. */
    private static final int GAPS = PACKED;

    private static final int KNOWN = PACKED + 4 * L;

    /** World friction impulse, and twist. */
    private static final int TANGENTIAL = PACKED + 8 * L;

    /** 1 in a lane whose surfaces do not slip; speed of separation without the turns. */
    private static final int RESTS = PACKED + 12 * L;

    private static final int APART = PACKED + 13 * L;

    /** Speeds along the tangents. */
    private static final int SLIPS = PACKED + 14 * L;

    /** Shares of their loads that the offsets may hold. */
    private static final int SHARES = PACKED + 16 * L;

    LaneStore(LaneKernels.Bodies bodies) {
        gathers = bodies;
    }

    @Override
    public void store(
            ConstraintRows rows,
            SolverBodies bodies,
            ContactStore contacts,
            SubStep sub,
            int from,
            int to,
            Scratch scratch) {
        double[] d = rows.doubles;
        double[] st = scratch.doubles;
        double gain = sub.offsetGain;
        double still = sub.still;
        if (gain > 0) {
            gathers.gather(bodies, rows.link, from, to, st);
        }
        for (int j = from, g = 0; j < to; j += L, g += L) {
            int points = rows.points[j / L];
            int o = START + j * FIELDS;
            friction(d, o, st);
            if (gain > 0) {
                stage(rows, contacts, j, st);
                shares(rows, bodies, j, sub, st);
                slip(d, o, st, g, still);
                offsets(d, o, st, g, points, sub, gain, still);
            }
            for (int l = 0; l < L; l++) {
                if (rows.link[(j + l) * LINK + COUNT] > 0) {
                    put(rows, contacts, j + l, o + l, st, l, gain > 0);
                }
            }
        }
    }

    /** Friction impulses in world axes, see {@link StoreRow}. */
    private static void friction(double[] d, int o, double[] st) {
        var f1 = DoubleVector.fromArray(S, d, o + LAMBDA * L);
        var f2 = DoubleVector.fromArray(S, d, o + (LAMBDA + 1) * L);
        for (int axis = 0; axis < 3; axis++) {
            f1.mul(DoubleVector.fromArray(S, d, o + (TANGENT1 + axis) * L))
                    .add(f2.mul(DoubleVector.fromArray(S, d, o + (TANGENT2 + axis) * L)))
                    .intoArray(st, TANGENTIAL + axis * L);
        }
        DoubleVector.fromArray(S, d, o + (LAMBDA + 2) * L).intoArray(st, TANGENTIAL + 3 * L);
    }

    /** Copies the separations at the start of the tick into lanes; 0 where there is no contact. */
    private static void stage(ConstraintRows rows, ContactStore c, int j, double[] st) {
        for (int l = 0; l < L; l++) {
            boolean there = rows.link[(j + l) * LINK + COUNT] > 0;
            int p = ContactStore.POINTS * rows.link[(j + l) * LINK + SOURCE];
            for (int i = 0; i < ContactStore.POINTS; i++) {
                st[GAPS + i * L + l] = there ? c.separation[p + i] : 0;
            }
        }
    }

    /** {@link Offsets#share} of each lane. */
    private static void shares(
            ConstraintRows rows, SolverBodies bodies, int j, SubStep sub, double[] st) {
        for (int l = 0; l < L; l++) {
            boolean there = rows.link[(j + l) * LINK + COUNT] > 0;
            st[SHARES + l] = there ? Offsets.share(rows, bodies, j + l, sub) : 0;
        }
    }

    /** Whether the surfaces slip, and how fast the centres part. */
    private static void slip(double[] d, int o, double[] st, int g, double still) {
        var x = DoubleVector.fromArray(S, st, VB + g).sub(DoubleVector.fromArray(S, st, VA + g));
        var y =
                DoubleVector.fromArray(S, st, VB + LINE + g)
                        .sub(DoubleVector.fromArray(S, st, VA + LINE + g));
        var z =
                DoubleVector.fromArray(S, st, VB + 2 * LINE + g)
                        .sub(DoubleVector.fromArray(S, st, VA + 2 * LINE + g));
        x.mul(DoubleVector.fromArray(S, d, o))
                .add(y.mul(DoubleVector.fromArray(S, d, o + L)))
                .add(z.mul(DoubleVector.fromArray(S, d, o + 2 * L)))
                .intoArray(st, APART);
        along(d, o + TANGENT1 * L, o + LEVER * L, st, g, SLIPS);
        along(d, o + TANGENT2 * L, o + (LEVER + 3) * L, st, g, SLIPS + L);
        var s1 = DoubleVector.fromArray(S, st, SLIPS);
        var s2 = DoubleVector.fromArray(S, st, SLIPS + L);
        var slip = s1.mul(s1).add(s2.mul(s2));
        var hasFriction =
                DoubleVector.fromArray(S, d, o + FRICTION * L).compare(VectorOperators.GT, 0.0);
        var speed = DoubleVector.zero(S).blend(slip.sqrt(), hasFriction);
        DoubleVector.zero(S)
                .blend(1.0, speed.compare(VectorOperators.LT, still))
                .intoArray(st, RESTS);
    }

    /** Writes the speed along the tangent at {@code d[t]}, its lever of A at {@code d[v]}. */
    private static void along(double[] d, int t, int v, double[] st, int g, int out) {
        int a = VA + g;
        int b = VB + g;
        int w = v + 6 * L;
        var x = DoubleVector.fromArray(S, st, b).sub(DoubleVector.fromArray(S, st, a));
        var y =
                DoubleVector.fromArray(S, st, b + LINE)
                        .sub(DoubleVector.fromArray(S, st, a + LINE));
        var z =
                DoubleVector.fromArray(S, st, b + 2 * LINE)
                        .sub(DoubleVector.fromArray(S, st, a + 2 * LINE));
        var turnA =
                DoubleVector.fromArray(S, d, v)
                        .mul(DoubleVector.fromArray(S, st, a + 3 * LINE))
                        .add(
                                DoubleVector.fromArray(S, d, v + L)
                                        .mul(DoubleVector.fromArray(S, st, a + 4 * LINE)))
                        .add(
                                DoubleVector.fromArray(S, d, v + 2 * L)
                                        .mul(DoubleVector.fromArray(S, st, a + 5 * LINE)));
        var turnB =
                DoubleVector.fromArray(S, d, w)
                        .mul(DoubleVector.fromArray(S, st, b + 3 * LINE))
                        .add(
                                DoubleVector.fromArray(S, d, w + L)
                                        .mul(DoubleVector.fromArray(S, st, b + 4 * LINE)))
                        .add(
                                DoubleVector.fromArray(S, d, w + 2 * L)
                                        .mul(DoubleVector.fromArray(S, st, b + 5 * LINE)));
        x.mul(DoubleVector.fromArray(S, d, t))
                .add(y.mul(DoubleVector.fromArray(S, d, t + L)))
                .add(z.mul(DoubleVector.fromArray(S, d, t + 2 * L)))
                .add(turnB)
                .sub(turnA)
                .intoArray(st, out);
    }

    /** The preloads of the next tick, see {@link Offsets}. */
    private static void offsets(
            double[] d,
            int o,
            double[] st,
            int g,
            int points,
            SubStep sub,
            double gain,
            double still) {
        var fixed =
                DoubleVector.fromArray(S, st, VA + 7 * LINE + g)
                        .compare(VectorOperators.EQ, 0.0)
                        .or(
                                DoubleVector.fromArray(S, st, VB + 7 * LINE + g)
                                        .compare(VectorOperators.EQ, 0.0));
        var stiffness =
                DoubleVector.broadcast(S, sub.stiffness(false)).blend(sub.stiffness(true), fixed);
        var rests = DoubleVector.fromArray(S, st, RESTS).compare(VectorOperators.GT, 0.0);
        var ax = DoubleVector.fromArray(S, st, VA + 3 * LINE + g);
        var ay = DoubleVector.fromArray(S, st, VA + 4 * LINE + g);
        var az = DoubleVector.fromArray(S, st, VA + 5 * LINE + g);
        var bx = DoubleVector.fromArray(S, st, VB + 3 * LINE + g);
        var by = DoubleVector.fromArray(S, st, VB + 4 * LINE + g);
        var bz = DoubleVector.fromArray(S, st, VB + 5 * LINE + g);
        double touch = /*(float)*/ sub.touch;
        var share = DoubleVector.fromArray(S, st, SHARES);
        for (int i = 0; i < points; i++) {
            int q = o + (POINT + i * POINT_FIELDS) * L;
            var impulse = DoubleVector.fromArray(S, d, q + IMPULSE * L);
            var gap = DoubleVector.fromArray(S, st, GAPS + i * L);
            var k = DoubleVector.fromArray(S, d, q + MASS * L).mul(stiffness);
            var known = k.mul(gap.sub(DoubleVector.fromArray(S, d, o + (GAP + i) * L)));
            int w = q + ARM_B * L;
            var turnA =
                    DoubleVector.fromArray(S, d, q + ARM_A * L)
                            .mul(ax)
                            .add(DoubleVector.fromArray(S, d, q + (ARM_A + 1) * L).mul(ay))
                            .add(DoubleVector.fromArray(S, d, q + (ARM_A + 2) * L).mul(az));
            var turnB =
                    DoubleVector.fromArray(S, d, w)
                            .mul(bx)
                            .add(DoubleVector.fromArray(S, d, w + L).mul(by))
                            .add(DoubleVector.fromArray(S, d, w + 2 * L).mul(bz));
            var speed = DoubleVector.fromArray(S, st, APART).add(turnB).sub(turnA);
            var holds =
                    speed.abs()
                            .compare(VectorOperators.LT, still)
                            .and(rests)
                            .and(impulse.compare(VectorOperators.GT, 0.0));
            var matters =
                    gap.compare(VectorOperators.LT, 0.0).or(gap.compare(VectorOperators.GT, touch));
            var learnt =
                    known.sub(k.mul(DoubleVector.zero(S).blend(gap, matters).mul(gain)))
                            .min(known.max(impulse.mul(share)));
            var open =
                    impulse.compare(VectorOperators.EQ, 0.0)
                            .and(gap.compare(VectorOperators.GT, 0.0));
            var faded =
                    known.mul(DoubleVector.broadcast(S, Offsets.MOVING).blend(Offsets.OPEN, open));
            known = faded.blend(learnt, holds);
            DoubleVector.zero(S)
                    .blend(known, known.compare(VectorOperators.GT, 0.0))
                    .intoArray(st, KNOWN + i * L);
        }
    }

    /** Writes what one lane holds to its contact. */
    private static void put(
            ConstraintRows rows, ContactStore c, int j, int o, double[] st, int l, boolean knows) {
        double[] d = rows.doubles;
        int source = rows.link[j * LINK + SOURCE];
        c.setFrictionImpulse(
                source,
                st[TANGENTIAL + l],
                st[TANGENTIAL + L + l],
                st[TANGENTIAL + 2 * L + l],
                st[TANGENTIAL + 3 * L + l]);
        int first = ContactStore.POINTS * source;
        int count = rows.link[j * LINK + COUNT];
        for (int i = 0; i < count; i++) {
            c.normalImpulse[first + i] = d[o + (POINT + i * POINT_FIELDS + IMPULSE) * L];
            // what was taken back leaves a rounding of either sign
            c.totalNormalImpulse[first + i] = Math.max(0, d[o + (SUM + i) * L]);
            if (knows) {
                c.preload[first + i] = st[KNOWN + i * L + l];
            }
        }
    }
}
