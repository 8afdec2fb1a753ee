package dev.cairn.core.ecs;

import dev.cairn.core.job.Jobs;

/** The tick that is being computed: the only context of a system. */
public final class Tick {
    Tick() {}

    /** @return number of this tick, 1 for the first */
    public long number() { throw new UnsupportedOperationException(); }
    /** @return length, s */
    public double stepSeconds() { throw new UnsupportedOperationException(); }
    /** @return jobs */
    public Jobs jobs() { throw new UnsupportedOperationException(); }
    /** @return index of the worker that runs this, for scratch only */
    public int worker() { throw new UnsupportedOperationException(); }
    /** @return commands of this (system, chunk) */
    public Commands commands() { throw new UnsupportedOperationException(); }
    /** @param type class @param <T> type @return the resource */
    public <T> T resource(Class<T> type) { throw new UnsupportedOperationException(); }
    /** @param entity whose @param stream which @return stream at its beginning, reused by the worker */
    public RandomStream random(long entity, int stream) { throw new UnsupportedOperationException(); }
    /** @return chunks of the running world system */
    public int chunkCount() { throw new UnsupportedOperationException(); }
    /** @param index of the chunk @return chunk */
    public Chunk chunk(int index) { throw new UnsupportedOperationException(); }
}
