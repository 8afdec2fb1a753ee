package dev.cairn.physics.solver.wide;

import static dev.cairn.physics.solver.body.SolverBodies.P;
import static dev.cairn.physics.solver.row.ConstraintRows.LINK;
import static dev.cairn.physics.solver.row.Scratch.LINE;
import static dev.cairn.physics.solver.row.Scratch.PA;
import static dev.cairn.physics.solver.row.Scratch.PB;
import static dev.cairn.physics.solver.row.Scratch.VA;
import static dev.cairn.physics.solver.row.Scratch.VB;

import dev.cairn.physics.solver.body.SolverBodies;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorShuffle;
import jdk.incubator.vector.VectorSpecies;

import java.lang.invoke.MethodHandles;

/**
 * Gathers the bodies of a chunk into lanes and scatters them again. With 8 lanes a body's half is
 * one vector, and 8 of them are transposed in registers: in each of three rounds the lanes whose
 * number has the round's bit change places with those of the partner that have not. With 4 lanes
 * scalar copies do it.
 */
final class LaneBodies implements LaneKernels.Bodies {
    private static final VectorSpecies<Double> S = LaneSpecies.doubles(MethodHandles.lookup());
    private static final int L = S.length();
    private static final VectorShuffle<Double> SWAP_1 = VectorShuffle.fromOp(S, i -> i ^ 1);
    private static final VectorShuffle<Double> SWAP_2 = VectorShuffle.fromOp(S, i -> i ^ 2);
    private static final VectorShuffle<Double> SWAP_4 =
            VectorShuffle.fromOp(S, i -> (i ^ 4) & L - 1);
    private static final VectorMask<Double> ODD_1 = VectorMask.fromLong(S, 0xaa);
    private static final VectorMask<Double> ODD_2 = VectorMask.fromLong(S, 0xcc);
    private static final VectorMask<Double> ODD_4 = VectorMask.fromLong(S, 0xf0);

    @Override
    public void gather(SolverBodies bodies, int[] link, int from, int to, double[] st) {
        double[] body = bodies.state;
        if (L == 8) {
            for (int j = from; j < to; j += L) {
                read(body, link, j * LINK, 0, st, VA + j - from);
                read(body, link, j * LINK + 1, 0, st, VB + j - from);
            }
        } else {
            for (int j = from; j < to; j++) {
                copy(body, link[j * LINK], st, VA + j - from, 8);
                copy(body, link[j * LINK + 1], st, VB + j - from, 8);
            }
        }
    }

    @Override
    public void gatherMovement(SolverBodies bodies, int[] link, int from, int to, double[] st) {
        double[] body = bodies.state;
        if (L == 8) {
            for (int j = from; j < to; j += L) {
                readSix(body, link, j * LINK, P, st, PA + j - from);
                readSix(body, link, j * LINK + 1, P, st, PB + j - from);
            }
        } else {
            for (int j = from; j < to; j++) {
                copy(body, link[j * LINK] + P, st, PA + j - from, 6);
                copy(body, link[j * LINK + 1] + P, st, PB + j - from, 6);
            }
        }
    }

    @Override
    public void scatter(SolverBodies bodies, int[] link, int from, int to, double[] st) {
        double[] body = bodies.state;
        if (L == 8) {
            for (int j = from; j < to; j += L) {
                write(body, link, j * LINK, st, VA + j - from);
                write(body, link, j * LINK + 1, st, VB + j - from);
            }
        } else {
            for (int j = from; j < to; j++) {
                copyBack(body, link[j * LINK], st, VA + j - from);
                copyBack(body, link[j * LINK + 1], st, VB + j - from);
            }
        }
    }

    private static void copy(double[] body, int i, double[] st, int o, int n) {
        for (int k = 0; k < n; k++) {
            st[o + k * LINE] = body[i + k];
        }
    }

    private static void copyBack(double[] body, int i, double[] st, int o) {
        for (int k = 0; k < 8 && i != 0; k++) {
            body[i + k] = st[o + k * LINE];
        }
    }

    /** The 8 numbers from {@code part} on of 8 bodies. */
    private static void read(double[] body, int[] link, int l, int part, double[] st, int o) {
        var r0 = DoubleVector.fromArray(S, body, link[l] + part);
        var r1 = DoubleVector.fromArray(S, body, link[l + LINK] + part);
        var r2 = DoubleVector.fromArray(S, body, link[l + 2 * LINK] + part);
        var r3 = DoubleVector.fromArray(S, body, link[l + 3 * LINK] + part);
        var r4 = DoubleVector.fromArray(S, body, link[l + 4 * LINK] + part);
        var r5 = DoubleVector.fromArray(S, body, link[l + 5 * LINK] + part);
        var r6 = DoubleVector.fromArray(S, body, link[l + 6 * LINK] + part);
        var r7 = DoubleVector.fromArray(S, body, link[l + 7 * LINK] + part);
        var s0 = r0.blend(r1.rearrange(SWAP_1), ODD_1);
        var s1 = r0.rearrange(SWAP_1).blend(r1, ODD_1);
        var s2 = r2.blend(r3.rearrange(SWAP_1), ODD_1);
        var s3 = r2.rearrange(SWAP_1).blend(r3, ODD_1);
        var s4 = r4.blend(r5.rearrange(SWAP_1), ODD_1);
        var s5 = r4.rearrange(SWAP_1).blend(r5, ODD_1);
        var s6 = r6.blend(r7.rearrange(SWAP_1), ODD_1);
        var s7 = r6.rearrange(SWAP_1).blend(r7, ODD_1);
        var t0 = s0.blend(s2.rearrange(SWAP_2), ODD_2);
        var t2 = s0.rearrange(SWAP_2).blend(s2, ODD_2);
        var t1 = s1.blend(s3.rearrange(SWAP_2), ODD_2);
        var t3 = s1.rearrange(SWAP_2).blend(s3, ODD_2);
        var t4 = s4.blend(s6.rearrange(SWAP_2), ODD_2);
        var t6 = s4.rearrange(SWAP_2).blend(s6, ODD_2);
        var t5 = s5.blend(s7.rearrange(SWAP_2), ODD_2);
        var t7 = s5.rearrange(SWAP_2).blend(s7, ODD_2);
        var u0 = t0.blend(t4.rearrange(SWAP_4), ODD_4);
        var u4 = t0.rearrange(SWAP_4).blend(t4, ODD_4);
        var u1 = t1.blend(t5.rearrange(SWAP_4), ODD_4);
        var u5 = t1.rearrange(SWAP_4).blend(t5, ODD_4);
        var u2 = t2.blend(t6.rearrange(SWAP_4), ODD_4);
        var u6 = t2.rearrange(SWAP_4).blend(t6, ODD_4);
        var u3 = t3.blend(t7.rearrange(SWAP_4), ODD_4);
        var u7 = t3.rearrange(SWAP_4).blend(t7, ODD_4);
        u0.intoArray(st, o);
        u1.intoArray(st, o + LINE);
        u2.intoArray(st, o + 2 * LINE);
        u3.intoArray(st, o + 3 * LINE);
        u4.intoArray(st, o + 4 * LINE);
        u5.intoArray(st, o + 5 * LINE);
        u6.intoArray(st, o + 6 * LINE);
        u7.intoArray(st, o + 7 * LINE);
    }

    /** The first 6 of them. */
    private static void readSix(double[] body, int[] link, int l, int part, double[] st, int o) {
        var r0 = DoubleVector.fromArray(S, body, link[l] + part);
        var r1 = DoubleVector.fromArray(S, body, link[l + LINK] + part);
        var r2 = DoubleVector.fromArray(S, body, link[l + 2 * LINK] + part);
        var r3 = DoubleVector.fromArray(S, body, link[l + 3 * LINK] + part);
        var r4 = DoubleVector.fromArray(S, body, link[l + 4 * LINK] + part);
        var r5 = DoubleVector.fromArray(S, body, link[l + 5 * LINK] + part);
        var r6 = DoubleVector.fromArray(S, body, link[l + 6 * LINK] + part);
        var r7 = DoubleVector.fromArray(S, body, link[l + 7 * LINK] + part);
        var s0 = r0.blend(r1.rearrange(SWAP_1), ODD_1);
        var s1 = r0.rearrange(SWAP_1).blend(r1, ODD_1);
        var s2 = r2.blend(r3.rearrange(SWAP_1), ODD_1);
        var s3 = r2.rearrange(SWAP_1).blend(r3, ODD_1);
        var s4 = r4.blend(r5.rearrange(SWAP_1), ODD_1);
        var s5 = r4.rearrange(SWAP_1).blend(r5, ODD_1);
        var s6 = r6.blend(r7.rearrange(SWAP_1), ODD_1);
        var s7 = r6.rearrange(SWAP_1).blend(r7, ODD_1);
        var t0 = s0.blend(s2.rearrange(SWAP_2), ODD_2);
        var t2 = s0.rearrange(SWAP_2).blend(s2, ODD_2);
        var t1 = s1.blend(s3.rearrange(SWAP_2), ODD_2);
        var t3 = s1.rearrange(SWAP_2).blend(s3, ODD_2);
        var t4 = s4.blend(s6.rearrange(SWAP_2), ODD_2);
        var t6 = s4.rearrange(SWAP_2).blend(s6, ODD_2);
        var t5 = s5.blend(s7.rearrange(SWAP_2), ODD_2);
        var t7 = s5.rearrange(SWAP_2).blend(s7, ODD_2);
        var u0 = t0.blend(t4.rearrange(SWAP_4), ODD_4);
        var u4 = t0.rearrange(SWAP_4).blend(t4, ODD_4);
        var u1 = t1.blend(t5.rearrange(SWAP_4), ODD_4);
        var u5 = t1.rearrange(SWAP_4).blend(t5, ODD_4);
        var u2 = t2.blend(t6.rearrange(SWAP_4), ODD_4);
        var u3 = t3.blend(t7.rearrange(SWAP_4), ODD_4);
        u0.intoArray(st, o);
        u1.intoArray(st, o + LINE);
        u2.intoArray(st, o + 2 * LINE);
        u3.intoArray(st, o + 3 * LINE);
        u4.intoArray(st, o + 4 * LINE);
        u5.intoArray(st, o + 5 * LINE);
    }

    private static void write(double[] body, int[] link, int l, double[] st, int o) {
        var r0 = DoubleVector.fromArray(S, st, o);
        var r1 = DoubleVector.fromArray(S, st, o + LINE);
        var r2 = DoubleVector.fromArray(S, st, o + 2 * LINE);
        var r3 = DoubleVector.fromArray(S, st, o + 3 * LINE);
        var r4 = DoubleVector.fromArray(S, st, o + 4 * LINE);
        var r5 = DoubleVector.fromArray(S, st, o + 5 * LINE);
        var r6 = DoubleVector.fromArray(S, st, o + 6 * LINE);
        var r7 = DoubleVector.fromArray(S, st, o + 7 * LINE);
        var s0 = r0.blend(r1.rearrange(SWAP_1), ODD_1);
        var s1 = r0.rearrange(SWAP_1).blend(r1, ODD_1);
        var s2 = r2.blend(r3.rearrange(SWAP_1), ODD_1);
        var s3 = r2.rearrange(SWAP_1).blend(r3, ODD_1);
        var s4 = r4.blend(r5.rearrange(SWAP_1), ODD_1);
        var s5 = r4.rearrange(SWAP_1).blend(r5, ODD_1);
        var s6 = r6.blend(r7.rearrange(SWAP_1), ODD_1);
        var s7 = r6.rearrange(SWAP_1).blend(r7, ODD_1);
        var t0 = s0.blend(s2.rearrange(SWAP_2), ODD_2);
        var t2 = s0.rearrange(SWAP_2).blend(s2, ODD_2);
        var t1 = s1.blend(s3.rearrange(SWAP_2), ODD_2);
        var t3 = s1.rearrange(SWAP_2).blend(s3, ODD_2);
        var t4 = s4.blend(s6.rearrange(SWAP_2), ODD_2);
        var t6 = s4.rearrange(SWAP_2).blend(s6, ODD_2);
        var t5 = s5.blend(s7.rearrange(SWAP_2), ODD_2);
        var t7 = s5.rearrange(SWAP_2).blend(s7, ODD_2);
        var u0 = t0.blend(t4.rearrange(SWAP_4), ODD_4);
        var u4 = t0.rearrange(SWAP_4).blend(t4, ODD_4);
        var u1 = t1.blend(t5.rearrange(SWAP_4), ODD_4);
        var u5 = t1.rearrange(SWAP_4).blend(t5, ODD_4);
        var u2 = t2.blend(t6.rearrange(SWAP_4), ODD_4);
        var u6 = t2.rearrange(SWAP_4).blend(t6, ODD_4);
        var u3 = t3.blend(t7.rearrange(SWAP_4), ODD_4);
        var u7 = t3.rearrange(SWAP_4).blend(t7, ODD_4);
        int b0 = link[l];
        if (b0 != 0) {
            u0.intoArray(body, b0);
        }
        int b1 = link[l + LINK];
        if (b1 != 0) {
            u1.intoArray(body, b1);
        }
        int b2 = link[l + 2 * LINK];
        if (b2 != 0) {
            u2.intoArray(body, b2);
        }
        int b3 = link[l + 3 * LINK];
        if (b3 != 0) {
            u3.intoArray(body, b3);
        }
        int b4 = link[l + 4 * LINK];
        if (b4 != 0) {
            u4.intoArray(body, b4);
        }
        int b5 = link[l + 5 * LINK];
        if (b5 != 0) {
            u5.intoArray(body, b5);
        }
        int b6 = link[l + 6 * LINK];
        if (b6 != 0) {
            u6.intoArray(body, b6);
        }
        int b7 = link[l + 7 * LINK];
        if (b7 != 0) {
            u7.intoArray(body, b7);
        }
    }
}
