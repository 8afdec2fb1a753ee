package dev.cairn.physics.solver.body;

import static dev.cairn.physics.solver.body.SolverBodies.GRAVITY;
import static dev.cairn.physics.solver.body.SolverBodies.LOADED;
import static dev.cairn.physics.solver.body.SolverBodies.MASS;
import static dev.cairn.physics.solver.body.SolverBodies.P;
import static dev.cairn.physics.solver.body.SolverBodies.V;

import dev.cairn.physics.internal.BodyStore;

/** Integrators of one body: flight, kick, drift. */
public final class Motion {
    private Motion() {}

    /**
     * A tick without contacts: {@code x += t v + t²/2 a, v += t a}, the parabola itself; rotation
     * in {@code substeps} Strang steps between half kicks of the torque.
     */
    public static void fly(
            BodyStore b,
            SolverBodies s,
            int i,
            double gx,
            double gy,
            double gz,
            double t,
            int substeps) {
        double m = b.inverseMass[i];
        double scale = b.gravityScale[i];
        double ax = scale * gx + m * b.forceX[i];
        double ay = scale * gy + m * b.forceY[i];
        double az = scale * gz + m * b.forceZ[i];
        if (b.motionFlags[i] != 0) {
            AxisLocks.fly(b, s, i, ax, ay, az, t, substeps);
            return;
        }
        double half = 0.5 * t * t;
        double[] c = s.carry;
        int q = 12 * i;
        if (b.isFar) {
            remember(b, c, q, i);
        }
        b.positionX[i] =
                add(
                        c,
                        q,
                        b.positionX[i],
                        t * b.velocityX[i],
                        t * lost(c, q + 3, b.velocityX[i]) + half * ax);
        b.positionY[i] =
                add(
                        c,
                        q + 1,
                        b.positionY[i],
                        t * b.velocityY[i],
                        t * lost(c, q + 4, b.velocityY[i]) + half * ay);
        b.positionZ[i] =
                add(
                        c,
                        q + 2,
                        b.positionZ[i],
                        t * b.velocityZ[i],
                        t * lost(c, q + 5, b.velocityZ[i]) + half * az);
        if (b.isFar || b.isFar(i)) {
            boolean far = b.isFar(i);
            b.lack(i, far ? c[q] : 0, far ? c[q + 1] : 0, far ? c[q + 2] : 0);
        }
        b.velocityX[i] = add(c, q + 3, b.velocityX[i], t * ax, 0);
        b.velocityY[i] = add(c, q + 4, b.velocityY[i], t * ay, 0);
        b.velocityZ[i] = add(c, q + 5, b.velocityZ[i], t * az, 0);
        s.state[SolverBodies.offset(i) + LOADED] = 0;
        spin(b, s, i, t, substeps);
    }

    /** What the position has lacked since the body had contacts is where its flight starts. */
    private static void remember(BodyStore b, double[] c, int q, int i) {
        double[] low = b.positionLow;
        int k = 3 * i;
        if (low[k] != 0 || low[k + 1] != 0 || low[k + 2] != 0) {
            System.arraycopy(low, k, c, q, 3);
            c[q + 6] = b.positionX[i];
            c[q + 7] = b.positionY[i];
            c[q + 8] = b.positionZ[i];
        }
    }

    /**
     * Rotation of a tick without contacts; damped, for the body's own time of {@link AxisLocks}.
     */
    static void spin(BodyStore b, SolverBodies s, int i, double t, int substeps) {
        double[] w = s.state;
        int o = SolverBodies.offset(i) + V + 3;
        w[o] = b.angularVelocityX[i];
        w[o + 1] = b.angularVelocityY[i];
        w[o + 2] = b.angularVelocityZ[i];
        boolean driven = b.torqueX[i] != 0 || b.torqueY[i] != 0 || b.torqueZ[i] != 0;
        int parts = driven ? substeps : 1;
        double h = t / parts;
        double damping = b.angularDamping[i];
        double own = damping == 0 ? h : h * AxisLocks.mean(damping * h);
        double left = damping == 0 ? 1 : AxisLocks.decay(damping * h);
        if (driven) {
            spinUp(b, s, i, 0.5 * h);
        }
        for (int k = 0; k < parts; k++) {
            rotate(b, s, i, driven ? own : own / substeps, driven ? 1 : substeps);
            w[o] *= left;
            w[o + 1] *= left;
            w[o + 2] *= left;
            if (driven) {
                spinUp(b, s, i, k + 1 == parts ? 0.5 * h : h);
            }
        }
        b.angularVelocityX[i] = w[o];
        b.angularVelocityY[i] = w[o + 1];
        b.angularVelocityZ[i] = w[o + 2];
    }

    /**
     * What rounding has taken from {@code value} so far, if it is still the value of the last tick.
     */
    private static double lost(double[] c, int q, double value) {
        return c[q + 6] == value ? c[q] : 0;
    }

    /**
     * {@code value + large + small} with compensation (Kahan 1965): a flight of hours keeps to its
     * parabola.
     */
    private static double add(double[] c, int q, double value, double large, double small) {
        double step = large + (small + lost(c, q, value));
        double sum = value + step;
        // exact error of the addition (Knuth's two-sum)
        double part = sum - value;
        c[q] = (value - (sum - part)) + (step - part);
        c[q + 6] = sum;
        return sum;
    }

    /** {@code w += t R I^-1 R^T torque} at the present orientation. */
    private static void spinUp(BodyStore b, SolverBodies s, int i, double t) {
        double qx = -b.orientationX[i];
        double qy = -b.orientationY[i];
        double qz = -b.orientationZ[i];
        double qw = b.orientationW[i];
        double x = t * b.torqueX[i];
        double y = t * b.torqueY[i];
        double z = t * b.torqueZ[i];
        double ux = 2 * (qy * z - qz * y);
        double uy = 2 * (qz * x - qx * z);
        double uz = 2 * (qx * y - qy * x);
        double lx = x + qw * ux + (qy * uz - qz * uy);
        double ly = y + qw * uy + (qz * ux - qx * uz);
        double lz = z + qw * uz + (qx * uy - qy * ux);
        x = b.inverseInertiaXX[i] * lx + b.inverseInertiaXY[i] * ly + b.inverseInertiaXZ[i] * lz;
        y = b.inverseInertiaXY[i] * lx + b.inverseInertiaYY[i] * ly + b.inverseInertiaYZ[i] * lz;
        z = b.inverseInertiaXZ[i] * lx + b.inverseInertiaYZ[i] * ly + b.inverseInertiaZZ[i] * lz;
        ux = 2 * (qz * y - qy * z);
        uy = 2 * (qx * z - qz * x);
        uz = 2 * (qy * x - qx * y);
        int o = SolverBodies.offset(i) + V + 3;
        s.state[o] += x + qw * ux - (qy * uz - qz * uy);
        s.state[o + 1] += y + qw * uy - (qz * ux - qx * uz);
        s.state[o + 2] += z + qw * uz - (qx * uy - qy * ux);
    }

    /**
     * Free rotation by {@code count} steps of {@code h} of a body whose angular velocity is in the
     * solver's state.
     */
    private static void rotate(BodyStore b, SolverBodies s, int i, double h, int count) {
        int o = SolverBodies.offset(i) + V + 3;
        double[] w = s.state;
        if (w[o] == 0 && w[o + 1] == 0 && w[o + 2] == 0) {
            return;
        }
        if (s.axes.isotropic[i]) {
            double t = h * count;
            Rotation.turn(b, i, t * w[o], t * w[o + 1], t * w[o + 2]);
        } else {
            FreeRotation.turn(b, i, s.axes.data, w, o, h, count);
        }
    }

    /**
     * Start of a sub-step of a body with contacts: {@code v += h (g + f/m), w += h I^-1 torque},
     * then the warm start, {@code v += M^-1 J^T lambda} of all its contacts.
     */
    public static void kick(
            BodyStore b, SolverBodies s, int i, double gx, double gy, double gz, double h) {
        double[] v = s.state;
        int o = SolverBodies.offset(i);
        if (s.guide[i] >= 0) {
            MotionRecord.begin(s, i);
        }
        v[o + LOADED] = 0;
        double m = v[o + MASS];
        double k = v[o + GRAVITY] * b.gravityScale[i];
        double hv = h;
        double hw = h;
        int motionFlags = b.motionFlags[i];
        if (motionFlags != 0) {
            AxisLocks.damp(b, v, i, h);
            hv = h * AxisLocks.mean(b.linearDamping[i] * h);
            hw = h * AxisLocks.mean(b.angularDamping[i] * h);
        }
        v[o + V] += hv * (k * gx + m * b.forceX[i]);
        v[o + V + 1] += hv * (k * gy + m * b.forceY[i]);
        v[o + V + 2] += hv * (k * gz + m * b.forceZ[i]);
        double x = hw * b.torqueX[i];
        double y = hw * b.torqueY[i];
        double z = hw * b.torqueZ[i];
        if (x != 0 || y != 0 || z != 0) {
            double[] d = s.root;
            int q = (i + 1) * SolverBodies.ROOT;
            v[o + V + 3] += d[q] * x + d[q + 3] * y + d[q + 6] * z;
            v[o + V + 4] += d[q + 1] * x + d[q + 4] * y + d[q + 7] * z;
            v[o + V + 5] += d[q + 2] * x + d[q + 5] * y + d[q + 8] * z;
        }
        if (s.guide[i] >= 0) {
            MotionRecord.forced(s, i);
        } else if (s.boundsEnergy) {
            MotionRecord.free(s, i);
        }
        int w = (i + 1) * SolverBodies.HALF;
        for (int c = 0; c < 6; c++) {
            v[o + c] += s.warm[w + c];
        }
        if (motionFlags != 0) {
            AxisLocks.lock(b, v, o);
        }
        System.arraycopy(v, o, s.mark, w, 6);
    }

    /**
     * Moves a body with contacts. Under load {@code x += h v}: the velocity holds at the end of the
     * sub-step, which is what the contacts were solved for. Without load {@code x += h v - h²/2 a}:
     * the parabola.
     */
    public static void drift(
            BodyStore b, SolverBodies s, int i, double gx, double gy, double gz, double h) {
        double[] v = s.state;
        int o = SolverBodies.offset(i);
        double turn = h;
        double half = 0.5 * h;
        double over = 1;
        if (b.motionFlags[i] != 0) {
            AxisLocks.lock(b, v, o);
            if (v[o + LOADED] == 0) {
                turn = h * AxisLocks.meanOverEnd(b.angularDamping[i] * h);
                over = AxisLocks.meanOverEnd(b.linearDamping[i] * h);
                half = h * AxisLocks.behind(b.linearDamping[i] * h);
            }
        }
        double vx = over * v[o + V];
        double vy = over * v[o + V + 1];
        double vz = over * v[o + V + 2];
        if (v[o + LOADED] == 0) {
            double m = v[o + MASS];
            double k = v[o + GRAVITY] * b.gravityScale[i];
            vx -= half * (k * gx + m * b.forceX[i]);
            vy -= half * (k * gy + m * b.forceY[i]);
            vz -= half * (k * gz + m * b.forceZ[i]);
            int locks = b.motionFlags[i];
            vx = (locks & 1) != 0 ? 0 : vx;
            vy = (locks & 2) != 0 ? 0 : vy;
            vz = (locks & 4) != 0 ? 0 : vz;
        } else if (s.guide[i] >= 0) {
            MotionRecord.moves(s, i, vx, vy, vz);
        }
        v[o + P] += h * vx;
        v[o + P + 1] += h * vy;
        v[o + P + 2] += h * vz;
        v[o + P + 3] += h * v[o + V + 3];
        v[o + P + 4] += h * v[o + V + 4];
        v[o + P + 5] += h * v[o + V + 5];
        turn(b, s, i, turn);
        if (s.guide[i] >= 0) {
            MotionRecord.turned(s, i);
        }
    }

    /**
     * Free rotation by {@code h} of a body whose weighted angular velocity is in the solver's
     * state; what it changes of it is no contact's doing.
     */
    private static void turn(BodyStore b, SolverBodies s, int i, double h) {
        int o = SolverBodies.offset(i) + V + 3;
        double[] w = s.state;
        if (w[o] == 0 && w[o + 1] == 0 && w[o + 2] == 0) {
            return;
        }
        double x = s.world(i, o, 0);
        double y = s.world(i, o, 1);
        double z = s.world(i, o, 2);
        if (s.axes.isotropic[i]) {
            Rotation.turn(b, i, h * x, h * y, h * z);
            return;
        }
        double u = w[o];
        double v = w[o + 1];
        double t = w[o + 2];
        w[o] = x;
        w[o + 1] = y;
        w[o + 2] = z;
        FreeRotation.turn(b, i, s.axes.data, w, o, h, 1);
        s.weigh(i, w[o], w[o + 1], w[o + 2]);
        int m = (i + 1) * SolverBodies.HALF + 3;
        s.mark[m] += w[o] - u;
        s.mark[m + 1] += w[o + 1] - v;
        s.mark[m + 2] += w[o + 2] - t;
    }

    /**
     * Gives a body whose rows stay as they are the root of its present inertia, once it turns so
     * far within a sub-step that energy would no longer be half a square in the old one. A body
     * that an impact has struck in this tick gets it however slowly it turns: a box that fell
     * without spin and bounced on a corner gained 2e-3 of its energy until the tick was over.
     *
     * @param h length of the sub-step, s
     */
    public static void renewRoot(BodyStore b, SolverBodies s, int i, double h) {
        boolean struck = s.motion[MotionRecord.STRIDE * i + MotionRecord.STRUCK] != 0;
        if (s.axes.isIsotropic(i) || !(struck || s.turnsFar(i, h))) {
            return;
        }
        int o = SolverBodies.offset(i) + V + 3;
        int w = (i + 1) * SolverBodies.HALF + 3;
        double x = s.world(i, o, 0);
        double y = s.world(i, o, 1);
        double z = s.world(i, o, 2);
        // what the contacts have given so far stays
        for (int c = 0; c < 3; c++) {
            s.mark[w + c] -= s.state[o + c];
        }
        s.rootOfInertia(b, i, s.state[SolverBodies.offset(i) + GRAVITY]);
        s.weigh(i, x, y, z);
        for (int c = 0; c < 3; c++) {
            s.mark[w + c] += s.state[o + c];
        }
    }

    /** End of a sub-step: what the contacts have done is the next warm start. */
    public static void keep(BodyStore b, SolverBodies s, int i) {
        int o = SolverBodies.offset(i);
        if (b.motionFlags[i] != 0) {
            AxisLocks.lock(b, s.state, o);
        }
        int w = (i + 1) * SolverBodies.HALF;
        for (int c = 0; c < 6; c++) {
            s.warm[w + c] += s.state[o + c] - s.mark[w + c];
        }
    }
}
