package dev.cairn.core.snapshot;

/** The visible entities of one tick, with the poses of this tick and the one before. */
public final class PoseSnapshot {
    /** Doubles per row. */
    public static final int STRIDE = 7;

    PoseSnapshot() {}

    /** @return tick number */
    public long tick() { throw new UnsupportedOperationException(); }
    /** @return s */
    public double stepSeconds() { throw new UnsupportedOperationException(); }
    /** @return System.nanoTime at publication */
    public long publishedNanos() { throw new UnsupportedOperationException(); }
    /** @return rows */
    public int size() { throw new UnsupportedOperationException(); }
    /** @param row row @return entity */
    public long entity(int row) { throw new UnsupportedOperationException(); }
    /** @param row row @return model */
    public Object model(int row) { throw new UnsupportedOperationException(); }
    /** @return x y z qx qy qz qw per row */
    public double[] previous() { throw new UnsupportedOperationException(); }
    /** @return x y z qx qy qz qw per row */
    public double[] current() { throw new UnsupportedOperationException(); }
}
