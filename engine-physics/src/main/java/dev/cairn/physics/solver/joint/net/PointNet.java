package dev.cairn.physics.solver.joint.net;

import dev.cairn.physics.solver.body.SolverContext;

import java.util.Arrays;

/**
 * A net of balls: all joints hold points together, and all bodies turn about any axis alike. What
 * {@link ConjugateGradients} does for rows of any kind takes a tenth of the numbers here: with r
 * the arms, rows in the axes of the world are
 *
 * <pre>
 * c = (x_B + r_B) - (x_A + r_A),   c' = (v_B + w_B × r_B) - (v_A + w_A × r_A)
 * </pre>
 *
 * <p>and with m and i the inverse mass and inertia of a body, {@code [r]} the matrix of {@code r
 * ×}, two of its joints j and k do to each other, but for a sign, {@code m 1 + i [k][j]^T = (m + i
 * k.j) 1 - i j k^T}.
 *
 * <p>Joints lie in the order of their {@link JointPaths}. Allocates when it is made.
 */
public final class PointNet {
    /** Most rounds, and the share of the error at which they end. */
    private static final int ROUNDS = 8;

    private static final double NEAR = 1e-6;

    /** Paths that lie side by side. */
    private static final int ABREAST = 32;

    private static final int STRIDE = NetBodies.STRIDE;

    /** Whether all joints hold points. */
    public final boolean isPoints;

    /** By place: the joint among those of the assembly. */
    public final int[] joint;

    public final NetBodies bodies;

    private final PathFactors paths;

    /** Where each group of paths begins; one more for the end. */
    private final int[] group;

    /** By place: where the numbers of body A begin, and of body B. */
    final int[] a;

    final int[] b;

    /** By place: arms in the bodies' axes, or the world's of static bodies; of A, of B. */
    public final double[] local;

    /** The same in the world, of the point where both are held, B's, in the present poses, m. */
    final double[] arm;

    /** By place: axes of its rows in A, row by row; those of static bodies in the world. */
    public final double[] axes;

    /** By place: distance of the centres at the tick's begin; c in the present poses, m. */
    public final double[] apart;

    public final double[] gap;

    /** By place: impulse in work, N s; those of the last sub-step's halves. */
    public final double[] impulse;

    public final double[] before;
    public final double[] after;

    /** By place: what is missing; the direction that is sought, and the last one. */
    public final double[] missing;

    double[] near;
    private double[] way;

    /** Share of a row's own inverse mass by which it yields. */
    private double slack;

    /** By place: inverse mass of a row, a mean of the three. */
    final double[] own;

    /** Products of an effect: with its way, with what is missing, with itself. */
    private double bend;

    private double meets;
    private double squares;

    /**
     * Room for an assembly, if it is one.
     *
     * @param slots of its bodies
     * @param end bodies of each joint, -1 for one that does not move
     * @param arms by end of a joint: its place in the body's frame, three numbers
     * @param rowAxes by joint: the axes of its rows in A's frame, row by row
     */
    public PointNet(boolean isPoints, int[] slots, int[] end, double[] arms, double[] rowAxes) {
        this.isPoints = isPoints;
        bodies = new NetBodies(isPoints ? slots : new int[0]);
        int n = isPoints ? end.length / 2 : 0;
        int[] ends = isPoints ? end : new int[0];
        JointPaths order = new JointPaths(bodies.count, ends, arms, ABREAST);
        joint = order.joint;
        group = order.group;
        a = new int[n];
        b = new int[n];
        local = new double[6 * n];
        axes = new double[9 * n];
        for (int p = 0; p < n; p++) {
            int k = joint[p];
            a[p] = STRIDE * (end[2 * k] < 0 ? bodies.count : end[2 * k]);
            b[p] = STRIDE * (end[2 * k + 1] < 0 ? bodies.count : end[2 * k + 1]);
            System.arraycopy(arms, 6 * k, local, 6 * p, 6);
            System.arraycopy(rowAxes, 9 * k, axes, 9 * p, 9);
        }
        paths = new PathFactors(order.prior, a, b);
        arm = new double[6 * n];
        apart = new double[3 * n];
        gap = new double[3 * n];
        impulse = new double[3 * n];
        before = new double[3 * n];
        after = new double[3 * n];
        missing = new double[3 * n];
        near = new double[3 * n];
        way = new double[3 * n];
        own = new double[n];
    }

    /** Impulses of rows in the axes of A. */
    public void fill(double[] from, int row, double[] into, int p) {
        for (int c = 0; c < 3; c++) {
            int e = 9 * p + c;
            into[3 * p + c] =
                    axes[e] * from[row] + axes[e + 3] * from[row + 1] + axes[e + 6] * from[row + 2];
        }
    }

    /** Gives them back to the rows. */
    public void give(double[] from, int p, double[] into, int row) {
        for (int r = 0; r < 3; r++) {
            int e = 9 * p + 3 * r;
            into[row + r] =
                    axes[e] * from[3 * p]
                            + axes[e + 1] * from[3 * p + 1]
                            + axes[e + 2] * from[3 * p + 2];
        }
    }

    /** Turns impulses in the axes of A into those of the world, times a factor. */
    public void outward(double[] from, double[] into, double scale) {
        turn(from, into, scale, 1, 3);
    }

    /** The way back. */
    public void inward(double[] from, double[] into) {
        turn(from, into, 1, 3, 1);
    }

    private void turn(double[] from, double[] into, double scale, int column, int row) {
        double[] turn = bodies.turn;
        for (int p = 0; p < joint.length; p++) {
            int q = 3 * p;
            double x = scale * from[q];
            double y = scale * from[q + 1];
            double z = scale * from[q + 2];
            for (int c = 0; c < 3; c++) {
                int o = 9 * (a[p] / STRIDE) + c * row;
                into[q + c] = turn[o] * x + turn[o + column] * y + turn[o + 2 * column] * z;
            }
        }
    }

    /** Arms and gaps in the poses of now. */
    public void derive(SolverContext tick) {
        bodies.look(tick);
        double[] turn = bodies.turn;
        double[] moved = bodies.change;
        for (int p = 0; p < joint.length; p++) {
            int o = 6 * p;
            int i = 9 * (a[p] / STRIDE);
            int k = 9 * (b[p] / STRIDE);
            for (int c = 0; c < 3; c++) {
                double ra =
                        turn[i + 3 * c] * local[o]
                                + turn[i + 3 * c + 1] * local[o + 1]
                                + turn[i + 3 * c + 2] * local[o + 2];
                double rb =
                        turn[k + 3 * c] * local[o + 3]
                                + turn[k + 3 * c + 1] * local[o + 4]
                                + turn[k + 3 * c + 2] * local[o + 5];
                double way = apart[3 * p + c] + (moved[b[p] + c] - moved[a[p] + c]) + rb;
                arm[o + c] = way;
                arm[o + 3 + c] = rb;
                gap[3 * p + c] = way - ra;
            }
        }
    }

    /**
     * What joints lack where a step will lead, over its length, into {@link #missing}. A turn by
     * the quaternion (d, w) moves an arm r by {@code w t + d × t, t = 2 d × r}.
     *
     * @param tiny gaps beyond this shall stay
     * @return the largest, m
     */
    public double foresee(double h, double tiny) {
        double[] s = bodies.step;
        double worst = 0;
        double scale = -1 / h;
        for (int p = 0; p < joint.length; p++) {
            int o = 6 * p;
            int q = 3 * p;
            int i = a[p];
            int k = b[p];
            double gx = gap[q];
            double gy = gap[q + 1];
            double gz = gap[q + 2];
            double mx = s[k] - s[i] + (Math.abs(gx) > tiny ? 0 : gx);
            double my = s[k + 1] - s[i + 1] + (Math.abs(gy) > tiny ? 0 : gy);
            double mz = s[k + 2] - s[i + 2] + (Math.abs(gz) > tiny ? 0 : gz);
            double rx = arm[o] - gx;
            double ry = arm[o + 1] - gy;
            double rz = arm[o + 2] - gz;
            double dx = s[i + 3];
            double dy = s[i + 4];
            double dz = s[i + 5];
            double w = s[i + 6];
            double tx = 2 * (dy * rz - dz * ry);
            double ty = 2 * (dz * rx - dx * rz);
            double tz = 2 * (dx * ry - dy * rx);
            mx -= w * tx + (dy * tz - dz * ty);
            my -= w * ty + (dz * tx - dx * tz);
            mz -= w * tz + (dx * ty - dy * tx);
            rx = arm[o + 3];
            ry = arm[o + 4];
            rz = arm[o + 5];
            dx = s[k + 3];
            dy = s[k + 4];
            dz = s[k + 5];
            w = s[k + 6];
            tx = 2 * (dy * rz - dz * ry);
            ty = 2 * (dz * rx - dx * rz);
            tz = 2 * (dx * ry - dy * rx);
            mx += w * tx + (dy * tz - dz * ty);
            my += w * ty + (dz * tx - dx * tz);
            mz += w * tz + (dx * ty - dy * tx);
            worst = Math.max(worst, largest(mx, my, mz));
            missing[q] = scale * mx;
            missing[q + 1] = scale * my;
            missing[q + 2] = scale * mz;
        }
        return worst;
    }

    /**
     * The bodies have made the step that was foreseen: arms, gaps and impulses go with them; what
     * these do is in the bodies' changes.
     *
     * @param factor on the impulses
     * @return the largest gap, m
     */
    public double follow(double factor) {
        double[] s = bodies.step;
        double worst = 0;
        Arrays.fill(bodies.change, 0.0);
        for (int p = 0; p < joint.length; p++) {
            int o = 6 * p;
            int q = 3 * p;
            int i = a[p];
            int k = b[p];
            double dx = s[k + 3];
            double dy = s[k + 4];
            double dz = s[k + 5];
            double w = s[k + 6];
            double rx = arm[o + 3];
            double ry = arm[o + 4];
            double rz = arm[o + 5];
            double tx = 2 * (dy * rz - dz * ry);
            double ty = 2 * (dz * rx - dx * rz);
            double tz = 2 * (dx * ry - dy * rx);
            double mx = w * tx + (dy * tz - dz * ty);
            double my = w * ty + (dz * tx - dx * tz);
            double mz = w * tz + (dx * ty - dy * tx);
            arm[o + 3] = rx + mx;
            arm[o + 4] = ry + my;
            arm[o + 5] = rz + mz;
            mx += s[k] - s[i];
            my += s[k + 1] - s[i + 1];
            mz += s[k + 2] - s[i + 2];
            rx = arm[o] - gap[q];
            ry = arm[o + 1] - gap[q + 1];
            rz = arm[o + 2] - gap[q + 2];
            arm[o] += mx;
            arm[o + 1] += my;
            arm[o + 2] += mz;
            dx = s[i + 3];
            dy = s[i + 4];
            dz = s[i + 5];
            w = s[i + 6];
            tx = 2 * (dy * rz - dz * ry);
            ty = 2 * (dz * rx - dx * rz);
            tz = 2 * (dx * ry - dy * rx);
            mx = gap[q] + (mx - (w * tx + (dy * tz - dz * ty)));
            my = gap[q + 1] + (my - (w * ty + (dz * tx - dx * tz)));
            mz = gap[q + 2] + (mz - (w * tz + (dx * ty - dy * tx)));
            gap[q] = mx;
            gap[q + 1] = my;
            gap[q + 2] = mz;
            worst = Math.max(worst, largest(mx, my, mz));
            rx = factor * impulse[q];
            ry = factor * impulse[q + 1];
            rz = factor * impulse[q + 2];
            tx = 2 * (dy * rz - dz * ry);
            ty = 2 * (dz * rx - dx * rz);
            tz = 2 * (dx * ry - dy * rx);
            rx += w * tx + (dy * tz - dz * ty);
            ry += w * ty + (dz * tx - dx * tz);
            rz += w * tz + (dx * ty - dy * tx);
            impulse[q] = rx;
            impulse[q + 1] = ry;
            impulse[q + 2] = rz;
            push(p, rx, ry, rz);
        }
        bodies.weigh();
        return worst;
    }

    /** Impulses go with A in the same way. */
    public void follow(double[] last) {
        double[] s = bodies.step;
        for (int p = 0; p < joint.length; p++) {
            int q = 3 * p;
            int i = a[p];
            double dx = s[i + 3];
            double dy = s[i + 4];
            double dz = s[i + 5];
            double w = s[i + 6];
            double x = last[q];
            double y = last[q + 1];
            double z = last[q + 2];
            double tx = 2 * (dy * z - dz * y);
            double ty = 2 * (dz * x - dx * z);
            double tz = 2 * (dx * y - dy * x);
            last[q] = x + (w * tx + (dy * tz - dz * ty));
            last[q + 1] = y + (w * ty + (dz * tx - dx * tz));
            last[q + 2] = z + (w * tz + (dx * ty - dy * tx));
        }
    }

    /**
     * Solves {@code (J M^-1 J^T + E) l = missing}.
     *
     * @param yields share of a row's own inverse mass by which it yields
     * @param isSame whether the poses are nearly those of the last time
     * @param counts whether l is added to the impulses, and what it does to the velocities; else
     *     that is the bodies' sum
     */
    public void solve(double yields, boolean isSame, boolean counts) {
        slack = yields;
        Arrays.fill(bodies.change, 0.0);
        double left = 0;
        double size = 0;
        // numbers of a group stay in the cache
        for (int g = 0; g + 1 < group.length; g++) {
            int from = group[g];
            int to = group[g + 1];
            left += isSame ? paths.sweep(this, from, to) : paths.factor(this, slack, from, to);
            size += paths.back(this, from, to);
            push(near, from, to);
        }
        bodies.weigh();
        if (!counts) {
            Arrays.fill(bodies.sum, 0.0);
        }
        double goal = NEAR * left;
        for (int round = 0; round < ROUNDS && left > goal; round++) {
            if (round > 0) {
                double last = size;
                paths.sweep(this, 0, joint.length);
                size = paths.back(this, 0, joint.length);
                double turned = size / last;
                for (int r = 0; r < way.length; r++) {
                    near[r] += turned * way[r];
                }
                apply(near);
            }
            double[] now = near;
            near = way;
            way = now;
            effect(0);
            if (!(bend > 0)) {
                return;
            }
            double step = size / bend;
            bodies.add(step, counts ? bodies.velocity : bodies.sum);
            for (int r = 0; r < way.length && counts; r++) {
                impulse[r] += step * way[r];
            }
            left += step * (step * squares - 2 * meets);
            if (left > goal) {
                effect(step);
            }
        }
    }

    /** What impulses do to the bodies' velocities. */
    public void apply(double[] l) {
        Arrays.fill(bodies.change, 0.0);
        push(l, 0, joint.length);
        bodies.weigh();
    }

    private void push(double[] l, int from, int to) {
        for (int p = from; p < to; p++) {
            push(p, l[3 * p], l[3 * p + 1], l[3 * p + 2]);
        }
    }

    /** Adds an impulse of a joint to its bodies' changes. */
    private void push(int p, double x, double y, double z) {
        double[] change = bodies.change;
        int i = a[p];
        int k = b[p];
        int o = 6 * p;
        change[i] -= x;
        change[i + 1] -= y;
        change[i + 2] -= z;
        change[i + 3] -= arm[o + 1] * z - arm[o + 2] * y;
        change[i + 4] -= arm[o + 2] * x - arm[o] * z;
        change[i + 5] -= arm[o] * y - arm[o + 1] * x;
        change[k] += x;
        change[k + 1] += y;
        change[k + 2] += z;
        change[k + 3] += arm[o + 4] * z - arm[o + 5] * y;
        change[k + 4] += arm[o + 5] * x - arm[o + 3] * z;
        change[k + 5] += arm[o + 3] * y - arm[o + 4] * x;
    }

    /**
     * Speeds of the rows with their sign turned, into {@link #missing}.
     *
     * @return the largest, m/s
     */
    public double speeds() {
        double[] v = bodies.velocity;
        double worst = 0;
        for (int p = 0; p < joint.length; p++) {
            int i = a[p];
            int k = b[p];
            double x = speed(v, i, k, 6 * p, 0, 1, 2);
            double y = speed(v, i, k, 6 * p, 1, 2, 0);
            double z = speed(v, i, k, 6 * p, 2, 0, 1);
            worst = Math.max(worst, largest(x, y, z));
            missing[3 * p] = -x;
            missing[3 * p + 1] = -y;
            missing[3 * p + 2] = -z;
        }
        return worst;
    }

    private static double largest(double x, double y, double z) {
        return Math.max(Math.abs(x), Math.max(Math.abs(y), Math.abs(z)));
    }

    /** Speed of a joint's row along axis c by velocities; d and e are the other axes. */
    private double speed(double[] v, int i, int k, int o, int c, int d, int e) {
        return v[k + c]
                - v[i + c]
                + (v[k + 3 + d] * arm[o + 3 + e] - v[k + 3 + e] * arm[o + 3 + d])
                - (v[i + 3 + d] * arm[o + e] - v[i + 3 + e] * arm[o + d]);
    }

    /** What the way does to the rows; a share of that is taken from what is missing. */
    private void effect(double share) {
        double[] v = bodies.change;
        double x = 0;
        double y = 0;
        double z = 0;
        for (int p = 0; p < joint.length; p++) {
            int i = a[p];
            int k = b[p];
            int q = 3 * p;
            double e = slack * own[p];
            double gx = speed(v, i, k, 6 * p, 0, 1, 2) + e * way[q];
            double gy = speed(v, i, k, 6 * p, 1, 2, 0) + e * way[q + 1];
            double gz = speed(v, i, k, 6 * p, 2, 0, 1) + e * way[q + 2];
            x += gx * way[q] + gy * way[q + 1] + gz * way[q + 2];
            y += gx * missing[q] + gy * missing[q + 1] + gz * missing[q + 2];
            z += gx * gx + gy * gy + gz * gz;
            if (share != 0) {
                missing[q] -= share * gx;
                missing[q + 1] -= share * gy;
                missing[q + 2] -= share * gz;
            }
        }
        bend = x;
        meets = y;
        squares = z;
    }
}
