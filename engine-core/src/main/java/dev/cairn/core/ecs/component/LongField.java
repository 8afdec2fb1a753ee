package dev.cairn.core.ecs.component;

/** Key of a column of {@code long}. */
public final class LongField extends Field {
    LongField(Component<?> component, String name, Class<?> type, int offset) {
        super(component, name, type, offset);
    }
}
