package dev.cairn.physics.solver.joint;

import dev.cairn.physics.internal.JointStore;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.SubStep;

/**
 * The velocity half of a sub-step: after the bodies have moved, joints are closed aside and what
 * they do not allow is taken from the velocities, {@code J(x') v = 0}.
 */
abstract class VelocityHalf extends JointWork {
    static final int ROUNDS = 12;

    /** Rounds in which limits and contacts are sought that hold together. */
    static final int MEETINGS = 8;

    /** Share of what joints do not allow that may be left of it: the next half closes joints. */
    private static final double STOPPED = 1e-9;

    /** Sweeps of contacts begin, or end. */
    public void sweeps(boolean end) {
        if (s.keeps) {
            JointEnergy.sweeps(tick, s, end);
        }
    }

    /** The same before bodies are moved. */
    public void presses(boolean end) {
        if (s.keeps) {
            JointEnergy.presses(tick, s, end);
        }
    }

    /**
     * The bodies will be moved.
     *
     * @param back share of contacts' impulses that was not there yet while they moved
     */
    public void moves(double back) {
        if (s.keeps) {
            JointEnergy.moves(tick, s, back);
        }
    }

    /** Solves contacts with the assembly: whether that changed anything. */
    boolean stands(ConstraintRows rows, SubStep sub, boolean soft) {
        if (!misses(rows, sub, soft)) {
            return false;
        }
        note();
        noteImpacts();
        double most = GUESS * (motion(rows) + pushed(rows, sub) + work());
        sweeps(false);
        carry(rows, sub, soft);
        for (int round = 1; round < MEETINGS && meet(false, round); round++) {
            halt();
            carry(rows, sub, soft);
        }
        boolean isWon = motion(rows) <= most;
        if (!isWon) {
            unload(rows, sub, soft);
            takeBack();
        }
        sweeps(true);
        return isWon;
    }

    /**
     * After the bodies have moved, and their roots are those of their present orientation. What is
     * solved by factors begins without impulses: they would be taken up by contacts, given again in
     * the next half, and grow where both can bear the same load.
     *
     * @param counts whether what is found are the impulses of the sub-step
     */
    public void beginVelocity(boolean counts) {
        System.arraycopy(s.start, 0, s.begun, 0, s.start.length);
        s.isFresh = false;
        derive();
        activate(false);
        double most = most();
        for (int k = 0; k < s.joint.length; k++) {
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                int row = row(k, r);
                byte role = store.role[row];
                double first = !s.isDirect && s.isActive[r] ? store.after[row] : 0;
                first = role == JointStore.SPRING ? store.after[row] : first;
                first = role == JointStore.MOTOR && !s.isActive[r] ? store.before[row] : first;
                s.impulse[r] = 0;
                set(k, r, counts ? first : 0);
            }
        }
        if (counts && !isGuess(most)) {
            release();
        }
    }

    /**
     * Takes from the velocities what the joints do not allow.
     *
     * @param counts whether its impulses are those of the sub-step
     * @param isStruck whether contacts act on the assembly
     */
    void velocity(double seconds, boolean counts, boolean isStruck) {
        h = seconds;
        close(isStruck);
        stop();
        if (counts) {
            relieve(false);
            end();
        }
    }

    /**
     * The same with contacts with static bodies.
     *
     * @param rows of the contacts
     */
    public void velocity(SubStep sub, boolean counts, ConstraintRows rows) {
        h = sub.seconds;
        close(true);
        stop();
        if (stands(rows, sub, false)) {
            stop();
        }
        double load = forget(rows, sub.seconds);
        if (counts) {
            relieve(false);
            end();
            keepLoad(load);
        }
    }

    /** No more energy comes of it than most, or nothing is done: rows may contradict each other. */
    private void stop() {
        boolean isGiven = s.carriedRoot > 0 || s.isDriven;
        double most = isGiven ? most() : 0;
        if (isGiven) {
            note();
        }
        nullSpeeds();
        if (isGiven && !(kinetic() <= most + work())) {
            comeBack();
        }
    }

    private void nullSpeeds() {
        changes = 0;
        double first = 0;
        for (int round = 0; round < ROUNDS; round++) {
            boolean changed = round > 0 && letGo();
            double worst = speeds();
            first = Math.max(first, worst);
            if (!changed && (worst <= STOPPED * first || round > (s.isDirect ? 2 : 0))) {
                return;
            }
            factor(false);
            correct();
        }
    }

    /** Writes the speeds that rows do not allow to {@link Assembly#now}; the largest. */
    private double speeds() {
        double worst = 0;
        for (int k = 0; k < s.joint.length; k++) {
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                int row = row(k, r);
                boolean isDriven = store.role[row] == JointStore.MOTOR;
                double miss = speed(k, r) - (isDriven ? store.target[row] : 0);
                s.now[r] = s.isActive[r] ? miss : 0;
                worst = Math.max(worst, Math.abs(s.now[r]));
            }
        }
        return worst;
    }

    /** Takes what rows do not allow from the velocities, once. */
    private void halt() {
        speeds();
        factor(false);
        correct();
    }

    /**
     * What limits passed on of an impact is no first guess for the next sub-step: a stop that
     * caught a car would throw it up. Locks are equations, which take a wrong guess back.
     *
     * @param share of what has come to them in the sub-step that may be a load
     */
    private void keepLoad(double share) {
        for (int k = 0; k < s.joint.length && share < 1; k++) {
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                int row = row(k, r);
                if (store.role[row] == JointStore.LIMIT) {
                    double before = s.load[2 * r];
                    double after = s.load[2 * r + 1];
                    store.before[row] = before + share * (store.before[row] - before);
                    store.after[row] = after + share * (store.after[row] - after);
                }
            }
        }
    }

    /** Keeps impulses, and the forces that they stand for. */
    private void end() {
        for (int k = 0; k < s.joint.length; k++) {
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                store.after[row(k, r)] = s.impulse[r];
            }
        }
        react();
    }
}
