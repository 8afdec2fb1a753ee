package dev.cairn.core.ecs;

import dev.cairn.core.ecs.component.Component;
import dev.cairn.core.ecs.component.ComponentException;
import dev.cairn.core.ecs.component.DoubleField;
import dev.cairn.core.ecs.component.Entities;
import dev.cairn.core.ecs.component.Field;
import dev.cairn.core.ecs.component.FloatField;
import dev.cairn.core.ecs.component.IntField;
import dev.cairn.core.ecs.component.LongField;
import dev.cairn.core.ecs.component.ObjectField;
import dev.cairn.core.ecs.storage.Slab;

/**
 * What an {@link Observer} is told: an entity and a component of it. One object per observer, valid
 * during the call. Reading columns by their fields allocates nothing; {@link #value()} makes a
 * record.
 *
 * @param <T> the record
 */
public final class Change<T extends Record> {
    private final World world;
    private final Component<T> component;

    /** The value that is replaced, as one row of columns. */
    private final Object[] before;

    private Object[] now;
    private int base;
    private int row;
    private long entity = Entities.NONE;
    private boolean replaces;

    Change(World world, Component<T> component) {
        this.world = world;
        this.component = component;
        this.before = new Object[component.fieldCount()];
        for (int i = 0; i < before.length; i++) {
            before[i] = component.field(i).newColumn(1);
        }
        this.now = before;
    }

    /** Keeps the value that is about to be replaced. */
    void keep(Slab slab, int local) {
        int from = slab.archetype.base(component);
        for (int i = 0; i < before.length; i++) {
            component.field(i).copyRow(slab.published[from + i], local, before[i], 0);
        }
    }

    void begin(long newEntity, Slab slab, int local, boolean isReplaced) {
        entity = newEntity;
        now = slab.published;
        base = slab.archetype.base(component);
        row = local;
        replaces = isReplaced;
    }

    void end() {
        entity = Entities.NONE;
        now = before;
        for (int i = 0; i < before.length; i++) {
            component.field(i).forget(before[i], 0);
        }
    }

    /**
     * The world in which it happens; forks tell the same observers.
     *
     * @return the world, which may be read
     */
    public World world() {
        return world;
    }

    /**
     * Whose component it is.
     *
     * @return the entity, which is alive
     */
    public long entity() {
        requireValid();
        return entity;
    }

    /**
     * Records what the observer asks for; made after what is being made now.
     *
     * @return the recorder
     */
    public Commands commands() {
        requireValid();
        return world.observers.commands();
    }

    /**
     * The value after the change; of a component that is removed, the last one.
     *
     * @return a new record
     */
    public T value() {
        requireValid();
        return component.type().cast(component.codec().read(now, base, row));
    }

    /**
     * A field of the value, see {@link #value()}.
     *
     * @param field a field of the component
     * @return the number
     * @throws ComponentException if it is a field of another component
     */
    public double value(DoubleField field) {
        return ((double[]) now[base + offset(field)])[row];
    }

    /**
     * A field of the value, see {@link #value()}.
     *
     * @param field a field of the component
     * @return the number
     * @throws ComponentException if it is a field of another component
     */
    public float value(FloatField field) {
        return ((float[]) now[base + offset(field)])[row];
    }

    /**
     * A field of the value, see {@link #value()}.
     *
     * @param field a field of the component
     * @return the number
     * @throws ComponentException if it is a field of another component
     */
    public int value(IntField field) {
        return ((int[]) now[base + offset(field)])[row];
    }

    /**
     * A field of the value, see {@link #value()}.
     *
     * @param field a field of the component
     * @return the number
     * @throws ComponentException if it is a field of another component
     */
    public long value(LongField field) {
        return ((long[]) now[base + offset(field)])[row];
    }

    /**
     * A field of the value, see {@link #value()}.
     *
     * @param field a field of the component
     * @param <V> type of the field
     * @return the object
     * @throws ComponentException if it is a field of another component
     */
    @SuppressWarnings("unchecked") // the array was made for the field's class
    public <V> V value(ObjectField<V> field) {
        return ((V[]) now[base + offset(field)])[row];
    }

    /**
     * The value that was replaced. In {@link Observer#set} only.
     *
     * @return a new record
     * @throws IllegalStateException if nothing was replaced
     */
    public T previous() {
        requirePrevious();
        return component.type().cast(component.codec().read(before, 0, 0));
    }

    /**
     * A field of the value that was replaced, see {@link #previous()}.
     *
     * @param field a field of the component
     * @return the number
     */
    public double previous(DoubleField field) {
        requirePrevious();
        return ((double[]) before[offset(field)])[0];
    }

    /**
     * A field of the value that was replaced, see {@link #previous()}.
     *
     * @param field a field of the component
     * @return the number
     */
    public float previous(FloatField field) {
        requirePrevious();
        return ((float[]) before[offset(field)])[0];
    }

    /**
     * A field of the value that was replaced, see {@link #previous()}.
     *
     * @param field a field of the component
     * @return the number
     */
    public int previous(IntField field) {
        requirePrevious();
        return ((int[]) before[offset(field)])[0];
    }

    /**
     * A field of the value that was replaced, see {@link #previous()}.
     *
     * @param field a field of the component
     * @return the number
     */
    public long previous(LongField field) {
        requirePrevious();
        return ((long[]) before[offset(field)])[0];
    }

    /**
     * A field of the value that was replaced, see {@link #previous()}.
     *
     * @param field a field of the component
     * @param <V> type of the field
     * @return the object
     */
    @SuppressWarnings("unchecked") // the array was made for the field's class
    public <V> V previous(ObjectField<V> field) {
        requirePrevious();
        return ((V[]) before[offset(field)])[0];
    }

    private int offset(Field field) {
        requireValid();
        if (!component.equals(field.component())) {
            throw new ComponentException(
                    "column "
                            + field
                            + " is none of "
                            + component
                            + ", which is observed; read other components of the entity with"
                            + " change.world().get(change.entity(), ..)");
        }
        return field.offset();
    }

    private void requireValid() {
        if (entity == Entities.NONE) {
            throw new IllegalStateException(
                    "this change of a "
                            + component
                            + " is over: it can be read during the call of the observer only, so"
                            + " keep its entity and values, not the object");
        }
    }

    private void requirePrevious() {
        requireValid();
        if (!replaces) {
            throw new IllegalStateException(
                    "there is no previous "
                            + component
                            + " of entity "
                            + Entities.toString(entity)
                            + ": it was added or removed, not set; ask for value");
        }
    }
}
