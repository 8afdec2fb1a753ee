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
}
