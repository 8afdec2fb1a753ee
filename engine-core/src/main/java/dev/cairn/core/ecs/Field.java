package dev.cairn.core.ecs;

/** Key of one column: one field of one component. */
public abstract sealed class Field
        permits DoubleField, FloatField, IntField, LongField, ObjectField {
    Field() {}
}
