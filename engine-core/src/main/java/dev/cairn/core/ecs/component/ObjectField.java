package dev.cairn.core.ecs.component;

/**
 * Key of a column of references.
 *
 * @param <V> type of the field
 */
public final class ObjectField<V> extends Field {
    ObjectField(Component<?> component, String name, Class<?> type, int offset) {
        super(component, name, type, offset);
    }

    /**
     * The declared class of the field, which is also the element type of its arrays.
     *
     * @return the class
     */
    @SuppressWarnings("unchecked") // Component hands the key out by this class only
    public Class<V> valueType() {
        return (Class<V>) type;
    }
}
