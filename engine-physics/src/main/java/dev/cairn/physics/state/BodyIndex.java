package dev.cairn.physics.state;

import dev.cairn.core.ecs.Tick;
import dev.cairn.core.ecs.component.Field;
import dev.cairn.core.state.StateVisitor;
import dev.cairn.core.state.Stateful;

/**
 * Whether entities came, went or were given another slot since the physics last looked: asks the
 * chunks, not their rows.
 */
public final class BodyIndex implements Stateful {
    private final Field slot;
    private int chunks = -1;
    private long looked;

    /**
     * An index that has not looked yet.
     *
     * @param slot the field of the entities that holds a body's slot
     */
    public BodyIndex(Field slot) {
        this.slot = slot;
    }

    @Override
    public void state(StateVisitor s) {
        s.section("index", this);
        chunks = s.value("chunks", chunks);
        looked = s.value("looked", looked);
    }

    /**
     * Asks once a tick.
     *
     * @param tick whose chunks are asked
     * @return true if all entities must be looked at
     */
    public boolean isStale(Tick tick) {
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
