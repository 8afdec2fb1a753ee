package dev.cairn.physics.solver.refresh;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.solver.body.Rotation;

/**
 * Where the contact points of a solid of revolution go while its body turns.
 *
 * <p>A can that tips over turns about the point of its rim on which it stands: that point goes with
 * the can. A can that rolls has another point of its side on the floor at every moment: the point
 * stays below the axis. Both are one rule. Whatever the body does, let Q be its turn, a its axis at
 * the tick's start and S the smallest turn that takes a to Q a: then the solid has turned by S, and
 * about its axis by something that does not show. With o the centre of the collider as seen from
 * that of the body, and r the point from there,
 *
 * <pre>o + r  goes to  Q o + T S (r - t n) + t n</pre>
 *
 * <p>where n is the contact's normal away from the solid and t the radius of what is laid around
 * its core, of a capsule its own, of a cylinder 0, and half of the gap. A ball is all radius:
 * {@code Q o + r}. T is 1 but for the point of a rim that lies deepest: a coin that rolls on its
 * rim stands on another one at every moment, so T turns S l to l', about Q a, where l and l' are
 * the directions across the axis in which the solid reaches farthest along n, at the start and now.
 * Not where it is that flat on the other body that all of its rim touches.
 *
 * <p>Without this the rim's point stayed where it was: cans rose by 7 mm of 200 while they tipped,
 * and gained 2 % of their energy. Without T a disc that rolls on its rim fell flat within two
 * turns, since its deepest point stayed behind by a tick. One thread at a time; allocates when it
 * is made. Source: own study; S is Rodrigues' rotation for two unit vectors.
 */
final class RoundTurn {
    /** What is kept of a side: o, then the axis, world, at the tick's start; t. */
    static final int NUMBERS = 7;

    static final int AXIS = 3;
    static final int RADIUS = 6;

    /** 1 - cosine of the angle to the deepest point of a rim, up to which a point is that one. */
    private static final double DEEPEST = 1e-6;

    /** Cosine of the largest way of the deepest point round its rim in a tick. */
    private static final double FAR = 0.5;

    /** Height of a rim across its solid, over the body's inner radius, up to which it is flat. */
    static final double FLAT = 1e-3;

    /** 1 if the normal points away from the solid. */
    private final double side;

    private boolean isSet;
    private boolean isBall;

    /** S, row by row. */
    private final double[] swing = new double[9];

    /** T S, row by row; whether there is a T. */
    private final double[] travel = new double[9];

    private boolean travels;

    /** Of the start: l, a, and the least distance from the axis of a point that travels. */
    private final double[] low = new double[3], axis = new double[3], now = new double[3];

    private double least;

    /** o, Q o, and t without the gap. */
    private double x, y, z, toX, toY, toZ, radius;

    RoundTurn(double side) {
        this.side = side;
    }

    /** Whether points of a round collider move at all as seen from the centre of its body. */
    static boolean moves(BodyStore b, int body, int collider) {
        int r = BodyStore.REVOLUTION * collider;
        double[] axis = b.revolution;
        return collider != body || axis[r] != 0 || axis[r + 1] != 0 || axis[r + 2] != 0;
    }

    /** Keeps what a side is when the tick begins. */
    static void keep(BodyStore b, int body, int collider, double[] to, int at) {
        boolean isChild = collider != body;
        to[at] = isChild ? b.apartX(body, collider) : 0;
        to[at + 1] = isChild ? b.apartY(body, collider) : 0;
        to[at + 2] = isChild ? b.apartZ(body, collider) : 0;
        double qx = b.orientationX[collider];
        double qy = b.orientationY[collider];
        double qz = b.orientationZ[collider];
        double qw = b.orientationW[collider];
        int r = BodyStore.REVOLUTION * collider;
        for (int n = 0; n < 3; n++) {
            double sum = 0;
            for (int axis = 0; axis < 3; axis++) {
                sum += b.revolution[r + axis] * Rotation.axis(qx, qy, qz, qw, axis, n);
            }
            to[at + AXIS + n] = sum;
        }
        to[at + RADIUS] = b.revolution[r + 3];
    }

    /**
     * Finds S, T and Q o.
     *
     * @param turn nine numbers of Q from {@code m} on
     * @param m or -1 for a side whose points do not go with an axis
     * @param kept of the side, from {@code k} on
     * @param normal of the contact, from A to B, world, from {@code n} on
     * @param inner radius of the body, m
     */
    void set(double[] turn, int m, double[] kept, int k, double[] normal, int n, double inner) {
        isSet = m >= 0;
        travels = false;
        if (!isSet) {
            return;
        }
        x = kept[k];
        y = kept[k + 1];
        z = kept[k + 2];
        toX = turn[m] * x + turn[m + 1] * y + turn[m + 2] * z;
        toY = turn[m + 3] * x + turn[m + 4] * y + turn[m + 5] * z;
        toZ = turn[m + 6] * x + turn[m + 7] * y + turn[m + 8] * z;
        radius = kept[k + RADIUS];
        double ax = kept[k + AXIS];
        double ay = kept[k + AXIS + 1];
        double az = kept[k + AXIS + 2];
        isBall = ax == 0 && ay == 0 && az == 0;
        if (isBall) {
            return;
        }
        for (int i = 0; i < 3; i++) {
            axis[i] = kept[k + AXIS + i];
            now[i] = turn[m + 3 * i] * ax + turn[m + 3 * i + 1] * ay + turn[m + 3 * i + 2] * az;
        }
        swing(ax, ay, az, now[0], now[1], now[2]);
        travel(side * normal[n], side * normal[n + 1], side * normal[n + 2], inner);
    }

    /**
     * T S: with c and s of the angle from S l to l', {@code T v = c v + (1 - c) b b.v + s b x v}.
     */
    private void travel(double nx, double ny, double nz, double inner) {
        double along = nx * axis[0] + ny * axis[1] + nz * axis[2];
        low[0] = nx - along * axis[0];
        low[1] = ny - along * axis[1];
        low[2] = nz - along * axis[2];
        double bx = now[0];
        double by = now[1];
        double bz = now[2];
        double on = nx * bx + ny * by + nz * bz;
        double mx = nx - on * bx;
        double my = ny - on * by;
        double mz = nz - on * bz;
        double start = low[0] * low[0] + low[1] * low[1] + low[2] * low[2];
        double end = mx * mx + my * my + mz * mz;
        if (!(start > 0 && end > 0)) {
            return;
        }
        start = 1 / Math.sqrt(start);
        end = 1 / Math.sqrt(end);
        least = FLAT * inner * Math.max(start, end);
        for (int i = 0; i < 3; i++) {
            low[i] *= start;
        }
        double lx = swing[0] * low[0] + swing[1] * low[1] + swing[2] * low[2];
        double ly = swing[3] * low[0] + swing[4] * low[1] + swing[5] * low[2];
        double lz = swing[6] * low[0] + swing[7] * low[1] + swing[8] * low[2];
        double c = (lx * mx + ly * my + lz * mz) * end;
        double s =
                ((ly * mz - lz * my) * bx + (lz * mx - lx * mz) * by + (lx * my - ly * mx) * bz)
                        * end;
        travels = c > FAR;
        for (int i = 0; i < 3; i++) {
            double vx = swing[i];
            double vy = swing[3 + i];
            double vz = swing[6 + i];
            double t = (1 - c) * (bx * vx + by * vy + bz * vz);
            travel[i] = c * vx + t * bx + s * (by * vz - bz * vy);
            travel[3 + i] = c * vy + t * by + s * (bz * vx - bx * vz);
            travel[6 + i] = c * vz + t * bz + s * (bx * vy - by * vx);
        }
    }

    /** Whether a point, from the collider's centre, is the one of its rim that lies deepest. */
    private boolean isDeepest(double rx, double ry, double rz) {
        double along = rx * axis[0] + ry * axis[1] + rz * axis[2];
        double ux = rx - along * axis[0];
        double uy = ry - along * axis[1];
        double uz = rz - along * axis[2];
        double reach = ux * low[0] + uy * low[1] + uz * low[2];
        double square = ux * ux + uy * uy + uz * uz;
        return reach > least && reach * reach >= (1 - 2 * DEEPEST) * square;
    }

    /** S from a to b: with w = a x b and c = a.b it is 1 c + [w] + w w^T / (1 + c). */
    private void swing(double ax, double ay, double az, double bx, double by, double bz) {
        double c = ax * bx + ay * by + az * bz;
        double wx = ay * bz - az * by;
        double wy = az * bx - ax * bz;
        double wz = ax * by - ay * bx;
        // half a turn within a tick has no shortest way; the points stay then
        double k = c > -0.999 ? 1 / (1 + c) : 0;
        c = k > 0 ? c : 1;
        double s = k > 0 ? 1 : 0;
        swing[0] = c + k * wx * wx;
        swing[1] = k * wx * wy - s * wz;
        swing[2] = k * wx * wz + s * wy;
        swing[3] = k * wx * wy + s * wz;
        swing[4] = c + k * wy * wy;
        swing[5] = k * wy * wz - s * wx;
        swing[6] = k * wx * wz - s * wy;
        swing[7] = k * wy * wz + s * wx;
        swing[8] = c + k * wz * wz;
    }

    /**
     * Moves a point, if it goes with an axis.
     *
     * @param record holds where it was at the tick's start, from the body's centre, at {@code q}
     * @param to receives where it is now, at {@code i}
     * @param half of the gap, m
     * @param nx normal of the contact, from A to B, world
     * @param ny as nx
     * @param nz as nx
     */
    void move(
            double[] record,
            int q,
            double[] to,
            int i,
            double half,
            double nx,
            double ny,
            double nz) {
        if (!isSet) {
            return;
        }
        double rx = record[q] - x;
        double ry = record[q + 1] - y;
        double rz = record[q + 2] - z;
        if (isBall) {
            to[i] = toX + rx;
            to[i + 1] = toY + ry;
            to[i + 2] = toZ + rz;
            return;
        }
        double t = side * (radius + half);
        rx -= t * nx;
        ry -= t * ny;
        rz -= t * nz;
        double[] w = travels && isDeepest(rx, ry, rz) ? travel : swing;
        to[i] = toX + (w[0] * rx + w[1] * ry + w[2] * rz) + t * nx;
        to[i + 1] = toY + (w[3] * rx + w[4] * ry + w[5] * rz) + t * ny;
        to[i + 2] = toZ + (w[6] * rx + w[7] * ry + w[8] * rz) + t * nz;
    }
}
