package dev.cairn.physics.solver.single;

import static dev.cairn.physics.solver.body.SolverBodies.P;
import static dev.cairn.physics.solver.body.SolverBodies.V;
import static dev.cairn.physics.solver.row.ConstraintRows.*;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.solver.body.MotionRecord;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.kernel.ScalarNormals;
import dev.cairn.physics.solver.kernel.WarmStart;
import dev.cairn.physics.solver.row.ConstraintRows;

import java.util.Arrays;

/**
 * What a sub-step in closed form of a body on one point has in common, be that a corner or the
 * deepest point of a rim: whether friction holds the point, and what the row is told.
 *
 * <p>One body at a time, any worker. Does not allocate.
 */
final class HeldPoint {
    /** Cosine of half the angle, 0.1 rad, by which sweeps and closed form may differ. */
    private static final double NEAR = 0.99875;

    /** Of the contact on the body, world, N s. */
    final double[] impulse = new double[3];

    /** Orientation as the sweeps left it. */
    private final double[] swept = new double[4];

    /** Remembers where a body is at the start of a sub-step. */
    static void remember(BodyStore b, SolverBodies s, int i) {
        double[] d = s.motion;
        int g = MotionRecord.STRIDE * i + MotionRecord.START;
        int o = SolverBodies.offset(i);
        for (int k = 0; k < 3; k++) {
            d[g + k] = s.state[o + P + k];
            d[g + 3 + k] = s.world(i, o + V + 3, k);
        }
        read(b, i, d, g + 6);
    }

    /** Gives a body another orientation than the sweeps'. */
    void begin(BodyStore b, int i, double[] q, int o) {
        read(b, i, swept, 0);
        write(b, i, q, o);
    }

    /** Turns a body as the sweeps had it. */
    void restore(BodyStore b, int i) {
        write(b, i, swept, 0);
    }

    /**
     * Whether the pose is nearly where the sweeps had it, too: the row's levers and the root of the
     * inertia are of there, and the next sub-step begins with them.
     */
    boolean isNear(BodyStore b, int i) {
        double cosine =
                swept[0] * b.orientationX[i]
                        + swept[1] * b.orientationY[i]
                        + swept[2] * b.orientationZ[i]
                        + swept[3] * b.orientationW[i];
        return Math.abs(cosine) >= NEAR;
    }

    /**
     * Whether the impulse presses, and friction can give it.
     *
     * @param d normal of the contact from {@code r} on, each {@code lanes} further
     * @param side 1 if it points towards the body, else -1
     */
    boolean isHeld(double[] d, int r, int lanes, double side, double friction) {
        double[] l = impulse;
        double normal = side * dot(d, r, lanes);
        double square = l[0] * l[0] + l[1] * l[1] + l[2] * l[2] - normal * normal;
        return normal > 0 && square <= friction * friction * normal * normal;
    }

    private double dot(double[] d, int r, int lanes) {
        return d[r] * impulse[0] + d[r + lanes] * impulse[1] + d[r + 2 * lanes] * impulse[2];
    }

    /** Gives the row its impulses, the warm start what they do, and the gaps what they are. */
    void tell(
            SolverBodies s,
            BodyStore b,
            int i,
            ConstraintRows rows,
            int place,
            int corner,
            double side) {
        double[] d = rows.doubles;
        int lanes = rows.lanes;
        int r = rows.base(place);
        double normal = side * dot(d, r, lanes);
        for (int p = 0; p < rows.points(place); p++) {
            int q = r + (POINT + p * POINT_FIELDS + IMPULSE) * lanes;
            double own = p == corner ? normal : 0;
            d[r + (SUM + p) * lanes] += own - d[q];
            d[q] = own;
        }
        for (int k = 0; k < 3; k++) {
            int t = r + (k == 0 ? TANGENT1 : TANGENT2) * lanes;
            double along = k < 2 ? side * dot(d, t, lanes) : 0;
            d[r + (TOTAL + k) * lanes] += along - d[r + (LAMBDA + k) * lanes];
            d[r + (LAMBDA + k) * lanes] = along;
        }
        int w = (i + 1) * SolverBodies.HALF;
        Arrays.fill(s.warm, w, w + 6, 0.0);
        WarmStart.addNormals(rows, s.warm, place, r, 1);
        WarmStart.addFriction(rows, s.warm, place, r, 1);
        lean(s, b, i);
        int link = place * LINK;
        int n = rows.points(place);
        ScalarNormals.separate(d, r, lanes, s.state, rows.link[link], rows.link[link + 1], n);
    }

    /** Adds what the body has turned beyond what the sweeps made of it to its weighted turn. */
    private void lean(SolverBodies s, BodyStore b, int i) {
        double bx = b.orientationX[i];
        double by = b.orientationY[i];
        double bz = b.orientationZ[i];
        double bw = b.orientationW[i];
        double w = bw * swept[3] + bx * swept[0] + by * swept[1] + bz * swept[2];
        double twice = w < 0 ? -2 : 2;
        double x = twice * (bx * swept[3] - bw * swept[0] - (by * swept[2] - bz * swept[1]));
        double y = twice * (by * swept[3] - bw * swept[1] - (bz * swept[0] - bx * swept[2]));
        double z = twice * (bz * swept[3] - bw * swept[2] - (bx * swept[1] - by * swept[0]));
        double[] root = s.root;
        int k = (i + 1) * SolverBodies.ROOT;
        int o = SolverBodies.offset(i) + P + 3;
        for (int c = 0; c < 3; c++) {
            s.state[o + c] +=
                    root[k + 9 + c] * (root[k + c] * x + root[k + 3 + c] * y + root[k + 6 + c] * z);
        }
    }

    static void read(BodyStore b, int i, double[] q, int o) {
        q[o] = b.orientationX[i];
        q[o + 1] = b.orientationY[i];
        q[o + 2] = b.orientationZ[i];
        q[o + 3] = b.orientationW[i];
    }

    static void write(BodyStore b, int i, double[] q, int o) {
        b.orientationX[i] = q[o];
        b.orientationY[i] = q[o + 1];
        b.orientationZ[i] = q[o + 2];
        b.orientationW[i] = q[o + 3];
    }
}
