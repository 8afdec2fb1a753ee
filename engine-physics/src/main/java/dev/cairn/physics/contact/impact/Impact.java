package dev.cairn.physics.contact.impact;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.Rotations;
import dev.cairn.physics.narrowphase.pair.Manifold;
import dev.cairn.physics.sweep.Flight;

/**
 * The impulses of one impact between two bodies, at the poses of that moment.
 *
 * <p>For each point that touches then, with the speed v of separation before and v' after,
 *
 * <pre>
 *   v' >= g,  l >= 0,  l (v' - g) = 0,      g = -e v if v &lt; 0, else 0
 * </pre>
 *
 * by equal impulses as a first guess and sweeps until nothing changes; then friction in the middle
 * of the points, up to mu times the sum. What several points with friction would gain of energy is
 * taken back by scaling the whole impact to where the energy is least.
 *
 * <p>One thread. Allocates nothing.
 */
final class Impact {
    private static final int SWEEPS = 256;
    private static final int MOST = 4;

    /** Normals and friction change each other: that often. */
    private static final int ROUNDS = 32;

    /** Of the sum of impulses: a change that is none. */
    private static final double ROUNDING = 1e-15;

    /** Of the patch's radius: points that far from the nearest take part. */
    private static final double FLUSH = 0.005;

    /** By side: velocity and angular velocity, before and after. */
    final double[] before = new double[12], after = new double[12];

    /** By point. */
    final double[] impulse = new double[MOST];

    /** Sum of the normal impulses, N s. */
    double sum;

    private final double[] mass = new double[2];

    /** By side: inverse inertia in world axes, 9 numbers. */
    private final double[] inverse = new double[18];

    /** By point and side: from the body's centre. */
    private final double[] arm = new double[6 * MOST];

    /** By point and side: arm x normal, and the turn that a unit impulse gives. */
    private final double[] lever = new double[6 * MOST], turn = new double[6 * MOST];

    private final double[] goal = new double[MOST];
    private final double[] column = new double[3];
    private final double[] mid = new double[6];
    private final double[] k = new double[9];
    private double nx, ny, nz;
    private int count;

    /** Friction so far, along two tangents, N s. */
    private double friction1, friction2;

    /**
     * Sets one side.
     *
     * @param side 0 or 1
     * @param body its slot; without mass if it does not answer
     * @param f how it lies and turns at the impact
     * @param time of the impact, s
     */
    void side(int side, BodyStore s, int body, Flight f, double time) {
        boolean answers = s.kind[body] == BodyStore.DYNAMIC;
        mass[side] = answers ? s.inverseMass[body] : 0;
        int at = 6 * side;
        before[at] = f.vx + time * f.ax;
        before[at + 1] = f.vy + time * f.ay;
        before[at + 2] = f.vz + time * f.az;
        before[at + 3] = f.nowX;
        before[at + 4] = f.nowY;
        before[at + 5] = f.nowZ;
        for (int c = 0; c < 3; c++) {
            if (!answers) {
                inverse[9 * side + 3 * c] = 0;
                inverse[9 * side + 3 * c + 1] = 0;
                inverse[9 * side + 3 * c + 2] = 0;
                continue;
            }
            // column c of R J R^T
            double ex = c == 0 ? 1 : 0;
            double ey = c == 1 ? 1 : 0;
            double ez = c == 2 ? 1 : 0;
            Rotations.rotate(-f.qx, -f.qy, -f.qz, f.qw, ex, ey, ez, column);
            Depenetration.inverseInertia(s, body, column[0], column[1], column[2], column);
            Rotations.rotate(f.qx, f.qy, f.qz, f.qw, column[0], column[1], column[2], column);
            System.arraycopy(column, 0, inverse, 9 * side + 3 * c, 3);
        }
    }

    /**
     * Strikes.
     *
     * @param m the contact; its points from a centre that is at (cx, cy, cz) from the first body's
     * @param bx from the first body's centre to the second one's, world, m
     * @param by see {@code bx}
     * @param bz see {@code bx}
     * @param threshold closing speed up to which nothing bounces, m/s
     * @return the largest speed at which points close; nothing is struck unless above 0
     */
    double strike(
            Manifold m,
            double cx,
            double cy,
            double cz,
            double bx,
            double by,
            double bz,
            double restitution,
            double friction,
            double threshold) {
        nx = m.normalX;
        ny = m.normalY;
        nz = m.normalZ;
        double near = Double.POSITIVE_INFINITY;
        for (int p = 0; p < m.pointCount; p++) {
            near = Math.min(near, m.separation[p]);
        }
        System.arraycopy(before, 0, after, 0, 12);
        double closing = 0;
        count = m.pointCount;
        for (int p = 0; p < count; p++) {
            double x = m.pointX[p] + cx;
            double y = m.pointY[p] + cy;
            double z = m.pointZ[p] + cz;
            set(p, 0, x, y, z);
            set(p, 1, x - bx, y - by, z - bz);
            impulse[p] = 0;
            double v = speed(p);
            boolean touches = m.separation[p] <= near + FLUSH * reach(m);
            goal[p] = touches ? (v < -threshold ? -restitution * v : 0) : Double.NaN;
            closing = touches ? Math.max(closing, -v) : closing;
        }
        sum = 0;
        if (!(closing > 0)) {
            return 0;
        }
        uniform();
        friction1 = 0;
        friction2 = 0;
        for (int round = 0; round < ROUNDS; round++) {
            sweep();
            double old = sum;
            sum = 0;
            for (int p = 0; p < count; p++) {
                sum += impulse[p];
            }
            if (!(friction > 0 && sum > 0) || Math.abs(sum - old) <= ROUNDING * sum) {
                break;
            }
            slide(friction * sum);
        }
        withoutGain();
        return closing;
    }

    /** How far points are from their middle. */
    private double reach(Manifold m) {
        double x = 0;
        double y = 0;
        double z = 0;
        for (int p = 0; p < m.pointCount; p++) {
            x += m.pointX[p] / m.pointCount;
            y += m.pointY[p] / m.pointCount;
            z += m.pointZ[p] / m.pointCount;
        }
        double most = 0;
        for (int p = 0; p < m.pointCount; p++) {
            double dx = m.pointX[p] - x;
            double dy = m.pointY[p] - y;
            double dz = m.pointZ[p] - z;
            most = Math.max(most, dx * dx + dy * dy + dz * dz);
        }
        return Math.sqrt(most);
    }

    private void set(int p, int side, double x, double y, double z) {
        int at = 6 * p + 3 * side;
        arm[at] = x;
        arm[at + 1] = y;
        arm[at + 2] = z;
        lever[at] = y * nz - z * ny;
        lever[at + 1] = z * nx - x * nz;
        lever[at + 2] = x * ny - y * nx;
        turned(side, lever, at, turn, at);
    }

    /** J u. */
    private void turned(int side, double[] u, int i, double[] out, int o) {
        int j = 9 * side;
        for (int c = 0; c < 3; c++) {
            out[o + c] =
                    inverse[j + c] * u[i]
                            + inverse[j + 3 + c] * u[i + 1]
                            + inverse[j + 6 + c] * u[i + 2];
        }
    }

    /** n . (vB - vA) + lever . w. */
    private double speed(int p) {
        double[] v = after;
        int a = 6 * p;
        int b = a + 3;
        return nx * (v[6] - v[0])
                + ny * (v[7] - v[1])
                + nz * (v[8] - v[2])
                + (lever[b] * v[9] + lever[b + 1] * v[10] + lever[b + 2] * v[11])
                - (lever[a] * v[3] + lever[a + 1] * v[4] + lever[a + 2] * v[5]);
    }

    /** Change of the speed at p by a unit impulse at q. */
    private double response(int p, int q) {
        double r = mass[0] + mass[1];
        for (int c = 0; c < 6; c++) {
            r += lever[6 * p + c] * turn[6 * q + c];
        }
        return r;
    }

    private void push(int p, double l) {
        double[] v = after;
        v[0] -= l * mass[0] * nx;
        v[1] -= l * mass[0] * ny;
        v[2] -= l * mass[0] * nz;
        v[6] += l * mass[1] * nx;
        v[7] += l * mass[1] * ny;
        v[8] += l * mass[1] * nz;
        for (int c = 0; c < 3; c++) {
            v[3 + c] -= l * turn[6 * p + c];
            v[9 + c] += l * turn[6 * p + 3 + c];
        }
    }

    private void uniform() {
        double miss = 0;
        double all = 0;
        for (int p = 0; p < count; p++) {
            if (Double.isNaN(goal[p])) {
                continue;
            }
            miss += goal[p] - speed(p);
            for (int q = 0; q < count; q++) {
                all += Double.isNaN(goal[q]) ? 0 : response(p, q);
            }
        }
        double l = miss / all;
        for (int p = 0; p < count && l > 0; p++) {
            if (!Double.isNaN(goal[p])) {
                impulse[p] = l;
                push(p, l);
            }
        }
    }

    private void sweep() {
        for (int round = 0; round < SWEEPS; round++) {
            double largest = 0;
            double total = 0;
            for (int p = 0; p < count; p++) {
                if (Double.isNaN(goal[p])) {
                    continue;
                }
                double old = impulse[p];
                impulse[p] = Math.max(0, old + (goal[p] - speed(p)) / response(p, p));
                push(p, impulse[p] - old);
                largest = Math.max(largest, Math.abs(impulse[p] - old));
                total += impulse[p];
            }
            if (largest <= ROUNDING * total) {
                return;
            }
        }
    }

    /** The middle of the impulses, from each body's centre. */
    private void middle() {
        for (int c = 0; c < 6; c++) {
            mid[c] = 0;
            for (int p = 0; p < count; p++) {
                mid[c] += impulse[p] / sum * arm[6 * p + c];
            }
        }
    }

    /** Friction at the middle of the impulses: stops the slip there, or is at its bound. */
    private void slide(double bound) {
        middle();
        // two tangents
        double tx = Math.abs(nx) < 0.75 ? 1 : 0;
        double ty = 1 - tx;
        double along = tx * nx + ty * ny;
        tx -= along * nx;
        ty -= along * ny;
        double tz = -along * nz;
        double unit = 1 / Math.sqrt(tx * tx + ty * ty + tz * tz);
        tx *= unit;
        ty *= unit;
        tz *= unit;
        double sx = ny * tz - nz * ty;
        double sy = nz * tx - nx * tz;
        double sz = nx * ty - ny * tx;
        double k11 = answer(tx, ty, tz, tx, ty, tz);
        double k12 = answer(tx, ty, tz, sx, sy, sz);
        double k22 = answer(sx, sy, sz, sx, sy, sz);
        double u = slip(tx, ty, tz);
        double v = slip(sx, sy, sz);
        double det = k11 * k22 - k12 * k12;
        double f = friction1 - (k22 * u - k12 * v) / det;
        double g = friction2 - (k11 * v - k12 * u) / det;
        double size = Math.sqrt(f * f + g * g);
        double share = size > bound ? bound / size : 1;
        double df = f * share - friction1;
        double dg = g * share - friction2;
        friction1 += df;
        friction2 += dg;
        pull(df * tx + dg * sx, df * ty + dg * sy, df * tz + dg * sz);
    }

    /** Slip along t: t . (vB + wB x rB - vA - wA x rA). */
    private double slip(double tx, double ty, double tz) {
        double[] v = after;
        double s = tx * (v[6] - v[0]) + ty * (v[7] - v[1]) + tz * (v[8] - v[2]);
        for (int side = 0; side < 2; side++) {
            cross(side, tx, ty, tz);
            double w = 0;
            for (int c = 0; c < 3; c++) {
                w += k[c] * v[6 * side + 3 + c];
            }
            s += side == 0 ? -w : w;
        }
        return s;
    }

    /** Change of the slip along t by a unit impulse along s. */
    private double answer(double tx, double ty, double tz, double sx, double sy, double sz) {
        double r = (mass[0] + mass[1]) * (tx * sx + ty * sy + tz * sz);
        for (int side = 0; side < 2; side++) {
            cross(side, sx, sy, sz);
            turned(side, k, 0, k, 3);
            cross(side, tx, ty, tz);
            r += k[0] * k[3] + k[1] * k[4] + k[2] * k[5];
        }
        return r;
    }

    /** Into k: arm of the middle x t. */
    private void cross(int side, double tx, double ty, double tz) {
        int at = 3 * side;
        k[0] = mid[at + 1] * tz - mid[at + 2] * ty;
        k[1] = mid[at + 2] * tx - mid[at] * tz;
        k[2] = mid[at] * ty - mid[at + 1] * tx;
    }

    private void pull(double fx, double fy, double fz) {
        for (int side = 0; side < 2; side++) {
            double sign = side == 0 ? -1 : 1;
            int at = 6 * side;
            after[at] += sign * mass[side] * fx;
            after[at + 1] += sign * mass[side] * fy;
            after[at + 2] += sign * mass[side] * fz;
            cross(side, fx, fy, fz);
            turned(side, k, 0, k, 3);
            for (int c = 0; c < 3; c++) {
                after[at + 3 + c] += sign * k[3 + c];
            }
        }
    }

    private void withoutGain() {
        middle();
        double share = ImpactEnergy.share(mass, inverse, before, after, mid);
        if (share == 1) {
            return;
        }
        for (int c = 0; c < 12; c++) {
            after[c] = before[c] + share * (after[c] - before[c]);
        }
        for (int p = 0; p < count; p++) {
            impulse[p] *= share;
        }
        sum *= share;
    }

    /**
     * How fast the point of the impact of a side moves along the normal, m/s.
     *
     * @param side 0 or 1
     */
    double carrier(int side, Manifold m) {
        int at = 6 * side;
        double v = nx * after[at] + ny * after[at + 1] + nz * after[at + 2];
        int nearest = 0;
        for (int p = 1; p < count; p++) {
            nearest = m.separation[p] < m.separation[nearest] ? p : nearest;
        }
        double w = 0;
        for (int c = 0; c < 3; c++) {
            w += lever[6 * nearest + 3 * side + c] * after[at + 3 + c];
        }
        return v + w;
    }
}
