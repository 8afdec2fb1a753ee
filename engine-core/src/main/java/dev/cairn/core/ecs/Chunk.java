package dev.cairn.core.ecs;

import dev.cairn.core.ecs.access.Access;
import dev.cairn.core.ecs.access.AccessException;
import dev.cairn.core.ecs.component.Component;
import dev.cairn.core.ecs.component.ComponentException;
import dev.cairn.core.ecs.component.DoubleField;
import dev.cairn.core.ecs.component.Field;
import dev.cairn.core.ecs.component.FloatField;
import dev.cairn.core.ecs.component.IntField;
import dev.cairn.core.ecs.component.LongField;
import dev.cairn.core.ecs.component.ObjectField;
import dev.cairn.core.ecs.storage.ChunkSizes;
import dev.cairn.core.ecs.storage.Slab;
import dev.cairn.core.ecs.storage.Store;

/**
 * Up to 16384 entities of one archetype, as raw columns, through the eyes of one system or query.
 * Row {@code r} of every column belongs to {@link #entity entity(r)}. Only rows below {@link #size}
 * count; a column's array may be longer.
 *
 * <pre>{@code
 * double[] x = chunk.out(X), vx = chunk.in(VX);
 * for (int row = 0, n = chunk.size(); row < n; row++) {
 *     x[row] += vx[row] * h;
 * }
 * }</pre>
 *
 * <p>Arrays are valid during the tick, or between two structural changes; fetch them again then.
 * Methods allocate nothing, but for the first write to a column. Inside a tick each chunk's {@code
 * out} columns are asked for by one thread.
 */
public final class Chunk {
    /** Most rows that a chunk can have. A table begins with chunks of 1024 rows. */
    public static final int CAPACITY = ChunkSizes.LARGEST;

    /**
     * A right beside those of {@link Access}: it is between ticks, writes are published at once.
     */
    static final byte DIRECT = 64;

    final Slab slab;
    private final String system;
    private final byte[] rights;
    private final int[] writable;
    private final Store store;
    private final boolean checked;

    Chunk(Slab slab, String system, byte[] rights, int[] writable, Store store, boolean checked) {
        this.slab = slab;
        this.system = system;
        this.rights = rights;
        this.writable = writable;
        this.store = store;
        this.checked = checked;
    }

    /**
     * Number of entities in this chunk.
     *
     * @return rows, up to {@link #CAPACITY}
     */
    public int size() {
        return slab.size;
    }

    /**
     * The entity of a row.
     *
     * @param row the row, in {@code [0, size())}
     * @return the entity
     * @throws IndexOutOfBoundsException if there is no such row
     */
    public long entity(int row) {
        if (row < 0 || row >= slab.size) {
            throw new IndexOutOfBoundsException(
                    "row is " + row + ", but must be in [0, " + slab.size + ")");
        }
        return slab.entities[row];
    }

    /**
     * The entities of all rows, to be read only.
     *
     * @return an array whose first {@link #size} elements are the entities
     */
    public long[] entities() {
        return slab.entities;
    }

    /**
     * Whether the entities of this chunk have a component.
     *
     * @param component the component
     * @return whether they have it
     */
    public boolean has(Component<?> component) {
        return slab.archetype.has(component);
    }

    /**
     * When a column last changed: the number of the tick whose commit replaced it, or in which rows
     * came, went or were set from outside. A reader that remembers the number can skip what stands.
     *
     * @param field the column
     * @return the tick's number, 0 for what was made before the first tick
     * @throws ComponentException if this chunk has no such column
     */
    public long version(Field field) {
        int slot = slab.archetype.slot(field);
        if (slot < 0) {
            throw absent(field);
        }
        return Math.max(slab.versions[slot], slab.structureTick);
    }

    /**
     * The published column: the state that the last tick left. To be read only.
     *
     * @param field the column
     * @return its array
     * @throws AccessException if the system has not declared it
     */
    public double[] in(DoubleField field) {
        return (double[]) slab.published[slot(field, Access.READ)];
    }

    /**
     * The column that this tick writes. Holds the published values at first, unless the system
     * declared {@code writesAll}. Asking is writing: the column counts as changed.
     *
     * @param field the column
     * @return its array
     * @throws AccessException if the system has not declared it
     */
    public double[] out(DoubleField field) {
        return (double[]) writable(field);
    }

    /**
     * The column as this tick's writer left it; the published one where nothing wrote. To be read
     * only.
     *
     * @param field the column
     * @return its array
     * @throws AccessException if the system has not declared it
     */
    public double[] next(DoubleField field) {
        return (double[]) slab.next[slot(field, Access.NEXT)];
    }

    /**
     * The published column: the state that the last tick left. To be read only.
     *
     * @param field the column
     * @return its array
     * @throws AccessException if the system has not declared it
     */
    public float[] in(FloatField field) {
        return (float[]) slab.published[slot(field, Access.READ)];
    }

    /**
     * The column that this tick writes. Holds the published values at first, unless the system
     * declared {@code writesAll}. Asking is writing: the column counts as changed.
     *
     * @param field the column
     * @return its array
     * @throws AccessException if the system has not declared it
     */
    public float[] out(FloatField field) {
        return (float[]) writable(field);
    }

    /**
     * The column as this tick's writer left it; the published one where nothing wrote. To be read
     * only.
     *
     * @param field the column
     * @return its array
     * @throws AccessException if the system has not declared it
     */
    public float[] next(FloatField field) {
        return (float[]) slab.next[slot(field, Access.NEXT)];
    }

    /**
     * The published column: the state that the last tick left. To be read only.
     *
     * @param field the column
     * @return its array
     * @throws AccessException if the system has not declared it
     */
    public int[] in(IntField field) {
        return (int[]) slab.published[slot(field, Access.READ)];
    }

    /**
     * The column that this tick writes. Holds the published values at first, unless the system
     * declared {@code writesAll}. Asking is writing: the column counts as changed.
     *
     * @param field the column
     * @return its array
     * @throws AccessException if the system has not declared it
     */
    public int[] out(IntField field) {
        return (int[]) writable(field);
    }

    /**
     * The column as this tick's writer left it; the published one where nothing wrote. To be read
     * only.
     *
     * @param field the column
     * @return its array
     * @throws AccessException if the system has not declared it
     */
    public int[] next(IntField field) {
        return (int[]) slab.next[slot(field, Access.NEXT)];
    }

    /**
     * The published column: the state that the last tick left. To be read only.
     *
     * @param field the column
     * @return its array
     * @throws AccessException if the system has not declared it
     */
    public long[] in(LongField field) {
        return (long[]) slab.published[slot(field, Access.READ)];
    }

    /**
     * The column that this tick writes. Holds the published values at first, unless the system
     * declared {@code writesAll}. Asking is writing: the column counts as changed.
     *
     * @param field the column
     * @return its array
     * @throws AccessException if the system has not declared it
     */
    public long[] out(LongField field) {
        return (long[]) writable(field);
    }

    /**
     * The column as this tick's writer left it; the published one where nothing wrote. To be read
     * only.
     *
     * @param field the column
     * @return its array
     * @throws AccessException if the system has not declared it
     */
    public long[] next(LongField field) {
        return (long[]) slab.next[slot(field, Access.NEXT)];
    }

    /**
     * The published column: the state that the last tick left. To be read only.
     *
     * @param field the column
     * @param <V> type of the field
     * @return its array
     * @throws AccessException if the system has not declared it
     */
    @SuppressWarnings("unchecked") // the array was made for the field's class
    public <V> V[] in(ObjectField<V> field) {
        return (V[]) slab.published[slot(field, Access.READ)];
    }

    /**
     * The column that this tick writes. Holds the published values at first, unless the system
     * declared {@code writesAll}. Asking is writing: the column counts as changed.
     *
     * @param field the column
     * @param <V> type of the field
     * @return its array
     * @throws AccessException if the system has not declared it
     */
    @SuppressWarnings("unchecked") // the array was made for the field's class
    public <V> V[] out(ObjectField<V> field) {
        return (V[]) writable(field);
    }

    /**
     * The column as this tick's writer left it; the published one where nothing wrote. To be read
     * only.
     *
     * @param field the column
     * @param <V> type of the field
     * @return its array
     * @throws AccessException if the system has not declared it
     */
    @SuppressWarnings("unchecked") // the array was made for the field's class
    public <V> V[] next(ObjectField<V> field) {
        return (V[]) slab.next[slot(field, Access.NEXT)];
    }

    private Object writable(Field field) {
        int slot = slot(field, Access.WRITE);
        int right = rights[slot];
        if ((right & DIRECT) != 0) {
            slab.versions[slot] = store.tick;
        } else if ((right & Access.IN_PLACE) != 0) {
            slab.versions[slot] = store.tick + 1; // the tick that is being computed
        } else if (!slab.isWritten(slot)) {
            slab.open(slot, (right & Access.ALL) == 0, checked);
        }
        return slab.next[slot];
    }

    private int slot(Field field, int need) {
        int slot = slab.archetype.slot(field);
        if (slot < 0 || (rights[slot] & need) == 0) {
            throw denied(field, slot, need);
        }
        return slot;
    }

    private RuntimeException denied(Field field, int slot, int need) {
        if (slot < 0 && (rights.length > 0 && (rights[0] & DIRECT) != 0)) {
            return absent(field);
        }
        String call = need == Access.WRITE ? "out" : need == Access.NEXT ? "next" : "in";
        return new AccessException(
                "system '"
                        + system
                        + "' uses column "
                        + field
                        + " through "
                        + call
                        + ", but has not declared it"
                        + (slot < 0 ? ", and this chunk has none" : "")
                        + "; add access."
                        + call
                        + "("
                        + field.component()
                        + ") to its describe method");
    }

    private ComponentException absent(Field field) {
        return new ComponentException(
                "this chunk has no column " + field + "; ask has(" + field.component() + ") first");
    }

    void commit(long tick) {
        for (int slot : writable) {
            slab.commit(slot, tick);
        }
    }

    void rollBack() {
        for (int slot : writable) {
            slab.rollBack(slot);
        }
    }

    /** Rights by column, for the guard of checked mode. */
    byte[] rights() {
        return rights;
    }
}
