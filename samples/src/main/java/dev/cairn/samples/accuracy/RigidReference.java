package dev.cairn.samples.accuracy;

import org.joml.Quaterniond;
import org.joml.Vector3d;

import java.util.ArrayList;
import java.util.List;

/**
 * The rotation of a free or driven rigid body by the classical Runge-Kutta method of order 4, in
 * steps so small that its error is far below the engine's: Euler's equations in the body frame and
 * {@code q' = q (0, w) / 2}. Checked against elliptic integrals by a test.
 */
final class RigidReference {
    private final double[] inertia;
    private final double[] torque;

    /** w in body axes, then x y z w of worldFromBody. */
    private final double[] y = new double[7];

    private final double[] stage = new double[7];
    private final double[][] k = new double[4][7];
    private final List<Double> flips = new ArrayList<>();

    /**
     * @param inertia principal moments along the body's axes
     * @param torque constant, world axes, N m
     * @param w angular velocity at the start; body and world axes agree then
     */
    RigidReference(double[] inertia, double[] torque, double[] w) {
        this.inertia = inertia.clone();
        this.torque = torque.clone();
        System.arraycopy(w, 0, y, 0, 3);
        y[6] = 1;
    }

    /** Moves on by {@code seconds} in {@code steps} equal steps. */
    RigidReference advance(double seconds, int steps) {
        double h = seconds / steps;
        for (int n = 0; n < steps; n++) {
            double before = y[1];
            step(h);
            if ((before < 0) != (y[1] < 0)) {
                flips.add((n + before / (before - y[1])) * h);
            }
        }
        return this;
    }

    private void step(double h) {
        slope(y, k[0]);
        slope(moved(k[0], 0.5 * h), k[1]);
        slope(moved(k[1], 0.5 * h), k[2]);
        slope(moved(k[2], h), k[3]);
        for (int i = 0; i < 7; i++) {
            y[i] += h / 6 * (k[0][i] + 2 * k[1][i] + 2 * k[2][i] + k[3][i]);
        }
    }

    private double[] moved(double[] slope, double h) {
        for (int i = 0; i < 7; i++) {
            stage[i] = y[i] + h * slope[i];
        }
        return stage;
    }

    private void slope(double[] s, double[] out) {
        double tx = 0;
        double ty = 0;
        double tz = 0;
        if (torque[0] != 0 || torque[1] != 0 || torque[2] != 0) {
            Vector3d body =
                    new Quaterniond(s[3], s[4], s[5], s[6])
                            .normalize()
                            .transformInverse(new Vector3d(torque[0], torque[1], torque[2]));
            tx = body.x;
            ty = body.y;
            tz = body.z;
        }
        // I1 w1' = (I2 - I3) w2 w3 + t1, and cyclic
        out[0] = ((inertia[1] - inertia[2]) * s[1] * s[2] + tx) / inertia[0];
        out[1] = ((inertia[2] - inertia[0]) * s[2] * s[0] + ty) / inertia[1];
        out[2] = ((inertia[0] - inertia[1]) * s[0] * s[1] + tz) / inertia[2];
        out[3] = 0.5 * (s[6] * s[0] + s[4] * s[2] - s[5] * s[1]);
        out[4] = 0.5 * (s[6] * s[1] + s[5] * s[0] - s[3] * s[2]);
        out[5] = 0.5 * (s[6] * s[2] + s[3] * s[1] - s[4] * s[0]);
        out[6] = -0.5 * (s[3] * s[0] + s[4] * s[1] + s[5] * s[2]);
    }

    Quaterniond orientation() {
        return new Quaterniond(y[3], y[4], y[5], y[6]).normalize();
    }

    double energy() {
        return 0.5
                * (inertia[0] * y[0] * y[0] + inertia[1] * y[1] * y[1] + inertia[2] * y[2] * y[2]);
    }

    /** Times at which the second component of w changed its sign, s. */
    List<Double> flips() {
        return flips;
    }
}
