package dev.cairn.physics.solver.joint;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.JointStore;
import dev.cairn.physics.solver.body.Rotation;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.body.SolverContext;

/**
 * Closes joints that are open already, bodies that were put elsewhere or pushed by contacts, by
 * moving bodies aside. No speed comes of it, so no energy of motion.
 */
abstract class PositionCorrection extends HoldingRows {
    /** Rounds in which gaps are closed aside, and down to which share of a body's size. */
    private static final int CLOSINGS = 4;

    private static final double CLOSELY = 1e-4;

    /** The same of what stands on something: impacts open joints far, and one at a time. */
    private static final double CLOSELY_STANDING = 1e-8;

    /** The most that a joint has opened by in the sub-step, over its size, or rad. */
    private double opened;

    private boolean closesAtOnce;

    private final double[] turn = new double[3];
    private final InnerMotion inner = new InnerMotion();

    /** What contacts have done to a body. */
    private final double[] pushed = new double[6];

    /**
     * Closes what is open by moving bodies, without any speed: {@code x' = x - M^-1 J^T (A + E)^-1
     * c}. Those of an assembly that floats would change its angular momentum: it gets that back.
     *
     * @param isStruck whether contacts act on it. What these, or Newton's method where it fails,
     *     have opened in the sub-step is closed at once; not where only motors and limits act,
     *     which may fight each other
     */
    void close(boolean isStruck) {
        boolean isNoted = false;
        opened = 0;
        closesAtOnce = s.isDirect && (isStruck || s.isRigid);
        double closely = s.touchCount > 0 ? CLOSELY_STANDING : CLOSELY;
        for (int round = 0; round < (s.isDirect ? CLOSINGS : 1); round++) {
            double worst = gaps(round == 0);
            if (!(worst > (round == 0 ? NEARLY : closely))) {
                break;
            }
            if (!isNoted && !s.isGrounded) {
                inner.note(tick, s);
                isNoted = true;
            }
            isClosing = true;
            factor(false);
            solve();
            isClosing = false;
            shift();
            if (isNoted) {
                renew();
            }
            s.isFresh = false;
            derive();
        }
        if (isNoted) {
            inner.giveBack(tick, s);
        }
    }

    /** Gives bodies the root of their inertia as they are turned now. */
    private void renew() {
        double[] v = tick.body.state;
        double[] mark = tick.body.mark;
        for (int i : s.body) {
            int o = SolverBodies.offset(i);
            int w = (i + 1) * SolverBodies.HALF;
            for (int c = 0; c < 6; c++) {
                pushed[c] = v[o + c] - mark[w + c];
            }
            renew(tick, i);
            for (int c = 0; c < 6; c++) {
                mark[w + c] = v[o + c] - pushed[c];
            }
        }
    }

    /**
     * Writes what is open to {@link Assembly#now}; the worst, over its size. A step closes what it
     * has opened itself, and of what was open before as much as the allowed speeds can; of what
     * stands on something no less than what the bodies' own turn may have opened: {@code w h}.
     */
    double gaps(boolean begins) {
        double worst = 0;
        for (int k = 0; k < s.joint.length; k++) {
            double size = size(k);
            double turned = turned(2 * k) + turned(2 * k + 1);
            for (int r = s.firstRow[k]; r < s.firstRow[k + 1]; r++) {
                int row = row(k, r);
                boolean isAngle = JointMath.isAngle(store.law[row]);
                double gap = 0;
                if (s.isActive[r] && store.role[row] == JointStore.LOCK) {
                    gap = s.start[r] - store.target[row];
                } else if (s.isActive[r] && store.role[row] == JointStore.LIMIT) {
                    double edge = store.held[row] < 0 ? store.lower[row] : store.upper[row];
                    double past = s.start[r] - edge;
                    gap = past * store.held[row] > 0 ? past : 0;
                }
                // what is far apart is drawn nearer only once
                double most = Math.max(reach(isAngle), isAngle ? turned : turned * size);
                double by = begins ? opened(r, isAngle, size) : opened;
                opened = gap == 0 ? opened : Math.max(opened, by);
                most += isAngle ? by : by * size;
                gap = begins || Math.abs(gap) < most ? within(gap, most) : 0;
                worst = Math.max(worst, Math.abs(isAngle ? gap : gap / size));
                s.now[r] = gap;
            }
        }
        return worst;
    }

    /** What a row has opened by since the sub-step began, over its joint's size, or rad. */
    private double opened(int r, boolean isAngle, double size) {
        double way = closesAtOnce ? s.start[r] - s.begun[r] : 0;
        return Math.abs(isAngle ? Angles.wrap(way) : way / size);
    }

    /** Angle by which the body at one end of a joint turns in the sub-step; 0 if it is fixed. */
    private double turned(int end) {
        return s.end[end] < 0 ? 0 : turned(tick.body, s.body[s.end[end]]);
    }

    private double turned(SolverBodies body, int i) {
        if (s.touchCount == 0) {
            return 0;
        }
        int w = SolverBodies.offset(i) + 3;
        double x = body.world(i, w, 0);
        double y = body.world(i, w, 1);
        double z = body.world(i, w, 2);
        return Math.abs(h) * SolverBodies.norm(x, y, z);
    }

    /** Size that the gaps of a joint are measured by, m: its smaller body that moves, and arms. */
    double size(int k) {
        BodyStore b = tick.bodies;
        double size = 0;
        for (int side = 0; side < 2; side++) {
            if (s.end[2 * k + side] >= 0) {
                size = Math.max(size, b.outerRadius[s.body[s.end[2 * k + side]]]);
            }
        }
        return size;
    }

    /**
     * Moves bodies by the solution. Where a loop is almost straight that would lead far beyond: it
     * is cut to twice the way that a gap is closed by.
     */
    void shift() {
        Assembly.Matrix f = s.system;
        double[] x = f.x();
        SolverBodies body = tick.body;
        double part = 1;
        for (int n = 0; n < s.body.length; n++) {
            int o = SolverBodies.offset(s.body[n]);
            int u = f.unknown(n);
            double root = Math.sqrt(body.state[o + SolverBodies.MASS]);
            double way = root * SolverBodies.norm(x[u], x[u + 1], x[u + 2]);
            turn(s.body[n], u + 3);
            double angle = SolverBodies.norm(turn[0], turn[1], turn[2]);
            double turned = turned(body, s.body[n]);
            double size = tick.bodies.outerRadius[s.body[n]];
            part = cut(part, way, Math.max(reach(false), turned * size) + opened * size);
            part = cut(part, angle, Math.max(reach(true), turned) + opened);
        }
        for (int n = 0; n < s.body.length; n++) {
            int i = s.body[n];
            int o = SolverBodies.offset(i);
            int p = o + SolverBodies.P;
            int u = f.unknown(n);
            double root = part * Math.sqrt(body.state[o + SolverBodies.MASS]);
            for (int c = 0; c < 3; c++) {
                body.state[p + c] += root * x[u + c];
                body.state[p + 3 + c] += part * x[u + 3 + c];
            }
            turn(i, u + 3);
            Rotation.turn(tick.bodies, i, part * turn[0], part * turn[1], part * turn[2]);
        }
    }

    /** A share of a way that is no more than twice as far as allowed. */
    static double cut(double part, double way, double reach) {
        return way * part > 2 * reach ? 2 * reach / way : part;
    }

    /** {@code L u} of three unknowns. */
    void turn(int i, int u) {
        double[] l = tick.body.root;
        int q = (i + 1) * SolverBodies.ROOT;
        double[] x = s.system.x();
        for (int c = 0; c < 3; c++) {
            turn[c] =
                    l[q + 3 * c] * x[u] + l[q + 3 * c + 1] * x[u + 1] + l[q + 3 * c + 2] * x[u + 2];
        }
    }

    /** Gives a body the root of its present inertia; no contact knows the old one. */
    static void renew(SolverContext tick, int i) {
        SolverBodies body = tick.body;
        if (body.axes.isIsotropic(i)) {
            return;
        }
        int o = SolverBodies.offset(i);
        double x = body.world(i, o + 3, 0);
        double y = body.world(i, o + 3, 1);
        double z = body.world(i, o + 3, 2);
        body.rootOfInertia(tick.bodies, i, body.state[o + SolverBodies.GRAVITY]);
        body.weigh(i, x, y, z);
        System.arraycopy(body.state, o, body.mark, (i + 1) * SolverBodies.HALF, 6);
    }
}
