package dev.cairn.core.ecs;

import dev.cairn.core.job.Jobs;

/** Entities, their components, and the systems that run on them. */
public final class World implements AutoCloseable {
    private World() {}

    /** @return builder */
    public static Builder builder() { return new Builder(); }
    /** @param components records @return entity */
    public long spawn(Record... components) { throw new UnsupportedOperationException(); }
    /** @param a record @return entity */
    public long spawn(Record a) { throw new UnsupportedOperationException(); }
    /** @param a record @param b record @return entity */
    public long spawn(Record a, Record b) { throw new UnsupportedOperationException(); }
    /** @param a record @param b record @param c record @return entity */
    public long spawn(Record a, Record b, Record c) { throw new UnsupportedOperationException(); }
    /** @param a record @param b record @param c record @param d record @return entity */
    public long spawn(Record a, Record b, Record c, Record d) { throw new UnsupportedOperationException(); }
    /** @param count entities @param components records, same for all @return entities */
    public long[] spawnMany(int count, Record... components) { throw new UnsupportedOperationException(); }
    /** @param entity which */
    public void delete(long entity) { throw new UnsupportedOperationException(); }
    /** @param entity which @return whether */
    public boolean isAlive(long entity) { throw new UnsupportedOperationException(); }
    /** @param entity which @param component record, not yet present */
    public void add(long entity, Record component) { throw new UnsupportedOperationException(); }
    /** @param entity which @param component which @param <T> record */
    public <T extends Record> void remove(long entity, Component<T> component) { throw new UnsupportedOperationException(); }
    /** @param entity which */
    public void clear(long entity) { throw new UnsupportedOperationException(); }
    /** @param entity which @param component which @param <T> record @return value */
    public <T extends Record> T get(long entity, Component<T> component) { throw new UnsupportedOperationException(); }
    /** @param entity which @param component which @return whether */
    public boolean has(long entity, Component<?> component) { throw new UnsupportedOperationException(); }
    /** @param entity which @param component record, present already */
    public void set(long entity, Record component) { throw new UnsupportedOperationException(); }
    /** Handle of {@link Commands#spawn} to entity. @param handle of the last tick @return entity */
    public long resolve(long handle) { throw new UnsupportedOperationException(); }
    /** @param include must be present @return query */
    public Query query(Component<?>... include) { throw new UnsupportedOperationException(); }
    /** @param resource by its class @param <T> type */
    public <T> void putResource(T resource) { throw new UnsupportedOperationException(); }
    /** @param type key @param resource value @param <T> type */
    public <T> void putResource(Class<T> type, T resource) { throw new UnsupportedOperationException(); }
    /** @param type class @param <T> type @return resource */
    public <T> T resource(Class<T> type) { throw new UnsupportedOperationException(); }
    /** @param stepSeconds length, s */
    public void step(double stepSeconds) { throw new UnsupportedOperationException(); }
    /** @return completed ticks */
    public long tickNumber() { throw new UnsupportedOperationException(); }
    /** @return length of the last tick, s */
    public double stepSeconds() { throw new UnsupportedOperationException(); }
    /** @return alive entities */
    public int entityCount() { throw new UnsupportedOperationException(); }
    /** @return digest of the published state */
    public long digest() { throw new UnsupportedOperationException(); }
    /** @return whether a system threw */
    public boolean hasFailed() { throw new UnsupportedOperationException(); }
    /** @return seed */
    public long seed() { throw new UnsupportedOperationException(); }
    /** @return schedule */
    public Schedule schedule() { throw new UnsupportedOperationException(); }
    /** @return jobs */
    public Jobs jobs() { throw new UnsupportedOperationException(); }
    @Override public void close() { throw new UnsupportedOperationException(); }

    /** Settings. */
    public static final class Builder {
        private Builder() {}

        /** @param schedule systems @return this */
        public Builder schedule(Schedule schedule) { return this; }
        /** @param systems more systems @return this */
        public Builder systems(EcsSystem... systems) { return this; }
        /** @param workers threads @return this */
        public Builder workers(int workers) { return this; }
        /** @param jobs shared, not closed by the world @return this */
        public Builder jobs(Jobs jobs) { return this; }
        /** @param seed of random streams @return this */
        public Builder seed(long seed) { return this; }
        /** @param checked whether contracts are verified @return this */
        public Builder checked(boolean checked) { return this; }
        /** @return world */
        public World build() { return new World(); }
    }
}
