package dev.cairn.physics.solver.joint;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.JointStore;
import dev.cairn.physics.solver.body.SolverBodies;

/**
 * What the rows of a joint measure in the bodies' present poses, and the derivatives of it by the
 * velocities.
 *
 * <p>A row has four vectors, {@link #JACOBIAN} numbers: {@code c' = eB vB + tB wB - eA vA - tA wA}.
 * Forces along e act on both bodies at one point, B's origin, so that a row makes no angular
 * momentum, whatever gap is left.
 *
 * <p>With {@code q} the quaternion of B's frame in A's, x y z w, the twist about axis 0 is {@code 2
 * atan2(qx, qw)}, and by {@code q' = w q/2}
 *
 * <pre>
 * twist' = wx + ((qw qz + qx qy) wy + (qx qz - qw qy) wz) / (qw² + qx²)
 * </pre>
 *
 * <p>One object to a worker. Arithmetic and square roots only. Does not allocate.
 */
public final class JointMath {
    /** Numbers to a row: {@code eA, tA, eB, tB}. */
    public static final int JACOBIAN = 12;

    /** Below this squared length a direction is not one. */
    private static final double NOWHERE = 1e-24;

    /** A length below which a direction is not one. */
    static final double SMALL = 1e-12;

    /** World axes of the frame in A, row by row, then those in B. */
    final double[] axesA = new double[9];

    final double[] axesB = new double[9];

    /** Origins relative to the bodies' centres; that of B relative to A's; the gap between them. */
    final double[] armA = new double[3];

    final double[] armB = new double[3];
    final double[] reach = new double[3];
    final double[] gap = new double[3];

    /** Origins in the world. */
    final double[] placeA = new double[3];

    final double[] placeB = new double[3];
    private final Gearing gearing = new Gearing();
    private final CurveRows curve = new CurveRows();

    /** Frame of B in that of A. */
    private final double[] q = new double[4];

    private final double[] qa = new double[4];
    private final double[] qb = new double[4];
    private final double[] g = new double[3];

    /** Moment within the tick at which kinematic partners are looked at, s, and its length. */
    private double time, step;

    private final MovingPartner partner = new MovingPartner();
    private final double[] shiftA = new double[3];
    private final double[] shiftB = new double[3];

    /**
     * Chooses the moment of what follows: kinematic partners move within the tick, on their own.
     *
     * @param sinceBegin s
     * @param stepSeconds length of the tick, s
     */
    void at(double sinceBegin, double stepSeconds) {
        time = sinceBegin;
        step = stepSeconds;
    }

    /**
     * Reads the poses of a joint's bodies.
     *
     * @param j the joint
     * @param oa offset of A in the state of the solver, 0 for one that does not move
     * @param ob offset of B
     */
    public void look(BodyStore b, double[] state, JointStore s, int j, int oa, int ob) {
        int a = s.bodyA[j];
        int c = s.bodyB[j];
        int f = JointStore.FRAME * j;
        place(b, state, a, oa, s.frame, f, qa, armA, axesA, shiftA);
        place(b, state, c, ob, s.frame, f + 7, qb, armB, axesB, shiftB);
        reach[0] = b.apartX(a, c) + (shiftB[0] - shiftA[0]) + armB[0];
        reach[1] = b.apartY(a, c) + (shiftB[1] - shiftA[1]) + armB[1];
        reach[2] = b.apartZ(a, c) + (shiftB[2] - shiftA[2]) + armB[2];
        for (int k = 0; k < 3; k++) {
            gap[k] = reach[k] - armA[k];
            placeA[k] = shiftA[k] + armA[k];
            placeB[k] = shiftB[k] + armB[k];
        }
        placeA[0] += b.positionX[a];
        placeA[1] += b.positionY[a];
        placeA[2] += b.positionZ[a];
        placeB[0] += b.positionX[c];
        placeB[1] += b.positionY[c];
        placeB[2] += b.positionZ[c];
        // q = qa^-1 qb
        q[0] = qa[3] * qb[0] - qa[0] * qb[3] - (qa[1] * qb[2] - qa[2] * qb[1]);
        q[1] = qa[3] * qb[1] - qa[1] * qb[3] - (qa[2] * qb[0] - qa[0] * qb[2]);
        q[2] = qa[3] * qb[2] - qa[2] * qb[3] - (qa[0] * qb[1] - qa[1] * qb[0]);
        q[3] = qa[3] * qb[3] + qa[0] * qb[0] + qa[1] * qb[1] + qa[2] * qb[2];
    }

    /** Axes of a frame with a quaternion, row by row. */
    static void axes(double[] q, int at, double[] axes) {
        double x = q[at];
        double y = q[at + 1];
        double z = q[at + 2];
        double w = q[at + 3];
        axes[0] = 1 - 2 * (y * y + z * z);
        axes[1] = 2 * (x * y + w * z);
        axes[2] = 2 * (x * z - w * y);
        axes[3] = 2 * (x * y - w * z);
        axes[4] = 1 - 2 * (x * x + z * z);
        axes[5] = 2 * (y * z + w * x);
        axes[6] = 2 * (x * z + w * y);
        axes[7] = 2 * (y * z - w * x);
        axes[8] = 1 - 2 * (x * x + y * y);
    }

    /** World frame of a joint in a body, and how far that has moved since the tick's begin. */
    private void place(
            BodyStore b,
            double[] state,
            int i,
            int offset,
            double[] local,
            int f,
            double[] q,
            double[] arm,
            double[] axes,
            double[] shift) {
        if (offset == 0 && time != 0 && b.isMoved(i)) {
            partner.place(b, i, time, step);
            shift[0] = partner.x;
            shift[1] = partner.y;
            shift[2] = partner.z;
            double[] t = partner.turn;
            frame(t[0], t[1], t[2], t[3], local, f, q, arm, axes);
            return;
        }
        System.arraycopy(state, offset + SolverBodies.P, shift, 0, 3);
        frame(
                b.orientationX[i],
                b.orientationY[i],
                b.orientationZ[i],
                b.orientationW[i],
                local,
                f,
                q,
                arm,
                axes);
    }

    private static void frame(
            double bx,
            double by,
            double bz,
            double bw,
            double[] local,
            int f,
            double[] q,
            double[] arm,
            double[] axes) {
        double px = local[f + 3];
        double py = local[f + 4];
        double pz = local[f + 5];
        double pw = local[f + 6];
        double x = bw * px + bx * pw + (by * pz - bz * py);
        double y = bw * py + by * pw + (bz * px - bx * pz);
        double z = bw * pz + bz * pw + (bx * py - by * px);
        double w = bw * pw - (bx * px + by * py + bz * pz);
        q[0] = x;
        q[1] = y;
        q[2] = z;
        q[3] = w;
        axes(q, 0, axes);
        double lx = local[f];
        double ly = local[f + 1];
        double lz = local[f + 2];
        double tx = 2 * (by * lz - bz * ly);
        double ty = 2 * (bz * lx - bx * lz);
        double tz = 2 * (bx * ly - by * lx);
        arm[0] = lx + bw * tx + (by * tz - bz * ty);
        arm[1] = ly + bw * ty + (bz * tx - bx * tz);
        arm[2] = lz + bw * tz + (bx * ty - by * tx);
    }

    /**
     * What a row measures, after {@link #look}.
     *
     * @return m or rad
     */
    public double measure(JointStore s, int j, int law) {
        return switch (law) {
            case JointStore.SLIDE, JointStore.SLIDE + 1, JointStore.SLIDE + 2 ->
                    dot(gap, 0, axesA, 3 * (law - JointStore.SLIDE));
            case JointStore.TURN, JointStore.TURN + 1, JointStore.TURN + 2 ->
                    (q[3] < 0 ? -2 : 2) * q[law - JointStore.TURN];
            case JointStore.ALIGN, JointStore.ALIGN + 1 ->
                    dot(axesB, 0, axesA, 3 * (law - JointStore.ALIGN + 1));
            case JointStore.TWIST -> twist();
            case JointStore.SWING -> Angles.of(-dot(axesB, 0, axesA, 6), dot(axesB, 0, axesA, 0));
            case JointStore.SWING + 1 ->
                    Angles.of(dot(axesB, 0, axesA, 3), dot(axesB, 0, axesA, 0));
            case JointStore.CONE -> {
                double y = dot(axesB, 0, axesA, 3);
                double z = dot(axesB, 0, axesA, 6);
                yield Angles.of(Math.sqrt(y * y + z * z), dot(axesB, 0, axesA, 0));
            }
            case JointStore.CROSS -> dot(axesB, 3, axesA, 0);
            case JointStore.DISTANCE -> SolverBodies.norm(gap[0], gap[1], gap[2]);
            case JointStore.PATH, JointStore.PATH + 1, JointStore.ALONG ->
                    curve.measure(this, s, j, law);
            default -> Gearing.measure(this, s, j, law);
        };
    }

    /**
     * What a joint remembers of where it is goes along; after {@link #look}, in the solver only.
     */
    void advance(JointStore s, int j) {
        curve.advance(this, s, j);
    }

    double twist() {
        return twist(q[0], q[3]);
    }

    private static double twist(double sin, double cos) {
        return cos < 0 ? 2 * Angles.of(-sin, -cos) : 2 * Angles.of(sin, cos);
    }

    /** Whether a row measures an angle. */
    static boolean isAngle(int law) {
        return law >= JointStore.TURN && law <= JointStore.CROSS;
    }

    /**
     * Writes the derivatives of a row, after {@link #look}.
     *
     * @param d receives them
     * @param o from here on
     */
    void derive(JointStore s, int j, int law, double[] d, int o) {
        switch (law) {
            case JointStore.SLIDE, JointStore.SLIDE + 1, JointStore.SLIDE + 2 ->
                    force(axesA, 3 * (law - JointStore.SLIDE), d, o);
            case JointStore.TURN, JointStore.TURN + 1, JointStore.TURN + 2 ->
                    torque(axesA, 3 * (law - JointStore.TURN), d, o);
            case JointStore.ALIGN, JointStore.ALIGN + 1 -> {
                cross(axesB, 0, axesA, 3 * (law - JointStore.ALIGN + 1), g);
                torque(g, 0, d, o);
            }
            case JointStore.TWIST -> deriveTwist(d, o);
            case JointStore.SWING, JointStore.SWING + 1 ->
                    deriveSwing(law - JointStore.SWING, d, o);
            case JointStore.CONE -> deriveCone(d, o);
            case JointStore.CROSS -> {
                cross(axesB, 3, axesA, 0, g);
                torque(g, 0, d, o);
            }
            case JointStore.DISTANCE -> {
                double length = SolverBodies.norm(gap[0], gap[1], gap[2]);
                for (int k = 0; k < 3; k++) {
                    g[k] = length * length > NOWHERE ? gap[k] / length : k == 0 ? 1 : 0;
                }
                force(g, 0, d, o);
            }
            case JointStore.PATH, JointStore.PATH + 1, JointStore.ALONG -> {
                curve.direction(this, s, j, law, g);
                force(g, 0, d, o);
            }
            default -> gearing.derive(this, s, j, law, d, o);
        }
    }

    private void deriveTwist(double[] d, int o) {
        double square = Math.max(q[3] * q[3] + q[0] * q[0], NOWHERE);
        double y = (q[3] * q[2] + q[0] * q[1]) / square;
        double z = (q[0] * q[2] - q[3] * q[1]) / square;
        for (int k = 0; k < 3; k++) {
            g[k] = axesA[k] + y * axesA[3 + k] + z * axesA[6 + k];
        }
        torque(g, 0, d, o);
    }

    /** {@code (x y' - y x')/(x² + y²)}, with {@code x' = w × x} of B's axis 0 in A's frame. */
    private void deriveSwing(int axis, double[] d, int o) {
        double x = dot(axesB, 0, axesA, 0);
        double y = dot(axesB, 0, axesA, 3);
        double z = dot(axesB, 0, axesA, 6);
        double other = axis == 0 ? z : y;
        double square = Math.max(x * x + other * other, NOWHERE);
        double along = axis == 0 ? -y * z / square : 0;
        // about axis 1: (-z, x): derivative by w; about axis 2: (y, x)
        double wx = axis == 0 ? -x * y / square : -x * z / square;
        double wy = axis == 0 ? (x * x + z * z) / square : -y * z / square;
        double wz = axis == 0 ? along : (x * x + y * y) / square;
        for (int k = 0; k < 3; k++) {
            g[k] = wx * axesA[k] + wy * axesA[3 + k] + wz * axesA[6 + k];
        }
        torque(g, 0, d, o);
    }

    private void deriveCone(double[] d, int o) {
        cross(axesA, 0, axesB, 0, g);
        double length = SolverBodies.norm(g[0], g[1], g[2]);
        for (int k = 0; k < 3; k++) {
            g[k] = length * length > NOWHERE ? g[k] / length : axesA[3 + k];
        }
        torque(g, 0, d, o);
    }

    private void force(double[] e, int at, double[] d, int o) {
        for (int k = 0; k < 3; k++) {
            d[o + k] = e[at + k];
            d[o + 6 + k] = e[at + k];
        }
        lever(reach, d, o, o + 3);
        lever(armB, d, o + 6, o + 9);
    }

    /** {@code r × e}. */
    private static void lever(double[] r, double[] d, int e, int to) {
        d[to] = r[1] * d[e + 2] - r[2] * d[e + 1];
        d[to + 1] = r[2] * d[e] - r[0] * d[e + 2];
        d[to + 2] = r[0] * d[e + 1] - r[1] * d[e];
    }

    private static void torque(double[] t, int at, double[] d, int o) {
        for (int k = 0; k < 3; k++) {
            d[o + k] = 0;
            d[o + 3 + k] = t[at + k];
            d[o + 6 + k] = 0;
            d[o + 9 + k] = t[at + k];
        }
    }

    /**
     * Adds force and torque at B's origin of an impulse of a row to a sum of six.
     *
     * @param arm B's origin from B's centre at {@code a}, m, world axes
     */
    static void react(
            double[] d, int o, double impulse, double[] arm, int a, double[] sum, int at) {
        for (int k = 0; k < 3; k++) {
            sum[at + k] += impulse * d[o + 6 + k];
            sum[at + 3 + k] += impulse * d[o + 9 + k];
        }
        sum[at + 3] -= impulse * (arm[a + 1] * d[o + 8] - arm[a + 2] * d[o + 7]);
        sum[at + 4] -= impulse * (arm[a + 2] * d[o + 6] - arm[a] * d[o + 8]);
        sum[at + 5] -= impulse * (arm[a] * d[o + 7] - arm[a + 1] * d[o + 6]);
    }

    private static double dot(double[] a, int i, double[] b, int j) {
        return a[i] * b[j] + a[i + 1] * b[j + 1] + a[i + 2] * b[j + 2];
    }

    private static void cross(double[] a, int i, double[] b, int j, double[] into) {
        double x = a[i + 1] * b[j + 2] - a[i + 2] * b[j + 1];
        double y = a[i + 2] * b[j] - a[i] * b[j + 2];
        double z = a[i] * b[j + 1] - a[i + 1] * b[j];
        into[0] = x;
        into[1] = y;
        into[2] = z;
    }
}
