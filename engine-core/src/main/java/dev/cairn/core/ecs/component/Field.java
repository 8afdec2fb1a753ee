package dev.cairn.core.ecs.component;

import org.jspecify.annotations.Nullable;

import java.util.concurrent.atomic.AtomicInteger;

/**
 * Key of one column: one field of one component. Obtained from its {@link Component} once, kept as
 * a constant, and handed to {@link dev.cairn.core.ecs.Chunk#in} and its siblings. Immutable; any
 * thread.
 */
public abstract sealed class Field
        permits DoubleField, FloatField, IntField, LongField, ObjectField {

    private static final AtomicInteger NEXT_ID = new AtomicInteger();

    /** Dense over the JVM, so that an archetype finds its column by one array load. */
    final int id = NEXT_ID.getAndIncrement();

    final Component<?> component;
    final String name;
    final Class<?> type;
    final Kind kind;

    /** Position among the component's columns. */
    final int offset;

    Field(Component<?> component, String name, Class<?> type, int offset) {
        this.component = component;
        this.name = name;
        this.type = type;
        this.kind = Kind.of(type);
        this.offset = offset;
    }

    static Field create(Component<?> component, String name, Class<?> type, int offset) {
        return switch (Kind.of(type)) {
            case DOUBLE -> new DoubleField(component, name, type, offset);
            case FLOAT -> new FloatField(component, name, type, offset);
            case LONG -> new LongField(component, name, type, offset);
            case INT -> new IntField(component, name, type, offset);
            case OBJECT -> new ObjectField<>(component, name, type, offset);
        };
    }

    /**
     * The component that has this field.
     *
     * @return the component
     */
    public final Component<?> component() {
        return component;
    }

    /**
     * The field's name in its record.
     *
     * @return the name
     */
    public final String name() {
        return name;
    }

    /**
     * The field's class in its record.
     *
     * @return the declared type, such as {@code boolean.class}
     */
    public final Class<?> type() {
        return type;
    }

    /**
     * Whether the column holds references; else it holds numbers, {@code boolean} and {@code char}
     * among them.
     *
     * @return whether it is an array of objects
     */
    public final boolean isReference() {
        return kind == Kind.OBJECT;
    }

    /**
     * The field's number in this JVM, for tables by field: dense, so that a column is found by one
     * array load. Depends on the order in which classes are loaded, so no result may depend on it.
     *
     * @return 0 or more
     */
    public final int id() {
        return id;
    }

    /**
     * The field's place among those of its component, which is its place in the record.
     *
     * @return 0 or more
     */
    public final int offset() {
        return offset;
    }

    /**
     * Makes an array for the column. Allocates nothing else.
     *
     * @param length rows
     * @return an array of the column's kind: {@code double[]}, {@code float[]}, {@code long[]},
     *     {@code int[]}, or an array of the field's class
     */
    public final Object newColumn(int length) {
        return kind.allocate(type, length);
    }

    /**
     * Copies one row of the column. Both arrays come from {@link #newColumn}.
     *
     * @param from array to read
     * @param fromRow its row
     * @param to array to write
     * @param toRow its row
     */
    public final void copyRow(Object from, int fromRow, Object to, int toRow) {
        kind.copy(from, fromRow, to, toRow);
    }

    /**
     * Drops the reference of a row that is no longer used; a column of numbers keeps its number.
     *
     * @param column an array from {@link #newColumn}, or null for none
     * @param row its row
     */
    public final void forget(@Nullable Object column, int row) {
        kind.forget(column, row);
    }

    /**
     * Component and field, such as {@code Pose.x}.
     *
     * @return the full name
     */
    @Override
    public final String toString() {
        return component.name() + "." + name;
    }
}
