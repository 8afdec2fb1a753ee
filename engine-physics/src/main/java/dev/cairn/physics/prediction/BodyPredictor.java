package dev.cairn.physics.prediction;

import dev.cairn.core.state.StateCodec;
import dev.cairn.core.state.StateColumns;

import java.util.Arrays;

/**
 * Predicts the numbers of bodies that move, and with {@link ContactPredictor} those of their
 * contacts. A row is twice a body's slot, and 1 more where its place of rest is another one: that
 * is the body's pose then.
 *
 * <p>Immutable; any thread.
 */
public final class BodyPredictor implements StateColumns.Predictor {
    /** The only one. */
    public static final BodyPredictor INSTANCE = new BodyPredictor();

    /** Writes that it is it. */
    public static final StateCodec<BodyPredictor> CODEC =
            StateCodec.of(
                    BodyPredictor.class, "cairn.predictor", (known, out) -> {}, in -> INSTANCE);

    private BodyPredictor() {}

    @Override
    public String toString() {
        return "predictor";
    }

    @Override
    public int[] rows(StateColumns before, StateColumns after) {
        BodyColumns a = new BodyColumns(before);
        BodyColumns b = new BodyColumns(after);
        if (!a.isWhole() || !b.isWhole()) {
            return new int[0];
        }
        boolean[] changed = new boolean[Math.max(a.slots, b.slots)];
        boolean[] settled = new boolean[changed.length];
        int common = Math.min(a.slots, b.slots);
        Arrays.fill(changed, common, changed.length, true);
        for (int c = 0; c < a.pose.length; c++) {
            mark(before, a.pose[c], after, b.pose[c], 1, changed);
        }
        for (int c = 0; c < a.velocity.length; c++) {
            mark(before, a.velocity[c], after, b.velocity[c], 1, changed);
        }
        mark(before, a.began, after, b.began, BodyColumns.POSE, changed);
        mark(before, a.last, after, b.last, BodyColumns.VELOCITY, changed);
        mark(before, a.tight, after, b.tight, BodyColumns.BOX, changed);
        if (a.mayRest && b.mayRest) {
            mark(before, a.place, after, b.place, BodyColumns.POSE, settled);
        }
        entities(before, after, changed);
        int[] rows = new int[changed.length];
        int count = 0;
        for (int s = 0; s < changed.length; s++) {
            if (changed[s]) {
                rows[count++] = 2 * s + (settled[s] ? 1 : 0);
            }
        }
        return Arrays.copyOf(rows, count);
    }

    /** The entity that has moved up where another one has left. */
    private static void entities(StateColumns before, StateColumns after, boolean[] changed) {
        EntityColumns a = new EntityColumns(before);
        EntityColumns b = new EntityColumns(after);
        while (a.next() && b.next()) {
            int rows = Math.min(a.rows, b.rows);
            for (int row = 0; row < rows; row++) {
                int x = a.slot(row);
                int y = b.slot(row);
                if (x != y) {
                    changed[x] |= x >= 0 && x < changed.length;
                    changed[y] |= y >= 0 && y < changed.length;
                }
            }
        }
    }

    /** Marks rows in which a column differs. */
    private static void mark(
            StateColumns before, int a, StateColumns after, int b, int width, boolean[] rows) {
        int i = before.mismatch(a, after, b, 0);
        while (i >= 0 && i / width < rows.length) {
            rows[i / width] = true;
            i = before.mismatch(a, after, b, width * (i / width + 1));
        }
    }

    @Override
    public void pack(StateColumns state, int[] rows, boolean isFirst) {
        BodyColumns b = new BodyColumns(state);
        if (!b.isWhole()) {
            return;
        }
        contacts(state, b, rows, true);
        entities(state, b, rows);
        for (int row : rows) {
            slot(b, row, isFirst, true);
        }
    }

    @Override
    public void unpack(StateColumns state, int[] rows, boolean isFirst) {
        BodyColumns b = new BodyColumns(state);
        if (!b.isWhole()) {
            return;
        }
        for (int row : rows) {
            slot(b, row, isFirst, false);
        }
        entities(state, b, rows);
        contacts(state, b, rows, false);
    }

    private static void contacts(StateColumns state, BodyColumns b, int[] rows, boolean packs) {
        RowColumns c = new RowColumns(state);
        boolean[] moves = b.marks(rows);
        ContactPredictor predictor = new ContactPredictor(state, b, c, packs);
        for (int row = 0; row < c.rows; row++) {
            int x = c.bodyA(row);
            int y = c.bodyB(row);
            if ((x >= 0 && x < moves.length && moves[x])
                    || (y >= 0 && y < moves.length && moves[y])) {
                predictor.row(row);
            }
        }
    }

    /** Of an entity what its body does not tell; there and back. */
    private static void entities(StateColumns state, BodyColumns b, int[] rows) {
        boolean[] moves = b.marks(rows);
        EntityColumns e = new EntityColumns(state);
        while (e.next()) {
            for (int row = 0; row < e.rows; row++) {
                int s = e.slot(row);
                if (s >= 0 && s < moves.length && moves[s]) {
                    e.mix(row, b, s);
                }
            }
        }
    }

    private static void slot(BodyColumns b, int row, boolean isFirst, boolean packs) {
        int s = row >> 1;
        if (s >= b.slots) {
            return;
        }
        if (packs) {
            b.rest(s, (row & 1) != 0);
            b.turns(s, true);
        }
        if (isFirst) {
            b.exchange(s);
        }
        if (!packs) {
            b.turns(s, false);
            b.rest(s, (row & 1) != 0);
        }
    }
}
