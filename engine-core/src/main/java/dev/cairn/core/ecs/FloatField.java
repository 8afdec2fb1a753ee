package dev.cairn.core.ecs;

/** Key of a column of {@code float}. */
public final class FloatField extends Field {
    FloatField() {}
}
