package dev.cairn.core.ecs;

/** Key of a column of {@code int}. */
public final class IntField extends Field {
    IntField() {}
}
