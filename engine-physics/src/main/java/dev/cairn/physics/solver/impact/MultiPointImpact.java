package dev.cairn.physics.solver.impact;

import static dev.cairn.physics.solver.row.ConstraintRows.ARM_A;
import static dev.cairn.physics.solver.row.ConstraintRows.ARM_B;
import static dev.cairn.physics.solver.row.ConstraintRows.COUNT;
import static dev.cairn.physics.solver.row.ConstraintRows.GAP;
import static dev.cairn.physics.solver.row.ConstraintRows.IMPULSE;
import static dev.cairn.physics.solver.row.ConstraintRows.LINK;
import static dev.cairn.physics.solver.row.ConstraintRows.MASS;
import static dev.cairn.physics.solver.row.ConstraintRows.MASS_A;
import static dev.cairn.physics.solver.row.ConstraintRows.MASS_B;
import static dev.cairn.physics.solver.row.ConstraintRows.POINT;
import static dev.cairn.physics.solver.row.ConstraintRows.POINT_FIELDS;

import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.kernel.RowArithmetic;
import dev.cairn.physics.solver.row.ConstraintRows;

/** The normal impulses of one contact in an impact: Newton's law for all points that touch then. */
public final class MultiPointImpact {
    private static final int SWEEPS = 64;

    /** The wanted speeds after the impact; NaN for points that do not touch then. */
    public final double[] goal = new double[ContactStore.POINTS];

    // the contact in work
    private double[] d = {};
    private double[] body = {};
    private int o;
    private int lanes;
    private int a;
    private int b;
    private int points;

    /** Turns to the row at {@code place}, and to the bodies' {@link SolverBodies#state}. */
    public void open(ConstraintRows rows, int place, double[] state) {
        d = rows.doubles;
        body = state;
        lanes = rows.lanes;
        o = rows.base(place);
        a = rows.link[place * LINK];
        b = rows.link[place * LINK + 1];
        points = rows.link[place * LINK + COUNT];
    }

    /** Where a point begins in the row. */
    public int point(int p) {
        return o + (POINT + p * POINT_FIELDS) * lanes;
    }

    /**
     * First guess: the same impulse at all points that touch, such that their mean speed is right.
     * A flat symmetric impact is solved by it, so that its symmetry does not drown in the order of
     * the points.
     */
    public void uniform(double early) {
        double miss = 0;
        double response = 0;
        int n = 0;
        for (int p = 0; p < points; p++) {
            if (Double.isNaN(goal[p])) {
                continue;
            }
            n++;
            miss += speed(p) + early - goal[p];
            int q = point(p);
            for (int i = 0; i < points; i++) {
                if (!Double.isNaN(goal[i])) {
                    int r = point(i);
                    for (int k = 0; k < 6; k++) {
                        response += d[q + k * lanes] * d[r + k * lanes];
                    }
                }
            }
        }
        response += (double) n * n * (d[o + MASS_A * lanes] + d[o + MASS_B * lanes]);
        double impulse = -miss / response;
        for (int p = 0; impulse > 0 && p < points; p++) {
            if (!Double.isNaN(goal[p])) {
                d[point(p) + IMPULSE * lanes] = impulse;
                push(p, impulse);
            }
        }
    }

    /**
     * {@code v_i + early >= goal_i, l_i >= 0}, complementary, by Gauss-Seidel to convergence.
     *
     * @return the largest change of an impulse in a sweep
     */
    public double newton(double early) {
        double worst = 0;
        for (int sweep = 0; sweep < SWEEPS; sweep++) {
            double largest = 0;
            double sum = 0;
            for (int p = 0; p < points; p++) {
                if (Double.isNaN(goal[p])) {
                    continue;
                }
                int q = point(p);
                double v = speed(p) + early;
                double old = d[q + IMPULSE * lanes];
                double next = Math.max(0, old - d[q + MASS * lanes] * (v - goal[p]));
                double delta = next - old;
                d[q + IMPULSE * lanes] = next;
                largest = Math.max(largest, Math.abs(delta));
                sum += next;
                push(p, delta);
            }
            worst = Math.max(worst, largest);
            if (largest <= 1e-15 * sum) {
                break;
            }
        }
        return worst;
    }

    private void push(int p, double impulse) {
        int q = point(p);
        double ma = impulse * d[o + MASS_A * lanes];
        double mb = impulse * d[o + MASS_B * lanes];
        for (int k = 0; k < 3; k++) {
            if (a != 0) {
                body[a + k] -= ma * d[o + k * lanes];
                body[a + 3 + k] -= impulse * d[q + (ARM_A + k) * lanes];
            }
            if (b != 0) {
                body[b + k] += mb * d[o + k * lanes];
                body[b + 3 + k] += impulse * d[q + (ARM_B + k) * lanes];
            }
        }
    }

    /** Separation at the start of the sub-step. */
    double gap(int p) {
        return d[o + (GAP + p) * lanes] + along(p, a + SolverBodies.P, b + SolverBodies.P);
    }

    /** Speed of separation. */
    public double speed(int p) {
        return along(p, a, b);
    }

    /** {@code n.(yB - yA) + uB.armB - uA.armA} of the pairs (y, u) at {@code i} and {@code j}. */
    private double along(int p, int i, int j) {
        return along(p, body, i, j);
    }

    /** The same of another array. */
    public double along(int p, double[] v, int i, int j) {
        int q = point(p);
        return d[o] * (v[j] - v[i])
                + d[o + lanes] * (v[j + 1] - v[i + 1])
                + d[o + 2 * lanes] * (v[j + 2] - v[i + 2])
                + RowArithmetic.dot(d, q + ARM_B * lanes, lanes, v, j + 3)
                - RowArithmetic.dot(d, q + ARM_A * lanes, lanes, v, i + 3);
    }
}
