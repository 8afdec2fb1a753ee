package dev.cairn.core.ecs.component;

/**
 * Moves one record between the heap and a row of columns. Implemented by classes that {@link
 * Component#of} generates beside the record; not for other implementations.
 */
public interface RecordCodec {
    /**
     * Writes the fields of a record into a row. Allocates nothing.
     *
     * @param value the record
     * @param columns the columns of a chunk
     * @param base index of the record's first column in {@code columns}
     * @param row the row
     */
    void write(Record value, Object[] columns, int base, int row);

    /**
     * Makes a record from a row.
     *
     * @param columns the columns of a chunk
     * @param base index of the record's first column in {@code columns}
     * @param row the row
     * @return a new record
     */
    Record read(Object[] columns, int base, int row);
}
