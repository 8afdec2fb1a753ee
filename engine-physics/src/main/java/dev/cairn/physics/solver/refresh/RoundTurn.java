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
 * <pre>o + r  goes to  Q o + S (r - t n) + t n</pre>
 *
 * <p>where n is the contact's normal away from the solid and t the radius of what is laid around
 * its core, of a capsule its own, of a cylinder 0, and half of the gap. A ball is all radius:
 * {@code Q o + r}.
 *
 * <p>Without this the rim's point stayed where it was: cans rose by 7 mm of 200 while they tipped,
 * and gained 2 % of their energy. One thread at a time; allocates when it is made. Source: own
 * study; S is Rodrigues' rotation for two unit vectors.
 */
final class RoundTurn {
    /** What is kept of a side: o, then the axis, world, at the tick's start; t. */
    static final int NUMBERS = 7;

    static final int AXIS = 3;
    static final int RADIUS = 6;

    /** 1 if the normal points away from the solid. */
    private final double side;

    private boolean isSet;
    private boolean isBall;

    /** S, row by row. */
    private final double[] swing = new double[9];

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
     * Finds S and Q o.
     *
     * @param turn nine numbers of Q from {@code m} on
     * @param m or -1 for a side whose points do not go with an axis
     * @param kept of the side, from {@code k} on
     */
    void set(double[] turn, int m, double[] kept, int k) {
        isSet = m >= 0;
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
        if (!isBall) {
            swing(
                    ax,
                    ay,
                    az,
                    turn[m] * ax + turn[m + 1] * ay + turn[m + 2] * az,
                    turn[m + 3] * ax + turn[m + 4] * ay + turn[m + 5] * az,
                    turn[m + 6] * ax + turn[m + 7] * ay + turn[m + 8] * az);
        }
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
     * Moves the points of a side, if they go with an axis.
     *
     * @param record holds where they were at the tick's start, from the body's centre, and their
     *     gaps, the first point at {@code first}
     * @param to receives where they are now, the first point at 0
     * @param part of a point: 0 for A, 3 for B
     * @param n number of points
     * @param nx normal of the contact, from A to B, world
     * @param ny as nx
     * @param nz as nx
     */
    void move(
            double[] record,
            int first,
            double[] to,
            int part,
            int n,
            double nx,
            double ny,
            double nz) {
        if (!isSet) {
            return;
        }
        int q = first + part;
        int end = RefreshRow.NUMBERS * n;
        if (isBall) {
            for (int i = part; i < end; i += RefreshRow.NUMBERS, q += RefreshRow.NUMBERS) {
                to[i] = toX + (record[q] - x);
                to[i + 1] = toY + (record[q + 1] - y);
                to[i + 2] = toZ + (record[q + 2] - z);
            }
            return;
        }
        for (int i = part; i < end; i += RefreshRow.NUMBERS, q += RefreshRow.NUMBERS) {
            double t = side * (radius + 0.5 * record[q - part + RefreshRow.GAPS]);
            double rx = record[q] - x - t * nx;
            double ry = record[q + 1] - y - t * ny;
            double rz = record[q + 2] - z - t * nz;
            to[i] = toX + (swing[0] * rx + swing[1] * ry + swing[2] * rz) + t * nx;
            to[i + 1] = toY + (swing[3] * rx + swing[4] * ry + swing[5] * rz) + t * ny;
            to[i + 2] = toZ + (swing[6] * rx + swing[7] * ry + swing[8] * rz) + t * nz;
        }
    }
}
