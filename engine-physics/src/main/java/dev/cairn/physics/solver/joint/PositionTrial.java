package dev.cairn.physics.solver.joint;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.JointStore;
import dev.cairn.physics.solver.body.Motion;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.SubStep;

/**
 * A trial of the position half: the bodies moved with the impulses so far, what joints lack there,
 * and what is done where trials lead nowhere.
 */
abstract class PositionTrial extends VelocityHalf {
    /** Whether contacts were just solved with the joints, so that {@code J(x) v = 0}. */
    boolean isHeld;

    private double keptTime;

    /** Moves the bodies as the sub-step will. */
    void move() {
        double[] g = tick.gravity;
        for (int i : s.body) {
            Motion.drift(tick.bodies, tick.body, i, g[0], g[1], g[2], h);
        }
        s.time += h;
    }

    void keep() {
        BodyStore b = tick.bodies;
        keptTime = s.time;
        for (int n = 0; n < s.body.length; n++) {
            int i = s.body[n];
            int o = SolverBodies.offset(i);
            int at = Assembly.KEPT * n;
            System.arraycopy(tick.body.state, o, s.kept, at, 6);
            System.arraycopy(tick.body.state, o + SolverBodies.P, s.kept, at + 6, 6);
            int w = (i + 1) * SolverBodies.HALF;
            System.arraycopy(tick.body.mark, w, s.kept, at + 12, 6);
            s.kept[at + 18] = b.orientationX[i];
            s.kept[at + 19] = b.orientationY[i];
            s.kept[at + 20] = b.orientationZ[i];
            s.kept[at + 21] = b.orientationW[i];
        }
    }

    void restore() {
        BodyStore b = tick.bodies;
        s.time = keptTime;
        for (int n = 0; n < s.body.length; n++) {
            int i = s.body[n];
            int o = SolverBodies.offset(i);
            int at = Assembly.KEPT * n;
            System.arraycopy(s.kept, at, tick.body.state, o, 6);
            System.arraycopy(s.kept, at + 6, tick.body.state, o + SolverBodies.P, 6);
            int w = (i + 1) * SolverBodies.HALF;
            System.arraycopy(s.kept, at + 12, tick.body.mark, w, 6);
            b.orientationX[i] = s.kept[at + 18];
            b.orientationY[i] = s.kept[at + 19];
            b.orientationZ[i] = s.kept[at + 20];
            b.orientationW[i] = s.kept[at + 21];
        }
    }

    /** What the rows measure in the poses of now. */
    void measure() {
        math.at(s.carriedRoot > 0 ? s.time : 0, tick.step);
        for (int k = 0; k < s.joint.length; k++) {
            int j = s.joint[k];
            math.look(tick.bodies, tick.body.state, store, j, offset(k, 0), offset(k, 1));
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                s.now[r] = math.measure(store, j, store.law[row(k, r)]);
            }
        }
    }

    /** Writes what is missing over h to {@link Assembly#now}; the worst, over its size. */
    double residuals() {
        double worst = 0;
        for (int k = 0; k < s.joint.length; k++) {
            double size = size(k);
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                int row = row(k, r);
                if (!s.isActive[r]) {
                    s.now[r] = 0;
                    continue;
                }
                double m = miss(r, row);
                boolean isAngle = JointMath.isAngle(store.law[row]);
                worst = Math.max(worst, Math.abs(isAngle ? m : m / size));
                if (Double.isNaN(m)) {
                    worst = Double.POSITIVE_INFINITY;
                }
                s.now[r] = m / h;
            }
        }
        return worst;
    }

    /**
     * Others hold than before: begins anew, as impulses that fought each other lead so far that
     * angles no longer tell.
     */
    void again() {
        comeBack();
        for (int k = 0; k < s.joint.length; k++) {
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                int row = row(k, r);
                boolean isDriven = store.role[row] >= JointStore.MOTOR && !isRound(k, row);
                if (!s.isActive[r] && store.role[row] == JointStore.LIMIT) {
                    set(k, r, 0);
                } else if (!s.isActive[r] && isDriven) {
                    double most = bound(row);
                    set(k, r, store.held[row] == 0 ? 0 : store.held[row] * most);
                }
            }
        }
    }

    /** Whether no springs share a largest force: these are sought step by step. */
    boolean isFirm() {
        for (int j : s.joint) {
            if (store.isRound[j]) {
                return false;
            }
        }
        return true;
    }

    /**
     * One round, or two where limits and motors may let go, of a solution that is rough itself.
     * What stays open is closed aside.
     */
    void approach(double most) {
        for (int round = 0; round < (s.isRigid ? 1 : 2); round++) {
            keep();
            move();
            measure();
            restore();
            hold(round, 0);
            residuals();
            factor(true);
            correct();
        }
        if (!(kinetic() <= most + work())) {
            takeBack();
            release();
        }
    }

    /**
     * Where Newton's method fails: its first round alone, and if that adds too much energy, no
     * impulse at all. What stands on something is stopped where joints hold it then, {@code J(x) v'
     * = 0}, which only takes energy away: its contacts are solved from there.
     */
    void project(double most) {
        takeBack();
        if (!isHeld) {
            single();
        } else if (!s.isRigid) {
            return;
        }
        if (isHeld || !(kinetic() <= most + work())) {
            takeBack();
            release();
            if (s.touchCount > 0) {
                rest();
                if (!(kinetic() <= most + work())) {
                    takeBack();
                    release();
                }
            }
        }
    }

    void single() {
        release();
        activate(true);
        keep();
        move();
        measure();
        restore();
        for (int k = 0; k < s.joint.length && !s.isRigid; k++) {
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                if (store.role[row(k, r)] == JointStore.LIMIT) {
                    limit(k, r, row(k, r), false);
                }
            }
        }
        residuals();
        factor(true);
        correct();
    }

    /**
     * Solves what the assembly stands on, with its joints and the limits that it is driven into. It
     * may not gain much by it, or contacts and joints contradict each other, and nothing is done.
     */
    void land(ConstraintRows rows, SubStep sub) {
        note();
        noteImpacts();
        double most = GUESS * (motion(rows) + pushed(rows, sub) + work());
        rest();
        carry(rows, sub, true);
        for (int round = 1; !s.isRigid && round < MEETINGS; round++) {
            keep();
            move();
            measure();
            restore();
            if (!meet(true, round)) {
                break;
            }
            rest();
            carry(rows, sub, true);
        }
        if (!(motion(rows) <= most)) {
            unload(rows, sub, true);
            takeBack();
        }
    }

    /**
     * Stops bodies where locks hold them, {@code J(x) v' = 0}, and lets limits be reached. Motors
     * keep the speed that they have.
     */
    void rest() {
        for (int k = 0; k < s.joint.length && s.isDriven; k++) {
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                s.driven[r] = speed(k, r);
            }
        }
        for (int k = 0; k < s.joint.length; k++) {
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                if (store.role[row(k, r)] < JointStore.MOTOR) {
                    set(k, r, 0);
                }
            }
        }
        for (int k = 0; k < s.joint.length; k++) {
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                int row = row(k, r);
                s.now[r] = speed(k, r) - (store.role[row] < JointStore.MOTOR ? 0 : s.driven[r]);
                if (s.isActive[r] && store.role[row] == JointStore.LIMIT) {
                    double way = (store.held[row] < 0 ? store.lower[row] : store.upper[row]);
                    way -= s.start[r];
                    s.now[r] -= way * store.held[row] > 0 ? way / h : 0;
                }
            }
        }
        factor(true);
        correct();
    }
}
