package dev.cairn.core.ecs;

import dev.cairn.core.ecs.access.Access;
import dev.cairn.core.ecs.component.Component;
import dev.cairn.core.ecs.storage.Store;

import java.util.Objects;
import java.util.function.LongConsumer;

/**
 * The chunks of the entities that have some components and lack others, for use between steps on
 * the simulation thread. Shows the published state. {@code chunk.out} gives the published column
 * itself, so tools can edit it in place. Keep the object and use it again: a repeated walk over an
 * unchanged structure costs and allocates nothing.
 *
 * <p>Creating and deleting during a walk moves rows between chunks; collect first, change after.
 */
public final class Query {
    private static final long[] NOBODY = {};

    private final WorldContents world;
    private final Access access;
    private final ChunkList chunks;

    Query(WorldContents world, Store store, Access access) {
        this.world = world;
        this.access = access;
        this.chunks = new ChunkList(store, access, true, false);
    }

    /**
     * A narrower query.
     *
     * @param components components that the entities must not have
     * @return a new query; this one stays as it is
     * @throws NullPointerException if a component is null
     */
    public Query exclude(Component<?>... components) {
        return world.query(access.copy().exclude(components));
    }

    /**
     * Number of matching chunks.
     *
     * @return the number of chunks
     * @throws IllegalStateException if called during a step
     */
    public int chunkCount() {
        world.requireBetweenSteps("a query is walked");
        return chunks.refresh();
    }

    /**
     * A matching chunk.
     *
     * @param index the chunk, in {@code [0, chunkCount())}
     * @return the chunk
     * @throws IndexOutOfBoundsException if there is no such chunk
     */
    public Chunk chunk(int index) {
        return chunks.get(Objects.checkIndex(index, chunks.refresh()));
    }

    /**
     * Calls back for each matching entity, in the order of chunks and rows: {@code
     * query.forEach(entity -> total += world.get(entity, MASS).kilograms())}. For loops that must
     * be fast take the columns of {@link #chunk}.
     *
     * @param action receives the entity; it may read, and change values, but neither create nor
     *     delete
     * @throws IllegalStateException if called during a step
     */
    public void forEach(LongConsumer action) {
        Objects.requireNonNull(action, "action must not be null");
        int count = chunkCount();
        for (int i = 0; i < count; i++) {
            Chunk chunk = chunks.get(i);
            for (int row = 0; row < chunk.size(); row++) {
                action.accept(chunk.entity(row));
            }
        }
    }

    /**
     * Number of matching entities.
     *
     * @return the number of entities
     */
    public int entityCount() {
        int total = 0;
        int count = chunkCount();
        for (int i = 0; i < count; i++) {
            total += chunks.get(i).size();
        }
        return total;
    }

    /**
     * The matching entities as they are now, in the order of chunks and rows: a list that stays
     * while what is done with them creates and deletes others.
     *
     * @return a copy; allocates, unless there are none
     */
    public long[] entities() {
        int count = entityCount();
        if (count == 0) {
            return NOBODY;
        }
        long[] found = new long[count];
        int n = 0;
        for (int c = 0; c < chunkCount(); c++) {
            for (int row = 0; row < chunk(c).size(); row++) {
                found[n++] = chunk(c).entity(row);
            }
        }
        return found;
    }
}
