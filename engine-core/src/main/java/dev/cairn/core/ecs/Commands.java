package dev.cairn.core.ecs;

/** Structural changes recorded during a tick, applied at commit. */
public final class Commands {
    Commands() {}

    /** @param components records @return handle, see {@link World#resolve} */
    public long spawn(Record... components) { throw new UnsupportedOperationException(); }
    /** @param entity id or handle */
    public void delete(long entity) { throw new UnsupportedOperationException(); }
    /** @param entity id or handle @param component record */
    public void add(long entity, Record component) { throw new UnsupportedOperationException(); }
    /** @param entity id or handle @param component which */
    public void remove(long entity, Component<?> component) { throw new UnsupportedOperationException(); }
    /** @param entity id or handle */
    public void clear(long entity) { throw new UnsupportedOperationException(); }
    /** @param entity id or handle @param component record */
    public void set(long entity, Record component) { throw new UnsupportedOperationException(); }
}
