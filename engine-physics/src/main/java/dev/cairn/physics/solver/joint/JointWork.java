package dev.cairn.physics.solver.joint;

import dev.cairn.physics.internal.JointStore;
import dev.cairn.physics.solver.body.SolverBodies;

/**
 * What motors and springs may give, and the way back: velocities and impulses of before a half of
 * the sub-step, to which it returns if more energy has come than that.
 */
abstract class JointWork extends ContactCoupling {
    /**
     * Energy that impulses may add beside contacts. Those of a turning link turn with it and add
     * {@code (w h)²/4}; more than this is no turn, but sweeps and joints that pull against each
     * other.
     */
    static final double GAIN = 1.05;

    /** Begin of a tick: whether a motor or a spring acts. */
    void findDrives() {
        s.isDriven = false;
        for (int j : s.joint) {
            for (int r = store.firstRow[j]; r < store.firstRow[j] + store.rows[j]; r++) {
                s.isDriven |= store.role[r] >= JointStore.MOTOR;
            }
        }
    }

    /** Energy of all springs, J: {@code k x²/2} up to where their force ends, then straight on. */
    private double stored() {
        derive();
        double sum = 0;
        for (int k = 0; k < s.joint.length; k++) {
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                int row = row(k, r);
                if (store.role[row] == JointStore.SPRING && s.compliance[r] > 0) {
                    double x = s.start[r] - store.target[row];
                    x = Math.abs(JointMath.isAngle(store.law[row]) ? Angles.wrap(x) : x);
                    double stiff = stiffness(r, row);
                    double end = Math.min(x, store.most[row] / stiff);
                    sum += stiff > 0 ? stiff * end * (x - 0.5 * end) : 0;
                }
            }
        }
        return sum;
    }

    /** Keeps velocities and impulses of before a half. */
    void note() {
        for (int n = 0; n < s.body.length; n++) {
            int i = s.body[n];
            int w = (i + 1) * SolverBodies.HALF;
            System.arraycopy(
                    tick.body.state, SolverBodies.offset(i), s.first, Assembly.FIRST * n, 6);
            System.arraycopy(tick.body.mark, w, s.first, Assembly.FIRST * n + 6, 6);
        }
        System.arraycopy(s.impulse, 0, s.firstImpulse, 0, s.impulse.length);
    }

    void comeBack() {
        for (int n = 0; n < s.body.length; n++) {
            int i = s.body[n];
            int w = (i + 1) * SolverBodies.HALF;
            System.arraycopy(
                    s.first, Assembly.FIRST * n, tick.body.state, SolverBodies.offset(i), 6);
            System.arraycopy(s.first, Assembly.FIRST * n + 6, tick.body.mark, w, 6);
        }
        System.arraycopy(s.firstImpulse, 0, s.impulse, 0, s.impulse.length);
    }

    /** Makes them those of now, where limits, motors or springs act. */
    void takeBack() {
        if (s.isRigid) {
            return;
        }
        comeBack();
        for (int k = 0; k < s.joint.length; k++) {
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                // what was found of motors on the way is as wrong as the impulses
                if (store.role[row(k, r)] == JointStore.MOTOR) {
                    store.held[row(k, r)] = 0;
                }
            }
        }
    }

    /**
     * Energy that motors and springs may give in a half, J: impulse times the speed that is wanted,
     * as a motor brakes beyond that, and what is stored.
     */
    double work() {
        double sum = 0;
        for (int k = 0; k < s.joint.length && s.isDriven; k++) {
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                int row = row(k, r);
                if (store.role[row] == JointStore.MOTOR) {
                    sum +=
                            Math.min(Math.abs(s.impulse[r]), bound(row))
                                    * Math.abs(store.target[row]);
                }
            }
        }
        return s.isDriven ? 2 * (sum + stored()) : 0;
    }
}
