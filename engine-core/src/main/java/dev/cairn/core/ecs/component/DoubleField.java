package dev.cairn.core.ecs.component;

/** Key of a column of {@code double}. */
public final class DoubleField extends Field {
    DoubleField(Component<?> component, String name, Class<?> type, int offset) {
        super(component, name, type, offset);
    }
}
