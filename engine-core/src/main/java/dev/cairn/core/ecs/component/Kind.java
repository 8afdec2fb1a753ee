package dev.cairn.core.ecs.component;

import org.jspecify.annotations.Nullable;

import java.lang.reflect.Array;

/** How a column is stored: four primitive arrays and one of references. */
enum Kind {
    DOUBLE,
    FLOAT,
    LONG,
    /** Also {@code boolean} (0 or 1), {@code byte}, {@code short} and {@code char}. */
    INT,
    OBJECT;

    /** The kind that stores a record field of the given type. */
    static Kind of(Class<?> type) {
        if (type == double.class) {
            return DOUBLE;
        }
        if (type == float.class) {
            return FLOAT;
        }
        if (type == long.class) {
            return LONG;
        }
        return type.isPrimitive() ? INT : OBJECT;
    }

    /** A new column; {@code type} is the array's element type for references. */
    Object allocate(Class<?> type, int length) {
        return switch (this) {
            case DOUBLE -> new double[length];
            case FLOAT -> new float[length];
            case LONG -> new long[length];
            case INT -> new int[length];
            case OBJECT -> Array.newInstance(type, length);
        };
    }

    /** Copies one row. */
    void copy(Object from, int fromRow, Object to, int toRow) {
        switch (this) {
            case DOUBLE -> ((double[]) to)[toRow] = ((double[]) from)[fromRow];
            case FLOAT -> ((float[]) to)[toRow] = ((float[]) from)[fromRow];
            case LONG -> ((long[]) to)[toRow] = ((long[]) from)[fromRow];
            case INT -> ((int[]) to)[toRow] = ((int[]) from)[fromRow];
            case OBJECT -> ((Object[]) to)[toRow] = ((Object[]) from)[fromRow];
        }
    }

    /** Drops the reference of one row, so that a deleted entity keeps nothing alive. */
    @SuppressWarnings("NullAway") // a vacated row of a reference column holds null
    void forget(@Nullable Object column, int row) {
        if (this == OBJECT && column != null) {
            ((Object[]) column)[row] = null;
        }
    }
}
