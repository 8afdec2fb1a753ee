package dev.cairn.core.ecs.component;

/** Key of a column of {@code float}. */
public final class FloatField extends Field {
    FloatField(Component<?> component, String name, Class<?> type, int offset) {
        super(component, name, type, offset);
    }
}
