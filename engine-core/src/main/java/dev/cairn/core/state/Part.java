package dev.cairn.core.state;

import org.jspecify.annotations.Nullable;

/** How values of one type, within a record, become bytes. */
interface Part {
    /** The type, as another program would know it. */
    String name();

    /** Writes a value, which is null only where {@link Parts.OrNull} takes it. */
    void write(Object value, StateOutput out);

    /** Reads a value of this type; what is none ends with a {@link StateException}. */
    @Nullable Object read(StateInput in);
}
