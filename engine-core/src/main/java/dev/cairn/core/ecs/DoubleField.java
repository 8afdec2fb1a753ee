package dev.cairn.core.ecs;

/** Key of a column of {@code double}. */
public final class DoubleField extends Field {
    DoubleField() {}
}
