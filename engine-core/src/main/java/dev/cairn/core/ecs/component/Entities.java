package dev.cairn.core.ecs.component;

/**
 * An entity is a {@code long}: generation in the high 32 bits, index in the low 32. The index is
 * reused after a delete, the generation then differs, so an old id never names a new entity.
 */
public final class Entities {
    /** No entity. Never alive. */
    public static final long NONE = 0L;

    private Entities() {}

    /**
     * The index of an entity, for tables on the side.
     *
     * @param entity an entity
     * @return its index, 0 or more
     */
    public static int index(long entity) {
        return (int) entity;
    }

    /**
     * The generation of an entity.
     *
     * @param entity an entity
     * @return its generation, from 1
     */
    public static int generation(long entity) {
        return (int) (entity >>> 32);
    }

    /**
     * Puts an id together.
     *
     * @param index the index, 0 or more
     * @param generation the generation, from 1
     * @return the id
     */
    public static long of(int index, int generation) {
        return (long) generation << 32 | (index & 0xFFFF_FFFFL);
    }

    /**
     * The id for messages, such as {@code 17v3}.
     *
     * @param entity an entity
     * @return index, {@code v}, generation; {@code none} for {@link #NONE}
     */
    public static String toString(long entity) {
        return entity == NONE ? "none" : index(entity) + "v" + generation(entity);
    }
}
