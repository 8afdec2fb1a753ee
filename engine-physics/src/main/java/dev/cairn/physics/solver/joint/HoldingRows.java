package dev.cairn.physics.solver.joint;

import dev.cairn.physics.internal.JointStore;

/**
 * Which rows hold: limits and motors are equations as long as their impulse is one that they may
 * have, springs as long as their force is below its most. It is found by trial (active set).
 */
abstract class HoldingRows extends AssemblyEquations {
    /** Up to this the search may end with a round that gains little, or with the last one. */
    static final double NEARLY = 1e-9;

    /** Changes of which rows hold, in one half. */
    private static final int CHANGES = 8;

    /**
     * Changes from which on a limit lets go only where the search has come as near as {@link
     * #SURE}: the first rounds may be wrong about the sign of a small impulse, and would let it go
     * and find it passed by turns.
     */
    private static final int GUESSES = 2;

    private static final double SURE = 1e-6;

    /** Gap, m or rad, that is closed by the movement itself; larger ones are closed aside. */
    private static final double TINY = 1e-7;

    /** Speeds at which what is out of place is drawn back, m/s and rad/s. */
    double push, turnBack;

    /** Changes so far. */
    int changes;

    /**
     * Which rows hold at first: limits as they were, or if they are passed, motors and springs
     * unless they were at their most.
     */
    void activate(boolean moves) {
        for (int k = 0; k < s.joint.length; k++) {
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                int row = row(k, r);
                boolean bound = store.held[row] != 0;
                s.isActive[r] =
                        switch (store.role[row]) {
                                    case JointStore.LIMIT ->
                                            isPast(r, row) || (bound && isAt(k, r, row));
                                    case JointStore.MOTOR -> !bound;
                                    case JointStore.SPRING -> moves && !bound && isSprung(r, row);
                                    default -> true;
                                }
                                && s.compliance[r] > 0;
                if (bound && store.role[row] >= JointStore.MOTOR && moves) {
                    set(k, r, isRound(k, row) ? held(k, row) : store.held[row] * bound(row));
                }
            }
            standAll(k);
        }
    }

    boolean isSprung(int r, int row) {
        return stiffness(r, row) > 0 || damping(r, row) > 0;
    }

    /** Largest impulse of a half. */
    double bound(int row) {
        return 0.5 * Math.abs(h) * store.most[row];
    }

    /**
     * Lets rows hold, or lets them go; whether any has changed.
     *
     * @param last what was missing a round ago, over its size
     */
    boolean hold(int round, double last) {
        if (changes >= CHANGES) {
            return false;
        }
        boolean judges = round > 0 && (changes < GUESSES || last <= SURE);
        boolean changed = false;
        for (int k = 0; k < s.joint.length; k++) {
            changed |= store.isRound[s.joint[k]] && clampLength(k);
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                int row = row(k, r);
                byte role = store.role[row];
                if (role == JointStore.LIMIT) {
                    changed |= limit(k, r, row, judges);
                } else if (role != JointStore.LOCK && !isRound(k, row) && s.compliance[r] > 0) {
                    changed |= clamp(k, r, row);
                }
            }
            changed |= standAll(k);
        }
        changes += changed ? 1 : 0;
        return changed;
    }

    /**
     * Whether a limit begins to hold, or lets go as it would pull.
     *
     * @param judges whether it may let go
     */
    boolean limit(int k, int r, int row, boolean judges) {
        if (s.compliance[r] == 0) {
            return false;
        }
        double tiny = tiny(JointMath.isAngle(store.law[row]));
        double start = s.start[r];
        double low = store.lower[row] - start > tiny ? start : store.lower[row];
        double high = start - store.upper[row] > tiny ? start : store.upper[row];
        int side = s.now[r] < low ? -1 : s.now[r] > high ? 1 : 0;
        if (!s.isActive[r]) {
            if (side == 0) {
                return false;
            }
            store.held[row] = (byte) side;
            s.isActive[r] = true;
            return true;
        }
        if (!judges || s.impulse[r] * store.held[row] <= pressure(k, row)) {
            return false;
        }
        return release(k, r, row);
    }

    /**
     * Lets limits hold that what was just given drives bodies past, and go that would pull; whether
     * any has changed. After the first rounds none goes: two could take turns without end, and one
     * that pulls only takes energy away.
     *
     * @param moves whether bodies are still to be moved, to where {@link Assembly#now} was measured
     * @param round from 1
     */
    boolean meet(boolean moves, int round) {
        boolean changed = false;
        for (int k = 0; k < s.joint.length; k++) {
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                int row = row(k, r);
                if (store.role[row] == JointStore.LIMIT) {
                    s.now[r] = moves ? s.now[r] : s.start[r] + Math.abs(h) * speed(k, r);
                    changed |=
                            (moves || s.isActive[r] || isAtEdge(r, row))
                                    && limit(k, r, row, round <= GUESSES);
                }
            }
        }
        return changed;
    }

    /** Whether it is where a limit begins. */
    private boolean isAtEdge(int r, int row) {
        double tiny = tiny(JointMath.isAngle(store.law[row]));
        double high = store.upper[row] - s.start[r];
        return high <= tiny || s.start[r] - store.lower[row] <= tiny;
    }

    /**
     * Impulse with which motors press the axis of a limit against it. A motor that drives its axis
     * into a limit stands still, and the limit holds both ways: what it pulls is the motor's.
     */
    double pressure(int k, int limit) {
        double sum = 0;
        int first = store.firstRow[s.joint[k]];
        for (int row = first; row < first + store.rows[s.joint[k]]; row++) {
            sum += presses(row, limit) ? bound(row) : 0;
        }
        return sum;
    }

    /** Whether a row is that of a motor that drives the axis of a limit further into it. */
    private boolean presses(int row, int limit) {
        return store.role[row] == JointStore.MOTOR
                && store.law[row] == store.law[limit]
                && store.target[row] * store.held[limit] >= 0;
    }

    /** Whether a limit that holds has brought a motor to a stand. */
    private boolean stands(int k, int motor) {
        int first = store.firstRow[s.joint[k]];
        for (int row = first; row < first + store.rows[s.joint[k]]; row++) {
            if (store.role[row] == JointStore.LIMIT
                    && store.held[row] != 0
                    && presses(motor, row)) {
                return true;
            }
        }
        return false;
    }

    private boolean standAll(int k) {
        boolean changed = false;
        for (int r = s.firstRow[k]; r < s.firstRow[k + 1] && !s.isRigid; r++) {
            if (store.role[row(k, r)] == JointStore.MOTOR && s.compliance[r] > 0) {
                changed |= stand(k, r, row(k, r));
            }
        }
        return changed;
    }

    /**
     * Brings a motor to a stand, or lets it go on, with all that it has: less was not enough to
     * stay at the limit. Whether it is another than before.
     */
    private boolean stand(int k, int r, int row) {
        boolean stands = stands(k, row);
        boolean stood = !s.isActive[r] && store.held[row] == 0;
        if (stands && !stood) {
            set(k, r, 0);
            s.isActive[r] = false;
            store.held[row] = 0;
        } else if (stood && !stands) {
            double most = bound(row);
            double way = Math.signum(store.target[row]);
            s.isActive[r] = way == 0 || most == Double.POSITIVE_INFINITY;
            store.held[row] = (byte) (s.isActive[r] ? 0 : way);
            set(k, r, s.isActive[r] ? 0 : way * most);
        }
        return stands != stood;
    }

    /** Whether what moved a body, or another limit of it that came first, has led past a limit. */
    private boolean isPast(int r, int row) {
        double tiny = tiny(JointMath.isAngle(store.law[row]));
        boolean high = s.start[r] - store.upper[row] > tiny;
        boolean is = high || store.lower[row] - s.start[r] > tiny;
        store.held[row] = (byte) (!is ? store.held[row] : high ? 1 : -1);
        return is;
    }

    /**
     * Whether a limit that held still does; not one that a body was taken away from, or whose axis
     * a motor that is strong enough drives away.
     */
    private boolean isAt(int k, int r, int limit) {
        double edge = store.held[limit] < 0 ? store.lower[limit] : store.upper[limit];
        boolean leaves = (edge - s.start[r]) * store.held[limit] > TINY;
        int first = store.firstRow[s.joint[k]];
        for (int row = first; row < first + store.rows[s.joint[k]]; row++) {
            leaves |=
                    store.role[row] == JointStore.MOTOR
                            && store.law[row] == store.law[limit]
                            && store.held[row] == 0
                            && store.target[row] * store.held[limit] < 0;
        }
        store.held[limit] = leaves ? 0 : store.held[limit];
        return !leaves;
    }

    boolean release(int k, int r, int row) {
        set(k, r, 0);
        store.held[row] = 0;
        s.isActive[r] = false;
        return true;
    }

    /** Whether a motor or spring comes to the most that it can do, or back from it. */
    boolean clamp(int k, int r, int row) {
        double most = bound(row);
        if (s.isActive[r]) {
            if (Math.abs(s.impulse[r]) <= most) {
                return false;
            }
            store.held[row] = (byte) (s.impulse[r] > 0 ? 1 : -1);
            s.isActive[r] = false;
            set(k, r, store.held[row] * most);
            return true;
        }
        // it pushes with all it has: if the row has gone too far, less would do
        if (store.held[row] != 0 && miss(r, row) * store.held[row] > 0) {
            store.held[row] = 0;
            s.isActive[r] = true;
            return true;
        }
        return false;
    }

    /** Whether a row is one of the springs whose forces together have a largest length. */
    boolean isRound(int k, int row) {
        return store.isRound[s.joint[k]]
                && store.role[row] == JointStore.SPRING
                && store.law[row] < JointStore.TURN;
    }

    /** The last impulse of such a row, if they were at their most. */
    double held(int k, int row) {
        double square = 0;
        for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
            double l = isRound(k, row(k, r)) ? store.before[row(k, r)] : 0;
            square += l * l;
        }
        return square > 0 ? store.before[row] * bound(row) / Math.sqrt(square) : 0;
    }

    /**
     * The same as {@link #clamp} for springs whose forces together have a largest length. At their
     * most they push as {@code -h/2 k x - d/2 step} points, which is sought by iteration.
     */
    boolean clampLength(int k) {
        double square = 0;
        double most = Double.POSITIVE_INFINITY;
        boolean isFree = false;
        for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
            int row = row(k, r);
            if (isRound(k, row)) {
                double l = wanted(r, row);
                square += l * l;
                most = bound(row);
                isFree |= s.isActive[r];
            }
        }
        double length = Math.sqrt(square);
        if (isFree && length <= most) {
            return false;
        }
        boolean changed = isFree || length <= most;
        for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
            int row = row(k, r);
            if (isRound(k, row) && s.compliance[r] > 0) {
                s.isActive[r] = length <= most;
                store.held[row] = (byte) (length <= most ? 0 : 1);
                double l = wanted(r, row) * Math.min(1, most / length);
                changed |= Math.abs(l - s.impulse[r]) > NEARLY * most;
                set(k, r, l);
            }
        }
        return changed;
    }

    /** Impulse that a spring wants. */
    double wanted(int r, int row) {
        double give = 0.25 * h * stiffness(r, row) + 0.5 * damping(r, row);
        return s.isActive[r] ? s.impulse[r] : s.impulse[r] - give * miss(r, row);
    }

    /** What an equation lacks; in metres or rad. */
    double miss(int r, int row) {
        boolean isAngle = JointMath.isAngle(store.law[row]);
        double c0 = s.start[r];
        double c1 = s.now[r];
        double most = tiny(isAngle);
        return switch (store.role[row]) {
            case JointStore.LIMIT -> {
                double edge = store.held[row] < 0 ? store.lower[row] : store.upper[row];
                double past = c0 - edge;
                boolean isPast = past * store.held[row] > 0;
                yield c1 - edge - (isPast && Math.abs(past) > most ? past : 0);
            }
            case JointStore.MOTOR ->
                    (isAngle ? Angles.wrap(c1 - c0) : c1 - c0) - store.target[row] * h;
            case JointStore.SPRING -> {
                double x = c0 - store.target[row];
                x = isAngle ? Angles.wrap(x) : x;
                double step = isAngle ? Angles.wrap(c1 - c0) : c1 - c0;
                double k2 = 0.5 * h * stiffness(r, row);
                yield step + (k2 * x + s.impulse[r]) / (0.5 * k2 + 0.5 * damping(r, row));
            }
            default -> {
                double gap = c0 - store.target[row];
                yield c1 - store.target[row] - (Math.abs(gap) > most ? gap : 0);
            }
        };
    }

    /** How much of a gap the movement itself closes, m or rad. */
    static double tiny(boolean isAngle) {
        return isAngle ? TINY : 0.1 * TINY;
    }

    /** How much of a gap a step closes, m or rad. */
    double reach(boolean isAngle) {
        return (isAngle ? turnBack : push) * Math.abs(h);
    }

    static double within(double x, double most) {
        return Math.max(-most, Math.min(most, x));
    }

    /** Lets limits go that would pull, and holds motors to their most. */
    boolean letGo() {
        boolean changed = false;
        for (int k = 0; k < s.joint.length && changes < CHANGES; k++) {
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                int row = row(k, r);
                if (!s.isActive[r]) {
                    continue;
                }
                if (store.role[row] == JointStore.LIMIT) {
                    changed |=
                            s.impulse[r] * store.held[row] > pressure(k, row) && release(k, r, row);
                } else if (store.role[row] == JointStore.MOTOR
                        && Math.abs(s.impulse[r]) > bound(row)) {
                    s.isActive[r] = false;
                    set(k, r, s.impulse[r] > 0 ? bound(row) : -bound(row));
                    changed = true;
                }
            }
            changed |= standAll(k);
        }
        changes += changed ? 1 : 0;
        return changed;
    }
}
