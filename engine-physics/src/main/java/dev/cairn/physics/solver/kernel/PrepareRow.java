package dev.cairn.physics.solver.kernel;

import static dev.cairn.physics.solver.row.ConstraintRows.*;

import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.Scratch;
import dev.cairn.physics.solver.row.SubStep;

/**
 * Fills constraint rows from contacts and their two bodies, and adds their last impulses to the
 * bodies' warm start. Chunks of a colour may run in parallel.
 */
public final class PrepareRow implements RowFiller {
    /**
     * Share of the patch's radius over which a point that leaves fades out of the friction's
     * centre.
     */
    public static final double FADE = 0.02;

    /**
     * Mean distance of an evenly pressed patch's area from its middle, over that of its points: of
     * a line, an equilateral triangle and a square, by their number. Oblongs lie between the line
     * and the square.
     */
    private static final double LINE = 0.5;

    private static final double TRIANGLE = 0.46;
    private static final double SQUARE = 0.541;

    /** How far from the patch's middle friction acts at a point, over its own distance. */
    public static double share(ContactStore c, int source) {
        double share = c.patch[source];
        int n = c.pointCount[source];
        return share > 0 ? share : n == 4 ? SQUARE : n == 3 ? TRIANGLE : LINE;
    }

    @Override
    public void fill(
            ConstraintRows rows,
            SolverBodies bodies,
            ContactStore c,
            SubStep sub,
            int from,
            int to,
            Scratch scratch) {
        int lanes = rows.lanes;
        double scale = sub.fillScale;
        for (int group = from; group < to; group += lanes) {
            int most = 0;
            boolean hasFriction = false;
            for (int j = group; j < group + lanes; j++) {
                int n = rows.link[j * LINK + ConstraintRows.COUNT];
                int o = rows.base(j);
                if (n == 0) {
                    clear(rows.doubles, o, lanes, 0, ConstraintRows.FIELDS);
                    continue;
                }
                int source = rows.link[j * LINK + ConstraintRows.SOURCE];
                most = Math.max(most, n);
                hasFriction |= c.friction(source) > 0;
                row(rows, bodies, c, j, o, source, sub, scale);
            }
            rows.points[group / lanes] = most == 3 ? 4 : most;
            rows.hasFriction[group / lanes] = hasFriction;
        }
    }

    private static void clear(double[] d, int o, int lanes, int field, int end) {
        for (int f = field; f < end; f++) {
            d[o + f * lanes] = 0;
        }
    }

    private static void row(
            ConstraintRows rows,
            SolverBodies bodies,
            ContactStore c,
            int j,
            int o,
            int source,
            SubStep sub,
            double scale) {
        double[] d = rows.doubles;
        int lanes = rows.lanes;
        int a = rows.link[j * LINK];
        int b = rows.link[j * LINK + 1];
        double ma = bodies.state[a + SolverBodies.MASS];
        double mb = bodies.state[b + SolverBodies.MASS];
        boolean fixed = ma == 0 || mb == 0;
        double nx = c.normalX(source);
        double ny = c.normalY(source);
        double nz = c.normalZ(source);
        d[o] = nx;
        d[o + lanes] = ny;
        d[o + 2 * lanes] = nz;
        d[o + MASS_A * lanes] = ma;
        d[o + MASS_B * lanes] = mb;
        d[o + FRICTION * lanes] = c.friction(source);
        tangents(d, o, lanes, nx, ny, nz);
        points(rows, bodies, c, j, o, source, sub.stiffness(fixed), scale);
        if (c.friction(source) > 0) {
            friction(rows, bodies, c, j, o, source, fixed, scale);
        } else {
            clear(d, o, lanes, REACH, REACH + 4);
            clear(d, o, lanes, BLOCK, TOTAL + 3);
        }
        WarmStart.positive(bodies.warm, a);
        WarmStart.positive(bodies.warm, b);
    }

    /** Turns the row of two balls, which holds no impulses, to the contact's normal and anchors. */
    public static void aim(
            ConstraintRows rows, SolverBodies bodies, ContactStore c, int j, int source) {
        double[] d = rows.doubles;
        int lanes = rows.lanes;
        int o = rows.base(j);
        double nx = c.normalX(source);
        double ny = c.normalY(source);
        double nz = c.normalZ(source);
        put(d, o, lanes, nx, ny, nz);
        // a ball's arm is parallel to the normal
        clear(d, o, lanes, POINT + ARM_A, POINT + ARM_A + 6);
        if (d[o + FRICTION * lanes] > 0) {
            tangents(d, o, lanes, nx, ny, nz);
            int p = ContactStore.POINTS * source;
            block(
                    rows,
                    bodies,
                    j,
                    o,
                    c.anchorAX(p),
                    c.anchorAY(p),
                    c.anchorAZ(p),
                    c.anchorBX(p),
                    c.anchorBY(p),
                    c.anchorBZ(p),
                    false);
        }
    }

    /**
     * Gives a point of a row other levers.
     *
     * @param arms from the middle of A, then from that of B, world, m
     */
    public static void point(
            ConstraintRows rows, SolverBodies bodies, int j, int point, double[] arms) {
        double[] d = rows.doubles;
        int lanes = rows.lanes;
        int o = rows.base(j);
        int q = o + (POINT + point * POINT_FIELDS) * lanes;
        double w = d[o + MASS_A * lanes] + d[o + MASS_B * lanes];
        for (int side = 0; side < 2; side++) {
            w +=
                    arm(
                            bodies.root,
                            rows.link[j * LINK + side],
                            d,
                            q + (ARM_A + 3 * side) * lanes,
                            lanes,
                            arms[3 * side],
                            arms[3 * side + 1],
                            arms[3 * side + 2],
                            d[o],
                            d[o + lanes],
                            d[o + 2 * lanes]);
        }
        d[q + MASS * lanes] = w > 0 ? 1 / w : 0;
    }

    /** {@code t1 = n x e / |n x e|}, e the axis along which n is shortest; {@code t2 = n x t1}. */
    public static void tangents(double[] d, int o, int lanes, double nx, double ny, double nz) {
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
        put(d, o + TANGENT1 * lanes, lanes, x, y, z);
        put(d, o + TANGENT2 * lanes, lanes, ny * z - nz * y, nz * x - nx * z, nx * y - ny * x);
    }

    private static void points(
            ConstraintRows rows,
            SolverBodies bodies,
            ContactStore c,
            int j,
            int o,
            int source,
            double stiffness,
            double scale) {
        double[] d = rows.doubles;
        int lanes = rows.lanes;
        int a = rows.link[j * LINK];
        int b = rows.link[j * LINK + 1];
        boolean settles = rows.settleMark[j] != 0;
        double nx = d[o];
        double ny = d[o + lanes];
        double nz = d[o + 2 * lanes];
        double ma = d[o + MASS_A * lanes];
        double mb = d[o + MASS_B * lanes];
        double sum = 0;
        int n = c.pointCount[source];
        for (int i = 0; i < n; i++) {
            int p = ContactStore.POINTS * source + i;
            int q = o + (POINT + i * POINT_FIELDS) * lanes;
            double square =
                    arm(
                                    bodies.root,
                                    a,
                                    d,
                                    q + ARM_A * lanes,
                                    lanes,
                                    c.anchorAX(p),
                                    c.anchorAY(p),
                                    c.anchorAZ(p),
                                    nx,
                                    ny,
                                    nz)
                            + arm(
                                    bodies.root,
                                    b,
                                    d,
                                    q + ARM_B * lanes,
                                    lanes,
                                    c.anchorBX(p),
                                    c.anchorBY(p),
                                    c.anchorBZ(p),
                                    nx,
                                    ny,
                                    nz);
            // 1/m_eff = 1/mA + 1/mB + (rA x n).IA^-1(rA x n) + (rB x n).IB^-1(rB x n)
            double w = ma + mb + square;
            double mass = w > 0 ? 1 / w : 0;
            d[q + MASS * lanes] = mass;
            // at rest the soft step holds the load l with the overlap l / k; the offset stands for
            // the load that it knows
            double k = mass * stiffness;
            double known = settles ? 0 : c.preload[p] * scale;
            double gap = c.separation[p] - (k > 0 ? known / k : 0);
            double impulse = c.normalImpulse[p] * scale;
            d[o + (GAP + i) * lanes] = gap;
            d[q + SEPARATION * lanes] = gap;
            d[q + IMPULSE * lanes] = impulse;
            d[o + (SUM + i) * lanes] = 0;
            WarmStart.turn(
                    bodies.warm, a, b, d, q + ARM_A * lanes, q + ARM_B * lanes, lanes, impulse);
            sum += impulse;
        }
        WarmStart.push(bodies.warm, a, b, ma * sum, mb * sum, nx, ny, nz);
        for (int i = n; i < ContactStore.POINTS; i++) {
            clear(d, o + (POINT + i * POINT_FIELDS) * lanes, lanes, 0, POINT_FIELDS);
            d[o + (GAP + i) * lanes] = 0;
            d[o + (SUM + i) * lanes] = 0;
        }
    }

    private static void friction(
            ConstraintRows rows,
            SolverBodies bodies,
            ContactStore c,
            int j,
            int o,
            int source,
            boolean fixed,
            double scale) {
        double[] d = rows.doubles;
        int lanes = rows.lanes;
        double nx = d[o];
        double ny = d[o + lanes];
        double nz = d[o + 2 * lanes];
        int first = ContactStore.POINTS * source;
        int n = c.pointCount[source];
        // Centre of the patch: the mean of the anchors, with points that have left fading out so
        // that it moves without jumps. Of a guided body that has not touched yet, those fade that
        // are behind the first that will; in larger islands, whose energy nothing bounds, the mean
        // of all stays. The anchors lie midway between the surfaces; against what does not move,
        // the anchor goes back to the body's own surface, because that is where the
        // body will touch when the gap has closed. Two moving bodies keep the common point, so that
        // their friction makes no angular momentum.
        double spread = 0;
        double least = c.separation[first];
        for (int p = first + 1; p < first + n; p++) {
            double x = c.anchorAX(p) - c.anchorAX(first);
            double y = c.anchorAY(p) - c.anchorAY(first);
            double z = c.anchorAZ(p) - c.anchorAZ(first);
            spread = Math.max(spread, x * x + y * y + z * z);
            least = Math.min(least, c.separation[p]);
        }
        double fade = FADE * Math.sqrt(spread);
        double moved = fixed ? 0 : moved(rows, bodies, j, nx, ny, nz);
        int link = j * LINK;
        boolean guided = bodies.isGuided(rows.link[link]) || bodies.isGuided(rows.link[link + 1]);
        double nearest = guided ? Math.max(0, least) : 0;
        double sum = 0;
        double ax = 0;
        double ay = 0;
        double az = 0;
        double bx = 0;
        double by = 0;
        double bz = 0;
        double shift = 0;
        for (int p = first; p < first + n; p++) {
            double gap = c.separation[p] + moved;
            double w = weight(gap - nearest, fade);
            sum += w;
            shift += w * (0.5 * (fixed ? gap : 0));
            ax += w * c.anchorAX(p);
            ay += w * c.anchorAY(p);
            az += w * c.anchorAZ(p);
            bx += w * c.anchorBX(p);
            by += w * c.anchorBY(p);
            bz += w * c.anchorBZ(p);
        }
        double k = 1 / sum;
        shift *= k;
        ax *= k;
        ay *= k;
        az *= k;
        double share = share(c, source);
        for (int i = 0; i < ContactStore.POINTS; i++) {
            // from the middle of the anchors, which is the same seen from either body
            double x = c.anchorAX(first + i) - ax;
            double y = c.anchorAY(first + i) - ay;
            double z = c.anchorAZ(first + i) - az;
            double far = i < n ? Math.sqrt(x * x + y * y + z * z) : 0;
            d[o + (REACH + i) * lanes] = far * share;
        }
        ax -= shift * nx;
        ay -= shift * ny;
        az -= shift * nz;
        bx = bx * k + shift * nx;
        by = by * k + shift * ny;
        bz = bz * k + shift * nz;
        block(rows, bodies, j, o, ax, ay, az, bx, by, bz, n > 1);
        warm(rows, bodies, c, j, o, source, scale);
    }

    /**
     * Weight of a point in the centre of its patch.
     *
     * @param behind how much farther from touching it is than what touches or will first, m
     * @param fade how far behind a point begins to fade, m
     * @return 1, towards 0 from {@code fade} to {@code 2 fade}
     */
    public static double weight(double behind, double fade) {
        return behind <= fade || fade == 0 ? 1 : Math.max(2 - behind / fade, 1e-10);
    }

    /** How far the bodies have parted along the normal since the tick's start, m. */
    private static double moved(
            ConstraintRows rows, SolverBodies bodies, int j, double nx, double ny, double nz) {
        int a = rows.link[j * LINK] + SolverBodies.P;
        int b = rows.link[j * LINK + 1] + SolverBodies.P;
        double[] s = bodies.state;
        return nx * (s[b] - s[a]) + ny * (s[b + 1] - s[a + 1]) + nz * (s[b + 2] - s[a + 2]);
    }

    /** Levers, tangent block and twist at the patch's centre, from the middles of A and B, m. */
    public static void block(
            ConstraintRows rows,
            SolverBodies bodies,
            int j,
            int o,
            double ax,
            double ay,
            double az,
            double bx,
            double by,
            double bz,
            boolean wide) {
        double[] d = rows.doubles;
        double[] root = bodies.root;
        int lanes = rows.lanes;
        int a = rows.link[j * LINK];
        int b = rows.link[j * LINK + 1];
        int t1 = o + TANGENT1 * lanes;
        int t2 = o + TANGENT2 * lanes;
        double x1 = d[t1];
        double y1 = d[t1 + lanes];
        double z1 = d[t1 + 2 * lanes];
        double x2 = d[t2];
        double y2 = d[t2 + lanes];
        double z2 = d[t2 + 2 * lanes];
        int lever = o + LEVER * lanes;
        int three = 3 * lanes;
        double sum = d[o + MASS_A * lanes] + d[o + MASS_B * lanes];
        // K_ij = (1/mA + 1/mB) d_ij + (rA x ti).IA^-1(rA x tj) + (rB x ti).IB^-1(rB x tj)
        double k11 =
                sum
                        + arm(root, a, d, lever, lanes, ax, ay, az, x1, y1, z1)
                        + arm(root, b, d, lever + 2 * three, lanes, bx, by, bz, x1, y1, z1);
        double k22 =
                sum
                        + arm(root, a, d, lever + three, lanes, ax, ay, az, x2, y2, z2)
                        + arm(root, b, d, lever + 3 * three, lanes, bx, by, bz, x2, y2, z2);
        double k12 =
                dot(d, lever, lever + three, lanes)
                        + dot(d, lever + 2 * three, lever + 3 * three, lanes);
        double det = 1 / (k11 * k22 - k12 * k12);
        put(d, o + BLOCK * lanes, lanes, k22 * det, -k12 * det, k11 * det);
        int t = o + TWIST * lanes;
        double twist =
                weighted(root, a, d, t, lanes, d[o], d[o + lanes], d[o + 2 * lanes])
                        + weighted(
                                root, b, d, t + three, lanes, d[o], d[o + lanes], d[o + 2 * lanes]);
        d[o + TWIST_MASS * lanes] = twist > 0 && wide ? 1 / twist : 0;
    }

    private static void warm(
            ConstraintRows rows,
            SolverBodies bodies,
            ContactStore c,
            int j,
            int o,
            int source,
            double scale) {
        double[] d = rows.doubles;
        int lanes = rows.lanes;
        int t1 = o + TANGENT1 * lanes;
        int t2 = o + TANGENT2 * lanes;
        double x = c.frictionImpulseX(source) * scale;
        double y = c.frictionImpulseY(source) * scale;
        double z = c.frictionImpulseZ(source) * scale;
        put(
                d,
                o + LAMBDA * lanes,
                lanes,
                x * d[t1] + y * d[t1 + lanes] + z * d[t1 + 2 * lanes] + 0.0,
                x * d[t2] + y * d[t2 + lanes] + z * d[t2 + 2 * lanes] + 0.0,
                d[o + TWIST_MASS * lanes] > 0 ? c.twistImpulse(source) * scale + 0.0 : 0);
        put(d, o + TOTAL * lanes, lanes, 0, 0, 0);
        WarmStart.addFriction(rows, bodies.warm, j, o, 1);
    }

    /** Writes {@code L^T (r x u)}; returns its square. */
    private static double arm(
            double[] root,
            int body,
            double[] d,
            int o,
            int lanes,
            double rx,
            double ry,
            double rz,
            double ux,
            double uy,
            double uz) {
        return weighted(
                root, body, d, o, lanes, ry * uz - rz * uy, rz * ux - rx * uz, rx * uy - ry * ux);
    }

    /** Writes {@code L^T v}; returns its square. */
    private static double weighted(
            double[] root, int body, double[] d, int o, int lanes, double x, double y, double z) {
        int k = (body >> 4) * SolverBodies.ROOT;
        double u = root[k] * x + root[k + 3] * y + root[k + 6] * z;
        double v = root[k + 1] * x + root[k + 4] * y + root[k + 7] * z;
        double w = root[k + 2] * x + root[k + 5] * y + root[k + 8] * z;
        put(d, o, lanes, u, v, w);
        return u * u + v * v + w * w;
    }

    private static void put(double[] d, int o, int lanes, double x, double y, double z) {
        d[o] = x;
        d[o + lanes] = y;
        d[o + 2 * lanes] = z;
    }

    private static double dot(double[] d, int i, int j, int lanes) {
        return d[i] * d[j] + d[i + lanes] * d[j + lanes] + d[i + 2 * lanes] * d[j + 2 * lanes];
    }
}
