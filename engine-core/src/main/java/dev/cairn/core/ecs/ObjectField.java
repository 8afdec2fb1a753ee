package dev.cairn.core.ecs;

/**
 * Key of a column of references.
 *
 * @param <V> type of the field
 */
public final class ObjectField<V> extends Field {
    ObjectField(Component<?> component, String name, Class<?> type, int offset) {
        super(component, name, type, offset);
    }
}
