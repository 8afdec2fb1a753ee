package dev.cairn.core.ecs.component;

/**
 * Key of a column of {@code int}; fields of type {@code boolean} (0 or 1), {@code byte}, {@code
 * short} and {@code char} are stored in such columns too.
 */
public final class IntField extends Field {
    IntField(Component<?> component, String name, Class<?> type, int offset) {
        super(component, name, type, offset);
    }
}
