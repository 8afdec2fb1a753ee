package dev.cairn.physics.solver.kernel;

import static dev.cairn.physics.solver.row.ConstraintRows.*;

import dev.cairn.physics.solver.row.ConstraintRows;

/**
 * What the impulses of a row do to the velocities of its bodies, added to their warm start: {@code
 * M^-1 J^T lambda}. Bodies that do not move stay untouched.
 */
public final class WarmStart {
    private WarmStart() {}

    /** Adds the velocities that the friction and twist of a row make, times {@code sign}. */
    public static void addFriction(ConstraintRows rows, double[] warm, int j, int o, double sign) {
        double[] d = rows.doubles;
        int lanes = rows.lanes;
        int a = rows.link[j * LINK];
        int b = rows.link[j * LINK + 1];
        int t1 = o + TANGENT1 * lanes;
        int t2 = o + TANGENT2 * lanes;
        int lever = o + LEVER * lanes;
        int three = 3 * lanes;
        int t = o + TWIST * lanes;
        double f1 = sign * d[o + LAMBDA * lanes];
        double f2 = sign * d[o + (LAMBDA + 1) * lanes];
        double f3 = sign * d[o + (LAMBDA + 2) * lanes];
        double ma = d[o + MASS_A * lanes];
        double mb = d[o + MASS_B * lanes];
        push(warm, a, b, ma * f1, mb * f1, d[t1], d[t1 + lanes], d[t1 + 2 * lanes]);
        push(warm, a, b, ma * f2, mb * f2, d[t2], d[t2 + lanes], d[t2 + 2 * lanes]);
        turn(warm, a, b, d, lever, lever + 2 * three, lanes, f1);
        turn(warm, a, b, d, lever + three, lever + 3 * three, lanes, f2);
        turn(warm, a, b, d, t, t + three, lanes, f3);
    }

    /** Adds the velocities that the normal impulses of a row make, times {@code sign}. */
    public static void addNormals(ConstraintRows rows, double[] warm, int j, int o, double sign) {
        double[] d = rows.doubles;
        int lanes = rows.lanes;
        int a = rows.link[j * LINK];
        int b = rows.link[j * LINK + 1];
        double sum = 0;
        for (int i = 0; i < rows.link[j * LINK + ConstraintRows.COUNT]; i++) {
            int q = o + (POINT + i * POINT_FIELDS) * lanes;
            double impulse = sign * d[q + IMPULSE * lanes];
            turn(warm, a, b, d, q + ARM_A * lanes, q + ARM_B * lanes, lanes, impulse);
            sum += impulse;
        }
        double ma = d[o + MASS_A * lanes] * sum;
        double mb = d[o + MASS_B * lanes] * sum;
        push(warm, a, b, ma, mb, d[o], d[o + lanes], d[o + 2 * lanes]);
    }

    /** Linear part of an impulse along n. */
    static void push(
            double[] warm, int a, int b, double ka, double kb, double nx, double ny, double nz) {
        if (a != 0) {
            int i = a >> 1;
            warm[i] -= ka * nx;
            warm[i + 1] -= ka * ny;
            warm[i + 2] -= ka * nz;
        }
        if (b != 0) {
            int i = b >> 1;
            warm[i] += kb * nx;
            warm[i + 1] += kb * ny;
            warm[i + 2] += kb * nz;
        }
    }

    /** Angular part of an impulse whose weighted arms are at {@code ia} and {@code ib}. */
    static void turn(
            double[] warm, int a, int b, double[] d, int ia, int ib, int lanes, double impulse) {
        if (a != 0) {
            int i = (a >> 1) + 3;
            warm[i] -= impulse * d[ia];
            warm[i + 1] -= impulse * d[ia + lanes];
            warm[i + 2] -= impulse * d[ia + 2 * lanes];
        }
        if (b != 0) {
            int i = (b >> 1) + 3;
            warm[i] += impulse * d[ib];
            warm[i + 1] += impulse * d[ib + lanes];
            warm[i + 2] += impulse * d[ib + 2 * lanes];
        }
    }

    /** Zeros leave positive: what a lane has to add nothing of could still turn a -0. */
    static void positive(double[] warm, int body) {
        int i = body >> 1;
        for (int end = body == 0 ? i : i + 6; i < end; i++) {
            warm[i] += 0.0;
        }
    }
}
