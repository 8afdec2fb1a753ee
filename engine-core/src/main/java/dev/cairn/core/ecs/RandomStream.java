package dev.cairn.core.ecs;

/** Counter-based random numbers. */
public final class RandomStream {
    /** Empty stream; see {@link #reset}. */
    public RandomStream() {}

    /** @param seed world's @param tick number @param entity id @param stream which @return this */
    public RandomStream reset(long seed, long tick, long entity, int stream) { return this; }
    /** @return 64 random bits */
    public long nextLong() { throw new UnsupportedOperationException(); }
    /** @param bound exclusive, positive @return in [0, bound) */
    public int nextInt(int bound) { throw new UnsupportedOperationException(); }
    /** @return in [0, 1) */
    public double nextDouble() { throw new UnsupportedOperationException(); }
    /** @param low inclusive @param high exclusive @return in [low, high) */
    public double nextDouble(double low, double high) { throw new UnsupportedOperationException(); }
    /** @return in [0, 1) */
    public float nextFloat() { throw new UnsupportedOperationException(); }
}
