package dev.cairn.physics.solver.refresh;

import dev.cairn.physics.internal.BodyStore;
import dev.cairn.physics.internal.ContactStore;
import dev.cairn.physics.internal.Surface;
import dev.cairn.physics.solver.impact.BallImpacts;
import dev.cairn.physics.solver.row.ConstraintRows;

/**
 * How a row is renewed, as bits: with what its points go, which point two bodies share, and which
 * stages have to know. 0 is a row that is not renewed. Stateless.
 */
final class RefreshKind {
    /** The row is renewed. */
    static final int YES = 1;

    /** How far apart the points of a contact are that is not of a meeting, over the outer radii. */
    private static final double MEETS = 1e-6;

    /** Of a row: its points turn with the corners of A, of B. */
    static final int TURNS_A = 2;

    static final int TURNS_B = 4;

    /** Of a row: two bodies share a point, that of A, of B, or what lies between. */
    static final int OF_A = 8;

    static final int OF_B = 16;
    static final int BETWEEN = OF_A | OF_B;

    /** Of a row: A, or B, moves but does not turn, so that it keeps its warm start. */
    static final int STAYS_A = 32;

    static final int STAYS_B = 64;

    /** Of a row: its normal may turn within the tick, see {@link BallImpacts}. */
    static final int AIMED = 128;

    /** Of a row: others read in the contact where its points are. */
    static final int TOLD = 256;

    /** Of a row: its points go with the axis of A, of B, see {@link RoundTurn}. */
    static final int SWINGS_A = 512;

    static final int SWINGS_B = 1024;

    /** Of a row: two bodies meet within the tick; their points are apart when it begins. */
    static final int APART = 2048;

    private RefreshKind() {}

    /**
     * How a row is renewed.
     *
     * @param turns by slot: whether the body turns in this tick
     * @param place of the row
     * @param movesA whether A moves, or B
     * @return some of the bits of this class, {@link #YES} among them
     */
    static int of(
            ConstraintRows rows,
            ContactStore c,
            BodyStore b,
            boolean[] turns,
            int place,
            boolean movesA,
            boolean movesB) {
        int source = rows.link[place * ConstraintRows.LINK + ConstraintRows.SOURCE];
        int i = c.bodyA[source];
        int k = c.bodyB[source];
        boolean isCorneredA = c.surfaceA[source] == Surface.CORNERED;
        boolean isCorneredB = c.surfaceB[source] == Surface.CORNERED;
        boolean bounces = c.restitution[source] > 0;
        int how = YES;
        how |= movesA && turns[i] && isCorneredA ? TURNS_A : 0;
        how |= movesB && turns[k] && isCorneredB ? TURNS_B : 0;
        how |=
                movesA && turns[i] && !isCorneredA && RoundTurn.moves(b, i, c.colliderA[source])
                        ? SWINGS_A
                        : 0;
        how |=
                movesB && turns[k] && !isCorneredB && RoundTurn.moves(b, k, c.colliderB[source])
                        ? SWINGS_B
                        : 0;
        how |= movesA && !turns[i] ? STAYS_A : 0;
        how |= movesB && !turns[k] ? STAYS_B : 0;
        how |= bounces ? AIMED : 0;
        // what lands, rolls or bounces
        how |= !movesA || !movesB || bounces || rows.rolling.has(place) ? TOLD : 0;
        if (movesA && movesB && !bounces) {
            // two bodies share one point: a ball's own, since on a ball a lever off its normal
            // would lift
            how |= isCorneredA == isCorneredB ? BETWEEN : isCorneredA ? OF_B : OF_A;
        }
        if (movesA && movesB && isApart(b, c, source)) {
            how = apart(how, b, c, source, bounces);
        }
        if (movesA && movesB && b.driven > 0) {
            // what stands or rolls on what only moves of itself meets it at its own point
            how = b.kind[i] != BodyStore.DYNAMIC ? (how & ~BETWEEN) | OF_B : how;
            how = b.kind[k] != BodyStore.DYNAMIC ? (how & ~BETWEEN) | OF_A : how;
        }
        if (rows.drags.has(place) && b.hasBelt[i] != b.hasBelt[k]) {
            // what lies on a belt runs over it for long, and its own points carry it
            how = (how & ~BETWEEN) | (b.hasBelt[i] ? OF_B : OF_A);
        }
        return how;
    }

    /** Whether two bodies pass each other so fast that their points drift apart. */
    static boolean passes(BodyStore b, int i, int j, double gravity) {
        double x = b.velocityX[j] - b.velocityX[i];
        double y = b.velocityY[j] - b.velocityY[i];
        double z = b.velocityZ[j] - b.velocityZ[i];
        double slow =
                JacobianRefresh.SLOW
                        * JacobianRefresh.SLOW
                        * gravity
                        * Math.min(b.innerRadius[i], b.innerRadius[j]);
        return x * x + y * y + z * z > slow;
    }

    /**
     * Share of the way between the points of two bodies that the one's goes to the other's.
     *
     * @param whole {@link #OF_B} for A's point, {@link #OF_A} for B's
     */
    static double share(int how, int whole) {
        int shared = how & BETWEEN;
        return shared == BETWEEN ? 0.5 : shared == whole ? 1 : 0;
    }

    /**
     * The same of two bodies whose points are apart: a ball's own, beside another round body. Two
     * balls that bounce keep their own.
     */
    private static int apart(int how, BodyStore b, ContactStore c, int source, boolean bounces) {
        boolean ballA =
                c.surfaceA[source] != Surface.CORNERED
                        && !RoundTurn.moves(b, c.bodyA[source], c.colliderA[source]);
        boolean ballB =
                c.surfaceB[source] != Surface.CORNERED
                        && !RoundTurn.moves(b, c.bodyB[source], c.colliderB[source]);
        if (ballA && ballB && bounces) {
            return how;
        }
        int shared = ballA == ballB ? BETWEEN : ballA ? OF_A : OF_B;
        return (how & ~BETWEEN) | APART | shared;
    }

    /** Whether the points that two bodies press with are not at one place as the tick begins. */
    private static boolean isApart(BodyStore b, ContactStore c, int source) {
        int i = c.bodyA[source];
        int j = c.bodyB[source];
        int q = ContactStore.anchor(ContactStore.POINTS * source);
        double[] at = c.anchors;
        double cx = b.positionX[j] - b.positionX[i];
        double cy = b.positionY[j] - b.positionY[i];
        double cz = b.positionZ[j] - b.positionZ[i];
        double x = at[q + 3] - at[q] + cx;
        double y = at[q + 4] - at[q + 1] + cy;
        double z = at[q + 5] - at[q + 2] + cz;
        double far = b.outerRadius[i] + b.outerRadius[j];
        return x * x + y * y + z * z > MEETS * MEETS * (far * far);
    }
}
