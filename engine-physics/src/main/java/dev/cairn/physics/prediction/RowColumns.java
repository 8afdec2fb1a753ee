package dev.cairn.physics.prediction;

import static dev.cairn.physics.internal.ContactColumns.ANCHORS;
import static dev.cairn.physics.internal.ContactColumns.HEAD;
import static dev.cairn.physics.internal.ContactColumns.KEPT;
import static dev.cairn.physics.internal.ContactColumns.POINTS;

import dev.cairn.core.state.StateColumns;

/** Where the numbers of contacts are in a state. */
final class RowColumns {
    final int head, anchors, separation, feature, cache, kept;

    /** Rows that all columns have. */
    final int rows;

    private final StateColumns state;
    private final int colliderA, colliderB, bodyA, bodyB, pointCount, keeps;

    RowColumns(StateColumns state) {
        this.state = state;
        int section = state.section("contacts", -1);
        colliderA = state.ints(section, "colliderA");
        colliderB = state.ints(section, "colliderB");
        bodyA = state.ints(section, "bodyA");
        bodyB = state.ints(section, "bodyB");
        pointCount = state.ints(section, "pointCount");
        cache = state.wide(section, "cache");
        head = state.wide(section, "head");
        feature = state.ints(section, "feature");
        anchors = state.wide(section, "anchors");
        separation = state.wide(section, "separation");
        kept = state.wide(section, "kept");
        keeps = state.bytes(section, "keeps");
        int least = Math.min(state.count(colliderA), state.count(colliderB));
        least = Math.min(least, Math.min(state.count(bodyA), state.count(bodyB)));
        least = Math.min(least, Math.min(state.count(pointCount), state.count(cache)));
        least = Math.min(least, state.count(head) / HEAD);
        least = Math.min(least, state.count(feature) / POINTS);
        least = Math.min(least, state.count(anchors) / (ANCHORS * POINTS));
        least = Math.min(least, Math.min(state.count(kept) / KEPT, state.count(keeps)));
        rows = Math.min(least, state.count(separation) / POINTS);
    }

    int bodyA(int row) {
        return state.integer(bodyA, row);
    }

    int bodyB(int row) {
        return state.integer(bodyB, row);
    }

    int colliderA(int row) {
        return state.integer(colliderA, row);
    }

    int colliderB(int row) {
        return state.integer(colliderB, row);
    }

    /** 0 to 4, whatever the state says. */
    int points(int row) {
        return Math.clamp(state.integer(pointCount, row), 0, POINTS);
    }

    boolean keeps(int row) {
        return state.octet(keeps, row) != 0;
    }

    long cache(int row) {
        return state.bits(cache, row);
    }

    int feature(int point) {
        return state.integer(feature, point);
    }
}
