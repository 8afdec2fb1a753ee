package dev.cairn.core.ecs;

/** Chunks by components, between steps. */
public final class Query {
    Query() {}

    /** @param components must be absent @return narrower query */
    public Query exclude(Component<?>... components) { return this; }
    /** @return chunks */
    public int chunkCount() { throw new UnsupportedOperationException(); }
    /** @param index of the chunk @return chunk */
    public Chunk chunk(int index) { throw new UnsupportedOperationException(); }
    /** @return matching entities */
    public int entityCount() { throw new UnsupportedOperationException(); }
}
