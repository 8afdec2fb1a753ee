package dev.cairn.core.ecs;

import java.util.concurrent.atomic.AtomicInteger;

/**
 * Key of one column: one field of one component. Obtained from its {@link Component} once, kept as
 * a constant, and handed to {@link Chunk#in} and its siblings. Immutable; any thread.
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
     * Component and field, such as {@code Pose.x}.
     *
     * @return the full name
     */
    @Override
    public final String toString() {
        return component.name() + "." + name;
    }
}
