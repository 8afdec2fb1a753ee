package dev.cairn.physics.solver.wide;

import static dev.cairn.physics.solver.row.ConstraintRows.LINK;

import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.solver.body.SolverBodies;
import dev.cairn.physics.solver.kernel.PrepareRow;
import dev.cairn.physics.solver.row.ConstraintRows;
import dev.cairn.physics.solver.row.SubStep;

/**
 * The staging area of {@link LanePrepare}: contacts and bodies of a group of rows, number by number
 * with one row to a lane. What a lane lacks is staged so that it adds nothing.
 */
final class LaneStaging {
    private LaneStaging() {}

    /** Staging, in fields of a group: normal, inverse masses, then these. */
    static final int INVERSE_A = 3;

    static final int INVERSE_B = 4;

    /** 1 where a body does not move, 2 where the other one is guided besides. */
    static final int FIXED = 5;

    static final int STIFFNESS = 6;
    static final int MU = 7;
    static final int POINTS = 8;
    static final int ROOT_A = 9;
    static final int ROOT_B = 18;

    /** Per point: anchors of A and B, separation, normal impulse, preload. */
    static final int STAGED = 27;

    static final int STAGED_FIELDS = 9;
    static final int OLD = 63;
    static final int WARM_A = 67;
    static final int WARM_B = 73;

    /** The patch's centre from A and from B. */
    static final int CENTRE = 79;

    static final int SUMMED = 85;

    /** Weights of the points in the centre. */
    static final int WEIGHT = 86;

    /** Squares and product of the levers of A, square of its twist; then of B. */
    static final int DOTS = 90;

    /** How far from the patch's middle friction acts at a point, over its own distance. */
    static final int SHARE = 98;

    /** What came of the look ahead: nobody reads it. */
    static final int TOUCHED = 99;

    /** A lane without a contact: no points, no mass, and a normal that can be divided by. */
    static void pad(double[] st, int l, int lanes) {
        for (int f = 0; f < CENTRE; f++) {
            st[f * lanes + l] = 0;
        }
        st[lanes + l] = 1;
    }

    /** Copies what the row at place {@code j} is made of. */
    static void stage(
            ConstraintRows rows,
            SolverBodies bodies,
            ContactStore c,
            SubStep sub,
            int j,
            int source,
            double[] st,
            int l,
            int lanes) {
        int a = rows.link[j * LINK];
        int b = rows.link[j * LINK + 1];
        double ma = bodies.state[a + SolverBodies.MASS];
        double mb = bodies.state[b + SolverBodies.MASS];
        boolean fixed = ma == 0 || mb == 0;
        st[l] = c.normalX(source);
        st[lanes + l] = c.normalY(source);
        st[2 * lanes + l] = c.normalZ(source);
        st[INVERSE_A * lanes + l] = ma;
        st[INVERSE_B * lanes + l] = mb;
        st[FIXED * lanes + l] = bodies.isGuided(a) || bodies.isGuided(b) ? 2 : fixed ? 1 : 0;
        st[STIFFNESS * lanes + l] = sub.stiffness(fixed);
        st[MU * lanes + l] = c.friction(source);
        st[POINTS * lanes + l] = c.pointCount[source];
        st[SHARE * lanes + l] = PrepareRow.share(c, source);
        copy(bodies.root, (a >> 4) * SolverBodies.ROOT, 9, st, ROOT_A * lanes + l, lanes);
        copy(bodies.root, (b >> 4) * SolverBodies.ROOT, 9, st, ROOT_B * lanes + l, lanes);
        copy(bodies.warm, a >> 1, 6, st, WARM_A * lanes + l, lanes);
        copy(bodies.warm, b >> 1, 6, st, WARM_B * lanes + l, lanes);
        boolean settles = rows.settleMark[j] != 0;
        int first = ContactStore.POINTS * source;
        for (int i = 0; i < ContactStore.POINTS; i++) {
            // a point that is not there stands at the first, with nothing in it
            boolean there = i < c.pointCount[source];
            int p = there ? first + i : first;
            int q = (STAGED + i * STAGED_FIELDS) * lanes + l;
            int at = ContactStore.anchor(p);
            for (int k = 0; k < ContactStore.ANCHORS; k++) {
                st[q + k * lanes] = c.anchors[at + k];
            }
            st[q + 6 * lanes] = there ? c.separation[p] : 0;
            st[q + 7 * lanes] = there ? c.normalImpulse[p] : 0;
            st[q + 8 * lanes] = there && !settles ? c.preload[p] : 0;
        }
        st[OLD * lanes + l] = c.frictionImpulseX(source);
        st[(OLD + 1) * lanes + l] = c.frictionImpulseY(source);
        st[(OLD + 2) * lanes + l] = c.frictionImpulseZ(source);
        st[(OLD + 3) * lanes + l] = c.twistImpulse(source);
    }

    private static void copy(double[] from, int i, int n, double[] st, int o, int lanes) {
        for (int k = 0; k < n; k++) {
            st[o + k * lanes] = from[i + k];
        }
    }

    /** Zeros leave positive, whatever a lane has added to them. */
    static void scatter(ConstraintRows rows, SolverBodies bodies, int j, double[] st, int lanes) {
        double[] warm = bodies.warm;
        for (int l = 0; l < lanes; l++) {
            int a = rows.link[(j + l) * LINK];
            int b = rows.link[(j + l) * LINK + 1];
            for (int k = 0; k < 6 && a != 0; k++) {
                warm[(a >> 1) + k] = st[(WARM_A + k) * lanes + l] + 0.0;
            }
            for (int k = 0; k < 6 && b != 0; k++) {
                warm[(b >> 1) + k] = st[(WARM_B + k) * lanes + l] + 0.0;
            }
        }
    }
}
