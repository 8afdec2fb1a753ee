package dev.cairn.core.ecs;

/** Up to 1024 rows. */
public final class Chunk {
    /** Rows of a full chunk. */
    public static final int CAPACITY = 1024;

    Chunk() {}

    /** @return rows */
    public int size() { throw new UnsupportedOperationException(); }
    /** @param row row @return entity */
    public long entity(int row) { throw new UnsupportedOperationException(); }
    /** @return ids of rows, do not write */
    public long[] entities() { throw new UnsupportedOperationException(); }
    /** @param component which @return whether */
    public boolean has(Component<?> component) { throw new UnsupportedOperationException(); }
    /** @param field field @return tick of last replacement */
    public long version(Field field) { throw new UnsupportedOperationException(); }
    /** @param field field @return published */
    public double[] in(DoubleField field) { throw new UnsupportedOperationException(); }
    /** @param field field @return published */
    public float[] in(FloatField field) { throw new UnsupportedOperationException(); }
    /** @param field field @return published */
    public int[] in(IntField field) { throw new UnsupportedOperationException(); }
    /** @param field field @return published */
    public long[] in(LongField field) { throw new UnsupportedOperationException(); }
    /** @param field field @param <V> type @return published */
    public <V> V[] in(ObjectField<V> field) { throw new UnsupportedOperationException(); }
    /** @param field field @return to write */
    public double[] out(DoubleField field) { throw new UnsupportedOperationException(); }
    /** @param field field @return to write */
    public float[] out(FloatField field) { throw new UnsupportedOperationException(); }
    /** @param field field @return to write */
    public int[] out(IntField field) { throw new UnsupportedOperationException(); }
    /** @param field field @return to write */
    public long[] out(LongField field) { throw new UnsupportedOperationException(); }
    /** @param field field @param <V> type @return to write */
    public <V> V[] out(ObjectField<V> field) { throw new UnsupportedOperationException(); }
    /** @param field field @return written this tick */
    public double[] next(DoubleField field) { throw new UnsupportedOperationException(); }
    /** @param field field @return written this tick */
    public float[] next(FloatField field) { throw new UnsupportedOperationException(); }
    /** @param field field @return written this tick */
    public int[] next(IntField field) { throw new UnsupportedOperationException(); }
    /** @param field field @return written this tick */
    public long[] next(LongField field) { throw new UnsupportedOperationException(); }
    /** @param field field @param <V> type @return written this tick */
    public <V> V[] next(ObjectField<V> field) { throw new UnsupportedOperationException(); }
}
