package dev.cairn.physics.prediction;

import dev.cairn.core.state.StateColumns;

/** Walks over the chunks of a state whose entities have bodies. */
final class EntityColumns {
    private static final String[] POSE = {"x", "y", "z", "qx", "qy", "qz", "qw"};
    private static final String[] VELOCITY = {"vx", "vy", "vz", "wx", "wy", "wz"};

    /** Rows of the chunk at hand. */
    int rows;

    private final StateColumns state;
    private final int[] pose = new int[POSE.length];
    private final int[] velocity = new int[VELOCITY.length];
    private int section = -1;
    private int slots;
    private boolean hasVelocity;

    EntityColumns(StateColumns state) {
        this.state = state;
    }

    /** To the next chunk; false if there is none. */
    boolean next() {
        section = state.section("chunk", section);
        while (section >= 0 && !isOfBodies()) {
            section = state.section("chunk", section);
        }
        return section >= 0;
    }

    private boolean isOfBodies() {
        slots = state.ints(section, "slot");
        rows = state.count(slots);
        for (int c = 0; c < pose.length; c++) {
            pose[c] = state.wide(section, POSE[c]);
            rows = Math.min(rows, state.count(pose[c]));
        }
        hasVelocity = true;
        for (int c = 0; c < velocity.length; c++) {
            velocity[c] = state.wide(section, VELOCITY[c]);
            hasVelocity &= state.count(velocity[c]) >= rows;
        }
        return rows > 0;
    }

    int slot(int row) {
        return state.integer(slots, row);
    }

    /** Exclusive or with the numbers of the body: 0 where they are the same. */
    void mix(int row, BodyColumns b, int slot) {
        for (int c = 0; c < pose.length; c++) {
            state.set(pose[c], row, state.bits(pose[c], row) ^ state.bits(b.pose[c], slot));
        }
        for (int c = 0; hasVelocity && c < velocity.length; c++) {
            state.set(
                    velocity[c],
                    row,
                    state.bits(velocity[c], row) ^ state.bits(b.velocity[c], slot));
        }
    }
}
