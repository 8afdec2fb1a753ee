package dev.cairn.physics.solver;

import dev.cairn.physics.internal.ContactStore;

/**
 * Fills one constraint row from a contact and its two bodies; blocks of rows may run in parallel.
 */
final class PrepareRow {
    /**
     * Share of the patch's radius over which a point that leaves fades out of the friction's
     * centre.
     */
    private static final double FADE = 0.02;

    private PrepareRow() {}

    /**
     * Fills row {@code m}.
     *
     * @param impulseScale factor on the stored impulses: this sub-step over the last tick's
     */
    static void run(
            ConstraintRows rows,
            SolverBodies bodies,
            ContactStore c,
            int m,
            Softness soft,
            Softness staticSoft,
            double impulseScale) {
        double[] d = rows.row;
        int[] link = rows.link;
        int r = m * ConstraintRows.ROW;
        int l = m * ConstraintRows.LINK;
        int source = link[l + ConstraintRows.SOURCE];
        int a = c.bodyA[source];
        int b = c.bodyB[source];
        double ma = bodies.state[a * SolverBodies.STRIDE + SolverBodies.MASS];
        double mb = bodies.state[b * SolverBodies.STRIDE + SolverBodies.MASS];
        Softness s = ma == 0 || mb == 0 ? staticSoft : soft;
        double nx = c.normalX[source];
        double ny = c.normalY[source];
        double nz = c.normalZ[source];
        d[r] = nx;
        d[r + 1] = ny;
        d[r + 2] = nz;
        d[r + ConstraintRows.FRICTION] = c.friction[source];
        d[r + ConstraintRows.RESTITUTION] = c.restitution[source];
        d[r + ConstraintRows.BIAS_RATE] = s.biasRate();
        d[r + ConstraintRows.MASS_SCALE] = s.massScale();
        d[r + ConstraintRows.IMPULSE_SCALE] = s.impulseScale();
        d[r + ConstraintRows.MASS_A] = ma;
        d[r + ConstraintRows.MASS_B] = mb;
        d[r + ConstraintRows.TOTAL] = 0;
        d[r + ConstraintRows.TOTAL + 1] = 0;
        d[r + ConstraintRows.TOTAL + 2] = 0;
        tangents(d, r, nx, ny, nz);
        centre(d, r, c, source);
        points(rows, bodies, c, m, a, b, impulseScale);
        if (d[r + ConstraintRows.FRICTION] > 0) {
            friction(d, r, bodies, c, source, a, b, impulseScale);
        } else {
            d[r + ConstraintRows.LAMBDA] = 0;
            d[r + ConstraintRows.LAMBDA + 1] = 0;
            d[r + ConstraintRows.LAMBDA + 2] = 0;
        }
    }

    /** {@code t1 = n x e / |n x e|}, e the axis along which n is shortest; {@code t2 = n x t1}. */
    private static void tangents(double[] d, int r, double nx, double ny, double nz) {
        double ax = Math.abs(nx);
        double ay = Math.abs(ny);
        double az = Math.abs(nz);
        double x;
        double y;
        double z;
        if (ax <= ay && ax <= az) {
            x = 0;
            y = nz;
            z = -ny;
        } else if (az <= ay) {
            x = ny;
            y = -nx;
            z = 0;
        } else {
            x = -nz;
            y = 0;
            z = nx;
        }
        double k = 1 / Math.sqrt(x * x + y * y + z * z);
        x *= k;
        y *= k;
        z *= k;
        int t = r + ConstraintRows.TANGENT1;
        d[t] = x;
        d[t + 1] = y;
        d[t + 2] = z;
        d[t + 3] = ny * z - nz * y;
        d[t + 4] = nz * x - nx * z;
        d[t + 5] = nx * y - ny * x;
    }

    /**
     * Centre of the friction patch, into the first three and second three lever slots as rA and rB:
     * the mean of the anchors, with points that have left fading out so that the centre moves
     * without jumps.
     *
     * <p>The anchors lie midway between the surfaces; here each goes back to its own body's
     * surface, because that is where the bodies will touch when the gap has closed. Overlap between
     * two moving bodies keeps the common point, so that their friction makes no angular momentum.
     */
    private static void centre(double[] d, int r, ContactStore c, int source) {
        int first = ContactStore.POINTS * source;
        int n = c.pointCount[source];
        boolean still = d[r + ConstraintRows.MASS_A] == 0 || d[r + ConstraintRows.MASS_B] == 0;
        double spread = 0;
        for (int p = first + 1; p < first + n; p++) {
            double x = c.anchorAX[p] - c.anchorAX[first];
            double y = c.anchorAY[p] - c.anchorAY[first];
            double z = c.anchorAZ[p] - c.anchorAZ[first];
            spread = Math.max(spread, x * x + y * y + z * z);
        }
        double fade = FADE * Math.sqrt(spread);
        double sum = 0;
        double ax = 0;
        double ay = 0;
        double az = 0;
        double bx = 0;
        double by = 0;
        double bz = 0;
        for (int p = first; p < first + n; p++) {
            double gap = c.separation[p];
            double w = gap <= fade || fade == 0 ? 1 : Math.max(2 - gap / fade, 1e-10);
            double half = 0.5 * (still ? gap : Math.max(gap, 0));
            sum += w;
            ax += w * (c.anchorAX[p] - half * d[r]);
            ay += w * (c.anchorAY[p] - half * d[r + 1]);
            az += w * (c.anchorAZ[p] - half * d[r + 2]);
            bx += w * (c.anchorBX[p] + half * d[r]);
            by += w * (c.anchorBY[p] + half * d[r + 1]);
            bz += w * (c.anchorBZ[p] + half * d[r + 2]);
        }
        double k = 1 / sum;
        int o = r + ConstraintRows.LEVER;
        d[o] = ax * k;
        d[o + 1] = ay * k;
        d[o + 2] = az * k;
        d[o + 3] = bx * k;
        d[o + 4] = by * k;
        d[o + 5] = bz * k;
    }

    private static void points(
            ConstraintRows rows,
            SolverBodies bodies,
            ContactStore c,
            int m,
            int a,
            int b,
            double impulseScale) {
        double[] d = rows.row;
        double[] q = rows.point;
        int r = m * ConstraintRows.ROW;
        int source = rows.link[m * ConstraintRows.LINK + ConstraintRows.SOURCE];
        double nx = d[r];
        double ny = d[r + 1];
        double nz = d[r + 2];
        double sum = d[r + ConstraintRows.MASS_A] + d[r + ConstraintRows.MASS_B];
        double cx = d[r + ConstraintRows.LEVER];
        double cy = d[r + ConstraintRows.LEVER + 1];
        double cz = d[r + ConstraintRows.LEVER + 2];
        double radius = 0;
        boolean unloaded = rows.link[m * ConstraintRows.LINK + ConstraintRows.UNLOADED] != 0;
        // k = m_eff biasRate massScale / impulseScale
        double stiffness =
                d[r + ConstraintRows.BIAS_RATE]
                        * d[r + ConstraintRows.MASS_SCALE]
                        / d[r + ConstraintRows.IMPULSE_SCALE];
        for (int i = 0; i < c.pointCount[source]; i++) {
            int p = ContactStore.POINTS * source + i;
            int o = (ContactStore.POINTS * m + i) * ConstraintRows.POINT;
            double x = c.anchorAX[p];
            double y = c.anchorAY[p];
            double z = c.anchorAZ[p];
            cross(q, o, x, y, z, nx, ny, nz);
            cross(q, o + 3, c.anchorBX[p], c.anchorBY[p], c.anchorBZ[p], nx, ny, nz);
            apply(bodies.inverseInertia, a, q, o, q, o + ConstraintRows.SPIN);
            apply(bodies.inverseInertia, b, q, o + 3, q, o + ConstraintRows.SPIN + 3);
            // 1/m_eff = 1/mA + 1/mB + (rA x n).IA^-1(rA x n) + (rB x n).IB^-1(rB x n)
            double w = sum + dot(q, o, q, o + 6) + dot(q, o + 3, q, o + 9);
            q[o + ConstraintRows.MASS] = w > 0 ? 1 / w : 0;
            // at rest the soft step holds the load l with the overlap l / k; the offset stands for
            // the load that it knows
            double k = q[o + ConstraintRows.MASS] * stiffness;
            q[o + ConstraintRows.STIFFNESS] = k;
            double known = unloaded ? 0 : c.preload[p] * impulseScale;
            q[o + ConstraintRows.GAP] = c.separation[p] - (k > 0 ? known / k : 0);
            q[o + ConstraintRows.IMPULSE] = c.normalImpulse[p] * impulseScale;
            q[o + ConstraintRows.SUM] = 0;
            double dx = x - cx;
            double dy = y - cy;
            double dz = z - cz;
            double reach = Math.sqrt(dx * dx + dy * dy + dz * dz);
            q[o + ConstraintRows.REACH] = reach;
            radius = Math.max(radius, reach);
        }
        d[r + ConstraintRows.RADIUS] = radius;
    }

    private static void friction(
            double[] d,
            int r,
            SolverBodies bodies,
            ContactStore c,
            int source,
            int a,
            int b,
            double impulseScale) {
        double[] inertia = bodies.inverseInertia;
        int lever = r + ConstraintRows.LEVER;
        int turn = r + ConstraintRows.TURN;
        int t1 = r + ConstraintRows.TANGENT1;
        int t2 = r + ConstraintRows.TANGENT2;
        double ax = d[lever];
        double ay = d[lever + 1];
        double az = d[lever + 2];
        double bx = d[lever + 3];
        double by = d[lever + 4];
        double bz = d[lever + 5];
        cross(d, lever, ax, ay, az, d[t1], d[t1 + 1], d[t1 + 2]);
        cross(d, lever + 3, ax, ay, az, d[t2], d[t2 + 1], d[t2 + 2]);
        cross(d, lever + 6, bx, by, bz, d[t1], d[t1 + 1], d[t1 + 2]);
        cross(d, lever + 9, bx, by, bz, d[t2], d[t2 + 1], d[t2 + 2]);
        apply(inertia, a, d, lever, d, turn);
        apply(inertia, a, d, lever + 3, d, turn + 3);
        apply(inertia, b, d, lever + 6, d, turn + 6);
        apply(inertia, b, d, lever + 9, d, turn + 9);
        apply(inertia, a, d, r, d, turn + 12);
        apply(inertia, b, d, r, d, turn + 15);
        double sum = d[r + ConstraintRows.MASS_A] + d[r + ConstraintRows.MASS_B];
        // K_ij = (1/mA + 1/mB) d_ij + (rA x ti).IA^-1(rA x tj) + (rB x ti).IB^-1(rB x tj)
        double k11 = sum + dot(d, lever, d, turn) + dot(d, lever + 6, d, turn + 6);
        double k12 = dot(d, lever, d, turn + 3) + dot(d, lever + 6, d, turn + 9);
        double k22 = sum + dot(d, lever + 3, d, turn + 3) + dot(d, lever + 9, d, turn + 9);
        double det = 1 / (k11 * k22 - k12 * k12);
        d[r + ConstraintRows.BLOCK] = k22 * det;
        d[r + ConstraintRows.BLOCK + 1] = -k12 * det;
        d[r + ConstraintRows.BLOCK + 2] = k11 * det;
        double twist = dot(d, r, d, turn + 12) + dot(d, r, d, turn + 15);
        d[r + ConstraintRows.TWIST_MASS] = twist > 0 && c.pointCount[source] > 1 ? 1 / twist : 0;
        double x = c.frictionImpulseX[source] * impulseScale;
        double y = c.frictionImpulseY[source] * impulseScale;
        double z = c.frictionImpulseZ[source] * impulseScale;
        d[r + ConstraintRows.LAMBDA] = x * d[t1] + y * d[t1 + 1] + z * d[t1 + 2];
        d[r + ConstraintRows.LAMBDA + 1] = x * d[t2] + y * d[t2 + 1] + z * d[t2 + 2];
        d[r + ConstraintRows.LAMBDA + 2] =
                d[r + ConstraintRows.TWIST_MASS] > 0 ? c.twistImpulse[source] * impulseScale : 0;
    }

    private static void cross(
            double[] out, int o, double ax, double ay, double az, double bx, double by, double bz) {
        out[o] = ay * bz - az * by;
        out[o + 1] = az * bx - ax * bz;
        out[o + 2] = ax * by - ay * bx;
    }

    /** {@code out = I^-1 v} with the world inverse inertia of a slot. */
    private static void apply(double[] inertia, int slot, double[] v, int i, double[] out, int o) {
        int k = 6 * slot;
        double x = v[i];
        double y = v[i + 1];
        double z = v[i + 2];
        out[o] = inertia[k] * x + inertia[k + 3] * y + inertia[k + 4] * z;
        out[o + 1] = inertia[k + 3] * x + inertia[k + 1] * y + inertia[k + 5] * z;
        out[o + 2] = inertia[k + 4] * x + inertia[k + 5] * y + inertia[k + 2] * z;
    }

    static double dot(double[] a, int i, double[] b, int j) {
        return a[i] * b[j] + a[i + 1] * b[j + 1] + a[i + 2] * b[j + 2];
    }
}
