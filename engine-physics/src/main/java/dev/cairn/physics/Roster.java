package dev.cairn.physics;

import dev.cairn.core.ecs.Field;
import dev.cairn.core.ecs.Tick;

/**
 * Whether entities came, went or were given another slot since the physics last looked: asks the
 * chunks, not their rows.
 */
final class Roster {
    private final Field slot;
    private int chunks = -1;
    private long looked;

    Roster(Field slot) {
        this.slot = slot;
    }

    /** Asks once a tick. */
    boolean isStale(Tick tick) {
        int count = tick.chunkCount();
        boolean stale = count != chunks;
        for (int c = 0; c < count; c++) {
            stale |= tick.chunk(c).version(slot) >= looked;
        }
        chunks = count;
        looked = tick.number();
        return stale;
    }
}
