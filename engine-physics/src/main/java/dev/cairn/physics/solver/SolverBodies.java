package dev.cairn.physics.solver;

import dev.cairn.physics.internal.BodyStore;

import java.util.Arrays;

/**
 * What the solver holds of each body, by slot: 16 doubles in a row, so that a contact gathers a
 * body from two cache lines.
 */
final class SolverBodies {
    /** Doubles to a slot of {@link #state}. */
    static final int STRIDE = 16;

    /** Velocity of the centre of mass, world, m/s; angular velocity at {@code V + 3}, rad/s. */
    static final int V = 0;

    /** Movement since the start of the tick, world, m; turn since then at {@code P + 3}, rad. */
    static final int P = 6;

    /** 1 if a contact pressed on the body in this sub-step, else 0. */
    static final int LOADED = 12;

    /** Inverse mass in the solver, 1/kg. */
    static final int MASS = 13;

    /** Factor on gravity in the solver. */
    static final int GRAVITY = 14;

    /** Value of {@link #guide}: no contact has points, the body flies the whole tick in one go. */
    static final int FREE = -2;

    /** Value of {@link #guide}: the body has contacts and takes sub-steps. */
    static final int BOUND = -1;

    double[] state = {};

    /** World inverse inertia in the solver, 6 to a slot: xx yy zz xy xz yz. */
    double[] inverseInertia = {};

    /**
     * For guided bodies: velocity at the start of the sub-step, and velocity that moved it. 6 to a
     * slot.
     */
    double[] glide = {};

    /**
     * {@link #FREE}, {@link #BOUND}, or the only row of the body where its partner is static: the
     * body is guided.
     */
    int[] guide = {};

    /**
     * Flight: what the last additions to position and velocity lost to rounding, then position and
     * velocity as they were left; 12 to a slot. A body that something else has moved starts anew.
     */
    double[] carry = {};

    final PrincipalAxes axes = new PrincipalAxes();

    void ensureCapacity(int slots) {
        if (slots > guide.length) {
            int n = Math.max(slots, guide.length + (guide.length >> 1));
            state = Arrays.copyOf(state, n * STRIDE);
            inverseInertia = Arrays.copyOf(inverseInertia, n * 6);
            glide = Arrays.copyOf(glide, n * 6);
            carry = Arrays.copyOf(carry, n * 12);
            guide = Arrays.copyOf(guide, n);
        }
        axes.ensureCapacity(slots);
    }

    /** Makes slot {@code i} an immovable thing at rest. */
    void loadStatic(int i) {
        Arrays.fill(state, i * STRIDE, (i + 1) * STRIDE, 0.0);
        Arrays.fill(inverseInertia, i * 6, i * 6 + 6, 0.0);
    }

    /** Loads a body that has contacts; keeps {@link #LOADED} of the last sub-step. */
    void loadBound(BodyStore b, int i, double massScale) {
        double[] s = state;
        int o = i * STRIDE;
        s[o + V] = b.velocityX[i];
        s[o + V + 1] = b.velocityY[i];
        s[o + V + 2] = b.velocityZ[i];
        s[o + V + 3] = b.angularVelocityX[i];
        s[o + V + 4] = b.angularVelocityY[i];
        s[o + V + 5] = b.angularVelocityZ[i];
        for (int k = P; k < P + 6; k++) {
            s[o + k] = 0;
        }
        double inverse = 1 / massScale;
        s[o + MASS] = b.inverseMass[i] * inverse;
        s[o + GRAVITY] = inverse;
        worldInverseInertia(b, i, inverse);
    }

    /** {@code R I^-1 R^T}, times {@code scale}. */
    private void worldInverseInertia(BodyStore b, int i, double scale) {
        double[] d = inverseInertia;
        int o = 6 * i;
        double xx = b.inverseInertiaXX[i] * scale;
        if (axes.isotropic[i]) {
            d[o] = xx;
            d[o + 1] = xx;
            d[o + 2] = xx;
            d[o + 3] = 0;
            d[o + 4] = 0;
            d[o + 5] = 0;
            return;
        }
        double yy = b.inverseInertiaYY[i] * scale;
        double zz = b.inverseInertiaZZ[i] * scale;
        double xy = b.inverseInertiaXY[i] * scale;
        double xz = b.inverseInertiaXZ[i] * scale;
        double yz = b.inverseInertiaYZ[i] * scale;
        double qx = b.orientationX[i];
        double qy = b.orientationY[i];
        double qz = b.orientationZ[i];
        double qw = b.orientationW[i];
        double r00 = 1 - 2 * (qy * qy + qz * qz);
        double r01 = 2 * (qx * qy - qw * qz);
        double r02 = 2 * (qx * qz + qw * qy);
        double r10 = 2 * (qx * qy + qw * qz);
        double r11 = 1 - 2 * (qx * qx + qz * qz);
        double r12 = 2 * (qy * qz - qw * qx);
        double r20 = 2 * (qx * qz - qw * qy);
        double r21 = 2 * (qy * qz + qw * qx);
        double r22 = 1 - 2 * (qx * qx + qy * qy);
        // T = R I^-1
        double t00 = r00 * xx + r01 * xy + r02 * xz;
        double t01 = r00 * xy + r01 * yy + r02 * yz;
        double t02 = r00 * xz + r01 * yz + r02 * zz;
        double t10 = r10 * xx + r11 * xy + r12 * xz;
        double t11 = r10 * xy + r11 * yy + r12 * yz;
        double t12 = r10 * xz + r11 * yz + r12 * zz;
        double t20 = r20 * xx + r21 * xy + r22 * xz;
        double t21 = r20 * xy + r21 * yy + r22 * yz;
        double t22 = r20 * xz + r21 * yz + r22 * zz;
        d[o] = t00 * r00 + t01 * r01 + t02 * r02;
        d[o + 1] = t10 * r10 + t11 * r11 + t12 * r12;
        d[o + 2] = t20 * r20 + t21 * r21 + t22 * r22;
        d[o + 3] = t00 * r10 + t01 * r11 + t02 * r12;
        d[o + 4] = t00 * r20 + t01 * r21 + t02 * r22;
        d[o + 5] = t10 * r20 + t11 * r21 + t12 * r22;
    }

    /** Writes velocities and the movement of the tick back; the orientation was kept up to date. */
    void store(BodyStore b, int i) {
        double[] s = state;
        int o = i * STRIDE;
        b.velocityX[i] = s[o + V];
        b.velocityY[i] = s[o + V + 1];
        b.velocityZ[i] = s[o + V + 2];
        b.angularVelocityX[i] = s[o + V + 3];
        b.angularVelocityY[i] = s[o + V + 4];
        b.angularVelocityZ[i] = s[o + V + 5];
        b.positionX[i] += s[o + P];
        b.positionY[i] += s[o + P + 1];
        b.positionZ[i] += s[o + P + 2];
    }
}
